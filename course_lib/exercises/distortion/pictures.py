"""Exercises of chapter 05 on pictures: the map that undistorts one, and lines that are straight."""

from __future__ import annotations

from course_lib import distortion
from course_lib.exercises.distortion import inputs, plain
from course_lib.exercises.distortion import picture_misconceptions as wrong
from course_lib.judging import Close, Exercise, Misconception, Part

UNDISTORTION_MAP = Exercise(
    "distortion",
    plain.undistortion_map,
    points=7,
    compare=Close(rtol=0, atol=1e-4),
    parts={
        "square pixels": Part(inputs.square_pixels, cases=2, weight=4),
        "pixels that are not square": Part(inputs.oblong_pixels, cases=2, weight=3),
    },
    forbidden=(
        "course_lib.distortion.pictures.undistortion_map",
        "course_lib.distortion.pixels.distort_pixels",
        "cv2.initUndistortRectifyMap",
    ),
    misconceptions=[
        Misconception(
            wrong.mapped_forward,
            "For each pixel of the new picture you ask where to look in the old one. Which "
            "direction of the lens is that?",
        ),
        Misconception(
            wrong.pixels_bent,
            "The lens model wants tangents. Are the pixels of a grid tangents?",
            also=[wrong.only_put_on],
        ),
        Misconception(
            wrong.pixels_from_the_centre_bent,
            "Measured from the centre, but still in px. What else does K take off?",
        ),
        Misconception(
            wrong.not_bent,
            "Your map looks at each pixel's own place: the picture stays as it is. Where do you "
            "distort?",
        ),
        Misconception(
            wrong.grid_exchanged,
            "`np.meshgrid` takes the columns first, then the rows. In which order does your grid "
            "run through the pixels?",
            also=[wrong.grid_of_exchanged_sizes],
        ),
        Misconception(
            wrong.left_as_tangents,
            "Your map holds tangents. What makes pixels of them?",
        ),
        Misconception(
            wrong.centre_not_put_back,
            "Your map is negative in the top left part. Which piece of K have you left off?",
        ),
        Misconception(
            wrong.rows_before_columns,
            "Which of the two maps should come first: columns, or rows?",
        ),
        Misconception(
            wrong.width_before_height,
            "Is the first number of an array's shape its width, or its height?",
        ),
        Misconception(
            wrong.filled_in_the_wrong_order,
            "All numbers are there, but in which shape did you put them back?",
            also=[wrong.filled_and_turned],
        ),
        Misconception(
            wrong.first_focal_length_for_both,
            "Right for square pixels. Which focal length belongs to the rows?",
        ),
        Misconception(
            wrong.centre_of_the_picture,
            "Is the principal point the middle of the picture? Which numbers of K say where it is?",
            also=[wrong.middle_of_the_pixels],
        ),
        Misconception(
            wrong.first_pixel_is_one,
            "Which numbers does the first pixel have in this course?",
            also=[wrong.first_pixel_is_half],
        ),
        Misconception(
            wrong.whole_pixels,
            "Must one look at a whole pixel only, or also between two?",
            also=[wrong.rounded_down],
        ),
        Misconception(
            wrong.displacements,
            "Is this where to look, or how far from there?",
        ),
        Misconception(
            wrong.size_exchanged,
            "Print the shape of your map. Does image_size begin with the width or the height, and "
            "does `np.meshgrid` take columns or rows first?",
        ),
        Misconception(
            wrong.left_flat,
            "A map has rows and columns, like a picture. Which shape has yours?",
        ),
        Misconception(
            wrong.both_in_one_table,
            "You put both maps into one array. How many results are asked for?",
        ),
        Misconception(
            wrong.centre_exchanged,
            "Which number of K is the centre's column, and which one its row?",
        ),
        Misconception(
            wrong.centre_left_out,
            "From where do tangents count: from the corner of the picture, or from the principal "
            "point?",
            also=[wrong.centre_not_taken_off],
        ),
        Misconception(
            wrong.stretched_to_the_width,
            "Print the columns of one row of your grid. How far is it from one pixel to the next?",
        ),
        Misconception(
            wrong.quotient_before_difference,
            "Python divides before it subtracts. What belongs above the fraction bar?",
        ),
    ],
)

STRAIGHTNESS = Exercise(
    "distortion",
    distortion.straightness,
    points=5,
    parts={
        "gentle lines": Part(inputs.gentle_line, cases=2, weight=1),
        "steep lines": Part(inputs.steep_line, cases=2, weight=1),
    },
    misconceptions=[
        Misconception(
            wrong.vertical_distances,
            "You measure straight up. What happens to that for a line that is nearly vertical?",
        ),
        Misconception(
            wrong.line_of_vertical_distances,
            "You measure across the line, but is it the one that fits best across?",
        ),
        Misconception(
            wrong.spread_of_y,
            "You measure how far the points are from their mean height. What would a slanted line "
            "get that is perfectly straight?",
            also=[wrong.spread_of_y_by_one_less],
        ),
        Misconception(
            wrong.divided_by_all_numbers,
            "`size` counts numbers, two for each point. How many points are there?",
        ),
        Misconception(
            wrong.mean_distance,
            "This is a mean of distances. What does the first word of root mean square say?",
        ),
        Misconception(
            wrong.largest_distance,
            "This depends on the worst points alone. Which mean of all of them is asked for?",
            also=[wrong.from_side_to_side],
        ),
        Misconception(
            wrong.root_forgotten,
            "In which unit is your answer, if the points are in px?",
        ),
        Misconception(
            wrong.mean_forgotten,
            "Twice as many points along the same line: should the answer grow?",
        ),
        Misconception(
            wrong.signed_mean,
            "Your answer is zero for every line. Print it before the last step: what cancels out?",
            also=[wrong.centred_by_point],
        ),
        Misconception(
            wrong.by_the_ends,
            "You trust the first and the last point. Do they lie on the best line?",
        ),
        Misconception(
            wrong.along_the_line,
            "Your number is as long as the line. Is the best line's direction the first or the "
            "last one?",
        ),
        Misconception(
            wrong.not_centred,
            "Through which point does the best line pass? Does yours pass there?",
            also=[wrong.measured_from_the_origin, wrong.one_mean_for_both],
        ),
        Misconception(
            wrong.by_freedom,
            "A mean over all points: by which number do you divide?",
            also=[wrong.by_one_less],
        ),
        Misconception(
            wrong.divided_by_the_count,
            "Your number is a root already. What becomes of the number of points below a root?",
        ),
    ],
)
