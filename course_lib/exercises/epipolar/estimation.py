"""Exercises of chapter 08 on F from eight pairs, errors of pairs, and how many samples it takes."""

from __future__ import annotations

from course_lib.exercises.epipolar import error_misconceptions as slips
from course_lib.exercises.epipolar import estimation_misconceptions as wrong
from course_lib.exercises.epipolar import inputs, pair_inputs
from course_lib.exercises.epipolar import plain_estimation as plain
from course_lib.exercises.epipolar.comparison import PixelMatrix
from course_lib.judging import Exercise, Misconception, Part

EIGHT_POINT = Exercise(
    "epipolar",
    plain.eight_point,
    points=8,
    compare=PixelMatrix(),
    parts={
        "exact pairs": Part(pair_inputs.exact_pairs, cases=1, weight=4),
        "pairs with noise": Part(pair_inputs.pairs_with_noise, cases=1, weight=4),
    },
    forbidden=(
        "course_lib.epipolar.fundamental.eight_point",
        "cv2.findFundamentalMat",
    ),
    misconceptions=[
        Misconception(
            wrong.pictures_swapped,
            "Yours fits if the pictures change places. Which point stands on the left of F?",
        ),
        Misconception(
            wrong.laid_out_by_columns,
            "Which entry of F does the second product of your row belong to: the one beside, or "
            "below?",
        ),
        Misconception(
            wrong.rank_left_out,
            "Without noise it is right. Do all lines of your F meet in one point when there is "
            "noise?",
        ),
        Misconception(
            wrong.rank_made_in_pixels,
            "Without noise it is right. Which comes first: rank 2, or the way back to pixels?",
        ),
        Misconception(
            wrong.rank_one,
            "How many singular values are left in your F, and how many should be?",
        ),
        Misconception(
            wrong.largest_made_zero,
            "Which singular value should be nearly zero: the first, or the last?",
        ),
        Misconception(
            wrong.put_together_with_the_transpose,
            "NumPy gives the last factor of the SVD transposed already. What do you multiply with?",
        ),
        Misconception(
            wrong.singular_values_not_a_matrix,
            "Between U and Vt stands a matrix. Which shape has the s of NumPy?",
        ),
        Misconception(
            wrong.not_normalised,
            "Without noise it is right. How large are the products of two pixels, beside the 1?",
            also=[wrong.neither_normalised_nor_rank_two],
        ),
        Misconception(
            wrong.normalised_alike,
            "Without noise it is right. Both pictures have one T here. Whose points should each "
            "be made of?",
            also=[wrong.normalised_together, wrong.normalised_alike_by_picture_2],
        ),
        Misconception(
            wrong.left_normalised,
            "Put two pixels into your F. Which points does it belong to?",
            also=[wrong.left_normalised_with_rank_three],
        ),
        Misconception(
            wrong.back_as_a_homography,
            "That is the way back of a homography. F has a point on both sides: what becomes of "
            "x2ᵀ F x1?",
            also=[wrong.back_inverted],
        ),
        Misconception(
            wrong.back_not_transposed,
            "x2 stands on the left of F, lying down. What does that do to its T?",
        ),
        Misconception(
            wrong.back_with_the_other_T,
            "On which side of F are the points of picture 1, and on which side is their T?",
        ),
        Misconception(
            wrong.back_with_one_T,
            "Each picture has a T of its own. How many do you use?",
        ),
        Misconception(
            wrong.pixels_in_the_equations,
            "You go back from normalised points. Which points are in your equations?",
        ),
        Misconception(
            wrong.last_number_fixed,
            "Without noise it is right. You make the last number of F 1. Which length should be 1?",
        ),
        Misconception(
            wrong.entries_multiplied,
            "Which sign multiplies matrices, and which one entry by entry?",
            also=[wrong.entries_multiplied_on_the_way_back],
        ),
        Misconception(
            wrong.first_vector,
            "Which singular vector makes A f shortest: that of the largest value, or the smallest?",
        ),
        Misconception(
            wrong.last_column,
            "NumPy gives the last factor of the SVD transposed. Are its vectors rows or columns?",
        ),
    ],
)

SAMPSON_ERROR = Exercise(
    "epipolar",
    plain.sampson_error,
    points=6,
    parts={
        "whole numbers": Part(inputs.small_errors, cases=2, weight=3),
        "pixels of two pictures": Part(inputs.errors_of_pixels, cases=1, weight=3),
    },
    forbidden=("course_lib.epipolar.lines.sampson_error", "cv2.sampsonDistance"),
    misconceptions=[
        Misconception(
            slips.squared,
            "In which unit is your answer: px, or px squared?",
        ),
        Misconception(
            slips.not_divided,
            "Multiply F by ten: it is as good as before. Does your error stay the same?",
            also=[slips.not_divided_with_sign],
        ),
        Misconception(
            slips.sign_kept,
            "A pair can miss on either side. Can an error be negative?",
        ),
        Misconception(
            slips.picture_2_only,
            "You measure in one picture only. Which line is there in the other one?",
            also=[slips.picture_1_only],
        ),
        Misconception(
            slips.both_distances_together,
            "You measure each distance as if the other point stayed. Can both share the way?",
            also=[slips.both_distances_added, slips.both_distances_averaged],
        ),
        Misconception(
            slips.symmetric_distance,
            "This is the symmetric distance. How many fractions are in the Sampson error, and what "
            "stands below its root?",
        ),
        Misconception(
            slips.scaled_lines,
            "Your lines have normals of length 1. Are the lengths of F x1 and Fᵀ x2 still in it?",
            also=[slips.scaled_lines_below_only],
        ),
        Misconception(
            slips.lengths_added,
            "You add two lengths. How do the sides of a right triangle add up?",
        ),
        Misconception(
            slips.F_transposed,
            "Points are rows here. Which of the two products makes F of x1, and which its "
            "transpose of x2?",
        ),
        Misconception(
            slips.second_line_by_F_too,
            "Each picture has its line. Does F, untransposed, lead to both pictures?",
        ),
        Misconception(
            slips.first_line_by_the_transpose_too,
            "Each picture has its line. Does the transpose of F lead to both pictures?",
        ),
        Misconception(
            slips.all_three_numbers,
            "Six squares stand below your bar. Which numbers of a line are its normal?",
        ),
        Misconception(
            slips.root_left_out,
            "Make F ten times larger: does your error stay the same? What is done to the sum?",
        ),
        Misconception(
            slips.numbers_not_squared,
            "Below the bar, two numbers of opposite sign cancel out in yours. Should they?",
        ),
        Misconception(
            slips.every_point_with_every_other,
            "You have each point with each line. Which of these belong together?",
        ),
        Misconception(
            slips.in_a_column,
            "Your errors stand below each other in a table. How many axes has a list?",
        ),
        Misconception(
            slips.added_up,
            "One number comes out. How many pairs are there, and how many errors?",
            also=[slips.averaged],
        ),
    ],
)

RANSAC_ITERATIONS = Exercise(
    "epipolar",
    plain.ransac_iterations,
    points=4,
    parts={
        "the classic example": Part(pair_inputs.published_case, cases=1, weight=1),
        "other cases": Part(pair_inputs.other_cases, weight=3),
    },
    forbidden=("course_lib.epipolar.search.ransac_iterations",),
    misconceptions=[
        Misconception(
            slips.not_rounded,
            "How many samples can you draw: is a part of one any use?",
        ),
        Misconception(
            slips.rounded_down,
            "Is one sample fewer enough for the confidence that is asked for?",
            also=[slips.rounded_to_the_nearest],
        ),
        Misconception(
            slips.all_wrong_for_all_right,
            "You take the chance that all pairs of a sample are slips. Which samples are good?",
        ),
        Misconception(
            slips.one_pair_for_a_sample,
            "How likely is it that all pairs of a sample are right, and not only the first?",
            also=[slips.divided_by_the_size, slips.times_the_size],
        ),
        Misconception(
            slips.confidence_for_its_rest,
            "Which chance shall all bad samples together have: the confidence, or what is left?",
        ),
        Misconception(
            slips.logarithm_of_the_quotient,
            "Below zero? The logarithm of a quotient is not the quotient of two logarithms: which "
            "one does the formula ask for?",
            also=[slips.logarithm_of_the_quotient_not_rounded],
        ),
        Misconception(
            slips.good_for_bad_samples,
            "Samples go on as long as they are bad. How likely is a bad one?",
        ),
        Misconception(
            slips.upside_down,
            "So few? Which logarithm is below the bar, are there two, and is a sample good as soon "
            "as one pair of it is right?",
            also=[slips.logarithms_left_out, slips.not_all_wrong],
        ),
        Misconception(
            slips.one_on_average,
            "So many bring one good sample on average. Where does the confidence come in?",
        ),
        Misconception(
            slips.one_more,
            "Is the number before your last step not enough yet?",
        ),
    ],
)
