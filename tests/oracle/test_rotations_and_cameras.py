"""Rotations, poses and camera matrices against SciPy and OpenCV: implementations not ours."""

import cv2
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from course_lib.camera import camera_matrix, decompose_projection, pixel_ray, project
from course_lib.homogeneous import apply_homography, from_homogeneous, to_homogeneous
from course_lib.transforms import (
    euler_from_rotation,
    pose_from_twist,
    quaternion_from_rotation,
    rotation_about_axis,
    rotation_from_euler,
    rotation_from_quaternion,
    rotation_from_vector,
    vector_from_rotation,
)
from course_lib.transforms.euler import ORDERS

SEEDS = range(20)
#: Lengths of rotation vectors: everywhere, and where formulas break down.
ANGLES = [1e-12, 1e-9, 1e-6, 1e-3, 0.5, 2.0, *(np.pi - 10.0**-n for n in (3, 6, 9, 12))]


def random_vectors(seed):
    axes = np.random.default_rng(seed).normal(size=(len(ANGLES), 3))
    return np.array(ANGLES)[:, None] * axes / np.linalg.norm(axes, axis=1, keepdims=True)


def random_camera(rng):
    K = np.array([[rng.uniform(300, 3000), rng.normal(), 320], [0, 900, 240], [0, 0, 1]])
    return K, Rotation.random(rng=rng).as_matrix(), rng.normal(size=3)


@pytest.mark.parametrize("seed", SEEDS)
def test_rodrigues_agrees(seed):
    for vector in random_vectors(seed):
        R, angle = cv2.Rodrigues(vector)[0], np.linalg.norm(vector)
        np.testing.assert_allclose(rotation_from_vector(vector), R, atol=1e-14)
        np.testing.assert_allclose(rotation_about_axis(vector, angle), R, atol=1e-14)


@pytest.mark.parametrize("seed", SEEDS)
def test_logarithm_agrees(seed):
    for vector in random_vectors(seed):
        R = Rotation.from_rotvec(vector).as_matrix()
        np.testing.assert_allclose(vector_from_rotation(R), vector, atol=1e-12)


@pytest.mark.parametrize("seed", SEEDS)
def test_quaternions_agree(seed):
    for vector in random_vectors(seed):
        theirs = Rotation.from_rotvec(vector)
        q = theirs.as_quat(canonical=True, scalar_first=True)
        np.testing.assert_allclose(quaternion_from_rotation(theirs.as_matrix()), q, atol=1e-13)
        np.testing.assert_allclose(rotation_from_quaternion(q), theirs.as_matrix(), atol=1e-14)


@pytest.mark.parametrize("order", ORDERS)
def test_euler_angles_agree(order):
    rng = np.random.default_rng(0)
    for _ in range(20):
        angles = rng.uniform((-3, -1.5, -3), (3, 1.5, 3))
        theirs = Rotation.from_euler(order.upper(), angles)  # capitals: axes that turn along
        np.testing.assert_allclose(
            rotation_from_euler(angles, order), theirs.as_matrix(), atol=1e-14
        )
        ours = euler_from_rotation(theirs.as_matrix(), order)
        np.testing.assert_allclose(ours, theirs.as_euler(order.upper()), atol=1e-12)


@pytest.mark.parametrize("seed", SEEDS)
def test_exponential_of_a_pose_agrees(seed):
    from scipy.linalg import expm

    vector, velocity = np.random.default_rng(seed).normal(size=(2, 3))
    x, y, z = vector
    generator = np.zeros((4, 4))
    generator[:3] = np.column_stack([[[0, -z, y], [z, 0, -x], [-y, x, 0]], velocity])
    np.testing.assert_allclose(
        np.column_stack(pose_from_twist(vector, velocity)), expm(generator)[:3], atol=1e-13
    )


@pytest.mark.parametrize("seed", SEEDS)
def test_projection_agrees(seed):
    rng = np.random.default_rng(seed)
    K, R, t = random_camera(rng)
    K[0, 1] = 0  # OpenCV's function knows no skew
    points = (rng.uniform((-3, -3, 0.5), (3, 3, 50), (1000, 3)) - t) @ R
    theirs, _ = cv2.projectPoints(points, cv2.Rodrigues(R)[0], t, K, None)
    np.testing.assert_allclose(project(points, camera_matrix(K, R, t)), theirs[:, 0], atol=1e-8)


def test_many_points_before_a_usual_camera_agree_to_a_billionth_of_a_pixel():
    K = np.array([[1000.0, 0, 640], [0, 1010, 480], [0, 0, 1]])
    turn, t = np.array([0.1, 0.2, 0.3]), np.array([0.1, 0.2, 5.0])
    points = np.random.default_rng(0).uniform(-1, 1, (100_000, 3))
    theirs, _ = cv2.projectPoints(points, turn, t, K, None)
    ours = project(points, camera_matrix(K, cv2.Rodrigues(turn)[0], t))
    np.testing.assert_allclose(ours, theirs[:, 0], rtol=0, atol=1e-9)


@pytest.mark.parametrize("seed", SEEDS)
def test_decomposition_agrees(seed):
    K, R, t = random_camera(np.random.default_rng(seed))
    P = camera_matrix(K, R, t) * 2.5
    theirs = cv2.decomposeProjectionMatrix(P)
    ours = decompose_projection(P)
    np.testing.assert_allclose(ours[0], theirs[0] / theirs[0][2, 2], rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(ours[1], theirs[1], atol=1e-10)
    np.testing.assert_allclose(ours[2], (theirs[2][:3] / theirs[2][3])[:, 0], atol=1e-9)


@pytest.mark.parametrize("seed", SEEDS)
def test_rays_agree(seed):
    rng = np.random.default_rng(seed)
    K, R, t = random_camera(rng)
    K[0, 1] = 0
    pixels = rng.uniform(0, 480, (20, 2))
    ahead = cv2.undistortPoints(pixels[:, None], K, None)[:, 0]
    theirs = np.column_stack([ahead, np.ones(20)]) @ R
    theirs /= np.linalg.norm(theirs, axis=1, keepdims=True)
    np.testing.assert_allclose(pixel_ray(pixels, K, R, t)[1], theirs, atol=1e-9)


def test_homogeneous_coordinates_agree():
    points = np.random.default_rng(0).normal(size=(20, 3))
    theirs = cv2.convertPointsFromHomogeneous(points)[:, 0]
    np.testing.assert_allclose(from_homogeneous(points), theirs)
    theirs = cv2.convertPointsToHomogeneous(points[:, :2])[:, 0]
    np.testing.assert_array_equal(to_homogeneous(points[:, :2]), theirs)


def test_projective_transformation_agrees():
    rng = np.random.default_rng(1)
    points, H = rng.normal(size=(20, 2)), rng.normal(size=(3, 3))
    theirs = cv2.perspectiveTransform(points[:, None], H)[:, 0]
    np.testing.assert_allclose(apply_homography(points, H), theirs, rtol=1e-9)
