"""The figures of chapter 05: each draws, says what its axes are, and shows the right thing."""

import matplotlib as mpl
import numpy as np
import pytest
from legible import Legible
from straightening import LENS, bent, coloured, ideal_rails, straightened

mpl.use("Agg")  # as a test has no screen

from course_lib import distortion
from course_lib.drawing import distortion as draw
from course_lib.drawing.distortion import mapping, pictures
from course_lib.drawing.style import BLACK
from data_generators import rails

GRID = distortion.pixel_grid((640, 480), 5, 4).reshape(-1, 2)
GRID = distortion.normalised_from_pixels(GRID, rails.K)


FIGURES = {
    "barrel_and_pincushion": draw.barrel_and_pincushion,
    "before_and_after": lambda: draw.before_and_after(*straightened()),
    "before_and_after part": lambda: draw.before_and_after(*straightened(), part=(340, 639)),
    "bent_lines": lambda: bent(np.arange(15) / 9),
    "doubled_corners": draw.doubled_corners,
    "displacement_fields": draw.displacement_fields,
    "fisheye_photograph": draw.fisheye_photograph,
    "fisheye_street": lambda: draw.fisheye_street(np.full((5, 2), 200.0)),
    "forward_and_backward": draw.forward_and_backward,
    "iterations": draw.iterations,
    "moved_points": lambda: draw.moved_points(GRID, LENS, GRID),
    "moved_points back": lambda: draw.moved_points(0.8 * GRID, LENS, back=True),
    "profiles": draw.profiles,
    "profiles yours": lambda: draw.profiles([(-0.31, 0), (-0.5, 0.1)], yours=[1.0, 1.1]),
    "rails": draw.rails,
    "straightened_rails": lambda: draw.straightened_rails(ideal_rails(), [0.02, 1.37, 0.02]),
    "straightened_rails none": lambda: draw.straightened_rails([]),
    "where_it_acts": draw.where_it_acts,
}


@pytest.fixture(params=FIGURES)
def figure(request):
    drawn = FIGURES[request.param]()
    drawn.draw_without_rendering()
    return drawn


class TestEachFigure(Legible):
    UNITS = ("px", "no unit", "°", "focal lengths")
    WHITE_ON_DARK = True


def test_every_function_is_tried_here():
    assert {name.split()[0] for name in FIGURES} == set(draw.__all__)


@pytest.mark.parametrize(
    "yours", [None, "left", [1, 2, 3], np.full((2, 2), np.nan), {}, [None] * 2]
)
def test_what_a_student_cannot_have_meant_is_not_drawn_or_does_no_harm(yours):
    picture, _, lines = straightened()
    draw.moved_points(GRID, LENS, yours).draw_without_rendering()
    draw.before_and_after(picture, yours, lines).draw_without_rendering()
    draw.fisheye_street(yours).draw_without_rendering()
    draw.straightened_rails([yours] * 3, [yours] * 3).draw_without_rendering()
    draw.straightened_rails(ideal_rails(), [yours] * 3).draw_without_rendering()
    draw.profiles([(-0.31, 0), (-0.5, 0.1)], yours=[yours, yours]).draw_without_rendering()


# What they show


def test_students_points_are_drawn_where_they_are():
    (ax,) = draw.moved_points(GRID, LENS, GRID + 0.01).axes
    (stars,) = coloured(ax, "second")
    np.testing.assert_allclose(stars, GRID + 0.01)


@pytest.mark.parametrize("back", [False, True])
def test_circles_are_where_the_lens_or_its_inverse_puts_the_points(back):
    points = 0.7 * GRID
    (ax,) = draw.moved_points(points, LENS, back=back).axes
    (circles,) = coloured(ax, "object")
    start, end = (circles, points) if back else (points, circles)
    np.testing.assert_allclose(distortion.distort(start, LENS), end, atol=1e-9)


def test_lines_of_the_house_bulge_as_their_lens_says():
    barrel, pinhole, pincushion = draw.barrel_and_pincushion().axes

    def bulge(ax):
        """Return how far the middle of the lowest drawn level line lies below its ends."""
        level = [line for line in coloured(ax, "object") if np.ptp(line[:, 0]) > 200]
        lowest = max(level, key=lambda line: line[len(line) // 2, 1])
        return lowest[len(lowest) // 2, 1] - lowest[0, 1]

    assert bulge(barrel) > 5
    assert bulge(pinhole) == pytest.approx(0)
    assert bulge(pincushion) < -5


def test_house_through_a_lens_looks_up_the_pinholes_picture():
    source, wide = pictures.wide_house()
    seen = pictures.house_through(LENS).astype(float)
    rng = np.random.default_rng(4)
    pixels = rng.integers(20, 220, (400, 2))
    there = np.rint(distortion.undistort_pixels(pixels, pictures.K, LENS, wide)).astype(int)
    expected = source[there[:, 1], there[:, 0]].astype(float)
    off = np.abs(seen[pixels[:, 1], pixels[:, 0]] - expected).max(axis=1)
    assert np.median(off) < 6
    assert (off < 60).mean() > 0.9  # the rest are edges, half a pixel away


def test_nothing_is_seen_beyond_the_fold():
    lens = [-0.6]
    fold = distortion.valid_radius(lens)
    u, v = np.meshgrid(*(np.arange(n) for n in pictures.SIZE))
    r = np.hypot(u - pictures.K[0, 2], v - pictures.K[1, 2]) / pictures.K[0, 0]
    black = (pictures.house_through(lens) == 0).all(axis=2)
    edge = fold * (1 + lens[0] * fold**2)
    assert black[r > edge + 0.03].all()
    assert not black[r < edge - 0.03].any()


def test_a_coarse_map_is_the_fine_one():
    coarse = pictures.straight_map(rails.K, LENS, rails.SIZE)
    fine = np.stack(distortion.undistortion_map(rails.K, LENS, rails.SIZE), axis=-1)
    np.testing.assert_allclose(coarse, fine, atol=0.02)


def test_stages_of_the_camera_mark_one_point():
    figure = draw.where_it_acts(point=(1.0, 0.5, 2.0), k1=-0.2, f=536.0)
    ideal, bent_point, pixel = (coloured(ax, "object")[0][0] for ax in figure.axes)
    np.testing.assert_allclose(ideal, [0.5, 0.25])
    np.testing.assert_allclose(bent_point, distortion.distort([0.5, 0.25], [-0.2]))
    np.testing.assert_allclose(pixel, 536 * bent_point + [342, 236])


def test_profiles_mark_the_fold_at_the_top_of_the_curve():
    (ax,) = draw.profiles([(-0.31,)]).axes
    (curve,) = coloured(ax, "object")
    (mark,) = (line for line in ax.lines if line.get_color() == BLACK)
    (at,) = np.asarray(mark.get_xydata())
    assert at[0] == pytest.approx(distortion.valid_radius([-0.31]))
    assert at[1] == pytest.approx(curve[:, 1].max(), rel=1e-3)


def test_profiles_draw_a_students_radius_on_its_curve():
    (ax,) = draw.profiles([(-0.31, 0)], yours=[0.5]).axes
    (star,) = coloured(ax, "second")
    np.testing.assert_allclose(star, [[0.5, 0.5 * (1 - 0.31 * 0.25)]])


def test_field_says_its_largest_displacement_and_draws_arrows_that_way():
    complete, _, tangential = draw.displacement_fields().axes
    assert "33.8 px" in complete.get_title(loc="left")
    assert "0.168 px" in tangential.get_title(loc="left")
    (quiver,) = (c for c in complete.collections if hasattr(c, "U"))
    towards = np.asarray(quiver.get_offsets()) - [302.71656, 242.33386]
    assert ((np.stack([quiver.U, quiver.V], axis=1) * towards).sum(axis=1) < 0).all()


def test_iso_lines_have_the_level_that_is_written_on_them():
    from course_lib.drawing.distortion.fields import CLASSIC_K, CLASSIC_LENS

    ax = draw.displacement_fields().axes[0]
    (lines,) = (c for c in ax.collections if hasattr(c, "levels"))
    for level, path in zip(lines.levels, lines.get_paths(), strict=True):
        moved = distortion.displacement_field(path.vertices, CLASSIC_K, CLASSIC_LENS)
        np.testing.assert_allclose(np.hypot(*moved.T), level, rtol=0.02)
    written = [text.get_text() for text in ax.texts]
    assert written == ["5", "15", "25"]


def test_newton_is_faster_and_the_fixed_point_fails_for_a_strong_lens():
    for k1 in (-0.2, 0.8):
        r_d = 0.7 * (1 + k1 * 0.49)
        assert mapping.newton(r_d, k1, 8)[-1] == pytest.approx(0.7, abs=1e-12)
    assert mapping.fixed_point(0.7 * (1 - 0.2 * 0.49), -0.2, 60)[-1] == pytest.approx(0.7)
    assert abs(mapping.fixed_point(0.7 * (1 + 0.8 * 0.49), 0.8, 60)[-1] - 0.7) > 0.1


def test_pixels_sent_forward_leave_holes_and_the_others_do_not():
    before, forward, backward = (
        ax.images[0].get_array() for ax in draw.forward_and_backward().axes
    )
    part = (slice(0, 48), slice(0, 64))
    holes = [(picture[part] == 0).all(axis=2).mean() for picture in (before, forward, backward)]
    assert holes[1] > 0.1
    assert max(holes[0], holes[2]) < 0.001
