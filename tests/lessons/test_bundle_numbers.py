"""The numbers that the text of chapter 10 states in its first sitting."""

import numpy as np
from lesson_text import about, lesson_text

from course_lib import bundle, orientation, transforms
from course_lib.drawing import bundle as draw
from course_lib.drawing.bundle import growing, space
from course_lib.exercises import all_exercises
from course_lib.exercises.bundle import plain

TEXT = lesson_text("10_bundle")
says = TEXT.says
CHAINED, ADJUSTED = growing.WAYS


def test_points_of_all_exercises_and_their_order():
    exercises = all_exercises("bundle")
    says(f"**Points:** {sum(exercise.points for exercise in exercises)}.")
    graded = [f"\n{e.name}\n" for e in exercises[:-1]]
    assert sorted(graded, key=TEXT.index) == graded
    says(f"({exercises[-1].points} points, read by a person)", f'"{exercises[-1].name}"')


def test_the_block_of_the_vase():
    known = growing.vase()
    assert (len(known.truth.R), len(known.truth.points)) == (24, 200)
    assert np.bincount(known.observations.points).max() == 9
    base = np.linalg.norm(known.truth.centres[1] - known.truth.centres[0])
    assert base == about(0.26, 2)
    says("seen by 9 of 24 cameras", "(26 cm)", "turned by 15°", "$24\\cdot 6 + 200\\cdot 3 = 744$")
    assert 24 * 6 == 144
    says("one system of 144 instead of 744", "6000 instead of three million")


def test_the_third_picture():
    points, pixels, K = draw.third_picture()
    stages = growing.grown(CHAINED)
    assert (stages[0].added, stages[1].seen, len(points)) == (45, 40, 40)
    says("45 points are triangulated", "It shows 40 of these points")
    np.testing.assert_allclose(growing.true_centres(3)[2], [0.866, 0.5, 0.35], atol=5e-4)
    says("$(0.866, 0.500, 0.350)$")
    R, t = plain.resect_camera(points, pixels, K)
    assert draw.pose_rms(points, pixels, K, R, t) == about(5.1, 1)
    best = orientation.resect_camera(points, pixels, K)
    assert draw.pose_rms(points, pixels, K, best.R, best.t) == about(1.6, 1)
    says("Yours leaves 5.1 px", "refines: 1.6 px")


def test_the_worked_resection():
    M = np.array([[0.0, -2, 0, 4], [2, 0, 0, 0], [0, 0, 2, 10]])
    X = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1.0)])
    q = X @ M[:, :3].T + M[:, 3]
    R, t = plain.resect_camera(X, q[:, :2] / q[:, 2:], np.eye(3))
    np.testing.assert_allclose(R, [[0, -1, 0], [1, 0, 0], [0, 0, 1]], atol=1e-9)
    np.testing.assert_allclose(t, [2, 0, 5], atol=1e-9)
    says("0 & -2 & 0 & 4\\\\ 2 & 0 & 0 & 0\\\\ 0 & 0 & 2 & 10", "$\\mathbf t = (2, 0, 5)$")


def test_the_chains():
    gaps, last = [], []
    for way in growing.WAYS:
        stage = growing.grown(way)[-1]
        gaps.append(1000 * np.linalg.norm(stage.block.centres[-1] - stage.block.centres[0]))
        last.append(stage.after)
    assert gaps == [about(18.5, 1), about(2.1, 1)]
    assert last == [about(3.2, 1), about(0.61, 2)]
    assert np.sqrt(0.5**2 + 0.5**2) == about(0.71, 2)
    says(
        "it is 18.5 mm off",
        "even worse, 64.5 mm",
        "is 3.2 px, although",
        "0.61 px, and the gap is 2.1 mm",
        "make 0.71 px",
    )
    off = 1000 * growing.drift(growing.grown(CHAINED)[-1])
    assert off.max() > 3 * off[-1]  # on the other side it is worse
    assert (int(np.argmax(off)), off.max()) == (13, about(64.5, 1))
    says("picture 13, by 64.5 mm")


def test_what_the_stepper_shows():
    chained, adjusted = growing.grown(CHAINED), growing.grown(ADJUSTED)
    assert [s.before for s in chained[1:3]] == [about(0.88, 2), about(1.18, 2)]
    says("Picture 2 brings it to 0.88 px and picture 3 to 1.18 px")
    assert (adjusted[1].before, adjusted[1].after) == (about(0.88, 2), about(0.49, 2))
    assert all(s.before - s.after < 0.03 for s in adjusted[-8:])
    says("Picture 2 from 0.88 to 0.49 px", "to 0.61 px")
    seen, added = ([getattr(s, what) for s in chained[1:]] for what in ("seen", "added"))
    assert (min(seen), max(seen), min(added), max(added)) == (40, 60, 4, 15)
    assert np.mean(added) == about(8, 0)
    says("sees 40 to 60 known points and adds 4 to 15, eight on the average")


def test_the_worked_derivatives():
    by_pose, by_point = plain.reprojection_jacobian(
        np.array([1.0, 0, 2]), np.diag([100.0, 100, 1]), np.eye(3), np.zeros(3)
    )
    assert by_point.tolist() == [[50, 0, -25], [0, 50, 0]]
    assert (by_pose[:, :3] + 0.0).tolist() == [[0, 125, 0], [-100, 0, 50]]
    assert transforms.skew([1, 0, 2]).tolist() == [[0, -2, 0], [2, 0, -1], [0, 1, 0]]
    says("50 & 0 & -25\\\\ 0 & 50 & 0", "0 & 125 & 0\\\\ -100 & 0 & 50")
    says("by 0.01 (the last column), its pixel moves by 0.25 px towards")
    one, other = (100 / z for z in (2, 2.01))
    assert one - other == about(0.25, 2)
    true = growing.vase().truth
    X, K, R, t = true.points[7], true.K[0], true.R[0], true.t[0]
    up = np.array([0, 0, 0.001])
    slopes = bundle.reprojection_jacobian(X, K, R, t)[0][:, 3:] @ up
    moved = draw.pixel(X, K, R, t - R @ up) - draw.pixel(X, K, R, t)
    np.testing.assert_allclose(slopes, moved, atol=0.001)
    assert slopes[1] > 3  # v grows downwards
    w = np.array([0, 0.001, 0])
    more = transforms.rotation_from_vector(w)
    slopes = bundle.reprojection_jacobian(X, K, R, t)[0][:, :3] @ w
    moved = draw.pixel(X, K, more @ R, more @ t) - draw.pixel(X, K, R, t)
    np.testing.assert_allclose(slopes, moved, atol=0.001)
    assert slopes[0] > 3  # u grows to the right
    says("the point moves *down*", "by 0.001 rad about its $y$-axis", "moves to the right.)")
    # The camera itself turns the other way: by 0.1, its axis goes to the left.
    (turned,), *_ = bundle.move_block(
        np.eye(3)[None], np.zeros((1, 3)), X[None], [0, 0.1, 0, 0, 0, 0], np.zeros((1, 3))
    )
    np.testing.assert_allclose(turned[2], [-np.sin(0.1), 0, np.cos(0.1)], atol=1e-12)
    says("by $-\\mathbf w$, just as")


def test_the_small_block_and_its_arrow():
    block, seen = draw.small_block()
    assert (len(block.R), len(block.points), len(seen)) == (6, 29, 66)
    says("6 cameras (blue), 29 points (red), 66 observations")
    J = draw.whole_jacobian(block, seen)
    sizes = np.linalg.svd(J / np.linalg.norm(J, axis=0), compute_uv=False)
    assert (sizes[-7:] < 1e-8).all()
    assert sizes[-8] > 5e-4
    assert len(sizes[-9:-7]) == 2
    says("Two are small, and seven are zero but for the rounding of the computer ($10^{-16}$)")
    U, W, V = np.array([[4.0]]), np.array([[[1.0, 0, 0]]]), 0.5 * np.eye(3)[None]
    a, b = plain.solve_normal_block(U, W, V, np.array([2.0]), np.zeros((1, 3)))
    assert (a.tolist(), b[0, 0]) == ([-1], 2)
    says("$4a + b = -2$ and $a + 0.5\\,b = 0$", "so $a = -1$", "$b = 2\\cdot(0 + 1) = 2$")


def test_the_steps_of_half_a_chain():
    K, R, t, points, pixels = draw.half_chain()
    damping, history = 0.001, []
    for _ in range(7):
        history.append(draw.block_rms(K, R, t, points, pixels))
        R, t, points, damping = plain.bundle_adjust(K, R, t, points, pixels, damping)
    assert (history[0], history[3]) == (about(2.25, 2), about(0.59, 2))
    assert history[3] - history[6] < 0.001 < history[2] - history[3]
    says("leave 2.25 px", "After three, nothing changes any more: 0.59 px")


def test_the_gauges():
    sigma = 1000 * space.centre_sigma("inner")
    assert sigma.mean() == about(1.2, 1)
    assert np.ptp(sigma) < 0.25
    says("The uncertainty is shared evenly, ± 1.2 mm")
