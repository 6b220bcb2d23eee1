"""The belt, its smear and the pictures of even surfaces."""

import numpy as np
import pytest

from course_lib.sensor import SensorModel
from data_generators import belt, flats


def test_shapes_and_range():
    picture = belt.belt()
    assert picture.shape == (320, 480, 3)
    assert picture.dtype == np.float32
    assert picture.min() > 0
    assert picture.max() <= 1.2


def test_the_same_belt_every_time_and_another_grain_for_another_rng():
    np.testing.assert_array_equal(belt.belt(), belt.belt())
    assert (belt.belt() != belt.belt(np.random.default_rng(1))).any()


def test_parts_have_the_areas_of_their_geometry():
    share = belt.silhouettes()
    outer, inner = belt.WASHER
    corner, hole = belt.NUT
    washers = 3 * np.pi * (outer**2 - inner**2)
    nuts = 2 * (1.5 * np.sqrt(3) * corner**2 - np.pi * hole**2)
    assert share.sum() * belt.PIXEL**2 == pytest.approx(washers + nuts, rel=0.004)


@pytest.mark.parametrize("length", [0.3, 1, 2, 7.5, 40])
def test_a_point_becomes_a_line_of_that_length(length):
    point = np.zeros((3, 121))
    point[1, 60] = 1
    line = belt.smeared(point, length)[1].astype(float)
    assert line.sum() == pytest.approx(1, abs=1e-5)
    away = np.arange(121) - 60
    assert line @ away == pytest.approx(0, abs=1e-5)
    # A point between two pixels is shared by both: its spread is that of the way, plus that.
    way = length * ((np.arange(20_000) + 0.5) / 20_000 - 0.5)
    between = way - np.floor(way)
    spread = np.mean(way**2 + between * (1 - between))
    assert line @ away**2 == pytest.approx(spread, rel=1e-3)


def test_a_still_belt_stays_as_it_is_and_brightness_is_kept():
    picture = belt.belt()
    np.testing.assert_array_equal(belt.smeared(picture, 0), picture)
    assert belt.smeared(picture, 30).mean() == pytest.approx(picture.mean(), rel=0.02)


def test_errors():
    with pytest.raises(ValueError, match="length must not be negative, got -1"):
        belt.smeared(np.zeros((2, 2)), -1)


def test_pairs_differ_by_noise_alone():
    sensor = SensorModel(gain=0.25, read_noise=5)
    pairs = flats.flat_pairs(sensor, [2000.0, 10_000.0], np.random.default_rng(0), (80, 120))
    assert pairs.first.shape == (2, 80, 120)
    difference = pairs.first.astype(float) - pairs.second
    mean = pairs.first.mean(axis=(1, 2)) - sensor.offset
    expected = sensor.gain * mean + (sensor.gain * 5) ** 2 + 1 / 12
    np.testing.assert_allclose(difference.var(axis=(1, 2)) / 2, expected, rtol=0.05)
    assert pairs.first[1].std() > difference[1].std()  # what both have in common


def test_uneven_pictures_are_dark_in_the_corners():
    image, dark, flat = flats.uneven_pictures(np.random.default_rng(0))
    assert image.shape == dark.shape == flat.shape == (320, 480)
    assert flat[:10, :10].mean() < 0.8 * flat[150:170, 230:250].mean()
    assert dark.max() > dark.mean() + 20
