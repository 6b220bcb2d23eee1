"""Cameras and points from tie points alone: against the truth, with wrong tie points."""

from itertools import pairwise

import numpy as np
import pytest

from course_lib.bundle import Block, Observations
from course_lib.checks import DegenerateConfigurationError
from course_lib.orientation import Similarity, check_point_rmse, similarity_transform
from course_lib.reconstruction import reconstruct
from course_lib.reconstruction.growth import Growth
from course_lib.reconstruction.start import start_pairs
from course_lib.tie_points import tracks
from course_lib.transforms import rotation_from_vector
from data_generators import blocks
from data_generators.block_pictures import flight_pictures, turntable_pictures
from data_generators.blocks import flight, turntable


def rng(seed=0):
    return np.random.default_rng(seed)


def errors(found, known):
    """Return how far points and centres are off after a similarity, by the size of the object."""
    truth = known.truth
    # Points of two rays may be wrong; they shall not move the others.
    sure = np.bincount(found.observations.points) > 2
    placed = similarity_transform(found.block.points[sure], truth.points[found.points[sure]])
    block = found.oriented(placed)
    size = np.ptp(truth.points, axis=0).max()
    points = np.linalg.norm(block.points - truth.points[found.points], axis=1)
    centres = np.linalg.norm(block.centres - truth.centres[found.cameras], axis=1)
    return points / size, centres / size


@pytest.fixture(scope="module")
def strips():
    """Return a flight of which every tenth tie point is wrong, and its reconstruction."""
    known = flight(rng(1), 2, 5, 400, wrong=0.1)
    return known, reconstruct(known.observations, known.truth.K[0], rng())


def test_accuracy(strips):
    known, found = strips
    assert sorted(found.cameras) == list(range(10))
    assert not found.left_out
    points, centres = errors(found, known)
    assert len(found.points) > 0.8 * len(known.truth.points)
    assert np.median(points) < 5e-4
    assert np.quantile(points, 0.95) < 2e-3
    assert np.sqrt((centres**2).mean()) < 1e-3
    # Pixels were measured to 0.5, and that is what their residuals say.
    assert found.adjustment.sigma0 == pytest.approx(1, abs=0.08)


def test_wrong_tie_points_are_thrown_out(strips):
    known, found = strips
    used = found.fates == "used"
    assert known.wrong.sum() > 100
    # Where two rays meet by accident, no third one contradicts.
    rays = np.bincount(known.observations.points)
    unnoticed = known.wrong & used
    assert unnoticed.sum() <= 0.05 * known.wrong.sum()
    assert (rays[known.observations.points[unnoticed]] == 2).all()
    assert used[~known.wrong].mean() > 0.85
    assert set(found.fates) <= {"used", "off", "behind", "alone", "left out"}
    assert used.sum() == len(found.observations)


def test_steps_tell_how_the_block_grew(strips):
    _, found = strips
    steps = found.steps
    assert len(steps) == 9
    assert len(steps[0].pictures) == 2
    assert [p for step in steps for p in step.pictures] == found.cameras.tolist()
    for before, step in pairwise(steps):
        assert len(step.block.R) == len(step.cameras) == len(before.block.R) + 1
        assert len(step.points) == len(step.block.points)
        assert step.agreed <= step.seen
        assert step.rms_after <= step.rms_before + 1e-9
        gone = len(before.points) + step.added - len(step.points)
        assert 0 <= gone <= step.rejected
    assert sum(step.rejected for step in steps) > 100
    assert "Picture" in str(steps[3])
    assert f"{steps[3].added} new" in str(steps[3])


def test_the_result_is_a_minimum(strips):
    """The block and its observations belong together, and the residuals are theirs."""
    _, found = strips
    seen, block = found.observations, found.block
    away = block.project(seen.cameras, seen.points) - seen.pixels
    np.testing.assert_allclose(away, found.adjustment.residuals, atol=1e-8)
    assert found.adjustment.converged
    assert np.linalg.norm(away, axis=1).max() < 4.2
    # Turned, moved and scaled, it sees the same.
    turn = Similarity(3.0, rotation_from_vector([0.3, -0.2, 0.5]), np.array([1.0, -2, 5]))
    moved = found.oriented(turn)
    np.testing.assert_allclose(
        moved.project(seen.cameras, seen.points) - seen.pixels, away, atol=1e-6
    )
    np.testing.assert_allclose(moved.centres, turn.apply(block.centres), atol=1e-8)
    assert found.rms == pytest.approx(np.sqrt((away**2).sum(axis=1).mean()))


def test_all_around_an_object():
    """A circle closes: the last picture is a neighbour of the first."""
    known = turntable(rng(2), 18, 200, wrong=0.15)
    found = reconstruct(known.observations, known.truth.K[0], rng())
    assert len(found.cameras) == 18
    points, centres = errors(found, known)
    assert np.sqrt((points**2).mean()) < 1e-3
    assert np.sqrt((centres**2).mean()) < 1e-2
    assert not (known.wrong & (found.fates == "used")).any()


def test_flat_ground(monkeypatch):
    """Two pictures of a plane begin if there are no better ones."""
    monkeypatch.setattr(blocks, "_hills", lambda plan, height: np.zeros(len(plan)))
    known = blocks.flight(rng(4), 2, 4, 300, wrong=0.1)
    found = reconstruct(known.observations, known.truth.K[0], rng())
    assert len(found.cameras) == 8
    assert np.quantile(errors(found, known)[0], 0.95) < 5e-3


def test_exact_pixels_give_the_truth():
    known = flight(rng(3), 1, 4, 200, noise=0)
    found = reconstruct(known.observations, known.truth.K[0], rng())
    points, centres = errors(found, known)
    assert points.max() < 1e-6
    assert centres.max() < 1e-6


def test_the_same_seed_gives_the_same_block(strips):
    known, found = strips
    again = reconstruct(known.observations, known.truth.K[0], rng())
    np.testing.assert_array_equal(again.block.points, found.block.points)


def measured(block, tracked, rays):
    """Return the errors of check points, after a similarity from control points."""
    found = reconstruct(tracked, block.K, rng())
    numbers, places = found.triangulated(block.observed_marks(rng(5), 0.3))
    control, check = np.isin(numbers, block.control), np.isin(numbers, block.check)
    placed = similarity_transform(places[control], block.marks[numbers[control]])
    assert check.sum() >= rays
    checked = check_point_rmse(placed.apply(places[check]), block.marks[numbers[check]])
    oriented = found.oriented(placed)
    away = np.linalg.norm(oriented.centres - block.centres[found.cameras], axis=1)
    return found, checked.total, np.sqrt((away**2).mean())


def test_a_vase_from_its_pictures():
    """From the pictures alone, by SIFT; then check points that were surveyed."""
    block = turntable_pictures(rng(0), 6, arc=np.deg2rad(6 * 15))
    pairs = [(i, j) for i in range(6) for j in range(i + 1, min(i + 4, 6))]
    tracked = tracks(block.pictures, block.K, rng(1), pairs=pairs, most=1500)
    found, checked, away = measured(block, tracked, 4)
    assert len(found.cameras) == 6
    assert len(found.points) > 800
    assert found.rms < 0.4
    assert checked < 1e-3  # m: the vase is 0.3 m high
    assert away < 5e-3


def test_ground_from_its_pictures():
    """Wrong pairs in the tracks are thrown out: no relative pose has seen them before."""
    block = flight_pictures(rng(0), 2, 3)
    tracked = tracks(block.pictures, ratio=0.9)
    found, checked, away = measured(block, tracked, 4)
    assert len(found.cameras) == 6
    assert (found.fates == "off").sum() > 20
    assert found.rms < 0.3
    assert checked < 0.35  # m: a pixel is 0.17 m wide, and the camera 100 m away
    assert away < 1


def test_pictures_of_something_else_are_left_out(strips):
    known, _ = strips
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


def test_a_picture_of_wrong_pixels_is_left_out(strips):
    known, _ = strips
    seen = known.observations.only(known.observations.cameras < 5)
    pixels = np.where(seen.cameras[:, None] == 2, rng().uniform(0, 3000, seen.pixels.shape), 0)
    pixels = np.where(seen.cameras[:, None] == 2, pixels, seen.pixels)
    found = reconstruct(Observations(seen.cameras, seen.points, pixels), known.truth.K[0], rng())
    assert sorted(found.cameras) == [0, 1, 3, 4]
    assert "pose" in found.left_out[2]


def test_pictures_with_a_few_points_in_common_are_left_out(strips):
    known, _ = strips
    seen = known.observations.only(known.observations.cameras < 4)
    mine = np.flatnonzero(seen.cameras == 3)
    found = reconstruct(
        seen.only(np.setdiff1d(np.arange(len(seen)), mine[6:])), known.truth.K[0], rng()
    )
    assert 3 in found.left_out
    assert "8 are needed" in found.left_out[3]


def test_observations_that_are_a_little_off_are_thrown_out():
    """Nine pixels are too few to be seen at once; the adjustment finds them."""
    known = flight(rng(7), 2, 4, 300, noise=0.3)
    seen = known.observations
    off = rng(8).random(len(seen)) < 0.05
    angle = rng(9).uniform(0, 2 * np.pi, len(seen))
    pixels = seen.pixels + 9 * off[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    moved = Observations(seen.cameras, seen.points, pixels)
    found = reconstruct(moved, known.truth.K[0], rng())
    rays = np.bincount(seen.points)[seen.points]
    well = off & (rays > 4)
    assert (found.fates[well] == "used").mean() < 0.1
    assert (found.fates[~off] == "used").mean() > 0.9


def test_the_threshold_holds_after_the_adjustment(strips):
    """Noise of 0.5 px often goes beyond 0.8 px, also when all has been adjusted."""
    known, _ = strips
    found = reconstruct(known.observations, known.truth.K[0], rng(), 0.8)
    assert np.linalg.norm(found.adjustment.residuals, axis=1).max() < 0.82


def test_a_step_that_fails_changes_nothing(strips, monkeypatch):
    known, _ = strips
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


def test_a_bad_start_is_not_the_end():
    """Two pictures from almost the same place have most in common, and are no start."""
    known = flight(rng(6), 1, 4, 300, (0.6, 0.6), noise=0.3)
    truth, old = known.truth, known.observations
    centres = np.append(truth.centres, truth.centres[:1] + np.array([0.2, 0, 0]), axis=0)
    R = np.append(truth.R, truth.R[:1], axis=0)
    block = Block(truth.K[0], R, -np.einsum("vij,vj->vi", R, centres), truth.points)
    twin = old.only(old.cameras == 0)
    pixels = block.project(np.full(len(twin), 4), twin.points)
    seen = Observations(
        np.concatenate([old.cameras, np.full(len(twin), 4)]),
        np.concatenate([old.points, twin.points]),
        np.concatenate([old.pixels, pixels]),
    )
    found = reconstruct(seen, truth.K[0], rng())
    assert set(found.steps[0].pictures) != {0, 4}
    assert len(found.cameras) == 5


def turned():
    """Return what cameras see that only turn."""
    X = rng().uniform((-2, -2, 6), (2, 2, 10), (60, 3))
    K = np.array([[800.0, 0, 320], [0, 800, 240], [0, 0, 1]])
    R = np.array([rotation_from_vector([0, a, 0]) for a in (0, 0.05, 0.1)])
    block = Block(K, R, np.zeros((3, 3)), X)
    cameras, points = np.divmod(np.arange(180), 60)
    noise = 0.2 * rng(1).normal(size=(180, 2))
    return Observations(cameras, points, block.project(cameras, points) + noise), K


def test_errors_say_what_to_do(strips):
    known, _ = strips
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
