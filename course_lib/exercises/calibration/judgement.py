"""Exercises of chapter 07 on judging a calibration: views to reject, covariance, a question."""

from __future__ import annotations

from course_lib.exercises.calibration import inputs
from course_lib.exercises.calibration import judgement_misconceptions as wrong
from course_lib.exercises.calibration import plain_refinement as plain
from course_lib.judging import Exercise, Explain, Misconception, Part, YesOrNo
from course_lib.judging.matching import SameShape

REJECT_VIEWS = Exercise(
    "calibration",
    plain.reject_views,
    points=5,
    compare=YesOrNo(),
    parts={
        "one very bad view": Part(inputs.one_bad_view, weight=3),
        "another limit": Part(inputs.another_limit, weight=2),
    },
    forbidden=("course_lib.calibration.judgement.reject_views",),
    misconceptions=[
        Misconception(
            wrong.those_to_reject,
            "Which views do you mark with True: those that stay, or those that go?",
        ),
        Misconception(
            wrong.mean_for_median,
            "A very bad view is among them. What does it do to the value that you compare with?",
            also=[wrong.mean_and_deviation],
        ),
        Misconception(
            wrong.limit_in_pixels,
            "Is the limit a number of pixels, or how many times larger than usual?",
        ),
        Misconception(
            wrong.compared_with_the_best,
            "Is the best view the usual one?",
        ),
        Misconception(
            wrong.above_the_median,
            "Half of all views are above the median, always. Where does the limit come in?",
        ),
        Misconception(
            wrong.mean_length,
            "One corner that slipped far away: does your error of a view notice it as much as an "
            "RMS does?",
        ),
        Misconception(
            wrong.worst_corner,
            "You look at the worst corner of each view. What of the others: is an RMS one corner?",
        ),
        Misconception(
            wrong.median_of_residuals,
            "You take the median of du and dv, of either sign. Of which numbers should it be?",
        ),
        Misconception(
            wrong.numbers_of_the_views,
            "This is not a yes or no for each view. What does a comparison give, before you pick "
            "with it?",
            also=[
                wrong.places_from_where,
                wrong.numbers_of_those_that_go,
                wrong.residuals_that_stay,
            ],
        ),
        Misconception(
            wrong.one_error_for_all,
            "`rms_error` takes one view. Handed the whole stack, it gives one number. How many "
            "errors do you need, and how do you get them from it one by one?",
        ),
        Misconception(
            wrong.each_against_itself,
            "You keep every view. Should the median be that of all views, or of a single one?",
        ),
        Misconception(
            wrong.squares_compared,
            "Is it errors that you compare, or their squares? Where is the root?",
        ),
        Misconception(
            wrong.each_point,
            "Print the shape of your errors. How many should each view have?",
            also=[wrong.point_by_point_over_views, wrong.u_and_v_of_each_view],
        ),
    ],
)

PARAMETER_COVARIANCE = Exercise(
    "calibration",
    plain.parameter_covariance,
    points=6,
    parts={
        "two parameters": Part(inputs.small_fit, weight=3),
        "five parameters of different size": Part(inputs.larger_fit, weight=3),
    },
    forbidden=("course_lib.least_squares.linear.parameter_covariance",),
    misconceptions=[
        Misconception(
            wrong.divided_by_all,
            "With as many parameters as residuals all are zero. What should be divided by then?",
            also=[wrong.divided_by_all_but_one, wrong.variance_of_numpy],
        ),
        Misconception(
            wrong.not_squared,
            "Residuals of opposite sign: do they cancel in your sum?",
            also=[wrong.sum_squared],
        ),
        Misconception(
            wrong.divided_by_points,
            "You count points. How many residuals does a point give?",
            also=[wrong.points_without_parameters],
        ),
        Misconception(
            wrong.residuals_left_out,
            "Suppose the corners were found twice as badly. Does your answer notice?",
        ),
        Misconception(
            wrong.deviation_for_variance,
            "You multiply with a standard deviation. Which unit should a covariance of px have?",
        ),
        Misconception(
            wrong.not_inverted,
            "The more strongly a parameter moves the pixels, the better it is known. Is it so in "
            "yours?",
        ),
        Misconception(
            wrong.roots_of_the_diagonal,
            "These are standard deviations. Which matrix did you take them from?",
        ),
        Misconception(
            wrong.variances_only,
            "The variances are right. Where have the other entries of the matrix gone?",
            also=[wrong.variances_in_a_row],
        ),
        Misconception(
            wrong.diagonal_inverted_only,
            "You took each parameter alone. Do f and the distance of the board not act alike?",
        ),
        Misconception(
            wrong.inverted_entry_by_entry,
            "You turn each entry over by itself. Which function of NumPy inverts a whole matrix?",
        ),
        Misconception(
            wrong.rows_for_parameters,
            "Your divisor is zero. Does J have a row for each parameter, or a column?",
        ),
        Misconception(
            wrong.more_parameters_than_residuals,
            "Your variances are negative. Which are more: the residuals, or the parameters?",
        ),
        Misconception(
            wrong.residuals_for_parameters,
            "Your table has a row for each residual. Which product with J has one for each "
            "parameter?",
            compare=SameShape(),
        ),
    ],
)

EXPLAIN_SMALL_RMS = Explain(
    "calibration",
    "explain_small_rms",
    rubric=[
        (1, "Says that the RMS only tells how well the model fits these pictures."),
        (1, "Says that parallel boards, or boards in the middle, leave parameters undetermined."),
        (1, "Names how to see it: large sigma, coverage, or the error on held-out pictures."),
        (1, "Says what to photograph: tilted boards in several directions, out to the corners."),
    ],
    model_answer=(
        "The RMS says how well the camera explains the corners it was calibrated with. Boards that "
        "all face the camera say the same again and again: a longer focal length and a larger "
        "distance give nearly the same pictures, so f can be far off while the RMS stays small. "
        "And where no corner was, as in the corners of the picture, the distortion is only "
        "extrapolated. One sees it in the standard deviations, in the coverage of the picture, and "
        "in the error on pictures that were kept out. Better: ten pictures with the board tilted "
        "by 20 to 45 degrees in different directions, near and far, out to the corners."
    ),
)
