"""What each source of error contributes to a length: propagation of covariances.

A length d depends on pixels, poses, cameras and the target. With its derivatives g by one of them,
and their covariance C, that source alone gives the variance ``g C gᵀ``.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from course_lib.checks import Array, check_length, check_not_negative, check_number
from course_lib.measuring.view import View

#: How far errors of a target reach, ℓ, by its diagonal.
SHARED = 0.25


def check_sigmas(pointing: float, **others: float) -> None:
    """Raise unless pointing is positive and the other standard deviations are not negative."""
    check_length(pointing, "pointing (px)")
    for name, value in others.items():
        check_not_negative(check_number(value, name), name)


def shares(views: Sequence[View], by_state: Sequence[Array], by_pixel: Array) -> dict[str, float]:
    """Return the standard deviations of a length by pointing, poses and cameras.

    Parameters
    ----------
    views : sequence of View
        The pictures.
    by_state : sequence of ndarray, shape (n + 6,)
        Derivatives of the length by the camera's numbers and the pose of each.
    by_pixel : ndarray
        Derivatives by all pixels that were pointed at, for a standard deviation of 1 px.

    Returns
    -------
    dict of str to float
        ``"pointing"`` (for 1 px), ``"pose"``, ``"camera"`` and ``"target"``.

    References
    ----------
    E. M. Mikhail, F. Ackermann, Observations and Least Squares, chapter 4; JCGM 100 (GUM),
    section 5.2 (correlated input quantities).
    """
    own = sum(
        float(g[-6:] @ view.pose_covariance @ g[-6:])
        for view, g in zip(views, by_state, strict=True)
    )
    # Pictures of one camera share its error: add the derivatives first, then square.
    common: dict[int, tuple[Array, Array]] = {}
    for view, g in zip(views, by_state, strict=True):
        C, sum_before = common.get(id(view.covariance), (view.covariance, np.zeros(1)))
        common[id(view.covariance)] = C, sum_before + g @ view.follows
    shared = sum(float(g @ C @ g) for C, g in common.values())
    variances = {"pointing": float((by_pixel**2).sum()), "pose": own, "camera": shared}
    variances["target"] = _by_unevenness(views, by_state)
    return {name: float(np.sqrt(max(value, 0.0))) for name, value in variances.items()}


def _by_unevenness(views: Sequence[View], by_state: Sequence[Array]) -> float:
    """Return the variance of a length by errors of the target, which are alike in all pictures.

    Points a distance r apart share their error by ``exp(-r² / 2ℓ²)``, in each direction. An error
    that each point has alone would average out, one that all share would only shift the target: ℓ
    is between, where it does about the most harm.
    """
    points = np.concatenate([view.target for view in views])
    if not len(points):
        return 0.0
    moves = [
        view.unevenness * np.einsum("i,inj->nj", g[-6:], view.by_target)
        for view, g in zip(views, by_state, strict=True)
    ]
    move, length = np.concatenate(moves), SHARED * float(np.linalg.norm(np.ptp(points, axis=0)))
    apart = ((points[:, None] - points[None]) ** 2).sum(axis=-1)
    return float(np.einsum("nj,nm,mj->", move, np.exp(-apart / (2 * length**2)), move))
