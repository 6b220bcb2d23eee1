import numpy as np
import pytest

from course_lib import data, distortion
from course_lib.drawing.distortion import boards, pictures
from course_lib.drawing.explorers import distortion as bending
from course_lib.drawing.explorers import undistort
from course_lib.widgets import distortion as widgets
from data_generators import rails


def bent(**coefficients):
    return bending.distortion_frame(**dict.fromkeys(bending.NAMES, 0.0) | coefficients)


def lens(**coefficients):
    return [coefficients.get(name, 0.0) for name in bending.NAMES]


def value(frame, label):
    (reading,) = (r for r in frame.readouts if r.label == label)
    return float(reading.value.replace("∞", "inf").replace("–", "nan"))


def texts(picture):
    return [label.text for label in picture.labels]


# Distortion

LENSES = [
    {"k1": -0.3, "k2": 0.1},
    {"k1": 0.2, "k3": 0.1},
    {"p1": 0.03, "p2": -0.02},
    {"k1": -0.1, "k4": 0.1, "k6": 0.05, "s1": 0.03, "s4": -0.02},
]


@pytest.mark.parametrize("coefficients", LENSES)
def test_readouts_are_those_of_the_lens(coefficients):
    frame, k = bent(**coefficients), lens(**coefficients)
    corners = distortion.pixel_grid(pictures.SIZE, 2, 2).reshape(-1, 2)
    moved = np.hypot(*distortion.displacement_field(corners, pictures.K, k).T).max()
    assert value(frame, "Corner moves by") == pytest.approx(moved, abs=0.051)
    limit = distortion.valid_radius(k)
    assert value(frame, "Valid radius") == pytest.approx(limit, abs=0.0051)
    tangential = distortion.displacement_field(corners, pictures.K, k, "tangential")
    expected = np.hypot(*tangential.T).max()
    assert value(frame, "of it tangential") == pytest.approx(expected, abs=0.051)


@pytest.mark.parametrize("coefficients", LENSES)
def test_grid_and_picture_are_bent_by_the_same_lens(coefficients):
    picture = bent(**coefficients).pictures[0]
    np.testing.assert_array_equal(picture.image, pictures.house_through(lens(**coefficients)))
    for line in picture.lines:
        drawn = np.asarray(line.points)
        drawn = drawn[np.isfinite(drawn[:, 0])]
        ideal = distortion.undistort_pixels(drawn, pictures.K, lens(**coefficients))
        assert distortion.straightness(ideal) < 1e-6


def test_arrows_point_from_ideal_to_distorted_pixels():
    field = bent(k1=-0.3).pictures[1]
    arrows = next(line for line in field.lines if line.role == "ray")
    shafts = np.asarray(arrows.points).reshape(-1, 6, 2)[:, :2]
    start, way = shafts[:, 0], shafts[:, 1] - shafts[:, 0]
    moved = distortion.displacement_field(start, pictures.K, lens(k1=-0.3))
    long = np.hypot(*way.T)
    scale = long / np.hypot(*moved.T)
    np.testing.assert_allclose(scale, scale[0])
    assert long.max() == pytest.approx(bending.ARROW)
    np.testing.assert_allclose(way, moved * scale[:, None])


def test_iso_lines_have_the_displacement_that_is_written_beside_them():
    field = bent(k1=-0.3).pictures[1]
    levels = [float(text) for text in texts(field)]
    pieces = [np.asarray(line.points) for line in field.lines if line.role == "camera"]
    seen = []
    for piece in pieces:
        moved = np.hypot(*distortion.displacement_field(piece, pictures.K, lens(k1=-0.3)).T)
        assert np.ptp(moved) < 0.06 * moved.mean()
        seen.append(moved.mean())
    for level in levels:
        assert np.abs(np.array(seen) / level - 1).min() < 0.03


@pytest.mark.parametrize("coefficients", [{"k1": -0.22}, {"k1": -0.15, "p2": 0.02}, {"k1": 0.3}])
def test_every_iso_line_has_a_number_and_no_two_collide(coefficients):
    frame = bent(**coefficients)
    labels = frame.pictures[1].labels
    moved = distortion.displacement_field(
        distortion.pixel_grid(pictures.SIZE, 41, 31).reshape(-1, 2),
        pictures.K,
        lens(**coefficients),
    )
    assert len(labels) == len(bending._levels(np.nanmax(np.hypot(*moved.T))))
    for n, label in enumerate(labels):
        for other in labels[:n]:
            across, down = np.abs(np.subtract(label.at, other.at))
            assert across >= 30 or down >= 16


def test_a_missing_coefficient_is_zero():
    assert bending.distortion_frame(k1=-0.2).in_words() == bent(k1=-0.2).in_words()


def test_words_say_which_way_lines_tilt():
    words = bent(p2=0.02).pictures[0].alt
    assert "up at its right end by 6 px" in words
    assert "down at its right end by 6 px" in words
    assert "bent" not in words


def test_a_pinhole_has_no_iso_lines_and_short_arrows():
    frame = bent()
    assert not texts(frame.pictures[1])
    assert value(frame, "Corner moves by") == 0
    assert "straight" in frame.pictures[0].alt


def test_fold_is_marked_at_the_top_of_the_profile():
    profile = bent(k1=-0.31).pictures[2]
    curve, dot = np.asarray(profile.lines[3].points), np.asarray(profile.lines[5].points)
    middle = dot.mean(axis=0)
    limit = distortion.valid_radius([-0.31])
    np.testing.assert_allclose(middle, bending.PROFILE.at(limit, limit * 2 / 3), atol=0.5)
    assert np.nanmin(curve[:, 1]) == pytest.approx(middle[1], abs=0.2)
    assert "folds at 1.04" in texts(profile)
    beyond = np.asarray(profile.lines[4].points)
    assert np.nanmin(beyond[:, 0]) >= np.nanmax(curve[:, 0])


def test_no_fold_is_marked_where_there_is_none_or_it_is_out_of_the_plot():
    for coefficients in ({"k1": 0.2}, {"k1": -0.1}, {"k1": -0.31, "k2": 0.12}):
        assert not [t for t in texts(bent(**coefficients).pictures[2]) if "folds" in t]


def test_a_fold_inside_the_picture_is_said():
    frame = bent(k1=-0.5)
    assert "No ray reaches the corners" in frame.pictures[0].alt
    assert np.isnan(value(frame, "Corner moves by"))
    assert (frame.pictures[0].image[0, 0] == 0).all()


@pytest.mark.parametrize(("k1", "seen"), [(-0.2, True), (-0.22, False)])
def test_corners_are_black_when_the_top_of_the_profile_is_lower(k1, seen):
    picture = bent(k1=k1).pictures[0]
    assert bool(picture.image[0, 0].any()) is seen
    assert ("No ray reaches the corners" in picture.alt) is not seen


def test_words_say_which_way_edges_bend():
    barrel, pincushion = (bent(k1=k).pictures[0].alt for k in (-0.2, 0.2))
    assert barrel.count("outwards") == 2
    assert pincushion.count("inwards") == 2


# Undistort


def straightened(name, k1, k2=0.0):
    return undistort.undistort_frame(name, k1, k2)


@pytest.mark.parametrize("name", undistort.BOARDS)
def test_without_coefficients_the_photograph_is_shown_as_it_is(name):
    frame = straightened(name, 0.0)
    grey, real = boards.board_photograph(undistort.BOARDS[name])
    np.testing.assert_array_equal(frame.pictures[0].image[..., 1], grey)
    assert ("computed" in frame.pictures[0].alt) is not real
    lines = boards.board_lines(grey)
    rms = np.sqrt(np.mean([distortion.straightness(line) ** 2 for line in lines]))
    for label in ("From straight, all lines, RMS", "in the photograph"):
        assert value(frame, label) == pytest.approx(rms, abs=0.00051)


@pytest.mark.parametrize("name", undistort.BOARDS)
def test_the_lens_of_the_chapter_straightens_every_photograph(name):
    frame = straightened(name, *rails.LENS[:2])
    assert value(frame, "From straight, all lines, RMS") < 0.12
    assert value(frame, "in the photograph") > 0.7


def test_corners_and_picture_move_together():
    grey, _ = boards.board_photograph()
    name = next(iter(undistort.BOARDS))
    frame = straightened(name, -0.31, 0.12)
    shown = np.ascontiguousarray(frame.pictures[0].image[..., 0])
    line = np.asarray(frame.pictures[0].lines[1].points)
    found = boards.board_lines(shown)[boards.most_bent(boards.board_lines(grey))]
    inside = (line[:, 0] < 630) & (line[:, 1] < 470)
    off = np.linalg.norm(found[:, None] - line[inside], axis=2).min(axis=0)
    assert np.median(off) < 0.3


def test_the_plot_shows_the_distances_of_the_line():
    name = next(iter(undistort.BOARDS))
    _, plot = straightened(name, -0.2).pictures
    before, after = (np.asarray(line.points) for line in plot.lines[2:])
    left, right, *_ = undistort.AWAY.box
    scale = (right - left) / np.ptp(undistort.AWAY.x)
    middle = undistort.AWAY.at(0, 0)[0]
    lines = boards.board_lines(boards.board_photograph(undistort.BOARDS[name])[0])
    line = lines[boards.most_bent(lines)]
    for drawn, points in (
        (before, line),
        (after, distortion.undistort_pixels(line, rails.K, [-0.2])),
    ):
        shown = np.abs(drawn[:, 0] - middle).max() / scale
        assert shown == pytest.approx(chord(points), abs=0.01)


def test_a_line_that_lies_far_off_is_drawn_to_its_end():
    name = next(iter(undistort.BOARDS))
    _, plot = straightened(name, -0.5).pictures
    drawn = np.asarray(plot.lines[3].points)
    grey, _ = boards.board_photograph(undistort.BOARDS[name])
    lines = boards.board_lines(grey)
    line = distortion.undistort_pixels(lines[boards.most_bent(lines)], rails.K, [-0.5])
    left, right, *_ = undistort.FAR_AWAY.box
    scale = (right - left) / np.ptp(undistort.FAR_AWAY.x)
    assert np.abs(drawn[:, 0] - (left + right) / 2).max() / scale == pytest.approx(chord(line))
    assert chord(line) > 15
    assert "20" in texts(plot)


def test_twelve_sliders_only_when_asked_for():
    assert list(widgets.distortion_explorer().state) == ["k1", "k2", "k3", "p1", "p2"]
    assert set(widgets.distortion_explorer(twelve=True).state) == set(bending.NAMES)


def test_still_names_the_coefficients_that_are_not_zero():
    explorer = widgets.distortion_explorer(twelve=True)
    assert "All sliders at zero" in explorer._repr_mimebundle_()[0]["text/plain"]
    explorer.set(k1=-0.3, s4=0.02)
    words = explorer._repr_mimebundle_()[0]["text/plain"]
    assert "Radial: k₁ = -0.30; Prism: s₄ = 0.020\n" in words


def chord(points):
    """Return the largest distance from the line through the first and the last point."""
    along = (points[-1] - points[0]) / np.linalg.norm(points[-1] - points[0])
    away = points - points[0]
    return np.abs(away[:, 0] * along[1] - away[:, 1] * along[0]).max()


def test_a_lens_that_does_not_reach_the_board_is_said():
    frame = straightened("large board", -0.6, -0.4)
    assert np.isnan(value(frame, "From straight, all lines, RMS"))
    assert "out of reach" in frame.in_words()


def test_without_a_network_a_computed_board_is_straightened(monkeypatch):
    def gone(name):
        raise data.Unavailable("not here")

    monkeypatch.setattr(data, "fetch", gone)
    caches = (boards.board_photograph, undistort._board)
    for cache in caches:
        cache.cache_clear()
    try:
        frame = straightened(next(iter(undistort.BOARDS)), -0.31, 0.12)
    finally:
        for cache in caches:
            cache.cache_clear()
    assert "computed" in frame.pictures[0].alt
    assert "no network" in frame.pictures[0].title
    assert value(frame, "From straight, all lines, RMS") < 0.12
