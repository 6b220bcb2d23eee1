"""The figures of chapter 11: each draws, says what it shows, and shows the right thing."""

from dataclasses import replace

import matplotlib as mpl
import numpy as np
import pytest
from legible import Legible

mpl.use("Agg")  # as a test has no screen

from course_lib.drawing import planning as draw
from course_lib.drawing.planning import choosing, flying, panel, site
from course_lib.drawing.style import ROLES
from course_lib.planning import box_in_view, read_cameras, read_lenses, views_of_ground

FIGURES = {
    "box_in_picture": draw.box_in_picture,
    "failures": draw.failures,
    "flight_map": draw.flight_map,
    "hidden": draw.hidden,
    "overlaps": draw.overlaps,
    "rig": draw.rig,
    "room_for_aperture": draw.room_for_aperture,
    "smallest_object": draw.smallest_object,
    "verdicts": draw.verdicts,
}
NO_FIGURES = {"AREA", "BOX", "TASK", "chosen", "compared", "counts", "drone", "flight", "ground"}
NO_FIGURES |= {"in_area", "limits", "pair", "panel_task", "stand"}


@pytest.fixture(scope="module", params=FIGURES)
def figure(request):
    drawn = FIGURES[request.param]()
    drawn.draw_without_rendering()
    return drawn


def lines(ax, role):
    """Return the data of the lines that have the colour of a role."""
    found = [line for line in ax.lines if line.get_color() == ROLES[role]]
    return [np.asarray(line.get_xydata()) for line in found]


class TestEachFigure(Legible):
    UNITS = ("px", "mm", "m", "°", "no unit")
    WHITE_ON_DARK = True


def test_every_function_is_tried_here():
    assert set(FIGURES) | NO_FIGURES == set(draw.__all__)


# First sitting


def test_both_ends_are_equally_sharp():
    setup = draw.chosen()
    near, far = panel.depth_range(draw.BOX, setup.view)
    from course_lib.planning.setup import blur_of

    spots = blur_of(setup, [near, far])
    assert spots[0] == pytest.approx(spots[1])


def test_the_picture_shows_the_room_that_it_says():
    (ax,) = draw.box_in_picture().axes
    seen = box_in_view(draw.BOX.with_motion(draw.TASK.motion), draw.chosen().view)
    texts = {text.get_text() for text in ax.texts}
    assert texts == {f"{room:.0f} px" for room in seen.margins}
    corners = next(c for c in lines(ax, "ray") if len(c) == 8)
    np.testing.assert_allclose(corners, seen.pixels)


def test_stars_are_at_the_ends_of_the_box():
    Z = panel.ENDS @ draw.chosen().view.R[2] + draw.chosen().view.t[2]
    near, far = panel.depth_range(draw.BOX, draw.chosen().view)
    np.testing.assert_allclose(Z, [near, far], atol=0.01)


def contrast(picture):
    return float(picture.astype(float).std())


def test_close_ups_lose_what_the_settings_lose():
    setup = draw.chosen()
    good = panel.close_up(setup, 0)
    for change in ({"N": 2.8, "exposure_time": 1 / 4000}, {"exposure_time": 1 / 1000}):
        assert contrast(panel.close_up(replace(setup, **change), 0)) < 0.9 * contrast(good)
    dark = panel.close_up(replace(setup, exposure_time=1 / 20000), 0)
    assert dark.mean() < 0.6 * good.mean()
    # A quarter of the light: 200 µs are needed.
    assert dark.max() / good.max() == pytest.approx(0.25 ** (1 / 2.2), abs=0.02)


def test_a_smear_is_upright():
    """The shaker moves the panel up and down: edges along the motion stay sharp."""
    picture = np.zeros((31, 31, 3), np.uint8)
    picture[:, 15:] = 200
    np.testing.assert_array_equal(panel._exposed(picture, 7.3, 1.0), picture)
    assert (np.diff(panel._exposed(picture.transpose(1, 0, 2), 7.3, 1.0)[:, 3, 0]) > 0).sum() >= 7


def test_the_table_has_a_cross_where_a_demand_is_missed():
    texts = [text.get_text() for text in draw.verdicts().axes[0].texts]
    missed = sum(not v.met for _, verdicts in draw.compared() for v in verdicts)
    assert sum(text.startswith("✗") for text in texts) == missed > 5
    assert sum(text.startswith("✓") for text in texts) == 5 * 10 - missed


def test_the_room_for_the_aperture_ends_where_demands_touch():
    (ax,) = draw.room_for_aperture().axes
    left, right = (line[0, 0] for line in lines(ax, "object"))
    assert choosing.limits(np.radians(left))[3] == pytest.approx(draw.TASK.sigma, rel=2e-3)
    assert choosing.limits(np.radians(right))[4] == pytest.approx(draw.TASK.resolution, rel=2e-3)


def test_shown_numbers():
    assert [choosing.shown(x) for x in (99.4, 99.6, 6600, 0.0957, -579.94)] == [
        "99.4", "100", "6600", "0.0957", "-580",
    ]  # fmt: skip


def test_the_panel_task_is_that_of_the_catalogue():
    task, cameras, lenses = draw.panel_task()
    assert task["width"] == 0.6
    assert task["speed"] == draw.TASK.speed
    assert cameras[1]["frame_rate"] == read_cameras()[panel.PHANTOM].frame_rate
    assert lenses[1]["closest"] == read_lenses()[panel.ZEISS].closest


# Second sitting


def test_crosses_are_as_large_as_they_say():
    for size in (2, 3, 5, 10):
        light = (flying.crosses(size) - 0.2).sum() / 0.75
        assert light == pytest.approx(5 / 9 * size**2, rel=0.03)  # of a cross of thirds


def test_green_footprints_contain_the_dotted_place():
    for ax, number in zip(draw.overlaps().axes, (2, 3, 5), strict=True):
        ((place, _), *_) = lines(ax, "object")[0]
        fields = lines(ax, "image")
        assert len(fields) == number
        assert all(field[0, 0] < place < field[-1, 0] for field in fields)
        grey = [field for field in lines(ax, "guide") if np.ptp(field[:, 0]) == pytest.approx(1)]
        assert all(not field[0, 0] < place < field[-1, 0] for field in grey)


@pytest.mark.parametrize("settings", [{}, {"forward": 0.6, "side": 0.3}, {"heading": 0.7}])
def test_looked_up_horizons_count_as_rays_do(settings):
    plan = draw.flight(**settings)
    quick = draw.counts(plan)
    slow = views_of_ground(plan, site.grid()[:, :2], draw.ground)
    assert np.abs(quick - slow).max() <= 1
    assert np.mean(quick == slow) > 0.985
    flat = draw.counts(plan, hilly=False)
    assert (flat == views_of_ground(plan, site.grid()[:, :2])).all()


def test_walls_hide_something():
    plan = draw.flight()
    _, number = site.in_footprints(plan, site.grid())
    without = np.bincount(number, minlength=len(site.grid()))
    assert (draw.counts(plan) <= without).all()
    assert (without - draw.counts(plan)).max() >= 3


def test_the_ground_is_a_pit_and_a_heap():
    assert draw.ground(*site.PIT) == -site.DEPTH
    assert draw.ground(*site.HEAP) == site.TOP
    assert draw.ground(5, 5) == 0
    x = np.array([60.0, 60 + site.WALL * site.HALF_AXES[0] / min(site.HALF_AXES)])
    np.testing.assert_allclose(draw.ground(x, site.PIT[1]), [0, -site.DEPTH])


def test_the_hidden_part_begins_at_the_wall_and_ends_at_the_ray():
    (ax,) = draw.hidden().axes
    (part,) = lines(ax, "object")
    ray = lines(ax, "ray")[0]
    assert part[1, 0] == pytest.approx(ray[1, 0])
    assert draw.ground(part[0, 0] + 1e-9, site.PIT[1]) == pytest.approx(-site.DEPTH)


def test_the_map_shows_the_flight():
    plan = draw.flight()
    (ax,) = draw.flight_map(plan).axes
    assert any(np.array_equal(line, plan.centres[:, :2]) for line in lines(ax, "camera"))
    first = lines(ax, "object")[0]
    np.testing.assert_allclose(first[:4], plan.footprints()[0])
