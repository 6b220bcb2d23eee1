"""Linear least squares: more equations than unknowns, solved so that what is left is smallest.

``A`` has a row for each equation and a column for each unknown; ``A x`` should be ``b``. Use these
functions through `course_lib.least_squares`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import SMALLEST, Array, DegenerateConfigurationError, check_numbers

#: A column this near to a combination of the others, by its length, counts as one.
DEPENDENT = 1e-12


def solve_normal_equations(A: ArrayLike, b: ArrayLike) -> Array:
    """Return the least-squares solution by ``AᵀA x = Aᵀb``: short, but half of the digits are lost.

    Parameters
    ----------
    A : array_like, shape (N, n)
        Coefficients of N equations in n unknowns, N ≥ n.
    b : array_like, shape (N,) or (N, k)
        Right-hand sides; each of k columns is a problem of its own.

    Returns
    -------
    ndarray, shape (n,) or (n, k)
        The unknowns for which the sum of squares of ``A x - b`` is smallest.

    Raises
    ------
    TypeError, ValueError
        If the shapes do not fit, a number is not finite, or there are fewer rows than columns.
    DegenerateConfigurationError
        If the columns of `A` are dependent, as far as the squared numbers can tell: to about
        eight digits.

    References
    ----------
    Golub & Van Loan, Matrix Computations, 4th ed., section 5.3.2.

    Examples
    --------
    >>> solve_normal_equations([[1, 0], [1, 1], [1, 2]], [1, 3, 5])
    array([1., 2.])
    """
    A, b = _check_system(A, b)
    N, lengths = A.T @ A, np.linalg.norm(A, axis=0)
    scale = np.where(lengths > 0, lengths, 1)
    try:  # L Lᵀ = N with unit columns: its diagonal says what each column adds to those before
        added = np.diag(np.linalg.cholesky(N / np.outer(scale, scale)))
    except np.linalg.LinAlgError:
        added = np.zeros(1)
    _check_independent(added, limit=1e-7)
    return np.asarray(np.linalg.solve(N, A.T @ b))


def solve_qr(A: ArrayLike, b: ArrayLike) -> Array:
    """Return the least-squares solution by ``A = QR``: as accurate as the data allow.

    Parameters
    ----------
    A : array_like, shape (N, n)
        Coefficients of N equations in n unknowns, N ≥ n.
    b : array_like, shape (N,) or (N, k)
        Right-hand sides; each of k columns is a problem of its own.

    Returns
    -------
    ndarray, shape (n,) or (n, k)
        The unknowns for which the sum of squares of ``A x - b`` is smallest.

    Raises
    ------
    TypeError, ValueError
        As `solve_normal_equations`.
    DegenerateConfigurationError
        If the columns of `A` are dependent (to twelve digits).

    References
    ----------
    Golub & Van Loan, Matrix Computations, 4th ed., section 5.3.3.

    Examples
    --------
    >>> solve_qr([[1, 0], [1, 1], [1, 2]], [1, 3, 5]).round(12)
    array([1., 2.])
    """
    A, b = _check_system(A, b)
    Q, R = np.linalg.qr(A)
    lengths = np.linalg.norm(A, axis=0)
    _check_independent(np.abs(np.diag(R)) / np.where(lengths > 0, lengths, 1))
    return np.asarray(np.linalg.solve(R, Q.T @ b))


def solve_svd(A: ArrayLike, b: ArrayLike, smallest: float = DEPENDENT) -> Array:
    """Return the least-squares solution by ``A = U S Vᵀ``; of several solutions the shortest.

    Parameters
    ----------
    A : array_like, shape (N, n)
        Coefficients of N equations in n unknowns; also N < n, also with dependent columns.
    b : array_like, shape (N,) or (N, k)
        Right-hand sides; each of k columns is a problem of its own.
    smallest : float
        Singular values below this share of the largest count as zero: the data do not tell those
        directions, and the solution has no part in them.

    Returns
    -------
    ndarray, shape (n,) or (n, k)
        Of the unknowns for which the sum of squares of ``A x - b`` is smallest, the shortest.

    Raises
    ------
    TypeError, ValueError
        If the shapes do not fit or a number is not finite.

    References
    ----------
    Golub & Van Loan, Matrix Computations, 4th ed., section 5.5.2.

    Examples
    --------
    Two unknowns of which only the sum is known:

    >>> solve_svd([[1, 1], [2, 2]], [4, 8]).round(12)
    array([2., 2.])
    """
    A, b = _check_system(A, b, least=0)
    U, s, Vt = np.linalg.svd(A, full_matrices=False)
    told = s > max(smallest * s[0], SMALLEST)
    return np.asarray((Vt[told].T / s[told]) @ (U[:, told].T @ b))


def solve_weighted(A: ArrayLike, b: ArrayLike, weights: ArrayLike) -> Array:
    """Return the least-squares solution when some equations count more than others.

    Parameters
    ----------
    A : array_like, shape (N, n)
        Coefficients of N equations in n unknowns, N ≥ n.
    b : array_like, shape (N,) or (N, k)
        Right-hand sides.
    weights : array_like, shape (N,)
        What each squared residual is multiplied by, not negative: 1/σ² if an equation's standard
        deviation is σ; 0 leaves it out.

    Returns
    -------
    ndarray, shape (n,) or (n, k)
        The unknowns for which the weighted sum of squares is smallest.

    Raises
    ------
    TypeError, ValueError
        If the shapes do not fit, a number is not finite, a weight is negative, or there are fewer
        rows than columns.
    DegenerateConfigurationError
        If the columns of `A` are dependent in the rows that count.

    References
    ----------
    Golub & Van Loan, Matrix Computations, 4th ed., section 6.1.1.

    Examples
    --------
    A length measured twice, the second time twice as accurately:

    >>> solve_weighted([[1], [1]], [10, 20], [1, 4]).round(12)
    array([18.])
    """
    A, b = _check_system(A, b)
    weights = check_numbers(weights, "weights")
    if weights.shape != (len(A),) or (weights < 0).any():
        raise ValueError(f"weights must be {len(A)} numbers that are not negative, got {weights!r}")
    roots = np.sqrt(weights)[:, None]
    return solve_qr(roots * A, roots * b if b.ndim == 2 else roots[:, 0] * b)


def solve_homogeneous(A: ArrayLike) -> Array:
    """Return the vector of length 1 for which ``A x`` is shortest.

    Parameters
    ----------
    A : array_like, shape (N, n)
        Coefficients of N equations with zero on the right, N ≥ n - 1.

    Returns
    -------
    ndarray, shape (n,)
        The right singular vector of the smallest singular value; its sign has no meaning.

    Raises
    ------
    TypeError, ValueError
        If the shape is wrong, a number is not finite, or there are fewer than n - 1 rows.
    DegenerateConfigurationError
        If there is more than one solution (to twelve digits): two singular values are zero.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., appendix A5.3.

    Examples
    --------
    >>> abs(solve_homogeneous([[3, -4], [6, -8]])).round(12)
    array([0.8, 0.6])
    """
    A = check_numbers(A, "A")
    if A.ndim != 2 or not 0 < A.shape[1] <= len(A) + 1:
        raise ValueError(f"A must have one row or more for each column but one, got {A.shape}")
    # Of a tall matrix only R matters: it has the same singular values and right vectors.
    A = np.linalg.qr(A, mode="r") if len(A) > 2 * A.shape[1] else A
    _, s, Vt = np.linalg.svd(A)
    if A.shape[1] > 1 and s[A.shape[1] - 2] <= DEPENDENT * s[0]:
        raise DegenerateConfigurationError(
            "more than one direction solves the equations, so the data do not tell the answer: add "
            "measurements that differ from these"
        )
    return np.asarray(Vt[-1])


def parameter_covariance(J: ArrayLike, residuals: ArrayLike) -> Array:
    """Return how uncertain fitted parameters are, judged by the residuals that are left.

    Parameters
    ----------
    J : array_like, shape (N, n)
        Derivatives of the residuals by the parameters, at the solution; in a linear problem ``A``.
    residuals : array_like, shape (N,)
        What is left, N > n.

    Returns
    -------
    ndarray, shape (n, n)
        ``σ² (JᵀJ)⁻¹`` with ``σ² = residualsᵀ residuals / (N - n)``. The roots of its diagonal are
        the standard deviations of the parameters, if the errors are independent and equally large.

    Raises
    ------
    TypeError, ValueError
        If the shapes do not fit, a number is not finite, or there is no equation to spare.
    DegenerateConfigurationError
        If the columns of `J` are dependent: some combination of parameters is not determined.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 5.2.

    Examples
    --------
    The mean of four numbers, and its variance:

    >>> parameter_covariance([[1], [1], [1], [1]], [-1, 1, -1, 1]).round(6)
    array([[0.333333]])
    """
    J, residuals = _check_system(J, residuals)
    count, unknowns = J.shape
    if residuals.ndim != 1 or count == unknowns:
        raise ValueError(
            f"residuals must be one number for each of more rows than the {unknowns} parameters, "
            f"got {residuals.shape}: without a row to spare nothing is left to judge by"
        )
    lengths = np.linalg.norm(J, axis=0)
    scale = np.where(lengths > 0, lengths, 1)
    R = np.linalg.qr(J / scale, mode="r")
    _check_independent(np.abs(np.diag(R)))
    inverse = np.linalg.inv(R) / scale[:, None]
    return np.asarray((residuals @ residuals) / (count - unknowns) * (inverse @ inverse.T))


def _check_independent(added: Array, limit: float = DEPENDENT) -> None:
    """Raise unless each column adds something, by its own length, to those before it."""
    if added.min() <= limit:
        raise DegenerateConfigurationError(
            "the columns are dependent: the data do not determine all unknowns; measure something "
            "that tells them apart, or leave an unknown out"
        )


def _check_system(A: ArrayLike, b: ArrayLike, least: int = 1) -> tuple[Array, Array]:
    """Return both as arrays, with at least so many rows for each column."""
    A, b = check_numbers(A, "A"), check_numbers(b, "b")
    if A.ndim != 2 or not A.size:
        raise ValueError(f"A must have rows of equations and columns of unknowns, got {A.shape}")
    if b.ndim not in (1, 2) or len(b) != len(A):
        raise ValueError(f"b must have a number for each of the {len(A)} rows of A, got {b.shape}")
    if len(A) < least * A.shape[1]:
        raise ValueError(f"{A.shape[1]} unknowns need as many equations or more, got {len(A)}")
    return A, b
