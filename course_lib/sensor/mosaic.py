"""The colour mosaic on a sensor: one colour a pixel, and the two others guessed.

A pattern is named by the colours of the square of 2 × 2 pixels in the top left corner, row by row:
"RGGB" is ``R G`` above ``G B``. Use these functions through `course_lib.sensor`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.checks import Array, check_numbers


def bayer_masks(shape: tuple[int, ...], pattern: str = "RGGB") -> NDArray[np.bool_]:
    """Return which pixels of a mosaic see which colour.

    Parameters
    ----------
    shape : tuple of int
        Rows and columns of the mosaic, both even.
    pattern : str
        Colours of the first row's first two pixels, then of the second row's.

    Returns
    -------
    ndarray, shape (rows, columns, 3), bool
        For red, green and blue: whether the pixel sees it. A quarter, a half and a quarter.

    Raises
    ------
    ValueError
        If the mosaic does not consist of whole 2 × 2 squares, or the pattern is none.

    Examples
    --------
    >>> bayer_masks((2, 4), "GBRG").argmax(axis=2)
    array([[1, 2, 1, 2],
           [0, 1, 0, 1]])
    """
    if len(shape) != 2 or min(shape) < 2 or shape[0] % 2 or shape[1] % 2:
        raise ValueError(
            f"a mosaic has an even number of rows and of columns, got shape {tuple(shape)}: "
            "cut off the last row or column"
        )
    if sorted(pattern) != ["B", "G", "G", "R"]:
        raise ValueError(
            f"pattern must be like 'RGGB', with two G, one R and one B, got {pattern!r}"
        )
    masks = np.zeros((*shape, 3), dtype=bool)
    for i, letter in enumerate(pattern):
        masks[i // 2 :: 2, i % 2 :: 2, "RGB".index(letter)] = True
    return masks


def bayer_mosaic(image: ArrayLike, pattern: str = "RGGB") -> NDArray[np.generic]:
    """Return what a sensor behind a mosaic of colour filters sees of a colour picture.

    Parameters
    ----------
    image : array_like, shape (rows, columns, 3)
        Red, green and blue at every pixel; an even number of rows and of columns.
    pattern : str
        The filters of the top left square of 2 × 2 pixels, first row first. With "RGGB" the
        picture's first row is ``R G R G …``, the second ``G B G B …``, and so on in turns.

    Returns
    -------
    ndarray, shape (rows, columns)
        One number a pixel: the colour of its filter.

    Raises
    ------
    TypeError, ValueError
        If `image` is not a colour picture, has an odd number of rows or columns, or the pattern
        is none.

    References
    ----------
    B. E. Bayer, "Color imaging array", US patent 3,971,065 (1976).

    Examples
    --------
    >>> image = [[[1, 2, 3], [4, 5, 6]], [[7, 8, 9], [10, 11, 12]]]
    >>> bayer_mosaic(image)
    array([[ 1,  5],
           [ 8, 12]])
    >>> bayer_mosaic(image, "GBRG")
    array([[ 2,  6],
           [ 7, 11]])
    """
    image = check_colour(image, "image")
    bayer_masks(image.shape[:2], pattern)
    mosaic = np.empty(image.shape[:2], dtype=image.dtype)
    for i, letter in enumerate(pattern):
        square = slice(i // 2, None, 2), slice(i % 2, None, 2)
        mosaic[square] = image[..., "RGB".index(letter)][square]
    return mosaic


def demosaic_bilinear(mosaic: ArrayLike) -> Array:
    """Return a colour picture from an RGGB mosaic, with the missing colours interpolated.

    Parameters
    ----------
    mosaic : array_like, shape (rows, columns)
        One number a pixel behind the filters ``R G R G …`` (first row), ``G B G B …`` (second
        row) and so on; an even number of rows and of columns.

    Returns
    -------
    ndarray, shape (rows, columns, 3)
        Red, green and blue at every pixel. The colour that a pixel has seen is kept as it is. Each
        other colour is the mean of those of the 8 pixels around that have seen it and are nearest:
        2 or 4 of them inside the picture, fewer at its edge.

    Raises
    ------
    TypeError, ValueError
        If `mosaic` is not one number a pixel, or has an odd number of rows or columns.

    References
    ----------
    R. Szeliski, Computer Vision, 2nd ed., section 10.3.1 (demosaicing).

    Examples
    --------
    >>> demosaic_bilinear(np.array([[10, 2, 10, 2], [4, 7, 4, 7]]))[0, 1]
    array([10.,  2.,  7.])
    """
    from scipy.ndimage import convolve

    mosaic = check_numbers(mosaic, "mosaic")
    seen = bayer_masks(mosaic.shape).astype(np.float64)
    green = np.array([[0, 1, 0], [1, 4, 1], [0, 1, 0]]) / 4
    red_or_blue = np.array([[1, 2, 1], [2, 4, 2], [1, 2, 1]]) / 4
    layers = []
    for colour, weights in enumerate((red_or_blue, green, red_or_blue)):
        here = seen[..., colour]
        known = convolve(mosaic * here, weights, mode="constant")
        # At the edge some neighbours are missing: divide by the weights of those that are there.
        layers.append(known / convolve(here, weights, mode="constant"))
    return np.stack(layers, axis=-1)


def check_colour(image: ArrayLike, name: str) -> NDArray[np.generic]:
    """Return a colour picture, shape (rows, columns, 3), in its own type of number."""
    array = np.asarray(image)
    check_numbers(array, name)
    if array.ndim != 3 or array.shape[2] != 3:
        raise ValueError(
            f"{name} must have shape (rows, columns, 3), got {array.shape}: red, green and blue "
            "at every pixel"
        )
    return array
