"""Inputs for the exercises of chapter 03; most with the answer known by construction."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.random import Generator

from course_lib.judging import Known

Inputs = dict[str, Any]


def focal_length(rng: Generator) -> float:
    return float(np.round(rng.uniform(12, 200), 1))


def full_or_half_stop(rng: Generator) -> float:
    return float(rng.choice([1.4, 1.7, 2, 2.4, 2.8, 3.3, 4, 4.8, 5.6, 6.7, 8, 9.5, 11, 16]))


def spot(rng: Generator, size: int | None = None) -> Any:
    """Draw the diameter of a spot, mm: one to ten pixels."""
    return rng.uniform(0.003, 0.03, size)


# --- image and object distance: chosen by magnification, where both have simple forms -----------


def some_object(rng: Generator) -> Known:
    f, m = focal_length(rng), rng.uniform(0.02, 0.8)
    return Known({"f": f, "Z": f + f / m}, f + f * m)


def several_objects(rng: Generator) -> Known:
    f, m = focal_length(rng), rng.uniform(0.02, 3, 4)
    return Known({"f": f, "Z": f + f / m}, f + f * m)


def star_among_objects(rng: Generator) -> Known:
    near = several_objects(rng)
    f, Z = near.inputs["f"], near.inputs["Z"]
    return Known({"f": f, "Z": np.append(Z, np.inf)}, np.append(near.truth, f))


def object_at(rng: Generator, smallest: float, largest: float) -> Known:
    """Choose the two distances; the lens and the magnification follow."""
    Z, m = rng.uniform(100, 3000), rng.uniform(smallest, largest)
    behind = Z * m
    return Known({"f": float(1 / (1 / Z + 1 / behind)), "m": float(behind / Z)}, Z)


def smaller_than_life(rng: Generator) -> Known:
    return object_at(rng, 0.01, 0.5)


def larger_than_life(rng: Generator) -> Known:
    return object_at(rng, 1.5, 10)


# --- f-number -----------------------------------------------------------------------------------


def opening(rng: Generator) -> Known:
    N, d = rng.uniform(1.2, 20), rng.uniform(2, 30)
    return Known({"f": float(N * d), "d": float(d)}, N)


def several_openings(rng: Generator) -> Known:
    N, f = np.sort(rng.uniform(1.2, 20, 4)), focal_length(rng)
    return Known({"f": f, "d": f / N}, N)


# --- sharpness ----------------------------------------------------------------------------------


def lens_for_landscapes(rng: Generator) -> Known:
    """Choose the hyperfocal distance; the spot of a star, by similar triangles, follows."""
    f, N = focal_length(rng), full_or_half_stop(rng)
    H = f * rng.uniform(100, 900)
    return Known({"f": f, "N": N, "c": f / N * f / (H - f)}, H)


def several_stops(rng: Generator) -> Known:
    lens = lens_for_landscapes(rng)
    f, c = lens.inputs["f"], lens.inputs["c"]
    N = lens.inputs["N"] * np.array([1, 2, 4])
    return Known({"f": f, "N": N, "c": c}, f + (lens.truth - f) / np.array([1, 2, 4]))


def focused(rng: Generator, ratio: Any) -> Known:
    """Choose the near limit as a share of the focus distance; the far limit follows.

    In 1/Z, the focus lies in the middle between the limits.
    """
    f, N, c = focal_length(rng), full_or_half_stop(rng), float(spot(rng))
    s = f + f * f * (1 / ratio - 1) / (N * c)  # the spot of the near limit is c
    beyond = 2 - 1 / ratio
    far = np.where(beyond > 0, s / np.where(beyond > 0, beyond, 1), np.inf)[()]
    return Known({"f": f, "N": N, "focus_distance": s, "c": c}, (ratio * s, far))


def close_enough(rng: Generator, size: int | None = None) -> Any:
    """Draw a near limit in focus distances, for a lens focused well before the hyperfocal one."""
    return 1 / (1 + np.exp(rng.uniform(np.log(0.02), np.log(0.6), size)))


def before_hyperfocal(rng: Generator) -> Known:
    return focused(rng, close_enough(rng))


def beyond_hyperfocal(rng: Generator) -> Known:
    return focused(rng, float(rng.uniform(0.1, 0.45)))


def exactly_hyperfocal(rng: Generator) -> Known:
    """Focus exactly on the hyperfocal distance, with plain numbers of which none is rounded."""
    f, N, c = float(rng.integers(12, 200)), float(rng.choice([2, 4, 8, 16])), 2.0**-7
    H = f * f / (N * c) + f
    return Known({"f": f, "N": N, "focus_distance": H, "c": c}, (H / 2, np.inf))


def focus_distances(rng: Generator) -> Known:
    return focused(rng, np.append(close_enough(rng, 3), rng.uniform(0.2, 0.4)))


def depth_range(rng: Generator) -> Known:
    """Choose f-number and focus; the ends of the range follow."""
    lens = before_hyperfocal(rng)
    (near, far), given = lens.truth, lens.inputs
    inputs = {"f": given["f"], "near": near, "far": far, "c": given["c"]}
    return Known(inputs, (given["N"], given["focus_distance"]))


def range_to_infinity(rng: Generator) -> Known:
    given = focused(rng, 0.5).inputs
    inputs = {"f": given["f"], "near": given["focus_distance"] / 2, "far": np.inf, "c": given["c"]}
    return Known(inputs, (given["N"], given["focus_distance"]))


def closeup(rng: Generator, smallest: float, largest: float) -> Inputs:
    m = float(rng.uniform(smallest, largest))
    return {"m": m, "N": full_or_half_stop(rng), "c": float(spot(rng))}


def machine_part(rng: Generator) -> Inputs:
    return closeup(rng, 0.02, 0.6)


def microscope(rng: Generator) -> Inputs:
    return closeup(rng, 2, 100)


def several_closeups(rng: Generator) -> Inputs:
    return {**closeup(rng, 0.1, 1), "m": rng.uniform(0.05, 20, 4)}


# --- diffraction --------------------------------------------------------------------------------

#: Airy disk in pixels: two clearly sharp, then one for each wrong rule to stumble over.
BANDS = ((0.25, 0.4), (0.6, 0.9), (1.1, 1.35), (1.5, 1.9), (2.1, 2.35), (2.7, 4))


def wavelength(rng: Generator) -> float:
    return float(rng.uniform(0.0004, 0.0007))


def airy(rng: Generator) -> Inputs:
    return {"wavelength": wavelength(rng), "N": full_or_half_stop(rng)}


def several_airy(rng: Generator) -> Inputs:
    return {"wavelength": wavelength(rng), "N": np.sort(rng.uniform(1.4, 22, 4))}


def disk_in_pixels(rng: Generator) -> Any:
    return rng.permutation([rng.uniform(low, high) for low, high in BANDS])


def one_camera(rng: Generator) -> Known:
    """Choose how many pixels wide the Airy disk is, as often below one as above."""
    few, many = np.split(np.sort(disk_in_pixels(rng)), [2])
    pixels = float(rng.choice(few if rng.uniform() < 0.5 else many))
    N, light = full_or_half_stop(rng), wavelength(rng)
    return Known({"N": N, "wavelength": light, "pitch": 2.44 * light * N / pixels}, pixels > 1)


def stops_of_a_lens(rng: Generator) -> Known:
    pixels, light, pitch = disk_in_pixels(rng), wavelength(rng), float(rng.uniform(0.005, 0.009))
    N = pixels * pitch / (2.44 * light)
    return Known({"N": N, "wavelength": light, "pitch": pitch}, pixels > 1)


def several_sensors(rng: Generator) -> Known:
    pixels, N, light = disk_in_pixels(rng), full_or_half_stop(rng), wavelength(rng)
    return Known({"N": N, "wavelength": light, "pitch": 2.44 * light * N / pixels}, pixels > 1)


# --- two lenses ---------------------------------------------------------------------------------


def pair(f1: float, f2: float, d: float) -> Known:
    """Take the truth from the textbook's closed form for two thin lenses, not from matrices."""
    f = f1 * f2 / (f1 + f2 - d)
    return Known({"f1": float(f1), "f2": float(f2), "d": float(d)}, (f, f * d / f2, -f * d / f1))


def two_that_collect(rng: Generator) -> Known:
    f1, f2 = rng.uniform(40, 200, 2)
    return pair(f1, f2, min(f1, f2) * rng.uniform(0.1, 0.6))


def telephoto(rng: Generator) -> Known:
    """Collect first, then spread: the system is shorter than its focal length."""
    f1 = rng.uniform(50, 150)
    f2 = -f1 * rng.uniform(0.3, 0.8)
    return pair(f1, f2, f1 + f2 - f2 * rng.uniform(0.2, 0.9))


def retrofocus(rng: Generator) -> Known:
    """Spread first, then collect: room for a mirror behind a wide lens."""
    f2 = rng.uniform(30, 80)
    return pair(-f2 * rng.uniform(1.3, 3), f2, rng.uniform(10, 60))
