"""Exercises of chapter 06 on applying a homography, and on normalising."""

from __future__ import annotations

from course_lib import homography
from course_lib.exercises.estimation import misconceptions_points as wrong_points
from course_lib.exercises.estimation import plane_inputs as inputs
from course_lib.judging import Exercise, Misconception, Part

APPLY_HOMOGRAPHY = Exercise(
    "estimation",
    homography.apply_homography,
    points=5,
    parts={
        "an affine matrix": Part(inputs.affine_matrix, cases=1, weight=1),
        "a wall seen at a slant": Part(inputs.wall_in_a_picture, cases=1, weight=2),
        "a single point": Part(inputs.one_point, cases=2, weight=1),
        "points that go to infinity": Part(inputs.some_to_infinity, cases=2, weight=1),
    },
    misconceptions=[
        Misconception(
            wrong_points.not_divided,
            "H gives three numbers for a point. Which step makes two coordinates of them?",
        ),
        Misconception(
            wrong_points.matrix_not_transposed,
            "Points are rows here. What must happen to a matrix that multiplies from the right?",
        ),
        Misconception(
            wrong_points.divided_by_one_long_row,
            "Taken as `p[:, 2]`, the w are one long row. What keeps them a column?",
            also=[wrong_points.divided_by_one_long_row_of_any],
        ),
        Misconception(
            wrong_points.a_single_point_stood_up,
            "Right for points in rows. What shape has a single point, and which functions of "
            "chapter 02 take both?",
            also=[wrong_points.columns_of_a_single_point],
        ),
        Misconception(
            wrong_points.zero_for_one,
            "A zero at the end of a row means a direction. Which number means a point?",
        ),
        Misconception(
            wrong_points.way_back,
            "Your map undoes H. In which direction were the points to go?",
        ),
        Misconception(
            wrong_points.one_divisor_for_all,
            "You divide all points by the same number. Does every point have the same w?",
        ),
        Misconception(
            wrong_points.three_numbers_for_a_point,
            "How many coordinates has a point of the plane, and how many do you return?",
        ),
        Misconception(
            wrong_points.infinity_divided,
            "What does a division by zero give, and what does the task want for such a point?",
        ),
        Misconception(
            wrong_points.infinity_left_undivided,
            "A point with w of zero gets ordinary coordinates from you. Is it anywhere in the "
            "plane?",
            also=[wrong_points.infinity_made_zero, wrong_points.infinity_made_far],
        ),
        Misconception(
            wrong_points.sign_of_w_dropped,
            "You take the sign of w away. What if all three numbers are negative: is it another "
            "point then?",
        ),
        Misconception(wrong_points.v_before_u, "Which row of H makes the first coordinate?"),
    ],
    forbidden=("cv2.perspectiveTransform",),
)

NORMALISE_POINTS = Exercise(
    "estimation",
    homography.normalise_points,
    points=5,
    parts={
        "pixels": Part(inputs.pixels_of_a_picture, cases=2, weight=2),
        "points of a wall, in metres": Part(inputs.points_of_a_facade, cases=1, weight=1),
        "points of space": Part(inputs.points_of_space, cases=2, weight=2),
    },
    misconceptions=[
        Misconception(
            wrong_points.distance_of_one,
            "How far from the origin are your points on average, and how far should they be?",
            also=[
                wrong_points.distance_of_d,
                wrong_points.farthest_point,
                wrong_points.farthest_point_at_one,
            ],
        ),
        Misconception(
            wrong_points.length_of_the_whole_table,
            "Of what did you take the mean? There is one distance for each point, made of all its "
            "coordinates.",
            also=[wrong_points.lengths_of_columns, wrong_points.mean_of_all_numbers],
        ),
        Misconception(
            wrong_points.root_two_in_space_too,
            "In the plane you are right. Which distance does the task want for points of space, "
            "and how large is T there?",
            also=[wrong_points.root_two_and_T_of_the_plane],
        ),
        Misconception(
            wrong_points.root_mean_square_distance,
            "You average squares and take the root at the end. Of what is the mean asked for?",
        ),
        Misconception(
            wrong_points.standard_deviation_of_all,
            "`std` is the root of a mean of squares, over all numbers of the table. Of what is the "
            "mean asked for?",
            also=[
                wrong_points.standard_deviation_of_all_by_dimension,
                wrong_points.standard_deviation_from_the_mean,
                wrong_points.standard_deviation_from_the_mean_by_dimension,
                wrong_points.spread_of_the_distances,
            ],
        ),
        Misconception(
            wrong_points.each_axis_by_itself,
            "You stretch each axis by a factor of its own. How many factors does the task allow?",
            also=[wrong_points.each_axis_to_one],
        ),
        Misconception(
            wrong_points.distance_before_the_shift,
            "From where did you measure the distances: from the origin, or from the mean?",
        ),
        Misconception(
            wrong_points.scaled_the_other_way,
            "Points that are spread widely: should your factor be large for them, or small?",
        ),
        Misconception(
            wrong_points.shift_not_scaled_in_T,
            "Your points are right, T is not. Is the shift made before the scaling, or after it?",
        ),
        Misconception(
            wrong_points.shift_to_the_wrong_side_in_T,
            "Your points are right, T is not. Put the mean of the points into T, with a 1 at the "
            "end: does zero come out, and again a 1?",
            also=[
                wrong_points.T_transposed,
                wrong_points.corner_of_T_scaled,
                wrong_points.shift_divided_in_T,
            ],
        ),
        Misconception(
            wrong_points.T_of_the_way_back,
            "Your points are right. Which way does your T lead: to the normalised points, or back?",
        ),
        Misconception(
            wrong_points.scaled_before_the_shift,
            "Where is the mean of your points now? It should be the origin: of what did you take "
            "away the mean, and when?",
            also=[wrong_points.median_for_the_middle],
        ),
        Misconception(
            wrong_points.one_mean_for_all_axes,
            "You take one mean of all numbers. How many coordinates has the middle of the points?",
        ),
        Misconception(
            wrong_points.T_before_the_points,
            "You return the right two things. In which order are they asked for?",
        ),
    ],
)
