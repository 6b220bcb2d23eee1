"""Exercises of chapter 09 on depth: from disparity, its uncertainty, and a question."""

from __future__ import annotations

from course_lib.exercises.triangulation import depth_misconceptions as wrong
from course_lib.exercises.triangulation import inputs, plain
from course_lib.judging import Exercise, Explain, Misconception, Part

DEPTH_FROM_DISPARITY = Exercise(
    "triangulation",
    plain.depth_from_disparity,
    points=6,
    parts={
        "the same principal point": Part(inputs.same_principal_points, cases=1, weight=2),
        "with an offset": Part(inputs.with_offset, cases=1, weight=2),
        "a negative disparity": Part(inputs.negative_disparity, cases=1, weight=1),
        "a point infinitely far away": Part(inputs.infinitely_far, cases=1, weight=0.5),
        "a wrong match": Part(inputs.wrong_match, cases=1, weight=0.5),
    },
    forbidden=("course_lib.triangulation.depth.depth_from_disparity",),
    misconceptions=[
        Misconception(
            wrong.offset_left_out,
            "Right without an offset. To what is it added?",
        ),
        Misconception(
            wrong.offset_subtracted,
            "Right without an offset. Is it added, or subtracted?",
        ),
        Misconception(
            wrong.brackets_forgotten,
            "The offset is in px. Is it added to a length, or are brackets missing?",
            also=[wrong.offset_added_to_the_depth],
        ),
        Misconception(
            wrong.depth_turned_around,
            "Your points are behind the camera. Which of u_left and u_right is the larger one?",
            also=[wrong.turned_around_with_refusal, wrong.disparity_the_other_way],
        ),
        Misconception(
            wrong.upside_down,
            "Your answer grows with the disparity. Which points are farther apart: near or far "
            "ones?",
        ),
        Misconception(
            wrong.far_is_large,
            "You multiply with the disparity. Does a point come nearer when its disparity grows?",
        ),
        Misconception(
            wrong.baseline_left_out,
            "Your depth has no unit of length. Which of the inputs has one?",
        ),
        Misconception(
            wrong.f_left_out,
            "Length divided by pixels: which other number in pixels should be there?",
        ),
        Misconception(
            wrong.metres_returned,
            "In which unit is the baseline, and in which unit should the depth be?",
        ),
        Misconception(
            wrong.nothing_refused,
            "Right where there is a depth. Which sums of disparity and offset have none, and does "
            "your question find a single one among many?",
            also=[wrong.asked_whether_any_is_small, wrong.refused_if_all],
        ),
        Misconception(
            wrong.nan_for_refused,
            "You found what has no depth. Should the function go on then, or raise an error?",
            also=[
                wrong.infinite_for_refused,
                wrong.zero_for_refused,
                wrong.left_out_for_refused,
                wrong.none_for_refused,
            ],
        ),
        Misconception(
            wrong.error_returned,
            "You found what has no depth. Is an error returned, or raised?",
            also=[wrong.kind_of_error_returned, wrong.name_of_the_error_returned],
        ),
        Misconception(
            wrong.other_error,
            "You refuse what has no depth. Which kind of error does the task name?",
        ),
        Misconception(
            wrong.sign_lost,
            "Right where there is a depth. What does a negative sum mean: is it a distance?",
        ),
        Misconception(
            wrong.zero_let_pass,
            "You refuse negative sums. What comes out if a sum is zero?",
        ),
        Misconception(
            wrong.only_zero_refused,
            "You refuse zero. Where is a point whose sum is negative?",
        ),
        Misconception(
            wrong.refused_without_offset,
            "You refuse a negative disparity. Is the disparity alone divided by?",
        ),
        Misconception(
            wrong.array_in_an_if,
            "You ask all points at once. How does NumPy say that any of them is wrong?",
        ),
    ],
)

DEPTH_UNCERTAINTY = Exercise(
    "triangulation",
    plain.depth_uncertainty,
    points=5,
    parts={
        "one depth": Part(inputs.one_depth, cases=1, weight=2),
        "many depths": Part(inputs.many_depths, cases=1, weight=3),
    },
    forbidden=("course_lib.triangulation.depth.depth_uncertainty",),
    misconceptions=[
        Misconception(
            wrong.linear_in_depth,
            "Your uncertainty doubles with the distance. Which power of d is in the derivative?",
            also=[
                wrong.linear_without_baseline,
                wrong.linear_without_f,
                wrong.linear_alone,
                wrong.twice_for_squared,
            ],
        ),
        Misconception(
            wrong.divided_by_sigma,
            "A disparity that is measured badly: does your depth become better then?",
        ),
        Misconception(
            wrong.cubed,
            "Which power of d is in the derivative, and which power of Z does it become?",
        ),
        Misconception(
            wrong.turned_over,
            "Yours shrinks with the distance. Is it Z or d that stands below in the derivative?",
            also=[wrong.turned_over_wholly],
        ),
        Misconception(
            wrong.variance,
            "This is a variance. What is its root?",
        ),
        Misconception(
            wrong.sigma_squared,
            "Twice the error in the pictures: how many times the error in depth do you get?",
        ),
        Misconception(
            wrong.sigma_left_out,
            "Suppose the disparity was measured twice as badly. Does your answer notice?",
        ),
        Misconception(
            wrong.baseline_forgotten,
            "Your answer is in squared millimetres. By which length is it divided?",
        ),
        Misconception(
            wrong.f_forgotten,
            "A longer lens sees depth more sharply. Where is that in your answer?",
        ),
        Misconception(
            wrong.times_baseline,
            "A wider baseline: does it make your depth better, or worse?",
            also=[wrong.times_both],
        ),
        Misconception(
            wrong.times_f,
            "A longer lens: does it make your depth better, or worse?",
        ),
        Misconception(
            wrong.divisor_squared,
            "How often does f b appear once d is replaced: does one of them cancel?",
        ),
        Misconception(
            wrong.sign_of_the_derivative,
            "Can a standard deviation be negative?",
        ),
        Misconception(
            wrong.two_pictures_counted,
            "You count two pictures. Is sigma that of one pixel, or already of the disparity?",
            also=[wrong.twice_counted],
        ),
        Misconception(
            wrong.sigma_put_into_the_depth,
            "You shift the disparity and look how far the depth goes. Is that the derivative?",
            also=[
                wrong.sigma_taken_off_in_the_depth,
                wrong.difference_of_both_depths,
                wrong.half_the_difference_of_both_depths,
            ],
        ),
    ],
)

EXPLAIN_TWICE_AS_FAR = Explain(
    "triangulation",
    "explain_twice_as_far",
    rubric=[
        (1, "Says that the uncertainty of depth becomes four times as large: 4 mm."),
        (
            1,
            "Gives the reason: half the disparity, so a pixel of it stands for four times as much.",
        ),
        (1, "Names a change that helps, with its size: four times the baseline or focal length."),
        (1, "Names what the change costs: less overlap and harder matching, or a smaller field."),
    ],
    model_answer=(
        "The uncertainty of depth grows with the square of the distance: four times as large, so "
        "4 mm. Twice as far away the disparity is half as large, and the same error of a fraction "
        "of a pixel is twice as large a share of a depth that is itself twice as large. To come "
        "back to 1 mm the product of focal length and baseline has to be four times as large: "
        "cameras four times as far apart, or twice as far apart with lenses twice as long. Cameras "
        "that are farther apart see less in common, and the same spot looks different in both "
        "pictures, so matching is harder. A longer lens sees a smaller field. Or measure the "
        "pixels four times as well: larger targets, or sixteen pictures and their mean."
    ),
)
