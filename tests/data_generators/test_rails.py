import numpy as np
import pytest

from course_lib.distortion import (
    distort_pixels,
    distortion_from_lines,
    straightness,
    undistort_pixels,
)
from data_generators.rails import (
    DISTANCE,
    LENGTH,
    LENS,
    RAILS,
    SIZE,
    K,
    middle_line,
    photograph,
    rail_points,
)


@pytest.fixture(scope="module")
def points():
    return rail_points(photograph())


def test_photograph_is_a_grey_picture_and_always_the_same():
    assert photograph().shape == SIZE[::-1]
    assert photograph().dtype == np.uint8
    photograph.cache_clear()
    first = photograph().copy()
    photograph.cache_clear()
    np.testing.assert_array_equal(photograph(), first)


@pytest.mark.parametrize("rail", range(3))
def test_found_points_lie_on_the_projected_middle_line(rail, points):
    x = np.linspace(-LENGTH / 2, LENGTH / 2, 400)
    ideal = np.column_stack([x, middle_line(RAILS[rail], x)]) / DISTANCE
    seen = distort_pixels(ideal * K[0, 0] + K[:2, 2], K, LENS)
    expected = np.interp(points[rail][:, 0], *seen.T)
    off = points[rail][:, 1] - expected
    assert np.abs(off).max() < 0.35
    assert np.sqrt(np.mean(off**2)) < 0.2


def test_the_bowed_rail_looks_straightest_and_is_the_least_straight(points):
    seen = [straightness(line) for line in points]
    true = [straightness(undistort_pixels(line, K, LENS)) for line in points]
    assert int(np.argmin(seen)) == 1
    assert int(np.argmax(true)) == 1
    assert seen[1] < 0.1
    assert min(seen[0], seen[2]) > 2.5
    assert true[1] > 1.2
    assert max(true[0], true[2]) < 0.05


def test_straight_rails_tell_the_lens(points):
    found = distortion_from_lines([points[0], points[2]], K)
    assert (np.abs(found.coefficients - LENS[:2]) < 4 * found.sigma).all()
    np.testing.assert_allclose(found.coefficients, LENS[:2], atol=0.01)
