"""Wrong answers to the exercise of chapter 09 on the closest points of two rays."""

from __future__ import annotations

from typing import Any

import numpy as np


def solved(o1: Any, d1: Any, o2: Any, d2: Any) -> Any:
    """Return the right λ1, λ2 and μ."""
    (a, b, c), (x, y, z) = d1, d2
    normal = np.array(
        [b * z - c * y, c * x - a * z, a * y - b * x]
    )  # as np.cross, in a tenth of its time
    return np.linalg.solve(np.array([d1, -d2, normal]).T, o2 - o1)


def closest(o1: Any, d1: Any, o2: Any, d2: Any) -> Any:
    """Return the right points."""
    length1, length2, _ = solved(o1, d1, o2, d2)
    return o1 + length1 * d1, o2 + length2 * d2


def mu_for_the_second_length(origin1, direction1, origin2, direction2):
    length1, _, gap = solved(origin1, direction1, origin2, direction2)
    return origin1 + length1 * direction1, origin2 + gap * direction2


def sign_of_the_second_length(origin1, direction1, origin2, direction2):
    length1, length2, _ = solved(origin1, direction1, origin2, -direction2)
    return origin1 + length1 * direction1, origin2 + length2 * direction2


def difference_the_other_way(origin1, direction1, origin2, direction2):
    length1, length2, _ = -solved(origin1, direction1, origin2, direction2)
    return origin1 + length1 * direction1, origin2 + length2 * direction2


def other_difference_and_sign(origin1, direction1, origin2, direction2):
    length1, length2, _ = -solved(origin1, direction1, origin2, -direction2)
    return origin1 + length1 * direction1, origin2 + length2 * direction2


def first_origin_only(origin1, direction1, origin2, direction2):
    length1, length2, _ = solved(0, direction1, origin1, direction2)
    return origin1 + length1 * direction1, origin2 + length2 * direction2


def second_origin_only(origin1, direction1, origin2, direction2):
    length1, length2, _ = solved(0, direction1, origin2, direction2)
    return origin1 + length1 * direction1, origin2 + length2 * direction2


def star_for_matrix_product(origin1, direction1, origin2, direction2):
    A = np.column_stack([direction1, -direction2, np.cross(direction1, direction2)])
    length1, length2, _ = np.linalg.inv(A) * (origin2 - origin1)
    return origin1 + length1 * direction1, origin2 + length2 * direction2


def rows_for_columns(origin1, direction1, origin2, direction2):
    normal = np.cross(direction1, direction2)
    A = np.array([direction1, -direction2, normal])
    length1, length2, _ = np.linalg.solve(A, origin2 - origin1)
    return origin1 + length1 * direction1, origin2 + length2 * direction2


def rows_and_sign(origin1, direction1, origin2, direction2):
    normal = np.cross(direction1, direction2)
    A = np.array([direction1, direction2, normal])
    length1, length2, _ = np.linalg.solve(A, origin2 - origin1)
    return origin1 + length1 * direction1, origin2 + length2 * direction2


def sign_of_the_common_normal(origin1, direction1, origin2, direction2):
    length1, _, gap = solved(origin1, direction1, origin2, direction2)
    one = origin1 + length1 * direction1
    return one, one - gap * np.cross(direction1, direction2)


def unit_normal_taken(origin1, direction1, origin2, direction2):
    length1, _, gap = solved(origin1, direction1, origin2, direction2)
    one = origin1 + length1 * direction1
    normal = np.cross(direction1, direction2)
    return one, one + gap * normal / np.linalg.norm(normal)


def directions_taken_for_unit(origin1, direction1, origin2, direction2):
    between = origin2 - origin1
    cosine = direction1 @ direction2
    length1 = (between @ direction1 - between @ direction2 * cosine) / (1 - cosine**2)
    length2 = (between @ direction1 * cosine - between @ direction2) / (1 - cosine**2)
    return origin1 + length1 * direction1, origin2 + length2 * direction2


def made_unit_for_the_lengths_only(origin1, direction1, origin2, direction2):
    size1, size2 = np.linalg.norm(direction1), np.linalg.norm(direction2)
    length1, length2, _ = solved(origin1, direction1 / size1, origin2, direction2 / size2)
    return origin1 + length1 * direction1, origin2 + length2 * direction2


def middle_returned(origin1, direction1, origin2, direction2):
    one, other = closest(origin1, direction1, origin2, direction2)
    return (one + other) / 2


def lengths_returned(origin1, direction1, origin2, direction2):
    length1, length2, _ = solved(origin1, direction1, origin2, direction2)
    return length1, length2


def all_unknowns_returned(origin1, direction1, origin2, direction2):
    return solved(origin1, direction1, origin2, direction2)


def points_swapped(origin1, direction1, origin2, direction2):
    one, other = closest(origin1, direction1, origin2, direction2)
    return other, one


def lengths_swapped(origin1, direction1, origin2, direction2):
    length2, length1, _ = solved(origin1, direction1, origin2, direction2)
    return origin1 + length1 * direction1, origin2 + length2 * direction2


def origins_forgotten(origin1, direction1, origin2, direction2):
    length1, length2, _ = solved(origin1, direction1, origin2, direction2)
    return length1 * direction1, length2 * direction2


def both_from_the_first_origin(origin1, direction1, origin2, direction2):
    length1, length2, _ = solved(origin1, direction1, origin2, direction2)
    return origin1 + length1 * direction1, origin1 + length2 * direction2


def nearest_to_the_other_origin(origin1, direction1, origin2, direction2):
    length1 = (origin2 - origin1) @ direction1 / (direction1 @ direction1)
    length2 = (origin1 - origin2) @ direction2 / (direction2 @ direction2)
    return origin1 + length1 * direction1, origin2 + length2 * direction2


def products_for_the_normal(origin1, direction1, origin2, direction2):
    A = np.column_stack([direction1, -direction2, direction1 * direction2])
    length1, length2, _ = np.linalg.solve(A, origin2 - origin1)
    return origin1 + length1 * direction1, origin2 + length2 * direction2
