import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from course_lib.checks import DegenerateConfigurationError
from course_lib.transforms import (
    camera_centre,
    check_rotation,
    compose,
    cv_from_graphics_camera,
    gimbal_pose,
    invert_pose,
    look_at,
    pose_from_matrix,
    pose_from_placement,
    rigid_matrix,
    rotation_x,
    rotation_y,
    rotation_z,
    transform_points,
)

numbers = st.one_of(st.just(0.0), st.floats(1e-6, 1e6), st.floats(-1e6, -1e-6))
vectors = st.tuples(numbers, numbers, numbers)


def random_pose(rng):
    a, b, c = rng.uniform(-3, 3, 3)
    return rotation_x(a) @ rotation_y(b) @ rotation_z(c), rng.normal(size=3)


class TestLookAt:
    def test_shapes(self):
        R, t = look_at((1, 2, 3), (0, 0, 0))
        assert R.shape == (3, 3)
        assert t.shape == (3,)

    def test_errors(self):
        with pytest.raises(ValueError, match=r"target must have shape \(3,\), got \(2,\)"):
            look_at((1, 2, 3), (0, 0))
        with pytest.raises(ValueError, match="eye must be finite"):
            look_at((1, np.inf, 3), (0, 0, 0))

    def test_accuracy(self):
        # From the south, looking north: east is right, up is up (-y), north is ahead.
        R, t = look_at(eye=(0, -5, 1), target=(0, 0, 1))
        np.testing.assert_allclose(R @ [1, 0, 0], [1, 0, 0], atol=1e-15)
        np.testing.assert_allclose(R @ [0, 0, 1], [0, -1, 0], atol=1e-15)
        np.testing.assert_allclose(R @ [0, 1, 0], [0, 0, 1], atol=1e-15)
        np.testing.assert_allclose(R @ [0, 0, 1] + t, [0, 0, 5], atol=1e-15)

    def test_degenerate(self):
        with pytest.raises(DegenerateConfigurationError, match="coincide"):
            look_at((1, 2, 3), (1, 2, 3))
        with pytest.raises(DegenerateConfigurationError, match="along up"):
            look_at((0, 0, 3), (0, 0, 0))
        with pytest.raises(DegenerateConfigurationError, match="along up"):
            look_at((0, 0, 3), (1, 0, 0), up=(0, 0, 0))

    @given(vectors, vectors, vectors)
    def test_fuzz(self, eye, target, up):
        try:
            R, t = look_at(eye, target, up)
        except DegenerateConfigurationError:
            return
        check_rotation(R)
        scale = max(1, np.linalg.norm(eye), np.linalg.norm(target))
        distance = np.linalg.norm(np.subtract(target, eye))
        np.testing.assert_allclose(R @ target + t, [0, 0, distance], atol=1e-9 * scale)
        assert (R @ up)[1] <= 1e-9 * np.linalg.norm(up)


class TestPoses:
    def test_shapes(self):
        R, t = random_pose(np.random.default_rng(1))
        assert transform_points((1, 2, 3), R, t).shape == (3,)
        assert transform_points(np.ones((5, 3)), R, t).shape == (5, 3)
        assert transform_points(np.ones((0, 3)), R, t).shape == (0, 3)
        assert camera_centre(R, t).shape == (3,)

    @pytest.mark.parametrize(
        ("points", "words"),
        [
            (np.ones((3, 2)), r"points must have shape \(N, 3\) or \(3,\), got \(3, 2\)"),
            ([[1, 2, np.nan]], "points must be finite"),
            ([[1, 2, 3], [1, 2]], "different lengths"),
        ],
    )
    def test_errors(self, points, words):
        with pytest.raises(ValueError, match=words):
            transform_points(points, np.eye(3), np.zeros(3))

    def test_errors_of_poses(self):
        with pytest.raises(ValueError, match=r"t must have shape \(3,\), got \(3, 1\)"):
            camera_centre(np.eye(3), np.zeros((3, 1)))
        with pytest.raises(ValueError, match="not a rotation"):
            invert_pose(2 * np.eye(3), np.zeros(3))
        with pytest.raises(TypeError, match="t_bc must be real numbers"):
            compose(np.eye(3), np.zeros(3), np.eye(3), ["a", "b", "c"])

    def test_round_trip(self):
        R, t = random_pose(np.random.default_rng(2))
        X = np.random.default_rng(3).normal(size=(7, 3))
        there = transform_points(X, R, t)
        np.testing.assert_allclose(transform_points(there, *invert_pose(R, t)), X, atol=1e-14)

    def test_accuracy(self):
        rng = np.random.default_rng(4)
        a_from_b, b_from_c, X = random_pose(rng), random_pose(rng), rng.normal(size=(7, 3))
        np.testing.assert_allclose(
            transform_points(X, *compose(*a_from_b, *b_from_c)),
            transform_points(transform_points(X, *b_from_c), *a_from_b),
            atol=1e-14,
        )
        # The centre is the point that the pose takes to the origin.
        np.testing.assert_allclose(
            transform_points(camera_centre(*a_from_b), *a_from_b), np.zeros(3), atol=1e-15
        )

    def test_inputs_stay_as_they_are(self):
        R, t = random_pose(np.random.default_rng(5))
        X = np.ones((2, 3))
        copies = R.copy(), t.copy(), X.copy()
        transform_points(X, R, t)
        invert_pose(R, t)
        for array, copy in zip((R, t, X), copies, strict=True):
            np.testing.assert_array_equal(array, copy)


class TestRigidMatrix:
    def test_shapes(self):
        assert rigid_matrix().shape == (4, 4)
        R, t = pose_from_matrix(np.eye(4))
        assert R.shape == (3, 3)
        assert t.shape == (3,)

    @pytest.mark.parametrize(
        ("matrix", "words"),
        [
            (np.eye(3), r"matrix must have shape \(4, 4\), got \(3, 3\)"),
            (rigid_matrix(t=(1, 2, 3)).T, "last row of a pose must be 0 0 0 1.*transposed"),
            (np.diag([2, 2, 2, 1]), "R is not a rotation"),
            (np.diag([1, 1, -1, 1]), "reflection"),
        ],
    )
    def test_errors(self, matrix, words):
        for function in (pose_from_matrix, cv_from_graphics_camera):
            with pytest.raises(ValueError, match=words):
                function(matrix)

    def test_round_trip(self):
        R, t = random_pose(np.random.default_rng(6))
        again = pose_from_matrix(rigid_matrix(R, t))
        np.testing.assert_array_equal(again[0], R)
        np.testing.assert_array_equal(again[1], t)

    def test_accuracy(self):
        # Composing poses is multiplying matrices, inverting is inverting.
        rng = np.random.default_rng(7)
        a_from_b, b_from_c = random_pose(rng), random_pose(rng)
        product = rigid_matrix(*a_from_b) @ rigid_matrix(*b_from_c)
        np.testing.assert_allclose(product, rigid_matrix(*compose(*a_from_b, *b_from_c)))
        inverse = np.linalg.inv(rigid_matrix(*a_from_b))
        np.testing.assert_allclose(rigid_matrix(*invert_pose(*a_from_b)), inverse, atol=1e-15)


class TestPlacing:
    def test_shapes(self):
        R, t = random_pose(np.random.default_rng(8))
        placements = [
            pose_from_placement(R, t),
            cv_from_graphics_camera(rigid_matrix(R, t)),
            gimbal_pose(0.1, 0.2, t, t),
        ]
        for R, t in placements:
            assert R.shape == (3, 3)
            assert t.shape == (3,)

    def test_errors(self):
        with pytest.raises(ValueError, match="not a rotation"):
            pose_from_placement(np.ones((3, 3)), (0, 0, 0))
        with pytest.raises(ValueError, match=r"centre must have shape \(3,\), got \(2,\)"):
            pose_from_placement(np.eye(3), (0, 0))
        with pytest.raises(ValueError, match="angle must be one number"):
            gimbal_pose([0.1, 0.2], 0, (0, 0, 0), (0, 0, 0))
        with pytest.raises(ValueError, match=r"t must have shape \(3,\)"):
            gimbal_pose(0.1, 0.2, (0, 0, 0), (0, 0))

    def test_round_trip(self):
        R_camera, centre = random_pose(np.random.default_rng(9))
        pose = pose_from_placement(R_camera, centre)
        np.testing.assert_allclose(camera_centre(*pose), centre)
        np.testing.assert_allclose(pose[0].T, R_camera)
        np.testing.assert_allclose(
            rigid_matrix(*pose), rigid_matrix(*invert_pose(R_camera, centre))
        )

    def test_accuracy_of_a_graphics_camera(self):
        # As in Blender: the default camera turned up by a quarter turn about x looks north.
        matrix = rigid_matrix(rotation_x(np.pi / 2), (0, -5, 1))
        ours, expected = cv_from_graphics_camera(matrix), look_at((0, -5, 1), (0, 0, 1))
        np.testing.assert_allclose(ours[0], expected[0], atol=1e-15)
        np.testing.assert_allclose(ours[1], expected[1], atol=1e-15)

    def test_accuracy_of_a_graphics_camera_point_by_point(self):
        R_camera, centre = random_pose(np.random.default_rng(10))
        X = np.random.default_rng(11).normal(size=(6, 3))
        x, y, z = R_camera.T @ (X - centre).T  # as the graphics camera measures them
        seen = transform_points(X, *cv_from_graphics_camera(rigid_matrix(R_camera, centre)))
        np.testing.assert_allclose(seen.T, (x, -y, -z))

    def test_accuracy_of_a_gimbal(self):
        mount, pan, tilt = np.array([1.0, 2, 3]), 0.5, 0.3
        R, t = gimbal_pose(pan, tilt, mount, (0, 0, 0))
        # It stays upright, looks `tilt` above the horizon and `pan` to the left of north.
        forward = (-np.sin(pan) * np.cos(tilt), np.cos(pan) * np.cos(tilt), np.sin(tilt))
        expected = look_at(mount, mount + forward)
        np.testing.assert_allclose(R, expected[0], atol=1e-15)
        np.testing.assert_allclose(t, expected[1], atol=1e-15)

    def test_gimbal_carries_the_camera_round(self):
        # 0.1 m to the right of the axes and 0.3 m ahead of them, turned to the left by 90 degrees.
        pose = gimbal_pose(np.pi / 2, 0, (5, 5, 5), (0.1, 0, 0.3))
        np.testing.assert_allclose(camera_centre(*pose), (5 - 0.3, 5.1, 5))
        # Looking straight up, what was ahead is above.
        pose = gimbal_pose(0, np.pi / 2, (5, 5, 5), (0.1, 0, 0.3))
        np.testing.assert_allclose(camera_centre(*pose), (5.1, 5, 5.3))

    def test_degenerate(self):
        for function in (pose_from_placement, invert_pose):
            with pytest.raises(ValueError, match="reflection"):
                function(np.diag([1, 1, -1]), (0, 0, 0))
