import numpy as np
import pytest

from course_lib.camera.projection import camera_matrix, project
from course_lib.checks import DegenerateConfigurationError
from course_lib.detection.circles import circle_bias, distorted_circle_bias, image_of_circles
from course_lib.distortion import distort_pixels
from course_lib.transforms.rotations import rotation_about_axis

K = np.array([[560.0, 2, 320], [0, 550, 240], [0, 0, 1]])
R = rotation_about_axis((1, 2, 0.3), 0.7)
T = np.array([-20.0, 10, 400])
CENTRES = np.array([(0.0, 0, 0), (80, 40, 0), (-60, 50, 0)])


def outline(centre, radius, count=4000):
    turn = np.arange(count) * 2 * np.pi / count
    rim = centre + radius * np.stack([np.cos(turn), np.sin(turn), 0 * turn], axis=1)
    return project(rim, camera_matrix(K, R, T))


def centroid(polygon):
    """Of the area inside, by Green's theorem."""
    x, y = polygon.T
    x1, y1 = np.roll(polygon, -1, axis=0).T
    cross = x * y1 - x1 * y
    return np.array([((x + x1) * cross).sum(), ((y + y1) * cross).sum()]) / (3 * cross.sum())


def test_outlines_lie_on_the_conics():
    H = K @ np.column_stack([R[:, :2], T])
    for centre, conic in zip(CENTRES, image_of_circles(H, CENTRES[:, :2], 15.0), strict=True):
        pixels = np.column_stack([outline(centre, 15.0), np.ones(4000)])
        values = np.einsum("ni,ij,nj->n", pixels, conic, pixels)
        assert np.abs(values).max() < 1e-9 * np.abs(conic).max() * 640**2


def test_bias_is_that_of_the_area():
    bias = circle_bias(CENTRES, 15.0, K, R, T)
    pictures = project(CENTRES, camera_matrix(K, R, T))
    measured = np.array([centroid(outline(centre, 15.0)) for centre in CENTRES]) - pictures
    np.testing.assert_allclose(bias, measured, atol=1e-4)
    assert np.linalg.norm(bias, axis=1).max() > 0.1


def test_no_bias_head_on():
    np.testing.assert_allclose(circle_bias(CENTRES, 15.0, K, np.eye(3), T), 0, atol=1e-9)


def test_grows_with_the_area():
    small, large = (circle_bias(CENTRES, radius, K, R, T) for radius in (1.0, 2.0))
    np.testing.assert_allclose(large, 4 * small, rtol=1e-3)


def test_degenerate():
    with pytest.raises(DegenerateConfigurationError, match="behind the camera"):
        circle_bias([(0, 0, 0)], 50.0, K, rotation_about_axis((1, 0, 0), 1.5), (0, 0, 40))


class TestThroughALens:
    LENS = (-0.3, 0.1, 0.001, 0.0005, 0)

    def test_without_distortion_as_without_lens(self):
        expected = circle_bias(CENTRES, 15.0, K, R, T)
        np.testing.assert_allclose(
            distorted_circle_bias(CENTRES, 15.0, K, R, T, [0]), expected, atol=2e-4
        )

    def test_is_that_of_the_area(self):
        rims = [outline(centre, 15.0) for centre in CENTRES]
        bent = [distort_pixels(rim, K, self.LENS) for rim in rims]
        middles = distort_pixels(project(CENTRES, camera_matrix(K, R, T)), K, self.LENS)
        measured = np.array([centroid(rim) for rim in bent]) - middles
        bias = distorted_circle_bias(CENTRES, 15.0, K, R, T, self.LENS)
        np.testing.assert_allclose(bias, measured, atol=5e-4)
        assert np.abs(bias - circle_bias(CENTRES, 15.0, K, R, T)).max() > 0.02

    def test_behind_the_camera(self):
        with pytest.raises(DegenerateConfigurationError, match="behind the camera"):
            distorted_circle_bias([(0, 0, 0)], 5, K, R, (0, 0, 1), [0])


def test_errors():
    with pytest.raises(ValueError, match="radius must be positive"):
        circle_bias(CENTRES, 0, K, R, T)
    with pytest.raises(ValueError, match=r"centres must have shape \(N, 3\)"):
        circle_bias(CENTRES[:, :2], 5, K, R, T)
