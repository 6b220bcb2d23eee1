"""The numbers that the text of chapter 06 states of the table, the wall and the cameras."""

import re

import numpy as np
import pytest
from lesson_text import about, lesson_text, read

from course_lib import homogeneous, homography, least_squares, resection
from course_lib.drawing import estimation as draw
from course_lib.drawing.estimation import resection as later
from course_lib.drawing.estimation import wall as walls
from course_lib.drawing.explorers import homography as wall_explorer
from course_lib.drawing.explorers.dlt_noise import dlt_noise_frame
from data_generators import cell

TEXT = lesson_text("06_estimation")
says = TEXT.says
CAMERAS = {"A": cell.camera_above(), "B": cell.camera_beside()}
MARKERS = {name: draw.found(camera, cell.MARKERS) for name, camera in CAMERAS.items()}
GOALS = {name: draw.found(camera, draw.GOALS, seed=7) for name, camera in CAMERAS.items()}
TABLE, BLOCK = slice(6), slice(6, 9)
SQUARE = np.array([[0.0, 0], [4, 0], [4, 4], [0, 4]])


def rms(differences):
    return np.sqrt((differences**2).sum(axis=1).mean())


# The table


def affine(name):
    A = least_squares.fit_affine(MARKERS[name], cell.MARKERS)
    return lambda pixels: homogeneous.to_homogeneous(pixels) @ A.T


def test_the_affine_map_of_both_cameras():
    miss = {name: affine(name)(GOALS[name]) - draw.GOALS[:, :2] for name in CAMERAS}
    assert rms(miss["A"][TABLE]) == about(0.2, 1)
    sizes = np.linalg.norm(miss["B"][TABLE], axis=1)
    assert (round(sizes.min()), round(sizes.max())) == (11, 24)
    left = {name: rms(affine(name)(MARKERS[name]) - cell.MARKERS) for name in CAMERAS}
    assert left == {"A": about(0.25, 2), "B": about(20.6, 1)}
    says("to 0.2 mm. With camera B it misses by 11 to 24 mm", "With camera A, 0.25 mm", "20.6 mm")
    pixel = np.linalg.norm(least_squares.fit_affine(MARKERS["A"], cell.MARKERS)[:, 0])
    assert pixel == about(0.98, 2)
    assert 0.2 * np.sqrt(2) * pixel == pytest.approx(left["A"], rel=0.15)
    says("$0.2\\sqrt2 = 0.28$ px, times 0.98 mm")


def test_height():
    r = np.linalg.norm(cell.BLOCK[2, :2] - CAMERAS["A"].centre[:2])
    assert (CAMERAS["A"].centre[2], cell.BLOCK[0, 2]) == (800, 60)
    assert r == about(221, 0)
    assert r * 60 / (800 - 60) == about(17.9, 1)
    limit = 221 * 60 / 5 + 60
    assert limit == 2712
    far = np.linalg.norm(cell.BLOCK[2, :2] - CAMERAS["B"].centre[:2])
    assert (far, far * 60 / 540) == (about(620, 0), about(69, 0))
    H = homography.homography_dlt(MARKERS["B"], cell.MARKERS)
    hit = homogeneous.apply_homography(GOALS["B"][8], H)
    assert np.linalg.norm(hit - cell.BLOCK[2, :2]) == about(69, 0)
    says("$620\\cdot 60/540 = 69$ mm", "target at $(460, 180)$")
    says("17.9 mm", "$r = 221$ mm", "$Z_C > 2712$ mm", "$Z_C = 800$ mm, $Z = 60$ mm")


def test_homography_of_camera_b():
    H = homography.homography_dlt(MARKERS["B"], cell.MARKERS)
    miss = homogeneous.apply_homography(GOALS["B"], H) - draw.GOALS[:, :2]
    assert rms(miss[TABLE]) == about(0.4, 1)
    assert rms(miss[BLOCK]) > 60
    says("camera B now hits to 0.4 mm")
    flat = affine("B")(GOALS["B"]) - draw.GOALS[:, :2]
    assert [rms(m[BLOCK]) for m in (miss, flat)] == [about(71.5, 1), about(85.1, 1)]
    says("71.5 mm instead of 85.1 mm")


def test_the_small_examples():
    H = [[4, 1, 10], [0, 5, 20], [0.5, 0.25, 1]]
    seen = homogeneous.apply_homography([[0, 0], [1, 0], [1, 1], [0, 1]], H)
    expected = [[10, 20], [9.33, 13.33], [8.57, 14.29], [8.8, 20]]
    np.testing.assert_allclose(seen, expected, atol=0.005)
    says("$(10, 20)$, $(9.33, 13.33)$, $(8.57, 14.29)$ and $(8.8, 20)$")
    _, S, Vt = np.linalg.svd(np.array([[2.0, 1], [1, 2]]))
    np.testing.assert_allclose(S, [3, 1])
    np.testing.assert_allclose(Vt[-1] * np.sign(Vt[-1, 0]), [0.71, -0.71], atol=0.005)
    says("the half axes are 3 and 1, and the last row is $(0.71, -0.71)$")
    _, T = homography.normalise_points(SQUARE)
    assert T[0, 0] == 0.5
    says("so $s = 0.5$")
    T_targets = homography.normalise_points(10 * SQUARE)[1]
    np.testing.assert_allclose(np.linalg.inv(T_targets), [[20, 0, 20], [0, 20, 20], [0, 0, 1]])
    np.testing.assert_allclose(np.linalg.inv(T_targets) @ T, np.diag([10, 10, 1]), atol=1e-12)


def condition(points, targets):
    """Return the first by the eighth singular value of the homography's design matrix."""
    (x, y), (u, v) = points.T, targets.T
    one, zero = np.ones_like(x), np.zeros_like(x)
    rows = [x, y, one, zero, zero, zero, -u * x, -u * y, -u]
    more = [zero, zero, zero, x, y, one, -v * x, -v * y, -v]
    sizes = np.linalg.svd(np.vstack([np.stack(rows, 1), np.stack(more, 1)]), compute_uv=False)
    return sizes[0] / sizes[7]


def test_normalising_mends_the_condition():
    near = homography.normalise_points(MARKERS["B"])[0]
    near_places = homography.normalise_points(cell.MARKERS)[0]
    assert round(condition(MARKERS["B"], cell.MARKERS), -5) == 1_100_000
    assert condition(near, near_places) == about(3.7, 1)
    largest = int(np.argmax(MARKERS["B"][:, 0] * cell.MARKERS[:, 0]))
    assert cell.MARKERS[largest, 0] == 480
    assert MARKERS["B"][largest, 0] == about(587, 0)
    says(
        "`S[0] / S[7]` falls from 1 100 000 to 3.7",
        "$u = 587$",
        f"x u = {480 * 587 // 1000}\\,{480 * 587 % 1000}",
    )


def test_the_wall_of_the_explorer():
    corners = [[76, 321], [351, 288], [347, 98], [85, 26]]
    np.testing.assert_allclose(wall_explorer.true_corners(), corners, atol=0.5)
    frame = wall_explorer.homography_frame(*np.ravel(corners))
    assert (read(frame, "A window is wide"), read(frame, "and high")) == (1.0, 1.3)
    says("(76, 321), (351, 288), (347, 98), (85, 26)", "1.00 m × 1.30 m")
    start = wall_explorer.START.copy()
    start[2] = 230, 185
    assert "on one line" in wall_explorer.homography_frame(*start.ravel()).readouts[0].value
    says('two sliders "Top right" to 230 and 185', "12.0 m wide and 8.2 m high")


def test_the_real_wall():
    floors = [np.array(floor.split(), float).reshape(-1, 2) for floor in walls.FLOORS]
    pixels = np.concatenate(floors)
    places = np.array([(k, up) for up, f in enumerate(floors) for k in range(len(f))], float)
    wall = walls.Wall(np.zeros((2, 2, 3), np.uint8), pixels, places)
    four = draw.outer_four(wall)
    exact = homography.homography_dlt(pixels[four], places[four])
    off = np.delete(homogeneous.apply_homography(pixels, exact) - places, four, axis=0)
    assert len(off) == 28
    assert rms(off) == about(0.047, 3)
    assert np.linalg.norm(off, axis=1).max() == about(0.11, 2)
    floor = np.delete(places, four, axis=0)[:, 1]
    assert [rms(off[floor == k]) for k in (3, 1)] == [about(0.072, 3), about(0.033, 3)]
    assert np.linalg.norm(off[floor == 3], axis=1).max() == about(0.11, 2)
    assert places[four].tolist() == [[0, 0], [9, 0], [9, 1], [0, 1]]
    says("0.072 bays, up to 0.11, while on floor 1, between two of them, it is 0.033")
    says("off by 0.047 bays (RMS)", "32 points", "these 28 are off")
    H = homography.homography_dlt(pixels, places)
    assert rms(homogeneous.apply_homography(pixels, H) - places) == about(0.025, 3)
    alone = []
    for k in range(32):
        H = homography.homography_dlt(*(np.delete(a, k, axis=0) for a in (pixels, places)))
        alone.append(homogeneous.apply_homography(pixels[k], H) - places[k])
    assert rms(np.array(alone)) == about(0.031, 3)
    says("now says 0.025 bays", "It says 0.031 bays", "the 0.047 of four points")
    assert len(draw.rendered_building().pixels) == 18
    says("a computed wall with 18 points")


# The whole camera


def test_published_decomposition():
    numbers = re.search(r"published = (\[.*?^\])", TEXT, re.MULTILINE | re.DOTALL)[1]
    P = [[float(x) for x in row.split(",")] for row in re.findall(r"\[([^\[\]]+)\]", numbers)]
    K, _, C = resection.decompose_projection(P)
    np.testing.assert_allclose(K, [[468.2, 91.2, 300], [0, 427.2, 200], [0, 0, 1]], atol=0.05)
    np.testing.assert_allclose(C, [1000, 2000, 1500], atol=0.5)
    says("[468.2, 91.2, 300;\\; 0, 427.2, 200;\\; 0, 0, 1]", "(1000, 2000, 1500)")


def test_where_camera_b_is():
    dots = cell.object_points()
    P = resection.camera_dlt(dots, draw.found(CAMERAS["B"], dots))
    K, _, C = resection.decompose_projection(P)
    np.testing.assert_allclose(C, [678.9, -398.8, 598.3], atol=0.051)
    assert np.linalg.norm(C - CAMERAS["B"].centre) == about(2.4, 1)
    assert (K[0, 0], K[1, 1]) == (about(818.0, 1), about(818.6, 1))
    says("$(678.9, -398.8, 598.3)$ mm, 2.4 mm", "818.0 px and 818.6 px")
    says("focal length 820 px, principal point (319.5, 239.5), centre (680, −400, 600) mm")
    np.testing.assert_allclose(CAMERAS["B"].centre, [680, -400, 600])
    places = np.empty((9, 2))
    for Z, which in ((0, TABLE), (60, BLOCK)):
        H = np.column_stack([P[:, 0], P[:, 1], Z * P[:, 2] + P[:, 3]])
        places[which] = homogeneous.apply_homography(GOALS["B"][which], np.linalg.inv(H))
    assert [round(x, 1) for x in (P[2, 3], 60 * P[2, 2] + P[2, 3])] == [950.4, 912.9]
    assert P[2, 2] == about(-0.626, 3)
    says("$60\\cdot(-0.626) + 950.4 = 912.9$")
    row = [rms((places - draw.GOALS[:, :2])[which]) for which in (TABLE, BLOCK)]
    says(f"the height is known | {row[0]:.1f} mm | {row[1]:.1f} mm |")
    assert rms(places - draw.GOALS[:, :2]) == about(0.5, 1)
    says("all nine, to 0.5 mm")


def test_noise_of_the_dlt():
    scatter = [
        read(dlt_noise_frame(n, 0.5, h, 1), "Scatter, longest way")
        for n, h in ((12, 120), (12, 60))
    ]
    assert scatter == [about(18, 0), about(36, 0)]
    says("from 18 mm to 36 mm", "done 16 times")


# What is left


def test_the_correction_table():
    rng = np.random.default_rng(6)
    seen = CAMERAS["A"].project(cell.on_table(draw.SHEET))
    seen = cell.observed(seen + cell.cover_shift(seen), 0.2, rng)
    H = homography.homography_dlt(draw.SHEET, seen)
    left = seen - homogeneous.apply_homography(draw.SHEET, H)
    assert len(draw.SHEET) == 187
    assert rms(left) == about(1.11, 2)
    assert 0.2 * np.sqrt(2) == about(0.28, 2)
    judged = {shape: later.judge_table(seen, left, shape) for shape in later.TABLES}
    best = min(judged, key=lambda shape: judged[shape].held_out)
    assert best[0] * best[1] == 80
    assert judged[best].held_out == about(0.48, 2)
    assert judged[12, 16].learned == about(0.31, 2)
    assert judged[12, 16].held_out == about(0.67, 2)
    says(
        "187 dots",
        "1.11 px, where chance alone makes 0.28 px",
        "The best table has 80 cells",
        "0.48 px",
    )
    says("about two dots for each", "even better, 0.31 px", "new ones are worse, 0.67 px")
    column, row = (np.minimum((seen + 0.5) / cell.SIZE * (16, 12), (15, 11)).astype(int)).T
    dots = np.bincount(16 * row + column, minlength=192)
    assert [np.sum(dots > 0), np.sum(dots == 1), np.sum(dots > 1)] == [120, 63, 57]
    says("192 cells only 120 hold a dot, 63 of them exactly one", "57 cells hold two dots or more")


def test_without_errors_large_tables_do_harm_too():
    exact = [later.judge_table(*later.exact_sheet(), shape).held_out for shape in later.TABLES]
    sizes = [rows * columns for rows, columns in later.TABLES]
    assert sizes[int(np.argmin(exact))] == 80
    assert [exact[sizes.index(n)] for n in (80, 192)] == [about(0.35, 2), about(0.57, 2)]
    says("from 0.35 px to 0.57 px", "dots without any error")


def test_the_polynomials():
    rng = np.random.default_rng(6)
    seen = CAMERAS["A"].project(cell.on_table(draw.SHEET))
    seen = cell.observed(seen + cell.cover_shift(seen), 0.2, rng)
    H = homography.homography_dlt(draw.SHEET, seen)
    left = seen - homogeneous.apply_homography(draw.SHEET, H)

    def judged(degree):
        def learned(known, residual, at):
            c = resection.polynomial_correction(known, residual, cell.SIZE, degree)
            return resection.correction_from_polynomial(at, c, cell.SIZE)

        return resection.hold_out(learned, seen, left, 10, np.random.default_rng(1)).held_out

    assert [judged(degree) for degree in (5, 9)] == [about(0.35, 2), about(0.46, 2)]
    assert 6 * 7 // 2 == 21  # terms up to degree 5
    says("Degree 5, with 21 numbers", "leaves 0.35 px", "With degree 9 it is 0.46 px")


def test_the_robot_at_the_end():
    for name in CAMERAS:
        H = homography.homography_dlt(MARKERS[name], cell.MARKERS)
        plane = homogeneous.apply_homography(GOALS[name], H)
        for model, hits in (("affine map", affine(name)(GOALS[name])), ("homography", plane)):
            off = [rms((hits - draw.GOALS[:, :2])[which]) for which in (TABLE, BLOCK)]
            says(f"| {name} | {model} | {off[0]:.1f} mm | {off[1]:.1f} mm |")
