import numpy as np
import pytest

from course_lib.checks import DegenerateConfigurationError
from course_lib.least_squares import (
    fit_affine,
    fit_line,
    huber_weights,
    parameter_covariance,
    solve_homogeneous,
    solve_normal_equations,
    solve_one_unknown,
    solve_qr,
    solve_robust,
    solve_svd,
    solve_weighted,
)

SOLVERS = [solve_normal_equations, solve_qr, solve_svd]
each_solver = pytest.mark.parametrize("solve", SOLVERS)


def system(rng, rows=12, unknowns=4, noise=0.1):
    A, x = rng.normal(size=(rows, unknowns)), rng.normal(size=unknowns)
    return A, A @ x + noise * rng.normal(size=rows), x


class TestOneUnknown:
    def test_published(self):
        """(2, 3, 4) x = b gives (2 b₁ + 3 b₂ + 4 b₃)/29."""
        for b in np.eye(3):
            assert 29 * solve_one_unknown([2, 3, 4], b) == pytest.approx(b @ [2, 3, 4], abs=1e-12)

    def test_it_is_a_minimum(self):
        a, b, _ = system(np.random.default_rng(1), unknowns=1)
        a, x = a[:, 0], solve_one_unknown(a[:, 0], b)
        squares = [np.sum((a * trial - b) ** 2) for trial in (x - 1e-3, x, x + 1e-3)]
        assert squares[1] < min(squares[0], squares[2])

    def test_errors(self):
        with pytest.raises(DegenerateConfigurationError, match="x may be anything"):
            solve_one_unknown([0, 0], [1, 2])
        with pytest.raises(ValueError, match="in pairs, got 2 and 3"):
            solve_one_unknown([1, 2], [1, 2, 3])
        with pytest.raises(ValueError, match="rows of numbers"):
            solve_one_unknown(1, 2)
        with pytest.raises(ValueError, match="1 numbers or more"):
            solve_one_unknown([], [])


class TestLine:
    def test_accuracy(self):
        x = np.linspace(-3, 9, 7)
        assert fit_line(x, 0.25 * x - 4) == pytest.approx((0.25, -4))

    def test_errors_are_in_y(self):
        """Swapping x and y gives another line: the errors are put elsewhere."""
        rng = np.random.default_rng(2)
        x = np.linspace(0, 10, 200)
        y = 2 * x + rng.normal(scale=3, size=200)
        slope, intercept = fit_line(x, y)
        residuals = y - (slope * x + intercept)
        assert residuals.sum() == pytest.approx(0, abs=1e-9)
        assert residuals @ x == pytest.approx(0, abs=1e-8)
        assert 1 / fit_line(y, x)[0] > slope + 0.1

    def test_far_from_the_origin(self):
        x = 1e6 + np.arange(5.0)
        slope, intercept = fit_line(x, 3 * x + 1)
        assert slope == pytest.approx(3, rel=1e-8)
        assert slope * 1e6 + intercept == pytest.approx(3e6 + 1, rel=1e-9)

    def test_errors(self):
        with pytest.raises(DegenerateConfigurationError, match="there is no slope"):
            fit_line([2, 2, 2], [1, 2, 3])
        with pytest.raises(ValueError, match="2 numbers or more"):
            fit_line([2], [1])


class TestAffine:
    A = np.array([[0.4, -0.03, 120], [0.05, 0.38, -60]])

    def test_accuracy(self):
        points = np.random.default_rng(3).uniform(0, 640, (9, 2))
        targets = points @ self.A[:, :2].T + self.A[:, 2]
        np.testing.assert_allclose(fit_affine(points, targets), self.A, rtol=1e-9)
        np.testing.assert_allclose(fit_affine(points[:3], targets[:3]), self.A, rtol=1e-9)

    def test_it_is_a_minimum(self):
        rng = np.random.default_rng(4)
        points = rng.uniform(0, 640, (9, 2))
        targets = points @ self.A[:, :2].T + self.A[:, 2] + rng.normal(size=(9, 2))
        rows = np.column_stack([points, np.ones(9)])
        residuals = rows @ fit_affine(points, targets).T - targets
        np.testing.assert_allclose(rows.T @ residuals, 0, atol=1e-8)

    def test_errors(self):
        with pytest.raises(DegenerateConfigurationError, match="all points are collinear"):
            fit_affine([[0, 0], [1, 1], [2, 2]], np.eye(3)[:, :2])
        with pytest.raises(ValueError, match="3 points or more"):
            fit_affine(np.eye(2), np.eye(2))
        with pytest.raises(ValueError, match="row by row"):
            fit_affine((1, 2), (3, 4))


class TestSolvers:
    @each_solver
    @pytest.mark.parametrize("seed", range(5))
    def test_residuals_are_perpendicular_to_the_columns(self, solve, seed):
        A, b, _ = system(np.random.default_rng(seed))
        np.testing.assert_allclose(A.T @ (A @ solve(A, b) - b), 0, atol=1e-12)

    @each_solver
    def test_several_right_hand_sides(self, solve):
        A, b, _ = system(np.random.default_rng(5))
        both = solve(A, np.stack([b, -2 * b], axis=1))
        np.testing.assert_allclose(both, np.outer(solve(A, b), [1, -2]), rtol=1e-9)

    def test_normal_equations_lose_half_of_the_digits(self):
        """A polynomial of degree 7: cond A is about 1e5, and the normal matrix has its square."""
        A = np.vander(np.linspace(0, 1, 30), 8)
        truth = np.ones(8)
        errors = [np.abs(solve(A, A @ truth) - truth).max() for solve in SOLVERS]
        assert errors[0] > 1000 * max(errors[1:])
        assert max(errors[1:]) < 1e-9

    @pytest.mark.parametrize("solve", [solve_normal_equations, solve_qr])
    def test_dependent_columns(self, solve):
        A = np.random.default_rng(6).normal(size=(9, 2)) @ [[1, 0, 2], [0, 1, 3]]
        with pytest.raises(DegenerateConfigurationError, match="the columns are dependent"):
            solve(A, np.ones(9))
        with pytest.raises(DegenerateConfigurationError, match="the columns are dependent"):
            solve(np.zeros((4, 2)), np.ones(4))

    @pytest.mark.parametrize("solve", [solve_normal_equations, solve_qr])
    def test_columns_of_any_size(self, solve):
        A, b, _ = system(np.random.default_rng(7))
        sizes = [1e-9, 1, 1e4, 1e9]
        np.testing.assert_allclose(solve(A * sizes, b) * sizes, solve_svd(A, b), rtol=1e-6)

    def test_the_shortest_of_many(self):
        x = solve_svd([[1.0, 2, 2]], [9])
        np.testing.assert_allclose(x, [1, 2, 2])
        np.testing.assert_array_equal(solve_svd(np.zeros((2, 3)), [1, 2]), np.zeros(3))

    def test_weights(self):
        A, b, _ = system(np.random.default_rng(8))
        twice = solve_qr(np.concatenate([A, A[:3]]), np.concatenate([b, b[:3]]))
        weights = np.ones(12)
        weights[:3] = 2
        np.testing.assert_allclose(solve_weighted(A, b, weights), twice)
        weights[:3] = 0
        np.testing.assert_allclose(solve_weighted(A, b, weights), solve_qr(A[3:], b[3:]))

    @each_solver
    def test_errors(self, solve):
        with pytest.raises(ValueError, match="rows of equations and columns of unknowns"):
            solve([1, 2], [1, 2])
        with pytest.raises(ValueError, match="each of the 3 rows of A"):
            solve(np.eye(3), [1, 2])
        with pytest.raises(ValueError, match="A must be finite"):
            solve([[np.nan], [1]], [1, 2])

    def test_more_errors(self):
        with pytest.raises(ValueError, match="3 unknowns need as many equations or more, got 2"):
            solve_qr(np.ones((2, 3)), [1, 2])
        with pytest.raises(ValueError, match="weights must be 2 numbers"):
            solve_weighted(np.eye(2), [1, 2], [1, -1])
        with pytest.raises(DegenerateConfigurationError, match="the columns are dependent"):
            solve_weighted(np.eye(2), [1, 2], [1, 0])


class TestHomogeneous:
    @pytest.mark.parametrize("rows", [3, 4, 40])
    def test_accuracy(self, rows):
        rng = np.random.default_rng(rows)
        x = rng.normal(size=4)
        A = rng.normal(size=(rows, 4))
        A -= np.outer(A @ x, x) / (x @ x)
        found = solve_homogeneous(A)
        np.testing.assert_allclose(found * (x @ found), x, atol=1e-9)

    def test_it_is_a_minimum(self):
        rng = np.random.default_rng(9)
        A = rng.normal(size=(20, 5))
        least = np.linalg.norm(A @ solve_homogeneous(A))
        others = rng.normal(size=(200, 5))
        others /= np.linalg.norm(others, axis=1, keepdims=True)
        assert least < np.linalg.norm(A @ others.T, axis=0).min()

    def test_errors(self):
        with pytest.raises(DegenerateConfigurationError, match="more than one direction"):
            solve_homogeneous([[1.0, 0, 0], [2, 0, 0], [3, 0, 0]])
        with pytest.raises(ValueError, match="one row or more for each column but one"):
            solve_homogeneous(np.ones((2, 4)))


class TestCovariance:
    def test_of_a_line(self):
        """Against the scatter of the slopes and intercepts of 2000 measured lines."""
        rng = np.random.default_rng(10)
        A = np.column_stack([np.linspace(1, 5, 12), np.ones(12)])
        b = A @ [2, -3] + 0.2 * rng.normal(size=(2000, 12))
        fits = solve_qr(A, b.T)
        told = np.mean(
            [parameter_covariance(A, A @ x - y) for x, y in zip(fits.T, b, strict=True)], 0
        )
        np.testing.assert_allclose(told, np.cov(fits), rtol=0.1)

    def test_errors(self):
        with pytest.raises(ValueError, match="without a row to spare"):
            parameter_covariance(np.eye(2), [1, 2])
        with pytest.raises(DegenerateConfigurationError, match="the columns are dependent"):
            parameter_covariance(np.ones((4, 2)), np.ones(4))


class TestRobust:
    def test_weights(self):
        np.testing.assert_allclose(huber_weights([-8, 0.5, 2, 4], 2), [0.25, 1, 1, 0.5])

    def test_a_fifth_of_slips_does_little(self):
        rng = np.random.default_rng(11)
        A, b, x = system(rng, rows=100, unknowns=2)
        b[::5] += rng.uniform(5, 50, 20)
        found = solve_robust(A, b)
        assert np.abs(found.x - x).max() < 0.1 < np.abs(solve_qr(A, b) - x).max() / 3
        assert (found.weights[::5] < 0.1).all()
        assert np.median(np.delete(found.weights, np.s_[::5])) == 1

    def test_without_slips_it_is_least_squares(self):
        A, b, _ = system(np.random.default_rng(12))
        np.testing.assert_allclose(solve_robust(A, b, threshold=100).x, solve_qr(A, b), rtol=1e-9)

    def test_it_is_a_minimum(self):
        """Of Huber's cost: squares within the threshold, linear beyond it."""
        rng = np.random.default_rng(13)
        A, b, _ = system(rng, rows=30, unknowns=2)
        b[:5] += 10

        def cost(x):
            r = np.abs(A @ x - b)
            return np.sum(np.where(r <= 0.2, r**2, 2 * 0.2 * r - 0.2**2))

        x = solve_robust(A, b, threshold=0.2).x
        assert all(cost(x) < cost(x + 1e-4 * rng.normal(size=2)) for _ in range(30))

    def test_exact_data_with_a_slip(self):
        b = np.array([3.0, 6, 9, 12, 99])
        np.testing.assert_allclose(solve_robust([[1], [2], [3], [4], [5]], b).x, [3], rtol=1e-6)
        np.testing.assert_allclose(solve_robust(np.eye(3)[:, :2], np.zeros(3)).x, 0)

    def test_errors(self):
        with pytest.raises(ValueError, match="threshold must be positive"):
            solve_robust(np.eye(2), [1, 2], threshold=0)
        with pytest.raises(ValueError, match="one number for each row"):
            solve_robust(np.eye(2), np.eye(2))
