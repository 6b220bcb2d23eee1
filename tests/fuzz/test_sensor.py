"""Whatever goes in: either the answer is right, or the documented error comes. Nothing else."""

import math

import numpy as np
import pytest
from fuzzing import fuzzing, outcome
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from course_lib import illumination, sensor
from course_lib.sensor import SensorModel

fuzz = fuzzing(100)

amounts = st.floats(1e-6, 1e9)
mischief = st.sampled_from(
    [0, -0.0, -1, math.nan, math.inf, "1/60", None, [], [1, [2, 3]], {}, 1j, True, [[]], [1, 2, 3]]
)
pictures = arrays.arrays(
    st.sampled_from([np.uint8, np.uint16, np.float64]),
    arrays.array_shapes(min_dims=1, max_dims=3, min_side=0, max_side=6),
    elements=st.integers(0, 255),
)
colourful = arrays.arrays(
    np.uint8,
    st.tuples(st.integers(1, 7), st.integers(1, 7), st.just(3)),
    elements=st.integers(0, 255),
)
anything = st.one_of(amounts, amounts, amounts, mischief, pictures)
sensors = st.builds(
    SensorModel,
    quantum_efficiency=st.floats(0.01, 1),
    full_well=st.floats(10, 1e6),
    read_noise=st.floats(0, 100),
    dark_current=st.floats(0, 1e4),
    gain=st.floats(1e-4, 100),
    offset=st.just(0.5),
    bits=st.integers(1, 16),
)
#: How many plain arguments each function takes.
PLAIN = {
    "exposure_value": 3,
    "equivalent_exposure": 5,
    "exposure_difference": 2,
    "stops": 1,
    "decibels": 1,
    "luminance": 2,
    "photons_per_pixel": 4,
    "vignetting": 1,
    "mechanical_vignetting": 4,
    "lateral_chromatic_shift": 3,
    "bayer_masks": 1,
    "bayer_mosaic": 1,
    "demosaic_bilinear": 1,
    "camera_gain_from_pairs": 5,
    "clipped_fraction": 3,
    "flat_field": 3,
    "motion_blur_pixels": 3,
    "fastest_speed": 3,
    "rolling_shutter_skew": 3,
    "srgb_encode": 1,
    "srgb_decode": 1,
    "grey_from_rgb": 1,
    "hsv_from_rgb": 1,
    "rgb_from_hsv": 1,
    "silhouette": 2,
    "silhouette_area": 3,
    "stripe_height": 3,
    "correct_lamp_drift": 4,
}
WITH_SENSOR = ("mean_electrons", "sensor_response", "signal_to_noise", "digitise")


def function_of(name):
    return getattr(sensor, name, None) or getattr(illumination, name)


@pytest.mark.parametrize("name", PLAIN)
@fuzz
@given(data=st.data())
def test_answer_or_documented_error(name, data):
    arguments = data.draw(st.tuples(*[anything] * PLAIN[name]))
    answer = outcome(function_of(name), *arguments)
    assert answer is None or np.isfinite(answer).all()


@pytest.mark.parametrize("name", WITH_SENSOR)
@fuzz
@given(value=anything, made=sensors)
def test_answer_of_a_sensor_or_documented_error(name, value, made):
    answer = outcome(function_of(name), value, made)
    assert answer is None or np.isfinite(answer).all()


def test_every_public_function_is_fuzzed():
    other = {"SensorModel", "dynamic_range", "expose", "expose_with_field"}
    lights = {"silhouette", "silhouette_area", "stripe_height", "correct_lamp_drift"}
    assert set(sensor.__all__) == (set(PLAIN) - lights) | set(WITH_SENSOR) | other


@fuzz
@given(arguments=st.tuples(*[st.one_of(st.floats(-1, 100), mischief)] * 7))
def test_sensor_or_documented_error(arguments):
    made = outcome(SensorModel, *arguments)
    if made is not None:
        assert 0 < made.saturation <= made.full_well
        assert sensor.dynamic_range(made) > 0


@fuzz
@given(photons=pictures, made=sensors, seconds=st.floats(0, 100), seed=st.integers(0, 99))
def test_numbers_are_whole_and_within_range(photons, made, seconds, seed):
    rng = np.random.default_rng(seed)
    field = rng.standard_normal(photons.shape)
    for picture in (
        sensor.expose(photons, made, rng, seconds),
        sensor.expose_with_field(photons, made, field, seconds),
    ):
        assert picture.shape == photons.shape
        assert picture.dtype == (np.uint8 if made.bits <= 8 else np.uint16)
        assert (picture <= made.white).all()


@fuzz
@given(made=sensors, photons=st.floats(1, 1e6))
def test_more_light_never_means_less(made, photons):
    dim, bright = sensor.sensor_response([photons, 1.5 * photons], made)
    assert dim <= bright
    poor, good = sensor.signal_to_noise([photons, 1.5 * photons], made)
    assert poor < good <= math.sqrt(1.5 * photons)


@fuzz
@given(t=amounts, N=st.floats(0.5, 100), other=st.floats(0.5, 100), iso=st.floats(1, 1e6))
def test_equivalent_settings_have_one_exposure_value(t, N, other, iso):
    t_new = sensor.equivalent_exposure(t, N, other, 100, iso)
    assert abs(sensor.exposure_difference((other, t_new, iso), (N, t, 100))) < 1e-9


@fuzz
@given(image=colourful, pattern=st.sampled_from(["RGGB", "BGGR", "GRBG", "GBRG"]))
def test_mosaic_keeps_one_colour_of_each_pixel(image, pattern):
    mosaic = outcome(sensor.bayer_mosaic, image, pattern)
    even = image.shape[0] % 2 == 0 and image.shape[1] % 2 == 0
    assert (mosaic is None) == (not even)
    if even:
        masks = sensor.bayer_masks(mosaic.shape, pattern)
        assert (mosaic == (image * masks).sum(axis=2)).all()


@fuzz
@given(image=colourful)
def test_demosaic_stays_between_its_neighbours(image):
    mosaic = image[: image.shape[0] // 2 * 2, : image.shape[1] // 2 * 2, 0]
    colours = outcome(sensor.demosaic_bilinear, mosaic)
    if colours is not None:
        assert (sensor.bayer_mosaic(colours) == mosaic).all()
        for colour, seen in zip(
            np.moveaxis(colours, -1, 0),
            np.moveaxis(sensor.bayer_masks(mosaic.shape), -1, 0),
            strict=True,
        ):
            assert mosaic[seen].min() - 1e-9 <= colour.min()
            assert colour.max() <= mosaic[seen].max() + 1e-9


@fuzz
@given(image=colourful, black=st.integers(0, 100), white=st.integers(101, 255))
def test_clipped_share_counts_pixels(image, black, white):
    shares = sensor.clipped_fraction(image, black, white)
    pixels = image.reshape(-1, 3).tolist()
    dark = sum(min(pixel) <= black for pixel in pixels)
    bright = sum(max(pixel) >= white for pixel in pixels)
    np.testing.assert_allclose(shares, [dark / len(pixels), bright / len(pixels)])


@fuzz
@given(
    height=st.floats(-1e3, 1e3),
    light=st.floats(0.01, 1.5),
    camera=st.floats(0, 1.5),
)
def test_stripe_and_back(height, light, camera):
    shift = height * math.tan(light) + height * math.tan(camera)
    assert abs(illumination.stripe_height(shift, light, camera) - height) <= 1e-9 * abs(height)


@fuzz
@given(light=arrays.arrays(np.float64, (4,), elements=st.floats(0, 1)))
def test_gamma_and_back(light):
    np.testing.assert_allclose(sensor.srgb_decode(sensor.srgb_encode(light)), light, atol=1e-6)
