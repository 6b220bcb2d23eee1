"""Exercises of chapter 03 on what is sharp: depth of field, aperture, diffraction."""

from __future__ import annotations

from course_lib import optics
from course_lib.exercises.lenses import inputs
from course_lib.exercises.lenses import misconceptions_sharpness as wrong
from course_lib.judging import Exercise, Explain, Misconception, Part, YesOrNo

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
            wrong.half_the_way,
            "From there on all is sharp when the lens is focused right. But where is the focus?",
        ),
        Misconception(
            wrong.diameter_for_f_number,
            "Stop the lens down: N grows. Should the range of sharpness begin nearer or farther?",
        ),
    ],
)

DEPTH_OF_FIELD = Exercise(
    "lenses",
    optics.depth_of_field,
    points=6,
    parts={
        "focused before the hyperfocal distance": Part(inputs.before_hyperfocal, weight=3),
        "focused beyond it": Part(inputs.beyond_hyperfocal, weight=2),
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
    ],
)

AIRY_DIAMETER = Exercise(
    "lenses",
    optics.airy_diameter,
    points=2,
    parts={"one f-number": inputs.airy, "several f-numbers at once": inputs.several_airy},
    misconceptions=[
        Misconception(
            wrong.airy_radius,
            "From the middle to the dark ring, or from one side of the ring to the other?",
        ),
        Misconception(
            wrong.airy_without_its_factor,
            "Right unit, right growth. Which number belongs to a round opening?",
        ),
        Misconception(
            wrong.airy_divided,
            "A smaller opening spreads the light more. Does N grow or shrink when you stop down?",
        ),
        Misconception(
            wrong.wavelength_in_nanometres,
            "You changed a unit. In which unit does the wavelength come, and the answer go?",
        ),
        Misconception(
            wrong.airy_area,
            "Which unit has your answer? You were asked for a diameter.",
        ),
    ],
)

IS_DIFFRACTION_LIMITED = Exercise(
    "lenses",
    optics.is_diffraction_limited,
    points=3,
    compare=YesOrNo(),
    parts={
        "one camera at a time": Part(inputs.one_camera, cases=10),
        "the stops of a lens": inputs.stops_of_a_lens,
        "several sensors": inputs.several_sensors,
    },
    misconceptions=[
        Misconception(
            wrong.pixel_wider_than_disk,
            "Think of a very small opening and fine pixels. What limits the detail then?",
        ),
        Misconception(
            wrong.radius_against_pixel,
            "You compare half of the disk with a whole pixel. How wide is the whole disk?",
        ),
        Misconception(
            wrong.wavelengths_for_the_disk,
            "Your disk is too small. Which number belongs to a round opening?",
        ),
        Misconception(
            wrong.disk_against_diagonal,
            "Which length of a pixel does the rule name: its side, or its diagonal?",
        ),
        Misconception(
            wrong.how_many_pixels,
            "You say how many pixels the disk is wide. The question wants a yes or a no: which?",
        ),
    ],
)

EXPLAIN_STOPPED_DOWN = Explain(
    "lenses",
    "explain_stopped_down",
    rubric=[
        (1, "Says that stopping down shrinks the blur of what is out of focus, as 1/N."),
        (1, "Says that diffraction grows with N and blurs everything, also what is in focus."),
        (1, "Compares the Airy disk with the pixel, or with the blur, by a number."),
        (
            1,
            "Proposes a remedy: the f-number where both are about equal, focus that splits the "
            "range, a shorter lens or smaller magnification, or several pictures.",
        ),
    ],
    model_answer=(
        "Stopping down makes the cone of light narrower, so the ends of the part, which are out of "
        "focus, get sharper: their spot shrinks as 1/N. But diffraction spreads every point, also "
        "those in focus, over an Airy disk that grows as N: at f/22 in green light it measures "
        "2.44 · 0.00055 mm · 22, about 0.03 mm or nine pixels of 3.45 µm, so the whole picture is "
        "soft. Choose the f-number at which the spot of the ends and the Airy disk are about "
        "equally large, focus so that both ends blur alike, and if that is not enough, step back "
        "(a smaller magnification is deeper) or take several pictures with different focus."
    ),
)
