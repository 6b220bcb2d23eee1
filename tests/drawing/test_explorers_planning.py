"""The explorers of chapter 11 compute what they show."""

import numpy as np
import pytest

from course_lib.drawing.explorers import flight_planner as air
from course_lib.drawing.explorers import setup_planner as bench
from course_lib.drawing.planning import site
from course_lib.drawing.planning.panel import BOX, TASK, close_up, stand
from course_lib.drawing.style import rgb
from course_lib.planning import box_in_view, judge_setup, plan_flight, views_of_ground
from course_lib.widgets.planning import flight_planner, setup_planner

SETTING = {"camera": "Phantom v2640", "lens": "Zeiss Milvus 1.4/85"}
SETTING |= {"Z": 2.2, "turn_deg": 15, "N": 10, "t": 250}
FLIGHT = flight_planner().state


def value(frame, label):
    (reading,) = (r for r in frame.readouts if r.label == label)
    return reading.value


def by_role(picture, role):
    return [np.asarray(drawn.points) for drawn in picture.lines if drawn.role == role]


def rows(frame):
    """Return the lines of the table: sign, name, value, limit, and the remedy or nothing."""
    found = []
    for label in frame.pictures[2].labels:
        if label.text in "✓✗":
            found.append([])
        found[-1].append(label.text)
    return found


def pair(**changes):
    s = SETTING | changes
    body, glass = bench.cameras()[s["camera"]], bench.lenses()[s["lens"]]
    turn = np.radians(s["turn_deg"])
    return [stand(body, glass, s["Z"], side * turn, s["N"], s["t"] / 1e6) for side in (1, -1)]


# Plan a set-up


@pytest.mark.parametrize(
    "changes", [{}, {"N": 5.6}, {"t": 1000}, {"turn_deg": 30}, {"Z": 1.2}, {"Z": 5, "t": 60}]
)
def test_the_table_is_the_verdict_of_the_library(changes):
    frame = bench.setup_frame(**SETTING | changes)
    one, other = pair(**changes)
    verdicts = judge_setup(one, TASK, other)
    table = rows(frame)
    assert [row[1] for row in table] == [v.name for v in verdicts]
    assert [row[0] == "✓" for row in table] == [v.met for v in verdicts]
    for row, verdict in zip(table, verdicts, strict=True):
        number = float(row[2].split()[0])
        assert number == pytest.approx(verdict.value, rel=0.006, abs=0.5 * (abs(number) >= 99))
        assert len(row) == 4 + (not verdict.met)
        assert verdict.met or verdict.remedy.startswith(row[4].removesuffix(" …"))
        # The words before the limit say which way it is meant.
        above = verdict.value >= verdict.limit
        assert verdict.met == (above if row[3].startswith("at least") else not above)
    assert value(frame, "Demands met") == f"{sum(v.met for v in verdicts)} of 10"


def test_the_box_is_drawn_where_the_camera_sees_it():
    frame = bench.setup_frame(**SETTING)
    one, _ = pair()
    seen = box_in_view(BOX.with_motion(TASK.motion), one.view)
    (drawn,) = by_role(frame.pictures[0], "image")
    drawn = drawn[np.isfinite(drawn[:, 0])]
    scale = bench.VIEW_SIZE[0] / one.view.image_size[0]
    wanted = scale * (seen.pixels + 0.5) - 0.5
    np.testing.assert_allclose(drawn.min(axis=0), wanted.min(axis=0), atol=0.01)
    np.testing.assert_allclose(drawn.max(axis=0), wanted.max(axis=0), atol=0.01)


def test_a_box_that_is_cut_off_is_red_and_stays_in_the_picture():
    picture = bench.setup_frame(**SETTING | {"Z": 1.2}).pictures[0]
    assert "is cut off" in picture.alt
    (drawn,) = by_role(picture, "object")
    drawn = drawn[np.isfinite(drawn[:, 0])]
    assert (drawn >= -0.5).all()
    assert (drawn <= np.array(picture.size) - 0.5).all()


def test_the_enlarged_pixels_are_those_of_the_picture():
    picture = bench.setup_frame(**SETTING).pictures[1]
    one, _ = pair()
    for end, top in enumerate(bench.TOPS):
        part = picture.image[top : top + bench.SIDE * bench.TIMES : bench.TIMES]
        part = part[:, 5 : 5 + bench.SIDE * bench.TIMES : bench.TIMES]
        np.testing.assert_array_equal(part, close_up(one, end, bench.SIDE))


def test_an_aperture_that_the_lens_has_not_is_the_nearest_that_it_has():
    frame = bench.setup_frame(**SETTING | {"lens": "Nikkor AF-S 50 mm f/1.8G", "N": 1.4})
    assert value(frame, "f-number") == "1.8"


def test_a_lens_that_does_not_fit_is_refused_in_words():
    frame = bench.setup_frame(**SETTING | {"lens": "Computar M1614-MP2"})
    texts = [label.text for label in frame.pictures[2].labels]
    assert "has the mount C" in texts[1]
    assert texts[2] == "Phantom v2640 has Nikon F"
    assert set(texts[4:]) == {
        name for name, lens in bench.lenses().items() if lens.mount == "Nikon F"
    }


@pytest.mark.parametrize("camera", bench.cameras())
@pytest.mark.parametrize("lens", bench.lenses())
def test_every_camera_with_every_lens_everywhere(camera, lens):
    controls = setup_planner()._controls
    for Z in (controls["Z"].positions[0], controls["Z"].positions[-1]):
        for turn in (controls["turn_deg"].positions[0], controls["turn_deg"].positions[-1]):
            frame = bench.setup_frame(camera, lens, Z, turn, 1.4, 20)
            assert [picture.size for picture in frame.pictures] == [
                bench.VIEW_SIZE,
                bench.PIXELS_SIZE,
                bench.TABLE_SIZE,
            ]


# Plan a flight


def test_the_map_counts_pictures():
    frame = air.flight_frame(**FLIGHT | {"forward": 60, "side": 30})
    plan = plan_flight(site.AREA, *site.drone(), 0.02, 0.6, 0.3, np.pi / 2)
    seen = views_of_ground(plan, site.grid()[:, :2], site.ground)
    for number in (3, 200, 371, 500, 700):
        u, v = (round(x) for x in air.PLAN.at(*site.grid()[number, :2]))
        step = np.digitize(seen[number], air.STEPS) - 1
        assert tuple(frame.pictures[0].image[v, u]) == rgb(air.COLOURS[step])
    inside = seen[site.in_area(site.AREA)]
    assert value(frame, "Fewest pictures of a place") == f"{inside.min()}"
    assert float(value(frame, "Area in fewer than 3 pictures")) == pytest.approx(
        100 * np.mean(inside < 3), abs=1.1
    )
    assert value(frame, "Pictures") == f"{len(plan.centres)} in 2 lines"


def test_a_corner_is_dragged_to_where_the_pointer_is():
    picture = air.flight_frame(**FLIGHT).pictures[0]
    assert len(picture.handles) == 4
    at = air.PLAN.at(205.0, 95.0)
    moved = {n: a + b * at[0] + c * at[1] for n, a, b, c in picture.handles[2].moves}
    assert moved == {"x3": pytest.approx(205), "y3": pytest.approx(95)}


def test_speed_and_time_are_those_of_the_formula():
    frame = air.flight_frame(**FLIGHT)
    plan = site.flight()
    speed = min(plan.base / 2.5, 0.5 * 0.02 * 1000)
    assert value(frame, "Speed") == f"{speed:.1f}"
    minutes = (plan.length / speed + 2 * 5) / 60
    assert value(frame, "Time in the air") == f"{minutes:.1f}"


def test_corners_on_a_line_are_no_area():
    line = {"x1": 10, "y1": 10, "x2": 50, "y2": 50, "x3": 100, "y3": 100, "x4": 150, "y4": 150}
    frame = air.flight_frame(**FLIGHT | line)
    assert "no area" in frame.readouts[0].value
    assert len(frame.pictures[0].handles) == 4


def test_an_area_between_the_places_that_are_counted():
    tiny = {"x1": 1, "y1": 1, "x2": 2, "y2": 1, "x3": 2, "y3": 2, "x4": 1, "y4": 2}
    frame = air.flight_frame(**FLIGHT | tiny)
    assert value(frame, "Area in fewer than 3 pictures") == "0"


def test_what_runs_out_of_the_map_ends_at_its_edge():
    picture = air.flight_frame(**FLIGHT | {"gsd": 4.0, "heading": 30}).pictures[0]
    left, right, top, bottom = air.PLAN.box
    for drawn in picture.lines:
        points = np.asarray(drawn.points)
        points = points[np.isfinite(points[:, 0])]
        assert (points >= [left - 2, top - 2]).all()
        assert (points <= [right + 2, bottom + 2]).all()
