import numpy as np
import pytest

from course_lib.checks import DegenerateConfigurationError
from course_lib.homography import (
    apply_homography,
    fit_homographies,
    fit_homography,
    homography_dlt,
    normalise_points,
    refine_homography,
)

ESTIMATORS = [homography_dlt, fit_homography]
each_estimator = pytest.mark.parametrize("estimate", ESTIMATORS)
#: Four points on a line, and one beside it.
ONE_BESIDE = np.array([[0, 0], [1, 1], [2, 2], [3, 3], [0, 5.0]])
LINE = np.array([[0, 1], [1, 3], [2, 5], [5, 11], [7, 15.0]])
GENERAL = np.array([[0, 0], [4, 0.5], [3.5, 4], [-0.5, 3], [1, 2.0]])


def board(columns=9, rows=6, square=30.0):
    x, y = np.meshgrid(np.arange(columns), np.arange(rows))
    return square * np.stack([x.ravel(), y.ravel()], axis=1)


def view(rng):
    """Return the homography of a tilted board to a picture of 640 × 480."""
    H = np.array([[1.5, 0.2, 100], [-0.1, 1.4, 80], [4e-4, -3e-4, 1]])
    return H + rng.normal(size=(3, 3)) * [[0.1, 0.1, 10], [0.1, 0.1, 10], [2e-4, 2e-4, 0]]


def measured(rng, noise=0.3, points=None):
    points = board() if points is None else points
    targets = apply_homography(points, view(rng))
    return points, targets + noise * rng.normal(size=targets.shape)


def rms(H, points, targets):
    return np.sqrt(np.mean(np.sum((apply_homography(points, H) - targets) ** 2, axis=1)))


class TestNormalise:
    @pytest.mark.parametrize("dimension", [1, 2, 3])
    def test_accuracy(self, dimension):
        points = np.random.default_rng(1).normal(500, 80, (40, dimension))
        normalised, T = normalise_points(points)
        np.testing.assert_allclose(normalised.mean(axis=0), 0, atol=1e-12)
        distances = np.linalg.norm(normalised, axis=1)
        assert distances.mean() == pytest.approx(np.sqrt(dimension))
        homogeneous = np.column_stack([points, np.ones(40)]) @ T.T
        np.testing.assert_allclose(homogeneous[:, :-1], normalised, atol=1e-12)

    def test_errors(self):
        with pytest.raises(DegenerateConfigurationError, match="the same point"):
            normalise_points([[1, 2], [1, 2]])
        with pytest.raises(ValueError, match="must be finite"):
            normalise_points([[1, np.nan], [1, 2]])


class TestEstimators:
    @each_estimator
    @pytest.mark.parametrize("seed", range(5))
    def test_truth_comes_back(self, estimate, seed):
        rng = np.random.default_rng(seed)
        H = view(rng)
        for points in (board(), board()[[0, 8, 45, 53]]):
            found = estimate(points, apply_homography(points, H))
            np.testing.assert_allclose(found, H, rtol=1e-7)

    @each_estimator
    def test_four_points_are_met_exactly(self, estimate):
        targets = np.array([[0, 0.3], [4.2, 0.5], [3.5, 4], [-0.4, 3.1]])
        np.testing.assert_allclose(
            apply_homography(GENERAL[:4], estimate(GENERAL[:4], targets)), targets, atol=1e-10
        )

    @each_estimator
    def test_the_corner_may_be_zero(self, estimate):
        H = np.array([[0.5, 0.2, 3], [0.1, 0.9, -2], [0.3, 0.4, 0]])
        points = GENERAL + 1
        found = estimate(points, apply_homography(points, H))
        assert np.linalg.norm(found) == pytest.approx(1)
        np.testing.assert_allclose(found / found[0, 0], H / H[0, 0], atol=1e-9)

    @each_estimator
    def test_does_not_depend_on_the_unit_or_the_origin(self, estimate):
        points, targets = measured(np.random.default_rng(3))
        seen = apply_homography(points, estimate(points, targets))
        far = estimate(points * 1e-3 + 70, targets * 1e3 - 4e5)
        again = (apply_homography(points * 1e-3 + 70, far) + 4e5) / 1e3
        np.testing.assert_allclose(again, seen, atol=1e-6)

    @each_estimator
    def test_inputs_stay_as_they_are(self, estimate):
        points, targets = measured(np.random.default_rng(3))
        copies = points.copy(), targets.copy()
        estimate(points, targets)
        np.testing.assert_array_equal((points, targets), copies)

    @each_estimator
    @pytest.mark.parametrize(
        ("points", "targets", "match"),
        [
            (LINE, GENERAL, "all points are collinear"),
            (GENERAL, LINE, "all targets are collinear"),
            (np.ones((5, 2)), GENERAL, "all points are the same point"),
            (GENERAL, np.ones((5, 2)), "all targets are the same point"),
            (ONE_BESIDE, GENERAL, "no three of them on a line"),
            (ONE_BESIDE[[0, 1, 2, 4]], GENERAL[:4], "no three of them on a line"),
            (GENERAL[:4], ONE_BESIDE[[0, 1, 2, 4]], "no three of them on a line"),
            (ONE_BESIDE, ONE_BESIDE, "no three of them on a line|add measurements"),
        ],
    )
    def test_degenerate(self, estimate, points, targets, match):
        with pytest.raises(DegenerateConfigurationError, match=match):
            estimate(points, targets)

    @each_estimator
    def test_errors(self, estimate):
        with pytest.raises(ValueError, match="4 points or more are needed, got 3"):
            estimate(GENERAL[:3], GENERAL[:3])
        with pytest.raises(ValueError, match=r"row by row, got shapes \(5, 2\) and \(4, 2\)"):
            estimate(GENERAL, GENERAL[:4])
        with pytest.raises(ValueError, match="targets must be finite"):
            estimate(GENERAL, np.where(GENERAL == 4, np.nan, GENERAL))
        with pytest.raises(ValueError, match="points are rows"):
            estimate(GENERAL.T, GENERAL.T)


class TestFit:
    def test_many_at_once_are_those_one_by_one(self):
        rng = np.random.default_rng(5)
        targets = np.array([measured(rng)[1] for _ in range(7)])
        many = fit_homographies(board(), targets)
        assert many.shape == (7, 3, 3)
        for H, seen in zip(many, targets, strict=True):
            np.testing.assert_allclose(H, fit_homography(board(), seen), rtol=1e-9)

    def test_each_with_points_of_its_own(self):
        rng = np.random.default_rng(6)
        sets = [measured(rng, points=rng.uniform(0, 300, (20, 2))) for _ in range(3)]
        points, targets = map(np.array, zip(*sets, strict=True))
        for H, *pair in zip(fit_homographies(points, targets), points, targets, strict=True):
            np.testing.assert_allclose(H, fit_homography(*pair), rtol=1e-9)

    def test_it_is_a_minimum(self):
        rng = np.random.default_rng(7)
        points, targets = measured(rng, noise=1)
        H = fit_homography(points, targets)
        least = rms(H, points, targets)
        for _ in range(50):
            other = H * (1 + 1e-5 * rng.normal(size=(3, 3)))
            assert rms(other, points, targets) > least
        assert rms(homography_dlt(points, targets), points, targets) > least

    def test_refining_gets_to_the_same_minimum(self):
        points, targets = measured(np.random.default_rng(8), noise=1)
        best = fit_homography(points, targets)
        for start in (
            homography_dlt(points, targets),
            best * 1.001,
            -3 * view(np.random.default_rng(9)),
        ):
            H = refine_homography(start, points, targets)
            assert rms(H, points, targets) == pytest.approx(rms(best, points, targets), abs=1e-9)

    @pytest.mark.parametrize("seed", range(5))
    def test_far_starts_need_damping(self, seed):
        points, targets = measured(np.random.default_rng(8), noise=1)
        least = rms(fit_homography(points, targets), points, targets)
        far = np.random.default_rng(seed).normal(size=(3, 3)) * [[1, 1, 100], [1, 1, 100], [0] * 3]
        far[2, :2] = 2e-3 * np.random.default_rng(seed).normal(size=9)[6:8]
        H = refine_homography(view(np.random.default_rng(9)) + far, points, targets)
        assert rms(H, points, targets) == pytest.approx(least, abs=1e-9)

    def test_slanted_lines_are_collinear_but_for_rounding(self):
        steps = np.random.default_rng(2).normal(size=(9, 1))
        line = steps * [np.pi, np.e]
        with pytest.raises(DegenerateConfigurationError, match="all points are collinear"):
            fit_homography(line, board()[:9] + 1e-3 * steps**2)
        nearly = line + 1e-4 * np.random.default_rng(3).normal(size=(9, 2))
        assert np.isfinite(fit_homography(nearly, apply_homography(nearly, np.eye(3)))).all()

    def test_errors(self):
        with pytest.raises(ValueError, match=r"targets \(B, N, 2\)"):
            fit_homographies(board(), board())
        with pytest.raises(ValueError, match=r"got \(54, 2\) and \(1, 53, 2\)"):
            fit_homographies(board(), board()[None, 1:])
        with pytest.raises(DegenerateConfigurationError, match="all targets are collinear"):
            fit_homographies(GENERAL, [GENERAL, LINE])
