"""Exercises of chapter 08 on known cameras: the cross product's matrix, E and F."""

from __future__ import annotations

from course_lib.exercises.epipolar import inputs, plain
from course_lib.exercises.epipolar import matrix_misconceptions as wrong
from course_lib.exercises.epipolar.comparison import PixelMatrix
from course_lib.judging import Exercise, Misconception, Part, UpToScale

SKEW = Exercise(
    "epipolar",
    plain.skew,
    points=3,
    parts={
        "whole numbers": Part(inputs.small_vector, cases=2, weight=2),
        "a baseline": Part(inputs.any_vector, cases=1, weight=1),
    },
    forbidden=("course_lib.transforms.rotations.skew",),
    misconceptions=[
        Misconception(
            wrong.transposed,
            "All numbers are in place. Does yours give v × x, or x × v?",
        ),
        Misconception(
            wrong.without_signs,
            "A cross product has differences in it. Which of your numbers are negative?",
        ),
        Misconception(
            wrong.minus_above_only,
            "Two signs are not right. Try (1, 0, 0), (0, 1, 0) and (0, 0, 1): what should v × each "
            "of them be?",
            also=[wrong.z_the_other_way, wrong.x_the_other_way],
        ),
        Misconception(
            wrong.first_and_last_swapped,
            "The signs are right. Which of x, y and z does the first row of v × x hold?",
            also=[
                wrong.last_two_swapped,
                wrong.first_two_swapped,
                wrong.one_place_on,
                wrong.one_place_back,
            ],
        ),
        Misconception(
            wrong.upper_half_only,
            "Half of the matrix is empty. How many zeros should there be?",
            also=[wrong.lower_half_only],
        ),
        Misconception(
            wrong.on_the_diagonal,
            "v × v is zero. Does your matrix times v give zero?",
            also=[wrong.every_product],
        ),
        Misconception(
            wrong.made_a_unit_vector,
            "A vector twice as long has a cross product twice as long. Has yours?",
        ),
        Misconception(
            wrong.cut_to_whole_numbers,
            "Where have the digits after the point gone? Which kind of numbers does your array "
            "take?",
        ),
        Misconception(
            wrong.crossed_with_itself,
            "A vector comes out, not a matrix. Which nine numbers multiply x like v ×?",
        ),
    ],
)

ESSENTIAL_FROM_POSE = Exercise(
    "epipolar",
    plain.essential_from_pose,
    points=4,
    compare=UpToScale(1e-8),
    parts={
        "a shift alone": Part(inputs.shifted_camera, cases=1, weight=1),
        "a shift and a turn": Part(inputs.turned_camera, cases=2, weight=3),
    },
    forbidden=("course_lib.epipolar.matrices.essential_from_pose",),
    misconceptions=[
        Misconception(
            wrong.turned_first,
            "In t × (R x1), which factor meets x1 first? And of which vectors of R, rows or "
            "columns, is the cross product taken?",
            also=[
                wrong.cross_product_of_rows,
                wrong.cross_product_with_rotation,
                wrong.turned_shift,
            ],
        ),
        Misconception(
            wrong.entry_by_entry,
            "Which sign multiplies matrices, and which one entry by entry?",
        ),
        Misconception(
            wrong.rotation_transposed,
            "R leads from camera 1 to camera 2. Do you need it, or its way back?",
        ),
        Misconception(
            wrong.other_way_round,
            "Yours fits if x1 and x2 change places. Which of them stands on the right of E?",
        ),
        Misconception(
            wrong.shift_of_the_centre,
            "You use the centre of camera 2 seen from camera 1. Which shift does X2 contain?",
        ),
        Misconception(
            wrong.matrix_without_skew,
            "This only scales R. Which matrix stands for the cross product with t?",
            also=[wrong.column_without_skew],
        ),
        Misconception(
            wrong.product_without_skew,
            "A vector comes out, not a matrix. Which matrix stands for the cross product with t?",
            also=[wrong.shift_times_rotation],
        ),
        Misconception(
            wrong.only_the_shift_turned,
            "You turn t, and then make the matrix. In t × (R x1), what is turned: t or x1?",
            also=[wrong.only_the_shift_turned_forth],
        ),
        Misconception(
            wrong.rotation_left_out,
            "Right for cameras that are not turned. What does the turn do to x1?",
        ),
        Misconception(
            wrong.added,
            "The cross product is taken of t and the turned x1. Is anything added there?",
        ),
    ],
)

FUNDAMENTAL_FROM_CAMERAS = Exercise(
    "epipolar",
    plain.fundamental_from_cameras,
    points=7,
    compare=PixelMatrix(),
    parts={
        "camera 1 at the origin": Part(inputs.first_at_the_origin, cases=1, weight=3),
        "both anywhere": Part(inputs.anywhere_in_the_world, cases=2, weight=4),
    },
    forbidden=("course_lib.epipolar.matrices.fundamental_from_cameras",),
    misconceptions=[
        Misconception(
            wrong.cameras_swapped,
            "Yours makes lines in picture 1. Which picture does x1 belong to, and which the line?",
        ),
        Misconception(
            wrong.not_inverted,
            "A camera matrix leads from space to pixels. Which way do you go from x1 to its ray?",
            also=[wrong.transposed_for_inverted],
        ),
        Misconception(
            wrong.other_one_inverted,
            "Which camera is undone to get from the pixel to the ray, and which one looks at it?",
            also=[wrong.other_one_inverted_last],
        ),
        Misconception(
            wrong.left_inverse_not_transposed,
            "Only a matrix that changes sides in a product is transposed. Which of your inverses "
            "stands beside x2ᵀ, and which beside x1?",
            also=[wrong.inverse_transposed],
        ),
        Misconception(
            wrong.factors_turned_round,
            "x1 stands on the right. Which matrix meets it first: that of camera 1 or of camera 2?",
        ),
        Misconception(
            wrong.entries_multiplied,
            "Which sign multiplies matrices, and which one entry by entry?",
            also=[wrong.last_entries_multiplied, wrong.first_entries_multiplied],
        ),
        Misconception(
            wrong.epipole_last,
            "In which picture is the cross product taken: before camera 2 looks, or after?",
        ),
        Misconception(
            wrong.second_camera_left_out,
            "You have the ray of x1 in space. Where does camera 2 see its direction?",
        ),
        Misconception(
            wrong.first_camera_left_out,
            "Camera 2 looks at directions of space. What makes a direction of the pixel x1?",
        ),
        Misconception(
            wrong.only_the_epipole,
            "A line has two points on it. You have the epipole. Which is the other one?",
        ),
        Misconception(
            wrong.only_the_plane_at_infinity,
            "You have a point of picture 2. Through which other point goes the line?",
        ),
        Misconception(
            wrong.epipole_of_picture_1,
            "The line is in picture 2. Whose centre does camera 2 see there?",
        ),
        Misconception(
            wrong.sign_of_the_centre,
            "Put your centre into camera 1: does it give zero? Look at the sign.",
            also=[wrong.transpose_in_the_centre],
        ),
        Misconception(
            wrong.last_column_for_the_centre,
            "Right for a camera at the origin. Is the last column of P1 where camera 1 stands?",
            also=[
                wrong.minus_last_column_for_the_centre,
                wrong.difference_of_last_columns,
            ],
        ),
        Misconception(
            wrong.last_column_for_the_epipole,
            "Right for a camera 1 at the origin. Where is its centre else, and what does P2 make "
            "of it?",
        ),
        Misconception(
            wrong.centre_as_a_direction,
            "A centre is a point. Which fourth number does a point have, and what meets it in P2?",
        ),
        Misconception(
            wrong.centre_of_camera_2,
            "Your F is zero. Whose centre did you take: what does P2 make of its own?",
        ),
        Misconception(
            wrong.centre_not_projected,
            "You cross with a point of space. What does camera 2 make of it?",
        ),
    ],
)
