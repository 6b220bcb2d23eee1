"""Wrong answers to the exercise of chapter 09 on rays and a plane."""

from __future__ import annotations

from typing import Any

import numpy as np


def lengths_to(origin: Any, directions: Any, plane: Any) -> Any:
    return -(plane[:3] @ origin + plane[3]) / (directions @ plane[:3])


def in_front(origin: Any, directions: Any, lengths: Any) -> Any:
    points = origin + lengths[:, None] * directions
    points[lengths < 0] = np.nan
    return points


def sign_of_the_length(origin, directions, plane):
    return in_front(origin, directions, -lengths_to(origin, directions, plane))


def sign_without_nan(origin, directions, plane):
    return origin - lengths_to(origin, directions, plane)[:, None] * directions


def sign_of_d(origin, directions, plane):
    return in_front(origin, directions, lengths_to(origin, directions, plane * [1, 1, 1, -1]))


def sign_of_d_without_nan(origin, directions, plane):
    turned = plane * [1, 1, 1, -1]
    return origin + lengths_to(origin, directions, turned)[:, None] * directions


def sign_of_the_origin(origin, directions, plane):
    lengths = (plane[:3] @ origin - plane[3]) / (directions @ plane[:3])
    return in_front(origin, directions, lengths)


def sign_of_the_origin_without_nan(origin, directions, plane):
    lengths = (plane[:3] @ origin - plane[3]) / (directions @ plane[:3])
    return origin + lengths[:, None] * directions


def d_left_out(origin, directions, plane):
    return in_front(origin, directions, lengths_to(origin, directions, plane * [1, 1, 1, 0]))


def d_left_out_without_nan(origin, directions, plane):
    turned = plane * [1, 1, 1, 0]
    return origin + lengths_to(origin, directions, turned)[:, None] * directions


def begun_at_zero(origin, directions, plane):
    return in_front(np.zeros(3), directions, lengths_to(np.zeros(3), directions, plane))


def begun_at_zero_without_nan(origin, directions, plane):
    return lengths_to(np.zeros(3), directions, plane)[:, None] * directions


def length_from_zero(origin, directions, plane):
    return in_front(origin, directions, lengths_to(np.zeros(3), directions, plane))


def length_from_zero_without_nan(origin, directions, plane):
    return origin + lengths_to(np.zeros(3), directions, plane)[:, None] * directions


def origin_not_added(origin, directions, plane):
    return in_front(np.zeros(3), directions, lengths_to(origin, directions, plane))


def origin_not_added_without_nan(origin, directions, plane):
    return lengths_to(origin, directions, plane)[:, None] * directions


def behind_let_pass(origin, directions, plane):
    return origin + lengths_to(origin, directions, plane)[:, None] * directions


def sign_of_the_length_lost(origin, directions, plane):
    return origin + np.abs(lengths_to(origin, directions, plane))[:, None] * directions


def rows_left_out(origin, directions, plane):
    points = in_front(origin, directions, lengths_to(origin, directions, plane))
    return points[~np.isnan(points[:, 0])]


def zeros_for_nan(origin, directions, plane):
    return np.nan_to_num(in_front(origin, directions, lengths_to(origin, directions, plane)))


def nan_for_those_in_front(origin, directions, plane):
    lengths = lengths_to(origin, directions, plane)
    points = origin + lengths[:, None] * directions
    points[lengths > 0] = np.nan
    return points


def sign_of_the_slope(origin, directions, plane):
    points = origin + lengths_to(origin, directions, plane)[:, None] * directions
    points[directions @ plane[:3] < 0] = np.nan
    return points


def other_sign_of_the_slope(origin, directions, plane):
    points = origin + lengths_to(origin, directions, plane)[:, None] * directions
    points[directions @ plane[:3] > 0] = np.nan
    return points


def a_length_for_each_axis(origin, directions, plane):
    lengths = -(plane[:3] * origin + plane[3]) / (directions * plane[:3])
    return origin + lengths * directions


def summed_over_the_rays(origin, directions, plane):
    lengths = -(plane[:3] @ origin + plane[3]) / (directions * plane[:3]).sum(axis=0)
    return origin + lengths * directions


def first_ray_only(origin, directions, plane):
    return origin + lengths_to(origin, directions, plane)[0] * directions[0]


def shortened_for_the_length_only(origin, directions, plane):
    short = directions / np.linalg.norm(directions, axis=1, keepdims=True)
    return in_front(origin, directions, lengths_to(origin, short, plane))


def nan_in_one_column(origin, directions, plane):
    lengths = lengths_to(origin, directions, plane)
    points = origin + lengths[:, None] * directions
    points[lengths < 0, 0] = np.nan
    return points


def nan_for_all_rays(origin, directions, plane):
    lengths = lengths_to(origin, directions, plane)
    points = origin + lengths[:, None] * directions
    return points * np.nan if (lengths < 0).any() else points


def lengths_only(origin, directions, plane):
    return lengths_to(origin, directions, plane)


def lengths_not_in_a_column(origin, directions, plane):
    return origin + lengths_to(origin, directions, plane) * directions


def unit_normal_but_old_d(origin, directions, plane):
    scaled = np.append(plane[:3] / np.linalg.norm(plane[:3]), plane[3])
    return in_front(origin, directions, lengths_to(origin, directions, scaled))


def unit_normal_without_nan(origin, directions, plane):
    scaled = np.append(plane[:3] / np.linalg.norm(plane[:3]), plane[3])
    return origin + lengths_to(origin, directions, scaled)[:, None] * directions


def not_divided_by_the_slope(origin, directions, plane):
    lengths = np.full(len(directions), -(plane[:3] @ origin + plane[3]))
    return in_front(origin, directions, lengths)


def not_divided_without_nan(origin, directions, plane):
    return origin - (plane[:3] @ origin + plane[3]) * directions


def star_in_the_slope(origin, directions, plane):
    lengths = -(plane[:3] @ origin + plane[3]) / (directions * plane[:3])
    return origin + lengths * directions


def star_in_the_origins_place(origin, directions, plane):
    lengths = -(plane[:3] * origin + plane[3]) / (directions @ plane[:3])
    return origin + lengths[:, None] * directions


def one_nan_for_all(origin, directions, plane):
    lengths = lengths_to(origin, directions, plane)
    return np.nan if (lengths < 0).any() else origin + lengths[:, None] * directions


def nan_for_negative_numbers(origin, directions, plane):
    points = origin + lengths_to(origin, directions, plane)[:, None] * directions
    points[points < 0] = np.nan
    return points


def camera_for_nan(origin, directions, plane):
    lengths = np.maximum(lengths_to(origin, directions, plane), 0)
    return origin + lengths[:, None] * directions
