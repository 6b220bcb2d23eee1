import numpy as np
import pytest

from course_lib.checks import DegenerateConfigurationError
from course_lib.sensor.detector import expose
from course_lib.sensor.photon_transfer import (
    camera_gain_from_pairs,
    clipped_fraction,
    dynamic_range,
    flat_field,
    signal_to_noise,
)
from course_lib.sensor.sensor_model import SensorModel

SENSOR = SensorModel(0.5, 30_000, read_noise=7, dark_current=5, gain=0.4, offset=120, bits=12)
SHAPE = (120, 130)


def rng():
    return np.random.default_rng(11)


def picture_pairs(sensor, shares, unevenness=0.0):
    draw = rng()
    even = 1 + unevenness * draw.standard_normal(SHAPE)
    levels = np.multiply(shares, sensor.saturation / sensor.quantum_efficiency)
    photons, dark = levels[:, None, None] * even, np.zeros(SHAPE)
    bright = [expose(photons, sensor, draw) for _ in range(2)]
    return *bright, *(expose(dark, sensor, draw) for _ in range(2)), sensor.white


class TestSignalToNoise:
    def test_shapes(self):
        assert np.ndim(signal_to_noise(100, SENSOR)) == 0
        assert signal_to_noise(np.ones((2, 3)), SENSOR).shape == (2, 3)

    @pytest.mark.parametrize("photons", [60, 600, 15_000])
    @pytest.mark.parametrize("seconds", [0, 30])
    def test_accuracy(self, photons, seconds):
        # Many simulated pictures of one pixel, their dark offset known.
        drawn = expose(np.full(100_000, float(photons)), SENSOR, rng(), seconds).astype(float)
        signal = drawn.mean() - 120 - 0.4 * 5 * seconds
        expected = signal_to_noise(photons, SENSOR, seconds)
        assert signal / drawn.std() == pytest.approx(expected, rel=0.03)

    def test_limits(self):
        # Four times the light: twice the ratio where photons rule, four times where readout does.
        bright = signal_to_noise([5000, 20_000], SENSOR)
        assert bright[1] / bright[0] == pytest.approx(2, rel=0.02)
        dim = signal_to_noise([0.1, 0.4], SENSOR)
        assert dim[1] / dim[0] == pytest.approx(4, rel=0.01)
        assert signal_to_noise(0, SENSOR, 100) == 0

    def test_errors(self):
        with pytest.raises(ValueError, match="photons must not be negative"):
            signal_to_noise(-1, SENSOR)

    def test_gain_before_digitising_beats_brightening_afterwards(self):
        # 8 coarse bits: a step of the digitiser is many electrons unless the amplifier comes first.
        coarse = SensorModel(0.6, 15_000, read_noise=3, gain=0.016, offset=8, bits=8)
        photons = rng().uniform(60, 180, 100_000)
        first = coarse.amplified(16)
        amplified = expose(photons, first, rng()).astype(float)
        afterwards = (expose(photons, coarse, rng()).astype(float) - 8) * 16 + 8
        right = 8 + first.gain * 0.6 * photons
        errors = [np.sqrt(((found - right) ** 2).mean()) for found in (amplified, afterwards)]
        assert errors[0] < 0.6 * errors[1]
        assert signal_to_noise(120, coarse.amplified(16)) > 1.7 * signal_to_noise(120, coarse)


class TestDynamicRange:
    def test_accuracy(self):
        # Sony IMX250 (EMVA 1288 data of a typical camera): 10 400 e, 2.4 e, 12 bits: about 72 dB.
        sensor = SensorModel(0.65, 10_400, 2.4, gain=4095 / 10_600, offset=0, bits=12)
        assert 20 * np.log10(dynamic_range(sensor)) == pytest.approx(72, abs=0.8)

    def test_gain_costs_range(self):
        first, second = dynamic_range(SENSOR), dynamic_range(SENSOR.amplified(8))
        assert second < first / 4

    def test_bits_limit_a_quiet_sensor(self):
        # Without noise of its own, the range is white by the rounding noise: (2^b - 1) √12.
        sensor = SensorModel(0.6, 1e6, read_noise=0, gain=1, offset=0, bits=8)
        assert dynamic_range(sensor) == pytest.approx(255 * np.sqrt(12))


class TestClippedFraction:
    def test_shapes(self):
        assert clipped_fraction(np.ones((2, 3))).shape == (2,)
        assert clipped_fraction(np.ones((2, 3, 3))).shape == (2,)

    def test_accuracy(self):
        image = np.full((10, 10, 3), 100, dtype=np.uint8)
        image[:2, :, 0] = 255  # 20 pixels in red
        image[:1, :, 1:] = 255  # ten of them in all colours
        image[-3:, 0, 2] = 0
        np.testing.assert_allclose(clipped_fraction(image), [0.03, 0.2])
        np.testing.assert_allclose(clipped_fraction(image, black=100, white=256), [0.9, 0])

    def test_one_pixel_may_be_both(self):
        np.testing.assert_array_equal(clipped_fraction([[[0, 90, 255]]]), [1, 1])

    def test_errors(self):
        with pytest.raises(ValueError, match=r"image must have shape \(rows, columns\)"):
            clipped_fraction([1, 2, 3])
        with pytest.raises(ValueError, match="image must have shape"):
            clipped_fraction(np.zeros((0, 4)))
        with pytest.raises(ValueError, match="black must be below white, got 255 and 0"):
            clipped_fraction(np.ones((2, 2)), 255, 0)


class TestGain:
    @pytest.mark.parametrize("gain", [0.1, 0.4, 1.7])
    @pytest.mark.parametrize("unevenness", [0, 0.05])
    def test_accuracy(self, gain, unevenness):
        sensor = SensorModel(0.5, 30_000, 7, gain=gain, offset=120, bits=12)
        pairs = picture_pairs(sensor, [0.1, 0.3, 0.5, 0.7], unevenness)
        assert camera_gain_from_pairs(*pairs) == pytest.approx(gain, rel=0.03)

    def test_quantum_efficiency_does_not_matter(self):
        # It decides how many electrons there are, not how many DN each of them makes.
        for efficiency in (0.2, 0.9):
            sensor = SensorModel(efficiency, 30_000, 7, gain=0.3, offset=120, bits=12)
            found = camera_gain_from_pairs(*picture_pairs(sensor, [0.2, 0.5, 0.7]))
            assert found == pytest.approx(0.3, rel=0.03)

    def test_saturated_pairs_are_left_out(self):
        good = camera_gain_from_pairs(*picture_pairs(SENSOR, [0.2, 0.4, 0.6]))
        also = camera_gain_from_pairs(*picture_pairs(SENSOR, [0.2, 0.4, 0.6, 1.0, 2.0]))
        assert good == pytest.approx(0.4, rel=0.03)
        assert also == pytest.approx(0.4, rel=0.03)

    def test_pixels_that_are_always_white_do_not_spoil_a_pair(self):
        first, second, dark_first, dark_second, white = picture_pairs(SENSOR, [0.2, 0.4, 0.6])
        for picture in (*first, *second, dark_first, dark_second):
            picture[5, 7] = white
        found = camera_gain_from_pairs(first, second, dark_first, dark_second, white)
        assert found == pytest.approx(0.4, rel=0.03)

    def test_degenerate(self):
        with pytest.raises(DegenerateConfigurationError, match="no pair is both brighter"):
            camera_gain_from_pairs(*picture_pairs(SENSOR, [1.5, 3]))
        dark = np.full(SHAPE, 120)
        with pytest.raises(DegenerateConfigurationError, match="take others"):
            camera_gain_from_pairs(dark[None], dark[None], dark, dark, 4095)

    def test_errors(self):
        first, second, dark_first, dark_second, white = picture_pairs(SENSOR, [0.2, 0.4])
        with pytest.raises(ValueError, match=r"first must have shape \(levels, rows, columns\)"):
            camera_gain_from_pairs(first[0], second[0], dark_first, dark_second, white)
        with pytest.raises(ValueError, match=r"second must have shape \(2, 120, 130\), as first"):
            camera_gain_from_pairs(first, second[:1], dark_first, dark_second, white)
        with pytest.raises(ValueError, match=r"dark_second must have shape \(120, 130\)"):
            camera_gain_from_pairs(first, second, dark_first, dark_second[1:], white)


class TestFlatField:
    @pytest.mark.parametrize("shape", [(6, 8), (6, 8, 3)])
    def test_round_trip(self, shape):
        truth, dark = rng().uniform(10, 200, shape), rng().uniform(5, 9, shape)
        share = rng().uniform(0.5, 1.5, shape)
        share /= share.mean(axis=(0, 1))
        found = flat_field(dark + share * truth, dark, dark + 180 * share)
        np.testing.assert_allclose(found, truth)

    def test_flat_becomes_flat(self):
        flat = rng().uniform(100, 200, (6, 8, 3)) * [1, 0.8, 0.6]
        dark = rng().uniform(5, 9, (6, 8, 3))
        found = flat_field(flat, dark, flat)
        np.testing.assert_allclose(found, np.broadcast_to((flat - dark).mean((0, 1)), found.shape))
        assert np.ptp(found[0, 0]) > 40  # each colour keeps its own mean

    def test_noise_below_dark_stays_negative(self):
        image, dark, flat = (np.full((2, 2), value, np.uint16) for value in (98, 100, 300))
        np.testing.assert_allclose(flat_field(image, dark, flat), -2)

    def test_errors(self):
        dark, flat = np.full((2, 3), 10), np.full((2, 3), 90)
        with pytest.raises(ValueError, match=r"dark must have the shape of image, \(2, 3\), got"):
            flat_field(flat, dark[:1], flat)
        with pytest.raises(ValueError, match=r"in 6 of 6 values: .* exchanged"):
            flat_field(flat, flat, dark)
