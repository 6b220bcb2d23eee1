"""Things on a table under slanted light."""

import numpy as np
import pytest

from data_generators import relief

SIZE, PIXEL = (400, 300), 0.1
ANGLE = np.radians(40)


@pytest.mark.parametrize("shape", relief.SHAPES)
def test_shapes_are_as_high_as_asked_and_the_table_is_flat(shape):
    heights = relief.height_map(shape, 5, SIZE, PIXEL)
    assert heights.shape == (300, 400)
    assert heights.max() == pytest.approx(5, abs=0.05)
    assert heights[0].max() == heights[:, 0].max() == heights.min() == 0
    assert relief.height_map(shape, 0, SIZE, PIXEL).max() == 0


def test_light_lands_farther_left_on_what_is_high():
    heights = relief.height_map("block", 5, SIZE, PIXEL)
    place, lit = relief.on_the_table(heights, ANGLE, PIXEL)
    x = (np.arange(400) - 199.5) * PIXEL
    assert lit[150, 200]
    assert place[150, 200] == pytest.approx(x[200] + 5 * np.tan(ANGLE))
    np.testing.assert_allclose(place[0], x)


def test_the_shadow_is_as_long_as_the_geometry_says():
    heights = relief.height_map("block", 5, SIZE, PIXEL)
    _, lit = relief.on_the_table(heights, ANGLE, PIXEL)
    assert (~lit[150]).sum() * PIXEL == pytest.approx(5 * np.tan(ANGLE), abs=2 * PIXEL)
    assert lit[150, : 200 - 82].all()
    assert lit[0].all()


def test_light_from_above_throws_no_shadow():
    heights = relief.height_map("dome", 5, SIZE, PIXEL)
    place, lit = relief.on_the_table(heights, 0, PIXEL)
    assert lit.all()
    np.testing.assert_allclose(np.diff(place, axis=1), PIXEL)


def test_stripes_have_their_period_and_width_on_the_table():
    light = relief.striped(np.zeros((4, 400)), ANGLE, PIXEL, period=3, width=0.8)
    bright = light[0] > 0.5
    assert bright.mean() == pytest.approx(0.8 / 3, abs=0.02)
    starts = np.flatnonzero(bright[1:] & ~bright[:-1])
    np.testing.assert_allclose(np.diff(starts) * PIXEL, 3, atol=0.11)
    assert light.min() == pytest.approx(relief.ROOM)


def test_errors():
    with pytest.raises(ValueError, match="no shape 'cone'; there are block"):
        relief.height_map("cone", 5, SIZE, PIXEL)
    with pytest.raises(ValueError, match="height must not be negative, got -1 mm"):
        relief.height_map("dome", -1, SIZE, PIXEL)
