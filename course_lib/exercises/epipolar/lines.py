"""Exercises of chapter 08 on epipolar lines, the epipole, and the distance from a line."""

from __future__ import annotations

from course_lib.exercises.epipolar import inputs, plain
from course_lib.exercises.epipolar import line_misconceptions as wrong
from course_lib.exercises.epipolar.comparison import LinesWithUnitNormal
from course_lib.judging import Close, Exercise, Misconception, Part

EPIPOLAR_LINES = Exercise(
    "epipolar",
    plain.epipolar_lines,
    points=5,
    compare=LinesWithUnitNormal(),
    parts={
        "whole numbers": Part(inputs.small_lines, cases=2, weight=2),
        "pixels of a picture": Part(inputs.lines_of_pixels, cases=1, weight=3),
    },
    forbidden=(
        "course_lib.epipolar.lines.epipolar_lines",
        "cv2.computeCorrespondEpilines",
    ),
    misconceptions=[
        Misconception(
            wrong.lines_of_the_other_picture,
            "Points are rows here. What must happen to a matrix that multiplies from the right?",
            also=[wrong.other_picture_and_not_scaled],
        ),
        Misconception(
            wrong.not_scaled,
            "The lines are right. How long is the normal (a, b) of each?",
        ),
        Misconception(
            wrong.scaled_by_all_three,
            "You made all three numbers together of length 1. Which two are the normal?",
        ),
        Misconception(
            wrong.last_number_one,
            "You divide by c. Lines are not scaled like points: which length should be 1?",
        ),
        Misconception(
            wrong.scaled_all_alike,
            "You divide all lines by one number. Has each line a length of its own?",
            also=[wrong.scaled_all_alike_by_everything, wrong.scaled_by_columns],
        ),
        Misconception(
            wrong.root_left_out,
            "You divide by the square of a length. Which step is missing?",
        ),
        Misconception(
            wrong.c_left_as_it_was,
            "The normals are right. What must happen to c, for the line to stay the same line?",
        ),
        Misconception(
            wrong.lines_in_columns,
            "Your lines stand in columns. In which direction does the answer list them?",
        ),
        Misconception(
            wrong.zero_for_one,
            "A zero at the end means a direction. Which number means a point?",
        ),
        Misconception(
            wrong.one_in_front,
            "Where does the 1 stand in homogeneous coordinates?",
        ),
        Misconception(
            wrong.rows_and_columns_swapped,
            "Which comes first in a pixel: the column u, or the row v?",
        ),
        Misconception(
            wrong.normals_only,
            "Two numbers tell how a line is turned. Which one tells where it is?",
        ),
    ],
)

EPIPOLE = Exercise(
    "epipolar",
    plain.epipole,
    points=5,
    parts={
        "whole numbers": Part(inputs.small_epipole, cases=2, weight=2),
        "a camera that went aside": Part(inputs.aside, cases=1, weight=1),
        "a camera that went forward": Part(inputs.forward, cases=1, weight=2),
    },
    compare=Close(rtol=1e-5, atol=1e-6),
    forbidden=("course_lib.epipolar.lines.epipole",),
    misconceptions=[
        Misconception(
            wrong.epipole_of_picture_2,
            "Put your point behind F: does F times (u, v, 1) give zero? Which picture is it in?",
        ),
        Misconception(
            wrong.column_of_the_last_factor,
            "NumPy gives the last factor transposed. Are its vectors in the rows or the columns?",
        ),
        Misconception(
            wrong.row_of_the_first_factor,
            "You took a row of the first factor. Which factor of the SVD does F's null vector "
            "belong to?",
        ),
        Misconception(
            wrong.largest_singular_value,
            "Which singular value is zero: the first, or the last?",
        ),
        Misconception(
            wrong.not_divided,
            "Three numbers are homogeneous coordinates. Which step makes a pixel of them?",
            also=[wrong.divided_and_not_cut],
        ),
        Misconception(
            wrong.not_divided_but_cut,
            "Your pixel is near the corner. What does the third number do to the first two?",
            also=[wrong.divided_by_the_length],
        ),
        Misconception(
            wrong.row_before_column,
            "Which comes first in a pixel: the column u, or the row v?",
        ),
        Misconception(
            wrong.singular_value_for_vector,
            "The SVD gives three things. Which of them are numbers, and which are vectors?",
        ),
        Misconception(
            wrong.zero_vector,
            "Any matrix takes the zero vector to zero, so it says nothing. Which other vector does "
            "the SVD of F give?",
            also=[wrong.zero_vector_not_divided, wrong.zero_vector_cut],
        ),
        Misconception(
            wrong.smallest_by_symmetric_eigenvectors,
            "`eigh` is for symmetric matrices. Is F symmetric?",
        ),
        Misconception(
            wrong.last_column,
            "A column of F is what F makes of one point. Which point does F take to zero?",
            also=[wrong.last_row],
        ),
    ],
)

LINE_DISTANCE = Exercise(
    "epipolar",
    plain.line_distance,
    points=4,
    parts={
        "whole numbers": Part(inputs.small_distances, cases=2, weight=2),
        "pixels of a picture": Part(inputs.pixels_and_lines, cases=1, weight=2),
    },
    forbidden=("course_lib.epipolar.lines.line_distance",),
    misconceptions=[
        Misconception(
            wrong.not_divided_by_the_length,
            "Multiply a line by ten: it is the same line. Does your distance stay the same?",
        ),
        Misconception(
            wrong.sign_kept,
            "A point may be on either side of a line. Can a distance be negative?",
            also=[wrong.sign_kept_and_not_divided],
        ),
        Misconception(
            wrong.root_of_the_squares_left_out,
            "You divide by the square of a length. Which step is missing?",
        ),
        Misconception(
            wrong.length_of_all_three,
            "By which length do you divide? Which of a, b and c are the normal?",
        ),
        Misconception(
            wrong.c_forgotten,
            "Your lines all pass through the first pixel. Which number moves them away?",
        ),
        Misconception(
            wrong.every_point_with_every_line,
            "You have each point with each line. Which of these belong together?",
            also=[
                wrong.every_point_with_every_line_not_divided,
                wrong.every_point_with_every_line_without_sign,
                wrong.every_point_with_every_line_divided_by_rows,
            ],
        ),
        Misconception(
            wrong.brackets_left_out,
            "In `x / p + q`, what is divided by what? Which brackets does the formula need?",
            also=[wrong.root_of_one_number],
        ),
        Misconception(
            wrong.added_down_the_columns,
            "A row is a point with its line. Do you add along the rows, or down the columns?",
        ),
        Misconception(
            wrong.one_length_for_all,
            "You divide all by one number. Has each line a length of its own?",
        ),
        Misconception(
            wrong.lengths_of_columns,
            "You take away the signs before you add. What of a positive and a negative term?",
        ),
        Misconception(
            wrong.in_a_column,
            "Your distances stand below each other in a table. How many axes has a list?",
        ),
        Misconception(
            wrong.squared,
            "In which unit is your answer: px, or px squared?",
        ),
        Misconception(
            wrong.a_and_b_swapped,
            "Which coordinate does a belong to: the column u, or the row v?",
        ),
        Misconception(
            wrong.added_up,
            "One number comes out. How many points are there, and how many distances?",
            also=[wrong.averaged],
        ),
    ],
)
