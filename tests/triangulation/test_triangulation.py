"""Points from rays: truth, scatter against covariance, and what tells nothing."""

import numpy as np
import pytest
from two_views import K, scene

from course_lib.camera import camera_at, camera_matrix, pixel_ray, project
from course_lib.checks import DegenerateConfigurationError
from course_lib.epipolar import fundamental_from_cameras, sampson_error
from course_lib.triangulation import (
    closest_points_on_rays,
    depth_from_disparity,
    depth_uncertainty,
    intersect_ray_plane,
    point_covariance,
    refine_point,
    triangulate,
    triangulate_linear,
    triangulate_midpoint,
)
from course_lib.triangulation.two_views import meeting_pixels

PAIR = np.stack([camera_matrix(K, np.eye(3), [0, 0, 0]), camera_matrix(K, np.eye(3), [-1, 0, 0])])


def ring(count=5, radius=6.0):
    """Return cameras about the origin."""
    angles = 2 * np.pi * np.arange(count) / count
    eyes = radius * np.column_stack([np.cos(angles), np.sin(angles), 0.3 + 0 * angles])
    return np.stack([camera_at(eye, [0, 0, 0], K, (640, 480)).P for eye in eyes])


def views(cameras, points):
    return np.stack([project(points, P) for P in cameras])


@pytest.mark.parametrize("seed", range(5))
def test_exact_pixels_give_the_points_back(seed):
    s = scene(seed, count=100, noise=0)
    pixels, cameras = np.stack([s.exact1, s.exact2]), np.stack([s.P1, s.P2])
    for points in (
        triangulate(*pixels, *cameras),
        triangulate(*pixels, -2 * cameras[0], 5 * cameras[1]),
        triangulate_midpoint(*pixels, *cameras),
        triangulate_linear(pixels, cameras),
        refine_point(1.02 * s.points, pixels, cameras),
    ):
        np.testing.assert_allclose(points, s.points, rtol=1e-6)
    one = triangulate(s.exact1[0], s.exact2[0], s.P1, s.P2)
    np.testing.assert_allclose(one, s.points[0], rtol=1e-7)
    np.testing.assert_allclose(triangulate_linear(pixels[:, 0], cameras), s.points[0], rtol=1e-7)


def test_the_linear_answer_depends_neither_on_the_origin_nor_on_the_size_of_a_matrix():
    near, far = (camera_at(eye, [0, 0, 0], K, (640, 480)) for eye in ([0, -1, 0], [10, 0, 0]))
    exact = [one.project([0, 0, 0]) for one in (near, far)]
    pixels = np.add(exact, [[0.6, -0.8], [0.3, 0.9]])
    found = triangulate_linear(pixels, [near.P, far.P])
    sized = triangulate_linear(pixels, [-3 * near.P, 70 * far.P])
    np.testing.assert_allclose(sized, found, atol=1e-12)
    away = np.array([100.0, 50, 20])
    moved = [camera_matrix(K, one.R, one.t - one.R @ away) for one in (near, far)]
    np.testing.assert_allclose(triangulate_linear(pixels, moved) - away, found, atol=1e-6)


def test_many_blocks_are_put_together():
    points = np.random.default_rng(0).uniform((-2, -2, 4), (2, 2, 9), (10_000, 3))
    found = triangulate(*views(PAIR, points), *PAIR)
    np.testing.assert_allclose(found, points, atol=1e-9)


@pytest.mark.parametrize("seed", range(3))
def test_closed_form_is_the_smallest_reprojection_error(seed):
    s = scene(seed, count=300)
    pixels, cameras = np.stack([s.points1, s.points2]), np.stack([s.P1, s.P2])

    def squares(X):
        return ((views(cameras, X) - pixels) ** 2).sum(axis=(0, 2))

    quick = triangulate(*pixels, *cameras)
    front = ~np.isnan(squares(quick))
    best = refine_point(quick[front], pixels[:, front], cameras)
    quick_squares = squares(quick)[front]
    best_squares = ((views(cameras, best) - pixels[:, front]) ** 2).sum(axis=(0, 2))
    assert front.mean() > 0.9
    assert (best_squares <= quick_squares * (1 + 1e-9) + 1e-12).all()
    assert np.median(quick_squares / best_squares) < 1.001


def test_moved_pixels_have_rays_that_meet():
    s = scene(3, count=100)
    F = fundamental_from_cameras(s.P1, s.P2)
    one, other = meeting_pixels(s.points1, s.points2, F)
    before = sampson_error(s.points1, s.points2, F)
    after = sampson_error(one[:2].T, other[:2].T, F)
    assert np.median(after) < 0.01 * np.median(before)
    moved = np.hypot(*(one[:2].T - s.points1).T), np.hypot(*(other[:2].T - s.points2).T)
    np.testing.assert_allclose(np.hypot(*moved), before, rtol=1e-9)


def test_more_views_and_gaps():
    rng = np.random.default_rng(1)
    points, cameras = rng.uniform(-1, 1, (200, 3)), ring()
    exact = views(cameras, points)
    pixels = exact + 0.5 * rng.normal(size=exact.shape)
    pixels[0, :50] = np.nan  # the first camera sees fewer
    linear = triangulate_linear(pixels, cameras)
    best = refine_point(linear, pixels, cameras)
    errors = [np.sqrt(((X - points) ** 2).sum(axis=1).mean()) for X in (best, linear)]
    assert errors[0] <= errors[1] < 0.01
    alone = refine_point(linear[:50], pixels[1:, :50], cameras[1:])
    np.testing.assert_allclose(best[:50], alone, atol=1e-9)
    residuals = views(cameras, best) - pixels
    for step in 1e-4 * np.eye(3):  # nothing near is better
        for sign in (1, -1):
            moved = views(cameras, best + sign * step) - pixels
            assert (np.nansum(moved**2, axis=(0, 2)) > np.nansum(residuals**2, axis=(0, 2))).all()


@pytest.mark.parametrize("cameras", [PAIR, ring(4)], ids=["pair", "ring"])
def test_covariance_is_the_scatter(cameras):
    rng, point = np.random.default_rng(2), np.array([0.3, 0.2, 5.0 if len(cameras) == 2 else 0.4])
    exact = views(cameras, point[None])
    pixels = exact + 0.2 * rng.normal(size=(len(cameras), 4000, 2))
    found = refine_point(np.tile(point, (4000, 1)), pixels, cameras)
    told = point_covariance(point, cameras, sigma=0.2)
    scatter = np.cov(found.T)
    size = np.sqrt(np.diag(told))
    np.testing.assert_allclose(
        scatter / np.outer(size, size), told / np.outer(size, size), atol=0.1
    )


def test_uncertainty_of_depth_is_the_covariance_of_a_rectified_pair():
    sigma, Z = 0.3, np.array([2.0, 4, 8])
    points = np.column_stack([0.5 + 0 * Z, 0 * Z, Z])  # midway between the cameras
    told = np.sqrt(point_covariance(points, PAIR, sigma)[:, 2, 2])
    rule = depth_uncertainty(Z, f=800, baseline=1, sigma=np.sqrt(2) * sigma)
    np.testing.assert_allclose(told, rule, rtol=1e-12)
    np.testing.assert_allclose(rule[1:] / rule[:-1], 4)


def test_depth_from_disparity():
    points = np.random.default_rng(3).uniform((-1, -1, 3), (1, 1, 9), (50, 3))
    left, right = views(PAIR, points)
    depths = depth_from_disparity(left[:, 0] - right[:, 0], 800, 1)
    np.testing.assert_allclose(depths, points[:, 2], rtol=1e-9)


def test_depth_of_the_published_pair():
    """Middlebury's Motorcycle: its right camera has its principal point 31.086 px farther right."""
    f, baseline, offset = 994.978, 193.001, 31.086
    left = np.array([[f, 0, 311.193, 0], [0, f, 254.877, 0], [0, 0, 1, 0]])
    right = left.copy()
    right[0, 2:] += offset, -f * baseline
    points = np.random.default_rng(6).uniform((-900, -500, 1800), (900, 500, 5000), (50, 3))
    (u_left, _), (u_right, _) = (image.T for image in views([left, right], points))
    depths = depth_from_disparity(u_left - u_right, f, baseline, offset)
    np.testing.assert_allclose(depths, points[:, 2], rtol=1e-9)
    assert depth_from_disparity(50.0, f, baseline, offset) == pytest.approx(2368.2, abs=0.05)


def test_closest_points():
    rng = np.random.default_rng(4)
    o1, o2 = rng.normal(size=(2, 3))
    d1, d2 = rng.normal(size=(2, 20, 3))
    one, other = closest_points_on_rays(o1, d1, o2, 5 * d2)
    for d in (d1, d2):
        np.testing.assert_allclose(((one - other) * d).sum(axis=1), 0, atol=1e-9)
    for p, o, d in ((one, o1, d1), (other, o2, d2)):
        np.testing.assert_allclose(np.cross(p - o, d), 0, atol=1e-9)
    swapped = closest_points_on_rays(o2, d2, o1, d1)
    np.testing.assert_allclose(swapped[0], other, atol=1e-9)


def test_midpoint_is_halfway_between_the_rays():
    s = scene(2, count=20)
    camera1, rays1 = pixel_ray(s.points1, K, np.eye(3), np.zeros(3))
    camera2, rays2 = pixel_ray(s.points2, K, s.R, s.t)
    one, other = closest_points_on_rays(camera1, rays1, camera2, rays2)
    found = triangulate_midpoint(s.points1, s.points2, s.P1, s.P2)
    np.testing.assert_allclose(found, (one + other) / 2, rtol=1e-9)


def test_laser_on_a_plane():
    camera = camera_at([0, -2, 1], [0, 0, 0], K, (640, 480))
    plane = np.array([0.1, -0.2, 1, 0.3])
    points = np.random.default_rng(5).uniform(-0.3, 0.3, (30, 3))
    points[:, 2] = -(points[:, :2] @ plane[:2] + plane[3]) / plane[2]
    rays = camera.pixel_ray(camera.project(points))
    np.testing.assert_allclose(
        intersect_ray_plane(camera.centre, rays, -3 * plane), points, atol=1e-9
    )
    assert np.isnan(intersect_ray_plane(camera.centre, -rays, plane)).all()


PARALLEL = [[320.0, 240], [320, 240]]


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: triangulate([[9, 9], PARALLEL[0]], [[5, 9], PARALLEL[1]], *PAIR), "of pair 1 "),
        (lambda: triangulate_midpoint(*PARALLEL, *PAIR), "parallel"),
        (lambda: triangulate_linear(PARALLEL, PAIR), "point 0 .* parallel"),
        (lambda: triangulate([9, 9], [5, 9], PAIR[0], PAIR[0]), "same place"),
        (lambda: triangulate_midpoint([9, 9], [5, 9], PAIR[0], 2 * PAIR[0]), "same place"),
        (lambda: triangulate_linear([[9, 9], [5, 9]], [PAIR[0], -PAIR[0]]), "same place"),
        (lambda: point_covariance([0.5, 0, 5], [PAIR[1], PAIR[1]]), "same place"),
        (lambda: point_covariance([5e8, 0, 1e15], PAIR), "not determined"),
        (lambda: closest_points_on_rays([0, 0, 0], [1, 1, 0], [1, 0, 0], [2, 2, 0]), "parallel"),
        (lambda: intersect_ray_plane([0, 0, 1], [1, 0, 0], [0, 0, 1, 0]), "parallel"),
        (lambda: intersect_ray_plane([3, 2, 0], [1, 0, 1], [0, 0, 1, 0]), "begin on the plane"),
        (lambda: depth_from_disparity([3, -2], 800, 0.1), "infinitely far"),
    ],
)
def test_degenerate_geometry_is_named(call, words):
    with pytest.raises(DegenerateConfigurationError, match=words):
        call()


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: triangulate([[1, 2]], [[1, 2], [3, 4]], *PAIR), "row by row"),
        (lambda: triangulate([1, np.nan], [1, 2], *PAIR), "NaN"),
        (lambda: triangulate_linear([[1, 2]], PAIR[:1]), "two or more camera matrices"),
        (lambda: triangulate_linear([[1, 2]] * 3, PAIR), r"shape \(V, N, 2\)"),
        (lambda: triangulate_linear([[1, 2], [np.nan, 2]], PAIR), "seen in 1 view"),
        (lambda: triangulate_linear([[1, 2], [np.inf, 2]], PAIR), "infinity"),
        (lambda: refine_point([0, 0, -5], [[9, 9], [5, 9]], PAIR), "behind a camera"),
        (lambda: refine_point([[0, 0, 5]] * 2, [[9, 9], [5, 9]], PAIR), "2 points"),
        (lambda: point_covariance([0, 0, -5], PAIR), "behind a camera"),
        (lambda: point_covariance([0, 0, 5], PAIR, sigma=0), "sigma must be positive"),
        (lambda: closest_points_on_rays([0] * 3, [[1, 0, 0]], [1] * 3, [1, 0, 0]), "partner"),
        (lambda: intersect_ray_plane([0, 0, 1], [0, 0, 0], [0, 0, 1, 0]), "points nowhere"),
        (lambda: intersect_ray_plane([0, 0, 1], [0, 0, 1], [0, 0, 0, 1]), "points nowhere"),
        (lambda: depth_uncertainty(-1, 800, 1, 1), "Z must be positive"),
        (lambda: depth_from_disparity(5, 0, 1), "f must be positive"),
    ],
)
def test_errors(call, words):
    with pytest.raises(ValueError, match=words):
        call()
