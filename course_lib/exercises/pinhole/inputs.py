"""Inputs for the exercises of chapter 01; some with the answer known by construction."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.random import Generator

from course_lib.judging import Known

Inputs = dict[str, Any]


def focal_length(rng: Generator) -> float:
    return float(np.round(rng.uniform(8, 200), 1))


def square_pixels(rng: Generator) -> Inputs:
    pitch = rng.uniform(0.002, 0.009)
    width, height = (int(size) for size in rng.choice([640, 800, 1280, 1920, 2448], 2, False))
    sensor_size = (width * pitch, height * pitch)
    return {"f": focal_length(rng), "sensor_size": sensor_size, "image_size": (width, height)}


def oblong_pixels(rng: Generator) -> Inputs:
    inputs = square_pixels(rng)
    width, height = inputs["sensor_size"]
    return {**inputs, "sensor_size": (width, height * rng.uniform(1.05, 1.4))}


def lens(rng: Generator, nearest: float, farthest: float) -> Inputs:
    """Draw a focal length in multiples of the width of a sensor that is not 3:2."""
    width = rng.uniform(5, 36)
    height = width * rng.choice([rng.uniform(0.5, 0.63), rng.uniform(0.7, 0.95)])
    return {"f": width * rng.uniform(nearest, farthest), "sensor_size": (width, height)}


def wide_lens(rng: Generator) -> Inputs:
    return lens(rng, 0.3, 0.9)


def long_lens(rng: Generator) -> Inputs:
    return lens(rng, 2, 9)


def same_shape_sensor(rng: Generator) -> Inputs:
    width = rng.uniform(5, 30)
    return {"f": focal_length(rng), "sensor_size": (width, width * 2 / 3)}


def intrinsics(rng: Generator) -> tuple[float, Any]:
    f, cx, cy = rng.uniform(500, 1500), rng.uniform(250, 400), rng.uniform(180, 280)
    return float(f), np.array([cx, cy])


def points_in_front(rng: Generator) -> Known:
    """Make points from their pixels: on each pixel's ray, at a depth that we choose."""
    f, c = intrinsics(rng)
    pixels = rng.uniform((-300, -200), (940, 680), (4, 2))  # also outside of the picture
    depth = rng.uniform(1, 9, (4, 1))
    points = np.hstack([(pixels - c) / f * depth, depth])
    return Known({"points": points, "f": f, "c": c}, pixels)


def one_point(rng: Generator) -> Known:
    many = points_in_front(rng)
    return Known({**many.inputs, "points": many.inputs["points"][0]}, many.truth[0])


def points_behind(rng: Generator) -> Known:
    """Turn two points to where the camera does not see: behind it, and into its own plane."""
    many = points_in_front(rng)
    points, truth = many.inputs["points"].copy(), many.truth.copy()
    points[1, 2], points[2, 2] = -points[1, 2], 0
    truth[1:3] = np.nan
    return Known({**many.inputs, "points": points}, truth)


def two_focal_lengths(rng: Generator) -> Known:
    many = points_in_front(rng)
    f = many.inputs["f"] * np.array([1, rng.uniform(1.1, 1.4)])
    c = many.inputs["c"]
    return Known({**many.inputs, "f": f}, (many.truth - c) * f / many.inputs["f"] + c)


def line_ahead(rng: Generator) -> Known:
    """Make a direction, not of unit length, from its vanishing point."""
    f, c = intrinsics(rng)
    pixel = rng.uniform((-300, -200), (900, 700))
    direction = rng.uniform(0.5, 4) * np.append((pixel - c) / f, 1)
    return Known({"direction": direction, "f": f, "c": c}, pixel)


def line_with_two_focal_lengths(rng: Generator) -> Known:
    ahead = line_ahead(rng)
    f = ahead.inputs["f"] * np.array([1, rng.uniform(1.1, 1.4)])
    c = ahead.inputs["c"]
    return Known({**ahead.inputs, "f": f}, (ahead.truth - c) * f / ahead.inputs["f"] + c)


def line_towards_us(rng: Generator) -> Known:
    ahead = line_ahead(rng)
    return Known({**ahead.inputs, "direction": -ahead.inputs["direction"]}, ahead.truth)


def lines_across(rng: Generator) -> Known:
    """Make two directions: one has a vanishing point, one is parallel to the image plane."""
    ahead = line_ahead(rng)
    across = np.append(rng.uniform(0.2, 1, 2), 0)
    directions = np.array([ahead.inputs["direction"], across])
    truth = np.array([ahead.truth, [np.nan, np.nan]])
    return Known({**ahead.inputs, "direction": directions}, truth)


def moving_away(rng: Generator) -> Inputs:
    Z = rng.uniform(1, 5)
    return {"f": focal_length(rng), "Z": float(Z), "Z_new": float(Z * rng.uniform(1.3, 4))}


def several_distances(rng: Generator) -> Inputs:
    away = moving_away(rng)
    return {**away, "Z_new": away["Z"] * rng.uniform(1.3, 4, 4)}


def moving_closer(rng: Generator) -> Inputs:
    away = moving_away(rng)
    return {**away, "Z": away["Z_new"], "Z_new": away["Z"]}


def several_boxes(rng: Generator) -> Inputs:
    return {**box_camera(rng), "image_distance": rng.uniform(40, 400, 3)}


def box_camera(rng: Generator) -> Inputs:
    wavelength = rng.uniform(0.0004, 0.0007)
    return {"image_distance": float(rng.uniform(40, 400)), "wavelength": float(wavelength)}
