"""The numbers that the text of chapter 07 states are those that the library computes."""

import sys

import numpy as np
import pytest
from lesson_text import lesson_text
from real_data import fetched

from course_lib import calibration as cal
from course_lib.boards import Checkerboard, DotGrid
from course_lib.detection import detect_board
from course_lib.detection.circles import circle_bias
from course_lib.distortion import distort_pixels
from course_lib.drawing import calibration as draw
from course_lib.drawing.calibration import photographs as made
from course_lib.drawing.calibration import using
from course_lib.drawing.distortion.boards import PHOTOGRAPHS
from course_lib.drawing.explorers import poses
from course_lib.drawing.explorers.detection import detection_frame
from course_lib.exercises import all_exercises
from course_lib.exercises.calibration import plain, plain_refinement
from course_lib.homography import homography_dlt
from course_lib.optics import image_distance

bad = sys.modules["course_lib.drawing.calibration.targets"]

TEXT = lesson_text("07_calibration")
says = TEXT.says
POINTS, SIZE = draw.BOARD.points(), draw.SIZE
PLANE = POINTS[:, :2]


def about(value, digits):
    """Return what agrees with a printed number of so many decimals."""
    return pytest.approx(value, abs=0.5001 * 10.0**-digits)


def read(frame, label):
    (found,) = (r for r in frame.readouts if r.label == label)
    return float(found.value.removeprefix("± "))


@pytest.fixture(scope="module")
def photographs():
    """Return the real photographs; skip where they are not to be had."""
    for name in PHOTOGRAPHS:
        fetched(name)
    return draw.left_photographs()


@pytest.fixture(scope="module")
def pixels(photographs):
    return [detect_board(picture, draw.BOARD).points for picture in photographs]


@pytest.fixture(scope="module")
def best(pixels):
    return cal.calibrate(POINTS, pixels, SIZE)


@pytest.fixture(scope="module")
def wide(photographs):
    return draw.opencv_corners(photographs, 11)


# What needs no photograph


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


# The photographs


def test_corners_by_three_ways(photographs, pixels, wide):
    ways = (wide, draw.opencv_corners(photographs, 5), pixels)
    by_eleven, by_five, by_fit = map(draw.opencv_calibration, ways)
    fx = [K[0, 0] for _, K, _ in (by_eleven, by_five, by_fit)]
    assert fx == [about(536.07, 2), about(532.83, 2), about(533.54, 2)]
    assert [found[0] for found in (by_eleven, by_five, by_fit)] == [
        about(0.409, 3),
        about(0.195, 3),
        about(0.159, 3),
    ]
    says("536.07 px or 532.83 px: the window alone moves the focal length by 3 px, nine times")
    near = np.linalg.norm(pixels[1][:, None] - pixels[1], axis=2)
    assert near[near > 0].min() == about(22, 0)
    slip = np.linalg.norm(wide[1] - pixels[1], axis=1)
    assert slip.argmax() == 45
    assert slip.max() == about(6.4, 1)
    moved = np.linalg.norm(np.subtract(wide, pixels), axis=2)
    assert np.unravel_index(moved.argmax(), moved.shape) == (1, 45)
    says("The squares are 22 px and more", "RMS 0.159 px against 0.195 px")
    assert fx[0] - fx[2] == about(2.5, 1)
    says("large window | $f$ off by 2.5 px")


def test_one_picture(pixels):
    middle = (np.array(SIZE) - 1) / 2
    squares = {}
    for view, seen in enumerate(pixels):
        H = homography_dlt(PLANE, seen)
        a, b = (H[:2, :2] / H[2, :2]).T - middle
        squares[view] = -a @ b
        if view == 7:
            assert a.round().tolist() == [433, -1552]
            assert b.round().tolist() == [-1863, -326]
    assert {view for view, square in squares.items() if square < 0} == {4, 6}
    f = sorted(np.sqrt(square) for view, square in squares.items() if square > 0 and view != 7)
    assert (np.sqrt(squares[7]), f[0], f[-1]) == (about(548, 0), about(509, 0), about(877, 0))
    assert about(300_700, -2) == 433 * 1863 - 1552 * 326
    says("$(433, -1552, f)$ and $(-1863, -326, f)$", "\\sqrt{300\\,700} = 548 \\text{ px}")
    says("509 to 877 px, and for views 4 and 6")


def test_the_closed_form(pixels, best):
    Hs = np.array([homography_dlt(PLANE, view) for view in pixels])
    three, all_views = (cal.intrinsics_from_homographies(Hs[:n]) for n in (3, 13))
    assert (three[0, 0], all_views[0, 0]) == (about(497, 0), about(539, 0))
    assert all_views[0, 1] == about(-2, 0)
    assert best.K[0, 0] == about(533.5, 1)
    np.testing.assert_allclose(np.diag(all_views) / np.diag(best.K), [1.01, 1.01, 1], atol=3e-3)
    assert np.linalg.norm((all_views - best.K)[:2, 2]) == pytest.approx(10, abs=1)
    says("$f$ is good to about 1 %, $c$ to 10 px")
    says("Three pictures say $f_x = 497$ px, thirteen say 539", "533.5", "$-2$ comes out")
    K, poses_ = draw.closed_form(pixels)
    depths = [t[2] / 10 for _, t in poses_]
    assert (min(depths), max(depths)) == (about(35, 0), about(50, 0))
    says("the first corner is 35 to 50 cm before the camera")
    seen = np.vstack(pixels)
    first = cal.initial_distortion(draw.without_lens(K, poses_), seen, K)
    good = cal.initial_distortion(draw.without_lens(best.K, best.poses), seen, best.K)
    assert first.tolist() == [about(0.068, 3), about(-0.723, 3)]
    assert good.tolist() == [about(-0.289, 3), about(0.108, 3)]
    says("$(-0.289, 0.108)$", "$(0.068, -0.723)$")
    assert draw.in_turns(pixels, 30)[29] == about(0.34, 2)
    says("After 30 rounds, 0.34 px are left", "1404 equations")
    assert 2 * sum(len(view) for view in pixels) == 1404


def test_the_refinement(pixels):
    K, poses_ = draw.closed_form(pixels)
    numbers, history = draw.packed(K, [0, 0], poses_), []
    for step in range(7):
        residuals, J = draw.residuals_and_derivatives(numbers, pixels)
        history.append(cal.rms_error(residuals.reshape(-1, 2)))
        numbers = cal.refine_calibration(numbers, residuals, J, 10.0 ** (-3 - step))
    assert J.shape == (1404, 84)
    assert np.mean(J == 0) == about(0.88, 2)
    says("Most of them are zero, 88 %")
    assert draw.in_turns(pixels, 1) == [about(2.75, 2)]
    says("It begins at 2.75 px, not 2.9 px")
    assert history[0] == about(2.9, 1)
    assert history[1] > 0.2 > history[2]
    np.testing.assert_allclose(history[4:], 0.1674, atol=5e-5)
    assert draw.in_turns(pixels, 7)[6] == about(1.07, 2)
    says("Two steps. After four", "0.167 px", "still 1.07 px", "6 + 13\\cdot 6 = 84")
    model = cal.CameraModel(coefficients=("k1", "k2"))
    found = cal.calibrate(POINTS, pixels, SIZE, model)
    np.testing.assert_allclose(numbers[:4], found.K[[0, 1, 0, 1], [0, 1, 2, 2]], atol=1e-3)


def test_the_same_minimum_as_opencv(pixels, best):
    rms, K, k = draw.opencv_calibration(pixels)
    assert best.rms == pytest.approx(rms, abs=1e-6)
    np.testing.assert_allclose(best.K, K, atol=1e-3)
    np.testing.assert_allclose(best.coefficients, k, atol=1e-4)


def test_zhangs_published_numbers():
    fetched("zhang/Model.txt")
    points, five = draw.zhang_data()
    model = cal.CameraModel(skew=True, coefficients=("k1", "k2"))
    found = cal.calibrate(points, five, (640, 480), model)
    (fx, s, cx), (_, fy, cy), _ = found.K
    assert (fx, fy) == (about(832.5, 1), about(832.53, 2))
    assert (s, found.sigma["s"]) == (about(0.204499, 6), about(0.08, 2))
    assert found.coefficients[1] == about(0.190354, 6)
    says("of $k_2$ (0.190354) and of the skew (0.204499)", "0.08 for the skew")
    assert (cx, cy) == (pytest.approx(303.959, abs=1e-3), pytest.approx(206.585, abs=1e-3))
    assert found.coefficients[:2].tolist() == [
        pytest.approx(-0.228601, abs=1.5e-6),
        pytest.approx(0.190353, abs=1.5e-6),
    ]
    says("832.53", "0.204494", "(303.959, 206.585)", "-0.228601", "0.190353")
    without = cal.calibrate(points, five, (640, 480), cal.CameraModel(skew=True, coefficients=()))
    assert without.K[0, 0] == about(867.3, 1)
    says("$f_x = 867.3$ px", "64 squares")
    assert len(points) == 4 * 64


def test_views_that_do_not_fit(wide, pixels):
    spoilt = cal.calibrate(POINTS, wide, SIZE)
    kept = cal.reject_views(spoilt.residuals, 2.0)
    assert np.flatnonzero(~kept).tolist() == [1, 11]
    assert spoilt.view_rms[1] == about(1.22, 2)
    left = cal.calibrate(POINTS, [v for v, k in zip(wide, kept, strict=True) if k], SIZE)
    assert left.K[0, 0] == about(533.46, 2)
    says("Views 1 and 11 go", "$f_x = 533.46$ px", "one view of 1.22 px")
    slips = np.linalg.norm(np.subtract(wide, pixels), axis=2)
    assert (slips > 0.5).sum(axis=1)[kept].tolist() == [0, 0, 0, 0, 0, 1, 0, 3, 0, 0, 0]
    assert slips[kept].max() == about(1.5, 1)
    says("in views 6 and 8, one and three corners have slipped too, by up to 1.5 px")


def test_standard_deviations(best, pixels):
    assert (best.K[0, 0], best.sigma["fx"]) == (about(533.54, 2), about(0.36, 2))
    assert best.sigma["fx"] / best.K[0, 0] == about(0.0007, 4)
    says("533.5 px, ± 0.4 px by chance alone")
    assert (best.coefficients[4], best.sigma["k3"]) == (about(0.148, 3), about(0.073, 3))
    says("$k_3 = 0.148 \\pm 0.073$", "two $\\sigma$ from zero")
    says("$f_x = 533.54 \\pm 0.36$ px, so 0.07 %", "0.7 mm at 1 m")
    assert (536.07 - 532.83) / best.sigma["fx"] == about(9, 0)
    residuals, J = cal.residuals_and_jacobian(best, POINTS, pixels)
    assert np.sqrt(residuals @ residuals / (J.shape[0] - J.shape[1])) == about(0.116, 3)
    assert best.rms == about(0.159, 3)
    says("0.116 px for the photographs", "0.159 px.)")
    C = plain_refinement.parameter_covariance(J, residuals)
    sigma = np.sqrt(np.diag(C))[: len(best.sigma)]
    np.testing.assert_allclose(sigma, list(best.sigma.values()), rtol=1e-6)


def test_more_and_more_views(pixels):
    from course_lib.drawing.calibration.judging import first_views

    two, every = first_views(pixels, 2), first_views(pixels, 13)
    assert (two.K[0, 0], two.sigma["fx"]) == (about(537.7, 1), about(0.8, 1))
    assert (two.K[0, 0] - every.K[0, 0]) / two.sigma["fx"] == about(5, 0)
    says("two views say 537.7 ± 0.8 px, and that is five $\\sigma$ from the end")


def test_the_longest_residual(best, wide):
    lengths = np.linalg.norm(best.residuals, axis=2)
    longest = np.argsort(lengths.ravel())[-2:]
    assert {divmod(int(n), 54) for n in longest} == {(7, 53), (8, 0)}
    assert lengths.ravel()[longest].tolist() == [about(0.43, 2)] * 2
    says("Corner 53 of view 7 and corner 0 of view 8, both 0.43 px")
    spoilt = np.linalg.norm(cal.calibrate(POINTS, wide, SIZE).residuals, axis=2)
    assert np.unravel_index(spoilt.argmax(), spoilt.shape) == (1, 45)
    assert spoilt.max() == about(4.81, 2)
    says("The longest, at corner 45, is 4.81 px")
    long = np.argwhere(spoilt > 0.8)
    assert set(long[:, 0].tolist()) == {1, 6, 8, 11}
    assert (long[:, 0] == 1).mean() > 0.7
    lower = np.sort(wide[1][:, 1])[-18:].min()  # two rows of nine, or three of six
    assert np.mean([wide[1][k, 1] >= lower - 60 for v, k in long if v == 1]) > 0.8
    says("Nearly all to view 1, a few to views 6, 8 and 11")


def test_rays_where_no_corner_was(best, pixels):
    seen = np.vstack(pixels)
    at = np.array([[320.0, 240], [0, 240], [0, 0], [0, 479]])
    middle, left, *corners = using.ray_sigma(best, at, seen)
    assert (middle, left) == (about(0.03, 2), about(1.4, 1))
    assert corners == [about(8.9, 1), about(9.6, 1)]
    assert best.rms == about(0.16, 2)
    says("0.03 px, in the middle of the left edge 1.4 px, and in the left corners 8.9 and 9.6 px!")
    says("RMS of 0.16 px", "rays off by 9 px in a corner")
    model = cal.CameraModel(coefficients=("k1", "k2"))
    fewer = using.ray_sigma(cal.calibrate(POINTS, pixels, SIZE, model), at, seen)
    assert fewer[1:].tolist() == [about(0.5, 1), about(1.8, 1), about(2.0, 1)]
    says("0.5 px at the left edge and 1.8 to 2.0 px in the left corners")


def test_models_on_pictures_held_out(pixels):
    from course_lib.drawing.calibration.judging import MODELS, model_errors

    found = {len(names): model_errors(pixels, names) for names in MODELS[1:]}
    own, others = zip(*found.values(), strict=True)
    assert (np.diff(own) < 0).all()
    assert min(others) > 0.998 * found[4][1]
    assert found[12][1] > 1.02 * found[4][1]
    assert (own[0], own[-1]) == (about(0.186, 3), about(0.158, 3))
    assert others[0] == about(0.194, 3)
    assert (found[4][1], found[12][1]) == (about(0.163, 3), about(0.168, 3))
    says("from 0.186 px to 0.158 px", "from 0.194 px to 0.163 px", "with twelve it is 0.168 px")
    assert list(found) == [1, 2, 4, 5, 8, 12]


def test_what_the_rms_does_not_show(best, pixels):
    half = cal.calibrate(POINTS, [view + 0.5 for view in pixels], SIZE)
    np.testing.assert_allclose(half.K - best.K, [[0, 0, 0.5], [0, 0, 0.5], [0, 0, 0]], atol=1e-4)
    assert half.rms == pytest.approx(best.rms, abs=1e-9)
    slipped = [view.copy() for view in pixels]
    slipped[4][53] += (10, 0)
    off = cal.calibrate(POINTS, slipped, SIZE)
    assert off.K[0, 2] - best.K[0, 2] == about(2.8, 1)
    assert (off.K[0, 2] - best.K[0, 2]) / best.sigma["cx"] == about(7, 0)
    assert off.view_rms[4] == about(1.26, 2)
    robust = cal.calibrate_robustly(POINTS, slipped, SIZE)
    assert robust.reasons == ("view 4: 1 of 54 points left out, up to 10.1 px off",)
    assert robust.calibration.K[0, 2] == pytest.approx(best.K[0, 2], abs=0.1)
    says(
        "$c$ off by 2.8 px, seven times its $\\sigma$ | a view of 1.26 px", "A single corner of 702"
    )


def test_corners_and_dots_of_the_sony_camera():
    model = cal.CameraModel(coefficients=("k1", "k2"))
    chess, dots = Checkerboard(4, 6, 30.0), DotGrid(8, 10, 25.0, 15.0)
    sets = {
        chess: [f"boofcv/Sony_DSC-HX5V_Chess/frame{n:02}.jpg" for n in range(1, 14)],
        dots: [f"boofcv/Sony_DSC-HX5V_CircleRegular/image{n:05}.jpg" for n in range(6)],
    }
    found = []
    for board, names in sets.items():
        for name in names:
            fetched(name)
        seen = [detect_board(made.grey_file(name), board).points for name in names]
        found.append(cal.calibrate(board.points(), seen, (640, 480), model))
    assert found[0].rms == pytest.approx(0.15, abs=0.01)
    assert found[1].rms == about(0.5, 1)
    assert [c.K[0, 0] for c in found] == [pytest.approx(702.5, abs=0.6), about(457, 0)]
    says("about 0.15 px at corners and 0.5 px at dots", "702 px at one setting and 457 px")
    np.testing.assert_allclose(np.diag(found[0].K)[:2], [701.0, 698.7], atol=2)  # as published
