"""Exercises of chapter 02 in the plane: points, lines, infinity."""

from __future__ import annotations

from course_lib import homogeneous
from course_lib.exercises.homogeneous import inputs
from course_lib.exercises.homogeneous import plane_misconceptions as wrong
from course_lib.judging import Exercise, Misconception, Part, UpToScale

TO_HOMOGENEOUS = Exercise(
    "homogeneous",
    homogeneous.to_homogeneous,
    points=3,
    parts={
        "points of the plane": inputs.plane_points,
        "points of space": inputs.space_points,
        "a single point": inputs.a_single_point,
    },
    misconceptions=[
        Misconception(
            wrong.zero_appended,
            "A zero at the end means a direction, which a translation cannot move. "
            "Which number lets a translation act?",
        ),
        Misconception(
            wrong.one_for_all,
            "You appended a single number. How many points came in, and where is their table now?",
        ),
        Misconception(
            wrong.one_in_front,
            "At which end of the row does the course keep w? Look at the example.",
        ),
        Misconception(
            wrong.only_for_the_plane,
            "What became of the third coordinate of the points of space?",
        ),
        Misconception(
            wrong.points_as_columns,
            "Is a point a row or a column in this course? Look at the shape of what went in.",
        ),
        Misconception(
            wrong.last_number_made_one,
            "You changed the coordinates. Does a point move when you only write it differently?",
        ),
        Misconception(
            wrong.as_many_ones_as_coordinates,
            "You append a one for each coordinate. How many more numbers does a point need?",
        ),
    ],
    forbidden=("cv2.convertPointsToHomogeneous",),
)

FROM_HOMOGENEOUS = Exercise(
    "homogeneous",
    homogeneous.from_homogeneous,
    points=5,
    parts={
        "points of the plane": Part(inputs.scaled_plane_points, weight=1),
        "points of space": Part(inputs.scaled_space_points, weight=1),
        "a single point": Part(inputs.scaled_point, weight=1),
        "points at infinity": Part(inputs.some_at_infinity, weight=2),
    },
    misconceptions=[
        Misconception(
            wrong.last_number_dropped,
            "(2, 4, 1) and (4, 8, 2) are the same point. Do they stay the same in your function?",
        ),
        Misconception(
            wrong.infinity_divided,
            "What does a division by zero give, and what should a point at infinity say instead?",
        ),
        Misconception(
            wrong.one_kept,
            "How many coordinates has an ordinary point, and how many do you return?",
        ),
        Misconception(
            wrong.always_third,
            "Your function knows the plane. Where is w in a point of space?",
        ),
        Misconception(
            wrong.divided_by_first,
            "Which number of the row is the scale: the first or the last?",
        ),
        Misconception(
            wrong.infinity_left_as_it_is,
            "You return a place for a point at infinity. Is there such a place in the plane?",
        ),
        Misconception(
            wrong.negative_w_refused,
            "Only the ratio counts. Which point is (−6, −8, −2), and what do you make of it?",
        ),
        Misconception(
            wrong.rows_for_numbers,
            "One point comes out right. Of a table with points in rows, what do `[:-1]` and `[-1]` "
            "pick, or `[:2]` and `[2]`: numbers of each row, or whole rows?",
            also=[wrong.first_rows_for_numbers],
        ),
    ],
    forbidden=("cv2.convertPointsFromHomogeneous",),
)

LINE_THROUGH = Exercise(
    "homogeneous",
    homogeneous.line_through,
    points=5,
    parts={
        "slanted lines": inputs.slanted_line,
        "lines straight up": inputs.vertical_line,
        "points of any w": inputs.points_of_any_w,
        "a point at infinity": inputs.line_to_infinity,
        "many pairs, in rows": inputs.several_lines,
    },
    compare=UpToScale(rows=True),
    misconceptions=[
        Misconception(
            wrong.w_ignored,
            "The points come with any w. Does your line still pass through them when w is not one?",
        ),
        Misconception(
            wrong.slope_and_intercept,
            "Which slope has a line straight up? Is there a way that needs no division at all?",
        ),
        Misconception(
            wrong.direction_for_normal,
            "The numbers a and b say which way is across the line. Which way do yours point?",
        ),
        Misconception(
            wrong.sign_of_c,
            "Put one of the points into your line's equation. Is the sum zero? Mind c.",
        ),
        Misconception(
            wrong.middle_sign_forgotten,
            "Put one of the points into your line's equation: the sum is not zero. Which of its "
            "three terms has the wrong sign?",
        ),
        Misconception(
            wrong.difference_of_points,
            "A difference says how to go from one point to the other. Is that a line's equation?",
        ),
        Misconception(
            wrong.scalar_product,
            "The scalar product is one number. How many numbers has a line?",
        ),
        Misconception(
            wrong.number_by_number,
            "Number times number: is that perpendicular to both? Which product of vectors is?",
        ),
        Misconception(
            wrong.slope_and_height_alone,
            "You give a line two numbers, slope and height. Which two has a line straight up, and "
            "how many has a homogeneous line?",
        ),
    ],
)

MEET = Exercise(
    "homogeneous",
    homogeneous.meet,
    points=5,
    parts={
        "two lines": Part(inputs.two_lines, weight=2),
        "parallel lines": Part(inputs.parallel_lines, weight=2),
        "many pairs, in rows": Part(inputs.several_meetings, weight=1),
    },
    compare=UpToScale(rows=True),
    misconceptions=[
        Misconception(
            wrong.c_on_the_other_side,
            "On which side of its equation does a line keep c? Put your point into both lines.",
        ),
        Misconception(
            wrong.determinant_with_wrong_sign,
            "Put your point into both equations: one term is off. Which of your three terms is it?",
        ),
        Misconception(
            wrong.must_be_finite,
            "Railway lines meet too, only not in the plane. Must the third number be one?",
        ),
        Misconception(
            wrong.x_and_y_exchanged,
            "Try x being 2 and y being 3, two easy lines. Which of your numbers comes first?",
        ),
        Misconception(
            wrong.lines_added,
            "The sum of two lines is a third line. Which vector is perpendicular to both?",
        ),
        Misconception(
            wrong.ordinary_point,
            "You return an ordinary point, two numbers. Which two has the point of parallel "
            "lines, and how many has a homogeneous one?",
        ),
    ],
)
