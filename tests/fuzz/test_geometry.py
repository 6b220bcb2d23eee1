"""Whatever goes in: the right answer, a documented row of NaN, or the documented error."""

import inspect
import math

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from course_lib import camera, homogeneous, optics, transforms
from course_lib.checks import DegenerateConfigurationError
from course_lib.transforms import check_rotation

fuzz = settings(
    derandomize=True,
    max_examples=100,
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much],
)

numbers = st.one_of(
    st.just(0.0), st.integers(-9, 9).map(float), st.floats(1e-30, 1e30), st.floats(-1e30, -1e-30)
)
#: Numbers as they come in a measurement, so that rounding stays small.
usual = st.one_of(st.just(0.0), st.floats(1e-3, 1e3), st.floats(-1e3, -1e-3))
angles = st.one_of(
    st.floats(-7, 7),
    st.builds(
        lambda base, n: base + 10.0**-n,
        st.sampled_from([0, math.pi / 2, math.pi, -math.pi]),
        st.integers(1, 300),
    ),
)
mischief = st.sampled_from(
    [None, "7", [], {}, 1j, True, math.nan, math.inf, [1, [2, 3]], [math.nan] * 3, 1e200, "xyz"]
)


def vectors(length, entries=numbers):
    return st.tuples(*[entries] * length).map(np.array)


def rows(length, entries=usual):
    return st.lists(vectors(length, entries), min_size=1, max_size=4).map(np.array)


def matrices(height, width, entries=numbers):
    return vectors(height * width, entries).map(lambda v: v.reshape(height, width))


rotations = st.builds(
    lambda q: transforms.rotation_from_quaternion(q / np.linalg.norm(q)),
    vectors(4, usual).filter(lambda q: np.linalg.norm(q) > 1e-3),
)
intrinsics = st.builds(
    lambda f, aspect, skew, c: np.array([[f, skew, c[0]], [0, f * aspect, c[1]], [0, 0, 1]]),
    st.floats(10, 1e4),
    st.floats(0.3, 3),
    st.floats(-100, 100),
    vectors(2, usual),
)
shapes = st.one_of(
    numbers,
    vectors(2),
    vectors(3),
    vectors(4),
    rows(3, numbers),
    rows(2, numbers),
    matrices(3, 3),
    matrices(3, 4),
    matrices(4, 4),
    rotations,
    intrinsics,
    mischief,
)

#: Rows of NaN are an answer of these.
NAN_ROWS = {"from_homogeneous", "apply_homography", "project", "project_pinhole", "vanishing_point"}
FUNCTIONS = [
    *(getattr(transforms, name) for name in transforms.__all__),
    homogeneous.to_homogeneous,
    homogeneous.from_homogeneous,
    homogeneous.line_through,
    homogeneous.meet,
    homogeneous.apply_homography,
    homogeneous.map_lines,
    homogeneous.cross_ratio,
    *(getattr(camera, name) for name in camera.__all__ if not name.lower().startswith("camera")),
    camera.camera_matrix,
    optics.cardinal_points,
    optics.image_of_point,
    optics.system_matrix,
    optics.trace_rays,
]


def flat(answer):
    """Return all numbers of an answer in one array."""
    parts = answer if isinstance(answer, tuple) else (answer,)
    return np.concatenate([np.ravel(part) for part in parts])


@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda f: f.__name__)
@fuzz
@given(data=st.data())
def test_anything_gives_numbers_or_the_documented_error(function, data):
    needed = [p for p in inspect.signature(function).parameters.values() if p.default is p.empty]
    arguments = [data.draw(shapes, label=p.name) for p in needed]
    copies = [np.copy(a) if isinstance(a, np.ndarray) else a for a in arguments]
    try:
        answer = function(*arguments)
    except (TypeError, ValueError) as error:
        words = str(error)
    else:
        words = ""
    if words:
        assert len(words) > 20, "an error says what was expected"
        assert "operands" not in words, "an error is ours, not NumPy's"
        return
    numbers = flat(answer)
    assert numbers.dtype == np.float64
    assert not np.isinf(numbers).any()
    if function.__name__ not in NAN_ROWS:
        assert not np.isnan(numbers).any()
    for argument, copy in zip(arguments, copies, strict=True):
        if isinstance(argument, np.ndarray):
            np.testing.assert_array_equal(argument, copy)


@fuzz
@given(rows(3, numbers))
def test_from_homogeneous(points):
    for row, (x, y, w) in zip(homogeneous.from_homogeneous(points), points, strict=True):
        expected = (x / w, y / w) if w else (math.nan, math.nan)
        np.testing.assert_allclose(row, expected, rtol=1e-15)


@fuzz
@given(vectors(3, usual), vectors(3, usual))
def test_join_and_meet(p, q):
    assume(np.abs(p).max() > 0)
    assume(np.abs(q).max() > 0)
    for function in (homogeneous.line_through, homogeneous.meet):
        try:
            joined = function(p, q)
        except DegenerateConfigurationError:
            sine = np.linalg.norm(np.cross(p, q)) / np.linalg.norm(p) / np.linalg.norm(q)
            assert sine < 1e-11
            return
        size = np.linalg.norm(joined)
        assert abs(joined @ p) <= 1e-12 * size * np.linalg.norm(p) + 1e-9 * (size < 1e-9)
        assert abs(joined @ q) <= 1e-12 * size * np.linalg.norm(q) + 1e-9 * (size < 1e-9)


@fuzz
@given(vectors(3), angles)
def test_rotation_about_axis(axis, angle):
    if not axis.any():
        with pytest.raises(ValueError, match="points nowhere"):
            transforms.rotation_about_axis(axis, angle)
        return
    R = transforms.rotation_about_axis(axis, angle)
    check_rotation(R, 1e-14)
    unit = axis / np.linalg.norm(axis)
    np.testing.assert_allclose(R @ unit, unit, atol=1e-14)
    assert np.trace(R) == pytest.approx(1 + 2 * math.cos(angle), abs=1e-14)
    vector = transforms.vector_from_rotation(R)
    np.testing.assert_allclose(transforms.rotation_from_vector(vector), R, atol=1e-13)
    again = transforms.rotation_from_quaternion(transforms.quaternion_from_rotation(R))
    np.testing.assert_allclose(again, R, atol=1e-13)


@fuzz
@given(vectors(3, angles), st.sampled_from(["xyz", "zyx", "yzx", "xzy", "zxy", "yxz"]))
def test_euler_angles(three, order):
    R = transforms.rotation_from_euler(three, order)
    check_rotation(R, 1e-14)
    try:
        back = transforms.euler_from_rotation(R, order)
    except DegenerateConfigurationError:
        assert abs(math.cos(three[1])) < 2e-9
        return
    np.testing.assert_allclose(transforms.rotation_from_euler(back, order), R, atol=1e-13)
    assert abs(back[1]) <= math.pi / 2


@fuzz
@given(rotations, vectors(3, usual), rows(3))
def test_poses(R, t, points):
    there = transforms.transform_points(points, R, t)
    for way_back in (
        transforms.invert_pose(R, t),
        transforms.pose_from_placement(R, t),
        transforms.pose_from_matrix(np.linalg.inv(transforms.rigid_matrix(R, t)).round(30)),
    ):
        back = transforms.transform_points(there, *way_back)
        np.testing.assert_allclose(back, points, atol=1e-10)
    assert np.abs(R @ transforms.camera_centre(R, t) + t).max() <= 1e-12 * (1 + np.abs(t).max())
    again = transforms.pose_from_twist(*transforms.twist_from_pose(R, t))
    np.testing.assert_allclose(again[0], R, atol=1e-12)
    np.testing.assert_allclose(again[1], t, atol=1e-12 * (1 + np.abs(t).max()))


@fuzz
@given(intrinsics, rotations, vectors(3, usual), rows(3), st.sampled_from([1, -1, 1e-20, -3e20]))
def test_project(K, R, t, points, scale):
    pixels = camera.project(points, scale * camera.camera_matrix(K, R, t))
    for pixel, point in zip(pixels, points, strict=True):
        X, Y, Z = R @ point + t
        rounding = 1e-13 * (1 + np.abs(point).max() + np.abs(t).max())
        if abs(Z) < 1e3 * rounding:
            continue  # in the plane of the camera, up to rounding
        if Z < 0:
            assert np.isnan(pixel).all()
        else:
            expected = K[:2] @ (X / Z, Y / Z, 1)
            size = np.abs(K).max() * (1 + max(abs(X), abs(Y)) / Z)
            np.testing.assert_allclose(pixel, expected, atol=size * (1e-12 + rounding / Z))


@fuzz
@given(intrinsics, rotations, vectors(3, usual), rows(2))
def test_pixel_ray_comes_back(K, R, t, pixels):
    centre, directions = camera.pixel_ray(pixels, K, R, t)
    np.testing.assert_allclose(np.linalg.norm(directions, axis=1), 1)
    distance = 10 * (1 + np.abs(t).max())
    seen = camera.project(centre + distance * directions, camera.camera_matrix(K, R, t))
    oblique = 1 / (directions @ R[2]).min() ** 2
    np.testing.assert_allclose(seen, pixels, atol=1e-11 * np.abs(K).max() * oblique)


@fuzz
@given(intrinsics, rotations, vectors(3, usual), st.floats(1e-6, 1e6), st.sampled_from([-1, 1]))
def test_decompose_projection(K, R, t, scale, sign):
    again = camera.decompose_projection(sign * scale * camera.camera_matrix(K, R, t))
    rounding = 1e-13 * np.abs(K).max() / np.diag(K)[:2].min()
    np.testing.assert_allclose(again[0], K, atol=rounding * np.abs(K).max())
    np.testing.assert_allclose(again[1], R, atol=rounding)
    np.testing.assert_allclose(again[2], -R.T @ t, atol=rounding * (1 + np.abs(t).max()))
