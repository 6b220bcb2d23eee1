"""What a camera model leaves over, corrected afterwards by a table over the picture.

A residual is measured minus computed, in px. Where residuals of many pictures agree, the model
lacks something, and subtracting what they agree on helps. Where they do not, a correction only
learns the noise: points that were held out tell. Use these functions through
`course_lib.resection`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array, check_numbers, check_points, check_size
from course_lib.correspondences import check_correspondences


def correction_table(
    pixels: ArrayLike,
    residuals: ArrayLike,
    image_size: tuple[int, int],
    shape: tuple[int, int],
) -> Array:
    """Return the mean residual in each cell of a grid over the picture.

    The grid's cells are equally large. Together they fill the picture, from its edge at -0.5 px to
    its edge at width - 0.5 (or height - 0.5). A pixel on the last edge belongs to the last cell.

    Parameters
    ----------
    pixels : array_like, shape (N, 2)
        Where residuals were measured, ``(u, v)`` in rows, all in the picture.
    residuals : array_like, shape (N, 2)
        Measured minus computed there, px.
    image_size : tuple of int
        Width and height of the picture in px.
    shape : tuple of int
        How many cells one above the other, and how many side by side: (rows, columns).

    Returns
    -------
    ndarray, shape (rows, columns, 2)
        The mean of the residuals whose pixels lie in each cell; zero for a cell without any.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, a pixel is outside of the picture, or the grid
        has no cells.

    References
    ----------
    T. Luhmann et al., Close-Range Photogrammetry and 3D Imaging, 3rd ed., section 3.3.4
    (correction grids).

    Examples
    --------
    >>> pixels, residuals = np.array([[0, 0], [9, 9]]), np.array([[1, 2], [3, 4]])
    >>> table = correction_table(pixels, residuals, (10, 10), (2, 2))
    >>> table[..., 0]  # the residuals of u
    array([[1., 0.],
           [0., 3.]])
    """
    pixels, residuals = check_residuals(pixels, residuals)
    size, (rows, columns) = check_size(image_size, "image_size"), check_shape(shape)
    share = (pixels + 0.5) / size  # from 0 at one edge to 1 at the other
    if share.min() < 0 or share.max() > 1:
        raise ValueError(f"pixels must be in the picture of {image_size}, -0.5 to width - 0.5")
    column = np.minimum((share[:, 0] * columns).astype(int), columns - 1)
    row = np.minimum((share[:, 1] * rows).astype(int), rows - 1)
    table = np.zeros((rows, columns, 2))
    for r in range(rows):
        for c in range(columns):
            inside = (row == r) & (column == c)
            if inside.any():
                table[r, c] = residuals[inside].mean(axis=0)
    return table


def correction_from_table(
    pixels: ArrayLike, table: ArrayLike, image_size: tuple[int, int]
) -> Array:
    """Return the residuals that a table expects at pixels: subtract them from what was measured.

    Between the middles of the cells it is bilinear; outside of the outermost ones it is constant.

    Parameters
    ----------
    pixels : array_like, shape (N, 2) or (2,)
        Where, ``(u, v)`` in rows.
    table : array_like, shape (rows, columns, 2)
        From `correction_table`.
    image_size : tuple of int
        Width and height of the picture in px.

    Returns
    -------
    ndarray, shape (N, 2) or (2,)
        What to subtract, px.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong or a number is not finite.

    References
    ----------
    As `correction_table`.

    Examples
    --------
    >>> table = [[[0, 0], [4, 0]]]  # one row of two cells, with middles at u = 4.5 and 14.5
    >>> correction_from_table([[0, 5], [9.5, 5], [14.5, 5]], table, (20, 10))
    array([[0., 0.],
           [2., 0.],
           [4., 0.]])
    """
    pixels, table = check_points(pixels, 2, "pixels"), check_numbers(table, "table")
    if table.ndim != 3 or table.shape[2] != 2 or not table.size:
        raise ValueError(f"table must have shape (rows, columns, 2), got {table.shape}")
    cells = np.array(table.shape[1::-1])
    # Counted in cells, with 0 in the middle of the first one.
    place = (pixels + 0.5) / check_size(image_size, "image_size") * cells - 0.5
    place = np.clip(place, 0, cells - 1)
    first = np.minimum(place.astype(int), np.maximum(cells - 2, 0))
    (c, r), (right, below) = np.moveaxis(first, -1, 0), np.moveaxis(place - first, -1, 0)[..., None]
    c2, r2 = np.minimum(c + 1, cells[0] - 1), np.minimum(r + 1, cells[1] - 1)
    upper = (1 - right) * table[r, c] + right * table[r, c2]
    lower = (1 - right) * table[r2, c] + right * table[r2, c2]
    return np.asarray((1 - below) * upper + below * lower)


def check_shape(shape: tuple[int, int]) -> tuple[int, int]:
    """Return a grid's numbers of rows and columns, both one or more."""
    rows, columns = shape
    if not (isinstance(rows, int | np.integer) and isinstance(columns, int | np.integer)):
        raise TypeError(f"shape must be two whole numbers (rows, columns), got {shape!r}")
    if min(rows, columns) < 1:
        raise ValueError(f"shape must be one row and one column or more, got {shape!r}")
    return int(rows), int(columns)


def check_residuals(pixels: ArrayLike, residuals: ArrayLike, least: int = 1) -> tuple[Array, Array]:
    """Return pixels and what is left there, as many rows, and at least so many."""
    return check_correspondences(pixels, residuals, (2, 2), ("pixels", "residuals"), least)
