"""Exercises of chapter 04 on what moves while a camera looks, and on stripes that shift."""

from __future__ import annotations

from course_lib import illumination, sensor
from course_lib.exercises.sensor import light_inputs as inputs
from course_lib.exercises.sensor import motion_misconceptions as wrong
from course_lib.judging import Exercise, Misconception, Part

MOTION_BLUR_PIXELS = Exercise(
    "sensor",
    sensor.motion_blur_pixels,
    points=3,
    parts={
        "a part on a belt (mm)": inputs.part_on_a_belt,
        "a drone above the ground (m)": inputs.drone,
        "several speeds at once": inputs.several_speeds,
    },
    misconceptions=[
        Misconception(
            wrong.whole_pixels,
            "A smear of 0.4 px is a smear. What does your function make of it?",
            also=[wrong.whole_pixels_up, wrong.whole_pixels_down],
        ),
        Misconception(
            wrong.units_converted,
            "Speed and pixel size come in one unit of length. Why do you convert?",
            also=[wrong.units_converted_back],
        ),
        Misconception(
            wrong.length_on_the_object,
            "That is how far the object moves, as a length. How many pixels does it cover?",
        ),
        Misconception(
            wrong.pixel_size_multiplied,
            "With finer pixels the same way covers more of them. Does your result grow then?",
        ),
        Misconception(wrong.divided_by_time, "Does a shorter exposure smear more, or less?"),
        Misconception(
            wrong.pixels_upside_down,
            "Let the object stand still. How long is the smear, and what do you get?",
        ),
        Misconception(
            wrong.only_half_of_it,
            "From where does the smear start, and where does it end? Measure its whole length.",
        ),
    ],
)

ROLLING_SHUTTER_SKEW = Exercise(
    "sensor",
    sensor.rolling_shutter_skew,
    points=3,
    parts={
        "an edge that moves to the right": inputs.to_the_right,
        "an edge that moves to the left": inputs.to_the_left,
        "several edges at once": inputs.several_edges,
    },
    misconceptions=[
        Misconception(
            wrong.one_row_only,
            "That is the step from one row to the next. How many such steps lead to the bottom?",
        ),
        Misconception(
            wrong.microseconds_converted,
            "You convert the time of a row. In which unit does it come into your function?",
        ),
        Misconception(
            wrong.divided_by_row_time,
            "Suppose the sensor reads faster. Should the picture lean more, or less?",
        ),
        Misconception(
            wrong.direction_lost,
            "An edge that moves to the left: to which side does it lean?",
        ),
        Misconception(
            wrong.leans_backwards,
            "The bottom is read last. Has the edge moved on by then, or back?",
        ),
        Misconception(
            wrong.time_per_picture,
            "The time is given for one row. Do you need the time of the whole edge, or a part?",
        ),
    ],
)

STRIPE_HEIGHT = Exercise(
    "sensor",
    illumination.stripe_height,
    parts={
        "the camera looks straight down": Part(inputs.straight_down, weight=2),
        "the camera looks from the side": Part(inputs.from_the_side, weight=1),
        "a profile with hollows": Part(inputs.profile, weight=1),
    },
    misconceptions=[
        Misconception(
            wrong.heights_added,
            "One height makes two shifts, which add up to the one you see. Do you add up heights?",
            also=[wrong.heights_added_for_slanted_cameras],
        ),
        Misconception(
            wrong.angle_from_the_table,
            "Light from straight above moves no stripe at all. Which angle is zero then?",
        ),
        Misconception(
            wrong.sine_for_tangent,
            "Draw the triangle of height, shift and light. Which two of its sides do you know of?",
        ),
        Misconception(
            wrong.camera_left_out,
            "Look at a tower from the side: where on the ground does its top seem to be?",
        ),
        Misconception(
            wrong.camera_on_the_light_side,
            "Light and camera stand on opposite sides. Do their two shifts add up, or cancel?",
        ),
        Misconception(
            wrong.tangent_of_the_sum,
            "There are two triangles, one for the light, one for the camera. What is in each?",
        ),
        Misconception(
            wrong.tangent_multiplied,
            "The flatter the light, the farther it moves for the same height. Does yours?",
        ),
        Misconception(
            wrong.angle_in_degrees,
            "Which unit does `np.tan` want, and which one do you give it?",
        ),
        Misconception(
            wrong.radians_of_radians,
            "You convert the angles. In which unit do they come into your function?",
        ),
    ],
)
