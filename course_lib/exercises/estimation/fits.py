"""Exercises of chapter 06 on least squares: one unknown, a line, an affine map."""

from __future__ import annotations

from course_lib import least_squares
from course_lib.exercises.estimation import fit_inputs as inputs
from course_lib.exercises.estimation import misconceptions_fits as wrong
from course_lib.judging import Exercise, Misconception, Part

SOLVE_ONE_UNKNOWN = Exercise(
    "estimation",
    least_squares.solve_one_unknown,
    parts={
        "equations that agree": Part(inputs.exact_equations, cases=1, weight=1),
        "equations with errors": Part(inputs.equations_with_errors, cases=2, weight=2),
        "negative numbers among them": Part(inputs.some_negative, cases=1, weight=1),
    },
    misconceptions=[
        Misconception(
            wrong.mean_of_the_single_answers,
            "You solve each equation by itself first. Should one with a tiny number before x count "
            "as much as the others?",
            also=[wrong.middle_of_the_single_answers],
        ),
        Misconception(
            wrong.sums_divided,
            "You add up all equations into one. What if some of a are negative?",
        ),
        Misconception(
            wrong.product_of_sums,
            "Is the product of two sums the same as the sum of the products? Try two equations.",
            also=[wrong.square_of_the_sum],
        ),
        Misconception(
            wrong.first_equation_only,
            "Only the first measurement counts for you. Which share of the others do you use?",
        ),
        Misconception(
            wrong.lengths_divided,
            "Two lengths are never negative, so your x is not either. What are you looking for: a "
            "ratio of lengths, or the bottom of a parabola?",
        ),
        Misconception(
            wrong.not_divided,
            "Suppose that all equations agree on x. Does your function give that x back?",
        ),
        Misconception(
            wrong.divided_by_the_length,
            "Multiply all equations by ten: x must stay. Does a stand as often below the fraction "
            "bar as above?",
            also=[wrong.divided_by_the_sum, wrong.divided_by_the_number],
        ),
        Misconception(
            wrong.divided_by_29,
            "You divide by the number of the example. From which numbers did it come there?",
        ),
        Misconception(
            wrong.divided_by_b,
            "Which side has the errors: a or b? And with which of them do you multiply both sides?",
        ),
        Misconception(
            wrong.upside_down,
            "If x is 5 your function says a fifth. Which of the two belongs below the bar?",
        ),
        Misconception(
            wrong.bracket_forgotten,
            "Python works from left to right. What does your last sign `@` multiply?",
        ),
        Misconception(
            wrong.an_answer_for_each_equation,
            "How many unknowns are there, and how many numbers do you return?",
            also=[wrong.products_not_added, wrong.squares_not_added],
        ),
    ],
)

FIT_LINE = Exercise(
    "estimation",
    least_squares.fit_line,
    points=5,
    parts={
        "points on a line": Part(inputs.points_on_a_line, cases=1, weight=1),
        "strain measured at rising loads": Part(inputs.strain_against_load, cases=2, weight=3),
        "loads in any order": Part(inputs.loads_in_any_order, cases=1, weight=1),
    },
    misconceptions=[
        Misconception(
            wrong.intercept_before_slope,
            "Your two numbers are right. In which order are they asked for?",
        ),
        Misconception(
            wrong.errors_in_x,
            "Your line is the best one if x has the errors. Which of the two was measured?",
        ),
        Misconception(
            wrong.x_and_y_exchanged,
            "You fit x as a function of y. Which of the two stands in the column of the design?",
        ),
        Misconception(
            wrong.across_the_line,
            "You measure the errors at a right angle to the line. In which direction does the "
            "task measure them?",
        ),
        Misconception(
            wrong.through_the_origin,
            "Your line runs through the origin. Which column of the design lets it run elsewhere?",
        ),
        Misconception(
            wrong.two_points_only,
            "Your slope comes from the two ends alone. Which say have the points between them?",
            also=[wrong.outermost_points, wrong.extremes_of_both],
        ),
        Misconception(
            wrong.first_two_points,
            "Your line meets the first two points exactly. Which say have the others?",
        ),
        Misconception(
            wrong.first_y_as_intercept,
            "Your slope is right. At which x does a line have the height of its intercept?",
        ),
        Misconception(
            wrong.mean_y_as_intercept,
            "Your slope is right. Your other number is the line's height in the middle: is x zero "
            "there?",
        ),
        Misconception(
            wrong.mean_of_slopes,
            "You average the slopes from point to point. Does a point in the middle still count?",
        ),
        Misconception(
            wrong.one_more_counted,
            "Your slope is off by a factor that depends on the number of points. By how many does "
            "`np.cov` divide, and `np.var`?",
        ),
        Misconception(
            wrong.inverse_of_a_tall_matrix,
            "NumPy finds no inverse of your matrix. Is it square, and do its columns differ? Which "
            "product of the design with itself is square?",
        ),
        Misconception(
            wrong.all_that_lstsq_returns,
            "`np.linalg.lstsq` returns four things. Which of them are slope and intercept, and how "
            "does section 2 take it out?",
            also=[wrong.lstsq_into_two_names],
        ),
        Misconception(
            wrong.slope_of_a_fit_through_the_origin,
            "Slope and intercept pull at each other. Were both unknown when you found the slope?",
        ),
    ],
)

FIT_AFFINE = Exercise(
    "estimation",
    least_squares.fit_affine,
    points=6,
    parts={
        "three points": Part(inputs.three_markers, cases=1, weight=1),
        "more points than needed": Part(inputs.exact_markers, cases=1, weight=2),
        "points with errors": Part(inputs.markers_with_errors, cases=2, weight=3),
    },
    misconceptions=[
        Misconception(
            wrong.left_transposed,
            "Your six numbers are right. Which shape should they have, and which one have yours?",
        ),
        Misconception(
            wrong.way_back,
            "Your map leads from the targets to the points. Which way was asked for?",
        ),
        Misconception(
            wrong.ones_in_front,
            "In which column of A does the task want the translation, and where is it in yours?",
        ),
        Misconception(
            wrong.two_columns_of_ones,
            "`np.ones_like` of a table is a table. How many ones does each row of the design need?",
            also=[
                wrong.two_columns_of_ones_left_transposed,
                wrong.two_columns_of_ones_in_normal_equations,
            ],
        ),
        Misconception(
            wrong.all_that_lstsq_returns_for_a_map,
            "`np.linalg.lstsq` returns four things. Which of them is the solution?",
            also=[wrong.lstsq_transposed_at_once],
        ),
        Misconception(
            wrong.first_three_points,
            "Three points would be enough. But what do the others say, when all have errors?",
        ),
        Misconception(
            wrong.inverse_of_a_table,
            "NumPy finds no inverse of your matrix. Is it square, and do its columns differ? Which "
            "product of the design with itself is square?",
        ),
        Misconception(
            wrong.no_translation,
            "Where does your map send the point (0, 0)? Must it stay there?",
            also=[wrong.column_of_zeros],
        ),
        Misconception(
            wrong.reshaped_for_transposed,
            "Your six numbers are right, in wrong places. Does `reshape` turn rows into columns?",
        ),
        Misconception(
            wrong.counted_from_the_mean,
            "The 2 × 2 part is right. Where does your map send the mean of the points, and where "
            "should it go?",
            also=[wrong.difference_of_the_means],
        ),
        Misconception(
            wrong.translation_from_the_means,
            "You found the translation after the rest. Were all six numbers free at the same time?",
        ),
        Misconception(
            wrong.rows_exchanged,
            "Which row of A makes the first coordinate of a target?",
        ),
        Misconception(
            wrong.coordinates_exchanged,
            "Your columns begin with the second coordinate of the points. Which one comes first?",
        ),
        Misconception(
            wrong.square_matrix,
            "You added a third row, which is always the same. Which shape was asked for?",
        ),
        Misconception(
            wrong.shift_and_scale_only,
            "Your map shifts and stretches along the axes. May it turn the plane as well?",
        ),
        Misconception(
            wrong.same_row_twice,
            "Both rows of your A are the same. Which targets belong to the second one?",
        ),
        Misconception(
            wrong.pseudo_inverse_without_the_last_factor,
            "That is the right side of the normal equations. Which matrix stands on their left?",
        ),
    ],
    forbidden=("cv2.estimateAffine2D", "cv2.getAffineTransform"),
)
