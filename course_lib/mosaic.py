"""The colour mosaic on a sensor: one colour a pixel, and the two others guessed.

Rows and columns count from the top left; the pattern there is ``R G`` above ``G B`` ("RGGB"). Use
these functions through `course_lib.sensor`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.checks import check_numbers


def bayer_masks(shape: tuple[int, int]) -> NDArray[np.bool_]:
    """Return which pixels of an RGGB mosaic see which colour.

    Parameters
    ----------
    shape : tuple of int
        Rows and columns of the mosaic, both even.

    Returns
    -------
    ndarray, shape (rows, columns, 3), bool
        For red, green and blue: whether the pixel sees it. A quarter, a half and a quarter.

    Raises
    ------
    ValueError
        If the mosaic does not consist of whole 2 × 2 squares.

    Examples
    --------
    >>> bayer_masks((2, 2)).argmax(axis=2)
    array([[0, 1],
           [1, 2]])
    """
    rows, columns = shape
    if rows < 2 or columns < 2 or rows % 2 or columns % 2:
        raise ValueError(
            f"an RGGB mosaic needs an even number of rows and columns, got {rows} × {columns}: "
            "cut off the last row or column"
        )
    masks = np.zeros((rows, columns, 3), dtype=bool)
    masks[0::2, 0::2, 0] = True
    masks[0::2, 1::2, 1] = True
    masks[1::2, 0::2, 1] = True
    masks[1::2, 1::2, 2] = True
    return masks


def bayer_mosaic(image: ArrayLike) -> NDArray[np.generic]:
    """Return what a sensor behind a mosaic of colour filters sees of a colour picture.

    Parameters
    ----------
    image : array_like, shape (rows, columns, 3)
        Red, green and blue at every pixel; an even number of rows and of columns.

    Returns
    -------
    ndarray, shape (rows, columns)
        One number a pixel, of the type of `image`: the colour of its filter. The filters are
        ``R G R G …`` in the first row, ``G B G B …`` in the second, and so on ("RGGB").

    Raises
    ------
    TypeError, ValueError
        If `image` is not a colour picture, or has an odd number of rows or columns.

    References
    ----------
    B. E. Bayer, "Color imaging array", US patent 3,971,065 (1976).

    Examples
    --------
    >>> bayer_mosaic([[[1, 2, 3], [4, 5, 6]], [[7, 8, 9], [10, 11, 12]]])
    array([[ 1,  5],
           [ 8, 12]])
    """
    image = check_colour(image, "image")
    bayer_masks(image.shape[:2])
    mosaic = image[:, :, 1].copy()
    mosaic[0::2, 0::2] = image[0::2, 0::2, 0]
    mosaic[1::2, 1::2] = image[1::2, 1::2, 2]
    return mosaic


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
