"""The numbers that the text of chapter 05 states are those that the library computes."""

import cv2
import numpy as np
import pytest
from lesson_text import about, lesson_text, read
from real_data import fetched

from course_lib import distortion
from course_lib.drawing.distortion import boards
from course_lib.drawing.distortion.fields import CLASSIC_K, CLASSIC_LENS
from course_lib.drawing.distortion.fisheye import things
from course_lib.drawing.distortion.mapping import TRIED, fixed_point, image_and_slope, newton
from course_lib.drawing.explorers.distortion import NAMES, distortion_frame
from course_lib.drawing.explorers.undistort import undistort_frame
from data_generators import rails

says = lesson_text("05_distortion").says
K, LENS = rails.K, rails.LENS


@pytest.fixture(scope="module")
def real():
    """Skip where the real photographs are not to be had."""
    fetched(boards.SHOWN)
    assert boards.board_photograph()[1]


# The rails


def arrow(line):
    """Return how far the middle of a line is above the chord, px."""
    chord = np.interp(line[:, 0], line[[0, -1], 0], line[[0, -1], 1])
    off = chord - line[:, 1]
    return float(off[np.argmax(np.abs(off))])


def test_rails_as_photographed_and_as_they_are():
    lines = rails.rail_points(rails.photograph())
    pitch = rails.DISTANCE / K[0, 0]
    assert pitch == about(1.9, 1)
    a, b, c = map(arrow, lines)
    assert (a, c) == (pytest.approx(9.8, abs=0.2), pytest.approx(-9.8, abs=0.2))
    assert abs(b) == about(0.2, 1)
    assert a * pitch == about(18, 0)
    ideal = [distortion.undistort_pixels(line, K, LENS) for line in lines]
    straight = [distortion.straightness(line) for line in ideal]
    assert straight[::2] == [about(0.02, 2)] * 2
    assert arrow(ideal[1]) == about(4.57, 2)
    assert arrow(ideal[1]) * pitch == about(8.5, 1)
    assert arrow(ideal[1]) * pitch > 4 * 2
    found = distortion.distortion_from_lines(lines[::2], K).coefficients
    assert found == about(np.array([-0.310, 0.120]), 3)
    says(
        "One pixel sees 1.9 mm",
        "straight to 0.2 px",
        "almost 10 px away, which is 18 mm",
        "more than four times the tolerance",
        "straight to 0.02 px (RMS)",
        "4.57 px, or 8.5 mm",
        "−0.310 and 0.120",
    )


# One coefficient, five coefficients


def test_worked_point():
    bent = distortion.distort([0.5, 0.25], [-0.2])
    assert bent == about(np.array([0.4688, 0.2344]), 4)
    pixel = distortion.pixels_from_normalised(bent, K)
    ideal = distortion.pixels_from_normalised([0.5, 0.25], K)
    assert ideal.tolist() == [610, 370]
    assert pixel == about(np.array([593.3, 361.6]), 1)
    assert np.hypot(*(ideal - pixel)) == about(18.7, 1)
    says("$1 - 0.2\\cdot 0.3125 = 0.9375$", "$x_d = 0.4688$", "(593.3, 361.6)", "by 18.7 px")


def test_pixels_bent_by_mistake():
    du, dv = 610 - 342, 370 - 236
    assert (du, dv, du**2 + dv**2) == (268, 134, 89_780)
    assert 1 - 0.2 * 89_780 == -17_955
    says("$r^2 = 89\\,780$", "$1 - 17\\,956 = -17\\,955$")


def test_tangential_point():
    moved = distortion.distort([0.5, 0.25], [0, 0, 0.001, 0]) - (0.5, 0.25)
    assert moved == about(np.array([0.00025, 0.00044]), 5)
    assert 536 * moved == about(np.array([0.13, 0.23]), 2)
    says("0.00025", "= 0.00044$", "0.13 and 0.23")


def test_published_field():
    u, v = np.meshgrid(np.arange(0, 640, 32), np.arange(0, 480, 24))
    grid = np.stack([u.ravel(), v.ravel()], axis=1)
    for part, largest, corner, digits in (
        ("complete", 28.9, 33.8, 1),
        ("tangential", 0.154, 0.168, 3),
    ):
        moved = np.hypot(*distortion.displacement_field(grid, CLASSIC_K, CLASSIC_LENS, part).T)
        assert moved.max() == about(largest, digits)
        assert grid[moved.argmax()].tolist() == [608, 0]
        last = distortion.displacement_field([639, 0], CLASSIC_K, CLASSIC_LENS, part)
        assert np.hypot(*last) == about(corner, digits)
    assert pytest.approx(200, rel=0.02) == 33.8 / 0.168
    says("**28.9 px** and **0.154 px**", "33.8 px and 0.168 px", "25 pixels", "0.14 pixel")


def explored(**coefficients):
    return distortion_frame(**dict.fromkeys(NAMES, 0.0) | coefficients)


def test_distortion_explorer_shows_what_the_text_says():
    assert read(explored(k1=-0.3), "Corner moves by") == about(41, 0)
    assert read(explored(k1=-0.3, k2=0.43), "Corner moves by") <= 0.5
    words = explored(p1=0.02).pictures[0].alt
    assert "upper edge is bent outwards" in words
    assert "lower edge bent inwards" in words
    assert "No ray reaches the corners" not in explored(k1=-0.21).pictures[0].alt
    assert "No ray reaches the corners" in explored(k1=-0.22).pictures[0].alt
    says("By 41 px. With $k_2 = 0.43$", "From about $k_1 = -0.22$ on", "upper one bulges outwards")


# The way back, and how far


def test_guesses():
    guesses = fixed_point(0.475, -0.2, 3)
    assert guesses[1:] == about(np.array([0.4964, 0.4995, 0.4999]), 4)
    assert about(0.4536, 4) == 0.475 * (1 - 0.2 * 0.475**2)
    says("goes to 0.4536 and misses by 0.0214", "= 0.4964$, the one after it 0.4995, then 0.4999")


def test_where_each_method_fails():
    assert image_and_slope(0.475, -0.2)[1] == about(0.865, 3)
    assert newton(0.475, -0.2, 1)[1] == about(0.4998, 4)
    says("$1 - 0.6\\cdot 0.475^2 = 0.865$", "$0.475 + 0.0214/0.865 = 0.4998$")
    (_, mild, near), (_, strong, _), (_, folding, far) = TRIED
    slopes = [image_and_slope(near, k)[1] for k in (mild, strong)]
    assert slopes == [about(0.71, 2), about(2.18, 2)]
    assert 1 - np.array(slopes) == about(np.array([0.29, -1.18]), 2)
    errors = fixed_point(image_and_slope(near, mild)[0], mild, 8) - near
    assert errors[8] / errors[7] == about(0.29, 2)
    says("That is $0.29$ for", "the slope is 2.18 and the factor $-1.18$")
    assert distortion.valid_radius([*folding, 0, 0]) == about(1.21, 2)
    image = image_and_slope(far, folding)[0]
    assert image == about(1.28, 2)
    assert image_and_slope(image, folding)[1] < 0
    assert newton(image, folding, 20)[-1] == about(1.30, 2)
    assert fixed_point(image, folding, 60)[-1] == pytest.approx(far)
    assert distortion.undistort_points([image, 0], [*folding, 0, 0])[0] == pytest.approx(far)
    says("folds over at $r = 1.21$", "imaged at 1.28", "goes to $r = 1.30$", "finds 1.1.")


@pytest.mark.parametrize(("k", "error"), [(LENS[:4], 0.06), ((-0.4, 0.15, 0, 0), 0.5)])
def test_five_rounds_of_opencv_are_not_enough(k, error):
    pixels = distortion.pixel_grid(rails.SIZE, 33, 25).reshape(-1, 2)
    theirs = cv2.undistortPoints(pixels[:, None], K, np.array(k))[:, 0]
    ours = distortion.undistort_points(distortion.normalised_from_pixels(pixels, K), k)
    off = 536 * np.hypot(*(ours - theirs).T)
    assert off.max() == pytest.approx(error, rel=0.06)
    says("an error of 0.06 px for our lens, and of half a pixel for $k_1 = -0.4$, $k_2 = 0.15$")


def test_valid_radius():
    limit = distortion.valid_radius([-0.31])
    assert limit == about(1.04, 2)
    assert np.degrees(np.arctan(limit)) == about(46, 0)
    assert distortion.valid_radius([-0.31, 0.12]) == np.inf
    assert distortion.valid_radius([-0.5, 0.1]) == pytest.approx(1)
    corners = distortion.pixel_grid(rails.SIZE, 2, 2).reshape(-1, 2)
    assert np.hypot(*distortion.normalised_from_pixels(corners, K).T).max() == about(0.78, 2)
    assert distortion.distort([limit, 0], [-0.31])[0] == about(0.69, 2)
    assert distortion.undistort_points([0.7827, 0], LENS)[0] == about(0.96, 2)
    says("so $r = 1.04$", "an angle of 46° with the axis", "its corners are at $r_d = 0.78$")
    says("top is at $r_d = 0.69$", "is at $r = 0.96$")


def test_map_of_the_first_pixel():
    u, v = distortion.undistortion_map(K, LENS, (2, 2), dtype=float)
    assert (u[0, 0], v[0, 0]) == (about(48.9, 1), about(33.7, 1))
    says("looks at (48.9, 33.7)")


def test_border_of_the_wider_picture():
    wider = K.copy()
    wider[[0, 1], [0, 1]] *= 0.8
    u, v = distortion.undistortion_map(K, LENS, rails.SIZE, new_K=wider)
    seen = (u >= 0) & (u <= 639) & (v >= 0) & (v <= 479)
    assert 1 - seen.mean() == about(0.17, 2)
    assert np.flatnonzero(seen[:, 342])[0] == 35
    ends = distortion.undistort_pixels([[0, 0], [639, 0]], K, LENS, new_K=wider)[:, 1]
    assert ends == pytest.approx(10, abs=5)
    says("35 px above, but about 10 px at the ends", "17 % of the picture")


def test_decentred_points():
    moved = distortion.distort([[0.6, 0.4], [-0.6, -0.4]], [0, 0, 0.05, 0.03])
    moved -= [[0.6, 0.4], [-0.6, -0.4]]
    np.testing.assert_allclose(moved[0], moved[1])
    other = distortion.distort([0.6, -0.4], [0, 0, 0.05, 0.03]) - (0.6, -0.4)
    assert np.hypot(*other) < 0.5 * np.hypot(*moved[0])
    says("the lower right and the upper left corner, by the same amount and in the same direction")


# Straight lines


def test_straightness_of_three_points():
    assert distortion.straightness([[0, 0], [1, 0.3], [2, 0]]) == about(0.141, 3)
    says("is 0.06 for these three points", "mean is 0.02", "is 0.141")


@pytest.mark.usefixtures("real")
def test_thirteen_photographs():
    lines = boards.all_lines()
    found = distortion.distortion_from_lines(lines, K)
    assert found.coefficients == about(np.array([-0.308, 0.131]), 3)
    assert found.sigma == about(np.array([0.002, 0.006]), 3)
    assert found.rms == about(0.06, 2)
    assert (np.abs(found.coefficients - LENS[:2]) < 2 * found.sigma).all()
    longer = K.copy()
    longer[[0, 1], [0, 1]] = 800
    other = distortion.distortion_from_lines(lines, longer)
    assert other.coefficients == about(np.array([-0.69, 0.65]), 2)
    assert other.rms == pytest.approx(found.rms)
    says("$k_1 = -0.308 \\pm 0.002$, $k_2 = 0.131 \\pm 0.006$", "they are −0.69 and 0.65")
    says("the lines are straight to 0.06 px")


@pytest.mark.usefixtures("real")
def test_most_bent_line():
    lines = boards.board_lines(boards.board_photograph()[0])
    assert boards.most_bent(lines) == 0
    u, _ = np.transpose(lines[0])
    assert u.min() > 540  # near the right edge
    assert sorted(np.argsort([distortion.straightness(line) for line in lines])[:2]) == [9, 10]
    assert np.abs(np.mean([lines[9], lines[10]], axis=(0, 1)) - K[:2, 2])[1] < 30
    says("near the right edge", "near the centre (10 and 11) are almost straight")


def all_lines_after(photograph, k1, k2=0.0):
    return read(undistort_frame(photograph, k1, k2), "From straight, all lines, RMS")


@pytest.mark.usefixtures("real")
@pytest.mark.parametrize(
    ("photograph", "before", "k1", "alone", "pair", "both"),
    [
        ("board on the right", 0.780, -0.25, 0.059, (-0.29, 0.10), 0.033),
        ("large board", 0.863, -0.26, 0.068, (-0.30, 0.10), 0.045),
    ],
)
def test_undistort_explorer_shows_what_the_text_says(photograph, before, k1, alone, pair, both):
    assert all_lines_after(photograph, 0) == about(before, 3)
    tried = np.arange(-0.4, -0.1, 0.01)
    best = min(tried, key=lambda k: all_lines_after(photograph, k))
    assert best == pytest.approx(k1, abs=0.006)
    assert all_lines_after(photograph, k1) == about(alone, 3)
    assert all_lines_after(photograph, *pair) == about(both, 3)
    says(f"from {before:.3f} px", f"to {alone:.3f} px", f"{both:.3f} px", "0.780 px before, 0.033")


def test_the_computed_photograph_starts_elsewhere():
    lines = boards.board_lines(boards.computed_board())
    before = np.sqrt(np.mean([distortion.straightness(line) ** 2 for line in lines]))
    assert before == about(0.992, 3)
    says("The computed one starts from 0.992 px.")


# Fisheye


def test_fisheye_numbers():
    K200 = np.array([[200.0, 0, 0], [0, 200, 0], [0, 0, 1]])
    assert distortion.fisheye_project([1, 0, 1], K200, np.zeros(4))[0] == about(157, 0)
    assert np.radians(45) == about(0.785, 3)
    first = things()[0]
    assert np.degrees(np.arccos(first[2] / np.linalg.norm(first))) == about(71, 0)
    says("images it 157 px from the centre, a pinhole 200 px", "It is 71° from the axis")


# Other forms


def test_division_model_example():
    assert distortion.undistort_division([0.5, 0], -0.25)[0] == about(0.533, 3)
    says("$\\lambda = -0.25$ sends 0.5 to $0.5/0.9375 = 0.533$")


def test_first_term_of_ebner():
    assert distortion.ebner([10, 20], [0.001, *np.zeros(11)], 100) == about([0.01, -0.02], 2)
    says("$(b_1x, -b_1y)$", "with $b_1 = 0.001$ it moves the point (10, 20) by (0.01, −0.02)")


def test_rational_and_prism_example():
    k, p, s = [0, 0, 0, 1, 0, 0], [0, 0.01], [0.002, 0, 0, 0]
    assert distortion.distort_rational_prism([1, 0], k, p, s)[0] == pytest.approx(0.532)
    says("$x_d = 0.5 + 0.03 + 0.002 = 0.532$")


def test_conversion_to_the_photogrammetric_form():
    f, k = 536.0, [-0.31, 0.12, 0.001, -0.002, 0.01]
    alpha, tangential = distortion.photogrammetric_from_opencv(k, f)
    assert alpha == pytest.approx([-0.31 / f**2, 0.12 / f**4, 0.01 / f**6])
    assert tangential == pytest.approx([0.001 / f, -0.002 / f])
    says("$\\alpha = k_1/f^2$, $\\beta = k_2/f^4$, $\\gamma = k_3/f^6$", "$P_1 = p_1/f$")
