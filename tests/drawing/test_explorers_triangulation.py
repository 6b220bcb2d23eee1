"""The explorers of chapter 09 compute what they show."""

import numpy as np
import pytest

from course_lib import triangulation as tri
from course_lib.drawing.explorers import bench, disparity
from course_lib.drawing.triangulation import pair

SEEN_BY_BOTH = [(1, 4, 0, 0), (2, 3, 0.5, 10), (4, 2, 0, 45), (0.2, 5, -1, 0), (3, 4.5, 0.3, 20)]


def value(frame, label):
    (reading,) = (r for r in frame.readouts if r.label == label)
    return float(reading.value)


def by_role(picture, role):
    return [np.asarray(drawn.points) for drawn in picture.lines if drawn.role == role]


def dragged(handle, at):
    """Return what controls a handle sets when it is dragged to a pixel."""
    return {name: a + b * at[0] + c * at[1] for name, a, b, c in handle.moves}


# The bench


@pytest.mark.parametrize("state", SEEN_BY_BOTH)
@pytest.mark.parametrize("third", [False, True])
def test_answers_scatter_as_the_covariance_says(state, third):
    b, Z, X, turn = state
    cameras = [c for c in bench.stand(b, turn, third) if bench.sees(c, np.array([X, Z, 0.0]))]
    P = np.stack([camera.P for camera in cameras])
    point = np.array([X, Z, 0.0])
    off = bench.answers(point, P, 0.2) - point
    sigma = np.sqrt(np.diag(tri.point_covariance(point, P, 0.2)))
    np.testing.assert_allclose(np.sqrt((off**2).mean(axis=0)), sigma, rtol=0.2)  # 200 answers
    frame = bench.bench_frame(b, Z, X, turn, 0.2, third)
    said = [value(frame, name) for name in ("Sideways", "In depth", "Height")]
    np.testing.assert_allclose(said, 1000 * sigma, atol=0.0051)
    assert value(frame, "Answers in the 2σ ellipse") == pytest.approx(86.5, abs=6)


def test_turned_cameras_look_inwards_and_the_third_straight_ahead():
    left, right, middle = bench.stand(2, 30, third=True)
    np.testing.assert_allclose(left.centre, [-1, 0, 0], atol=1e-12)
    np.testing.assert_allclose(right.centre, [1, 0, 0], atol=1e-12)
    np.testing.assert_allclose(left.R[2], [0.5, np.sqrt(0.75), 0], atol=1e-12)
    np.testing.assert_allclose(right.R[2], [-0.5, np.sqrt(0.75), 0], atol=1e-12)
    np.testing.assert_allclose(middle.R[2], [0, 1, 0], atol=1e-12)


def test_the_rule_is_exact_for_a_point_before_the_middle_of_parallel_cameras():
    for b, Z, sigma in ((1, 4, 0.5), (0.5, 2, 0.1), (2, 5, 1)):
        frame = bench.bench_frame(b, Z, 0, 0, sigma, False)
        assert value(frame, "In depth") == pytest.approx(value(frame, "Z² √2 σ / (f b)"), abs=0.011)
        angle = 2 * np.degrees(np.arctan(b / 2 / Z))
        assert value(frame, "Angle between the outer rays") == pytest.approx(angle, abs=0.051)
        one_ray = value(frame, "One ray is off by")
        assert value(frame, "Sideways") == pytest.approx(one_ray / np.sqrt(2), abs=0.011)


@pytest.mark.parametrize(
    ("state", "words"),
    [((4, 4, 0, 0), "No camera sees the point"), ((1, 4, 2, 0), "Only 1 camera sees the point")],
)
def test_it_says_why_there_is_no_answer(state, words):
    frame = bench.bench_frame(*state, 0.5, False)
    assert frame.pictures[1].alt.startswith(words)
    assert not by_role(frame.pictures[1], "object")
    assert next(label.text for label in frame.pictures[1].labels) == f"{words}:"
    shown = len(by_role(frame.pictures[0], "ray"))
    assert shown == int(words.startswith("Only 1"))


@pytest.mark.parametrize("number", [0, 1])
def test_a_dragged_spot_goes_where_the_pointer_is(number):
    state = {"b": 1.4, "Z": 3.0, "X": 0.4, "turn_deg": 0, "sigma": 0.5, "third": False}
    handle = bench.bench_frame(**state).pictures[0].handles[number]
    target = np.add(handle.at, (30, -20))
    moved = state | dragged(handle, target)
    after = bench.bench_frame(**moved).pictures[0].handles[number]
    expected = target if number == 0 else [target[0], handle.at[1]]  # a camera stays in its row
    np.testing.assert_allclose(after.at, expected, atol=1e-6)


def test_the_enlarged_ellipse_is_that_of_the_numbers():
    frame = bench.bench_frame(1, 4, 0, 0, 0.5, False)
    near = frame.pictures[1]
    (ellipse,) = by_role(near, "camera")
    *_, top, bottom = bench.NEAR_BOX
    reach = max(float(label.text) for label in near.labels if label.text.lstrip("-").isdigit())
    scale = 2 * reach / (bottom - top)  # mm a px, the same along both axes
    tall, wide = np.ptp(ellipse[:, 1]) * scale, np.ptp(ellipse[:, 0]) * scale
    assert tall == pytest.approx(4 * value(frame, "In depth"), rel=0.01)
    assert wide == pytest.approx(4 * value(frame, "Sideways"), rel=0.01)


def test_every_answer_is_drawn_or_outside():
    (marks,) = by_role(bench.bench_frame(1, 4, 0, 0, 0.5, False).pictures[1], "object")
    assert bench.TRIALS - 3 <= len(marks) / 6 <= bench.TRIALS


# The disparity of a real pair


def plain_search(u, v, reach):
    """Return the differences of windows along a row, window by window."""
    left, right = pair.motorcycle().left.astype(float), pair.motorcycle().right.astype(float)
    rows = slice(v - reach, v + reach + 1)
    window = left[rows, u - reach : u + reach + 1]
    found = []
    for d in range(min(disparity.FARTHEST, u - reach) + 1):
        other = right[rows, u - d - reach : u - d + reach + 1]
        found.append(np.sqrt(((window - other) ** 2).mean()))
    return np.array(found)


@pytest.mark.parametrize(("u", "v", "reach"), [(97, 208, 4), (13, 13, 12), (727, 486, 1)])
def test_the_search_compares_every_window_of_the_row(u, v, reach):
    found = disparity.search(u, v, reach)
    expected = plain_search(u, v, reach)
    np.testing.assert_allclose(found.differences, expected, rtol=1e-4)
    assert found.best == np.argmin(expected)
    assert abs(found.disparity - found.best) <= 0.5 + 1e-9


def test_a_parabola_is_read_between_the_pixels():
    d = np.arange(10)
    for lowest in (3.0, 4.3, 5.75):
        means = 2 * (d - lowest) ** 2 + 7
        best = int(np.argmin(means))
        assert best + disparity._between(means, best) == pytest.approx(lowest)
    assert disparity._between(np.array([1.0, 2, 3]), 0) == 0
    assert disparity._between(np.ones(3), 1) == 0


def test_sharp_places_have_the_true_disparity():
    truth = pair.motorcycle().truth
    for u, v in ((97, 208), (573, 380), (275, 110), (368, 331), (250, 460)):
        assert disparity.search(u, v, 4).disparity == pytest.approx(truth[v, u], abs=0.4), (u, v)


def test_good_matches_are_off_by_as_much_as_the_explorer_says():
    rng, truth = np.random.default_rng(0), pair.motorcycle().truth
    off = []
    while len(off) < 250:
        u, v = rng.integers((90, 12), (729, 488))
        near = truth[v - 10 : v + 11, u - 10 : u + 11]
        if np.isfinite(near).all() and np.ptp(near) <= 3:
            off.append(disparity.search(u, v, 4).disparity - truth[v, u])
    good = np.abs(off) < 1.5
    assert good.mean() > 0.75
    assert np.sqrt(np.mean(np.square(off)[good])) == pytest.approx(disparity.SIGMA, abs=0.06)


def test_the_frame_says_what_it_draws():
    frame = disparity.disparity_frame(275, 110, 4)
    _, right, curve, windows = frame.pictures
    (box,) = by_role(right, "camera")
    scale = disparity.SCALE
    middle = (box.mean(axis=0) + 0.5) / scale - 0.5
    np.testing.assert_allclose(middle, [275 - value(frame, "Disparity"), 110], atol=0.06)
    np.testing.assert_allclose(np.ptp(box, axis=0), 9 * scale)
    (spot,) = by_role(curve, "camera")
    axes = disparity.curve_axes(disparity.search(275, 110, 4))
    at = axes.at(value(frame, "Disparity"), 0)[0]
    assert spot[:, 0].mean() == pytest.approx(at, abs=0.4)
    depth, sigma = next(r.value for r in frame.readouts if r.label == "Depth").split(" ± ")
    expected = tri.depth_from_disparity(
        disparity.search(275, 110, 4).disparity, pair.F, pair.BASELINE, pair.OFFSET
    )
    assert float(depth) == pytest.approx(expected, abs=0.51)
    assert float(sigma) == pytest.approx(
        tri.depth_uncertainty(expected, pair.F, pair.BASELINE, disparity.SIGMA), abs=0.51
    )
    tile = windows.image[disparity.TOP :, disparity.TILES[0] :]
    assert tuple(tile[disparity.TILE // 2, disparity.TILE // 2]) == tuple(
        pair.motorcycle().left[110, 275]
    )


def test_where_nobody_knows_the_truth_it_says_so():
    v, u = np.argwhere(np.isnan(pair.motorcycle().truth[20:480, 20:700]))[0] + 20
    frame = disparity.disparity_frame(u, v, 3)
    assert [r.value for r in frame.readouts if r.label in ("True disparity", "Off by")] == [
        "not known",
        "not known",
    ]
    assert not by_role(frame.pictures[1], "image")


def test_other_places_that_fit_are_named():
    flat = disparity.Match(np.array([9.0, 5, 9, 9, 9, 5.2, 9, 9, 4.9, 9]), 8.0, 8)
    assert disparity._elsewhere(flat) == "1, 5 px"
    assert disparity._elsewhere(flat._replace(differences=np.array([9.0, 9, 9, 4, 9]), best=3)) == (
        "nowhere"
    )


def test_a_dragged_window_goes_where_the_pointer_is():
    (handle,) = disparity.disparity_frame(300, 200, 4).pictures[0].handles
    target = np.add(handle.at, (40, -25))
    moved = dragged(handle, target)
    after = disparity.disparity_frame(round(moved["u"]), round(moved["v"]), 4).pictures[0]
    np.testing.assert_allclose(after.handles[0].at, target, atol=disparity.SCALE)


@pytest.mark.parametrize(("u", "v", "reach"), [(97, 208, 4), (260, 70, 4), (260, 70, 1)])
def test_the_curve_fills_its_axes_and_is_never_cut(u, v, reach):
    found = disparity.search(u, v, reach)
    frame = disparity.disparity_frame(u, v, reach)
    (curve,) = by_role(frame.pictures[2], "ink")
    assert np.isfinite(curve).all()
    *_, top, bottom = disparity.CURVE_BOX
    assert (bottom - curve[:, 1].min()) / (bottom - top) > 0.45
    ticks = [float(x.text) for x in frame.pictures[2].labels if x.text.replace(".", "").isdigit()]
    assert max(ticks[8:]) >= found.differences.max()


@pytest.mark.parametrize("place", disparity.PLACES)
def test_a_place_is_gone_to_by_name_and_the_sliders_follow(place):
    u, v = disparity.PLACES[place]
    named, set_by_hand = (
        disparity.disparity_frame(*at, 4, p)
        for at, p in (((300, 300), place), ((u, v), "anywhere"))
    )
    assert named.readouts == set_by_hand.readouts
    assert named.follows == {"u": u, "v": v}
    assert not set_by_hand.follows
    assert not named.pictures[0].handles
    assert len(set_by_hand.pictures[0].handles) == 1
