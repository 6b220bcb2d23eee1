"""What a camera model leaves over, corrected afterwards: a table over the picture, or a polynomial.

A residual is measured minus computed, in px. Where residuals of many pictures agree, the model
lacks something, and subtracting what they agree on helps. Where they do not, a correction only
learns the noise: points that were held out tell. Use these functions through
`course_lib.resection`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.random import Generator
from numpy.typing import ArrayLike

from course_lib.checks import Array, check_numbers, check_pairs, check_points, check_size
from course_lib.linear_least_squares import solve_qr

NAMES = ("pixels", "residuals")

#: Takes pixels and residuals to learn from, and pixels; returns the residuals expected there.
Corrector = Callable[[Array, Array, Array], Array]


class HeldOut(NamedTuple):
    """How large residuals are, as root mean squares over points, in px.

    Attributes
    ----------
    before : float
        Without a correction.
    learned : float
        With it, at the points that it was learned from: never a reason to trust it.
    held_out : float
        With it, at points that it has not seen.
    """

    before: float
    learned: float
    held_out: float


def correction_table(
    pixels: ArrayLike,
    residuals: ArrayLike,
    image_size: tuple[int, int],
    shape: tuple[int, int],
) -> Array:
    """Return the mean residual in each cell of a grid over the picture.

    The grid's cells are equally large. Together they fill the picture, from its edge at -0.5 px to
    its edge at width - 0.5 (or height - 0.5).

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
    >>> table = correction_table([[0, 0], [9, 9]], [[1, 2], [3, 4]], (10, 10), (2, 2))
    >>> table[..., 0]  # the residuals of u
    array([[1., 0.],
           [0., 3.]])
    """
    pixels, residuals = check_pairs(pixels, residuals, (2, 2), NAMES, least=1)
    size, (rows, columns) = check_size(image_size, "image_size"), _check_shape(shape)
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


def polynomial_correction(
    pixels: ArrayLike, residuals: ArrayLike, image_size: tuple[int, int], degree: int
) -> Array:
    """Learn the polynomial over the picture that fits residuals best.

    Parameters
    ----------
    pixels, residuals : array_like, shape (N, 2)
        As in `correction_table`.
    image_size : tuple of int
        Width and height of the picture in px.
    degree : int
        Largest sum of the powers of u and v, 0 to 12: the larger, the more of the noise it fits.

    Returns
    -------
    ndarray, shape (n, 2)
        Coefficients for `correction_from_polynomial`; n = (degree + 1)(degree + 2)/2.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, the degree is not one of those, or there are
        fewer points than coefficients.
    DegenerateConfigurationError
        If the points do not determine the polynomial.

    References
    ----------
    C. M. Bishop, Pattern Recognition and Machine Learning, section 1.1 (fitting and overfitting).
    """
    pixels, residuals = check_pairs(pixels, residuals, (2, 2), NAMES, least=1)
    if degree not in range(13):
        raise ValueError(f"degree must be a whole number from 0 to 12, got {degree!r}")
    return solve_qr(_terms(pixels, image_size, degree), residuals)


def correction_from_polynomial(
    pixels: ArrayLike, coefficients: ArrayLike, image_size: tuple[int, int]
) -> Array:
    """Return the residuals that a polynomial expects at pixels.

    Parameters
    ----------
    pixels : array_like, shape (N, 2) or (2,)
        Where, ``(u, v)`` in rows.
    coefficients : array_like, shape (n, 2)
        From `polynomial_correction`.
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
    As `polynomial_correction`.
    """
    pixels = check_points(pixels, 2, "pixels")
    coefficients = check_points(coefficients, 2, "coefficients")
    degree = round(np.sqrt(2 * len(coefficients) + 0.25) - 1.5)
    if coefficients.ndim != 2 or len(coefficients) != (degree + 1) * (degree + 2) // 2:
        raise ValueError(f"coefficients must be 1, 3, 6, 10 … rows, got {coefficients.shape}")
    terms = _terms(pixels.reshape(-1, 2), image_size, degree)
    return (terms @ coefficients).reshape(pixels.shape)


def hold_out(
    correct: Corrector, pixels: ArrayLike, residuals: ArrayLike, parts: int, rng: Generator
) -> HeldOut:
    """Judge a correction by points that it has not seen.

    The points are dealt into parts; each part is corrected by what was learned from the others.

    Parameters
    ----------
    correct : callable
        Takes pixels and residuals to learn from, and other pixels; returns the residuals that it
        expects there.
    pixels, residuals : array_like, shape (N, 2)
        As in `correction_table`.
    parts : int
        How many parts, from 2 to N.
    rng : numpy.random.Generator
        Deals the points.

    Returns
    -------
    HeldOut
        Root mean squares without and with the correction. It helps if `held_out` is below `before`.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or the number of parts is none of those.

    References
    ----------
    T. Hastie, R. Tibshirani, J. Friedman, The Elements of Statistical Learning, 2nd ed., section
    7.10 (cross-validation).
    """
    pixels, residuals = check_pairs(pixels, residuals, (2, 2), NAMES, least=2)
    if parts not in range(2, len(pixels) + 1):
        raise ValueError(f"parts must be from 2 to {len(pixels)}, the number of points: {parts!r}")
    part = rng.permutation(np.arange(len(pixels)) % parts)
    left = residuals - correct(pixels, residuals, pixels)
    unseen = residuals.copy()
    for number in range(parts):
        out = part == number
        unseen[out] -= correct(pixels[~out], residuals[~out], pixels[out])
    return HeldOut(_rms(residuals), _rms(left), _rms(unseen))


def _rms(residuals: Array) -> float:
    return float(np.sqrt(np.mean((residuals**2).sum(axis=1))))


def _terms(pixels: Array, image_size: tuple[int, int], degree: int) -> Array:
    """Return the products of Legendre polynomials of u and v up to a degree, shape (N, n).

    The picture is the square from -1 to 1, where these are nearly perpendicular.
    """
    x, y = (2 * (pixels + 0.5) / check_size(image_size, "image_size") - 1).T
    along, down = (np.polynomial.legendre.legvander(a, degree) for a in (x, y))
    powers = [(i, j) for i in range(degree + 1) for j in range(degree + 1 - i)]
    return np.stack([along[:, i] * down[:, j] for i, j in powers], axis=1)


def _check_shape(shape: tuple[int, int]) -> tuple[int, int]:
    rows, columns = shape
    if not (isinstance(rows, int | np.integer) and isinstance(columns, int | np.integer)):
        raise TypeError(f"shape must be two whole numbers (rows, columns), got {shape!r}")
    if min(rows, columns) < 1:
        raise ValueError(f"shape must be one row and one column or more, got {shape!r}")
    return int(rows), int(columns)
