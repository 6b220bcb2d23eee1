"""Light as a tool: silhouettes before a bright field, stripes that show heights, ageing lamps."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.checks import (
    Array,
    check_number,
    check_numbers,
    check_positive,
    check_size,
)


def silhouette(image: ArrayLike, threshold: float) -> NDArray[np.bool_]:
    """Return which pixels show an object in front of a bright background.

    Parameters
    ----------
    image : array_like, shape (rows, columns)
        Grey values; the light comes from behind.
    threshold : float
        Grey values below it belong to the object.

    Returns
    -------
    ndarray, shape (rows, columns), bool
        True where the object is.

    Raises
    ------
    TypeError, ValueError
        If the picture is not one of grey values.
    """
    return np.asarray(check_grey(image) < check_number(threshold, "threshold"))


def silhouette_area(image: ArrayLike, threshold: float, pixel_size: ArrayLike) -> float:
    """Return the area of a dark object in front of a bright background.

    Parameters
    ----------
    image : array_like, shape (rows, columns)
        Grey values; the light comes from behind.
    threshold : float
        Grey values below it belong to the object; the threshold itself does not.
    pixel_size : float or array_like, shape (2,)
        What one pixel covers in the plane of the object: its side, or width and height, in mm.

    Returns
    -------
    float
        Area in mm². A hole through which the light falls does not count.

    Raises
    ------
    TypeError, ValueError
        If the picture is not one of grey values, or the size is not positive.

    References
    ----------
    R. Gonzalez, R. Woods, Digital Image Processing, 4th ed., section 10.3 (thresholding).

    Examples
    --------
    Three pixels of 0.5 mm × 0.5 mm:

    >>> image = np.array([[15, 15, 15], [15, 1, 15], [0, 0, 15]])
    >>> silhouette_area(image, threshold=8, pixel_size=0.5)
    0.75
    """
    dark = check_grey(image) < check_number(threshold, "threshold")
    size = check_positive(pixel_size, "pixel_size")
    width, height = (size, size) if size.ndim == 0 else check_size(size, "pixel_size")
    return float(np.count_nonzero(dark) * width * height)


def stripe_height(shift: ArrayLike, light_angle: float, camera_angle: float = 0.0) -> Array:
    """Return the height of a surface from the sideways shift of a stripe of light on it.

    A sheet of light falls on a table at a slant. Where something stands on the table, the light
    is stopped earlier, and the stripe appears moved towards the light.

    Parameters
    ----------
    shift : float or array_like
        How far the stripe seems moved along the table, by where it is when nothing stands there;
        positive towards the light, in mm.
    light_angle : float
        Between the sheet of light and the vertical, in rad.
    camera_angle : float
        Between the line of sight and the vertical, in rad, positive when the camera stands on the
        side away from the light; 0 when it looks straight down.

    Returns
    -------
    float or ndarray
        Height above the table in mm; a hollow is negative.

    Raises
    ------
    TypeError, ValueError
        If an angle reaches a right angle, or camera and light look along the same line.

    References
    ----------
    T. Luhmann et al., Close-Range Photogrammetry and 3D Imaging, 4th ed., chapter 6 (light
    sectioning).

    Examples
    --------
    >>> stripe_height(np.array([0, 2.5]), light_angle=np.pi / 4)
    array([0. , 2.5])
    """
    shift = check_numbers(shift, "shift")
    check_slants(light_angle, camera_angle)
    return shift / float(np.tan(light_angle) + np.tan(camera_angle))


def correct_lamp_drift(
    image: ArrayLike, patch: ArrayLike, patch_before: ArrayLike, offset: float = 0.0
) -> Array:
    """Return a picture as the lamp would have lit it when it was new.

    A patch of constant reflectance that is in all pictures says how much light there is: lamps
    lose light with age, and change it with temperature and voltage.

    Parameters
    ----------
    image : array_like, any shape
        Numbers, linear in light.
    patch, patch_before : array_like
        Numbers of the patch in this picture, and in the first one.
    offset : float
        DN of a picture without light.

    Returns
    -------
    ndarray, the shape of `image`
        Numbers, with the same offset.

    Raises
    ------
    TypeError, ValueError
        If a patch is not brighter than `offset`.

    Examples
    --------
    The lamp has lost a fifth:

    >>> correct_lamp_drift([16, 96, 176], patch=[176, 176], patch_before=[216, 216], offset=16)
    array([ 16., 116., 216.])
    """
    offset = check_number(offset, "offset")
    now, before = _mean(patch, "patch") - offset, _mean(patch_before, "patch_before") - offset
    if min(now, before) <= 0:
        raise ValueError("the patch must be brighter than the offset in both pictures")
    return offset + (check_numbers(image, "image") - offset) * (before / now)


def _mean(values: ArrayLike, name: str) -> float:
    array = check_numbers(values, name)
    if not array.size:
        raise ValueError(f"{name} must hold at least one number, got none: where does it lie?")
    return float(array.mean())


def check_grey(image: ArrayLike) -> Array:
    """Return a picture of grey values, shape (rows, columns), as `float64`."""
    array = check_numbers(image, "image")
    if array.ndim != 2 or not array.size:
        raise ValueError(
            f"image must have shape (rows, columns), got {array.shape}: a picture of grey values"
        )
    return array


def check_slants(light_angle: float, camera_angle: float) -> None:
    """Raise unless light and camera look at a height from two sides."""
    for angle, name in ((light_angle, "light_angle"), (camera_angle, "camera_angle")):
        if abs(check_number(angle, name)) >= np.pi / 2:
            raise ValueError(
                f"{name} must be less than a right angle, got {angle:g} rad: degrees must be "
                "converted with np.radians"
            )
    if abs(np.tan(light_angle) + np.tan(camera_angle)) < 1e-12:
        raise ValueError(
            "camera and light look along the same line: no height moves the stripe. Tilt one "
            "against the other"
        )
