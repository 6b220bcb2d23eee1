"""Wrong answers to the exercise of chapter 09 on the midpoint of two rays."""

from __future__ import annotations

from typing import Any

import numpy as np

from course_lib import triangulation
from course_lib.exercises.triangulation.ray_misconceptions import closest


def rays(pixel1: Any, pixel2: Any, P1: Any, P2: Any) -> Any:
    """Return both centres and directions, right ones."""
    M1, M2 = np.linalg.inv(P1[:, :3]), np.linalg.inv(P2[:, :3])
    return [-M1 @ P1[:, 3], M1 @ np.append(pixel1, 1), -M2 @ P2[:, 3], M2 @ np.append(pixel2, 1)]


def middle(o1: Any, d1: Any, o2: Any, d2: Any) -> Any:
    one, other = closest(o1, d1, o2, d2)
    return (one + other) / 2


def M_not_inverted(pixel1, pixel2, P1, P2):
    o1, _, o2, _ = rays(pixel1, pixel2, P1, P2)
    return middle(o1, P1[:, :3] @ np.append(pixel1, 1), o2, P2[:, :3] @ np.append(pixel2, 1))


def pixel_for_the_direction(pixel1, pixel2, P1, P2):
    o1, _, o2, _ = rays(pixel1, pixel2, P1, P2)
    return middle(o1, np.append(pixel1, 1), o2, np.append(pixel2, 1))


def one_pixel_for_both(pixel1, pixel2, P1, P2):
    return middle(*rays(pixel1, pixel1, P1, P2))


def M_transposed(pixel1, pixel2, P1, P2):
    o1, _, o2, _ = rays(pixel1, pixel2, P1, P2)
    M1, M2 = np.linalg.inv(P1[:, :3]), np.linalg.inv(P2[:, :3])
    return middle(o1, np.append(pixel1, 1) @ M1, o2, np.append(pixel2, 1) @ M2)


def transpose_for_inverse(pixel1, pixel2, P1, P2):
    o1, _, o2, _ = rays(pixel1, pixel2, P1, P2)
    return middle(o1, np.append(pixel1, 1) @ P1[:, :3], o2, np.append(pixel2, 1) @ P2[:, :3])


def transpose_in_the_centre(pixel1, pixel2, P1, P2):
    _, d1, _, d2 = rays(pixel1, pixel2, P1, P2)
    return middle(-P1[:, 3] @ P1[:, :3], d1, -P2[:, 3] @ P2[:, :3], d2)


def transpose_in_both(pixel1, pixel2, P1, P2):
    d1, d2 = np.append(pixel1, 1) @ P1[:, :3], np.append(pixel2, 1) @ P2[:, :3]
    return middle(-P1[:, 3] @ P1[:, :3], d1, -P2[:, 3] @ P2[:, :3], d2)


def third_row_for_p(pixel1, pixel2, P1, P2):
    _, d1, _, d2 = rays(pixel1, pixel2, P1, P2)
    o1, o2 = (np.linalg.solve(P[:, :3], -P[2, :3]) for P in (P1, P2))
    return middle(o1, d1, o2, d2)


def one_in_front(pixel1, pixel2, P1, P2):
    o1, _, o2, _ = rays(pixel1, pixel2, P1, P2)
    d1 = np.linalg.solve(P1[:, :3], np.append(1, pixel1))
    return middle(o1, d1, o2, np.linalg.solve(P2[:, :3], np.append(1, pixel2)))


def arguments_out_of_order(pixel1, pixel2, P1, P2):
    o1, d1, o2, d2 = rays(pixel1, pixel2, P1, P2)
    return middle(o1, o2, d1, d2)


def star_in_the_direction(pixel1, pixel2, P1, P2):
    o1, _, o2, _ = rays(pixel1, pixel2, P1, P2)
    d1, d2 = (
        np.linalg.inv(P[:, :3]) * np.append(pixel, 1) for pixel, P in ((pixel1, P1), (pixel2, P2))
    )
    return sum(triangulation.closest_points_on_rays(o1, d1, o2, d2)) / 2


def third_number_zero(pixel1, pixel2, P1, P2):
    o1, _, o2, _ = rays(pixel1, pixel2, P1, P2)
    M1, M2 = np.linalg.inv(P1[:, :3]), np.linalg.inv(P2[:, :3])
    return middle(o1, M1[:, :2] @ pixel1, o2, M2[:, :2] @ pixel2)


def last_column_for_the_centre(pixel1, pixel2, P1, P2):
    _, d1, _, d2 = rays(pixel1, pixel2, P1, P2)
    return middle(P1[:, 3], d1, P2[:, 3], d2)


def minus_last_column(pixel1, pixel2, P1, P2):
    _, d1, _, d2 = rays(pixel1, pixel2, P1, P2)
    return middle(-P1[:, 3], d1, -P2[:, 3], d2)


def sign_of_the_centre(pixel1, pixel2, P1, P2):
    o1, d1, o2, d2 = rays(pixel1, pixel2, P1, P2)
    return middle(-o1, d1, -o2, d2)


def direction_taken_for_a_point(pixel1, pixel2, P1, P2):
    o1, d1, o2, d2 = rays(pixel1, pixel2, P1, P2)
    return middle(o1, d1 - o1, o2, d2 - o2)


def pixels_swapped(pixel1, pixel2, P1, P2):
    return middle(*rays(pixel2, pixel1, P1, P2))


def first_camera_for_both(pixel1, pixel2, P1, P2):
    o1, d1, o2, _ = rays(pixel1, pixel2, P1, P2)
    return middle(o1, d1, o2, np.linalg.inv(P1[:, :3]) @ np.append(pixel2, 1))


def point_on_the_first_ray(pixel1, pixel2, P1, P2):
    return closest(*rays(pixel1, pixel2, P1, P2))[0]


def point_on_the_second_ray(pixel1, pixel2, P1, P2):
    return closest(*rays(pixel1, pixel2, P1, P2))[1]


def half_of_the_difference(pixel1, pixel2, P1, P2):
    one, other = closest(*rays(pixel1, pixel2, P1, P2))
    return (one - other) / 2


def half_of_the_other_difference(pixel1, pixel2, P1, P2):
    one, other = closest(*rays(pixel1, pixel2, P1, P2))
    return (other - one) / 2


def sum_not_halved(pixel1, pixel2, P1, P2):
    one, other = closest(*rays(pixel1, pixel2, P1, P2))
    return one + other


def only_one_halved(pixel1, pixel2, P1, P2):
    one, other = closest(*rays(pixel1, pixel2, P1, P2))
    return one + other / 2


def both_points(pixel1, pixel2, P1, P2):
    return closest(*rays(pixel1, pixel2, P1, P2))


def mean_of_all_numbers(pixel1, pixel2, P1, P2):
    return np.mean(closest(*rays(pixel1, pixel2, P1, P2)))


def mean_of_each_point(pixel1, pixel2, P1, P2):
    return np.mean(closest(*rays(pixel1, pixel2, P1, P2)), axis=1)


def middle_of_the_centres(pixel1, pixel2, P1, P2):
    o1, _, o2, _ = rays(pixel1, pixel2, P1, P2)
    return (o1 + o2) / 2


def star_in_the_centre(pixel1, pixel2, P1, P2):
    _, d1, _, d2 = rays(pixel1, pixel2, P1, P2)
    o1, o2 = (-np.linalg.inv(P[:, :3]) * P[:, 3] for P in (P1, P2))
    return sum(triangulation.closest_points_on_rays(o1, d1, o2, d2)) / 2


def q_as_a_table(pixel1, pixel2, P1, P2):
    _, d1, _, d2 = rays(pixel1, pixel2, P1, P2)
    o1, o2 = (-np.linalg.inv(P[:, :3]) @ P[:, 3:] for P in (P1, P2))
    return sum(triangulation.closest_points_on_rays(o1, d1, o2, d2)) / 2
