"""Exercise of chapter 05 on the full model: a fraction, tangential terms, a thin prism."""

from __future__ import annotations

from course_lib.exercises.distortion import full_model_misconceptions as wrong
from course_lib.exercises.distortion import inputs, plain
from course_lib.exercises.distortion.models import FULL_MODEL
from course_lib.judging import Exercise, Misconception, Part

DISTORT_RATIONAL_PRISM = Exercise(
    "distortion",
    plain.distort_rational_prism,
    points=5,
    parts={
        "the fraction alone": Part(inputs.fraction_alone, cases=2, weight=2),
        "the prism alone": Part(inputs.prism_alone, cases=2, weight=2),
        "all twelve": Part(inputs.all_twelve, cases=2, weight=1),
    },
    forbidden=(*FULL_MODEL, "course_lib.distortion.model.distort_rational_prism"),
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
            also=[wrong.opencv_places, wrong.opencv_kept_place],
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
            "Which two of the four prism coefficients move x, and which two y?",
            also=[wrong.prism_pairs_exchanged, wrong.prism_same_for_both],
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
        Misconception(
            wrong.fraction_without_brackets,
            "Python divides before it adds. What belongs below the fraction bar, and how does "
            "Python see it?",
        ),
        Misconception(
            wrong.below_left_out,
            "Three of the six radial coefficients change nothing in your answer. Which?",
        ),
        Misconception(
            wrong.prism_square_taken_twice,
            "Your r2 is a square already. Which power of it belongs to s2?",
        ),
        Misconception(
            wrong.prism_of_one_coordinate,
            "Does the prism ask for the distance of a point, or for one coordinate?",
        ),
        Misconception(
            wrong.tangential_left_out_of_twelve,
            "Two of the twelve coefficients change nothing in your answer. Which?",
        ),
    ],
)
