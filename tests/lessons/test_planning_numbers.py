"""The numbers that the text of chapter 11 states of set-ups."""

from itertools import pairwise

import numpy as np
import pytest
from lesson_text import about, lesson_text

from course_lib.drawing import planning as draw
from course_lib.drawing.explorers.setup_planner import setup_frame
from course_lib.drawing.planning import choosing, shaker
from course_lib.drawing.planning.panel import AMPLITUDE, FREQUENCY, PHANTOM, ZEISS, overview
from course_lib.exercises import all_exercises
from course_lib.exercises.planning import plain
from course_lib.exercises.planning.plain_setup import plan_setup
from course_lib.planning import (
    aperture_window,
    box_in_view,
    depth_range,
    judge_setup,
    read_cameras,
    read_lenses,
)
from course_lib.triangulation import point_covariance

TEXT = lesson_text("11_planning")
says = TEXT.says
TABLE = {v.name: v for v in draw.compared()[0][1]}


def test_points_of_all_exercises():
    exercises = all_exercises("planning")
    says(f"**Points:** {sum(exercise.points for exercise in exercises)}.")
    graded = [f"\n{e.name}\n" for e in exercises if "explain" not in e.name]
    assert sorted(graded, key=TEXT.index) == graded
    assert len(graded) == 9
    (explain,) = (e for e in exercises if "explain" in e.name)
    says(f"({explain.points} points, read by a person)", f'"{explain.name}"')


def test_the_demands():
    task = draw.TASK
    assert task.box.size.tolist() == [0.6, 0.06, 0.5]
    assert (task.resolution, task.motion, task.blur_px) == (0.0004, 0.003, 1.5)
    assert (task.frame_rate, task.sigma, task.exposure_at_f1) == (1000, 0.0001, 2e-6)
    assert (AMPLITUDE, FREQUENCY) == (0.003, 100)
    assert task.speed == about(1.88, 2)
    assert pytest.approx(15) == 6 / 0.4
    says("600 × 60 × 500 mm", "0.4 mm or less", "= 1.88", "2 µs at f/1", "15 px wide")
    camera = read_cameras()[PHANTOM]
    assert camera.image_size == (2048, 1920)
    assert (camera.pitch_um, camera.frame_rate) == (13.5, 6600)
    assert camera.sensor_size[0] == about(27.65, 2)
    says("2048 × 1920 pixels of 13.5 µm", "This camera does 6600")


def test_the_first_guess_of_the_distance():
    width = read_cameras()[PHANTOM].sensor_size[0]
    assert 606 * 85 / width == about(1863, 0)
    says("Z = 1863")


def test_the_worked_box():
    P = np.array([[1000, 0, 319.5, 639], [0, 1000, 239.5, 479], [0, 0, 1, 2]])
    size, middle = np.array([1, 0.5, 0.4]), np.zeros(3)
    room = plain.box_in_view(size, middle, np.zeros(3), P, (640, 480))
    assert room[1] == about(42.2, 1)
    moved = plain.box_in_view(size, middle, np.array([0.1, 0, 0]), P, (640, 480))
    assert moved[1] == about(-13.3, 1)
    says("597.3", "$639.5 - 597.3 = 42.2$", "652.8", "by 13.3 px")


def test_the_chosen_camera():
    setup = draw.chosen()
    assert (shaker.DISTANCE, np.degrees(shaker.TURN), shaker.N, shaker.TIME) == (
        2.2,
        pytest.approx(15),
        10,
        1 / 4000,
    )
    seen = box_in_view(draw.BOX.with_motion(draw.TASK.motion), setup.view)
    assert seen.inside
    assert seen.margins.argmin() == 1  # on the right, as the text says
    assert seen.margins.min() == about(108, 0)
    says("| 108 px |")


def test_what_a_pixel_covers():
    finest, coarsest = plain.object_resolution(2, 50, 5, np.radians(60))
    assert (finest, coarsest) == (pytest.approx(0.0002), pytest.approx(0.0004))
    fine, tilted = plain.object_resolution(2.2, 85, 13.5, np.radians(15))
    assert 1000 * tilted == about(0.362, 3)
    assert 1000 * plain.object_resolution(2.2, 85, 13.5, np.radians(30))[1] == about(0.403, 3)
    assert fine < tilted < draw.TASK.resolution
    assert 1000 * fine == about(0.349, 3)
    assert np.degrees(np.arccos(fine / 0.0004)) == about(29.1, 1)
    says("$\\cos\\alpha = 0.349/0.4$, at 29.1°")
    assert TABLE["resolution"].value == about(0.378, 3)
    says(
        "At 15° yes, with 0.362 mm, and at 30° no, with 0.403 mm",
        "the library finds 0.378 mm",
        "| 0.349 and 0.362 mm |",
    )


def test_the_aperture_windows():
    least, most = plain.aperture_window(50, 0.95, 1.05, 10, 0.55)
    assert (least, most) == (about(13.2, 1), about(7.1, 1))
    assert 2 * 950 * 1050 / 2000 == 997.5
    assert about(0.0528, 4) == 50 / 947.5
    near, far = depth_range(draw.BOX, draw.chosen().view)
    assert (near, far) == (about(2.093, 3), about(2.307, 3))
    least, most = plain.aperture_window(85, 2.093, 2.307, 20.25, 0.55)
    assert (least, most) == (about(8.2, 1), about(14.5, 1))
    assert 1.5 * 13.5 == 20.25
    window = aperture_window(85, near, far, 20.25)
    assert window.focus_distance == about(2.195, 3)
    assert read_lenses()[ZEISS].closest == 0.8
    says("From f/8.2 to f/14.5", "$s = 2.195$ m", "begins at 0.8 m", "$Z = 2.093$ m to $Z = 2.307$")


def test_smear_and_light():
    assert TABLE["motion blur"].value == about(1.47, 2)
    m = 85 / (2195 - 85)  # focused on 2.195 m
    assert m == about(0.0403, 4)
    assert 85 * (1 + m) == about(88.4, 1)
    assert 1 - 1 / (1 + m) ** 2 == about(0.08, 2)
    says("$1/(1 + m)^2$ or 8 %")
    assert 13.5 * 2.2 / (85 * (1 + m)) == about(0.336, 3)
    assert draw.chosen().view.K[0, 0] * 13.5e-3 == about(88.4, 1)  # the library's
    assert about(0.000320, 6) == 2.093 * 13.5e-6 / 0.0884
    assert about(1.47, 2) == 1.88 / 4000 / 0.000320
    says("85\\cdot 1.0403 = 88.4$ mm", "0.336 instead of 0.349 mm", "/0.0884 = 0.000320$")
    assert TABLE["light"].limit == pytest.approx(200)
    assert np.sqrt(250 / 2) == about(11.2, 1)
    says("= 1.47", "200\\ \\text{µs}", "= 11.2$", "0.000320")


def test_the_precision():
    camera = 0.1 * 0.336
    assert (camera, camera) == (about(0.034, 3), about(0.0336, 4))
    assert camera / np.sin(np.radians(15)) == about(0.13, 2)
    depth = camera / np.sqrt(2) / np.sin(np.radians(15))
    one, other = draw.pair(2.2, shaker.TURN, 10, 1 / 4000)
    middle = point_covariance([[0, 0, 0]], [one.view.P, other.view.P], 0.1)[0]
    assert 1000 * np.sqrt(middle[1, 1]) == pytest.approx(depth, rel=0.002)
    assert depth == about(0.092, 3)
    assert TABLE["expected σ"].value == about(0.096, 3)
    says("which is 0.034 mm on the panel", "= 0.13$ mm", "= 0.092\\ \\text{mm}", "it is 0.096 mm")


def test_what_the_demands_leave():
    turns = np.linspace(5, 30, 126)
    found = np.array([draw.limits(np.radians(t)) for t in turns])
    assert turns[found[:, 3] <= draw.TASK.sigma].min() == about(14.4, 1)
    assert turns[found[:, 4] <= draw.TASK.resolution].max() == pytest.approx(20.8, abs=0.21)
    between = found[(turns > 14.4) & (turns < 20.8)]
    assert (between[:, 0] < between[:, 2]).all()
    assert (between[:, 2] < between[:, 1]).all()
    says("less than 14.4°", "From 20.8° on")


def test_the_set_ups_compared():
    good, turned, short, photographer, small = (
        {v.name: v for v in verdicts} for _, verdicts in draw.compared()
    )
    missed = [[n for n, v in d.items() if not v.met] for d in (good, turned, short)]
    assert missed[0] == []
    assert {"resolution", "depth of field"} <= set(missed[1])
    least, _, light, *_ = draw.limits(np.radians(30))
    assert light < least == about(13.6, 1)
    says("f/13.6, which would make them sharp, is too dark")
    assert turned["expected σ"].value < 0.55 * good["expected σ"].value
    assert short["in view"].value == about(169, 0)
    assert short["resolution"].value == about(0.43, 2)
    says("would double the precision", "(169 px)", "cover 0.43 mm", "45 million pixels")
    width, height = read_cameras()["Nikon D850"].image_size
    assert width * height == pytest.approx(45e6, rel=0.02)
    assert not photographer["depth of field"].met
    assert not photographer["diffraction"].met
    assert "No f-number" in photographer["depth of field"].remedy
    assert photographer["frame rate"].value == 7
    assert small["frame rate"].value == 80
    assert small["depth of field"].met


def test_the_image_circle():
    assert TABLE["image circle"].limit == about(37.9, 1)
    assert TABLE["image circle"].value == 43.3 == round(np.hypot(24, 36), 1)
    says("37.9 mm for the high-speed camera", "24 × 36 mm draws 43.3 mm")


def verdicts_of(**changes):
    setting = {
        "camera": "Phantom v2640",
        "lens": ZEISS,
        "Z": 2.2,
        "turn_deg": 15,
        "N": 10,
        "t": 250,
    }
    table = setup_frame(**setting | changes).pictures[2]
    rows = [label.text for label in table.labels]
    missed = [rows[i + 1] for i, text in enumerate(rows) if text == "✗"]
    return missed, dict(pairwise(rows)), rows


def test_what_the_set_up_planner_shows():
    missed, number, _ = verdicts_of(N=5.6)
    assert missed == ["depth of field"]
    assert (number["depth of field"], number["diffraction"]) == ("2.2 px", "0.579 px")
    assert verdicts_of()[1]["depth of field"] == "1.23 px"
    assert about(63, 0) == 2 * 5.6**2
    says("spots of 2.2 px at the ends, instead of 1.2 px", "(0.58 px)", "only 63 µs")
    missed, _, rows = verdicts_of(t=125)
    assert missed == ["light"]
    assert "Open to f/7.9, or bring more lamps." in rows
    short = {"lens": "Nikkor AF-S 50 mm f/1.8G", "Z": 1.25}
    assert verdicts_of(**short, t=200)[0] == []
    assert verdicts_of(**short, t=250)[0] == ["motion blur"]
    says("from 1.25 m, with ± 15°, f/10 and 200 µs")
    cameras, lenses = read_cameras(), read_lenses()
    one = draw.stand(cameras[PHANTOM], lenses[short["lens"]], 1.25, shaker.TURN, 10, 2e-4)
    longest = 200 * 1.5 / judge_setup(one, draw.TASK)[6].value
    assert longest == about(236, 0)
    assert np.sqrt(longest / 2) == about(10.9, 1)
    assert aperture_window(50, *depth_range(draw.BOX, one.view), 20.25).least == about(8.8, 1)
    says("it begins at f/8.8, and 236 µs allow f/10.9")


# The whole plan


def test_the_worked_plan():
    task = {"width": 0.4, "height": 0.3, "depth": 0.05, "motion": 0.01, "speed": 0.1}
    task |= {"resolution": 4e-4, "blur_px": 2, "frame_rate": 50, "stand_off": 0.5}
    task |= {"exposure_at_f1": 1e-4}
    cameras = [{"width": 1280, "height": 1024, "pitch_um": 5, "frame_rate": 100}]
    lenses = [{"f_mm": 12, "N_least": 1.4, "N_most": 16, "closest": 0.1}]
    plan = plan_setup(task, cameras, lenses)
    assert plan["distance"] == pytest.approx(0.8125)
    near, far = 0.42 * 12 / 6.4, 0.42 * 12 / 6.4 + 0.05
    assert (near, far, 0.32 * 12 / 5.12) == pytest.approx((0.7875, 0.8375, 0.75))
    assert far * 5 / 12 == about(0.35, 2)
    assert near * 5 / 12 == about(0.328, 3)
    assert plan["exposure_time"] == about(0.0066, 4)
    window = aperture_window(12, near, far, 10)
    assert (window.least, window.most) == (about(0.6, 1), about(7.3, 1))
    assert np.sqrt(6.56 / 0.1) == about(8.1, 1)
    says("f/0.6 to f/7.3", "0.7875 m (the height asks for 0.75 m only)", "= 8.1", "0.8125 m")


def test_the_small_catalogue_has_a_set_up_for_the_panel():
    task, cameras, lenses = draw.panel_task()
    plan = plan_setup(task, cameras, lenses)
    assert cameras[plan["camera"]]["frame_rate"] >= 1000


def test_a_small_picture_shows_what_the_large_one_does():
    setup = draw.chosen()
    small, picture = overview(setup, 512)
    assert picture.shape[1] == 512
    scale = 512 / 2048
    corners = draw.BOX.corners
    large = setup.view.project(corners)
    np.testing.assert_allclose(small.project(corners) + 0.5, scale * (large + 0.5), atol=0.05)
    assert choosing.COMPARED[0][2:4] == (2.2, 15)
