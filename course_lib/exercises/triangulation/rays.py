"""Exercises of chapter 09 on two rays: where they come closest, and the point halfway."""

from __future__ import annotations

from course_lib.exercises.triangulation import inputs, plain
from course_lib.exercises.triangulation import midpoint_misconceptions as middle
from course_lib.exercises.triangulation import ray_misconceptions as wrong
from course_lib.judging import Exercise, Misconception, Part

CLOSEST_POINTS_ON_RAYS = Exercise(
    "triangulation",
    plain.closest_points_on_rays,
    points=7,
    parts={
        "directions of length 1": Part(inputs.unit_rays, cases=1, weight=4),
        "directions of any length": Part(inputs.rays_of_any_length, cases=1, weight=3),
    },
    forbidden=("course_lib.triangulation.rays.closest_points_on_rays",),
    misconceptions=[
        Misconception(
            wrong.directions_taken_for_unit,
            "With arrows of length 1 it is right. What is d1 times d1 if the arrow is longer?",
        ),
        Misconception(
            wrong.made_unit_for_the_lengths_only,
            "You solve with shortened arrows. With which arrows do you walk along the ray then?",
        ),
        Misconception(
            wrong.sign_of_the_second_length,
            "Bring all unknowns to one side. Which sign does the part with d2 get there?",
        ),
        Misconception(
            wrong.difference_the_other_way,
            "Your first point lies behind its origin. Which origin is subtracted from the other?",
            also=[wrong.other_difference_and_sign],
        ),
        Misconception(
            wrong.first_origin_only,
            "If both origins move alike, so do the points. Which origins are on your right side?",
            also=[wrong.second_origin_only],
        ),
        Misconception(
            wrong.star_for_matrix_product,
            "Print the shape of your unknowns: are they three numbers? Which sign multiplies a "
            "matrix by a vector?",
        ),
        Misconception(
            wrong.rows_for_columns,
            "λ1 multiplies all three numbers of d1. Do they stand in a column of your matrix?",
            also=[wrong.rows_and_sign],
        ),
        Misconception(
            wrong.sign_of_the_common_normal,
            "Your first point is right. Is the other ray on the side where n points?",
        ),
        Misconception(
            wrong.unit_normal_taken,
            "Your first point is right. How long is the n with which μ was found: is it 1?",
        ),
        Misconception(
            wrong.mu_for_the_second_length,
            "In which order are your columns, and in which order do the unknowns come out?",
        ),
        Misconception(
            wrong.products_for_the_normal,
            "Is your third direction perpendicular to both rays? Which product of NumPy gives it?",
        ),
        Misconception(
            wrong.nearest_to_the_other_origin,
            "Your point is nearest to the place where the other ray begins. Is that asked for?",
        ),
        Misconception(
            wrong.lengths_returned,
            "These are lengths along the rays. Where in space do they lead?",
            also=[wrong.all_unknowns_returned],
        ),
        Misconception(
            wrong.middle_returned,
            "This is the middle of two points. Which two?",
        ),
        Misconception(
            wrong.points_swapped,
            "Both points are right. Which of them lies on the first ray?",
        ),
        Misconception(
            wrong.lengths_swapped,
            "Along which ray do you walk λ1, and along which one λ2?",
        ),
        Misconception(
            wrong.origins_forgotten,
            "Your ways along the rays are right. Where do they begin?",
        ),
        Misconception(
            wrong.both_from_the_first_origin,
            "Your first point is right. Where does the second ray begin?",
        ),
    ],
)

TRIANGULATE_MIDPOINT = Exercise(
    "triangulation",
    plain.triangulate_midpoint,
    points=7,
    parts={
        "rays that meet": Part(inputs.rays_meet, cases=1, weight=4),
        "rays that miss each other": Part(inputs.rays_miss, cases=1, weight=3),
    },
    forbidden=(
        "course_lib.triangulation.rays.triangulate_midpoint",
        "course_lib.triangulation.two_views.triangulate",
        "course_lib.triangulation.many_views.triangulate_linear",
        "cv2.triangulatePoints",
    ),
    misconceptions=[
        Misconception(
            middle.M_not_inverted,
            "M makes pixels of directions. Which way do you have to go here?",
            also=[middle.pixel_for_the_direction],
        ),
        Misconception(
            middle.M_transposed,
            "M⁻¹ works on a column here. On which side of the pixel does it stand?",
        ),
        Misconception(
            middle.transpose_for_inverse,
            "Only of a rotation the transpose is the inverse. Is M a rotation?",
            also=[middle.transpose_in_the_centre, middle.transpose_in_both],
        ),
        Misconception(
            middle.one_in_front,
            "In which place of the pixel's three numbers is the 1?",
        ),
        Misconception(
            middle.third_row_for_p,
            "P has three rows and four columns. Is q a row or a column?",
        ),
        Misconception(
            middle.arguments_out_of_order,
            "In which order does the helper want its four arguments: are the origins side by side?",
        ),
        Misconception(
            middle.star_in_the_direction,
            "Print the shape of your directions: are they three numbers? Which sign multiplies a "
            "matrix by a vector?",
        ),
        Misconception(
            middle.star_in_the_centre,
            "Print the shape of your centres: are they three numbers? Which sign multiplies a "
            "matrix by a vector, and is q cut out as `P[:, 3]`?",
            also=[middle.q_as_a_table],
        ),
        Misconception(
            middle.third_number_zero,
            "A pixel has two numbers and M⁻¹ three columns. Which number do you append?",
        ),
        Misconception(
            middle.last_column_for_the_centre,
            "q is not yet the place of the camera. What does P make of its own centre?",
            also=[middle.minus_last_column],
        ),
        Misconception(
            middle.sign_of_the_centre,
            "Multiply P with your centre and a 1: are there three zeros?",
        ),
        Misconception(
            middle.direction_taken_for_a_point,
            "You subtract the centre from M⁻¹ times the pixel. Is that a point, or a direction?",
        ),
        Misconception(
            middle.pixels_swapped,
            "Which camera took pixel1, and which one pixel2?",
            also=[middle.one_pixel_for_both],
        ),
        Misconception(
            middle.first_camera_for_both,
            "Both directions come from the same M. Which camera saw the second pixel?",
        ),
        Misconception(
            middle.point_on_the_first_ray,
            "Right where the rays meet. Where they miss, your point lies on which of them?",
            also=[middle.point_on_the_second_ray],
        ),
        Misconception(
            middle.half_of_the_difference,
            "This is half of the way between the points. From where do you have to go it?",
            also=[middle.half_of_the_other_difference],
        ),
        Misconception(
            middle.sum_not_halved,
            "The middle of 2 and 4 is 3. What do you get from 2 and 4?",
            also=[middle.only_one_halved],
        ),
        Misconception(
            middle.both_points,
            "These are the two closest points. Which single point is asked for?",
        ),
        Misconception(
            middle.mean_of_all_numbers,
            "A mean of X, Y and Z together is no place. Of which numbers is each mean taken?",
            also=[middle.mean_of_each_point],
        ),
        Misconception(
            middle.middle_of_the_centres,
            "This lies between the cameras. Between which two points should it lie?",
        ),
    ],
)
