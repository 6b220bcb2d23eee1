"""The lens bends: where a ray that a pinhole would send to (x, y) really meets the image.

Distortion acts on normalised coordinates ``x = X/Z, y = Y/Z``, before the intrinsics make pixels of
them. The coefficients are OpenCV's, in its order: ``k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4``. With
``r² = x² + y²``,

    x_d = x g + 2 p1 x y + p2 (r² + 2 x²) + s1 r² + s2 r⁴
    y_d = y g + p1 (r² + 2 y²) + 2 p2 x y + s3 r² + s4 r⁴
    g = (1 + k1 r² + k2 r⁴ + k3 r⁶) / (1 + k4 r² + k5 r⁴ + k6 r⁶)

Use these functions through `course_lib.distortion`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array, check_numbers, check_points, check_vector

#: How many coefficients make a model: quadratic, radial, Brown-Conrady, rational, thin prism.
COUNTS = (1, 2, 4, 5, 8, 12)
#: A tangent beyond this is no field of view; it was a pixel or a length.
LARGEST_TANGENT = 1e6
LARGEST_COEFFICIENT = 1e30
#: Places of the tangential and prism terms, which do not act along the line from the centre.
SIDEWAYS = [2, 3, 8, 9, 10, 11]


def distort(points: ArrayLike, coefficients: ArrayLike) -> Array:
    """Return where a lens with distortion images the rays of an ideal one.

    Parameters
    ----------
    points : array_like, shape (N, 2) or (2,)
        Ideal points in normalised coordinates ``(X/Z, Y/Z)``, in rows.
    coefficients : array_like, shape (1,), (2,), (4,), (5,), (8,) or (12,)
        ``k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4``, or the first of them; the rest is zero. One is the
        quadratic model, five are Brown's and Conrady's, eight the rational, twelve have a prism.

    Returns
    -------
    ndarray, shape (N, 2) or (2,)
        Distorted points in normalised coordinates. Beyond `valid_radius` the model has folded over
        and its numbers are no picture of anything. A row of NaN for a point at which the rational
        model divides by zero.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or the points are pixels rather than tangents.

    References
    ----------
    D. C. Brown, "Close-range camera calibration", Photogrammetric Engineering 37 (1971); OpenCV,
    calib3d, detailed description (rational and thin prism terms).

    Examples
    --------
    >>> distort([[0.5, 0], [0, 0.5]], [-0.2])
    array([[0.475, 0.   ],
           [0.   , 0.475]])
    """
    points, k = check_normalised(points, "points"), check_coefficients(coefficients)
    distorted = np.empty_like(points)
    distorted[..., 0], distorted[..., 1] = distorted_columns(*columns(points), k)
    return distorted


def distort_radial(points: ArrayLike, k: ArrayLike) -> Array:
    """Return points moved along the line from the centre, by a polynomial of their distance.

    Parameters
    ----------
    points : array_like, shape (N, 2) or (2,)
        Ideal points in normalised coordinates, in rows.
    k : float or array_like, shape (n,)
        Radial coefficients ``k1, k2, …``; a single one is the quadratic model. Negative ``k1``
        draws corners in (barrel), positive pulls them out (pincushion).

    Returns
    -------
    ndarray, shape (N, 2) or (2,)
        The points times ``1 + k1 r² + k2 r⁴ + …``.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, there are more than ten coefficients, or the
        points are pixels rather than tangents.

    References
    ----------
    R. Szeliski, Computer Vision, 2nd ed., section 2.1.5 (radial distortion).

    Examples
    --------
    >>> distort_radial([0.6, 0.8], [-0.2, 0.05])
    array([0.51, 0.68])
    """
    points, k = check_normalised(points, "points"), np.atleast_1d(check_numbers(k, "k"))
    if k.ndim != 1 or not 1 <= k.size <= 10 or np.abs(k).max() > LARGEST_COEFFICIENT:
        raise ValueError(f"k must be up to ten coefficients k1, k2, …, got shape {k.shape}")
    r2 = (points**2).sum(axis=-1, keepdims=True)
    return np.asarray(points * np.polynomial.polynomial.polyval(r2, [1, *k]))


def distort_rational_prism(points: ArrayLike, k: ArrayLike, p: ArrayLike, s: ArrayLike) -> Array:
    """Return distorted points by the full model, its coefficients grouped by what they do.

    Parameters
    ----------
    points : array_like, shape (N, 2) or (2,)
        Ideal points in normalised coordinates, in rows.
    k : array_like, shape (6,)
        Radial: ``k1 k2 k3`` of the numerator, ``k4 k5 k6`` of the denominator.
    p : array_like, shape (2,)
        Tangential, ``p1 p2``: lens elements that are not centred.
    s : array_like, shape (4,)
        Thin prism, ``s1 s2`` for x, ``s3 s4`` for y: elements or a sensor that are tilted.

    Returns
    -------
    ndarray, shape (N, 2) or (2,)
        Distorted points, as by `distort` with the same twelve numbers in OpenCV's order.

    Raises
    ------
    TypeError, ValueError
        As `distort`.

    References
    ----------
    J. Weng, P. Cohen, M. Herniou, "Camera calibration with distortion models and accuracy
    evaluation", IEEE PAMI 14 (1992); OpenCV, calib3d, detailed description.

    Examples
    --------
    >>> distort_rational_prism([1, 0], [0, 0, 0, 1, 0, 0], p=[0, 0.01], s=[0.002, 0, 0, 0])
    array([0.532, 0.   ])
    """
    k, p, s = check_vector(k, 6, "k"), check_vector(p, 2, "p"), check_vector(s, 4, "s")
    return distort(points, [*k[:2], *p, *k[2:], *s])


def distortion_jacobian(points: ArrayLike, coefficients: ArrayLike) -> Array:
    """Return how a distorted point moves when the ideal one does.

    Parameters
    ----------
    points, coefficients : array_like
        As in `distort`.

    Returns
    -------
    ndarray, shape (N, 2, 2) or (2, 2)
        ``[[∂x_d/∂x, ∂x_d/∂y], [∂y_d/∂x, ∂y_d/∂y]]``. Where its determinant is zero, the picture
        folds over.

    Raises
    ------
    TypeError, ValueError
        As `distort`.

    References
    ----------
    The derivative of the equations at the head of this module.

    Examples
    --------
    >>> distortion_jacobian([1, 0], [-0.2])
    array([[0.4, 0. ],
           [0. , 0.8]])
    """
    points, k = check_normalised(points, "points"), check_coefficients(coefficients)
    _, _, xx, xy, yx, yy = distorted_columns_and_slopes(*columns(points), k)
    return np.moveaxis(np.array([[xx, xy], [yx, yy]]), (0, 1), (-2, -1))


def radial_factor(r2: Array, k: Array) -> Array:
    """Return g, what the distance from the centre is multiplied with, from r²."""
    factor = 1 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]))
    if k[5:8].any():
        factor /= 1 + r2 * (k[5] + r2 * (k[6] + r2 * k[7]))
    return np.asarray(factor)


def radial_factor_and_slope(r2: Array, k: Array) -> tuple[Array, Array]:
    """Return g and dg/d(r²)."""
    factor = 1 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]))
    slope = k[0] + r2 * (2 * k[1] + r2 * (3 * k[4]))
    if k[5:8].any():
        below = 1 + r2 * (k[5] + r2 * (k[6] + r2 * k[7]))
        factor /= below
        slope -= factor * (k[5] + r2 * (2 * k[6] + r2 * (3 * k[7])))  # (N' - g D') / D
        slope /= below
    return factor, slope


def sideways_columns(x: Array, y: Array, k: Array) -> tuple[Array, Array]:
    """Return what the tangential and prism terms add to x and y."""
    _, _, p1, p2, *_, s1, s2, s3, s4 = k
    r2 = x * x + y * y
    prism = r2 if k[8:].any() else np.float64(0)  # without a prism, s1 … s4 are zero
    g = 2 * (p1 * y + p2 * x)  # 2 p1 x y + 2 p2 x² = x (2 p1 y + 2 p2 x), alike for y
    return x * g + r2 * (p2 + s1 + s2 * prism), y * g + r2 * (p1 + s3 + s4 * prism)


def distorted_columns(x: Array, y: Array, k: Array) -> tuple[Array, Array]:
    """Return x_d and y_d, from twelve checked coefficients."""
    with np.errstate(divide="ignore", invalid="ignore"):
        g = radial_factor(x * x + y * y, k)
        x_d, y_d = x * g, y * g
    if k[SIDEWAYS].any():
        aside_x, aside_y = sideways_columns(x, y, k)
        x_d += aside_x
        y_d += aside_y
    bad = ~np.isfinite(x_d + y_d)
    return np.where(bad, np.nan, x_d), np.where(bad, np.nan, y_d)


def distorted_columns_and_slopes(x: Array, y: Array, k: Array) -> tuple[Array, ...]:
    """Return x_d, y_d and their derivatives by x and y: xx, xy, yx, yy."""
    _, _, p1, p2, *_, s1, s2, s3, s4 = k
    r2 = x * x + y * y
    with np.errstate(divide="ignore", invalid="ignore"):
        g, slope = radial_factor_and_slope(r2, k)
        g += 2 * (p1 * y + p2 * x)
    # g depends on x through r² and through p2, on y through r² and p1.
    slope *= 2
    g_x, g_y = slope * x + 2 * p2, slope * y + 2 * p1
    prism = r2 if k[8:].any() else np.float64(0)  # without a prism, a and b are only numbers
    a, b = p2 + s1 + s2 * prism, p1 + s3 + s4 * prism
    a2, b2 = 2 * (a + s2 * prism), 2 * (b + s4 * prism)  # d(r² a)/dx = x a2
    x_d, y_d = x * g + r2 * a, y * g + r2 * b
    return x_d, y_d, g + x * (g_x + a2), x * g_y + y * a2, y * g_x + x * b2, g + y * (g_y + b2)


def columns(points: Array) -> tuple[Array, Array]:
    """Return x and y of points in rows, each in one piece of memory."""
    return points[..., 0].copy(), points[..., 1].copy()


def check_coefficients(value: ArrayLike) -> Array:
    """Return distortion coefficients as twelve numbers, those that are not given as zero."""
    given = np.atleast_1d(check_numbers(value, "coefficients"))
    if given.ndim == 2 and 1 in given.shape:
        given = given.ravel()  # OpenCV's shape
    if given.ndim != 1 or given.size not in COUNTS:
        hint = "k3 stands fifth: k1, k2, 0, 0, k3" if given.shape == (3,) else "fill up with zeros"
        if given.shape == (14,):
            hint = "the tilt of the sensor, two more in OpenCV, is not part of this model"
        raise ValueError(
            f"coefficients must be 1, 2, 4, 5, 8 or 12 numbers, got shape {given.shape}: "
            f"k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4; {hint}"
        )
    if np.abs(given).max() > LARGEST_COEFFICIENT:
        raise ValueError(f"coefficients hold {np.abs(given).max():g}, which no lens has")
    return np.concatenate([given, np.zeros(12 - given.size)])


def check_normalised(value: ArrayLike, name: str) -> Array:
    """Return points in normalised coordinates, shape ``(N, 2)`` or ``(2,)``."""
    points = check_points(value, 2, name)
    if points.size and np.abs(points).max() > LARGEST_TANGENT:
        raise ValueError(
            f"{name} must be tangents X/Z, got {np.abs(points).max():g}: "
            "take K off the pixels first (normalised_from_pixels)"
        )
    return points
