"""The numbers that the text of chapter 03 states are those that the library computes."""

import ast

import numpy as np
import pytest
from lesson_text import LESSONS, about, lesson_text, read

from course_lib import optics
from course_lib.authoring.lesson import read_lesson
from course_lib.drawing.explorers.aperture_window import best_aperture
from course_lib.drawing.explorers.depth_of_field import depth_of_field_frame
from course_lib.drawing.explorers.ray_tracer import ray_tracer_frame
from course_lib.widgets.lenses import two_lens_explorer

TEXT = lesson_text("03_lenses")
says = TEXT.says

PITCH, GREEN = 27.6 / 2048, 0.00055  # mm
F, NEAR, FAR = 85, 2000, 2500  # the wing, mm


# Published worked numbers


def test_published_working_distance():
    assert optics.object_distance(35.7, 0.05) == about(749.7, 1)
    says("$m = 0.05$ and $f = 35.7$ mm", "749.7 mm; printed is 750")
    others = [optics.object_distance(f, 0.05) for f in (8, 16, 75)]
    assert others == [about(168, 0), about(336, 0), about(1575, 0)]
    says("168, 336, 749.7 and 1575 mm")


def test_published_magnification():
    assert 4 / 80 == 1 / 20
    assert optics.pixel_on_object(4 / 100, 4 / 80) == about(0.8, 1)
    says("m = 4/80 = 1/20", "4 mm/100 = 0.04 mm", "0.04 \\cdot 20 = 0.8$ mm")


def test_openings_of_the_lecture():
    assert optics.f_number(200, 50) == 4
    assert optics.aperture_diameter(40, 8) == 5
    says("an opening of 50 mm has $N = 4$", "A 40 mm lens at f/8 has an opening of $40/8 = 5$ mm")


def test_close_up_depths_of_the_lectures():
    small, microscope = optics.closeup_depth_of_field([1 / 20, 100], 16, 0.038)
    assert small == about(511, 0)
    assert 1000 * microscope == about(12, 0)
    says("the depth is 511 mm", "it is 12 µm", "$c = 0.038$ mm")
    near, far = optics.depth_of_field(35.7, 16, optics.object_distance(35.7, 1 / 20), 0.038)
    assert far - near == about(578, 0)
    says("for $f = 35.7$ mm is 578 mm")
    working = optics.working_f_number(16, 100)
    assert working == 1616
    assert optics.airy_diameter(GREEN, working) == about(2.2, 1)
    says("= 1616$", "over 2.2 mm of the sensor")


def test_hyperfocal_limits_of_the_lecture():
    H = optics.hyperfocal_distance(24, 8, 0.006)
    assert H == 12024
    near, far = optics.depth_of_field(24, 8, H, 0.006)
    assert (near, far) == (pytest.approx(H / 2), np.inf)
    says("$H = 24^2/(8 \\cdot 0.006) + 24 = 12\\,024$ mm", "everything from half of $H$")
    says("dropped, since it is small: 12 000 mm")
    meant = [optics.hyperfocal_distance(f, 8, 0.006) / 1000 for f in (12, 24, 50, 85)]
    assert meant == [about(3.0, 1), about(12.0, 1), about(52.1, 1), about(150.6, 1)]
    says("3.0, 12.0, 52.1 and 150.6 m")


def test_name_of_the_lecture():
    parts = optics.parse_lens_name("Nikkor 18-140mm 1:3.5-5.6")
    assert parts == {"focal_length": (18, 140), "f_number": (3.5, 5.6)}
    says("f/3.5 at 18 mm and to f/5.6 at 140 mm")


# Light and images


def test_light_of_a_lens():
    area = (25 / 0.35) ** 2
    assert area == pytest.approx(5100, rel=0.01)
    assert area / 10 == pytest.approx(500, rel=0.03)
    says("= 5100$ times", "now takes 1/500 s")
    assert optics.stops_between(1.4, 16) == about(7, 0)
    assert pytest.approx(130, abs=1) == (16 / 1.4) ** 2
    assert about(5.66, 2) == 2**2.5
    says("seven stops", "= 128$", "about 130 times", "f/5.66")


def test_power():
    assert optics.optical_power(50) == 20
    assert optics.optical_power(85) == about(11.8, 1)
    says("= 20$ dioptres", "only 11.8")


def test_image_of_the_lens():
    s = optics.image_distance(85, 1000)
    assert s == about(92.9, 1)
    assert s - 85 == about(7.9, 1)
    says("$s = 92.9$ mm", "must travel 7.9 mm")
    assert optics.image_distance(100, 200) == 200
    assert optics.magnification(100, 200) == 1
    assert optics.working_f_number(8, 1) == 16
    focus = optics.aperture_for_depth(F, NEAR, FAR, PITCH)[1]
    assert optics.magnification(F, focus) == about(0.04, 2)
    says("200 mm from the object, and 200 mm from the sensor", "works like f/16", "$m = 0.04$")


@pytest.mark.parametrize(("Z", "s", "m"), [(120, 120, -1), (65, 780, -12), (40, -120, 3)])
def test_ray_tracer_shows_what_the_text_says(Z, s, m):
    frame = ray_tracer_frame(Z, 60)
    assert read(frame, "Image behind the lens") == s
    assert read(frame, "Magnification") == m


def test_ray_tracer_at_the_focal_point_and_as_a_telescope():
    parallel = ray_tracer_frame(60, 60)
    assert read(parallel, "Image behind the lens") == np.inf
    assert "no image" in parallel.pictures[0].alt
    start = two_lens_explorer()
    assert read(start.frame_now(), "Focal length of the whole") == 150
    assert read(start.frame_now(), "Image behind the last lens") == 60
    start.set(d=20)
    assert read(start.frame_now(), "Focal length of the whole") == np.inf
    assert read(start.frame_now(), "Image behind the last lens") == np.inf
    says(
        "At first it meets 60 mm behind the second lens",
        "$d = 20$ mm, which is $f_1 + f_2$",
        "it is 780 mm away and 12 times as large",
    )


# Blur and depth


def test_spot_of_the_wing():
    spot = optics.circle_of_confusion(NEAR, 2200, F, 1.4)
    assert spot == about(0.244, 3)
    assert spot / PITCH == about(18.1, 1)
    assert about(0.0135, 4) == PITCH
    says("a spot of 0.244 mm", "**18.1 pixels**", "0.0135 mm wide")


def test_depth_of_the_wing():
    near, far = optics.depth_of_field(F, 8, 2200, PITCH)
    assert (near, far, far - near) == (about(2133, 0), about(2272, 0), about(139, 0))
    a = 8 * PITCH * (2200 - F) / F**2
    assert a == about(0.0316, 4)
    assert (near, far) == (pytest.approx(2200 / (1 + a)), pytest.approx(2200 / (1 - a)))
    says("$a = 0.0316$", "2133 mm to 2272 mm", "139 mm of the 500 mm")
    near, far = optics.depth_of_field_approximate(F, 8, 2200, PITCH)
    assert (near, far, far - near) == (about(2130, 0), about(2275, 0), about(145, 0))
    says("2130 mm to 2275 mm, a range of 145 mm")


@pytest.mark.parametrize(("times", "percent"), [(100, 1), (10, 11)])
def test_error_of_the_approximation(times, percent):
    exact, rough = (
        np.diff(limits(F, 8, times * F, PITCH))
        for limits in (optics.depth_of_field, optics.depth_of_field_approximate)
    )
    assert 100 * (rough / exact - 1) == about(percent, 0)
    says("At 100 focal lengths the depth is 1 % too large, at 10 focal lengths 11 %")


def sharp(N, focus, f=50):
    """Return near limit, far limit and depth in the explorer, m."""
    frame = depth_of_field_frame(f, N, focus, 50)
    return [read(frame, label) for label in ("Near limit", "Far limit", "Depth of field")]


def test_depth_explorer_shows_what_the_text_says():
    near, far, depth = sharp(2.8, 3.5)
    assert near > 2
    assert far < 7
    assert depth == about(1.40, 2)
    assert sharp(11, 3.5)[:2] == [about(1.99, 2), about(14.5, 1)]
    assert sharp(2.8, 3.5, f=100)[2] == about(0.33, 2)
    says("2.0 m to 14.5 m", "1.40 m to 0.33 m")


# The window


def test_aperture_of_the_wing():
    N, D = optics.aperture_for_depth(F, NEAR, FAR, PITCH)
    assert (about(27.9, 1), about(2222, 0)) == (N, D)
    half_way, _ = optics.apertures_for_limits(F, NEAR, FAR, 2250, PITCH)
    assert half_way == about(31, 0)
    working = optics.working_f_number(N, optics.magnification(F, D))
    assert optics.airy_diameter(GREEN, working) / PITCH == about(2.9, 1)
    says("$D = 2222$ mm and **$N = 27.9$**", "would need f/31", "the Airy disk alone has 2.9 px")


def test_airy_disks():
    disks = 1000 * optics.airy_diameter(GREEN, np.array([4, 8, 22]))
    assert disks.tolist() == [about(5.4, 1), about(10.7, 1), about(29.5, 1)]
    assert about(10, 0) == PITCH / (2.44 * GREEN)
    assert about(2.6, 1) == 0.00345 / (2.44 * GREEN)
    says("5.4 µm at f/4, 10.7 µm at f/8 and 29.5 µm at f/22", "begins at f/10", "begins at f/2.6")


def k_of_the_wing(depth):
    """Return the defocus at f/1 of the ends of a range that begins where the wing does, mm."""
    _, focus = optics.aperture_for_depth(F, NEAR, NEAR + depth, PITCH)
    return optics.circle_of_confusion(NEAR, focus, F, 1)


def test_best_apertures():
    assert optics.sharpest_f_number(2000, 2200, F, GREEN) == pytest.approx(16, rel=0.03)
    k, half = k_of_the_wing(500), k_of_the_wing(250)
    assert (k, half) == (about(0.376, 3), about(0.209, 3))
    assert np.sqrt(k / (2.44 * GREEN)) == about(16.7, 1)
    best, best_half = best_aperture(F, 2.0, 0.5), best_aperture(F, 2.0, 0.25)
    assert (best, best_half) == (about(16.4, 1), about(12.2, 1))
    assert best / np.sqrt(2) == about(11.6, 1)
    says(
        "$k = 0.376$ mm", "The box gives f/16.7", "finds f/16.4", "our wing, $k = 0.376$ mm: f/16.7"
    )
    says("from f/16.4 to f/12.2", "$16.4/\\sqrt 2 = 11.6$", "0.376 mm to 0.209 mm only")


def test_one_stop_from_the_best_costs_little():
    one, other = np.sqrt(2), 1 / np.sqrt(2)  # of equal blurs, one grows and one shrinks
    assert 100 * ((one + other) / 2 - 1) == about(6, 0)
    says("one stop more or less costs 6 %")


@pytest.mark.parametrize(("f", "pixels"), [(85, 3.4), (50, 2.0)])
def test_what_no_setting_can_do(f, pixels):
    focus = optics.aperture_for_depth(f, NEAR, FAR, PITCH)[1]
    best = optics.sharpest_f_number(NEAR, focus, f, GREEN)
    m = optics.magnification(f, focus)
    airy = optics.airy_diameter(GREEN, optics.working_f_number(best, m))
    blur = optics.circle_of_confusion(NEAR, focus, f, best) + airy
    assert blur / PITCH == about(pixels, 1)
    assert airy / PITCH == about(pixels / 2, 1)
    assert blur / m == about(1.15, 2)
    assert f / best == about(5.2, 1)
    says("its best is 2.0 px", "blur over 1.15 mm", "it is 5.2 mm for both")
    says("1.7 px of defocus and 1.7 px of diffraction at the ends: 3.4 px", "3.4 px is no disaster")


def test_one_pixel_of_each_blur_makes_two():
    N, D = optics.aperture_for_depth(50, NEAR, FAR, PITCH)
    working = optics.working_f_number(N, optics.magnification(50, D))
    assert about(9.5, 1) == N
    assert optics.airy_diameter(GREEN, working) / PITCH == about(1, 1)
    says("needs only f/9.5")


def test_pinhole_instead_of_the_lens():
    s = optics.image_distance(F, 2200)
    hole = optics.best_pinhole_diameter(s, GREEN)
    blur = 2 * hole / PITCH  # hole and Airy disk are equally wide
    assert optics.airy_diameter(GREEN, s / hole) == pytest.approx(hole)
    assert blur == about(51, 0)
    assert blur > 2 * optics.circle_of_confusion(FAR, 2200, F, 1.4) / PITCH
    says("a point is 51 pixels wide", "behind the best hole")


def test_focus_on_the_stars_gives_half_of_the_range_away():
    near, far = optics.depth_of_field(24, 8, np.inf, 0.006)
    assert near == pytest.approx(24**2 / (8 * 0.006))
    assert far == np.inf
    says("the near limit moves out to $f^2/(N c)$")


# The notebook


def test_no_cell_leaves_a_letter_of_a_formula_behind():
    """A forgotten parameter is then a NameError, and not a number from another section."""
    lesson = read_lesson(LESSONS / "03_lenses.md")
    trees = [ast.parse(cell.source) for cell in lesson.cells if cell.role == "code"]
    names = {node.id for tree in trees for node in ast.walk(tree) if is_assigned(node)}
    assert {"places", "distances"} <= names
    assert not [name for name in names if len(name) == 1]


def is_assigned(node):
    return isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)


# Lenses in a row


def test_two_lenses():
    f, _, back = optics.lens_system(50, -30, 30)
    assert f == pytest.approx(150)
    assert 30 + back + f == pytest.approx(90)
    assert back == pytest.approx(-90)
    system = optics.thin_lens(-30) @ optics.free_space(30) @ optics.thin_lens(50)
    assert system[:, 0] == pytest.approx([0.4, -1 / 150])
    says("act like a 150 mm lens", "only 90 mm behind the first lens")
    says("$A = 1 - d/f_1 = 0.4$ and $C = -1/150$, so $H'$ is $0.6 \\cdot (-150) = -90$ mm")
    zoomed = [optics.lens_system(50, -30, d)[0] for d in (27, 35)]
    assert zoomed == [about(214, 0), about(100, 0)]
    says("from 214 mm to 100 mm")


def test_ray_through_the_focal_point():
    height, _ = optics.free_space(50) @ optics.thin_lens(50) @ (3, 0)
    assert height == pytest.approx(0)
