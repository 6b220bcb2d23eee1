"""Wrong answers to the exercises of chapter 10 on circles of pictures and on check points."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

# --- pictures_for_circle ----------------------------------------------------------------------


def rounded_down(step):
    return int(2 * np.pi / step + 1e-9)


def rounded_down_without_care(step):
    return math.floor(2 * np.pi / step)


def floor_division(step):
    return 2 * np.pi // step


def rounded_to_the_nearest(step):
    return round(2 * np.pi / step)


def not_rounded(step):
    return 2 * np.pi / step


def degrees_of_a_circle(step):
    return math.ceil(360 / step)


def degrees_for_radians(step):
    return math.ceil(360 / np.radians(step))


def half_a_circle(step):
    return math.ceil(np.pi / step - 1e-9)


def one_more(step):
    return math.ceil(2 * np.pi / step - 1e-9) + 1


def down_and_one_more(step):
    return int(2 * np.pi / step) + 1


def rounded_down_below_whole_numbers(step):
    return int(2 * np.pi / step - 1e-9)


def rounding_asks_for_one_more(step):
    return math.ceil(2 * np.pi / step)


def upside_down(step):
    return math.ceil(step / (2 * np.pi))


def share_of_a_circle(step):
    return step / (2 * np.pi)


# --- check_point_rmse -------------------------------------------------------------------------


def roots(squares: Any) -> Any:
    """Return the errors along the axes and in space, from their squares."""
    return np.sqrt(np.append(squares, np.sum(squares)))


def mean_of_sizes(estimated, surveyed):
    off = estimated - surveyed
    return np.append(np.abs(off).mean(axis=0), np.linalg.norm(off, axis=1).mean())


def mean_of_differences(estimated, surveyed):
    off = (estimated - surveyed).mean(axis=0)
    return np.append(off, np.linalg.norm(off))


def root_left_out(estimated, surveyed):
    squares = ((estimated - surveyed) ** 2).mean(axis=0)
    return np.append(squares, squares.sum())


def deviations_from_the_mean(estimated, surveyed):
    return roots((estimated - surveyed).var(axis=0))


def divided_by_one_less(estimated, surveyed):
    squares = ((estimated - surveyed) ** 2).sum(axis=0)
    return roots(squares / (len(estimated) - 1))


def sum_not_divided(estimated, surveyed):
    return roots(((estimated - surveyed) ** 2).sum(axis=0))


def divided_outside_of_the_root(estimated, surveyed):
    return roots(((estimated - surveyed) ** 2).sum(axis=0)) / len(estimated)


def over_all_coordinates(estimated, surveyed):
    squares = (estimated - surveyed) ** 2
    return np.sqrt(np.append(squares.mean(axis=0), squares.mean()))


def mean_of_the_axes(estimated, surveyed):
    axes = np.sqrt(((estimated - surveyed) ** 2).mean(axis=0))
    return np.append(axes, axes.mean())


def sum_of_the_axes(estimated, surveyed):
    axes = np.sqrt(((estimated - surveyed) ** 2).mean(axis=0))
    return np.append(axes, axes.sum())


def mean_distance(estimated, surveyed):
    off = estimated - surveyed
    axes = np.sqrt((off**2).mean(axis=0))
    return np.append(axes, np.linalg.norm(off, axis=1).mean())


def horizontal_for_space(estimated, surveyed):
    axes = np.sqrt(((estimated - surveyed) ** 2).mean(axis=0))
    return np.append(axes, np.hypot(axes[0], axes[1]))


def axes_only(estimated, surveyed):
    return np.sqrt(((estimated - surveyed) ** 2).mean(axis=0))


def space_only(estimated, surveyed):
    return np.sqrt(((estimated - surveyed) ** 2).sum(axis=1).mean())


def all_coordinates_only(estimated, surveyed):
    return np.sqrt(((estimated - surveyed) ** 2).mean())


def in_two_pieces(estimated, surveyed):
    squares = ((estimated - surveyed) ** 2).mean(axis=0)
    return np.sqrt(squares), np.sqrt(squares.sum())


def space_in_front(estimated, surveyed):
    return np.roll(roots(((estimated - surveyed) ** 2).mean(axis=0)), 1)


def axes_not_squared(estimated, surveyed):
    axes = np.sqrt(((estimated - surveyed) ** 2).mean(axis=0))
    return np.append(axes, np.sqrt(axes.sum()))


def deviations_and_all(estimated, surveyed):
    off = estimated - surveyed
    return np.append(off.std(axis=0), off.std())


def size_of_the_mean(estimated, surveyed):
    off = (estimated - surveyed).mean(axis=0)
    return np.append(np.abs(off), np.linalg.norm(off))


def mean_squared_afterwards(estimated, surveyed):
    off = estimated - surveyed
    return np.append(np.abs(off.mean(axis=0)), np.sqrt((off**2).sum(axis=1).mean()))


def rows_for_columns(estimated, surveyed):
    off = estimated - surveyed
    dx, dy, dz = off[0], off[1], off[2]
    squares = [(dx**2).mean(), (dy**2).mean(), (dz**2).mean(), (dx**2 + dy**2 + dz**2).mean()]
    return np.sqrt(squares)


def of_each_point_and_in_space(estimated, surveyed):
    squares = (estimated - surveyed) ** 2
    return np.sqrt(np.append(squares.mean(axis=1), squares.sum(axis=1).mean()))


def in_unequal_rows(estimated, surveyed):
    """Put three numbers and one into an array of two entries, which NumPy refuses."""
    squares = ((estimated - surveyed) ** 2).mean(axis=0)
    return np.array([np.sqrt(squares), np.sqrt(squares.sum())])


def of_each_point_and_all(estimated, surveyed):
    return roots(((estimated - surveyed) ** 2).mean(axis=1))


def of_each_point(estimated, surveyed):
    return np.sqrt(((estimated - surveyed) ** 2).mean(axis=1))


def distance_of_each_point(estimated, surveyed):
    return np.linalg.norm(estimated - surveyed, axis=1)


def largest_errors(estimated, surveyed):
    off = np.abs(estimated - surveyed)
    return np.append(off.max(axis=0), np.linalg.norm(off, axis=1).max())


def places_for_errors(estimated, surveyed):
    return roots((estimated**2).mean(axis=0))
