"""Roots of many cubic equations at once."""

from __future__ import annotations

import numpy as np

from course_lib.checks import Array


def real_roots_of_cubics(coefficients: Array) -> Array:
    """Return the real roots of cubic equations.

    Parameters
    ----------
    coefficients : ndarray, shape (B, 4)
        ``a, b, c, d`` of ``a x³ + b x² + c x + d = 0`` in rows.

    Returns
    -------
    ndarray, shape (B, 3)
        The roots; NaN in place of those that are not real, or that do not exist as a is zero.

    References
    ----------
    W. H. Press et al., Numerical Recipes, 3rd ed., section 5.6 (trigonometric form).
    """
    with np.errstate(all="ignore"):
        a, b, c, d = coefficients.T
        p, q, r = b / a, c / a, d / a
        Q = (p * p - 3 * q) / 9
        R = (2 * p * p * p - 9 * p * q + 27 * r) / 54
        three = R * R < Q * Q * Q
        angle = np.arccos(np.clip(R / np.sqrt(Q * Q * Q), -1, 1)) / 3
        turns = angle[:, None] + 2 * np.pi / 3 * np.array([0, 1, -1])
        roots = -2 * np.sqrt(Q)[:, None] * np.cos(turns)
        A = -np.sign(R) * np.cbrt(np.abs(R) + np.sqrt(R * R - Q * Q * Q))
        only = A + np.where(A == 0, 0, Q / A)
        roots[~three] = np.nan
        roots[~three, 0] = only[~three]
        roots -= p[:, None] / 3
        for _ in range(2):  # Newton's steps win back the digits that the differences cost
            value = ((a[:, None] * roots + b[:, None]) * roots + c[:, None]) * roots + d[:, None]
            slope = (3 * a[:, None] * roots + 2 * b[:, None]) * roots + c[:, None]
            step = value / slope
            roots = np.where(np.abs(step) < 0.1 * (np.abs(roots) + 1e-3), roots - step, roots)
        return np.where(np.isfinite(roots), roots, np.nan)
