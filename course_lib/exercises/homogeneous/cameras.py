"""Exercises of chapter 02 on the camera matrix: from the world to pixels, and back to rays."""

from __future__ import annotations

from course_lib import camera
from course_lib.exercises.homogeneous import camera_misconceptions as wrong
from course_lib.exercises.homogeneous import pose_inputs as inputs
from course_lib.judging import Exercise, Explain, Misconception, Part, UpToScale

CAMERA_MATRIX = Exercise(
    "homogeneous",
    camera.camera_matrix,
    points=5,
    parts={
        "a camera at the origin": Part(inputs.matrix_at_the_origin, weight=1),
        "cameras that were only moved": Part(inputs.matrix_of_a_moved_camera, weight=1),
        "cameras anywhere, with skew": Part(inputs.matrix_of_any_camera, weight=3),
    },
    compare=UpToScale(tolerance=1e-9),  # the last row is thousands of times smaller
    misconceptions=[
        Misconception(
            wrong.t_without_K,
            "Your last column is the image of the world's origin. In which unit is it?",
        ),
        Misconception(
            wrong.t_before_the_turn,
            "Is t counted along the world's axes or along the camera's?",
        ),
        Misconception(
            wrong.R_transposed,
            "Which way does the given R lead: from the world to the camera, or back?",
        ),
        Misconception(
            wrong.centre_in_the_last_column,
            "Where does your matrix send the world's origin? Compare with where t says it is.",
        ),
        Misconception(
            wrong.intrinsics_left_out,
            "Your matrix gives directions. What turns a direction into a pixel?",
        ),
        Misconception(
            wrong.K_on_the_right,
            "A point is first turned and moved, then becomes a pixel. Which matrix acts last?",
        ),
        Misconception(
            wrong.t_in_the_first_column,
            "Your first column is the image of the world's origin. In which column of P does the "
            "text expect it?",
        ),
        Misconception(
            wrong.divided_by_the_last_number,
            "You divide by the last number of P. For which camera is it zero, and does P need a "
            "scale at all?",
        ),
        Misconception(
            wrong.K_times_t_entry_by_entry,
            "Your matrix has six columns. Which of Python's two products makes a single column of "
            "K and t?",
        ),
    ],
)

PROJECT = Exercise(
    "homogeneous",
    camera.project,
    points=7,
    parts={
        "points in front of the camera": Part(inputs.points_in_front, weight=3),
        "a single point": Part(inputs.one_point, weight=1),
        "points behind the camera": Part(inputs.points_behind, weight=2),
        "a negative multiple of the matrix": Part(inputs.negative_matrix, weight=1),
    },
    misconceptions=[
        Misconception(
            wrong.not_divided,
            "P gives three numbers for a point. Which step makes two of them pixels?",
        ),
        Misconception(
            wrong.divided_by_world_Z,
            "Which depth makes things small: the one in the world or the one before the camera?",
        ),
        Misconception(
            wrong.fourth_column_unused,
            "Move the camera away: your pixels stay the same. Which column of P knows its place?",
        ),
        Misconception(
            wrong.mirrored_through_the_hole,
            "A point behind the camera got a pixel. Can its light reach the picture?",
        ),
        Misconception(
            wrong.sign_of_w_trusted,
            "P and minus P are one camera, but w changes its sign. What else changes with it?",
        ),
        Misconception(
            wrong.v_before_u,
            "Which row of P makes u, the column of the pixel?",
        ),
        Misconception(
            wrong.block_transposed,
            "Points are rows here. What must happen to a matrix that multiplies from the right?",
        ),
        Misconception(
            wrong.all_numbers_made_positive,
            "A camera matrix has negative numbers inside. Which single number tells whether the "
            "whole matrix is negated?",
        ),
        Misconception(
            wrong.size_of_w,
            "A point behind the camera got a pixel. Which sign of w says that it has none, and "
            "where does your w keep it?",
        ),
        Misconception(
            wrong.points_left_out,
            "You return fewer rows than points came in. What belongs into the row of a point "
            "without an image?",
        ),
    ],
    forbidden=("cv2.projectPoints", "cv2.perspectiveTransform"),
)

PIXEL_RAY = Exercise(
    "homogeneous",
    camera.pixel_ray,
    points=6,
    parts={
        "a camera at the origin": Part(inputs.rays_from_the_origin, weight=2),
        "cameras anywhere": Part(inputs.rays_of_pixels, weight=2),
        "a single pixel": Part(inputs.ray_of_one_pixel, weight=1),
        "pixel axes with skew": Part(inputs.rays_with_skew, weight=1),
    },
    misconceptions=[
        Misconception(
            wrong.still_in_the_camera,
            "Turn the camera: your rays do not notice. In which frame are they?",
        ),
        Misconception(
            wrong.turned_the_other_way,
            "Your rays are turned from the world to the camera, and they must go back. Behind a "
            "row every matrix stands transposed: what becomes of Rᵀ there?",
        ),
        Misconception(
            wrong.any_length,
            "Your rays point the right way. How long is each of them, and how long should it be?",
        ),
        Misconception(
            wrong.starts_at_t,
            "Your directions are right. Where in the world do all the rays meet?",
        ),
        Misconception(
            wrong.skew_ignored,
            "K has five numbers of interest. Which of them does your way back not undo?",
        ),
        Misconception(
            wrong.points_for_directions,
            "A direction has no place. Did you add one?",
        ),
        Misconception(
            wrong.point_made_a_unit_vector,
            "A direction has no place. Did you add one before you made it a unit vector?",
        ),
        Misconception(
            wrong.matrix_not_transposed,
            "Your pixels are rows. Does the inverse of K multiply rows the way it should?",
        ),
        Misconception(
            wrong.one_length_for_all,
            "You divide all rays by one length. Is it the length of each row, or of the whole "
            "table?",
        ),
        Misconception(
            wrong.length_of_each_column,
            "You measured the columns of the table of rays. Along which axis do the three numbers "
            "of one ray lie?",
        ),
        Misconception(
            wrong.centre_of_the_picture_at_zero,
            "The ray of the principal point is the optical axis. Is it, with your function?",
        ),
        Misconception(
            wrong.intrinsics_not_inverted,
            "K turns directions into pixels. Which matrix leads back from pixels to directions?",
        ),
        Misconception(
            wrong.intrinsics_inverted_entry_by_entry,
            "You invert the nine numbers of K one by one, zeros too. Is a matrix inverted like "
            "this?",
        ),
        Misconception(
            wrong.rays_backwards,
            "Your rays leave the camera at its back. What sign has the depth of the things that "
            "it sees?",
        ),
    ],
)

EXPLAIN_TRANSLATION = Explain(
    "homogeneous",
    "explain_translation",
    rubric=[
        (1, "Says what t is: the world's origin seen from the camera, along the camera's axes."),
        (1, "Says that the camera is at minus R transposed times t, or sees why from the pose."),
        (1, "Says when −t would be the right place: only for a camera that is not rotated, R = I."),
        (1, "Gives a check: the centre must map to zero; or a distance, which is the same."),
    ],
    model_answer=(
        "The pose takes world points to the camera: with the world's origin, X = 0, we get t. So "
        "t says where the origin is, seen from the camera and counted along the camera's axes. "
        "The camera's centre C is the point that becomes zero: R C + t = 0, so C = −Rᵀ t. Without "
        "rotation C = −t; with rotation the direction is wrong too, "
        "while the distance of the camera from the origin is the length of t in both. To check, "
        "put the supposed centre into R X + t and see whether zero comes out."
    ),
)
