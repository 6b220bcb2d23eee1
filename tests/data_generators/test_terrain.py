"""The ground is one net of triangles under one map."""

import numpy as np
import pytest

from data_generators.raycast import bilinear
from data_generators.terrain import CELL, height_at, terrain


@pytest.fixture(scope="module")
def ground():
    marks = np.array([[20.0, 20.0], [41.5, 29.0]])
    return terrain(np.random.default_rng(0), (7, 6), 5.0, marks, houses=2)


def test_the_corners_are_those_of_the_net(ground):
    for patch in ground.scene.patches[: 2 * 7 * 6]:
        x, y, z = patch.corners.T
        np.testing.assert_allclose(x % CELL, 0, atol=1e-9)
        column, row = np.rint(np.stack([x, y]) / CELL).astype(int)
        np.testing.assert_allclose(z, ground.heights[row, column], atol=1e-9)
        assert patch.normal[2] > 0.5


def test_the_height_between_corners_is_that_of_the_triangles(ground):
    for patch in ground.scene.patches[: 2 * 7 * 6 : 5]:
        inside = np.array([[0.2, 0.3, 0.5], [0.6, 0.2, 0.2]]) @ patch.corners
        z = height_at(ground.heights, inside[:, :2])
        np.testing.assert_allclose(z, inside[:, 2], atol=1e-9)
    assert np.ptp(ground.heights) <= 5
    np.testing.assert_allclose(ground.marks[:, 2], height_at(ground.heights, ground.marks[:, :2]))


def colour(patch, place):
    """Return the colour of a patch at a place in plan."""
    edges = np.stack([patch.edge_u[:2], patch.edge_v[:2]], axis=1)
    a, b = np.linalg.solve(edges, place - patch.origin[:2])
    rows, columns = patch.texture.shape[:2]
    return bilinear(patch.texture, np.array([a * columns - 0.5]), np.array([b * rows - 0.5]), False)


def test_the_map_has_no_seam(ground):
    """On an edge that triangles share, they show the same colour."""
    patches = ground.scene.patches[: 2 * 7 * 6]
    shared = 0
    for i, one in enumerate(patches):
        for other in patches[:i]:
            same = [c for c in one.corners if (np.abs(other.corners - c) < 1e-9).all(axis=1).any()]
            if len(same) == 2:
                shared += 1
                for share in (0.25, 0.6):
                    place = (share * same[0] + (1 - share) * same[1])[:2]
                    np.testing.assert_allclose(colour(one, place), colour(other, place), atol=1e-6)
    assert shared == 42 + 6 * 6 + 7 * 5  # diagonals, and borders of cells


def test_houses_stand_on_the_ground(ground):
    """Their feet touch it, and no mark is under one."""
    for patch in ground.scene.patches[2 * 7 * 6 :]:
        low = patch.corners[patch.corners[:, 2].argmin()]
        assert low[2] > height_at(ground.heights, low[None, :2])[0] - 1e-9
        away = np.abs(ground.marks[:, None, :2] - patch.corners[:, :2]).max(axis=2)
        assert away.min() > 1
