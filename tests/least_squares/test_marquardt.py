import numpy as np
import pytest

from course_lib.checks import DegenerateConfigurationError
from course_lib.least_squares import levenberg_marquardt, solve_qr

TIME = np.linspace(0, 3, 40)
TRUTH = np.array([2, 1.3, 0.5])


def decay(seen):
    """Return the problem ``a exp(-b t) + c = seen``."""

    def problem(x):
        a, b, c = x
        shape = np.exp(-b * TIME)
        return a * shape + c - seen, np.stack([shape, -a * TIME * shape, np.ones(40)], axis=1)

    return problem


def model(x):
    return decay(np.zeros(40))(x)[0]


@pytest.mark.parametrize("start", [(1, 1, 0), (0.1, 5, 3), (10, 0.1, -5)])
def test_exact_data_give_the_truth(start):
    fit = levenberg_marquardt(decay(model(TRUTH)), start)
    assert fit.converged
    np.testing.assert_allclose(fit.parameters, TRUTH, rtol=1e-9)


def test_it_begins_at_the_minimum_and_stays():
    fit = levenberg_marquardt(decay(model(TRUTH)), TRUTH)
    assert fit.converged
    np.testing.assert_allclose(fit.parameters, TRUTH, rtol=1e-12)


def test_a_linear_problem_is_solved_as_such():
    rng = np.random.default_rng(1)
    A, b = rng.normal(size=(9, 3)), rng.normal(size=9)
    fit = levenberg_marquardt(lambda x: (A @ x - b, A), np.zeros(3))
    np.testing.assert_allclose(fit.parameters, solve_qr(A, b), rtol=1e-6)
    assert fit.converged


def test_a_curved_valley():
    """Rosenbrock's: the way to (1, 1) is narrow and bent."""
    fit = levenberg_marquardt(
        lambda x: (
            np.array([10 * (x[1] - x[0] ** 2), 1 - x[0]]),
            np.array([[-20 * x[0], 10.0], [-1, 0]]),
        ),
        [-1.2, 1],
    )
    assert fit.converged
    np.testing.assert_allclose(fit.parameters, 1, atol=1e-9)


def test_sigma_is_the_scatter():
    rng = np.random.default_rng(2)
    noisy = model(TRUTH) + 0.02 * rng.normal(size=(300, 40))
    fits = [levenberg_marquardt(decay(seen), TRUTH) for seen in noisy]
    told = np.sqrt(np.mean([fit.sigma**2 for fit in fits], axis=0))
    np.testing.assert_allclose(told, np.std([f.parameters for f in fits], axis=0), rtol=0.12)


def test_forbidden_parameters_are_left_again():
    """The root of a negative number is NaN: the step must become shorter."""

    def root(x):
        return np.sqrt(x) - 0.1, np.atleast_2d(0.5 / np.sqrt(x))

    fit = levenberg_marquardt(root, [4.0])
    assert fit.converged
    np.testing.assert_allclose(fit.parameters, [0.01], rtol=1e-6)


def test_too_few_steps_are_said():
    fit = levenberg_marquardt(decay(model(TRUTH)), (10, 0.1, -5), steps=3)
    assert not fit.converged
    assert fit.steps == 3


def test_degenerate():
    with pytest.raises(DegenerateConfigurationError, match=r"parameter 1 \(counted from 0\)"):
        levenberg_marquardt(lambda x: (x[:1] - np.ones(2), np.eye(2) * [[1, 0]]), [3.0, 4])
    fit = levenberg_marquardt(lambda x: (np.full(3, x.sum() - 1), np.ones((3, 2))), [3.0, 4])
    assert fit.parameters.sum() == pytest.approx(1)
    with pytest.raises(DegenerateConfigurationError, match="the columns are dependent"):
        _ = fit.covariance


def test_errors():
    with pytest.raises(ValueError, match=r"shape \(N, 3\), got \(40,\) and \(3, 40\)"):
        levenberg_marquardt(lambda x: (model(x), np.ones((3, 40))), TRUTH)
    with pytest.raises(ValueError, match="start elsewhere"):
        levenberg_marquardt(decay(np.full(40, np.nan)), TRUTH)
    with pytest.raises(ValueError, match="one row of parameters"):
        levenberg_marquardt(decay(TIME), [[1, 2, 3]])
