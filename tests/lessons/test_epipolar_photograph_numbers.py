"""Chapter 08's numbers of its real pairs: the motorcycle, the boards, the painted wall."""

import numpy as np
import pytest
from lesson_text import about, lesson_text
from lesson_text import readout as read
from real_data import fetched

from course_lib import epipolar as epi
from course_lib.distortion import normalised_from_pixels
from course_lib.drawing import epipolar as draw
from course_lib.drawing.distortion.boards import PHOTOGRAPHS
from course_lib.drawing.explorers import rectification
from course_lib.epipolar.fundamental import pair_rows
from course_lib.exercises.epipolar import plain_estimation
from course_lib.homography import normalise_points
from course_lib.tie_points import tie_points

says = lesson_text("08_epipolar").says


@pytest.fixture(scope="module")
def boards():
    """Return the real pairs of boards; skip where they are not to be had."""
    for name in PHOTOGRAPHS:
        fetched(name)
        fetched(name.replace("left", "right"))
    return draw.stereo_boards()


@pytest.fixture(scope="module")
def corners(boards):
    return boards.straight_corners()


def test_the_tie_points_of_the_motorcycle():
    for ratio, count, share in ((1.0, 1154, 79), (0.8, 813, 95)):
        one, two = tie_points(*draw.motorcycle(), ratio)
        assert len(one) == count
        assert 100 * (abs(one[:, 1] - two[:, 1]) < 1.5).mean() == about(share, 0)
    says("79 % of 1154", "95 % of 813")


def test_some_of_those_that_agree_are_wrong():
    one, two = tie_points(*draw.motorcycle(), 1.0)
    rng = np.random.default_rng(1)
    count = 2 * epi.ransac_iterations(0.99, 8, 0.21)
    samples = np.array([rng.choice(len(one), 8, replace=False) for _ in range(count)])
    _, fits = plain_estimation.ransac_fundamental(one, two, samples, 1.5)
    apart = abs(one - two)[:, 1]
    in_row = apart < 1.5
    assert (len(one), fits.sum(), (fits & in_row).sum(), (fits & ~in_row).sum()) == (
        1154,
        937,
        912,
        25,
    )
    assert (~fits & in_row).sum() == 2
    assert apart[fits].max() == about(22.8, 1)
    says("937 of the 1154 pairs agree. 912 of these", "only two such pairs are missed")
    says("But 25 others", "up to 22.8 px apart")


def test_the_calibrated_pair(boards, corners):
    c = boards.calibration
    assert np.linalg.norm(c.t) == about(99.8, 1)
    F, (left, right) = draw.board_fundamental(boards), corners
    taken = epi.line_distance(
        boards.right_corners[0], epi.epipolar_lines(boards.left_corners[0], F)
    )
    assert (taken.mean(), taken.max()) == (about(1.22, 2), about(4.6, 1))
    off = epi.line_distance(right, epi.epipolar_lines(left, F))
    assert off[:54].mean() == about(0.09, 2)
    assert off.mean() == about(0.069, 3)
    error = epi.sampson_error(left, right, F).mean()
    assert error == about(0.048, 3)
    assert error == pytest.approx(off.mean() / 2**0.5, abs=0.001)
    says("its 54 corners are 1.22 px beside", "up to 4.6 px", "0.09 px are left")
    says("702 corners", "are 0.069 px from", "0.048 px where section 6 had 0.069 px")


def test_eight_points_from_all_corners(corners):
    left, right = corners
    plain = np.linalg.svd(pair_rows(left, right))
    near = np.linalg.svd(pair_rows(normalise_points(left)[0], normalise_points(right)[0]))[1]
    assert plain[1][0] / plain[1][7] == about(514_000, -3)
    assert near[0] / near[7] == about(14, 0)
    U, s, Vt = np.linalg.svd(plain[2][-1].reshape(3, 3))
    for F, expected in ((epi.eight_point(left, right), 0.067), (U[:, :2] * s[:2] @ Vt[:2], 0.128)):
        assert epi.line_distance(right, epi.epipolar_lines(left, F)).mean() == about(expected, 3)
    F = epi.eight_point(left[:54], right[:54])  # one board is a plane
    assert epi.line_distance(right, epi.epipolar_lines(left, F))[54:].mean() == about(21, 0)
    says("514 000 times", "normalised, 14 times", "0.067 px", "0.128 px", "21 px off their lines")
    says("other twelve views")


def test_the_pose_from_all_corners_agrees_with_the_calibration(boards, corners):
    c = boards.calibration
    E = epi.essential_from_fundamental(epi.eight_point(*corners), c.K_left, c.K_right)
    hats = (
        normalised_from_pixels(p, K) for p, K in zip(corners, (c.K_left, c.K_right), strict=True)
    )
    turn, direction = draw.pose_errors(*epi.pose_from_essential(E, *hats), c)
    assert (turn, direction) == (about(0.017, 3), about(0.023, 3))
    says("0.017° and 0.023°")


def test_the_poses_from_tie_points_alone(boards):
    """No wrong pose without a doubt: within 0.5 and 1 degrees, as the course asks for, or named."""
    c, off, found = boards.calibration, [], []
    pairs = [tie_points(*boards.straightened(view)) for view in range(13)]
    for one, two in pairs:
        found.append(epi.ransac_pose(one, two, c.K_left, c.K_right, np.random.default_rng(0)))
        off.append(draw.pose_errors(found[-1].R, found[-1].t, c))
        assert found[-1].doubt or (off[-1][0] < 0.5 and off[-1][1] < 1)
    assert [view for view in range(13) if found[view].doubt] == [2, 4]
    assert off.pop(4) == (about(7, 0), about(15, 0))
    worst = np.max(off, axis=0).tolist()  # with NumPy 2.5 it draws other samples
    assert worst in ([about(0.43, 2), about(0.62, 2)], [about(0.37, 2), about(0.42, 2)])
    says("Twelve of the thirteen are within 0.43° and 0.62°", "by 7° and 15°")
    F = draw.board_fundamental(boards)
    right = [epi.line_distance(two, epi.epipolar_lines(one, F)) < 1.5 for one, two in pairs]
    counts = [
        (len(f.fits), f.fits.sum(), (f.fits & r).sum()) for f, r in zip(found, right, strict=True)
    ]
    assert counts[4] == (36, 18, 7)
    says("only 36 pairs passed", "18 of them agree (green), and of these only 7 are right")
    keyboard = (pairs[2][0] < [210, 480]).all(axis=1) & (pairs[2][0] > [0, 310]).all(axis=1)
    assert keyboard[found[2].fits].mean() > 0.5
    assert "(79 pairs, this one 81)" in found[2].doubt
    assert "its baseline by 125.6" in found[2].doubt
    says("whose baseline points 126° elsewhere, fits 79 pairs instead of 81")


def test_the_rail_is_rectified_to_rows(boards):
    for s, label, expected in (
        (0.0, "Rows differ by (RMS)", "7.51"),
        (1.0, "Rows differ by (RMS)", "0.07"),
    ):
        frame = rectification.rectification_frame(s, rectification.BOARD)
        assert read(frame, label) == expected
    assert read(frame, "Left turned by") == "0.62"
    assert read(frame, "Right turned by") == "0.69"
    left, right = boards.left_corners[0][:, 1], boards.right_corners[0][:, 1]
    assert np.sqrt(((left - right) ** 2).mean()) == about(12.46, 2)
    says("$7.5\\cdot 1.6 = 12.0$", "12.46 px")
    says("0.6° and 0.7°", "7.5 px apart", "to 0.07 px")


def test_the_wall_gives_two_answers():
    for name in ("graf1.png", "graf3.png", "H1to3p.xml"):
        fetched(f"opencv_stereo/{name}")
    F, G, one, two = draw.two_halves(*draw.painted_wall())
    assert max(epi.sampson_error(one, two, X).mean() for X in (F, G)) < 0.45
    apart = np.linalg.norm(epi.epipole(F.T) - epi.epipole(G.T))
    assert 2800 < apart < 3000
    says("almost 3000 px apart")
    found = [epi.find_degeneracy(one, two, threshold) for threshold in (0.5, 1.5)]
    assert (len(one), *found) == (269, "none", "plane or rotation")
    everything = tie_points(*draw.painted_wall())
    assert len(everything[0]) == 403
    assert epi.find_degeneracy(*everything, 1.5) == "none"
    assert epi.ransac_fundamental(*everything, np.random.default_rng(0)).fits.sum() > 300
    says("the 269 pairs that were kept", "all 403 pairs", "does *not* refuse the 403 pairs")
