"""The figures of chapter 10: each draws, says what it shows, and shows the right thing."""

import matplotlib as mpl
import numpy as np
import pytest
from legible import Legible

mpl.use("Agg")  # as a test has no screen

from course_lib.bundle import bundle_adjust
from course_lib.bundle.derivatives import Position
from course_lib.bundle.gauge import gauge_directions
from course_lib.drawing import bundle as draw
from course_lib.drawing.bundle import flights, growing, matrices, space
from course_lib.drawing.style import ROLES

FIGURES = {
    "acquisition": draw.acquisition,
    "chains_from_above": draw.chains_from_above,
    "control_flatters": draw.control_flatters,
    "domes": draw.domes,
    "sparsity": draw.sparsity,
    "timeline": draw.timeline,
    "two_gauges": draw.two_gauges,
    "vase_block": draw.vase_block,
}
NO_FIGURES = {"chain", "grown", "small_block", "vase", "whole_jacobian"}


@pytest.fixture(scope="module", params=FIGURES)
def figure(request):
    drawn = FIGURES[request.param]()
    drawn.canvas.draw()
    return drawn


def lines(ax, role):
    """Return the data of the lines that have the colour of a role."""
    found = [line for line in ax.lines if line.get_color() == ROLES[role]]
    return [np.asarray(line.get_xydata()) for line in found]


class TestEachFigure(Legible):
    UNITS = ("px", "mm", "m", "number")


def test_every_function_is_tried_here():
    assert {name.split()[0] for name in FIGURES} | NO_FIGURES == set(draw.__all__)


# What they show


def test_the_chosen_point_has_a_ray_to_each_camera_that_sees_it():
    rays = lines(draw.vase_block().axes[0], "ray")
    counts = np.bincount(growing.vase().observations.points)
    assert len(rays) == counts.max() == 9


def test_a_pyramid_is_what_the_camera_sees():
    known = growing.vase()
    a, b, c, d, *_, o, _ = space.pyramid(known.truth, 3, 0.28, known.image_size)
    block = known.truth.moved_to(np.array([a, b, c, d]))
    corners = block.project([3] * 4, range(4))
    np.testing.assert_allclose(
        corners, [[-0.5, -0.5], [1999.5, -0.5], [1999.5, 1499.5], [-0.5, 1499.5]]
    )
    np.testing.assert_allclose(o, known.truth.centres[3])


def test_the_chains_are_drawn_five_times_too_far():
    for ax, way in zip(draw.chains_from_above().axes, growing.WAYS, strict=True):
        true = growing.true_centres(25)
        apart = growing.grown(way)[-1].block.centres - true
        (shown,) = lines(ax, "camera")
        np.testing.assert_allclose(shown, (true + 5 * apart)[:, :2])


def test_the_matrices_are_zero_where_nobody_sees():
    block, seen = matrices.small_block()
    J = matrices.whole_jacobian(block, seen)
    assert (np.count_nonzero(np.abs(J) > 1e-9, axis=1) <= 9).all()
    cameras, points = gauge_directions(Position.of(block))
    G = np.concatenate([cameras, points.reshape(-1, 7)])
    assert np.abs(J @ G).max() < 1e-8 * np.abs(J).max()
    titles = [ax.get_title(loc="left") for ax in draw.sparsity().axes]
    assert titles[0].endswith(f"{J.shape[0]} × {J.shape[1]}")
    assert titles[2].endswith("36 × 36")


def test_cameras_without_a_common_point_do_not_meet_in_what_is_left():
    _, seen = matrices.small_block()
    image = draw.sparsity().axes[2].images[0].get_array()
    for i in range(6):
        for j in range(6):
            common = np.intersect1d(seen.points[seen.cameras == i], seen.points[seen.cameras == j])
            assert image[6 * i : 6 * i + 6, 6 * j : 6 * j + 6].any() == bool(len(common))


def test_a_gauge_changes_the_sigma_but_not_the_fit():
    fixed, inner = (space.adjusted_vase(gauge) for gauge in ("fixed", "inner"))
    assert fixed.rms == pytest.approx(inner.rms, rel=1e-9)
    assert space.centre_sigma("fixed")[0] == 0
    assert space.centre_sigma("inner").min() > 0.0005
    curves = [
        line for role in ("object", "camera") for line in lines(draw.two_gauges().axes[0], role)
    ]
    np.testing.assert_allclose(curves[0][:, 1], 1000 * space.centre_sigma("fixed"))
    np.testing.assert_allclose(curves[1][:, 1], 1000 * space.centre_sigma("inner"))


# Flights


def test_a_wrong_lens_bends_the_block_and_the_rms_does_not_show_it():
    right, wrong = flights.flown(0, False, False, 0.0), flights.flown(0, False, False)
    assert wrong.rms < 1.002 * right.rms
    assert wrong.check_rms > 3 * right.check_rms
    middle = wrong.known.truth.points.mean(axis=0)
    away = np.linalg.norm((wrong.known.truth.points - middle)[:, :2], axis=1)
    assert np.corrcoef(away**2, wrong.errors[:, 2])[0, 1] < -0.8  # a dome


def test_oblique_pictures_find_the_lens():
    known = flights.flown(8, False, True)
    assert known.k1 == pytest.approx(-flights.WRONG_K1, abs=3e-4)
    assert known.check_rms < 0.03
    sigmas = []
    for oblique in (0, 8):
        block = flights.flown(oblique, False, False).known
        bent = flights.bent_by(block.observations, block.truth.K[0], flights.WRONG_K1)
        sigmas.append(flights.best_k1(block, bent)[1])
    assert sigmas[0] > 7 * sigmas[1]


def test_the_parabola_is_the_cost():
    block = flights.flown(8, False, False).known
    k1, sigma = flights.best_k1(block, block.observations)
    K = block.truth.K[0]
    costs = [
        bundle_adjust(block.truth, flights.bent_by(block.observations, K, k1 + step)).cost
        for step in (-sigma, 0, sigma)
    ]
    scale = bundle_adjust(block.truth, flights.bent_by(block.observations, K, k1)).sigma0 ** 2
    assert costs[0] - costs[1] == pytest.approx(scale, rel=0.05)
    assert costs[2] - costs[1] == pytest.approx(scale, rel=0.05)


def test_maps_hold_the_errors_in_millimetres():
    axes = draw.domes().axes[:3]
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
