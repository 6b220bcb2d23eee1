import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from course_lib import transforms
from course_lib.transforms import check_rotation, rotation_x, rotation_y, rotation_z

AXES = np.eye(3)
ROTATIONS = [(rotation_x, 0), (rotation_y, 1), (rotation_z, 2)]
angles = st.floats(-10, 10)


class TestRotations:
    @pytest.mark.parametrize(("rotation", "axis"), ROTATIONS)
    def test_shapes(self, rotation, axis):
        assert rotation(0.3).shape == (3, 3)
        assert rotation(0.3).dtype == np.float64
        np.testing.assert_array_equal(rotation(0), AXES)

    @pytest.mark.parametrize(("rotation", "axis"), ROTATIONS)
    @pytest.mark.parametrize(
        ("angle", "error"), [(np.nan, ValueError), ([0.1, 0.2], ValueError), ("30°", TypeError)]
    )
    def test_errors(self, rotation, axis, angle, error):
        with pytest.raises(error, match="angle"):
            rotation(angle)

    @pytest.mark.parametrize(("rotation", "axis"), ROTATIONS)
    def test_round_trip(self, rotation, axis):
        np.testing.assert_allclose(rotation(0.7) @ rotation(-0.7), AXES, atol=1e-15)

    @pytest.mark.parametrize(("rotation", "axis"), ROTATIONS)
    def test_accuracy(self, rotation, axis):
        # A quarter turn leaves its axis and takes each other axis to the next one, right-handed.
        after, then = (axis + 1) % 3, (axis + 2) % 3
        turned = rotation(np.pi / 2) @ AXES
        np.testing.assert_allclose(turned[:, axis], AXES[axis], atol=1e-15)
        np.testing.assert_allclose(turned[:, after], AXES[then], atol=1e-15)
        np.testing.assert_allclose(turned[:, then], -AXES[after], atol=1e-15)

    @given(angles, angles, angles)
    def test_fuzz(self, a, b, c):
        check_rotation(rotation_x(a) @ rotation_y(b) @ rotation_z(c), 1e-12)


class TestCheckRotation:
    def test_shapes(self):
        assert check_rotation(np.eye(3, dtype=int)).dtype == np.float64
        with pytest.raises(ValueError, match=r"\(3, 3\), got \(4, 4\)"):
            check_rotation(np.eye(4))

    @pytest.mark.parametrize(
        ("matrix", "words"),
        [
            (np.eye(3) * 0.9, "not a rotation: R Rᵀ differs"),
            (np.diag([1, 1, -1]), "reflection"),
            (np.full((3, 3), 1e70), "not a rotation"),
            (np.full((3, 3), np.nan), "finite"),
        ],
    )
    def test_errors(self, matrix, words):
        with pytest.raises(ValueError, match=words):
            check_rotation(matrix)

    def test_accuracy(self):
        matrix = rotation_x(0.2)
        matrix[0, 0] += 1e-4
        check_rotation(matrix, 1e-3)
        with pytest.raises(ValueError, match=r"differs from the identity by 0\.0002"):
            check_rotation(matrix)


EYE, ZERO, ONES = np.eye(3), np.zeros(3), np.ones(3)
#: Each public function with arguments that it takes.
CALLS = {
    "camera_centre": (EYE, ZERO),
    "compose": (EYE, ZERO, EYE, ZERO),
    "skew": (ONES,),
    "cv_from_graphics_camera": (np.eye(4),),
    "euler_from_rotation": (EYE,),
    "gimbal_pose": (0.1, 0.2, ONES, ZERO),
    "invert_pose": (EYE, ZERO),
    "look_at": (ONES, ZERO, (0, 0, 1)),
    "omega_phi_kappa_from_rotation": (EYE,),
    "pose_from_matrix": (np.eye(4),),
    "pose_from_placement": (EYE, ZERO),
    "pose_from_twist": (ONES, ZERO),
    "quaternion_from_rotation": (EYE,),
    "rigid_matrix": (EYE, ZERO),
    "rotation_about_axis": (ONES, 0.1),
    "rotation_from_euler": (ONES,),
    "rotation_from_omega_phi_kappa": (0.1, 0.2, 0.3),
    "rotation_from_quaternion": (np.ones(4),),
    "rotation_from_vector": (ONES,),
    "rotation_x": (0.1,),
    "rotation_y": (0.1,),
    "rotation_z": (0.1,),
    "transform_points": (ONES, EYE, ZERO),
    "twist_from_pose": (EYE, ZERO),
    "vector_from_rotation": (EYE,),
}


@pytest.mark.parametrize("name", sorted({*transforms.__all__} - {"check_rotation"}))
@pytest.mark.parametrize(
    ("bad", "words"),
    [
        (lambda good: np.full_like(good, np.nan, dtype=float), "must be finite"),
        (lambda good: np.zeros((2, 7)), "must (have shape|be one number)"),
    ],
    ids=["nan", "shape"],
)
def test_every_argument_is_checked(name, bad, words):
    function, good = getattr(transforms, name), CALLS[name]
    function(*good)
    for i, argument in enumerate(good):
        with pytest.raises(ValueError, match=words):
            function(*good[:i], bad(argument), *good[i + 1 :])
