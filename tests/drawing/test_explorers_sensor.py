"""The explorers of chapter 04 show what they say, and follow every state."""

import numpy as np
import pytest

from course_lib import sensor
from course_lib.drawing.explorers import bayer, exposure, rolling_shutter, structured_light

EXPOSURE = exposure.exposure_frame
ROLL = rolling_shutter.rolling_shutter_frame
BAYER = bayer.bayer_frame
STRIPES = structured_light.structured_light_frame
ROLLING, GLOBAL = rolling_shutter.ROLLING, rolling_shutter.GLOBAL
ONE, MANY = structured_light.ONE, structured_light.MANY


def value(frame, label):
    (reading,) = (r for r in frame.readouts if r.label == label)
    return float(reading.value)


def grey(frame, place=0):
    return frame.pictures[place].image[..., 0].astype(float)


# Exposure


def label(frame):
    """Return the grey values of clean paper on the label."""
    return grey(frame)[180:250, 415:440]


def test_equal_exposure_values_are_equally_bright():
    one, other = EXPOSURE(8, 4, 100, 500, 0, False), EXPOSURE(2, 4, 400, 500, 0, False)
    assert value(one, "Exposure value") == value(other, "Exposure value")
    assert label(one).mean() == pytest.approx(label(other).mean(), abs=1)
    assert label(other).std() > 1.7 * label(one).std()  # a quarter of the photons


def test_photons_follow_time_aperture_and_light_but_not_iso():
    photons = "Photons from the label"
    start = value(EXPOSURE(10, 4, 100, 500, 0, False), photons)
    changes = ((5, 4, 100, 500), (10, 8, 100, 500), (10, 4, 100, 1000), (10, 4, 800, 500))
    for state, factor in zip(changes, (1 / 2, 1 / 4, 2, 1), strict=True):
        assert value(EXPOSURE(*state, 0, False), photons) == pytest.approx(factor * start, rel=1e-4)


def test_the_signal_to_noise_ratio_is_that_of_the_picture():
    frame = EXPOSURE(1, 4, 100, 500, 0, False)
    # Undo the screen's curve to measure in light, linear.
    light = sensor.srgb_decode(label(frame) / 255)
    assert light.mean() / light.std() == pytest.approx(
        value(frame, "Signal to noise, label"), rel=0.1
    )


def test_the_smear_is_as_long_as_it_says():
    frame = EXPOSURE(5, 16, 100, 8000, 800, False)
    blur = value(frame, "Blur by motion")
    assert blur == 20
    row = sensor.srgb_decode(grey(frame)[266:272].mean(axis=0) / 255)  # below the text
    row = row[285:345]
    low, high = np.percentile(row[:12], 50), row[-6:].mean()
    share = (row - low) / (high - low)
    ramp = np.flatnonzero(share > 0.9)[0] - np.flatnonzero(share > 0.1)[0]
    assert ramp == pytest.approx(0.8 * blur, abs=3)


def test_stopping_down_sharpens_the_label():
    open_wide, closed = EXPOSURE(1, 2, 100, 1000, 0, False), EXPOSURE(16, 8, 100, 1000, 0, False)
    blur = "Blur by defocus, label"
    assert value(open_wide, blur) == pytest.approx(4 * value(closed, blur), abs=0.25)
    detail = [np.abs(np.diff(grey(f)[172:230, 322:378])).mean() for f in (open_wide, closed)]
    assert detail[1] > 1.5 * detail[0]


def test_brightening_afterwards_changes_the_picture_and_not_the_numbers():
    dark, bright = (EXPOSURE(0.125, 4, 100, 500, 0, after) for after in (False, True))
    assert label(bright).mean() > 4 * label(dark).mean()
    assert dark.readouts == bright.readouts
    np.testing.assert_array_equal(
        dark.pictures[1].lines[0].points, bright.pictures[1].lines[0].points
    )


def test_too_much_light_is_counted_as_clipped():
    frame = EXPOSURE(50, 1.4, 100, 5000, 0, False)
    assert value(frame, "Clipped to white") > 50
    assert "clipped" in [word.text for word in frame.pictures[1].labels]
    assert value(EXPOSURE(1, 4, 100, 500, 0, False), "Clipped to white") == 0


def test_a_pixel_sees_the_length_on_the_belt_that_the_formula_needs():
    assert exposure.pitch_um() / 1000 * (500 - 25) / 25 == pytest.approx(0.2)


# Rolling shutter


def test_a_global_shutter_shows_straight_blades_and_a_rolling_one_does_not():
    still, rolling = ROLL(20, 20, 0.1, 3, GLOBAL), ROLL(20, 20, 0.1, 3, ROLLING)
    assert (ROLL(0, 20, 0.1, 3, ROLLING).pictures[0].image == still.pictures[0].image).mean() > 0.98
    assert (still.pictures[0].image != rolling.pictures[0].image).any(axis=2).mean() > 0.05
    assert value(still, "Turn from first to last row") == 0
    assert value(rolling, "Turn from first to last row") == 144


def test_the_blur_at_the_tips_follows_the_exposure():
    short, long = ROLL(20, 0, 1, 2, ROLLING), ROLL(20, 0, 4, 2, ROLLING)
    blur = "Blur at the tips"
    assert value(long, blur) == pytest.approx(4 * value(short, blur), abs=0.3)
    assert value(short, blur) == pytest.approx(2 * np.pi * 0.02 * 0.46 * 320, abs=0.1)


def test_the_diagram_ends_when_the_last_row_has_been_exposed():
    frame = ROLL(20, 20, 5, 3, ROLLING)
    band = np.asarray(frame.pictures[1].lines[1].points)
    left, right = rolling_shutter.PLOT[:2]
    time = (band[:, 0] - left) / (right - left) * rolling_shutter.LONGEST
    assert sorted(time.round(6)) == [0, 5, 20, 25]


# The mosaic


def test_each_pixel_of_the_mosaic_has_one_colour():
    image = BAYER(bayer.LABEL, bayer.FILTERS, 30, 0.5, 0.5, 0).pictures[1].image
    assert ((image > 0).sum(axis=2) <= 1).all()
    greens = (image.argmax(axis=2) == 1)[image.any(axis=2)].mean()
    assert greens == pytest.approx(0.5, abs=0.03)


def test_the_green_view_shows_only_green_and_the_grey_view_no_colour():
    green = BAYER(bayer.LABEL, bayer.GREEN, 30, 0.5, 0.5, 0).pictures[1].image
    assert not green[..., [0, 2]].any()
    plain = BAYER(bayer.LABEL, bayer.GREY, 30, 0.5, 0.5, 0).pictures[1].image
    assert np.ptp(plain, axis=2).max() == 0


def test_false_colours_stand_at_edges_and_a_soft_lens_takes_them_away():
    sharp, soft = (BAYER(bayer.STAR, bayer.FILTERS, 60, 0.5, 0.5, s) for s in (0, 1))
    colourful = [np.ptp(f.pictures[2].image.astype(int), axis=2).mean() for f in (sharp, soft)]
    assert colourful[0] > 4 * colourful[1]
    error = "Error of the colours (RMS)"
    assert value(sharp, error) > 3 * value(soft, error)


@pytest.mark.parametrize("subject", [bayer.STAR, bayer.LABEL, bayer.STREET])
@pytest.mark.parametrize("corner", [(0, 0), (1, 1)])
def test_every_part_of_every_subject_can_be_shown(subject, corner):
    for pixels in (8, 30, 240):
        frame = BAYER(subject, bayer.FILTERS, pixels, *corner, 0.5)
        assert value(frame, "Numbers measured") == pixels**2


# Structured light


@pytest.mark.parametrize("shape", ["block", "ramp", "dome", "plate with a groove"])
@pytest.mark.parametrize("angle", [20, 45, 60])
def test_the_shift_gives_the_height(shape, angle):
    frame = STRIPES(shape, 5, angle, ONE, 1)
    found, truth = (value(frame, name) for name in ("Height from the shift", "True height there"))
    assert found == pytest.approx(truth, abs=0.15 / np.tan(np.radians(angle)))


def test_the_stripe_is_seen_where_the_line_of_the_shift_ends():
    frame = STRIPES("block", 5, 40, ONE, 0)
    image = frame.pictures[0].image.astype(int)
    red = np.flatnonzero(image[150, :, 0] - image[150, :, 2] > 60)
    end = np.asarray(frame.pictures[0].lines[1].points)[0, 0]
    assert red.mean() == pytest.approx(end, abs=1)
    assert value(frame, "Shift of the stripe") == pytest.approx(
        50 * np.tan(np.radians(40)), abs=0.6
    )


def test_light_on_an_upright_side_is_not_seen():
    frame = STRIPES("block", 8, 65, ONE, 5)
    shift = next(r for r in frame.readouts if r.label == "Shift of the stripe")
    assert (shift.value, shift.unit) == ("not seen", "")
    assert "not seen" in frame.pictures[0].alt


@pytest.mark.parametrize("place", np.arange(-2, 11, 0.5))
def test_light_on_a_slope_is_seen_everywhere(place):
    for shape in ("ramp", "dome"):
        frame = STRIPES(shape, 8, 65, ONE, place)
        found, truth = (
            value(frame, name) for name in ("Height from the shift", "True height there")
        )
        assert found == pytest.approx(truth, abs=0.06)


def test_light_that_is_not_seen_ends_on_the_upright_side():
    side = STRIPES("block", 8, 65, ONE, 5).pictures[1]
    ray = next(line for line in side.lines if line.role == "ray")
    u, v = np.asarray(ray.points)[-1]
    left = np.flatnonzero(structured_light._heights("block", 8)[150])[0] * 0.1 - 19.95
    assert u == pytest.approx(200 + 9.6 * left, abs=1)
    assert 150 - 9.6 * 8 < v < 150


def test_beside_a_high_block_stripes_are_missing():
    image = STRIPES("block", 8, 65, MANY, 0).pictures[0].image.astype(int)
    red = image[150, :, 0] - image[150, :, 2] > 60
    assert red[290:].sum() == 0  # right of the block, in its shadow
    assert red[120:275].any()  # on the block


def test_an_empty_table_shifts_nothing():
    assert value(STRIPES("dome", 0, 40, MANY, 3), "Shift of the stripe") == 0


def test_the_pointer_reads_the_true_height():
    grid = STRIPES("plate with a groove", 6, 40, MANY, 0).pictures[0].probes[0].values
    assert grid[15].max() == 6
    assert grid[15, 20] == 3


# All of them


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (EXPOSURE(0.1, 22, 100, 200, 0, False), EXPOSURE(50, 1.4, 6400, 50_000, 1000, True)),
        (ROLL(0, 0, 0.1, 2, GLOBAL), ROLL(60, 30, 10, 6, ROLLING)),
        (BAYER(bayer.STAR, bayer.GREY, 8, 0, 0, 0), BAYER(bayer.STREET, bayer.GREEN, 240, 1, 1, 2)),
        (STRIPES("block", 0, 5, ONE, -15), STRIPES("dome", 8, 70, MANY, 15)),
    ],
    ids=["exposure", "rolling shutter", "mosaic", "structured light"],
)
def test_pictures_and_words_follow_the_state(one, other):
    assert one.in_words() != other.in_words()
    for first, second in zip(one.pictures, other.pictures, strict=True):
        assert first.alt != second.alt
        assert first.alt.endswith(".")
    assert (one.pictures[0].image != other.pictures[0].image).any()
