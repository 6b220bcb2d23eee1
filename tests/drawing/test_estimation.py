"""The figures of chapter 06: each draws, says what it shows, and shows the right thing."""

import itertools

import matplotlib as mpl
import numpy as np
import pytest
from legible import Legible

mpl.use("Agg")  # as a test has no screen

from matplotlib.quiver import Quiver
from real_data import fetched

from course_lib import homography, least_squares, resection
from course_lib.drawing import estimation as draw
from course_lib.drawing.estimation import resection as later
from course_lib.drawing.estimation import wall as walls
from course_lib.drawing.style import ROLES
from course_lib.homogeneous import apply_homography
from data_generators import cell

CAMERA = cell.camera_beside()
PIXELS = draw.found(CAMERA, cell.object_points())
P = resection.camera_dlt(cell.object_points(), PIXELS)
WALL = draw.rendered_building()
H = homography.homography_dlt(WALL.pixels, WALL.places)


def sheet():
    """Return pixels of the dots of the sheet below the bent cover, and what a homography leaves."""
    seen = cell.camera_above().project(cell.on_table(draw.SHEET))
    seen = cell.observed(seen + cell.cover_shift(seen), 0.2, np.random.default_rng(6))
    model = homography.homography_dlt(draw.SHEET, seen)
    return seen, seen - apply_homography(draw.SHEET, model)


SEEN, LEFT = sheet()
TABLE = resection.correction_table(SEEN, LEFT, cell.SIZE, (6, 8))
FIGURES = {
    "bar_in_tension": draw.bar_in_tension,
    "calibration_object": lambda: draw.calibration_object(PIXELS, P),
    "calibration_object alone": lambda: draw.calibration_object(PIXELS),
    "circle_to_ellipse": draw.circle_to_ellipse,
    "correction": lambda: draw.correction(TABLE),
    "held_out": lambda: draw.held_out(SEEN, LEFT),
    "misses": lambda: draw.misses({"all": draw.GOALS[:, :2] + 9, "none": None}, draw.GOALS),
    "one_unknown": lambda: draw.one_unknown(yours=10.3),
    "residual_field": lambda: draw.residual_field({"before": (SEEN, LEFT)}),
    "shadows": draw.shadows,
    "slipped_gauge": draw.slipped_gauge,
    "straightened": lambda: draw.straightened(WALL, H),
    "strain_line": lambda: draw.strain_line(yours=(45, 20)),
    "too_high": draw.too_high,
    "two_views": draw.two_views,
}
NO_FIGURES = {"BLOCKS", "GOALS", "LOADS", "PIXELS", "SHEET"}
NO_FIGURES |= {"building", "found", "outer_four", "readings", "rendered_building", "through"}


@pytest.fixture(scope="module", params=FIGURES)
def figure(request):
    drawn = FIGURES[request.param]()
    drawn.draw_without_rendering()
    return drawn


def lines(figure, role):
    """Return the data of the lines that have the colour of a role."""
    found = [line for ax in figure.axes for line in ax.lines if line.get_color() == ROLES[role]]
    return [np.asarray(line.get_xydata()) for line in found]


def ticked(figure):
    return [text.get_text() for ax in figure.axes for text in ax.texts]


class TestEachFigure(Legible):
    UNITS = (
        "px",
        "px²",
        "px a cm",
        "cm",
        "mm",
        "kN",
        r"\$10\^\{-6\}\$",
        "bays",
        "floors",
        "cells",
    )
    WHITE_ON_DARK = True


def test_every_function_is_tried_here():
    assert {name.split()[0] for name in FIGURES} | NO_FIGURES == set(draw.__all__)


@pytest.mark.parametrize(
    "yours", [None, "left", [1, 2, 3], np.full((3, 3), np.nan), {}, np.zeros(2)]
)
def test_what_a_student_cannot_have_meant_is_not_drawn_or_does_no_harm(yours):
    draw.one_unknown(yours=yours).draw_without_rendering()
    draw.strain_line(yours=yours).draw_without_rendering()
    draw.misses({"yours": yours}, draw.GOALS).draw_without_rendering()
    draw.straightened(WALL, yours).draw_without_rendering()
    draw.calibration_object(PIXELS, yours).draw_without_rendering()
    draw.correction(yours).draw_without_rendering()


@pytest.mark.parametrize("H", [np.ones((3, 3)), 1e200 * np.eye(3), np.diag([1, 1, 1e-15])])
def test_a_matrix_that_maps_no_plane_straightens_none(H):
    figure = draw.straightened(WALL, H)
    assert [text.get_text() for text in figure.axes[1].texts] == ["no homography yet"]
    assert draw.through([[1, 2]], H) is None


def test_points_go_through_a_students_homography():
    np.testing.assert_allclose(
        draw.through([[1, 2], [3, 4]], np.diag([2, 3, 1])), [[2, 6], [6, 12]]
    )
    assert draw.through([[1, 2]], None) is None


@pytest.mark.parametrize(
    ("matrix", "title"),
    [
        (np.ones((3, 4)), "P is not a camera"),
        (np.full((3, 4), np.nan), "P is not a camera"),
        (P * [-1, -1, -1, 1], "P has dots behind the camera"),
        (None, "48 dots"),
    ],
)
def test_a_matrix_that_is_no_camera_is_named(matrix, title):
    figure = draw.calibration_object(PIXELS, matrix)
    figure.draw_without_rendering()
    assert figure.axes[0].get_title(loc="left") == title


# What they show


def test_the_parabola_is_lowest_at_the_least_squares_solution():
    (curve,) = [line for line in lines(draw.one_unknown(), "ray") if len(line) > 50]
    x = least_squares.solve_one_unknown(draw.BLOCKS, draw.PIXELS)
    assert curve[np.argmin(curve[:, 1]), 0] == pytest.approx(x, abs=0.02)


def test_residuals_hang_on_the_students_line():
    figure = draw.strain_line(yours=(40, 30))
    sticks = lines(figure, "object")
    assert len(sticks) == 8
    for stick, load, strain in zip(sticks, draw.LOADS, draw.readings(), strict=True):
        np.testing.assert_allclose(stick, [[load, strain], [load, 40 * load + 30]])


def test_the_robust_line_passes_the_slip_by():
    figure = draw.slipped_gauge()
    (plain,), (robust,) = lines(figure, "object"), lines(figure, "image")
    true = np.polyfit(draw.LOADS, draw.readings(), 1)
    at = plain[:, 0]
    assert np.abs(robust[:, 1] - np.polyval(true, at)).max() < 12
    assert np.abs(plain[:, 1] - np.polyval(true, at)).max() > 60
    weights = [float(text) for text in ticked(figure) if text[:2] in ("0.", "1.")]
    assert min(weights) == weights[6] < 0.2


def test_misses_are_drawn_from_the_goal_to_the_needle():
    figure = draw.misses({"both": draw.GOALS[:, :2] + [3, -4]}, draw.GOALS, times=10)
    ways = [np.diff(line, axis=0)[0] for line in lines(figure, "object") if len(line) == 2]
    np.testing.assert_allclose(ways, np.tile([30, -40], (9, 1)))
    crosses = [line[0] for line in lines(figure, "object") if len(line) == 1]
    np.testing.assert_allclose(crosses, draw.GOALS[:, :2] + [30, -40])
    title = figure.axes[0].get_title(loc="left")
    assert title == "both: table 5.00, block 5.00 mm"
    flat = draw.misses({"both": draw.GOALS[:6, :2] + [30, -40]}, draw.GOALS[:6, :2])
    assert flat.axes[0].get_title(loc="left") == "both: 50.0 mm"


def test_a_higher_target_is_missed_by_what_the_formula_says():
    above = cell.camera_above()
    markers = above.project(cell.on_table(cell.MARKERS))
    A = least_squares.fit_affine(markers, cell.MARKERS)
    goals = above.project(cell.BLOCK)
    off = goals @ A[:, :2].T + A[:, 2] - cell.BLOCK[:, :2]
    r = np.linalg.norm(cell.BLOCK[:, :2] - [240, 160], axis=1)
    np.testing.assert_allclose(np.linalg.norm(off, axis=1), r * 60 / (800 - 60), rtol=1e-6)


def test_four_points_fit_and_the_others_tell():
    four = draw.outer_four(WALL)
    exact = homography.homography_dlt(WALL.pixels[four], WALL.places[four])
    off = np.linalg.norm(apply_homography(WALL.pixels, exact) - WALL.places, axis=1)
    assert off[four].max() < 1e-9
    assert off.max() > 0.005
    title = draw.straightened(WALL, exact, four).axes[1].get_title(loc="left")
    unused = np.delete(off, four)
    assert title == f"the others are off by {np.sqrt((unused**2).mean()):.3f} bays (RMS)"
    off = np.linalg.norm(apply_homography(WALL.pixels, H) - WALL.places, axis=1)
    title = draw.straightened(WALL, H).axes[1].get_title(loc="left")
    assert title == f"all are off by {np.sqrt((off**2).mean()):.3f} bays (RMS)"


def test_the_points_that_were_read_off_are_those_of_one_plane():
    pixels = [np.array(f.split(), float).reshape(-1, 2) for f in walls.FLOORS]
    assert [len(floor) for floor in pixels] == [10, 10, 8, 4]
    places = np.array([(k, up) for up, floor in enumerate(pixels) for k in range(len(floor))])
    H = homography.homography_dlt(places, np.concatenate(pixels))
    left = apply_homography(places.astype(float), H) - np.concatenate(pixels)
    assert np.sqrt((left**2).sum(axis=1).mean()) < 2.0


def test_the_straightened_wall_has_the_photographs_colours_where_its_points_are():
    figure = draw.straightened(WALL, H)
    (picture,) = figure.axes[1].images
    left, right, bottom, top = picture.get_extent()
    straight = np.asarray(picture.get_array(), float)
    rows, columns = straight.shape[:2]
    for k, floor in ((0, 1), (2, 2), (4, 0)):  # a little inside of a window
        place = np.array([k + 0.2, floor + 0.2])
        u, v = np.rint(apply_homography(place, np.linalg.inv(H))).astype(int)
        column = int((place[0] - left) / (right - left) * columns)
        row = int((top - place[1]) / (top - bottom) * rows)
        seen = straight[row - 1 : row + 2, column - 1 : column + 2].mean(axis=(0, 1))
        expected = WALL.picture[v - 1 : v + 2, u - 1 : u + 2].mean(axis=(0, 1))
        assert np.abs(seen - expected).max() < 30


def test_rings_are_where_the_camera_matrix_puts_the_dots():
    figure = draw.calibration_object(PIXELS, P)
    (rings,) = [x for x in figure.axes[0].lines if x.get_marker() == "o"]
    np.testing.assert_allclose(rings.get_xydata(), CAMERA.project(cell.object_points()), atol=1.0)
    assert figure.axes[0].get_title(loc="left") == "rings: P, 0.26 px from the dots"


def test_the_table_says_what_the_cover_does():
    (fine, coarse) = [
        c for c in draw.correction(TABLE).axes[0].collections if isinstance(c, Quiver)
    ]
    np.testing.assert_allclose(np.stack([coarse.U, coarse.V], 1), TABLE.reshape(-1, 2))
    inside = (fine.X > 120) & (fine.X < 520) & (fine.Y > 120) & (fine.Y < 360)
    told = np.stack([fine.U, fine.V], 1)[inside]
    truth = LEFT[
        np.argmin(
            np.hypot(fine.X[inside, None] - SEEN[:, 0], fine.Y[inside, None] - SEEN[:, 1]), axis=1
        )
    ]
    assert np.corrcoef(told.ravel(), truth.ravel())[0, 1] > 0.8


def test_the_largest_table_fits_best_and_helps_less():
    judged = [later.judge_table(SEEN, LEFT, shape) for shape in later.TABLES]
    learned, unseen = [j.learned for j in judged], [j.held_out for j in judged]
    assert learned == sorted(learned, reverse=True)
    best = int(np.argmin(unseen))
    assert 3 < best < len(unseen) - 1
    assert unseen[-1] > 1.25 * unseen[best]
    assert unseen[best] < 0.5 * judged[0].before


def bays(wall, H):
    """Return the bays 1 to 7 of the lowest floor, straightened by H, as rows of grey values."""
    import cv2

    grey = cv2.cvtColor(wall.picture, cv2.COLOR_RGB2GRAY)
    u, v = np.meshgrid(np.linspace(0.03, 0.97, 40), np.linspace(0.95, 0.1, 40))
    patches = []
    for k in range(1, 8):
        pixels = apply_homography(np.stack([u.ravel() + k, v.ravel()], axis=1), np.linalg.inv(H))
        seen = cv2.remap(grey, *pixels.astype(np.float32).T[:, None], cv2.INTER_LINEAR)
        patches.append(seen[0].astype(float))
    return np.array(patches)


def test_the_bays_of_the_real_building_become_alike():
    wall = draw.building(fetched("opencv_stereo/building.jpg"))
    assert wall.picture.shape == (600, 868, 3)
    assert wall.pixels.shape == wall.places.shape == (32, 2)
    projective = homography.homography_dlt(wall.pixels, wall.places)
    affine = np.vstack([least_squares.fit_affine(wall.pixels, wall.places), [0, 0, 1]])
    alike, unlike = (
        np.mean([np.corrcoef(a, b)[0, 1] for a, b in itertools.pairwise(bays(wall, H))])
        for H in (projective, affine)
    )
    assert alike > 0.9
    assert unlike < 0.5
