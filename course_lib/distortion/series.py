"""Distortion as photogrammetry computes it: polynomials of image coordinates, in px or mm.

Use these functions through `course_lib.distortion`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    Array,
    check_length,
    check_number,
    check_numbers,
    check_points,
    check_vector,
)
from course_lib.distortion.inverse import valid_radius
from course_lib.distortion.model import LARGEST_COEFFICIENT, check_coefficients, radial_factor

#: No image is larger, in px or mm.
LARGEST_IMAGE = 1e6


def distort_photogrammetric(
    points: ArrayLike, centre: ArrayLike, radial: ArrayLike, tangential: ArrayLike = (0, 0)
) -> Array:
    """Return distorted image points, by photogrammetry's form.

    ``D(L) = C + CL (1 + α d² + β d⁴ + γ d⁶ + …)``, and the tangential P-series
    ``(P2 (d² + 2 x²) + 2 P1 x y) (1 + P3 d² + P4 d⁴ + …)`` in x, alike in y.

    Parameters
    ----------
    points : array_like, shape (N, 2) or (2,)
        Ideal image points L, in px or mm, in rows.
    centre : array_like, shape (2,)
        Centre of distortion C, in the same unit.
    radial : array_like, shape (n,)
        α, β, γ, …
    tangential : array_like, shape (m,)
        P1, P2, and possibly P3, P4, …

    Returns
    -------
    ndarray, shape (N, 2) or (2,)
        Points in the real image.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite or there is a P1 without P2.

    References
    ----------
    D. C. Brown, "Decentering distortion of lenses", Photogrammetric Engineering 32 (1966).

    Examples
    --------
    >>> distort_photogrammetric([1500, 500], (500, 500), [-1e-7])
    array([1400.,  500.])
    """
    k, p = _check_series(radial, "radial", 1), _check_series(tangential, "tangential", 2)
    offset = _check_image(points, "points") - _check_image(
        check_vector(centre, 2, "centre"), "centre"
    )
    d2 = (offset**2).sum(axis=-1, keepdims=True)
    swapped = np.array([p[1], p[0]])
    # x: P2 (d² + 2 x²) + 2 P1 x y = P2 d² + 2 x (P2 x + P1 y); alike for y.
    bent = swapped * d2 + 2 * offset * (offset @ swapped)[..., None]
    polyval = np.polynomial.polynomial.polyval
    moved = offset * polyval(d2, [1, *k]) + bent * polyval(d2, [1, *p[2:]])
    return np.asarray(centre + moved)


def ebner(points: ArrayLike, coefficients: ArrayLike, b: float) -> Array:
    """Return what Ebner's polynomial adds to image points, for what a physical model leaves over.

    Its twelve terms do not disturb each other, nor a shift, on a grid of 3 × 3 points with the
    spacing b.

    Parameters
    ----------
    points : array_like, shape (N, 2) or (2,)
        Image points from the centre of the picture, in px or mm, in rows.
    coefficients : array_like, shape (12,)
        ``b1 … b12``; the first is in no unit, later ones by the unit to some power.
    b : float
        Half the side of the square that is to be covered, in the same unit.

    Returns
    -------
    ndarray, shape (N, 2) or (2,)
        Displacements in the same unit.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite or `b` is not positive.

    References
    ----------
    H. Ebner, "Self calibrating block adjustment", Bildmessung und Luftbildwesen 44 (1976). The
    terms, their order and their signs were compared with those of MicMac, the photogrammetric
    software of IGN (``phgr_ebner_brown_dist.cpp``): they are the same.

    Examples
    --------
    >>> ebner([10, 20], [0.001, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0], b=100)
    array([ 0.01, -0.02])
    """
    points, b = _check_image(points, "points"), check_length(b, "b")
    c = check_vector(_check_series(coefficients, "coefficients", 12), 12, "coefficients")
    x, y = points[..., 0], points[..., 1]
    u, v = x**2 - 2 * b**2 / 3, y**2 - 2 * b**2 / 3
    across = c[0] * x + c[1] * y - 2 * c[2] * u + c[3] * x * y + c[4] * v
    across = across + c[6] * x * v + c[8] * y * u + c[10] * u * v
    down = -c[0] * y + c[1] * x + c[2] * x * y - 2 * c[3] * v + c[5] * u
    down = down + c[7] * y * u + c[9] * x * v + c[11] * u * v
    return np.stack([across, down], axis=-1)


def radial_correction(
    coefficients: ArrayLike, radius: float, terms: int = 3
) -> tuple[Array, float]:
    """Return the polynomial that takes radial distortion back, as many programs state it.

    They give the correction, from the measured point to the ideal one, and not the distortion. The
    inverse of a polynomial is none, but a fit comes close.

    Parameters
    ----------
    coefficients : array_like, shape (1,), (2,), (4,), (5,), (8,) or (12,)
        As in `distort`; the tangential and prism terms are left out.
    radius : float
        Up to which ideal distance from the centre, in normalised coordinates, it must fit.
    terms : int
        How many coefficients, at most ten.

    Returns
    -------
    corrections : ndarray, shape (terms,)
        ``c1, c2, …`` for ``r = r_d (1 + c1 r_d² + c2 r_d⁴ + …)``; `distort_radial` applies them.
    largest_error : float
        Largest deviation of that from the ideal distance, in normalised coordinates.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, or the radius is not positive or beyond `valid_radius`.

    References
    ----------
    P. Drap, J. Lefèvre, "An exact formula for calculating inverse radial lens distortions",
    Sensors 16 (2016).

    Examples
    --------
    >>> corrections, error = radial_correction([-0.2], radius=0.5)
    >>> corrections.round(3)
    array([0.2  , 0.11 , 0.156])
    """
    k, limit = check_coefficients(coefficients), valid_radius(coefficients)
    if not 1e-6 <= check_number(radius, "radius") <= limit:
        raise ValueError(
            f"radius must be above 1e-6 and not beyond the valid radius {limit:g}, got {radius:g}"
        )
    if not 1 <= terms <= 10:
        raise ValueError(f"terms must be 1 to 10, got {terms}")
    # Chebyshev's places keep the largest error near the smallest possible.
    r = radius * np.sin(np.linspace(0, np.pi / 2, 201)[1:])
    r_d = r * radial_factor(r * r, k)
    unit = r_d / r_d[-1]
    powers = 2 * np.arange(1, terms + 1)
    design = unit[:, None] ** (powers + 1)
    scaled, *_ = np.linalg.lstsq(design, (r - r_d) / r_d[-1], rcond=None)
    error = float(np.abs(r_d + design @ scaled * r_d[-1] - r).max())
    return scaled / r_d[-1] ** powers, error


def _check_series(value: ArrayLike, name: str, least: int) -> Array:
    numbers = np.atleast_1d(check_numbers(value, name))
    if numbers.ndim != 1 or not least <= numbers.size <= 12:
        raise ValueError(f"{name} must be {least} to 12 numbers, got shape {numbers.shape}")
    if np.abs(numbers).max() > LARGEST_COEFFICIENT:
        raise ValueError(f"{name} holds {np.abs(numbers).max():g}, which no lens has")
    return numbers


def _check_image(value: ArrayLike, name: str) -> Array:
    points = check_points(value, 2, name)
    if points.size and np.abs(points).max() > LARGEST_IMAGE:
        raise ValueError(
            f"{name} must be in px or mm in the image, got {np.abs(points).max():g}: check the unit"
        )
    return points
