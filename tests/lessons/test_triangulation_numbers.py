"""Every number of chapter 09 up to the end of its first sitting, computed anew."""

import ast
import builtins
import re

import numpy as np
from lesson_text import about, lesson_text

from course_lib import triangulation as tri
from course_lib.drawing.triangulation import methods, pair, uncertainty
from course_lib.exercises import all_exercises
from course_lib.exercises.triangulation import plain
from course_lib.exercises.triangulation.refinement_misconceptions import linearised

TEXT = lesson_text("09_triangulation")
says = TEXT.says
MARKS = np.array(list(pair.MARKED.values()))  # point, picture, (u, v)
CAMERAS = np.array([pair.P_LEFT, pair.P_RIGHT])
EYE = np.array([[800.0, 0, 320, 0], [0, 800, 240, 0], [0, 0, 1, 0]])
BESIDE = np.array([[800.0, 0, 320, -800], [0, 800, 240, 0], [0, 0, 1, 0]])
PLAIN = np.array([[100.0, 0, 0, 0], [0, 100, 0, 0], [0, 0, 1, 0]])
PLAIN_PAIR = np.stack([PLAIN, PLAIN - [[0, 0, 0, 100], [0, 0, 0, 0], [0, 0, 0, 0]]])


def length(points):
    return float(np.linalg.norm(points[0] - points[1]))


def test_points_of_all_exercises():
    says(f"**Points:** {sum(exercise.points for exercise in all_exercises('triangulation'))}")
    graded = [e.name for e in all_exercises("triangulation")]
    assert [TEXT.index(f"\n{name}\n") for name in graded[:-1]] == sorted(
        TEXT.index(f"\n{name}\n") for name in graded[:-1]
    )


def test_the_second_sitting_needs_no_cell_of_the_first():
    cells = re.findall(r"```{code-cell} ipython3\n(.*?)```", TEXT, flags=re.DOTALL)
    second = re.findall(
        r"```{code-cell} ipython3\n(.*?)```", TEXT[TEXT.index("## Second") :], flags=re.DOTALL
    )
    assert 10 < len(second) < len(cells)
    code = "\n".join([cells[0], *(c for c in second if "[exercise]" not in c)])
    names = [node for node in ast.walk(ast.parse(code)) if isinstance(node, ast.Name)]
    known = {node.id for node in names if isinstance(node.ctx, ast.Store)} | set(dir(builtins))
    for node in ast.walk(ast.parse(code)):
        if isinstance(node, ast.Import | ast.ImportFrom):
            known |= {(alias.asname or alias.name).split(".")[0] for alias in node.names}
    graded = [e.name for e in all_exercises("triangulation")]
    known |= {n.split(".")[1] for n in graded if f"\n{n}\n" in "".join(second)}
    assert {node.id for node in names} <= known


def test_the_rays_that_miss():
    o1, d1, o2, d2 = np.array([[0, 0, 0], [0, 0, 1], [1, 2, 0], [-1, 0, 5]], float)
    assert np.cross(d1, d2).tolist() == [0, -1, 0]
    A = np.column_stack([d1, -d2, np.cross(d1, d2)])
    assert A.tolist() == [[0, 1, 0], [0, 0, -1], [1, -5, 0]]
    np.testing.assert_allclose(np.linalg.solve(A, o2 - o1), [5, 1, -2])
    one, other = plain.closest_points_on_rays(o1, d1, o2, d2)
    np.testing.assert_allclose([one, other], [[0, 0, 5], [0, 2, 5]], atol=1e-12)
    says("$\\lambda_2 = 1$, $\\mu = -2$ and $\\lambda_1 = 5$", "(0, 0, 5)$ and", "(0, 2, 5)$")
    says("0\\,\\lambda_1 + 0\\,\\lambda_2 - 1\\,\\mu = 2", "1\\,\\lambda_1 - 5\\,\\lambda_2")


def test_the_rays_of_the_example():
    for P, pixel, centre, ray in (
        (EYE, (520, 240), (0, 0, 0), (0.25, 0, 1)),
        (BESIDE, (320, 240), (1, 0, 0), (0, 0, 1)),
    ):
        np.testing.assert_allclose(np.linalg.inv(P[:, :3]) @ [*pixel, 1], ray, atol=1e-12)
        np.testing.assert_allclose(-np.linalg.inv(P[:, :3]) @ P[:, 3], centre, atol=1e-12)
    found = plain.triangulate_midpoint(np.array([520, 240]), np.array([320, 240]), EYE, BESIDE)
    np.testing.assert_allclose(found, [1, 0, 4], atol=1e-12)
    assert (520 * EYE[2] - EYE[0]).tolist() == [-800, 0, 200, 0]
    assert (320 * BESIDE[2] - BESIDE[0]).tolist() == [-800, 0, 0, 800]
    assert (240 * EYE[2] - EYE[1]).tolist() == (240 * BESIDE[2] - BESIDE[1]).tolist()
    assert (240 * EYE[2] - EYE[1]).tolist() == [0, -800, 0, 0]
    says("(-800, 0, 200, 0)", "(-800, 0, 0, 800)", "(0, -800, 0, 0)", "meet in $(1, 0, 4)$")


def test_the_motorcycle():
    left, right = MARKS.transpose(1, 0, 2)
    middle = tri.triangulate_midpoint(left, right, *CAMERAS)
    assert middle[0].tolist() == [about(-543.2, 1), about(-118.3, 1), about(2523.6, 1)]
    says("$(-543.2, -118.3, 2523.6)$ mm")
    assert length(middle) == about(1241.7, 1)
    says("**1241.7 mm** long")
    inverse = [np.linalg.inv(K).T for K in (pair.K_LEFT, pair.K_RIGHT)]
    rays = [np.column_stack([p, [1, 1]]) @ K for p, K in zip((left, right), inverse, strict=True)]
    one, other = tri.closest_points_on_rays([0, 0, 0], rays[0], [pair.BASELINE, 0, 0], rays[1])
    gaps = np.linalg.norm(one - other, axis=1)
    assert (gaps > 1).all()
    assert (gaps < 1.3).all()
    says("misses by a bit more than 1 mm")
    linear = tri.triangulate_linear([left, right], CAMERAS)
    refined = tri.refine_point(linear, [left, right], CAMERAS)
    assert (length(linear), length(refined)) == (about(1241.8, 1), about(1241.8, 1))
    says("1241.8 mm: nearly the same", "For our motorcycle nothing changes: 1241.8 mm")
    assert np.abs(left[:, 1] - right[:, 1]).tolist() == [0.5, 0.5]


def test_a_pixel_at_one_and_at_ten_metres():
    assert [1000 * Z / 800 for Z in (1, 10)] == [1.25, 12.5]
    says("1.25 mm at a distance of 1 m", "12.5 mm at 10 m")


def test_steps_to_the_best_point():
    X, pixels = np.array([1.0, 0, 5]), np.array([[25.0, 0], [0, 0]])
    u = (PLAIN @ [*X, 1])[0] / 5
    assert u == 20
    assert ((PLAIN[0, :3] - u * PLAIN[2, :3]) / 5).tolist() == [20, 0, -4]
    depths = []
    for _ in range(3):
        X = plain.refine_point(X, pixels, PLAIN_PAIR)
        depths.append(X[2])
    assert depths == [about(3.75, 9), about(3.984, 3), about(4.000, 3)]
    J, r = linearised(np.array([1.0, 0, 5]), pixels, PLAIN_PAIR)
    assert J.tolist() == [[20, 0, -4], [0, 20, 0], [20, 0, 0], [0, 20, 0]]
    assert r.tolist() == [-5, 0, 0, 0]
    says(r"20 & 0 & -4 \\ 0 & 20 & 0 \\ 20 & 0 & 0 \\ 0 & 20 & 0 \end", r"-5 \\ 0 \\ 0 \\ 0 \end")
    says("the depth goes from 5 to 3.75. The next steps lead to 3.984 and 4.000")
    says("(20, 0, -4)", "20 - 25 = -5")


def test_the_methods_compared():
    side, unequal, close = methods.SETUPS
    whole = {
        s: {n: methods.rms_mm(X) for n, X in methods.answers(s).items()} for s in methods.SETUPS
    }
    assert max(whole[side].values()) / min(whole[side].values()) < 1.002
    assert (whole[unequal]["midpoint"], whole[unequal]["refined"]) == (
        about(6.97, 2),
        about(6.24, 2),
    )
    assert whole[unequal]["linear"] == about(6.97, 2)
    says("falls from 7.0 to 6.2 mm")
    height = {n: methods.rms_mm(X[:, 2]) for n, X in methods.answers(unequal).items()}
    assert (height["midpoint"], height["refined"]) == (about(3.15, 2), about(0.62, 2))
    assert height["linear"] / height["refined"] == about(5, 0)
    says("0.6 mm instead of 3.2 mm, *five times better*")
    far = {n: methods.rms_mm(X[:, 1]) for n, X in methods.answers(unequal).items()}
    assert max(far.values()) / min(far.values()) < 1.01  # what only the far camera sees
    assert whole[close]["midpoint"] / 10 == about(24, 0)
    assert whole[close]["refined"] / 10 == about(24, 0)
    assert whole[close]["linear"] == max(whole[close].values()) < 1.1 * whole[close]["refined"]
    assert methods.NOISE == 0.5
    assert methods.TRIALS == 4000
    assert 100 / np.sqrt(2 * methods.TRIALS) == about(1, 0)
    says("Chance still moves the bars by about 1 %")
    says("24 cm off, whatever you do", "4000 tries each", "off by 0.5 px")


def test_more_cameras():
    arc = {n: methods.arc_errors(n, methods.ARC) for n in methods.COUNTS}
    assert np.degrees([methods.ARC, 4 * methods.ARC]).round().tolist() == [14, 57]
    for predicted, simulated in arc.values():
        np.testing.assert_allclose(simulated, predicted, rtol=0.05)
    (two, sideways_two), (three, sideways_three) = arc[2][0], arc[3][0]
    assert (two, three) == (about(14.3, 1), about(14.3, 1))
    assert (sideways_two, sideways_three) == (about(1.8, 1), about(1.5, 1))
    assert arc[16][0][0] == about(8.2, 1)
    assert methods.arc_errors(2, 4 * methods.ARC)[0][0] == about(3.7, 1)
    says("depth does not get better at all (14.3 mm)", "1.8 mm become 1.5 mm", "down to 8.2 mm")
    says("are at 3.7 mm")
    assert methods.rms_mm(methods.answers("4 m away, 1 m apart")["refined"]) == about(14.5, 1)
    straight = tri.point_covariance([0.5, 0, 4], uncertainty.PAIR, 0.5)
    assert 1000 * np.sqrt(straight[2, 2]) == about(14.1, 1)
    says(
        "Here it is 14.3 mm", "The 15 mm of the bars are 14.5 before", "In section 8 it is 14.1 mm"
    )
