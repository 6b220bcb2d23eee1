"""The explorers of chapter 11 compute what they show."""

from dataclasses import replace

import numpy as np
import pytest

from course_lib.drawing.explorers import flight_planner as air
from course_lib.drawing.explorers import setup_planner as bench
from course_lib.drawing.planning import site
from course_lib.drawing.planning.panel import BOX, TASK, close_up, stand
from course_lib.drawing.style import ROLES, rgb
from course_lib.planning import (
    CameraModel,
    LensModel,
    box_in_view,
    judge_setup,
    plan_flight,
    read_cameras,
    read_lenses,
    views_of_ground,
)
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
    """Return the lines of the table: sign, name, value, limit, and the reason or the remedy."""
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
        (why,) = row[4:]
        assert why == (verdict.reason if verdict.met else verdict.remedy)
        # The words before the limit say which way it is meant.
        above = verdict.value >= verdict.limit
        assert verdict.met == (above if row[3].startswith("at least") else not above)
    assert value(frame, "Demands met") == f"{sum(v.met for v in verdicts)} of 10"


def test_the_words_say_of_each_demand_number_limit_reason_and_what_would_help():
    told = bench.setup_frame(**SETTING | {"N": 5.6}).pictures[2].alt
    assert told.startswith("Table of 10 demands; not met: depth of field. In view: 108 px, ")
    assert "at least 0 px, met. In the picture; the smallest room is 108 px, on the right." in told
    assert (
        "Depth of field: 2.2 px, at most 1.5 px, not met. At the far end of the box a point makes "
        "a spot of 2.2 px. Focus on 2.19 m and stop down to f/8.2. Diffraction: "
    ) in told
    assert told.count(", met.") == 9


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
    fitting = [name for name, lens in bench.lenses().items() if lens.mount == "Nikon F"]
    assert texts[4:] == fitting
    assert f"These lenses fit this camera: {', '.join(fitting)}." in frame.pictures[2].alt


MY_LENS = LensModel("Mine", 70, 2.8, 16, 0.6, 43.3, "Nikon F", "its maker")
MY_CAMERA = CameraModel("Mine, 8 Mpx", (4000, 2000), 3.0, 500, "global", "M42", "its maker")


def test_cameras_and_lenses_of_ones_own_stand_behind_those_of_the_catalogue(tmp_path):
    table = tmp_path / "mine.tsv"
    columns = ["name", "f_mm", "N_least", "N_most", "closest", "image_circle_mm", "mount", "source"]
    table.write_text("\t".join(columns) + "\nTable's\t40\t2\t11\t0.3\t30\tM42\tmeasured\n")
    for lenses in (MY_LENS, [MY_LENS], {"Mine": MY_LENS}):
        planner = setup_planner(lenses=lenses)
        assert planner._controls["lens"].options == (*bench.lenses(), "Mine")
    planner = setup_planner([MY_CAMERA], table)
    assert planner._controls["camera"].options == (*bench.cameras(), "Mine")
    planner.set(camera="Mine")
    assert planner.frame_now().pictures[2].alt.endswith("These lenses fit this camera: Table's.")
    planner.set(lens="Table's", Z=2)
    one = stand(MY_CAMERA, read_lenses(table)["Table's"], 2, np.radians(15), 10, 250e-6)
    seen = box_in_view(BOX.with_motion(TASK.motion), one.view)
    assert rows(planner.frame_now())[0][2] == f"{seen.margins.min():.0f} px"


def test_cameras_that_are_alike_before_the_comma_keep_their_whole_names():
    other = replace(MY_CAMERA, name="Mine, cropped")
    options = setup_planner([MY_CAMERA, other])._controls["camera"].options
    assert options == (*bench.cameras(), "Mine, 8 Mpx", "Mine, cropped")


def test_a_camera_without_any_lens_says_so():
    planner = setup_planner(MY_CAMERA)
    planner.set(camera="Mine")
    assert planner.frame_now().pictures[2].alt.endswith("fit this camera: none.")
    with pytest.raises(ValueError, match="Mine, 8 Mpx has the mount 'M42', and no lens has it"):
        flight_planner(MY_CAMERA)


def test_a_camera_flies_with_ones_own_lens_before_those_of_the_catalogue():
    body, glass = site.drone()
    own = replace(body, name="Mine"), replace(glass, name="Mine", f_mm=2 * glass.f_mm)
    planner = flight_planner(*own)
    heights = []
    for camera in (body.name, "Mine"):
        planner.set(camera=camera)
        heights.append(float(value(planner.frame_now(), "Height")))
    assert heights[1] == pytest.approx(2 * heights[0], abs=1.5)


@pytest.mark.parametrize("wrong", [7, [MY_CAMERA], ["Mine"]])
def test_what_is_no_lens_is_refused_in_a_sentence(wrong):
    with pytest.raises(TypeError, match="lenses must be of LensModel or a table's file name"):
        setup_planner(lenses=wrong)


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
            assert "e+" not in frame.pictures[2].alt  # no power of ten


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


def test_a_drone_of_ones_own_flies_with_the_lens_that_fits_it():
    mine = LensModel("Mine", 20, 2.8, 16, 0.6, 30, "M42", "its maker")
    planner = flight_planner([MY_CAMERA, read_cameras()["Nikon D850"]], mine)
    assert planner._controls["camera"].options[2:] == ("Mine, 8 Mpx", "Nikon D850")
    planner.set(camera="Mine, 8 Mpx", gsd=2)
    assert value(planner.frame_now(), "Height") == f"{0.02 * 20e-3 / 3e-6:.0f}"
    planner.set(camera="Nikon D850")  # with the first lens of the catalogue that fits
    assert value(planner.frame_now(), "Height") == f"{0.02 * 85e-3 / 4.35e-6:.0f}"


def test_hidden_places_are_seen_on_the_map_and_in_the_words():
    sparse = {"forward": 50, "side": 20}
    frame = air.flight_frame(**FLIGHT | sparse)
    plan = site.flight(forward=0.5, side=0.2)
    places = site.grid()[:, :2]
    shown, covered = (
        views_of_ground(plan, places, site.ground),
        site.in_footprints(plan, site.grid()),
    )
    covered = np.bincount(covered[1], minlength=len(places))
    hidden = (shown < 2) & (covered >= 2)
    assert 0 < hidden.sum() < np.sum(shown < covered)
    picture = frame.pictures[0]
    for number in range(len(places)):
        u, v = (round(x) for x in air.PLAN.at(*places[number]))
        field = picture.image[v - 5 : v + 5, u - 5 : u + 5].reshape(-1, 3).tolist()
        assert (list(rgb(ROLES["second"])) in field) == hidden[number]
        assert ([0, 0, 0] in field) == (shown[number] < covered[number])
    inside = site.in_area(site.AREA)
    partly = 100 * np.mean((shown < covered)[inside])
    assert value(frame, "Area hidden from some pictures") == f"{partly:.0f}"
    assert f"{partly:.0f} % of the area are hidden from some pictures, " in picture.alt
    assert f"{100 * np.mean(hidden[inside]):.0f} % so that fewer than two remain." in picture.alt
    flat = air.flight_frame(**FLIGHT | sparse | {"hilly": False})
    assert value(flat, "Area hidden from some pictures") == "0"
    assert not (flat.pictures[0].image[30:390, 46:496] == 0).all(axis=2).any()


def test_the_footprints_of_the_first_line_are_on_the_map():
    frame = air.flight_frame(**FLIGHT | {"hilly": False})
    plan = site.flight()
    footprints = plan.footprints()[plan.strips == 0]
    (first,) = by_role(frame.pictures[0], "object")
    corners = air.PLAN.pixels(*footprints[0].T)
    there = corners[np.isfinite(corners[:, 0])]
    assert len(there) == 2  # the others are beyond the map
    assert all(np.nanmin(np.abs(first - corner).max(axis=1)) < 1e-3 for corner in there)
    red = np.array(rgb(ROLES["object"]))
    for footprint in footprints[2:8]:
        u, v = (round(x) for x in air.PLAN.at(footprint[:, 0].max(), 203))
        row = frame.pictures[0].image[v, u - 3 : u + 4].astype(int)
        assert np.abs(row - red).sum(axis=1).argmin() == 3
        assert np.abs(row[3] - row[0]).sum() > 60


def test_segments_end_at_the_edges_of_the_axes():
    inside = air.PLAN.within([[(-50, 120), (350, 120)], [(10, 10), (10, 10.5)], [(-9, 0), (-9, 9)]])
    left, right, top, bottom = air.PLAN.box
    middle = (top + bottom) / 2
    assert inside.shape == (2, 2, 2)
    np.testing.assert_allclose(inside[0], [(left, middle), (right, middle)])
    np.testing.assert_allclose(inside[1], air.PLAN.pixels([10, 10], [10, 10.5]))
    (slanted,) = air.PLAN.within([[(-100, -80), (400, 320)]])
    np.testing.assert_allclose(slanted, [(left, bottom), (right, top)])


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
