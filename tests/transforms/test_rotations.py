"""Rotations as axis and angle, vectors, quaternions and three angles; poses as twists."""

import numpy as np
import pytest

from course_lib.checks import DegenerateConfigurationError
from course_lib.transforms import (
    check_rotation,
    euler_from_rotation,
    omega_phi_kappa_from_rotation,
    pose_from_twist,
    quaternion_from_rotation,
    rotation_about_axis,
    rotation_from_euler,
    rotation_from_omega_phi_kappa,
    rotation_from_quaternion,
    rotation_from_vector,
    rotation_x,
    rotation_y,
    rotation_z,
    skew,
    twist_from_pose,
    vector_from_rotation,
)
from course_lib.transforms.euler import ORDERS

#: Steps away from the angles where formulas break down.
STEPS = [0.0, *(10.0**-n for n in range(12, 2, -1)), 0.1]
#: Angles at and near no turn, a quarter turn and half a turn.
ANGLES = sorted(
    {
        abs(base + s * step)
        for base in (0, np.pi / 2, np.pi)
        for step in STEPS
        for s in (-1, 1)
        if base + s * step <= np.pi
    }
)


def random_axes(count=20):
    axes = np.random.default_rng(0).normal(size=(count, 3))
    return [*np.eye(3), *-np.eye(3), *(axes / np.linalg.norm(axes, axis=1, keepdims=True))]


class TestAxisAndAngle:
    def test_shapes(self):
        assert rotation_about_axis((0, 0, 1), 0.3).shape == (3, 3)
        assert rotation_about_axis([0, 1, 0], 1).dtype == np.float64
        assert skew((1, 2, 3)).shape == (3, 3)

    @pytest.mark.parametrize(
        ("axis", "angle", "words"),
        [
            ((0, 0, 0), 1, "axis is a zero vector, which points nowhere"),
            ((0, 0), 1, r"axis must have shape \(3,\), got \(2,\)"),
            ((0, 0, np.inf), 1, "axis must be finite"),
            ((0, 0, 1), [1, 2], r"angle must be one number"),
            ((0, 0, 1), np.nan, "angle must be finite"),
        ],
    )
    def test_errors(self, axis, angle, words):
        with pytest.raises(ValueError, match=words):
            rotation_about_axis(axis, angle)

    @pytest.mark.parametrize("axis", random_axes(8))
    def test_accuracy(self, axis):
        for angle in ANGLES:
            R = rotation_about_axis(7 * axis, angle)
            check_rotation(R, 1e-14)
            np.testing.assert_allclose(R @ axis, axis, atol=1e-14)
            # What is perpendicular turns by the angle, right-handed.
            side = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
            turned = np.cos(angle) * side + np.sin(angle) * np.cross(axis, side)
            np.testing.assert_allclose(R @ side, turned, atol=1e-14)

    def test_agrees_with_the_axes_of_the_frame(self):
        for axis, about in zip(np.eye(3), (rotation_x, rotation_y, rotation_z), strict=True):
            np.testing.assert_allclose(rotation_about_axis(axis, 0.7), about(0.7), atol=1e-15)

    def test_round_trip(self):
        for axis in random_axes(5):
            there, back = rotation_about_axis(axis, 0.9), rotation_about_axis(-axis, 0.9)
            np.testing.assert_allclose(there @ back, np.eye(3), atol=1e-15)

    def test_skew_multiplies(self):
        a, b = np.random.default_rng(1).normal(size=(2, 3))
        np.testing.assert_allclose(skew(a) @ b, np.cross(a, b), atol=1e-15)


class TestVector:
    def test_shapes(self):
        assert rotation_from_vector((0, 0, 0)).shape == (3, 3)
        assert vector_from_rotation(np.eye(3)).shape == (3,)

    def test_errors(self):
        with pytest.raises(ValueError, match=r"vector must have shape \(3,\), got \(3, 1\)"):
            rotation_from_vector([[1], [2], [3]])
        with pytest.raises(ValueError, match="reflection"):
            vector_from_rotation(-np.eye(3))

    @pytest.mark.parametrize("angle", ANGLES)
    def test_round_trip(self, angle):
        for axis in random_axes():
            vector = angle * axis
            back = vector_from_rotation(rotation_from_vector(vector))
            if angle == np.pi and back @ vector < 0:
                back = -back  # the same half turn
            np.testing.assert_allclose(back, vector, rtol=0, atol=1e-12)
            R = rotation_about_axis(axis, angle)
            np.testing.assert_allclose(rotation_from_vector(vector_from_rotation(R)), R, atol=1e-12)

    def test_accuracy(self):
        # Small turns keep their relative accuracy too.
        for size in (1e-3, 1e-8, 1e-12):
            vector = size * np.array([0.6, -0.0, 0.8])
            back = vector_from_rotation(rotation_from_vector(vector))
            np.testing.assert_allclose(back, vector, rtol=1e-12)
        np.testing.assert_allclose(
            rotation_from_vector([3, -1, 2]),
            rotation_about_axis([3, -1, 2], np.sqrt(14)),
            atol=1e-15,
        )

    def test_degenerate(self):
        np.testing.assert_array_equal(rotation_from_vector((0, 0, 0)), np.eye(3))
        np.testing.assert_array_equal(vector_from_rotation(np.eye(3)), np.zeros(3))
        for half_turn in (np.diag([1, -1, -1]), np.diag([-1, 1, -1]), np.diag([-1, -1, 1])):
            vector = vector_from_rotation(half_turn)
            assert np.linalg.norm(vector) == pytest.approx(np.pi)
            np.testing.assert_allclose(rotation_from_vector(vector), half_turn, atol=1e-15)


class TestQuaternion:
    def test_shapes(self):
        assert rotation_from_quaternion((1, 0, 0, 0)).shape == (3, 3)
        assert quaternion_from_rotation(np.eye(3)).shape == (4,)

    def test_errors(self):
        with pytest.raises(ValueError, match="quaternion is a zero vector"):
            rotation_from_quaternion((0, 0, 0, 0))
        with pytest.raises(ValueError, match=r"quaternion must have shape \(4,\), got \(3,\)"):
            rotation_from_quaternion((0, 0, 1))

    def test_accuracy(self):
        # The real part comes first: cos and sin of half the angle.
        q = quaternion_from_rotation(rotation_z(0.8))
        np.testing.assert_allclose(q, (np.cos(0.4), 0, 0, np.sin(0.4)), atol=1e-15)
        np.testing.assert_allclose(
            rotation_from_quaternion((0, 3, 0, 0)), np.diag([1, -1, -1]), atol=1e-15
        )

    @pytest.mark.parametrize("angle", ANGLES)
    def test_round_trip(self, angle):
        for axis in random_axes():
            R = rotation_about_axis(axis, angle)
            q = quaternion_from_rotation(R)
            assert q[0] >= 0
            assert np.linalg.norm(q) == pytest.approx(1)
            np.testing.assert_allclose(rotation_from_quaternion(q), R, atol=1e-12)
            np.testing.assert_allclose(rotation_from_quaternion(-3 * q), R, atol=1e-12)


class TestEuler:
    def test_shapes(self):
        assert rotation_from_euler((0.1, 0.2, 0.3)).shape == (3, 3)
        assert euler_from_rotation(np.eye(3)).shape == (3,)

    def test_errors(self):
        with pytest.raises(ValueError, match=r"order must be one of xyz, .*, got 'zyz'"):
            rotation_from_euler((1, 2, 3), "zyz")
        with pytest.raises(ValueError, match="order must be one of"):
            euler_from_rotation(np.eye(3), "ZYX")
        with pytest.raises(ValueError, match=r"angles must have shape \(3,\)"):
            rotation_from_euler((1, 2))

    def test_accuracy(self):
        yaw, pitch, roll = 0.3, -0.4, 0.5
        expected = rotation_z(yaw) @ rotation_y(pitch) @ rotation_x(roll)
        np.testing.assert_allclose(rotation_from_euler((yaw, pitch, roll)), expected)

    @pytest.mark.parametrize("order", ORDERS)
    def test_round_trip(self, order):
        rng = np.random.default_rng(2)
        for _ in range(50):
            angles = rng.uniform((-3.1, -1.5, -3.1), (3.1, 1.5, 3.1))
            R = rotation_from_euler(angles, order)
            np.testing.assert_allclose(euler_from_rotation(R, order), angles, atol=1e-12)

    @pytest.mark.parametrize("order", ORDERS)
    @pytest.mark.parametrize("step", [1e-3, 1e-5, 1e-8])
    def test_round_trip_near_gimbal_lock(self, order, step):
        # The angles become uncertain, the rotation that they stand for must not.
        for side in (-1, 1):
            R = rotation_from_euler((0.7, side * (np.pi / 2 - step), -1.1), order)
            again = rotation_from_euler(euler_from_rotation(R, order), order)
            np.testing.assert_allclose(again, R, atol=1e-12)

    @pytest.mark.parametrize("order", ORDERS)
    @pytest.mark.parametrize("second", [np.pi / 2, -np.pi / 2])
    def test_degenerate(self, order, second):
        R = rotation_from_euler((0.7, second, -1.1), order)
        with pytest.raises(DegenerateConfigurationError, match=f"gimbal lock: .* {order[1]} is"):
            euler_from_rotation(R, order)


class TestOmegaPhiKappa:
    def test_shapes(self):
        assert rotation_from_omega_phi_kappa(0.1, 0.2, 0.3).shape == (3, 3)
        assert omega_phi_kappa_from_rotation(np.diag([1, -1, -1])).shape == (3,)

    def test_errors(self):
        with pytest.raises(ValueError, match="finite"):
            rotation_from_omega_phi_kappa(0, np.inf, 0)
        with pytest.raises(ValueError, match="not a rotation"):
            omega_phi_kappa_from_rotation(np.ones((3, 3)))

    def test_round_trip(self):
        rng = np.random.default_rng(3)
        for _ in range(50):
            angles = rng.uniform((-3.1, -1.5, -3.1), (3.1, 1.5, 3.1))
            R = rotation_from_omega_phi_kappa(*angles)
            check_rotation(R, 1e-14)
            np.testing.assert_allclose(omega_phi_kappa_from_rotation(R), angles, atol=1e-12)

    def test_accuracy(self):
        # An aerial picture: with zeros, east is right, north is up, the ground is ahead.
        R = rotation_from_omega_phi_kappa(0, 0, 0)
        np.testing.assert_array_equal(R @ [1, 0, 0], [1, 0, 0])
        np.testing.assert_array_equal(R @ [0, 1, 0], [0, -1, 0])
        np.testing.assert_array_equal(R @ [0, 0, -1], [0, 0, 1])
        # kappa turns the camera counter-clockwise: north then is to the right in the picture.
        north = rotation_from_omega_phi_kappa(0, 0, np.pi / 2) @ [0, 1, 0]
        np.testing.assert_allclose(north, [1, 0, 0], atol=1e-15)

    def test_collinearity_equations_are_the_same_camera(self):
        """The textbook's rotation matrix, written out, and its two equations in the image."""
        o, p, k = angles = 0.03, -0.05, 0.8
        co, so, cp, sp, ck, sk = *_cs(o), *_cs(p), *_cs(k)
        world_from_image = np.array(
            [
                [cp * ck, -cp * sk, sp],
                [co * sk + so * sp * ck, co * ck - so * sp * sk, -so * cp],
                [so * sk - co * sp * ck, so * ck + co * sp * sk, co * cp],
            ]
        )
        centre, c = np.array([500.0, 800, 1200]), 150.0
        ground = np.random.default_rng(4).uniform((0, 0, -20), (900, 900, 60), (20, 3))
        # x' = -c a / n and y' = -c b / n, on axes that point right and up.
        a, b, n = world_from_image.T @ (ground - centre).T
        right, up = -c * a / n, -c * b / n
        X, Y, Z = rotation_from_omega_phi_kappa(*angles) @ (ground - centre).T
        np.testing.assert_allclose((c * X / Z, c * Y / Z), (right, -up))


def _cs(angle):
    return np.cos(angle), np.sin(angle)


class TestTwist:
    def test_shapes(self):
        R, t = pose_from_twist((0.1, 0, 0), (1, 2, 3))
        assert R.shape == (3, 3)
        assert t.shape == (3,)
        assert [part.shape for part in twist_from_pose(R, t)] == [(3,), (3,)]

    def test_errors(self):
        with pytest.raises(ValueError, match=r"velocity must have shape \(3,\)"):
            pose_from_twist((0, 0, 0), (1, 2))
        with pytest.raises(ValueError, match=r"t must have shape \(3,\)"):
            twist_from_pose(np.eye(3), (1, 2))

    def test_accuracy(self):
        # Many small steps along the screw end at the same pose.
        vector, velocity = np.array([0.4, -0.9, 1.3]), np.array([1.0, 2.0, -0.5])
        step = np.eye(4)
        step[:3] += np.column_stack([skew(vector), velocity]) / 2**20
        many = np.linalg.matrix_power(step, 2**20)
        R, t = pose_from_twist(vector, velocity)
        np.testing.assert_allclose(many[:3], np.column_stack([R, t]), atol=1e-5)

    @pytest.mark.parametrize("angle", ANGLES)
    def test_round_trip(self, angle):
        velocity = np.array([1.0, -2.0, 3.0])
        for axis in random_axes():
            R, t = pose_from_twist(angle * axis, velocity)
            vector, back = twist_from_pose(R, t)
            if angle == np.pi and vector @ axis < 0:
                continue  # the other of the two half turns has another velocity
            np.testing.assert_allclose(vector, angle * axis, atol=1e-12)
            np.testing.assert_allclose(back, velocity, atol=1e-12)

    def test_degenerate(self):
        # Without a turn the velocity is the way; along the axis it stays so.
        np.testing.assert_array_equal(pose_from_twist((0, 0, 0), (1, 2, 3))[1], (1, 2, 3))
        np.testing.assert_allclose(pose_from_twist((0, 0, 2), (0, 0, 3))[1], (0, 0, 3))
