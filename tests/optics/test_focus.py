"""Blur and depth of field against traced rays, against each other and against published numbers."""

import numpy as np
import pytest

from course_lib.optics import (
    circle_of_confusion,
    closeup_depth_of_field,
    depth_of_field,
    depth_of_field_approximate,
    hyperfocal_distance,
    magnification,
    object_distance,
)

FUNCTIONS = {
    circle_of_confusion: (1000, 2000, 50, 4),
    hyperfocal_distance: (50, 4, 0.01),
    depth_of_field: (50, 4, 2000, 0.01),
    depth_of_field_approximate: (50, 4, 2000, 0.01),
    closeup_depth_of_field: (0.1, 4, 0.01),
}
DISTANT = ("Z", "focus_distance")  # may be infinite


def spot_of_traced_rays(Z, focus_distance, f, N, height=0.0):
    """Send a fan of rays through a lens, each by its bend y / f, and measure the spot."""

    def slopes_behind(point_distance, point_height, y):
        return (y - point_height) / point_distance - y / f

    y = np.linspace(-0.5, 0.5, 101) * f / N
    # The sensor stands where two rays of a point in focus meet.
    ends = np.array([0.0, 1.0])
    a, b = slopes_behind(focus_distance, 0.0, ends)
    sensor = (ends[1] - ends[0]) / (a - b)
    hits = y + sensor * slopes_behind(Z, height, y)
    return hits.max() - hits.min()


@pytest.mark.parametrize("function", FUNCTIONS)
@pytest.mark.parametrize("bad", [0, -1, np.nan, -np.inf])
def test_errors(function, bad):
    arguments = FUNCTIONS[function]
    for i in range(len(arguments)):
        with pytest.raises(ValueError, match=r"positive|finite"):
            function(*arguments[:i], bad, *arguments[i + 1 :])


@pytest.mark.parametrize("function", FUNCTIONS)
def test_errors_of_type(function):
    with pytest.raises(TypeError, match="must be real numbers, got 'f/4'"):
        function(*FUNCTIONS[function][:-1], "f/4")


def test_focus_inside_the_focal_length_is_named():
    with pytest.raises(ValueError, match=r"focus_distance must be larger than the focal length"):
        circle_of_confusion(1000, 50, 50, 4)
    with pytest.raises(ValueError, match=r"focus_distance must be larger .*got 40: .*virtual"):
        depth_of_field(50, 4, [2000, 40], 0.01)


def test_shapes():
    assert np.ndim(circle_of_confusion(1000, 2000, 50, 4)) == 0
    assert circle_of_confusion([[1000], [3000]], 2000, 50, [2, 4, 8]).shape == (2, 3)
    for function in (depth_of_field, depth_of_field_approximate):
        near, far = function(50, 4, 2000, 0.01)
        assert np.ndim(near) == np.ndim(far) == 0
        near, far = function(50, [[2], [4]], [1000, 2000, 1e6], 0.01)
        assert near.shape == far.shape == (2, 3)
    assert hyperfocal_distance(50, [4, 8], 0.01).shape == (2,)


class TestCircleOfConfusion:
    @pytest.mark.parametrize("height", [0.0, 120.0])
    @pytest.mark.parametrize("focus_distance", [120, 900, 20000])
    @pytest.mark.parametrize("Z", [40, 100, 500, 899, 4000, 1e7])
    def test_accuracy(self, Z, focus_distance, height):
        spot = spot_of_traced_rays(Z, focus_distance, 50, 2.8, height)
        assert circle_of_confusion(Z, focus_distance, 50, 2.8) == pytest.approx(spot, rel=1e-6)

    def test_in_focus(self):
        assert circle_of_confusion(2000, 2000, 50, 4) == 0
        assert circle_of_confusion(np.inf, np.inf, 50, 4) == 0

    def test_infinity(self):
        far = circle_of_confusion(1e12, 2000, 50, 4)
        assert circle_of_confusion(np.inf, 2000, 50, 4) == pytest.approx(far)
        # Focused on the stars, a point at the distance Z is blurred by f² / (N Z).
        assert circle_of_confusion(2000, np.inf, 50, 4) == pytest.approx(50**2 / (4 * 2000))

    def test_inverse_to_the_f_number(self):
        N = np.array([1.4, 2.8, 5.6])
        blur = circle_of_confusion(1000, 2000, 50, N)
        np.testing.assert_allclose(blur * N, blur[0] * N[0])


class TestDepthOfField:
    @pytest.mark.parametrize("f", [8, 50, 400])
    @pytest.mark.parametrize("N", [1.4, 8, 32])
    def test_limits_have_the_largest_blur_allowed(self, f, N):
        c, H = 0.01, float(hyperfocal_distance(f, N, 0.01))
        for focus_distance in np.linspace(f, H, 7)[1:-1]:
            near, far = depth_of_field(f, N, focus_distance, c)
            assert f < near < focus_distance < far < np.inf
            for limit in (near, far):
                blur = circle_of_confusion(limit, focus_distance, f, N)
                assert blur == pytest.approx(c, rel=1e-9)

    def test_at_the_hyperfocal_distance(self):
        # Published: focused on H, everything from H / 2 to infinity is sharp.
        H = hyperfocal_distance(50, 8, [0.005, 0.01, 0.03])
        near, far = depth_of_field(50, 8, H, [0.005, 0.01, 0.03])
        np.testing.assert_allclose(near, H / 2, rtol=1e-14)
        assert np.isinf(far).all()
        np.testing.assert_allclose(
            circle_of_confusion(np.inf, H, 50, 8), [0.005, 0.01, 0.03], rtol=1e-12
        )
        assert np.isfinite(depth_of_field(50, 8, H * (1 - 1e-12), [0.005, 0.01, 0.03])[1]).all()

    def test_beyond_the_hyperfocal_distance(self):
        H = hyperfocal_distance(50, 8, 0.01)
        near, far = depth_of_field(50, 8, [H * 1.01, 10 * H, np.inf], 0.01)
        assert np.isinf(far).all()
        blur = circle_of_confusion(near, [H * 1.01, 10 * H, np.inf], 50, 8)
        np.testing.assert_allclose(blur, 0.01)
        assert near[2] == pytest.approx(H - 50)  # focused on infinity

    def test_inside_is_sharp_and_outside_is_not(self):
        near, far = depth_of_field(85, 2.8, 3000, 0.01)
        inside = np.linspace(near, far, 50)[1:-1]
        assert (circle_of_confusion(inside, 3000, 85, 2.8) < 0.01).all()
        outside = [near * 0.999, far * 1.001, 100, np.inf]
        assert (circle_of_confusion(outside, 3000, 85, 2.8) > 0.01).all()


class TestDepthOfFieldApproximate:
    def test_published_form(self):
        H = 50**2 / (8 * 0.01)
        near, far = depth_of_field_approximate(50, 8, [2000, H], 0.01)
        np.testing.assert_allclose(near, [H * 2000 / (H + 2000), H / 2])
        np.testing.assert_allclose(far, [H * 2000 / (H - 2000), np.inf])

    def test_how_far_it_is_off(self):
        # As the docstring says: the width is wrong by about f / focus_distance.
        for focus_distance in (500, 1000, 2000):
            near, far = depth_of_field(50, 2.8, focus_distance, 0.005)
            near2, far2 = depth_of_field_approximate(50, 2.8, focus_distance, 0.005)
            off = (far2 - near2) / (far - near) - 1
            assert off == pytest.approx(50 / focus_distance, rel=0.15)

    def test_infinite_one_focal_length_too_early(self):
        H = hyperfocal_distance(50, 8, 0.01)
        for focus_distance in (H - 49, H - 1):
            assert np.isfinite(depth_of_field(50, 8, focus_distance, 0.01)[1])
            assert np.isinf(depth_of_field_approximate(50, 8, focus_distance, 0.01)[1])
        assert np.isfinite(depth_of_field_approximate(50, 8, H - 51, 0.01)[1])


class TestCloseup:
    def test_published_numbers(self):
        assert round(float(closeup_depth_of_field(1 / 20, 16, 0.038)), 1) == 510.7
        assert round(float(closeup_depth_of_field(100, 16, 0.038)) * 1000, 2) == 12.28

    @pytest.mark.parametrize("f", [20, 100])
    @pytest.mark.parametrize("m", [0.05, 0.3, 1, 5])
    def test_accuracy(self, f, m):
        # The exact depth is larger by 1 / (1 - q²) with q = c N / (m f).
        N, c = 8, 0.005
        near, far = depth_of_field(f, N, object_distance(f, m), c)
        exact = closeup_depth_of_field(m, N, c) / (1 - (c * N / (m * f)) ** 2)
        assert far - near == pytest.approx(exact, rel=1e-8)

    def test_published_pair_in_the_exact_form(self):
        # 510.7 mm needs c N much smaller than m f: at f = 50 mm the exact depth is 543 mm.
        Z = object_distance(50, 1 / 20)
        assert magnification(50, Z) == pytest.approx(1 / 20)
        near, far = depth_of_field(50, 16, Z, 0.038)
        assert round(float(far - near)) == 543
