"""What the hole and the sensor decide, before there is a lens: view and sharpness."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    Array,
    check_length,
    check_positive,
    check_size,
)


def field_of_view(f: float, sensor_size: ArrayLike) -> Array:
    """Return the angles of view: across, up and down, and from corner to corner.

    Parameters
    ----------
    f : float
        Focal length in mm, positive.
    sensor_size : array_like, shape (2,)
        Width and height of the light-sensitive area in mm.

    Returns
    -------
    ndarray, shape (3,)
        ``[horizontal, vertical, diagonal]`` in rad, each the full angle between opposite edges
        (or corners) of the picture.

    Raises
    ------
    TypeError, ValueError
        If an argument has the wrong shape or is not positive and finite.

    References
    ----------
    R. Szeliski, Computer Vision, 2nd ed., section 2.1.4.

    Examples
    --------
    >>> np.degrees(field_of_view(4, sensor_size=(8, 6))).round(2)
    array([ 90.  ,  73.74, 102.68])
    """
    f = check_length(f, "f")
    width, height = check_size(sensor_size, "sensor_size")
    extent = np.array([width, height, np.hypot(width, height)])
    return 2 * np.arctan(extent / (2 * f))


def equivalent_focal_length(f: float, sensor_size: ArrayLike) -> float:
    """Return the focal length that shows the same on a 36 mm × 24 mm sensor ("full frame").

    "The same" is the angle of view from corner to corner, as sensors differ in shape.

    Parameters
    ----------
    f : float
        Focal length in mm, positive.
    sensor_size : array_like, shape (2,)
        Width and height of the light-sensitive area in mm.

    Returns
    -------
    float
        35 mm equivalent focal length in mm.

    Raises
    ------
    TypeError, ValueError
        If an argument has the wrong shape or is not positive and finite.

    References
    ----------
    CIPA DCG-001, Guideline for Noting Digital Camera Specifications in Catalogs, "35 mm film
    equivalent focal length".

    Examples
    --------
    >>> round(equivalent_focal_length(25, sensor_size=(17.3, 13.0)), 2)
    49.98
    """
    f = check_length(f, "f")
    width, height = check_size(sensor_size, "sensor_size")
    return float(f * np.hypot(36, 24) / np.hypot(width, height))


def pinhole_blur_diameter(d: ArrayLike, image_distance: ArrayLike, Z: ArrayLike) -> Array:
    """Return the diameter of the spot that a point of light makes through a round hole.

    Light is taken to travel in straight lines only (no diffraction).

    Parameters
    ----------
    d : float or array_like
        Diameter of the hole in mm, positive.
    image_distance : float or array_like
        Distance from the hole to the sensor in mm, positive.
    Z : float or array_like
        Distance from the point of light to the hole in mm, positive. Arrays broadcast.

    Returns
    -------
    float or ndarray
        Diameter of the spot on the sensor in mm, with the broadcast shape.

    Raises
    ------
    TypeError, ValueError
        If an argument is not positive and finite.

    References
    ----------
    E. Hecht, Optics, 5th ed., section 5.7.6 (the camera).

    Examples
    --------
    >>> float(pinhole_blur_diameter(0.5, image_distance=100, Z=200))
    0.75
    """
    d, Z = check_positive(d, "d"), check_positive(Z, "Z")
    image_distance = check_positive(image_distance, "image_distance")
    return d * (Z + image_distance) / Z


def best_pinhole_diameter(image_distance: ArrayLike, wavelength: ArrayLike) -> Array:
    """Return the diameter of the hole that makes the sharpest picture of a far object.

    A large hole blurs by its size, a small one by diffraction. The spot is taken as the sum of
    the two diameters: the geometric one of a very distant point, and the Airy disk's. The
    sharpest picture has the smallest spot.

    Parameters
    ----------
    image_distance : float or array_like
        Distance from the hole to the sensor, positive.
    wavelength : float or array_like
        Wavelength of the light, positive, in the same unit (550 nm are 0.00055 mm).

    Returns
    -------
    float or ndarray
        Best diameter of the hole, in the same unit.

    Raises
    ------
    TypeError, ValueError
        If an argument is not positive and finite.

    References
    ----------
    E. Hecht, Optics, 5th ed., section 5.7.6 (the camera); M. Young, "Pinhole optics",
    Applied Optics 10 (1971) 2763-2767.

    Examples
    --------
    >>> round(float(best_pinhole_diameter(50, 0.00055)), 3)
    0.259
    """
    image_distance = check_positive(image_distance, "image_distance")
    wavelength = check_positive(wavelength, "wavelength")
    return np.sqrt(2.44 * wavelength * image_distance)
