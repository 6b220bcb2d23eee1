"""The figures of chapter 08: each draws, says what it shows, and shows the right thing."""

import matplotlib as mpl
import numpy as np
import pytest
from legible import Legible
from real_data import fetched

mpl.use("Agg")  # as a test has no screen

from course_lib import data
from course_lib import epipolar as epi
from course_lib.drawing import epipolar as draw
from course_lib.drawing.epipolar import geometry, gruber, photographs, street
from course_lib.drawing.explorers import pairs
from course_lib.drawing.style import ROLES
from course_lib.orientation.relative import pose_from_relative
from course_lib.transforms import rotation_y

LEFT, RIGHT = draw.street_points()
F = epi.fundamental_from_cameras(*draw.street_cameras())
LINES = epi.epipolar_lines(LEFT, F)
BOARDS = draw.computed_boards()
CAR = draw.forward_fundamental()
GREY = np.full((360, 480, 3), 128, np.uint8)
FIGURES = {
    "candidates": draw.candidates,
    "corner_lines": lambda: draw.corner_lines(BOARDS),
    "epipolar_plane": draw.epipolar_plane,
    "forward": lambda: draw.forward(epi.epipole(CAR)),
    "forward none": lambda: draw.forward(None),
    "four_poses": draw.four_poses,
    "lines_of_points": lambda: draw.lines_of_points(LINES),
    "lines_of_points none": lambda: draw.lines_of_points(None),
    "rank": lambda: draw.rank(CAR, epi.eight_point(*draw.eight_pairs())),
    "rows": lambda: draw.rows(BOARDS),
    "strokes": lambda: draw.strokes(GREY, LEFT, RIGHT, [True, False, True, True, False]),
    "two_answers": lambda: draw.two_answers(GREY, LEFT, RIGHT, F, CAR),
    "von_gruber": draw.von_gruber,
}
NO_FIGURES = {"board_fundamental", "computed_boards", "eight_pairs", "forward_fundamental"}
NO_FIGURES |= {"motorcycle", "painted_wall", "pose_errors", "stereo_boards", "street_cameras"}
NO_FIGURES |= {"of_rank_three", "street_points", "two_halves", "judged_matrix", "judged_pose"}


@pytest.fixture(scope="module", params=FIGURES)
def figure(request):
    drawn = FIGURES[request.param]()
    drawn.draw_without_rendering()
    return drawn


def lines(ax, role):
    """Return the data of the lines that have the colour of a role."""
    found = [line for line in ax.lines if line.get_color() == ROLES[role]]
    return [np.asarray(line.get_xydata(), dtype=float) for line in found]


def written(ax):
    return [text.get_text() for text in ax.texts]


class TestEachFigure(Legible):
    UNITS = ("px",)


def test_every_function_is_tried_here():
    assert {name.split()[0] for name in FIGURES} | NO_FIGURES == set(draw.__all__)


# Answers of students


@pytest.mark.parametrize("yours", [None, "line", [1, 2, 3], {}, np.zeros((5, 2)), 1j * LINES])
def test_lines_that_are_none_are_not_drawn(yours):
    figure = draw.lines_of_points(yours)
    figure.draw_without_rendering()
    assert "no answer yet" in written(figure.axes[1])
    assert not [
        line for role in ("camera", "ray") for line in lines(figure.axes[1], role) if len(line) == 2
    ]


@pytest.mark.parametrize("bad", [np.nan, np.inf, 0.0])
def test_lines_without_a_place_are_counted(bad):
    figure = draw.lines_of_points(np.where(np.arange(5)[:, None] == 2, bad, LINES))
    figure.draw_without_rendering()
    assert "1 of 5 lines miss the picture" in written(figure.axes[1])


def test_lines_in_the_wrong_picture_are_drawn_where_they_are():
    figure = draw.lines_of_points(epi.epipolar_lines(LEFT, F.T))
    figure.draw_without_rendering()
    (stroke,) = (line for line in lines(figure.axes[1], "camera") if len(line) == 2)
    assert epi.line_distance(RIGHT[0], np.cross(*np.column_stack([stroke, [1, 1]]))) > 5


@pytest.mark.parametrize(
    ("R", "t", "words"),
    [
        (np.eye(3), np.zeros(3), "Your t has no direction"),
        (2 * np.eye(3), (1, 0, 0), "Your R cannot be compared: "),
        (np.full((3, 3), np.nan), (1, 0, 0), "Your R cannot be compared: "),
        (np.diag([1, 1, -1]), (1, 0, 0), "Your R cannot be compared: "),
        (np.eye(3), (np.nan, 0, 0), "Your t has no direction"),
        (BOARDS.calibration.R, BOARDS.calibration.t, "turn off by 0.000°, direction by 0.000°"),
    ],
)
def test_of_any_pose_a_sentence_says_what_it_is(R, t, words):
    assert draw.judged_pose(R, t, BOARDS.calibration).startswith(words)


@pytest.mark.parametrize("bad", [np.zeros((3, 3)), np.full((3, 3), np.nan), np.diag([0, 0, 1.0])])
def test_a_matrix_without_lines_is_said_to_be_one(bad):
    assert draw.judged_matrix(bad, LEFT, RIGHT).startswith("Your F gives no lines: ")
    assert draw.judged_matrix(F, LEFT, RIGHT) == "0.000 px off the lines on average"


@pytest.mark.parametrize(
    ("yours", "words"),
    [
        (None, "no epipole yet"),
        ([1.0, 2, 3], "no epipole yet"),
        ([np.nan, 1], "no epipole yet"),
        ([2000.0, -30], "your epipole is outside: (2000, -30) px"),
        ([240.0, 180], "epipole"),
    ],
)
def test_whatever_the_epipole_a_sentence_says_where_it_is(yours, words):
    figure = draw.forward(yours)
    figure.draw_without_rendering()
    assert written(figure.axes[0])[-1] == words


# What they show


def test_the_spots_of_the_lamp_are_on_its_line_at_their_depths():
    ax = draw.candidates().axes[1]
    (spots,) = (line for line in lines(ax, "object") if len(line) == 4)
    at, _ = pairs.lamp(pairs.TOWARDS, street.WIDTH)
    assert epi.line_distance(spots, epi.epipolar_lines(at, F)).max() < 1e-6
    one, other = pairs.cameras(pairs.TOWARDS, street.WIDTH)
    ray = one.pixel_ray(at)
    point = one.centre + 16 * ray / (ray @ one.R[2])
    np.testing.assert_allclose(spots[2], other.project(point), atol=1e-6)
    assert written(ax)[2] == "16 m"


def test_strokes_are_the_lines_within_the_picture():
    size = (480, 360)
    for line in (*LINES, (1.0, 0, -100), (0, 1.0, -30)):
        ends = street.stroke_of(np.asarray(line), size)
        assert epi.line_distance(ends, line).max() < 1e-9
        assert ((ends >= -0.6) & (ends <= np.array(size))).all()
        assert np.linalg.norm(ends[1] - ends[0]) > 100
    for line in ((0, 1.0, 50), (0, 0, 1.0), (np.nan, 1, 1), (0, 0, 0)):
        assert street.stroke_of(np.array(line, dtype=float), size) is None


def test_the_epipolar_plane_holds_what_it_names():
    one, other = geometry.sketched_cameras()
    for camera, partner in ((one, other), (other, one)):
        x = geometry._on_plane(camera, geometry.POINT)
        e = geometry._on_plane(camera, partner.centre)
        normal = np.cross(other.centre - one.centre, geometry.POINT - one.centre)
        for place in (x, e):
            assert (place - one.centre) @ normal == pytest.approx(0, abs=1e-9)
            assert camera.R[2] @ (place - camera.centre) == pytest.approx(geometry.NEAR)


def test_only_one_of_the_four_poses_is_the_true_one():
    figure = draw.four_poses()
    titles = [ax.get_title(loc="left") for ax in figure.axes]
    assert sorted(titles) == ["behind both", "behind one", "behind one", "in front of both"]
    (R, t) = epi.poses_from_essential(epi.essential_from_pose(geometry.TURN, geometry.SHIFT))[
        titles.index("in front of both")
    ]
    np.testing.assert_allclose(R, geometry.TURN, atol=1e-9)
    np.testing.assert_allclose(t, geometry.SHIFT / np.linalg.norm(geometry.SHIFT), atol=1e-9)


def test_lines_of_rank_two_meet_and_of_rank_three_do_not():
    points1, points2 = draw.eight_pairs()
    mended = epi.eight_point(points1, points2)
    U, s, Vt = np.linalg.svd(mended)
    raw = U @ np.diag([s[0], s[1], 1e-7 * s[0]]) @ Vt
    spread = []
    for ax in draw.rank(raw, mended).axes:
        drawn = lines(ax, "ray")
        at = [np.cross(*np.column_stack([a, [1, 1]])) for a in drawn]
        met = [np.cross(at[0], line) for line in at[1:]]
        places = np.array([p[:2] / p[2] for p in met])
        spread.append(places.std(axis=0).max())
    assert spread[1] < 1e-6 < 1e-3 < spread[0]


def test_rows_agree_only_after_rectification():
    taken, rectified = (ax.get_title(loc="left") for ax in draw.rows(BOARDS).axes)
    off = [float(text.split(" by ")[1].removesuffix(" px")) for text in (taken, rectified)]
    assert off[0] > 3
    assert off[1] < 0.1


def test_without_distortion_corners_are_on_their_lines():
    taken, straight = (ax.get_title(loc="left") for ax in draw.corner_lines(BOARDS).axes)
    assert float(taken.split()[-3]) > 0.3
    assert float(straight.split()[-3]) < 0.05


def test_the_parallaxes_are_what_a_wrong_number_does_to_rays():
    rows = gruber.parallaxes()
    ground = np.column_stack([gruber.POSITIONS, np.full(6, -gruber.HEIGHT)]) * [1, -1, -1]
    for k, numbers in enumerate(1e-4 * np.eye(5)):
        R, t = pose_from_relative([1, *numbers[:2]], numbers[2:])
        seen = ground @ R.T + t
        level = ground + pose_from_relative([1, 0, 0], [0, 0, 0])[1]
        moved = -seen[:, 1] / seen[:, 2] + level[:, 1] / level[:, 2]
        np.testing.assert_allclose(moved / 1e-4, rows[k], atol=1e-3)
    assert np.linalg.matrix_rank(rows) == 5  # so six positions are enough


# What they are drawn from


def test_the_computed_pairs_are_those_of_their_cameras():
    found = BOARDS.calibration
    assert len(BOARDS.left) == 13
    np.testing.assert_allclose(found.t, (-100, 1, 0), atol=0.2)
    for K in (found.K_left, found.K_right):
        np.testing.assert_allclose(K, photographs.K, atol=0.6)
    left, right = BOARDS.straight_corners()
    off = epi.line_distance(right, epi.epipolar_lines(left, draw.board_fundamental(BOARDS)))
    assert off.max() < 0.2


def test_errors_of_a_pose_are_its_angles():
    c = BOARDS.calibration
    turn, direction = draw.pose_errors(rotation_y(np.radians(2)) @ c.R, 5 * c.t, c)
    assert (turn, direction) == (pytest.approx(2), pytest.approx(0, abs=1e-5))
    assert draw.pose_errors(c.R, -c.t, c)[1] == pytest.approx(180)


def test_the_wall_is_where_its_published_homography_says():
    fetched("opencv_stereo/H1to3p.xml")
    H = photographs.wall_homography()
    assert H[0, 0] == 0.76285898
    assert H[2].tolist() == [3.4663091e-04, -1.4364524e-05, 1.0]


def test_what_cannot_be_had_is_said(monkeypatch, tmp_path):
    def missing(name):
        raise data.Unavailable(name)

    monkeypatch.setattr(data, "fetch", missing)
    photographs.painted_wall.cache_clear()
    with pytest.raises(data.Unavailable):
        draw.painted_wall()
