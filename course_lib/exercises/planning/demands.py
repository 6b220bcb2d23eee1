"""What a set-up of chapter 11 must meet, whichever it is: how far each demand is missed."""

from __future__ import annotations

import sys
from collections.abc import Callable
from functools import partial
from typing import Any

from course_lib.exercises.planning.plain import aperture_window
from course_lib.judging import Case
from course_lib.judging.comparison import Mismatch, describe

Inputs = dict[str, Any]
KEYS = ("camera", "lens", "distance", "N", "exposure_time")
WAVELENGTH_UM = 0.55
ROUNDING = 1e-9
HOPELESS = 10  # times: a demand missed so far shows that no set-up was looked for


def window(f_mm: float, near: float, far: float, spot_um: float) -> Any:
    """Return the f-numbers between which a depth range is sharp, in green light."""
    compute: Any = aperture_window
    return compute(f_mm, near, far, spot_um, WAVELENGTH_UM)


def broken(plan: Any, inputs: Inputs) -> str:
    """Say why an answer is no set-up at all: a key, an index, a number; empty if it is one."""
    if plan is None:
        return (
            "No set-up came back (None), but there is one. Is the `return` missing, or does one of "
            "your demands reject every pair?"
        )
    if not isinstance(plan, dict) or set(plan) != set(KEYS):
        return f"A dictionary with the keys {', '.join(KEYS)} was expected, not {_keys_of(plan)}."
    for key, several in (("camera", "cameras"), ("lens", "lenses")):
        if reason := _no_index(plan[key], key, len(inputs[several])):
            return reason
    for key in KEYS[2:]:
        value = plan[key]
        if not _is_number(value):
            return f"`{key}` is {describe(value)}; a number was expected."
        if not 0 < value <= sys.float_info.max:  # NaN, infinity and whole numbers without end, too
            return f"`{key}` must be a positive number."
    return _not_on_the_lens(plan, inputs)


def _keys_of(plan: Any) -> str:
    """Say what came for a dictionary with `KEYS`; no text of a student's reaches the verdict."""
    if not isinstance(plan, dict):
        return describe(plan)
    missing = [key for key in KEYS if key not in plan]
    return f"a dictionary without {', '.join(missing)}" if missing else "a dictionary with more"


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _no_index(value: Any, key: str, count: int) -> str:
    if not _is_number(value) or value % 1:  # NaN too
        return f"`{key}` is {describe(value)}; its number in the list was expected, from 0."
    return "" if 0 <= value < count else f"`{key}` must be one of the numbers 0 to {count - 1}."


def _not_on_the_lens(plan: Inputs, inputs: Inputs) -> str:
    lens = inputs["lenses"][int(plan["lens"])]
    least, most = lens["N_least"] * (1 - ROUNDING), lens["N_most"] * (1 + ROUNDING)
    if not least <= plan["N"] <= most:
        return f"This lens goes from f/{lens['N_least']:g} to f/{lens['N_most']:g}; `N` is outside."
    if plan["distance"] - inputs["task"]["depth"] / 2 <= 2 * lens["f_mm"] / 1000:
        return "The box reaches to the lens or beyond: is `distance` in metres, to its middle?"
    return ""


def shares(plan: Inputs, inputs: Inputs) -> dict[str, float]:
    """Return what a set-up needs of each demand, as a share of what it may: 1 is just met."""
    task, camera = inputs["task"], inputs["cameras"][int(plan["camera"])]
    lens, N, time = inputs["lenses"][int(plan["lens"])], plan["N"], plan["exposure_time"]
    near, far = plan["distance"] - task["depth"] / 2, plan["distance"] + task["depth"] / 2
    pixel = camera["pitch_um"] / 1000 / lens["f_mm"]  # at 1 m, m
    spot_um = task["blur_px"] * camera["pitch_um"]
    least, most = window(lens["f_mm"], near, far, spot_um)
    focus = 2 * near * far / (near + far)
    return {
        "in view": max(
            (task[side] + 2 * task["motion"]) / (camera[side] * pixel * near)
            for side in ("width", "height")
        ),
        "resolution": far * pixel / task["resolution"],
        "depth of field": least / N,
        "diffraction": N / most,
        "distance": max(task["stand_off"] / near, lens["closest"] / focus),
        "motion blur": task["speed"] * time / (near * pixel) / task["blur_px"],
        "frame rate": max(task["frame_rate"] / camera["frame_rate"], time * task["frame_rate"]),
        "light": N**2 * task["exposure_at_f1"] / time,
    }


#: What a missed demand means for the pictures.
MEANING = {
    "in view": "The box is cut off: with its motion, its near face does not fit into the picture",
    "resolution": "Too coarse: at the far face a pixel covers more than it may",
    "depth of field": "Blurred: at the ends of the box a point makes a spot that is too large",
    "diffraction": "Blurred by diffraction: the Airy disk is too large",
    "distance": "Too near: for the stand-off that is asked for, or for this lens to focus",
    "motion blur": "Smeared: while a picture is exposed, the object moves too far",
    "frame rate": "Too few pictures a second: by this camera, or with this exposure",
    "light": "Too dark: at this f-number the exposure is too short",
}


def excess(share: float) -> str:
    """Write by how much a demand is missed."""
    return f"{share:.3g} times too much" if share >= 2 else f"by {100 * (share - 1):.2g} %"


def judge_demand(name: str, plan: Any, inputs: Inputs) -> Mismatch | None:
    """Return None if a set-up meets a demand, or say by how much it does not.

    What follows a comma in its name tells tasks apart, not demands.
    """
    if reason := broken(plan, inputs):
        return Mismatch("type" if not isinstance(plan, dict) else "values", reason)
    needed = shares(plan, inputs)
    worst = max(needed, key=lambda demand: needed[demand])
    if needed[worst] > HOPELESS:
        message = f"{MEANING[worst]}, {excess(needed[worst])}. That far off, nothing else counts."
        units = " Are all lengths in metres?" if needed[worst] > 100 else ""
        return Mismatch("values", message + units)
    asked = name.partition(",")[0]
    if needed[asked] <= 1 + ROUNDING:
        return None
    return Mismatch("values", f"{MEANING[asked]}, {excess(needed[asked])}.")


def demand(name: str) -> Callable[[Any, Inputs], Mismatch | None]:
    """Return the demand with a name, as a part of an exercise takes it."""
    return partial(judge_demand, name)


#: Change a set-up and what was asked, in place, as if a mistake were none.
Reading = Callable[[Inputs, Inputs], None]


def _reread(read: Reading, case: Case, plan: Any) -> tuple[Inputs, Inputs] | None:
    if not isinstance(plan, dict) or set(plan) != set(KEYS):
        return None
    if not all(_is_number(value) and value >= 0 for value in plan.values()):
        return None
    changed, task = dict(plan), dict(case.inputs["task"])
    inputs = case.inputs | {"task": task}
    try:
        read(changed, inputs)
    except ZeroDivisionError:
        return None
    return None if broken(changed, inputs) else (changed, inputs)


def met_if(read: Reading, just: bool = False) -> Callable[[Case, Any], bool]:
    """Return whether the demand would be met if a mistake were none; with `just`, hardly so."""

    def explains(case: Case, plan: Any) -> bool:
        reread = _reread(read, case, plan)
        if reread is None or judge_demand(case.part, *reread):
            return False
        if broken(plan, case.inputs) or max(shares(plan, case.inputs).values()) > HOPELESS:
            return False
        return not just or shares(*reread)[case.part.partition(",")[0]] > 0.97

    return explains


def all_met_if(read: Reading) -> Callable[[Case, Any], bool]:
    """Return whether every demand would be met if a mistake were none."""

    def explains(case: Case, plan: Any) -> bool:
        reread = _reread(read, case, plan)
        return reread is not None and max(shares(*reread).values()) <= 1 + ROUNDING

    return explains
