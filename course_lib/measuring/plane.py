"""Lengths on the plane of a target, from one picture.

Use these functions through `course_lib.measuring`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    Array,
    DegenerateConfigurationError,
    check_number,
    check_points,
    check_vector,
)
from course_lib.distortion import undistort_pixels
from course_lib.distortion.pixels import normalised_from_pixels
from course_lib.measuring.measured import Measured
from course_lib.measuring.shares import check_sigmas, shares
from course_lib.measuring.view import View, pixels_and_slopes
from course_lib.triangulation import intersect_ray_plane


def point_on_plane(pixels: ArrayLike, view: View, height: float = 0.0) -> Array:
    """Return the points of the target's plane, or of one parallel to it, that pixels show.

    The ray of a pixel without distortion begins at the camera's centre ``C = -Rᵀ t`` and goes
    along ``Rᵀ (x, y, 1)``; it meets the plane at z = -height.

    Parameters
    ----------
    pixels : array_like, shape (N, 2) or (2,)
        Pixels of the real picture.
    view : View
        The picture, as `view_of_target` gives it.
    height : float
        How high the points lie above the target's plane, towards the camera.

    Returns
    -------
    ndarray, shape (N, 3) or (3,)
        Points in the frame of the target, in its unit; a row of NaN for a pixel that looks above
        the plane's horizon.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or the distortion cannot be undone at a pixel.
    DegenerateConfigurationError
        If a ray is parallel to the plane, or the camera is in it.

    References
    ----------
    R. Szeliski, Computer Vision, 2nd ed., section 13.2.1 (a ray and a plane).

    Examples
    --------
    A camera 500 mm above the target's first point, looking straight down:

    >>> from course_lib.calibration import CameraModel
    >>> K, none = np.array([[1000, 0, 320], [0, 1000, 240], [0, 0, 1]]), np.zeros((6, 6))
    >>> known = CameraModel(focal=False, principal_point=False, coefficients=())
    >>> view = View(K, np.zeros(5), np.eye(3), np.array([0, 0, 500]), known, none, none, none, 0.1)
    >>> point_on_plane([[320, 240], [420, 240]], view)
    array([[ 0.,  0.,  0.],
           [50.,  0.,  0.]])
    >>> point_on_plane([420, 240], view, height=50)
    array([ 45.,   0., -50.])
    """
    seen, height = check_points(pixels, 2, "pixels"), check_number(height, "height")
    straight = undistort_pixels(seen, view.K, view.coefficients)
    if np.isnan(straight).any():
        raise ValueError(
            "the lens model says nothing about one of these pixels: it is too far outside; point "
            "nearer to the middle of the picture"
        )
    ideal = normalised_from_pixels(straight, view.K)
    directions = np.concatenate([ideal, np.ones((*ideal.shape[:-1], 1))], axis=-1) @ view.R
    return intersect_ray_plane(view.centre, directions, [0, 0, 1, height])


def distance_on_plane(
    one: ArrayLike,
    other: ArrayLike,
    view: View,
    pointing: float = 0.5,
    scale: float = 0.0,
    height: float = 0.0,
    height_sigma: float = 0.0,
) -> Measured:
    """Return the distance of two points on the target's plane, or at a height above it.

    A point (x, y) of the plane gives the pixel π(x, y); with ``M = (∂π/∂(x, y))⁻¹`` it moves by
    ``M (δpixel - J_θ δθ - Jₚ δp - J_z δz)`` when the pixel, the camera θ, the pose p or the
    plane change, and the distance by the difference of both points' moves along their line.

    Parameters
    ----------
    one, other : array_like, shape (2,)
        Pixels of both points in the real picture.
    view : View
        The picture, as `view_of_target` gives it.
    pointing : float
        Standard deviation of each coordinate of a pixel pointed at, px; see `pointing_sigma`.
    scale : float
        Relative standard deviation of the target's lengths: 0.002 for a bar of 100 mm that was
        measured to ± 0.2 mm.
    height, height_sigma : float
        How high both points lie above the target's plane, and its standard deviation. Who forgets
        a height h measures ``Z / (Z - h)`` times the length, if the camera is Z above the plane.

    Returns
    -------
    Measured
        With the parts ``"pointing"``, ``"pose"``, ``"camera"`` and ``"target"`` (its corners), and,
        if they are given, ``"scale"`` and ``"height"``.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, a standard deviation is negative, or both
        pixels are the same.
    DegenerateConfigurationError
        If the camera does not see the plane at one of the pixels.

    References
    ----------
    E. M. Mikhail, F. Ackermann, Observations and Least Squares, chapter 4; A. Criminisi, I. Reid,
    A. Zisserman, "A plane measuring device", Image and Vision Computing 17 (1999).
    """
    check_sigmas(pointing, scale=scale, height_sigma=height_sigma)
    pixels = np.stack([check_vector(one, 2, "one"), check_vector(other, 2, "other")])
    points = point_on_plane(pixels, view, height)
    if np.isnan(points).any():
        raise DegenerateConfigurationError(
            "a pixel looks above the horizon of the target's plane: point at something on it"
        )
    value, line = length_and_line(points)
    _, by_state, by_point = pixels_and_slopes(view, points)
    # One row for each point: how the length answers when its pixel is moved.
    towards = np.array([-line, line])
    by_pixel = np.linalg.solve(by_point[..., :2].swapaxes(1, 2), towards[:, :2, None])[..., 0]
    state = -np.einsum("ki,kij->j", by_pixel, by_state)
    lift = abs(float(np.einsum("ki,ki->", by_pixel, by_point[..., 2])))
    parts = shares([view], [state], by_pixel)
    parts["pointing"] *= pointing
    given = {"scale": scale * value, "height": lift * height_sigma}
    return Measured(value, parts | {name: sigma for name, sigma in given.items() if sigma})


def length_and_line(points: Array) -> tuple[float, Array]:
    """Return the distance of two points, (2, 3), and the unit vector from one to the other."""
    line = points[1] - points[0]
    value = float(np.linalg.norm(line))
    if value == 0:
        raise ValueError("both points are the same: point at two different ones")
    return value, line / value
