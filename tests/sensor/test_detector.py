import numpy as np
import pytest

from course_lib.sensor.detector import (
    NORMAL_FROM,
    digitise,
    expose,
    expose_with_field,
    mean_electrons,
    sensor_response,
)
from course_lib.sensor.sensor_model import SensorModel

SENSOR = SensorModel(
    quantum_efficiency=0.5,
    full_well=20_000,
    read_noise=6,
    dark_current=10,
    gain=0.8,
    offset=100,
    bits=16,
)
CHAIN = [mean_electrons, sensor_response]
PIXELS = 200_000
RNG_SEED = 4


def rng():
    return np.random.default_rng(RNG_SEED)


def noisy(photons, sensor=SENSOR, seconds=0.0):
    return expose(np.full(PIXELS, float(photons)), sensor, rng(), seconds).astype(float)


def noisy_with_field(photons, sensor=SENSOR, seconds=0.0):
    field = rng().standard_normal(PIXELS)
    return expose_with_field(np.full(PIXELS, float(photons)), sensor, field, seconds).astype(float)


class TestSensorModel:
    @pytest.mark.parametrize(
        ("change", "message"),
        [
            (
                {"quantum_efficiency": 60},
                "must be above 0 and at most 1, got 60: 60 % is",
            ),
            ({"quantum_efficiency": 0}, "above 0 and at most 1"),
            ({"full_well": 0}, "full_well must be positive"),
            ({"gain": -1}, "gain must be positive"),
            ({"read_noise": -1}, "read_noise must not be negative"),
            ({"dark_current": np.nan}, "dark_current must be finite"),
            ({"bits": 0}, "bits must be a whole number from 1 to 16, got 0"),
            ({"bits": 17}, "from 1 to 16"),
            ({"bits": 11.5}, "whole number"),
            ({"offset": 4095, "bits": 12}, "offset must be below 4095"),
        ],
    )
    def test_errors(self, change, message):
        with pytest.raises(ValueError, match=message):
            SensorModel(**change)

    def test_properties(self):
        assert SensorModel(bits=12, offset=95, gain=0.1, full_well=30_000).saturation == 30_000
        assert SensorModel(bits=12, offset=95, gain=0.5, full_well=30_000).saturation == 8000
        assert SENSOR.amplified(4).gain == pytest.approx(3.2)
        assert SENSOR.amplified(4).full_well == SENSOR.full_well
        # Rounding errors are spread evenly over one step.
        errors = np.linspace(-0.5, 0.5, 10_001)
        assert SENSOR.quantisation_noise * SENSOR.gain == pytest.approx(errors.std(), rel=1e-3)


class TestResponse:
    @pytest.mark.parametrize("function", CHAIN)
    def test_shapes(self, function):
        assert np.ndim(function(100, SENSOR)) == 0
        assert function(np.ones((2, 3)), SENSOR).shape == (2, 3)

    @pytest.mark.parametrize("function", CHAIN)
    def test_errors(self, function):
        with pytest.raises(ValueError, match="photons must not be negative, got -1"):
            function([-1, 5], SENSOR)
        with pytest.raises(ValueError, match="exposure_time must not be negative"):
            function([1, 5], SENSOR, -1)
        with pytest.raises(ValueError, match="exposure_time must be one number"):
            function([1, 5], SENSOR, [1, 2])
        with pytest.raises(TypeError, match="photons must be real numbers"):
            function("many", SENSOR)

    def test_accuracy(self):
        # 0.5 · 1000 + 10 · 3 = 530 electrons; 0.8 · 530 + 100 = 524.
        assert sensor_response(1000, SENSOR, 3) == pytest.approx(524)
        assert sensor_response(1e6, SENSOR) == pytest.approx(0.8 * 20_000 + 100)
        assert sensor_response(1e6, SENSOR.amplified(10)) == 65_535

    @pytest.mark.parametrize("photons", [0, 3, 60, 800, 20_000])
    def test_mean_of_many_pictures(self, photons):
        spread = np.sqrt(noisy(photons).var() / PIXELS)
        assert abs(noisy(photons).mean() - sensor_response(photons, SENSOR)) < 4 * spread


class TestExpose:
    @pytest.mark.parametrize(("bits", "kind"), [(8, np.uint8), (9, np.uint16), (16, np.uint16)])
    def test_type_and_shape(self, bits, kind):
        sensor = SensorModel(bits=bits, offset=1, gain=0.01)
        assert expose(np.ones((2, 4, 3)), sensor, rng()).dtype == kind
        assert expose(np.ones((2, 4, 3)), sensor, rng()).shape == (2, 4, 3)
        assert expose_with_field(np.ones(5), sensor, np.zeros(5)).dtype == kind
        assert expose(1000.0, sensor, rng()).shape == ()

    def test_same_seed_same_picture(self):
        np.testing.assert_array_equal(noisy(500), noisy(500))
        assert (expose(np.full(99, 500.0), SENSOR, rng()) != noisy(500)[-99:]).any()

    def test_arguments_stay_as_they_are(self):
        photons, field = np.full(50, 900.0), np.full(50, 0.5)
        expose(photons, SENSOR, rng())
        expose_with_field(photons, SENSOR, field)
        np.testing.assert_array_equal(photons, 900)
        np.testing.assert_array_equal(field, 0.5)

    @pytest.mark.parametrize("take", [noisy, noisy_with_field])
    @pytest.mark.parametrize("photons", [40, 2 * NORMAL_FROM - 2, 2 * NORMAL_FROM, 30_000])
    @pytest.mark.parametrize("seconds", [0, 20])
    def test_variance(self, take, photons, seconds):
        # Shot noise of all electrons, readout, rounding: K² (e + r²) + 1 / 12.
        electrons = 0.5 * photons + 10 * seconds
        variance = 0.8**2 * (electrons + 6**2) + 1 / 12
        assert take(photons, seconds=seconds).var() == pytest.approx(variance, rel=0.02)

    @pytest.mark.parametrize("electrons", [1, 30, NORMAL_FROM - 1, NORMAL_FROM, 5000])
    def test_moments_are_those_of_poisson(self, electrons):
        ideal = SensorModel(1, 60_000, read_noise=0, dark_current=0, gain=1, offset=0, bits=16)
        drawn = expose(np.full(PIXELS, float(electrons)), ideal, rng()).astype(float)
        assert drawn.mean() == pytest.approx(electrons, abs=4 * np.sqrt(electrons / PIXELS))
        # The variance of a sample variance: (2 + 1 / n) n² / pixels.
        spread = np.sqrt((2 + 1 / electrons) * electrons**2 / PIXELS)
        assert drawn.var() == pytest.approx(electrons, abs=4 * spread + 1 / 12)
        skewness = ((drawn - drawn.mean()) ** 3).mean() / drawn.std() ** 3
        normal = electrons >= NORMAL_FROM
        expected = 0 if normal else electrons**-0.5
        assert skewness == pytest.approx(expected, abs=4 * np.sqrt((6 + 25 / electrons) / PIXELS))

    def test_mixed_picture(self):
        # Dark and bright pixels side by side: each gets its own noise.
        photons = np.tile([20.0, 20_000.0], PIXELS // 2)
        picture = expose(photons, SENSOR, rng()).astype(float)
        for k, level in enumerate((20, 20_000)):
            variance = 0.64 * (level / 2 + 36) + 1 / 12
            assert picture[k::2].var() == pytest.approx(variance, rel=0.03)

    @pytest.mark.parametrize("take", [noisy, noisy_with_field])
    def test_full_well_has_no_shot_noise(self, take):
        # Nothing but the readout is left: clipping of electrons comes before it.
        assert take(200_000).std() == pytest.approx(0.8 * 6, rel=0.02)
        assert take(200_000).mean() == pytest.approx(0.8 * 20_000 + 100, abs=0.1)

    @pytest.mark.parametrize("take", [noisy, noisy_with_field])
    def test_numbers_end_after_the_noise(self, take):
        # In the middle of a white picture's noise half of the pixels are clipped, half are not.
        sensor = SensorModel(1, 50_000, 5, 0, gain=0.1, offset=0, bits=10)
        picture = take(10_230, sensor)
        assert picture.max() == 1023
        assert 0.45 < (picture == 1023).mean() < 0.6
        assert picture.mean() < 1023 - 2  # clipping first would leave noise of mean zero

    def test_black_clips_noise(self):
        sensor = SensorModel(1, 50_000, 10, 0, gain=1, offset=0, bits=10)
        assert noisy(0, sensor).min() == 0
        assert noisy(0, sensor).mean() == pytest.approx(10 / np.sqrt(2 * np.pi), rel=0.03)

    @pytest.mark.parametrize("seed", [0, None, np.random])
    def test_errors_of_generator(self, seed):
        with pytest.raises(TypeError, match=r"rng must be a generator such as np\.random\.default"):
            expose(np.ones(5), SENSOR, seed)

    def test_errors_of_field(self):
        with pytest.raises(ValueError, match=r"field must have the shape of photons, \(5,\)"):
            expose_with_field(np.ones(5), SENSOR, np.zeros(4))


class TestDigitise:
    def test_accuracy(self):
        sensor = SensorModel(bits=8, offset=1, gain=0.01)
        levels = [-3.2, 0.4, 0.6, 254.4, 254.6, 900]
        np.testing.assert_array_equal(digitise(levels, sensor), [0, 0, 1, 254, 255, 255])
        assert digitise(7.2, sensor) == 7
