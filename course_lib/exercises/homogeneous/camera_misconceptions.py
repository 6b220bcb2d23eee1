"""Wrong answers to the exercises of chapter 02 on the camera matrix."""

from __future__ import annotations

from typing import Any

import numpy as np

# --- camera_matrix ----------------------------------------------------------------------------


def t_without_K(K, R, t):
    return np.column_stack([K @ R, t])


def t_before_the_turn(K, R, t):
    return K @ R @ np.column_stack([np.eye(3), t])


def R_transposed(K, R, t):
    return K @ np.column_stack([R.T, t])


def centre_in_the_last_column(K, R, t):
    return K @ np.column_stack([R, -R.T @ t])


def intrinsics_left_out(K, R, t):
    return np.column_stack([R, t])


def K_on_the_right(K, R, t):
    return np.column_stack([R @ K, K @ t])


def t_in_the_first_column(K, R, t):
    return K @ np.column_stack([t, R])


def K_times_t_entry_by_entry(K, R, t):
    return np.column_stack([K @ R, K * t])


def divided_by_the_last_number(K, R, t):
    P = K @ np.column_stack([R, t])
    return P / P[2, 3]


# --- project ----------------------------------------------------------------------------------


def _in_front(points: Any, P: Any) -> Any:
    depth = points @ P[2, :3] + P[2, 3]
    return (depth * np.linalg.det(P[:, :3]) > 0)[..., None]


def _images(points: Any, P: Any) -> Any:
    return points @ P[:, :3].T + P[:, 3]


def not_divided(points, P):
    return np.where(_in_front(points, P), _images(points, P)[..., :2], np.nan)


def divided_by_world_Z(points, P):
    return np.where(_in_front(points, P), _images(points, P)[..., :2] / points[..., 2:], np.nan)


def fourth_column_unused(points, P):
    x = points @ P[:, :3].T
    return np.where(_in_front(points, P), x[..., :2] / x[..., 2:], np.nan)


def mirrored_through_the_hole(points, P):
    x = _images(points, P)
    return x[..., :2] / x[..., 2:]


def sign_of_w_trusted(points, P):
    x = _images(points, P)
    return np.where(x[..., 2:] > 0, x[..., :2] / x[..., 2:], np.nan)


def v_before_u(points, P):
    x = _images(points, P)
    return np.where(_in_front(points, P), x[..., 1::-1] / x[..., 2:], np.nan)


def block_transposed(points, P):
    x = points @ P[:, :3] + P[:, 3]
    return np.where(_in_front(points, P), x[..., :2] / x[..., 2:], np.nan)


def all_numbers_made_positive(points, P):
    x = _images(points, np.abs(P))
    return np.where(x[..., 2:] > 0, x[..., :2] / x[..., 2:], np.nan)


def size_of_w(points, P):
    x = _images(points, P)
    return x[..., :2] / np.abs(x[..., 2:])


def points_left_out(points, P):
    x = _images(points, P if np.linalg.det(P[:, :3]) > 0 else -P)
    pixels = x[..., :2] / x[..., 2:]
    return pixels[x[:, 2] > 0] if x.ndim == 2 else pixels


# --- pixel_ray --------------------------------------------------------------------------------


def _ahead(pixels: Any, K: Any) -> Any:
    ones = np.ones_like(pixels[..., :1])
    return np.concatenate([pixels, ones], axis=-1) @ np.linalg.inv(K).T


def _unit(rays: Any) -> Any:
    return rays / np.linalg.norm(rays, axis=-1, keepdims=True)


def still_in_the_camera(pixels, K, R, t):
    return -R.T @ t, _unit(_ahead(pixels, K))


def turned_the_other_way(pixels, K, R, t):
    return -R.T @ t, _unit(_ahead(pixels, K) @ R.T)


def any_length(pixels, K, R, t):
    return -R.T @ t, _ahead(pixels, K) @ R


def starts_at_t(pixels, K, R, t):
    return t, _unit(_ahead(pixels, K) @ R)


def skew_ignored(pixels, K, R, t):
    straight = np.array([[K[0, 0], 0, K[0, 2]], [0, K[1, 1], K[1, 2]], [0, 0, 1]])
    return -R.T @ t, _unit(_ahead(pixels, straight) @ R)


def points_for_directions(pixels, K, R, t):
    return -R.T @ t, _unit(_ahead(pixels, K) @ R) - R.T @ t


def centre_of_the_picture_at_zero(pixels, K, R, t):
    return -R.T @ t, _unit(_ahead(pixels + K[:2, 2], K) @ R)


def point_made_a_unit_vector(pixels, K, R, t):
    return -R.T @ t, _unit(_ahead(pixels, K) @ R - R.T @ t)


def matrix_not_transposed(pixels, K, R, t):
    ones = np.ones_like(pixels[..., :1])
    ahead = np.concatenate([pixels, ones], axis=-1) @ np.linalg.inv(K)
    return -R.T @ t, _unit(ahead @ R)


def one_length_for_all(pixels, K, R, t):
    rays = _ahead(pixels, K) @ R
    return -R.T @ t, rays / np.linalg.norm(rays)


def length_of_each_column(pixels, K, R, t):
    rays = _ahead(pixels, K) @ R
    return -R.T @ t, rays / np.linalg.norm(rays, axis=0)


def intrinsics_not_inverted(pixels, K, R, t):
    ones = np.ones_like(pixels[..., :1])
    return -R.T @ t, _unit(np.concatenate([pixels, ones], axis=-1) @ K.T @ R)


def intrinsics_inverted_entry_by_entry(pixels, K, R, t):
    ones = np.ones_like(pixels[..., :1])
    return -R.T @ t, _unit(np.concatenate([pixels, ones], axis=-1) @ (1 / K).T @ R)


def rays_backwards(pixels, K, R, t):
    return -R.T @ t, -_unit(_ahead(pixels, K) @ R)
