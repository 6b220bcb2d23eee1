"""Wrong answers to the exercises of chapter 11 on pixels on the ground, speed and pictures."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

# --- ground_sample_distance -------------------------------------------------------------------


def millimetres(H, f_mm, pitch_um):
    return H * pitch_um / f_mm


def centimetres(H, f_mm, pitch_um):
    return H * pitch_um / f_mm / 10


def focal_length_in_mm(H, f_mm, pitch_um):
    return H * pitch_um * 1e-6 / f_mm


def pitch_in_um(H, f_mm, pitch_um):
    return H * pitch_um / (f_mm * 1e-3)


def brackets_left_out(H, f_mm, pitch_um):
    return H * (pitch_um * 1e-6) / f_mm * 1e-3


def pitch_upside_down(H, f_mm, pitch_um):
    return H * f_mm * 1e-3 / (pitch_um * 1e-6)


def plain_pitch_upside_down(H, f_mm, pitch_um):
    return H * f_mm / pitch_um


def pitch_upside_down_by_1000(H, f_mm, pitch_um):
    return H * f_mm / pitch_um * 1e-3


def pixels_per_metre(H, f_mm, pitch_um):
    return f_mm * 1e3 / (H * pitch_um)


def height_below(H, f_mm, pitch_um):
    return f_mm * 1e-3 * pitch_um * 1e-6 / H


def height_below_in_mm(H, f_mm, pitch_um):
    return f_mm * pitch_um * 1e-3 / H


def smallest_object(H, f_mm, pitch_um):
    return 3 * H * pitch_um * 1e-3 / f_mm


def area_of_a_pixel(H, f_mm, pitch_um):
    return (H * pitch_um * 1e-3 / f_mm) ** 2


def height_left_out(H, f_mm, pitch_um):
    return pitch_um * 1e-3 / f_mm + 0 * H


def height_left_out_once(H, f_mm, pitch_um):
    return pitch_um * 1e-3 / f_mm


def focal_length_left_out(H, f_mm, pitch_um):
    return H * pitch_um * 1e-6


def mean_height(H, f_mm, pitch_um):
    return np.mean(H) * pitch_um * 1e-3 / f_mm


def rounded_to_centimetres(H, f_mm, pitch_um):
    return np.round(H * pitch_um * 1e-3 / f_mm, 2)


def rounded_to_millimetres(H, f_mm, pitch_um):
    return np.round(H * pitch_um * 1e-3 / f_mm, 3)


# --- max_speed --------------------------------------------------------------------------------


def faster_one(base, interval, gsd, exposure_time, blur):
    return np.maximum(base / interval, blur * gsd / exposure_time)


def in_time_only(base, interval, gsd, exposure_time, blur):
    return base / interval


def smear_only(base, interval, gsd, exposure_time, blur):
    return blur * gsd / exposure_time


def interval_multiplied(base, interval, gsd, exposure_time, blur):
    return np.minimum(base * interval, blur * gsd / exposure_time)


def interval_above(base, interval, gsd, exposure_time, blur):
    return np.minimum(interval / base, blur * gsd / exposure_time)


def exposure_multiplied(base, interval, gsd, exposure_time, blur):
    return np.minimum(base / interval, blur * gsd * exposure_time)


def exposure_above(base, interval, gsd, exposure_time, blur):
    return np.minimum(base / interval, exposure_time / (blur * gsd))


def one_whole_pixel(base, interval, gsd, exposure_time, blur):
    return np.minimum(base / interval, gsd / exposure_time)


def half_a_pixel(base, interval, gsd, exposure_time, blur):
    return np.minimum(base / interval, 0.5 * gsd / exposure_time)


def smear_in_pixels(base, interval, gsd, exposure_time, blur):
    return np.minimum(base / interval, blur / exposure_time)


def blur_below(base, interval, gsd, exposure_time, blur):
    return np.minimum(base / interval, gsd / (blur * exposure_time))


def pixel_below(base, interval, gsd, exposure_time, blur):
    return np.minimum(base / interval, blur / (gsd * exposure_time))


def smear_not_timed(base, interval, gsd, exposure_time, blur):
    return np.minimum(base / interval, blur * gsd)


def smear_until_the_next_picture(base, interval, gsd, exposure_time, blur):
    return np.minimum(base / interval, blur * gsd / interval)


def both_added(base, interval, gsd, exposure_time, blur):
    return base / interval + blur * gsd / exposure_time


def mean_of_both(base, interval, gsd, exposure_time, blur):
    return (base / interval + blur * gsd / exposure_time) / 2


def both_returned(base, interval, gsd, exposure_time, blur):
    return base / interval, blur * gsd / exposure_time


def kilometres_an_hour(base, interval, gsd, exposure_time, blur):
    return 3.6 * np.minimum(base / interval, blur * gsd / exposure_time)


def smallest_of_all(base, interval, gsd, exposure_time, blur):
    return np.min([base / interval, blur * gsd / exposure_time])


def python_s_min(base, interval, gsd, exposure_time, blur):
    return min(base / interval, blur * gsd / exposure_time)


def array_in_an_if(base, interval, gsd, exposure_time, blur):
    if base / interval < blur * gsd / exposure_time:
        return base / interval
    return blur * gsd / exposure_time


# --- photo_count ------------------------------------------------------------------------------


def up(number: Any) -> Any:
    return math.ceil(number)


def strips_for(width: Any, distance: Any, footprint_width: Any) -> Any:
    return max(up((width - footprint_width) / distance) + 1, 1)


def pictures_without_one(length, width, base, distance, footprint_width):
    return up(length / base), strips_for(width, distance, footprint_width)


def strips_without_one(length, width, base, distance, footprint_width):
    return up(length / base) + 1, max(up((width - footprint_width) / distance), 1)


def both_without_one(length, width, base, distance, footprint_width):
    return up(length / base), max(up((width - footprint_width) / distance), 1)


def rounded_down(length, width, base, distance, footprint_width):
    return int(length / base) + 1, max(int((width - footprint_width) / distance) + 1, 1)


def pictures_rounded_down(length, width, base, distance, footprint_width):
    return int(length / base) + 1, strips_for(width, distance, footprint_width)


def strips_rounded_down(length, width, base, distance, footprint_width):
    return up(length / base) + 1, max(math.floor((width - footprint_width) / distance) + 1, 1)


def rounded_to_the_nearest(length, width, base, distance, footprint_width):
    strips = max(round((width - footprint_width) / distance) + 1, 1)
    return round(length / base) + 1, strips


def not_rounded(length, width, base, distance, footprint_width):
    return length / base + 1, max((width - footprint_width) / distance + 1, 1)


def one_too_many(length, width, base, distance, footprint_width):
    strips = max(math.floor((width - footprint_width) / distance) + 2, 1)
    return int(length / base) + 2, strips


def pictures_one_too_many(length, width, base, distance, footprint_width):
    return int(length / base) + 2, strips_for(width, distance, footprint_width)


def footprint_forgotten(length, width, base, distance, footprint_width):
    return up(length / base) + 1, up(width / distance) + 1


def footprint_and_one_forgotten(length, width, base, distance, footprint_width):
    return up(length / base) + 1, up(width / distance)


def strips_side_by_side(length, width, base, distance, footprint_width):
    return up(length / base) + 1, up(width / footprint_width)


def strips_side_by_side_and_one(length, width, base, distance, footprint_width):
    return up(length / base) + 1, up(width / footprint_width) + 1


def half_a_footprint_at_each_end(length, width, base, distance, footprint_width):
    return up(length / base) + 1, max(up((width - footprint_width / 2) / distance) + 1, 1)


def no_strip_at_all(length, width, base, distance, footprint_width):
    return up(length / base) + 1, up((width - footprint_width) / distance) + 1


def no_strip_is_none(length, width, base, distance, footprint_width):
    return up(length / base) + 1, max(up((width - footprint_width) / distance) + 1, 0)


def all_together(length, width, base, distance, footprint_width):
    return (up(length / base) + 1) * strips_for(width, distance, footprint_width)


def sides_of_the_field(length, width, base, distance, footprint_width):
    return up(width / base) + 1, strips_for(length, distance, footprint_width)


def steps_exchanged(length, width, base, distance, footprint_width):
    return up(length / distance) + 1, strips_for(width, base, footprint_width)


def strips_first(length, width, base, distance, footprint_width):
    return strips_for(width, distance, footprint_width), up(length / base) + 1


def pictures_beyond_both_ends(length, width, base, distance, footprint_width):
    return up(length / base) + 3, strips_for(width, distance, footprint_width)


def footprint_taken_off_the_length(length, width, base, distance, footprint_width):
    pictures = up((length - footprint_width) / base) + 1
    return pictures, strips_for(width, distance, footprint_width)
