"""Ray transfer ("ABCD") matrices: lenses in a row, as products of 2 × 2 matrices.

A ray near the optical axis is ``(y, angle)``: its height above the axis in mm and its slope in
rad (small). Each piece of the way is a matrix that acts from the left, so that the piece which
the light meets first stands rightmost. Distances along the axis count in the direction of the
light. Use these functions through `course_lib.optics`.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    Array,
    check_matrix,
    check_not_negative,
    check_number,
    check_points,
)

#: Relative to the products that a determinant is the difference of.
ROUNDING = 1e-12


def free_space(d: float) -> Array:
    """Return the matrix of a way through air.

    Parameters
    ----------
    d : float
        Length of the way along the axis in mm, not negative.

    Returns
    -------
    ndarray, shape (2, 2)
        It changes a ray's height and keeps its angle.

    Raises
    ------
    TypeError, ValueError
        If d is not one finite number, or negative.

    References
    ----------
    E. Hecht, Optics, 5th ed., section 6.2.1 (matrix methods).

    Examples
    --------
    >>> free_space(10) @ (2, 0.1)
    array([3. , 0.1])
    """
    d = check_number(check_not_negative(d, "d"), "d")
    return np.array([[1.0, d], [0.0, 1.0]])


def thin_lens(f: float) -> Array:
    """Return the matrix of a thin lens.

    Parameters
    ----------
    f : float
        Focal length in mm; negative for a lens that spreads light. Not zero.

    Returns
    -------
    ndarray, shape (2, 2)
        It changes a ray's angle and keeps its height.

    Raises
    ------
    TypeError, ValueError
        If f is not one finite number, or zero.

    References
    ----------
    E. Hecht, Optics, 5th ed., section 6.2.1 (matrix methods).

    Examples
    --------
    >>> thin_lens(50) @ (2, 0.1)
    array([2.  , 0.06])
    """
    f = check_focal_length(f, "f")
    return np.array([[1.0, 0.0], [-1.0 / f, 1.0]])


def system_matrix(elements: Sequence[ArrayLike]) -> Array:
    """Return the one matrix of several pieces in a row.

    Parameters
    ----------
    elements : sequence of array_like, shape (2, 2)
        Matrices in the order in which the light meets them; none gives the identity.

    Returns
    -------
    ndarray, shape (2, 2)
        Their product, the first one rightmost.

    Raises
    ------
    TypeError, ValueError
        If an element is not a finite 2 × 2 matrix.

    References
    ----------
    E. Hecht, Optics, 5th ed., section 6.2.1 (matrix methods).

    Examples
    --------
    >>> system_matrix([thin_lens(50), free_space(25)]) @ (2, 0)
    array([ 1.  , -0.04])
    """
    system = np.eye(2)
    for i, element in enumerate(elements):
        system = check_matrix(element, (2, 2), f"elements[{i}]") @ system
    return system


def trace_rays(elements: Sequence[ArrayLike], rays: ArrayLike) -> Array:
    """Return rays before, between and after the pieces of a system.

    Parameters
    ----------
    elements : sequence of array_like, shape (2, 2)
        n matrices in the order in which the light meets them.
    rays : array_like, shape (N, 2) or (2,)
        Rays ``(y, angle)`` in mm and rad, in rows, before the first piece.

    Returns
    -------
    ndarray, shape (n + 1, N, 2) or (n + 1, 2)
        The rays as they come in, then after each piece.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong or a number is not finite.

    References
    ----------
    E. Hecht, Optics, 5th ed., section 6.2.1 (matrix methods).

    Examples
    --------
    >>> trace_rays([thin_lens(50), free_space(25)], (2, 0))
    array([[ 2.  ,  0.  ],
           [ 2.  , -0.04],
           [ 1.  , -0.04]])
    """
    traced = [check_points(rays, 2, "rays")]
    for i, element in enumerate(elements):
        matrix = check_matrix(element, (2, 2), f"elements[{i}]")
        traced.append(traced[-1] @ matrix.T)
    return np.stack(traced)


def image_of_point(system: ArrayLike, Z: float) -> tuple[float, float]:
    """Return where a system makes the image of a point, and how large it makes things there.

    Parameters
    ----------
    system : array_like, shape (2, 2)
        Matrix from just before the first lens to just behind the last one.
    Z : float
        Distance from the point to the first lens in mm, not negative.

    Returns
    -------
    distance, m : float
        Distance from the last lens to the image in mm (negative: the image is virtual, before that
        lens), and the magnification (negative: upside down). Both ``inf`` where the rays of the
        point leave the system parallel.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite or Z is negative.

    References
    ----------
    E. Hecht, Optics, 5th ed., section 6.2.1 (matrix methods).

    Examples
    --------
    >>> image_of_point(thin_lens(50), Z=250)
    (62.5, -0.25)
    """
    system = check_matrix(system, (2, 2), "system")
    (_, B), (_, D) = system @ free_space(Z)
    if D == 0:
        return np.inf, np.inf
    # The ray's height behind the image's distance s must not depend on its angle: B + s D = 0.
    # Then m = A + s C is det / D, which loses no digits; free space has the determinant one.
    return float(-B / D), float(_determinant(system) / D)


def _determinant(system: Array) -> float:
    """Return a determinant; in air it is exactly one, and what differs is rounding."""
    product, other = system[0, 0] * system[1, 1], system[0, 1] * system[1, 0]
    in_air = abs(product - other - 1) <= ROUNDING * (abs(product) + abs(other))
    return 1.0 if in_air else float(product - other)


def check_focal_length(value: ArrayLike, name: str) -> float:
    """Return `value` as one finite float other than zero."""
    f = check_number(value, name)
    if f == 0:
        raise ValueError(f"{name} must not be zero: a lens of focal length zero does not exist")
    return f
