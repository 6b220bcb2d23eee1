"""The explorers of chapter 10 compute what they show."""

from itertools import pairwise

import numpy as np
import pytest

from course_lib.bundle import Control, Observations, bundle_adjust
from course_lib.drawing.bundle import growing, placement
from course_lib.drawing.bundle.flights import SURVEY, WRONG_K1, bent_by
from course_lib.drawing.explorers import control_points as game
from course_lib.drawing.explorers import growing as stepper

CHAINED, ADJUSTED = growing.WAYS
CORNERS = (0, 14, 150, 164)


def value(frame, label):
    (reading,) = (r for r in frame.readouts if r.label == label)
    return float(reading.value)


def by_role(picture, role):
    return [np.asarray(drawn.points) for drawn in picture.lines if drawn.role == role]


def dragged(handle, at):
    """Return what controls a handle sets when it is dragged to a pixel."""
    return {name: a + b * at[0] + c * at[1] for name, a, b, c in handle.moves}


def named(places):
    """Return places of the game's points by the names of their sliders."""
    return {
        f"{c}{i}": v for i, place in enumerate(places, 1) for c, v in zip("xy", place, strict=True)
    }


# A block grows


def test_a_point_that_comes_into_view_again_is_a_new_one():
    seen, ring = growing.chain(), growing.vase().observations
    assert seen.cameras.max() == 24
    for point in np.unique(seen.points):
        cameras = np.sort(seen.cameras[seen.points == point])
        assert len(cameras) > 1
        assert (np.diff(cameras) == 1).all()
    first = {tuple(row) for row in ring.pixels[ring.cameras == 0]}
    assert {tuple(row) for row in seen.pixels[seen.cameras == 24]} <= first


def test_the_adjustment_of_the_whole_chain_is_that_of_the_library():
    last, seen = growing.grown(ADJUSTED)[-1], growing.chain()
    known = np.isfinite(last.points[:, 0])
    assert known.all()
    fit = bundle_adjust(last.block, seen)
    assert fit.rms == pytest.approx(last.after, rel=1e-6)
    assert last.after < last.before
    left = last.block.project(seen.cameras, seen.points) - seen.pixels
    assert last.after == pytest.approx(np.sqrt((left**2).sum(axis=1).mean()))


@pytest.mark.parametrize("way", growing.WAYS)
def test_the_first_camera_and_the_first_base_stay(way):
    true = growing.vase().truth
    for stage in growing.grown(way):
        np.testing.assert_allclose(stage.block.centres[0], true.centres[0], atol=1e-9)
        np.testing.assert_allclose(stage.block.R[0], true.R[0], atol=1e-9)
        base, wanted = (np.linalg.norm(c[1] - c[0]) for c in (stage.block.centres, true.centres))
        assert base == pytest.approx(wanted)


def test_every_camera_adds_what_the_numbers_say():
    stages = growing.grown(CHAINED)
    for before, after in pairwise(stages):
        new = np.isfinite(after.points[:, 0]) & np.isnan(before.points[:, 0])
        assert new.sum() == after.added
        old = np.isfinite(before.points[:, 0])
        np.testing.assert_array_equal(before.points[old], after.points[old])
        numbers, _ = growing.observed(growing.chain(), len(after.block.R) - 1)
        assert after.seen == old[numbers].sum()


def test_a_chain_drifts_and_adjustment_holds_it():
    gaps = []
    for way in growing.WAYS:
        C = growing.grown(way)[-1].block.centres
        gaps.append(np.linalg.norm(C[-1] - C[0]))
        frame = stepper.growing_frame(24, way, 20)
        label = frame.pictures[1].labels[-1].text
        assert label == f"gap {1000 * gaps[-1]:.1f} mm"
    assert gaps[0] > 5 * gaps[1]


@pytest.mark.parametrize("way", growing.WAYS)
def test_the_frame_says_what_it_draws(way):
    frame = stepper.growing_frame(13, way, 35)
    stage = growing.grown(way)[12]
    assert value(frame, "Newest picture") == 13
    assert value(frame, "Known points it sees") == stage.seen
    assert value(frame, "Points it adds") == stage.added
    (after,) = (r.value for r in frame.readouts if r.label == "RMS after it")
    assert after == (f"{stage.after:.2f}" if growing.WAYS[way] else "none made")
    space, above, curve = frame.pictures
    newest = by_role(above, "object")[0].mean(
        axis=0, where=np.isfinite(by_role(above, "object")[0])
    )
    true = growing.true_centres(14)[-1]
    shown = true + stepper.TIMES * (stage.block.centres[-1] - true)
    np.testing.assert_allclose(newest, stepper.ABOVE.pixels(*shown[None, :2].T)[0], atol=1e-9)
    apart = 1000 * np.linalg.norm(stage.block.centres[-1] - true)
    assert value(frame, "Newest camera is off by") == pytest.approx(apart, abs=0.05)
    (rays, *_) = by_role(space, "ray")
    assert np.isfinite(rays[:, 0]).sum() == 2 * (stage.seen + stage.added)
    (after,) = by_role(curve, "camera")
    assert len(after) == 13


def test_everything_is_inside_from_all_sides():
    for turn in range(-180, 181, 45):
        space = stepper.growing_frame(24, ADJUSTED, turn).pictures[0]
        for line in space.lines:
            points = np.asarray(line.points)
            points = points[np.isfinite(points[:, 0])]
            assert (points >= 0).all()
            assert (points < stepper.SPACE_SIZE).all()


# Place the control points


def test_expected_errors_are_how_adjustments_scatter():
    free = placement.free_block()
    block, seen = free.block, placement._all_seen(free.block)
    control = np.array([17, 28, 82, 150, 164])
    bent = bent_by(seen, block.K[0], WRONG_K1).pixels
    rng, found = np.random.default_rng(1), []
    for _ in range(25):
        pixels = bent + placement.PIXEL * rng.standard_normal(bent.shape)
        noisy = Observations(seen.cameras, seen.points, pixels, placement.PIXEL)
        places = block.points[control] + SURVEY * rng.standard_normal((5, 3))
        fit = bundle_adjust(block, noisy, Control(control, places, SURVEY))
        found.append(fit.block.points[:, 2] - block.points[:, 2])
    scattered = np.sqrt((np.array(found) ** 2).mean(axis=0))
    expected = placement.height_errors(tuple(control), True)
    assert np.median(np.abs(scattered / expected - 1)) < 0.12
    assert np.sqrt((scattered**2).mean()) == pytest.approx(
        placement.check_error(tuple(control), True), rel=0.08
    )


def test_expected_errors_are_the_precision_of_an_adjustment():
    free = placement.free_block()
    block, seen = free.block, placement._all_seen(free.block)
    rng, control = np.random.default_rng(3), np.array([2, 13, 75, 152, 161])
    pixels = seen.pixels + placement.PIXEL * rng.standard_normal(seen.pixels.shape)
    noisy = Observations(seen.cameras, seen.points, pixels, placement.PIXEL)
    fit = bundle_adjust(block, noisy, Control(control, block.points[control], SURVEY))
    sigma = fit.precision.point_sigma[:, 2] / fit.sigma0
    np.testing.assert_allclose(placement.height_errors(tuple(control), False), sigma, rtol=0.01)


def test_each_point_of_the_grid_is_in_two_pictures():
    seen = placement._all_seen(placement.free_block().block)
    assert np.bincount(seen.points, minlength=165).min() >= 2


@pytest.mark.parametrize("dome", [False, True])
def test_no_other_choice_beats_the_best(dome):
    rng = np.random.default_rng(2)
    for count in (3, 4, 5):
        best = placement.check_error(placement.best_control(count, dome), dome)
        for _ in range(300):
            other = tuple(rng.choice(165, count, replace=False).tolist())
            assert placement.check_error(other, dome) >= best


def test_points_on_a_line_or_twice_the_same_do_not_fix_the_block():
    for control in ((0, 7, 14), (0, 0, 164), (0, 16, 32), (30, 75, 120)):
        assert placement.height_errors(control, False) is None
    assert placement.check_error((0, 14, 164), False) < 1


def test_more_control_is_never_worse_and_a_dome_never_better():
    without = placement.height_errors(CORNERS, False)
    assert (placement.height_errors((*CORNERS, 82), False) <= without + 1e-12).all()
    assert (placement.height_errors(CORNERS, True) >= without).all()


def test_a_spot_is_dragged_to_the_nearest_point_of_the_grid():
    picture = game.control_frame(5, True, **named(game.START)).pictures[0]
    handle = picture.handles[2]
    at = game.PLAN.at(96.0, 24.0)
    moved = dragged(handle, at)
    assert moved == {"x3": pytest.approx(96), "y3": pytest.approx(24)}
    assert game.numbered(97.5, 22.9) == 2 * 15 + 8


def test_the_map_shows_the_errors():
    picture = game.control_frame(4, True, **named(game.START)).pictures[0]
    control = tuple(game.numbered(*place) for place in game.START[:4])
    errors = 1000 * placement.height_errors(control, True)
    for number in (16, 82, 140):
        row, column = divmod(number, 15)
        u, v = (round(x) for x in game.PLAN.at(12.0 * column, 12.0 * row))
        wanted = game._coloured(errors[number : number + 1])[0]
        np.testing.assert_allclose(picture.image[v, u].astype(int), wanted.astype(int), atol=6)


def test_the_scale_tells_large_errors_apart():
    picture = game.control_frame(4, True, **named(game.START)).pictures[0]
    control = tuple(game.numbered(*place) for place in game.START[:4])
    errors = 1000 * placement.height_errors(control, True)
    assert 200 < errors.max() < game.SCALE.y[1]
    shades = game._coloured(np.array([25.0, 50, 100, 200, 400])).astype(int).sum(axis=1)
    assert (np.diff(shades) < -60).all()
    scale = [label.text for label in picture.labels if label.at[0] > 560]
    assert scale == ["25", "50", "100", "200", "400+"]


def test_numbers_of_points_keep_off_the_name_of_the_axis():
    corners = [(0, 0), (168, 0), (168, 120), (0, 120)]
    labels = game.control_frame(4, False, **named(corners)).pictures[0].labels
    (axis,) = (label for label in labels if label.text == "north (m)")
    assert all(abs(label.at[1] - axis.at[1]) > 14 for label in labels if label.text in "34")


def test_the_score_is_the_share_of_the_best():
    frame = game.control_frame(4, True, **named(game.START))
    share = value(frame, "Best choice found") / value(frame, "Height error, RMS of all points")
    assert value(frame, "Score") == pytest.approx(100 * share, abs=1)
    best = [divmod(n, 15) for n in placement.best_control(4, True)]
    places = [(12.0 * column, 12.0 * row) for row, column in best]
    assert value(game.control_frame(4, True, **named(places)), "Score") == 100
    line = game.control_frame(3, False, **named([(0, 0), (12, 12), (24, 24)]))
    assert "do not fix" in line.readouts[0].value
