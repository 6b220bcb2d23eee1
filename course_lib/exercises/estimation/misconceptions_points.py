"""Wrong answers to the exercises of chapter 06 on applying a homography and normalising."""

from __future__ import annotations

from typing import Any

import numpy as np

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


def divided_by_one_long_row(points, H):
    x = _images(points, H)
    return x[:, :2] / x[:, 2]


def divided_by_one_long_row_of_any(points, H):
    x = _images(points, H)
    return x[..., :2] / x[..., 2]


def a_single_point_stood_up(points, H):
    x = np.column_stack([points, np.ones(len(points))]) @ H.T
    return x[..., :2] / _finite(x[..., 2:])


def columns_of_a_single_point(points, H):
    x = _images(points, H)
    return x[:, :2] / _finite(x[:, 2:])


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


def infinity_made_zero(points, H):
    x = _images(points, H)
    return np.where(x[..., 2:] == 0, 0, x[..., :2] / _finite(x[..., 2:]))


def infinity_made_far(points, H):
    x = _images(points, H)
    return x[..., :2] / np.where(x[..., 2:] == 0, 1e-12, x[..., 2:])


def sign_of_w_dropped(points, H):
    x = _images(points, H)
    return x[..., :2] / np.abs(_finite(x[..., 2:]))


def v_before_u(points, H):
    x = _images(points, H)
    return x[..., 1::-1] / _finite(x[..., 2:])


# --- normalise_points -------------------------------------------------------------------------


def _similarity(points: Any, scale: Any, centre: Any) -> Any:
    d = points.shape[1]
    T = np.eye(d + 1)
    T[range(d), range(d)] = scale
    T[:d, d] = -scale * centre
    return scale * (points - centre), T


def _mean_distance(points: Any, centre: Any) -> Any:
    return np.linalg.norm(points - centre, axis=1).mean()


def normalised(points: Any) -> Any:
    """Normalise as it should be, without checks, for other wrong answers."""
    centre = points.mean(axis=0)
    return _similarity(points, np.sqrt(points.shape[1]) / _mean_distance(points, centre), centre)


def only_one_row(given: Any, shape: tuple[int, int], targets: Any) -> bool:
    """Whether a matrix is what the rows of one coordinate leave: the row of the other, alone."""
    M = np.asarray(given, dtype=float)
    if M.shape != shape or not np.isfinite(M).all():
        return bool(M.shape == shape)  # divided by a last number of zero
    lengths = np.sort(np.linalg.norm(normalised(targets)[1] @ M, axis=1))
    return bool(lengths[1] < 1e-6 * lengths[2])


def distance_of_one(points):
    centre = points.mean(axis=0)
    return _similarity(points, 1 / _mean_distance(points, centre), centre)


def distance_of_d(points):
    centre = points.mean(axis=0)
    return _similarity(points, points.shape[1] / _mean_distance(points, centre), centre)


def farthest_point(points):
    centre = points.mean(axis=0)
    farthest = np.linalg.norm(points - centre, axis=1).max()
    return _similarity(points, np.sqrt(points.shape[1]) / farthest, centre)


def farthest_point_at_one(points):
    centre = points.mean(axis=0)
    return _similarity(points, 1 / np.linalg.norm(points - centre, axis=1).max(), centre)


def length_of_the_whole_table(points):
    centre = points.mean(axis=0)
    return _similarity(points, np.sqrt(points.shape[1]) / np.linalg.norm(points - centre), centre)


def lengths_of_columns(points):
    centre = points.mean(axis=0)
    lengths = np.linalg.norm(points - centre, axis=0)
    return _similarity(points, np.sqrt(points.shape[1]) / lengths.mean(), centre)


def mean_of_all_numbers(points):
    centre = points.mean(axis=0)
    return _similarity(points, np.sqrt(points.shape[1]) / np.abs(points - centre).mean(), centre)


def root_two_and_T_of_the_plane(points):
    there, T = root_two_of(points)
    return there, T if len(T) == 3 else np.delete(np.delete(T, 2, axis=0), 2, axis=1)


def root_two_of(points: Any) -> Any:
    centre = points.mean(axis=0)
    return _similarity(points, np.sqrt(2) / _mean_distance(points, centre), centre)


def root_two_in_space_too(points):
    return root_two_of(points)


def root_mean_square_distance(points):
    centre = points.mean(axis=0)
    squares = ((points - centre) ** 2).sum(axis=1)
    return _similarity(points, np.sqrt(points.shape[1] / squares.mean()), centre)


def _of_deviations(points: Any, distance: Any) -> Any:
    return _similarity(points, distance / points.std(), points.mean(axis=0))


def standard_deviation_of_all(points):
    return _of_deviations(points, np.sqrt(2))


def standard_deviation_of_all_by_dimension(points):
    return _of_deviations(points, np.sqrt(points.shape[1]))


def standard_deviation_from_the_mean(points):
    centre = points.mean(axis=0)
    return _similarity(points, np.sqrt(2) / (points - centre).std(), centre)


def standard_deviation_from_the_mean_by_dimension(points):
    centre = points.mean(axis=0)
    return _similarity(points, np.sqrt(points.shape[1]) / (points - centre).std(), centre)


def spread_of_the_distances(points):
    centre = points.mean(axis=0)
    spread = np.linalg.norm(points - centre, axis=1).std()
    return _similarity(points, np.sqrt(points.shape[1]) / spread, centre)


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
    there, T = normalised(points)
    T[:-1, -1] = -points.mean(axis=0)
    return there, T


def shift_to_the_wrong_side_in_T(points):
    there, T = normalised(points)
    T[:-1, -1] *= -1
    return there, T


def T_transposed(points):
    there, T = normalised(points)
    return there, T.T


def corner_of_T_scaled(points):
    there, T = normalised(points)
    T[-1, -1] = T[0, 0]
    return there, T


def shift_divided_in_T(points):
    centre = points.mean(axis=0)
    scale = np.sqrt(points.shape[1]) / _mean_distance(points, centre)
    there, T = _similarity(points, scale, centre)
    T[:-1, -1] = -centre / scale
    return there, T


def scaled_before_the_shift(points):
    centre = points.mean(axis=0)
    scale = np.sqrt(points.shape[1]) / _mean_distance(points, centre)
    return scale * points - centre, _similarity(points, scale, centre)[1]


def median_for_the_middle(points):
    centre = np.median(points, axis=0)
    scale = np.sqrt(points.shape[1]) / _mean_distance(points, centre)
    return _similarity(points, scale, centre)


def T_of_the_way_back(points):
    there, T = normalised(points)
    return there, np.linalg.inv(T)


def one_mean_for_all_axes(points):
    scale = np.sqrt(points.shape[1]) / _mean_distance(points, points.mean())
    return _similarity(points, scale, np.full(points.shape[1], points.mean()))


def T_before_the_points(points):
    centre = points.mean(axis=0)
    return _similarity(points, np.sqrt(points.shape[1]) / _mean_distance(points, centre), centre)[
        ::-1
    ]
