"""Zhang's closed form: what homographies of a flat board say about the camera that made them.

A board in its own frame has z = 0, so that its picture is a homography, ``H ~ K [r1 r2 t]``. That
r1 and r2 are perpendicular and of one length gives two equations for ``B = K⁻ᵀ K⁻¹`` a view. Use
these functions through `course_lib.calibration`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    SMALLEST,
    Array,
    DegenerateConfigurationError,
    check_intrinsics,
    check_numbers,
    check_points,
)

#: Two directions in which the equations of a board say that little leave K undecided.
WEAKEST = 1e-9


def homography_constraints(H: ArrayLike) -> Array:
    """Return the two equations that the homography of a board gives for ``B = K⁻ᵀ K⁻¹``.

    B is symmetric, so six numbers ``b = (B11, B12, B22, B13, B23, B33)`` are all of it, and
    ``h_iᵀ B h_j = v_ij · b`` with the columns h_i of H. The rows are ``v12``, which must be zero
    because r1 and r2 are perpendicular, and ``v11 - v22``, because they are equally long.

    Parameters
    ----------
    H : array_like, shape (3, 3) or (N, 3, 3)
        Homography from the board's x and y to pixels, of any scale; or several.

    Returns
    -------
    ndarray, shape (2, 6) or (N, 2, 6)
        Rows ``v12`` and ``v11 - v22``; their product with b is zero.

    Raises
    ------
    TypeError, ValueError
        If the shape is wrong or a number is not finite.

    References
    ----------
    Z. Zhang, "A flexible new technique for camera calibration", IEEE PAMI 22 (2000), equations 7
    and 8.

    Examples
    --------
    >>> homography_constraints([[2, 0, 5], [0, 3, 7], [0, 0, 1]])
    array([[ 0.,  6.,  0.,  0.,  0.,  0.],
           [ 4.,  0., -9.,  0.,  0.,  0.]])
    """
    H = check_homographies(H)

    def v(i: int, j: int) -> Array:
        (a, b, c), (d, e, f) = np.moveaxis(H[..., i], -1, 0), np.moveaxis(H[..., j], -1, 0)
        return np.stack([a * d, a * e + b * d, b * e, a * f + c * d, b * f + c * e, c * f], axis=-1)

    return np.stack([v(0, 1), v(0, 0) - v(1, 1)], axis=-2)


def intrinsics_from_homographies(Hs: ArrayLike) -> Array:
    """Return the intrinsics from the homographies of a board in different poses.

    Parameters
    ----------
    Hs : array_like, shape (N, 3, 3)
        Homographies from the board's x and y to pixels, of any scale. With two of them the skew is
        taken to be zero.

    Returns
    -------
    ndarray, shape (3, 3)
        ``K = [[fx, s, cx], [0, fy, cy], [0, 0, 1]]``, px.

    Raises
    ------
    TypeError, ValueError
        If the shape is wrong or a number is not finite, or there are less than two homographies.
    DegenerateConfigurationError
        If they do not determine K: the boards are parallel, or the views the same; or if no camera
        makes such homographies.

    References
    ----------
    Z. Zhang, "A flexible new technique for camera calibration", IEEE PAMI 22 (2000), section 3.1
    and appendix B.

    Examples
    --------
    >>> from course_lib.transforms import rotation_x, rotation_y
    >>> K = np.array([[800, 0, 320], [0, 780, 240], [0, 0, 1]])
    >>> turns = [rotation_x(0.4), rotation_y(0.5), rotation_x(-0.3) @ rotation_y(-0.4)]
    >>> Hs = [K @ np.column_stack([R[:, 0], R[:, 1], [1, 2, 9]]) for R in turns]
    >>> intrinsics_from_homographies(Hs).round(6) + 0.0
    array([[800.,   0., 320.],
           [  0., 780., 240.],
           [  0.,   0.,   1.]])
    """
    Hs = check_homographies(Hs)
    if Hs.ndim != 3 or len(Hs) < 2:
        raise DegenerateConfigurationError(
            "one view gives two equations, but K has four unknowns or five: take two views (then "
            "the skew is taken as 0), better ten"
        )
    V = homography_constraints(Hs).reshape(-1, 6)
    if len(Hs) == 2:
        V = np.vstack([V, [0, 1, 0, 0, 0, 0]])  # skew 0 means B12 = 0
    b = np.linalg.svd(V)[2][-1]
    B = (b if b[0] > 0 else -b)[[0, 1, 3, 1, 2, 4, 3, 4, 5]].reshape(3, 3)
    _check_determined(V)
    try:
        L = np.linalg.cholesky(B)  # B = K⁻ᵀ K⁻¹ up to scale, and K⁻ᵀ is lower triangular
    except np.linalg.LinAlgError as error:
        raise DegenerateConfigurationError(
            "no camera makes these homographies: check the order of the corners and the number of "
            "columns and rows, and take more views, tilted in different directions"
        ) from error
    K = np.linalg.inv(L.T)
    return np.asarray(K / K[2, 2])


def pose_from_homography(K: ArrayLike, H: ArrayLike) -> tuple[Array, Array]:
    """Return where a board is, from its homography and the intrinsics.

    Parameters
    ----------
    K : array_like, shape (3, 3)
        Intrinsics in px.
    H : array_like, shape (3, 3) or (N, 3, 3)
        Homography from the board's x and y to pixels, of any scale and sign; or several.

    Returns
    -------
    R : ndarray, shape (3, 3) or (N, 3, 3)
        Rotation, board to camera: the nearest to what H says, which noise makes a little skewed.
    t : ndarray, shape (3,) or (N, 3)
        Translation, board to camera; the board's origin is before the camera, ``t[2] > 0``.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite or K is no matrix of intrinsics.
    DegenerateConfigurationError
        If H squeezes the board, so that r1 and r2 have no length.

    References
    ----------
    Z. Zhang, "A flexible new technique for camera calibration", IEEE PAMI 22 (2000), section 3.1
    and appendix C.

    Examples
    --------
    >>> K = np.diag([800, 800, 1])
    >>> R, t = pose_from_homography(K, [[-1600, 0, 0], [0, -1600, 0], [0, 0, -10]])
    >>> R + 0.0, t + 0.0
    (array([[1., 0., 0.],
           [0., 1., 0.],
           [0., 0., 1.]]), array([0., 0., 5.]))
    """
    K, H = check_intrinsics(K), check_homographies(H)
    M = np.linalg.inv(K) @ H  # r1 r2 t, all times one unknown number
    length = np.linalg.norm(M[..., :2], axis=-2).mean(axis=-1)
    M = M / (np.where(M[..., 2, 2] < 0, -1, 1) * length)[..., None, None]
    r1, r2, t = (M[..., i] for i in range(3))
    U, _, Vt = np.linalg.svd(np.stack([r1, r2, np.cross(r1, r2)], axis=-1))
    return U @ Vt, t


def initial_distortion(ideal: ArrayLike, observed: ArrayLike, K: ArrayLike) -> Array:
    """Return k1 and k2 from where points should be without distortion, and where they are.

    To first order the lens moves a pixel by ``(u - cx)(k1 r² + k2 r⁴)``, and v alike: two linear
    equations a point, which least squares solves.

    Parameters
    ----------
    ideal : array_like, shape (N, 2)
        Pixels that the camera without distortion would make.
    observed : array_like, shape (N, 2)
        The same points as they were seen.
    K : array_like, shape (3, 3)
        Intrinsics in px.

    Returns
    -------
    ndarray, shape (2,)
        ``k1, k2``, as in `distort`; r is the distance from the principal point in normalised
        coordinates.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or there are not as many ideal as observed.

    References
    ----------
    Z. Zhang, "A flexible new technique for camera calibration", IEEE PAMI 22 (2000), section 3.3,
    equation 13.

    Examples
    --------
    >>> K = [[100, 0, 0], [0, 100, 0], [0, 0, 1]]
    >>> initial_distortion([[100, 0], [0, 200]], [[90, 0], [0, 120]], K).round(9)
    array([-0.1,  0. ])
    """
    ideal, observed = check_points(ideal, 2, "ideal"), check_points(observed, 2, "observed")
    K = check_intrinsics(K)
    if ideal.ndim != 2 or ideal.shape != observed.shape:
        raise ValueError(
            "ideal and observed must be as many points in rows, got shapes "
            f"{ideal.shape} and {observed.shape}"
        )
    offset = ideal - K[:2, 2]
    normalised = offset @ np.linalg.inv(K[:2, :2]).T
    r2 = (normalised**2).sum(axis=1, keepdims=True)
    A = np.column_stack([(offset * r2).ravel(), (offset * r2**2).ravel()])
    return np.asarray(np.linalg.lstsq(A, (observed - ideal).ravel(), rcond=None)[0])


def check_homographies(H: ArrayLike) -> Array:
    """Return one homography, shape ``(3, 3)``, or several, ``(N, 3, 3)``, that do not squeeze."""
    H = check_numbers(H, "H")
    if H.ndim not in (2, 3) or H.shape[-2:] != (3, 3):
        raise ValueError(f"H must have shape (3, 3) or (N, 3, 3), got {H.shape}")
    lengths = np.linalg.norm(H, axis=-2, keepdims=True)
    if not (lengths > SMALLEST).all() or (np.abs(np.linalg.det(H / lengths)) < WEAKEST).any():
        raise DegenerateConfigurationError(
            "a homography squeezes the board into a line: are its points on one line?"
        )
    return H


def _check_determined(V: Array) -> None:
    """Raise unless only one direction fulfils the equations."""
    # Columns of one length, so that the unit of the pixels does not matter.
    lengths = np.linalg.norm(V, axis=0)
    sizes = np.linalg.svd(V / np.where(lengths > 0, lengths, 1), compute_uv=False)
    if sizes[4] < WEAKEST * sizes[0]:
        raise DegenerateConfigurationError(
            "the homographies do not determine K: the boards are parallel, or views are the same. "
            "Tilt the board in different directions"
        )
