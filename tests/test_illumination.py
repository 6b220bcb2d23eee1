import numpy as np
import pytest

from course_lib.illumination import (
    correct_lamp_drift,
    silhouette,
    silhouette_area,
    stripe_height,
)

# The lecture's back-lighted object.
FIELD = [
    [15, 15, 15, 15, 15, 15, 15, 15],
    [15, 15, 15, 15, 15, 15, 15, 15],
    [15, 1, 0, 15, 15, 0, 1, 15],
    [15, 1, 0, 10, 10, 0, 1, 15],
    [15, 1, 0, 0, 0, 0, 1, 15],
    [15, 1, 0, 0, 0, 0, 1, 15],
    [15, 1, 1, 1, 1, 1, 1, 15],
    [15, 15, 15, 15, 15, 15, 15, 15],
]


class TestSilhouette:
    def test_accuracy(self):
        # Counted by hand: 4 + 4 + 6 + 6 + 6 pixels; the two of value 10 depend on the threshold.
        assert silhouette_area(FIELD, 8, 1) == 26
        assert silhouette_area(FIELD, 12, 1) == 28
        assert silhouette_area(FIELD, 10, 1) == 26  # the threshold itself is background
        assert silhouette_area(FIELD, 8, 0.5) == 6.5
        assert silhouette_area(FIELD, 8, (0.5, 2)) == 26

    def test_mask(self):
        mask = silhouette(FIELD, 8)
        assert mask.dtype == bool
        assert silhouette_area(FIELD, 8, 2) == 4 * mask.sum()
        np.testing.assert_array_equal(mask[2], np.array([0, 1, 1, 0, 0, 1, 1, 0], bool))

    def test_shapes(self):
        assert type(silhouette_area(FIELD, 8, 1)) is float

    def test_errors(self):
        with pytest.raises(ValueError, match=r"must have shape \(rows, columns\), got \(3,\)"):
            silhouette_area([1, 2, 3], 8, 1)
        with pytest.raises(ValueError, match="a picture of grey values"):
            silhouette(np.zeros((2, 2, 3)), 8)
        with pytest.raises(ValueError, match="pixel_size must be positive"):
            silhouette_area(FIELD, 8, 0)
        with pytest.raises(ValueError, match=r"pixel_size \(width, height\) must have shape"):
            silhouette_area(FIELD, 8, (1, 2, 3))
        with pytest.raises(ValueError, match="threshold must be one number"):
            silhouette_area(FIELD, [8, 9], 1)


class TestStripe:
    @pytest.mark.parametrize("height", [-2, 0.5, 10])
    @pytest.mark.parametrize("camera", [-0.2, 0, 0.4])
    def test_accuracy(self, height, camera):
        # Light and line of sight are cut with planes; x points towards the light.
        light = 0.7
        x = height * np.tan(light)  # the sheet of light passes (0, 0) and (tan, 1)
        eye = np.array([-1000 * np.tan(camera), 1000.0]) + np.array([x, height])
        ray = np.array([x, height]) - eye
        on_table = (eye - ray * eye[1] / ray[1])[0]
        assert stripe_height(on_table, light, camera) == pytest.approx(height)

    def test_shapes(self):
        assert np.ndim(stripe_height(2, 0.5)) == 0
        assert stripe_height(np.ones((2, 3)), 0.5).shape == (2, 3)

    def test_flat_light_is_more_sensitive(self):
        steep, flat = stripe_height(1, 0.3), stripe_height(1, 1.2)
        assert flat < steep / 8

    @pytest.mark.parametrize("name", ["light_angle", "camera_angle"])
    def test_errors(self, name):
        angles = {"light_angle": 0.5, "camera_angle": 0.1, name: 45}
        with pytest.raises(ValueError, match=f"{name} must be less than a right angle, got 45"):
            stripe_height(1, **angles)

    def test_degenerate(self):
        for light, camera in ((0, 0), (0.4, -0.4)):
            with pytest.raises(ValueError, match="camera and light look along the same line"):
                stripe_height(1, light, camera)


class TestLampDrift:
    def test_round_trip(self):
        scene = np.random.default_rng(1).uniform(0, 200, (6, 8))
        new, old = 20 + scene, 20 + 0.85 * scene  # the lamp has lost 15 %
        patch = np.s_[:2, :2]
        mended = correct_lamp_drift(old, old[patch], new[patch], offset=20)
        np.testing.assert_allclose(mended, new)

    def test_errors(self):
        with pytest.raises(ValueError, match="the patch must be brighter than the offset"):
            correct_lamp_drift([1, 2], [5, 5], [9, 9], offset=5)
