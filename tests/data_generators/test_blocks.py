import numpy as np
import pytest

from course_lib.bundle import bundle_adjust, check_block
from course_lib.orientation import check_point_rmse, similarity_transform
from data_generators.blocks import flight, large_block, turntable

MAKERS = {"flight": flight, "turntable": turntable}


@pytest.fixture(params=MAKERS)
def make(request):
    return MAKERS[request.param]


def test_the_same_seed_gives_the_same_block(make):
    one, other = (make(np.random.default_rng(1), points=50, pictures=5) for _ in range(2))
    np.testing.assert_array_equal(one.observations.pixels, other.observations.pixels)
    np.testing.assert_array_equal(one.truth.points, other.truth.points)


def test_noise_and_wrong_matches_are_what_was_asked_for(make):
    known = make(np.random.default_rng(2), points=400, noise=0.5, wrong=0.1)
    seen, truth = known.observations, known.truth
    away = seen.pixels - truth.project(seen.cameras, seen.points)
    assert known.wrong.mean() == pytest.approx(0.1, abs=0.03)
    assert away[~known.wrong].std() == pytest.approx(0.5, rel=0.05)
    assert np.linalg.norm(away[known.wrong], axis=1).min() > 15
    check_block(truth, seen)


def test_the_pixels_are_inside_and_fill_the_picture(make):
    known = make(np.random.default_rng(3), points=400, noise=0)
    assert (known.observations.pixels > -0.5).all()
    assert (known.observations.pixels < np.array(known.image_size) - 0.5).all()
    assert np.bincount(known.observations.cameras).min() > 30
    reach = np.ptp(known.observations.pixels, axis=0) / known.image_size
    assert reach.min() > 0.4
    assert reach.max() > 0.8
    assert not set(known.control) & set(known.check)


def test_neighbours_overlap_as_asked_for():
    for forward in (0.6, 0.8):
        known = flight(np.random.default_rng(4), 1, 6, 800, (forward, 0.6), noise=0)
        seen = known.observations
        common = [
            len(np.intersect1d(seen.points[seen.cameras == i], seen.points[seen.cameras == i + 1]))
            / (seen.cameras == i).sum()
            for i in range(1, 4)
        ]
        # Points in one picture alone are no tie points, so the share is a little larger.
        assert np.mean(common) == pytest.approx(forward, abs=0.15)


def test_the_back_of_the_vase_is_hidden():
    known = turntable(np.random.default_rng(5), noise=0)
    seen, truth = known.observations, known.truth
    outward = truth.points * [1, 1, 0]
    towards = truth.centres[seen.cameras] - truth.points[seen.points]
    assert ((outward[seen.points] * towards).sum(axis=1) > 0).all()


def test_oblique_pictures_look_from_the_side():
    known = flight(np.random.default_rng(6), oblique=4)
    tilt = np.arccos(-known.truth.R[:, 2, 2])
    assert (tilt[:-4] < 0.1).all()
    assert (tilt[-4:] > 0.5).all()


def test_the_large_block_has_the_size_of_its_model():
    known = large_block(np.random.default_rng(0))
    assert (len(known.truth.R), len(known.truth.points)) == (49, 7776)
    assert len(known.observations) == 31_919
    check_block(known.truth, known.observations)


def test_a_lens_that_was_not_taken_into_account_makes_a_dome():
    """Parallel pictures bend into a dome; control in the middle, or oblique pictures, hold it."""
    heights = {}
    for oblique in (0, 8):
        known = flight(np.random.default_rng(7), 3, 7, 500, noise=0.1, oblique=oblique)
        seen, f = known.observations, known.truth.K[0, 0, 0]
        x = (seen.pixels - known.truth.K[0, :2, 2]) / f
        pixels = seen.pixels + f * -0.01 * (x * x).sum(axis=1, keepdims=True) * x
        fit = bundle_adjust(known.truth, type(seen)(seen.cameras, seen.points, pixels, 0.1))
        placed = similarity_transform(fit.block.points, known.truth.points)
        errors = check_point_rmse(placed.apply(fit.block.points), known.truth.points)
        heights[oblique] = errors.z
    assert heights[0] > 1.5 * heights[8]
