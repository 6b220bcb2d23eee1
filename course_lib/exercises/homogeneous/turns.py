"""Exercises of chapter 02 on turning: about an axis, and on a gimbal."""

from __future__ import annotations

from course_lib import transforms
from course_lib.exercises.homogeneous import inputs, pose_inputs
from course_lib.exercises.homogeneous import turn_misconceptions as wrong
from course_lib.judging import Exercise, Misconception, Part, RotationClose

ROTATION_ABOUT_AXIS = Exercise(
    "homogeneous",
    transforms.rotation_about_axis,
    points=5,
    parts={
        "about x, y or z": Part(inputs.about_a_coordinate_axis, weight=1),
        "about any axis of length 1": Part(inputs.about_a_unit_axis, weight=3),
        "about an axis of another length": Part(inputs.about_a_long_axis, weight=1),
    },
    compare=RotationClose(),
    misconceptions=[
        Misconception(
            wrong.axis_not_unit,
            "The formula wants an axis of length 1. How long is the one that you put into it?",
            also=[
                wrong.axis_not_unit_in_three_terms,
                wrong.axis_not_unit_in_the_skew_matrix,
                wrong.axis_not_unit_in_the_outer_product,
                wrong.axis_divided_by_its_square,
            ],
        ),
        Misconception(
            wrong.angle_taken_for_degrees,
            "You turn by far too little. In which unit does the angle come?",
        ),
        Misconception(
            wrong.clockwise,
            "Curl the fingers of your right hand with the thumb along the axis. "
            "Do you turn that way?",
        ),
        Misconception(
            wrong.small_turns_only,
            "Is your matrix a rotation for a quarter turn? Are its columns still of length 1?",
        ),
        Misconception(
            wrong.cosine_for_its_complement,
            "With an angle of zero nothing must turn. What does your matrix do then?",
            also=[
                wrong.cosine_of_the_outer_product,
                wrong.outer_product_whole,
                wrong.skew_matrix_whole,
                wrong.sine_for_cosine,
            ],
        ),
        Misconception(
            wrong.sine_term_forgotten,
            "A quarter turn about z takes x to y. Which of your terms brings in a direction at "
            "right angles to both, and is it more than zero?",
        ),
        Misconception(
            wrong.three_turns_in_turn,
            "Three turns one after another depend on their order. "
            "Does the axis stay where it is under your matrix?",
        ),
        Misconception(
            wrong.number_for_a_matrix,
            "NumPy adds a number, or a list of three, to a whole matrix. Which of your terms is no "
            "3 × 3 matrix?",
            also=[wrong.one_outside_of_its_bracket, wrong.axis_for_its_skew_matrix],
        ),
        Misconception(
            wrong.number_for_the_outer_product,
            "How many numbers has your product of n with itself: one, three, or nine?",
            also=[wrong.three_numbers_for_the_outer_product],
        ),
    ],
    forbidden=("cv2.Rodrigues",),
)

GIMBAL_POSE = Exercise(
    "homogeneous",
    transforms.gimbal_pose,
    points=6,
    parts={
        "panned only": Part(pose_inputs.panned, weight=1),
        "tilted only": Part(pose_inputs.tilted, weight=1),
        "panned and tilted": Part(pose_inputs.panned_and_tilted, weight=2),
        "a camera off the axes": Part(pose_inputs.off_the_axes, weight=2),
    },
    misconceptions=[
        Misconception(
            wrong.tilted_first,
            "Pan a gimbal: its tilt axis goes along. Which of your two turns moves the other axis?",
        ),
        Misconception(
            wrong.offset_along_the_world,
            "When the head turns, does the camera's offset turn along?",
        ),
        Misconception(
            wrong.offset_before_the_axes,
            "Is the offset counted along the camera's axes, or along those that L begins with?",
        ),
        Misconception(
            wrong.angles_in_degrees,
            "Your camera hardly moves. In which unit do pan and tilt come?",
        ),
        Misconception(
            wrong.pans_to_the_right,
            "Seen from above, a positive pan goes which way: with the clock or against it?",
        ),
        Misconception(
            wrong.tilts_down,
            "With a positive tilt the sky should come into view. What does your camera see?",
        ),
        Misconception(
            wrong.camera_to_world,
            "You found how to get from the camera to the world. Which way does a pose lead?",
        ),
        Misconception(
            wrong.looks_up_at_rest,
            "With both angles zero the camera is level. Where does the axis of yours point?",
        ),
        Misconception(
            wrong.axes_as_rows,
            "At rest your camera looks south. Do the camera's axes stand in the rows of your L, "
            "or in its columns?",
        ),
        Misconception(
            wrong.factors_reversed,
            "A point seen by the camera meets the rightmost matrix first. Which one must that be?",
        ),
        Misconception(
            wrong.offset_forgotten,
            "Your camera sits right where the axes cross. Which of the four inputs is unused?",
        ),
        Misconception(
            wrong.mount_forgotten,
            "Carry the gimbal to another street: does your camera go along? Which input knows?",
        ),
        Misconception(
            wrong.matrix_of_the_placement,
            "You return one 4 × 4 matrix, from camera to world. Which two parts, and which "
            "direction, were asked for?",
        ),
        Misconception(
            wrong.matrix_of_the_pose,
            "You return the pose as one 4 × 4 matrix. Which two parts of it were asked for?",
        ),
    ],
)
