"""Exercise of chapter 10 on absolute orientation: the similarity of a model and the world."""

from __future__ import annotations

from course_lib.exercises.bundle import similarity_inputs as inputs
from course_lib.exercises.bundle import similarity_misconceptions as wrong
from course_lib.exercises.bundle import similarity_plain as plain
from course_lib.judging import Exercise, Misconception, Part

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
            wrong.rotation_before_the_test,
            "Your U and S have changed their sign. Is R made of them after that, or before?",
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
            wrong.column_of_R_turned,
            "You turn a column of R. In which of the factors are the directions sorted by S?",
            also=[wrong.column_of_R_turned_but_not_S],
        ),
        Misconception(
            wrong.product_of_all_points,
            "M has three rows and three columns. Print the shape of yours: what is summed up?",
            also=[wrong.star_for_matrix_product],
        ),
        Misconception(
            wrong.mean_of_S,
            "Is it the mean of the three numbers S that is asked for, or their sum?",
        ),
        Misconception(
            wrong.mean_of_the_ratios,
            "Without errors it is right. Does your scale come from lengths alone, without S?",
            also=[wrong.ratio_of_the_mean_lengths, wrong.scale_of_the_spreads],
        ),
        Misconception(
            wrong.scale_from_one_distance,
            "Without errors it is right. How many points take part in your scale?",
            also=[wrong.scale_from_the_last_distance],
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
            also=[wrong.means_left_on_unguarded, wrong.means_left_on_M],
        ),
        Misconception(
            wrong.mean_of_all_numbers,
            "`mean()` without an axis is a single number. How many has the middle of points?",
            also=[wrong.mean_of_all_numbers_in_M, wrong.mean_of_all_numbers_turned],
        ),
        Misconception(
            wrong.move_of_one_point,
            "Without errors it is right. Should the errors of a single point tell the move?",
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
