"""The figures of chapter 05: each draws, says what its axes are, and shows the right thing."""

import matplotlib as mpl
import numpy as np
import pytest
from legible import Legible
from matplotlib.colors import to_hex
from real_data import fetched

mpl.use("Agg")  # as a test has no screen

from course_lib import distortion
from course_lib.drawing import distortion as draw
from course_lib.drawing.distortion import boards, mapping, pictures
from course_lib.drawing.style import BLACK, ROLES
from data_generators import rails

LENS = [-0.31, 0.12]
GRID = distortion.pixel_grid((640, 480), 5, 4).reshape(-1, 2)
GRID = distortion.normalised_from_pixels(GRID, rails.K)


def straightened():
    picture = boards.computed_board()
    line = boards.board_lines(picture)[0]
    maps = distortion.undistortion_map(rails.K, LENS, rails.SIZE)
    return picture, maps, (line, distortion.undistort_pixels(line, rails.K, LENS))


def ideal_rails():
    lines = rails.rail_points(rails.photograph())
    return [distortion.undistort_pixels(line, rails.K, LENS) for line in lines]


def bent(yours=None):
    picture = boards.computed_board()
    return draw.bent_lines(picture, boards.board_lines(picture), yours)


FIGURES = {
    "barrel_and_pincushion": draw.barrel_and_pincushion,
    "before_and_after": lambda: draw.before_and_after(*straightened()),
    "before_and_after part": lambda: draw.before_and_after(*straightened(), part=(340, 639)),
    "bent_lines": lambda: bent(np.arange(15) / 9),
    "doubled_corners": draw.doubled_corners,
    "displacement_fields": draw.displacement_fields,
    "fisheye_photograph": draw.fisheye_photograph,
    "fisheye_street": lambda: draw.fisheye_street(np.full((5, 2), 200.0)),
    "forward_and_backward": draw.forward_and_backward,
    "iterations": draw.iterations,
    "moved_points": lambda: draw.moved_points(GRID, LENS, GRID),
    "moved_points back": lambda: draw.moved_points(0.8 * GRID, LENS, back=True),
    "profiles": draw.profiles,
    "profiles yours": lambda: draw.profiles([(-0.31, 0), (-0.5, 0.1)], yours=[1.0, 1.1]),
    "rails": draw.rails,
    "straightened_rails": lambda: draw.straightened_rails(ideal_rails(), [0.02, 1.37, 0.02]),
    "straightened_rails none": lambda: draw.straightened_rails([]),
    "where_it_acts": draw.where_it_acts,
}


@pytest.fixture(params=FIGURES)
def figure(request):
    drawn = FIGURES[request.param]()
    drawn.canvas.draw()
    return drawn


class TestEachFigure(Legible):
    UNITS = ("px", "no unit", "°", "focal lengths")
    WHITE_ON_DARK = True


def test_every_function_is_tried_here():
    assert {name.split()[0] for name in FIGURES} == set(draw.__all__)


@pytest.mark.parametrize(
    "yours", [None, "left", [1, 2, 3], np.full((2, 2), np.nan), {}, [None] * 2]
)
def test_what_a_student_cannot_have_meant_is_not_drawn_or_does_no_harm(yours):
    picture, _, lines = straightened()
    draw.moved_points(GRID, LENS, yours).canvas.draw()
    draw.before_and_after(picture, yours, lines).canvas.draw()
    draw.fisheye_street(yours).canvas.draw()
    draw.straightened_rails([yours] * 3, [yours] * 3).canvas.draw()
    draw.straightened_rails(ideal_rails(), [yours] * 3).canvas.draw()
    draw.profiles([(-0.31, 0), (-0.5, 0.1)], yours=[yours, yours]).canvas.draw()


def coloured(ax, role):
    """Return the points of the lines of a role in axes."""
    return [np.asarray(line.get_xydata()) for line in ax.lines if line.get_color() == ROLES[role]]


# What they show


def test_students_points_are_drawn_where_they_are():
    (ax,) = draw.moved_points(GRID, LENS, GRID + 0.01).axes
    (stars,) = coloured(ax, "second")
    np.testing.assert_allclose(stars, GRID + 0.01)


@pytest.mark.parametrize("back", [False, True])
def test_circles_are_where_the_lens_or_its_inverse_puts_the_points(back):
    points = 0.7 * GRID
    (ax,) = draw.moved_points(points, LENS, back=back).axes
    (circles,) = coloured(ax, "object")
    start, end = (circles, points) if back else (points, circles)
    np.testing.assert_allclose(distortion.distort(start, LENS), end, atol=1e-9)


def test_lines_of_the_house_bulge_as_their_lens_says():
    barrel, pinhole, pincushion = draw.barrel_and_pincushion().axes

    def bulge(ax):
        """Return how far the middle of the lowest drawn level line lies below its ends."""
        level = [line for line in coloured(ax, "object") if np.ptp(line[:, 0]) > 200]
        lowest = max(level, key=lambda line: line[len(line) // 2, 1])
        return lowest[len(lowest) // 2, 1] - lowest[0, 1]

    assert bulge(barrel) > 5
    assert bulge(pinhole) == pytest.approx(0)
    assert bulge(pincushion) < -5


def test_house_through_a_lens_looks_up_the_pinholes_picture():
    source, wide = pictures.wide_house()
    seen = pictures.house_through(LENS).astype(float)
    rng = np.random.default_rng(4)
    pixels = rng.integers(20, 220, (400, 2))
    there = np.rint(distortion.undistort_pixels(pixels, pictures.K, LENS, wide)).astype(int)
    expected = source[there[:, 1], there[:, 0]].astype(float)
    off = np.abs(seen[pixels[:, 1], pixels[:, 0]] - expected).max(axis=1)
    assert np.median(off) < 6
    assert (off < 60).mean() > 0.9  # the rest are edges, half a pixel away


def test_nothing_is_seen_beyond_the_fold():
    lens = [-0.6]
    fold = distortion.valid_radius(lens)
    u, v = np.meshgrid(*(np.arange(n) for n in pictures.SIZE))
    r = np.hypot(u - pictures.K[0, 2], v - pictures.K[1, 2]) / pictures.K[0, 0]
    black = (pictures.house_through(lens) == 0).all(axis=2)
    edge = fold * (1 + lens[0] * fold**2)
    assert black[r > edge + 0.03].all()
    assert not black[r < edge - 0.03].any()


def test_a_coarse_map_is_the_fine_one():
    coarse = pictures.straight_map(rails.K, LENS, rails.SIZE)
    fine = np.stack(distortion.undistortion_map(rails.K, LENS, rails.SIZE), axis=-1)
    np.testing.assert_allclose(coarse, fine, atol=0.02)


def test_stages_of_the_camera_mark_one_point():
    figure = draw.where_it_acts(point=(1.0, 0.5, 2.0), k1=-0.2, f=536.0)
    ideal, bent_point, pixel = (coloured(ax, "object")[0][0] for ax in figure.axes)
    np.testing.assert_allclose(ideal, [0.5, 0.25])
    np.testing.assert_allclose(bent_point, distortion.distort([0.5, 0.25], [-0.2]))
    np.testing.assert_allclose(pixel, 536 * bent_point + [342, 236])


def test_profiles_mark_the_fold_at_the_top_of_the_curve():
    (ax,) = draw.profiles([(-0.31,)]).axes
    (curve,) = coloured(ax, "object")
    (mark,) = (line for line in ax.lines if line.get_color() == BLACK)
    (at,) = np.asarray(mark.get_xydata())
    assert at[0] == pytest.approx(distortion.valid_radius([-0.31]))
    assert at[1] == pytest.approx(curve[:, 1].max(), rel=1e-3)


def test_profiles_draw_a_students_radius_on_its_curve():
    (ax,) = draw.profiles([(-0.31, 0)], yours=[0.5]).axes
    (star,) = coloured(ax, "second")
    np.testing.assert_allclose(star, [[0.5, 0.5 * (1 - 0.31 * 0.25)]])


def test_field_says_its_largest_displacement_and_draws_arrows_that_way():
    complete, _, tangential = draw.displacement_fields().axes
    assert "33.8 px" in complete.get_title(loc="left")
    assert "0.168 px" in tangential.get_title(loc="left")
    (quiver,) = (c for c in complete.collections if hasattr(c, "U"))
    towards = np.asarray(quiver.get_offsets()) - [302.71656, 242.33386]
    assert ((np.stack([quiver.U, quiver.V], axis=1) * towards).sum(axis=1) < 0).all()


def test_iso_lines_have_the_level_that_is_written_on_them():
    from course_lib.drawing.distortion.fields import CLASSIC_K, CLASSIC_LENS

    ax = draw.displacement_fields().axes[0]
    (lines,) = (c for c in ax.collections if hasattr(c, "levels"))
    for level, path in zip(lines.levels, lines.get_paths(), strict=True):
        moved = distortion.displacement_field(path.vertices, CLASSIC_K, CLASSIC_LENS)
        np.testing.assert_allclose(np.hypot(*moved.T), level, rtol=0.02)
    written = [text.get_text() for text in ax.texts]
    assert written == ["5", "15", "25"]


def test_newton_is_faster_and_the_fixed_point_fails_for_a_strong_lens():
    for k1 in (-0.2, 0.8):
        r_d = 0.7 * (1 + k1 * 0.49)
        assert mapping.newton(r_d, k1, 8)[-1] == pytest.approx(0.7, abs=1e-12)
    assert mapping.fixed_point(0.7 * (1 - 0.2 * 0.49), -0.2, 60)[-1] == pytest.approx(0.7)
    assert abs(mapping.fixed_point(0.7 * (1 + 0.8 * 0.49), 0.8, 60)[-1] - 0.7) > 0.1


def test_pixels_sent_forward_leave_holes_and_the_others_do_not():
    before, forward, backward = (
        ax.images[0].get_array() for ax in draw.forward_and_backward().axes
    )
    part = (slice(0, 48), slice(0, 64))
    holes = [(picture[part] == 0).all(axis=2).mean() for picture in (before, forward, backward)]
    assert holes[1] > 0.1
    assert max(holes[0], holes[2]) < 0.001


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
