"""The thin lens: where it makes an image, and how large.

Distances are measured from the lens along the optical axis, in mm. Use these functions through
`course_lib.optics`.
"""

from __future__ import annotations

from numpy.typing import ArrayLike

from course_lib.checks import (
    Array,
    check_distance,
    check_outside_focus,
    check_positive,
)


def image_distance(f: ArrayLike, Z: ArrayLike) -> Array:
    """Return where a thin lens makes the sharp image of an object.

    Parameters
    ----------
    f : float or array_like
        Focal length in mm, positive.
    Z : float or array_like
        Distance from the object to the lens in mm, larger than f; ``np.inf`` for a star. Arrays
        broadcast.

    Returns
    -------
    float or ndarray
        Distance from the lens to the sharp image in mm, with the broadcast shape.

    Raises
    ------
    TypeError, ValueError
        If an argument is not positive, or the object is not outside the focal length: then the
        light leaves the lens without meeting, and the image is virtual.

    References
    ----------
    E. Hecht, Optics, 5th ed., section 5.2.3 (the Gaussian lens formula).

    Examples
    --------
    >>> float(image_distance(50, Z=250))
    62.5
    """
    f, Z = check_positive(f, "f"), check_distance(Z, "Z")
    check_outside_focus(Z, f, "Z")
    return f / (1 - f / Z)  # 1/f = 1/Z + 1/image_distance, finite for Z = inf


def magnification(f: ArrayLike, Z: ArrayLike) -> Array:
    """Return how large the sharp image of an object is: image size divided by object size.

    Parameters
    ----------
    f : float or array_like
        Focal length in mm, positive.
    Z : float or array_like
        Distance from the object to the lens in mm, larger than f; ``np.inf`` gives 0.

    Returns
    -------
    float or ndarray
        Magnification, positive. (The image on the sensor stands on its head.)

    Raises
    ------
    TypeError, ValueError
        As `image_distance`.

    References
    ----------
    E. Hecht, Optics, 5th ed., section 5.2.3 (transverse magnification).

    Examples
    --------
    >>> float(magnification(50, Z=250))
    0.25
    """
    return image_distance(f, Z) / check_distance(Z, "Z")


def object_distance(f: ArrayLike, m: ArrayLike) -> Array:
    """Return how far from the lens an object stands that is imaged with a given magnification.

    Parameters
    ----------
    f : float or array_like
        Focal length in mm, positive.
    m : float or array_like
        Magnification, positive: size of the sharp image divided by the size of the object.

    Returns
    -------
    float or ndarray
        Distance from the object to the lens in mm.

    Raises
    ------
    TypeError, ValueError
        If an argument is not positive and finite.

    References
    ----------
    E. Hecht, Optics, 5th ed., section 5.2.3 (transverse magnification).

    Examples
    --------
    >>> float(object_distance(50, m=0.25))
    250.0
    """
    f, m = check_positive(f, "f"), check_positive(m, "m")
    return f * (1 + 1 / m)


def optical_power(f: ArrayLike) -> Array:
    """Return the power of a lens in dioptres (1/m): the inverse of its focal length.

    Parameters
    ----------
    f : float or array_like
        Focal length in mm, positive.

    Returns
    -------
    float or ndarray
        Power in dioptres.

    Raises
    ------
    TypeError, ValueError
        If f is not positive and finite.

    References
    ----------
    E. Hecht, Optics, 5th ed., section 5.7.2 (dioptric power).

    Examples
    --------
    >>> float(optical_power(50))
    20.0
    """
    return 1000 / check_positive(f, "f")


def pixel_on_object(pitch: ArrayLike, m: ArrayLike) -> Array:
    """Return how much of the object one pixel sees.

    Parameters
    ----------
    pitch : float or array_like
        Distance from one pixel to the next on the sensor, positive, in any unit of length.
    m : float or array_like
        Magnification, positive.

    Returns
    -------
    float or ndarray
        Width of a pixel on the object, in the unit of `pitch`.

    Raises
    ------
    TypeError, ValueError
        If an argument is not positive and finite.

    References
    ----------
    E. Hecht, Optics, 5th ed., section 5.2.3 (transverse magnification).

    Examples
    --------
    >>> round(float(pixel_on_object(0.04, m=1 / 20)), 3)
    0.8
    """
    return check_positive(pitch, "pitch") / check_positive(m, "m")
