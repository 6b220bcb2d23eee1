"""Exercises of chapter 06 on correction tables, and on what residuals say."""

from __future__ import annotations

from course_lib import resection
from course_lib.exercises.estimation import camera_inputs as inputs
from course_lib.exercises.estimation import misconceptions_tables as wrong
from course_lib.judging import Exercise, Explain, Misconception, Part

CORRECTION_TABLE = Exercise(
    "estimation",
    resection.correction_table,
    points=5,
    parts={
        "residuals in every cell": Part(inputs.every_cell_seen, cases=2, weight=2),
        "cells without any": Part(inputs.some_cells_empty, cases=1, weight=1),
        "pixels near the edges of cells": Part(inputs.near_the_edges_of_cells, cases=1, weight=1),
        "a pixel on the last edge": Part(inputs.on_the_last_edge, cases=1, weight=1),
    },
    misconceptions=[
        Misconception(
            wrong.edge_at_zero,
            "Where does the picture begin: in the middle of its first pixel, or at its edge?",
        ),
        Misconception(
            wrong.last_edge_left_out,
            "Right, but for a pixel exactly on the edge of the picture, at width - 0.5. Which "
            "column do you get for it, and how many are there?",
        ),
        Misconception(
            wrong.one_cell_too_few,
            "How many cells do your numbers count side by side, and how many were asked for?",
        ),
        Misconception(
            wrong.comparison_with_fractions,
            "Your table is empty. Are the numbers of rows and columns that you compare whole?",
        ),
        Misconception(
            wrong.height_before_width,
            "An image size is width and height. Which of them do you divide u by?",
            also=[wrong.height_before_width_unclipped],
        ),
        Misconception(
            wrong.cells_rounded,
            "A pixel near the end of the first cell: does rounding leave it in that cell?",
            also=[wrong.cells_rounded_unclipped],
        ),
        Misconception(
            wrong.sum_for_mean,
            "Ten points with the same residual: should they correct ten times as much as one?",
        ),
        Misconception(
            wrong.median_for_mean,
            "You take the middle one of the residuals. Which sort of average was asked for?",
        ),
        Misconception(
            wrong.sizes_of_residuals,
            "Residuals have signs, for u and for v. May those on the left and on the right cancel?",
            also=[wrong.lengths_of_residuals],
        ),
        Misconception(
            wrong.last_one_stays,
            "Several residuals fall into one cell. How many of them have a say in your entry?",
        ),
        Misconception(
            wrong.one_mean_for_u_and_v,
            "Both numbers of a cell are the same. Over which axis must the mean be taken?",
        ),
        Misconception(
            wrong.nan_where_nothing_was_seen,
            "The mean of nothing is NaN. What should a cell without residuals hold instead?",
        ),
        Misconception(
            wrong.minus_the_mean,
            "The sign is turned round. Does the table hold what is left, or what to add?",
        ),
        Misconception(
            wrong.columns_before_rows,
            "Which index of the table comes first: the one that goes down, or the one across?",
            also=[wrong.indices_exchanged, wrong.shape_read_the_other_way],
        ),
        Misconception(
            wrong.u_down_and_v_across,
            "u runs along a row of pixels. Does a larger u change the row of the cell, or its "
            "column?",
            also=[wrong.u_down_and_v_across_by_own_sides],
        ),
        Misconception(
            wrong.rows_from_the_bottom,
            "In which direction does v grow in a picture: up or down?",
        ),
        Misconception(
            wrong.returned_after_one_cell,
            "Only the beginning of your table is filled. How far to the right does your last line "
            "begin: does it belong to a loop?",
            also=[wrong.returned_after_one_row, wrong.returned_after_one_filled_cell],
        ),
        Misconception(
            wrong.divided_by_all_points,
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
