"""Exercises of chapter 07 on the board and the closed form: points, constraints, K, poses."""

from __future__ import annotations

from course_lib.exercises.calibration import closed_form_misconceptions as wrong
from course_lib.exercises.calibration import inputs, plain
from course_lib.exercises.calibration import pose_misconceptions as pose
from course_lib.judging import Close, Exercise, Misconception, Part

BOARD_POINTS = Exercise(
    "calibration",
    plain.board_points,
    points=5,
    parts={
        "more columns than rows": Part(inputs.landscape_board, weight=3),
        "more rows than columns": Part(inputs.portrait_board, weight=2),
    },
    forbidden=("course_lib.calibration.views.board_points",),
    misconceptions=[
        Misconception(
            wrong.columns_and_rows_swapped,
            "How many corners does your first row have before y changes: as many as there are "
            "columns?",
        ),
        Misconception(
            wrong.square_forgotten,
            "Your corners are 1 apart. In which unit, and how far apart are they on the board?",
        ),
        Misconception(
            wrong.column_after_column,
            "All corners are there. Which is the second one in your list: the next in the row?",
        ),
        Misconception(
            wrong.x_and_y_swapped,
            "Which coordinate changes as you walk along a row of the board?",
        ),
        Misconception(
            wrong.squares_counted,
            "Are inner corners asked for, where four squares meet, or all corners of squares?",
        ),
        Misconception(
            wrong.last_row_and_column_left_out,
            "The inner corners are counted already. Which is the last number of `range(9)`?",
            also=[wrong.last_column_left_out, wrong.last_row_left_out],
        ),
        Misconception(
            wrong.first_corner_at_one,
            "Where is the origin of the board's frame: at your first corner?",
        ),
        Misconception(
            wrong.cut_to_whole_numbers,
            "All your numbers are whole. What becomes of 96.8 in an array made of whole numbers?",
        ),
        Misconception(
            wrong.origin_in_the_middle,
            "Where should the first corner be? Yours lies on the negative side.",
        ),
        Misconception(
            wrong.without_z,
            "A point of space has three coordinates. Which is the third, on a flat board?",
        ),
    ],
)

HOMOGRAPHY_CONSTRAINTS = Exercise(
    "calibration",
    plain.homography_constraints,
    points=7,
    parts={
        "small whole numbers": Part(inputs.small_homography, weight=3),
        "a view of a board": Part(inputs.view_of_a_board, weight=4),
    },
    forbidden=("course_lib.calibration.zhang.homography_constraints",),
    misconceptions=[
        Misconception(
            wrong.rows_for_columns,
            "H is K times r1, r2 and t, side by side. Are h1 and h2 then rows of H, or columns?",
        ),
        Misconception(
            wrong.lengths_added,
            "r1 and r2 are equally long. Is it their sum that is zero?",
        ),
        Misconception(
            wrong.half_of_the_mixed_products,
            "B12 stands twice in B, once above the diagonal and once below. Do both count?",
            also=[wrong.half_of_the_mixed_squares, wrong.half_in_v11, wrong.half_in_v22],
        ),
        Misconception(
            wrong.in_the_order_of_rows,
            "Which number of b is the third: B13, or B22?",
        ),
        Misconception(
            wrong.equations_swapped,
            "Both equations are there. Which of them should be in the first row?",
        ),
        Misconception(
            wrong.only_one_length,
            "Your second row says that r1 has no length. With what should it be compared?",
        ),
        Misconception(
            wrong.three_rows,
            "One view gives two equations. Which two of your rows belong to the same equation?",
        ),
        Misconception(
            wrong.subtracted_the_other_way,
            "Times b, yours is zero too. Which of v11 and v22 does the text subtract from the "
            "other?",
        ),
        Misconception(
            wrong.second_and_third_column,
            "Which columns of H come from the rotation, and which one from t?",
        ),
    ],
)

INTRINSICS_FROM_HOMOGRAPHIES = Exercise(
    "calibration",
    plain.intrinsics_from_homographies,
    points=8,
    compare=Close(rtol=1e-5, atol=1e-3),
    parts={
        "three views": Part(inputs.three_views, cases=2, weight=5),
        "six views, with skew": Part(inputs.many_views_with_skew, cases=2, weight=3),
    },
    forbidden=("course_lib.calibration.zhang.intrinsics_from_homographies",),
    misconceptions=[
        Misconception(
            wrong.not_scaled,
            "B is only known up to a scale. Which entry of K do you know beforehand?",
        ),
        Misconception(
            wrong.inverse_left_out,
            "The factor of B is not yet K. What does B hold: K, or its inverse?",
            also=[wrong.inverse_and_scale_left_out],
        ),
        Misconception(
            wrong.lower_triangle,
            "Your numbers stand below the diagonal. Where should those of K stand?",
        ),
        Misconception(
            wrong.B_itself_inverted,
            "You inverted B as a whole. Of which two factors, each a triangle, is B made?",
        ),
        Misconception(
            wrong.B_for_K,
            "This is B, and symmetric. Which triangular matrix is inside it?",
        ),
        Misconception(
            wrong.scaled_by_the_first,
            "Which entry of K is 1: the first one, or the last one?",
        ),
        Misconception(
            wrong.mixed_entries_halved,
            "B12 stands in B twice, but the equations know that. Does an entry of b change on its "
            "way into B?",
            also=[wrong.mixed_entries_doubled],
        ),
        Misconception(
            wrong.upper_triangle_only,
            "B is symmetric. What stands below its diagonal in yours?",
        ),
        Misconception(
            wrong.signs_of_B_lost,
            "B has negative entries, and needs them. If b has the wrong sign, what do you change: "
            "all signs, or only the negative ones?",
        ),
        Misconception(
            wrong.skew_set_to_zero,
            "Right, if there is no skew. Who says that there is none?",
        ),
        Misconception(
            wrong.one_view_is_enough,
            "K has five numbers, and one view gives two equations. Where do your other three come "
            "from, and what do the other views say to them?",
        ),
        Misconception(
            wrong.order_of_b_mixed_up,
            "Cholesky finds no factor. Has your table two rows of each view and six columns? Is it "
            "zero times b? Is B11 positive? Where in B does the third of b go?",
            also=[
                wrong.largest_singular_value,
                wrong.column_of_the_last_factor,
                wrong.first_view_only,
                wrong.last_view_only,
                wrong.rows_side_by_side,
            ],
        ),
        Misconception(
            wrong.rows_not_below_each_other,
            "Print the shape of all your rows together. Are they one table with six columns?",
            also=[wrong.rows_not_below_each_other_without_if],
        ),
    ],
)

POSE_FROM_HOMOGRAPHY = Exercise(
    "calibration",
    plain.pose_from_homography,
    points=8,
    parts={
        "an exact homography": Part(inputs.exact_homography, cases=2, weight=3),
        "with a negative factor": Part(inputs.negative_homography, cases=2, weight=2),
        "with noise": Part(inputs.noisy_homography, cases=2, weight=3),
    },
    forbidden=(
        "course_lib.calibration.zhang.pose_from_homography",
        "cv2.solvePnP",
        "cv2.decomposeHomographyMat",
    ),
    misconceptions=[
        Misconception(
            pose.intrinsics_left_out,
            "H holds pixels, a pose holds lengths. What stands between them?",
        ),
        Misconception(
            pose.K_not_inverted,
            "K makes pixels of directions. Which way do you have to go here?",
        ),
        Misconception(
            pose.behind_the_camera,
            "Look at the third number of your t: is the board before the camera?",
        ),
        Misconception(
            pose.only_t_turned_to_the_front,
            "The unknown factor is common to r1, r2 and t. If it is negative, which of them turn?",
        ),
        Misconception(
            pose.last_factor_transposed,
            "NumPy's SVD gives its last factor transposed already. What do you multiply U with?",
        ),
        Misconception(
            pose.built_upon_r1,
            "Your R trusts r1 wholly and bends only r2. Which rotation is nearest to all columns?",
        ),
        Misconception(
            pose.not_a_rotation,
            "Multiply your R by its transpose. Is that the identity when H has noise?",
        ),
        Misconception(
            pose.lengths_mended_only,
            "Your columns are of length 1. Are the first two perpendicular when H has noise?",
        ),
        Misconception(
            pose.t_not_scaled,
            "You scaled r1 and r2. Which of the three columns has the same unknown factor?",
        ),
        Misconception(
            pose.t_scaled_by_r1,
            "With noise r1 and r2 are not equally long. Which length does the task ask for?",
            also=[pose.geometric_mean, pose.quadratic_mean],
        ),
        Misconception(
            pose.rows_for_columns,
            "r1 and r2 are columns. Which axis does your length run along?",
        ),
        Misconception(
            pose.each_made_one_before_the_rotation,
            "Nearly right. Does the nearest rotation have to be near to columns that are mended "
            "already? Divide all by one length.",
            also=[pose.each_made_one_and_t_by_the_mean],
        ),
        Misconception(
            pose.multiplied_number_by_number,
            "Your third axis is r1 times r2, number by number. Which product of two directions is "
            "perpendicular to both?",
        ),
        Misconception(
            pose.factors_number_by_number,
            "U and Vᵀ are matrices. Does your sign multiply matrices, or number by number?",
        ),
        Misconception(
            pose.mirrored,
            "What is the determinant of your R? A right hand should not become a left one.",
            also=[pose.mirrored_and_not_a_rotation],
        ),
        Misconception(
            pose.camera_to_board,
            "Your R leads from the camera to the board. Which way does a pose go here?",
        ),
        Misconception(
            pose.third_column_in_R,
            "The third column of H belongs to t. Where does the third axis of the board come from?",
        ),
    ],
)
