"""Wrong answers to the exercise of chapter 11 on the aperture window."""

from __future__ import annotations

from typing import Any


def in_metres(f_mm: Any, spot_um: Any, wavelength_um: Any) -> Any:
    return f_mm / 1e3, spot_um / 1e6, wavelength_um / 1e6


def between(near: Any, far: Any) -> Any:
    return 2 * near * far / (near + far)


def least_for(f: Any, near: Any, far: Any, c: Any, s: Any) -> Any:
    """Return the larger of the f-numbers that both ends need."""
    return f**2 / (c * (s - f)) * max((s - near) / near, (far - s) / far)


def window(f_mm: Any, near: Any, far: Any, spot_um: Any, wavelength_um: Any) -> Any:
    """Return the right answer."""
    f, c, wavelength = in_metres(f_mm, spot_um, wavelength_um)
    s = between(near, far)
    m = f / (s - f)
    return least_for(f, near, far, c, s), c / (2.44 * wavelength * (1 + m))


def ends_exchanged(f_mm, near, far, spot_um, wavelength_um):
    least, most = window(f_mm, near, far, spot_um, wavelength_um)
    return -least, most


def near_end_over_far(f_mm, near, far, spot_um, wavelength_um):
    least, most = window(f_mm, near, far, spot_um, wavelength_um)
    return least * far / near, most


def far_end_over_near(f_mm, near, far, spot_um, wavelength_um):
    least, most = window(f_mm, near, far, spot_um, wavelength_um)
    return least * near / far, most


def focus_in_the_middle(f_mm, near, far, spot_um, wavelength_um):
    f, c, wavelength = in_metres(f_mm, spot_um, wavelength_um)
    s = (near + far) / 2
    most = c / (2.44 * wavelength * (1 + f / (s - f)))
    return f**2 * (far - s) / (c * far * (s - f)), most


def focus_in_the_middle_and_near_end(f_mm, near, far, spot_um, wavelength_um):
    f, c, wavelength = in_metres(f_mm, spot_um, wavelength_um)
    s = (near + far) / 2
    most = c / (2.44 * wavelength * (1 + f / (s - f)))
    return least_for(f, near, far, c, s), most


def focus_on_the_near_end(f_mm, near, far, spot_um, wavelength_um):
    f, c, wavelength = in_metres(f_mm, spot_um, wavelength_um)
    most = c / (2.44 * wavelength * (1 + f / (near - f)))
    return f**2 * (far - near) / (c * far * (near - f)), most


def two_forgotten(f_mm, near, far, spot_um, wavelength_um):
    f, c, wavelength = in_metres(f_mm, spot_um, wavelength_um)
    s = near * far / (near + far)
    most = c / (2.44 * wavelength * (1 + f / (s - f)))
    return f**2 * (far - s) / (c * far * (s - f)), most


def f_not_squared(f_mm, near, far, spot_um, wavelength_um):
    least, most = window(f_mm, near, far, spot_um, wavelength_um)
    return least / (f_mm / 1e3), most


def brackets_left_out(f_mm, near, far, spot_um, wavelength_um):
    f, c, wavelength = in_metres(f_mm, spot_um, wavelength_um)
    s = between(near, far)
    return f**2 * (far - s) / c * far * (s - f), c / (2.44 * wavelength * (1 + f / (s - f)))


def brackets_left_out_of_both(f_mm, near, far, spot_um, wavelength_um):
    f, c, wavelength = in_metres(f_mm, spot_um, wavelength_um)
    s = between(near, far)
    return f**2 * (far - s) / c * far * (s - f), c / 2.44 * wavelength * (1 + f / (s - f))


def brackets_left_out_of_the_most(f_mm, near, far, spot_um, wavelength_um):
    f, c, wavelength = in_metres(f_mm, spot_um, wavelength_um)
    s = between(near, far)
    return least_for(f, near, far, c, s), c / 2.44 * wavelength * (1 + f / (s - f))


def brackets_left_out_of_the_focus(f_mm, near, far, spot_um, wavelength_um):
    f, c, wavelength = in_metres(f_mm, spot_um, wavelength_um)
    s = 2 * near * far / near + far
    most = c / (2.44 * wavelength * (1 + f / (s - f)))
    return f**2 * (far - s) / (c * far * (s - f)), most


def always_green(f_mm, near, far, spot_um, wavelength_um):
    return window(f_mm, near, far, spot_um, 0.55)


def without_f_below(f_mm, near, far, spot_um, wavelength_um):
    f, c, _ = in_metres(f_mm, spot_um, wavelength_um)
    s = between(near, far)
    return f**2 * (far - s) / (c * far * s), window(f_mm, near, far, spot_um, wavelength_um)[1]


def f_added_below(f_mm, near, far, spot_um, wavelength_um):
    f, c, _ = in_metres(f_mm, spot_um, wavelength_um)
    s, most = between(near, far), window(f_mm, near, far, spot_um, wavelength_um)[1]
    return f**2 * (far - s) / (c * far * (s + f)), most


def whole_depth(f_mm, near, far, spot_um, wavelength_um):
    f, c, _ = in_metres(f_mm, spot_um, wavelength_um)
    s, most = between(near, far), window(f_mm, near, far, spot_um, wavelength_um)[1]
    return f**2 * (far - near) / (c * far * (s - f)), most


def mixed_units(f_mm, near, far, spot_um, wavelength_um):
    c, wavelength = spot_um, wavelength_um
    s = between(near, far)
    m = f_mm / (s - f_mm)
    return f_mm**2 * (far - s) / (c * far * (s - f_mm)), c / (2.44 * wavelength * (1 + m))


def distances_not_in_mm(f_mm, near, far, spot_um, wavelength_um):
    c, wavelength, s = spot_um / 1e3, wavelength_um / 1e3, between(near, far)
    m = f_mm / (s - f_mm)
    return f_mm**2 * (far - s) / (c * far * (s - f_mm)), c / (2.44 * wavelength * (1 + m))


def focal_length_not_in_metres(f_mm, near, far, spot_um, wavelength_um):
    return window(1e3 * f_mm, near, far, spot_um, wavelength_um)


def spot_in_mm(f_mm, near, far, spot_um, wavelength_um):
    least, most = window(f_mm, near, far, spot_um, wavelength_um)
    return least / 1e3, most


def spot_in_mm_for_both(f_mm, near, far, spot_um, wavelength_um):
    least, most = window(f_mm, near, far, spot_um, wavelength_um)
    return least / 1e3, most * 1e3


def spot_in_um(f_mm, near, far, spot_um, wavelength_um):
    least, most = window(f_mm, near, far, spot_um, wavelength_um)
    return least / 1e6, most


def wavelength_in_mm(f_mm, near, far, spot_um, wavelength_um):
    least, most = window(f_mm, near, far, spot_um, wavelength_um)
    return least, most / 1e3


def magnification_forgotten(f_mm, near, far, spot_um, wavelength_um):
    least, _ = window(f_mm, near, far, spot_um, wavelength_um)
    return least, spot_um / (2.44 * wavelength_um)


def magnification_over_s(f_mm, near, far, spot_um, wavelength_um):
    least, _ = window(f_mm, near, far, spot_um, wavelength_um)
    m = f_mm / 1e3 / between(near, far)
    return least, spot_um / (2.44 * wavelength_um * (1 + m))


def magnification_upside_down(f_mm, near, far, spot_um, wavelength_um):
    f, c, wavelength = in_metres(f_mm, spot_um, wavelength_um)
    s = between(near, far)
    return least_for(f, near, far, c, s), c / (2.44 * wavelength * (1 + (s - f) / f))


def magnification_multiplied(f_mm, near, far, spot_um, wavelength_um):
    f, c, wavelength = in_metres(f_mm, spot_um, wavelength_um)
    s = between(near, far)
    return least_for(f, near, far, c, s), c / (2.44 * wavelength) * (1 + f / (s - f))


def radius_of_the_disk(f_mm, near, far, spot_um, wavelength_um):
    least, most = window(f_mm, near, far, spot_um, wavelength_um)
    return least, 2 * most


def radius_of_the_spot(f_mm, near, far, spot_um, wavelength_um):
    least, most = window(f_mm, near, far, spot_um, wavelength_um)
    return 2 * least, most


def half_the_spot(f_mm, near, far, spot_um, wavelength_um):
    least, most = window(f_mm, near, far, spot_um, wavelength_um)
    return 2 * least, most / 2


def far_end_forgotten_below(f_mm, near, far, spot_um, wavelength_um):
    f, c, _ = in_metres(f_mm, spot_um, wavelength_um)
    s, most = between(near, far), window(f_mm, near, far, spot_um, wavelength_um)[1]
    return f**2 * (far - s) / (c * (s - f)), most


def factor_of_the_disk_forgotten(f_mm, near, far, spot_um, wavelength_um):
    least, most = window(f_mm, near, far, spot_um, wavelength_um)
    return least, 2.44 * most


def upside_down(f_mm, near, far, spot_um, wavelength_um):
    least, most = window(f_mm, near, far, spot_um, wavelength_um)
    return 1 / least, most


def diffraction_upside_down(f_mm, near, far, spot_um, wavelength_um):
    least, most = window(f_mm, near, far, spot_um, wavelength_um)
    return least, 1 / most


def most_first(f_mm, near, far, spot_um, wavelength_um):
    least, most = window(f_mm, near, far, spot_um, wavelength_um)
    return most, least


def in_order_of_size(f_mm, near, far, spot_um, wavelength_um):
    return tuple(sorted(window(f_mm, near, far, spot_um, wavelength_um)))


def refused(f_mm, near, far, spot_um, wavelength_um):
    least, most = window(f_mm, near, far, spot_um, wavelength_um)
    if least > most:
        raise ValueError("no aperture does both")
    return least, most


def nothing_where_closed(f_mm, near, far, spot_um, wavelength_um):
    least, most = window(f_mm, near, far, spot_um, wavelength_um)
    return (least, most) if least <= most else None


def not_above_the_most(f_mm, near, far, spot_um, wavelength_um):
    least, most = window(f_mm, near, far, spot_um, wavelength_um)
    return min(least, most), most


def yes_or_no(f_mm, near, far, spot_um, wavelength_um):
    least, most = window(f_mm, near, far, spot_um, wavelength_um)
    return bool(least <= most)


def width_of_the_window(f_mm, near, far, spot_um, wavelength_um):
    least, most = window(f_mm, near, far, spot_um, wavelength_um)
    return most - least


def with_the_focus(f_mm, near, far, spot_um, wavelength_um):
    return *window(f_mm, near, far, spot_um, wavelength_um), between(near, far)


def least_only(f_mm, near, far, spot_um, wavelength_um):
    return window(f_mm, near, far, spot_um, wavelength_um)[0]
