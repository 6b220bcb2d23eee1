"""A street with signs that look equally large from one place, though they stand far apart."""

from __future__ import annotations

import numpy as np

from course_lib.checks import Array
from data_generators.bodies import WOOD, at, board, solid
from data_generators.places import street
from data_generators.scene import Scene, box
from data_generators.targets import letter_chart

#: Where they are seen equally large from, m in the world; the view is to the north.
VIEWPOINT = np.array([0.0, -3.5, 1.5])
#: Distances of the signs, m, and the tangents of their directions to the right of north.
DISTANCES = (1.2, 2.0, 3.5, 7.0, 14.0)
DIRECTIONS = (-0.176, 0.176, -0.088, 0.088, 0.0)
WIDTH = 0.075  # of a sign, by its distance


def street_with_signs(rng: np.random.Generator | None = None) -> Scene:
    """Return the street of `places` with five eye charts on posts.

    Parameters
    ----------
    rng : numpy.random.Generator, optional
        For the letters and the grain of the surfaces; the same street every time without one.

    Returns
    -------
    Scene
        World: x east, y north, z up, m.
    """
    empty = street(rng, targets=False)
    letters = np.random.default_rng(3) if rng is None else rng
    signs = []
    for foot, Z in zip(sign_feet(), DISTANCES, strict=True):
        side = WIDTH * Z
        low = float(VIEWPOINT[2]) - 0.5 * side
        chart = letter_chart(320, 5, rng=letters)
        front, rear, *_ = board(foot, chart, (side, side), lift=low)
        thick = 0.05 * side
        post = box(foot + at(-thick / 2, thick, 0), (thick, thick, low), solid(WOOD), solid(WOOD))
        signs += [front, rear, *post]
    return Scene((*empty.patches, *signs), empty.background)


def sign_feet() -> Array:
    """Return the places below the middles of the signs, shape (5, 3), m."""
    x, y, _ = VIEWPOINT
    feet = [at(x + Z * a, y + Z, 0) for Z, a in zip(DISTANCES, DIRECTIONS, strict=True)]
    return np.array(feet)
