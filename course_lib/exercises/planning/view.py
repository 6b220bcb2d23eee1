"""Exercises of chapter 11 on what a camera sees of a box, and how fine."""

from __future__ import annotations

from course_lib.exercises.planning import inputs, plain
from course_lib.exercises.planning import resolution_misconceptions as coarse
from course_lib.exercises.planning import view_misconceptions as wrong
from course_lib.judging import Exercise, Misconception, Part

BOX_IN_VIEW = Exercise(
    "planning",
    plain.box_in_view,
    points=8,
    parts={
        "a box at rest": Part(inputs.at_rest, cases=1, weight=3),
        "a box that moves": Part(inputs.moving, cases=1, weight=4),
        "a corner behind the camera": Part(inputs.around_the_camera, cases=1, weight=1),
    },
    forbidden=("course_lib.planning.view.box_in_view",),
    misconceptions=[
        Misconception(
            wrong.motion_forgotten,
            "Right at rest. By how much is the room larger that a moving box needs?",
        ),
        Misconception(
            wrong.motion_shared,
            "It moves that far to each side. By how much does its whole room grow then?",
            also=[wrong.motion_counted_twice],
        ),
        Misconception(
            wrong.motion_to_one_side,
            "It moves to both sides. Does your room grow on one of them only?",
            also=[wrong.motion_to_the_other_side],
        ),
        Misconception(
            wrong.motion_taken_off,
            "Does a box that moves need more room than one at rest, or less?",
        ),
        Misconception(
            wrong.whole_edges_to_each_side,
            "Your box is too large. How far is it from its middle to a face?",
            also=[wrong.whole_edges_and_twice_the_motion],
        ),
        Misconception(
            wrong.begins_at_the_middle,
            "The centre is the middle of the box. Does yours begin there?",
        ),
        Misconception(
            wrong.only_the_middle,
            "You follow the middle only. Which points of a box come nearest to the edges?",
        ),
        Misconception(
            wrong.two_corners,
            "You take two opposite corners. Why could another one lie farther out in the picture?",
        ),
        Misconception(
            wrong.one_face,
            "That is one face with four corners. How many corners has a box?",
            also=[wrong.other_face],
        ),
        Misconception(
            wrong.place_forgotten,
            "Your box stands in the origin of the world. Where is it really?",
        ),
        Misconception(
            wrong.half_pixels_forgotten,
            "Nearly. Is the edge of a picture the middle of its outermost pixels?",
            also=[
                wrong.last_pixel_for_the_edge,
                wrong.half_pixel_on_one_side,
                wrong.half_pixel_the_other_way,
            ],
        ),
        Misconception(
            wrong.nearest_to_the_wrong_edge,
            "Which corner is nearest to the left edge: that with the smallest u or the largest?",
        ),
        Misconception(
            wrong.far_sides_negative,
            "A box well inside the picture: should its room on the right be negative?",
        ),
        Misconception(
            wrong.size_exchanged,
            "Which comes first in the size of a picture, its width or its height?",
        ),
        Misconception(
            wrong.top_and_bottom_exchanged,
            "From which edge of the picture is v counted: from the top, or from the bottom?",
        ),
        Misconception(
            wrong.left_and_right_exchanged,
            "From which edge of the picture is u counted: from the left, or from the right?",
        ),
        Misconception(
            wrong.order_of_a_frame,
            "The numbers are right. In which order are they asked for?",
        ),
        Misconception(
            wrong.division_forgotten,
            "P gives three numbers for each corner. How do two pixel coordinates come of them?",
        ),
        Misconception(
            wrong.yes_or_no,
            "That says whether it fits. How much room is left on each of the four sides?",
        ),
        Misconception(
            wrong.smallest_only,
            "That is the smallest room. What is it on each of the four sides?",
        ),
        Misconception(
            wrong.room_not_below_zero,
            "A box that is cut off: by how much? What do you give there?",
        ),
        Misconception(
            wrong.behind_is_before,
            "Right in front of the camera. What does P make of a point behind it?",
            also=[wrong.behind_left_out, wrong.behind_turned_round],
        ),
        Misconception(
            wrong.below_the_ground,
            "Which number says that a corner is in front of the camera: its Z in the world?",
        ),
        Misconception(
            wrong.nan_for_behind,
            "You found the corner without an image. Which four numbers are asked for then?",
            also=[
                wrong.one_number_for_behind,
            ],
        ),
    ],
)

OBJECT_RESOLUTION = Exercise(
    "planning",
    plain.object_resolution,
    points=5,
    parts={
        "a surface that faces the camera": Part(inputs.facing, cases=1, weight=2),
        "a tilted surface": Part(inputs.tilted, cases=2, weight=3),
    },
    forbidden=("course_lib.planning.view.object_resolution",),
    misconceptions=[
        Misconception(
            coarse.millimetres,
            "In which unit is your answer, and which one is asked for?",
            also=[coarse.micrometres, coarse.focal_length_in_mm],
        ),
        Misconception(
            coarse.brackets_left_out,
            "Python multiplies what follows a division. Is your focal length all below the line?",
        ),
        Misconception(
            coarse.pitch_upside_down,
            "A longer lens sees finer details. Does yours?",
        ),
        Misconception(
            coarse.pixels_per_metre,
            "That is how many pixels there are in a metre. How many metres are there in a pixel?",
            also=[coarse.pixels_per_metre_tilted],
        ),
        Misconception(
            coarse.distance_below,
            "Farther away, a pixel covers more. Does your answer grow with the distance?",
        ),
        Misconception(
            coarse.distance_left_out,
            "Your answer does not know how far away the surface is. Where does that come in?",
        ),
        Misconception(
            coarse.lens_left_out,
            "Your answer is the same with any lens. What does the focal length do?",
        ),
        Misconception(
            coarse.tilt_forgotten,
            "Right for a surface that faces the camera. What does foreshortening do to the other?",
        ),
        Misconception(
            coarse.times_the_cosine,
            "Seen from the side, does a pixel cover more of the surface, or less?",
        ),
        Misconception(
            coarse.coarsest_first,
            "Which of your two numbers is the finer one, and which is asked for first?",
        ),
        Misconception(
            coarse.finer_by_a_tilt,
            "Can a surface be seen finer by tilting it away?",
        ),
        Misconception(
            coarse.both_tilted,
            "Along the axis about which it is tilted: is the surface foreshortened there?",
        ),
        Misconception(
            coarse.sine_for_cosine,
            "Without any tilt nothing should change. What does your angle function give there?",
            also=[coarse.tangent_for_cosine],
        ),
        Misconception(
            coarse.radians_of_radians,
            "In which unit does the tilt come, and which one does `np.cos` want?",
            also=[coarse.degrees_of_radians],
        ),
        Misconception(
            coarse.cosine_twice,
            "You foreshorten twice. By which factor is a tilted line shorter?",
        ),
        Misconception(
            coarse.one_number_only,
            "One number came. For which two directions of the surface is one asked for?",
            also=[coarse.finest_only],
        ),
    ],
)
