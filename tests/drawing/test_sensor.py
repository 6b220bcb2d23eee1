"""The figures of chapter 04: each draws, says what its axes are, and shows the right thing."""

import matplotlib as mpl
import numpy as np
import pytest
from legible import Legible

mpl.use("Agg")  # as a test has no screen

from skimage.data import camera, clock

from course_lib import illumination, sensor
from course_lib.drawing import sensor as draw
from course_lib.drawing.style import ROLES
from data_generators import flats

MODEL = sensor.SensorModel(full_well=15_000, read_noise=5, gain=0.25, offset=64, bits=12)
MYSTERY = sensor.SensorModel(full_well=20_000, read_noise=4, gain=0.31, offset=100, bits=12)
PAIRS = flats.flat_pairs(MYSTERY, np.linspace(800, 24_000, 14), np.random.default_rng(1))
UNEVEN = flats.uneven_pictures(np.random.default_rng(3))
NUT = draw.label_and_nut()
ANGLE = np.radians(40)
SCAN = draw.stripe_scan(ANGLE)
WHITE_BALANCE = {"black": 600, "white": 15_520, "gains": (1.949, 1.344)}

FIGURES = {
    "acquisition_chain": draw.acquisition_chain,
    "aliasing": draw.aliasing,
    "apertures_to_scale": draw.apertures_to_scale,
    "back_lit": draw.back_lit,
    "belt_photographs": lambda: draw.belt_photographs([(0.01, 4, 100, 500), (None, 4, 100, 500)]),
    "clock_blur": lambda: draw.clock_blur(clock()),
    "colour_fringes": draw.colour_fringes,
    "colour_spaces": lambda: draw.colour_spaces(draw.dimmed_belt()),
    "colour_strategies": draw.colour_strategies,
    "corrected_afterwards": draw.corrected_afterwards,
    "development": lambda: draw.development(draw.computed_raw(), **WHITE_BALANCE),
    "exposure_chart": lambda: draw.exposure_chart(np.arange(10.0) + 7),
    "flat_field_series": lambda: draw.flat_field_series(UNEVEN),
    "gain_before_or_after": draw.gain_before_or_after,
    "gamma_curve": draw.gamma_curve,
    "height_field": lambda: draw.height_field(camera()),
    "histogram_series": draw.histogram_series,
    "lamp_drift": draw.lamp_drift,
    "light_to_number": draw.light_to_number,
    "mosaic_and_back": lambda: draw.mosaic_and_back(NUT, NUT[..., 1], NUT),
    "photon_patches": draw.photon_patches,
    "photon_transfer": lambda: draw.photon_transfer(PAIRS, MYSTERY.white, gain=0.31),
    "quantisation": lambda: draw.quantisation(camera()),
    "response_curve": lambda: draw.response_curve(MODEL),
    "sampled_wave": draw.sampled_wave,
    "scanned_profile": lambda: draw.scanned_profile(SCAN, ANGLE),
    "shutters": draw.shutters,
    "skewed_pole": lambda: draw.skewed_pole(yours=17.2),
    "snr_curve": lambda: draw.snr_curve(MODEL),
    "spectrum": draw.spectrum,
    "stripe_geometry": draw.stripe_geometry,
    "three_lights": draw.three_lights,
    "vignetting_profile": draw.vignetting_profile,
    "ways_of_reading": draw.ways_of_reading,
}
NO_FIGURES = {
    "BACK_LIT",
    "STOPS",
    "computed_raw",
    "dimmed_belt",
    "label_and_nut",
    "street_exposed",
    "street_light",
    "stripe_scan",
}


@pytest.fixture(scope="module", params=FIGURES)
def figure(request):
    drawn = FIGURES[request.param]()
    drawn.draw_without_rendering()
    return drawn


class TestEachFigure(Legible):
    UNITS = (
        *("px", "mm", "nm", "s", "ms", "h", "DN", "DN²", "%", "share", "share in %"),
        *("number", "ratio", "relative", "no unit"),
    )
    WHITE_ON_DARK = True
    SLANTED = True


def test_every_function_is_tried_here():
    assert set(FIGURES) | NO_FIGURES == set(draw.__all__)


@pytest.mark.parametrize("yours", [None, "left", [1, 2], {}, np.nan])
def test_what_a_student_cannot_have_meant_does_no_harm(yours):
    for drawn in (
        draw.exposure_chart(yours),
        draw.response_curve(MODEL, yours),
        draw.snr_curve(MODEL, yours),
        draw.photon_transfer(PAIRS, MYSTERY.white, yours),
        draw.skewed_pole(yours=yours),
        draw.mosaic_and_back(NUT, yours, yours),
        draw.flat_field_series(UNEVEN, yours),
        draw.scanned_profile(SCAN, ANGLE, yours),
    ):
        drawn.draw_without_rendering()
        assert not lines(drawn, "second")


def lines(figure, role):
    """Return the data of the lines that have the colour of a role."""
    found = [line for ax in figure.axes for line in ax.lines if line.get_color() == ROLES[role]]
    return [np.asarray(line.get_xydata()) for line in found]


def images(figure):
    return [np.asarray(ax.images[0].get_array()) for ax in figure.axes if ax.images]


def test_the_students_numbers_are_drawn_where_they_belong():
    photons = np.arange(13) * 3000.0
    numbers = sensor.sensor_response(photons, MODEL)
    (drawn,) = lines(draw.response_curve(MODEL, numbers + 100), "second")
    np.testing.assert_allclose(drawn, np.stack([photons, numbers + 100], axis=1))
    (drawn,) = lines(draw.photon_transfer(PAIRS, MYSTERY.white, 0.5), "second")
    np.testing.assert_allclose(drawn[:, 1], 0.5 * drawn[:, 0])
    (drawn,) = lines(draw.scanned_profile(SCAN, ANGLE, 2 * SCAN.shift), "second")
    np.testing.assert_allclose(drawn[:, 1], 2 * SCAN.shift)
    (drawn,) = lines(draw.skewed_pole(yours=50), "second")
    assert np.ptp(drawn[:, 0]) == pytest.approx(50)


@pytest.mark.parametrize(("too_much", "factor"), [(0, 1), (1, 1 / 2), (-3, 8)])
def test_an_exposure_value_is_drawn_where_it_lies(too_much, factor):
    values = sensor.exposure_value(np.array(draw.STOPS), 1 / 125) + too_much
    (dots,) = lines(draw.exposure_chart(values), "second")
    np.testing.assert_allclose(dots[:, 1], factor / 125)


def test_the_pairs_lie_on_a_line_with_the_slope_of_the_gain():
    figure = draw.photon_transfer(PAIRS, MYSTERY.white)
    points = next(np.asarray(line.get_xydata()) for line in figure.axes[0].lines)
    assert 8 <= len(points) < 14  # some lights are clipped
    slope = (points[:, 0] @ points[:, 1]) / (points[:, 0] @ points[:, 0])
    assert slope == pytest.approx(MYSTERY.gain, rel=0.03)


def test_the_pole_leans_as_far_as_the_formula_says():
    picture = images(draw.skewed_pole(speed=1800, row_time=30e-6))[0][..., 0]
    dark = [np.flatnonzero(row < 0.4).mean() for row in (picture[2], picture[-3])]
    rows = picture.shape[0] - 5
    assert dark[1] - dark[0] == pytest.approx(1800 * 30e-6 * rows, abs=1)


def test_the_clock_is_wider_than_high_by_the_motion():
    grey = clock().astype(float)
    across = np.convolve(grey[146:155].mean(axis=0), np.ones(5) / 5, "same")
    wide = np.flatnonzero(np.abs(np.gradient(across))[5:-5] > 0.9)
    high = np.flatnonzero(np.abs(np.gradient(grey[:, 208:217].mean(axis=1))) > 5)
    assert np.ptp(high) == pytest.approx(122, abs=3)
    assert np.ptp(wide) - np.ptp(high) == pytest.approx(25, abs=4)


def test_patches_have_the_noise_that_their_titles_claim():
    figure = draw.photon_patches(means=(4, 100), side=200)
    for ax, mean in zip(figure.axes, (4, 100), strict=True):
        patch = np.asarray(ax.images[0].get_array())
        assert patch.std() / patch.mean() == pytest.approx(1 / np.sqrt(mean), rel=0.03)


def test_gain_before_keeps_more_grey_values_than_afterwards():
    before, after = (len(np.unique(image)) for image in images(draw.gain_before_or_after()))
    assert before > 8 * after


def test_over_exposure_loses_the_sky_and_under_exposure_does_not():
    under, over, _, _ = images(draw.corrected_afterwards(stops=(-3, 2)))
    sky = slice(0, 60), slice(190, 300)
    truth = draw.street_light()[sky]
    assert np.ptp(truth) > 0.05
    assert np.corrcoef(under[sky].ravel(), truth.ravel())[0, 1] > 0.6
    assert over[sky].std() < 0.2 * under[sky].std()


def test_the_sampled_wave_and_its_alias_share_their_samples():
    figure = draw.sampled_wave(period=1.25)
    fine, slow, samples = (np.asarray(line.get_xydata()) for line in figure.axes[0].lines)
    for wave in (fine, slow):
        at = np.interp(samples[:, 0], wave[:, 0], wave[:, 1])
        np.testing.assert_allclose(at, samples[:, 1], atol=0.02)
    assert len(draw.sampled_wave(period=4).axes[0].lines) == 2  # nothing false to read


def test_only_the_hue_finds_the_brass():
    hue = images(draw.colour_spaces(draw.dimmed_belt()))[5]
    coloured = np.ptp(hue, axis=2) > 0.3
    nuts = coloured.sum() * 0.04  # mm²
    corner, hole = 8.0, 4.0
    assert nuts == pytest.approx(2 * (1.5 * np.sqrt(3) * corner**2 - np.pi * hole**2), rel=0.08)


def test_the_titles_of_the_colour_spaces_stay_above_their_own_pictures():
    figure = draw.colour_spaces(draw.dimmed_belt())
    figure.canvas.draw()
    for ax in figure.axes:
        assert ax._left_title.get_window_extent().x1 <= ax.get_window_extent().x1 + 1


def test_the_raw_picture_has_the_facts_of_the_real_one():
    raw = draw.computed_raw()
    assert raw.shape == (512, 768)
    assert raw.dtype == np.uint16
    assert raw.min() > 550
    assert 12_000 < raw.max() < 16_384
    paper = images(draw.development(raw, **WHITE_BALANCE))[4][235:260, 110:230]
    white = paper[paper.min(axis=2) > 0.8]
    assert np.ptp(white.mean(axis=0)) < 0.02  # white paper is white


def test_vignetting_falls_as_the_fourth_power_of_the_cosine():
    figure = draw.vignetting_profile(f=24)
    x, y = np.asarray(figure.axes[0].lines[0].get_xydata())[-1]
    assert y == pytest.approx(100 * np.cos(np.arctan(x / 24)) ** 4)


def test_the_flat_field_evens_the_wall():
    corrected = sensor.flat_field(*UNEVEN)
    paper = corrected[170:270, 430:446], corrected[170:270, 317:321]
    assert paper[0].mean() == pytest.approx(paper[1].mean(), rel=0.02)
    assert UNEVEN.flat[5:15, 5:15].mean() < 0.8 * UNEVEN.flat[155:165, 235:245].mean()


def test_the_scan_gives_the_height_of_the_dome():
    heights = illumination.stripe_height(SCAN.shift, ANGLE)
    radius = (10**2 + 5**2) / 10
    inside = np.abs(SCAN.x) < 9
    truth = np.sqrt(radius**2 - SCAN.x[inside] ** 2) - (radius - 5)
    assert np.abs(heights[inside] - truth).max() < 0.15


def test_the_lamp_loses_what_the_text_says():
    from course_lib.drawing.sensor.lighting import fading

    assert fading([0, 100]).tolist() == pytest.approx([1, 0.85])
    assert 0.8 < fading(400) < 0.85


def test_a_time_is_written_as_photographers_do():
    from course_lib.drawing.sensor.exposure import seconds

    assert [seconds(t) for t in (2, 1 / 6, 1 / 8000)] == ["2 s", "1/6 s", "1/8000 s"]
