"""The numbers that the text of chapter 04 states are those that the library computes."""

import numpy as np
import pytest
from lesson_text import lesson_text

from course_lib import illumination, optics, sensor
from course_lib.drawing import sensor as draw
from course_lib.drawing.explorers import bayer, exposure, rolling_shutter
from data_generators import belt

TEXT = lesson_text("04_sensor")
says = TEXT.says


def readings(t, N, iso, lux, speed):
    """Return what the exposure explorer shows, by label; t in s."""
    frame = exposure.exposure_frame(1000 * t, N, iso, lux, speed, False)
    return {r.label: float(r.value) for r in frame.readouts}


def test_exposure_values():
    assert sensor.exposure_value(16, 1 / 125) == pytest.approx(15.0, abs=0.05)
    assert np.log2(256 * 125) == pytest.approx(15.0, abs=0.05)
    ratios = np.divide(draw.STOPS[1:], draw.STOPS[:-1]) ** 2
    np.testing.assert_allclose(ratios, 2, rtol=0.07)  # the printed numbers are rounded
    says(r"$\log_2 (256 \cdot 125) = 15.0$", "$2^{10} = 1024$", "f/16, 1/125 s, ISO 100: 15.0")
    assert sensor.exposure_value(16, 1 / 125, 400) == pytest.approx(13.0, abs=0.05)
    says(r"$15.0 - \log_2 4 = 13.0$")


def test_equivalent_time():
    t = sensor.equivalent_exposure(1 / 100, N=4, N_new=11)
    assert t == pytest.approx(0.076, abs=0.0005)
    assert 1 / t == pytest.approx(13, abs=0.5)
    assert pytest.approx(7.6, abs=0.05) == (11 / 4) ** 2
    says("$(11/4)^2 = 7.6$", "$0.076$ s, about 1/13 s", "0.076 s at f/11")


def test_the_three_exposures_of_the_lecture():
    settings = [(16, 2, 100), (4.5, 1 / 6, 100), (16, 1 / 6, 1250)]
    stops = [sensor.exposure_difference(s, settings[0]) for s in settings[1:]]
    assert stops == pytest.approx([0.075, 0.059], abs=0.001)
    assert max(stops) < 0.08
    assert 2 ** max(stops) - 1 == pytest.approx(0.05, abs=0.004)
    photons = [readings(t, N, iso, 40, 0)["Photons from the label"] for N, t, iso in settings]
    assert photons[0] / photons[2] == pytest.approx(12, abs=0.05)
    says("less than 0.08 stops, or 5 %", "a twelfth of the photons")


def test_what_the_explorer_shows():
    start = readings(1 / 100, 4, 100, 500, 800)
    assert start["Blur by motion"] == 40
    assert start["Photons from the label"] == 27_165
    assert start["Signal to noise, label"] == 128
    short = readings(1 / 8000, 4, 6400, 500, 800)
    assert (short["Blur by motion"], short["Photons from the label"]) == (0.5, 340)
    assert short["Signal to noise, label"] == 13
    bright = readings(1 / 8000, 2.8, 100, 20_000, 800)
    assert bright["Signal to noise, label"] == 129
    blurs = bright["Blur by defocus, label"], start["Blur by defocus, label"]
    assert blurs == (4.4, 3.1)
    says("340 photons into a pixel instead of 27 165", "from 128 to 13", "f/2.8 give 129")
    says("blurred by 4.4 px at f/2.8 and by 3.1 px at f/4", "45 mm higher than the belt")
    says("Half a pixel is 0.1 mm, and 800 mm/s need 0.125 ms")
    assert exposure.CARTON == 45


def test_the_chain_in_one_pixel():
    model = sensor.SensorModel(quantum_efficiency=0.6, gain=0.2, offset=64, bits=12)
    assert sensor.sensor_response(8000, model) == 1024
    assert model.white == 4095
    says("8000 photons at 0.6 make 4800 electrons", r"$4800 \cdot 0.2 + 64 = 1024$ DN")
    assert sensor.sensor_response(50_000, model) == 3064
    assert sensor.sensor_response(50_000, model.amplified(4)) == 4095
    assert 15_000 * 0.8 + 64 == 12_064
    says(r"$15\,000\cdot 0.2 + 64 = 3064$ DN", "it would be 12 064, but 4095 is written")


def test_noise():
    model = sensor.SensorModel(full_well=15_000, read_noise=5, gain=0.25, offset=64, bits=12)
    bright, dark = sensor.signal_to_noise([10_000, 10], model)
    assert bright == pytest.approx(77, abs=0.5)
    assert dark == pytest.approx(1.06, abs=0.005)
    assert model.quantisation_noise**2 == pytest.approx(1.3, abs=0.05)
    assert 1 / np.sqrt(12) == pytest.approx(0.29, abs=0.002)
    says(r"$6000/\sqrt{6000 + 25 + 1.3} = 77$", r"$6 / \sqrt{6 + 25 + 1.3} = 1.06$", "= 0.29$ DN")
    ratio = sensor.dynamic_range(model)
    assert ratio == pytest.approx(2923, abs=0.5)
    assert np.hypot(5, model.quantisation_noise) == pytest.approx(5.13, abs=0.005)
    assert sensor.stops(ratio) == pytest.approx(11.5, abs=0.05)
    assert sensor.decibels(ratio) == pytest.approx(69, abs=0.5)
    assert model.quantisation_noise == pytest.approx(1.15, abs=0.005)
    says(r"$\sigma_q^2 = 1.15^2 = 1.3$", "a gain of 0.25")
    says(r"$15\,000 / 5.13 = 2923$", r"$\log_2 2923 = 11.5$", "= 69$ dB")


def test_the_mystery_camera():
    says("gain=0.31, offset=100", "about 0.31 DN per electron", "14 lights")


def test_clipping_of_the_street():
    shares = {stop: sensor.clipped_fraction(draw.street_exposed(stop), 0, 4095) for stop in (0, 2)}
    assert shares[2][1] == pytest.approx(0.410, abs=0.0005)
    assert shares[0][1] < 0.001
    says("41.0 % of the pixels clipped at +2 stops", "almost none at 0")
    model = sensor.SensorModel(quantum_efficiency=1, read_noise=5, gain=0.25)
    right, dark = sensor.signal_to_noise([1000, 1000 / 8], model)
    assert right == pytest.approx(31, abs=0.5)
    assert dark == pytest.approx(10, abs=0.3)
    says("1000 electrons got 125", "SNR is 10 instead of 31")


def test_the_alias():
    assert 1 / abs(1 / 1.25 - 1) == pytest.approx(5)
    says("period of 1.25 px", "a wave of 5 px")


def test_motion():
    assert sensor.motion_blur_pixels(800, 1 / 100, 0.2) == pytest.approx(40)
    assert sensor.fastest_speed(1 / 100, 0.2, 0.5) == pytest.approx(10)
    assert sensor.motion_blur_pixels(800, 1 / 8000, 0.2) == pytest.approx(0.5)
    assert sensor.rolling_shutter_skew(1800, 30e-6, 319) == pytest.approx(17.2, abs=0.05)
    says(
        r"$800 \cdot 0.01 / 0.2 = 40$ px", "slower than $0.2/0.01 \\cdot 0.5 = 10$ mm/s", "17.2 px"
    )
    # The clock's sizes are measured in the test of its figure.
    says("about 122 px high, but 147 px wide", "the blur is about 25 px")


def test_the_propeller():
    frame = rolling_shutter.rolling_shutter_frame(20, 20, 0.5, 3, rolling_shutter.ROLLING)
    assert next(r.value for r in frame.readouts if "first to last" in r.label) == "144"
    says("turns by 144°")


def test_colour():
    says("black=600, white=15_520, gains=(1.949, 1.344)", "by 1.949 and blue by 1.344")
    assert sensor.srgb_decode(0.5) == pytest.approx(0.214, abs=0.0005)
    assert pytest.approx(0.218, abs=0.0005) == 0.5**2.2
    says("the darkest 21.4 % of the light", "0.5^{2.2} = 21.8$ %", "Code 0.5 is 21 % of the light")
    grey = sensor.grey_from_rgb(np.eye(3))
    np.testing.assert_allclose(grey, (0.21, 0.72, 0.07), atol=0.005)
    says("0.21 R + 0.72 G + 0.07 B")
    masks = sensor.bayer_masks((4, 4))
    assert masks.mean(axis=(0, 1)).tolist() == [0.25, 0.5, 0.25]


def test_vignetting():
    angle = np.arctan2(np.hypot(36, 24) / 2, 24)
    assert np.hypot(36, 24) / 2 == pytest.approx(21.6, abs=0.05)
    assert np.degrees(angle) == pytest.approx(42, abs=0.1)
    assert sensor.vignetting(angle) == pytest.approx(0.30, abs=0.005)
    says("21.6 mm from the\nmiddle: $\\theta = 42°$, and 30 % are left")


def test_silhouettes():
    part = np.array(draw.BACK_LIT)
    assert (part < 7.5).sum() == 26
    assert illumination.silhouette_area(part, 7.5, 0.5) == pytest.approx(6.5)
    assert illumination.silhouette_area(0.9 * part, 7.5, 0.5) == pytest.approx(6.5)
    says(r"$26 \cdot 0.25 = 6.5$ mm²", "15 becomes 13.5")
    truth = np.pi * (9**2 - 4.6**2)
    assert truth == pytest.approx(188.0, abs=0.05)
    assert belt.WASHER == (9, 4.6)
    washer = 15 * (1 - belt.silhouettes()[:130, :150])
    area = illumination.silhouette_area(washer, 7.5, belt.PIXEL)
    assert area / truth - 1 == pytest.approx(0.005, abs=0.0005)
    says("= 188.0$ mm²", "about 0.5 %")


def test_stripes():
    at_40, at_20 = np.radians([40, 20])
    assert illumination.stripe_height(4.2, at_40) == pytest.approx(5.0, abs=0.01)
    assert np.tan(at_40) == pytest.approx(0.839, abs=0.0005)
    assert illumination.stripe_height(0.1, at_40) == pytest.approx(0.12, abs=0.005)
    assert illumination.stripe_height(0.1, at_20) == pytest.approx(0.27, abs=0.005)
    tilted = illumination.stripe_height(1.0, at_40, camera_angle=at_20)
    assert tilted == pytest.approx(1 / (np.tan(at_40) + np.tan(at_20)))
    says("$h = 4.2/0.839 = 5.0$ mm", "0.12 mm of height at 40°, but 0.27 mm at 20°")


def test_back_to_the_belt():
    t = 0.5 * 0.2 / 800
    assert t == pytest.approx(0.125e-3)
    dim = 27_165 * t / 0.01
    assert dim == pytest.approx(340, abs=0.5)
    assert pytest.approx(16_700, abs=50) == 10_000 / 0.6
    assert 16_667 / dim == pytest.approx(49, abs=0.2)
    model = sensor.SensorModel(full_well=20_000, read_noise=6, gain=exposure.SENSOR.gain)
    lux = np.array([49 * 500, 25_000])
    enough = sensor.signal_to_noise(dim * lux / 500, model)
    assert enough == pytest.approx([100, 101], abs=0.5)
    assert readings(t, 4, 100, 25_000, 800)["Signal to noise, label"] == 101
    says(
        "16\\,700$ photons: 49 times as many",
        "$49\\cdot 500 = 24\\,500$ lx",
        "an SNR of 101",
        "340 photons",
    )
    says("a quarter of full sunlight (about 100 000 lx)")
    assert f"read_noise=6, gain={exposure.SENSOR.gain:g})" in TEXT
    assert pytest.approx(0.182) == 0.2 * 455 / 500
    assert sensor.motion_blur_pixels(800, t, 0.182) == pytest.approx(0.55, abs=0.005)
    says("= 0.18$ mm", "= 0.55$ px", "$= 0.125$ ms")
    assert optics.magnification(25, 500) * 0.2 == pytest.approx(exposure.pitch_um() / 1000)


def test_the_star_behind_the_mosaic():
    errors = []
    for softness in (0, 0.5, 1):
        frame = bayer.bayer_frame(bayer.STAR, bayer.FILTERS, 60, 0.5, 0.5, softness)
        errors.append(next(r.value for r in frame.readouts if "RMS" in r.label))
    assert errors == ["25.2", "15.1", "2.5"]
    says("wrong by 25.2 %", "0.5 px leaves 15.1 %", "1 px only 2.5 %")


def test_the_worked_greens():
    small = [[10, 20, 12, 24], [30, 90, 34, 94], [14, 28, 16, 32], [38, 98, 42, 99]]
    green = sensor.demosaic_bilinear(small)[..., 1]
    assert (green[0, 1], green[1, 0], green[0, 0], green[1, 1]) == (20, 30, 25, 28)
    says(f"small = np.array({small})", "so its green is 25", "has 20, 34, 28 and 30 around it: 28")


def test_the_worked_flat_field():
    even = sensor.flat_field([[110, 60]], [[10, 10]], [[210, 110]])
    assert even.tolist() == [[75, 75]]
    says("110 and 60 in the picture, 10 and 10 in the dark, 210 and 110 in the flat picture")
    says(r"$100/200\cdot 150 = 50/100\cdot 150 = 75$")
