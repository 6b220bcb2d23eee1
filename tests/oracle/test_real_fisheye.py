"""A real fisheye camera: its photographs, and what was published of it."""

import cv2
import numpy as np
import pytest
import yaml
from real_data import fetched
from scipy.optimize import least_squares

from course_lib import data, distortion
from course_lib.boards import Checkerboard
from course_lib.calibration import pose_from_homography
from course_lib.detection import detect_board
from course_lib.drawing.distortion import real_fisheye
from course_lib.homography import homography_dlt
from course_lib.transforms import rotation_from_vector, vector_from_rotation

FOLDER = "boofcv/fisheye_chessboard"


def mei_project(points, published):
    """Mei and Rives: onto the unit sphere, then from a point ξ behind its centre."""
    x, y, z = (points / np.linalg.norm(points, axis=1, keepdims=True)).T
    m = np.stack([x, y], axis=1) / (z + published["mirror_offset"])[:, None]
    r2 = (m**2).sum(axis=1, keepdims=True)
    k1, k2 = published["radial_tangential"]["radial"]
    pinhole = published["pinhole"]
    f, c = ([pinhole[name] for name in names] for names in (("fx", "fy"), ("cx", "cy")))
    return m * (1 + k1 * r2 + k2 * r2**2) * f + c


@pytest.fixture(scope="module")
def published():
    """The calibration that its owners give with the fisheye photographs."""
    return yaml.safe_load(fetched(f"{FOLDER}/fisheye.yaml").read_text())


def test_published_fisheye_in_the_form_of_kannala_and_brandt(published):
    K, k = real_fisheye.kannala_brandt()
    around, angle = np.meshgrid(np.arange(8), np.radians([0.0, 5, 30, 60, 85, 90]))
    side = np.sin(angle)
    rays = np.stack([side * np.cos(around), side * np.sin(around), np.cos(angle)], axis=-1)
    pixels = distortion.fisheye_project(rays.reshape(-1, 3), K, k)
    # It has one focal length for both directions; theirs differ by 0.006 px.
    np.testing.assert_allclose(pixels, mei_project(rays.reshape(-1, 3), published), atol=5e-3)


def test_finds_every_board_and_the_published_camera_fits(published):
    """To each of the 26 photographs only the pose is fitted; the camera stays as published."""
    K, k = real_fisheye.kannala_brandt()
    board, left = Checkerboard(4, 6, 30), []
    for name in (n for n in data.names(FOLDER) if n.endswith(".jpg")):
        found = detect_board(cv2.imread(str(fetched(name)))[..., ::-1], board)
        assert found.good, name
        points, rays = board.points()[found.ids], distortion.fisheye_ray(found.points, K, k)
        H = homography_dlt(points[:, :2], rays[:, :2] / rays[:, 2:])
        R, t = pose_from_homography(np.eye(3), H)

        def missed(pose, points=points, seen=found.points):
            moved = points @ rotation_from_vector(pose[:3]).T + pose[3:]
            return (mei_project(moved, published) - seen).ravel()

        start = [*vector_from_rotation(R), *t]
        pose = least_squares(missed, start, x_scale="jac").x
        left.append(np.linalg.norm(missed(pose).reshape(-1, 2), axis=1))
    assert len(left) == 26
    # With corners of cornerSubPix it is 0.19 to 0.22 px, for windows of 7 to 3 px.
    assert np.median(np.concatenate(left)) == pytest.approx(0.177, abs=0.005)
