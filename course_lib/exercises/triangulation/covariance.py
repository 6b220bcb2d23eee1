"""Exercise of chapter 09 on the covariance of a point."""

from __future__ import annotations

from course_lib.exercises.triangulation import covariance_misconceptions as wrong
from course_lib.exercises.triangulation import inputs, plain
from course_lib.judging import Exercise, Misconception, Part
from course_lib.judging.matching import SameShape

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
            wrong.sigma_not_squared,
            "A covariance of lengths is in squared units. Is your sigma a deviation or a variance?",
        ),
        Misconception(
            wrong.sigma_counted_twice,
            "Each row of J stands for one measured number already, a u or a v. What does your 2 "
            "count?",
            also=[wrong.twice_sigma_squared],
        ),
        Misconception(
            wrong.sigma_left_out,
            "Suppose the pixels were measured twice as badly. Does your answer notice?",
        ),
        Misconception(
            wrong.divided_by_sigma,
            "Pixels that are measured badly: does your point become better then?",
        ),
        Misconception(
            wrong.not_inverted,
            "The more strongly a point moves the pixels, the better it is known. Is it so in "
            "yours?",
            also=[wrong.not_inverted_but_divided],
        ),
        Misconception(
            wrong.rows_for_unknowns,
            "Your table has a row for each residual. Which product with J has one for each "
            "unknown?",
            compare=SameShape(),
        ),
        Misconception(
            wrong.inverted_entry_by_entry,
            "You turn each entry over by itself. Which function of NumPy inverts a whole matrix?",
        ),
        Misconception(
            wrong.roots_of_the_diagonal,
            "These are three numbers. Of which table are they taken?",
            also=[wrong.variances_only],
        ),
        Misconception(
            wrong.roots_of_all,
            "Is the whole table asked for, or a root of each of its entries?",
        ),
        Misconception(
            wrong.diagonal_only,
            "Errors of X and of Z go together if the rays are oblique. Where is that in yours?",
        ),
        Misconception(
            wrong.each_axis_alone,
            "You took each axis alone. Do the pixels tell X without knowing Z?",
        ),
        Misconception(
            wrong.divided_by_rows,
            "You divide by a count. Does J not have more rows already, the more cameras there are?",
            also=[wrong.divided_by_cameras, wrong.divided_by_freedom],
        ),
        Misconception(
            wrong.equations_of_u,
            "How many rows has your J? Does each picture not measure u and v?",
        ),
        Misconception(
            wrong.last_column_left_out,
            "Your JᵀJ has no inverse, whatever comes out. Has J the rows of every camera, and "
            "three columns? Does the last column of P take part in x, y and w?",
            also=[wrong.four_columns, wrong.last_camera_only],
        ),
        Misconception(
            wrong.first_row_for_v,
            "Which row of P makes v? Is it in the derivative of v?",
        ),
        Misconception(
            wrong.first_two_cameras,
            "Right for two cameras. Are the rows of all the others in your J?",
        ),
        Misconception(
            wrong.depth_left_out_of_J,
            "Twice as far away, a pixel moves half as much. Where does your J get smaller?",
        ),
        Misconception(
            wrong.depth_taken_for_constant,
            "Both x and w change with the point. What does the change of w do to u?",
        ),
        Misconception(
            wrong.sign_in_the_derivative,
            "If only w grows, does u become larger or smaller? What sign has that part in J?",
        ),
        Misconception(
            wrong.only_one_term_divided,
            "Both parts of the derivative are divided by w. Where are your brackets?",
        ),
        Misconception(
            wrong.pixels_not_divided,
            "x and y are not pixels yet. What are they divided by?",
        ),
        Misconception(
            wrong.same_pixel_in_both_rows,
            "The first row belongs to u. Which pixel coordinate belongs to the second row?",
        ),
    ],
)
