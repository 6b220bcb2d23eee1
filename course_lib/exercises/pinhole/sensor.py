"""Exercises of chapter 01 on the camera itself: hole, sensor, focal length, first guess."""

from __future__ import annotations

from course_lib import camera, optics
from course_lib.exercises.pinhole import inputs
from course_lib.exercises.pinhole import misconceptions as wrong
from course_lib.judging import Close, Exercise, Misconception, Part, ValuesExercise

PIXEL_FOCAL_LENGTH = Exercise(
    "pinhole",
    camera.pixel_focal_length,
    parts={
        "square pixels": inputs.square_pixels,
        "pixels that are not square": inputs.oblong_pixels,
    },
    misconceptions=[
        Misconception(
            wrong.pixel_upside_down,
            "Is your answer in pixels? Write the units behind each quantity and see what cancels.",
        ),
        Misconception(
            wrong.width_for_both_axes,
            "Suppose a pixel is taller than it is wide. Which of its sides matters for fy?",
        ),
        Misconception(
            wrong.height_first,
            "A size is (width, height). Which of the two belongs to the first result, fx?",
        ),
        Misconception(
            wrong.pixels_per_millimetre,
            "This is how many pixels fit into one millimetre. How long is the lens in millimetres?",
        ),
    ],
)

FIELD_OF_VIEW = Exercise(
    "pinhole",
    optics.field_of_view,
    parts={"wide lenses": inputs.wide_lens, "long lenses": inputs.long_lens},
    misconceptions=[
        Misconception(
            wrong.half_angle,
            "Your angle reaches from the optical axis to one edge. Does the picture end there?",
        ),
        Misconception(
            wrong.in_degrees,
            "These are angles in degrees. Which unit does the task ask for?",
        ),
        Misconception(
            wrong.whole_width,
            "Draw the right triangle at the hole: how much of the sensor is its short side?",
        ),
        Misconception(
            wrong.small_angle,
            "For a long lens you are nearly right. What did you take an angle and its tangent for?",
        ),
        Misconception(
            wrong.width_for_height,
            "Which side of the sensor limits how far the camera sees up and down?",
        ),
        Misconception(
            wrong.triangle_upside_down,
            "A longer lens sees less. Does your angle get smaller when f grows?",
        ),
        Misconception(
            wrong.brackets_forgotten,
            "Python computes from left to right. Is f still below your fraction bar?",
        ),
        Misconception(
            wrong.tangent_for_arctangent,
            "You know the tangent of the angle and want the angle. Which function goes that way?",
        ),
        Misconception(
            wrong.angles_added,
            "Do angles add up like this? Which side of which triangle is the diagonal?",
        ),
    ],
)

EQUIVALENT_FOCAL_LENGTH = Exercise(
    "pinhole",
    optics.equivalent_focal_length,
    parts={
        "sensors of the same shape": Part(inputs.same_shape_sensor, weight=1),
        "sensors of another shape": Part(inputs.wide_lens, weight=3),
    },
    misconceptions=[
        Misconception(
            wrong.crop_by_width,
            "Sensors differ in shape. Which length did the makers agree to compare?",
        ),
        Misconception(
            wrong.crop_by_height,
            "You compare the short sides. Which length takes both sides into account?",
        ),
        Misconception(
            wrong.crop_upside_down,
            "A small sensor sees less through the same lens. "
            "Which lens sees less on full frame: a longer or a shorter one?",
        ),
        Misconception(
            wrong.crop_by_area,
            "Focal length and angle go with lengths. What kind of quantity did you compare?",
        ),
        Misconception(
            wrong.only_the_crop_factor,
            "That is a factor without a unit. Which length has to be multiplied by it?",
        ),
    ],
)

FIRST_GUESS_INTRINSICS = Exercise(
    "pinhole",
    camera.first_guess_intrinsics,
    parts={
        "square pixels": inputs.square_pixels,
        "pixels that are not square": inputs.oblong_pixels,
    },
    misconceptions=[
        Misconception(
            wrong.half_the_size,
            "Where is pixel 0: at the left edge of the picture, or half a pixel inside?",
        ),
        Misconception(
            wrong.millimetres_in_K,
            "K turns directions into pixels. In which unit is the focal length that you put in?",
        ),
        Misconception(
            wrong.no_principal_point,
            "Which pixel does a point straight ahead fall on? Try it with your matrix.",
        ),
        Misconception(
            wrong.centre_rows_first,
            "In K, the first row makes u. Does u count columns or rows?",
        ),
        Misconception(
            wrong.transposed,
            "Multiply your matrix with (X, Y, Z). Is the last of the three results still Z?",
        ),
        Misconception(
            wrong.fx_for_both_axes,
            "Suppose a pixel is taller than wide. Does a millimetre hold as many rows as columns?",
        ),
    ],
)

BEST_PINHOLE_DIAMETER = Exercise(
    "pinhole",
    optics.best_pinhole_diameter,
    parts={
        "boxes of all sizes and light of all colours": Part(inputs.box_camera, cases=4, weight=3),
        "several boxes at once": inputs.several_boxes,
    },
    misconceptions=[
        Misconception(
            wrong.radius_of_airy_disk,
            "Is your diffraction spot a diameter or a radius? Compare like with like.",
        ),
        Misconception(
            wrong.not_square_rooted,
            "Which unit does your answer have: a length, or a length squared?",
        ),
        Misconception(
            wrong.size_of_the_spot,
            "You found how large the smallest spot is. How large is the hole that makes it?",
        ),
        Misconception(
            wrong.radius_of_the_hole,
            "A drill is sold by its diameter. Is your number the diameter of the hole?",
        ),
        Misconception(
            wrong.factor_forgotten,
            "Your formula has the right unit. Where has the number in front of the Airy disk gone?",
        ),
    ],
)


def data_sheet(f, sensor_size, image_size, f_calibrated):
    """Work out a camera's first guess from its data sheet, and read a calibration back."""
    pixels_per_mm = image_size[0] / sensor_size[0]
    c_u, c_v = camera.image_centre(image_size)
    return {
        "pixels_per_mm": pixels_per_mm,
        "f_px": f * pixels_per_mm,
        "c_u": c_u,
        "c_v": c_v,
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
        "c_u": "principal point, column in px",
        "c_v": "principal point, row in px",
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
    ],
)
