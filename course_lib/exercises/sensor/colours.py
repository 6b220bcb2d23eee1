"""Exercises of chapter 04 on the colour mosaic: what it leaves, and what can be guessed."""

from __future__ import annotations

from course_lib import sensor
from course_lib.exercises.sensor import colour_misconceptions as wrong
from course_lib.exercises.sensor import picture_inputs as inputs
from course_lib.judging import Exercise, Misconception, Part

BAYER_MOSAIC = Exercise(
    "sensor",
    sensor.bayer_mosaic,
    parts={
        "red first (RGGB)": Part(inputs.red_first, weight=2),
        "blue first (BGGR)": Part(inputs.blue_first, weight=1),
        "green first (GRBG, GBRG)": Part(inputs.green_first, weight=1),
    },
    misconceptions=[
        Misconception(
            wrong.always_red_first,
            "Not every sensor begins with red. Which argument says how this one does?",
        ),
        Misconception(
            wrong.red_and_blue_exchanged,
            "In this course a colour is red, green, blue. Which layer is number 0?",
        ),
        Misconception(
            wrong.columns_before_rows,
            "Is the second letter of the pattern to the right of the first one, or below it?",
        ),
        Misconception(
            wrong.mean_of_colours,
            "Does a pixel behind a red filter know anything of green?",
        ),
        Misconception(
            wrong.three_layers,
            "How many numbers does the sensor write for one pixel?",
        ),
        Misconception(
            wrong.one_pixel_a_square,
            "Does every pixel of the picture get its filter, or only one of four?",
        ),
        Misconception(
            wrong.one_place_a_square,
            "All four pixels of your square look at one place. Where does each of them lie?",
        ),
    ],
    forbidden=("cv2.cvtColor", "cv2.demosaicing"),
)

DEMOSAIC_BILINEAR = Exercise(
    "sensor",
    sensor.demosaic_bilinear,
    points=8,
    parts={
        "a wall of one colour": Part(inputs.one_colour, weight=1),
        "many colours": Part(inputs.many_colours, weight=1),
    },
    misconceptions=[
        Misconception(
            wrong.layers_first,
            "Your colours are the first axis and should be the last. Which `axis` of `np.stack` "
            "does that?",
        ),
        Misconception(
            wrong.weights_of_green_for_all,
            "Red is known at the corners of a blue pixel. Do your weights for red reach there?",
        ),
        Misconception(
            wrong.nearest_in_the_square,
            "You take the nearest value of the same square. Which neighbours are as near on the "
            "other side?",
        ),
        Misconception(
            wrong.dark_frame,
            "The edge of your picture is too dark. How many neighbours are really there?",
        ),
        Misconception(
            wrong.blue_first,
            "Which colour has the pixel in the top left corner seen? And in your picture?",
        ),
        Misconception(
            wrong.green_in_the_corner,
            "What does the first row of the mosaic begin with: green, or red?",
        ),
        Misconception(
            wrong.seen_green_smoothed,
            "Where a pixel has seen green itself, is there anything to guess?",
            also=[wrong.seen_green_averaged],
        ),
        Misconception(
            wrong.other_side_of_the_picture,
            "What does a pixel at the left edge have to do with the right edge?",
        ),
        Misconception(
            wrong.blue_below_red,
            "The second row goes G B G B. In which of its columns have pixels seen blue?",
        ),
        Misconception(
            wrong.all_colours_summed,
            "Which pixels are in your sum for red: those that have seen red, or all?",
        ),
        Misconception(
            wrong.green_layer_first,
            "In which order should the three layers lie?",
        ),
        Misconception(
            wrong.grey_three_times,
            "A red wall: what should the green of its pixels be, and what is it in yours?",
        ),
    ],
    forbidden=("cv2.cvtColor", "cv2.demosaicing"),
)
