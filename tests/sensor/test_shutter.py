import numpy as np
import pytest

from course_lib.sensor.shutter import fastest_speed, motion_blur_pixels, rolling_shutter_skew

FUNCTIONS = {
    motion_blur_pixels: (900, 0.002, 0.3),
    fastest_speed: (0.002, 0.3, 0.5),
    rolling_shutter_skew: (900, 2e-5, 700),
}


@pytest.mark.parametrize("function", FUNCTIONS)
class TestAllFunctions:
    @pytest.mark.parametrize("bad", [0, -1, np.nan, np.inf])
    def test_errors(self, function, bad):
        good = FUNCTIONS[function]
        for i in range(1, 3):
            with pytest.raises(ValueError, match=r"positive|finite"):
                function(*good[:i], bad, *good[i + 1 :])

    def test_shapes(self, function):
        good = FUNCTIONS[function]
        assert np.ndim(function(*good)) == 0
        assert function(np.full((2, 1), good[0]), np.full(3, good[1]), good[2]).shape == (2, 3)


class TestMotionBlur:
    def test_accuracy(self):
        # A point is followed through the exposure; the pixels that it visits are counted.
        way = 900 * np.linspace(0, 0.002, 1001)
        pixels = way / 0.3
        assert motion_blur_pixels(900, 0.002, 0.3) == pytest.approx(pixels.max() - pixels.min())
        assert motion_blur_pixels(0, 0.002, 0.3) == 0

    def test_round_trip(self):
        speed = fastest_speed(0.002, 0.3, [0.5, 2])
        np.testing.assert_allclose(motion_blur_pixels(speed, 0.002, 0.3), [0.5, 2])

    def test_errors(self):
        with pytest.raises(ValueError, match="speed must not be negative"):
            motion_blur_pixels(-1, 0.002, 0.3)


class TestRollingShutter:
    @pytest.mark.parametrize("speed", [-3000, 0, 3000])
    def test_accuracy(self, speed):
        # Row after row is read from a picture in which the edge has moved on.
        rows, row_time = 400, 5e-5
        seen = [100 + speed * row * row_time for row in range(rows + 1)]
        assert rolling_shutter_skew(speed, row_time, rows) == pytest.approx(seen[-1] - seen[0])
