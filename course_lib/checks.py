"""Checks at the public edge: what came in is what the docstring asks for, or a sentence says so.

Every function here returns its argument as a `float64` array (or float), so that a body can
begin with one line for each argument.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]

#: No measurement is that large, and products of a few numbers below it stay finite.
LARGEST = 1e75
#: Vectors that are shorter have no direction: the squares of such numbers get lost.
SMALLEST = 1 / LARGEST


class DegenerateConfigurationError(ValueError):
    """The data are well formed, but their geometry does not determine the answer."""


def check_numbers(value: ArrayLike, name: str) -> Array:
    """Return `value` as a `float64` array of finite real numbers.

    Parameters
    ----------
    value : array_like
        Numbers, of any shape.
    name : str
        What the caller calls them; the error begins with it.

    Returns
    -------
    ndarray
        The numbers; a copy only where the conversion needs one.

    Raises
    ------
    TypeError
        If `value` is not made of real numbers.
    ValueError
        If it holds NaN, infinity or a number beyond 1e75, or rows of different lengths.
    """
    array = check_real(value, name)
    # NaN is in every maximum, and compares as False.
    if array.size and not max(array.max(), -array.min()) <= LARGEST:
        if not np.isfinite(array).all():
            raise ValueError(
                f"{name} must be finite, got NaN or infinity: remove those entries first"
            )
        raise ValueError(f"{name} holds a number beyond {LARGEST:g}: check its unit")
    return array


def check_real(value: ArrayLike, name: str) -> Array:
    """Return `value` as a `float64` array of real numbers; NaN may stand for what is missing."""
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise ValueError(f"{name}: the rows have different lengths; make them equal") from error
    if array.dtype.kind not in "iuf":
        raise TypeError(f"{name} must be real numbers, got {value!r:.60}")
    return array.astype(np.float64, copy=False)


def check_number(value: ArrayLike, name: str) -> float:
    """Return `value` as one finite float; errors as in `check_numbers`, or for a wrong shape."""
    array = check_numbers(value, name)
    if array.ndim != 0:
        raise ValueError(f"{name} must be one number, got an array of shape {array.shape}")
    return float(array)


def check_positive(value: ArrayLike, name: str) -> Array:
    """Return `value`, a number or an array of any shape, as positive finite numbers."""
    array = check_numbers(value, name)
    if (array <= 0).any():
        raise ValueError(f"{name} must be positive, got {array.min():g}: check its sign and unit")
    return array


def check_not_negative(value: ArrayLike, name: str) -> Array:
    """Return `value`, a number or an array of any shape, as finite numbers from zero upwards."""
    array = check_numbers(value, name)
    if (array < 0).any():
        raise ValueError(f"{name} must not be negative, got {array.min():g}: check its sign")
    return array


def check_distance(value: ArrayLike, name: str) -> Array:
    """Return `value` as positive numbers; infinity, the distance of a star, is one of them."""
    array = check_real(value, name)
    check_positive(np.where(np.isposinf(array), 1, array), name)
    return array


def check_outside_focus(Z: Array, f: Array, name: str) -> None:
    """Raise unless each distance is larger than the focal length: nearer has no real image."""
    if (f >= Z).any():
        raise ValueError(
            f"{name} must be larger than the focal length ({np.max(f):g} mm), got {np.min(Z):g}: "
            "light from there does not meet again behind the lens, so the image is virtual"
        )


def check_length(value: ArrayLike, name: str) -> float:
    """Return `value` as one positive finite float, such as a focal length."""
    check_positive(value, name)
    return check_number(value, name)


def check_vector(value: ArrayLike, length: int, name: str) -> Array:
    """Return `value` as a finite vector of shape ``(length,)``."""
    array = check_numbers(value, name)
    if array.shape != (length,):
        raise ValueError(f"{name} must have shape ({length},), got {array.shape}")
    return array


def check_size(value: ArrayLike, name: str) -> Array:
    """Return `value` as a ``(width, height)`` of positive numbers, shape ``(2,)``."""
    return check_positive(check_vector(value, 2, f"{name} (width, height)"), name)


def check_points(value: ArrayLike, dimension: int, name: str) -> Array:
    """Return `value` as points in rows, shape ``(N, dimension)``, or one point ``(dimension,)``."""
    array = check_numbers(value, name)
    if array.ndim not in (1, 2) or array.shape[-1] != dimension:
        raise ValueError(
            f"{name} must have shape (N, {dimension}) or ({dimension},), got {array.shape}: "
            "points are rows"
        )
    return array


def check_rows(value: ArrayLike, name: str, least: int = 1) -> Array:
    """Return `value` as rows of at least so many numbers each, or as one such row."""
    array = check_numbers(value, name)
    if array.ndim not in (1, 2) or array.shape[-1] < least:
        raise ValueError(
            f"{name} must be rows of {least} or more numbers, got shape {array.shape}: "
            "points are rows"
        )
    return array


def check_directions(value: ArrayLike, name: str) -> Array:
    """Return `value` as directions in rows, shape ``(N, 3)`` or ``(3,)``, none of them zero."""
    array = check_points(value, 3, name)
    if (np.abs(array).max(axis=-1) < SMALLEST).any():
        raise ValueError(f"{name} holds a zero vector, which points nowhere")
    return array


def check_direction(value: ArrayLike, name: str, length: int = 3) -> Array:
    """Return `value` as one vector of shape ``(length,)`` that is not zero."""
    array = check_vector(value, length, name)
    if np.abs(array).max() < SMALLEST:
        raise ValueError(f"{name} is a zero vector, which points nowhere")
    return array


def check_matrix(value: ArrayLike, shape: tuple[int, int], name: str) -> Array:
    """Return `value` as a finite matrix of the given shape."""
    array = check_numbers(value, name)
    if array.shape != shape:
        raise ValueError(f"{name} must have shape {shape}, got {array.shape}")
    return array


def check_pixel_focal(value: ArrayLike, name: str) -> Array:
    """Return a focal length in px, one number or ``(fx, fy)``, as positive numbers."""
    array = check_positive(value, name)
    if array.shape not in ((), (2,)):
        raise ValueError(f"{name} must be one number or (fx, fy), got shape {array.shape}")
    return array


def check_intrinsics(K: ArrayLike) -> Array:
    """Return `K` as intrinsics: upper triangular, positive focal lengths, 1 in the corner."""
    K = check_matrix(K, (3, 3), "K")
    if (np.diag(K) < SMALLEST).any() or np.tril(K, -1).any() or K[2, 2] != 1:
        raise ValueError(f"K must be [[fx, s, cx], [0, fy, cy], [0, 0, 1]], got {K.tolist()}")
    return K


def check_rotation(R: ArrayLike, tolerance: float = 1e-6) -> Array:
    """Return `R` as an array, once it is sure to be a rotation.

    Parameters
    ----------
    R : array_like, shape (3, 3)
        The matrix in question.
    tolerance : float
        Largest allowed error of an entry of ``R Rᵀ``.

    Returns
    -------
    ndarray, shape (3, 3)
        The same numbers in `float64`.

    Raises
    ------
    TypeError, ValueError
        If `R` is not a 3 × 3 matrix, its rows are not orthonormal, or it mirrors.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 2.4.1.

    Examples
    --------
    >>> check_rotation(np.diag([1, 1, -1]))
    Traceback (most recent call last):
    ValueError: R is a reflection (determinant -1), not a rotation: swap two axes or a sign
    """
    R = check_matrix(R, (3, 3), "R")
    # Beyond 2 no entry belongs to a rotation, and the product could overflow.
    error = np.inf if np.abs(R).max() > 2 else np.abs(R @ R.T - np.eye(3)).max()
    if error > tolerance:
        raise ValueError(
            f"R is not a rotation: R Rᵀ differs from the identity by {error:.2g}. "
            "Its rows must be perpendicular and of length 1"
        )
    if np.linalg.det(R) < 0:
        raise ValueError(
            "R is a reflection (determinant -1), not a rotation: swap two axes or a sign"
        )
    return R


def check_generator(rng: object) -> np.random.Generator:
    """Return a random generator; a seed is none."""
    if not isinstance(rng, np.random.Generator):
        raise TypeError(f"rng must be a generator such as np.random.default_rng(0), got {rng!r}")
    return rng


def check_count(value: int, name: str, least: int = 1) -> int:
    """Return a whole number that is large enough."""
    whole = isinstance(value, int | np.integer) and not isinstance(value, bool)
    if not whole or value < least:
        raise ValueError(f"{name} must be a whole number, {least} or more, got {value!r}")
    return int(value)
