"""Exercises of chapter 04 on pictures: their noise, their ends, their shade."""

from __future__ import annotations

from course_lib import illumination, sensor
from course_lib.exercises.sensor import gain_misconceptions as gain_wrong
from course_lib.exercises.sensor import picture_inputs as inputs
from course_lib.exercises.sensor import picture_misconceptions as wrong
from course_lib.judging import Exercise, Explain, Misconception, Part
from course_lib.judging.comparison import Close
from course_lib.judging.matching import BothBeyond

CAMERA_GAIN_FROM_PAIRS = Exercise(
    "sensor",
    sensor.camera_gain_from_pairs,
    points=8,
    parts={
        "pairs within the range": Part(inputs.pairs_within_range, cases=1, weight=5),
        "some pairs saturated": Part(inputs.some_pairs_saturated, cases=1, weight=3),
    },
    # What chance leaves of 768 pixels, with room for other ways to fit the line.
    compare=Close(rtol=0.06, atol=0),
    misconceptions=[
        Misconception(
            gain_wrong.difference_not_halved,
            "A difference of two pictures holds the noise of both. How many times one variance "
            "is that?",
            compare=Close(rtol=0.04, atol=0),
        ),
        Misconception(
            gain_wrong.dark_not_subtracted,
            "Without light the numbers are not zero. Do those DN come from electrons of light?",
        ),
        Misconception(
            gain_wrong.dark_noise_not_subtracted,
            "The dark pictures are noisy too. Is that noise made by electrons of light?",
            compare=Close(rtol=0.01, atol=0),
        ),
        Misconception(
            gain_wrong.saturated_pairs_kept,
            "A white picture has no noise at all. Should it tell you about electrons?",
            also=[gain_wrong.line_through_saturated_pairs],
        ),
        Misconception(
            gain_wrong.partly_saturated_kept,
            "Of one of your pairs, only some pixels are at the largest number. Is its noise whole?",
            also=[gain_wrong.line_through_partly_saturated],
        ),
        Misconception(
            gain_wrong.one_picture_alone,
            "Within one picture the pixels differ for other reasons than chance. What is the "
            "second one of the pair for?",
            also=[gain_wrong.line_through_single_pictures],
        ),
        Misconception(
            gain_wrong.electrons_per_number,
            "DN per electron is asked for. Which unit does your number have?",
            compare=Close(rtol=0.04, atol=0),  # other mistakes come near by chance
        ),
        Misconception(
            gain_wrong.deviation_for_variance,
            "What grows in proportion to the number of electrons: the variance, or its root?",
            also=[gain_wrong.line_through_deviations],
        ),
        Misconception(
            gain_wrong.wraps_around,
            "Ask NumPy for `np.uint16(3) - np.uint16(5)`. Is that what you want to average?",
            also=[gain_wrong.wraps_around_whole],
            compare=BothBeyond(50),
        ),
    ],
)

CLIPPED_FRACTION = Exercise(
    "sensor",
    sensor.clipped_fraction,
    parts={
        "a grey picture": Part(inputs.grey_picture, weight=1.5),
        "raw numbers with other ends": Part(inputs.raw_picture, weight=1),
        "a picture in colour": Part(inputs.colour_picture, weight=1.5),
    },
    misconceptions=[
        Misconception(
            wrong.colours_counted_thrice,
            "A white pixel has three numbers at the end. How often do you count it?",
        ),
        Misconception(
            wrong.ends_left_out,
            "A pixel that holds exactly the last number: could it have been brighter?",
        ),
        Misconception(
            wrong.beyond_left_out,
            "Some raw numbers lie beyond the ends that were given. Are those pixels fine?",
        ),
        Misconception(
            wrong.each_colour_counted,
            "How many pixels does the picture have: as many as it has numbers?",
        ),
        Misconception(
            wrong.all_colours_at_once,
            "If only the red of a pixel is clipped, is its colour still right?",
        ),
        Misconception(
            wrong.white_first,
            "In which order are the two shares asked for?",
        ),
        Misconception(
            wrong.in_percent,
            "Which share is the whole picture: 1, or 100?",
        ),
        Misconception(
            wrong.pixels_counted,
            "That is how many pixels are clipped. Which share of the picture is it?",
        ),
        Misconception(
            wrong.always_8_bits,
            "Not all cameras end at the same number. Which arguments tell you where this one does?",
        ),
        Misconception(
            wrong.divided_by_all_numbers,
            "Do you divide by how many pixels a picture in colour has, or by how many numbers?",
        ),
        Misconception(
            wrong.columns_for_colours,
            "Over which axis do you ask for any in a grey picture? What lies along it?",
        ),
    ],
)

FLAT_FIELD = Exercise(
    "sensor",
    sensor.flat_field,
    parts={
        "grey pictures": Part(inputs.shaded_greys, weight=2),
        "pictures in colour": Part(inputs.shaded_colours, weight=1),
        "unsigned whole numbers": Part(inputs.raw_numbers, weight=1),
    },
    misconceptions=[
        Misconception(
            wrong.dark_added_back,
            "With the cap on, what should a corrected picture hold: the dark numbers, or nothing?",
        ),
        Misconception(
            wrong.scaled_to_the_image,
            "Of which picture do you take the mean: of the scene, or of the white paper?",
            also=[wrong.scaled_to_the_whole_image],
        ),
        Misconception(
            wrong.dark_left_out,
            "With the cap on, the numbers are not zero. Does that part come through the lens?",
        ),
        Misconception(
            wrong.dark_left_in_flat,
            "The flat picture was taken with the same sensor. What else is in it than light?",
        ),
        Misconception(
            wrong.scaled_with_dark,
            "You scale with the mean of the flat picture. Is all of that mean light?",
        ),
        Misconception(
            wrong.dark_left_in_image,
            "The flat picture has lost what is there without light. Has the picture itself?",
        ),
        Misconception(
            wrong.flat_multiplied,
            "Dark corners should get brighter. Do they, if you multiply by the flat picture?",
        ),
        Misconception(
            wrong.mean_of_rows_only,
            "How many means of a grey picture are there: one, or one for each column?",
        ),
        Misconception(
            wrong.not_scaled_back,
            "Divided by the flat picture, a white wall becomes 1. How bright should it be in DN?",
        ),
        Misconception(
            wrong.flat_subtracted,
            "A pixel that gets half of the light: does it lack a number, or a factor?",
        ),
        Misconception(
            wrong.one_mean_for_all,
            "The flat picture is brighter in green than in blue. Do you mix up their means?",
        ),
        Misconception(
            wrong.scaled_to_brightest,
            "As bright as the surface is seen on average: which number did you scale with?",
        ),
        Misconception(
            wrong.unsigned_difference,
            "Ask NumPy for `np.uint16(3) - np.uint16(5)`. Can that happen in the shadows here?",
        ),
        Misconception(
            wrong.clipped_before_the_noise_averages_out,
            "In the shadows, noise takes some numbers below the dark ones. If you lift just those, "
            "is the mean of many pixels still right?",
            also=[wrong.magnitude_of_the_noise],
        ),
        Misconception(
            wrong.gamma_taken_off_again,
            "The numbers are linear in light already. Which curve do you take off or put on?",
            also=[wrong.gamma_put_on],
        ),
    ],
)

SILHOUETTE_AREA = Exercise(
    "sensor",
    illumination.silhouette_area,
    points=3,
    parts={
        "square pixels": Part(inputs.square_pixels, weight=2),
        "pixels that are not square": Part(inputs.oblong_pixels, weight=1),
    },
    misconceptions=[
        Misconception(
            wrong.share_of_the_picture,
            "That uses the share of dark pixels. Does the part shrink when the picture grows?",
            also=[wrong.share_without_a_size],
        ),
        Misconception(
            wrong.bright_counted,
            "The light comes from behind. Is the object bright in this picture, or dark?",
            also=[wrong.brighter_counted],
        ),
        Misconception(
            wrong.threshold_included,
            "To which side does a pixel belong that holds the threshold itself?",
        ),
        Misconception(
            wrong.side_for_area,
            "Which unit should an area have, and which one does yours have?",
            also=[wrong.times_the_sides],
        ),
        Misconception(
            wrong.number_of_pixels,
            "That is how many pixels are dark. How large is one of them on the object?",
        ),
        Misconception(
            wrong.box_around_it,
            "You measure a box around the object. Is all of the box dark?",
        ),
        Misconception(
            wrong.grey_values_added,
            "Does a pixel count for more when it is less dark?",
        ),
        Misconception(
            wrong.width_squared,
            "Suppose that a pixel is higher than wide. Which two lengths make its area?",
            also=[wrong.sizes_squared],
        ),
    ],
)

EXPLAIN_UNDER_OR_OVER = Explain(
    "sensor",
    "explain_under_or_over",
    rubric=[
        (1, "Says that a clipped pixel has lost its value: nothing can bring it back."),
        (1, "Says that an underexposed pixel still holds its value, with more noise for its size."),
        (1, "Names where that noise comes from: few photons (shot), readout, coarse steps."),
        (1, "Draws the limit: expose as bright as possible without clipping what matters."),
    ],
    model_answer=(
        "A pixel at the last number may have seen a little more light or a hundred times as much; "
        "darkening the picture makes it a uniform grey, and edges and colours stay lost. A pixel "
        "that got a quarter of the light holds a quarter of the number: multiplied by four it is "
        "right on average, but its shot noise by signal is twice as large, and the readout noise "
        "and the rounding steps are four times as large as in a good exposure. So expose as bright "
        "as the scene allows, keep the highlights that matter just below the end of the histogram, "
        "and when in doubt stay a little below."
    ),
)
