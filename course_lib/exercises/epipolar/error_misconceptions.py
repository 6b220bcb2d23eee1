"""Wrong answers to the exercises of chapter 08 on errors of pairs and the number of samples."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from course_lib.exercises.epipolar.keeping import kept
from course_lib.exercises.epipolar.line_misconceptions import homogeneous

# --- sampson_error ----------------------------------------------------------------------------


@kept
def parts(points1: Any, points2: Any, F: Any) -> Any:
    """Return x2ᵀ F x1, and the lines of both pictures."""
    x1, x2 = homogeneous(points1), homogeneous(points2)
    return (x2 * (x1 @ F.T)).sum(axis=1), x1 @ F.T, x2 @ F


def squares(lines: Any) -> Any:
    return lines[:, 0] ** 2 + lines[:, 1] ** 2


def squared(points1, points2, F):
    e, l2, l1 = parts(points1, points2, F)
    return e**2 / (squares(l2) + squares(l1))


def not_divided(points1, points2, F):
    return np.abs(parts(points1, points2, F)[0])


def not_divided_with_sign(points1, points2, F):
    return parts(points1, points2, F)[0]


def sign_kept(points1, points2, F):
    e, l2, l1 = parts(points1, points2, F)
    return e / np.sqrt(squares(l2) + squares(l1))


def picture_2_only(points1, points2, F):
    e, l2, _ = parts(points1, points2, F)
    return np.abs(e) / np.sqrt(squares(l2))


def picture_1_only(points1, points2, F):
    e, _, l1 = parts(points1, points2, F)
    return np.abs(e) / np.sqrt(squares(l1))


def both_distances_together(points1, points2, F):
    e, l2, l1 = parts(points1, points2, F)
    return np.sqrt(e**2 / squares(l2) + e**2 / squares(l1))


def both_distances_added(points1, points2, F):
    e, l2, l1 = parts(points1, points2, F)
    return np.abs(e) / np.sqrt(squares(l2)) + np.abs(e) / np.sqrt(squares(l1))


def both_distances_averaged(points1, points2, F):
    e, l2, l1 = parts(points1, points2, F)
    return np.abs(e) / np.sqrt(squares(l2)) / 2 + np.abs(e) / np.sqrt(squares(l1)) / 2


def symmetric_distance(points1, points2, F):
    e, l2, l1 = parts(points1, points2, F)
    return np.sqrt((e**2 / squares(l2) + e**2 / squares(l1)) / 2)


def scaled_lines(points1, points2, F):
    e, l2, _ = parts(points1, points2, F)
    return np.abs(e) / np.sqrt(squares(l2) * 2)


def scaled_lines_below_only(points1, points2, F):
    return np.abs(parts(points1, points2, F)[0]) / np.sqrt(2)


def lengths_added(points1, points2, F):
    e, l2, l1 = parts(points1, points2, F)
    return np.abs(e) / (np.sqrt(squares(l2)) + np.sqrt(squares(l1)))


def F_transposed(points1, points2, F):
    e, l2, l1 = parts(points1, points2, F.T)
    return np.abs(e) / np.sqrt(squares(l2) + squares(l1))


def second_line_by_F_too(points1, points2, F):
    e, l2, _ = parts(points1, points2, F)
    return np.abs(e) / np.sqrt(squares(l2) + squares(homogeneous(points2) @ F.T))


def first_line_by_the_transpose_too(points1, points2, F):
    e, _, l1 = parts(points1, points2, F)
    return np.abs(e) / np.sqrt(squares(homogeneous(points1) @ F) + squares(l1))


def all_three_numbers(points1, points2, F):
    e, l2, l1 = parts(points1, points2, F)
    return np.abs(e) / np.sqrt((l2**2).sum(axis=1) + (l1**2).sum(axis=1))


def root_left_out(points1, points2, F):
    e, l2, l1 = parts(points1, points2, F)
    return np.abs(e) / (squares(l2) + squares(l1))


def numbers_not_squared(points1, points2, F):
    e, l2, l1 = parts(points1, points2, F)
    return np.abs(e) / np.sqrt(np.abs(l2[:, :2].sum(axis=1) + l1[:, :2].sum(axis=1)))


def every_point_with_every_other(points1, points2, F):
    _, l2, l1 = parts(points1, points2, F)
    return np.abs(homogeneous(points2) @ l2.T) / np.sqrt(squares(l2) + squares(l1))


def in_a_column(points1, points2, F):
    e, l2, l1 = parts(points1, points2, F)
    return (np.abs(e) / np.sqrt(squares(l2) + squares(l1)))[:, None]


def added_up(points1, points2, F):
    e, l2, l1 = parts(points1, points2, F)
    return (np.abs(e) / np.sqrt(squares(l2) + squares(l1))).sum()


def averaged(points1, points2, F):
    e, l2, l1 = parts(points1, points2, F)
    return (np.abs(e) / np.sqrt(squares(l2) + squares(l1))).mean()


# --- ransac_iterations ------------------------------------------------------------------------


def exact(confidence: Any, all_right: Any) -> Any:
    return math.log(1 - confidence) / math.log(1 - all_right)


def not_rounded(confidence, size, wrong_share):
    return exact(confidence, (1 - wrong_share) ** size)


def rounded_down(confidence, size, wrong_share):
    return int(exact(confidence, (1 - wrong_share) ** size))


def rounded_to_the_nearest(confidence, size, wrong_share):
    return round(exact(confidence, (1 - wrong_share) ** size))


def all_wrong_for_all_right(confidence, size, wrong_share):
    return math.ceil(exact(confidence, wrong_share**size))


def not_all_wrong(confidence, size, wrong_share):
    return math.ceil(exact(confidence, 1 - wrong_share**size))


def one_pair_for_a_sample(confidence, size, wrong_share):
    return math.ceil(exact(confidence, 1 - wrong_share))


def divided_by_the_size(confidence, size, wrong_share):
    return math.ceil(exact(confidence, (1 - wrong_share) / size))


def times_the_size(confidence, size, wrong_share):
    return math.ceil(size * exact(confidence, 1 - wrong_share))


def confidence_for_its_rest(confidence, size, wrong_share):
    return math.ceil(exact(1 - confidence, (1 - wrong_share) ** size))


def logarithm_of_the_quotient(confidence, size, wrong_share):
    return math.ceil(math.log((1 - confidence) / (1 - (1 - wrong_share) ** size)))


def logarithm_of_the_quotient_not_rounded(confidence, size, wrong_share):
    return math.log((1 - confidence) / (1 - (1 - wrong_share) ** size))


def good_for_bad_samples(confidence, size, wrong_share):
    return math.ceil(exact(confidence, 1 - (1 - wrong_share) ** size))


def upside_down(confidence, size, wrong_share):
    return math.ceil(1 / exact(confidence, (1 - wrong_share) ** size))


def one_on_average(confidence, size, wrong_share):
    return math.ceil(1 / (1 - wrong_share) ** size)


def logarithms_left_out(confidence, size, wrong_share):
    return math.ceil((1 - confidence) / (1 - (1 - wrong_share) ** size))


def one_more(confidence, size, wrong_share):
    return math.ceil(exact(confidence, (1 - wrong_share) ** size)) + 1
