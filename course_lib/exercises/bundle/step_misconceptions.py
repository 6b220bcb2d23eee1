"""Wrong answers to the exercise of chapter 10 on the normal equations."""

from __future__ import annotations

from typing import Any

import numpy as np


def left_for_cameras(
    U: Any, W: Any, V: Any, g_c: Any, g_p: Any, by: float = -1, add: float = 1
) -> Any:
    """Return the step of the cameras, with chosen signs of the two sums."""
    Y = W @ np.linalg.inv(V)
    S = U + by * sum(Y @ W.swapaxes(1, 2))
    return np.linalg.solve(S, -g_c + add * np.einsum("nck,nk->c", Y, g_p))


def followed(W: Any, V: Any, g_p: Any, cameras: Any) -> Any:
    return np.linalg.solve(V, (-g_p - np.einsum("nck,c->nk", W, cameras))[..., None])[..., 0]


def added_to_U(U, W, V, g_c, g_p):
    cameras = left_for_cameras(U, W, V, g_c, g_p, by=1)
    return cameras, followed(W, V, g_p, cameras)


def points_ignored(U, W, V, g_c, g_p):
    cameras = np.linalg.solve(U, -g_c)
    return cameras, followed(W, V, g_p, cameras)


def each_alone(U, W, V, g_c, g_p):
    return np.linalg.solve(U, -g_c), np.linalg.solve(V, -g_p[..., None])[..., 0]


def gradient_of_points_left_out(U, W, V, g_c, g_p):
    cameras = left_for_cameras(U, W, V, g_c, g_p, add=0)
    return cameras, followed(W, V, g_p, cameras)


def gradient_of_points_subtracted(U, W, V, g_c, g_p):
    cameras = left_for_cameras(U, W, V, g_c, g_p, add=-1)
    return cameras, followed(W, V, g_p, cameras)


def uphill(U, W, V, g_c, g_p):
    cameras = left_for_cameras(U, W, V, -g_c, -g_p)
    return cameras, followed(W, V, -g_p, cameras)


def cameras_uphill(U, W, V, g_c, g_p):
    cameras = left_for_cameras(U, W, V, -g_c, g_p)
    return cameras, followed(W, V, g_p, cameras)


def points_uphill(U, W, V, g_c, g_p):
    cameras = left_for_cameras(U, W, V, g_c, g_p)
    return cameras, followed(W, V, -g_p, cameras)


def cameras_put_in_with_plus(U, W, V, g_c, g_p):
    cameras = left_for_cameras(U, W, V, g_c, g_p)
    return cameras, followed(W, V, g_p, -cameras)


def points_do_not_follow(U, W, V, g_c, g_p):
    cameras = left_for_cameras(U, W, V, g_c, g_p)
    return cameras, np.linalg.solve(V, -g_p[..., None])[..., 0]


def V_not_inverted(U, W, V, g_c, g_p):
    Y = W @ V
    S = U - sum(Y @ W.swapaxes(1, 2))
    cameras = np.linalg.solve(S, -g_c + np.einsum("nck,nk->c", Y, g_p))
    return cameras, followed(W, V, g_p, cameras)


def inverted_entry_by_entry(U, W, V, g_c, g_p):
    Y = W @ (1 / V)
    S = U - sum(Y @ W.swapaxes(1, 2))
    cameras = np.linalg.solve(S, -g_c + np.einsum("nck,nk->c", Y, g_p))
    return cameras, followed(W, V, g_p, cameras)


def the_last_point_only(U, W, V, g_c, g_p):
    cameras = left_for_cameras(U, W[-1:], V[-1:], g_c, g_p[-1:])
    return cameras, followed(W, V, g_p, cameras)


def S_of_the_last_point_only(U, W, V, g_c, g_p):
    Y = W @ np.linalg.inv(V)
    cameras = np.linalg.solve(U - Y[-1] @ W[-1].T, -g_c + np.einsum("nck,nk->c", Y, g_p))
    return cameras, followed(W, V, g_p, cameras)


def right_side_of_the_last_point_only(U, W, V, g_c, g_p):
    Y = W @ np.linalg.inv(V)
    S = U - sum(Y @ W.swapaxes(1, 2))
    cameras = np.linalg.solve(S, -g_c + Y[-1] @ g_p[-1])
    return cameras, followed(W, V, g_p, cameras)


def U_left_out(U, W, V, g_c, g_p):
    cameras = left_for_cameras(0 * U, W, V, g_c, g_p)
    return cameras, followed(W, V, g_p, cameras)


def both_begin_at_zero(U, W, V, g_c, g_p):
    cameras = left_for_cameras(0 * U, W, V, 0 * g_c, g_p)
    return cameras, followed(W, V, g_p, cameras)


def both_begin_at_zero_and_grow(U, W, V, g_c, g_p):
    cameras = left_for_cameras(0 * U, W, V, 0 * g_c, g_p, by=1)
    return cameras, followed(W, V, g_p, cameras)


def sum_of_the_points_only(U, W, V, g_c, g_p):
    cameras = left_for_cameras(0 * U, W, V, g_c, g_p, by=1)
    return cameras, followed(W, V, g_p, cameras)


def gradient_of_cameras_left_out(U, W, V, g_c, g_p):
    cameras = left_for_cameras(U, W, V, 0 * g_c, g_p)
    return cameras, followed(W, V, g_p, cameras)


def whole_stacks(U, W, V, g_c, g_p):
    """Write the equation down as if there were one point; NumPy says that it does not fit."""
    Y = W @ np.linalg.inv(V)
    cameras = np.linalg.solve(U - Y @ W.T, -g_c + Y @ g_p)
    return cameras, np.linalg.inv(V) @ (-g_p - W.T @ cameras)


def whole_stacks_turned_rightly(U, W, V, g_c, g_p):
    Y = W @ np.linalg.inv(V)
    right = -g_c + np.einsum("nck,nk->nc", Y, g_p)
    cameras = np.linalg.solve(U - Y @ W.swapaxes(1, 2), right[..., None])[..., 0]
    return cameras, np.linalg.solve(V, (-g_p - np.einsum("nck,nc->nk", W, cameras))[..., None])[
        ..., 0
    ]


def summed_over_everything(U, W, V, g_c, g_p):
    Y = W @ np.linalg.inv(V)
    right = -g_c + np.sum(np.einsum("nck,nk->nc", Y, g_p))
    cameras = np.linalg.solve(U - np.sum(Y @ W.swapaxes(1, 2)), right)
    return cameras, followed(W, V, g_p, cameras)


def S_summed_over_everything(U, W, V, g_c, g_p):
    Y = W @ np.linalg.inv(V)
    right = -g_c + np.einsum("nck,nk->c", Y, g_p)
    cameras = np.linalg.solve(U - np.sum(Y @ W.swapaxes(1, 2)), right)
    return cameras, followed(W, V, g_p, cameras)


def back_after_the_first_point(U, W, V, g_c, g_p):
    cameras, points = left_for_cameras(U, W, V, g_c, g_p), np.zeros_like(g_p)
    points[0] = followed(W, V, g_p, cameras)[0]
    return cameras, points


def back_after_the_first_round(U, W, V, g_c, g_p):
    cameras, points = left_for_cameras(U, W[:1], V[:1], g_c, g_p[:1]), np.zeros_like(g_p)
    points[0] = followed(W[:1], V[:1], g_p[:1], cameras)[0]
    return cameras, points


def first_point_only_returned(U, W, V, g_c, g_p):
    cameras = left_for_cameras(U, W, V, g_c, g_p)
    return cameras, followed(W, V, g_p, cameras)[:1]


def inverted_entry_by_entry_everywhere(U, W, V, g_c, g_p):
    Y = W @ (1 / V)
    S = U - sum(Y @ W.swapaxes(1, 2))
    cameras = np.linalg.solve(S, -g_c + np.einsum("nck,nk->c", Y, g_p))
    left = -g_p - np.einsum("nck,c->nk", W, cameras)
    return cameras, np.einsum("nij,nj->ni", 1 / V, left)


def inverse_times_entries(U, W, V, g_c, g_p):
    """Multiply the inverse with `*`: that makes a table, which the points do not take."""
    Y = W @ np.linalg.inv(V)
    S = U - sum(Y @ W.swapaxes(1, 2))
    cameras = np.linalg.inv(S) * (-g_c + np.einsum("nck,nk->c", Y, g_p))
    points = np.empty_like(g_p)
    for j, W_j in enumerate(W):
        points[j] = np.linalg.solve(V[j], -g_p[j] - W_j.T @ cameras)
    return cameras, points


def U_once_for_each_point(U, W, V, g_c, g_p):
    cameras = left_for_cameras(len(W) * U, W, V, len(W) * g_c, g_p)
    return cameras, followed(W, V, g_p, cameras)


def not_transposed(U, W, V, g_c, g_p):
    """Leave out all transposes; where the shapes do not fit, NumPy says so."""
    Y = W @ np.linalg.inv(V)
    cameras = np.linalg.solve(U - sum(Y @ W), -g_c + np.einsum("nck,nk->c", Y, g_p))
    return cameras, np.array(
        [np.linalg.solve(V_j, -g - W_j @ cameras) for V_j, g, W_j in zip(V, g_p, W, strict=True)]
    )


def not_transposed_for_cameras(U, W, V, g_c, g_p):
    Y = W @ np.linalg.inv(V)
    cameras = np.linalg.solve(U - sum(Y @ W), -g_c + np.einsum("nck,nk->c", Y, g_p))
    return cameras, followed(W, V, g_p, cameras)


def not_transposed_for_points(U, W, V, g_c, g_p):
    cameras = left_for_cameras(U, W, V, g_c, g_p)
    return cameras, np.array(
        [np.linalg.solve(V_j, -g - W_j @ cameras) for V_j, g, W_j in zip(V, g_p, W, strict=True)]
    )


def points_first(U, W, V, g_c, g_p):
    cameras = left_for_cameras(U, W, V, g_c, g_p)
    return followed(W, V, g_p, cameras), cameras


def all_in_one_row(U, W, V, g_c, g_p):
    cameras = left_for_cameras(U, W, V, g_c, g_p)
    return np.concatenate([cameras, followed(W, V, g_p, cameras).ravel()])


def points_in_a_row(U, W, V, g_c, g_p):
    cameras = left_for_cameras(U, W, V, g_c, g_p)
    return cameras, followed(W, V, g_p, cameras).ravel()


def cameras_only(U, W, V, g_c, g_p):
    return left_for_cameras(U, W, V, g_c, g_p)


def last_point_only_returned(U, W, V, g_c, g_p):
    cameras = left_for_cameras(U, W, V, g_c, g_p)
    return cameras, followed(W, V, g_p, cameras)[-1]


def cameras_not_solved(U, W, V, g_c, g_p):
    Y = W @ np.linalg.inv(V)
    S = U - sum(Y @ W.swapaxes(1, 2))
    cameras = S @ (-g_c + np.einsum("nck,nk->c", Y, g_p))
    return cameras, followed(W, V, g_p, cameras)


def points_not_solved(U, W, V, g_c, g_p):
    cameras = left_for_cameras(U, W, V, g_c, g_p)
    return cameras, -g_p - np.einsum("nck,c->nk", W, cameras)


def points_multiplied_by_V(U, W, V, g_c, g_p):
    cameras = left_for_cameras(U, W, V, g_c, g_p)
    return cameras, np.einsum("nij,nj->ni", V, -g_p - np.einsum("nck,c->nk", W, cameras))
