"""The figures of chapter 09: each draws, says what it shows, and shows the right thing."""

import matplotlib as mpl
import numpy as np
import pytest
from legible import Legible

mpl.use("Agg")  # as a test has no screen

from course_lib import triangulation as tri
from course_lib.drawing import triangulation as draw
from course_lib.drawing.style import ROLES
from course_lib.drawing.triangulation import dense, methods, pair, plane, uncertainty
from course_lib.exercises.triangulation import plain

LINE = draw.laser_line()
MET = tri.intersect_ray_plane(LINE.camera.centre, LINE.directions, LINE.plane)
C = tri.point_covariance(uncertainty.POINT, uncertainty.PAIR, uncertainty.NOISE)
CLOSEST = (np.array([0.0, 0, 5]), np.array([0.0, 2, 5]))
FIGURES = {
    "cloud": draw.cloud,
    "cloud yours": lambda: draw.cloud(1.3 * C),
    "dense_errors": draw.dense_errors,
    "dense_result": draw.dense_result,
    "depth_curves": lambda: draw.depth_curves([0.7, 2.8, 6.4, 11.3]),
    "disparity_and_depth": lambda: draw.disparity_and_depth([2523.9, 2325.2]),
    "laser_profile": lambda: draw.laser_profile(MET),
    "laser_profile none": draw.laser_profile,
    "marked_pair": draw.marked_pair,
    "methods_compared": draw.methods_compared,
    "more_cameras": draw.more_cameras,
    "point_cloud": draw.point_cloud,
    "structured_light": draw.structured_light,
    "two_rays": lambda: draw.two_rays(CLOSEST),
    "two_rays far": lambda: draw.two_rays((CLOSEST[0], 100 * CLOSEST[1])),
    "disparity_and_depth far": lambda: draw.disparity_and_depth([2523.9, 1.0]),
    "depth_curves far": lambda: draw.depth_curves([0.7, 2.8, 6.4, 100.0]),
    "cloud far": lambda: draw.cloud(100 * C),
}
NO_FIGURES = {"dense_disparity", "laser_line", "motorcycle"}
WITH_ANSWERS = {
    draw.cloud: (3, 3),
    draw.depth_curves: (4,),
    draw.disparity_and_depth: (2,),
    draw.laser_profile: LINE.directions.shape,
}


@pytest.fixture(scope="module", params=FIGURES)
def figure(request):
    drawn = FIGURES[request.param]()
    drawn.draw_without_rendering()
    return drawn


def marked(ax, marker):
    """Return where markers of a kind are, (N, 2)."""
    found = [line.get_xydata() for line in ax.lines if line.get_marker() == marker]
    return np.vstack(found) if found else np.zeros((0, 2))


def written(ax):
    return [text.get_text() for text in ax.texts]


class TestEachFigure(Legible):
    UNITS = ("px", "mm", "m", "number")


def test_every_function_is_tried_here():
    assert {name.split()[0] for name in FIGURES} | NO_FIGURES == set(draw.__all__)


@pytest.mark.parametrize("show", WITH_ANSWERS, ids=lambda show: show.__name__)
@pytest.mark.parametrize("kind", ["none", "text", "short", "nan", "huge", "negative"])
def test_what_a_student_cannot_have_meant_does_no_harm(show, kind):
    shape = WITH_ANSWERS[show]
    yours = {
        "none": None,
        "text": "left",
        "short": [1.0],
        "nan": np.full(shape, np.nan),
        "huge": np.full(shape, 1e300),
        "negative": np.full(shape, -5.0),
    }[kind]
    drawn = show(yours=yours)
    drawn.draw_without_rendering()
    assert not len(marked(drawn.axes[-1], "*"))
    said = " ".join([*written(drawn.axes[-1]), drawn.axes[-1].get_xlabel()])
    assert ("yours" in said) == (kind in ("nan", "huge", "negative"))


@pytest.mark.parametrize(
    "yours", [None, "two", (), ([1, 2], [3, 4]), (None, None), (np.full(3, np.nan),) * 2, 5]
)
def test_no_stars_where_no_points_are(yours):
    ax = draw.two_rays(yours).axes[0]
    assert not len(marked(ax, "*"))
    assert ("yours: not all inside the figure" in written(ax)) == (yours is not None)


# What they show


def test_stars_of_right_points_lie_on_the_spots():
    ax = draw.two_rays(CLOSEST).axes[0]
    spots, stars = marked(ax, "o"), marked(ax, "*")
    np.testing.assert_allclose(stars, spots)
    away = draw.two_rays((CLOSEST[0] + [0, 0, 1], CLOSEST[1])).axes[0]
    assert np.abs(marked(away, "*") - spots).max() > 10


def test_stars_of_depths_lie_in_the_rings():
    depths = tri.depth_from_disparity([45, 51.5], pair.F, pair.BASELINE, pair.OFFSET)
    ax = draw.disparity_and_depth(depths).axes[1]
    np.testing.assert_allclose(marked(ax, "*"), marked(ax, "o"))


def test_stars_of_uncertainties_lie_on_the_middle_curve():
    Z = np.arange(1, 5) * 1000.0
    ax = draw.depth_curves(plain.depth_uncertainty(Z, 1000, 200, 0.1 * np.sqrt(2))).axes[0]
    (curve,) = [c.get_xydata() for c in ax.lines if c.get_color() == ROLES["camera"]]
    stars = marked(ax, "*")
    assert len(stars) == 4
    np.testing.assert_allclose(stars[:, 1], np.interp(stars[:, 0], *curve.T), atol=0.01)


def test_an_ellipse_has_the_axes_of_its_covariance():
    turned = np.array([[np.cos(0.4), -np.sin(0.4)], [np.sin(0.4), np.cos(0.4)]])
    shape = turned @ np.diag([9.0, 1.0]) @ turned.T
    line = uncertainty.outline(shape, 2)
    away = (line * np.linalg.solve(shape, line.T).T).sum(axis=1)
    np.testing.assert_allclose(away, 4)
    assert np.linalg.norm(line, axis=1).max() == pytest.approx(6, rel=1e-3)
    points = np.random.default_rng(1).multivariate_normal([0, 0], shape, 20_000)
    assert uncertainty.inside(points, shape) == pytest.approx(1 - np.exp(-2), abs=0.01)


def test_the_cloud_shows_its_share_and_a_students_ellipse():
    near = draw.cloud(4 * C).axes[1]
    assert len(marked(near, ".")) == uncertainty.TRIALS
    ours, yours = (line.get_xydata() for line in near.lines if len(line.get_xydata()) == 73)
    np.testing.assert_allclose(yours, 2 * ours, atol=1e-9)
    assert "yours" in near.get_xlabel()
    assert "yours" not in draw.cloud().axes[1].get_xlabel()


def test_the_laser_line_is_measured_where_the_rail_is():
    x, y, z = MET.T
    assert np.abs(y).max() < 1e-9
    sound = np.abs(np.abs(x) - plane.GROOVE) > 0.5
    np.testing.assert_allclose(z[sound], plane.profile(x)[sound], atol=0.7)
    ax = draw.laser_profile(MET).axes[-1]
    np.testing.assert_allclose(marked(ax, "."), MET[:, [0, 2]])
    assert written(ax) == ["yours: 132 µm from the rail (RMS)"]
    assert written(draw.laser_profile().axes[-1]) == ["no answer yet"]
    some = np.where(np.arange(len(MET))[:, None] > 5, MET, np.nan)
    assert written(draw.laser_profile(some).axes[-1]) == ["yours: not all are here"]


def test_patterns_number_the_planes_of_light():
    lights, numbers = plane.lit_by(), np.arange(8)
    np.testing.assert_array_equal(lights[0] * 4 + lights[1] * 2 + lights[2], numbers)
    assert lights[:, plane.PICKED].tolist() == [True, False, True]
    on_box = [False] * 3 + [True] * 4 + [False]
    places = plane.places_of_planes()
    np.testing.assert_allclose(places[:, 1], np.where(on_box, 4.4, 6.0))
    # No plane is met behind the box, and the camera sees where the marked one ends.
    corner = plane.SURFACE[3]
    assert places[7, 0] > corner[0]
    plan, patterns = draw.structured_light().axes
    ends = [line.get_xydata()[-1] for line in plan.lines if len(line.get_xydata()) == 2]
    np.testing.assert_allclose(ends, [*places, places[plane.PICKED]])
    assert [text for text in written(patterns) if text in ("0", "1")][:3] == ["1", "0", "1"]


def test_the_marks_are_where_the_truth_says():
    for left, right in pair.MARKED.values():
        truth = pair.motorcycle().truth[int(left[1]), int(left[0])]
        assert left[0] - right[0] == pytest.approx(truth, abs=0.25)
        assert abs(left[1] - right[1]) <= 0.5


def test_the_camera_matrices_are_those_of_a_rectified_pair():
    X = np.array([100.0, -50, 2500, 1])
    left, right = (P @ X for P in (pair.P_LEFT, pair.P_RIGHT))
    (u1, v1), (u2, v2) = left[:2] / left[2], right[:2] / right[2]
    assert v1 == pytest.approx(v2)
    depth = tri.depth_from_disparity(u1 - u2, pair.F, pair.BASELINE, pair.OFFSET)
    assert depth == pytest.approx(2500)


def test_bars_are_as_high_as_the_errors():
    axes = draw.methods_compared().axes
    side, unequal, _ = methods.SETUPS
    for ax, setup in ((axes[0], side), (axes[1], unequal)):
        heights = [bar.get_height() for bar in ax.patches]
        expected = [methods.rms_mm(X) for X in methods.answers(setup).values()]
        np.testing.assert_allclose(heights, expected)


def test_bars_have_no_more_digits_than_chance_leaves():
    said = [[text.get_text() for text in ax.texts][::2] for ax in draw.methods_compared().axes]
    assert said == [
        ["15"] * 3,
        ["7.0", "7.0", "6.2"],
        ["3.2", "3.2", "0.62"],
        ["240", "250", "240"],
    ]


def test_the_matcher_finds_a_pair_that_we_shift():
    rng = np.random.default_rng(4)
    wide = rng.integers(0, 255, (120, 400, 3), dtype=np.uint8)
    found = dense.match_pair(wide[:, 20:380], wide[:, 32:392])
    assert np.nanmedian(found) == 12
    assert np.isfinite(found[:, 64:]).mean() > 0.9


def test_kinds_of_pixels_do_not_overlap():
    edges, plain_parts, textured = dense.kinds().values()
    assert not (edges & plain_parts).any()
    assert not (edges & textured).any()
    assert not (plain_parts & textured).any()
    known = np.isfinite(pair.motorcycle().truth)
    assert known[edges | plain_parts | textured].all()


def test_a_near_point_hides_a_far_one():
    from course_lib.drawing.space import onlooker

    view = onlooker((0, -10, 0), (0, 0, 0), 100, (40, 30))
    points = np.array([[0.0, 5, 0], [0, -5, 0], [50, 0, 0]])
    red, blue = np.array([200, 0, 0], np.uint8), np.array([0, 0, 200], np.uint8)
    for order in ([0, 1, 2], [1, 0, 2]):
        shown = dense.splat(points[order], np.stack([red, blue, red])[order], view)
        middle = shown[13:17, 18:22].reshape(-1, 3)
        assert {tuple(colour) for colour in middle.tolist()} == {(255, 255, 255), (0, 0, 200)}


def test_the_cloud_of_the_pair_is_projected_back_to_its_pixels():
    points, colours = dense.cloud_points()
    seen = points @ dense.UPRIGHT @ pair.K_LEFT.T
    u, v = np.rint(seen[:, :2] / seen[:, 2:]).astype(int).T
    np.testing.assert_array_equal(pair.motorcycle().left[v, u], colours)


def test_the_corners_of_the_short_way_are_right_in_space():
    ax = draw.two_rays().axes[0]
    corners = [line.get_xydata() for line in ax.lines if len(line.get_xydata()) == 3]
    assert len(corners) == 2
    for corner, spot in zip(corners, marked(ax, "o"), strict=True):
        assert 5 < np.linalg.norm(corner[1] - spot) < 40


def test_no_point_was_found_where_the_floor_is_hidden():
    points, _ = dense.cloud_points()
    hidden = np.array(dense.HIDDEN)
    assert np.linalg.norm(points - hidden, axis=1).min() > 100  # mm
    u, v, w = pair.P_LEFT @ [*(hidden @ dense.UPRIGHT), 1]
    before = dense.depths(pair.motorcycle().truth)[int(v / w), int(u / w)]
    assert before < hidden[1] - 300  # the motorcycle


def test_a_disparity_of_the_figure_reaches_from_two_to_five_metres():
    ax = draw.disparity_and_depth().axes[1]
    depths = ax.lines[0].get_ydata()
    assert depths.min() < 2
    assert depths.max() > 5
