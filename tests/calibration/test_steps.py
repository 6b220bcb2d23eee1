"""The steps of Zhang's calibration: its closed form, its derivatives, its covariance."""

import numpy as np
import pytest
from board_views import BOARD, SIZE, K, observe

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

SKEW = np.array([[0, 5.0, 0], [0, 0, 0], [0, 0, 0]])
ALL = calibration_model.COEFFICIENTS


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
