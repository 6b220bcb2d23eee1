"""Exercises of chapter 11 on flights: the size of a pixel, speed, number of pictures."""

from __future__ import annotations

from course_lib.exercises.planning import flight_misconceptions as wrong
from course_lib.exercises.planning import inputs, plain
from course_lib.judging import Exercise, Misconception, Part

GROUND_SAMPLE_DISTANCE = Exercise(
    "planning",
    plain.ground_sample_distance,
    points=4,
    parts={
        "one height": Part(inputs.one_height, cases=1, weight=3),
        "several heights at once": Part(inputs.several_heights, cases=1, weight=1),
    },
    forbidden=("course_lib.planning.flight.ground_sample_distance",),
    misconceptions=[
        Misconception(
            wrong.millimetres,
            "In which unit is your answer: is a pixel really as large as that many metres?",
            also=[wrong.centimetres],
        ),
        Misconception(
            wrong.focal_length_in_mm,
            "Height, focal length and pitch come in three units. Are all of them metres in yours?",
            also=[wrong.pitch_in_um],
        ),
        Misconception(
            wrong.brackets_left_out,
            "Python multiplies what follows a division. Is your focal length all below the line?",
        ),
        Misconception(
            wrong.pitch_upside_down,
            "With a longer lens a pixel covers less. Does it in your answer?",
            also=[wrong.plain_pitch_upside_down, wrong.pitch_upside_down_by_1000],
        ),
        Misconception(
            wrong.pixels_per_metre,
            "That is how many pixels show a metre. How many metres does a pixel show?",
        ),
        Misconception(
            wrong.height_below,
            "Fly twice as high: does a pixel cover more ground, or less?",
            also=[wrong.height_below_in_mm],
        ),
        Misconception(
            wrong.smallest_object,
            "That is the smallest object that can be told. How much does one pixel cover?",
        ),
        Misconception(
            wrong.area_of_a_pixel,
            "That is an area. How long is one side of it?",
        ),
        Misconception(
            wrong.height_left_out,
            "Your answer does not know how high the camera flies. Where does that come in?",
            also=[wrong.height_left_out_once],
        ),
        Misconception(
            wrong.focal_length_left_out,
            "Your answer is the same with every lens. What does a longer one do?",
        ),
        Misconception(
            wrong.mean_height,
            "You are given several heights. How many answers belong to them?",
        ),
        Misconception(
            wrong.rounded_to_centimetres,
            "You round. What becomes of two flights that differ by a millimetre?",
            also=[wrong.rounded_to_millimetres],
        ),
    ],
)

MAX_SPEED = Exercise(
    "planning",
    plain.max_speed,
    points=6,
    parts={
        "the interval decides": Part(inputs.interval_decides, cases=1, weight=2),
        "the smear decides": Part(inputs.smear_decides, cases=1, weight=2),
        "several flights at once": Part(inputs.several_flights, cases=1, weight=2),
    },
    forbidden=("course_lib.planning.flight.max_speed",),
    misconceptions=[
        Misconception(
            wrong.faster_one,
            "At the faster of both speeds, is the other demand still met?",
        ),
        Misconception(
            wrong.in_time_only,
            "In time for the next picture. But how many metres may it move while one is exposed?",
            also=[wrong.smear_in_pixels, wrong.pixel_below],
        ),
        Misconception(
            wrong.smear_only,
            "Sharp pictures. But is the camera ready in time for the next one?",
        ),
        Misconception(
            wrong.interval_multiplied,
            "A camera that needs longer from picture to picture: may it fly faster?",
            also=[wrong.interval_above],
        ),
        Misconception(
            wrong.exposure_multiplied,
            "With a longer exposure, may the camera fly faster, or must it fly slower?",
            also=[wrong.exposure_above],
        ),
        Misconception(
            wrong.one_whole_pixel,
            "How many pixels long may the smear be? Where is that number in your answer?",
            also=[wrong.half_a_pixel],
        ),
        Misconception(
            wrong.blur_below,
            "Accept a longer smear: may the camera fly faster then? Does yours?",
        ),
        Misconception(
            wrong.smear_not_timed,
            "How far the camera may move is a length. In which time does it move that far?",
        ),
        Misconception(
            wrong.smear_until_the_next_picture,
            "When does a picture smear: while it is exposed, or until the next one?",
        ),
        Misconception(
            wrong.both_added,
            "Two limits on one speed: do they add up?",
            also=[wrong.mean_of_both],
        ),
        Misconception(
            wrong.both_returned,
            "Those are two speeds. At which one are both demands met?",
        ),
        Misconception(
            wrong.kilometres_an_hour,
            "In which unit is your speed?",
        ),
        Misconception(
            wrong.smallest_of_all,
            "Right for one flight. With several, does each have its own limit?",
        ),
        Misconception(
            wrong.python_s_min,
            "Right for one flight. How does NumPy take the smaller ones of two arrays?",
            also=[wrong.array_in_an_if],
        ),
    ],
)

PHOTO_COUNT = Exercise(
    "planning",
    plain.photo_count,
    points=7,
    parts={
        "a field": Part(inputs.field, cases=1, weight=2),
        "a larger field": Part(inputs.larger_field, cases=1, weight=2),
        "without a rest": Part(inputs.even_field, cases=1, weight=2),
        "one strip is wide enough": Part(inputs.narrow_field, cases=1, weight=1),
    },
    forbidden=("course_lib.planning.flight.photo_count",),
    misconceptions=[
        Misconception(
            wrong.both_without_one,
            "A field as long as one base: how many pictures, one at each end?",
            also=[wrong.pictures_without_one],
        ),
        Misconception(
            wrong.strips_without_one,
            "A field as wide as a footprint and one distance: how many strips?",
        ),
        Misconception(
            wrong.rounded_down,
            "What becomes of the rest of the field where you round down?",
            also=[wrong.pictures_rounded_down, wrong.strips_rounded_down],
        ),
        Misconception(
            wrong.rounded_to_the_nearest,
            "You round to the nearest number. Where that is down, what becomes of the rest?",
        ),
        Misconception(
            wrong.not_rounded,
            "How do you take a quarter of a picture?",
        ),
        Misconception(
            wrong.one_too_many,
            "Where the base goes into the length without a rest: do you take one too many?",
            also=[wrong.pictures_one_too_many],
        ),
        Misconception(
            wrong.footprint_forgotten,
            "The first strip covers a whole footprint. How much of the width is left after it?",
            also=[wrong.footprint_and_one_forgotten, wrong.half_a_footprint_at_each_end],
        ),
        Misconception(
            wrong.strips_side_by_side,
            "Your strips lie side by side. How much do strips overlap at the distance given?",
            also=[wrong.strips_side_by_side_and_one],
        ),
        Misconception(
            wrong.no_strip_at_all,
            "A field narrower than a footprint: how many strips does it take, and what is yours?",
            also=[wrong.no_strip_is_none],
        ),
        Misconception(
            wrong.all_together,
            "That is how many pictures there are in all. Which two numbers are asked for?",
        ),
        Misconception(
            wrong.sides_of_the_field,
            "Which side of the field runs along the strips?",
        ),
        Misconception(
            wrong.steps_exchanged,
            "Which step leads from picture to picture, and which from strip to strip?",
        ),
        Misconception(
            wrong.strips_first,
            "The numbers are right. Which one is asked for first?",
        ),
        Misconception(
            wrong.pictures_beyond_both_ends,
            "More pictures beyond the ends are prudent. But how many does the exercise ask for?",
        ),
        Misconception(
            wrong.footprint_taken_off_the_length,
            "The first picture is taken above one end. Is there anything to take off the length?",
        ),
    ],
)
