"""The exercise of chapter 01 on a real data sheet."""

from __future__ import annotations

from course_lib import camera
from course_lib.exercises.pinhole import misconceptions_data_sheet as wrong
from course_lib.judging import Close, Misconception, ValuesExercise


def data_sheet(f, sensor_size, image_size, f_calibrated):
    """Work out a camera's first guess from its data sheet, and read a calibration back."""
    pixels_per_mm = image_size[0] / sensor_size[0]
    c_x, c_y = camera.image_centre(image_size)
    return {
        "pixels_per_mm": pixels_per_mm,
        "f_px": f * pixels_per_mm,
        "c_x": c_x,
        "c_y": c_y,
        "f_calibrated_mm": f_calibrated / pixels_per_mm,
    }


DATA_SHEET = ValuesExercise(
    "pinhole",
    data_sheet,
    given={
        "f": 85.0,
        "sensor_size": (27.6, 25.9),
        "image_size": (2048, 1920),
        "f_calibrated": 6890.5,
    },
    units={
        "pixels_per_mm": "px/mm, along the width",
        "f_px": "focal length in px, along the width",
        "c_x": "principal point, column in px",
        "c_y": "principal point, row in px",
        "f_calibrated_mm": "the calibrated focal length in mm",
    },
    points=5,
    # Digits of a pocket calculator are enough; half a pixel of 1024 is too much.
    compare=Close(rtol=4.5e-4, atol=0),
    misconceptions=[
        Misconception(
            wrong.data_sheet_pixel_size,
            "Is that the number of pixels in a millimetre, or of millimetres in a pixel?",
        ),
        Misconception(
            wrong.data_sheet_rows_first,
            "A picture of 2048 × 1920 has 2048 columns. Which coordinate counts columns?",
        ),
        Misconception(
            wrong.data_sheet_inverse_ratio,
            "The calibrated focal length is longer in pixels. Should it be shorter in millimetres?",
        ),
        Misconception(
            wrong.data_sheet_whole_size,
            "The principal point is near the middle of the picture. Is yours?",
        ),
        Misconception(
            wrong.data_sheet_half_the_size,
            "Where is pixel 0: at the left edge of the picture, or half a pixel inside?",
        ),
        Misconception(
            wrong.data_sheet_along_the_height,
            "The task asks along the width. Which of the two sides did you take?",
        ),
        Misconception(
            wrong.data_sheet_still_in_pixels,
            "Is this number in pixels or in millimetres?",
        ),
        Misconception(
            wrong.data_sheet_half_a_pixel_too_far,
            "Of four pixels the first is number 0, the last number 3. What is half-way?",
        ),
        Misconception(
            wrong.data_sheet_multiplied_back,
            "From mm to pixels you multiplied. Which way do you go here?",
        ),
        Misconception(
            wrong.data_sheet_only_the_ratio,
            "This says how many times longer the lens is than 85 mm. How long is it?",
        ),
        Misconception(
            wrong.data_sheet_rounded_at_the_end,
            "Whole numbers are too coarse here. Can you give four digits?",
        ),
        Misconception(
            wrong.data_sheet_rounded_on_the_way,
            "Keep at least four digits on the way: did you round the pixels per millimetre?",
        ),
    ],
)
