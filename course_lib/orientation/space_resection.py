"""Space resection: where a calibrated camera stood, from points whose places are known."""

from __future__ import annotations

from itertools import combinations
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.bundle.adjustment import BundleAdjustment, bundle_adjust
from course_lib.bundle.block import Block, Indices, Observations
from course_lib.bundle.control import Control
from course_lib.checks import (
    Array,
    DegenerateConfigurationError,
    check_count,
    check_generator,
    check_intrinsics,
    check_length,
)
from course_lib.correspondences import check_correspondences, check_spread
from course_lib.orientation.three_points import three_point_poses, unit_rays
from course_lib.resection import camera_dlt

#: From so many points, far from each other, all triples are tried.
CORNERS = 6
#: The best so many starts are refined.
STARTS = 4


class Resection(NamedTuple):
    """The pose of a camera, and how well it is known.

    Attributes
    ----------
    R, t : ndarray, shape (3, 3) and (3,)
        Pose, world to camera.
    centre : ndarray, shape (3,)
        Centre of projection in the world.
    residuals : ndarray, shape (N, 2)
        Where the camera sees the points, minus the measured pixels, px.
    sigma0 : float
        Standard deviation of a coordinate, px, judged by the residuals.
    covariance : ndarray, shape (6, 6)
        Of the turn about the camera's axes, rad, and of the centre, judged by the residuals.
    used : ndarray of bool, shape (N,)
        Which points decided; all, unless a robust resection left some out.
    """

    R: Array
    t: Array
    centre: Array
    residuals: Array
    sigma0: float
    covariance: Array
    used: NDArray[np.bool_]


def resect_camera(points: ArrayLike, pixels: ArrayLike, K: ArrayLike) -> Resection:
    """Return the pose of a calibrated camera with the smallest reprojection error.

    No start is needed: triples of points, and the camera's DLT if there are six points or more that
    are not in one plane, give several; the best are refined.

    Parameters
    ----------
    points : array_like, shape (N, 3)
        N ≥ 4 points of the world, not all on one line; a plane will do.
    pixels : array_like, shape (N, 2)
        Where the camera sees them, freed from distortion.
    K : array_like, shape (3, 3)
        Intrinsics, px.

    Returns
    -------
    Resection
        Pose, residuals and covariance.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or there are fewer than four points.
    DegenerateConfigurationError
        If the points or the pixels are on one line, or no pose has all points in front.

    References
    ----------
    K. Kraus, Photogrammetry, 2nd ed., section 4.2 (spatial resection); R. M. Haralick et al., IJCV
    13 (1994).

    Examples
    --------
    >>> corners = [[0, 0, 0], [4, 0, 0], [4, 3, 0], [0, 3, 0]]
    >>> pixels = [[0, 0], [80, 0], [80, 60], [0, 60]]
    >>> resect_camera(corners, pixels, np.diag([100, 100, 1])).centre.round(6) + 0.0
    array([ 0.,  0., -5.])
    """
    names = "points", "pixels"
    X, seen = check_correspondences(points, pixels, (3, 2), names, least=4)
    K = check_intrinsics(K)
    check_spread(X, 2, names[0])
    check_spread(seen, 2, names[1])
    fits = [_refined(X, seen, K, *pose) for pose in _starts(X, seen, K)]
    if not fits:
        raise DegenerateConfigurationError(
            "no pose has all points in front of the camera: check that points and pixels belong "
            "together row by row, that y of the pixels runs downwards, and that no axis is swapped"
        )
    return _resection(min(fits, key=lambda fit: fit.cost))


def resect_robustly(
    points: ArrayLike,
    pixels: ArrayLike,
    K: ArrayLike,
    rng: np.random.Generator,
    threshold: float = 4.0,
    samples: int = 300,
) -> Resection:
    """Return the pose that most points agree on, though others may be wrong.

    Parameters
    ----------
    points, pixels, K
        As in `resect_camera`, N ≥ 4.
    rng : numpy.random.Generator
        Chooses triples of points.
    threshold : float
        Length of a residual up to which a point agrees, px.
    samples : int
        How many triples are tried.

    Returns
    -------
    Resection
        Refined with the points that agree; `used` says which.

    Raises
    ------
    TypeError, ValueError
        As `resect_camera`, or if the threshold is not positive.
    DegenerateConfigurationError
        As `resect_camera`, or if fewer than four points agree on any pose.

    References
    ----------
    M. A. Fischler, R. C. Bolles, "Random sample consensus", Communications of the ACM 24 (1981),
    which was made for this task.
    """
    names = "points", "pixels"
    X, seen = check_correspondences(points, pixels, (3, 2), names, least=4)
    K, threshold = check_intrinsics(K), check_length(threshold, "threshold")
    rng, samples = check_generator(rng), check_count(samples, "samples")
    check_spread(X, 2, names[0])
    triples = rng.random((samples, len(X))).argpartition(2, axis=1)[:, :3]
    R, t = _poses(X, seen, K, triples)
    sizes = _sizes(X, seen, K, R, t)
    agreeing = sizes <= threshold
    if not len(R) or agreeing.sum(axis=1).max() < 4:
        raise DegenerateConfigurationError(
            f"no pose is agreed on by four points within {threshold:g} px: check the pairs, or "
            "allow more"
        )
    # The most points; of equals, the smallest errors.
    score = np.minimum(sizes, threshold).sum(axis=1)
    used = agreeing[np.argmin(score)]
    for _ in range(3):
        fit = resect_camera(X[used], seen[used], K)
        found = _sizes(X, seen, K, fit.R[None], fit.t[None])[0] <= threshold
        if (found == used).all() or found.sum() < 4:
            break
        used = found
    away = _projected(X, K, fit.R[None], fit.t[None])[0] - seen
    return fit._replace(residuals=away, used=used)


def _starts(X: Array, seen: Array, K: Array) -> list[tuple[Array, Array]]:
    """Return the best poses to begin with."""
    corners = _far_apart(seen)
    R, t = _poses(X, seen, K, np.array(list(combinations(corners, 3))))
    if len(X) >= 6:
        try:
            by_dlt = camera_dlt(X, unit_rays(seen, K)[:, :2] / unit_rays(seen, K)[:, 2:])
        except DegenerateConfigurationError:
            pass  # a plane: the triples must do
        else:
            U, _, Vt = np.linalg.svd(by_dlt[:, :3])
            turn = U @ np.diag([1, 1, np.linalg.det(U @ Vt)]) @ Vt
            centre = np.linalg.solve(by_dlt[:, :3], -by_dlt[:, 3])
            R, t = np.append(R, turn[None], axis=0), np.append(t, -(turn @ centre)[None], axis=0)
    costs = (_sizes(X, seen, K, R, t) ** 2).sum(axis=1)
    best = np.argsort(costs)
    return [(R[i], t[i]) for i in best[:STARTS] if np.isfinite(costs[i])]


def _poses(X: Array, seen: Array, K: Array, triples: Indices) -> tuple[Array, Array]:
    """Return the poses of triples of points, (k, 3, 3) and (k, 3)."""
    R, t, found = three_point_poses(X[triples], unit_rays(seen, K)[triples])
    return R[found], t[found]


def _projected(X: Array, K: Array, R: Array, t: Array) -> Array:
    """Return the pixels of points for several poses, (k, N, 2); infinite behind the camera."""
    q = np.einsum("kij,nj->kni", R, X) + t[:, None]
    z = np.where(q[..., 2] > 0, q[..., 2], np.nan)
    pixels = np.einsum("ij,knj->kni", K[:2], q / z[..., None])
    return np.asarray(np.nan_to_num(pixels, nan=np.inf))


def _sizes(X: Array, seen: Array, K: Array, R: Array, t: Array) -> Array:
    """Return the lengths of the residuals for several poses, (k, N); infinite behind."""
    return np.asarray(np.linalg.norm(_projected(X, K, R, t) - seen, axis=2))


def _far_apart(seen: Array) -> list[int]:
    """Return points that are far from each other in the picture."""
    chosen = [int(np.argmax(((seen - seen.mean(axis=0)) ** 2).sum(axis=1)))]
    nearest = np.full(len(seen), np.inf)
    while len(chosen) < min(CORNERS, len(seen)):
        nearest = np.minimum(nearest, ((seen - seen[chosen[-1]]) ** 2).sum(axis=1))
        chosen.append(int(np.argmax(nearest)))
    return chosen


def _refined(X: Array, seen: Array, K: Array, R: Array, t: Array) -> BundleAdjustment:
    """Return the adjustment of one camera to points that are all held."""
    numbers = np.arange(len(X))
    observations = Observations(np.zeros(len(X), np.intp), numbers, seen)
    control = Control(numbers, X)
    return bundle_adjust(Block(K, R[None], t[None], X), observations, control, tolerance=1e-14)


def _resection(fit: BundleAdjustment) -> Resection:
    block = fit.block
    used = np.ones(len(fit.residuals), dtype=bool)
    covariance = fit.precision.cameras[0]
    return Resection(
        block.R[0], block.t[0], block.centres[0], fit.residuals, fit.sigma0, covariance, used
    )
