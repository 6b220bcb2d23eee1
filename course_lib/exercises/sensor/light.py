"""Exercises of chapter 04 on light: exposure, electrons and their noise."""

from __future__ import annotations

from course_lib import sensor
from course_lib.exercises.sensor import light_inputs as inputs
from course_lib.exercises.sensor import light_misconceptions as wrong
from course_lib.judging import Exercise, Misconception, Part

EXPOSURE_VALUE = Exercise(
    "sensor",
    sensor.exposure_value,
    parts={
        "ISO 100": Part(inputs.settings, weight=2),
        "other ISO speeds": Part(inputs.sensitive_settings, weight=1),
        "several settings at once": Part(inputs.many_settings, weight=1),
    },
    misconceptions=[
        Misconception(
            wrong.f_number_not_squared,
            "Half the diameter of a round opening: which share of the light gets through?",
        ),
        Misconception(
            wrong.time_multiplied,
            "A higher value is for a brighter scene. Does that ask for more time, or for less?",
        ),
        Misconception(
            wrong.natural_logarithm,
            "One more should be a factor of two. Which logarithm counts doublings?",
        ),
        Misconception(
            wrong.decimal_logarithm,
            "Your value grows by one when the light grows tenfold. How large is a stop?",
        ),
        Misconception(
            wrong.logarithm_left_out,
            "Stops count how often the light doubles. Does your value grow by one, or twofold?",
            also=[wrong.logarithm_left_out_of_both],
        ),
        Misconception(
            wrong.iso_the_other_way,
            "With more ISO the same settings suit a darker scene. Does your value rise or fall?",
        ),
        Misconception(
            wrong.iso_left_out,
            "Turn up the ISO only: the picture gets brighter. Where does your function see that?",
        ),
        Misconception(
            wrong.not_referred_to_100,
            "One second at f/1 and ISO 100 should give 0. What does your function say?",
        ),
    ],
)

EQUIVALENT_EXPOSURE = Exercise(
    "sensor",
    sensor.equivalent_exposure,
    parts={
        "another aperture": Part(inputs.other_aperture, weight=1.5),
        "another ISO speed": Part(inputs.other_speed, weight=1.5),
        "several apertures at once": Part(inputs.several_apertures, weight=1),
    },
    misconceptions=[
        Misconception(
            wrong.number_of_stops,
            "That counts stops. To which time, in seconds, do they lead?",
            also=[wrong.number_of_stops_backwards],
        ),
        Misconception(
            wrong.aperture_not_squared,
            "From f/4 to f/8 the opening is half as wide. What happens to its area?",
        ),
        Misconception(
            wrong.aperture_upside_down,
            "A larger f-number is a smaller opening. Must the shutter then stay open for longer?",
        ),
        Misconception(
            wrong.speed_upside_down,
            "With more ISO, is more light needed for the same number, or less?",
        ),
        Misconception(
            wrong.speed_squared,
            "Twice the ISO speed is one stop. How many stops are twice the f-number?",
        ),
        Misconception(
            wrong.speed_left_out,
            "Change the ISO only. Should the time not answer to that?",
        ),
        Misconception(
            wrong.stops_added,
            "Each stop doubles or halves the light. Do you add something to the seconds, or scale?",
        ),
        Misconception(
            wrong.only_the_factor,
            "That says how many times longer the new exposure is. Longer than what?",
        ),
        Misconception(
            wrong.one_f_number_squared,
            "Keep the f-number as it is. Does your time stay as it was?",
        ),
    ],
)

SENSOR_RESPONSE = Exercise(
    "sensor",
    sensor.sensor_response,
    points=6,
    parts={
        "ordinary light": Part(inputs.ordinary_light, weight=2),
        "a long exposure in little light": Part(inputs.long_exposure, weight=1.5),
        "pixels that are full": Part(inputs.full_pixels, weight=1.25),
        "numbers that come to their end": Part(inputs.last_number, weight=1.25),
    },
    misconceptions=[
        Misconception(
            wrong.never_clipped,
            "Ten times the light, again and again: does your number ever stop? What fills up "
            "on the way?",
            also=[wrong.never_clipped_without_dark],
        ),
        Misconception(
            wrong.photons_fill_the_well,
            "What collects in the well: photons, or the electrons that they set free?",
        ),
        Misconception(
            wrong.dark_needs_efficiency,
            "The dark current is given in electrons. Does the quantum efficiency act on those?",
        ),
        Misconception(
            wrong.always_12_bits,
            "Not every camera has 12 bits. Which entry of its data sheet is the largest number?",
        ),
        Misconception(
            wrong.every_photon_counts,
            "Does each photon set an electron free? Which number of the data sheet says so?",
        ),
        Misconception(wrong.offset_left_out, "Which number should a pixel hold in the dark?"),
        Misconception(
            wrong.offset_amplified,
            "The offset is given in DN. Does the amplifier still come after it?",
        ),
        Misconception(
            wrong.divided_by_gain,
            "The gain says how many DN one electron makes. Do more of them make a larger number?",
        ),
        Misconception(
            wrong.numbers_without_end,
            "With 12 bits, which is the largest number that can be written?",
        ),
        Misconception(
            wrong.clipped_too_early,
            "You clip, and something is added afterwards. Can a file hold what comes out?",
        ),
        Misconception(
            wrong.well_without_brim,
            "Before anything is amplified: can a pixel hold any number of electrons?",
        ),
        Misconception(
            wrong.dark_left_out,
            "What collects in a warm pixel during a long exposure, even with the cap on?",
        ),
        Misconception(
            wrong.dark_without_time,
            "The dark current is given per second. How long does it flow?",
        ),
        Misconception(
            wrong.dark_added_to_full_wells,
            "The well is full of light's electrons. Is there room for those of the dark current?",
        ),
        Misconception(
            wrong.larger_of_two,
            "Three electrons in a pixel: does your well hold three, or is it full?",
        ),
    ],
)

SIGNAL_TO_NOISE = Exercise(
    "sensor",
    sensor.signal_to_noise,
    points=6,
    parts={
        "much light": Part(inputs.light_rules, weight=2),
        "little light and coarse numbers": Part(inputs.readout_rules, weight=2),
        "a long exposure": Part(inputs.long_exposure, weight=2),
    },
    misconceptions=[
        Misconception(
            wrong.dark_current_for_dark_electrons,
            "The dark current is given per second. For how many seconds does it flow here?",
        ),
        Misconception(
            wrong.rounding_in_numbers,
            "All other noises are in electrons. In which unit do you add that of rounding?",
            also=[wrong.rounding_of_0_29],
        ),
        Misconception(
            wrong.deviations_added,
            "The sources do not know of each other. Which of their quantities may be added up?",
        ),
        Misconception(
            wrong.variance_for_deviation,
            "Signal and noise should have the same unit. Which unit does your noise have?",
        ),
        Misconception(
            wrong.noise_like_signal,
            "Electrons come one by one, by chance. Does four times the light make four times "
            "the noise?",
        ),
        Misconception(
            wrong.readout_not_squared,
            "The data sheet gives the readout as a standard deviation. What do you add up: "
            "those, or variances?",
        ),
        Misconception(
            wrong.photons_for_electrons,
            "A photon that sets no electron free: does the sensor know of it?",
        ),
        Misconception(
            wrong.dark_as_signal,
            "With the cap on there should be no signal. What does your function say there?",
        ),
        Misconception(
            wrong.dark_squared,
            "The dark current is a number of electrons, no deviation. How large is the variance "
            "of such a number?",
        ),
        Misconception(
            wrong.shot_noise_only,
            "In very dim light your ratio is too good. Which noise is there without any light?",
        ),
        Misconception(
            wrong.rounding_left_out,
            "One step of these numbers is many electrons. Is rounding to whole steps exact?",
        ),
        Misconception(
            wrong.dark_noise_left_out,
            "In a long exposure warmth frees electrons too. Where do you count their scatter?",
        ),
        Misconception(
            wrong.noise_alone,
            "That is the noise, in electrons. How many times larger than it is the signal?",
        ),
        Misconception(
            wrong.root_of_the_first_only,
            "Which noises stand under your root, and which ones outside of it?",
        ),
        Misconception(wrong.in_decibels, "Is a plain ratio asked for, or its logarithm?"),
    ],
)
