"""Exercises of chapter 05 on models: where a lens images what a pinhole would image elsewhere."""

from __future__ import annotations

from course_lib import distortion
from course_lib.exercises.distortion import inputs, plain
from course_lib.exercises.distortion import model_misconceptions as wrong
from course_lib.judging import Exercise, Misconception, Part

#: The library's functions that take every lens; each answers more than one exercise.
FULL_MODEL = (
    "course_lib.distortion_model.distort",
    "course_lib.distortion_pixels.distort_pixels",
    "cv2.projectPoints",
)

DISTORT_RADIAL = Exercise(
    "distortion",
    distortion.distort_radial,
    points=5,
    parts={
        "one coefficient": Part(inputs.one_coefficient, cases=2, weight=2),
        "several coefficients": Part(inputs.several_coefficients, cases=2, weight=2),
        "a single point": Part(inputs.single_point, cases=2, weight=1),
    },
    forbidden=FULL_MODEL,
    misconceptions=[
        Misconception(
            wrong.distance_not_squared,
            "Which power of the distance stands behind k1: the first, or the second?",
        ),
        Misconception(
            wrong.powers_one_by_one,
            "The first term is right. By how much do the powers grow from one term to the next?",
        ),
        Misconception(
            wrong.same_power_for_all,
            "With one coefficient you are right. Which power belongs to the second one?",
        ),
        Misconception(
            wrong.one_forgotten,
            "With all coefficients zero, where is your point? And where should it be?",
        ),
        Misconception(
            wrong.factor_alone,
            "This is the factor. What does it multiply, and which shape has the answer?",
        ),
        Misconception(
            wrong.divided,
            "You go from the distorted point towards the ideal one. Which way is asked for?",
        ),
        Misconception(
            wrong.one_radius_for_all,
            "One distance for all points together? Along which axis should `sum` add?",
        ),
        Misconception(
            wrong.each_coordinate_alone,
            "Does the point still move along the line from the centre? Is a distance made of x "
            "alone?",
        ),
        Misconception(
            wrong.first_coefficient_only,
            "How many coefficients come in, and how many do you use?",
        ),
        Misconception(
            wrong.backwards,
            "`np.polyval` begins with the highest power. With which does your list begin?",
        ),
        Misconception(
            wrong.from_the_last,
            "Which coefficient belongs to the lowest power: the first in k, or the last?",
        ),
    ],
)

DISTORT = Exercise(
    "distortion",
    plain.distort,
    points=7,
    parts={
        "radial terms alone": Part(inputs.radial_alone, cases=2, weight=2),
        "tangential terms alone": Part(inputs.tangential_alone, cases=2, weight=3),
        "all five": Part(inputs.all_five, cases=2, weight=2),
    },
    forbidden=(*FULL_MODEL, "course_lib.exercises.distortion.plain.distort_rational_prism"),
    misconceptions=[
        Misconception(
            wrong.tangential_swapped,
            "Which of p1 and p2 stands before the cross term 2 x y in x, and which in y?",
        ),
        Misconception(
            wrong.third_radial_third,
            "At which place among the five does k3 come?",
        ),
        Misconception(
            wrong.factor_two_forgotten,
            "Look at the term with x times y. Which number stands before it in the box?",
        ),
        Misconception(
            wrong.own_square_once,
            "Beside the square of the distance stands a coordinate's own square. How many times?",
        ),
        Misconception(
            wrong.own_square_forgotten,
            "The brackets behind p1 and p2 hold two squares each. Which one have you left out?",
        ),
        Misconception(
            wrong.radial_by_distance,
            "Which power of the distance stands behind k1: the first, or the second?",
        ),
        Misconception(
            wrong.tangential_left_out,
            "Two of the five coefficients change nothing in your answer. Which?",
        ),
        Misconception(
            wrong.tangential_scaled_too,
            "Does the radial factor stretch the tangential terms too, or only x and y?",
        ),
        Misconception(
            wrong.one_after_the_other,
            "Your tangential terms start from points that were moved already. From which x and y "
            "does the box start?",
        ),
        Misconception(
            wrong.x_overwritten,
            "x is right, y is not. Which x does your line for y use: the old one?",
        ),
        Misconception(
            wrong.same_aside_for_both,
            "You add the same amount to x and to y. Do p1 and p2 change places between the two "
            "lines of the box?",
        ),
        Misconception(
            wrong.displacement_only,
            "With all coefficients zero, where is your point? And where should it be?",
        ),
    ],
)

DISTORT_RATIONAL_PRISM = Exercise(
    "distortion",
    plain.distort_rational_prism,
    points=5,
    parts={
        "the fraction alone": Part(inputs.fraction_alone, cases=2, weight=2),
        "the prism alone": Part(inputs.prism_alone, cases=2, weight=2),
        "all twelve": Part(inputs.all_twelve, cases=2, weight=1),
    },
    forbidden=(*FULL_MODEL, "course_lib.distortion_model.distort_rational_prism"),
    misconceptions=[
        Misconception(
            wrong.below_multiplied,
            "If k4 is positive, should the picture get larger or smaller towards the corners?",
        ),
        Misconception(
            wrong.below_without_one,
            "With all coefficients zero, what is above the fraction bar, and what below?",
        ),
        Misconception(
            wrong.fraction_upside_down,
            "Which three of the six coefficients stand above the fraction bar?",
        ),
        Misconception(
            wrong.six_powers,
            "You go on with higher powers. On which side of the fraction bar is k4?",
        ),
        Misconception(
            wrong.opencv_order,
            "In OpenCV's list p1 and p2 stand between. In which order does k come here?",
        ),
        Misconception(
            wrong.prism_by_distance,
            "Which power of the distance does s1 multiply: the first, or the second?",
        ),
        Misconception(
            wrong.prism_same_power,
            "What is the difference between s1 and s2, if both multiply the same power?",
        ),
        Misconception(
            wrong.prism_alternating,
            "Which two of the four prism coefficients move x?",
        ),
        Misconception(
            wrong.prism_times_point,
            "A prism moves all points at one distance by the same amount. Do yours?",
        ),
        Misconception(
            wrong.all_divided,
            "Which terms does the fraction multiply: all of them, or x and y alone?",
        ),
        Misconception(
            wrong.prism_left_out,
            "Four of the twelve coefficients change nothing in your answer. Which?",
        ),
        Misconception(
            wrong.tangential_exchanged,
            "Which of p1 and p2 stands before the cross term 2 x y in x, and which in y?",
        ),
    ],
)
