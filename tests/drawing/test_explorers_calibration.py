"""The explorers of chapter 07 compute what they show."""

import numpy as np
import pytest
from real_data import fetched

from course_lib import calibration as cal
from course_lib.calibration.model import CameraModel
from course_lib.distortion import distort_pixels
from course_lib.drawing.calibration import photographs as made
from course_lib.drawing.explorers import detection as corner
from course_lib.drawing.explorers import poses
from course_lib.drawing.explorers import reprojection as inspector
from course_lib.homography import homography_dlt

VIEWS = list(poses.VIEWS)
EVERY_SECOND = [n % 2 == 0 for n in range(8)]


def value(frame, label):
    (reading,) = (r for r in frame.readouts if r.label == label)
    return float(reading.value.removeprefix("± "))


def by_role(picture, role):
    return [np.asarray(drawn.points) for drawn in picture.lines if drawn.role == role]


def dragged(handle, at):
    """Return what controls a handle sets when it is dragged to a pixel."""
    return {name: a + b * at[0] + c * at[1] for name, a, b, c in handle.moves}


# Finding a corner


def test_the_corners_of_the_computed_picture_are_where_its_brightness_says():
    fitted = [corner.fitted_corner(corner.photograph(0.7, 0), n) for n in range(54)]
    np.testing.assert_allclose(fitted, corner.true_corners(), atol=0.05)
    assert np.abs(np.mean(fitted - corner.true_corners(), axis=0)).max() < 0.01


def test_the_picture_shows_the_whole_part_of_the_board_that_is_searched():
    seen = corner.true_corners()
    assert (seen > 15).all()
    assert (seen < np.array(corner.SIZE) - 16).all()


@pytest.mark.parametrize(("number", "last_good"), [(33, 7), (35, 6), (4, 11)])
def test_a_window_that_reaches_the_next_edge_loses_its_corner(number, last_good):
    errors = {
        reach: value(corner.detection_frame(number, reach, 0.8, 2), "Error of the window search")
        for reach in range(3, 15)
    }
    edge = value(corner.detection_frame(number, 5, 0.8, 2), "Next edge")
    assert max(errors[reach] for reach in range(3, last_good + 1)) < 0.1
    jump = next(reach for reach in errors if errors[reach] > 1)
    assert edge - 0.6 < jump < edge + 1  # a window reaches half a pixel more to each side


def test_blur_wants_a_wider_window_and_noise_hurts():
    def off(reach, blur, noise):
        frame = corner.detection_frame(33, reach, blur, noise)
        return value(frame, "Window search, all 54, RMS")

    assert off(2, 2, 2) > 5 * off(5, 2, 2)
    assert off(5, 0.8, 20) > 4 * off(5, 0.8, 2)


def test_the_frame_says_what_it_draws():
    frame = corner.detection_frame(33, 6, 0.8, 2)
    _, near = frame.pictures
    (ring,), (search,), (fit,) = (by_role(near, role) for role in ("image", "object", "camera"))
    truth = ring.mean(axis=0)
    for cross, label in ((search, "Error of the window search"), (fit, "Error of the fit")):
        middle = np.nanmean(cross, axis=0)
        drawn = np.linalg.norm(middle - truth) / corner.TIMES
        assert drawn == pytest.approx(value(frame, label), abs=6e-4)
    (window,) = by_role(near, "ray")
    np.testing.assert_allclose(np.ptp(window, axis=0), 13 * corner.TIMES)


def test_the_picture_is_the_same_again():
    first, second = (corner.photograph(1.0, 5.0) for _ in range(2))
    np.testing.assert_array_equal(first, second)


# Which views tell what


def test_the_information_of_views_is_that_of_a_calibration():
    chosen = [True, False, False, True, True, True, True, True]
    picked = [v for v, on in zip(poses.VIEWS.values(), chosen, strict=True) if on]
    board, rng = poses.BOARD.points(), np.random.default_rng(3)
    exact = []
    for R, middle in picked:
        t = np.array(middle) - R @ board.mean(axis=0)
        rows = (board @ R.T + t) @ poses.K.T
        exact.append(distort_pixels(rows[:, :2] / rows[:, 2:], poses.K, poses.LENS))
    noisy = [p + rng.normal(0, 0.1, p.shape) for p in exact]
    model = CameraModel(coefficients=("k1", "k2"))
    found = cal.calibrate(board, noisy, poses.SIZE, model)
    expected = poses.sigmas(chosen)
    for name, sigma in found.sigma.items():
        assert sigma == pytest.approx(0.1 * expected[name], rel=0.08), name


def test_facing_boards_leave_the_focal_length_open_however_many():
    for chosen in ([1, 1, 0], [1, 1, 1], [1, 0, 1]):
        sigma = poses.sigmas([bool(n) for n in chosen] + [False] * 5)
        assert np.isinf([sigma["fx"], sigma["fy"], sigma["k1"]]).all()
        assert sigma["cx"] < 40
    assert np.isfinite(list(poses.sigmas([True] * 3 + [True] + [False] * 4).values())).all()


def test_no_view_makes_a_number_less_certain():
    some = [True, True, False, True, True, False, False, False]
    before = poses.sigmas(some)
    for n in (2, 5, 6, 7):
        after = poses.sigmas([on or k == n for k, on in enumerate(some)])
        assert all(after[name] <= before[name] * (1 + 1e-9) for name in before), VIEWS[n]


def test_nothing_is_known_without_views():
    assert np.isinf(list(poses.sigmas([False] * 8).values())).all()
    frame = poses.poses_frame(0.1)
    assert [r.value for r in frame.readouts[1:]] == ["not determined"] * 4
    assert "none" in frame.pictures[1].alt


def test_the_error_of_a_corner_scales_all():
    state = {f"view{n}": True for n in range(1, 9)}
    one, ten = poses.poses_frame(0.1, **state), poses.poses_frame(1.0, **state)
    for name in poses.BARS:
        assert value(ten, name) == pytest.approx(10 * value(one, name), rel=0.06)


def test_numbers_are_written_without_a_power_of_ten():
    written = [poses._short(x) for x in (0.01234, 1.96, 12.3, 99.4, 99.6, 1234.4)]
    assert written == ["0.012", "2", "12", "99", "100", "1234"]


def test_every_board_is_in_the_picture():
    frame = poses.poses_frame(0.1, **{f"view{n}": True for n in range(1, 9)})
    outlines = by_role(frame.pictures[2], "object")
    assert len(outlines) == 8
    inside = np.concatenate(outlines)
    assert (inside > 0).all()
    assert (inside < np.array(poses.SEEN_SIZE) - 1).all()
    assert len(by_role(frame.pictures[1], "object")) == 8
    numbers = np.array([label.at for label in frame.pictures[2].labels])
    apart = np.linalg.norm(numbers[:, None] - numbers, axis=2) + 99 * np.eye(8)
    assert apart.min() > 12  # px: all can be read


def test_bars_end_at_their_values():
    state = {f"view{n}": True for n in (1, 4, 5)}
    frame = poses.poses_frame(0.1, **state)
    bars = by_role(frame.pictures[0], "camera")
    assert len(bars) == 4
    for bar, (name, (_, factor)) in zip(bars, poses.BARS.items(), strict=True):
        sigma = 0.1 * factor * poses.sigmas([f"view{n}" in state for n in range(1, 9)])[name]
        assert bar[:, 0].max() == pytest.approx(poses.AXES.at(sigma, 0)[0], abs=1e-6), name


# Inspect the residuals


@pytest.fixture(scope="module", params=inspector.WAYS)
def way(request):
    return request.param


def test_the_residuals_are_those_of_a_calibration(way):
    seen = inspector.inspected(way)
    assert seen.residuals.shape == seen.pixels.shape == (13, 54, 2)
    found = cal.calibrate(made.BOARD.points(), list(seen.pixels), made.SIZE)
    np.testing.assert_allclose(seen.residuals, np.array(found.residuals))
    frame = inspector.reprojection_frame(way, 0, 0)
    assert value(frame, "RMS of all") == pytest.approx(found.rms, abs=6e-4)


def test_all_residuals_are_inside_the_plot(way):
    seen = inspector.inspected(way)
    if seen.real:
        assert np.abs(seen.residuals).max() < inspector.WAYS[way]
    marks = by_role(inspector.reprojection_frame(way, 0, 0).pictures[0], "guide")[-1]
    assert len(marks) == 6 * 13 * 54


def test_the_nearest_residual_is_chosen_and_drawn(way):
    seen = inspector.inspected(way)
    for view, number in ((0, 0), (3, 17), (12, 53)):
        du, dv = seen.residuals[view, number]
        assert inspector.chosen(seen, du, dv) == (view, number)
        frame = inspector.reprojection_frame(way, du, dv)
        assert (value(frame, "View"), value(frame, "Corner")) == (view, number)
        (ring,) = by_role(frame.pictures[1], "camera")
        scale = inspector.SHOWN_SIZE[0] / made.SIZE[0]
        at = (ring.mean(axis=0) + 0.5) / scale - 0.5
        np.testing.assert_allclose(at, seen.pixels[view, number], atol=1e-6)
        (cross,), (circle,) = (by_role(frame.pictures[2], r) for r in ("object", "camera"))
        drawn = (circle.mean(axis=0) - np.nanmean(cross, axis=0)) / inspector.TIMES
        np.testing.assert_allclose(drawn, (du, dv), atol=1e-6)


def test_a_dragged_spot_goes_where_the_pointer_is(way):
    (handle,) = inspector.reprojection_frame(way, 0, 0).pictures[0].handles
    target = np.add(handle.at, (30, -20))
    moved = dragged(handle, target)
    after = inspector.reprojection_frame(way, **moved).pictures[0].handles[0]
    np.testing.assert_allclose(after.at, target, atol=1e-6)
    assert moved["du"] > 0 > moved["dv"]  # v grows downwards


def test_every_residual_says_where_it_comes_from(way):
    seen, plot = inspector.inspected(way), inspector._plot(way)
    cloud, photograph, _ = inspector.reprojection_frame(way, *seen.residuals[5, 7]).pictures
    number = 5 * 54 + 7
    assert cloud.marks.names == ("view", "corner", "du", "dv", "residual")
    np.testing.assert_allclose(
        cloud.marks.values[number],
        [5, 7, *seen.residuals[5, 7], np.linalg.norm(seen.residuals[5, 7])],
    )
    np.testing.assert_allclose(
        cloud.marks.points[number], plot.pixels(*seen.residuals[5, 7])[0], equal_nan=True
    )
    np.testing.assert_array_equal(photograph.marks.values, cloud.marks.values[5 * 54 : 6 * 54])
    scale = inspector.SHOWN_SIZE[0] / made.SIZE[0]
    at = (photograph.marks.points + 0.5) / scale - 0.5
    np.testing.assert_allclose(at, seen.pixels[5])


def test_a_larger_window_finds_worse_corners():
    fetched("opencv_stereo/left01.jpg")  # the computed boards have a wide border
    fine, wide = (inspector.inspected(way) for way in inspector.WAYS)
    assert fine.real
    assert wide.residuals[1].std() > 5 * fine.residuals[1].std()


def test_the_board_is_the_one_of_the_photographs():
    seen = inspector.inspected("corners fitted")
    plane = made.BOARD.points()[:, :2]
    for view in seen.pixels:
        H = homography_dlt(plane, view)
        assert np.isfinite(H).all()
