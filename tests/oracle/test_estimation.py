"""Least squares, homographies and resection agree with SciPy, OpenCV and scikit-image."""

import cv2
import numpy as np
import pytest
from scipy import optimize
from skimage.transform import ProjectiveTransform

from course_lib.camera import decompose_projection, project
from course_lib.homography import (
    apply_homography,
    fit_homographies,
    fit_homography,
    homography_dlt,
)
from course_lib.least_squares import (
    fit_affine,
    fit_line,
    levenberg_marquardt,
    parameter_covariance,
    solve_qr,
    solve_robust,
    solve_svd,
)
from course_lib.resection import camera_dlt, fit_camera

SEEDS = range(5)


def system(seed, rows=30, unknowns=5):
    rng = np.random.default_rng(seed)
    A = rng.normal(size=(rows, unknowns)) * 10.0 ** rng.uniform(-2, 2, unknowns)
    return A, A @ rng.normal(size=unknowns) + rng.normal(size=rows)


def view(rng, count=54, noise=0.5):
    """Return points of a board and their measured pixels in a tilted view."""
    H = np.array([[1.5, 0.2, 100], [-0.1, 1.4, 80], [4e-4, -3e-4, 1]])
    H += rng.normal(size=(3, 3)) * [[0.1, 0.1, 10], [0.1, 0.1, 10], [2e-4, 2e-4, 0]]
    points = rng.uniform(0, 300, (count, 2))
    pixels = apply_homography(points, H)
    return points, pixels + noise * rng.normal(size=pixels.shape)


def rms(H, points, pixels):
    return np.sqrt(np.mean(np.sum((apply_homography(points, H) - pixels) ** 2, axis=1)))


@pytest.mark.parametrize("seed", SEEDS)
def test_linear_solutions(seed):
    A, b = system(seed)
    theirs = np.linalg.lstsq(A, b)[0]
    np.testing.assert_allclose(solve_qr(A, b), theirs, rtol=1e-9)
    np.testing.assert_allclose(solve_svd(A[:3], b[:3]), np.linalg.pinv(A[:3]) @ b[:3], rtol=1e-9)
    x, y = A[:, 0], b
    (slope, intercept), covariance = np.polyfit(x, y, 1, cov=True)
    assert fit_line(x, y) == pytest.approx((slope, intercept), rel=1e-9)
    design = np.column_stack([x, np.ones(len(x))])
    told = parameter_covariance(design, design @ [slope, intercept] - y)
    np.testing.assert_allclose(told, covariance, rtol=1e-9)


@pytest.mark.parametrize("seed", SEEDS)
def test_robust_solution_has_hubers_cost_at_its_smallest(seed):
    A, b = system(seed)
    b[::6] += 20
    theirs = optimize.least_squares(
        lambda x: A @ x - b, solve_qr(A, b), loss="huber", f_scale=1.3, xtol=1e-15, ftol=1e-15
    )
    ours = solve_robust(A, b, threshold=1.3).x

    def cost(x):
        r = np.abs(A @ x - b)
        return np.where(r < 1.3, r**2 / 2, 1.3 * r - 1.3**2 / 2).sum()

    assert cost(ours) <= cost(theirs.x) * (1 + 1e-12)
    np.testing.assert_allclose(A @ ours, A @ theirs.x, atol=1e-3)


@pytest.mark.parametrize("seed", SEEDS)
def test_levenberg_marquardt(seed):
    rng = np.random.default_rng(seed)
    t = np.linspace(0, 3, 40)
    truth = rng.uniform((1, 0.5, -1), (3, 2, 1))
    seen = truth[0] * np.exp(-truth[1] * t) + truth[2] + 0.05 * rng.normal(size=40)

    def residuals(x):
        return x[0] * np.exp(-x[1] * t) + x[2] - seen

    def jacobian(x):
        decay = np.exp(-x[1] * t)
        return np.stack([decay, -x[0] * t * decay, np.ones(40)], axis=1)

    ours = levenberg_marquardt(lambda x: (residuals(x), jacobian(x)), np.ones(3))
    theirs = optimize.least_squares(
        residuals, np.ones(3), jac=jacobian, method="lm", xtol=1e-14, ftol=1e-14
    )
    np.testing.assert_allclose(ours.parameters, theirs.x, rtol=1e-7)
    _, covariance = optimize.curve_fit(
        lambda t, a, b, c: a * np.exp(-b * t) + c, t, seen, p0=np.ones(3)
    )
    np.testing.assert_allclose(ours.covariance, covariance, rtol=1e-3)  # finite differences


@pytest.mark.parametrize("seed", SEEDS)
def test_affine(seed):
    points, pixels = view(np.random.default_rng(seed), count=12)
    three = points[:3].astype(np.float32), pixels[:3].astype(np.float32)
    np.testing.assert_allclose(fit_affine(*three), cv2.getAffineTransform(*three), rtol=1e-9)
    theirs = optimize.least_squares(
        lambda a: (points @ a[:4].reshape(2, 2).T + a[4:] - pixels).ravel(), np.zeros(6)
    )
    ours = fit_affine(points, pixels)
    np.testing.assert_allclose(ours[:, :2].ravel(), theirs.x[:4], rtol=1e-5, atol=1e-7)
    np.testing.assert_allclose(ours[:, 2], theirs.x[4:], rtol=1e-5)


@pytest.mark.parametrize("seed", SEEDS)
def test_homography_of_four_points(seed):
    points, pixels = view(np.random.default_rng(seed), count=4)
    theirs = cv2.getPerspectiveTransform(points.astype(np.float32), pixels.astype(np.float32))
    for estimate in (homography_dlt, fit_homography):
        ours = estimate(points, pixels)
        np.testing.assert_allclose(
            apply_homography(points, ours), apply_homography(points, theirs), atol=1e-2
        )
        np.testing.assert_allclose(apply_homography(points, ours), pixels, atol=1e-8)


@pytest.mark.parametrize("seed", SEEDS)
def test_algebraic_homography(seed):
    """The same equations and normalisation; both make the same vector shortest."""
    points, pixels = view(np.random.default_rng(seed), count=12)
    theirs = ProjectiveTransform.from_estimate(points, pixels).params
    ours = homography_dlt(points, pixels)
    seen, other = apply_homography(points, ours), apply_homography(points, theirs)
    np.testing.assert_allclose(seen, other, atol=0.02)
    assert rms(ours, points, pixels) == pytest.approx(rms(theirs, points, pixels), abs=1e-3)


@pytest.mark.parametrize("count", [5, 12, 54, 2000])
def test_homography_has_the_same_minimum(count):
    rng = np.random.default_rng(count)
    pairs = [view(rng, count) for _ in range(10)]
    points, pixels = map(np.array, zip(*pairs, strict=True))
    for H, *pair in zip(fit_homographies(points, pixels), points, pixels, strict=True):
        theirs = rms(cv2.findHomography(*pair)[0], *pair)
        assert rms(H, *pair) <= theirs + 1e-9  # OpenCV stops after ten steps
        assert rms(H, *pair) == pytest.approx(theirs, abs=1e-4)


@pytest.mark.parametrize("seed", SEEDS)
def test_camera(seed):
    rng = np.random.default_rng(seed)
    R, _ = cv2.Rodrigues(rng.normal(size=3))
    K = np.array([[1200, 3, 640], [0, 1190, 480], [0, 0, 1.0]])
    centre = -R.T @ [0.2, -0.1, 6]
    P = -2.5 * K @ R @ np.column_stack([np.eye(3), -centre])
    points = rng.uniform(-1, 1, (20, 3))
    found = camera_dlt(points, project(points, P))
    for matrix in (P, found):
        their_K, their_R, their_centre = cv2.decomposeProjectionMatrix(matrix)[:3]
        sign = np.sign(np.linalg.det(their_K))  # OpenCV leaves -P with negative focal lengths
        our_K, our_R, our_centre = decompose_projection(matrix)
        np.testing.assert_allclose(our_K, their_K / their_K[2, 2] * [sign, sign, 1], atol=1e-5)
        np.testing.assert_allclose(our_R, their_R * [[sign], [sign], [1]], atol=1e-8)
        np.testing.assert_allclose(our_centre, (their_centre[:3] / their_centre[3])[:, 0])


@pytest.mark.parametrize("seed", SEEDS)
def test_smallest_reprojection_error_of_a_camera(seed):
    rng = np.random.default_rng(seed)
    points = rng.uniform(-1, 1, (15, 3))
    P = np.array([[900, 20, 300, 2000], [10, 880, 250, 1500], [0.1, -0.1, 1, 6.0]])
    pixels = project(points, P) + 0.5 * rng.normal(size=(15, 2))
    ours = fit_camera(points, pixels)

    def residuals(p):
        return (project(points, np.append(p, ours.P[2, 3]).reshape(3, 4)) - pixels).ravel()

    start = camera_dlt(points, pixels)
    start = (start / start[2, 3] * ours.P[2, 3]).ravel()[:11]
    theirs = optimize.least_squares(residuals, start, x_scale=np.abs(start) + 1e-3, xtol=1e-14)
    assert (ours.residuals**2).sum() <= 2 * theirs.cost * (1 + 1e-9)
    assert (ours.residuals**2).sum() == pytest.approx(2 * theirs.cost, rel=1e-4)
