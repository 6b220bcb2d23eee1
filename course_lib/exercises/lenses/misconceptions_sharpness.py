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


def spot_above_the_bar(f, N, c):
    return f**2 / N * c + f


def focal_length_taken_off(f, N, c):
    return f**2 / (N * c) - f


def answer_in_metres(f, N, c):
    return (f**2 / (N * c) + f) / 1000


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


def divides_before_it_chooses(f, N, focus_distance, c):
    a = N * c * (focus_distance - f) / f**2
    return focus_distance / (1 + a), np.where(a < 1, focus_distance / (1 - a), np.inf)


def sign_taken_off(f, N, focus_distance, c):
    a = N * c * (focus_distance - f) / f**2
    return focus_distance / (1 + a), abs(focus_distance / (1 - a))


def handbook_with_the_exact_hyperfocal(f, N, focus_distance, c):
    H, s = f**2 / (N * c) + f, focus_distance
    return H * s / (H + s), np.where(s < H, H * s / np.where(s < H, H - s, 1), np.inf)


def handbook_with_half_of_the_focal_lengths(f, N, focus_distance, c):
    H, s = f**2 / (N * c) + f, focus_distance
    beyond = H - (s - f)
    return H * s / (H + (s - f)), np.where(s < H, H * s / np.where(s < H, beyond, 1), np.inf)


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


def ratio(near: Any, far: Any) -> Any:
    """Return (far − near) / (far + near), also for an infinite far end."""
    return (1 - near / far) / (1 + near / far)


def halfway_in_the_box(f, near, far, c):
    s = (near + far) / 2
    return f**2 / (c * (s - f)) * (far - near) / (far + near), s


def multiplied_by_the_way_to_the_focus(f, near, far, c):
    s = 2 / (1 / near + 1 / far)
    return f**2 / c * (s - f) * ratio(near, far), s


def two_lost(f, near, far, c):
    s = 1 / (1 / near + 1 / far)
    return f**2 / (c * (s - f)) * ratio(near, far), s


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


def star_for_a_power(m, N, c):
    return 2 * c * N * (m + 1) / m * 2


def closeup_bracket_forgotten(m, N, c):
    return 2 * c * N * m + 1 / m**2


# --- airy_diameter ----------------------------------------------------------------------------


def airy_radius(wavelength, N):
    return 1.22 * wavelength * N


def airy_without_its_factor(wavelength, N):
    return wavelength * N


def airy_divided(wavelength, N):
    return 2.44 * wavelength / N


def wavelength_in_nanometres(wavelength, N):
    return 2.44 * (wavelength / 1e6) * N


def airy_area(wavelength, N):
    return np.pi / 4 * (2.44 * wavelength * N) ** 2


def airy_in_a_thousandth(wavelength, N):
    return 2.44 * wavelength * N / 1000


def always_green(wavelength, N):
    return 2.44 * 0.00055 * N


def always_green_in_micrometres(wavelength, N):
    return 2.44 * 0.55 * N


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


def pitch_times_a_thousand(N, wavelength, pitch):
    return 2.44 * wavelength * N > pitch * 1000


def pitch_by_a_thousand(N, wavelength, pitch):
    return 2.44 * wavelength * N > pitch / 1000
