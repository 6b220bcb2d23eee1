"""Inputs for the set-up of chapter 11: tasks that one of the cameras does with the right lens."""

from __future__ import annotations

from typing import Any

from numpy.random import Generator

from course_lib.exercises.planning.setup_misconceptions import search

Inputs = dict[str, Any]
FOCAL_LENGTHS = (12, 16, 25, 35, 50, 75)


def three_digits(number: float) -> float:
    return float(f"{number:.3g}")


def camera(rng: Generator) -> Inputs:
    width = int(rng.choice([1600, 1920, 2048, 2464]))
    size = {"width": width, "height": int(width * rng.choice([0.625, 0.75]))}
    pitch, rate = float(rng.choice([3.45, 4.5, 5.5, 5.86])), float(rng.integers(60, 160))
    return {**size, "pitch_um": pitch, "frame_rate": rate}


def lens(f_mm: float) -> Inputs:
    return {"f_mm": float(f_mm), "N_least": 1.4, "N_most": 16.0, "closest": round(f_mm * 0.008, 3)}


def box(rng: Generator, right: Inputs, f_mm: float, near: float, blur_px: float) -> Inputs:
    """Choose a box that fills the width of the right camera's picture with the middle lens."""
    p, f = right["pitch_um"] / 1e6, f_mm / 1e3
    across, upright = (right[side] * p * near / f for side in ("width", "height"))
    motion = round(across * rng.uniform(0.035, 0.05), 3)
    N = rng.uniform(0.52, 0.62) * blur_px * p / (2.44 * 0.55e-6)
    depth = round(2 * blur_px * p * near**2 * N / f**2, 3)
    size = {"width": round(across - 2 * motion, 3), "height": round(0.8 * upright - 2 * motion, 3)}
    resolution = three_digits(1.1 * (near + depth) * p / f)
    return {**size, "depth": depth, "motion": motion, "resolution": resolution}


def setup(
    rng: Generator,
    slow: bool,
    light: float,
    stand_off: float,
    last: int = 2,
    barely: bool = False,
) -> Inputs:
    """Choose the light as a share of what a set-up needs, and how far the camera stands off."""
    right, blur_px = camera(rng), float(rng.choice([1.5, 2, 2.5]))
    middle = int(rng.integers(1, 5))
    f_mm = FOCAL_LENGTHS[middle]
    near = rng.uniform(20, 32) * f_mm / 1e3
    task = box(rng, right, f_mm, near, blur_px)
    rate = round(right["frame_rate"] * rng.uniform(0.5, 0.8))
    longest = rng.uniform(1.5, 3) / rate if slow else 1 / rate / rng.uniform(2.5, 5)
    speed = three_digits(blur_px * right["pitch_um"] / 1e3 * near / f_mm / longest)
    task |= {"speed": speed, "blur_px": blur_px, "frame_rate": float(rate)}
    task |= {"stand_off": three_digits(stand_off * near), "exposure_at_f1": 0.0}
    coarser = 1.1 + 0.6 * task["depth"] / near if barely else 2  # fine enough in front, or not
    coarse = right | {side: round(right[side] / coarser) for side in ("width", "height")}
    late = right | {"frame_rate": float(round(rate * rng.uniform(0.5, 0.8)))}
    wrong = [coarse, late] if rng.integers(2) else [late, coarse]
    lenses = [lens(f) for f in FOCAL_LENGTHS[middle - 1 : middle + 2]]
    cameras = [*wrong[:last], right, *wrong[last:]]
    posed: Inputs = {"task": task, "cameras": cameras, "lenses": lenses}
    plan = search(**posed)
    task["exposure_at_f1"] = three_digits(light * plan["exposure_time"] / plan["N"] ** 2)
    return posed


def with_small_pixels(rng: Generator) -> Inputs:
    """Put a camera first that has so many pixels in the same picture that the window is closed."""
    posed = bright(rng)
    plan, times = search(**posed), rng.uniform(1.7, 1.85)
    right = posed["cameras"][plan["camera"]]
    finer = {side: round(right[side] * times) for side in ("width", "height")}
    finer |= {"pitch_um": three_digits(right["pitch_um"] / times)}
    return posed | {"cameras": [right | finer, *posed["cameras"]]}


def with_a_slow_lens(rng: Generator) -> Inputs:
    """Put the right lens first in a version that does not open wide enough for the light."""
    posed = setup(rng, False, rng.uniform(0.52, 0.56), 0.25, int(rng.integers(3)))
    plan = search(**posed)
    right, longest = posed["lenses"][plan["lens"]], plan["exposure_time"]
    N_least = (1.1 * longest / posed["task"]["exposure_at_f1"]) ** 0.5
    slow_lens = right | {"N_least": three_digits(N_least)}
    return posed | {"lenses": [slow_lens, *posed["lenses"]]}


def with_a_far_focus(rng: Generator) -> Inputs:
    """Put the right lens first in a version that cannot be focused so near."""
    posed = far_off(rng)
    plan = search(**posed)
    near = plan["distance"] - posed["task"]["depth"] / 2
    distant = posed["lenses"][plan["lens"]] | {"closest": three_digits(1.4 * near)}
    return posed | {"lenses": [distant, *posed["lenses"]]}


def dark(rng: Generator) -> Inputs:
    return setup(rng, False, rng.uniform(0.45, 0.55), 0.25, int(rng.integers(3)))


def bright(rng: Generator) -> Inputs:
    return setup(rng, False, rng.uniform(0.04, 0.07), 0.25, int(rng.integers(3)))


def tempting_cameras(rng: Generator) -> Inputs:
    """Put the cameras that will not do before the one that will."""
    return setup(rng, False, rng.uniform(0.04, 0.07), 0.25)


def barely_too_coarse(rng: Generator) -> Inputs:
    """Let the camera that is too coarse be fine enough at the front of the box."""
    return setup(rng, False, rng.uniform(0.04, 0.07), 0.25, barely=True)


def slow(rng: Generator) -> Inputs:
    return setup(rng, True, rng.uniform(0.45, 0.55), 0.25)


def far_off(rng: Generator) -> Inputs:
    """Ask for more distance than the first lenses that fit would take."""
    return setup(rng, False, rng.uniform(0.04, 0.07), rng.uniform(1.1, 1.2), int(rng.integers(3)))


def upright(rng: Generator) -> Inputs:
    """Turn boxes and cameras on their side, so that it is their height that counts."""
    posed = dark(rng)
    for turned in (posed["task"], *posed["cameras"]):
        turned["width"], turned["height"] = turned["height"], turned["width"]
    return posed
