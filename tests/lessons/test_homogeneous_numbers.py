"""The numbers that the text of chapter 02 states are those that the library computes."""

import re

import numpy as np
import pytest
from lesson_text import lesson_text

from course_lib import camera, homogeneous, transforms
from course_lib.camera import Camera
from course_lib.drawing import homogeneous as draw
from course_lib.drawing.explorers.join_meet import join_meet_frame
from course_lib.drawing.explorers.whole_camera import FIRST, whole_camera, whole_camera_frame
from course_lib.drawing.homogeneous import projective
from course_lib.widgets.homogeneous import join_meet_explorer, whole_camera_explorer

TEXT = lesson_text("02_homogeneous")
says = TEXT.says
SECOND = Camera(draw.K, *transforms.cv_from_graphics_camera(draw.FROM_BLENDER), draw.SIZE)


def rounded(values, digits):
    return (np.round(values, digits) + 0.0).tolist()


def test_one_number_more():
    assert homogeneous.from_homogeneous([6, 8, 2]).tolist() == [3, 4]
    shift = np.array([[1, 0, 10], [0, 1, 20], [0, 0, 1]])
    moved = homogeneous.to_homogeneous([[0.0, 0.0], [1.0, 2.0]]) @ shift.T
    assert moved.tolist() == [[10, 20, 1], [11, 22, 1]]
    away = [homogeneous.from_homogeneous([2, w])[0] for w in (1, 0.1, 0.01)]
    np.testing.assert_allclose(away, [2, 20, 200])
    says("$(10, 20, 1)$ and $(11, 22, 1)$", "They mean 2, 20, 200")


def test_join_and_meet():
    assert np.cross([0, 1, 1], [2, 2, 1]).tolist() == [-1, 2, -2]
    point = homogeneous.meet([1, -2, 2], [1, 1, -4])
    assert point.tolist() == [6, 6, 3]
    says("(-1, 2, -2)", "(6, 6, 3)", r"\sim (2, 2)")


def test_the_explorer_shows_where_the_point_runs():
    where = {r: join_meet_frame(0.3, 0.7, r, -0.7).readouts[3].value for r in (0.2, 0.3, 0.4)}
    assert where[0.2].startswith("(-14.00,")
    assert where[0.3] == "at infinity, direction (1.4, 0.42)"
    assert where[0.4].startswith("(14.00,")
    assert join_meet_explorer().state == {"p": 0.3, "q": 0.7, "r": -0.4, "s": -0.7}
    says("at $r = 0.2$ it is at $x = -14$", "at $x = 14$", "slopes 0.3 and $-0.4$")


def test_boards_meet_where_chapter_01_found():
    edges = [[(527, 11.5), (709.5, 13)], [(559.5, 168.5), (693, 176)]]
    lines = [homogeneous.line_through(*homogeneous.to_homogeneous(edge)) for edge in edges]
    pixel = homogeneous.from_homogeneous(homogeneous.meet(*lines))
    assert rounded(pixel, 0) == [-2708, -15]
    says("$(-2708, -15)$", *(f"{tuple(edge[0])}, {tuple(edge[1])}" for edge in edges))


def test_cross_ratio_of_equal_steps():
    steps = np.array([[0.0, 1], [1, 1], [2, 1], [3, 1]])
    seen = homogeneous.apply_homography(steps, [[0.8, 0.1, 5], [0.05, 0.7, 2], [0.02, 0.04, 1]])
    assert np.ptp(np.linalg.norm(np.diff(seen, axis=0), axis=1)) > 0.04
    for points in (steps, seen):
        assert homogeneous.cross_ratio(points) == pytest.approx(4 / 3)
    says("= 4/3$")


def test_upright_lines_of_the_projective_picture_meet_at_its_second_column():
    H = projective.KINDS["projective"]
    assert H[:, 1].tolist() == [0.06, 0.72, 0.32]
    there = homogeneous.from_homogeneous(H @ (0, 1, 0))
    assert rounded(there, 2) == [0.19, 2.25]
    assert homogeneous.apply_homography([[-1, 1], [1, 1]], H)[:, 1].max() < there[1]
    for x in (-1, 0, 1):
        seen = homogeneous.to_homogeneous(homogeneous.apply_homography([[x, -1], [x, 1]], H))
        assert abs(homogeneous.line_through(*seen) @ (*there, 1)) < 1e-12
    says("second column $(0.06, 0.72, 0.32)$", "the ordinary point $(0.19, 2.25)$")


def test_a_pose_and_its_way_back():
    R, t = transforms.rotation_z(np.pi / 2), np.array([1, 2, 3])
    assert rounded(R @ (1, 0, 0), 9) == [0, 1, 0]
    assert rounded(R @ (1, 0, 0) + t, 9) == [1, 3, 3]
    assert [rounded(R.T @ x, 9) for x in (t, (1, 3, 3))] == [[2, -1, 3], [3, -1, 3]]
    back = transforms.invert_pose(R, t)
    assert rounded(back[0] @ (1, 3, 3) + back[1], 9) == [1, 0, 0]
    says(r"$R^\mathsf{T}\mathbf t = (2, -1, 3)$", "(3, -1, 3) - (2, -1, 3) = (1, 0, 0)")
    says("$(0, 1, 0) + (1, 2, 3) = (1, 3, 3)$")


def test_the_pose_of_the_drone():
    axes = np.array([[1, 0, 0], [0, -0.8, 0.6], [0, -0.6, -0.8]])
    R, t = transforms.pose_from_placement(axes, (2, -10, 40))
    assert rounded(t, 9) == [-2, 16, 38]
    assert rounded(R, 9) == [[1, 0, 0], [0, -0.8, -0.6], [0, 0.6, -0.8]]
    says(
        r"-(2,\, -16,\, -38) = (-2, 16, 38)", "$(0, -0.8, -0.6)$ down and $(0, 0.6, -0.8)$ forward"
    )
    says("axes = np.array([[1, 0, 0], [0, -0.8, 0.6], [0, -0.6, -0.8]])", "np.array([2, -10, 40])")


def test_the_file_names_the_direction_backwards():
    assert draw.FROM_BLENDER[:3, 2].tolist() == [0.768, -0.576, 0.28]
    assert rounded(SECOND.R[2], 9) == [-0.768, 0.576, -0.28]
    says("$(0.768, -0.576, 0.28)$", "along $(-0.768, 0.576, -0.28)$")


def test_the_lamp_divided_by_its_depth():
    readings = {r.label: r.value for r in whole_camera_frame(**FIRST).readouts}
    assert readings["Lamp times P"] == "(3932, 1392, 12.74)"
    assert rounded(np.array([3932, 1392]) / 12.74, 0) == [309, 109]
    assert readings["Lamp in the picture"].startswith("(309, 109)")
    says("$(3932, 1392, 12.74)$", "= (309, 109)$")


def test_moves():
    foot = transforms.rotation_z(np.radians(60)) @ [2, 0, 0]
    assert rounded(foot[:2], 2) == [1, 1.73]
    assert rounded(transforms.rotation_z(np.radians(30)) @ [1, 0, 0], 2) == [0.87, 0.5, 0]
    says("$(1, 1.73)$ on the right", "to $(0.87, 0.5)$")


def test_rotations():
    one = transforms.rotation_from_euler(np.radians([30, 90, 0]), "zyx")
    other = transforms.rotation_from_euler(np.radians([0, 90, -30]), "zyx")
    np.testing.assert_allclose(one, other, atol=1e-12)
    turn = transforms.rotation_about_axis((1, 1, 1), np.radians(120))
    np.testing.assert_allclose(turn, np.roll(np.eye(3), 1, axis=0), atol=1e-12)
    np.testing.assert_allclose(transforms.quaternion_from_rotation(turn), [0.5] * 4)
    says("Yaw 30° and roll 0° give the same matrix as yaw 0° and roll −30°", "(0.5, 0.5, 0.5, 0.5)")


def test_where_the_second_camera_is():
    assert rounded(SECOND.t, 2) == [-12.84, 7.79, -1.35]
    assert rounded(SECOND.centre, 2) == [4.92, 12.36, 7.10]
    assert np.linalg.norm(SECOND.t) == pytest.approx(15.1, abs=0.05)
    assert np.linalg.norm(SECOND.centre) == pytest.approx(np.linalg.norm(SECOND.t))
    measured = SECOND.R @ draw.CORNER + SECOND.t
    assert rounded(measured, 3) == [4.090, -2.854, 16.907]
    says(r"(-12.84,\, 7.79,\, -1.35)", r"(4.92,\, 12.36,\, 7.10)", "15.1 m")
    says("np.array([4.090, -2.854, 16.907])")


def test_the_corner_is_the_tip_of_the_roof():
    from data_generators.places import street

    corners = np.concatenate([patch.corners for patch in street().patches])
    assert np.linalg.norm(corners - draw.CORNER, axis=1).min() < 1e-9


def test_the_mast_grows():
    file = draw.FROM_BLENDER.copy()
    file[2, 3] = 12
    high = Camera(draw.K, *transforms.cv_from_graphics_camera(file), draw.SIZE)
    low, moved = SECOND.project(draw.CORNER), high.project(draw.CORNER)
    assert [rounded(low, 0), rounded(moved, 0)] == [[529, 121], [516, 310]]
    says("by 189 px at the corner of the eaves: from $(529, 121)$ to $(516, 310)$")


def test_the_mark_at_t_lies_in_the_cellar_of_the_neighbours():
    from data_generators.places import HOUSES

    side, start, length, depth, *_ = HOUSES[0]
    x, y, z = SECOND.t
    assert side == -1
    assert -6.6 - depth < x < -6.6
    assert start < y < start + length
    assert round(z, 2) == -1.35
    says("inside the neighbour's house, 1.35 m below the ground", "(-12.84, 7.79, -1.35)")


def test_the_file_read_wrongly_looks_elsewhere():
    placed = transforms.pose_from_placement(draw.FROM_BLENDER[:3, :3], draw.FROM_BLENDER[:3, 3])
    np.testing.assert_allclose(placed[0][2], -SECOND.R[2])  # backwards
    np.testing.assert_allclose(placed[0][1], -SECOND.R[1])  # upside down
    assert placed[0][1] @ (0, 0, 1) > 0.9  # its y axis, down in the picture, is up in the world


def test_intrinsics_of_the_example():
    assert pytest.approx(draw.K[0, 0]) == 35 / 0.05
    assert pytest.approx(20) == 1 / 0.05
    says("$m_x = 20$ px/mm", "$f_x = 700$ px")


def test_answers_to_the_questions_on_the_whole_camera():
    assert len(whole_camera_explorer().state) == 11 == len(FIRST)
    moved = whole_camera(**FIRST | {"x": 2, "y": 1, "z": 3}).P - whole_camera(**FIRST).P
    assert (np.abs(moved[:, :3]) < 1e-12).all()
    west = [whole_camera(**FIRST | {"pan": 90, "y": y}).t for y in (-3.5, 2.0)]
    change = np.abs(west[1] - west[0]) > 1e-9
    assert change.tolist() == [True, False, False]
    readings = {r.label: r.value for r in whole_camera_frame(**FIRST | {"pan": 180}).readouts}
    assert float(readings["Lamp times P"].strip("()").split(",")[2]) < 0
    says("exactly eleven sliders", "the first number of $\\mathbf t$ changes")


def test_columns():
    P = draw.corner_camera().P
    assert rounded(P[:2, 0], 1) == [514.5, 26.8]
    assert rounded(P[2, 0], 2) == 0.58
    assert rounded(P[:2, 0] / P[2, 0], 0) == [887, 46]
    assert draw.corner_camera().K[0, 0] == 400
    says(r"$(514.5,\, 26.8,\, 0.58)$", "$(887, 46)$", "$f = 400$ px")


def test_published_example_of_a_decomposition():
    numbers = re.search(r"^P = (\[.*?^\])", TEXT, re.MULTILINE | re.DOTALL)[1]
    P = [[float(x) for x in row.split(",")] for row in re.findall(r"\[([^\[\]]+)\]", numbers)]
    K, _, C = camera.decompose_projection(P)
    assert rounded(K, 1) == [[468.2, 91.2, 300], [0, 427.2, 200], [0, 0, 1]]
    assert rounded(C, 0) == [1000, 2000, 1500]
    says("468.2 px and 427.2 px, the skew is 91.2 px", "$(1000, 2000, 1500)$")


def test_angles_of_photogrammetry():
    angles = np.degrees(transforms.omega_phi_kappa_from_rotation(SECOND.R))
    assert rounded(angles, 1) == [64.1, 50.2, 20.5]
    down = transforms.rotation_from_omega_phi_kappa(0, 0, 0)
    assert (down @ (0, 0, -1)).tolist() == [0, 0, 1]  # the ground is ahead
    assert (down @ (0, 1, 0)).tolist() == [0, -1, 0]  # north is up in the picture
    says("ω = 64.1°, φ = 50.2°, κ = 20.5°")


def test_gimbal_moves_the_hole():
    ahead, left = (
        camera.camera_centre(*transforms.gimbal_pose(pan, 0, (0, 0, 3), (0, -0.1, 0.2)))
        for pan in (0, np.pi / 2)
    )
    assert rounded(ahead, 9) == [0, 0.2, 3.1]
    assert rounded(left, 9) == [-0.2, 0, 3.1]
    assert np.linalg.norm(ahead - left) == pytest.approx(0.28, abs=0.005)
    says("$(0, 0.2, 3.1)$ and at $(-0.2, 0, 3.1)$", "by 0.28 m")


def test_gimbal_is_the_product_that_the_text_writes():
    pan, tilt, mount, offset = 0.4, -0.3, (1, 2, 3), (0.1, -0.2, 0.3)
    rest = np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]]).T  # x, y, z at rest as columns
    product = (
        transforms.rigid_matrix(t=mount)
        @ transforms.rigid_matrix(transforms.rotation_z(pan))
        @ transforms.rigid_matrix(transforms.rotation_x(tilt))
        @ transforms.rigid_matrix(rest)
        @ transforms.rigid_matrix(t=offset)
    )
    R, t = transforms.gimbal_pose(pan, tilt, mount, offset)
    np.testing.assert_allclose(transforms.rigid_matrix(R, t) @ product, np.eye(4), atol=1e-12)
    says(r"$x \to (1, 0, 0)$, $y \to (0, 0, -1)$, $z \to (0, 1, 0)$")


def test_measuring_with_one_picture():
    pixels = SECOND.project(draw.HOUSE[:2])
    assert rounded(pixels, 0) == [[169, 427], [496, 317]]
    C, d = camera.pixel_ray(rounded(pixels, 0), SECOND.K, SECOND.R, SECOND.t)
    along = -C[2] / d[:, 2:]
    ground = C + along * d
    assert rounded(np.linalg.norm(ground[1] - ground[0]), 2) == 8.97
    assert rounded(np.linalg.norm(draw.HOUSE[1] - SECOND.centre), 1) == 18.9
    assert np.linalg.norm(draw.HOUSE[1] - draw.HOUSE[0]) == 9
    says(
        "9.00 m wide, and whole pixels give 8.97 m", "18.9 m away", "(169.0, 427.0), (496.0, 317.0)"
    )


def test_back_to_the_street():
    first = draw.first_camera()
    pixels = [rounded(view.project(draw.CORNER), 1) for view in (first, SECOND)]
    assert pixels == [[650.9, 107.0], [528.8, 121.3]]
    sizes = [1000 * (v.R @ draw.CORNER + v.t)[2] / v.K[0, 0] for v in (first, SECOND)]
    assert rounded(sizes, 1) == [16.6, 24.2]
    assert rounded(np.multiply(sizes, 720 / 6000), 1) == [2.0, 2.9]
    assert rounded(np.linalg.norm(first.centre - SECOND.centre), 2) == 9.62
    assert rounded(np.linalg.norm(draw.CORNER - first.centre), 1) == 12.8
    assert first.project(draw.CORNER).round().tolist() == [651, 107]
    direction = np.linalg.inv(first.K) @ (651, 107, 1)
    assert rounded(direction, 3) == [0.416, -0.189, 1]
    says("$(651, 107)$", "$(0.416, -0.189, 1)$", "It is 12.8 m away")
    assert first.centre[0] - draw.HOUSE[0, 0] == pytest.approx(12)
    says(
        "$(650.9, 107.0)$", "$(528.8, 121.3)$", "16.6 mm and 24.2 mm", "2.0 mm and 2.9 mm", "9.62 m"
    )
