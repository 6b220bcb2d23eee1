"""The figures of chapter 07: each draws, says what it shows, and shows the right thing."""

import sys

import matplotlib as mpl
import numpy as np
import pytest
from legible import Legible

mpl.use("Agg")  # as a test has no screen

from matplotlib.quiver import Quiver

from course_lib import calibration as cal
from course_lib.calibration.model import CameraModel
from course_lib.detection import Detection, detect_board
from course_lib.distortion import distort
from course_lib.drawing import calibration as draw
from course_lib.drawing.calibration import photographs as made
from course_lib.drawing.calibration import stepping, using
from course_lib.drawing.style import ROLES
from course_lib.homography import homography_dlt
from course_lib.least_squares import parameter_covariance
from data_generators.board_observations import observe_board

# A figure of the package has the same name.
bad = sys.modules["course_lib.drawing.calibration.targets"]

POINTS, SIZE = draw.BOARD.points(), draw.SIZE
PICTURES = draw.computed_photographs()
SEEN = observe_board(
    np.random.default_rng(5), POINTS, made.K, made.LENS, SIZE, views=13, noise=0.15, tilt=0.4
)
PIXELS = SEEN.pixels
FOUND = cal.calibrate(POINTS, PIXELS, SIZE)
DETECTED = Detection(True, PIXELS[0], np.arange(54), "", "")
H = homography_dlt(POINTS[:, :2], PIXELS[3])
FIGURES = {
    "board_poses": lambda: draw.board_poses(FOUND.K, FOUND.poses),
    "board_poses none": lambda: draw.board_poses(FOUND.K, [None] * 13),
    "contact_sheet": lambda: draw.contact_sheet(PICTURES, PIXELS),
    "detected_corners": lambda: draw.detected_corners(PICTURES[0], DETECTED),
    "flatness": draw.flatness,
    "focus_changes": draw.focus_changes,
    "held_out_models": lambda: draw.held_out_models(PIXELS),
    "over_the_picture": lambda: draw.over_the_picture(PIXELS, FOUND.residuals),
    "ray_uncertainty": lambda: draw.ray_uncertainty(FOUND, PIXELS),
    "residual_arrows": lambda: draw.residual_arrows(PICTURES[0], PIXELS[0], FOUND.residuals[0]),
    "residual_arrows none": lambda: draw.residual_arrows(PICTURES[0], PIXELS[0], None),
    "set_of_rays": lambda: draw.set_of_rays(FOUND),
    "slipped_search": lambda: draw.slipped_search(PICTURES[0], PIXELS[0] + 3, PIXELS[0], 45, 11),
    "steps_down": lambda: draw.steps_down({"in turns": [2, 1.5], "together": [2, 0.3, 0.2]}),
    "targets": draw.targets,
    "vanishing_columns": lambda: draw.vanishing_columns(PICTURES[3], H),
    "views_grow": lambda: draw.views_grow(PIXELS),
    "views_one_by_one": lambda: draw.views_one_by_one(PIXELS, FOUND.residuals),
}
NO_FIGURES = {"BOARD", "SIZE", "closed_form", "computed_photographs", "in_turns"}
NO_FIGURES |= {"left_photographs", "opencv_corners", "packed", "residuals_and_derivatives"}
NO_FIGURES |= {"opencv_calibration", "tilted_views", "with_dots", "without_lens", "zhang_data"}


@pytest.fixture(scope="module", params=FIGURES)
def figure(request):
    drawn = FIGURES[request.param]()
    drawn.draw_without_rendering()
    return drawn


def lines(ax, role):
    """Return the data of the lines that have the colour of a role."""
    found = [line for line in ax.lines if line.get_color() == ROLES[role]]
    return [np.asarray(line.get_xydata()) for line in found]


def written(ax):
    return [text.get_text() for text in ax.texts]


class TestEachFigure(Legible):
    UNITS = ("px", "m", "cm", "number", "no unit")
    SLANTED = True  # numbers along lines of equal uncertainty


def test_every_function_is_tried_here():
    assert {name.split()[0] for name in FIGURES} | NO_FIGURES == set(draw.__all__)


@pytest.mark.parametrize(
    "yours",
    [None, "left", [1, 2, 3], np.full((54, 2), np.nan), np.full((54, 2), 1e200), {}, np.zeros(2)],
)
def test_what_a_student_cannot_have_meant_is_not_drawn_or_does_no_harm(yours):
    figure = draw.residual_arrows(PICTURES[0], PIXELS[0], yours)
    figure.draw_without_rendering()
    assert written(figure.axes[0]) == ["no answer yet"]


@pytest.mark.parametrize("pose", [None, (np.eye(3), np.full(3, np.nan))])
def test_a_pose_that_is_none_is_not_drawn(pose):
    figure = draw.board_poses(FOUND.K, [*FOUND.poses[:5], pose, *FOUND.poses[6:]])
    figure.draw_without_rendering()
    numbers = [text for text in written(figure.axes[0]) if text.isdigit()]
    assert sorted(numbers) == ["4", "6", "9"]


# What they show


def test_arrows_lead_from_the_observed_to_the_projected_corner():
    figure = draw.residual_arrows(PICTURES[0], PIXELS[0], FOUND.residuals[0], times=10)
    (arrows,) = [c for c in figure.axes[0].collections if isinstance(c, Quiver)]
    np.testing.assert_allclose(arrows.XY, PIXELS[0])
    np.testing.assert_allclose(np.column_stack([arrows.U, arrows.V]), FOUND.residuals[0])
    assert arrows.scale == pytest.approx(1 / 10)
    assert f"RMS {FOUND.view_rms[0]:.2f} px" in figure.axes[0].get_title(loc="left")


def test_a_board_from_above_is_where_its_pose_says():
    ax = draw.board_poses(FOUND.K, FOUND.poses).axes[0]
    boards = [patch.get_xy() for patch in ax.patches[1:]]  # the first is the camera
    assert len(boards) == 4
    for drawn, number in zip(boards, (4, 5, 6, 9), strict=True):
        R, t = FOUND.poses[number]
        middle = R @ (POINTS.min(axis=0) + POINTS.max(axis=0)) / 2 + t
        np.testing.assert_allclose(drawn[:4].mean(axis=0), middle[[0, 2]] / 10)  # mm to cm


def test_the_corners_of_the_picture_say_how_sure_their_rays_are():
    ax = draw.ray_uncertainty(FOUND, PIXELS).axes[0]
    said = [float(text.removesuffix(" px")) for text in written(ax) if text.endswith("px")]
    at = np.array([[0, 239.5], [0, 0], [SIZE[0] - 1, 0], [0, SIZE[1] - 1], np.array(SIZE) - 1])
    np.testing.assert_allclose(said, using.ray_sigma(FOUND, at, np.vstack(PIXELS)), atol=0.051)


def test_the_columns_of_H_are_where_the_boards_lines_meet():
    figure = draw.vanishing_columns(PICTURES[3], H)
    for column, role in ((0, "camera"), (1, "object")):
        spots = [line for line in lines(figure.axes[0], role) if len(line) == 1]
        np.testing.assert_allclose(spots, [[H[:2, column] / H[2, column]]])
        far = H @ (np.eye(3)[column] * 1e7 + [0, 0, 1])  # a point of the board far along the axis
        np.testing.assert_allclose(spots[0][0], far[:2] / far[2], rtol=1e-3)


def test_the_directions_of_the_vanishing_points_are_perpendicular():
    R, t = SEEN.poses[3]
    ideal = homography_dlt(POINTS[:, :2], project_ideal(R, t))
    one, two = (np.linalg.inv(made.K) @ ideal[:, i] for i in (0, 1))
    assert one @ two / np.linalg.norm(one) / np.linalg.norm(two) == pytest.approx(0, abs=1e-9)


def project_ideal(R, t):
    rows = (POINTS @ R.T + t) @ made.K.T
    return rows[:, :2] / rows[:, 2:]


def test_held_out_views_are_never_better_than_those_used():
    figure = draw.held_out_models(PIXELS)
    (own,), (others,) = lines(figure.axes[0], "camera"), lines(figure.axes[0], "object")
    assert (np.diff(own[:, 1]) <= 1e-9).all()  # each model contains the one before
    assert (others[:, 1] > own[:, 1]).all()


def test_a_bad_board_does_what_the_text_says():
    boards = bad.bad_boards()
    f = {name: np.diag(found.K)[:2] - [560, 558] for name, (_, found) in boards.items()}
    assert np.abs(f["as it should be"]).max() < 0.3
    np.testing.assert_allclose(f["bent by 1 mm"], -6.6, atol=0.2)
    assert abs(f["1 % too long one way"][0]) < 0.5
    assert f["1 % too long one way"][1] == pytest.approx(-0.0095 * 558, abs=0.2)
    np.testing.assert_allclose(f["1 % too large"], f["as it should be"], atol=0.02)
    assert [round(found.rms, 2) for _, found in boards.values()] == [0.14, 0.27, 0.2, 0.14]


def test_the_wall_behind_the_pixels_is_the_lens_turned_around():
    rng = np.random.default_rng(1)
    pixels = rng.uniform((50, 50), (590, 430), (20, 2))
    wall = using.directions(FOUND, pixels)
    there = distort(wall[:, :2], FOUND.coefficients) @ FOUND.K[:2, :2].T + FOUND.K[:2, 2]
    np.testing.assert_allclose(there, pixels, atol=1e-6)


def test_the_uncertainty_of_rays_is_the_scatter_of_calibrations():
    model = CameraModel(coefficients=("k1", "k2"))
    rng, clean = np.random.default_rng(2), [p.copy() for p in _without_noise()]
    at = np.array([[320.0, 240], [100, 100], [560, 400], [60, 420]])
    seen = np.vstack(clean)
    found = [
        cal.calibrate(POINTS, [p + rng.normal(0, 0.2, p.shape) for p in clean], SIZE, model)
        for _ in range(60)
    ]
    expected = np.mean([using.ray_sigma(c, at, seen) for c in found], axis=0)
    off = [_scatter(c, at, seen) for c in found]
    scatter = np.sqrt(np.mean([(o**2).sum(axis=1) for o in off], axis=0))
    np.testing.assert_allclose(scatter, expected, rtol=0.25)


def _without_noise():
    rng = np.random.default_rng(5)
    return observe_board(rng, POINTS, made.K, made.LENS[:2], SIZE, views=13, tilt=0.4).pixels


def _true():
    from dataclasses import replace

    return replace(FOUND, K=made.K, coefficients=np.array(made.LENS[:2]))


def _scatter(found, at, seen):
    """Return how far rays are off in px, after the turn that suits the corners best."""
    both = [using.directions(c, np.vstack([at, seen])) for c in (found, _true())]
    ours, theirs = (rows / np.linalg.norm(rows, axis=1, keepdims=True) for rows in both)
    U, _, Vt = np.linalg.svd(ours[len(at) :].T @ theirs[len(at) :])
    turned = ours[: len(at)] @ (U @ Vt)
    ideal = turned[:, :2] / turned[:, 2:]
    return distort(ideal, made.LENS[:2]) @ made.K[:2, :2].T + made.K[:2, 2] - at


# What they are drawn from


def test_the_computed_photographs_are_those_of_their_camera():
    found = [detect_board(picture, draw.BOARD) for picture in PICTURES[:5]]
    assert all(view.good for view in found)
    camera = cal.calibrate(POINTS, [view.points for view in found], SIZE)
    np.testing.assert_allclose(camera.K, made.K, atol=0.5)
    np.testing.assert_allclose(camera.coefficients[:2], made.LENS[:2], atol=0.02)


def test_a_row_of_numbers_is_the_camera_it_was_packed_from():
    K, poses = draw.closed_form(PIXELS)
    again, k, views = stepping.unpacked(draw.packed(K, [0.1, 0.2], poses))
    np.testing.assert_allclose(again, K)
    assert k.tolist() == [0.1, 0.2]
    for (R, t), (S, u) in zip(poses, views, strict=True):
        np.testing.assert_allclose(R, S, atol=1e-12)
        np.testing.assert_array_equal(t, u)


def test_steps_along_the_derivatives_come_to_the_librarys_minimum():
    model = CameraModel(coefficients=("k1", "k2"))
    best = cal.calibrate(POINTS, PIXELS, SIZE, model)
    numbers = draw.packed(*_camera_and_lens(best), best.poses)
    residuals, J = draw.residuals_and_derivatives(numbers, PIXELS)
    assert cal.rms_error(residuals.reshape(-1, 2)) == pytest.approx(best.rms, rel=1e-9)
    slope = J.T @ residuals / np.linalg.norm(J, axis=0)
    assert np.abs(slope).max() < 1e-3
    sigma = np.sqrt(np.diag(parameter_covariance(J, residuals)))[: stepping.CAMERA]
    np.testing.assert_allclose(sigma, list(best.sigma.values()), rtol=1e-4)


def test_a_board_behind_the_camera_has_no_derivatives():
    numbers = draw.packed(*_camera_and_lens(FOUND), FOUND.poses)
    numbers[stepping.CAMERA + 5] = -500  # z of the first view
    with pytest.raises(ValueError, match="corners of the board lie behind the camera"):
        draw.residuals_and_derivatives(numbers, PIXELS)


def _camera_and_lens(found):
    return found.K, found.coefficients[:2]


def test_in_turns_it_gets_better_but_slowly():
    history = draw.in_turns(PIXELS, 20)
    assert history[-1] < history[5] < history[0]
    assert history[-1] > 1.5 * FOUND.rms
