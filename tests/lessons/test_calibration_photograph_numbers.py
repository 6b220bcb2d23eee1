"""Every number of chapter 07 that comes from the photographs, computed anew from them."""

import numpy as np
import pytest
from lesson_text import about, lesson_text
from real_data import fetched

from course_lib import calibration as cal
from course_lib.boards import Checkerboard, DotGrid
from course_lib.detection import detect_board
from course_lib.drawing import calibration as draw
from course_lib.drawing.calibration import photographs as made
from course_lib.drawing.calibration import using
from course_lib.drawing.distortion.boards import PHOTOGRAPHS
from course_lib.exercises.calibration import plain_refinement
from course_lib.homography import homography_dlt

TEXT = lesson_text("07_calibration")
says = TEXT.says
POINTS, SIZE = draw.BOARD.points(), draw.SIZE
PLANE = POINTS[:, :2]


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


def test_how_far_away_the_corners_were(best):
    depths = np.concatenate([(POINTS @ R.T + t)[:, 2] for R, t in best.poses]) / 10
    assert (depths.min(), depths.max()) == (about(25, 0), about(51, 0))
    says("thirteen boards are 25 to 51 cm before the camera", "**calibration volume**")


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
