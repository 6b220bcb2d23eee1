"""Wrong answers to the exercise of chapter 10 on derivatives."""

from __future__ import annotations

from typing import Any

import numpy as np

from course_lib.transforms import skew


def by_the_ray(K: Any, q: Any) -> Any:
    """Return the right derivatives of the pixel by the point in the camera's frame."""
    x, y, z = q
    return np.array([[1 / z, 0, -x / z**2], [0, 1 / z, -y / z**2]]) * np.diag(K)[:2, None]


def chained(A: Any, q: Any, R: Any) -> Any:
    return np.hstack([-A @ skew(q), -A @ R]), A @ R


def depth_with_plus(point, K, R, t):
    q = R @ point + t
    return chained(by_the_ray(K, q) * [1, 1, -1], q, R)


def depth_not_squared(point, K, R, t):
    q = R @ point + t
    return chained(by_the_ray(K, q) * [1, 1, q[2]], q, R)


def depth_left_out(point, K, R, t):
    q = R @ point + t
    return chained(by_the_ray(K, q) * [1, 1, 0], q, R)


def fx_for_both(point, K, R, t):
    q = R @ point + t
    A = by_the_ray(K, q)
    return chained(np.array([A[0], A[1] * K[0, 0] / K[1, 1]]), q, R)


def f_left_out(point, K, R, t):
    q = R @ point + t
    return chained(by_the_ray(np.eye(3), q), q, R)


def pixels_for_the_ray(point, K, R, t):
    """Derive by the depth as -u/z, with the principal point in u."""
    q = R @ point + t
    A = by_the_ray(K, q)
    A[:, 2] -= K[:2, 2] / q[2]
    return chained(A, q, R)


def u_and_v_swapped(point, K, R, t):
    q = R @ point + t
    return chained(by_the_ray(K, q)[::-1], q, R)


def translation_left_out(point, K, R, t):
    q = R @ point
    return chained(by_the_ray(K, q), q, R)


def rotation_left_out_of_q(point, K, R, t):
    q = point + t
    return chained(by_the_ray(K, q), q, R)


def the_world_for_q(point, K, R, t):
    return chained(by_the_ray(K, point), point, R)


def the_world_for_the_first_link(point, K, R, t):
    return chained(by_the_ray(K, point), R @ point + t, R)


def intrinsics_by_depth(point, K, R, t):
    q = R @ point + t
    return chained(K[:2] / q[2], q, R)


def rotation_transposed(point, K, R, t):
    q = R @ point + t
    return chained(by_the_ray(K, q), q, R.T)


def rotation_left_out(point, K, R, t):
    q = R @ point + t
    return chained(by_the_ray(K, q), q, np.eye(3))


def turn_of_the_world_point(point, K, R, t):
    q = R @ point + t
    A = by_the_ray(K, q)
    return np.hstack([-A @ skew(point), -A @ R]), A @ R


def turn_with_plus(point, K, R, t):
    q = R @ point + t
    A = by_the_ray(K, q)
    return np.hstack([A @ skew(q), -A @ R]), A @ R


def turn_followed_by_R(point, K, R, t):
    q = R @ point + t
    A = by_the_ray(K, q)
    return np.hstack([-A @ skew(q) @ R, -A @ R]), A @ R


def turn_left_unchained(point, K, R, t):
    q = R @ point + t
    A = by_the_ray(K, q)
    return np.hstack([-skew(q)[:2], -A @ R]), A @ R


def centre_with_plus(point, K, R, t):
    q = R @ point + t
    A = by_the_ray(K, q)
    return np.hstack([-A @ skew(q), A @ R]), A @ R


def translation_for_centre(point, K, R, t):
    q = R @ point + t
    A = by_the_ray(K, q)
    return np.hstack([-A @ skew(q), A]), A @ R


def point_with_minus(point, K, R, t):
    q = R @ point + t
    A = by_the_ray(K, q)
    return np.hstack([-A @ skew(q), -A @ R]), -A @ R


def move_before_turn(point, K, R, t):
    by_pose, by_point = chained(by_the_ray(K, R @ point + t), R @ point + t, R)
    return np.hstack([by_pose[:, 3:], by_pose[:, :3]]), by_point


def point_first(point, K, R, t):
    return chained(by_the_ray(K, R @ point + t), R @ point + t, R)[::-1]


def links_below_each_other(point, K, R, t):
    by_pose, by_point = chained(by_the_ray(K, R @ point + t), R @ point + t, R)
    return np.vstack([by_pose[:, :3], by_pose[:, 3:]]), by_point


def in_one_table(point, K, R, t):
    return np.hstack(chained(by_the_ray(K, R @ point + t), R @ point + t, R))


def pose_only(point, K, R, t):
    return chained(by_the_ray(K, R @ point + t), R @ point + t, R)[0]


def depth_squared_everywhere(point, K, R, t):
    q = R @ point + t
    return chained(by_the_ray(K, q) / [q[2], q[2], 1], q, R)


def not_divided_by_depth(point, K, R, t):
    q = R @ point + t
    return chained(by_the_ray(K, q) * [q[2], q[2], 1], q, R)


def x_in_both_rows(point, K, R, t):
    q = R @ point + t
    A = by_the_ray(K, q)
    A[1, 2] *= q[0] / q[1]
    return chained(A, q, R)


def rotation_transposed_in_q(point, K, R, t):
    q = R.T @ point + t
    return chained(by_the_ray(K, q), q, R)


def rotation_left_out_for_the_point(point, K, R, t):
    A = by_the_ray(K, R @ point + t)
    return chained(A, R @ point + t, R)[0], A


def turn_after_R(point, K, R, t):
    q = R @ point + t
    A = by_the_ray(K, q)
    return np.hstack([-A @ R @ skew(q), -A @ R]), A @ R


def point_only(point, K, R, t):
    return chained(by_the_ray(K, R @ point + t), R @ point + t, R)[1]


def first_link_only(point, K, R, t):
    return by_the_ray(K, R @ point + t)
