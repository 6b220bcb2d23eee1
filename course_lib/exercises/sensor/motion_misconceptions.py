"""Wrong answers to the exercises of chapter 04 on motion and on stripes of light."""

from __future__ import annotations

import numpy as np

# --- motion_blur_pixels -----------------------------------------------------------------------


def length_on_the_object(speed, exposure_time, pixel_size):
    return speed * exposure_time


def pixel_size_multiplied(speed, exposure_time, pixel_size):
    return speed * exposure_time * pixel_size


def divided_by_time(speed, exposure_time, pixel_size):
    return speed / exposure_time / pixel_size


def pixels_upside_down(speed, exposure_time, pixel_size):
    return pixel_size / (speed * exposure_time)


def only_half_of_it(speed, exposure_time, pixel_size):
    return speed * exposure_time / pixel_size / 2


def whole_pixels(speed, exposure_time, pixel_size):
    return np.round(speed * exposure_time / pixel_size)


def whole_pixels_up(speed, exposure_time, pixel_size):
    return np.ceil(speed * exposure_time / pixel_size)


def whole_pixels_down(speed, exposure_time, pixel_size):
    return np.floor(speed * exposure_time / pixel_size)


def units_converted(speed, exposure_time, pixel_size):
    return 1000 * speed * exposure_time / pixel_size


def units_converted_back(speed, exposure_time, pixel_size):
    return speed * exposure_time / pixel_size / 1000


# --- rolling_shutter_skew ---------------------------------------------------------------------


def one_row_only(speed, row_time, rows):
    return speed * row_time


def microseconds_converted(speed, row_time, rows):
    return speed * row_time * 1e-6 * rows


def divided_by_row_time(speed, row_time, rows):
    return speed / row_time * rows


def direction_lost(speed, row_time, rows):
    return np.abs(speed) * row_time * rows


def leans_backwards(speed, row_time, rows):
    return -speed * row_time * rows


def time_per_picture(speed, row_time, rows):
    return speed * row_time / rows


# --- stripe_height ----------------------------------------------------------------------------


def angle_from_the_table(shift, light_angle, camera_angle=0.0):
    return shift / (np.tan(np.pi / 2 - light_angle) + np.tan(camera_angle))


def sine_for_tangent(shift, light_angle, camera_angle=0.0):
    return shift / (np.sin(light_angle) + np.sin(camera_angle))


def camera_left_out(shift, light_angle, camera_angle=0.0):
    return shift / np.tan(light_angle)


def camera_on_the_light_side(shift, light_angle, camera_angle=0.0):
    return shift / (np.tan(light_angle) - np.tan(camera_angle))


def heights_added(shift, light_angle, camera_angle=0.0):
    return shift / np.tan(light_angle) + shift / np.tan(camera_angle)


def heights_added_for_slanted_cameras(shift, light_angle, camera_angle=0.0):
    height = shift / np.tan(light_angle)
    return height + shift / np.tan(camera_angle) if camera_angle else height


def tangent_of_the_sum(shift, light_angle, camera_angle=0.0):
    return shift / np.tan(light_angle + camera_angle)


def tangent_multiplied(shift, light_angle, camera_angle=0.0):
    return shift * (np.tan(light_angle) + np.tan(camera_angle))


def angle_in_degrees(shift, light_angle, camera_angle=0.0):
    return shift / (np.tan(np.degrees(light_angle)) + np.tan(np.degrees(camera_angle)))


def radians_of_radians(shift, light_angle, camera_angle=0.0):
    return shift / (np.tan(np.radians(light_angle)) + np.tan(np.radians(camera_angle)))
