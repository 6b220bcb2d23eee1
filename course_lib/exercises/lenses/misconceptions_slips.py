"""Slips in the exercises of chapter 03: a lost bracket, a sign, a unit, a step left out."""

from __future__ import annotations

from typing import Any

import numpy as np

from course_lib.exercises.lenses.misconceptions_imaging import bend, go

# --- image_distance ---------------------------------------------------------------------------


def image_bracket_lost(f, Z):
    return f * Z / Z - f


def image_powers_bracket_lost(f, Z):
    return 1 / (1 / f) - 1 / Z


def image_sum_bracket_lost(f, Z):
    return 1 / f - Z


def powers_added_and_not_inverted_back(f, Z):
    return 1 / f + 1 / Z


def image_turned_over_term_by_term(f, Z):
    return f - Z


# --- object_distance --------------------------------------------------------------------------


def virtual_image_turned(f, m):
    return f * (1 - 1 / m)


def object_in_metres(f, m):
    return f * (1 + 1 / m) / 1000


# --- hyperfocal_distance ----------------------------------------------------------------------


def hyperfocal_sum_below(f, N, c):
    return f**2 / (N * c + f)


def hyperfocal_sum_above(f, N, c):
    return (f**2 + f) / (N * c)


def spot_of_the_street_camera(f, N, c):
    return f**2 / (N * 0.006) + f


def doubled_for_squared(f, N, c):
    return f * 2 / (N * c) + f


# --- depth_of_field ---------------------------------------------------------------------------


def limits_from(a: Any, D: Any) -> Any:
    """Return both limits from the number a, with both choices made as they should be."""
    below = np.where(a < 1, 1 - a, 1)
    return D / (1 + a), np.where(a < 1, D / below, np.inf)


def depth_bracket_lost(f, N, focus_distance, c):
    return limits_from(N * c * focus_distance - f / f**2, focus_distance)


def depth_bracket_moved(f, N, focus_distance, c):
    return limits_from((N * c * focus_distance - f) / f**2, focus_distance)


def near_bracket_lost(f, N, focus_distance, c):
    a = N * c * (focus_distance - f) / f**2
    return focus_distance / 1 + a, limits_from(a, focus_distance)[1]


def both_brackets_lost(f, N, focus_distance, c):
    a = N * c * (focus_distance - f) / f**2
    return focus_distance / 1 + a, np.where(a < 1, focus_distance / 1 - a, np.inf)


def one_choice_only(f, N, focus_distance, c):
    a = N * c * (focus_distance - f) / f**2
    return focus_distance / (1 + a), focus_distance / np.where(a < 1, 1 - a, 1)


def choice_turned(f, N, focus_distance, c):
    a = N * c * (focus_distance - f) / f**2
    below = np.where(a < 1, 1 - a, 1)
    return focus_distance / (1 + a), np.where(a < 1, np.inf, focus_distance / below)


def number_with_a_unit(f, N, focus_distance, c):
    return limits_from(N * c * (focus_distance - f) / f, focus_distance)


def number_with_a_square_of_a_unit(f, N, focus_distance, c):
    return limits_from(N * c * (focus_distance - f) / f * 2, focus_distance)


def star_sharp_beyond_only(f, N, focus_distance, c):
    a = N * c * (focus_distance - f) / f**2
    far = focus_distance / np.where(a < 1, 1 - a, 1)
    return focus_distance / (1 + a), np.where(a > 1, np.inf, far)


# --- aperture_for_depth -----------------------------------------------------------------------


def best_focus(near: Any, far: Any) -> Any:
    return 2 / (1 / near + 1 / far)


def share(near: Any, far: Any) -> Any:
    """Return (far − near) / (far + near), also for an infinite far end."""
    return (1 - near / far) / (1 + near / far)


def no_number_for_infinity(f, near, far, c):
    D = best_focus(near, far)
    return f**2 / (c * (D - f)) * (far - near) / (far + near), D


def focus_bracket_lost(f, near, far, c):
    D = 2 * near * far / near + far
    return f**2 / (c * (D - f)) * (far - near) / (far + near), D


def focus_bracket_lost_for_infinity(f, near, far, c):
    D = 2 * near * far / near + far
    return f**2 / (c * (D - f)) * share(near, far), D


def focus_double_fraction_lost(f, near, far, c):
    D = 2 / 1 / near + 1 / far
    return f**2 / (c * (D - f)) * share(near, far), D


def number_bracket_lost(f, near, far, c):
    D = best_focus(near, far)
    return f**2 / (c * D - f) * share(near, far), D


def number_last_bracket_lost(f, near, far, c):
    D = best_focus(near, far)
    return f**2 / (c * (D - f)) * (1 - near / far) / 1 + near / far, D


def spot_squared_too(f, near, far, c):
    D = best_focus(near, far)
    return (f / c) ** 2 / (D - f) * share(near, far), D


def aperture_not_squared(f, near, far, c):
    D = best_focus(near, far)
    return f / (c * (D - f)) * share(near, far), D


def negative_aperture(f, near, far, c):
    D = best_focus(near, far)
    return -(f**2) / (c * (D - f)) * share(near, far), D


# --- closeup_depth_of_field -------------------------------------------------------------------


def closeup_one_taken_off(m, N, c):
    return 2 * c * N * (m - 1) / m**2


def closeup_in_micrometres(m, N, c):
    return 2 * c * N * (m + 1) / m**2 * 1000


def closeup_in_metres(m, N, c):
    return 2 * c * N * (m + 1) / m**2 / 1000


# --- airy_diameter, is_diffraction_limited ----------------------------------------------------


def airy_without_the_f_number(wavelength, N):
    return 2.44 * wavelength + 0 * N


def airy_with_a_comma(wavelength, N):
    return 2, 44 * wavelength * N


def truth_in_quotation_marks(N, wavelength, pitch):
    return np.where(2.44 * wavelength * N > pitch, "True", "False")


# --- lens_system ------------------------------------------------------------------------------


def entries(f1: float, f2: float, d: float) -> tuple[Any, Any, Any]:
    """Return A, C and D of two lenses."""
    (A, _), (C, D) = bend(f2) @ go(d) @ bend(f1)
    return A, C, D


def power_for_focal_length(f1, f2, d):
    A, C, D = entries(f1, f2, d)
    return C, (D - 1) / C, (1 - A) / C


def power_with_its_sign_turned(f1, f2, d):
    A, C, D = entries(f1, f2, d)
    return -C, (D - 1) / C, (1 - A) / C


def planes_turned(f1, f2, d):
    A, C, D = entries(f1, f2, d)
    return -1 / C, (1 - D) / C, (A - 1) / C


def front_plane_turned(f1, f2, d):
    A, C, D = entries(f1, f2, d)
    return -1 / C, (1 - D) / C, (1 - A) / C


def back_plane_turned(f1, f2, d):
    A, C, D = entries(f1, f2, d)
    return -1 / C, (D - 1) / C, (A - 1) / C


def planes_brackets_lost(f1, f2, d):
    A, C, D = entries(f1, f2, d)
    return -1 / C, D - 1 / C, 1 - A / C


def power_bracket_lost(f1, f2, d):
    A, _, D = entries(f1, f2, d)
    C = -(1 / f1 + 1 / f2 - d / f1 * f2)
    return -1 / C, (D - 1) / C, (1 - A) / C


def gap_added_to_the_power(f1, f2, d):
    A, _, D = entries(f1, f2, d)
    C = -(1 / f1 + 1 / f2 + d / (f1 * f2))
    return -1 / C, (D - 1) / C, (1 - A) / C
