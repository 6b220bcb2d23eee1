"""Exercises of chapter 06 on camera matrices and correction tables."""

from __future__ import annotations

from course_lib import resection
from course_lib.exercises.estimation import camera_inputs as inputs
from course_lib.exercises.estimation import misconceptions_cameras as wrong
from course_lib.exercises.estimation import misconceptions_tables as wrong_table
from course_lib.judging import Exercise, Explain, Misconception, Part, UpToScale

CAMERA_DLT = Exercise(
    "estimation",
    resection.camera_dlt,
    points=8,
    parts={
        "six points": Part(inputs.six_points, cases=1, weight=3),
        "more points than needed": Part(inputs.twelve_points, cases=1, weight=3),
        "points in millimetres": Part(inputs.points_in_millimetres, cases=1, weight=2),
    },
    compare=UpToScale(tolerance=1e-9),  # the last row is thousands of times smaller
    misconceptions=[
        Misconception(
            wrong.camera_of_normalised_points,
            "Your P takes normalised points to normalised pixels. How do you get in and out?",
        ),
        Misconception(
            wrong.pixels_left_normalised,
            "Your P takes real points, but to what kind of pixels? What is still to be undone?",
        ),
        Misconception(
            wrong.points_left_normalised,
            "Your P gives real pixels, but of what kind of points? Which T must come first?",
        ),
        Misconception(
            wrong.normalised_once_more,
            "Put a point into your product, from right to left: is it first normalised, or first "
            "taken back?",
            also=[wrong.both_undone],
        ),
        Misconception(
            wrong.pixels_normalised_once_more,
            "On the right your product is fine. The last matrix that acts on a pixel: does it "
            "normalise, or undo it?",
        ),
        Misconception(
            wrong.longest_of_twelve,
            "That is the direction in which A makes a vector longest. Where is the other end?",
        ),
        Misconception(
            wrong.last_column_of_twelve,
            "The right vector is there, but you took numbers from all of them. Does NumPy give the "
            "vectors as rows here, or as columns?",
            also=[wrong.last_column_with_rows_in_blocks],
        ),
        Misconception(
            wrong.filled_column_by_column,
            "Look at the order of p in your rows of A. Does it fill P row by row?",
        ),
        Misconception(
            wrong.sign_of_the_last_four,
            "Bring everything to one side of the equation. Which sign do the last four get?",
        ),
        Misconception(
            wrong.v_for_u,
            "Which row of P makes u? In which rows of A does u stand, and where does v?",
            also=[wrong.u_for_v, wrong.v_for_u_in_the_rows, wrong.exchanged_in_the_rows],
        ),
        Misconception(
            wrong.last_row_of_a_parallel_camera,
            "With your P nothing gets smaller with distance. Which row of P knows the distance?",
        ),
    ],
    forbidden=("cv2.calibrateCamera", "cv2.solvePnP"),
)

DECOMPOSE_PROJECTION = Exercise(
    "estimation",
    resection.decompose_projection,
    points=8,
    parts={
        "a matrix as it was put together": Part(inputs.as_it_was_put_together, cases=1, weight=3),
        "a multiple of it": Part(inputs.any_multiple, cases=1, weight=3),
        "a negative multiple": Part(inputs.negative_multiple, cases=2, weight=2),
    },
    misconceptions=[
        Misconception(
            wrong.signs_as_they_come,
            "Look at the diagonal of your K. May a focal length be negative, and what may you "
            "multiply K and R with so that K R stays?",
            also=[
                wrong.signs_as_they_come_from_flipping,
                wrong.signs_as_they_come_from_scipy,
                wrong.signs_as_they_come_after_the_mirror,
            ],
        ),
        Misconception(
            wrong.signs_of_K_only,
            "Your K is right. You changed signs in it: is the product of K and R still the same?",
            also=[
                wrong.signs_of_K_only_without_the_mirror,
                wrong.signs_of_K_in_the_columns_of_R,
            ],
        ),
        Misconception(
            wrong.signs_on_the_outer_sides,
            "Between K and R, two equal sign matrices cancel. Do yours stand there, or outside?",
        ),
        Misconception(
            wrong.inverse_left_in_K,
            "You split the inverse of M. Does the triangle belong to K then, or to its inverse?",
        ),
        Misconception(
            wrong.mirror_left_in,
            "Right, unless P is negative. Which determinant has your R then, and a rotation's?",
        ),
        Misconception(
            wrong.rotation_first,
            "QR gives the rotation first and the triangle second. Which of them is first in K R?",
            also=[wrong.rotation_first_with_signs, wrong.rotation_first_signs_inside],
        ),
        Misconception(
            wrong.K_not_divided,
            "Two multiples of P are one camera. Which number of K shows the scale that is left?",
        ),
        Misconception(
            wrong.rotation_transposed,
            "Your K is right. Does your R lead from the world to the camera, or back?",
            also=[wrong.transpose_left_out],
        ),
        Misconception(
            wrong.last_column_as_centre,
            "K and R are right. The last column of P is the image of the world's origin: is the "
            "camera there?",
            also=[wrong.minus_last_column_as_centre],
        ),
        Misconception(
            wrong.translation_as_centre,
            "K and R are right. You return where the origin is, seen from the camera. Who asks "
            "for whom?",
            also=[wrong.translation_of_a_scaled_matrix, wrong.t_for_the_centre],
        ),
        Misconception(
            wrong.scale_left_in_the_centre,
            "Right while P is not multiplied. You divided K by a number: did the last column of P "
            "know of it?",
        ),
        Misconception(
            wrong.null_vector_not_divided,
            "K and R are right. The point that P maps to zero has four numbers: what makes three "
            "coordinates of them?",
        ),
        Misconception(
            wrong.last_column_without_K,
            "K and R are right. The last column of P is K times t: what did you do about K?",
        ),
        Misconception(
            wrong.sign_of_the_centre,
            "P maps the centre to zero. What does it make of your point?",
        ),
    ],
    forbidden=("cv2.decomposeProjectionMatrix", "cv2.RQDecomp3x3"),
)

CORRECTION_TABLE = Exercise(
    "estimation",
    resection.correction_table,
    points=5,
    parts={
        "residuals in every cell": Part(inputs.every_cell_seen, cases=2, weight=3),
        "cells without any": Part(inputs.some_cells_empty, cases=1, weight=1),
        "pixels near the edges of cells": Part(inputs.near_the_edges_of_cells, cases=1, weight=1),
    },
    misconceptions=[
        Misconception(
            wrong_table.edge_at_zero,
            "Where does the picture begin: in the middle of its first pixel, or at its edge?",
        ),
        Misconception(
            wrong_table.one_cell_too_few,
            "How many cells do your numbers count side by side, and how many were asked for?",
        ),
        Misconception(
            wrong_table.comparison_with_fractions,
            "Your table is empty. Are the numbers of rows and columns that you compare whole?",
        ),
        Misconception(
            wrong_table.height_before_width,
            "An image size is width and height. Which of them do you divide u by?",
            also=[wrong_table.height_before_width_unclipped],
        ),
        Misconception(
            wrong_table.cells_rounded,
            "A pixel near the end of the first cell: does rounding leave it in that cell?",
        ),
        Misconception(
            wrong_table.sum_for_mean,
            "Ten points with the same residual: should they correct ten times as much as one?",
        ),
        Misconception(
            wrong_table.median_for_mean,
            "You take the middle one of the residuals. Which sort of average was asked for?",
        ),
        Misconception(
            wrong_table.sizes_of_residuals,
            "Residuals have signs, for u and for v. May those on the left and on the right cancel?",
            also=[wrong_table.lengths_of_residuals],
        ),
        Misconception(
            wrong_table.last_one_stays,
            "Several residuals fall into one cell. How many of them have a say in your entry?",
        ),
        Misconception(
            wrong_table.one_mean_for_u_and_v,
            "Both numbers of a cell are the same. Over which axis must the mean be taken?",
        ),
        Misconception(
            wrong_table.nan_where_nothing_was_seen,
            "The mean of nothing is NaN. What should a cell without residuals hold instead?",
        ),
        Misconception(
            wrong_table.minus_the_mean,
            "The sign is turned round. Does the table hold what is left, or what to add?",
        ),
        Misconception(
            wrong_table.columns_before_rows,
            "Which index of the table comes first: the one that goes down, or the one across?",
            also=[wrong_table.indices_exchanged, wrong_table.shape_read_the_other_way],
        ),
        Misconception(
            wrong_table.u_down_and_v_across,
            "u runs along a row of pixels. Does a larger u change the row of the cell, or its "
            "column?",
            also=[wrong_table.u_down_and_v_across_by_own_sides],
        ),
        Misconception(
            wrong_table.rows_from_the_bottom,
            "In which direction does v grow in a picture: up or down?",
        ),
        Misconception(
            wrong_table.divided_by_all_points,
            "You divide by the number of all points. How many of them lie in the cell?",
        ),
    ],
)

EXPLAIN_RESIDUALS = Explain(
    "estimation",
    "explain_residuals",
    rubric=[
        (
            1,
            "Says that zero residuals say nothing here: four points give eight equations for eight "
            "unknowns, so any four readings, also wrong ones, are met exactly.",
        ),
        (
            1,
            "Proposes points that were not used (or more markers), and to judge by them.",
        ),
        (1, "Says that these must be spread over the whole table, or where the needle will work."),
        (
            1,
            "Names an error that points on the table cannot show: a target above or below it, or "
            "the needle's own error, or a wrong scale of all marker places.",
        ),
    ],
    model_answer=(
        "Nothing at all: four points give eight equations for the eight unknowns of a homography, "
        "so the residuals are zero whatever was read, even with a slip of 10 mm. She should "
        "measure more markers all over the table, keep some of them out of the fit, and look how "
        "far off the homography is there. But a homography knows one plane only: 100 markers on "
        "the table would never show how far the needle misses a target that lies higher."
    ),
)
