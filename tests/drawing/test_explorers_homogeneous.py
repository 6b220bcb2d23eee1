import numpy as np
import pytest

from course_lib.camera import project_pinhole
from course_lib.drawing.explorers import join_meet
from course_lib.drawing.explorers import street as scenery
from course_lib.drawing.explorers import whole_camera as whole
from course_lib.transforms import look_at
from data_generators.render import radiance
from data_generators.scene import Scene

MEET = join_meet.join_meet_frame
WHOLE = whole.whole_camera_frame


def state(**changes):
    return whole.FIRST | changes


def value(frame, label):
    (reading,) = (r for r in frame.readouts if r.label == label)
    return reading


def table(frame, label):
    return np.array(value(frame, label).rows, dtype=float)


# The whole camera


def test_the_matrices_shown_are_those_of_the_camera():
    numbers = state(f=700, aspect=1.2, skew=60, cx=199.5, pan=30, tilt=-10, roll=20, x=-2)
    frame, camera = WHOLE(**numbers), whole.whole_camera(**numbers)
    K, pose = table(frame, "Intrinsics"), table(frame, "Extrinsics")
    np.testing.assert_allclose(K, [[700, 60, 199.5], [0, 840, 179.5], [0, 0, 1]])
    np.testing.assert_allclose(pose[:, :3] @ (-2, -3.5, 1.6), -pose[:, 3], atol=0.01)
    P = table(frame, "Camera matrix")
    np.testing.assert_allclose(P, camera.K @ np.column_stack([camera.R, camera.t]), atol=0.051)


def test_the_lamp_is_ringed_where_its_numbers_say():
    frame = WHOLE(**state(pan=10))
    x, y, w = map(float, value(frame, "Lamp times P").value.strip("()").split(","))
    ring = np.asarray(frame.pictures[0].lines[0].points).mean(axis=0)
    np.testing.assert_allclose(ring, [x / w, y / w], atol=0.2)
    assert value(frame, "Lamp in the picture").value == f"({ring[0]:.0f}, {ring[1]:.0f})"


def test_a_lamp_behind_the_camera_is_nowhere():
    frame = WHOLE(**state(pan=180))
    assert value(frame, "Lamp in the picture").value == "nowhere: it is behind the camera"
    assert not frame.pictures[0].lines
    assert frame.pictures[0].alt.endswith("The lamp is nowhere: it is behind the camera.")


def test_no_number_of_the_camera_is_minus_zero():
    frame = WHOLE(**state(x=-0.0, y=-0.04, pan=180))
    assert "from (0.0, 0.0, 1.6) m" in frame.pictures[0].alt
    assert "at (0.0, 0.0, 1.6) m" in frame.pictures[1].alt
    assert "-0," not in value(frame, "Lamp times P").value


@pytest.mark.parametrize(
    ("angle", "way"), [("pan", (-1, 0)), ("tilt", (0, -1))], ids=["pan", "tilt"]
)
def test_the_camera_turns_towards_what_was_left_or_above(angle, way):
    turned = whole.whole_camera(**state(tilt=0) | {angle: 10})
    straight = whole.whole_camera(**state(tilt=0))
    seen = straight.project(turned.centre + 5 * turned.R[2]) - straight.K[:2, 2]
    np.testing.assert_allclose(seen / np.linalg.norm(seen), way, atol=1e-12)


def test_a_camera_rolled_clockwise_sees_the_world_turned_the_other_way():
    camera = whole.whole_camera(**state(tilt=0, roll=20))
    low, high = camera.project([[0.5, 4, 1.6], [0.5, 4, 2.6]])
    up = (high - low) / np.linalg.norm(high - low)
    np.testing.assert_allclose(up, [-np.sin(np.radians(20)), -np.cos(np.radians(20))], atol=1e-12)


def test_without_a_turn_it_is_the_upright_camera_of_look_at():
    np.testing.assert_allclose(whole.turned(0, 0, 0), look_at((0, 0, 0), (0, 1, 0))[0], atol=1e-15)
    pan, tilt = 0.3, 0.2
    ahead = (-np.sin(pan) * np.cos(tilt), np.cos(pan) * np.cos(tilt), np.sin(tilt))
    np.testing.assert_allclose(whole.turned(pan, tilt, 0), look_at((0, 0, 0), ahead)[0], atol=1e-12)


def test_the_photograph_shows_skew_and_aspect_as_rays_do():
    camera = whole.whole_camera(**state(skew=150, aspect=1.4, roll=10, f=500))
    small = Scene(scenery.renderer().scene.patches, scenery.renderer().scene.background)
    quick = scenery.renderer().picture(camera).astype(float) / 255
    difference = np.abs(quick - radiance(small, camera, samples=2))
    assert difference.mean() < 0.01
    other = scenery.renderer().picture(whole.whole_camera(**state(aspect=1.4, roll=10, f=500)))
    assert np.abs(quick - other / 255).mean() > 0.05


def test_the_axes_are_drawn_two_metres_long_from_the_centre():
    frame = WHOLE(**state(pan=25, roll=10))
    camera, (view, *_) = whole.whole_camera(**state(pan=25, roll=10)), whole._bird()
    axes = [np.asarray(line.points) for line in frame.pictures[1].lines if line.role == "second"]
    for row, axis in zip(camera.R, axes, strict=True):
        ends = np.array([camera.centre, camera.centre + 2 * row])
        inside = project_pinhole(ends @ view.R.T + view.t, np.diag(view.K)[:2], view.K[:2, 2])
        np.testing.assert_allclose(axis, inside, atol=1e-9)


def test_the_view_from_outside_stays_the_same_array():
    assert WHOLE(**state()).pictures[1].image is WHOLE(**state(pan=50)).pictures[1].image


# Join and meet


def test_the_meeting_point_lies_on_both_lines():
    frame = MEET(0.3, 0.7, -0.4, -0.7)
    x, y = map(float, value(frame, "In the plane").value.strip("()").split(","))
    assert (x, y) == (-2.0, 0.1)
    assert y == pytest.approx(0.3 * x + 0.7)
    assert y == pytest.approx(-0.4 * x - 0.7)


def test_no_number_of_the_meeting_point_is_minus_zero():
    assert "(0.00, -3.00)" in MEET(0.5, -3, -2, -3).in_words()


def test_parallel_lines_meet_at_infinity_in_their_direction():
    frame = MEET(0.5, 1, 0.5, -1)
    point = value(frame, "They meet in").value
    assert point == "(2, 1, 0)"
    assert value(frame, "In the plane").value == "at infinity, direction (2, 1)"
    arrows = [np.asarray(line.points) for line in frame.pictures[0].lines[-2:]]
    ways = [(arrow[1] - arrow[0]) / np.abs(arrow[1, 0] - arrow[0, 0]) for arrow in arrows]
    np.testing.assert_allclose(sorted(map(tuple, ways)), [(-1, 0.5), (1, -0.5)])  # v points down


def test_one_line_twice_meets_everywhere():
    frame = MEET(0.5, 1, 0.5, 1)
    assert value(frame, "In the plane").value == "everywhere: it is one line"
    assert value(frame, "They meet in").value == "(0, 0, 0)"


@pytest.mark.parametrize(("r", "tip"), [(0.2, -1), (0.4, 1)])
def test_an_arrow_points_the_way_to_a_point_off_the_page(r, tip):
    lines = MEET(0.3, 1, r, -1).pictures[0].lines
    arrow = np.asarray(lines[-1].points)
    assert np.sign(arrow[1, 0] - arrow[0, 0]) == tip


def test_the_ray_goes_through_the_meeting_point_on_the_sheet():
    frame = MEET(0.3, 0.2, -0.4, -0.3)
    x, y = -0.5 / 0.7, 0.3 * -0.5 / 0.7 + 0.2
    marks = [line for line in frame.pictures[1].lines if line.role == "object" and line.fill]
    centres = [np.asarray(mark.points).mean(axis=0) for mark in marks]
    expected = join_meet._seen(np.array([x, y, 1.0]))
    assert min(np.linalg.norm(c - expected) for c in centres) < 1e-9


def test_both_lines_are_named_in_both_pictures_and_in_words():
    frame = MEET(0.3, 0.7, -0.4, -0.7)
    plane, space = ({label.text: label.role for label in p.labels} for p in frame.pictures)
    assert (plane["line l"], plane["line m"]) == (space["l"], space["m"]) == ("camera", "image")
    assert value(frame, "Line l").value == "(0.3, -1, 0.7)"
    assert "Line m: (-0.4, -1, -0.7)" in frame.in_words()


def test_lines_cross_on_the_sphere_where_the_ray_does():
    lines = np.array([[0.3, -1, 0.2], [-0.4, -1, -0.3]])
    point = np.cross(*lines) / np.linalg.norm(np.cross(*lines))
    for line in lines:
        circle = join_meet._great_circle(line)
        np.testing.assert_allclose(np.linalg.norm(circle, axis=1), 1)
        assert np.abs(circle @ line).max() < 1e-12
        assert np.linalg.norm(circle - point, axis=1).min() < 0.1


def test_a_line_ends_at_the_edge_of_the_sheet():
    for line in ([0.1, -1, 0.2], [5.0, -1, 0.2], [0.0, -1, 1.0]):
        ends = join_meet._on_sheet(np.array(line))
        assert np.abs(ends @ line).max() < 1e-12
        assert (np.isclose(np.abs(ends[:, :2]), join_meet.SHEET[2]).any(axis=1)).all()
    assert len(join_meet._on_sheet(np.array([0.0, -1, 3.0]))) == 0


@pytest.mark.parametrize("heights", [(0.7, -0.7), (0.7, 0.7), (3, -3)])
@pytest.mark.parametrize("slopes", [(0.3, -0.4), (0, 0), (2, -2), (0.3, 0.3)])
def test_every_state_can_be_drawn_and_says_so(slopes, heights):
    frame = MEET(slopes[0], heights[0], slopes[1], heights[1])
    for picture in frame.pictures:
        assert picture.alt.endswith(".")
        for label in picture.labels:
            assert (np.array(label.at) >= 0).all()
            assert (np.array(label.at) <= picture.size).all()


@pytest.mark.parametrize("pan", [90, 180, -90])
def test_the_meadow_reaches_the_hills_on_all_sides(pan):
    column = WHOLE(**state(pan=pan)).pictures[0].image[:, 300].astype(int)
    green = column[:, 1] > column[:, 2] + 30
    start = int(np.argmax(green))
    assert green[start : start + 60].all()
