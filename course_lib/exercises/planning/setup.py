"""The capstone of chapter 11: a set-up, judged demand by demand, and a question on flights."""

from __future__ import annotations

from typing import Any

from course_lib.exercises.planning import setup_inputs as inputs
from course_lib.exercises.planning import setup_misconceptions as wrong
from course_lib.exercises.planning.demands import all_met_if, demand, met_if
from course_lib.exercises.planning.plain_setup import plan_setup
from course_lib.judging import Case, Exercise, Explain, Misconception, Part

Inputs = dict[str, Any]


def task_without(*names: str, share: float = 0.0) -> Any:
    """Return the reading in which some numbers of the task are smaller, or zero."""

    def read(_: Inputs, posed: Inputs) -> None:
        posed["task"] |= {name: share * posed["task"][name] for name in names}

    return read


def with_coarser_pixels(_: Inputs, posed: Inputs) -> None:
    posed["task"]["resolution"] = float("inf")


def with_faster_cameras(_: Inputs, posed: Inputs) -> None:
    posed["cameras"] = [camera | {"frame_rate": float("inf")} for camera in posed["cameras"]]


def with_close_focus(_: Inputs, posed: Inputs) -> None:
    posed["lenses"] = [lens | {"closest": 0.0} for lens in posed["lenses"]]


def one_less(plan: Inputs, _: Inputs) -> None:
    plan |= {"camera": plan["camera"] - 1, "lens": plan["lens"] - 1}


def distance_by_1000(plan: Inputs, _: Inputs) -> None:
    plan["distance"] /= 1000


def exposure_by_1000(plan: Inputs, _: Inputs) -> None:
    plan["exposure_time"] /= 1000


def exposure_inverted(plan: Inputs, _: Inputs) -> None:
    plan["exposure_time"] = 1 / plan["exposure_time"]


def half_a_box_farther(plan: Inputs, posed: Inputs) -> None:
    plan["distance"] += posed["task"]["depth"] / 2


def exposure_as_the_rate_allows(plan: Inputs, posed: Inputs) -> None:
    plan["exposure_time"] = min(plan["exposure_time"], 1 / posed["task"]["frame_rate"])


def with_n_for_its_square(plan: Inputs, posed: Inputs) -> None:
    posed["task"]["exposure_at_f1"] /= plan["N"]


def with_larger_spots(_: Inputs, posed: Inputs) -> None:
    posed["task"]["blur_px"] *= 4


def nothing_came(_: Case, plan: Any) -> bool:
    return plan is None


def at_the_front(plan: Inputs, posed: Inputs) -> None:
    half, distance = posed["task"]["depth"] / 2, plan["distance"]
    posed["task"]["resolution"] *= (distance + half) / (distance - half)


def with_the_front_as_far(case: Case, plan: Any) -> bool:
    return case.part.startswith("resolution") and met_if(at_the_front)(case, plan)


def one_side_fits(case: Case, plan: Any) -> bool:
    return any(met_if(task_without(side))(case, plan) for side in ("height", "width"))


def too_far_stopped_down(case: Case, plan: Any) -> bool:
    """Return whether it is diffraction that such a set-up has too much of."""
    return case.part == "diffraction" and met_if(with_larger_spots)(case, plan)


PLAN_SETUP = Exercise(
    "planning",
    plan_setup,
    points=15,
    parts={
        "in view": Part(inputs.dark, 1, 1.5, demand("in view")),
        "in view, an upright box": Part(inputs.upright, 1, 1.5, demand("in view")),
        "resolution": Part(inputs.tempting_cameras, 1, 1, demand("resolution")),
        "resolution, at the far face": Part(inputs.barely_too_coarse, 1, 1, demand("resolution")),
        "depth of field": Part(inputs.bright, 1, 2, demand("depth of field")),
        "diffraction": Part(inputs.with_small_pixels, 1, 1.5, demand("diffraction")),
        "distance": Part(inputs.with_a_far_focus, 1, 1, demand("distance")),
        "motion blur": Part(inputs.dark, 1, 2, demand("motion blur")),
        "frame rate": Part(inputs.slow, 1, 1.5, demand("frame rate")),
        "light": Part(inputs.with_a_slow_lens, 1, 2, demand("light")),
    },
    misconceptions=[
        Misconception(
            wrong.nothing_found,
            "There is a pair that does it. Print its demands one by one: which one rejects it?",
            also=[wrong.sides_exchanged, wrong.pitch_in_mm],
            explains=nothing_came,
        ),
        Misconception(
            wrong.counted_from_one,
            "Which number has the first camera in the list?",
            explains=all_met_if(one_less),
        ),
        Misconception(
            wrong.distance_in_mm,
            "In which unit is the distance asked for?",
            explains=all_met_if(distance_by_1000),
        ),
        Misconception(
            wrong.exposure_in_ms,
            "In which unit is the exposure time asked for?",
            explains=all_met_if(exposure_by_1000),
        ),
        Misconception(
            wrong.one_over_the_exposure,
            "An exposure of 1/200: is the time 200 seconds?",
            explains=all_met_if(exposure_inverted),
        ),
        Misconception(
            wrong.motion_shared,
            "The box moves to the left and to the right. How much wider is the room that it needs?",
            explains=met_if(task_without("motion", share=0.5), just=True),
        ),
        Misconception(
            wrong.motion_forgotten,
            "At rest the box is just in view. What happens to its edge when it moves?",
            explains=met_if(task_without("motion"), just=True),
        ),
        Misconception(
            wrong.height_forgotten,
            "The box fits in one direction. Does it fit in the other one, too?",
            explains=one_side_fits,
        ),
        Misconception(
            wrong.half_the_box,
            "Half of the box fits into the picture. Do you hold a half against a whole?",
            explains=met_if(task_without("width", "height", "motion", share=0.5)),
        ),
        Misconception(
            wrong.wide_open,
            "The middle of the box is sharp. Which f-number do its two ends need?",
            also=[wrong.stop_rounded_down],
            explains=lambda case, plan: (
                case.part == "depth of field" and met_if(task_without("depth"))(case, plan)
            ),
        ),
        Misconception(
            wrong.stand_off_forgotten,
            "Everything fits. How near may the camera come to the box?",
            explains=met_if(task_without("stand_off")),
        ),
        Misconception(
            wrong.closest_focus_forgotten,
            "Far enough from the box. Can this lens be focused so near?",
            explains=met_if(with_close_focus),
        ),
        Misconception(
            wrong.front_for_the_middle,
            "To which place of the box is the distance measured: to its front, or to its middle?",
            explains=met_if(half_a_box_farther, just=True),
        ),
        Misconception(
            wrong.only_the_middle,
            "You compute with the middle of the box. Which face of it is nearer, which is farther?",
            explains=met_if(task_without("depth")),
        ),
        Misconception(
            wrong.resolution_in_front,
            "On the front of the box a pixel is fine enough. Where on the box is it coarsest?",
            explains=with_the_front_as_far,
        ),
        Misconception(
            wrong.resolution_not_looked_at,
            "This camera sees all of the box. How much of it does one pixel cover at the far face?",
            explains=met_if(with_coarser_pixels),
        ),
        Misconception(
            wrong.slow_camera,
            "How many pictures a second can the camera take that you chose?",
            explains=met_if(with_faster_cameras),
        ),
        Misconception(
            wrong.as_long_as_the_smear_allows,
            "Can an exposure last longer than the time from one picture to the next?",
            explains=met_if(exposure_as_the_rate_allows),
        ),
        Misconception(
            wrong.as_long_as_the_rate_allows,
            "The exposure fits between two pictures. How far does the object move meanwhile?",
            explains=met_if(task_without("speed")),
        ),
        Misconception(
            wrong.stopped_down,
            "Both ends are sharp. What does so small an aperture do to a point, in these pixels?",
            also=[wrong.diffraction_not_looked_at],
            explains=too_far_stopped_down,
        ),
        Misconception(
            wrong.f_number_not_squared,
            "Twice the f-number, half the diameter. Which share of the light comes through?",
            explains=met_if(with_n_for_its_square, just=True),
        ),
        Misconception(
            wrong.light_forgotten,
            "Short exposures do not smear. Is there enough light for yours, at this f-number?",
            also=[wrong.light_not_looked_at],
            explains=met_if(task_without("exposure_at_f1")),
        ),
    ],
)

EXPLAIN_TWICE_AS_HIGH = Explain(
    "planning",
    "explain_twice_as_high",
    rubric=[
        (1, "Says that the ground sampling distance doubles, and so does what can be recognised."),
        (
            1,
            "Says that footprint and base double; about a quarter of the pictures is enough.",
        ),
        (
            1,
            "Says that the smear halves, in pixels, and that heights are half as precise.",
        ),
        (1, "Judges: it is faster, but right only if the coarser survey still meets the demands."),
    ],
    model_answer=(
        "Twice as high, a pixel covers twice as much: the ground sampling distance doubles, from 2 "
        "to 4 cm, and so does the smallest object that can be recognised. The footprint is twice "
        "as long and twice as wide. With the same overlaps, the base and the distance of the lines "
        "double too, so about a quarter of the pictures is enough; a few more, because of the one "
        "that is added in each line and the one more line. At the same speed the smear is half as "
        "many pixels, and the drone may fly twice as fast. Base and height keep their ratio, so an "
        "error of a tenth of a pixel makes an error in height that is twice as large. The owner is "
        "right that it is faster, but only if the volume and the smallest object that are asked "
        "for can do with half the precision."
    ),
)
