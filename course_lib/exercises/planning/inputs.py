"""Inputs for the exercises of chapter 11: boxes before cameras, surfaces, depth ranges, flights."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from course_lib.camera import camera_at
from course_lib.judging import Known

Inputs = dict[str, Any]
Floats = NDArray[np.float64]


def rounded(rng: Generator, low: float, high: float, digits: int = 2) -> float:
    return round(float(rng.uniform(low, high)), digits)


# --- box_in_view ------------------------------------------------------------------------------


def box(rng: Generator, motion: Floats, distance: float = 4.0) -> Inputs:
    """Draw a box with three different edges, seen obliquely by a camera that is turned."""
    size = rng.permutation([0.5, 0.8, 1.2]) + rng.uniform(0, 0.1, 3).round(2)
    centre = rng.choice([-1, 1], 3) * rng.uniform(0.2, 0.5, 3).round(2)
    f, (width, height) = rng.uniform(1100, 1400), rng.permutation([1280, 960])
    K = np.array([[f, 0, width / 2 + rng.uniform(20, 60)], [0, f, height / 2 - 30], [0, 0, 1]])
    turn, rise = rng.uniform(0, 2 * np.pi), rng.uniform(0.3, 0.6)
    aside = np.array([np.cos(turn) * np.cos(rise), np.sin(turn) * np.cos(rise), np.sin(rise)])
    camera = camera_at(centre + distance * aside, centre, K, (int(width), int(height)))
    seen = {"P": camera.P, "image_size": camera.image_size}
    return {"size": size, "centre": centre, "motion": motion, **seen}


def at_rest(rng: Generator) -> Inputs:
    return box(rng, np.zeros(3))


def moving(rng: Generator) -> Inputs:
    return box(rng, rng.permutation([0.04, 0.08, 0.12]) + rng.uniform(0, 0.02, 3).round(3))


def around_the_camera(rng: Generator) -> Known:
    """Put the camera into the box: some corners are behind it."""
    return Known(box(rng, np.full(3, 0.05), distance=0.2), np.full(4, -np.inf))


# --- object_resolution ------------------------------------------------------------------------


def facing(rng: Generator) -> Inputs:
    Z, f_mm = rounded(rng, 1.2, 6), rounded(rng, 12, 90, 0)
    return {"Z": Z, "f_mm": f_mm, "pitch_um": rounded(rng, 2.5, 9), "tilt": 0.0}


def tilted(rng: Generator) -> Inputs:
    return facing(rng) | {"tilt": rounded(rng, 0.9, 1.2) * float(rng.choice([-1, 1]))}


# --- aperture_window --------------------------------------------------------------------------


def depth_range(rng: Generator, share: float) -> Inputs:
    """Choose how far up the window begins, as a share of where it ends."""
    f_mm, spot = rounded(rng, 25, 60, 0), rounded(rng, 6, 12)
    middle = f_mm / 1000 * rng.uniform(15, 25)
    most = spot / (2.44 * 0.55)
    depth = 2 * spot / 1e6 * middle**2 * share * most / (f_mm / 1000) ** 2
    ends = {"near": round(middle - depth / 2, 3), "far": round(middle + depth / 2, 3)}
    return {"f_mm": f_mm, **ends, "spot_um": spot, "wavelength_um": rounded(rng, 0.45, 0.65)}


def flat_object(rng: Generator) -> Inputs:
    return depth_range(rng, rng.uniform(0.4, 0.7))


def deep_object(rng: Generator) -> Inputs:
    return depth_range(rng, rng.uniform(1.6, 2.5))


# --- flights ----------------------------------------------------------------------------------


def one_height(rng: Generator) -> Inputs:
    f_mm, pitch = rounded(rng, 8, 50, 1), rounded(rng, 2, 5)
    return {"H": rounded(rng, 40, 150, 0), "f_mm": f_mm, "pitch_um": pitch}


def several_heights(rng: Generator) -> Inputs:
    return one_height(rng) | {"H": rng.uniform(40, 150, 4).round(1)}


def with_overlap(rng: Generator) -> Inputs:
    footprint = rounded(rng, 60, 140, 0)
    return {"base": round(footprint * float(rng.uniform(0.12, 0.45)), 1), "footprint": footprint}


def with_a_gap(rng: Generator) -> Inputs:
    footprint = rounded(rng, 60, 140, 0)
    return {"base": round(footprint * float(rng.uniform(1.1, 1.6)), 1), "footprint": footprint}


def several_pairs(rng: Generator) -> Inputs:
    footprint = rounded(rng, 60, 140, 0)
    return {"base": footprint * rng.uniform(0.1, 0.9, 4).round(2), "footprint": footprint}


def three_pictures(rng: Generator) -> Known:
    """At two thirds each point is in three pictures: they are a third of a footprint apart."""
    base = rounded(rng, 15, 45, 1)
    return Known({"share": 2 / 3, "footprint": 3 * base}, base)


def any_share(rng: Generator) -> Inputs:
    return {"share": rounded(rng, 0.55, 0.9), "footprint": rounded(rng, 60, 140, 1)}


def several_shares(rng: Generator) -> Inputs:
    return any_share(rng) | {"share": rng.uniform(0.3, 0.9, 4).round(2)}


def flight(rng: Generator, share: float, interval: float, blur: float) -> Inputs:
    """Choose the speed that the interval allows, and the smear's as a multiple of it."""
    in_time, gsd = rounded(rng, 5, 12, 1), rounded(rng, 0.015, 0.04, 3)
    time = float(f"{blur * gsd / (share * in_time):.3g}")
    posed = {"base": round(in_time * interval, 2), "interval": interval, "gsd": gsd}
    return {**posed, "exposure_time": time, "blur": blur}


def interval_decides(rng: Generator) -> Inputs:
    interval, blur = rounded(rng, 1.5, 3.5, 1), rounded(rng, 0.4, 0.8, 1)
    return flight(rng, rng.uniform(1.3, 2.5), interval, blur)


def smear_decides(rng: Generator) -> Inputs:
    interval, blur = rounded(rng, 1.5, 3.5, 1), rounded(rng, 0.4, 0.8, 1)
    return flight(rng, rng.uniform(0.4, 0.75), interval, blur)


def several_flights(rng: Generator) -> Inputs:
    """Draw flights by a faster camera: for some the interval decides, for some the smear."""
    one = flight(rng, 1.5, rounded(rng, 0.4, 0.8, 1), rounded(rng, 1.5, 2.5, 1))
    base = one["base"] * np.array([0.7, 1, 1.3, 1.6])
    gsd = one["gsd"] * np.array([0.6, 1, 0.7, 1.7])
    return one | {"base": base.round(2), "gsd": gsd.round(4)}


def rectangle(rng: Generator, pictures: float, strips: float) -> Inputs:
    """Draw a field as long as some bases, and as wide as the footprint and some distances."""
    base, distance = float(rng.integers(11, 25)), float(rng.integers(26, 45))
    across = float(round(distance * rng.uniform(2.2, 3.4)))
    length, width = round(pictures * base, 2), round(across + strips * distance, 2)
    steps = {"base": base, "distance": distance, "footprint_width": across}
    return {"length": length, "width": width, **steps}


def field(rng: Generator) -> Inputs:
    return rectangle(rng, rng.integers(12, 20) + 0.25, rng.integers(3, 6) + 0.75)


def larger_field(rng: Generator) -> Inputs:
    return rectangle(rng, rng.integers(25, 35) + 0.75, rng.integers(6, 9) + 0.25)


def even_field(rng: Generator) -> Inputs:
    return rectangle(rng, float(rng.integers(12, 30)), float(rng.integers(4, 9)))


def narrow_field(rng: Generator) -> Inputs:
    return rectangle(rng, rng.integers(12, 30) + 0.5, -float(rng.choice([1.25, 1.5])))
