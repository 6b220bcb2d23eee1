"""Exercises of chapter 03 on what is sharp: depth of field, aperture."""

from __future__ import annotations

from course_lib import optics
from course_lib.exercises.lenses import inputs
from course_lib.exercises.lenses import misconceptions_sharpness as wrong
from course_lib.exercises.lenses import misconceptions_slips as slips
from course_lib.judging import Exercise, Misconception, Part

HYPERFOCAL_DISTANCE = Exercise(
    "lenses",
    optics.hyperfocal_distance,
    parts={
        "one lens": Part(inputs.lens_for_landscapes, weight=3),
        "several f-numbers at once": inputs.several_stops,
    },
    misconceptions=[
        Misconception(
            wrong.focal_length_neglected,
            "Very close: you measure from the focal point before the lens. Where does the task "
            "measure from?",
        ),
        Misconception(
            wrong.focal_length_not_squared,
            "Which unit does your first term have? N has none.",
            also=[slips.doubled_for_squared],
        ),
        Misconception(
            slips.hyperfocal_sum_below,
            "Which part of the box is a fraction, and which stands beside it? Do your brackets "
            "say so?",
            also=[slips.hyperfocal_sum_above],
        ),
        Misconception(
            wrong.radius_of_the_spot,
            "Is c the diameter of the spot, or its radius?",
        ),
        Misconception(
            wrong.spot_in_micrometres,
            "Some kilometres too far. In which unit does c come?",
        ),
        Misconception(
            slips.spot_of_the_street_camera,
            "This is right for the street camera alone. Which argument have you not used?",
        ),
        Misconception(
            wrong.half_the_way,
            "From there on all is sharp when the lens is focused right. But where is the focus?",
        ),
        Misconception(
            wrong.diameter_for_f_number,
            "Stop the lens down: N grows. Should the range of sharpness begin nearer or farther?",
        ),
        Misconception(
            wrong.spot_above_the_bar,
            "Python works from left to right. Does your line leave c below the fraction bar, or "
            "put it above?",
        ),
        Misconception(
            wrong.focal_length_taken_off,
            "Very close. Solve for H once more: on which side of the equation do you take f away?",
        ),
        Misconception(
            wrong.answer_in_metres,
            "Your number is a thousand times too small. In which unit do all lengths come and go "
            "here?",
        ),
    ],
)

DEPTH_OF_FIELD = Exercise(
    "lenses",
    optics.depth_of_field,
    points=6,
    parts={
        "focused before the hyperfocal distance": Part(inputs.before_hyperfocal, weight=2),
        "focused beyond it": Part(inputs.beyond_hyperfocal, weight=2),
        "focused exactly on it": Part(inputs.exactly_hyperfocal, weight=1, cases=2),
        "several focus distances at once": Part(inputs.focus_distances, weight=1),
    },
    misconceptions=[
        Misconception(
            wrong.far_limit_behind_the_camera,
            "Your far limit is negative: behind the camera. What does it mean that even a star is "
            "sharp?",
        ),
        Misconception(
            wrong.focal_length_small_enough,
            "A good rule for far things. Which f did you leave out beside the focus distance, and "
            "beside H?",
        ),
        Misconception(
            wrong.far_before_near,
            "Which of your two limits is nearer to the camera, and which should come first?",
        ),
        Misconception(
            wrong.twice_the_spot,
            "Is c the diameter of the largest spot allowed, or its radius?",
        ),
        Misconception(
            wrong.same_on_both_sides,
            "Does the spot grow equally fast before and behind the focus? Try a star.",
        ),
        Misconception(
            wrong.measured_from_the_focus,
            "You measure from the plane of focus. Where does the task measure from?",
        ),
        Misconception(
            wrong.decides_once,
            "An `if` looks at one number. How does NumPy choose for each entry of an array?",
        ),
        Misconception(
            wrong.divides_before_it_chooses,
            "`np.where` gets both values ready before it chooses. What happens to the one that "
            "it will not take?",
        ),
        Misconception(
            wrong.sign_taken_off,
            "Without its sign the number looks like a distance, but does the spot ever reach c "
            "out there? Try a star.",
        ),
        Misconception(
            wrong.handbook_with_the_exact_hyperfocal,
            "This is the short form of the handbooks, with the exact H in it. Where does the box "
            "have a focal length more?",
        ),
        Misconception(
            wrong.handbook_with_half_of_the_focal_lengths,
            "Nearly the exact formula: which of your focal lengths is still too many, if you "
            "start from the number a?",
        ),
        Misconception(
            slips.depth_bracket_lost,
            "Python multiplies and divides before it adds. Do brackets hold together what the "
            "formula has in brackets, or below a bar?",
            also=[slips.depth_bracket_moved, slips.near_bracket_lost, slips.both_brackets_lost],
        ),
        Misconception(
            slips.one_choice_only,
            "Beyond H your far limit is the focus distance itself. Your first choice only made "
            "the division harmless: which second one is missing?",
        ),
        Misconception(
            slips.star_sharp_beyond_only,
            "On H itself, a is exactly 1. To which side does your condition count it, and is a "
            "star sharp there?",
        ),
        Misconception(
            slips.choice_turned,
            "Infinity stands where the far limit is finite. Is the number a below 1 or above it, "
            "when the lens is focused before H?",
        ),
        Misconception(
            slips.number_with_a_unit,
            "The number a has no unit. Has yours one?",
            also=[slips.number_with_a_square_of_a_unit],
        ),
    ],
)

APERTURE_FOR_DEPTH = Exercise(
    "lenses",
    optics.aperture_for_depth,
    points=6,
    parts={
        "a range with two ends": Part(inputs.depth_range, weight=2),
        "from here to infinity": Part(inputs.range_to_infinity, weight=1),
    },
    misconceptions=[
        Misconception(
            wrong.halfway,
            "Focused halfway, one end is blurred more than the other. Which one, and where would "
            "both be equal?",
        ),
        Misconception(
            wrong.halfway_and_only_far,
            "The far end is sharp. Have you looked at the near one?",
        ),
        Misconception(
            wrong.focused_on_the_far_end,
            "The far end is perfectly sharp, but only one side of the focus is used. What lies "
            "behind it?",
        ),
        Misconception(
            wrong.focal_length_not_taken_off,
            "When the lens is focused close by, does the sensor still stand at the focal length?",
        ),
        Misconception(
            wrong.spot_as_a_radius,
            "Is c the diameter of the largest spot allowed, or its radius?",
        ),
        Misconception(
            wrong.focus_before_f_number,
            "Your two numbers may be right. In which order does the task want them?",
        ),
        Misconception(
            wrong.no_focus_for_infinity,
            "What is infinity divided by infinity? Can you write the focus distance with 1 divided "
            "by far?",
        ),
        Misconception(
            wrong.halfway_in_the_box,
            "The box for N holds for one focus distance only. Did you take that one, or the "
            "middle of the range?",
        ),
        Misconception(
            wrong.multiplied_by_the_way_to_the_focus,
            "Python works from left to right. Is the way to the focus still below the fraction "
            "bar in your line?",
        ),
        Misconception(
            wrong.two_lost,
            "Compare your focus distance with the near end. Is the lens focused inside the range "
            "at all?",
        ),
        Misconception(
            slips.no_number_for_infinity,
            "The focus is right, also for infinity. What becomes of the last fraction of N there, "
            "if you divide above and below by the far end first?",
        ),
        Misconception(
            slips.focus_bracket_lost,
            "Python multiplies and divides before it adds. Do brackets hold together what stands "
            "below each bar?",
            also=[
                slips.focus_bracket_lost_for_infinity,
                slips.focus_double_fraction_lost,
                slips.number_bracket_lost,
                slips.number_last_bracket_lost,
            ],
        ),
        Misconception(
            slips.spot_squared_too,
            "Your f-number is far too large. What does your square reach: f alone, or c too?",
        ),
        Misconception(
            slips.aperture_not_squared,
            "An f-number has no unit. Which unit has yours?",
        ),
        Misconception(
            slips.negative_aperture,
            "Your f-number is negative. Which end of the range is farther away?",
        ),
    ],
)

CLOSEUP_DEPTH_OF_FIELD = Exercise(
    "lenses",
    optics.closeup_depth_of_field,
    parts={
        "a part of a machine": Part(inputs.machine_part, weight=1.5),
        "under a microscope": Part(inputs.microscope, weight=1.5),
        "several magnifications at once": inputs.several_closeups,
    },
    misconceptions=[
        Misconception(
            wrong.one_side_only,
            "The sharp range reaches to both sides of the focus. How many sides did you count?",
        ),
        Misconception(
            wrong.small_magnification,
            "At small m you are nearly right. How far is the sensor from the lens at life size?",
        ),
        Misconception(
            wrong.magnification_not_squared,
            "Compare m at 1/20 and 1/10. By which factor should the depth shrink, roughly?",
        ),
        Misconception(
            wrong.magnification_upside_down,
            "A microscope sees a very thin layer only. Does your depth shrink when m grows?",
        ),
        Misconception(
            wrong.on_the_sensor_side,
            "This is how far the sensor may be off. How long is that in front of the lens?",
        ),
        Misconception(
            wrong.star_for_a_power,
            "One star multiplies in Python. How many stars make a power?",
        ),
        Misconception(
            wrong.closeup_bracket_forgotten,
            "Python divides before it adds. What belongs above the fraction bar, and how does "
            "Python see it?",
        ),
        Misconception(
            slips.closeup_one_taken_off,
            "At life size your depth is zero. Which sign has the bracket of the box?",
        ),
        Misconception(
            slips.closeup_in_micrometres,
            "A factor of a thousand. In which unit does c come, and should the depth go?",
            also=[slips.closeup_in_metres],
        ),
    ],
)
