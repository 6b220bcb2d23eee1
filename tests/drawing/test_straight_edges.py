"""The photographs that chapter 05 straightens: boards and rails, before and after."""

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib.colors import to_hex
from real_data import fetched
from straightening import LENS, bent, coloured, ideal_rails, straightened

mpl.use("Agg")  # as a test has no screen

from course_lib import distortion
from course_lib.drawing import distortion as draw
from course_lib.drawing.distortion import boards
from course_lib.drawing.style import ROLES
from data_generators import rails


def test_straight_edge_goes_through_the_ends_of_the_line():
    picture, maps, (line, ideal) = straightened()
    before, after = draw.before_and_after(picture, maps, (line, ideal)).axes
    for ax, points in ((before, line), (after, ideal)):
        (edge,) = coloured(ax, "ray")
        np.testing.assert_allclose(edge, points[[0, -1]])
    assert after.images[0].get_array().shape == (480, 640)
    assert not np.array_equal(before.images[0].get_array(), after.images[0].get_array())


def test_a_map_that_is_missing_leaves_the_second_picture_empty():
    picture, _, lines = straightened()
    _, after = draw.before_and_after(picture, None, lines).axes
    assert not after.images
    assert [text.get_text() for text in after.texts] == ["your map goes here"]


def test_bars_are_the_straightness_of_each_line():
    lines = boards.board_lines(boards.computed_board())
    _, right = bent().axes
    heights = [bar.get_height() for bar in right.patches]
    np.testing.assert_allclose(heights, [distortion.straightness(line) for line in lines])
    worst = right.patches[boards.most_bent(lines)]
    assert to_hex(worst.get_facecolor()).upper() == ROLES["object"]


def test_computed_board_stands_in_for_the_photograph():
    lines = boards.board_lines(boards.computed_board())
    assert [len(line) for line in lines] == [9] * 6 + [6] * 9
    found = distortion.distortion_from_lines(lines, rails.K)
    assert (np.abs(found.coefficients - LENS) < 4 * found.sigma).all()
    assert found.rms < 0.1


def test_without_a_network_the_computed_board_is_shown(monkeypatch):
    def gone(name):
        raise boards.data.Unavailable("not here")

    monkeypatch.setattr(boards.data, "fetch", gone)
    boards.board_photograph.cache_clear()
    boards.all_lines.cache_clear()
    try:
        picture, real = boards.board_photograph()
        assert not real
        np.testing.assert_array_equal(picture, boards.computed_board())
        assert len(boards.all_lines()) == 15
    finally:
        boards.board_photograph.cache_clear()
        boards.all_lines.cache_clear()


def test_no_board_is_said():
    with pytest.raises(ValueError, match="No checkerboard was found"):
        boards.board_lines(np.full((480, 640), 128, np.uint8))


def test_rails_deviate_as_their_points_say():
    _, right = draw.rails().axes
    (curve,) = coloured(right, "object")
    np.testing.assert_allclose(curve[[0, -1], 1], 0, atol=1e-9)
    assert curve[:, 1].max() == pytest.approx(9.7, abs=0.1)
    labels = [text.get_text() for text in right.get_legend().get_texts()]
    assert labels == ["A: middle 9.7 px", "B: middle 0.2 px", "C: middle −9.9 px"]


def test_straightened_rails_leave_room_for_a_students_own():
    def said(lines):
        return [text.get_text() for text in draw.straightened_rails(lines).axes[1].texts]

    assert said([None] * 3) == ["your rails go here"]
    assert said(ideal_rails()) == []


def test_straightened_rails_show_the_bent_one():
    left, right = draw.straightened_rails(ideal_rails()).axes
    (curve,) = coloured(right, "camera")
    assert curve[:, 1].max() == pytest.approx(4.6, abs=0.05)
    for role in ("object", "second"):
        assert np.abs(coloured(right, role)[0][:, 1]).max() < 0.15
    edges = coloured(left, "ray")
    picture = left.images[0].get_array()
    for line in (edges[0], edges[2]):  # the picture was straightened with the points
        u, v = np.rint(line.mean(axis=0)).astype(int)
        assert picture[v, u] > 150


def test_without_rails_the_picture_is_as_photographed():
    left, right = draw.straightened_rails([None] * 3).axes
    np.testing.assert_array_equal(left.images[0].get_array(), rails.photograph())
    assert right.get_legend() is None


def test_a_students_straightness_is_in_the_legend():
    _, right = draw.straightened_rails(ideal_rails(), [0.02, 1.369, 0.02]).axes
    labels = [text.get_text() for text in right.get_legend().get_texts()]
    assert labels == ["A: RMS 0.02 px", "B: RMS 1.37 px", "C: RMS 0.02 px"]


def test_corners_beyond_the_fold_repeat_what_lies_inside():
    fetched(boards.SHOWN)  # on the photograph alone a keyboard lies there
    shown = draw.doubled_corners().axes[1].images[0].get_array()
    f, centre = 0.48 * 536, np.array([342, 236])
    towards = np.array([-342, 200]) / np.hypot(342, 200)  # the keyboard
    # r and its twin beyond the fold, at which r - 0.31 r³ is the same
    r = np.linspace(0.72, 0.9, 40)
    twin = [max(np.roots([-0.31, 0, 1, 0.31 * q**3 - q]).real) for q in r]
    inside, beyond = (np.rint(f * np.outer(q, towards) + centre).astype(int) for q in (r, twin))
    one, other = (shown[p[:, 1], p[:, 0]].astype(float) for p in (inside, beyond))
    assert np.ptp(one) > 60
    assert np.corrcoef(one, other)[0, 1] > 0.9


def test_a_rail_without_numbers_is_left_out():
    a, _, c = ideal_rails()
    _, right = draw.straightened_rails([a, np.full((89, 2), np.nan), c]).axes
    labels = [text.get_text()[0] for text in right.get_legend().get_texts()]
    assert labels == ["A", "C"]
