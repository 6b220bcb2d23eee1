import numpy as np
import pytest

from course_lib.camera import (
    Camera,
    camera_at,
    camera_centre,
)
from course_lib.transforms import look_at

K = np.array([[810.0, 3.0, 318.0], [0.0, 790.0, 242.0], [0.0, 0.0, 1.0]])


def a_camera():
    return camera_at((4, -3, 2), (0, 0, 0.5), K, (640, 480))


class TestCamera:
    def test_shapes(self):
        cam = a_camera()
        assert cam.project((0, 0, 0)).shape == (2,)
        assert cam.project(np.zeros((4, 3))).shape == (4, 2)
        assert cam.pixel_ray((0, 0)).shape == (3,)
        assert cam.pixel_ray(np.zeros((4, 2))).shape == (4, 3)
        assert cam.image_size == (640, 480)

    @pytest.mark.parametrize(
        ("change", "words"),
        [
            ({"K": np.eye(4)}, r"K must have shape \(3, 3\)"),
            ({"K": K.T}, r"K must be \[\[fx, s, cx\]"),
            ({"K": -K}, r"K must be \[\[fx, s, cx\]"),
            ({"R": 2 * np.eye(3)}, "not a rotation"),
            ({"t": np.zeros(4)}, r"t must have shape \(3,\)"),
            ({"image_size": (640, 0)}, "image_size must be positive"),
            ({"image_size": (640.5, 480)}, "whole pixels"),
        ],
    )
    def test_errors(self, change, words):
        good = {"K": K, "R": np.eye(3), "t": np.zeros(3), "image_size": (640, 480)}
        with pytest.raises(ValueError, match=words):
            Camera(**(good | change))

    def test_is_frozen(self):
        mine = K.copy()
        cam = Camera(mine, np.eye(3), np.zeros(3), (640, 480))
        mine[0, 0] = 1
        assert cam.K[0, 0] == 810
        for array in (cam.K, cam.R, cam.t, cam.P, cam.centre):
            with pytest.raises(ValueError, match="read-only"):
                array[0] = 1

    def test_round_trip(self):
        cam = a_camera()
        pixels = np.random.default_rng(0).uniform(0, 480, (50, 2))
        rays = cam.pixel_ray(pixels)
        np.testing.assert_allclose(np.linalg.norm(rays, axis=1), 1)
        seen = cam.project(cam.centre + 3.7 * rays)
        np.testing.assert_allclose(seen, pixels, atol=1e-9)

    def test_accuracy(self):
        # The target is seen in the principal point, and what stands above it higher up.
        uv = a_camera().project([(0, 0, 0.5), (0, 0, 0.7)])
        np.testing.assert_allclose(uv[0], K[:2, 2])
        assert uv[1, 1] < uv[0, 1]
        assert uv[1, 0] == pytest.approx(uv[0, 0], abs=0.2)  # the skew moves it a little

    def test_degenerate(self):
        cam = Camera(K, *look_at((0, -1, 0), (0, 0, 0)), (640, 480))
        behind = cam.project([(0, -2, 0), (5, -1, 3)])
        assert np.isnan(behind).all()

    def test_properties(self):
        cam = a_camera()
        np.testing.assert_allclose(cam.P, cam.K @ np.column_stack([cam.R, cam.t]))
        np.testing.assert_allclose(cam.centre, (4, -3, 2))
        np.testing.assert_allclose(cam.centre, camera_centre(cam.R, cam.t))
