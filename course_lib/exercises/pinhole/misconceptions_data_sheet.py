"""Wrong answers to the data sheet of chapter 01, as students write them."""

from __future__ import annotations


def filled_in(
    pixels_per_mm: float, f: float, image_size: tuple[int, int], f_calibrated: float
) -> dict[str, float]:
    """Return the data sheet's values that follow from a number of pixels per millimetre."""
    return {
        "pixels_per_mm": pixels_per_mm,
        "f_px": f * pixels_per_mm,
        "c_x": (image_size[0] - 1) / 2,
        "c_y": (image_size[1] - 1) / 2,
        "f_calibrated_mm": f_calibrated / pixels_per_mm,
    }


def data_sheet_pixel_size(f, sensor_size, image_size, f_calibrated):
    return filled_in(sensor_size[0] / image_size[0], f, image_size, f_calibrated)


def data_sheet_along_the_height(f, sensor_size, image_size, f_calibrated):
    return filled_in(image_size[1] / sensor_size[1], f, image_size, f_calibrated)


def data_sheet_rows_first(f, sensor_size, image_size, f_calibrated):
    values = filled_in(image_size[0] / sensor_size[0], f, image_size, f_calibrated)
    return {**values, "c_x": values["c_y"], "c_y": values["c_x"]}


def data_sheet_inverse_ratio(f, sensor_size, image_size, f_calibrated):
    values = filled_in(image_size[0] / sensor_size[0], f, image_size, f_calibrated)
    return {**values, "f_calibrated_mm": f * values["f_px"] / f_calibrated}


def data_sheet_whole_size(f, sensor_size, image_size, f_calibrated):
    values = filled_in(image_size[0] / sensor_size[0], f, image_size, f_calibrated)
    return {**values, "c_x": image_size[0], "c_y": image_size[1]}


def data_sheet_half_the_size(f, sensor_size, image_size, f_calibrated):
    values = filled_in(image_size[0] / sensor_size[0], f, image_size, f_calibrated)
    return {**values, "c_x": image_size[0] / 2, "c_y": image_size[1] / 2}


def data_sheet_still_in_pixels(f, sensor_size, image_size, f_calibrated):
    values = filled_in(image_size[0] / sensor_size[0], f, image_size, f_calibrated)
    return {**values, "f_calibrated_mm": f_calibrated}


def data_sheet_half_a_pixel_too_far(f, sensor_size, image_size, f_calibrated):
    values = filled_in(image_size[0] / sensor_size[0], f, image_size, f_calibrated)
    return {**values, "c_x": (image_size[0] + 1) / 2, "c_y": (image_size[1] + 1) / 2}


def data_sheet_multiplied_back(f, sensor_size, image_size, f_calibrated):
    values = filled_in(image_size[0] / sensor_size[0], f, image_size, f_calibrated)
    return {**values, "f_calibrated_mm": f_calibrated * values["pixels_per_mm"]}


def data_sheet_only_the_ratio(f, sensor_size, image_size, f_calibrated):
    values = filled_in(image_size[0] / sensor_size[0], f, image_size, f_calibrated)
    return {**values, "f_calibrated_mm": f_calibrated / values["f_px"]}


def data_sheet_rounded_at_the_end(f, sensor_size, image_size, f_calibrated):
    values = filled_in(image_size[0] / sensor_size[0], f, image_size, f_calibrated)
    whole = ("pixels_per_mm", "f_calibrated_mm")
    return {**values, **{name: round(values[name]) for name in whole}}


def data_sheet_rounded_on_the_way(f, sensor_size, image_size, f_calibrated):
    return filled_in(round(image_size[0] / sensor_size[0]), f, image_size, f_calibrated)
