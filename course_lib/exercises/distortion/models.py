"""Exercises of chapter 05 on the first models: radial terms, and tangential ones."""

from __future__ import annotations

from course_lib import distortion
from course_lib.exercises.distortion import inputs, plain
from course_lib.exercises.distortion import model_misconceptions as wrong
from course_lib.judging import Exercise, Misconception, Part

#: The library's functions that take every lens; each answers more than one exercise.
FULL_MODEL = (
    "course_lib.distortion.model.distort",
    "course_lib.distortion.pixels.distort_pixels",
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
            also=[wrong.factor_in_a_column],
        ),
        Misconception(
            wrong.divided,
            "You go from the distorted point towards the ideal one. Which way is asked for?",
        ),
        Misconception(
            wrong.one_radius_for_all,
            "One distance for all points together? Along which axis should `sum` add?",
            also=[wrong.added_along_the_wrong_axis],
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
        Misconception(
            wrong.square_taken_twice,
            "Your r2 is a square already. Which power of it belongs to k1?",
            also=[wrong.powers_from_the_fourth],
        ),
        Misconception(
            wrong.counted_from_zero,
            "Python counts from 0. Which power of the distance does k1 get in your loop?",
        ),
        Misconception(
            wrong.last_coefficient_only,
            "Does each turn of your loop add to the factor, or begin it anew?",
        ),
        Misconception(
            wrong.factor_added,
            "Does the factor shift the point, or multiply it?",
        ),
        Misconception(
            wrong.lens_of_the_text,
            "Your answer is the same for every lens. Which argument have you not used?",
        ),
        Misconception(
            wrong.opposite_sign,
            "Negative k1 draws points in. Does your point move that way?",
        ),
        Misconception(
            wrong.rows_do_not_fit,
            "One point works, several do not. Print the shapes of `points` and of your "
            "distances: do they fit?",
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
            "You add the same number to x and to y. What differs between the two lines of the box?",
        ),
        Misconception(
            wrong.displacement_only,
            "With all coefficients zero, where is your point? And where should it be?",
        ),
        Misconception(
            wrong.y_like_x,
            "x is right, y is not. Do p1 and p2 change places between the two lines of the box?",
        ),
        Misconception(
            wrong.own_square_of_x,
            "x is right, y is not. Whose own square stands in the line for y?",
        ),
        Misconception(
            wrong.own_squares_exchanged,
            "Whose own square stands in the brackets of the line for x: its own, or that of y?",
        ),
        Misconception(
            wrong.opposite_tangential,
            "A positive p1 moves all points down: y grows. And in your answer?",
        ),
        Misconception(
            wrong.two_squared_too,
            "Python takes a power before it multiplies. Is your 2 squared too?",
        ),
        Misconception(
            wrong.own_not_squared,
            "In the brackets behind p1 and p2: a coordinate, or its square?",
        ),
        Misconception(
            wrong.third_like_the_second,
            "k2 has the fourth power of the distance. Which one has k3?",
        ),
        Misconception(
            wrong.bracket_forgotten,
            "With p1 and p2 zero, does something remain of your tangential terms? What do the "
            "brackets hold?",
            also=[wrong.bracket_forgotten_in_x],
        ),
        Misconception(
            wrong.square_taken_twice_again,
            "Your r2 is a square already. Which powers of it belong to k1, k2 and k3?",
            also=[wrong.powers_as_of_the_distance],
        ),
        Misconception(
            wrong.tangential_multiplied,
            "Are the tangential terms added to the point, or does the point multiply them?",
        ),
        Misconception(
            wrong.third_radial_left_out,
            "One of the five coefficients changes nothing in your answer. Which?",
        ),
        Misconception(
            wrong.root_in_the_brackets,
            "In the brackets behind p1 and p2: is it the distance, or its square?",
        ),
    ],
)
