"""Pictures bent by a map: every pixel of the new picture looks up its colour in the old one.

OpenCV does the looking up, between the four nearest pixels.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.checks import check_intrinsics, check_numbers
from course_lib.distortion import undistortion_map
from course_lib.distortion.model import check_coefficients

Picture = NDArray[Any]
#: Whole columns and rows, and both fractions in one number: what OpenCV reads fastest.
PackedMap = tuple[NDArray[np.int16], NDArray[np.uint16]]

#: Steps between two pixels.
STEPS = 32
#: Rows that are filled together: few enough for the processor's fast memory.
ROWS = 16
#: OpenCV counts pixels with 16 bits.
LARGEST_SIDE = 32766


def packed_map(map_u: ArrayLike, map_v: ArrayLike) -> PackedMap:
    """Return a map in whole numbers, rounded to a 32nd of a pixel.

    Parameters
    ----------
    map_u, map_v : array_like, shape (height, width)
        Column and row in the old picture, for each pixel of the new one, in px.

    Returns
    -------
    whole : ndarray, shape (height, width, 2), int16
        Columns and rows, rounded down; those in no picture are at -32768.
    fraction : ndarray, shape (height, width), uint16
        32 times the row's part of 32 plus the column's.

    Raises
    ------
    TypeError, ValueError
        If the shapes differ or a number is not finite.

    References
    ----------
    OpenCV, imgproc, ``convertMaps``.

    Examples
    --------
    >>> whole, fraction = packed_map([[2.5]], [[7.25]])
    >>> whole[0, 0], fraction[0, 0]
    (array([2, 7], dtype=int16), np.uint16(272))
    """
    u, v = check_numbers(map_u, "map_u"), check_numbers(map_v, "map_v")
    if u.ndim != 2 or u.shape != v.shape:
        raise ValueError(
            f"map_u and map_v must both have shape (height, width), got {u.shape} and {v.shape}"
        )
    ends = STEPS * np.iinfo(np.int16).min, STEPS * np.iinfo(np.int16).max
    steps = [np.clip(np.rint(STEPS * m), *ends).astype(np.int32) for m in (u, v)]
    whole = np.stack([m // STEPS for m in steps], axis=-1).astype(np.int16)
    across, down = (m % STEPS for m in steps)
    return whole, (STEPS * down + across).astype(np.uint16)


def remap(image: ArrayLike, packed: PackedMap) -> Picture:
    """Return a picture that looks up its colours in another.

    Parameters
    ----------
    image : array_like, shape (rows, columns) or (rows, columns, 3)
        The old picture, of ``uint8``, ``uint16``, ``float32`` or ``float64``.
    packed : tuple of ndarray
        Where to look, by `packed_map`.

    Returns
    -------
    ndarray, shape (height, width) or (height, width, 3)
        The new picture, interpolated bilinearly; black where the map leaves the old one.

    Raises
    ------
    TypeError, ValueError
        If `image` is not a picture of such numbers, is empty or larger than 32766 pixels.

    References
    ----------
    OpenCV, imgproc, ``remap``.

    Examples
    --------
    >>> remap(np.array([[0, 100]], dtype=np.uint8), packed_map([[0.5]], [[0]]))
    array([[50]], dtype=uint8)
    """
    import cv2

    image, (whole, fraction) = _check_picture(image), packed
    new = np.empty(fraction.shape + image.shape[2:], dtype=image.dtype)
    for top in range(0, len(new), ROWS):
        rows = slice(top, top + ROWS)
        cv2.remap(image, whole[rows], fraction[rows], cv2.INTER_LINEAR, dst=new[rows])
    return new


def undistort_picture(
    image: ArrayLike, K: ArrayLike, coefficients: ArrayLike, new_K: ArrayLike | None = None
) -> Picture:
    """Return the picture that a pinhole camera would have taken in place of a real lens.

    The map of the last two cameras is kept, so that a film needs it computed only once.

    Parameters
    ----------
    image : array_like, shape (rows, columns) or (rows, columns, 3)
        Picture with distortion, as in `remap`.
    K, coefficients : array_like
        Intrinsics in px, and the lens as in `course_lib.distortion.distort`.
    new_K : array_like, shape (3, 3), optional
        Intrinsics of the new picture; `K` unless given.

    Returns
    -------
    ndarray, shape of `image`
        The undistorted picture, black where the real one saw nothing.

    Raises
    ------
    TypeError, ValueError
        As `remap` and `course_lib.distortion.undistortion_map`.

    References
    ----------
    OpenCV, calib3d, ``undistort``.

    Examples
    --------
    >>> K = [[4, 0, 1], [0, 4, 1], [0, 0, 1]]
    >>> undistort_picture(np.full((3, 3), 7, dtype=np.uint8), K, [0])
    array([[7, 7, 7],
           [7, 7, 7],
           [7, 7, 7]], dtype=uint8)
    """
    image = _check_picture(image)
    K, k = check_intrinsics(K), check_coefficients(coefficients)
    new_K = K if new_K is None else check_intrinsics(new_K)
    return remap(image, _kept_map(K.tobytes(), k.tobytes(), new_K.tobytes(), image.shape[:2]))


@lru_cache(maxsize=2)
def _kept_map(K: bytes, coefficients: bytes, new_K: bytes, shape: tuple[int, int]) -> PackedMap:
    old, new = (np.frombuffer(matrix).reshape(3, 3) for matrix in (K, new_K))
    k, size = np.frombuffer(coefficients), (shape[1], shape[0])
    return packed_map(*undistortion_map(old, k, size, new, dtype=np.float64))


def _check_picture(image: ArrayLike) -> Picture:
    array = np.asarray(image)
    if array.dtype not in (np.uint8, np.uint16, np.float32, np.float64):
        raise TypeError(
            f"image must be uint8, uint16, float32 or float64, got {array.dtype}: "
            "convert it with astype"
        )
    if array.ndim not in (2, 3) or array.shape[2:] not in ((), (3,)) or 0 in array.shape:
        raise ValueError(
            f"image must have shape (rows, columns) or (rows, columns, 3), got {array.shape}"
        )
    if max(array.shape) > LARGEST_SIDE:
        raise ValueError(f"image must be at most {LARGEST_SIDE} pixels wide, got {array.shape}")
    return array
