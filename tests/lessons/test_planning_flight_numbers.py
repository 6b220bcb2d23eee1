"""The numbers that the text of chapter 11 states of flights."""

import numpy as np
import pytest
from lesson_text import about, lesson_text

from course_lib.drawing import planning as draw
from course_lib.drawing.planning import flying, site
from course_lib.exercises.planning import plain
from course_lib.planning import ground_sample_distance, photo_count
from course_lib.planning.flight import SMALLEST_OBJECT
from course_lib.widgets.planning import flight_planner

says = lesson_text("11_planning").says
FLIGHT = draw.flight()


def test_ground_sampling_distances():
    assert plain.ground_sample_distance(100, 8.8, 2.41) == about(0.0274, 4)
    camera, lens = draw.drone()
    assert (camera.pitch_um, lens.f_mm, camera.image_size) == (2.41, 8.8, (5472, 3648))
    assert about(73, 0) == FLIGHT.H
    assert float(ground_sample_distance(93, 8.8, 2.41)) == about(0.025, 3)
    assert (site.DEPTH, site.TOP) == (20, 14)
    says("the pit is 20 m deep, and has a heap of 14 m", "On the floor of the pit it is 2.5 cm")


def test_the_smallest_object():
    """Of crosses of so many pixels: at 1 a grey pixel, at 3 as light and as large as it is."""
    assert SMALLEST_OBJECT == 3
    says("The rule of thumb says: **3 GSD**", "| Smallest object | 3 GSD | 6 cm |")
    assert about(0.06, 2) == 3 * 0.02
    light = {n: (flying.crosses(n).max() - 0.2) / 0.75 for n in (1, 2, 3)}
    size = {n: np.ptp(np.argwhere(flying.crosses(n) > 0.3), axis=0) + 1 for n in (1, 2, 3)}
    says("At 1 GSD it is a grey pixel. At 3 GSD you see that something is there, and how large")
    assert light[1] < 0.4
    assert size[1].tolist() == [1, 1]
    assert light[3] > 0.95
    assert set(size[3].tolist()) == {3, 4}
    lowest = 3 * 100 * plain.ground_sample_distance(FLIGHT.H + site.DEPTH, 8.8, 2.41)
    assert numbers()["Smallest object found there"] == f"{lowest:.1f}"


def test_overlaps():
    width, depth = (0.02 * n for n in draw.drone()[0].image_size)
    assert (width, depth) == (about(109.4, 1), about(73.0, 1))
    assert plain.base_for_overlap(0.8, depth) == about(14.6, 1)
    assert plain.base_for_overlap(0.6, width) == about(43.8, 1)
    assert plain.base_for_overlap(2 / 3, 1) == pytest.approx(1 / 3)
    assert plain.overlap(14.592, 72.96 * 59.03 / 73.03) == about(0.75, 2)
    assert plain.overlap(14.592, 72.96 * 93.03 / 73.03) == about(0.84, 2)
    says("80 % become 75 %, and in the pit 84 %", "**67 %**", "**80 %**", "109.4 × 73.0 m")


def test_speeds():
    assert plain.max_speed(18, 2, 0.02, 1 / 1000, 0.5) == pytest.approx(9)
    assert plain.max_speed(18, 2, 0.02, 1 / 500, 0.5) == pytest.approx(5)
    sun = plain.max_speed(14.592, 2.5, 0.02, 1 / 1000, 0.5)
    assert sun == about(5.8, 1)
    assert sun == pytest.approx(14.592 / 2.5)  # the pictures decide
    assert plain.max_speed(14.592, 2.5, 0.02, 1 / 250, 0.5) == pytest.approx(2.5)
    assert 1 / draw.drone()[0].frame_rate == 2.5
    says("| 5.8 m/s |", "needs 2.5 s from picture to picture")


def test_counts():
    assert plain.photo_count(500, 300, 18, 36, 110) == (29, 7)
    assert 29 * 7 == 203
    assert photo_count(240, 180, 14.592, 43.776, 109.44) == (18, 3)
    assert np.bincount(FLIGHT.strips).tolist() == [18, 18, 18]
    seen = draw.counts(FLIGHT)[draw.in_area(draw.AREA)]
    assert seen.min() == 4
    middle = np.hypot(*(site.grid()[draw.in_area(draw.AREA), :2] - [150, 115]).T) < 40
    assert seen[middle].min() >= 9
    edge = draw.in_area(draw.AREA) & (np.abs(site.grid()[:, 1] - 35) < 5)
    assert set(draw.counts(FLIGHT)[edge]) == {4, 5}
    says("18 pictures in each of 3 lines", "sees it, in 4 or 5 pictures")


def test_what_the_edge_hides():
    assert about(14.8, 1) == 54 * 20 / 73
    wall = site.WALL * site.HALF_AXES[0] / min(site.HALF_AXES)
    assert wall == about(3.6, 1)
    assert 54 * 20 / FLIGHT.H - wall == about(11, 0)
    assert wall > 6 * 20 / FLIGHT.H  # from C nothing is hidden
    says("$54\\cdot 20/73 = 14.8$ m", "takes 3.6 m of it", "11 m wide")


def numbers(**changes):
    planner = flight_planner()
    frame = planner._frame(**planner.state | changes)
    return {r.label: r.value for r in frame.readouts}


def test_what_the_flight_planner_shows():
    few, least = "Area in fewer than 3 pictures", "Fewest pictures of a place"
    assert numbers(forward=60, side=30)[few] == "34"
    assert numbers(forward=60, side=30, hilly=False)[few] == "44"
    assert [numbers(forward=f, side=30)[least] for f in (68, 70, 72, 74, 76)] == ["2"] * 4 + ["3"]
    flat = [numbers(forward=f, side=30, hilly=False)[least] for f in (66, 68)]
    assert flat == ["2", "3"]
    assert numbers()["Area hidden from some pictures"] == "4"
    says("are hatched: 4 % of the area, with the flight of section 10")
    says("1. 34 % of the area; on flat ground 44 %.", "2. 76 %. (On flat ground 68 %")
    assert (numbers()["Pictures"], numbers()["Time in the air"]) == ("54 in 3 lines", "2.5")
    fine = numbers(gsd=1)
    assert (fine["Pictures"], fine["Time in the air"]) == ("238 in 7 lines", "10.9")
    assert [n["GSD on the lowest ground"] for n in (numbers(), fine)] == ["2.55", "1.55"]
    says("covers 1.55 cm, not half of 2.55")
    says("238 pictures instead of 54, in 7 lines instead of 3", "10.9 minutes instead of 2.5")
    narrow = {"x1": 30, "y1": 80, "x2": 270, "y2": 80, "x3": 270, "y3": 140, "x4": 30, "y4": 140}
    along, across = numbers(**narrow), numbers(**narrow, heading=0)
    assert (along["Pictures"], along["Time in the air"]) == ("18 in 1 line", "0.7")
    assert (across["Pictures"], across["Time in the air"]) == ("24 in 4 lines", "1.5")
    says("one line of 18 pictures takes 0.7 minutes; across, 4 lines of 6 take 1.5")
