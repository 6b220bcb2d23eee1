"""Wrong answers to the exercise of chapter 05 on fisheye lenses."""

from __future__ import annotations

from typing import Any

import numpy as np

from course_lib.exercises.distortion.model_misconceptions import length, polynomial

#: Powers of the angle beside the first.
EVEN = (2, 4, 6, 8)


def on_sensor(plane: Any, K: Any) -> Any:
    return plane * [K[0, 0], K[1, 1]] + K[:2, 2]


def sideways(points: Any) -> Any:
    """Return how far points are from the axis."""
    return np.hypot(points[:, 0], points[:, 1])


def placed(points: Any, K: Any, way: Any) -> Any:
    """Return the pixels of points that are imaged at some distance from the centre."""
    return on_sensor(points[:, :2] * (way / sideways(points))[:, None], K)


def imaged(points: Any, K: Any, k: Any, distance: Any = np.asarray, powers: Any = EVEN) -> Any:
    """Return the image for a distance from the centre, given by the angle."""
    angle = np.arctan2(sideways(points), points[:, 2])
    return placed(points, K, distance(angle) * polynomial(angle, k, powers))


def pinhole_instead(points, K, k):
    return imaged(points, K, np.zeros(4), np.tan)


def tangent_bent(points, K, k):
    return imaged(points, K, k, np.tan)


def polynomial_of_the_tangent(points, K, k):
    r = length(points[:, :2] / points[:, 2:])
    return on_sensor(points[:, :2] / points[:, 2:] * polynomial(r, k, EVEN), K)


def polynomial_of_the_distance(points, K, k):
    rho = sideways(points)
    return placed(points, K, np.arctan2(rho, points[:, 2]) * polynomial(rho, k, EVEN))


def sine_of_the_angle(points, K, k):
    return imaged(points, K, k, np.sin)


def angle_in_degrees(points, K, k):
    angle = np.degrees(np.arctan2(sideways(points), points[:, 2]))
    return placed(points, K, angle * polynomial(angle, k, EVEN))


def nothing_behind(points, K, k):
    angle = np.arctan(sideways(points) / points[:, 2])
    return placed(points, K, angle * polynomial(angle, k, EVEN))


def each_axis_alone(points, K, k):
    angles = np.arctan2(points[:, :2], points[:, 2:])
    return on_sensor(angles * polynomial(np.abs(angles), k, EVEN), K)


def direction_not_unit(points, K, k):
    return on_sensor(sideways(points)[:, None] * imaged(points, np.eye(3), k), K)


def direction_from_tangents(points, K, k):
    slope = (sideways(points) / points[:, 2])[:, None]
    return on_sensor(slope * imaged(points, np.eye(3), k), K)


def coefficients_left_out(points, K, k):
    return imaged(points, K, np.zeros(4))


def all_powers_of_the_angle(points, K, k):
    return imaged(points, K, k, powers=(1, 2, 3, 4))


def powers_one_by_one(points, K, k):
    return imaged(points, K, k, powers=(2, 3, 4, 5))


def centre_left_out(points, K, k):
    return imaged(points, K, k) - K[:2, 2]


def one_focal_length(points, K, k):
    K = np.array([[K[0, 0], 0, K[0, 2]], [0, K[0, 0], K[1, 2]], [0, 0, 1]])
    return imaged(points, K, k)


def sides_exchanged_in_the_angle(points, K, k):
    angle = np.arctan2(points[:, 2], sideways(points))
    return placed(points, K, angle * polynomial(angle, k, EVEN))


def turn_about_the_axis(points, K, k):
    angle = np.arctan2(points[:, 1], points[:, 0])
    return placed(points, K, angle * polynomial(angle, k, EVEN))


def direction_in_space(points, K, k):
    share = sideways(points)[:, None] / length(points)
    return on_sensor(share * imaged(points, np.eye(3), k), K)


def distance_from_the_camera(points, K, k):
    far = length(points)[:, 0]
    angle = np.arctan2(far, points[:, 2])
    return on_sensor(points[:, :2] * (angle * polynomial(angle, k, EVEN) / far)[:, None], K)


def by_the_arcsine(points, K, k):
    angle = np.arcsin(sideways(points) / length(points)[:, 0])
    return placed(points, K, angle * polynomial(angle, k, EVEN))


def angle_left_out(points, K, k):
    return imaged(points, K, k, np.ones_like)


def left_in_focal_lengths(points, K, k):
    return imaged(points, np.eye(3), k)


def angle_counted_twice(points, K, k):
    return imaged(points, K, k, powers=(3, 5, 7, 9))


def root_left_out(points, K, k):
    angle = np.arctan2(sideways(points) ** 2, points[:, 2])
    return placed(points, K, angle * polynomial(angle, k, EVEN))


def root_left_out_in_the_direction(points, K, k):
    return on_sensor(imaged(points, np.eye(3), k) / sideways(points)[:, None], K)


def root_left_out_everywhere(points, K, k):
    square = sideways(points) ** 2
    angle = np.arctan2(square, points[:, 2])
    return on_sensor(points[:, :2] * (angle * polynomial(angle, k, EVEN) / square)[:, None], K)
