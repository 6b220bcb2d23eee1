"""Corrections that learn: a polynomial over the picture, and a judge that holds points out.

Use these functions through `course_lib.resection`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.random import Generator
from numpy.typing import ArrayLike

from course_lib.checks import Array, check_points, check_size
from course_lib.least_squares.linear import solve_qr
from course_lib.resection.correction import check_residuals

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
    pixels, residuals = check_residuals(pixels, residuals)
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
    pixels, residuals = check_residuals(pixels, residuals, least=2)
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
