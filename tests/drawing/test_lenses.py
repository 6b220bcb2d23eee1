"""The figures of chapter 03: each draws, says what its axes are, and shows the right thing."""

import matplotlib as mpl
import numpy as np
import pytest
from legible import Legible

mpl.use("Agg")  # as a test has no screen

from scipy.signal import fftconvolve

from course_lib import optics
from course_lib.drawing import lenses as draw
from course_lib.drawing.lenses import views
from course_lib.drawing.style import BLACK, ROLES

FIGURES = {
    "airy_on_pixels": draw.airy_on_pixels,
    "aperture_branches": lambda: draw.aperture_branches(yours=(20, 1200)),
    "aperture_branches outside": lambda: draw.aperture_branches(yours=(1200, 20)),
    "aperture_series": draw.aperture_series,
    "approximation": draw.approximation,
    "blur_against_distance": lambda: draw.blur_against_distance(yours=(2100, 2300)),
    "blur_against_distance beyond": lambda: draw.blur_against_distance(24, 8, 13000, 0.006),
    "blur_cones": draw.blur_cones,
    "closeup": lambda: draw.closeup(yours=(500, 0.01)),
    "hole_and_lens": draw.hole_and_lens,
    "image_against_object": lambda: draw.image_against_object(85, [100, 170], [567, 170]),
    "image_construction": draw.image_construction,
    "lens_name": draw.lens_name,
    "pixel_on_object": draw.pixel_on_object,
    "principal_planes": draw.principal_planes,
    "ranges": draw.ranges,
    "ranges outside": lambda: draw.ranges(yours=[None] * 4 + [(8581, -20044)]),
    "ray_steps": draw.ray_steps,
    "stops": draw.stops,
    "sweet_spot": draw.sweet_spot,
    "wing": draw.wing,
    "zoom": draw.zoom,
    "zoom outside": lambda: draw.zoom(yours=[(-300, 0, 0)] * 3),
}


@pytest.fixture(params=FIGURES)
def figure(request):
    drawn = FIGURES[request.param]()
    drawn.draw_without_rendering()
    return drawn


class TestEachFigure(Legible):
    UNITS = ("px", "mm", "m", "%", "no unit")


def test_every_function_is_tried_here():
    assert {name.split()[0] for name in FIGURES} == set(draw.__all__)


@pytest.mark.parametrize("yours", [None, "left", [1, 2, 3, 4], np.full(2, np.nan), {}, (1, -5)])
def test_what_a_student_cannot_have_meant_is_not_drawn_or_does_no_harm(yours):
    draw.image_against_object(85, [100, 200], yours=yours).draw_without_rendering()
    draw.blur_against_distance(yours=yours).draw_without_rendering()
    draw.ranges(yours=[yours] * 5).draw_without_rendering()
    draw.closeup(yours=yours).draw_without_rendering()
    draw.aperture_branches(yours=yours).draw_without_rendering()
    draw.zoom(yours=[yours] * 3).draw_without_rendering()


def lines(figure, colour):
    """Return the points of all lines of a colour."""
    found = [line for ax in figure.axes for line in ax.lines if line.get_color() == colour]
    return [np.asarray(line.get_xydata()) for line in found]


def yours(figure):
    return np.concatenate([line.reshape(-1, 2) for line in lines(figure, ROLES["second"])])


# What they show


def test_the_students_numbers_are_drawn_where_they_belong():
    images = draw.image_against_object(85, [100, 200], [5, 6])
    assert yours(images).tolist() == [[100, 5], [200, 6]]
    assert yours(draw.aperture_branches(yours=(20, 1234))).tolist() == [[1234, 20]]
    assert yours(draw.blur_against_distance(c=0.01, yours=(7, 8))).tolist() == [
        [7, 0.01],
        [8, 0.01],
    ]
    limits = [(900, 1100), (1500, np.inf)]
    stars = yours(draw.ranges(focus=(1000, 2000), yours=limits))
    assert stars.tolist() == [[0.9, 0], [1.1, 0], [1.5, 1], [200, 1]]


def outside(figure):
    return (
        figure.axes[0].get_title(loc="right").removeprefix("your values lie outside the figure: ")
    )


def test_values_that_a_figure_cannot_show_are_written_above_it():
    images = draw.image_against_object(85, [100, 170, 200, 300, 500], [567, 5, -6, np.nan, 1e9])
    assert outside(images) == "5 mm, −6 mm, nan mm, …"
    assert outside(draw.aperture_branches(yours=(1200, 20))) == "N = 1200, D = 20 mm"
    assert outside(draw.ranges(yours=[(900, np.inf), (1500, -20044)])) == "−20.04 m"
    assert outside(draw.closeup(yours=(1e9, 0.01))) == "1e+09 mm"
    assert outside(draw.blur_against_distance(yours=(2133, 9000))) == "9000 mm"
    for seen in (draw.aperture_branches(yours=(20, 1200)), draw.closeup(yours=(511, 0.0123))):
        assert outside(seen) == ""


def test_a_focus_outside_of_the_zoom_is_written_beside_it():
    first, second, _ = draw.zoom(yours=[(-300, 0, 0), (150, 0, -90), None]).axes
    assert "yours: −300 mm,\nits focus at −273 mm" in [text.get_text() for text in first.texts]
    assert "yours: 150 mm" in [text.get_text() for text in second.texts]


def test_both_similar_triangles_of_a_cone_are_filled():
    for ax, Z in zip(
        draw.blur_cones(f=1.5, d=1.7, focus=5.0, far=9.0).axes, (3.2, 9.0), strict=True
    ):
        large, small = (patch.get_xy()[:3] for patch in ax.patches[:2])
        np.testing.assert_allclose(large[1], small[1])  # they meet in one point
        base, height = np.abs(large[0] - large[2])[1], abs(large[0] - large[1])[0]
        spot, beside = np.abs(small[0] - small[2])[1], abs(small[0] - small[1])[0]
        assert base / height == pytest.approx(spot / beside)
        assert spot == pytest.approx(optics.circle_of_confusion(Z, 5.0, 1.5, 1.5 / 1.7))


def test_the_wing_names_the_airy_disk_of_the_working_f_number():
    working = optics.working_f_number(16, optics.magnification(85, 2222))
    disk = optics.airy_diameter(views.WAVELENGTH, working) / views.PITCH
    assert f"Airy disk {disk:.1f} px everywhere" in draw.wing(N=16, focus=2.222).get_suptitle()


def test_rays_of_the_construction_meet_in_the_image():
    figure = draw.image_construction(f=2.0, Z=5.0, height=1.5)
    rays = lines(figure, ROLES["ray"])
    s = float(optics.image_distance(2, 5))
    assert len(rays) == 3
    for ray in rays:
        np.testing.assert_allclose(ray[-1], [s, -1.5 * s / 5])
    first, second, third = rays
    through = np.interp(0.0, [first[2, 1], first[1, 1]], [first[2, 0], first[1, 0]])
    assert through == pytest.approx(2.0)  # the focal point
    assert second[1, 1] == 0  # the middle of the lens
    assert np.interp(0.0, third[1::-1, 1], third[1::-1, 0]) == pytest.approx(-2.0)


def test_a_pixel_of_the_lecture_sees_eight_tenths_of_a_millimetre():
    (ax,) = draw.pixel_on_object(width=80, sensor_width=4, pixels=100).axes
    said = [text.get_text() for text in ax.texts]
    assert {"m = 1/20", "a pixel sees 0.8 mm", "100 pixels of 0.04 mm"} <= set(said)
    widths = [np.ptp(patch.get_xy()[:, 0]) for patch in ax.patches]
    assert widths[:2] == pytest.approx([80, 4])
    part = next(line for line in ax.lines if np.ptp(line.get_xdata()) == pytest.approx(4.0))
    assert np.ptp(part.get_xdata()) / 5 == pytest.approx(0.8)  # five pixels across


def test_spots_of_the_cones_are_circles_of_confusion():
    d, f, focus = 1.7, 1.5, 5.0
    figure = draw.blur_cones(f=f, d=d, focus=focus, near=3.2, far=9.0)
    for ax, Z in zip(figure.axes, (3.2, 9.0), strict=True):
        (spot,) = (line for line in ax.lines if line.get_color() == ROLES["image"])
        expected = optics.circle_of_confusion(Z, focus, f, f / d)
        assert np.ptp(spot.get_ydata()) == pytest.approx(expected)


def test_ranges_are_bars_from_the_near_to_the_far_limit():
    (ax,) = draw.ranges(f=24, N=8, c=0.006, focus=(1000, 20000)).axes
    near, far = optics.depth_of_field(24, 8, np.array([1000, 20000]), 0.006)
    first, second = ax.patches[:2]
    assert 1000 * first.get_x() == pytest.approx(near[0])
    assert 1000 * (first.get_x() + first.get_width()) == pytest.approx(far[0])
    assert 1000 * second.get_x() == pytest.approx(near[1])
    assert "∞" in [text.get_text() for text in ax.texts]


def test_branches_cross_at_the_best_focus():
    (ax,) = draw.aperture_branches(50, 1000, 1500, 0.02).axes
    near, far = (np.asarray(line.get_xydata()) for line in ax.lines[:2])
    crossing = near[np.argmin(np.abs(near[:, 1] - far[:, 1]))]
    N, D = optics.aperture_for_depth(50, 1000, 1500, 0.02)
    assert crossing == pytest.approx([D, N], rel=0.01)


def test_a_right_star_is_not_hidden_by_the_best_focus():
    N, D = optics.aperture_for_depth(50, 1000, 1500, 0.02)
    (ax,) = draw.aperture_branches(50, 1000, 1500, 0.02, yours=(N, D)).axes
    ring, star = (line for line in ax.lines if np.allclose(line.get_xydata(), (D, N)))
    assert ring.get_markerfacecolor() == "none"
    assert ring.get_markersize() > star.get_markersize()


def test_a_wrong_star_stays_off_the_words():
    far_left, right = (-300, 0, 0), (150, 0, -90)
    (first, second, _) = draw.zoom(yours=[far_left, right, None]).axes
    stars = [[x for x in ax.lines if x.get_marker() == "*"] for ax in (first, second)]
    assert [len(found) for found in stars] == [0, 1]


def test_window_marks_the_smallest_sum():
    (ax,) = draw.sweet_spot(85, 2000, 2500).axes
    total, mark = (np.asarray(line.get_xydata()) for line in ax.lines if line.get_color() == BLACK)
    assert mark[0, 1] == total[:, 1].min()
    focus = optics.aperture_for_depth(85, 2000, 2500, 0.01)[1]
    best = optics.sharpest_f_number(2000, focus, 85, 0.00055)
    assert mark[0, 0] == pytest.approx(best, rel=0.04)


def test_disks_of_the_stops_halve_their_area():
    (ax,) = draw.stops(50, count=5).axes
    widths = np.array([np.ptp(patch.get_xy()[:, 0]) for patch in ax.patches])
    np.testing.assert_allclose(widths[0], 50 / np.sqrt(2), rtol=1e-3)
    np.testing.assert_allclose(widths[:-1] ** 2 / widths[1:] ** 2, 2, rtol=1e-3)


def test_two_lenses_bend_a_ray_like_the_one_in_the_principal_plane():
    figure = draw.principal_planes(50, -30, 30)
    (plane,) = lines(figure, ROLES["second"])
    ray = lines(figure, ROLES["ray"])[0]
    (x, y), (end, zero) = ray[-2:]
    slope = (zero - y) / (end - x)
    assert zero + slope * (plane[0, 0] - end) == pytest.approx(ray[0, 1])
    assert end - plane[0, 0] == pytest.approx(150)


# Pictures through the lens


def contrast(picture, radius=12.0):
    """Return how far the star's spokes stand out on a circle around its middle."""
    turn = np.linspace(0, 2 * np.pi, 720, endpoint=False)
    middle = (views.SHOWN - 1) / 2
    u = np.rint(middle + radius * np.cos(turn)).astype(int)
    v = np.rint(middle + radius * np.sin(turn)).astype(int)
    return float(np.std(picture[v, u, 0].astype(float)))


def test_sharpest_aperture_of_the_series_is_the_computed_one():
    numbers = (1.4, 4, 8, 16, 32, 64)
    seen = [contrast(views.through_lens(2.0, 2.2, 85, N)) for N in numbers]
    best = optics.sharpest_f_number(2000, 2200, 85, views.WAVELENGTH)
    nearest = int(np.argmin(np.abs(np.log(np.array(numbers) / best))))
    assert int(np.argmax(seen)) == nearest == 3


def test_marker_in_focus_is_sharper_than_those_before_and_behind():
    near, focus, far = (contrast(views.through_lens(Z, 2.2, 85, 2.8)) for Z in (2.1, 2.2, 2.3))
    assert focus > 2 * max(near, far)


def test_defocus_is_a_disk_of_the_size_of_the_circle_of_confusion():
    Z, focus, f, N = 2.4, 2.2, 85, 2.8
    sharp = views._sharp(views.MARKER * optics.image_distance(f, 1000 * focus) / 2400 / views.PITCH)
    spot = optics.circle_of_confusion(1000 * Z, 1000 * focus, f, N) / views.PITCH * views.FINE
    x = np.arange(-30, 31)
    disk = (np.hypot(x, x[:, None]) <= spot / 2).astype(float)
    blurred = fftconvolve(sharp[..., 0], disk / disk.sum(), mode="same")
    inside = slice(views.MARGIN, -views.MARGIN)
    pixels = blurred[inside, inside].reshape(views.SHOWN, views.FINE, views.SHOWN, views.FINE)
    seen = views.through_lens(Z, focus, f, N)[..., 0].astype(float)
    assert np.abs(seen - pixels.mean(axis=(1, 3))).mean() < 2


def test_marker_has_the_size_that_the_lens_gives_it():
    picture = views.through_lens(2.2, 2.2, 85, 5.6).astype(float)
    side = views.MARKER * float(optics.magnification(85, 2200)) / views.PITCH
    top = round((views.SHOWN - side) / 2) + 2  # a row of its rim, above the star
    assert np.count_nonzero(picture[top, :, 0] > 193) == pytest.approx(side, abs=1.5)
