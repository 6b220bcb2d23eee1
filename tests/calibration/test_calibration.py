"""Zhang's calibration: steps of the closed form, the minimum, and what does not determine it."""

import numpy as np
import pytest

from course_lib.calibration import (
    CameraModel,
    board_points,
    calibrate,
    homography_constraints,
    initial_distortion,
    intrinsics_from_homographies,
    parameter_covariance,
    pose_from_homography,
    refine_calibration,
    reprojection_residuals,
    residuals_and_jacobian,
)
from course_lib.calibration import model as calibration_model
from course_lib.calibration.derivatives import derivative_blocks, residuals
from course_lib.calibration.model import NAMES, State, rotations_from_vectors
from course_lib.calibration.views import gather_views
from course_lib.checks import DegenerateConfigurationError
from course_lib.distortion import distort_pixels
from course_lib.least_squares import levenberg_marquardt
from course_lib.transforms import rotation_from_vector
from data_generators.board_observations import observe_board

SIZE = (640, 480)
K = np.array([[700.0, 0, 330], [0, 720, 250], [0, 0, 1]])
k = np.array([-0.25, 0.1, 0.001, -0.0008, 0.02])
BOARD = board_points(8, 6, 30)
SKEW = np.array([[0, 5.0, 0], [0, 0, 0], [0, 0, 0]])
ALL = calibration_model.COEFFICIENTS


def observe(seed=0, views=8, noise=0.0, K=K, k=k, **how):
    return observe_board(np.random.default_rng(seed), BOARD, K, k, SIZE, views, noise, **how)


def homographies(seed=0, views=4, K=K):
    return np.array([K @ np.column_stack([R[:, :2], t]) for R, t in observe(seed, views).poses])


class TestClosedForm:
    def test_constraints_hold_for_the_camera(self):
        inverse = np.linalg.inv(K)
        B = inverse.T @ inverse
        b = B[[0, 0, 1, 0, 1, 2], [0, 1, 1, 2, 2, 2]]
        V = homography_constraints(homographies())
        assert V.shape == (4, 2, 6)
        np.testing.assert_allclose(V @ b, 0, atol=1e-9)
        np.testing.assert_array_equal(V[1], homography_constraints(homographies()[1]))

    @pytest.mark.parametrize("seed", range(5))
    def test_intrinsics_come_back(self, seed):
        skewed = K + SKEW
        scales = np.random.default_rng(seed).uniform(-3, 3, (4, 1, 1))
        found = intrinsics_from_homographies(scales * homographies(seed, K=skewed))
        np.testing.assert_allclose(found, skewed, rtol=1e-6, atol=1e-4)

    def test_two_views_without_skew(self):
        np.testing.assert_allclose(
            intrinsics_from_homographies(homographies(views=2)), K, rtol=1e-6, atol=1e-3
        )

    def test_poses_come_back(self):
        truth = observe().poses
        R, t = pose_from_homography(K, -2 * homographies(views=8))
        np.testing.assert_allclose(R, [pose[0] for pose in truth], atol=1e-9)
        np.testing.assert_allclose(t, [pose[1] for pose in truth], rtol=1e-9)

    def test_pose_is_a_rotation_in_spite_of_noise(self):
        H = homographies(views=1)[0]
        R, _ = pose_from_homography(K, H + 1e-2 * np.abs(H))
        np.testing.assert_allclose(R @ R.T, np.eye(3), atol=1e-12)
        assert np.linalg.det(R) == pytest.approx(1)

    def test_first_distortion(self):
        ideal = np.random.default_rng(0).uniform((0, 0), SIZE, (200, 2))
        skewed = K + SKEW
        found = initial_distortion(ideal, distort_pixels(ideal, skewed, [-0.2, 0.1]), skewed)
        np.testing.assert_allclose(found, [-0.2, 0.1], atol=1e-9)

    def test_errors(self):
        with pytest.raises(DegenerateConfigurationError, match="one view gives two equations"):
            intrinsics_from_homographies(homographies(views=1))
        with pytest.raises(DegenerateConfigurationError, match="boards are parallel"):
            intrinsics_from_homographies(homographies()[[0, 0, 0]])
        with pytest.raises(DegenerateConfigurationError, match="no camera makes these"):
            intrinsics_from_homographies(np.random.default_rng(3).normal(size=(3, 3, 3)))
        with pytest.raises(DegenerateConfigurationError, match="into a line"):
            pose_from_homography(K, np.ones((3, 3)))
        with pytest.raises(ValueError, match=r"H must have shape \(3, 3\)"):
            homography_constraints(np.eye(4))
        with pytest.raises(ValueError, match="as many points in rows"):
            initial_distortion(BOARD[:, :2], BOARD[:3, :2], K)
        with pytest.raises(ValueError, match="square must be positive, got 0"):
            board_points(9, 6, 0)
        with pytest.raises(ValueError, match="columns must be a whole number"):
            board_points(1, 6, 25)


class TestDerivatives:
    @pytest.mark.parametrize(
        "model",
        [
            CameraModel(skew=True, coefficients=ALL),
            CameraModel(square_pixels=True, principal_point=False),
            CameraModel(focal=False, coefficients=("k4", "k2")),
        ],
    )
    def test_agree_with_differences(self, model):
        seen = observe(views=3)
        views = gather_views(BOARD, seen.pixels)
        camera = np.array([700, 720, 4, 330, 250, -0.3, 0.1, 1e-3, -1e-3, 0.05, 0.1, 0.02, 0.01])
        camera = np.append(camera, [1e-3, 2e-3, -1e-3, 5e-4])
        R, t = (np.array(part) for part in zip(*seen.poses, strict=True))
        state, n = State(model, camera, R, t), len(model.names)
        (block,) = derivative_blocks(state, views)
        np.testing.assert_allclose(block[:, -1], residuals(state, views), atol=1e-9)
        for i in range(n + 6):
            h = 1e-6 * (max(abs(camera[NAMES.index(model.names[i])]), 0.1) if i < n else 1)
            step = h * np.eye(n + 6)[i]
            ahead, behind = (
                residuals(state.moved(s * step[:n], np.tile(s * step[n:], (3, 1))), views)
                for s in (1, -1)
            )
            np.testing.assert_allclose(
                block[:, i], (ahead - behind) / (2 * h), rtol=2e-5, atol=2e-4
            )

    def test_turns(self):
        vectors = np.random.default_rng(0).normal(size=(5, 3)) * [[1], [1e-3], [1e-9], [0], [3]]
        expected = [rotation_from_vector(vector) for vector in vectors]
        np.testing.assert_allclose(rotations_from_vectors(vectors), expected, atol=1e-14)

    def test_dense_form_leads_to_the_same_minimum(self):
        seen, model = observe(views=3, noise=0.3), CameraModel(coefficients=("k1", "k2"))
        found = calibrate(BOARD, seen.pixels, SIZE, model)
        left, J = residuals_and_jacobian(found, BOARD, seen.pixels)
        assert J.shape == (2 * 3 * len(BOARD), 6 + 6 * 3)
        np.testing.assert_allclose(left.reshape(-1, 2), np.concatenate(found.residuals), atol=1e-9)
        # Not downhill any more: a step by the whole matrix leads nowhere.
        step = refine_calibration(np.zeros(J.shape[1]), left, J, damping=0)
        assert (np.abs(step[:6]) < 1e-4 * np.array(list(found.sigma.values()))).all()

    def test_covariance_is_that_of_the_dense_form(self):
        seen, model = observe(views=4, noise=0.3), CameraModel(skew=True)
        found = calibrate(BOARD, seen.pixels, SIZE, model)
        left, J = residuals_and_jacobian(found, BOARD, seen.pixels)
        whole = parameter_covariance(J, left)
        n = len(found.sigma)
        np.testing.assert_allclose(found.covariance, whole[:n, :n], rtol=1e-4)
        np.testing.assert_allclose(found.pose_sigma.ravel() ** 2, np.diag(whole)[n:], rtol=1e-4)

    def test_general_solver_finds_the_same_minimum(self):
        """From the start of one camera, without any of the block elimination."""
        seen, model = observe(views=3, noise=0.3), CameraModel(coefficients=("k1",))
        views = gather_views(BOARD, seen.pixels)
        R, t = (np.array(part) for part in zip(*seen.poses, strict=True))
        start = State(model, np.array([650, 650, 0, 320, 240, *np.zeros(12)]), R, t)

        def problem(x):
            state = start.moved(x[:5], x[5:].reshape(3, 6))
            (block,) = derivative_blocks(state, views)
            rows, J = block.transpose(0, 3, 2, 1), np.zeros((3, len(BOARD), 2, 23))
            J[..., :5] = rows[..., :5]
            for i in range(3):
                J[i, ..., 5 + 6 * i : 11 + 6 * i] = rows[i, ..., 5:11]
            # About the poses of the start and not of the state, which is the same to first order.
            return rows[..., -1].ravel(), J.reshape(-1, 23)

        fit = levenberg_marquardt(problem, np.zeros(23))
        ours = calibrate(BOARD, seen.pixels, SIZE, model)
        assert np.sqrt(2 * np.mean(fit.residuals**2)) == pytest.approx(ours.rms, rel=1e-6)


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
    for _ in range(200):
        pixels = [p + rng.normal(0, 0.3, p.shape) for p in noiseless.pixels]
        found = calibrate(BOARD, pixels, SIZE)
        runs.append([*found.K[[0, 1, 0, 1], [0, 1, 2, 2]], *found.coefficients, *found.poses[0][1]])
        told.append([*found.sigma.values(), *found.pose_sigma[0, 3:]])
    ratio = np.sqrt(np.mean(np.square(told), axis=0)) / np.std(runs, axis=0, ddof=1)
    # The scatter of 200 runs is itself only known to 5 % (one standard deviation).
    assert np.abs(np.sqrt(np.mean(ratio**2)) - 1) < 0.1
    np.testing.assert_allclose(ratio, 1, atol=0.15)


class TestNotDetermined:
    def test_parallel_boards(self):
        seen = observe(tilt=0, k=[0])
        with pytest.raises(DegenerateConfigurationError, match="all boards are parallel"):
            calibrate(BOARD, seen.pixels, SIZE)

    @pytest.mark.parametrize("seed", range(5))
    def test_nearly_parallel_boards_with_noise(self, seed):
        """What noise makes of such views is no camera, and the message says what to do."""
        seen = observe(seed, tilt=0.01, noise=0.3, views=5)
        with pytest.raises(DegenerateConfigurationError, match="tilt the board by 20° to 45°"):
            calibrate(BOARD, seen.pixels, SIZE)

    @pytest.mark.parametrize("seed", range(5))
    def test_small_tilts_give_a_large_sigma(self, seed):
        found = calibrate(BOARD, observe(seed, tilt=0.1, noise=0.3, views=5).pixels, SIZE)
        assert found.sigma["fx"] > 5
        assert abs(found.K[0, 0] - K[0, 0]) < 4 * found.sigma["fx"]

    def test_the_better_of_two_minima(self):
        """Small tilts: from the closed form one comes to rest at f = 1659 px, RMS 0.51 px."""
        found = calibrate(BOARD, observe(3, tilt=0.03, noise=0.3, views=5).pixels, SIZE)
        assert found.rms < 0.4
        assert abs(found.K[0, 0] - K[0, 0]) < 4 * found.sigma["fx"]

    def test_too_few_views(self):
        pixels = observe().pixels
        with pytest.raises(DegenerateConfigurationError, match="there are no views"):
            calibrate(BOARD, [], SIZE)
        with pytest.raises(DegenerateConfigurationError, match="2 or more different views, got 1"):
            calibrate(BOARD, pixels[:1], SIZE)
        with pytest.raises(DegenerateConfigurationError, match="but some are the same"):
            calibrate(BOARD, [pixels[0]] * 5, SIZE)
        with pytest.raises(DegenerateConfigurationError, match="3 or more different views, got 2"):
            calibrate(BOARD, pixels[:2], SIZE, CameraModel(skew=True))

    def test_too_few_points(self):
        pixels = observe().pixels
        four = [0, 7, 40, 47]
        with pytest.raises(DegenerateConfigurationError, match="16 equations, but there are 21"):
            calibrate(BOARD[four], [p[four] for p in pixels[:2]], SIZE)
        with pytest.raises(DegenerateConfigurationError, match="the board has 3 points"):
            calibrate(BOARD[[0, 1, 8]], [p[[0, 1, 8]] for p in pixels], SIZE)

    def test_board_of_another_size(self):
        pixels = observe().pixels
        with pytest.raises(ValueError, match="view 0 has 48 pixels, but its board has 54 points"):
            calibrate(board_points(9, 6, 30), pixels, SIZE)
        with pytest.raises(DegenerateConfigurationError, match="columns and rows swapped"):
            calibrate(board_points(6, 8, 30), pixels, SIZE)
        with pytest.raises(ValueError, match="got 2 boards and 8 views"):
            calibrate([BOARD, BOARD], pixels, SIZE)

    def test_boards_that_are_none(self):
        pixels = observe().pixels
        with pytest.raises(DegenerateConfigurationError, match="is the side of a square 0"):
            calibrate(0 * BOARD, pixels, SIZE)
        with pytest.raises(DegenerateConfigurationError, match="lie on one line"):
            calibrate(BOARD * [1, 0, 0], pixels, SIZE)
        with pytest.raises(DegenerateConfigurationError, match="is not flat"):
            calibrate(BOARD + [0, 0, 1] * BOARD[:, :1], pixels, SIZE)

    def test_one_shuffled_view_is_named(self):
        pixels = observe().pixels
        pixels[3] = pixels[3][::-1].copy()  # a half turn is a picture of the board as well
        calibrate(BOARD, pixels, SIZE)
        pixels[3] = np.random.default_rng(0).permutation(pixels[3])
        with pytest.raises(DegenerateConfigurationError, match="pixels of view 3 are no picture"):
            calibrate(BOARD, pixels, SIZE)

    def test_a_view_on_a_line_is_named(self):
        pixels = observe().pixels
        pixels[5] = pixels[5] * [1, 0]
        with pytest.raises(DegenerateConfigurationError, match="view 5 has no homography"):
            calibrate(BOARD, pixels, SIZE)

    def test_bad_numbers(self):
        pixels = observe().pixels
        pixels[2] = pixels[2].copy()
        pixels[2][5] = np.nan
        with pytest.raises(ValueError, match="the pixels of view 2 must be finite, got NaN"):
            calibrate(BOARD, pixels, SIZE)
        with pytest.raises(ValueError, match="put a single view into a list"):
            calibrate(BOARD, pixels[0], SIZE)
        with pytest.raises(TypeError, match="image_points must be a sequence"):
            calibrate(BOARD, 5, SIZE)
        with pytest.raises(ValueError, match="all pixels of view 0 are the same"):
            calibrate(BOARD, [0 * p for p in pixels[:2]], SIZE)
        with pytest.raises(ValueError, match="image_size"):
            calibrate(BOARD, pixels[:2], (0, 480))
