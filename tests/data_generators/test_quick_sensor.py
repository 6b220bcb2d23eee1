import numpy as np
import pytest

from course_lib.sensor import SensorModel, expose, sensor_response
from data_generators.quick_sensor import QuickSensor, developed

SENSOR = SensorModel(quantum_efficiency=0.5, full_well=9_000, read_noise=10, gain=0.3, bits=12)
WHITE = 16_000.0
SIZE = (160, 120)


def flat(level, size=SIZE):
    return np.full((size[1], size[0], 3), level, np.uint8)


@pytest.fixture(scope="module")
def quick():
    return QuickSensor(SIZE, np.random.default_rng(1))


class TestQuickSensor:
    def test_shapes(self, quick):
        assert quick.numbers(flat(9), SENSOR, WHITE).dtype == np.uint16
        assert quick.numbers(flat(9)[..., 0], SENSOR, WHITE).shape == (120, 160)
        eight = SensorModel(gain=0.02, offset=8, bits=8)
        assert quick.numbers(flat(9), eight, WHITE).dtype == np.uint8

    @pytest.mark.parametrize("level", [0, 3, 40, 128, 200, 255])
    def test_is_what_the_sensor_does(self, quick, level):
        photons = np.full((120, 160, 3), level / 255 * WHITE)
        true = expose(photons, SENSOR, np.random.default_rng(2), 0.5)
        numbers = quick.numbers(flat(level), SENSOR, WHITE, exposure_time=0.5)
        assert numbers.mean() == pytest.approx(true.mean(), abs=0.5)
        assert numbers.std() == pytest.approx(true.std(), rel=0.02)
        mean = sensor_response(level / 255 * WHITE, SENSOR, 0.5)
        assert numbers.mean() == pytest.approx(mean, abs=0.5)

    @pytest.mark.parametrize("bits", [1, 4, 8, 10, 16])
    def test_range(self, quick, bits):
        sensor = SensorModel(gain=2**bits / 20_000, offset=0, bits=bits, read_noise=3000)
        picture = np.repeat(np.arange(160, dtype=np.uint8)[None, :, None], 120, axis=0)
        numbers = quick.numbers(np.repeat(picture, 3, axis=2), sensor, 40_000)
        assert numbers.min() == 0
        assert numbers.max() == 2**bits - 1

    def test_frames(self, quick):
        first, again, other = (quick.numbers(flat(90), SENSOR, WHITE, frame=k) for k in (1, 1, 2))
        np.testing.assert_array_equal(first, again)
        noise = np.stack([first, other]).reshape(2, -1).astype(float)
        assert abs(np.corrcoef(noise)[0, 1]) < 0.02

    def test_many_frames_differ(self, quick):
        seen = {quick.numbers(flat(90), SENSOR, WHITE, frame=k).tobytes() for k in range(500)}
        assert len(seen) == 500

    def test_errors(self, quick):
        with pytest.raises(ValueError, match=r"picture must be uint8 and \(160, 120\) px"):
            quick.numbers(flat(9, (120, 160)), SENSOR, WHITE)
        with pytest.raises(ValueError, match="white must not be negative"):
            quick.numbers(flat(9), SENSOR, -1)


class TestDeveloped:
    def test_round_trip(self, quick):
        silent = SensorModel(
            quantum_efficiency=0.5, full_well=8000, read_noise=0, dark_current=0, gain=0.4
        )
        for level in (0, 10, 255):
            shown = developed(quick.numbers(flat(level), silent, 16_000), silent)
            assert shown.dtype == np.uint8
            assert shown.mean() == pytest.approx(level, abs=0.6)

    def test_noise_below_the_offset_is_black(self):
        numbers = np.array([[0, 60, 64, 2000, 4095]], np.uint16)
        shown = developed(numbers, SensorModel(gain=1.0))
        np.testing.assert_array_equal(shown[0, :3], 0)
        assert shown[0, 4] == 255
