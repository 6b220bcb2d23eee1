"""Exercises of chapter 09 on points: the linear method, one step to the best one, covariance."""

from __future__ import annotations

from course_lib.exercises.triangulation import covariance_misconceptions as spread
from course_lib.exercises.triangulation import inputs, plain
from course_lib.exercises.triangulation import point_misconceptions as wrong
from course_lib.judging import Close, Exercise, Misconception, Part
from course_lib.judging.matching import SameShape

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
            "u is p1 X over p3 X. Multiplied out and brought to one side: which sign is there?",
        ),
        Misconception(
            wrong.third_row_forgotten,
            "You subtract from u itself. Which row of P does u multiply?",
        ),
        Misconception(
            wrong.columns_for_rows,
            "Your table has three columns. Are p1, p2, p3 rows of P, or its columns?",
            also=[wrong.columns_and_last_number],
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
            "Your table has two rows. Does the loop keep the rows of the cameras before?",
            also=[wrong.first_camera_only],
        ),
        Misconception(
            wrong.one_matrix_for_all,
            "Every pixel has a camera of its own. Which matrix does your loop use?",
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
            wrong.uphill,
            "Your step leads away. Are r and the right side of the equations of the same sign?",
        ),
        Misconception(
            wrong.step_only,
            "Your answer is near zero. Is it a point, or the way to it?",
            also=[wrong.negative_step_only],
        ),
        Misconception(
            wrong.measured_pixel_in_J,
            "J describes the camera at X. Are the u and v in it projected, or measured?",
        ),
        Misconception(
            wrong.depth_left_out_of_J,
            "Twice as far away, a pixel moves half as much. Where does your J get smaller?",
        ),
        Misconception(
            wrong.depth_taken_for_constant,
            "Both a and c change with X. What does the change of c do to u?",
        ),
        Misconception(
            wrong.sign_in_the_derivative,
            "If only c grows, does u become larger or smaller? What sign has that part in J?",
        ),
        Misconception(
            wrong.only_one_term_divided,
            "Both parts of the derivative are divided by c. Where are your brackets?",
        ),
        Misconception(
            wrong.squared_depth,
            "How often is your derivative divided by c: is one c in u already?",
        ),
        Misconception(
            wrong.same_pixel_in_both_rows,
            "The first row belongs to u. Which pixel coordinate belongs to the second row?",
        ),
        Misconception(
            wrong.pixels_not_divided,
            "a and b are not pixels yet. What are they divided by?",
        ),
        Misconception(
            wrong.downhill_only,
            "This goes straight down, however far. What tells the length of a Gauss–Newton step?",
        ),
        Misconception(
            wrong.four_columns,
            "How many columns has your J, and how many numbers of X can change?",
        ),
        Misconception(
            wrong.until_nothing_moves,
            "Your point is better than asked for. How many steps does the task name?",
            also=[wrong.two_steps],
        ),
        Misconception(
            wrong.equations_of_u,
            "How many residuals does each picture give, and how many has your r?",
        ),
        Misconception(
            wrong.first_camera,
            "One picture cannot tell the depth. Are the rows of every camera in your J?",
            also=[wrong.last_camera],
        ),
        Misconception(
            wrong.two_cameras_of_all,
            "Right for two cameras. Are the rows of all the others in your J?",
        ),
        Misconception(
            wrong.order_of_rows_mixed,
            "In which order are the rows of J, and in which order is r?",
        ),
        Misconception(
            wrong.all_that_lstsq_gives,
            "NumPy's `lstsq` gives four things at once. Which of them is the step?",
        ),
    ],
)

POINT_COVARIANCE = Exercise(
    "triangulation",
    plain.point_covariance,
    points=6,
    parts={
        "two cameras": Part(inputs.uncertain_from_two, cases=1, weight=3),
        "five cameras": Part(inputs.uncertain_from_five, cases=1, weight=3),
    },
    forbidden=("course_lib.triangulation.many_views.point_covariance",),
    misconceptions=[
        Misconception(
            spread.sigma_not_squared,
            "A covariance of lengths is in squared units. Is your sigma a deviation or a variance?",
        ),
        Misconception(
            spread.sigma_left_out,
            "Suppose the pixels were measured twice as badly. Does your answer notice?",
        ),
        Misconception(
            spread.divided_by_sigma,
            "Pixels that are measured badly: does your point become better then?",
        ),
        Misconception(
            spread.not_inverted,
            "The more strongly a point moves the pixels, the better it is known. Is it so in "
            "yours?",
            also=[spread.not_inverted_but_divided],
        ),
        Misconception(
            spread.rows_for_unknowns,
            "Your table has a row for each residual. Which product with J has one for each "
            "unknown?",
            compare=SameShape(),
        ),
        Misconception(
            spread.inverted_entry_by_entry,
            "You turn each entry over by itself. Which function of NumPy inverts a whole matrix?",
        ),
        Misconception(
            spread.roots_of_the_diagonal,
            "These are three numbers. Of which table are they taken?",
            also=[spread.variances_only],
        ),
        Misconception(
            spread.roots_of_all,
            "Is the whole table asked for, or a root of each of its entries?",
        ),
        Misconception(
            spread.diagonal_only,
            "Errors of X and of Z go together if the rays are oblique. Where is that in yours?",
        ),
        Misconception(
            spread.each_axis_alone,
            "You took each axis alone. Do the pixels tell X without knowing Z?",
        ),
        Misconception(
            spread.divided_by_rows,
            "You divide by a count. Does J not have more rows already, the more cameras there are?",
            also=[spread.divided_by_cameras, spread.divided_by_freedom],
        ),
        Misconception(
            spread.first_two_cameras,
            "Right for two cameras. Are the rows of all the others in your J?",
        ),
        Misconception(
            spread.depth_left_out_of_J,
            "Twice as far away, a pixel moves half as much. Where does your J get smaller?",
        ),
        Misconception(
            spread.depth_taken_for_constant,
            "Both a and c change with X. What does the change of c do to u?",
        ),
        Misconception(
            spread.sign_in_the_derivative,
            "If only c grows, does u become larger or smaller? What sign has that part in J?",
        ),
        Misconception(
            spread.only_one_term_divided,
            "Both parts of the derivative are divided by c. Where are your brackets?",
        ),
        Misconception(
            spread.pixels_not_divided,
            "a and b are not pixels yet. What are they divided by?",
        ),
        Misconception(
            spread.same_pixel_in_both_rows,
            "The first row belongs to u. Which pixel coordinate belongs to the second row?",
        ),
        Misconception(
            spread.four_columns,
            "How many columns has your J, and how many numbers of X can change?",
        ),
    ],
)
