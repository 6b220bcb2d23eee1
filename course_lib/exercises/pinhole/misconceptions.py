"""Wrong answers to the exercises of chapter 01, as students write them."""

from __future__ import annotations

import numpy as np

# --- pixel_focal_length -----------------------------------------------------------------------


def pixel_upside_down(f, sensor_size, image_size):
    return f * np.array(sensor_size) / np.array(image_size)


def width_for_both_axes(f, sensor_size, image_size):
    return np.array([f, f]) * image_size[0] / sensor_size[0]


def height_first(f, sensor_size, image_size):
    return (f * np.array(image_size) / np.array(sensor_size))[::-1]


def crosses_the_sizes(f, sensor_size, image_size):
    return f * np.array(image_size)[::-1] / np.array(sensor_size)


def pixels_per_millimetre(f, sensor_size, image_size):
    return np.array(image_size) / np.array(sensor_size)


# --- field_of_view ----------------------------------------------------------------------------


def half_angle(f, sensor_size):
    width, height = sensor_size
    return np.arctan(np.array([width, height, np.hypot(width, height)]) / (2 * f))


def in_degrees(f, sensor_size):
    width, height = sensor_size
    return np.degrees(2 * np.arctan(np.array([width, height, np.hypot(width, height)]) / (2 * f)))


def whole_width(f, sensor_size):
    width, height = sensor_size
    return 2 * np.arctan(np.array([width, height, np.hypot(width, height)]) / f)


def small_angle(f, sensor_size):
    width, height = sensor_size
    return np.array([width, height, np.hypot(width, height)]) / f


def width_for_height(f, sensor_size):
    width, height = sensor_size
    return 2 * np.arctan(np.array([width, width, np.hypot(width, height)]) / (2 * f))


def triangle_upside_down(f, sensor_size):
    width, height = sensor_size
    return 2 * np.arctan(2 * f / np.array([width, height, np.hypot(width, height)]))


def brackets_forgotten(f, sensor_size):
    width, height = sensor_size
    return 2 * np.arctan(np.array([width, height, np.hypot(width, height)]) / 2 * f)


def tangent_for_arctangent(f, sensor_size):
    width, height = sensor_size
    return 2 * np.tan(np.array([width, height, np.hypot(width, height)]) / (2 * f))


def angles_added(f, sensor_size):
    a, b = 2 * np.arctan(np.array(sensor_size) / (2 * f))
    return np.array([a, b, a + b])


def angles_squared_and_added(f, sensor_size):
    a, b = 2 * np.arctan(np.array(sensor_size) / (2 * f))
    return np.array([a, b, np.hypot(a, b)])


def sides_added(f, sensor_size):
    width, height = sensor_size
    return 2 * np.arctan(np.array([width, height, width + height]) / (2 * f))


# --- equivalent_focal_length ------------------------------------------------------------------


def crop_by_width(f, sensor_size):
    return f * 36 / sensor_size[0]


def crop_by_height(f, sensor_size):
    return f * 24 / sensor_size[1]


def crop_upside_down(f, sensor_size):
    return f * np.hypot(*sensor_size) / np.hypot(36, 24)


def crop_by_area(f, sensor_size):
    return f * 36 * 24 / (sensor_size[0] * sensor_size[1])


def only_the_crop_factor(f, sensor_size):
    return np.hypot(36, 24) / np.hypot(*sensor_size)


def crop_by_root_of_area(f, sensor_size):
    return f * np.sqrt(36 * 24 / (sensor_size[0] * sensor_size[1]))


def always_twice(f, sensor_size):
    return f * 2


# --- first_guess_intrinsics -------------------------------------------------------------------


def half_the_size(f, sensor_size, image_size):
    fx, fy = f * np.array(image_size) / np.array(sensor_size)
    return np.array([[fx, 0, image_size[0] / 2], [0, fy, image_size[1] / 2], [0, 0, 1]])


def millimetres_in_K(f, sensor_size, image_size):
    cx, cy = (np.array(image_size) - 1) / 2
    return np.array([[f, 0, cx], [0, f, cy], [0, 0, 1]])


def no_principal_point(f, sensor_size, image_size):
    fx, fy = f * np.array(image_size) / np.array(sensor_size)
    return np.array([[fx, 0, 0], [0, fy, 0], [0, 0, 1]])


def centre_rows_first(f, sensor_size, image_size):
    fx, fy = f * np.array(image_size) / np.array(sensor_size)
    cx, cy = (np.array(image_size) - 1) / 2
    return np.array([[fx, 0, cy], [0, fy, cx], [0, 0, 1]])


def transposed(f, sensor_size, image_size):
    fx, fy = f * np.array(image_size) / np.array(sensor_size)
    cx, cy = (np.array(image_size) - 1) / 2
    return np.array([[fx, 0, 0], [0, fy, 0], [cx, cy, 1]])


def fx_for_both_axes(f, sensor_size, image_size):
    fx, _ = f * np.array(image_size) / np.array(sensor_size)
    cx, cy = (np.array(image_size) - 1) / 2
    return np.array([[fx, 0, cx], [0, fx, cy], [0, 0, 1]])


def middle_rounded_down(f, sensor_size, image_size):
    fx, fy = f * np.array(image_size) / np.array(sensor_size)
    cx, cy = (np.array(image_size) - 1) // 2
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])


def last_one_forgotten(f, sensor_size, image_size):
    fx, fy = f * np.array(image_size) / np.array(sensor_size)
    cx, cy = (np.array(image_size) - 1) / 2
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 0]])


# --- best_pinhole_diameter --------------------------------------------------------------------


def radius_of_airy_disk(image_distance, wavelength):
    return np.sqrt(1.22 * wavelength * image_distance)


def not_square_rooted(image_distance, wavelength):
    return 2.44 * wavelength * image_distance


def size_of_the_spot(image_distance, wavelength):
    return 2 * np.sqrt(2.44 * wavelength * image_distance)


def radius_of_the_hole(image_distance, wavelength):
    return np.sqrt(2.44 * wavelength * image_distance) / 2


def factor_forgotten(image_distance, wavelength):
    return np.sqrt(wavelength * image_distance)


def divided_by_the_distance(image_distance, wavelength):
    return np.sqrt(2.44 * wavelength / image_distance)


def distance_outside_the_root(image_distance, wavelength):
    return image_distance / np.sqrt(2.44 * wavelength)


def rayleighs_number(image_distance, wavelength):
    return 1.9 * np.sqrt(wavelength * image_distance)
