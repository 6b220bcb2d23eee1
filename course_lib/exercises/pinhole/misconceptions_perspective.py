"""Wrong answers to the exercises of chapter 01 on perspective, as students write them."""

from __future__ import annotations

import numpy as np

# --- project_pinhole --------------------------------------------------------------------------


def divides_by_focal_length(points, f, c):
    return np.where(points[..., 2:] > 0, points[..., :2] / f, np.nan) + c


def exchanges_f_and_Z(points, f, c):
    Z = np.where(points[..., 2:] > 0, points[..., 2:], np.nan)
    return Z * points[..., :2] / f + c


def principal_point_forgotten(points, f, c):
    Z = np.where(points[..., 2:] > 0, points[..., 2:], np.nan)
    return f * points[..., :2] / Z


def row_then_column(points, f, c):
    Z = np.where(points[..., 2:] > 0, points[..., 2:], np.nan)
    return (f * points[..., :2] / Z + c)[..., ::-1]


def image_plane_behind(points, f, c):
    Z = np.where(points[..., 2:] > 0, points[..., 2:], np.nan)
    return -f * points[..., :2] / Z + c


def distance_for_depth(points, f, c):
    distance = np.linalg.norm(points, axis=-1, keepdims=True)
    return f * points[..., :2] / np.where(points[..., 2:] > 0, distance, np.nan) + c


def mirrors_what_is_behind(points, f, c):
    return f * points[..., :2] / points[..., 2:] + c


def centre_added_first(points, f, c):
    Z = np.where(points[..., 2:] > 0, points[..., 2:], np.nan)
    return (points[..., :2] + c) * f / Z


def depth_without_sign(points, f, c):
    Z = np.abs(points[..., 2:])
    return f * points[..., :2] / np.where(Z > 0, Z, np.nan) + c


def zero_depth_is_in_front(points, f, c):
    Z = np.where(points[..., 2:] >= 0, points[..., 2:], np.nan)
    return f * points[..., :2] / Z + c


def both_focal_lengths_for_each(points, f, c):
    X, Y, Z = points.T
    Z = np.where(Z > 0, Z, np.nan)
    return np.stack([f * X / Z + c[0], f * Y / Z + c[1]], axis=-1)


def first_focal_length_for_both(points, f, c):
    Z = np.where(points[..., 2:] > 0, points[..., 2:], np.nan)
    return np.ravel(f)[0] * points[..., :2] / Z + c


def loop_over_one_point(points, f, c):
    fx, fy = np.broadcast_to(f, 2)
    pixels = []
    for X, Y, Z in points:
        seen = Z > 0
        pixels.append([fx * X / Z + c[0], fy * Y / Z + c[1]] if seen else [np.nan, np.nan])
    return np.array(pixels)


# --- vanishing_point --------------------------------------------------------------------------


def forward_only(direction, f, c):
    Z = np.where(direction[..., 2:] > 0, direction[..., 2:], np.nan)
    return f * direction[..., :2] / Z + c


def centre_forgotten(direction, f, c):
    Z = np.where(direction[..., 2:] != 0, direction[..., 2:], np.nan)
    return f * direction[..., :2] / Z


def unit_direction(direction, f, c):
    length = np.linalg.norm(direction, axis=-1, keepdims=True)
    return f * direction[..., :2] / length + c


def tangent_without_focal_length(direction, f, c):
    Z = np.where(direction[..., 2:] != 0, direction[..., 2:], np.nan)
    return direction[..., :2] / Z + c


def at_infinity(direction, f, c):
    return f * direction[..., :2] / direction[..., 2:] + c


def without_sign(direction, f, c):
    Z = np.abs(direction[..., 2:])
    return f * direction[..., :2] / np.where(Z > 0, Z, np.nan) + c


def one_direction_only(direction, f, c):
    if direction[2] == 0:
        return np.array([np.nan, np.nan])
    return f * direction[:2] / direction[2] + c


def both_lengths_for_each_pixel(direction, f, c):
    X, Y, Z = direction.T
    Z = np.where(Z != 0, Z, np.nan)
    return np.stack([f * X / Z + c[0], f * Y / Z + c[1]], axis=-1)


# --- dolly_zoom -------------------------------------------------------------------------------


def inverse_ratio(f, Z, Z_new):
    return f * Z / Z_new


def adds_the_way(f, Z, Z_new):
    return f + (Z_new - Z)


def ratio_squared(f, Z, Z_new):
    return f * (Z_new / Z) ** 2


def only_the_factor(f, Z, Z_new):
    return Z_new / Z


def times_the_distance(f, Z, Z_new):
    return f * Z_new


def only_the_change(f, Z, Z_new):
    return f * (Z_new - Z) / Z
