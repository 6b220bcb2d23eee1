"""Exercises of chapter 06 on homographies."""

from __future__ import annotations

from course_lib import homography
from course_lib.exercises.estimation import misconceptions_planes as wrong
from course_lib.exercises.estimation import plane_inputs as inputs
from course_lib.judging import Exercise, Misconception, Part, UpToScale

APPLY_HOMOGRAPHY = Exercise(
    "estimation",
    homography.apply_homography,
    points=5,
    parts={
        "an affine matrix": Part(inputs.affine_matrix, cases=2, weight=1),
        "a wall seen at a slant": Part(inputs.wall_in_a_picture, cases=2, weight=2),
        "a single point": Part(inputs.one_point, cases=2, weight=1),
        "points that go to infinity": Part(inputs.some_to_infinity, cases=2, weight=1),
    },
    misconceptions=[
        Misconception(
            wrong.not_divided,
            "H gives three numbers for a point. Which step makes two coordinates of them?",
        ),
        Misconception(
            wrong.matrix_not_transposed,
            "Points are rows here. What must happen to a matrix that multiplies from the right?",
        ),
        Misconception(
            wrong.zero_for_one,
            "A zero at the end of a row means a direction. Which number means a point?",
        ),
        Misconception(
            wrong.way_back,
            "Your map undoes H. In which direction were the points to go?",
        ),
        Misconception(
            wrong.one_divisor_for_all,
            "You divide all points by the same number. Does every point have the same w?",
        ),
        Misconception(
            wrong.three_numbers_for_a_point,
            "How many coordinates has a point of the plane, and how many do you return?",
        ),
        Misconception(
            wrong.infinity_divided,
            "What does a division by zero give, and what does the task want for such a point?",
        ),
        Misconception(
            wrong.infinity_left_undivided,
            "A point with w of zero gets ordinary coordinates from you. Is it anywhere in the "
            "plane?",
        ),
        Misconception(
            wrong.v_before_u,
            "Which row of H makes the first coordinate?",
        ),
    ],
    forbidden=("cv2.perspectiveTransform",),
)

NORMALISE_POINTS = Exercise(
    "estimation",
    homography.normalise_points,
    points=5,
    parts={
        "pixels": Part(inputs.pixels_of_a_picture, cases=2, weight=2),
        "points of a wall, in metres": Part(inputs.points_of_a_facade, cases=2, weight=1),
        "points of space": Part(inputs.points_of_space, cases=2, weight=2),
    },
    misconceptions=[
        Misconception(
            wrong.distance_of_one,
            "How far from the origin are your points on average, and how far should they be?",
        ),
        Misconception(
            wrong.root_two_in_space_too,
            "In the plane you are right. Which distance does the task want for points of space?",
        ),
        Misconception(
            wrong.root_mean_square_distance,
            "You average squares and take the root at the end. Of what is the mean asked for?",
        ),
        Misconception(
            wrong.each_axis_by_itself,
            "You stretch each axis by a factor of its own. How many factors does the task allow?",
            also=[wrong.each_axis_to_one],
        ),
        Misconception(
            wrong.distance_before_the_shift,
            "From where did you measure the distances: from the origin, or from the mean?",
        ),
        Misconception(
            wrong.scaled_the_other_way,
            "Points that are spread widely: should your factor be large for them, or small?",
        ),
        Misconception(
            wrong.shift_not_scaled_in_T,
            "Your points are right, T is not. Is the shift made before the scaling, or after it?",
        ),
        Misconception(
            wrong.shift_to_the_wrong_side_in_T,
            "Your points are right, T is not. Where does T send the mean of the points?",
        ),
        Misconception(
            wrong.T_of_the_way_back,
            "Your points are right. Which way does your T lead: to the normalised points, or back?",
        ),
        Misconception(
            wrong.one_mean_for_all_axes,
            "You take one mean of all numbers. How many coordinates has the middle of the points?",
        ),
        Misconception(
            wrong.T_before_the_points,
            "You return the right two things. In which order are they asked for?",
        ),
    ],
)

HOMOGRAPHY_DLT = Exercise(
    "estimation",
    homography.homography_dlt,
    points=10,
    parts={
        "four points": Part(inputs.four_corners, cases=2, weight=3),
        "more points than needed": Part(inputs.many_corners, cases=2, weight=3),
        "points with errors": Part(inputs.corners_with_errors, cases=2, weight=4),
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
            wrong.still_normalised,
            "Your H takes normalised points to normalised targets. How do you get in and out?",
        ),
        Misconception(
            wrong.undone_in_the_wrong_order,
            "A point meets the rightmost matrix first. Which of the two T is made for points?",
            also=[wrong.undone_on_the_wrong_side],
        ),
        Misconception(
            wrong.done_once_more,
            "Put a point into your product, from right to left: is it first normalised, or first "
            "taken back?",
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
            "NumPy gives the vectors already transposed. Are they rows or columns then?",
        ),
        Misconception(
            wrong.read_column_by_column,
            "Look at the order of h in your rows of A. Does it fill H row by row?",
        ),
        Misconception(
            wrong.wrong_sign_in_the_rows,
            "Bring everything to one side of the equation. Which sign do the last three get?",
        ),
        Misconception(
            wrong.from_targets_to_points,
            "Your H leads from the targets to the points. Which way was asked for?",
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
