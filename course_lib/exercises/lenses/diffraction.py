"""Exercises of chapter 03 on diffraction: the limit of what stopping down can do."""

from __future__ import annotations

from course_lib import optics
from course_lib.exercises.lenses import inputs
from course_lib.exercises.lenses import misconceptions_sharpness as wrong
from course_lib.exercises.lenses import misconceptions_slips as slips
from course_lib.judging import Exercise, Explain, Misconception, Part, YesOrNo

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
        Misconception(
            wrong.airy_in_a_thousandth,
            "A thousand times too small. Which unit has an answer that comes from a wavelength "
            "and pure numbers?",
        ),
        Misconception(
            wrong.always_green,
            "Your light is always green. Which argument have you not used?",
        ),
        Misconception(
            slips.airy_without_the_f_number,
            "Your disk is equally large at every aperture. Which argument have you not used?",
        ),
        Misconception(
            wrong.always_green_in_micrometres,
            "A fixed wavelength, and not in mm. Where does the wavelength come from in this "
            "function?",
        ),
        Misconception(
            slips.airy_with_a_comma,
            "Two values: a comma parts them in Python. Which sign do its decimals have?",
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
        Misconception(
            wrong.pitch_times_a_thousand,
            "You say no to every camera. Wavelength and pitch come in one unit: which of them "
            "did you change?",
        ),
        Misconception(
            wrong.pitch_by_a_thousand,
            "You say yes to every camera. Wavelength and pitch come in one unit: which of them "
            "did you change?",
        ),
        Misconception(
            slips.truth_in_quotation_marks,
            "A word in quotation marks is a text, even if it reads True. What does the comparison "
            "give by itself?",
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
