"""Chapter 00: one practice exercise, so that the way a check speaks is no surprise later."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.random import Generator

from course_lib import camera
from course_lib.judging import Exercise, Misconception


def _even_size(rng: Generator) -> dict[str, Any]:
    width, height = 2 * rng.integers(160, 2000, size=2)
    return {"image_size": (int(width), int(height) + 2 * int(width == height))}


def _odd_size(rng: Generator) -> dict[str, Any]:
    size = _even_size(rng)["image_size"]
    return {"image_size": (size[0] + 1, size[1] + 1)}


def computes_with_a_tuple(image_size):
    return (image_size - 1) / 2


def half_the_size(image_size):
    return np.array(image_size) / 2


def row_then_column(image_size):
    width, height = image_size
    return np.array([(height - 1) / 2, (width - 1) / 2])


def last_pixel(image_size):
    return np.array(image_size) - 1


def rounded_down(image_size):
    return (np.array(image_size) - 1) // 2


IMAGE_CENTRE = Exercise(
    "welcome",
    camera.image_centre,
    parts={"an odd number of pixels": _odd_size, "an even number of pixels": _even_size},
    misconceptions=[
        Misconception(
            computes_with_a_tuple,
            "A size comes as a tuple, such as (640, 480). What makes an array of it?",
        ),
        Misconception(
            half_the_size,
            "A picture 3 pixels wide has the columns 0, 1 and 2. Which of them is in the middle?",
        ),
        Misconception(
            row_then_column, "Which of u and v runs along a row of pixels, and which comes first?"
        ),
        Misconception(
            last_pixel, "Is this pixel in the middle of the picture, or in its last corner?"
        ),
        Misconception(
            rounded_down,
            "A picture 2 pixels wide has the columns 0 and 1. Must its middle be a whole pixel?",
        ),
    ],
    points=2,
)

EXERCISES = (IMAGE_CENTRE,)
