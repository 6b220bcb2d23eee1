"""The flights of chapter 10: what a wrong lens does to a block, and what control points show."""

import matplotlib as mpl
import numpy as np
import pytest

mpl.use("Agg")  # as a test has no screen

from course_lib.bundle import bundle_adjust
from course_lib.drawing import bundle as draw
from course_lib.drawing.bundle import flights


def test_a_wrong_lens_bends_the_block_and_the_rms_does_not_show_it():
    right, wrong = flights.flown(0, 0, False, 0.0), flights.flown(0, 0)
    assert wrong.rms < 1.002 * right.rms
    assert wrong.check_rms > 3 * right.check_rms
    middle = wrong.known.truth.points.mean(axis=0)
    away = np.linalg.norm((wrong.known.truth.points - middle)[:, :2], axis=1)
    assert np.corrcoef(away**2, wrong.errors[:, 2])[0, 1] < -0.8  # a dome


def test_oblique_pictures_find_the_lens():
    known = flights.flown(8, 0, True)
    assert known.k1 == pytest.approx(-flights.WRONG_K1, abs=3e-4)
    assert known.check_rms < 0.03
    (_, sigma), (_, without) = flights.k1_told_by(8), flights.k1_told_by(0)
    assert without > 7 * sigma


def test_the_correction_of_the_lens_has_come_to_rest():
    known, seen = flights.pictures_with(8, flights.WRONG_K1)
    k1, sigma = flights.k1_told_by(8)
    K = known.truth.K[0]
    costs = [
        bundle_adjust(known.truth, flights.bent_by(seen, K, k1 + step)).cost
        for step in (-sigma, 0, sigma)
    ]
    fit = bundle_adjust(known.truth, flights.bent_by(seen, K, k1))
    assert costs[0] - costs[1] == pytest.approx(fit.sigma0**2, rel=0.05)
    assert costs[2] - costs[1] == pytest.approx(fit.sigma0**2, rel=0.05)


def test_points_of_a_grid_are_spread_over_the_area():
    known = flights.flown(0, 25)
    places = known.known.truth.points[known.control, :2]
    assert len(set(known.control.tolist())) == 25
    apart = np.linalg.norm(places[:, None] - places, axis=2) + 1e3 * np.eye(25)
    assert apart.min() > 8
    assert known.control_rms < 0.02


def test_maps_hold_the_errors_in_millimetres():
    axes = draw.domes().axes[:5]
    for ax, (name, kind) in zip(axes, flights.FLIGHTS.items(), strict=True):
        title = ax.get_title(loc="left")
        assert title.startswith(name)
        assert f"± {1000 * flights.flown(*kind).check_rms:.0f} mm" in title


def test_control_points_flatter():
    rows = flights.flattering()
    numbers, control, check = rows.T
    assert (control < check).all()
    assert (np.diff(control) > 0).all()
    assert (np.diff(check) < 0).all()
    sigma = 0.02 * np.sqrt(3)
    # Seven of 3n numbers went into the similarity.
    np.testing.assert_allclose(control, sigma * np.sqrt(1 - 7 / (3 * numbers)), rtol=0.12)
    assert (check > sigma).all()
