"""Zhang's calibration: the minimum, from any start, for every model, and its uncertainty."""

import numpy as np
import pytest
from board_views import BOARD, SIZE, K, k, observe

from course_lib.calibration import (
    CameraModel,
    board_points,
    calibrate,
    refine_calibration,
    reprojection_residuals,
    residuals_and_jacobian,
)
from course_lib.calibration import model as calibration_model
from data_generators.board_observations import observe_board

ALL = calibration_model.COEFFICIENTS


class TestCalibrate:
    @pytest.mark.parametrize("count", [1, 2, 4, 5, 8, 12])
    def test_truth_comes_back(self, count):
        truth = np.array([-0.25, 0.1, 0.001, -8e-4, 0.02, 0.05, 0.02, 0.01, 1e-3, 5e-4, -1e-3, 0])
        seen = observe(k=truth[:count], views=12)
        found = calibrate(BOARD, seen.pixels, SIZE, CameraModel(coefficients=ALL[:count]))
        assert found.rms < 1e-6
        assert found.coefficients.shape == (count,)
        if count < 8:  # above and below the fraction bar nearly cancel
            np.testing.assert_allclose(found.K, K, atol=1e-4)
            np.testing.assert_allclose(found.coefficients, truth[:count], atol=1e-5)
            for (R, t), (R_truth, t_truth) in zip(found.poses, seen.poses, strict=True):
                np.testing.assert_allclose(R, R_truth, atol=1e-6)
                np.testing.assert_allclose(t, t_truth, atol=1e-3)

    def test_residuals_are_those_of_the_camera(self):
        seen = observe(noise=0.3)
        found = calibrate(BOARD, seen.pixels, SIZE)
        for pixels, pose, left in zip(seen.pixels, found.poses, found.residuals, strict=True):
            again = reprojection_residuals(BOARD, pixels, found.K, *pose, found.coefficients)
            np.testing.assert_allclose(left, again, atol=1e-9)
        lengths = np.linalg.norm(np.concatenate(found.residuals), axis=1)
        assert found.rms == pytest.approx(np.sqrt(np.mean(lengths**2)))
        assert found.rms == pytest.approx(0.3 * np.sqrt(2), rel=0.05)
        np.testing.assert_allclose(np.mean(found.view_rms**2), found.rms**2)

    def test_views_with_different_points(self):
        seen = observe(noise=0.3)
        boards = [BOARD[i:] for i in range(8)]
        ragged = [pixels[i:] for i, pixels in enumerate(seen.pixels)]
        found = calibrate(boards, ragged, SIZE)
        assert [len(left) for left in found.residuals] == [48, 47, 46, 45, 44, 43, 42, 41]
        one_by_one = np.concatenate(found.residuals)
        assert found.rms == pytest.approx(np.sqrt((one_by_one**2).sum(axis=1).mean()))
        whole = calibrate([BOARD.copy() for _ in range(8)], seen.pixels, SIZE)
        assert np.abs(found.K - whole.K).max() < 3 * whole.sigma["fx"]
        same = calibrate(BOARD, np.array(seen.pixels), SIZE)
        np.testing.assert_allclose(whole.K, same.K, atol=1e-6)

    def test_many_points_a_view(self):
        """The first steps take a part of the points; the last ones must take all."""
        dense = board_points(22, 14, 10)
        seen = observe_board(np.random.default_rng(1), dense, K, k, SIZE, 5, noise=0.2)
        found = calibrate(dense, seen.pixels, SIZE)
        left, J = residuals_and_jacobian(found, dense, seen.pixels)
        step = refine_calibration(np.zeros(J.shape[1]), left, J, damping=0)
        assert (np.abs(step[:9]) < 1e-4 * np.array(list(found.sigma.values()))).all()

    def test_opencv_shapes_are_taken(self):
        seen = observe(noise=0.1)
        theirs = [pixels[:, None] for pixels in seen.pixels]
        found = calibrate([BOARD[:, None]] * 8, theirs, SIZE)
        np.testing.assert_array_equal(found.K, calibrate(BOARD, seen.pixels, SIZE).K)

    def test_inputs_stay_as_they_are(self):
        seen = observe(noise=0.1)
        before = np.array(seen.pixels)
        calibrate(BOARD, seen.pixels, SIZE)
        np.testing.assert_array_equal(seen.pixels, before)


class TestModels:
    def test_square_pixels(self):
        seen = observe(K=np.array([[700.0, 0, 330], [0, 700, 250], [0, 0, 1]]), noise=0.2)
        found = calibrate(BOARD, seen.pixels, SIZE, CameraModel(square_pixels=True))
        assert found.K[0, 0] == found.K[1, 1]
        assert list(found.sigma)[:3] == ["fx", "cx", "cy"]
        assert abs(found.K[0, 0] - 700) < 4 * found.sigma["fx"]

    def test_ratio_of_a_start_is_kept(self):
        model = CameraModel(square_pixels=True)
        start = ([[650, 0, 320], [0, 650 * 720 / 700, 240], [0, 0, 1]], [0])
        found = calibrate(BOARD, observe(noise=0.2).pixels, SIZE, model, start)
        assert found.K[1, 1] / found.K[0, 0] == pytest.approx(720 / 700, rel=1e-12)
        assert found.rms < 0.3

    def test_what_is_not_free_stays(self):
        model = CameraModel(principal_point=False, coefficients=("k1", "k2"))
        found = calibrate(BOARD, observe(noise=0.2).pixels, SIZE, model)
        np.testing.assert_array_equal(found.K[:2, 2], [319.5, 239.5])  # the middle
        start = (K, [0, 0, 0.001, -0.0008, 0.02])
        found = calibrate(BOARD, observe(noise=0.2).pixels, SIZE, model, start)
        np.testing.assert_array_equal(found.K[:2, 2], K[:2, 2])
        np.testing.assert_array_equal(found.coefficients[2:], start[1][2:])
        assert found.coefficients[0] == pytest.approx(-0.25, abs=0.01)

    def test_one_tilted_view_is_enough_for_one_unknown(self):
        square = np.array([[700.0, 0, 319.5], [0, 700, 239.5], [0, 0, 1]])
        seen = observe(seed=4, views=1, K=square, k=[0], noise=0.05)
        model = CameraModel(square_pixels=True, principal_point=False, coefficients=())
        found = calibrate(BOARD, seen.pixels, SIZE, model)
        assert abs(found.K[0, 0] - 700) < 4 * found.sigma["fx"] < 40

    def test_errors(self):
        with pytest.raises(ValueError, match="each once"):
            CameraModel(coefficients=("k1", "k1"))
        with pytest.raises(ValueError, match="must be some of k1"):
            CameraModel(coefficients=("k9",))


class TestStart:
    @pytest.mark.parametrize("shift", [0, 400])
    @pytest.mark.parametrize("factor", [0.3, 0.5, 2, 5])
    def test_bad_starts_lead_to_the_same_minimum(self, factor, shift):
        seen = observe(noise=0.3, seed=5)
        start = (K * [[factor, 1, 1], [1, factor, 1], [1, 1, 1]], np.zeros(5))
        start[0][:2, 2] += shift
        found = calibrate(BOARD, seen.pixels, SIZE, start=start)
        best = calibrate(BOARD, seen.pixels, SIZE)
        assert found.rms == pytest.approx(best.rms, abs=1e-9)

    @pytest.mark.parametrize("factor", [0.7, 1.5])
    def test_moderate_starts_without_a_closed_form(self, factor):
        seen = observe(noise=0.3, seed=5)
        model = CameraModel(principal_point=False)
        start = (K * [[factor, 1, 1], [1, factor, 1], [1, 1, 1]], np.zeros(5))
        found = calibrate(BOARD, seen.pixels, SIZE, model, start)
        assert found.rms < 0.5


def test_sigma_is_the_scatter_of_many_calibrations():
    noiseless = observe(views=6)
    rng, runs, told = np.random.default_rng(11), [], []
    for _ in range(1000):
        pixels = [p + rng.normal(0, 0.3, p.shape) for p in noiseless.pixels]
        found = calibrate(BOARD, pixels, SIZE)
        runs.append([*found.K[[0, 1, 0, 1], [0, 1, 2, 2]], *found.coefficients, *found.poses[0][1]])
        told.append([*found.sigma.values(), *found.pose_sigma[0, 3:]])
    # The scatter of 200 runs is itself known to 5 % (one standard deviation), of 1000 to 2.2 %.
    for many, off in ((200, 0.1), (1000, 0.06)):
        usual = np.sqrt(np.mean(np.square(told[:many]), axis=0))
        np.testing.assert_allclose(usual / np.std(runs[:many], axis=0, ddof=1), 1, atol=off)
