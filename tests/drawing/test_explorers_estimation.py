"""The explorers of chapter 06 compute what they show."""

import numpy as np
import pytest

from course_lib.drawing.explorers import dlt_noise as noise
from course_lib.drawing.explorers import homography as wall
from course_lib.drawing.explorers import least_squares as line
from course_lib.homogeneous import apply_homography
from course_lib.homography import homography_dlt
from data_generators import facade

LINE, WALL, NOISE = line.least_squares_frame, wall.homography_frame, noise.dlt_noise_frame


def value(frame, label):
    (reading,) = (r for r in frame.readouts if r.label == label)
    return float(reading.value)


def by_role(picture, role):
    return [np.asarray(drawn.points) for drawn in picture.lines if drawn.role == role]


def dragged(handle, at):
    """Return what controls a handle sets when it is dragged to a pixel."""
    return {name: a + b * at[0] + c * at[1] for name, a, b, c in handle.moves}


# Least squares by hand


def test_the_squares_are_as_large_as_the_residuals_and_add_up():
    frame = LINE(40, 10)
    y = line.readings()
    squares = by_role(frame.pictures[0], "object")
    unit = (line.PLOT.y[1] - line.PLOT.y[0]) / (line.PLOT.box[3] - line.PLOT.box[2])
    sides = [np.ptp(square, axis=0) for square in squares]
    np.testing.assert_allclose([w for w, _ in sides], [h for _, h in sides])
    residuals = unit * np.array([h for _, h in sides])
    np.testing.assert_allclose(residuals, np.abs(y - 40 * line.LOADS - 10), atol=1e-6)
    assert value(frame, "Sum of the squares") == round((residuals**2).sum())


@pytest.mark.parametrize("slipped", [False, True])
def test_no_line_beats_the_best_one(slipped):
    frame = LINE(40, 10, slipped, best=True)
    m, c = value(frame, "Best slope"), value(frame, "Best height")
    least = value(LINE(m, c, slipped), "Sum of the squares")
    assert least <= value(frame, "Smallest possible") + 5
    for dm, dc in ((1, 0), (-1, 0), (0, 8), (0, -8), (1, -5)):
        assert value(LINE(m + dm, c + dc, slipped), "Sum of the squares") > least


def test_each_parabola_passes_through_the_present_line():
    frame = LINE(44, 16)
    for picture, here, name in zip(frame.pictures[1:], (44, 16), "mc", strict=True):
        (curve,), (spot,) = by_role(picture, "ray"), by_role(picture, "camera")
        centre = spot.mean(axis=0)
        seen = curve[~np.isnan(curve).any(axis=1)]
        assert np.interp(centre[0], *seen.T) == pytest.approx(centre[1], abs=0.5), (here, name)


@pytest.mark.parametrize("number", [0, 1])
def test_a_dragged_line_goes_where_the_pointer_is(number):
    state = {"m": 30.0, "c": 100.0}
    handle = LINE(**state).pictures[0].handles[number]
    target = np.array(handle.at) + np.array([0, -40])
    moved = state | dragged(handle, target)
    assert len(handle.moves) == 1
    after = LINE(**moved).pictures[0].handles[number]
    np.testing.assert_allclose(after.at, target, atol=1e-6)


def test_the_best_line_is_not_told_before_it_is_asked_for():
    assert [r.label for r in LINE(30, 100).readouts] == ["Sum of the squares"]
    assert "45.6" not in str(LINE(30, 100))


def test_one_slip_turns_the_best_line():
    assert value(LINE(30, 100, best=True), "Best slope") == 45.6
    assert value(LINE(30, 100, slipped=True, best=True), "Best slope") == 56.9
    assert len(by_role(LINE(30, 100, best=True).pictures[0], "image")) == 1


# A homography from four corners


def test_the_true_corners_straighten_the_wall():
    corners = wall.true_corners()
    frame = WALL(*corners.ravel())
    assert value(frame, "A window is wide") == 1.0
    assert value(frame, "and high") == 1.3
    H = homography_dlt(corners, facade.CORNERS)
    straight = frame.pictures[1]
    marked = np.asarray(straight.lines[0].points)
    expected = facade.window(*wall.MEASURED) * [1, -1] * wall.SCALE
    expected += [-0.5, facade.WALL[1] * wall.SCALE - 0.5]
    np.testing.assert_allclose(marked, expected, atol=0.3)
    blue = straight.image.astype(float)[..., 2]  # frames are white, plaster is yellow
    for column, floor in ((0, 0), (0, 2), (5, 0), (5, 2)):
        window = facade.window(column, floor)
        for share, brighter in ((0.95, True), (1.25, False)):
            place = window.mean(axis=0) + share * (window - window.mean(axis=0))
            u, v = (place * [1, -1] * wall.SCALE + [0, facade.WALL[1] * wall.SCALE]).T.astype(int)
            assert ((blue[v, u] > 105) == brighter).all(), (column, floor, blue[v, u])
    np.testing.assert_allclose(apply_homography(corners, H), facade.CORNERS, atol=1e-9)


def test_the_pointer_reads_metres():
    corners = wall.true_corners()
    right, up = WALL(*corners.ravel()).pictures[0].probes
    H = homography_dlt(corners, facade.CORNERS)
    u, v = np.meshgrid(np.linspace(0, 479, wall.GRID[0]), np.linspace(0, 359, wall.GRID[1]))
    expected = apply_homography(np.stack([u.ravel(), v.ravel()], axis=1), H).reshape(*u.shape, 2)
    inside = (expected > 0).all(axis=2) & (expected < facade.WALL).all(axis=2)
    assert inside.sum() > 40
    np.testing.assert_allclose(right.values[inside], expected[inside][:, 0])
    np.testing.assert_allclose(up.values[inside], expected[inside][:, 1])


def test_a_dragged_corner_moves_its_own_two_controls():
    handle = WALL(*wall.START.ravel()).pictures[0].handles[2]
    assert dragged(handle, (12, 34)) == {"u3": 12, "v3": 34}
    assert handle.at == tuple(wall.START[2])


def test_three_corners_on_a_line_make_no_wall():
    frame = WALL(110, 290, 350, 290, 230, 185, 110, 80)
    assert frame.readouts[0].value == "three corners lie on one line"
    assert frame.pictures[1].image is None
    assert "no homography" in frame.pictures[1].alt


def test_corners_in_a_silly_order_can_still_be_drawn():
    for order in ([1, 0, 2, 3], [3, 2, 1, 0], [0, 2, 1, 3]):
        frame = WALL(*wall.true_corners()[order].ravel())
        assert all(picture.alt.endswith(".") for picture in frame.pictures)
    straight = frame.pictures[1].image  # here its edges cross: a part lies beyond the photograph
    assert (straight == 235).all(axis=2).any()
    assert not (straight == 0).all(axis=2).any()


# The DLT under noise


def test_exact_points_find_the_camera():
    frame = NOISE(6, 0, 120, 1)
    assert value(frame, "Scatter, longest way") < 1e-2
    found = noise.centres(noise.pins(6, 120), 0, 1)
    np.testing.assert_allclose(found, np.tile(noise._camera().centre, (noise.TRIALS, 1)), atol=1e-3)


def test_more_noise_fewer_points_and_flatter_pins_scatter_more():
    def scatter(n, sigma, h):
        return np.mean([value(NOISE(n, sigma, h, k), "Scatter, longest way") for k in (1, 2, 3)])

    usual = scatter(12, 0.5, 120)
    assert scatter(12, 1.0, 120) == pytest.approx(2 * usual, rel=0.1)
    assert scatter(12, 0.5, 60) == pytest.approx(2 * usual, rel=0.15)
    assert scatter(48, 0.5, 120) < 0.6 * usual


def test_the_camera_is_least_certain_along_its_view():
    found = noise.centres(noise.pins(24, 120), 0.3, 2)[:, :2]
    _, axes = noise._ellipse(found)
    view = noise._camera().centre[:2] - [210, 150]
    assert abs(axes[:, 0] @ view) / np.linalg.norm(view) > 0.97


def test_the_ellipse_holds_most_of_the_tries():
    frame = NOISE(24, 0.5, 120, 3)
    zoom = frame.pictures[2]
    drawn = by_role(zoom, "object")
    outline, spots = drawn[-1], np.array([d.mean(axis=0) for d in drawn[:-1]])
    centre = outline[:-1].mean(axis=0)
    shape = np.cov((outline[:-1] - centre).T) * 2  # of an ellipse: half the squared radii
    inside = np.einsum("ni,ij,nj->n", spots - centre, np.linalg.inv(shape), spots - centre) < 1
    assert len(spots) == noise.TRIALS
    assert inside.mean() > 0.75


@pytest.mark.parametrize(("sigma", "verb"), [(2, "are"), (0.5, "is")])
def test_the_enlarged_view_keeps_its_scale_and_counts_what_is_outside(sigma, verb):
    small, large = (NOISE(n, error, 120, 1).pictures[2] for n, error in ((24, 0.1), (6, sigma)))
    ticks = [[label.text for label in p.labels if "100" in label.text] for p in (small, large)]
    assert ticks[0] == ticks[1] != []
    found = noise.centres(noise.pins(6, 120), sigma, 1) - noise._camera().centre
    outside = int((np.abs(found[:, :2]) > 100).any(axis=1).sum())
    assert outside > 0
    assert len(by_role(large, "object")) == noise.TRIALS - outside + 1
    assert f"{outside} of them {verb} outside" in [label.text for label in large.labels]
    assert not [label for label in small.labels if "outside" in label.text]


def test_pins_in_one_plane_find_no_camera():
    frame = NOISE(12, 0.5, 0, 1)
    assert "one plane" in frame.readouts[0].value
    assert "one plane" in frame.pictures[2].alt
