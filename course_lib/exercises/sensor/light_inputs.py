"""Inputs for the exercises of chapter 04 on exposure, electrons, motion and stripes of light."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.random import Generator

from course_lib.judging import Known
from course_lib.sensor import SensorModel

Inputs = dict[str, Any]

F_NUMBERS = (1.4, 2.0, 2.8, 4.0, 5.6, 8.0, 11.0, 16.0)
SPEEDS = (200, 400, 800, 1250, 3200)

# --- exposure ---------------------------------------------------------------------------------


def two_f_numbers(rng: Generator) -> tuple[float, float]:
    before, after = rng.choice(F_NUMBERS, 2, replace=False)
    return float(before), float(after)


def shutter_time(rng: Generator) -> float:
    return float(np.round(1 / rng.uniform(3, 500), 5))


def settings(rng: Generator) -> Inputs:
    return {"N": two_f_numbers(rng)[0], "t": shutter_time(rng), "iso": 100}


def sensitive_settings(rng: Generator) -> Inputs:
    return {**settings(rng), "iso": int(rng.choice(SPEEDS))}


def many_settings(rng: Generator) -> Inputs:
    N = rng.choice(F_NUMBERS, 4, replace=False)
    return {"N": N, "t": 1 / rng.uniform(3, 500, 4), "iso": int(rng.choice(SPEEDS))}


def other_aperture(rng: Generator) -> Inputs:
    N, N_new = two_f_numbers(rng)
    iso = int(rng.choice(SPEEDS))
    return {"t": shutter_time(rng), "N": N, "N_new": N_new, "iso": iso, "iso_new": iso}


def other_speed(rng: Generator) -> Inputs:
    N, _ = two_f_numbers(rng)
    iso, iso_new = (int(speed) for speed in rng.choice(SPEEDS, 2, replace=False))
    return {"t": shutter_time(rng), "N": N, "N_new": N, "iso": iso, "iso_new": iso_new}


def several_apertures(rng: Generator) -> Inputs:
    speed = other_speed(rng)
    return {**speed, "N_new": rng.choice(F_NUMBERS, 4, replace=False)}


# --- photons to numbers -----------------------------------------------------------------------


def any_sensor(rng: Generator, **changes: Any) -> SensorModel:
    """Draw a sensor whose well is full and whose numbers end at about the same light."""
    bits = int(rng.choice([10, 12]))
    full_well = float(np.round(rng.uniform(8_000, 20_000), -2))
    made: dict[str, Any] = {
        "quantum_efficiency": float(np.round(rng.uniform(0.35, 0.8), 2)),
        "full_well": full_well,
        "read_noise": float(np.round(rng.uniform(4, 15), 1)),
        "dark_current": float(np.round(rng.uniform(20, 60))),
        "gain": float(np.round(2**bits / full_well, 3)),
        "offset": float(rng.integers(16, 64)),
        "bits": bits,
    }
    return SensorModel(**(made | changes))


def photons_for(rng: Generator, camera: SensorModel, low: float, high: float) -> Any:
    """Draw numbers of photons that fill the pixel between two shares of its saturation."""
    shares = rng.uniform(low, high, 4)
    return np.round(shares * camera.saturation / camera.quantum_efficiency)


def ordinary_light(rng: Generator) -> Inputs:
    camera = any_sensor(rng)
    photons = photons_for(rng, camera, 0.1, 0.8)
    return {"photons": photons, "camera": camera, "exposure_time": 0.0}


def long_exposure(rng: Generator) -> Inputs:
    """Draw little light, and seconds in which the dark current is a good part of the signal."""
    camera = any_sensor(rng)
    photons = photons_for(rng, camera, 0.05, 0.2)
    seconds = float(np.round(rng.uniform(4, 20), 1))
    return {"photons": photons, "camera": camera, "exposure_time": seconds}


def too_bright(rng: Generator, **changes: Any) -> Inputs:
    camera = any_sensor(rng, **changes)
    photons = photons_for(rng, camera, 0.1, 0.8)
    photons[1:3] = np.round(rng.uniform(1.3, 4, 2) * photons_for(rng, camera, 1, 1)[:2])
    return {"photons": photons, "camera": camera, "exposure_time": 0.0}


def full_pixels(rng: Generator) -> Inputs:
    """Draw a well that overflows long before the numbers end, in seconds of dark current."""
    made = too_bright(rng, full_well=8_000.0, gain=0.35, bits=12)
    return {**made, "exposure_time": float(np.round(rng.uniform(4, 20), 1))}


def last_number(rng: Generator) -> Inputs:
    """Draw numbers that end long before the well is full, as at a high ISO speed."""
    bits = int(rng.choice([13, 14]))
    return too_bright(rng, full_well=20_000.0, gain=0.55 * 2 ** (bits - 12), bits=bits)


def light_rules(rng: Generator) -> Inputs:
    camera = any_sensor(rng)
    photons = photons_for(rng, camera, 0.1, 0.9)
    return {"photons": photons, "camera": camera, "exposure_time": 0.0}


def readout_rules(rng: Generator) -> Inputs:
    """Draw a handful of photons, and numbers so coarse that their rounding is heard too."""
    camera = any_sensor(rng, bits=8, offset=4, gain=float(np.round(rng.uniform(0.012, 0.03), 3)))
    photons = np.round(rng.uniform(20, 300, 4))
    return {"photons": photons, "camera": camera, "exposure_time": 0.0}


# --- motion -----------------------------------------------------------------------------------


def part_on_a_belt(rng: Generator) -> Inputs:
    speed, pixel_size = rng.uniform(100, 2000), rng.uniform(0.05, 0.4)
    seconds = 1 / rng.uniform(500, 5000)
    return {"speed": speed, "exposure_time": seconds, "pixel_size": pixel_size}


def drone(rng: Generator) -> Inputs:
    speed, pixel_size = rng.uniform(4, 18), rng.uniform(0.01, 0.06)
    seconds = 1 / rng.uniform(200, 2000)
    return {"speed": speed, "exposure_time": seconds, "pixel_size": pixel_size}


def several_speeds(rng: Generator) -> Inputs:
    return {**part_on_a_belt(rng), "speed": rng.uniform(100, 2000, 4)}


def to_the_right(rng: Generator) -> Inputs:
    return {
        "speed": rng.uniform(200, 5000),
        "row_time": rng.uniform(8e-6, 40e-6),
        "rows": int(rng.integers(200, 1500)),
    }


def to_the_left(rng: Generator) -> Inputs:
    right = to_the_right(rng)
    return {**right, "speed": -right["speed"]}


def several_edges(rng: Generator) -> Inputs:
    right = to_the_right(rng)
    rows = rng.integers(200, 1500, 4)
    speed = right["speed"] * np.array([1, -0.5, -1.5, 0.3])
    return {**right, "speed": speed, "rows": rows}


# --- structured light -------------------------------------------------------------------------


def stripe(rng: Generator, heights: Any, camera_angle: float) -> Known:
    """Follow the light and the line of sight of points that we choose; their places are exact.

    In the plane of the picture x points towards the light and z up. The sheet of light that hits
    the table at 0 runs along (sin, cos) of its angle; the line of sight goes down the other way.
    """
    light_angle = float(np.radians(np.round(rng.uniform(20, 65))))
    along_light = np.array([np.sin(light_angle), np.cos(light_angle)])
    lit = np.asarray(heights)[..., None] / along_light[1] * along_light
    # Down the line of sight, from (x, z) on the surface to (shift, 0) on the table.
    steps = lit[..., 1] / np.cos(camera_angle)
    shift = lit[..., 0] + steps * np.sin(camera_angle)
    inputs = {"shift": shift, "light_angle": light_angle, "camera_angle": camera_angle}
    return Known(inputs, heights)


def tilt(rng: Generator) -> float:
    return float(np.radians(np.round(rng.uniform(10, 40))))


def straight_down(rng: Generator) -> Known:
    return stripe(rng, float(rng.uniform(1, 20)), 0.0)


def from_the_side(rng: Generator) -> Known:
    return stripe(rng, float(rng.uniform(1, 20)), tilt(rng))


def profile(rng: Generator) -> Known:
    heights = rng.uniform(1, 20, 5) * np.array([1, 1, -0.3, 1, -0.2])
    return stripe(rng, heights, tilt(rng))
