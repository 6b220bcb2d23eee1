"""The pinhole: from millimetres to pixels, and from points in front of a hole to their image.

The camera frame has x right, y down, z forward, with the hole (the centre of projection) at the
origin. Pixel ``(0, 0)`` is the centre of the top-left pixel, so the image reaches from -0.5 to
``width - 0.5``. Use these functions through `course_lib.camera`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    Array,
    check_directions,
    check_length,
    check_pixel_focal,
    check_points,
    check_positive,
    check_size,
    check_vector,
)


def image_centre(image_size: ArrayLike) -> Array:
    """Return the middle of a picture in pixel coordinates.

    The top-left pixel is a small square whose *centre* is ``(0, 0)``.

    Parameters
    ----------
    image_size : array_like, shape (2,)
        Width and height of the picture in px.

    Returns
    -------
    ndarray, shape (2,)
        Pixel ``(u, v)``: column and row, with halves where the middle lies between two pixels.

    Raises
    ------
    TypeError, ValueError
        If the size has the wrong shape or is not positive and finite.

    References
    ----------
    The pixel convention is OpenCV's.

    Examples
    --------
    >>> image_centre((3, 5))
    array([1., 2.])
    """
    return (check_size(image_size, "image_size") - 1) / 2


def pixel_focal_length(f: float, sensor_size: ArrayLike, image_size: ArrayLike) -> Array:
    """Return the focal length in pixels, across (for u) and down (for v).

    Parameters
    ----------
    f : float
        Focal length in mm, positive.
    sensor_size : array_like, shape (2,)
        Width and height of the light-sensitive area in mm.
    image_size : array_like, shape (2,)
        Width and height of the picture in px, taken with the whole sensor.

    Returns
    -------
    ndarray, shape (2,)
        ``[fx, fy]`` in px. They differ when the pixels are not square.

    Raises
    ------
    TypeError, ValueError
        If an argument has the wrong shape or is not positive and finite.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 6.1 (CCD cameras).

    Examples
    --------
    >>> pixel_focal_length(10, sensor_size=(8, 6), image_size=(800, 600))
    array([1000., 1000.])
    """
    f = check_length(f, "f")
    sensor_size = check_size(sensor_size, "sensor_size")
    image_size = check_size(image_size, "image_size")
    return f * image_size / sensor_size


def first_guess_intrinsics(f: float, sensor_size: ArrayLike, image_size: ArrayLike) -> Array:
    """Return the camera matrix that the data sheet of a camera and its lens suggest.

    Without a calibration, the optical axis is taken to meet the middle of the picture and the
    axes to be perpendicular (no skew).

    Parameters
    ----------
    f : float
        Focal length in mm, positive.
    sensor_size : array_like, shape (2,)
        Width and height of the light-sensitive area in mm.
    image_size : array_like, shape (2,)
        Width and height of the picture in px, taken with the whole sensor.

    Returns
    -------
    ndarray, shape (3, 3)
        ``K = [[fx, 0, cx], [0, fy, cy], [0, 0, 1]]`` in px. Mind where the middle is when the
        centre of the top-left pixel is ``(0, 0)``: for a picture 3 px wide it is the pixel 1.

    Raises
    ------
    TypeError, ValueError
        If an argument has the wrong shape or is not positive and finite.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 6.1 (CCD cameras).

    Examples
    --------
    >>> first_guess_intrinsics(10, sensor_size=(8.01, 6.01), image_size=(801, 601)).round()
    array([[1000.,    0.,  400.],
           [   0., 1000.,  300.],
           [   0.,    0.,    1.]])
    """
    fx, fy = pixel_focal_length(f, sensor_size, image_size)
    cx, cy = image_centre(image_size)
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])


def project_pinhole(points: ArrayLike, f: ArrayLike, c: ArrayLike) -> Array:
    """Return the image of points in front of a pinhole camera.

    Parameters
    ----------
    points : array_like, shape (N, 3) or (3,)
        Points ``(X, Y, Z)`` in the camera frame, in rows, in any unit of length.
    f : float or array_like, shape (2,)
        Focal length in px; two numbers are ``(fx, fy)``.
    c : array_like, shape (2,)
        Principal point ``(cx, cy)`` in px.

    Returns
    -------
    ndarray, shape (N, 2) or (2,)
        Pixels ``(u, v)``. A point that is not in front of the camera, ``Z <= 0``, has no image:
        its row is ``(nan, nan)``. A point outside the picture's edges is returned all the same.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or f is not positive.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 6.1.

    Examples
    --------
    >>> project_pinhole([[0, 0, 2], [0.5, -0.25, 2], [0, 0, -2]], f=800, c=(320, 240))
    array([[320., 240.],
           [520., 140.],
           [ nan,  nan]])
    """
    points = check_points(points, 3, "points")
    f, c = check_pixel_focal(f, "f"), check_vector(c, 2, "c")
    Z = points[..., 2:]
    Z = np.where(Z > 0, Z, np.nan)
    return f * points[..., :2] / Z + c


def vanishing_point(direction: ArrayLike, f: ArrayLike, c: ArrayLike) -> Array:
    """Return the pixel in which all lines of one direction seem to meet.

    Parameters
    ----------
    direction : array_like, shape (3,) or (N, 3)
        Direction of the parallel lines in the camera frame, of any length but zero. The opposite
        direction belongs to the same lines and gives the same point.
    f : float or array_like, shape (2,)
        Focal length in px; two numbers are ``(fx, fy)``.
    c : array_like, shape (2,)
        Principal point ``(cx, cy)`` in px.

    Returns
    -------
    ndarray, shape (2,) or (N, 2)
        Pixel ``(u, v)``, which may lie far outside the picture. Lines parallel to the image plane
        stay parallel in the picture and meet nowhere: ``(nan, nan)``.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, f is not positive or a direction is zero.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 8.6.

    Examples
    --------
    >>> vanishing_point((1, 0, 2), f=800, c=(320, 240))
    array([720., 240.])
    """
    direction = check_directions(direction, "direction")
    f, c = check_pixel_focal(f, "f"), check_vector(c, 2, "c")
    Z = direction[..., 2:]
    Z = np.where(Z != 0, Z, np.nan)
    return f * direction[..., :2] / Z + c


def dolly_zoom(f: float, Z: ArrayLike, Z_new: ArrayLike) -> Array:
    """Return the focal length that keeps an object as large in the picture as it was.

    The camera moves along its axis, so that the object's distance changes from `Z` to `Z_new`;
    the zoom makes up for it. (What is nearer or farther than the object does change its size.)

    Parameters
    ----------
    f : float
        Focal length before the move, in mm, positive.
    Z : float
        Distance of the object from the hole before the move, positive.
    Z_new : float or array_like, shape (N,)
        Distance of the object after the move, positive, in the unit of `Z`.

    Returns
    -------
    float or ndarray, shape (N,)
        Focal length after the move, in mm.

    Raises
    ------
    TypeError, ValueError
        If an argument is not positive and finite.

    References
    ----------
    R. Szeliski, Computer Vision, 2nd ed., section 2.1.4.

    Examples
    --------
    >>> float(dolly_zoom(50, Z=2, Z_new=6))
    150.0
    """
    f = check_length(f, "f")
    Z, Z_new = check_positive(Z, "Z"), check_positive(Z_new, "Z_new")
    return f * Z_new / Z
