"""Exercises of chapter 10 on one camera: its pose, and how its pixels change."""

from __future__ import annotations

from course_lib.exercises.bundle import derivative_misconceptions as slope
from course_lib.exercises.bundle import inputs, plain
from course_lib.exercises.bundle import pose_misconceptions as wrong
from course_lib.judging import Exercise, Misconception, Part

RESECT_CAMERA = Exercise(
    "bundle",
    plain.resect_camera,
    points=8,
    parts={
        "exact pixels": Part(inputs.exact_pixels, cases=1, weight=4),
        "pixels with errors": Part(inputs.pixels_with_errors, cases=1, weight=4),
    },
    forbidden=(
        "course_lib.orientation.space_resection.resect_camera",
        "course_lib.camera.projection.decompose_projection",
        "cv2.solvePnP",
    ),
    misconceptions=[
        Misconception(
            wrong.K_left_out,
            "P takes points to pixels. What must be taken off its left before rotation and "
            "translation are left?",
            also=[
                wrong.K_not_inverted,
            ],
        ),
        Misconception(
            wrong.K_from_the_right,
            "Of a product, on which side does K stand in P, and on which side is it taken off?",
        ),
        Misconception(
            wrong.K_for_the_rotation_only,
            "Your R is right. Is your t a last column of pixels, or of the world's unit?",
        ),
        Misconception(
            wrong.not_made_a_rotation,
            "Without errors it is right. With them, are the three columns of your R still "
            "perpendicular and of length 1?",
            also=[
                wrong.divided_but_no_rotation,
                wrong.lengths_put_back,
                wrong.columns_made_length_one,
                wrong.columns_made_length_one_only,
                wrong.made_length_one_and_divided_by_the_first,
                wrong.made_length_one_and_divided_by_the_mean,
                wrong.divided_by_the_length_of_the_first,
            ],
        ),
        Misconception(
            wrong.rotation_by_qr,
            "Your R is a rotation. Is it the nearest one, which treats all three columns alike?",
        ),
        Misconception(
            wrong.not_divided,
            "Without errors it is right. Which number makes the columns of the rotation longer "
            "than 1, and the last column with them?",
        ),
        Misconception(
            wrong.divided_by_the_first,
            "The three numbers of the SVD differ a little. Do you take one of them, their sum, or "
            "what the text says?",
            also=[
                wrong.divided_by_the_sum,
                wrong.divided_by_the_determinant,
                wrong.divided_one_by_one,
            ],
        ),
        Misconception(
            wrong.multiplied_instead,
            "The last column is as many times too long as the others. Should it become longer?",
        ),
        Misconception(
            wrong.divided_to_length_one,
            "Your t has length 1. Is every camera one unit away from the origin of the world?",
        ),
        Misconception(
            wrong.V_not_transposed,
            "NumPy gives U, S and a third matrix. Is that V, or its transpose already?",
        ),
        Misconception(
            wrong.factors_swapped,
            "A product of matrices has an order. Which of the two stands on the left in the SVD?",
        ),
        Misconception(
            wrong.entries_multiplied,
            "U and Vᵀ are multiplied number by number. Which sign multiplies matrices?",
        ),
        Misconception(
            wrong.svd_of_all_four,
            "A rotation has three columns. Of how many columns do you take the SVD?",
            also=[wrong.svd_of_all_four_unfitting, wrong.svd_of_all_four_cut],
        ),
        Misconception(
            wrong.rotation_with_K_in_it,
            "Of which matrix do you take the SVD: is K still in it?",
            also=[wrong.rotation_and_scale_with_K_in_them],
        ),
        Misconception(
            wrong.centre_for_translation,
            "Your t is where the camera stands in the world. What is asked for?",
        ),
        Misconception(
            wrong.camera_to_world,
            "Does your rotation lead from the world to the camera, or back?",
            also=[wrong.inverse_pose],
        ),
        Misconception(
            wrong.translation_first,
            "Both are there. Which of R and t is to come first?",
        ),
        Misconception(
            wrong.one_matrix,
            "R and t stand in one table. How does a function return two things?",
        ),
        Misconception(
            wrong.translation_as_a_column,
            "Your t is a table with one column. Does `3:` pick a number of each row, or a list?",
        ),
        Misconception(
            wrong.row_for_column,
            "Your t has four numbers. Is it a row of the matrix, or a column?",
        ),
    ],
)

REPROJECTION_JACOBIAN = Exercise(
    "bundle",
    plain.reprojection_jacobian,
    points=10,
    parts={
        "the camera is at the world's origin": Part(inputs.camera_at_the_origin, cases=1, weight=5),
        "the camera is anywhere": Part(inputs.camera_anywhere, cases=1, weight=5),
    },
    forbidden=("course_lib.bundle.derivatives.reprojection_jacobian",),
    misconceptions=[
        Misconception(
            slope.depth_with_plus,
            "A point to the right moves further away: does it move outwards in the picture, or "
            "inwards?",
        ),
        Misconception(
            slope.depth_not_squared,
            "What is the derivative of 1/z: which power of z does it have?",
        ),
        Misconception(
            slope.depth_squared_everywhere,
            "Move the point to the right by a little. By which power of z is the step of its pixel "
            "divided?",
            also=[slope.not_divided_by_depth],
        ),
        Misconception(
            slope.x_in_both_rows,
            "The row of u is right. Which of x and y makes v?",
        ),
        Misconception(
            slope.depth_left_out,
            "The last column of your A is zero. Does a pixel not change when the point comes "
            "nearer?",
        ),
        Misconception(
            slope.intrinsics_by_depth,
            "Your A is K by z. But u is a fraction, and z stands below: how does u change with z?",
        ),
        Misconception(
            slope.fx_for_both,
            "The row of u is right. Which focal length belongs to v?",
        ),
        Misconception(
            slope.f_left_out,
            "Are your numbers in pixels? Where is the focal length?",
        ),
        Misconception(
            slope.pixels_for_the_ray,
            "The principal point moves all pixels alike. Does it stand in a derivative?",
        ),
        Misconception(
            slope.u_and_v_swapped,
            "Which of u and v belongs to the first row?",
        ),
        Misconception(
            slope.the_world_for_q,
            "At the origin it is right. Where is the point in the frame of a camera that stands "
            "elsewhere?",
            also=[
                slope.the_world_for_the_first_link,
                slope.translation_left_out,
                slope.rotation_left_out_of_q,
                slope.rotation_transposed_in_q,
            ],
        ),
        Misconception(
            slope.rotation_left_out,
            "At the origin it is right. A move is counted along the axes of the world. Which "
            "matrix tells what it is in the camera's frame?",
            also=[slope.rotation_transposed, slope.rotation_left_out_for_the_point],
        ),
        Misconception(
            slope.turn_of_the_world_point,
            "At the origin it is right. The turn is about the camera's centre: which vector from "
            "there leads to the point?",
        ),
        Misconception(
            slope.turn_followed_by_R,
            "The turn is about the camera's own axes. Is a rotation needed to get there?",
            also=[slope.turn_after_R],
        ),
        Misconception(
            slope.turn_with_plus,
            "A turn w of all that is seen moves q by w × q. Which sign comes when you write that "
            "as q × …?",
        ),
        Misconception(
            slope.turn_left_unchained,
            "Your first three columns say how q turns. What does the pixel do then?",
        ),
        Misconception(
            slope.centre_with_plus,
            "The camera moves to the right: do the points in its picture move to the right, too?",
        ),
        Misconception(
            slope.translation_for_centre,
            "Columns four to six are by t. Is it t that moves here, or the centre of the camera?",
        ),
        Misconception(
            slope.point_with_minus,
            "A point moves to the right. Does its pixel, by your numbers, move to the left?",
        ),
        Misconception(
            slope.move_before_turn,
            "All six columns are there. Which three come first?",
        ),
        Misconception(
            slope.links_below_each_other,
            "A pixel has two rows. Do turn and move stand side by side, or below each other?",
        ),
        Misconception(
            slope.point_first,
            "Both are there. Which of them is to come first?",
        ),
        Misconception(
            slope.in_one_table,
            "How many tables does the function return?",
            also=[slope.pose_only, slope.point_only, slope.first_link_only],
        ),
    ],
)
