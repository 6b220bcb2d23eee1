"""Exercise of chapter 11 on the apertures between defocus and diffraction."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from course_lib.exercises.planning import aperture_misconceptions as wrong
from course_lib.exercises.planning import inputs, plain
from course_lib.judging import Case, Close, Exercise, Misconception, Part

LEAST, MOST = 0, 1


def only_right(place: int) -> Callable[[Case, Any], bool]:
    """Return what tells whether, of a wrong answer, this one of both f-numbers is right."""

    def tell(case: Case, got: Any) -> bool:
        two = got.tolist() if isinstance(got, np.ndarray) else got
        if not isinstance(two, tuple | list) or len(two) != 2:
            return False
        return Close()(two[place], wrong.window(**case.inputs)[place]) is None

    return tell


APERTURE_WINDOW = Exercise(
    "planning",
    plain.aperture_window,
    points=8,
    parts={
        "an open window": Part(inputs.flat_object, cases=1, weight=3),
        "a closed window": Part(inputs.deep_object, cases=1, weight=1),
    },
    forbidden=(
        "course_lib.planning.depth.aperture_window",
        "course_lib.optics.aperture_choice.aperture_for_depth",
        "course_lib.optics.aperture_choice.apertures_for_limits",
    ),
    misconceptions=[
        Misconception(
            wrong.ends_exchanged,
            "An f-number is positive. Which end lies beyond the focus?",
        ),
        Misconception(
            wrong.near_end_over_far,
            "The least f-number is that of one end. Do both of its distances belong to that end?",
            also=[wrong.far_end_over_near],
        ),
        Misconception(
            wrong.focus_in_the_middle,
            "With the focus halfway, are both ends equally sharp?",
            also=[wrong.focus_in_the_middle_and_near_end],
        ),
        Misconception(
            wrong.focus_on_the_near_end,
            "You focus on the near end. How sharp is the far end then?",
        ),
        Misconception(
            wrong.two_forgotten,
            "Let both ends come together. Is your focus there too?",
        ),
        Misconception(
            wrong.f_not_squared,
            "An f-number has no unit. Which unit has yours, and which length is missing?",
        ),
        Misconception(
            wrong.brackets_left_out,
            "Python multiplies what follows a division. Which of your brackets is missing?",
            also=[
                wrong.brackets_left_out_of_both,
                wrong.brackets_left_out_of_the_most,
                wrong.brackets_left_out_of_the_focus,
            ],
        ),
        Misconception(
            wrong.without_f_below,
            "Which of the distances below the line is measured from the lens's focal point?",
            also=[wrong.f_added_below],
        ),
        Misconception(
            wrong.whole_depth,
            "From where to where is the distance above the line: from the near end?",
        ),
        Misconception(
            wrong.mixed_units,
            "Distances, focal length and spot come in three units. Which one do you compute in?",
            also=[wrong.distances_not_in_mm, wrong.focal_length_not_in_metres],
        ),
        Misconception(
            wrong.spot_in_mm,
            "How large is the spot in metres, and how large in yours?",
            also=[wrong.spot_in_mm_for_both, wrong.spot_in_um],
        ),
        Misconception(
            wrong.wavelength_in_mm,
            "The least is right. In which units are the spot and the wavelength in the other one?",
        ),
        Misconception(
            wrong.always_green,
            "The least is right. Is the light green each time? How would your function know?",
        ),
        Misconception(
            wrong.magnification_forgotten,
            "The least is right. Is a near object's image as close to the lens as that of a star?",
        ),
        Misconception(
            wrong.magnification_over_s,
            "The least is right. By which distance is f divided in the magnification?",
            also=[wrong.magnification_upside_down],
        ),
        Misconception(
            wrong.magnification_multiplied,
            "The least is right. Does a closer object make the disk larger or smaller?",
        ),
        Misconception(
            wrong.radius_of_the_disk,
            "The least is right. Is the other one held against the radius of the disk?",
        ),
        Misconception(
            wrong.radius_of_the_spot,
            "Is the spot that is allowed given by its radius, or by its diameter?",
            also=[wrong.half_the_spot],
        ),
        Misconception(
            wrong.upside_down,
            "A deeper object needs a smaller aperture: a larger f-number, or a smaller one?",
        ),
        Misconception(
            wrong.diffraction_upside_down,
            "The least is right. May a larger spot have a larger f-number, or only a smaller one?",
        ),
        Misconception(
            wrong.most_first,
            "Which of your two f-numbers keeps both ends sharp, and which is asked for first?",
        ),
        Misconception(
            wrong.in_order_of_size,
            "You put the two in order. How can one see then that no aperture does both?",
            also=[wrong.not_above_the_most],
        ),
        Misconception(
            wrong.refused,
            "Where no aperture does both, which two numbers still say so?",
            also=[wrong.nothing_where_closed],
        ),
        Misconception(
            wrong.with_the_focus,
            "Which two numbers are asked for: the ends of what?",
            also=[wrong.least_only, wrong.yes_or_no, wrong.width_of_the_window],
        ),
        Misconception(
            wrong.factor_of_the_disk_forgotten,
            "The least is right. Which disk does diffraction draw, and how large may it be?",
            explains=only_right(LEAST),
        ),
        Misconception(
            wrong.far_end_forgotten_below,
            "The most is right. Has every length of the other formula its place in yours?",
            explains=only_right(MOST),
        ),
    ],
)
