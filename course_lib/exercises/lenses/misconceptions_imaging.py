"""Wrong answers to the exercises of chapter 03 on imaging, as students write them."""

from __future__ import annotations

from typing import Any

import numpy as np

# --- image_distance ---------------------------------------------------------------------------


def powers_added(f, Z):
    return 1 / (1 / f + 1 / Z)


def not_inverted_back(f, Z):
    return 1 / f - 1 / Z


def in_front_of_the_lens(f, Z):
    return 1 / (1 / Z - 1 / f)


def always_at_the_focal_point(f, Z):
    return f + 0 / Z


def from_the_focal_point(f, Z):
    return f**2 / (Z - f)


def nothing_at_infinity(f, Z):
    return f * Z / (Z - f)


# --- object_distance --------------------------------------------------------------------------


def image_side(f, m):
    return f * (1 + m)


def one_forgotten(f, m):
    return f / m


def virtual_image(f, m):
    return f * (1 / m - 1)


def object_to_sensor(f, m):
    return f * (2 + m + 1 / m)


def magnification_alone(f, m):
    return f * m


def bracket_forgotten(f, m):
    return f * 1 + 1 / m


# --- f_number ---------------------------------------------------------------------------------


def f_number_inverted(f, d):
    return d / f


def radius_for_diameter(f, d):
    return f / (d / 2)


def ratio_squared(f, d):
    return (f / d) ** 2


def rounded_to_a_full_stop(f, d):
    return np.sqrt(2) ** np.round(2 * np.log2(f / d))


# --- lens_system ------------------------------------------------------------------------------


def bend(f: float) -> Any:
    return np.array([[1, 0], [-1 / f, 1]])


def go(d: float) -> Any:
    return np.array([[1, d], [0, 1]])


def read_off(system: Any) -> Any:
    (A, _), (C, D) = system
    return -1 / C, (D - 1) / C, (1 - A) / C


def light_from_behind(f1, f2, d):
    return read_off(bend(f1) @ go(d) @ bend(f2))


def gap_in_the_wrong_place(f1, f2, d):
    return read_off(go(d) @ bend(f2) @ bend(f1))


def element_by_element(f1, f2, d):
    return read_off(bend(f2) * go(d) * bend(f1))


def lenses_touching(f1, f2, d):
    return 1 / (1 / f1 + 1 / f2), 0.0, 0.0


def sign_of_the_power(f1, f2, d):
    f, front, back = read_off(bend(f2) @ go(d) @ bend(f1))
    return -f, front, back


def focal_points_for_planes(f1, f2, d):
    (A, _), (C, D) = bend(f2) @ go(d) @ bend(f1)
    return -1 / C, D / C, -A / C


def planes_exchanged(f1, f2, d):
    f, front, back = read_off(bend(f2) @ go(d) @ bend(f1))
    return f, back, front


def gap_left_out_of_the_power(f1, f2, d):
    _, front, back = read_off(bend(f2) @ go(d) @ bend(f1))
    return 1 / (1 / f1 + 1 / f2), front, back


def back_plane_from_the_first_lens(f1, f2, d):
    f, front, back = read_off(bend(f2) @ go(d) @ bend(f1))
    return f, front, d + back
