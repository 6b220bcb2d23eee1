"""Exercise of chapter 05 on fisheye lenses."""

from __future__ import annotations

from course_lib.exercises.distortion import fisheye_misconceptions as wrong
from course_lib.exercises.distortion import inputs, plain
from course_lib.judging import Exercise, Misconception, Part

FISHEYE_PROJECT = Exercise(
    "distortion",
    plain.fisheye_project,
    points=5,
    parts={
        "equidistant": Part(inputs.equidistant_ahead, cases=2, weight=2.5),
        "with coefficients": Part(inputs.with_coefficients, cases=2, weight=1.5),
        "beside and behind the camera": Part(inputs.beside_and_behind, cases=2, weight=1),
    },
    forbidden=(
        "course_lib.distortion.fisheye.fisheye_project",
        "cv2.projectPoints",
        "cv2.distortPoints",
    ),
    misconceptions=[
        Misconception(
            wrong.pinhole_instead,
            "Where is a ray at a right angle from the axis imaged by your lens?",
        ),
        Misconception(
            wrong.tangent_bent,
            "The polynomial is right. Which does it multiply: the angle, or its tangent?",
        ),
        Misconception(
            wrong.polynomial_of_the_tangent,
            "Your polynomial takes the tangent. What does that of a fisheye lens take?",
        ),
        Misconception(
            wrong.polynomial_of_the_distance,
            "Your polynomial takes the distance from the axis. What does that of a lens take?",
        ),
        Misconception(
            wrong.sine_of_the_angle,
            "Equidistant: equal steps of the angle, equal steps in the image. Is yours like that?",
        ),
        Misconception(
            wrong.angle_in_degrees,
            "In which unit does the formula count the angle?",
        ),
        Misconception(
            wrong.nothing_behind,
            "For a point behind the camera, is the angle more or less than a right one? And yours?",
            also=[wrong.by_the_arcsine],
        ),
        Misconception(
            wrong.each_axis_alone,
            "There is one angle for each point: between which two directions?",
            also=[wrong.turn_about_the_axis],
        ),
        Misconception(
            wrong.direction_not_unit,
            "Move a point twice as far away along its ray. Should its image move?",
        ),
        Misconception(
            wrong.direction_from_tangents,
            "The direction in the image is a pair of length 1. Which length has yours?",
            also=[wrong.direction_in_space],
        ),
        Misconception(
            wrong.coefficients_left_out,
            "For the equidistant lens you are right. Which argument have you not used?",
        ),
        Misconception(
            wrong.all_powers_of_the_angle,
            "By how much do the powers of the angle grow from one coefficient to the next?",
            also=[wrong.powers_one_by_one],
        ),
        Misconception(
            wrong.centre_left_out,
            "Where should a ray almost along the axis be imaged, and where is it in your answer?",
        ),
        Misconception(
            wrong.one_focal_length,
            "The columns are right. Which focal length belongs to the rows?",
        ),
        Misconception(
            wrong.sides_exchanged_in_the_angle,
            "From where do you measure the angle: from the axis, or from the plane across it?",
        ),
        Misconception(
            wrong.angle_left_out,
            "With all coefficients zero, which distance has your image from the centre: the angle?",
        ),
        Misconception(
            wrong.left_in_focal_lengths,
            "Your answer is in focal lengths. What makes pixels of it?",
        ),
        Misconception(
            wrong.angle_counted_twice,
            "The angle stands before the brackets. Which powers are then left inside?",
        ),
        Misconception(
            wrong.distance_from_the_camera,
            "How far is a point from the axis: does its Z count, too?",
        ),
        Misconception(
            wrong.root_left_out,
            "How far is a point from the axis: did you take the root?",
            also=[wrong.root_left_out_in_the_direction, wrong.root_left_out_everywhere],
        ),
    ],
)
