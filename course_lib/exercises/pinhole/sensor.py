"""Exercises of chapter 01 on the camera itself: hole, sensor, focal length, first guess."""

from __future__ import annotations

from course_lib import camera, optics
from course_lib.exercises.pinhole import inputs
from course_lib.exercises.pinhole import misconceptions as wrong
from course_lib.judging import Close, Exercise, Misconception, Part

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
            wrong.crosses_the_sizes,
            "Sizes are (width, height). Do you divide the picture's width by the sensor's width?",
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
        Misconception(
            wrong.angles_squared_and_added,
            "Is the triangle with the diagonal made of angles or of lengths?",
        ),
        Misconception(
            wrong.sides_added,
            "How long is the diagonal of a rectangle? Shorter than the way along its two sides.",
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
    compare=Close(rtol=1e-4),  # the diagonal may be typed in with four digits: 43.27 mm
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
        Misconception(
            wrong.crop_by_root_of_area,
            "Equal areas are not equal diagonals. Which length did the makers agree to compare?",
        ),
        Misconception(
            wrong.always_twice,
            "Twice is right for one size of sensor. Does your factor know how large this one is?",
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
        Misconception(
            wrong.middle_rounded_down,
            "A row of 4 pixels has its middle between two of them. Which number is that?",
        ),
        Misconception(
            wrong.last_one_forgotten,
            "Multiply your matrix with (X, Y, Z). The third result should be Z: is it?",
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
        Misconception(
            wrong.divided_by_the_distance,
            "Has your answer the unit of a length? And which box needs the larger hole?",
        ),
        Misconception(
            wrong.distance_outside_the_root,
            "Has your answer the unit of a length? Which quantities stand under the root?",
        ),
        Misconception(
            wrong.rayleighs_number,
            "Lord Rayleigh's 1.9 follows from another rule. Which number makes our b(d) smallest?",
        ),
    ],
)
