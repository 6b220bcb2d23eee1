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


# --- project_pinhole --------------------------------------------------------------------------


def divides_by_focal_length(points, f, c):
    return np.where(points[..., 2:] > 0, points[..., :2] / f, np.nan) + c


def exchanges_f_and_Z(points, f, c):
    Z = np.where(points[..., 2:] > 0, points[..., 2:], np.nan)
    return Z * points[..., :2] / f + c


def principal_point_forgotten(points, f, c):
    Z = np.where(points[..., 2:] > 0, points[..., 2:], np.nan)
    return f * points[..., :2] / Z


def row_then_column(points, f, c):
    Z = np.where(points[..., 2:] > 0, points[..., 2:], np.nan)
    return (f * points[..., :2] / Z + c)[..., ::-1]


def image_plane_behind(points, f, c):
    Z = np.where(points[..., 2:] > 0, points[..., 2:], np.nan)
    return -f * points[..., :2] / Z + c


def distance_for_depth(points, f, c):
    distance = np.linalg.norm(points, axis=-1, keepdims=True)
    return f * points[..., :2] / np.where(points[..., 2:] > 0, distance, np.nan) + c


def mirrors_what_is_behind(points, f, c):
    return f * points[..., :2] / points[..., 2:] + c


# --- vanishing_point --------------------------------------------------------------------------


def forward_only(direction, f, c):
    Z = np.where(direction[..., 2:] > 0, direction[..., 2:], np.nan)
    return f * direction[..., :2] / Z + c


def centre_forgotten(direction, f, c):
    Z = np.where(direction[..., 2:] != 0, direction[..., 2:], np.nan)
    return f * direction[..., :2] / Z


def unit_direction(direction, f, c):
    length = np.linalg.norm(direction, axis=-1, keepdims=True)
    return f * direction[..., :2] / length + c


def tangent_without_focal_length(direction, f, c):
    Z = np.where(direction[..., 2:] != 0, direction[..., 2:], np.nan)
    return direction[..., :2] / Z + c


def at_infinity(direction, f, c):
    return f * direction[..., :2] / direction[..., 2:] + c


# --- dolly_zoom -------------------------------------------------------------------------------


def inverse_ratio(f, Z, Z_new):
    return f * Z / Z_new


def adds_the_way(f, Z, Z_new):
    return f + (Z_new - Z)


def ratio_squared(f, Z, Z_new):
    return f * (Z_new / Z) ** 2


def only_the_factor(f, Z, Z_new):
    return Z_new / Z


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


# --- the data sheet ---------------------------------------------------------------------------


def filled_in(
    pixels_per_mm: float, f: float, image_size: tuple[int, int], f_calibrated: float
) -> dict[str, float]:
    """Return the data sheet's values that follow from a number of pixels per millimetre."""
    return {
        "pixels_per_mm": pixels_per_mm,
        "f_px": f * pixels_per_mm,
        "c_u": (image_size[0] - 1) / 2,
        "c_v": (image_size[1] - 1) / 2,
        "f_calibrated_mm": f_calibrated / pixels_per_mm,
    }


def data_sheet_pixel_size(f, sensor_size, image_size, f_calibrated):
    return filled_in(sensor_size[0] / image_size[0], f, image_size, f_calibrated)


def data_sheet_along_the_height(f, sensor_size, image_size, f_calibrated):
    return filled_in(image_size[1] / sensor_size[1], f, image_size, f_calibrated)


def data_sheet_rows_first(f, sensor_size, image_size, f_calibrated):
    values = filled_in(image_size[0] / sensor_size[0], f, image_size, f_calibrated)
    return {**values, "c_u": values["c_v"], "c_v": values["c_u"]}


def data_sheet_inverse_ratio(f, sensor_size, image_size, f_calibrated):
    values = filled_in(image_size[0] / sensor_size[0], f, image_size, f_calibrated)
    return {**values, "f_calibrated_mm": f * values["f_px"] / f_calibrated}


def data_sheet_whole_size(f, sensor_size, image_size, f_calibrated):
    values = filled_in(image_size[0] / sensor_size[0], f, image_size, f_calibrated)
    return {**values, "c_u": image_size[0], "c_v": image_size[1]}


def data_sheet_half_the_size(f, sensor_size, image_size, f_calibrated):
    values = filled_in(image_size[0] / sensor_size[0], f, image_size, f_calibrated)
    return {**values, "c_u": image_size[0] / 2, "c_v": image_size[1] / 2}


def data_sheet_still_in_pixels(f, sensor_size, image_size, f_calibrated):
    values = filled_in(image_size[0] / sensor_size[0], f, image_size, f_calibrated)
    return {**values, "f_calibrated_mm": f_calibrated}
