"""A rotating propeller, row by row."""

import numpy as np
import pytest

from data_generators.propeller import HUB, Propeller, row_angles


@pytest.fixture(scope="module")
def propeller():
    return Propeller(201, 3)


def blade_angles(share, propeller, radius=0.7):
    """Return the middles of the dark stretches on a circle, rad in [0, 2π)."""
    turn = np.linspace(0, 2 * np.pi, 3600, endpoint=False)
    middle = (propeller.size - 1) / 2
    u = np.rint(middle + radius * propeller.radius * np.cos(turn)).astype(int)
    v = np.rint(middle - radius * propeller.radius * np.sin(turn)).astype(int)
    dark = share[v, u] > 0.5
    starts = np.flatnonzero(dark & ~np.roll(dark, 1))
    ends = np.flatnonzero(dark & ~np.roll(dark, -1))
    return [
        float(turn[(s + (e - s) % 3600 // 2) % 3600]) for s, e in zip(starts, ends, strict=False)
    ]


def test_shapes_and_range(propeller):
    share = propeller.share(0.3)
    assert share.shape == (201, 201)
    assert share.dtype == np.float32
    assert share.min() >= 0
    assert share.max() <= 1 + 1e-4


@pytest.mark.parametrize("angle", [0.4, 1.5])
def test_blades_point_where_they_should(propeller, angle):
    found = np.sort(blade_angles(propeller.share(angle), propeller))
    expected = np.sort((angle + np.arange(3) * 2 * np.pi / 3) % (2 * np.pi))
    np.testing.assert_allclose(found, expected, atol=0.03)


def test_turning_by_a_third_changes_nothing(propeller):
    np.testing.assert_allclose(
        propeller.share(0.2), propeller.share(0.2 + 2 * np.pi / 3), atol=1e-4
    )


@pytest.mark.parametrize("smear", [0.0, 0.5, 3.0])
def test_the_smear_keeps_the_amount_of_light(propeller, smear):
    assert propeller.share(0.3, smear).mean() == pytest.approx(
        propeller.share(0.3).mean(), rel=0.01
    )


def test_the_smear_is_the_mean_over_the_exposure(propeller):
    moments = 0.3 + 0.6 * (np.arange(120) + 0.5 - 60) / 120
    mean = np.mean([propeller.share(angle) for angle in moments], axis=0)
    v, u = np.indices(mean.shape) - 100
    outside = np.hypot(u, v) > 1.3 * HUB * propeller.radius
    assert np.abs(propeller.share(0.3, 0.6) - mean)[outside].max() < 0.06


def test_each_row_shows_its_own_moment(propeller):
    angles = row_angles(201, 20, 0.02)
    rolling = propeller.share(angles)
    for row in (20, 100, 170):
        np.testing.assert_allclose(rolling[row], propeller.share(angles[row])[row], atol=1e-5)


def test_rows_are_read_at_even_times():
    angles = row_angles(101, 10, 0.02, start=1.0)
    assert angles[50] == pytest.approx(1.0)
    assert angles[-1] - angles[0] == pytest.approx(2 * np.pi * 10 * 0.02)
    assert np.ptp(row_angles(101, 10, 0)) == 0


def test_the_hub_hides_the_sky(propeller):
    middle = (propeller.size - 1) / 2
    v, u = np.indices((201, 201)) - middle
    hub = np.hypot(u, v) < HUB * propeller.radius - 1
    np.testing.assert_allclose(propeller.share(0.1)[hub], 1, atol=1e-4)


def test_errors():
    with pytest.raises(ValueError, match=r"size >= 2 and blades >= 1, got 200 and 0"):
        Propeller(200, 0)
    with pytest.raises(ValueError, match=r"angle must have shape \(20,\)"):
        Propeller(20).share(np.zeros(19))
