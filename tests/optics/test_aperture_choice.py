import numpy as np
import pytest

from course_lib.optics import (
    airy_diameter,
    aperture_for_depth,
    apertures_for_limits,
    circle_of_confusion,
    depth_of_field,
    hyperfocal_distance,
    magnification,
    sharpest_f_number,
    working_f_number,
)

FUNCTIONS = {
    aperture_for_depth: (50, 900, 1100, 0.01),
    apertures_for_limits: (50, 900, 1100, 1000, 0.01),
    sharpest_f_number: (1100, 1000, 50, 0.00055),
}


@pytest.mark.parametrize("function", FUNCTIONS)
@pytest.mark.parametrize("bad", [0, -1, np.nan, -np.inf])
def test_errors(function, bad):
    arguments = FUNCTIONS[function]
    for i in range(len(arguments)):
        with pytest.raises(ValueError, match=r"positive|finite"):
            function(*arguments[:i], bad, *arguments[i + 1 :])


@pytest.mark.parametrize(("near", "far"), [(1100, 900), (1000, 1000)])
def test_errors_of_order(near, far):
    for function, rest in ((aperture_for_depth, (0.01,)), (apertures_for_limits, (1000, 0.01))):
        with pytest.raises(ValueError, match=r"near must be smaller than far.*exchange them"):
            function(50, near, far, *rest)


def test_errors_of_focus():
    with pytest.raises(ValueError, match=r"near must be larger than the focal length"):
        aperture_for_depth(50, 45, 1000, 0.01)
    for focus_distance in (800, 1200):
        with pytest.raises(ValueError, match="must lie between near and far"):
            apertures_for_limits(50, 900, 1100, focus_distance, 0.01)
    with pytest.raises(ValueError, match="Z must differ from focus_distance"):
        sharpest_f_number([900, 1000], 1000, 50, 0.00055)


def test_shapes():
    N, focus_distance = aperture_for_depth(50, [900, 950], 1100, [[0.01], [0.02], [0.03]])
    assert (N.shape, focus_distance.shape) == ((3, 2), (2,))
    assert np.ndim(aperture_for_depth(50, 900, 1100, 0.01)[0]) == 0
    assert apertures_for_limits(50, 900, 1100, [950, 1000], 0.01)[0].shape == (2,)
    assert sharpest_f_number([900, 950], 1000, 50, 0.00055).shape == (2,)


@pytest.mark.parametrize(("near", "far"), [(900, 1100), (60, 70), (3000, 1e6), (2500, np.inf)])
def test_round_trip(near, far):
    N, focus_distance = aperture_for_depth(50, near, far, 0.01)
    np.testing.assert_allclose(circle_of_confusion([near, far], focus_distance, 50, N), 0.01)
    limits = depth_of_field(50, N * (1 + 1e-9), focus_distance, 0.01)
    np.testing.assert_allclose(limits, (near, far), rtol=1e-6)


def test_no_focus_does_with_a_smaller_f_number():
    N, focus_distance = aperture_for_depth(50, 900, 1100, 0.01)
    tried = np.linspace(900, 1100, 2001)
    needed = np.maximum(*apertures_for_limits(50, 900, 1100, tried, 0.01))
    assert needed.min() == pytest.approx(N, rel=1e-3)
    assert needed.min() > N * (1 - 1e-12)
    assert tried[np.argmin(needed)] == pytest.approx(focus_distance, abs=0.2)


def test_focus_on_one_end():
    N_near, N_far = apertures_for_limits(50, 900, 1100, 900, 0.01)
    assert N_near == 0  # any opening does
    assert circle_of_confusion(1100, 900, 50, N_far) == pytest.approx(0.01)


def test_published_branches():
    # N = f² (d - near) / (c d near) and f² (far - d) / (c d far): f is neglected beside d.
    f, near, far, d, c = 50, 9000, 12000, 10500, 0.005
    N_near, N_far = apertures_for_limits(f, near, far, d, c)
    assert N_near == pytest.approx(f**2 * (d - near) / (c * d * near), rel=2 * f / d)
    assert N_far == pytest.approx(f**2 * (far - d) / (c * d * far), rel=2 * f / d)


def test_up_to_infinity():
    # Focus on the hyperfocal distance: twice as far as the near end.
    N, focus_distance = aperture_for_depth(50, 2000, np.inf, 0.01)
    assert focus_distance == 4000
    assert hyperfocal_distance(50, N, 0.01) == pytest.approx(4000)


class TestSharpest:
    @pytest.mark.parametrize(("Z", "s", "f"), [(1100, 1000, 50), (np.inf, 5000, 85), (90, 100, 40)])
    def test_is_the_minimum(self, Z, s, f):
        best = sharpest_f_number(Z, s, f, 0.00055)
        N = best * np.linspace(0.5, 2, 1001)
        seen = working_f_number(N, magnification(f, s))
        spot = circle_of_confusion(Z, s, f, N) + airy_diameter(0.00055, seen)
        np.testing.assert_allclose(N[np.argmin(spot)], best, rtol=2e-3)

    def test_halves_are_equal(self):
        best = sharpest_f_number(1100, np.inf, 50, 0.00055)
        blur = circle_of_confusion(1100, np.inf, 50, best)
        assert blur == pytest.approx(airy_diameter(0.00055, best))
