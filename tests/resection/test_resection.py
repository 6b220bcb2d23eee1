import numpy as np
import pytest

from course_lib.camera import Camera, camera_at, project
from course_lib.checks import DegenerateConfigurationError
from course_lib.resection import (
    camera_dlt,
    decompose_projection,
    dlt_parameters,
    fit_camera,
)

K = np.array([[1200, 3, 640], [0, 1190, 480], [0, 0, 1.0]])


def scene(seed=0, count=30, noise=0.0) -> tuple[Camera, np.ndarray, np.ndarray]:
    """Return a camera, points in a box before it, and their pixels."""
    rng = np.random.default_rng(seed)
    camera = camera_at(rng.uniform(3, 6, 3), (0, 0, 0), K, (1280, 960))
    points = rng.uniform(-1, 1, (count, 3))
    return camera, points, camera.project(points) + noise * rng.normal(size=(count, 2))


def with_eleven(points, pixels):
    return np.append(dlt_parameters(points, pixels), 1).reshape(3, 4)


each_estimator = pytest.mark.parametrize(
    "estimate", [camera_dlt, with_eleven, lambda *pair: fit_camera(*pair).P]
)


@each_estimator
@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("count", [6, 30])
def test_truth_comes_back(estimate, seed, count):
    camera, points, pixels = scene(seed, count)
    P = estimate(points, pixels)
    np.testing.assert_allclose(P / P[2, 3] * camera.P[2, 3], camera.P, rtol=1e-6, atol=1e-6)


@each_estimator
@pytest.mark.parametrize("seed", range(3))
def test_and_its_parts_too(estimate, seed):
    camera, points, pixels = scene(seed)
    intrinsics, R, centre = decompose_projection(estimate(points, pixels))
    np.testing.assert_allclose(intrinsics, K, atol=1e-5)
    np.testing.assert_allclose(R, camera.R, atol=1e-8)
    np.testing.assert_allclose(centre, camera.centre, atol=1e-7)


def test_the_third_row_is_the_depth():
    camera, points, pixels = scene()
    np.testing.assert_allclose(camera_dlt(points, pixels), camera.P, rtol=1e-7, atol=1e-7)


def test_normalising_makes_it_independent_of_units():
    _, points, pixels = scene(1, noise=1)
    seen = project(points, camera_dlt(points, pixels))
    far = camera_dlt(1000 * points + 5e5, pixels)
    np.testing.assert_allclose(project(1000 * points + 5e5, far), seen, atol=1e-3)


def test_fit_is_a_minimum():
    rng = np.random.default_rng(2)
    _, points, pixels = scene(2, noise=1)
    fit = fit_camera(points, pixels)
    np.testing.assert_allclose(project(points, fit.P) - pixels, fit.residuals, atol=1e-8)
    least = (fit.residuals**2).sum()
    for _ in range(30):
        other = project(points, fit.P * (1 + 1e-6 * rng.normal(size=(3, 4)))) - pixels
        assert (other**2).sum() > least
    dlt = project(points, camera_dlt(points, pixels)) - pixels
    assert (dlt**2).sum() > least


def test_the_centres_covariance_is_their_scatter():
    camera, points, pixels = scene(3)
    rng = np.random.default_rng(3)
    fits = [fit_camera(points, pixels + 0.5 * rng.normal(size=pixels.shape)) for _ in range(300)]
    scatter = np.cov(np.array([fit.centre for fit in fits]).T)
    told = np.mean([fit.centre_covariance for fit in fits], axis=0)
    root = np.linalg.inv(np.linalg.cholesky(scatter))
    np.testing.assert_allclose(root @ told @ root.T, np.eye(3), atol=0.25)
    errors = np.mean([fit.centre - camera.centre for fit in fits], axis=0)
    assert np.abs(errors).max() < 4 * np.sqrt(np.diag(scatter).max() / 300)


def test_published_decomposition():
    """Hartley & Zisserman, example 6.2, to the printed digits."""
    P = [
        [3.53553e2, 3.39645e2, 2.77744e2, -1.44946e6],
        [-1.03528e2, 2.33212e1, 4.59607e2, -6.32525e5],
        [7.07107e-1, -3.53553e-1, 6.12372e-1, -9.18559e2],
    ]
    intrinsics, R, centre = decompose_projection(P)
    np.testing.assert_allclose(
        intrinsics, [[468.2, 91.2, 300], [0, 427.2, 200], [0, 0, 1]], atol=0.05
    )
    np.testing.assert_allclose(centre, (1000, 2000, 1500), atol=0.05)
    np.testing.assert_allclose(
        R,
        [[0.41380, 0.90915, 0.04708], [-0.57338, 0.22011, 0.78917], [0.70711, -0.35355, 0.61237]],
        atol=1e-5,
    )
    seen = np.array([[x, y, z] for x in (-50, 40) for y in (-30, 40) for z in (90, 200)])
    points = centre + seen @ R
    found = decompose_projection(camera_dlt(points, project(points, P)))
    np.testing.assert_allclose(found[0], intrinsics, rtol=1e-4, atol=1e-4)
    np.testing.assert_allclose(found[2], centre, rtol=1e-4)


@each_estimator
def test_degenerate(estimate):
    _, points, pixels = scene()
    flat = points * [1, 1, 0]
    with pytest.raises(DegenerateConfigurationError, match="all points are coplanar"):
        estimate(flat, pixels)
    slanted = flat @ np.linalg.qr(np.random.default_rng(1).normal(size=(3, 3)))[0] + 7
    with pytest.raises(DegenerateConfigurationError, match="all points are coplanar"):
        estimate(slanted, pixels)
    with pytest.raises(DegenerateConfigurationError, match="all points are collinear"):
        estimate(points * [1, 0, 0], pixels)
    with pytest.raises(DegenerateConfigurationError, match="all points are the same point"):
        estimate(np.ones((6, 3)), pixels[:6])
    with pytest.raises(DegenerateConfigurationError, match="all pixels are collinear"):
        estimate(points, pixels * [1, 0])


@each_estimator
def test_two_planes_of_which_one_holds_a_single_point(estimate):
    _, points, _ = scene()
    flat = points * [1, 1, 0]
    flat[0, 2] = 1
    pixels = camera_at((3, 4, 5), (0, 0, 0), K, (1280, 960)).project(flat)
    with pytest.raises(DegenerateConfigurationError, match=r"more than one direction|dependent"):
        estimate(flat, pixels)


@each_estimator
def test_errors(estimate):
    _, points, pixels = scene()
    with pytest.raises(ValueError, match="6 points or more are needed, got 5"):
        estimate(points[:5], pixels[:5])
    with pytest.raises(ValueError, match="points and pixels belong together row by row"):
        estimate(points, pixels[:9])
    with pytest.raises(ValueError, match="pixels must be finite"):
        estimate(points, np.where(pixels == pixels[0, 0], np.nan, pixels))
    with pytest.raises(ValueError, match=r"points must have shape \(N, 3\)"):
        estimate(pixels, points)


def test_parallel_rays_have_no_depth():
    _, points, _ = scene()
    with pytest.raises(DegenerateConfigurationError, match="centre is at infinity"):
        camera_dlt(points, points[:, :2] * 100 + 300)


def test_inputs_stay_as_they_are():
    _, points, pixels = scene()
    copies = points.copy(), pixels.copy()
    fit_camera(points, pixels)
    np.testing.assert_array_equal(points, copies[0])
    np.testing.assert_array_equal(pixels, copies[1])
