"""Wrong answers to the exercises of chapter 05 on pictures: the map, and straight lines."""

from __future__ import annotations

from typing import Any

import numpy as np

from course_lib import distortion

# --- undistortion_map -------------------------------------------------------------------------


def mapped(
    K: Any, coefficients: Any, image_size: Any, bend: Any = distortion.distort, first: Any = 0.0
) -> Any:
    """Return columns and rows of every pixel after some way to bend points."""
    width, height = image_size
    u, v = np.meshgrid(np.arange(width) + first, np.arange(height) + first)
    grid = np.stack([u.ravel(), v.ravel()], axis=1)
    found = (bend((grid - K[:2, 2]) / K[[0, 1], [0, 1]], coefficients)) * K[[0, 1], [0, 1]]
    map_u, map_v = (found + K[:2, 2]).T
    return map_u.reshape(height, width), map_v.reshape(height, width)


def mapped_forward(K, coefficients, image_size):
    return mapped(K, coefficients, image_size, distortion.undistort_points)


def pixels_bent(K, coefficients, image_size):
    """Leave K out: pixels go into the model as if they were tangents."""
    return mapped(np.eye(3), coefficients, image_size)


def only_put_on(K, coefficients, image_size):
    """Bend pixels as if they were tangents, and then put K on."""
    map_u, map_v = mapped(np.eye(3), coefficients, image_size)
    return map_u * K[0, 0] + K[0, 2], map_v * K[1, 1] + K[1, 2]


def not_bent(K, coefficients, image_size):
    return mapped(K, np.zeros(5), image_size)


def grid_exchanged(K, coefficients, image_size):
    """Let the grid run down the columns, and put the numbers back row by row."""
    map_u, map_v = mapped(K, coefficients, image_size)
    return map_u.T.reshape(map_u.shape), map_v.T.reshape(map_v.shape)


def grid_of_exchanged_sizes(K, coefficients, image_size):
    """Make the grid of a picture that is as wide as this one is high, in the right shape."""
    width, height = image_size
    map_u, map_v = mapped(K, coefficients, image_size[::-1])
    return map_u.reshape(height, width), map_v.reshape(height, width)


def pixels_from_the_centre_bent(K, coefficients, image_size):
    only_centre = np.array([[1, 0, K[0, 2]], [0, 1, K[1, 2]], [0, 0, 1]])
    return mapped(only_centre, coefficients, image_size)


def left_as_tangents(K, coefficients, image_size):
    map_u, map_v = mapped(K, coefficients, image_size)
    return (map_u - K[0, 2]) / K[0, 0], (map_v - K[1, 2]) / K[1, 1]


def centre_not_put_back(K, coefficients, image_size):
    map_u, map_v = mapped(K, coefficients, image_size)
    return map_u - K[0, 2], map_v - K[1, 2]


def rows_before_columns(K, coefficients, image_size):
    return mapped(K, coefficients, image_size)[::-1]


def width_before_height(K, coefficients, image_size):
    map_u, map_v = mapped(K, coefficients, image_size)
    return map_u.T, map_v.T


def filled_in_the_wrong_order(K, coefficients, image_size):
    map_u, map_v = mapped(K, coefficients, image_size)
    return map_u.reshape(map_u.shape[::-1]), map_v.reshape(map_v.shape[::-1])


def filled_and_turned(K, coefficients, image_size):
    map_u, map_v = mapped(K, coefficients, image_size)
    turned = map_u.shape[::-1]
    return map_u.reshape(turned).T, map_v.reshape(turned).T


def both_in_one_table(K, coefficients, image_size):
    return np.stack(mapped(K, coefficients, image_size), axis=-1)


def centre_exchanged(K, coefficients, image_size):
    K = np.array([[K[0, 0], 0, K[1, 2]], [0, K[1, 1], K[0, 2]], [0, 0, 1]])
    return mapped(K, coefficients, image_size)


def first_focal_length_for_both(K, coefficients, image_size):
    K = np.array([[K[0, 0], 0, K[0, 2]], [0, K[0, 0], K[1, 2]], [0, 0, 1]])
    return mapped(K, coefficients, image_size)


def centre_of_the_picture(K, coefficients, image_size):
    width, height = image_size
    K = np.array([[K[0, 0], 0, width / 2], [0, K[1, 1], height / 2], [0, 0, 1]])
    return mapped(K, coefficients, image_size)


def middle_of_the_pixels(K, coefficients, image_size):
    width, height = image_size
    K = np.array([[K[0, 0], 0, (width - 1) / 2], [0, K[1, 1], (height - 1) / 2], [0, 0, 1]])
    return mapped(K, coefficients, image_size)


def first_pixel_is_one(K, coefficients, image_size):
    return mapped(K, coefficients, image_size, first=1.0)


def first_pixel_is_half(K, coefficients, image_size):
    return mapped(K, coefficients, image_size, first=0.5)


def whole_pixels(K, coefficients, image_size):
    return tuple(np.rint(m) for m in mapped(K, coefficients, image_size))


def rounded_down(K, coefficients, image_size):
    return tuple(m.astype(int) for m in mapped(K, coefficients, image_size))


def displacements(K, coefficients, image_size):
    map_u, map_v = mapped(K, coefficients, image_size)
    return map_u - np.arange(map_u.shape[1]), map_v - np.arange(map_u.shape[0])[:, None]


def size_exchanged(K, coefficients, image_size):
    return mapped(K, coefficients, image_size[::-1])


def left_flat(K, coefficients, image_size):
    map_u, map_v = mapped(K, coefficients, image_size)
    return map_u.ravel(), map_v.ravel()


def centre_left_out(K, coefficients, image_size):
    return mapped(np.diag(np.diag(K)), coefficients, image_size)


def centre_not_taken_off(K, coefficients, image_size):
    width, height = image_size
    u, v = np.meshgrid(np.arange(width), np.arange(height))
    return looked_up(K, coefficients, u / K[0, 0], v / K[1, 1])


def stretched_to_the_width(K, coefficients, image_size):
    width, height = image_size
    u, v = np.meshgrid(np.linspace(0, width, width), np.linspace(0, height, height))
    return looked_up(K, coefficients, (u - K[0, 2]) / K[0, 0], (v - K[1, 2]) / K[1, 1])


def quotient_before_difference(K, coefficients, image_size):
    width, height = image_size
    u, v = np.meshgrid(np.arange(width), np.arange(height))
    return looked_up(K, coefficients, u - K[0, 2] / K[0, 0], v - K[1, 2] / K[1, 1])


def looked_up(K: Any, coefficients: Any, x: Any, y: Any) -> Any:
    """Return columns and rows of tangents after the lens."""
    found = distortion.distort(np.stack([x.ravel(), y.ravel()], axis=1), coefficients)
    map_u, map_v = (found * K[[0, 1], [0, 1]] + K[:2, 2]).T
    return map_u.reshape(x.shape), map_v.reshape(x.shape)


# --- straightness -----------------------------------------------------------------------------


def across(points: Any) -> Any:
    """Return the distances from the best line."""
    centred = points - points.mean(axis=0)
    return centred @ np.linalg.svd(centred)[2][1]


def above_the_line(points: Any) -> Any:
    x, y = points.T
    x, y = x - x.mean(), y - y.mean()
    return y - x * (x @ y) / (x @ x)


def vertical_distances(points: Any) -> Any:
    return float(np.sqrt(np.mean(above_the_line(points) ** 2)))


def line_of_vertical_distances(points):
    x, y = (points - points.mean(axis=0)).T
    return vertical_distances(points) / float(np.hypot(1, (x @ y) / (x @ x)))


def mean_distance(points):
    return float(np.abs(across(points)).mean())


def spread_of_y(points):
    return float(points[:, 1].std())


def spread_of_y_by_one_less(points):
    return float(points[:, 1].std(ddof=1))


def largest_distance(points):
    return float(np.abs(across(points)).max())


def root_forgotten(points):
    return float(np.mean(across(points) ** 2))


def mean_forgotten(points):
    return float(np.linalg.norm(across(points)))


def signed_mean(points):
    return float(across(points).mean())


def by_the_ends(points):
    (x0, y0), (x1, y1) = points[0], points[-1]
    normal = np.array([y0 - y1, x1 - x0]) / np.hypot(x1 - x0, y1 - y0)
    return float(np.sqrt(np.mean(((points - points[0]) @ normal) ** 2)))


def along_the_line(points):
    centred = points - points.mean(axis=0)
    return float(np.linalg.svd(centred)[1][0] / np.sqrt(len(points)))


def not_centred(points):
    return float(np.linalg.svd(points)[1][1] / np.sqrt(len(points)))


def by_freedom(points):
    return float(np.sqrt(np.sum(across(points) ** 2) / (len(points) - 2)))


def by_one_less(points):
    return float(np.sqrt(np.sum(across(points) ** 2) / (len(points) - 1)))


def from_side_to_side(points):
    return float(np.ptp(across(points)))


def centred_by_point(points):
    centred = points - points.mean(axis=1, keepdims=True)
    return float(np.linalg.svd(centred)[1][1] / np.sqrt(len(points)))


def measured_from_the_origin(points):
    direction = np.linalg.svd(points - points.mean(axis=0))[2][1]
    return float(np.sqrt(np.mean((points @ direction) ** 2)))


def one_mean_for_both(points):
    return float(np.linalg.svd(points - points.mean())[1][1] / np.sqrt(len(points)))


def divided_by_all_numbers(points):
    return float(np.linalg.norm(across(points)) / np.sqrt(points.size))


def divided_by_the_count(points):
    return float(np.linalg.norm(across(points)) / len(points))
