"""Wrong answers to the exercise of chapter 07 on the pose of a board."""

from __future__ import annotations

from typing import Any

import numpy as np


def scaled(M: Any) -> Any:
    M = M / np.mean([np.linalg.norm(M[:, 0]), np.linalg.norm(M[:, 1])])
    return -M if M[2, 2] < 0 else M


def nearest_rotation(M: Any) -> Any:
    U, _, Vt = np.linalg.svd(np.column_stack([M[:, 0], M[:, 1], np.cross(M[:, 0], M[:, 1])]))
    return U @ Vt


def intrinsics_left_out(K, H):
    M = scaled(H)
    return nearest_rotation(M), M[:, 2]


def K_not_inverted(K, H):
    M = scaled(K @ H)
    return nearest_rotation(M), M[:, 2]


def behind_the_camera(K, H):
    M = scaled(np.linalg.inv(K) @ H) * (1 if H[2, 2] > 0 else -1)
    return nearest_rotation(M), M[:, 2]


def only_t_turned_to_the_front(K, H):
    M = scaled(np.linalg.inv(K) @ H) * (1 if H[2, 2] > 0 else -1)
    return nearest_rotation(M), M[:, 2] * np.sign(M[2, 2])


def last_factor_transposed(K, H):
    M = scaled(np.linalg.inv(K) @ H)
    U, _, Vt = np.linalg.svd(np.column_stack([M[:, 0], M[:, 1], np.cross(M[:, 0], M[:, 1])]))
    return U @ Vt.T, M[:, 2]


def built_upon_r1(K, H):
    M = scaled(np.linalg.inv(K) @ H)
    r1 = M[:, 0] / np.linalg.norm(M[:, 0])
    r2 = M[:, 1] - r1 * (r1 @ M[:, 1])
    r2 = r2 / np.linalg.norm(r2)
    return np.column_stack([r1, r2, np.cross(r1, r2)]), M[:, 2]


def not_a_rotation(K, H):
    M = scaled(np.linalg.inv(K) @ H)
    r1, r2, t = M.T
    return np.column_stack([r1, r2, np.cross(r1, r2)]), t


def lengths_mended_only(K, H):
    M = scaled(np.linalg.inv(K) @ H)
    r1, r2, t = M.T
    r1, r2 = r1 / np.linalg.norm(r1), r2 / np.linalg.norm(r2)
    return np.column_stack([r1, r2, np.cross(r1, r2)]), t


def t_not_scaled(K, H):
    M = np.linalg.inv(K) @ H
    return nearest_rotation(scaled(M)), M[:, 2]


def t_scaled_by_r1(K, H):
    M = scaled(np.linalg.inv(K) @ H)
    return nearest_rotation(M), M[:, 2] / np.linalg.norm(M[:, 0])


def scaled_by(M: Any, length: Any) -> Any:
    M = M / length
    return -M if M[2, 2] < 0 else M


def geometric_mean(K, H):
    M = np.linalg.inv(K) @ H
    M = scaled_by(M, np.sqrt(np.linalg.norm(M[:, 0]) * np.linalg.norm(M[:, 1])))
    return nearest_rotation(M), M[:, 2]


def quadratic_mean(K, H):
    M = np.linalg.inv(K) @ H
    M = scaled_by(M, np.linalg.norm(M[:, :2]) / np.sqrt(2))
    return nearest_rotation(M), M[:, 2]


def rows_for_columns(K, H):
    M = np.linalg.inv(K) @ H
    M = scaled_by(M, np.linalg.norm(M, axis=1)[:2].mean())
    return nearest_rotation(M), M[:, 2]


def each_made_one_before_the_rotation(K, H):
    M = scaled(np.linalg.inv(K) @ H)
    lengths = np.linalg.norm(M, axis=0)
    return nearest_rotation(M / lengths), M[:, 2] / lengths[0]


def each_made_one_and_t_by_the_mean(K, H):
    M = scaled(np.linalg.inv(K) @ H)
    return nearest_rotation(M / np.linalg.norm(M, axis=0)), M[:, 2]


def multiplied_number_by_number(K, H):
    M = scaled(np.linalg.inv(K) @ H)
    r1, r2, t = M.T
    U, _, Vt = np.linalg.svd(np.column_stack([r1, r2, r1 * r2]))
    return U @ Vt, t


def factors_number_by_number(K, H):
    M = scaled(np.linalg.inv(K) @ H)
    U, _, Vt = np.linalg.svd(np.column_stack([M[:, 0], M[:, 1], np.cross(M[:, 0], M[:, 1])]))
    return U * Vt, M[:, 2]


def mirrored(K, H):
    M = scaled(np.linalg.inv(K) @ H)
    r1, r2, t = M.T
    U, _, Vt = np.linalg.svd(np.column_stack([r1, r2, np.cross(r2, r1)]))
    return U @ Vt, t


def mirrored_and_not_a_rotation(K, H):
    M = scaled(np.linalg.inv(K) @ H)
    r1, r2, t = M.T
    return np.column_stack([r1, r2, np.cross(r2, r1)]), t


def camera_to_board(K, H):
    M = scaled(np.linalg.inv(K) @ H)
    return nearest_rotation(M).T, M[:, 2]


def third_column_in_R(K, H):
    M = scaled(np.linalg.inv(K) @ H)
    U, _, Vt = np.linalg.svd(M)
    return U @ Vt, M[:, 2]
