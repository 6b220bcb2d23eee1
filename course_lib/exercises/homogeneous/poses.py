"""Exercises of chapter 02 on placing: poses, and cameras in the world."""

from __future__ import annotations

from course_lib import transforms
from course_lib.exercises.homogeneous import pose_inputs
from course_lib.exercises.homogeneous import pose_misconceptions as wrong
from course_lib.judging import Exercise, Misconception, Part

INVERT_POSE = Exercise(
    "homogeneous",
    transforms.invert_pose,
    points=5,
    parts={
        "translations alone": Part(pose_inputs.moved_pose, weight=1),
        "rotations alone": Part(pose_inputs.turned_pose, weight=1),
        "rotation and translation": Part(pose_inputs.any_pose, weight=3),
    },
    misconceptions=[
        Misconception(
            wrong.only_R_transposed,
            "Send a point there with the pose, and back with yours. What is left over?",
        ),
        Misconception(
            wrong.R_and_t_apart,
            "The way back begins in the other frame. Do its axes point the same way?",
        ),
        Misconception(
            wrong.R_where_its_inverse_belongs,
            "Solve for X, step by step: which matrix is in front of t at the end?",
        ),
        Misconception(
            wrong.sign_left_out,
            "Try it without any rotation: you moved by t. How do you get back?",
        ),
        Misconception(
            wrong.R_kept,
            "Turn your head to the left. Which turn brings it back: the same one once more?",
        ),
        Misconception(
            wrong.matrix_of_the_way_back,
            "You return the inverse as one 4 × 4 matrix. Which two parts of it were asked for?",
        ),
        Misconception(
            wrong.R_times_t_entry_by_entry,
            "Your t is a table of nine numbers. Which of Python's two products multiplies a "
            "matrix and a vector?",
        ),
        Misconception(
            wrong.R_inverted_entry_by_entry,
            "You invert the nine numbers of R one by one. Multiply the result by R: is it the "
            "identity?",
        ),
    ],
)

CAMERA_CENTRE = Exercise(
    "homogeneous",
    transforms.camera_centre,
    parts={
        "cameras that are not turned": Part(pose_inputs.centre_of_moved_camera, weight=1),
        "cameras turned any way": Part(pose_inputs.centre_of_any_camera, weight=3),
    },
    misconceptions=[
        Misconception(
            wrong.translation_as_centre,
            "t is where the world's origin is, seen from the camera. Who is asking for whom here?",
        ),
        Misconception(
            wrong.minus_translation,
            "Seen from the camera that is right. Along whose axes are your three numbers counted?",
        ),
        Misconception(
            wrong.minus_R_t,
            "R takes the world's axes to the camera's. Which way do you need to go?",
        ),
        Misconception(
            wrong.in_front_for_behind,
            "The camera must map its own centre to zero. What does it make of your point?",
        ),
        Misconception(
            wrong.centre_entry_by_entry,
            "You get nine numbers for one place. Which of Python's two products multiplies a "
            "matrix and a vector?",
        ),
        Misconception(
            wrong.rotation_of_the_way_back,
            "The way back is a turn and a shift. What do they make of the camera's origin, and "
            "which of the two is that?",
            also=[wrong.whole_way_back],
        ),
    ],
)

POSE_FROM_PLACEMENT = Exercise(
    "homogeneous",
    transforms.pose_from_placement,
    points=5,
    parts={
        "cameras that were only moved": Part(pose_inputs.moved_camera, weight=1),
        "cameras that were only turned": Part(pose_inputs.turned_camera, weight=1),
        "cameras anywhere": Part(pose_inputs.any_camera, weight=3),
    },
    misconceptions=[
        Misconception(
            wrong.placement_as_pose,
            "You return the placement. Does it lead from the world to the camera, or back?",
        ),
        Misconception(
            wrong.centre_as_translation,
            "The camera's own centre must become zero. What does your pose make of it?",
        ),
        Misconception(
            wrong.only_the_sign_changed,
            "t is counted along the camera's axes. Along which axes is the centre given?",
        ),
        Misconception(
            wrong.R_camera_for_R,
            "The columns of R_camera are the camera's axes in the world. "
            "Does your R take such an axis to (0, 0, 1)?",
        ),
        Misconception(
            wrong.R_camera_on_the_centre,
            "Your rotation is right. Is it also the one that you used for t?",
        ),
        Misconception(
            wrong.t_entry_by_entry,
            "Your t is a table of nine numbers. Which of Python's two products multiplies a "
            "matrix and a vector?",
        ),
        Misconception(
            wrong.matrix_of_the_pose,
            "You return the pose as one 4 × 4 matrix. Which two parts of it were asked for?",
        ),
    ],
)

CV_FROM_GRAPHICS_CAMERA = Exercise(
    "homogeneous",
    transforms.cv_from_graphics_camera,
    points=5,
    parts={
        "graphics cameras that were only moved": Part(
            pose_inputs.graphics_camera_at_rest, weight=2
        ),
        "graphics cameras anywhere": Part(pose_inputs.any_graphics_camera, weight=3),
    },
    misconceptions=[
        Misconception(
            wrong.axes_left_as_they_are,
            "What the graphics camera looks at has negative z there. Which depth do you give it?",
        ),
        Misconception(
            wrong.only_z_turned_round,
            "Which sign has the determinant of your R? Can you hold a camera like that?",
            also=[
                wrong.only_y_turned_round,
                wrong.all_axes_turned_round,
                wrong.y_and_z_exchanged,
            ],
        ),
        Misconception(
            wrong.turned_about_y,
            "Your camera looks the right way, on its head. About which axis must it turn?",
        ),
        Misconception(
            wrong.turned_in_the_world,
            "It is the camera's axes that get other names. Do you turn the camera, or the world?",
        ),
        Misconception(
            wrong.not_inverted,
            "Your camera has the right axes. Does your pose lead from the world to the camera?",
        ),
        Misconception(
            wrong.translation_not_turned,
            "Your R is right. Where does your pose send the camera's own centre?",
        ),
        Misconception(
            wrong.only_z_turned_round_late,
            "You turn one axis alone. Is your frame still right-handed, like every real camera?",
        ),
        Misconception(
            wrong.last_row_for_the_centre,
            "Your t does not know the place. Does the place stand in a row of the matrix or a "
            "column?",
        ),
        Misconception(
            wrong.graphics_t_entry_by_entry,
            "Your R is right, your t a table of nine numbers. Which of Python's two products "
            "multiplies a matrix and a vector?",
        ),
        Misconception(
            wrong.matrix_of_the_graphics_pose,
            "You return the pose as one 4 × 4 matrix. Which two parts of it were asked for?",
        ),
    ],
)
