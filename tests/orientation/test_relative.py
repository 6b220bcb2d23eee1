import numpy as np
import pytest

from course_lib.camera import camera_matrix, project
from course_lib.checks import DegenerateConfigurationError
from course_lib.orientation import (
    pose_from_relative,
    relative_from_pose,
    relative_orientation,
)

K = np.array([[3000.0, 0, 2000], [0, 3000, 1500], [0, 0, 1]])


def pair(rng, angles, base, count=40, noise=0.0):
    """Return pixels of hills, seen by a camera that looks down and by its neighbour."""
    plan = rng.uniform([-3, -3], [4, 3], (count, 2))
    X = np.column_stack([plan, rng.normal(8, 0.7, count)])
    R, t = pose_from_relative(base, angles)
    first = project(X, camera_matrix(K, np.eye(3), [0, 0, 0]))
    second = project(X, camera_matrix(K, R, t))
    return [p + noise * rng.standard_normal(p.shape) for p in (first, second)]


def test_there_and_back():
    base, angles = [1, 0.1, -0.2], [0.1, -0.2, 0.3]
    found = relative_from_pose(*pose_from_relative(base, angles))
    np.testing.assert_allclose(found[0], base, rtol=0, atol=1e-12)
    np.testing.assert_allclose(found[1], angles, rtol=0, atol=1e-12)


@pytest.mark.parametrize("angles", [[0, 0, 0], [0.05, -0.08, 0.1], [-0.2, 0.15, -0.3]])
def test_without_noise_the_orientation_comes_back(angles):
    base = [1, 0.08, -0.05]
    found = relative_orientation(*pair(np.random.default_rng(1), angles, base), K)
    np.testing.assert_allclose(found.base, base, rtol=0, atol=1e-7)
    np.testing.assert_allclose(found.angles, angles, rtol=0, atol=1e-7)
    R, t = found.pose
    np.testing.assert_allclose(R, pose_from_relative(base, angles)[0], rtol=0, atol=1e-7)
    assert t.shape == (3,)


def test_sigma_is_the_scatter():
    rng, base, angles = np.random.default_rng(2), [1, 0.05, 0.02], [0.03, -0.02, 0.05]
    errors, reported = [], []
    for _ in range(300):
        first, second = pair(np.random.default_rng(3), angles, base)
        noise = 0.5 * rng.standard_normal((2, *first.shape))
        found = relative_orientation(first + noise[0], second + noise[1], K)
        errors.append(np.append(found.base[1:], found.angles) - [*base[1:], *angles])
        reported.append(found.sigma)
    scatter = np.sqrt(np.mean(np.square(errors), axis=0))
    np.testing.assert_allclose(np.sqrt(np.mean(np.square(reported), axis=0)), scatter, rtol=0.1)


def test_the_residuals_are_as_large_as_the_noise():
    first, second = pair(np.random.default_rng(4), [0.03, -0.02, 0.05], [1, 0, 0], 300, 0.5)
    found = relative_orientation(first, second, K)
    assert np.sqrt((found.residuals**2).sum() / 295) == pytest.approx(0.5, rel=0.05)


def test_what_leaves_it_open_is_named():
    rng = np.random.default_rng(5)
    pixels = rng.uniform(0, 3000, (20, 2))
    with pytest.raises(DegenerateConfigurationError, match="do not fix"):
        relative_orientation(pixels, pixels, K)  # no base at all
    with pytest.raises(ValueError, match="6 pixels of the first or more"):
        relative_orientation(pixels[:5], pixels[:5], K)
