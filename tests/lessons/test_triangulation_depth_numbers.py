"""Every number in the second sitting of chapter 09: depth from disparity, and how sure it is."""

import numpy as np
import pytest
from lesson_text import about, lesson_text, read

from course_lib import triangulation as tri
from course_lib.drawing.explorers import bench, disparity
from course_lib.drawing.explorers.disparity import disparity_frame
from course_lib.drawing.triangulation import dense, pair, plane, uncertainty
from course_lib.exercises.triangulation import plain

TEXT = lesson_text("09_triangulation")
says = TEXT.says
MARKS = np.array(list(pair.MARKED.values()))  # point, picture, (u, v)
CAMERAS = np.array([pair.P_LEFT, pair.P_RIGHT])
EYE = np.array([[800.0, 0, 320, 0], [0, 800, 240, 0], [0, 0, 1, 0]])
PLAIN = np.array([[100.0, 0, 0, 0], [0, 100, 0, 0], [0, 0, 1, 0]])
PLAIN_PAIR = np.stack([PLAIN, PLAIN - [[0, 0, 0, 100], [0, 0, 0, 0], [0, 0, 0, 0]]])


def length(points):
    return float(np.linalg.norm(points[0] - points[1]))


def true_points():
    """Return the marked points from the true disparities of their left pixels."""
    depths = dense.depths(pair.motorcycle().truth)
    rays = np.column_stack([MARKS[:, 0], [1, 1]]) @ np.linalg.inv(pair.K_LEFT).T
    u, v = MARKS[:, 0].astype(int).T
    return rays * depths[v, u][:, None]


def test_disparity_and_depth():
    depths = tri.depth_from_disparity([45, 51.5], pair.F, pair.BASELINE, pair.OFFSET)
    assert depths.tolist() == [about(2523.9, 1), about(2325.2, 1)]
    assert about(192031.7, 0) == pair.F * pair.BASELINE
    says(
        "$f = 994.978$ px, $b = 193.001$ mm and $\\Delta c = 31.086$ px",
        "192\\,031/76.086 = 2523.9$ mm",
    )
    assert true_points()[:, 2].tolist() == [about(2529.1, 1), about(2326.0, 1)]
    d = pair.F * pair.BASELINE / np.array([2000, 2500, 4000, 5000])
    assert pair.OFFSET < d[0] < 70 + pair.OFFSET  # 2 m is in the figure
    assert (-np.diff(d)[[0, 2]]).tolist() == [about(19, 0), about(10, 0)]
    says("From 2 to 2.5 m the disparity falls by 19 px, from 4 to 5 m by 10 px only")
    says("It says 2529.1 and 2326.0 mm; by hand we have 2523.9 and 2325.2 mm")


def test_the_windows_of_the_explorer():
    def at(u, v, reach):
        frame = disparity_frame(u, v, reach)
        return read(frame, "Disparity"), read(frame, "True disparity")

    assert [at(97, 208, reach)[0] for reach in (4, 12, 1)] == [45.0, 45.0, 44.2]
    says("45.0 px with 4 px and with 12 px, and 44.2 px with 1 px to each side")
    assert (at(570, 220, 4), at(570, 220, 12)[0]) == ((20.4, 20.0), 50.6)
    says("20.4 px with 4 px; the truth is 20.0. With 12 px it is 50.6")
    assert [at(260, 70, reach)[0] for reach in (1, 2, 4, 8, 12)] == [1.6, 0.0, 1.5, 3.7, 4.6]
    assert at(260, 70, 4)[1] == 12.3
    lamp, door = (disparity.search(*uv, 4).differences for uv in ((97, 208), (260, 70)))
    assert (lamp.min(), lamp.max()) == (about(10, 0), about(112, 0))
    assert (door.min(), door[12]) == (about(1.4, 1), about(2.5, 1))
    says("is 1.4 grey levels, and that at the true place 2.5", "10 at the right place, up to 112")
    assert all(abs(at(260, 70, reach)[0] - 12.3) > 2 for reach in range(1, 13))
    says("No: 1.6, 0.0, 1.5, 3.7 and 4.6 px with 1, 2, 4, 8 and 12 px to each side")
    depth = next(r.value for r in disparity_frame(260, 70, 4).readouts if r.label == "Depth")
    assert depth == "5891 ± 63"
    true = float(tri.depth_from_disparity(at(260, 70, 4)[1], pair.F, pair.BASELINE, pair.OFFSET))
    assert (5891 - true) / 1000 == about(1.5, 1)
    says("5891 ± 63 mm, and it is wrong by a metre and a half")


def test_the_uncertainty_of_depth():
    Z = float(tri.depth_from_disparity(45, pair.F, pair.BASELINE, pair.OFFSET))
    assert 0.25 * np.sqrt(2) == about(0.354, 3)
    sigma = tri.depth_uncertainty(Z, pair.F, pair.BASELINE, 0.25 * np.sqrt(2))
    assert sigma == about(11.7, 1)
    assert true_points()[0, 2] - Z == about(5.2, 1)
    says("$\\sigma_d = 0.354$ px", "= 11.7$ mm. (It was off by 5.2 mm.)")
    assert disparity.SIGMA == 0.35  # measured by a test of the explorer
    says("with $\\sigma_d = 0.35$ px: so far off are good matches in this pair")
    curve = tri.depth_uncertainty([2000, 4000], 1000, 200, 0.1 * np.sqrt(2))
    assert curve.tolist() == [about(2.8, 1), about(11.3, 1)]
    says("2.8 mm, then 11.3 mm", "2.8 mm at 2 m, 11.3 mm at 4 m")


def test_the_design_rule():
    sigma = 0.1 * np.sqrt(2)
    assert sigma == about(0.1414, 4)
    assert 2000**2 * sigma / (1000 * 1) == about(566, 0)
    says("2000^2\\cdot 0.1414/(1000\\cdot 1) = 566$ mm")
    for Z, f, b, pixel in (
        (2000, 1000, 566, 0.1),
        (2000, 2830, 200, 0.1),
        (2000, 1000, 200, 0.035),
        (1190, 1000, 200, 0.1),
    ):
        assert tri.depth_uncertainty(Z, f, b, np.sqrt(2) * pixel) == about(1.0, 1)
    says(
        "$b = 566$ mm | 1.0",
        "$f = 2830$ px (a longer lens) | 1.0",
        "0.035 px | 1.0",
        "1.19 m | 1.0",
    )
    assert uncertainty.BASELINES == (100, 200, 566)


def test_the_ellipsoid_of_the_example():
    X = np.array([0.5, 0, 5])
    images = PLAIN_PAIR @ [*X, 1]
    assert (images[:, 0] / images[:, 2]).tolist() == [10, -10]
    C = plain.point_covariance(X, PLAIN_PAIR, 0.2)
    np.testing.assert_allclose(0.04 * np.linalg.inv(C), np.diag([800, 800, 8]), atol=1e-9)
    sideways, _, depth = np.sqrt(np.diag(C))
    assert (sideways, depth) == (about(0.007, 3), about(0.071, 3))
    assert depth / sideways == pytest.approx(2 * 5 / 1)
    assert tri.depth_uncertainty(5, 100, 1, 0.2 * np.sqrt(2)) == about(0.071, 3)
    says(
        "0.2/\\sqrt{800} = 0.007$ m", "0.2/\\sqrt 8 = 0.071$ m", "The ratio of both is $10 = 2Z/b$"
    )
    says("$(20, 0, -2)$ and $(20, 0, 2)$")


def test_the_cloud_is_in_its_ellipse():
    C = tri.point_covariance(uncertainty.POINT, uncertainty.PAIR, uncertainty.NOISE)
    off = uncertainty.thousand_answers() - uncertainty.POINT
    flat = C[np.ix_([0, 2], [0, 2])]
    assert uncertainty.inside(off[:, [0, 2]], flat) == pytest.approx(1 - np.exp(-2), abs=0.03)
    assert 100 * (1 - np.exp(-2)) == about(86.5, 1)
    np.testing.assert_allclose(np.sqrt((off**2).mean(axis=0)), np.sqrt(np.diag(C)), rtol=0.06)
    assert np.sqrt(C[2, 2] / C[0, 0]) == pytest.approx(8)
    says("86.5 % of all answers", "2·4/1 = 8 times")


def test_the_ellipses_from_above_grow_and_lean():
    def longest(x, z):
        C = tri.point_covariance([x, 0, z], uncertainty.PAIR, uncertainty.NOISE)
        sizes, axes = np.linalg.eigh(C[np.ix_([0, 2], [0, 2])])
        along = axes[:, 1]
        return np.sqrt(sizes[1]), x - z * along[0] / along[1]  # length; where it meets z = 0

    assert longest(0.5, 4)[0] / longest(0.5, 2)[0] == pytest.approx(4)
    for x in (-1, 2):
        for z in (2, 3, 4, 5):
            assert longest(x, z)[1] == pytest.approx(uncertainty.APART / 2, abs=0.07)
    says("four times as long when the distance doubles", "points to the middle between the cameras")


def test_the_bench():
    def at(b, Z, turn, third=False):
        frame = bench.bench_frame(b, Z, 0, turn, 0.5, third)
        return [read(frame, name) for name in ("Sideways", "In depth", "Height")]

    assert at(1, 4, 0) == [1.77, 14.14, 1.77]
    assert read(bench.bench_frame(1, 4, 0, 0, 0.5, False), "One ray is off by") == 2.50
    assert 2.50 / np.sqrt(2) == about(1.77, 2)
    says("$Z\\sigma/f = 4000\\cdot 0.5/800 = 2.50$ mm", "the mean of two by $2.50/\\sqrt2$")
    assert at(2, 4, 0) == [1.77, 7.07, 1.77]
    says("from 14.14 to 7.07 mm. $\\sigma_X$ stays at 1.77 mm")
    assert [r.label for r in bench.bench_frame(4, 4, 0, 0, 0.5, False).readouts] == [
        "One ray is off by"
    ]
    assert at(4, 4, 10)[1] == 4.06
    assert read(bench.bench_frame(4, 4, 0, 10, 0.5, False), "Z² √2 σ / (f b)") == 3.54
    says("$\\sigma_Z = 4.06$ mm", "says 3.54 mm")
    assert at(1, 4, 0, third=True) == [1.44, 14.14, 1.44]
    says("from 1.77 to 1.44 mm")
    assert at(4, 2, 45)[:2] == [1.77, 1.77]
    assert read(bench.bench_frame(4, 2, 0, 45, 0.5, False), "Angle between the outer rays") == 90
    says("turned by 45°, $\\sigma_X = \\sigma_Z = 1.77$ mm")


def test_how_sure_the_length_is():
    points = tri.triangulate_linear(MARKS.transpose(1, 0, 2), CAMERAS)
    C = tri.point_covariance(points, CAMERAS, 0.25)
    g = (points[0] - points[1]) / length(points)
    sigma = np.sqrt(g @ C[0] @ g + g @ C[1] @ g)
    assert (length(points), sigma) == (about(1241.8, 1), about(4.9, 1))
    assert g.tolist() == [about(-0.93, 2), about(-0.33, 2), about(0.16, 2)]
    assert [np.sqrt(g @ c @ g) for c in C] == [about(4.8, 1), about(1.0, 1)]
    says("g = (-0.93, -0.33, 0.16)$", "The lamp gives $4.8^2$ mm², the axle $1.0^2$ mm²")
    assert np.sqrt(C[:, 2, 2]).tolist() == [about(12, 0), about(10, 0)]
    assert length(true_points()) == about(1244.3, 1)
    assert length(true_points()) - length(points) == about(2.5, 1)
    assert 2.5 / sigma == about(0.5, 1)
    says("**1241.8 ± 4.9 mm.**", "12 and 10 mm only", "the length is 1244.3 mm: 2.5 mm more")


def test_the_plane_of_light():
    rays = np.array([[1.0, 0, -1], [0, 0, 1]])
    met = plain.intersect_ray_plane(np.array([0, 0, 2]), rays, np.array([0, 0, 1, 0]))
    assert met[0].tolist() == [2, 0, 0]
    assert np.isnan(met[1]).all()
    line = plane.laser_line()
    points = tri.intersect_ray_plane(line.camera.centre, line.directions, line.plane)
    assert np.sqrt(np.mean(plane._off(points) ** 2)) == about(0.13, 2)
    assert plane.profile(np.array([10.0, 0.0])).tolist() == [12, 8]
    assert np.linalg.norm(plane.EYE) == 500
    assert (plane.K[0, 0], plane.NOISE) == (1200, 0.2)
    across, sine = 0.2 * 500 / 1200, -plane.EYE[1] / 500  # the eye is so far before the plane
    assert (across, np.degrees(np.arcsin(sine))) == (about(0.083, 3), about(37, 0))
    assert across / sine == about(0.14, 2)
    says(
        "The groove is 4 mm deep, and your points are off by 0.13 mm",
        "$0.2\\cdot 500/1200 = 0.083$ mm",
        "plane at 37°, so in height it becomes $0.083/\\sin 37° = 0.14$ mm",
        "from 50 cm",
        "12 mm high with a groove",
    )


def test_three_patterns_number_eight_planes():
    lights = plane.lit_by()
    assert lights.shape == (3, 8)
    assert ["".join("01"[light] for light in seen) for seen in lights.T.astype(int)] == [
        f"{number:03b}" for number in range(8)
    ]
    assert lights[:, 5].tolist() == [True, False, True]
    assert int("101", 2) == plane.PICKED == 5
    says("saw light, dark, light", "$4 + 0 + 1 = 5$", "tell 8 planes apart", "$2^{10} = 1024$")


def test_dense_stereo():
    how = dense.judged()
    assert (100 * how["found"], 100 * how["bad"]) == (about(87, 0), about(6.2, 1))
    assert how["median"] == pytest.approx(0.2, abs=0.005)
    says(
        "for 87 % of the pixels",
        "**6.2 % are off by more than 2 px**",
        "The median error is 0.2 px, and at 2.5 m that is 6.5 mm",
    )
    assert tri.depth_uncertainty(2500, pair.F, pair.BASELINE, 0.2) == about(6.5, 1)
    assert np.isfinite(dense.dense_disparity()).sum() / 1e4 == about(32, 0)
    says("320 000 points")
    door = slice(5, 88), slice(185, 285)
    known = np.isfinite(pair.motorcycle().truth[door])
    wrong = [
        1 - (np.abs(found[door] - pair.motorcycle().truth[door]) <= dense.BAD)[known].mean()
        for found in (dense.block_matching(4), dense.dense_disparity())
    ]
    assert (100 * wrong[0], wrong[1]) == (about(68, 0), 0)
    says("wrong for 68 % of the pixels, the program for none")
    bad = np.abs(dense.dense_disparity() - pair.motorcycle().truth) > dense.BAD
    edges = dense.kinds()["edges"]
    assert 100 * (bad & edges).sum() / bad.sum() == about(82, 0)
    known = np.isfinite(pair.motorcycle().truth) & np.isfinite(dense.dense_disparity())
    assert 100 * bad[known & ~edges].mean() == about(1.4, 1)
    says("**82 % of all bad pixels", "only 1.4 % are bad")
    alone, smooth = (
        [round(100 * share) for share in dense.wrong_shares(d).values()]
        for d in (dense.block_matching(4), dense.dense_disparity())
    )
    for name, one, other in zip(("beside edges", "plain", "textured"), alone, smooth, strict=True):
        says(f"| {name} | {one} % | {other} % |")
