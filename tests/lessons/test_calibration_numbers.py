"""Every number of chapter 07 that needs no photograph, computed anew."""

import sys

import numpy as np
import pytest
from lesson_text import about, lesson_text, read

from course_lib import calibration as cal
from course_lib.calibration_files import FORMS, StoredCamera, write_camera
from course_lib.detection import detect_board
from course_lib.detection.circles import circle_bias
from course_lib.distortion import distort_pixels
from course_lib.drawing import calibration as draw
from course_lib.drawing.calibration import photographs as made
from course_lib.drawing.calibration import using
from course_lib.drawing.explorers import poses
from course_lib.drawing.explorers.detection import detection_frame
from course_lib.exercises import all_exercises
from course_lib.exercises.calibration import plain, plain_refinement
from course_lib.optics import image_distance

bad = sys.modules["course_lib.drawing.calibration.targets"]

TEXT = lesson_text("07_calibration")
says = TEXT.says
POINTS, SIZE = draw.BOARD.points(), draw.SIZE


def test_points_of_all_exercises():
    says(f"**Points:** {sum(exercise.points for exercise in all_exercises('calibration'))}")


def test_the_data_sheet_of_chapter_01():
    assert about(1.09, 2) == 6890.5 / 6307.2
    says("$f = 6307$ px", "6890 px, 9 % more")
    assert about(0.085, 3) == 1 - 6307 / 6890
    says("$6307/6890$ of the true one, 8.5 % too short")


def test_bad_boards():
    boards = bad.bad_boards()
    bent, long, large = (boards[name][1] for name in list(boards)[1:])
    assert bent.K[0, 0] - 560 == about(-6.6, 1)
    says("A bend of 1 mm costs almost 7 px of $f$", "$f$ off by 7 px | twice as large")
    assert bent.rms / boards["as it should be"][1].rms == about(2, 0)
    assert (long.K[1, 1] - 558) / 558 == about(-0.01, 2)
    assert (boards["as it should be"][1].rms, long.rms) == (about(0.14, 2), about(0.20, 2))
    says("it costs 1 % of *one* focal length, and the RMS", "grows from 0.14 px to only 0.20 px")
    assert np.ptp(POINTS[:, 0]) == 240
    says("a bend of 1 mm over 24 cm")
    exact = bad.with_bad_board(1.01 * POINTS, noise=0)
    np.testing.assert_allclose(exact.K, bad.K, atol=1e-6)
    depth = [t[2] / u[2] for (_, t), (_, u) in zip(exact.poses, bad._shot(), strict=True)]
    np.testing.assert_allclose(depth, 1 / 1.01)
    assert large.K[0, 0] == pytest.approx(560, abs=0.3)


def test_the_window_of_the_search():
    def off(reach, blur=0.8, noise=2):
        return read(detection_frame(33, reach, blur, noise), "Error of the window search")

    every = [read(detection_frame(33, n, 0.8, 2), "Window search, all 54, RMS") for n in (2, 5)]
    assert every == [about(0.12, 2), about(0.045, 3)]
    assert (off(8), off(9)) == (about(0.12, 2), about(5.6, 1))
    assert read(detection_frame(33, 5, 0.8, 2), "Next edge") == about(9.1, 1)
    says("0.12 px (window 2) to 0.045 px (window 5)", "from 0.12 px to 5.6 px", "9.1 px away")
    errors = {n: off(n, blur=2) for n in range(2, 10)}
    assert sorted(errors, key=errors.get)[:2] == [4, 5]
    assert errors[2] == about(0.92, 2)
    says("4 or 5 px. A window of 2 px is narrower than the blur: 0.92 px off")


def test_worked_lines_are_what_the_exercises_return():
    rows = plain.homography_constraints(np.array([[1, 4, 7], [2, 0, 6], [3, 5, 1]]))
    assert rows.tolist() == [[4, 8, 0, 17, 10, 15], [-15, 4, 4, -34, 12, -16]]
    says("(4, 8, 0, 17, 10, 15)", "(-15, 4, 4, -34, 12, -16)")
    squares = np.subtract((1, 4, 4, 6, 12, 9), (16, 0, 0, 40, 0, 25))
    assert squares.tolist() == rows[1].tolist()
    says("(1, 4, 4, 6, 12, 9)", "(16, 0, 0, 40, 0, 25)")
    K = np.array([[2, 0, 3], [0, 2, 1], [0, 0, 1]])
    B = np.linalg.inv(K).T @ np.linalg.inv(K)
    assert B.tolist() == [[0.25, 0, -0.75], [0, 0.25, -0.25], [-0.75, -0.25, 3.5]]
    np.testing.assert_allclose(np.linalg.cholesky(B), np.linalg.inv(K).T, atol=1e-12)
    says("0.25 & 0 & -0.75\\\\ 0 & 0.25 & -0.25\\\\ -0.75 & -0.25 & 3.5")
    R, t = plain.pose_from_homography(np.eye(3), np.array([[-2.0, 0, -1], [0, -2, 0], [0, 0, -10]]))
    assert (R + 0.0).tolist() == np.eye(3).tolist()
    assert (t + 0.0).tolist() == [0.5, 0, 5]
    says("$\\mathbf t = (0.5, 0, 5)$")
    step = plain_refinement.refine_calibration
    J, r = np.array([[2.0], [2.0]]), np.array([6.0, 6.0])
    assert [float(step(np.array([10.0]), r, J, n)[0]) for n in (0, 1)] == [7, 8.5]
    says("$-24/8 = -3$, to 7", "$-24/16 = -1.5$, to 8.5")
    left = np.array([[3.0, 4], [0, 0], [0, 0], [0, 0]])
    assert plain_refinement.rms_error(left) == 2.5
    J, r = np.ones((4, 1)), np.array([-1.0, 1, -1, 1])
    assert plain_refinement.parameter_covariance(J, r)[0, 0] == about(0.333, 3)
    says("C = 1.333/4 = 0.333", "4/(4 - 1)")
    rms = np.array([0.2, 0.2, 0.3, 1.2])
    assert (np.median(rms), rms.mean()) == (pytest.approx(0.25), pytest.approx(0.475))
    says("The median is 0.25", "(The mean is 0.475")


def test_the_zeros_of_the_chosen_camera():
    K = np.array([[800, 0, 320], [0, 800, 240], [0, 0, 1.0]])
    H = K @ np.array([[1, 0, 2], [0, 0.8, 1], [0, 0.6, 10]])
    np.testing.assert_allclose(H, [[800, 192, 4800], [0, 784, 3200], [0, 0.6, 10]])
    np.testing.assert_allclose(H @ [1, 0, 1], [5600, 3200, 10])
    says("800 & 192 & 4800\\\\ 0 & 784 & 3200\\\\ 0 & 0.6 & 10", "(5600, 3200, 10)", "(560, 320)")
    rows = plain.homography_constraints(H)
    B = np.linalg.inv(K).T @ np.linalg.inv(K)
    np.testing.assert_allclose(rows @ B[[0, 0, 1, 0, 1, 2], [0, 1, 1, 2, 2, 2]], 0, atol=1e-9)


def test_which_views_tell_what():
    def sigma(*views):
        found = poses.sigmas([n in views for n in range(1, 9)])
        return {name: 0.1 * value for name, value in found.items()}

    assert np.isinf([sigma(1, 2)[name] for name in ("fx", "k1")]).all()
    assert sigma(1, 2)["cx"] == about(3.3, 1)
    assert sigma(1, 2, 4)["fx"] == about(1.9, 1)
    assert sigma(1, 2, 4, 5)["k1"] == pytest.approx(0.0155, abs=1e-4)
    most = {n: sigma(1, 2, 4, 5, n)["k1"] for n in (3, 6, 7, 8)}
    assert (most[7], most[8]) == (about(0.0038, 4), about(0.0041, 4))
    assert min(most[3], most[6]) > 0.013
    says("± 3.3 px", "open to ± 1.9 px", "from 0.015 to 0.0038", "to 0.0041", "above 0.013")


def test_boards_that_face_the_camera():
    found = draw.tilted_views(np.radians(2))
    assert (found.K[0, 0], found.sigma["fx"]) == (about(549, 0), about(16, 0))
    others = [draw.tilted_views(np.radians(n)).rms for n in (2, 6, 12, 25)]
    assert np.ptp(others) < 0.001
    says("549 ± 16 px", "true $f_x = 560$ px")


def test_dots():
    found = draw.with_dots()
    assert found.K[0, 0] - 560 == about(-0.44, 2)
    assert 560 - found.K[0, 0] == about(0.437, 3)
    assert (560 - found.K[0, 0]) / found.sigma["fx"] == about(7.6, 1)
    centres, off = bad.DOTS.points(), []
    for R, t in bad._shot():
        rows = (centres @ R.T + t) @ bad.K.T
        ideal = rows[:, :2] / rows[:, 2:]
        bias = circle_bias(centres, bad.DOTS.diameter / 2, bad.K, R, t)
        off.append(
            np.subtract(*(distort_pixels(p, bad.K, bad.LENS) for p in (ideal + bias, ideal)))
        )
    assert cal.rms_error(np.vstack(off)) == about(0.18, 2)
    assert bad.DOTS.diameter == 18
    says("by 0.18 px for dots of 18 mm", "dots | $f$ off by 0.437 px, 7.6 times its")


def test_files_that_are_written(tmp_path):
    camera = StoredCamera(made.K, np.zeros(5), SIZE)
    assert set(FORMS.values()) == {".yml", ".m", ".yaml", ".json"}
    assert "kc = [" in write_camera(tmp_path / "camera.m", camera).read_text()
    says("It writes neither `.mat` (in MATLAB, run `camera.m`", "nor OCamCalib's file")


def test_focus_and_warmth():
    near = float(image_distance(6.0, 500.0))
    assert near == about(6.07, 2)
    assert (near / 6 - 1, 534 * (near / 6 - 1)) == (about(0.012, 3), about(6.5, 1))
    assert (using.LENS, using.FAR) == (6, 534)
    says("6.07 mm at half a metre: 1.2 % more, 6.5 px of 534")
    assert about(7, 0) == 30_000 * 23e-6 * 10
    says("23 millionths a degree", "30 mm by 7 µm in 10 degrees")


def test_computed_photographs_do_what_the_text_says_of_them():
    photographs = draw.computed_photographs()
    fitted = [detect_board(picture, draw.BOARD).points for picture in photographs]
    fx = [
        draw.opencv_calibration(views)[1][0, 0]
        for views in (fitted, draw.opencv_corners(photographs, 5))
    ]
    assert fx == [about(533.99, 2), about(533.89, 2)]
    assert made.K[0, 0] == 534
    says("where $f_x = 534$ px is known, the fit finds 533.99 px and the window of 5 px 533.89 px")
    wide = draw.opencv_corners(photographs, 11)
    spoilt = cal.calibrate(POINTS, wide, SIZE)
    assert np.flatnonzero(~cal.reject_views(spoilt.residuals, 2.0)).tolist() == [4]
    moved = np.linalg.norm(np.subtract(wide, fitted), axis=2)
    assert np.flatnonzero(moved.max(axis=1) > 0.5).tolist() == [4]
    K, poses_ = draw.closed_form(fitted)
    k1, _ = cal.initial_distortion(draw.without_lens(K, poses_), np.vstack(fitted), K)
    assert k1 < 0
    says("view 4 that corners slip (sections 2 and 9), and section 6 finds the right sign")
