"""Wrong answers to the exercises of chapter 03 on sharpness, as students write them."""

from __future__ import annotations

from typing import Any

import numpy as np

# --- hyperfocal_distance ----------------------------------------------------------------------


def focal_length_neglected(f, N, c):
    return f**2 / (N * c)


def focal_length_not_squared(f, N, c):
    return f / (N * c) + f


def radius_of_the_spot(f, N, c):
    return f**2 / (N * 2 * c) + f


def spot_in_micrometres(f, N, c):
    return f**2 / (N * c / 1000) + f


def half_the_way(f, N, c):
    return (f**2 / (N * c) + f) / 2


def diameter_for_f_number(f, N, c):
    return f**2 * N / c + f


# --- depth_of_field ---------------------------------------------------------------------------


def limits(f: Any, N: Any, s: Any, c: Any) -> Any:
    H = f**2 / (N * c) + f
    near = (H - f) * s / (H + s - 2 * f)
    far = np.where(s < H, (H - f) * s / np.where(s < H, H - s, 1), np.inf)
    return near, far


def far_limit_behind_the_camera(f, N, focus_distance, c):
    H, s = f**2 / (N * c) + f, focus_distance
    return (H - f) * s / (H + s - 2 * f), (H - f) * s / (H - s)


def focal_length_small_enough(f, N, focus_distance, c):
    H, s = f**2 / (N * c), focus_distance
    return H * s / (H + s), np.where(s < H, H * s / np.where(s < H, H - s, 1), np.inf)


def far_before_near(f, N, focus_distance, c):
    near, far = limits(f, N, focus_distance, c)
    return far, near


def twice_the_spot(f, N, focus_distance, c):
    return limits(f, N, focus_distance, 2 * c)


def same_on_both_sides(f, N, focus_distance, c):
    near, _ = limits(f, N, focus_distance, c)
    return near, 2 * focus_distance - near


def measured_from_the_focus(f, N, focus_distance, c):
    near, far = limits(f, N, focus_distance, c)
    return focus_distance - near, far - focus_distance


def decides_once(f, N, focus_distance, c):
    H, s = f**2 / (N * c) + f, focus_distance
    far = (H - f) * s / (H - s) if s < H else np.inf
    return (H - f) * s / (H + s - 2 * f), far


# --- aperture_for_depth -----------------------------------------------------------------------


def needed(f: Any, limit: Any, s: Any, c: Any) -> Any:
    return f**2 * np.abs(1 / limit - 1 / s) / (c * (1 - f / s))


def halfway(f, near, far, c):
    s = (near + far) / 2
    return np.maximum(needed(f, near, s, c), needed(f, far, s, c)), s


def halfway_and_only_far(f, near, far, c):
    s = (near + far) / 2
    return needed(f, far, s, c), s


def focused_on_the_far_end(f, near, far, c):
    return needed(f, near, far, c), far


def focal_length_not_taken_off(f, near, far, c):
    s = 2 / (1 / near + 1 / far)
    return f**2 * (1 / near - 1 / s) / c, s


def spot_as_a_radius(f, near, far, c):
    s = 2 / (1 / near + 1 / far)
    return needed(f, near, s, 2 * c), s


def focus_before_f_number(f, near, far, c):
    s = 2 / (1 / near + 1 / far)
    return s, needed(f, near, s, c)


def no_focus_for_infinity(f, near, far, c):
    s = 2 * near * far / (near + far)
    return f**2 * (s - near) / (c * near * (s - f)), s


# --- closeup_depth_of_field -------------------------------------------------------------------


def one_side_only(m, N, c):
    return c * N * (m + 1) / m**2


def small_magnification(m, N, c):
    return 2 * c * N / m**2


def magnification_not_squared(m, N, c):
    return 2 * c * N * (m + 1) / m


def magnification_upside_down(m, N, c):
    return 2 * c * N * (1 / m + 1) * m**2


def on_the_sensor_side(m, N, c):
    return 2 * c * N * (m + 1)


# --- airy_diameter ----------------------------------------------------------------------------


def airy_radius(wavelength, f_number):
    return 1.22 * wavelength * f_number


def airy_without_its_factor(wavelength, f_number):
    return wavelength * f_number


def airy_divided(wavelength, f_number):
    return 2.44 * wavelength / f_number


def wavelength_in_nanometres(wavelength, f_number):
    return 2.44 * (wavelength / 1e6) * f_number


def airy_area(wavelength, f_number):
    return np.pi / 4 * (2.44 * wavelength * f_number) ** 2


# --- is_diffraction_limited -------------------------------------------------------------------


def pixel_wider_than_disk(N, wavelength, pitch):
    return 2.44 * wavelength * N < pitch


def radius_against_pixel(N, wavelength, pitch):
    return 1.22 * wavelength * N > pitch


def wavelengths_for_the_disk(N, wavelength, pitch):
    return wavelength * N > pitch


def disk_against_diagonal(N, wavelength, pitch):
    return 2.44 * wavelength * N > pitch * np.sqrt(2)


def how_many_pixels(N, wavelength, pitch):
    return 2.44 * wavelength * N / pitch
