"""Wrong answers to the exercise of chapter 06 that takes a camera matrix apart."""

from __future__ import annotations

from typing import Any

import numpy as np


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


def divided_before_the_signs(P):
    return _divided_first(P * np.sign(np.linalg.det(P[:, :3])))


def divided_before_the_signs_without_the_mirror(P):
    return _divided_first(P)


def _divided_first(P: Any) -> Any:
    K, R, centre = _signs_left(P)
    D = np.diag(np.sign(np.diag(K)))
    return K @ D, D @ R, centre


def block_taken_too_early(P):
    K, R, _ = _right(P)
    sign = np.sign(np.linalg.det(P[:, :3]))
    return K, sign * R, -np.linalg.inv(P[:, :3]) @ (sign * P[:, 3])


def rotation_first_and_nothing_else(P):
    Q, U = np.linalg.qr(P[:, :3])
    return U, Q, _parts(P)[2]


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


def rotation_before_K(P):
    K, R, centre = _right(P)
    return R, K, centre


def centre_before_R(P):
    K, R, centre = _right(P)
    return K, centre, R


def centre_first(P):
    K, R, centre = _right(P)
    return centre, K, R


def turned_round(P):
    return _right(P)[::-1]
