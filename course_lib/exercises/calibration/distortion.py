"""Exercise of chapter 07 on the first k1 and k2."""

from __future__ import annotations

from course_lib.exercises.calibration import distortion_misconceptions as bent
from course_lib.exercises.calibration import inputs
from course_lib.exercises.calibration import plain_refinement as plain
from course_lib.judging import Exercise, Misconception, Part

INITIAL_DISTORTION = Exercise(
    "calibration",
    plain.initial_distortion,
    points=8,
    parts={
        "exact points": Part(inputs.exactly_bent, weight=5),
        "points with noise": Part(inputs.bent_with_noise, weight=3),
    },
    forbidden=("course_lib.calibration.zhang.initial_distortion",),
    misconceptions=[
        Misconception(
            bent.correction_for_distortion,
            "For a barrel lens k1 is negative. Do you go from the ideal point to the observed one?",
        ),
        Misconception(
            bent.powers_of_r,
            "Which powers of r do k1 and k2 belong to?",
            also=[bent.powers_squared, bent.powers_two_and_three],
        ),
        Misconception(
            bent.doubled_for_squared,
            "Your second column is twice the first. Is the fourth power of r twice its square?",
        ),
        Misconception(
            bent.powers_alone,
            "A point at the principal point does not move, whatever k1 is. Which factor before "
            "the powers of r sees to that?",
            also=[bent.pixels_for_offsets],
        ),
        Misconception(
            bent.k2_before_k1,
            "Both numbers are there. Which column of your matrix belongs to the first unknown?",
        ),
        Misconception(
            bent.fx_for_both,
            "x is divided by fx. By which focal length is y divided?",
        ),
        Misconception(
            bent.observed_for_moved,
            "Your right side holds pixels of the picture. How far did the lens move each of them?",
        ),
        Misconception(
            bent.radius_in_pixels,
            "Your coefficients are tiny. In which coordinates is r measured?",
        ),
        Misconception(
            bent.not_from_the_principal_point,
            "From which point does the lens move the others away, and are distances from there?",
        ),
        Misconception(
            bent.normalised_on_one_side,
            "On one side of your equations are pixels. In which unit is the other side?",
            also=[bent.normalised_on_the_other_side],
        ),
        Misconception(
            bent.equations_of_u_only,
            "Without noise it is right. Are the equations of v in your system, too?",
        ),
        Misconception(
            bent.radius_of_the_observed,
            "Nearly right. Is r the distance of the ideal point, or of the observed one?",
            also=[bent.everything_from_the_observed],
        ),
        Misconception(
            bent.right_side_point_by_point,
            "One side of your system has u, v of a point, then the next point. In which order is "
            "the other side?",
            also=[bent.left_side_point_by_point],
        ),
        Misconception(
            bent.four_columns,
            "How many unknowns has your system? Do the equations of v need columns of their own?",
        ),
        Misconception(
            bent.all_that_lstsq_gives,
            "NumPy's `lstsq` gives four things at once. Which of them is the solution?",
        ),
        Misconception(
            bent.normalised_on_both_sides,
            "Without noise it is right. In which unit are the misses that the text makes small?",
        ),
        Misconception(
            bent.k1_only,
            "Your k2 is zero. How many unknowns does the system have?",
        ),
    ],
)
