"""The numbers that the text of chapter 01 states are those that the library computes."""

import numpy as np
import pytest
from lesson_text import about, lesson_text
from scipy.ndimage import map_coordinates
from skimage.data import stereo_motorcycle

from course_lib import camera, optics
from course_lib.drawing import pinhole as draw
from course_lib.drawing.explorers.dolly import dolly_zoom_frame
from course_lib.exercises.pinhole.data_sheet import data_sheet

TEXT = lesson_text("01_pinhole")
says = TEXT.says

# The photograph: published intrinsics, and the edges as the lesson gives them.
F, C = 994.978, np.array([311.193, 254.877])
BASELINE, OFFSET = 193.001, 31.086  # mm, px
TOP, LOWER = ((527, 11.5), (709.5, 13)), ((559.5, 168.5), (693, 176))
LEFT, RIGHT = ((341, 6.5), (338.5, 185.5)), ((719, 3.5), (689, 290))


def crossing(first, second):
    """Intersect two lines as homogeneous vectors: another way than the lesson's."""
    lines = [np.cross([*a, 1], [*b, 1]) for a, b in (first, second)]
    point = np.cross(*lines)
    return point[:2] / point[2]


def direction(pixel):
    d = np.append((pixel - C) / F, 1)
    return d / np.linalg.norm(d)


def degrees_between(a, b):
    return np.degrees(np.arccos(np.clip(a @ b, -1, 1)))


def test_edges_in_the_lesson_are_those_tested_here():
    for edge in (TOP, LOWER, LEFT, RIGHT):
        says(str(edge))
    says("f_photo, c_photo = 994.978, np.array([311.193, 254.877])", "193.001", "31.086")


@pytest.mark.parametrize("edge", [TOP, LOWER, LEFT, RIGHT], ids=["top", "lower", "left", "right"])
def test_edges_lie_on_edges_of_the_photograph(edge):
    picture = stereo_motorcycle()[0].astype(float)
    channels = np.dstack([picture, picture[..., :1] - picture[..., 2:]])
    a, b = np.array(edge)
    along = (b - a) / np.linalg.norm(b - a)
    across = np.array([-along[1], along[0]])
    offsets = np.arange(-4, 4.01, 0.25)
    points = a + (b - a) * np.linspace(0.05, 0.95, 200)[:, None]
    where = points[:, None] + offsets[:, None] * across
    profile = [
        map_coordinates(channels[..., k], [where[..., 1], where[..., 0]], order=1).mean(axis=0)
        for k in range(4)
    ]
    steps = np.abs(np.diff(profile, axis=1)).max(axis=0)
    steepest = (offsets[:-1] + 0.125)[steps.argmax()]
    assert abs(steepest) < 1.0


def test_rack_has_a_right_angle_and_the_text_says_what_was_measured():
    boards, posts = crossing(TOP, LOWER), crossing(LEFT, RIGHT)
    along, down = direction(boards), direction(posts)
    assert degrees_between(along, down) == pytest.approx(89.9, abs=0.05)
    says("we measured 89.9° in space")
    moved = crossing(((527, 11.5), (709.5, 14)), LOWER)
    assert np.linalg.norm(moved - boards) == pytest.approx(400, abs=50)
    assert degrees_between(direction(moved), along) == pytest.approx(2, abs=0.2)
    change = degrees_between(direction(moved), down) - degrees_between(along, down)
    assert change == pytest.approx(0.3, abs=0.05)
    assert degrees_between(direction(moved), down) == pytest.approx(90.2, abs=0.05)
    says("moves by about 400 px", "by only 2°", "by 0.3°", "it becomes 90.2°")


def test_depth_of_the_photograph_confirms_the_direction():
    depth = BASELINE * F / (stereo_motorcycle()[2] + OFFSET)
    points = [
        np.append((np.array([u, v]) - C) / F, 1) * depth[v, u] for u, v in [(530, 8), (705, 9)]
    ]
    true = (points[1] - points[0]) / np.linalg.norm(points[1] - points[0])
    assert degrees_between(-true, direction(crossing(TOP, LOWER))) == pytest.approx(0.7, abs=0.05)
    says("agree to 0.7°")


def test_principal_point_of_the_photograph_is_off_the_middle():
    height, width = stereo_motorcycle()[0].shape[:2]
    assert (width, height) == (741, 500)
    assert (width - 1) / 2 - C[0] == pytest.approx(59, abs=0.5)
    halves = np.degrees(np.arctan([(C[0] + 0.5) / F, (width - 0.5 - C[0]) / F]))
    assert halves[1] - halves[0] == pytest.approx(6, abs=0.1)
    says("59 pixels to the left")

    centred = np.degrees(optics.field_of_view(F, (width, height)))[0]
    assert tuple(halves) == (about(17.4, 1), about(23.3, 1))
    assert (halves.sum(), centred) == (about(40.73, 2), about(40.85, 2))
    assert centred - halves.sum() == about(0.1, 1)
    says("sees 17.4°, to the right 23.3°, in all 40.73°. The formula says 40.85°")
    says("difference of 0.1° is little, but the two halves differ by 6°")


def test_data_sheet():
    answers = data_sheet(85.0, (27.6, 25.9), (2048, 1920), 6890.5)
    assert round(answers["pixels_per_mm"], 1) == 74.2
    assert round(answers["f_px"], 1) == 6307.2
    assert (answers["c_x"], answers["c_y"]) == (1023.5, 959.5)
    assert round(answers["f_calibrated_mm"], 1) == 92.9
    assert answers["f_calibrated_mm"] == pytest.approx(92.86, abs=0.005)
    says("74.2 px/mm", "6307.2", "92.86", "$(1024, 960)$", "9 % larger")

    widths = camera.pixel_focal_length(85, (27.55, 25.9), (2048, 1920))[0] - answers["f_px"]
    assert widths == pytest.approx(11, abs=0.6)
    assert pytest.approx(92.9, abs=0.05) == 85 * 1000 / (1000 - 85)


def test_holes():
    assert optics.best_pinhole_diameter(100, 0.00055) == pytest.approx(0.37, abs=0.005)
    assert optics.airy_diameter(0.00055, 100 / 0.35) == pytest.approx(0.38, abs=0.005)
    assert optics.airy_diameter(0.00055, 100 / 0.07) == pytest.approx(1.92, abs=0.005)
    assert optics.airy_diameter(0.00055, 100 / 0.07) / 0.07 == pytest.approx(27, abs=0.5)
    assert np.sqrt(2.44) == pytest.approx(1.56, abs=0.005)
    assert pytest.approx(286, abs=0.5) == 100 / 0.35
    assert pytest.approx(8, abs=0.2) == (2 / 0.07) ** 2 / 100
    says("0.37 mm", "0.38 mm", "1.92 mm", "27 times", "k = 1.56", "= 286", "about 8 s")


@pytest.mark.parametrize(
    ("f", "degrees"), [(14, 104), (35, 54), (50, 40), (60, 33), (70, 29), (200, 10), (300, 7)]
)
def test_lens_classes(f, degrees):
    assert np.degrees(optics.field_of_view(f, (36, 24))[0]) == pytest.approx(degrees, abs=0.5)


def test_equivalents():
    assert optics.equivalent_focal_length(25, (17.3, 13)) == pytest.approx(50, abs=0.1)
    assert optics.equivalent_focal_length(1, (6.17, 4.55)) == pytest.approx(5.6, abs=0.05)


def test_perspective():
    assert pytest.approx(69, abs=0.5) == 800 * 1.5 * (1 / 5 - 1 / 7)
    assert pytest.approx(12, abs=0.5) == 800 * 1.5 * (1 / 13 - 1 / 15)
    says("69 px high", "12 px high")
    pixel = camera.project_pinhole((1.2, 0.5, 4), 800, (319.5, 239.5))
    assert pixel.tolist() == [559.5, 339.5]
    meeting = camera.vanishing_point((1, 0, 2), 800, (319.5, 239.5))
    assert meeting.tolist() == [719.5, 239.5]
    person = camera.pixel_focal_length(35, (36, 24), (6000, 4000))[1] * 1.8 / 20
    assert person == pytest.approx(525)
    says("559.5", "(719.5, 239.5)", "525 px")


def test_house():
    assert pytest.approx(3.9, abs=0.05) == 27.6 * 12 / 85
    assert pytest.approx(9.5, abs=0.05) == 27.6 * 12 / 35
    pixel = 12_000 / camera.pixel_focal_length(35, (27.6, 25.9), (2048, 1920))[0]
    assert pixel == pytest.approx(4.6, abs=0.05)
    assert pytest.approx(27.7, abs=0.05) == 85 * 9 / 27.6
    says("only 3.9 m", "shows 9.5 m", "4.6 mm of the wall", "= 27.7$ m")


def test_older_convention_is_ours_with_the_sign_turned():
    f, X, Z = 50, 1000, 10_000
    assert f * X / (f - (Z + f)) == -f * X / Z == -5
    says("both give $x = -5$ mm", "$+5$ mm")
    forgotten = f * X / (Z + f)
    assert 1 - forgotten / (f * X / Z) == pytest.approx(f / Z, rel=0.01)
    assert pytest.approx(833, abs=0.5) == 5 / 0.006


def test_best_hole_in_the_explorer():
    assert round(float(optics.best_pinhole_diameter(75, 0.00055)), 2) == 0.32
    assert round(float(optics.best_pinhole_diameter(150, 0.00055)), 2) == 0.45
    says("only from 0.32 mm to 0.45 mm")


def test_foreshortening_with_the_middle_of_the_step():
    f, height = 800, 1.5
    for near, far, exact, formula in ((5, 7, 69, 67), (13, 15, 12, 12)):
        assert round(f * height / near - f * height / far) == exact
        assert round(f * height * 2 / ((near + far) / 2) ** 2) == formula
    says("/ 6^2 = 67$ px", "(1/5 - 1/7) = 69$ px", "draw.foreshortening(f=800, height=1.5")


def test_point_goes_to_the_same_pixel_through_K():
    K = np.array([[800, 0, 319.5], [0, 800, 239.5], [0, 0, 1]])
    assert (K @ (1.2, 0.5, 4)).tolist() == [2238, 1358, 4]
    assert camera.project_pinhole((1.2, 0.5, 4), 800, (319.5, 239.5)).tolist() == [559.5, 339.5]
    says("2238 \\\\ 1358 \\\\ 4", "= 559.5", "= 339.5")


def test_camera_that_looks_up():
    view = draw.street_view(turn_deg=14, tilt_deg=20, f=24)
    f, c = view.K[0, 0], view.K[:2, 2]
    assert f == pytest.approx(480)
    road = camera.vanishing_point(draw.road_direction(view), f, c)
    upright = camera.vanishing_point(view.R @ (0, 0, 1), f, c)
    assert [round(road[1]), round(upright[1])] == [414, -1079]
    says("to the row 414", "= -1079$", "tilt_deg=20")


def test_dolly_explorer_shows_what_the_text_says():
    values = {Z: [r.value for r in dolly_zoom_frame(Z, 28, True).readouts] for Z in (4.0, 12.0)}
    assert [values[Z][0] for Z in values] == ["112", "112"]
    assert [values[Z][1] for Z in values] == ["88", "205"]
    says("stays at 112 px", "from 88 px at $Z = 4$ m to 205 px at 12 m")


def test_lens_that_sees_the_same_on_a_smaller_sensor():
    full, small = (36, 24), (17.3, 13.0)
    same_width = optics.field_of_view(24, small)[0] - optics.field_of_view(50, full)[0]
    same_diagonal = optics.field_of_view(25, small)[2] - optics.field_of_view(50, full)[2]
    assert abs(np.degrees(same_width)) < 0.1
    assert abs(np.degrees(same_diagonal)) < 0.1
    says("With 24 mm it sees the same width again, with 25 mm the same diagonal")
