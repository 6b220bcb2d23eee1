"""Exercises of chapter 07 on the refinement: residuals, one step."""

from __future__ import annotations

from course_lib.exercises.calibration import inputs
from course_lib.exercises.calibration import plain_refinement as plain
from course_lib.exercises.calibration import refinement_misconceptions as wrong
from course_lib.judging import Exercise, Misconception, Part

REPROJECTION_RESIDUALS = Exercise(
    "calibration",
    plain.reprojection_residuals,
    points=8,
    parts={
        "without distortion": Part(inputs.without_distortion, weight=4),
        "with distortion": Part(inputs.with_distortion, weight=4),
    },
    forbidden=(
        "course_lib.calibration.judgement.reprojection_residuals",
        "cv2.projectPoints",
    ),
    misconceptions=[
        Misconception(
            wrong.observed_minus_projected,
            "The sizes are right. Which of the two is subtracted from the other?",
        ),
        Misconception(
            wrong.distortion_left_out,
            "Without distortion it is right. Where do k1 and k2 come in?",
        ),
        Misconception(
            wrong.radius_not_squared,
            "Which power of the distance does k1 belong to, and which one k2?",
            also=[wrong.square_for_fourth_power, wrong.sixth_power_for_fourth],
        ),
        Misconception(
            wrong.pixels_distorted,
            "Does the lens bend rays before they become pixels, or afterwards?",
        ),
        Misconception(
            wrong.radius_in_pixels,
            "Without distortion it is right. Is your r as small as a tangent, or as large as "
            "pixels or millimetres?",
            also=[wrong.radius_in_pixels_from_the_centre, wrong.radius_before_depth],
        ),
        Misconception(
            wrong.radius_of_the_observed,
            "Without distortion it is right. Is r that of the ideal point, or of the observed one?",
        ),
        Misconception(
            wrong.one_left_out,
            "A lens without distortion leaves points where they are. Where do yours go then?",
        ),
        Misconception(
            wrong.distortion_backwards,
            "You take distortion off. Do you start from the ideal point, or from the observed one?",
            also=[wrong.divided_by_distortion],
        ),
        Misconception(
            wrong.rotation_transposed,
            "Points are rows here. What must happen to a matrix that multiplies from the right?",
        ),
        Misconception(
            wrong.moved_before_turned,
            "Is t counted along the axes of the board or along those of the camera?",
        ),
        Misconception(
            wrong.translation_left_out,
            "Where is the board in yours: before the camera, or around its centre?",
        ),
        Misconception(
            wrong.v_before_u,
            "Which is the first number of a pixel: how far to the right it is, or how far down?",
            also=[wrong.principal_point_swapped],
        ),
        Misconception(
            wrong.still_normalised,
            "You compare pixels with coordinates that are not pixels yet. What makes pixels of "
            "them?",
            also=[wrong.only_moved_to_the_centre],
        ),
        Misconception(
            wrong.all_in_one_row,
            "All numbers are there. Print the shape: has it a row for each point?",
            also=[wrong.columns_for_rows],
        ),
        Misconception(
            wrong.half_a_pixel_off,
            "All your residuals are off by the same half. Where is the centre of the first pixel: "
            "at 0 or at 0.5?",
            also=[wrong.half_a_pixel_back],
        ),
        Misconception(
            wrong.principal_point_left_out,
            "All your residuals are off by hundreds of pixels. Where does the axis meet the "
            "picture?",
        ),
        Misconception(
            wrong.not_divided_by_depth,
            "A board twice as far away looks half as large. Where does yours get smaller?",
            also=[wrong.not_divided_after_K],
        ),
        Misconception(
            wrong.fx_for_v,
            "Right for u. Which focal length belongs to v?",
        ),
        Misconception(
            wrong.projected_only,
            "These are pixels of the picture. By how much do they miss the observed ones?",
        ),
        Misconception(
            wrong.sign_lost,
            "A residual can point to the left or to the right. Where has its sign gone?",
            also=[wrong.squared_already],
        ),
        Misconception(
            wrong.lengths_of_residuals,
            "These are distances. Which two numbers are asked for at each point?",
        ),
    ],
)

RMS_ERROR = Exercise(
    "calibration",
    plain.rms_error,
    points=4,
    parts={
        "five points": Part(inputs.few_residuals, weight=2),
        "a whole board": Part(inputs.many_residuals, weight=2),
    },
    forbidden=("course_lib.calibration.judgement.rms_error",),
    misconceptions=[
        Misconception(
            wrong.over_coordinates,
            "You divide by the number of coordinates. How many points are that?",
        ),
        Misconception(
            wrong.columns_for_points,
            "A row is a point. Do you add du and dv of each point, or all du of the board?",
            also=[wrong.one_error_for_u_one_for_v, wrong.lengths_of_columns, wrong.mean_of_u_and_v],
        ),
        Misconception(
            wrong.length_of_each,
            "You have a number for each point. Which step makes a single one of them?",
            also=[wrong.rms_of_each],
        ),
        Misconception(
            wrong.mean_length,
            "In which order do square, mean and root come in a root mean square?",
        ),
        Misconception(
            wrong.root_left_out,
            "In which unit is your answer: px, or px squared?",
        ),
        Misconception(
            wrong.largest_error,
            "That is how far the worst point is off. What of the others?",
        ),
        Misconception(
            wrong.length_of_the_mean,
            "Two residuals that point in opposite directions: do they cancel out in yours?",
        ),
        Misconception(
            wrong.deviation_from_the_mean,
            "`std` measures from the mean. Should a shift of all residuals together not count?",
        ),
        Misconception(
            wrong.divided_outside_of_the_root,
            "The mean is taken of squares. Do you divide before the root, or after it?",
        ),
        Misconception(
            wrong.not_divided,
            "With twice as many points, does your error grow? Where is the mean?",
        ),
    ],
)

REFINE_CALIBRATION = Exercise(
    "calibration",
    plain.refine_calibration,
    points=7,
    parts={
        "without damping": Part(inputs.undamped_step, weight=3),
        "with damping": Part(inputs.damped_step, weight=4),
    },
    forbidden=("course_lib.calibration.judgement.refine_calibration",),
    misconceptions=[
        Misconception(
            wrong.uphill,
            "Put your step into the linear problem: do the residuals get smaller or larger?",
        ),
        Misconception(
            wrong.step_only,
            "This is the step. Where does it lead to?",
        ),
        Misconception(
            wrong.not_damped,
            "Where does the damping come in? Try a very large one: how long is your step then?",
        ),
        Misconception(
            wrong.ones_on_the_diagonal,
            "A focal length and a k1 differ by thousands. Is the damping the same for both?",
        ),
        Misconception(
            wrong.row_added_to_the_matrix,
            "`np.diag` of a matrix is a row of numbers. What does adding it to a matrix do?",
        ),
        Misconception(
            wrong.residuals_for_parameters,
            "J has a row for each residual and a column for each parameter. Which product of J "
            "with itself has a row and a column for each parameter?",
            also=[wrong.residuals_for_parameters_undamped],
        ),
        Misconception(
            wrong.diagonal_of_J,
            "D has as many rows as columns, J has not. Which matrix is the diagonal taken from?",
            also=[wrong.matrix_of_the_diagonal_of_J],
        ),
        Misconception(
            wrong.all_entries_damped,
            "You damp the whole matrix. Which of its entries does D have?",
        ),
        Misconception(
            wrong.downhill_only,
            "That is the direction downhill. Which system of equations tells how far to go?",
        ),
        Misconception(
            wrong.diagonal_only,
            "The parameters are tied to each other. Where have the other entries of the matrix "
            "gone?",
        ),
    ],
)
