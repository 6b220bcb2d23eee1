"""Scenes and motions that leave the epipolar geometry open, recognised in measured pairs."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.checks import (
    Array,
    DegenerateConfigurationError,
    check_intrinsics,
    check_length,
)
from course_lib.epipolar.fundamental import common_scale
from course_lib.epipolar.lines import check_pairs
from course_lib.homogeneous import to_homogeneous

Degeneracy = Literal["none", "plane or rotation", "plane", "rotation"]
#: So many of the pairs must fit a homography for the epipolar geometry to be open.
NEARLY_ALL = 0.9
ROUNDS = 10
#: So many thresholds off is the better half of pairs that no homography fits.
HOPELESS = 6
#: What to do about each.
ADVICE = {
    "plane or rotation": (
        "one homography explains the pairs: the points are on a plane, or the camera has only "
        "turned, so many fundamental matrices fit; take points at other depths, move the camera, "
        "or use the homography"
    ),
    "plane": (
        "the points are on a plane, so many fundamental matrices fit: take points at other depths, "
        "or use the homography; with known intrinsics only two poses are left (ransac_pose)"
    ),
    "rotation": (
        "the camera has only turned (or the scene is very far away): there is no baseline to find; "
        "move the camera, or use the homography to join the pictures"
    ),
}


def find_degeneracy(
    points1: ArrayLike,
    points2: ArrayLike,
    threshold: float,
    K1: ArrayLike | None = None,
    K2: ArrayLike | None = None,
) -> Degeneracy:
    """Return what keeps pairs from telling the epipolar geometry, if anything does.

    If nearly all pairs fit a homography within the threshold, the plane's homography is all that
    they tell. "none" is no proof: it is the answer too where the threshold is less than the errors
    of the pixels, or where more than a tenth of the pairs are wrong. A camera that only turned has
    such a homography too; intrinsics tell whether it is one.

    Parameters
    ----------
    points1, points2 : array_like, shape (N, 2)
        N ≥ 5 pixels of picture 1, and their partners in picture 2, wrong pairs removed.
    threshold : float
        Largest error of a right pair, px.
    K1, K2 : array_like, shape (3, 3), optional
        Intrinsics in px.

    Returns
    -------
    {"none", "plane or rotation", "plane", "rotation"}
        With intrinsics one of "none", "plane" and "rotation"; without them one of the first two.

    Raises
    ------
    TypeError, ValueError
        If the shapes do not fit, a number is not finite, the threshold is not positive, there are
        fewer than five pairs, or only one of the intrinsics is given.
    DegenerateConfigurationError
        If all points of a picture are on a line.

    References
    ----------
    P. Torr, A. Fitzgibbon & A. Zisserman, "The problem of degeneracy in structure and motion
    recovery from uncalibrated image sequences", IJCV 32 (1999).
    """
    points1, points2 = check_pairs(points1, points2, least=5)
    threshold = check_length(threshold, "threshold")
    if (K1 is None) != (K2 is None):
        raise ValueError("give the intrinsics of both cameras, or of neither")
    H, kept = _main_homography(points1, points2, threshold)
    if not _explains(H, points1, points2, threshold):
        return "none"
    if K1 is None or K2 is None:
        return "plane or rotation"
    K1, K2 = check_intrinsics(K1), check_intrinsics(K2)
    inverse1, inverse2 = (np.asarray(np.linalg.inv(K), dtype=np.float64) for K in (K1, K2))
    R = _turn_between(_bearings(points1[kept], inverse1), _bearings(points2[kept], inverse2))
    turned = _explains(K2 @ R @ inverse1, points1, points2, threshold)
    return "rotation" if turned else "plane"


def raise_degeneracy(found: Degeneracy) -> None:
    """Raise with what to do, unless there is no degeneracy."""
    if found != "none":
        raise DegenerateConfigurationError(ADVICE[found])


def _bearings(points: Array, inverse: Array) -> Array:
    """Return the directions of pixels, unit vectors in rows."""
    rays = to_homogeneous(points) @ inverse.T
    return np.asarray(rays / np.linalg.norm(rays, axis=1, keepdims=True))


def _turn_between(one: Array, other: Array) -> Array:
    """Return the rotation that brings directions nearest to their partners (Kabsch)."""
    U, _, Vt = np.linalg.svd(other.T @ one)
    return np.asarray(U @ np.diag([1, 1, np.linalg.det(U @ Vt)]) @ Vt)


def _main_homography(
    points1: Array, points2: Array, threshold: float
) -> tuple[Array, NDArray[np.bool_]]:
    """Return the homography that most pairs fit, and which: again and again of the better half."""
    x1, x2, T1, T2, _ = common_scale(points1, points2)
    kept: NDArray[np.bool_] = np.ones(len(points1), dtype=bool)
    half = len(points1) // 2
    for turn in range(ROUNDS):
        H = np.linalg.inv(T2) @ _linear_homography(x1[:, kept], x2[:, kept]) @ T1
        errors = _transfer_errors(H, points1, points2)
        limit = max(threshold, float(np.partition(errors, half)[half]))
        new = errors <= limit
        # Where a homography fits nearly all, its better half is soon good.
        if (new == kept).all() or new.sum() < 4 or (turn > 0 and limit > HOPELESS * threshold):
            break
        kept = new
    return H, kept


def _linear_homography(x1: Array, x2: Array) -> Array:
    """Return the homography of normalised pairs, homogeneous columns, by the DLT."""
    nothing = np.zeros_like(x1)
    rows_u = np.concatenate([x1, nothing, -x2[0] * x1])
    rows_v = np.concatenate([nothing, x1, -x2[1] * x1])
    return np.asarray(np.linalg.eigh(rows_u @ rows_u.T + rows_v @ rows_v.T)[1][:, 0].reshape(3, 3))


def _explains(H: Array, points1: Array, points2: Array, threshold: float) -> bool:
    return bool((_transfer_errors(H, points1, points2) <= threshold).mean() >= NEARLY_ALL)


def _transfer_errors(H: Array, points1: Array, points2: Array) -> Array:
    """Return how far partners are from where H puts them, shared between both pictures, px."""
    image = to_homogeneous(points1) @ H.T
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        apart = np.linalg.norm(image[:, :2] / image[:, 2:] - points2, axis=1) / np.sqrt(2)
    return np.asarray(np.where(np.isnan(apart), np.inf, apart))
