"""The pinhole camera against OpenCV: an implementation that is not ours."""

import cv2
import numpy as np
import pytest

from course_lib.camera import Camera, first_guess_intrinsics, project_pinhole
from course_lib.optics import field_of_view
from course_lib.transforms import compose, rotation_x, rotation_y, rotation_z

SEEDS = range(20)


def random_camera(rng):
    K = np.array([[rng.uniform(300, 3000), 0, 320], [0, rng.uniform(300, 3000), 240], [0, 0, 1]])
    R = cv2.Rodrigues(rng.normal(size=3))[0]
    return Camera(K, R, rng.normal(size=3), (640, 480))


def points_in_front(rng, camera):
    in_camera = rng.uniform((-3, -3, 0.5), (3, 3, 50), (100, 3))
    return (in_camera - camera.t) @ camera.R


@pytest.mark.parametrize("seed", SEEDS)
def test_project_agrees(seed):
    rng = np.random.default_rng(seed)
    camera = random_camera(rng)
    points = points_in_front(rng, camera)
    expected, _ = cv2.projectPoints(points, cv2.Rodrigues(camera.R)[0], camera.t, camera.K, None)
    np.testing.assert_allclose(camera.project(points), expected[:, 0], atol=1e-6)


@pytest.mark.parametrize("seed", SEEDS)
def test_project_pinhole_agrees(seed):
    rng = np.random.default_rng(seed)
    points = rng.uniform((-3, -3, 0.5), (3, 3, 50), (100, 3))
    f, c = rng.uniform(300, 3000, 2), rng.uniform(0, 480, 2)
    K = np.array([[f[0], 0, c[0]], [0, f[1], c[1]], [0, 0, 1]])
    expected, _ = cv2.projectPoints(points, np.zeros(3), np.zeros(3), K, None)
    np.testing.assert_allclose(project_pinhole(points, f, c), expected[:, 0], rtol=1e-12)


@pytest.mark.parametrize(("rotation", "axis"), [(rotation_x, 0), (rotation_y, 1), (rotation_z, 2)])
def test_rotations_agree(rotation, axis):
    for angle in np.linspace(-6, 6, 25):
        vector = np.zeros(3)
        vector[axis] = angle
        np.testing.assert_allclose(rotation(angle), cv2.Rodrigues(vector)[0], atol=1e-15)


@pytest.mark.parametrize("seed", SEEDS)
def test_compose_agrees(seed):
    rng = np.random.default_rng(seed)
    r1, t1, r2, t2 = rng.normal(size=(4, 3))
    r3, t3, *_ = cv2.composeRT(r1, t1, r2, t2)  # first 1, then 2
    R, t = compose(cv2.Rodrigues(r2)[0], t2, cv2.Rodrigues(r1)[0], t1)
    np.testing.assert_allclose(R, cv2.Rodrigues(r3)[0], atol=1e-12)
    np.testing.assert_allclose(t, t3[:, 0], atol=1e-12)


def test_field_of_view_agrees():
    K = first_guess_intrinsics(35, (36, 24), (6000, 4000))
    horizontal, vertical, focal, _, _ = cv2.calibrationMatrixValues(K, (6000, 4000), 36, 24)
    np.testing.assert_allclose(
        np.degrees(field_of_view(35, (36, 24)))[:2], (horizontal, vertical), atol=0.02
    )
    assert focal == pytest.approx(35)
