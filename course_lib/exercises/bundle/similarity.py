"""Exercises of chapter 10 on a circle of pictures, absolute orientation and check points."""

from __future__ import annotations

from course_lib.exercises.bundle import control_misconceptions as control
from course_lib.exercises.bundle import similarity_inputs as inputs
from course_lib.exercises.bundle import similarity_misconceptions as wrong
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
            control.rounded_down,
            "Right where the steps fill the circle. With so few pictures, how large is a step "
            "where they do not?",
            also=[control.rounded_down_without_care],
        ),
        Misconception(
            control.rounded_to_the_nearest,
            "Right for a large rest. If 36.2 pictures are needed, are 36 enough?",
        ),
        Misconception(
            control.not_rounded,
            "Is 51.4 a number of pictures? To which side must it be rounded?",
        ),
        Misconception(
            control.degrees_of_a_circle,
            "The step is in radians. How large is a whole circle in that unit?",
        ),
        Misconception(
            control.degrees_for_radians,
            "The step is in radians already. Do you make it even smaller?",
        ),
        Misconception(
            control.half_a_circle,
            "You have half of the pictures. How many radians has a whole circle?",
        ),
        Misconception(
            control.one_more,
            "The last picture of a circle has the first as its neighbour. Do you count it twice?",
        ),
        Misconception(
            control.down_and_one_more,
            "With a rest it is right. What if the steps fill the circle?",
        ),
        Misconception(
            control.one_less,
            "On a line there is one gap less than points. Is it so on a circle?",
        ),
        Misconception(
            control.rounding_asks_for_one_more,
            "What becomes of 83.00000000000001 when it is rounded up, and is so small a rest real?",
        ),
        Misconception(
            control.upside_down,
            "Do you count how many circles go into a step, or how many steps go into a circle?",
        ),
    ],
)

SIMILARITY_TRANSFORM = Exercise(
    "bundle",
    plain.similarity_transform,
    points=9,
    parts={
        "without errors": Part(inputs.exact_targets, cases=1, weight=3),
        "with errors": Part(inputs.targets_with_errors, cases=1, weight=3),
        "nearly flat ground": Part(inputs.nearly_flat, cases=1, weight=3),
    },
    forbidden=("course_lib.similarity.similarity_transform",),
    misconceptions=[
        Misconception(
            wrong.reflection_returned,
            "What is the determinant of your R on flat ground? A left hand should not become a "
            "right one.",
        ),
        Misconception(
            wrong.scale_of_the_reflection,
            "Your R is right. On flat ground, which number of S changes its sign with the column "
            "of U?",
        ),
        Misconception(
            wrong.whole_matrix_turned,
            "Changing all signs of R turns the model upside down. Which direction is known worst?",
        ),
        Misconception(
            wrong.first_column_turned,
            "You turn the best-known direction. Which number of S is the smallest?",
        ),
        Misconception(
            wrong.row_of_U_turned,
            "You change a row of U. Is its third direction a row or a column?",
        ),
        Misconception(
            wrong.scale_from_one_distance,
            "Without errors it is right. How many points take part in your scale?",
            also=[wrong.scale_from_the_last_distance],
        ),
        Misconception(
            wrong.scale_of_the_spreads,
            "Without errors it is right. Errors make the targets' spread larger: does your scale "
            "grow with them?",
        ),
        Misconception(
            wrong.divided_by_the_targets,
            "The scale leads from the model to the world. The lengths of which points are below?",
        ),
        Misconception(
            wrong.scale_upside_down,
            "Is a length of the world your scale times one of the model, or the other way round?",
        ),
        Misconception(
            wrong.mean_of_the_lengths,
            "S holds sums over all points. Is the number that you divide by a sum, too?",
            also=[wrong.mean_of_all_coordinates],
        ),
        Misconception(
            wrong.lengths_not_squared,
            "S holds products of two lengths. What do you divide by: lengths, or their squares?",
            also=[wrong.root_of_the_squares],
        ),
        Misconception(
            wrong.scale_left_out,
            "Your scale is 1. Are lengths in the world those of the model?",
        ),
        Misconception(
            wrong.world_to_model,
            "You bring the targets to the points. Which way is asked for?",
        ),
        Misconception(
            wrong.M_transposed,
            "Your R turns the world back to the model. In which order are x' and y' in M?",
        ),
        Misconception(
            wrong.last_factor_transposed,
            "NumPy's SVD gives its last factor transposed already. What do you multiply U with?",
            also=[wrong.last_factor_transposed_unguarded],
        ),
        Misconception(
            wrong.means_left_on,
            "Points far from zero: are their products about how they lie to each other?",
            also=[wrong.means_left_on_unguarded],
        ),
        Misconception(
            wrong.mean_of_all_numbers,
            "Your mean is a single number. How many has the middle of points in space?",
        ),
        Misconception(
            wrong.move_without_turn,
            "Put the mean of the points into your answer. Is the turn in it, too?",
        ),
        Misconception(
            wrong.move_without_scale,
            "Put the mean of the points into your answer. Is the scale in it, too?",
        ),
        Misconception(
            wrong.move_between_the_means,
            "Your t leads from mean to mean. But are the points not turned and scaled first?",
        ),
        Misconception(
            wrong.move_turned_from_the_right,
            "A single vector on the left of R: is it turned, or turned back?",
        ),
        Misconception(
            wrong.move_the_other_way,
            "Scale and turn are right. Which mean is subtracted from the other?",
        ),
        Misconception(
            wrong.in_another_order,
            "All three are there. In which order are they asked for?",
        ),
        Misconception(
            wrong.scale_at_the_end_of_R,
            "Multiply your R by its transpose: is that the identity?",
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
            control.mean_of_sizes,
            "This is a mean of sizes. Where are the squares and the root of an RMSE?",
        ),
        Misconception(
            control.mean_of_differences,
            "Errors of opposite sign: do they cancel in your mean?",
        ),
        Misconception(
            control.root_left_out,
            "Your answer is in squared metres. What is missing at the end?",
        ),
        Misconception(
            control.deviations_from_the_mean,
            "If all heights are too low by the same amount, is your answer zero?",
        ),
        Misconception(
            control.divided_by_one_less,
            "Nothing was fitted to these points. By how many do you divide?",
        ),
        Misconception(
            control.sum_not_divided,
            "Twice as many points that are as good: should the number become larger?",
        ),
        Misconception(
            control.divided_outside_of_the_root,
            "Is the number of points inside of the root, or outside?",
        ),
        Misconception(
            control.over_all_coordinates,
            "The axes are right. In space, over what is the mean: over coordinates, or points?",
        ),
        Misconception(
            control.mean_of_the_axes,
            "The axes are right. How long is the diagonal of a box: the mean of its edges?",
        ),
        Misconception(
            control.sum_of_the_axes,
            "The axes are right. How long is the diagonal of a box: the sum of its edges?",
        ),
        Misconception(
            control.mean_distance,
            "The axes are right. In space, is it a root of a mean of squares as well?",
        ),
        Misconception(
            control.horizontal_for_space,
            "The axes are right. Which axis is missing in the last number?",
        ),
        Misconception(
            control.axes_only,
            "These are three numbers. How far off is a point in space?",
        ),
        Misconception(
            control.space_only,
            "This is the error in space. What is it along each axis?",
            also=[control.all_coordinates_only],
        ),
        Misconception(
            control.of_each_point,
            "There is a number for each point. Over which axis of the table is the mean?",
            also=[control.distance_of_each_point],
        ),
        Misconception(
            control.largest_errors,
            "These are the worst errors. What is a mean of squares?",
        ),
        Misconception(
            control.places_for_errors,
            "These are places. By how much are they off from the surveyed ones?",
        ),
    ],
)
