"""What a lens does to the light between the middle and the corner: less of it, and not all alike.

Use these functions through `course_lib.sensor`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array, check_length, check_numbers, check_vector
from course_lib.checks import check_points as check_pixels


def vignetting(angle: ArrayLike) -> Array:
    """Return how bright a plain lens makes a point off its axis, by that on the axis.

    Parameters
    ----------
    angle : float or array_like
        Angle between the ray through the middle of the lens and the optical axis, in rad.

    Returns
    -------
    float or ndarray
        Share of the light, 1 on the axis, 0 at a right angle: the fourth power of the cosine.

    Raises
    ------
    TypeError, ValueError
        If an angle is not a finite number, or beyond a right angle.

    References
    ----------
    W. J. Smith, Modern Optical Engineering, 4th ed., on radiometry (the cosine-fourth law).

    Examples
    --------
    >>> round(float(vignetting(np.pi / 4)), 6)
    0.25
    """
    return np.asarray(np.cos(_check_angle(angle)) ** 4)[()]


def mechanical_vignetting(
    angle: ArrayLike, pupil_diameter: float, rim_diameter: float, distance: float
) -> Array:
    """Return the share of a lens's opening that is still seen past the rim of its barrel.

    Seen from the side, the round opening and the round rim in front of it no longer lie behind
    each other; light passes where both disks overlap.

    Parameters
    ----------
    angle : float or array_like
        Angle between the direction of the light and the optical axis, in rad.
    pupil_diameter : float
        Diameter of the opening (the entrance pupil) in mm. Stopping down makes it smaller.
    rim_diameter : float
        Diameter of the rim in mm.
    distance : float
        From the opening to the rim, along the axis, in mm.

    Returns
    -------
    float or ndarray
        Share of the opening, 1 where nothing is cut off, 0 where nothing passes. The natural
        falloff (`vignetting`) comes on top.

    Raises
    ------
    TypeError, ValueError
        If a length is not positive, or an angle beyond a right angle.

    References
    ----------
    N. Asada, A. Amano, M. Baba, "Photometric calibration of zoom lens systems", ICPR 1996.

    Examples
    --------
    >>> mechanical_vignetting([0, 0.3, 0.6], 10, rim_diameter=20, distance=30).round(3)
    array([1.   , 0.537, 0.   ])
    """
    shift = check_length(distance, "distance") * np.tan(np.abs(_check_angle(angle)))
    pupil = check_length(pupil_diameter, "pupil_diameter") / 2
    rim = check_length(rim_diameter, "rim_diameter") / 2
    return _overlap(shift, pupil, rim) / (np.pi * pupil**2)


def lateral_chromatic_shift(pixels: ArrayLike, scale: float, centre: ArrayLike) -> Array:
    """Return where a colour's image lies, when the lens makes it a little larger than another's.

    Parameters
    ----------
    pixels : array_like, shape (N, 2) or (2,)
        Pixels ``(u, v)`` in the colour that is taken as it is, usually green.
    scale : float
        Magnification of the other colour by that of this one, such as 1.0008; positive.
    centre : array_like, shape (2,)
        Where the optical axis meets the picture, in px.

    Returns
    -------
    ndarray, shape (N, 2) or (2,)
        Pixels of the same points in the other colour.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or the scale is not positive.

    References
    ----------
    J. Mallon, P. Whelan, "Calibration and removal of lateral chromatic aberration in images",
    Pattern Recognition Letters 28 (2007) 125-135.

    Examples
    --------
    A thousandth makes a pixel and a bit in the corner of a picture 2000 px wide:

    >>> lateral_chromatic_shift((2000, 1500), 1.001, centre=(1000, 750))
    array([2001.  , 1500.75])
    """
    pixels = check_pixels(pixels, 2, "pixels")
    centre = check_vector(centre, 2, "centre")
    return centre + check_length(scale, "scale") * (pixels - centre)


def _check_angle(angle: ArrayLike) -> Array:
    angle = check_numbers(angle, "angle")
    if (np.abs(angle) > np.pi / 2).any():
        raise ValueError(
            f"angle must not be beyond a right angle, got {np.abs(angle).max():g} rad: "
            "degrees must be converted with np.radians"
        )
    return angle


def _overlap(distance: Array, r1: float, r2: float) -> Array:
    """Return the area that two disks of radii r1 and r2 share, their centres `distance` apart."""
    apart, inside = r1 + r2, abs(r1 - r2)
    d = np.clip(distance, max(inside, 1e-12 * apart), apart)
    # Two circular segments; the half-angles follow from the law of cosines.
    half_1 = np.arccos(np.clip((d**2 + r1**2 - r2**2) / (2 * d * r1), -1, 1))
    half_2 = np.arccos(np.clip((d**2 + r2**2 - r1**2) / (2 * d * r2), -1, 1))
    segment_1 = r1**2 * (half_1 - np.sin(half_1) * np.cos(half_1))
    segment_2 = r2**2 * (half_2 - np.sin(half_2) * np.cos(half_2))
    return np.asarray(segment_1 + segment_2)[()]
