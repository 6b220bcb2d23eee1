"""The figures of chapter 12: each draws, says what it shows, and shows the right thing."""

import matplotlib as mpl
import numpy as np
import pytest
from legible import Legible
from matplotlib.collections import PolyCollection

mpl.use("Agg")  # as a test has no screen

from course_lib.drawing import lab as draw
from course_lib.drawing.lab.page import Length
from course_lib.drawing.lab.plane import above
from course_lib.drawing.style import ROLES
from data_generators import desk

SIZE = (640, 480)
PARTS = {"pointing": 0.3, "pose": 0.0, "target": 0.4}
R, T = desk.pose_towards((180, 50), 24, -8, 500, 0)
VIEW = desk.photograph_desk(R, T, SIZE, np.random.default_rng(1))
CAMERA = (VIEW.camera.K, desk.LENS, R, T)
EXTENT = (-60.0, 400.0, -60.0, 185.0)
BOARD = VIEW.project(desk.TARGET.points())
LID = desk.box_corners()[4:6]
THUMBNAIL = draw.thumbnail(VIEW.picture[..., 1], BOARD)
EYES = [np.array([-43.0, 303.0, -386.0]), np.array([414.0, 312.0, -386.0])]


GREY = np.full((120, 160), 200, np.uint8)
#: A slanted row of corners, its middle one 0.8 px above it, and others 0.4 px below.
STRAIGHT = np.array([[100.0, 100], [200, 110], [300, 120]])
BENT = STRAIGHT + np.array([[0, 0.4], [0, -0.8], [0, 0.4]])


def page():
    pictures = ((VIEW.picture, np.array([[420.0, 250.0], [500.0, 270.0]])),)
    lengths = [Length("card: 85.6 mm ± 0.9 mm", PARTS, pictures * n) for n in (1, 2)]
    return draw.report_page(
        "Lab report", [("✓ desk_1.jpg", THUMBNAIL)] * 12, ["7 of 9 photographs"] * 3, lengths
    )


FIGURES = {
    "contact_sheet": lambda: draw.contact_sheet(
        [THUMBNAIL, None] * 4, ["IMG_2.jpg", "a_name_that_is_very_long.jpg"] * 4, [True, False] * 4
    ),
    "contributions": lambda: draw.contributions({"card": PARTS, "lid": {"pointing": 0.2}}),
    "covered": lambda: draw.covered([BOARD], SIZE, (0, 8, 53, 45)),
    "from_above": lambda: draw.from_above(
        VIEW.picture, CAMERA, EXTENT, desk.card_corners()[:2, :2], "85.6 mm ± 0.9 mm (95 %)"
    ),
    "lens_bend": lambda: draw.lens_bend(VIEW.camera.K, desk.LENS, SIZE),
    "off_by": lambda: draw.off_by(["1", "1", "2"], [0.1, -0.2, 2.0], [0.5, 0.5, 0.8]),
    "ray_and_plane": draw.ray_and_plane,
    "rays_from_above": lambda: draw.rays_from_above(desk.TARGET.points(), EYES, LID, 51.0),
    "report_page": page,
    "straightened": lambda: draw.straightened((GREY, GREY), (BENT, STRAIGHT), SIZE),
    "ruler_and_camera": lambda: draw.ruler_and_camera(
        ["card", "lid"], [0.1, -0.3], [0.9, 0.7], [0.5, 0.5]
    ),
}


@pytest.fixture(scope="module", params=FIGURES)
def figure(request):
    drawn = FIGURES[request.param]()
    drawn.draw_without_rendering()
    return drawn


class TestEachFigure(Legible):
    UNITS = ("px", "mm", "number")


def test_every_function_is_tried_here():
    assert set(FIGURES) | {"thumbnail"} == set(draw.__all__)


def lines(ax, role):
    found = [line for line in ax.lines if line.get_color() == ROLES[role]]
    return [np.asarray(line.get_xydata()) for line in found]


def test_a_thumbnail_has_its_dots_where_the_corners_are():
    bare = draw.thumbnail(VIEW.picture[..., 1], [])
    assert bare.shape == (240, 320, 3)
    changed = np.argwhere((bare != THUMBNAIL).any(axis=2))[:, ::-1]
    small = (BOARD + 0.5) / 2 - 0.5
    far = np.linalg.norm(changed[:, None] - small[None], axis=2)
    assert far.min(axis=0).max() < 1  # a dot at each corner
    assert far.min(axis=1).max() < 6  # and nowhere else


def test_fields_without_a_corner_are_grey_and_counted():
    (ax,) = FIGURES["covered"]().axes
    cells = np.floor((BOARD + 0.5) / 80).astype(int)
    count = len(np.unique(cells, axis=0))
    assert ax.get_title(loc="left").startswith(f"{count} of 48 fields")
    grey = np.ma.masked_invalid(ax.collections[0].get_array()).count()
    assert grey == 48 - count


def test_the_lens_is_drawn_as_it_is_but_longer():
    (ax,) = FIGURES["lens_bend"]().axes
    times = float(ax.get_title(loc="left").split()[0])
    moved = max((np.diff(line, axis=0)[0] for line in lines(ax, "camera")), key=np.linalg.norm)
    longest = float(ax.get_title(loc="left").split()[-2])
    assert np.linalg.norm(moved) / times == pytest.approx(longest, abs=0.05)
    assert longest > 1


def test_a_row_of_corners_is_drawn_more_bent_than_it_is():
    before, after = FIGURES["straightened"]().axes
    assert before.get_title(loc="left") == "as taken: 0.80 px off a line, drawn 20 ×"
    assert after.get_title(loc="left") == "straightened: 0.00 px off a line, drawn 20 ×"
    (bent,), (straight,) = (lines(ax, "camera") for ax in (before, after))
    np.testing.assert_allclose(straight, STRAIGHT, atol=1e-9)
    middle = (bent[0] + bent[2]) / 2
    assert middle[1] - bent[1, 1] == pytest.approx(20 * 1.2, rel=0.02)
    assert all(ax.images[0].get_extent() == [-0.5, 639.5, 479.5, -0.5] for ax in (before, after))


def test_from_above_squares_are_squares():
    """Straight above the print, dark and light squares alternate every 25 mm."""
    map_ = above(VIEW.picture, CAMERA, EXTENT).astype(int)
    at = lambda x, y: map_[round((y - EXTENT[2]) / 0.5), round((x - EXTENT[0]) / 0.5)]  # noqa: E731
    for i in range(7):
        for j in range(4):
            dark = at(12.5 + 25 * i, 12.5 + 25 * j).mean() < 110
            assert dark == ((i + j) % 2 == 0)
    x, y, _ = desk.card_corners()[:2].mean(axis=0)
    red, _, blue = at(x, y - 4)
    assert red > blue  # wood beside the card
    x, y, _ = desk.card_corners().mean(axis=0)
    red, _, blue = at(x, y)
    assert blue > red + 40


def test_bars_are_the_parts_and_their_sum():
    one, _ = FIGURES["contributions"]().axes
    widths = [bar.get_width() for bar in one.patches]
    np.testing.assert_allclose(widths, [0.3, 0.4, 0.5])  # what is zero is left out
    assert [t.get_text() for t in one.texts][:3] == ["pointing", "target", "together"]


def test_intervals_that_miss_the_truth_look_different():
    (ax,) = FIGURES["off_by"]().axes
    colours = [bars.lines[0].get_color() for bars in ax.containers]
    assert colours == [ROLES["camera"], ROLES["camera"], ROLES["object"]]
    markers = [bars.lines[0].get_marker() for bars in ax.containers]
    assert markers[2] != markers[0]


def test_the_rulers_interval_is_grey_and_the_cameras_an_error_bar():
    (ax,) = FIGURES["ruler_and_camera"]().axes
    bands = [band for band in ax.collections if isinstance(band, PolyCollection)]
    grey = [np.ptp(band.get_paths()[0].vertices[:, 0]) for band in bands]
    np.testing.assert_allclose(grey, [1.0, 1.0])
    half = [np.ptp(bars.lines[2][0].get_segments()[0][:, 0]) / 2 for bars in ax.containers]
    np.testing.assert_allclose(half, [0.9, 0.7])


def test_rays_go_from_the_cameras_to_both_ends():
    (ax,) = FIGURES["rays_from_above"]().axes
    assert sum("386 mm up" in text.get_text() for text in ax.texts) == 2
    assert "-" not in "".join(text.get_text() for text in ax.texts)
    rays = lines(ax, "ray")
    expected = [np.array([eye, end])[:, :2] for eye in EYES for end in LID]
    np.testing.assert_allclose(rays, expected)
