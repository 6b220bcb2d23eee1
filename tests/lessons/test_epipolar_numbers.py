"""The numbers that the text of chapter 08 states, but for those of its photographs."""

import math

import numpy as np
import pytest
from lesson_text import about, lesson_text
from lesson_text import readout as read

from course_lib import epipolar as epi
from course_lib.drawing import epipolar as draw
from course_lib.drawing.epipolar import street
from course_lib.drawing.explorers import pairs, ransac, rectification
from course_lib.drawing.explorers.epipolar import epipolar_frame
from course_lib.drawing.explorers.whole_camera import LAMP
from course_lib.epipolar.fundamental import pair_rows
from course_lib.exercises import all_exercises
from course_lib.homogeneous import apply_homography
from course_lib.homography import normalise_points
from course_lib.transforms import camera_centre, skew
from course_lib.widgets.epipolar import epipolar_explorer

says = lesson_text("08_epipolar").says
SAME_ROW = np.array([[0, 0, 0], [0, 0, -1], [0, 1, 0]])
K = np.array([[100, 0, 50], [0, 100, 40], [0, 0, 1.0]])


def test_points_of_all_exercises():
    says(f"**Points:** {sum(exercise.points for exercise in all_exercises('epipolar'))}")
    says("with six exercises", "with five exercises", "(4 points, read by a person)")
    assert len(all_exercises("epipolar")) == 6 + 5 + 1


def test_the_lamp_is_between_the_second_spot_and_the_third():
    one, _ = pairs.cameras(pairs.TOWARDS, street.WIDTH)
    depth = float(one.R[2] @ LAMP + one.t[2])
    assert depth == about(14, 0)
    assert street.DEPTHS[1] < depth < street.DEPTHS[2]
    assert (street.DEPTHS[0], street.DEPTHS[-1]) == (9, 28)
    says("9 m before the camera", "28 m, at the last", "14 m away", "the second spot and the third")


def differences(u, v):
    """Return the positions of the depth slider, and by how much the two patches differ there."""
    depths = epipolar_explorer()._controls["Z"].positions
    apart = [
        read(epipolar_frame(pairs.TOWARDS, u, v, Z), "The two patches differ by") for Z in depths
    ]
    return depths, [math.inf if text == "–" else float(text) for text in apart]


def test_patches_agree_where_the_text_says():
    start = epipolar_explorer().state
    chart = start["u"], start["v"]
    depths, apart = differences(*chart)
    assert depths[int(np.argmin(apart))] == about(10, 0)
    depths, apart = differences(228, 80)
    best = int(np.argmin(apart))
    assert (depths[best], apart[best]) == (about(27, 0), 17)
    for Z, levels in ((19.5, 30), (31.4, 27)):
        i = depths.index(Z)
        assert apart[i] == levels == min(apart[i - 1 : i + 2])
    one, _ = pairs.cameras(pairs.TOWARDS, 340)
    for at, depth in ((chart, 10), ((228, 80), 27)):
        (X,) = pairs.surface(one, np.array([at]))
        assert float(one.R[2] @ X + one.t[2]) == about(depth, 0)
    says("$u = 228$, $v = 80$", "At about 10 m", "17 grey levels at 27 m, which is right")
    says("at 19.5 m and at 31.4 m", "30 and 27 levels")


def test_the_worked_examples_of_the_first_sitting():
    np.testing.assert_array_equal(skew([1, 2, 3]) @ [0, 1, 0], (-3, 0, 1))
    E = epi.essential_from_pose(np.eye(3), [-1, 0, 0])
    np.testing.assert_allclose(E, [[0, 0, 0], [0, 0, 1], [0, -1, 0]])
    np.testing.assert_allclose(E @ [0.25, 0.5, 1], (0, 1, -0.5))
    assert np.array([0, 0.5, 1]) @ E @ [0.25, 0.5, 1] == 0
    np.testing.assert_allclose(camera_centre(np.eye(3), [-1, 0, 0]), (1, 0, 0))
    R = np.array([[0, 0, -1], [0, 1, 0], [1, 0, 0]])
    expected = [[2, -3, 0], [-1, 0, -3], [0, 1, 2]]
    np.testing.assert_allclose(epi.essential_from_pose(R, [1, 2, 3]), expected)
    P1 = np.array([[2, 0, 0, 2], [0, 2, 0, 0], [0, 0, 1, 0]])
    P2 = np.array([[0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 1, 1]])
    F = epi.fundamental_from_cameras(P1, P2)
    expected = [[-0.5, 0, -1], [0, -0.5, 0], [0, -0.5, 0]]
    np.testing.assert_allclose(-F / F[0, 2], expected, atol=1e-12)
    np.testing.assert_allclose(P2[:, :3] @ (-1, 0, 0) + P2[:, 3], (0, -1, 1))
    np.testing.assert_allclose(P1 @ (-1, 0, 0, 1), 0)
    np.testing.assert_allclose(np.abs(epi.epipolar_lines([10, 30], SAME_ROW)), (0, 1, 30))
    assert epi.line_distance([0, 0], [3, 4, -10]) == 2
    example = np.array([[0, -1, 50], [1, 0, -60], [-50, 60, 0]])
    np.testing.assert_allclose(epi.epipole(example), (60, 50))
    np.testing.assert_array_equal(SAME_ROW @ (1, 0, 0), 0)
    a, b = np.array([[1, 2, 1], [3, 0, 1]]), np.array([[5, 1, 2], [4, 2, 0]])
    assert (a * b).sum(axis=1).tolist() == [9, 12]


def test_F_and_E_with_the_same_camera_twice():
    E = epi.essential_from_pose(np.eye(3), [-1, 0, 0])
    np.testing.assert_allclose(np.linalg.inv(K), [[0.01, 0, -0.5], [0, 0.01, -0.4], [0, 0, 1]])
    half_way = E @ np.linalg.inv(K)
    np.testing.assert_allclose(half_way, [[0, 0, 0], [0, 0, 1], [0, -0.01, 0.4]], atol=1e-12)
    F = np.linalg.inv(K).T @ half_way
    np.testing.assert_allclose(F, [[0, 0, 0], [0, 0, 0.01], [0, -0.01, 0]], atol=1e-12)
    np.testing.assert_allclose(F @ (75, 90, 1), (0, 0.01, -0.9), atol=1e-12)
    np.testing.assert_allclose(F @ K, [[0, 0, 0], [0, 0, 0.01], [0, -1, -0.4]], atol=1e-12)
    np.testing.assert_allclose(K.T @ F @ K, E, atol=1e-12)
    says("$(75, 90)$ gets the line", "the row $v = 0.9/0.01 = 90$")


def test_lines_of_two_points_of_the_street_are_not_parallel():
    one, other = pairs.cameras(pairs.TOWARDS, 340)
    F = epi.fundamental_from_cameras(one.P, other.P)
    lines = epi.epipolar_lines([[170, 20], [170, 240]], F)
    slopes = lines[:, 0] / lines[:, 1]
    assert slopes.tolist() == [about(0.17, 2), about(0.08, 2)]
    assert epi.epipole(F.T).tolist() == [about(-2243, 0), about(441, 0)]
    one, other = pairs.cameras(pairs.APART, 340)
    F = epi.fundamental_from_cameras(one.P, other.P)
    np.testing.assert_allclose(F @ (1, 0, 0), 0, atol=1e-12 * np.abs(F).max())
    says("by 0.17 px for each px", "$(170, 240)$ by 0.08", "$(-2243, 441)$")
    says("its pictures are 340 px wide, those of the other figures 480")
    assert street.WIDTH == 480


def test_the_car_heads_for_the_middle():
    np.testing.assert_allclose(epi.epipole(draw.forward_fundamental()), (239.5, 179.5), atol=1e-6)
    eyes = np.array(pairs.EYES[pairs.AHEAD])
    assert np.linalg.norm(eyes[1] - eyes[0]) == 4
    says("4 m apart", "$(239.5, 179.5)$")


def test_one_px_down_is_a_bit_less_off_the_lines():
    left, right = draw.street_points()
    lines = epi.epipolar_lines(left, epi.fundamental_from_cameras(*draw.street_cameras()))
    assert epi.line_distance(right, lines).max() < 1e-9
    off = epi.line_distance(right + np.array([0, 1]), lines)
    assert ((off > 0.95) & (off < 1)).all()


def test_the_worked_examples_of_the_second_sitting():
    row = pair_rows(np.array([[2.0, 3]]), np.array([[5.0, 7]]))[0]
    np.testing.assert_array_equal(row, (10, 15, 5, 14, 21, 7, 2, 3, 1))
    near = [normalise_points(points)[0] for points in draw.eight_pairs()]
    raw = np.linalg.svd(pair_rows(*near))[2][-1].reshape(3, 3)
    assert np.linalg.svd(raw)[1].tolist() == [about(0.733, 3), about(0.680, 3), about(0.0015, 4)]
    assert epi.sampson_error([[10, 30]], [[5, 32]], SAME_ROW) == about(1.41, 2)
    assert epi.symmetric_distance([[10, 30]], [[5, 32]], SAME_ROW) == pytest.approx(2)
    assert epi.ransac_iterations(0.99, 8, 0.5) == 1177
    assert epi.ransac_iterations(0.99, 5, 0.5) == 146
    assert epi.ransac_iterations(0.99, 7, 0.5) == 588
    assert about(0.0039, 4) == 0.5**8
    assert math.log(0.01) == about(-4.605, 3)
    assert math.log(1 - 0.5**8) == about(-0.003914, 6)
    E = np.array([[0, 0, 0], [0, 0, 1], [0, -1, 0]])
    U, _, Vt = np.linalg.svd(E.astype(float))
    np.testing.assert_allclose(U, [[0, 0, 1], [0, 1, 0], [1, 0, 0]], atol=1e-12)
    np.testing.assert_allclose(Vt, [[0, -1, 0], [0, 0, 1], [1, 0, 0]], atol=1e-12)
    W = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    np.testing.assert_allclose(U @ W @ Vt, np.diag([1, -1, -1]), atol=1e-12)
    np.testing.assert_allclose(U @ W.T @ Vt, np.eye(3), atol=1e-12)
    for e, line in (((1, 0, 0), (0, -1, 3)), ((0, 1, 0), (1, 0, -5))):
        np.testing.assert_array_equal(np.cross(e, (5, 3, 1)), line)
        assert np.dot(line, (5, 3, 1)) == 0
    _, t = epi.pose_from_essential(E, [[0.25, 0]], [[0, 0]])
    np.testing.assert_allclose(t, (-1, 0, 0), atol=1e-12)
    for sign in (1, -1):
        depths = epi.pair_depths(np.eye(3), [-sign, 0, 0], [[0.25, 0]], [[0, 0]])
        np.testing.assert_allclose(np.ravel(depths), 4 * sign)
    says(
        "$(0.733, 0.680, 0.0015)$",
        "$N = 1177$",
        "it would be 146",
        "588 draws instead of 1177",
        "-4.605",
        "-0.003914",
    )


def test_the_stepper_does_what_the_text_says():
    drawn = ransac.drawn(30.0)
    clean = np.flatnonzero(drawn.right[drawn.samples].all(axis=1)) + 1
    assert clean[:2].tolist() == [18, 71]
    agree = (drawn.errors <= 1.0).sum(axis=1)
    assert (agree[:17].min(), agree[:17].max()) == (1, 9)
    assert (agree[17], agree[70], drawn.right.sum()) == (41, 17, 42)
    assert drawn.right[drawn.errors[17] <= 1].all()
    wide = drawn.errors[17] <= 10
    assert (wide.sum(), (wide & ~drawn.right).sum()) == (45, 3)
    says("one to nine agree", "Draw 18", "41 of the 42", "Draw 71", "Only 17")
    says("45 pairs agree in draw 18, three more")


def test_a_clean_draw_is_one_in_17():
    assert about(0.058, 3) == 0.7**8
    assert about(17, 0) == 0.7**-8
    says("$0.7^8 = 0.058$, one in 17")


def test_the_example_of_rectification():
    found = epi.rectify(K, K, np.eye(3), [-0.8, -0.6, 0])
    expected = [[0.8, 0.6, 0], [-0.6, 0.8, 0], [0, 0, 1]]
    np.testing.assert_allclose(found.R1, expected, atol=1e-12)
    partner = K @ (2 * (np.linalg.inv(K) @ (150, 140, 1)) - (0.8, 0.6, 0))
    np.testing.assert_allclose(partner[:2] / partner[2], (110, 110))
    np.testing.assert_allclose(apply_homography([150, 140], found.H1), (190, 60))
    np.testing.assert_allclose(apply_homography([110, 110], found.H2), (140, 60))
    says("the pixel $(190, 60)$", "at $(110, 110)$", "pixel $(140, 60)$. The same row.")


def test_the_street_turns_as_the_text_says():
    start = rectification.rectification_frame(1.0, rectification.STREET)
    assert read(start, "Left turned by") == "11.15"
    assert read(start, "Right turned by") == "12.06"
    eyes = np.array(pairs.EYES[pairs.TOWARDS])
    assert eyes[1, 2] - eyes[0, 2] == pytest.approx(0.6)
    says("by 11.2° and 12.1°", "60 cm higher")


def test_the_six_positions_do_what_the_text_says():
    from course_lib.drawing.epipolar.gruber import parallaxes

    by, bz, omega, phi, kappa = (np.abs(row) > 1e-6 for row in parallaxes())
    at = [np.flatnonzero(acts) + 1 for acts in (by, bz, omega, phi, kappa)]
    expected = [[1, 2, 3, 4, 5, 6], [3, 4, 5, 6], [1, 2, 3, 4, 5, 6], [3, 5], [1, 3, 5]]
    assert [places.tolist() for places in at] == expected
    says("$\\kappa$ acts only at 1, 3 and 5", "$\\varphi$ only at 3 and 5")


def test_of_the_solutions_of_seven_pairs_the_eighth_picks_one():
    points1, points2 = draw.eight_pairs(sigma=0.0)
    solutions = epi.seven_point(points1[:7], points2[:7])
    off = [epi.sampson_error(points1[7:], points2[7:], F)[0] for F in solutions]
    assert len(off) == 3
    assert sorted(off)[0] < 1e-6 < 5 < sorted(off)[1]
