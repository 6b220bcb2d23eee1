"""Wrong answers to the exercises of chapter 06 on homographies."""

from __future__ import annotations

from typing import Any

import numpy as np

# --- normalise_points -------------------------------------------------------------------------


def _similarity(points: Any, scale: Any, centre: Any) -> Any:
    d = points.shape[1]
    T = np.eye(d + 1)
    T[range(d), range(d)] = scale
    T[:d, d] = -scale * centre
    return scale * (points - centre), T


def _mean_distance(points: Any, centre: Any) -> Any:
    return np.linalg.norm(points - centre, axis=1).mean()


def distance_of_one(points):
    centre = points.mean(axis=0)
    return _similarity(points, 1 / _mean_distance(points, centre), centre)


def root_two_in_space_too(points):
    centre = points.mean(axis=0)
    return _similarity(points, np.sqrt(2) / _mean_distance(points, centre), centre)


def root_mean_square_distance(points):
    centre = points.mean(axis=0)
    squares = ((points - centre) ** 2).sum(axis=1)
    return _similarity(points, np.sqrt(points.shape[1] / squares.mean()), centre)


def each_axis_by_itself(points):
    centre = points.mean(axis=0)
    return _similarity(points, 1 / points.std(axis=0), centre)


def each_axis_to_one(points):
    centre = points.mean(axis=0)
    return _similarity(points, 1 / np.abs(points - centre).mean(axis=0), centre)


def distance_before_the_shift(points):
    scale = np.sqrt(points.shape[1]) / np.linalg.norm(points, axis=1).mean()
    return _similarity(points, scale, points.mean(axis=0))


def scaled_the_other_way(points):
    centre = points.mean(axis=0)
    return _similarity(points, _mean_distance(points, centre) / np.sqrt(points.shape[1]), centre)


def shift_not_scaled_in_T(points):
    centre = points.mean(axis=0)
    normalised, T = _similarity(
        points, np.sqrt(points.shape[1]) / _mean_distance(points, centre), centre
    )
    T[:-1, -1] = -centre
    return normalised, T


def shift_to_the_wrong_side_in_T(points):
    centre = points.mean(axis=0)
    normalised, T = _similarity(
        points, np.sqrt(points.shape[1]) / _mean_distance(points, centre), centre
    )
    T[:-1, -1] *= -1
    return normalised, T


def T_of_the_way_back(points):
    centre = points.mean(axis=0)
    normalised, T = _similarity(
        points, np.sqrt(points.shape[1]) / _mean_distance(points, centre), centre
    )
    return normalised, np.linalg.inv(T)


def one_mean_for_all_axes(points):
    scale = np.sqrt(points.shape[1]) / _mean_distance(points, points.mean())
    return _similarity(points, scale, np.full(points.shape[1], points.mean()))


def T_before_the_points(points):
    centre = points.mean(axis=0)
    return _similarity(points, np.sqrt(points.shape[1]) / _mean_distance(points, centre), centre)[
        ::-1
    ]


# --- homography_dlt ---------------------------------------------------------------------------


def _usual(points: Any) -> Any:
    centre = points.mean(axis=0)
    return _similarity(points, np.sqrt(2) / _mean_distance(points, centre), centre)


def _design(points: Any, targets: Any, sign: int = -1) -> Any:
    rows = []
    for (x, y), (u, v) in zip(points, targets, strict=True):
        rows.append([x, y, 1, 0, 0, 0, sign * u * x, sign * u * y, sign * u])
        rows.append([0, 0, 0, x, y, 1, sign * v * x, sign * v * y, sign * v])
    return np.array(rows)


def _vectors(points: Any, targets: Any) -> Any:
    return np.linalg.svd(_design(points, targets))[2]


def _scaled(H: Any) -> Any:
    return H / H[2, 2]


def numbers_as_they_come(points, targets):
    return _scaled(_vectors(points, targets)[-1].reshape(3, 3))


def only_the_targets_normalised(points, targets):
    q, T = _usual(targets)
    return _scaled(np.linalg.inv(T) @ _vectors(points, q)[-1].reshape(3, 3))


def only_the_points_normalised(points, targets):
    p, T = _usual(points)
    return _scaled(_vectors(p, targets)[-1].reshape(3, 3) @ T)


def still_normalised(points, targets):
    return _scaled(_vectors(_usual(points)[0], _usual(targets)[0])[-1].reshape(3, 3))


def _between(points: Any, targets: Any) -> Any:
    (p, T_points), (q, T_targets) = _usual(points), _usual(targets)
    return T_points, _vectors(p, q)[-1].reshape(3, 3), T_targets


def undone_in_the_wrong_order(points, targets):
    T_points, H, T_targets = _between(points, targets)
    return _scaled(T_points @ H @ np.linalg.inv(T_targets))


def undone_on_the_wrong_side(points, targets):
    T_points, H, T_targets = _between(points, targets)
    return _scaled(np.linalg.inv(T_points) @ H @ T_targets)


def done_once_more(points, targets):
    T_points, H, T_targets = _between(points, targets)
    return _scaled(T_targets @ H @ np.linalg.inv(T_points))


def undone_with_one_matrix(points, targets):
    T_points, H, _ = _between(points, targets)
    return _scaled(np.linalg.inv(T_points) @ H @ T_points)


def _solved_by(pick: Any, points: Any, targets: Any) -> Any:
    (p, T_points), (q, T_targets) = _usual(points), _usual(targets)
    return _scaled(np.linalg.inv(T_targets) @ pick(_design(p, q)).reshape(3, 3) @ T_points)


def longest_for_shortest(points, targets):
    return _solved_by(lambda A: np.linalg.svd(A)[2][0], points, targets)


def last_column_of_the_transposed(points, targets):
    return _solved_by(lambda A: np.linalg.svd(A)[2][:, -1], points, targets)


def read_column_by_column(points, targets):
    return _solved_by(
        lambda A: np.linalg.svd(A)[2][-1].reshape(3, 3).T,
        points,
        targets,
    )


def wrong_sign_in_the_rows(points, targets):
    (p, T_points), (q, T_targets) = _usual(points), _usual(targets)
    H = np.linalg.svd(_design(p, q, sign=1))[2][-1].reshape(3, 3)
    return _scaled(np.linalg.inv(T_targets) @ H @ T_points)


def from_targets_to_points(points, targets):
    T_points, H, T_targets = _between(targets, points)
    return _scaled(np.linalg.inv(T_targets) @ H @ T_points)


def only_affine(points, targets):
    X = np.column_stack([points, np.ones(len(points))])
    return np.vstack([np.linalg.lstsq(X, targets)[0].T, [0, 0, 1]])


def first_four_points(points, targets):
    T_points, H, T_targets = _between(points[:4], targets[:4])
    return _scaled(np.linalg.inv(T_targets) @ H @ T_points)


# --- apply_homography -------------------------------------------------------------------------


def _images(points: Any, H: Any) -> Any:
    return np.concatenate([points, np.ones_like(points[..., :1])], axis=-1) @ H.T


def _finite(w: Any) -> Any:
    return np.where(w == 0, np.nan, w)


def not_divided(points, H):
    return _images(points, H)[..., :2]


def matrix_not_transposed(points, H):
    x = np.concatenate([points, np.ones_like(points[..., :1])], axis=-1) @ H
    return x[..., :2] / _finite(x[..., 2:])


def zero_for_one(points, H):
    x = np.concatenate([points, np.zeros_like(points[..., :1])], axis=-1) @ H.T
    return x[..., :2] / _finite(x[..., 2:])


def way_back(points, H):
    x = _images(points, np.linalg.inv(H))
    return x[..., :2] / _finite(x[..., 2:])


def one_divisor_for_all(points, H):
    return _images(points, H)[..., :2] / H[2, 2]


def three_numbers_for_a_point(points, H):
    x = _images(points, H)
    return x / _finite(x[..., 2:])


def infinity_divided(points, H):
    x = _images(points, H)
    return x[..., :2] / x[..., 2:]


def infinity_left_undivided(points, H):
    x = _images(points, H)
    return x[..., :2] / np.where(x[..., 2:] == 0, 1, x[..., 2:])


def v_before_u(points, H):
    x = _images(points, H)
    return x[..., 1::-1] / _finite(x[..., 2:])
