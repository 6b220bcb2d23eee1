"""The figures of chapter 10: each draws, says what it shows, and shows the right thing."""

from functools import cache

import matplotlib as mpl
import numpy as np
import pytest
from legible import Legible
from real_data import fetched

mpl.use("Agg")  # as a test has no screen

from course_lib.bundle import Observations, squared_error
from course_lib.bundle.derivatives import Position
from course_lib.bundle.gauge import gauge_directions
from course_lib.drawing import bundle as draw
from course_lib.drawing.bundle import growing, matrices, space, stepping
from course_lib.drawing.bundle import pictures as shown
from course_lib.drawing.style import ROLES
from course_lib.orientation import resect_camera
from course_lib.reconstruction import reconstruct
from course_lib.similarity import similarity_transform
from data_generators.block_pictures import turntable_pictures

# What the model of the photographs needs to be drawn, from points that were measured in them.
KNOWN = turntable_pictures(np.random.default_rng(1), 8)
FIGURES = {
    "acquisition": draw.acquisition,
    "adjustment_steps": lambda: draw.adjustment_steps([2.25, 0.68, 0.61, 0.6]),
    "adjustment_steps none": lambda: draw.adjustment_steps([2.25]),
    "adjustment_steps worse": lambda: draw.adjustment_steps([2.25, 3e5, np.inf, 2]),
    "adjustment_steps no block": lambda: draw.adjustment_steps([2.25, np.nan]),
    "chains_from_above": draw.chains_from_above,
    "control_flatters": draw.control_flatters,
    "domes": draw.domes,
    "followed_points": lambda: draw.followed_points(KNOWN, followed()),
    "reconstructed": lambda: draw.reconstructed(KNOWN, model()),
    "sparsity": draw.sparsity,
    "strasbourg_plan": lambda: draw.strasbourg_plan(strasbourg()),
    "timeline": draw.timeline,
    "two_gauges": draw.two_gauges,
    "vase_block": draw.vase_block,
}
NO_FIGURES = {"chain", "grown", "small_block", "vase", "whole_jacobian", "arrow", "block_rms"}
NO_FIGURES |= {"half_chain", "neighbours", "photographs", "pixel", "pose_rms", "small_equations"}
NO_FIGURES |= {"strasbourg", "textbook_resection", "third_picture"}


def followed():
    """Return points of the vase's surface where the pictures show them."""
    u, v = np.meshgrid(np.linspace(180, 460, 29), np.linspace(90, 420, 34))
    X = KNOWN.surface(0, np.column_stack([u.ravel(), v.ravel()]))
    X = X[np.isfinite(X[:, 0])]
    pixels = [camera.project(X) for camera in KNOWN.cameras[:3]]
    cameras, points = np.repeat(np.arange(3), len(X)), np.tile(np.arange(len(X)), 3)
    return Observations(cameras, points, np.concatenate(pixels))


@cache
def model():
    """Return what is made of three pictures."""
    return reconstruct(followed(), KNOWN.K, np.random.default_rng(0))


def strasbourg():
    """Return the block of Strasbourg; skip where it is not to be had."""
    fetched("aerial_block/ref/ctrlpts-fixed.txt")
    return draw.strasbourg()


@pytest.fixture(scope="module", params=FIGURES)
def figure(request):
    drawn = FIGURES[request.param]()
    drawn.draw_without_rendering()
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
        assert "(deviations × 5)" in ax.get_title(loc="left")


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


def test_where_cameras_and_points_meet_has_a_colour_of_its_own():
    c = 36
    N = np.asarray(draw.sparsity().axes[1].images[0].get_array())
    kinds = [set(np.unique(part)) for part in (N[:c, :c], N[c:, c:], N[:c, c:], N[c:, :c])]
    assert kinds == [{0, 1}, {0, 2}, {0, 3}, {0, 3}]


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


# Exercises and pictures


def test_the_third_picture_sees_what_the_first_two_gave():
    points, pixels, K = draw.third_picture()
    true = growing.vase().truth
    assert len(points) == growing.grown("only chained")[1].seen
    found = resect_camera(points, pixels, K)
    rms = np.sqrt((found.residuals**2).sum(axis=1).mean())
    assert draw.pose_rms(points, pixels, K, found.R, found.t) == pytest.approx(rms)
    np.testing.assert_allclose(
        draw.pixel(true.points[3], K, true.R[2], true.t[2]), true.project([2], [3])[0]
    )


def test_the_arrow_is_the_damped_normal_matrix():
    J = matrices.whole_jacobian(*matrices.small_block())
    N = J.T @ J
    N += stepping.DAMPING * np.diag(np.diag(N))
    found = draw.arrow(*draw.small_equations()[:3])
    np.testing.assert_allclose(found, N, atol=1e-9 * np.abs(N).max())


def test_half_of_the_chain_is_its_first_twelve_cameras():
    start, stage = draw.half_chain(), growing.grown("only chained")[10]
    assert draw.block_rms(*start) == pytest.approx(stage.after)
    error = squared_error(*start)
    count = np.isfinite(start.pixels[..., 0]).sum()
    assert draw.block_rms(*start) == pytest.approx(np.sqrt(error / count))
    assert (np.isfinite(start.pixels[..., 0]).sum(axis=0) >= 2).all()


@pytest.mark.parametrize("nonsense", [None, "left", np.zeros((3, 3)), [1, 2], np.nan])
def test_what_is_no_block_has_no_error(nonsense):
    K, _, t, points, pixels = draw.half_chain()
    assert np.isnan(draw.block_rms(K, nonsense, t, points, pixels))


def test_steps_end_where_there_is_no_number():
    ax = draw.adjustment_steps([2.25, 0.7, np.nan, 0.5]).axes[0]
    (line,) = lines(ax, "camera")
    np.testing.assert_allclose(line[:, 1], [2.25, 0.7])
    words = [text.get_text() for text in draw.adjustment_steps([2.25]).axes[0].texts]
    assert "no answer yet" in words


def test_each_picture_is_compared_with_the_next_two():
    pairs = draw.neighbours()
    assert len(set(pairs)) == 48
    assert all((j - i) % 24 in (1, 2, 22, 23) and i < j for i, j in pairs)


def test_followed_points_keep_their_colours():
    axes = draw.followed_points(KNOWN, followed()).axes
    colours = [ax.collections[0].get_facecolors() for ax in axes]
    np.testing.assert_array_equal(colours[0], colours[1])
    places = [np.asarray(ax.collections[0].get_offsets()) for ax in axes]
    moved = KNOWN.transferred(0, places[0], 1)
    np.testing.assert_allclose(moved, places[1], atol=1e-6)


def test_the_model_is_upright_and_has_the_colours_of_the_pictures():
    found = model()
    marks = similarity_transform(found.block.centres, KNOWN.centres[found.cameras])
    up = marks.R @ shown.upright(found)[2]
    assert up[2] > 0.85  # the cameras look down a little
    number = 100
    seen = found.observations.only(found.observations.points == number)
    u, v = np.rint(seen.pixels[0]).astype(int)
    picture = KNOWN.pictures[found.cameras[seen.cameras[0]]]
    np.testing.assert_array_equal(shown.point_colours(KNOWN, found)[number], picture[v, u])


def test_strasbourg_is_as_published():
    city = strasbourg()
    assert city.fit.sigma0 == pytest.approx(city.published, abs=5.1e-5)
    assert city.apart < 0.002


def test_the_textbook_resection_is_as_published():
    fetched("resection_tables/wuhan_resection.txt")
    centre = draw.textbook_resection().centre
    np.testing.assert_allclose(centre, [39795.45, 27476.46, 7572.69], atol=0.006)
