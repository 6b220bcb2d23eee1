"""The exercise of chapter 06 that finds a homography."""

from __future__ import annotations

from course_lib import homography
from course_lib.exercises.estimation import misconceptions_planes as wrong
from course_lib.exercises.estimation import misconceptions_rows as wrong_rows
from course_lib.exercises.estimation import plane_inputs as inputs
from course_lib.judging import Exercise, Misconception, Part, UpToScale

HOMOGRAPHY_DLT = Exercise(
    "estimation",
    homography.homography_dlt,
    points=10,
    parts={
        "four points": Part(inputs.four_corners, cases=1, weight=3),
        "more points than needed": Part(inputs.many_corners, cases=1, weight=3),
        "points with errors": Part(inputs.corners_with_errors, cases=1, weight=4),
    },
    compare=UpToScale(tolerance=1e-9),  # the last row is thousands of times smaller
    misconceptions=[
        Misconception(
            wrong.numbers_as_they_come,
            "Right for exact points. How much larger are the largest numbers of your A than the "
            "ones, and what did normalise_points do about it?",
        ),
        Misconception(
            wrong.only_the_targets_normalised,
            "You normalised the targets. Are the points themselves already near the origin?",
        ),
        Misconception(
            wrong.only_the_points_normalised,
            "You normalised the points. Are the targets already numbers of about 1?",
        ),
        Misconception(
            wrong.rows_as_they_come_but_undone,
            "You undo a normalising at the end. Are all numbers in your A normalised ones?",
            also=[wrong.rows_of_points_as_they_come, wrong.rows_of_targets_as_they_come],
        ),
        Misconception(
            wrong.last_number_is_one,
            "Right for exact points. You set the last number of H to 1 and solve for the other "
            "eight. Which vector does the task ask for instead?",
            also=[wrong.last_number_is_one_for_normalised],
        ),
        Misconception(
            wrong.eight_vectors_of_nine,
            "Four points make only eight rows. Without its full matrices the SVD leaves out the "
            "ninth vector. Which one do you need?",
        ),
        Misconception(
            wrong.u_and_v_exchanged_in_the_rows,
            "Which row of H makes the first coordinate of a target? In which rows of A does that "
            "coordinate stand, and is u the first one of your points?",
            also=[
                wrong.targets_exchanged,
                wrong.points_exchanged,
                wrong.points_exchanged_in_the_rows,
            ],
        ),
        Misconception(
            wrong.still_normalised,
            "Your H takes normalised points to normalised targets. How do you get in and out?",
            also=[wrong.points_left_normalised, wrong.targets_left_normalised],
        ),
        Misconception(
            wrong.undone_in_the_wrong_order,
            "A point meets the rightmost matrix first. Which of the two T is made for points?",
            also=[wrong.undone_on_the_wrong_side, wrong.both_from_the_left],
        ),
        Misconception(
            wrong.done_once_more,
            "Put a point into your product, from right to left: is it first normalised, or first "
            "taken back?",
            also=[wrong.both_undone],
        ),
        Misconception(
            wrong.targets_done_once_more,
            "On the right your product is fine. The last matrix that acts on a target: does it "
            "normalise, or undo it?",
            also=[wrong.transposed_for_inverted],
        ),
        Misconception(
            wrong.multiplied_entry_by_entry,
            "For arrays, Python has two signs that multiply. Which of them goes row by column?",
            also=[
                wrong_rows.all_entry_by_entry,
                wrong_rows.inverse_entry_by_entry,
                wrong_rows.points_entry_by_entry,
            ],
        ),
        Misconception(
            wrong_rows.y_in_the_rows_of_x,
            "A row of A belongs to one coordinate of one target. Do you find only this one in each "
            "of your rows?",
            also=[
                wrong_rows.x_in_the_rows_of_y,
                wrong_rows.all_x_in_the_rows_of_y,
                wrong_rows.x_at_the_end_of_y,
            ],
        ),
        Misconception(
            wrong_rows.y_where_x_begins,
            "Which row of H makes y, and in which three columns of A do its numbers stand?",
        ),
        Misconception(
            wrong_rows.only_rows_of_x,
            "One coordinate of the targets never enters A. How many rows does each point give?",
            also=[wrong_rows.only_rows_of_y],
            explains=wrong_rows.one_row_alone,
        ),
        Misconception(
            wrong.nothing_but_zeros,
            "Zero solves the equations, always, and says nothing. Which length should h have?",
        ),
        Misconception(
            wrong.undone_with_one_matrix,
            "Points and targets were normalised separately. How many matrices T do you need?",
        ),
        Misconception(
            wrong.longest_for_shortest,
            "That is the direction in which A makes a vector longest. Where is the other end?",
        ),
        Misconception(
            wrong.last_column_of_the_transposed,
            "The right vector is there, but you took numbers from all of them. Does NumPy give the "
            "vectors as rows here, or as columns?",
            also=[
                wrong.last_column_with_rows_in_blocks,
                wrong.row_of_eigenvectors,
                wrong.row_of_eigenvectors_from_blocks,
            ],
        ),
        Misconception(
            wrong.read_column_by_column,
            "Look at the order of h in your rows of A. Does it fill H row by row?",
        ),
        Misconception(
            wrong.wrong_sign_in_the_rows,
            "Bring everything to one side of the equation. Which sign do the last three get?",
            also=[
                wrong_rows.plus_at_the_end,
                wrong_rows.plus_at_the_end_for_y,
                wrong_rows.plus_at_the_end_for_x,
                wrong_rows.plus_in_the_rows_of_y,
                wrong_rows.plus_in_the_rows_of_x,
                wrong_rows.plus_before_yu,
                wrong_rows.plus_before_yv,
                wrong_rows.plus_before_u,
                wrong_rows.plus_before_v,
            ],
        ),
        Misconception(
            wrong.one_for_the_target,
            "Look at the last entry of each row of A. Where has the target gone?",
            also=[wrong_rows.one_for_y],
        ),
        Misconception(
            wrong.from_targets_to_points,
            "Your H leads from the targets to the points. Which way was asked for?",
            also=[wrong.from_targets_to_points_inside],
        ),
        Misconception(
            wrong.only_affine,
            "Your last row is always the same. Can parallel edges meet in your picture?",
        ),
        Misconception(
            wrong.first_four_points,
            "Four points would be enough. But what do the others say, when all have errors?",
        ),
    ],
    forbidden=("cv2.findHomography", "cv2.getPerspectiveTransform"),
)
