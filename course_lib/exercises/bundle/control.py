"""Exercises of chapter 10 on a circle of pictures and on check points."""

from __future__ import annotations

from course_lib.exercises.bundle import control_misconceptions as wrong
from course_lib.exercises.bundle import similarity_inputs as inputs
from course_lib.exercises.bundle import similarity_plain as plain
from course_lib.judging import Exercise, Misconception, Part

PICTURES_FOR_CIRCLE = Exercise(
    "bundle",
    plain.pictures_for_circle,
    points=4,
    parts={
        "steps that fill the circle": Part(inputs.steps_that_fill_the_circle, cases=1, weight=1),
        "a small rest": Part(inputs.small_rest, cases=1, weight=1),
        "a large rest": Part(inputs.large_rest, cases=1, weight=1),
        "a whole number but for rounding": Part(inputs.rounded_up, cases=1, weight=1),
    },
    forbidden=("course_lib.orientation.control.pictures_for_circle",),
    misconceptions=[
        Misconception(
            wrong.rounded_down,
            "How large are the steps with so few pictures: are they still small enough?",
            also=[
                wrong.rounded_down_without_care,
                wrong.rounded_down_below_whole_numbers,
                wrong.floor_division,
            ],
        ),
        Misconception(
            wrong.rounded_to_the_nearest,
            "Right for a large rest. If 36.2 pictures are needed, are 36 enough?",
        ),
        Misconception(
            wrong.not_rounded,
            "Is 51.4 a number of pictures? To which side must it be rounded?",
        ),
        Misconception(
            wrong.degrees_of_a_circle,
            "The step is in radians. How large is a whole circle in that unit?",
        ),
        Misconception(
            wrong.degrees_for_radians,
            "The step is in radians already. Do you make it even smaller?",
        ),
        Misconception(
            wrong.half_a_circle,
            "You have half of the pictures. How many radians has a whole circle?",
        ),
        Misconception(
            wrong.one_more,
            "The last picture of a circle has the first as its neighbour. Do you count it twice?",
        ),
        Misconception(
            wrong.down_and_one_more,
            "With a rest it is right. What if the steps fill the circle?",
        ),
        Misconception(
            wrong.rounding_asks_for_one_more,
            "What becomes of 83.00000000000001 when it is rounded up, and is so small a rest real?",
        ),
        Misconception(
            wrong.upside_down,
            "Do you count how many circles go into a step, or how many steps go into a circle?",
            also=[wrong.share_of_a_circle],
        ),
    ],
)

CHECK_POINT_RMSE = Exercise(
    "bundle",
    plain.check_point_rmse,
    points=5,
    parts={
        "few points": Part(inputs.few_check_points, cases=1, weight=3),
        "heights that are too low": Part(inputs.heights_too_low, cases=1, weight=2),
    },
    forbidden=("course_lib.orientation.control.check_point_rmse",),
    misconceptions=[
        Misconception(
            wrong.mean_of_sizes,
            "This is a mean of sizes. Where are the squares and the root of an RMSE?",
        ),
        Misconception(
            wrong.mean_of_differences,
            "Errors of opposite sign: do they cancel in your mean? What comes first, the square or "
            "the mean?",
            also=[wrong.size_of_the_mean, wrong.mean_squared_afterwards],
        ),
        Misconception(
            wrong.root_left_out,
            "Your answer is in squared metres. What is missing at the end?",
        ),
        Misconception(
            wrong.deviations_from_the_mean,
            "If all heights are too low by the same amount, is your answer zero?",
            also=[wrong.deviations_and_all],
        ),
        Misconception(
            wrong.divided_by_one_less,
            "Nothing was fitted to these points. By how many do you divide?",
        ),
        Misconception(
            wrong.sum_not_divided,
            "Twice as many points that are as good: should the number become larger?",
        ),
        Misconception(
            wrong.divided_outside_of_the_root,
            "Is the number of points inside of the root, or outside?",
        ),
        Misconception(
            wrong.over_all_coordinates,
            "The axes are right. In space, over what is the mean: over coordinates, or points?",
        ),
        Misconception(
            wrong.mean_of_the_axes,
            "The axes are right. How long is the diagonal of a box: the mean of its edges?",
        ),
        Misconception(
            wrong.sum_of_the_axes,
            "The axes are right. How long is the diagonal of a box: the sum of its edges?",
        ),
        Misconception(
            wrong.mean_distance,
            "The axes are right. In space, is it a root of a mean of squares as well?",
        ),
        Misconception(
            wrong.horizontal_for_space,
            "The axes are right. Which axis is missing in the last number?",
        ),
        Misconception(
            wrong.axes_not_squared,
            "The axes are right. In space, what adds up: errors, or their squares?",
        ),
        Misconception(
            wrong.in_two_pieces,
            "All four are there. Are they in one array? `np.append(a, b)` sets b at the end of a.",
            also=[wrong.in_unequal_rows],
        ),
        Misconception(
            wrong.space_in_front,
            "All four are there. In which order are they asked for?",
        ),
        Misconception(
            wrong.axes_only,
            "These are three numbers. How far off is a point in space?",
        ),
        Misconception(
            wrong.space_only,
            "This is the error in space. What is it along each axis?",
            also=[wrong.all_coordinates_only],
        ),
        Misconception(
            wrong.of_each_point,
            "There is a number for each point. Over which axis of the table is the mean?",
            also=[
                wrong.distance_of_each_point,
                wrong.of_each_point_and_all,
                wrong.of_each_point_and_in_space,
            ],
        ),
        Misconception(
            wrong.rows_for_columns,
            "A row of the table is a point. How do you pick its first column, dx of all points?",
        ),
        Misconception(
            wrong.largest_errors,
            "These are the worst errors. What is a mean of squares?",
        ),
        Misconception(
            wrong.places_for_errors,
            "These are places. By how much are they off from the surveyed ones?",
        ),
    ],
)
