"""Distortion against OpenCV: an implementation that is not ours."""

import cv2
import numpy as np
import pytest
from skimage.data import astronaut

from course_lib.distortion import (
    distort_pixels,
    distortion_jacobian,
    fisheye_project,
    fisheye_ray,
    undistort_pixels,
    undistort_points,
    undistortion_map,
)
from course_lib.remapping import packed_map, undistort_picture

SEEDS = range(12)
COUNTS = [4, 5, 8, 12]
SIZE = (640, 480)
ITERATIONS = (cv2.TERM_CRITERIA_COUNT, 200, 0)


def random_lens(seed, count):
    """Return intrinsics and a lens that is strong but far from folding over."""
    rng = np.random.default_rng(seed)
    K = np.array([[rng.uniform(500, 700), 0, 320], [0, rng.uniform(500, 700), 240], [0, 0, 1]])
    scale = [0.2, 0.05, 0.004, 0.004, 0.02, 0.05, 0.02, 0.01, 0.004, 0.004, 0.004, 0.004]
    return K, rng.uniform(-1, 1, count) * scale[:count]


def ideal_pixels(seed, count=300):
    return np.random.default_rng(seed).uniform((0, 0), SIZE, (count, 2))


def rays(pixels, K):
    return np.column_stack([pixels, np.ones(len(pixels))]) @ np.linalg.inv(K).T


@pytest.mark.parametrize("count", COUNTS)
@pytest.mark.parametrize("seed", SEEDS)
def test_distort_agrees(seed, count):
    (K, k), pixels = random_lens(seed, count), ideal_pixels(seed)
    theirs, _ = cv2.projectPoints(rays(pixels, K), np.zeros(3), np.zeros(3), K, k)
    np.testing.assert_allclose(distort_pixels(pixels, K, k), theirs[:, 0], atol=1e-10)


@pytest.mark.parametrize("count", COUNTS)
@pytest.mark.parametrize("seed", SEEDS)
def test_jacobian_agrees(seed, count):
    # OpenCV's derivative by the translation, of points at depth 1: J / 1 in its first two columns.
    (_, k), points = (
        random_lens(seed, count),
        np.random.default_rng(seed).uniform(-0.6, 0.6, (9, 2)),
    )
    ahead = np.column_stack([points, np.ones(9)])
    _, derivatives = cv2.projectPoints(ahead, np.zeros(3), np.zeros(3), np.eye(3), k)
    theirs = derivatives[:, 3:5].reshape(9, 2, 2)
    np.testing.assert_allclose(distortion_jacobian(points, k), theirs, atol=1e-12)


@pytest.mark.parametrize("count", COUNTS)
@pytest.mark.parametrize("seed", SEEDS)
def test_undistort_agrees(seed, count):
    K, k = random_lens(seed, count)
    pixels = distort_pixels(ideal_pixels(seed), K, k)
    theirs = cv2.undistortPoints(pixels[:, None], K, k, criteria=ITERATIONS)[:, 0]
    ours = undistort_points((pixels - K[:2, 2]) / np.diag(K)[:2], k)
    np.testing.assert_allclose(ours, theirs, atol=1e-12)
    new = np.array([[400.0, 0, 200], [0, 410, 210], [0, 0, 1]])
    theirs = cv2.undistortPoints(pixels[:, None], K, k, None, None, new, ITERATIONS)[:, 0]
    np.testing.assert_allclose(undistort_pixels(pixels, K, k, new), theirs, atol=1e-9)


@pytest.mark.parametrize("count", COUNTS)
@pytest.mark.parametrize("seed", range(4))
def test_map_agrees(seed, count):
    K, k = random_lens(seed, count)
    new = np.array([[450.0, 0, 300], [0, 460, 250], [0, 0, 1]])
    theirs = cv2.initUndistortRectifyMap(K, k, None, new, SIZE, cv2.CV_32FC1)
    ours = undistortion_map(K, k, SIZE, new)
    for one, other in zip(ours, theirs, strict=True):
        np.testing.assert_allclose(one, other, atol=1e-4)  # two units in the last place


def test_packed_map_agrees():
    maps = undistortion_map(*random_lens(1, 5), SIZE)
    theirs = cv2.convertMaps(*maps, cv2.CV_16SC2)
    for one, other in zip(packed_map(*maps), theirs, strict=True):
        np.testing.assert_array_equal(one, other)


@pytest.mark.parametrize("colour", [False, True])
@pytest.mark.parametrize("count", COUNTS)
@pytest.mark.parametrize("seed", range(4))
def test_undistorted_picture_agrees(seed, count, colour):
    K, k = random_lens(seed, count)
    image = cv2.resize(astronaut(), SIZE)
    image = image if colour else np.ascontiguousarray(image[..., 0])
    theirs = cv2.undistort(image, K, k).astype(int)
    assert np.abs(undistort_picture(image, K, k) - theirs).max() <= 1


class TestFisheye:
    K = np.array([[300.0, 0, 320], [0, 310, 240], [0, 0, 1]])

    @pytest.mark.parametrize("seed", SEEDS)
    def test_project_agrees(self, seed):
        rng = np.random.default_rng(seed)
        k = rng.uniform(-1, 1, 4) * [0.05, 0.01, 0.003, 0.0005]
        points = rng.uniform((-3, -3, 0.3), (3, 3, 2), (200, 3))
        theirs, _ = cv2.fisheye.projectPoints(points[:, None], np.zeros(3), np.zeros(3), self.K, k)
        ours = fisheye_project(points, self.K, k)
        seen = np.isfinite(ours[:, 0])  # OpenCV goes on beyond the fold
        assert seen.mean() > 0.7
        np.testing.assert_allclose(ours[seen], theirs[seen, 0], atol=1e-9)

    @pytest.mark.parametrize("seed", SEEDS)
    def test_ray_agrees(self, seed):
        rng = np.random.default_rng(seed)
        k = rng.uniform(-1, 1, 4) * [0.05, 0.01, 0.003, 0.0005]
        pixels = rng.uniform((100, 60), (540, 420), (200, 2))
        theirs = cv2.fisheye.undistortPoints(pixels[:, None], self.K, k)[:, 0]
        ours = fisheye_ray(pixels, self.K, k)
        np.testing.assert_allclose(ours[:, :2] / ours[:, 2:], theirs, atol=1e-6)
