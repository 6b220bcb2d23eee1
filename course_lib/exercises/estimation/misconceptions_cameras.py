"""Wrong answers to the exercises of chapter 06 on camera matrices."""

from __future__ import annotations

from typing import Any

import numpy as np

from course_lib.exercises.estimation.misconceptions_points import normalised

# --- camera_dlt -------------------------------------------------------------------------------


def _design(points: Any, pixels: Any, sign: int = -1) -> Any:
    X = np.column_stack([points, np.ones(len(points))])
    A = np.zeros((len(points), 2, 12))
    A[:, 0, :4] = A[:, 1, 4:8] = X
    A[:, :, 8:] = sign * pixels[:, :, None] * X[:, None]
    return A.reshape(-1, 12)


def _between(points: Any, pixels: Any, pick: Any = None, sign: int = -1) -> Any:
    p, T_points = normalised(points)
    q, T_pixels = normalised(pixels)
    A = _design(p, q, sign)
    P = pick(A) if pick else np.linalg.svd(A)[2][-1].reshape(3, 4)
    return T_pixels, P, T_points


def _undone(T_pixels: Any, P: Any, T_points: Any) -> Any:
    return np.linalg.inv(T_pixels) @ P @ T_points


def camera_of_normalised_points(points, pixels):
    return _between(points, pixels)[1]


def pixels_left_normalised(points, pixels):
    _, P, T_points = _between(points, pixels)
    return P @ T_points


def points_left_normalised(points, pixels):
    T_pixels, P, _ = _between(points, pixels)
    return np.linalg.inv(T_pixels) @ P


def normalised_once_more(points, pixels):
    T_pixels, P, T_points = _between(points, pixels)
    return T_pixels @ P @ np.linalg.inv(T_points)


def pixels_normalised_once_more(points, pixels):
    T_pixels, P, T_points = _between(points, pixels)
    return T_pixels @ P @ T_points


def both_undone(points, pixels):
    T_pixels, P, T_points = _between(points, pixels)
    return np.linalg.inv(T_pixels) @ P @ np.linalg.inv(T_points)


def longest_of_twelve(points, pixels):
    return _undone(*_between(points, pixels, lambda A: np.linalg.svd(A)[2][0].reshape(3, 4)))


def last_column_of_twelve(points, pixels):
    return _undone(*_between(points, pixels, lambda A: np.linalg.svd(A)[2][:, -1].reshape(3, 4)))


def last_column_with_rows_in_blocks(points, pixels):
    def pick(A: Any) -> Any:
        return np.linalg.svd(np.concatenate([A[::2], A[1::2]]))[2][:, -1].reshape(3, 4)

    return _undone(*_between(points, pixels, pick))


def u_for_v(points, pixels):
    return _undone(*_between_as(points, pixels, [0, 0]))


def v_for_u_in_the_rows(points, pixels):
    return _undone(*_between_as(points, pixels, [1, 1]))


def exchanged_in_the_rows(points, pixels):
    return _undone(*_between_as(points, pixels, [1, 0]))


def _between_as(points: Any, pixels: Any, columns: Any) -> Any:
    """Write the rows with these columns of the normalised pixels."""
    p, T_points = normalised(points)
    q, T_pixels = normalised(pixels)
    return T_pixels, np.linalg.svd(_design(p, q[:, columns]))[2][-1].reshape(3, 4), T_points


def filled_column_by_column(points, pixels):
    return _undone(*_between(points, pixels, lambda A: np.linalg.svd(A)[2][-1].reshape(4, 3).T))


def sign_of_the_last_four(points, pixels):
    return _undone(*_between(points, pixels, sign=1))


def v_for_u(points, pixels):
    return _undone(*_between(points, pixels[:, ::-1]))


def last_row_of_a_parallel_camera(points, pixels):
    X = np.column_stack([points, np.ones(len(points))])
    return np.vstack([np.linalg.lstsq(X, pixels)[0].T, [0, 0, 0, 1]])


# --- decompose_projection ---------------------------------------------------------------------


def _parts(P: Any) -> Any:
    """Take P apart as it should be, with K[2, 2] still open."""
    M = P[:, :3] * np.sign(np.linalg.det(P[:, :3]))
    Q, U = np.linalg.qr(np.linalg.inv(M))
    D = np.diag(np.sign(np.diag(U)))
    return np.linalg.inv(U) @ D, D @ Q.T, -np.linalg.inv(P[:, :3]) @ P[:, 3]


def _right(P: Any) -> Any:
    K, R, centre = _parts(P)
    return K / K[2, 2], R, centre


def _signs_left(P: Any) -> Any:
    Q, U = np.linalg.qr(np.linalg.inv(P[:, :3]))
    K = np.linalg.inv(U)
    return K / K[2, 2], Q.T, _parts(P)[2]


def signs_as_they_come(P):
    return _signs_left(P)


def signs_as_they_come_from_flipping(P):
    Q, U = np.linalg.qr(P[::-1, :3].T)
    K, R = U.T[::-1, ::-1], Q.T[::-1]
    return K / K[2, 2], R, _parts(P)[2]


def signs_as_they_come_from_scipy(P):
    from scipy.linalg import rq

    K, R = rq(P[:, :3])
    return K / K[2, 2], R, _parts(P)[2]


def signs_as_they_come_after_the_mirror(P):
    return _signs_left(P * np.sign(np.linalg.det(P[:, :3])))


def signs_of_K_only(P):
    Q, U = np.linalg.qr(np.linalg.inv(P[:, :3] * np.sign(np.linalg.det(P[:, :3]))))
    K = np.linalg.inv(U)
    K = K * np.sign(np.diag(K))
    return K / K[2, 2], Q.T, _parts(P)[2]


def signs_of_K_only_without_the_mirror(P):
    Q, U = np.linalg.qr(np.linalg.inv(P[:, :3]))
    K = np.linalg.inv(U)
    K = K * np.sign(np.diag(K))
    return K / K[2, 2], Q.T, _parts(P)[2]


def signs_of_K_in_the_columns_of_R(P):
    Q, U = np.linalg.qr(np.linalg.inv(P[:, :3] * _sign(P)))
    signs = np.sign(np.diag(U))
    return _right(P)[0], signs * Q.T, _parts(P)[2]


def signs_on_the_outer_sides(P):
    Q, U = np.linalg.qr(np.linalg.inv(P[:, :3] * _sign(P)))
    D = np.diag(np.sign(np.diag(U)))
    K = D @ np.linalg.inv(U)
    return K / K[2, 2], Q.T @ D, _parts(P)[2]


def inverse_left_in_K(P):
    Q, U = np.linalg.qr(np.linalg.inv(P[:, :3] * _sign(P)))
    D = np.diag(np.sign(np.diag(U)))
    K = U @ D
    return K / K[2, 2], D @ Q.T, _parts(P)[2]


def _sign(P: Any) -> Any:
    return np.sign(np.linalg.det(P[:, :3]))


def mirror_left_in(P):
    K, R, centre = _right(P)
    return K, R * np.sign(np.linalg.det(P[:, :3])), centre


def rotation_first(P):
    R, K = np.linalg.qr(P[:, :3])
    return K / K[2, 2], R, _parts(P)[2]


def rotation_first_with_signs(P):
    R, K = np.linalg.qr(P[:, :3])
    D = np.diag(np.sign(np.diag(K)))
    return D @ K / abs(K[2, 2]), R @ D, _parts(P)[2]


def rotation_first_signs_inside(P):
    R, K = np.linalg.qr(P[:, :3])
    D = np.diag(np.sign(np.diag(K)))
    return K @ D / (K @ D)[2, 2], D @ R, _parts(P)[2]


def K_not_divided(P):
    return _parts(P)


def rotation_transposed(P):
    K, R, centre = _right(P)
    return K, R.T, centre


def transpose_left_out(P):
    Q, U = np.linalg.qr(np.linalg.inv(P[:, :3] * _sign(P)))
    D = np.diag(np.sign(np.diag(U)))
    return _right(P)[0], D @ Q, _parts(P)[2]


def null_vector_not_divided(P):
    K, R, _ = _right(P)
    return K, R, np.linalg.svd(P)[2][-1][:3]


def last_column_as_centre(P):
    K, R, _ = _right(P)
    return K, R, P[:, 3]


def minus_last_column_as_centre(P):
    K, R, _ = _right(P)
    return K, R, -P[:, 3]


def translation_as_centre(P):
    K, R, _ = _right(P)
    return K, R, np.linalg.inv(_parts(P * np.sign(np.linalg.det(P[:, :3])))[0]) @ P[:, 3]


def translation_of_a_scaled_matrix(P):
    K, R, _ = _right(P)
    return K, R, np.linalg.inv(K) @ P[:, 3]


def scale_left_in_the_centre(P):
    K, R, _ = _right(P)
    return K, R, -R.T @ np.linalg.inv(K) @ P[:, 3]


def last_column_without_K(P):
    K, R, _ = _right(P)
    return K, R, -R.T @ P[:, 3]


def sign_of_the_centre(P):
    K, R, centre = _right(P)
    return K, R, -centre


def t_for_the_centre(P):
    K, R, centre = _right(P)
    return K, R, -R @ centre
