"""Pictures that do not fit are left out, and what cannot be reconstructed says why."""

import numpy as np
import pytest

from course_lib.bundle import Block, Observations
from course_lib.checks import DegenerateConfigurationError
from course_lib.reconstruction import reconstruct, start
from course_lib.reconstruction.growth import Growth
from course_lib.reconstruction.start import start_pairs
from course_lib.transforms import rotation_from_vector
from data_generators.blocks import flight


def rng(seed=0):
    return np.random.default_rng(seed)


@pytest.fixture(scope="module")
def known():
    """Return a flight of which every tenth tie point is wrong."""
    return flight(rng(1), 2, 5, 400, wrong=0.1)


def test_pictures_of_something_else_are_left_out(known):
    seen = known.observations
    near = seen.only(np.isin(seen.cameras, [0, 1, 2, 3]))
    far = Observations(
        np.concatenate([near.cameras, [4] * 30]),
        np.concatenate([near.points, near.points.max() + 1 + np.arange(30)]),
        np.concatenate([near.pixels, rng().uniform(0, 3000, (30, 2))]),
    )
    found = reconstruct(far, known.truth.K[0], rng())
    assert sorted(found.cameras) == [0, 1, 2, 3]
    assert list(found.left_out) == [4]
    assert "no point in common" in found.left_out[4]
    assert (found.fates[-30:] == "left out").all()


def test_a_picture_of_wrong_pixels_is_left_out(known):
    seen = known.observations.only(known.observations.cameras < 5)
    pixels = np.where(seen.cameras[:, None] == 2, rng().uniform(0, 3000, seen.pixels.shape), 0)
    pixels = np.where(seen.cameras[:, None] == 2, pixels, seen.pixels)
    found = reconstruct(Observations(seen.cameras, seen.points, pixels), known.truth.K[0], rng())
    assert sorted(found.cameras) == [0, 1, 3, 4]
    assert "pose" in found.left_out[2]


def test_pictures_with_a_few_points_in_common_are_left_out(known):
    seen = known.observations.only(known.observations.cameras < 4)
    mine = np.flatnonzero(seen.cameras == 3)
    found = reconstruct(
        seen.only(np.setdiff1d(np.arange(len(seen)), mine[6:])), known.truth.K[0], rng()
    )
    assert 3 in found.left_out
    assert "8 are needed" in found.left_out[3]


def test_a_step_that_fails_changes_nothing(known, monkeypatch):
    growth = Growth(known.observations, known.truth.K[0], rng(), 4.0)
    growth.begin(next(start_pairs(growth.pixels, growth.K, rng(), 2.0)))
    before = {name: np.array(getattr(growth, name)) for name in ("R", "X", "trusted", "placed")}
    picture = next(k for k in range(10) if k not in growth.placed)

    def fails(*_):
        raise DegenerateConfigurationError("singular")

    monkeypatch.setattr(growth, "_adjusted", fails)
    with pytest.raises(DegenerateConfigurationError):
        growth.place(picture)
    for name, value in before.items():
        np.testing.assert_array_equal(getattr(growth, name), value)


def test_two_pictures_whose_pose_is_in_doubt_come_last(known, monkeypatch):
    growth = Growth(known.observations, known.truth.K[0], rng(), 4.0)
    found = iter(["another pose fits nearly as well", *[""] * start.LOOKED_AT])

    def looked_at(pixels, pictures, *_):
        return start.Pair(pictures, np.eye(3), np.zeros(3), (), (), next(found))

    monkeypatch.setattr(start, "_looked_at", looked_at)
    first, *_, last = start_pairs(growth.pixels, growth.K, rng(), 2.0)
    assert not first.doubt
    assert last.doubt


def turned():
    """Return what cameras see that only turn."""
    X = rng().uniform((-2, -2, 6), (2, 2, 10), (60, 3))
    K = np.array([[800.0, 0, 320], [0, 800, 240], [0, 0, 1]])
    R = np.array([rotation_from_vector([0, a, 0]) for a in (0, 0.05, 0.1)])
    block = Block(K, R, np.zeros((3, 3)), X)
    cameras, points = np.divmod(np.arange(180), 60)
    noise = 0.2 * rng(1).normal(size=(180, 2))
    return Observations(cameras, points, block.project(cameras, points) + noise), K


def test_errors_say_what_to_do(known):
    seen, K = known.observations, known.truth.K[0]
    with pytest.raises(DegenerateConfigurationError, match=r"no baseline.*Move the camera farther"):
        reconstruct(*turned(), rng())
    few = seen.only(seen.points < 15)
    with pytest.raises(DegenerateConfigurationError, match=r"20 points in common.*overlap more"):
        reconstruct(few, K, rng())
    twice = seen.only(np.append(np.arange(len(seen)), 0))
    with pytest.raises(ValueError, match="twice: keep one"):
        reconstruct(twice, K, rng())
    with pytest.raises(TypeError, match="default_rng"):
        reconstruct(seen, K, 0)
    with pytest.raises(ValueError, match="threshold"):
        reconstruct(seen, K, rng(), 0)
    with pytest.raises(ValueError, match="K must be"):
        reconstruct(seen, np.eye(3) * 2, rng())
    narrow = known.truth.centres * [0.001, 0.001, 1]
    block = Block(
        K, known.truth.R, -np.einsum("vij,vj->vi", known.truth.R, narrow), known.truth.points
    )
    exact = Observations(seen.cameras, seen.points, block.project(seen.cameras, seen.points))
    with pytest.raises(DegenerateConfigurationError, match="no two pictures to begin with"):
        reconstruct(exact, K, rng())
