"""Exercises of chapter 09 on points: the linear method, and one step to the best one."""

from __future__ import annotations

from course_lib.exercises.triangulation import inputs, plain
from course_lib.exercises.triangulation import linear_misconceptions as wrong
from course_lib.exercises.triangulation import refinement_misconceptions as step
from course_lib.judging import Close, Exercise, Misconception, Part

TRIANGULATE_LINEAR = Exercise(
    "triangulation",
    plain.triangulate_linear,
    points=8,
    compare=Close(rtol=0, atol=1e-4),
    parts={
        "two cameras": Part(inputs.two_cameras, cases=1, weight=4),
        "five cameras, with noise": Part(inputs.five_cameras, cases=1, weight=4),
    },
    forbidden=(
        "course_lib.triangulation.many_views.triangulate_linear",
        "course_lib.triangulation.many_views.refine_point",
        "course_lib.triangulation.two_views.triangulate",
        "course_lib.triangulation.rays.triangulate_midpoint",
        "cv2.triangulatePoints",
    ),
    misconceptions=[
        Misconception(
            wrong.rows_mixed_up,
            "Which row of P makes u, the first one or the second one?",
        ),
        Misconception(
            wrong.rows_added,
            "u is p1 h over p3 h. Multiplied out and brought to one side: which sign is there?",
        ),
        Misconception(
            wrong.third_row_forgotten,
            "You subtract from u itself. Which row of P does u multiply?",
        ),
        Misconception(
            wrong.columns_and_last_number,
            "Your table has three columns. Are p1, p2, p3 rows of P, or its columns?",
        ),
        Misconception(
            wrong.columns_for_rows,
            "An index goes too far. Python counts from 0: is p1 then P[0] or P[1]? And are p1, p2, "
            "p3 rows of P, or columns?",
            also=[wrong.counted_from_one],
        ),
        Misconception(
            wrong.not_divided,
            "These numbers belong to a vector of length 1. What turns its last number into 1?",
        ),
        Misconception(
            wrong.four_numbers,
            "These are four numbers. What is left of them once the last one is 1?",
            also=[wrong.four_numbers_of_length_one],
        ),
        Misconception(
            wrong.divided_by_the_third,
            "For a pixel the third number is the divisor. Which one is it for a point of space?",
            also=[wrong.two_numbers],
        ),
        Misconception(
            wrong.two_numbers_of_three,
            "These are two numbers. How many does `0:2` pick, and how many has a point of space?",
        ),
        Misconception(
            wrong.last_column,
            "NumPy's SVD gives its last factor transposed. Is the solution then a row or a column?",
        ),
        Misconception(
            wrong.largest_singular_value,
            "Do you take the vector that makes the errors smallest, or largest?",
        ),
        Misconception(
            wrong.first_factor,
            "The first factor has a row for each equation. Which one has a row for each unknown?",
        ),
        Misconception(
            wrong.equations_of_u_only,
            "How many equations does each picture give, and how many has your table?",
            also=[wrong.equations_of_v_only],
        ),
        Misconception(
            wrong.first_two_cameras,
            "Right for two cameras. Are the equations of all the others in your table?",
        ),
        Misconception(
            wrong.last_camera_only,
            "Your table has two rows. Are those of every camera in it when it is solved?",
            also=[wrong.first_camera_only],
        ),
        Misconception(
            wrong.one_matrix_for_all,
            "Every pixel has a camera of its own. Which pixel and which matrix does your loop use?",
            also=[wrong.one_pixel_for_all],
        ),
        Misconception(
            wrong.rows_in_pairs,
            "Print the shape of your table. Has it a row for each equation, and four columns?",
            also=[wrong.rows_in_pairs_and_last_of_each, wrong.rows_in_pairs_with_other_signs],
        ),
        Misconception(
            wrong.whole_factor,
            "You divide a whole table by one of its rows. Which single row of it is the solution?",
            also=[wrong.whole_factor_with_other_signs],
        ),
        Misconception(
            wrong.first_row_in_both,
            "The second equation is that of v. Which two letters of the first change in it?",
            also=[wrong.u_in_both],
        ),
        Misconception(
            wrong.zero_for_the_solution,
            "Zeros fulfil these equations exactly. What keeps h from being zero?",
        ),
        Misconception(
            wrong.sign_of_the_last_column,
            "You take the last column to the other side of the equations. With which sign?",
        ),
        Misconception(
            wrong.both_equations_in_one_row,
            "Are two equations one row of your table, one after the other? How many unknowns are "
            "there?",
            also=[wrong.all_in_one_row],
        ),
        Misconception(
            wrong.singular_values,
            "These are singular values: lengths of errors. Which factor holds the vectors?",
        ),
        Misconception(
            wrong.three_rows_a_camera,
            "Without noise it is right. How many rows for each camera does the task name?",
        ),
    ],
)

REFINE_POINT = Exercise(
    "triangulation",
    plain.refine_point,
    points=10,
    compare=Close(rtol=1e-5, atol=1e-5),
    parts={
        "two cameras": Part(inputs.guess_from_two, cases=1, weight=5),
        "four cameras, with noise": Part(inputs.guess_from_four, cases=1, weight=5),
    },
    forbidden=(
        "course_lib.triangulation.many_views.refine_point",
        "course_lib.triangulation.many_views.triangulate_linear",
        "course_lib.triangulation.two_views.triangulate",
    ),
    misconceptions=[
        Misconception(
            step.uphill,
            "Your step leads away. Are r and the right side of the equations of the same sign?",
        ),
        Misconception(
            step.step_only,
            "Your answer is near zero. Is it a point, or the way to it?",
        ),
        Misconception(
            step.measured_pixel_in_J,
            "J describes the camera at the guess. Are the u and v in it projected, or measured?",
        ),
        Misconception(
            step.depth_left_out_of_J,
            "Twice as far away, a pixel moves half as much. Where does your J get smaller?",
        ),
        Misconception(
            step.depth_taken_for_constant,
            "Both x and w change with the point. What does the change of w do to u?",
        ),
        Misconception(
            step.sign_in_the_derivative,
            "If only w grows, does u become larger or smaller? What sign has that part in J?",
        ),
        Misconception(
            step.only_one_term_divided,
            "Both parts of the derivative are divided by w. Where are your brackets?",
        ),
        Misconception(
            step.squared_depth,
            "How often is your derivative divided by w: is one w in u already?",
        ),
        Misconception(
            step.same_pixel_in_both_rows,
            "The first row belongs to u. Which pixel coordinate belongs to the second row?",
        ),
        Misconception(
            step.depth_in_the_world,
            "w is the depth before this camera. Is that the Z of the world?",
        ),
        Misconception(
            step.columns_for_rows,
            "Are m1, m2, m3 rows of P, or its columns?",
        ),
        Misconception(
            step.camera_after_camera,
            "All cameras are to agree on one step. Do you solve once, or once for each of them?",
        ),
        Misconception(
            step.first_row_for_v,
            "Which row of P makes v? Is it in the derivative of v?",
        ),
        Misconception(
            step.last_column_left_out,
            "Where is the point (0, 0, 0) in your pictures: does the last column of P take part?",
        ),
        Misconception(
            step.measured_for_residuals,
            "The numbers in your r are hundreds of pixels. Which two pixels make a residual?",
            also=[step.measured_with_the_other_sign, step.projected_for_residuals],
        ),
        Misconception(
            step.matrix_not_inverted,
            "You multiply by JᵀJ. On which side of the normal equations does it stand?",
        ),
        Misconception(
            step.pixels_not_divided,
            "x and y are not pixels yet. What are they divided by?",
        ),
        Misconception(
            step.downhill_only,
            "This goes straight down, however far. What tells the length of a Gauss–Newton step?",
        ),
        Misconception(
            step.four_columns,
            "How many columns has your J, and how many numbers of the point can change?",
        ),
        Misconception(
            step.until_nothing_moves,
            "Your point is better than asked for. How many steps does the task name?",
            also=[step.two_steps],
        ),
        Misconception(
            step.equations_of_u,
            "How many residuals does each picture give, and how many has your r?",
        ),
        Misconception(
            step.first_camera,
            "One picture cannot tell the depth. Are the rows of every camera in your J?",
            also=[step.last_camera],
        ),
        Misconception(
            step.two_cameras_of_all,
            "Right for two cameras. Are the rows of all the others in your J?",
        ),
        Misconception(
            step.order_of_rows_mixed,
            "In which order are the rows of J, and in which order is r?",
        ),
        Misconception(
            step.all_that_lstsq_gives,
            "NumPy's `lstsq` gives four things at once. Which of them is the step?",
        ),
    ],
)
