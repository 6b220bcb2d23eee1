"""Exercises of chapter 03 on where an image is, how large, and what a lens is called."""

from __future__ import annotations

from course_lib import optics
from course_lib.exercises.lenses import inputs
from course_lib.exercises.lenses import misconceptions_imaging as wrong
from course_lib.exercises.lenses import misconceptions_slips as slips
from course_lib.judging import Exercise, Misconception, Part

IMAGE_DISTANCE = Exercise(
    "lenses",
    optics.image_distance,
    parts={
        "an object": Part(inputs.some_object, weight=1.5),
        "several objects at once": Part(inputs.several_objects, weight=1.5),
        "a star among several objects": Part(inputs.star_among_objects, weight=1),
    },
    misconceptions=[
        Misconception(
            wrong.powers_added,
            "A nearer object has its image farther behind the lens. Does yours move that way?",
        ),
        Misconception(
            wrong.not_inverted_back,
            "Which unit has your answer: is it a length, or one divided by a length?",
            also=[slips.powers_added_and_not_inverted_back],
        ),
        Misconception(
            wrong.in_front_of_the_lens,
            "Your distance is negative. On which side of the lens does the sensor stand?",
        ),
        Misconception(
            wrong.always_at_the_focal_point,
            "This is where the image of a star is. Must the lens move when you focus closer?",
        ),
        Misconception(
            wrong.from_the_focal_point,
            "For a very distant object your answer goes to zero. From which point do you measure?",
        ),
        Misconception(
            wrong.nothing_at_infinity,
            "What is infinity divided by infinity? Rewrite the formula so that 1 divided by Z "
            "stands in it.",
        ),
        Misconception(
            slips.image_bracket_lost,
            "Python divides before it subtracts. Which difference of your formula stands below a "
            "bar, and do brackets hold it?",
            also=[slips.image_powers_bracket_lost, slips.image_sum_bracket_lost],
        ),
        Misconception(
            slips.image_turned_over_term_by_term,
            "You turned each fraction over by itself. Try it with 1/2 - 1/4: what is one divided "
            "by it, and what gives your way?",
        ),
    ],
)

OBJECT_DISTANCE = Exercise(
    "lenses",
    optics.object_distance,
    parts={
        "images smaller than the object": inputs.smaller_than_life,
        "images larger than the object": inputs.larger_than_life,
    },
    misconceptions=[
        Misconception(
            wrong.image_side,
            "To make the image smaller, step back. Does your distance grow when m gets smaller?",
        ),
        Misconception(
            wrong.one_forgotten,
            "Nearly right when m is tiny. At life size, object and image are equally far from the "
            "lens: how far?",
        ),
        Misconception(
            wrong.virtual_image,
            "At life size your object touches the lens. Which sign has the thin-lens equation?",
            also=[slips.virtual_image_turned],
        ),
        Misconception(
            wrong.object_to_sensor,
            "You measure from the object to the sensor. Where should the tape measure end?",
        ),
        Misconception(
            wrong.magnification_alone,
            "A lens has no real image of an object inside its focal length. Is yours outside?",
        ),
        Misconception(
            wrong.bracket_forgotten,
            "Python multiplies before it adds. Which part of your sum does f reach?",
        ),
        Misconception(
            slips.object_in_metres,
            "A thousand times too small. In which unit does f come, and should the answer go?",
        ),
    ],
)

F_NUMBER = Exercise(
    "lenses",
    optics.f_number,
    points=2,
    parts={"one opening": inputs.opening, "several openings": inputs.several_openings},
    misconceptions=[
        Misconception(
            wrong.f_number_inverted,
            "At f/8 the opening is an eighth of the focal length. Which of the two is larger?",
        ),
        Misconception(
            wrong.radius_for_diameter,
            "Is d the whole width of the opening, or from its middle to its rim?",
        ),
        Misconception(
            wrong.ratio_squared,
            "The light goes with the square. Does the number that is engraved on the lens?",
        ),
        Misconception(
            wrong.rounded_to_a_full_stop,
            "Which opening do you compute with: the one you are given, or the nearest click of "
            "the ring?",
        ),
    ],
)

LENS_SYSTEM = Exercise(
    "lenses",
    optics.lens_system,
    points=6,
    parts={
        "two lenses that collect light": inputs.two_that_collect,
        "collect, then spread (a telephoto lens)": inputs.telephoto,
        "spread, then collect (a retrofocus lens)": inputs.retrofocus,
    },
    misconceptions=[
        Misconception(
            wrong.light_from_behind,
            "A matrix acts on what stands right of it. Which lens does the light meet first?",
        ),
        Misconception(
            wrong.gap_in_the_wrong_place,
            "Read your product from right to left, as the light goes. Where is the gap?",
        ),
        Misconception(
            wrong.element_by_element,
            "For arrays, Python has two signs that multiply. Which of them goes row by column?",
        ),
        Misconception(
            wrong.lenses_touching,
            "You add the powers as if the lenses touched. What happens to a ray in the gap?",
        ),
        Misconception(
            wrong.sign_of_the_power,
            "A single collecting lens bends rays towards the axis: is its C positive or negative?",
        ),
        Misconception(
            wrong.focal_points_for_planes,
            "These are the places of the focal points. How far from its focal point is a principal "
            "plane?",
        ),
        Misconception(
            wrong.planes_exchanged,
            "Which plane belongs to rays that come in parallel: the front or the back one?",
        ),
        Misconception(
            wrong.gap_left_out_of_the_power,
            "Both planes are right. For the focal length you add the powers only: what does the "
            "gap do to them?",
        ),
        Misconception(
            wrong.back_plane_from_the_first_lens,
            "Two numbers of three are right. From which lens does the task measure the back plane?",
        ),
        Misconception(
            slips.power_for_focal_length,
            "Your first number is tiny. Which unit has C, and which has a focal length?",
            also=[slips.power_with_its_sign_turned],
        ),
        Misconception(
            slips.planes_turned,
            "Right distance, wrong side of the lens. What comes first in the fraction of the "
            "text: the 1, or the entry of the matrix? And has your C its minus?",
            also=[slips.front_plane_turned, slips.back_plane_turned],
        ),
        Misconception(
            slips.planes_brackets_lost,
            "Python divides before it adds and subtracts. Do brackets hold together what stands "
            "above, and what below a bar?",
            also=[slips.power_bracket_lost],
        ),
        Misconception(
            slips.gap_added_to_the_power,
            "A gap makes two collecting lenses weaker together. Does the third term of your C "
            "do that?",
        ),
    ],
)
