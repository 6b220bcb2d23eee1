"""Exercise of chapter 09 on rays and a plane of light."""

from __future__ import annotations

from course_lib.exercises.triangulation import inputs, plain
from course_lib.exercises.triangulation import plane_misconceptions as wrong
from course_lib.judging import Exercise, Misconception, Part

INTERSECT_RAY_PLANE = Exercise(
    "triangulation",
    plain.intersect_ray_plane,
    points=7,
    parts={
        "light before the camera": Part(inputs.light_before_the_camera, cases=1, weight=4),
        "some rays go away from the plane": Part(inputs.some_rays_go_away, cases=1, weight=3),
    },
    forbidden=("course_lib.triangulation.rays.intersect_ray_plane",),
    misconceptions=[
        Misconception(
            wrong.sign_of_the_length,
            "Put your length back into the plane's equation. Is it zero, or does a sign differ?",
            also=[wrong.sign_without_nan],
        ),
        Misconception(
            wrong.sign_of_d,
            "When d goes to the other side of the equation, together with the origin, which signs "
            "do both have?",
            also=[
                wrong.sign_of_d_without_nan,
                wrong.sign_of_the_origin,
                wrong.sign_of_the_origin_without_nan,
            ],
        ),
        Misconception(
            wrong.d_left_out,
            "Does your plane pass through the point (0, 0, 0)? Which number says where it is?",
            also=[wrong.d_left_out_without_nan],
        ),
        Misconception(
            wrong.begun_at_zero,
            "The rays begin at the camera. Is that the point (0, 0, 0) of the world?",
            also=[wrong.begun_at_zero_without_nan],
        ),
        Misconception(
            wrong.length_from_zero,
            "How far it is to the plane depends on where the ray begins. Does your length?",
            also=[wrong.length_from_zero_without_nan],
        ),
        Misconception(
            wrong.origin_not_added,
            "You have the way from the camera to the plane. Where does it begin?",
            also=[wrong.origin_not_added_without_nan],
        ),
        Misconception(
            wrong.behind_let_pass,
            "Right for rays that meet the plane. What does a negative length mean?",
        ),
        Misconception(
            wrong.sign_of_the_length_lost,
            "Right for rays that meet the plane. Do the others meet it in the point that you give?",
        ),
        Misconception(
            wrong.rows_left_out,
            "How many rays came in, and how many rows go out?",
        ),
        Misconception(
            wrong.zeros_for_nan,
            "A row of zeros is a place in the world. What marks a row that has no answer?",
        ),
        Misconception(
            wrong.nan_for_those_in_front,
            "Which rays go away from the plane: those with a positive length, or the others?",
        ),
        Misconception(
            wrong.sign_of_the_slope,
            "A camera can be on either side of the plane. What is negative for rays that go away: "
            "the slope, or the length?",
            also=[wrong.other_sign_of_the_slope],
        ),
        Misconception(
            wrong.a_length_for_each_axis,
            "Print the shape of your lengths. Is there one for each ray?",
            also=[wrong.summed_over_the_rays, wrong.star_in_the_slope],
        ),
        Misconception(
            wrong.first_ray_only,
            "There is one point only. How many rays came in, and where is your return?",
        ),
        Misconception(
            wrong.shortened_for_the_length_only,
            "You shorten the arrows before you take the length. Which arrows do you walk along?",
        ),
        Misconception(
            wrong.nan_in_one_column,
            "A row has three numbers. How many of them are NaN in yours?",
        ),
        Misconception(
            wrong.nan_for_all_rays,
            "Some of these rays do meet the plane. Why are they NaN as well?",
            also=[wrong.one_nan_for_all],
        ),
        Misconception(
            wrong.nan_for_negative_numbers,
            "A place of the world may have negative numbers. What is negative for a ray that goes "
            "away: its point, or its length?",
        ),
        Misconception(
            wrong.camera_for_nan,
            "A length of 0 leads to the camera itself. What marks a row that has no answer?",
        ),
        Misconception(
            wrong.lengths_only,
            "These are lengths along the rays. Where in space do they lead?",
        ),
        Misconception(
            wrong.lengths_not_in_a_column,
            "Print the shapes. Is n times o a single number (`@`), and do your lengths stand in a "
            "column, so that each belongs to one row of directions?",
            also=[wrong.star_in_the_origins_place],
        ),
        Misconception(
            wrong.unit_normal_but_old_d,
            "You shorten a, b and c. What becomes of the equation if d stays as it was?",
            also=[wrong.unit_normal_without_nan],
        ),
        Misconception(
            wrong.not_divided_by_the_slope,
            "A ray that grazes the plane has a long way to it. Do all of yours go equally far?",
            also=[wrong.not_divided_without_nan],
        ),
    ],
)
