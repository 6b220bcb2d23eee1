"""The target itself, measured with the camera: where its points really are.

Use these functions through `course_lib.measuring`.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from course_lib.bundle import Block, Observations, bundle_adjust
from course_lib.calibration import Calibration
from course_lib.calibration.quality import posed_boards
from course_lib.calibration.views import gather_views
from course_lib.checks import Array
from course_lib.distortion import undistort_pixels


def target_offsets(
    calibration: Calibration, target_points: ArrayLike, image_points: Sequence[ArrayLike]
) -> Array:
    """Return how far the points of a target are from where they should be, seen by the camera.

    What is left over at a corner is partly chance, another one in each picture, and partly the
    target, the same in all of them. A bundle adjustment that lets the target's points move tells
    both apart. It cannot tell a wrong scale: the points are laid over the ideal ones as they fit
    best.

    Parameters
    ----------
    calibration : Calibration
        The camera.
    target_points : array_like, shape (N, 3)
        Where the points should be, z = 0.
    image_points : sequence of V array_like, shape (N, 2)
        Their pixels in V ≥ 2 pictures from different sides, with distortion.

    Returns
    -------
    ndarray, shape (N, 3)
        Offsets, in the unit of the target; their root mean square is the `unevenness` that
        `view_of_target` asks for.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or there is one picture only.
    DegenerateConfigurationError
        If the points or pixels are on one line, or do not fit each other.

    References
    ----------
    K. H. Strobl, G. Hirzinger, "More accurate pinhole camera calibration with imperfect planar
    target", ICCV workshops (2011); T. Luhmann et al., Close-Range Photogrammetry and 3D Imaging,
    3rd ed., section 7.3 (simultaneous calibration).
    """
    views = gather_views(target_points, image_points)
    count, points = len(views.counts), views.points[0].T
    if count < 2:
        raise ValueError("image_points must be of two or more pictures: take more")
    state = posed_boards(calibration.K, calibration.coefficients, views)
    pixels = views.pixels.transpose(0, 2, 1).reshape(-1, 2)
    straight = undistort_pixels(pixels, calibration.K, calibration.coefficients)
    camera, point = np.divmod(np.arange(count * len(points)), len(points))
    block = Block(calibration.K, state.R, state.t, points)
    found = bundle_adjust(block, Observations(camera, point, straight)).block.points
    return np.asarray(found - points)
