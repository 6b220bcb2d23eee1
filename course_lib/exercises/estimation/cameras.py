"""Exercises of chapter 06 on camera matrices."""

from __future__ import annotations

from course_lib import resection
from course_lib.exercises.estimation import camera_inputs as inputs
from course_lib.exercises.estimation import misconceptions_cameras as wrong
from course_lib.exercises.estimation import misconceptions_parts as wrong_parts
from course_lib.judging import Exercise, Misconception, Part, UpToScale

CAMERA_DLT = Exercise(
    "estimation",
    resection.camera_dlt,
    points=8,
    parts={
        "six points": Part(inputs.six_points, cases=1, weight=3),
        "more points than needed": Part(inputs.twelve_points, cases=1, weight=2),
        "points in millimetres": Part(inputs.points_in_millimetres, cases=1, weight=1),
        "pixels with errors": Part(inputs.pixels_with_errors, cases=1, weight=2),
    },
    compare=UpToScale(tolerance=1e-9),  # the last row is thousands of times smaller
    misconceptions=[
        Misconception(
            wrong.numbers_as_they_come,
            "Right for exact pixels. With errors it matters which numbers stand in A: points and "
            "pixels, or what normalise_points makes of them?",
            also=[
                wrong.last_number_is_one,
                wrong.only_the_pixels_normalised,
                wrong.only_the_points_normalised,
            ],
        ),
        Misconception(
            wrong.rows_of_the_numbers_as_they_come,
            "You undo a normalising at the end. Are the numbers in your A normalised ones?",
            also=[wrong.rows_of_the_points_as_they_come, wrong.rows_of_the_pixels_as_they_come],
        ),
        Misconception(
            wrong.one_not_appended,
            "Your A has nine columns, and p must have twelve numbers. What has each point of space "
            "at its end before it meets P?",
            also=[wrong.one_not_appended_for_nine],
        ),
        Misconception(
            wrong.camera_of_normalised_points,
            "Your P takes normalised points to normalised pixels. How do you get in and out?",
        ),
        Misconception(
            wrong.pixels_left_normalised,
            "Your P takes real points, but to what kind of pixels? What is still to be undone?",
        ),
        Misconception(
            wrong.points_left_normalised,
            "Your P gives real pixels, but of what kind of points? Which T must come first?",
        ),
        Misconception(
            wrong.normalised_once_more,
            "Put a point into your product, from right to left: is it first normalised, or first "
            "taken back?",
            also=[wrong.both_undone],
        ),
        Misconception(
            wrong.pixels_normalised_once_more,
            "On the right your product is fine. The last matrix that acts on a pixel: does it "
            "normalise, or undo it?",
        ),
        Misconception(
            wrong.longest_of_twelve,
            "That is the direction in which A makes a vector longest. Where is the other end?",
        ),
        Misconception(
            wrong.last_column_of_twelve,
            "The right vector is there, but you took numbers from all of them. Does NumPy give the "
            "vectors as rows here, or as columns?",
            also=[wrong.last_column_with_rows_in_blocks],
        ),
        Misconception(
            wrong.filled_column_by_column,
            "Look at the order of p in your rows of A. Does it fill P row by row?",
        ),
        Misconception(
            wrong.sign_of_the_last_four,
            "Bring everything to one side of the equation. Which sign do the last four get?",
            also=[wrong.plus_in_the_rows_of_v, wrong.plus_in_the_rows_of_u],
        ),
        Misconception(
            wrong.v_where_u_begins,
            "Which row of P makes v, and in which four columns of A do its numbers stand?",
        ),
        Misconception(
            wrong.only_rows_of_u,
            "One coordinate of the pixels never enters your A. How many rows does each point give?",
            also=[wrong.only_rows_of_v],
            explains=wrong.one_row_alone,
        ),
        Misconception(
            wrong.v_for_u,
            "Which row of P makes u? In which rows of A does u stand, and where does v?",
            also=[wrong.u_for_v, wrong.v_for_u_in_the_rows, wrong.exchanged_in_the_rows],
        ),
        Misconception(
            wrong.last_row_of_a_parallel_camera,
            "With your P nothing gets smaller with distance. Which row of P knows the distance?",
        ),
    ],
    forbidden=("cv2.calibrateCamera", "cv2.solvePnP"),
)

DECOMPOSE_PROJECTION = Exercise(
    "estimation",
    resection.decompose_projection,
    points=8,
    parts={
        "a matrix as it was put together": Part(inputs.as_it_was_put_together, cases=1, weight=3),
        "a multiple of it": Part(inputs.any_multiple, cases=1, weight=3),
        "a negative multiple": Part(inputs.negative_multiple, cases=2, weight=2),
    },
    misconceptions=[
        Misconception(
            wrong_parts.signs_as_they_come,
            "Look at the diagonal of your K. May a focal length be negative, and what may you "
            "multiply K and R with so that K R stays?",
            also=[
                wrong_parts.signs_as_they_come_from_flipping,
                wrong_parts.signs_as_they_come_from_scipy,
                wrong_parts.signs_as_they_come_after_the_mirror,
            ],
        ),
        Misconception(
            wrong_parts.divided_before_the_signs,
            "You divided K by its last number before you mended the signs. If that number is "
            "negative, which sign changes does K get that R does not?",
            also=[wrong_parts.divided_before_the_signs_without_the_mirror],
        ),
        Misconception(
            wrong_parts.block_taken_too_early,
            "You turn the sign of P. When was M taken out of it: before, or after?",
        ),
        Misconception(
            wrong_parts.signs_of_K_only,
            "Your K is right. You changed signs in it: is the product of K and R still the same?",
            also=[
                wrong_parts.signs_of_K_only_without_the_mirror,
                wrong_parts.signs_of_K_in_the_columns_of_R,
            ],
        ),
        Misconception(
            wrong_parts.signs_on_the_outer_sides,
            "Between K and R, two equal sign matrices cancel. Do yours stand there, or outside?",
        ),
        Misconception(
            wrong_parts.inverse_left_in_K,
            "You split the inverse of M. Does the triangle belong to K then, or to its inverse?",
        ),
        Misconception(
            wrong_parts.mirror_left_in,
            "Right, unless P is negative. Which determinant has your R then, and a rotation's?",
        ),
        Misconception(
            wrong_parts.rotation_first,
            "QR gives the rotation first and the triangle second. Which of them is first in K R?",
            also=[
                wrong_parts.rotation_first_with_signs,
                wrong_parts.rotation_first_signs_inside,
                wrong_parts.rotation_first_and_nothing_else,
            ],
        ),
        Misconception(
            wrong_parts.K_not_divided,
            "Two multiples of P are one camera. Which number of K shows the scale that is left?",
        ),
        Misconception(
            wrong_parts.rotation_transposed,
            "Your K is right. Does your R lead from the world to the camera, or back?",
            also=[wrong_parts.transpose_left_out],
        ),
        Misconception(
            wrong_parts.last_column_as_centre,
            "K and R are right. The last column of P is the image of the world's origin: is the "
            "camera there?",
            also=[wrong_parts.minus_last_column_as_centre],
        ),
        Misconception(
            wrong_parts.translation_as_centre,
            "K and R are right. You return where the origin is, seen from the camera. Who asks "
            "for whom?",
            also=[wrong_parts.translation_of_a_scaled_matrix, wrong_parts.t_for_the_centre],
        ),
        Misconception(
            wrong_parts.scale_left_in_the_centre,
            "Right while P is not multiplied. You divided K by a number: did the last column of P "
            "know of it?",
        ),
        Misconception(
            wrong_parts.null_vector_not_divided,
            "K and R are right. The point that P maps to zero has four numbers: what makes three "
            "coordinates of them?",
        ),
        Misconception(
            wrong_parts.last_column_without_K,
            "K and R are right. The last column of P is K times t: what did you do about K?",
        ),
        Misconception(
            wrong_parts.rotation_before_K,
            "Your three answers are right. In which order are they asked for?",
            also=[wrong_parts.centre_before_R, wrong_parts.centre_first, wrong_parts.turned_round],
        ),
        Misconception(
            wrong_parts.sign_of_the_centre,
            "P maps the centre to zero. What does it make of your point?",
        ),
    ],
    forbidden=("cv2.decomposeProjectionMatrix", "cv2.RQDecomp3x3"),
)
