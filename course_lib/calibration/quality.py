"""Whether pictures say enough of a camera: what they cover, and how it does on others.

Use these functions through `course_lib.calibration`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.calibration.degeneracy import check_order
from course_lib.calibration.derivatives import residuals
from course_lib.calibration.judgement import rms_error
from course_lib.calibration.model import CameraModel, State, camera_numbers
from course_lib.calibration.refinement import minimised
from course_lib.calibration.result import Calibration
from course_lib.calibration.start import minimum, view_homographies
from course_lib.calibration.views import Views, gather_views
from course_lib.calibration.zhang import pose_from_homography
from course_lib.checks import Array, check_points, check_rotation, check_size
from course_lib.distortion import undistort_pixels

#: A camera of which nothing is free: only the board moves.
NOTHING_FREE = CameraModel(focal=False, principal_point=False, coefficients=())


@dataclass(frozen=True, eq=False)
class Coverage:
    """Where in the picture the points of all views are.

    Attributes
    ----------
    counts : ndarray of int, shape (rows, columns)
        Points in each cell of a grid over the picture.
    share : float
        Cells with a point, of all.
    reach : float
        Distance of the outermost point from the middle, by that of a corner of the picture: beyond
        it, distortion is extrapolated.
    """

    counts: NDArray[np.int_]
    share: float
    reach: float


def coverage(
    image_points: Sequence[ArrayLike], image_size: tuple[int, int], cells: tuple[int, int] = (8, 6)
) -> Coverage:
    """Return which part of the picture the points of all views cover.

    Parameters
    ----------
    image_points : sequence of array_like, shape (N, 2)
        Pixels of each view.
    image_size : tuple of int
        Width and height, px.
    cells : tuple of int
        Into how many columns and rows the picture is divided.

    Returns
    -------
    Coverage
        Points by cells, the share that is covered, and how far out the points reach.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite or there is no point.

    References
    ----------
    T. Luhmann et al., Close-Range Photogrammetry and 3D Imaging, 3rd ed., section 7.3 (camera
    calibration: filling the format).

    Examples
    --------
    >>> coverage([[[10, 10], [630, 470]]], (640, 480), cells=(2, 2)).counts
    array([[1, 0],
           [0, 1]])
    """
    size, (columns, rows) = check_size(image_size, "image_size"), check_size(cells, "cells")
    listed = [np.atleast_2d(check_points(v, 2, "the pixels of a view")) for v in image_points]
    if not sum(map(len, listed)):
        raise ValueError("there are no points: was the board found in none of the pictures?")
    pixels = np.concatenate(listed)
    # Pixel centres are whole numbers, so the picture begins at -0.5.
    edges = [
        np.linspace(-0.5, side - 0.5, int(n) + 1)
        for side, n in zip(size, (columns, rows), strict=True)
    ]
    counts = np.histogram2d(pixels[:, 1], pixels[:, 0], bins=(edges[1], edges[0]))[0].astype(int)
    middle = (size - 1) / 2
    reach = np.linalg.norm(pixels - middle, axis=1).max() / np.linalg.norm(middle)
    return Coverage(counts, float((counts > 0).mean()), float(reach))


def board_tilts(poses: Sequence[tuple[ArrayLike, ArrayLike]]) -> tuple[Array, Array]:
    """Return how much each board was tilted against the camera's axis, and towards where.

    Parameters
    ----------
    poses : sequence of (R, t)
        Board to camera, as `Calibration.poses`.

    Returns
    -------
    tilts : ndarray, shape (V,)
        Angle between the board's normal and the camera's axis, rad: 0 for a board that faces it.
    directions : ndarray, shape (V,)
        Towards which side of the picture the board's near edge is, rad from the picture's x
        towards y.

    Raises
    ------
    TypeError, ValueError
        If a pose has no rotation.

    References
    ----------
    Z. Zhang, "A flexible new technique for camera calibration", IEEE PAMI 22 (2000), section 5.1:
    errors are smallest near 45°.

    Examples
    --------
    >>> from course_lib.transforms import rotation_y
    >>> tilts, directions = board_tilts([(rotation_y(0.5), [0, 0, 9])])
    >>> tilts, directions
    (array([0.5]), array([0.]))
    """
    normals = np.array([check_rotation(R)[:, 2] for R, _ in poses]).reshape(-1, 3)
    normals = normals * np.where(normals[:, 2:] < 0, -1, 1)
    # With the normal (a, b, c), c > 0, depth grows by (-a, -b) / c: the near edge is at (a, b).
    tilts = np.arccos(np.clip(normals[:, 2], -1, 1))
    return tilts, np.arctan2(normals[:, 1], normals[:, 0])


def view_residuals(
    calibration: Calibration,
    object_points: ArrayLike | Sequence[ArrayLike],
    image_points: Sequence[ArrayLike],
) -> list[Array]:
    """Return what a calibrated camera leaves over in pictures that it was not calibrated with.

    Only the pose of the board is fitted to each of them; the camera stays as it is.

    Parameters
    ----------
    calibration : Calibration
        The camera.
    object_points, image_points : as in `calibrate`
        The other pictures; one is enough.

    Returns
    -------
    list of ndarray, shape (N, 2)
        For each view, projected minus observed pixels.

    Raises
    ------
    TypeError, ValueError, DegenerateConfigurationError
        As `calibrate`.

    References
    ----------
    T. Hastie, R. Tibshirani, J. Friedman, The Elements of Statistical Learning, section 7.2.
    """
    views = gather_views(object_points, image_points)
    state, _ = minimised(posed_boards(calibration.K, calibration.coefficients, views), views)
    return views.per_view(residuals(state, views))


def posed_boards(K: ArrayLike, coefficients: ArrayLike, views: Views) -> State:
    """Return a known camera with the pose of each view from its straightened homography."""
    seen = views.pixels.transpose(0, 2, 1)
    straight = undistort_pixels(seen.reshape(-1, 2), K, coefficients).reshape(seen.shape)
    straight = np.where(np.isnan(straight), seen, straight).transpose(0, 2, 1)  # beyond the fold
    ideal = Views(views.points, straight, views.weights, views.counts)
    Hs = view_homographies(ideal)
    check_order(ideal, Hs)
    R, t = pose_from_homography(K, Hs)
    return State(NOTHING_FREE, camera_numbers(K, coefficients), R, t)


def held_out_rms(
    object_points: ArrayLike | Sequence[ArrayLike],
    image_points: Sequence[ArrayLike],
    image_size: tuple[int, int],
    model: CameraModel | None = None,
    folds: int = 5,
) -> Array:
    """Return how well each view agrees with a camera that was calibrated without it.

    The views are dealt into parts; each part in turn is left out, and judged by the camera that the
    others give. A model with too many numbers looks good on its own pictures only.

    Parameters
    ----------
    object_points, image_points, image_size, model
        As in `calibrate`.
    folds : int
        How many parts, from 2 to the number of views.

    Returns
    -------
    ndarray, shape (V,)
        RMS of each view, px, when it was left out.

    Raises
    ------
    TypeError, ValueError, DegenerateConfigurationError
        As `calibrate`; also if the remaining views are too few.

    References
    ----------
    T. Hastie, R. Tibshirani, J. Friedman, The Elements of Statistical Learning, section 7.10.
    """
    model = CameraModel() if model is None else model
    size, views = check_size(image_size, "image_size"), gather_views(object_points, image_points)
    count = len(views.counts)
    if not 2 <= folds <= count:
        raise ValueError(f"folds must be from 2 to the {count} views, got {folds}")
    rms = np.empty(count)
    for fold in range(folds):
        left_out = np.arange(count) % folds == fold
        camera, _ = minimum(views.only(~left_out), size, model)
        others = views.only(left_out)
        state, _ = minimised(posed_boards(camera.K, camera.coefficients, others), others)
        rms[left_out] = [rms_error(r) for r in others.per_view(residuals(state, others))]
    return rms
