"""The figures of chapter 01: each draws, says what its axes are, and shows the right thing."""

import matplotlib as mpl
import numpy as np
import pytest
from legible import Legible

mpl.use("Agg")  # as a test has no screen


from course_lib.camera import project_pinhole, vanishing_point
from course_lib.drawing import pinhole as draw
from course_lib.drawing.pinhole import light, perspective
from course_lib.drawing.style import ROLES
from course_lib.optics import best_pinhole_diameter, field_of_view

PHOTOGRAPH = np.full((60, 80, 3), 200, np.uint8)
EDGES = {"a": ((10.0, 10.0), (70.0, 12.0)), "b": ((10.0, 50.0), (70.0, 40.0))}
UPRIGHT = {"a": ((10.0, 10.0), (12.0, 50.0)), "b": ((70.0, 10.0), (60.0, 50.0))}
C = (319.5, 239.5)

FIGURES = {
    "bare_sensor_and_hole": lambda: draw.bare_sensor_and_hole(0.8),
    "blur_against_hole": lambda: draw.blur_against_hole(100, 0.00055, yours=0.4),
    "blur_against_hole outside": lambda: draw.blur_against_hole(300, 0.00055, yours=634),
    "blur_geometry": draw.blur_geometry,
    "dolly_strip": draw.dolly_strip,
    "eclipse": draw.eclipse,
    "facade": draw.facade,
    "foreshortening": draw.foreshortening,
    "hole_series": draw.hole_series,
    "house_picture": lambda: draw.house_picture(draw.house()),
    "image_planes": draw.image_planes,
    "lens_centred": draw.lens_centred,
    "lens_fan": draw.lens_fan,
    "meeting_lines": lambda: draw.meeting_lines(PHOTOGRAPH, EDGES, (250, 16)),
    "meeting_lines nowhere": lambda: draw.meeting_lines(PHOTOGRAPH, EDGES, (np.nan, 16)),
    "meeting_lines upright": lambda: draw.meeting_lines(PHOTOGRAPH, UPRIGHT, (20, 400)),
    "one_line_runs_away": draw.one_line_runs_away,
    "photograph": lambda: draw.photograph(PHOTOGRAPH, (30, 30), EDGES),
    "pixel_grid": draw.pixel_grid,
    "sensors_to_scale": draw.sensors_to_scale,
    "similar_triangles": draw.similar_triangles,
    "size_against_distance": draw.size_against_distance,
    "street_lines": lambda: draw.street_lines(draw.street_view(14, 5)),
    "view_angle": draw.view_angle,
}
NO_FIGURES = {"SENSORS", "house", "road_direction", "street_view"}


@pytest.fixture(params=FIGURES)
def figure(request):
    drawn = FIGURES[request.param]()
    drawn.draw_without_rendering()
    return drawn


class TestEachFigure(Legible):
    pass


def test_every_function_is_tried_here():
    assert {name.split()[0] for name in FIGURES} | NO_FIGURES == set(draw.__all__)


@pytest.mark.parametrize("yours", [None, "left", [1, 2], np.full((10, 2), np.nan), {}])
def test_what_a_student_cannot_have_meant_is_not_drawn_or_does_no_harm(yours):
    draw.house_picture(draw.house(), 800, C, yours=yours).draw_without_rendering()
    draw.blur_against_hole(yours=yours).draw_without_rendering()
    draw.lens_fan(yours=yours).draw_without_rendering()
    draw.dolly_strip(yours=yours).draw_without_rendering()
    draw.street_lines(draw.street_view(14), yours=yours).draw_without_rendering()


def lines(figure, role):
    """Return the data of the lines that have the colour of a role."""
    found = [line for ax in figure.axes for line in ax.lines if line.get_color() == ROLES[role]]
    return [np.asarray(line.get_xydata()) for line in found]


def test_house_shows_the_students_points_when_there_are_any():
    corners = draw.house()
    pixels = project_pinhole(corners, 800, C)
    assert not lines(draw.house_picture(corners, 800, C), "second")
    drawn = lines(draw.house_picture(corners, 800, C, yours=pixels + 3), "second")
    np.testing.assert_allclose(drawn[-1], pixels + 3)
    np.testing.assert_allclose(drawn[0], pixels[[0, 1]] + 3)
    assert len(drawn) == 15 + 1  # edges, and the corners


def behind_the_house(point, X):
    """Return whether the sight line to a point runs through the inside of the house."""
    x, y, z = np.outer(point, np.linspace(0.3, 0.999, 2000))
    roof = -5 + np.abs(x - X) * 2.5 / 3
    return bool(((z > 20) & (z < 29) & (np.abs(x - X) < 3) & (y < 1.5) & (y > roof)).any())


@pytest.mark.parametrize("X", [4, -4, 0, 1])
def test_only_edges_that_the_house_hides_are_dashed(X):
    corners = draw.house(X)
    pixels = project_pinhole(corners, 800, C)
    edges = draw.house_picture(corners, 800, C, yours=pixels).axes[0].lines[1:16]
    for edge, line in zip(perspective.HOUSE_EDGES, edges, strict=True):
        np.testing.assert_allclose(line.get_xydata(), pixels[list(edge)])
        hidden = behind_the_house(corners[list(edge)].mean(axis=0), X)
        assert line.is_dashed() is hidden, edge


def test_house_fits_into_its_picture():
    pixels = project_pinhole(draw.house(), 800, C)
    assert ((pixels > 0) & (pixels < (640, 480))).all()


def test_strip_of_a_bare_sensor_is_nearly_even_and_that_of_a_hole_is_not():
    bare, hole = light._strip(None), light._strip(0.3)
    assert np.ptp(bare, axis=0).max() < 0.2
    assert np.ptp(hole, axis=0).min() > 0.4
    red = hole[:, 0]  # the red lamp is the upper one; row 0 of the strip is at the bottom
    assert red[:44].sum() > red[44:].sum()


def test_blur_curve_marks_the_smallest_spot():
    ax = draw.blur_against_hole(100, 0.00055).axes[0]
    total = ax.lines[2].get_xydata()
    smallest = total[total[:, 1].argmin(), 0]
    best = float(best_pinhole_diameter(100, 0.00055))
    assert smallest == pytest.approx(best, rel=0.03)
    assert ax.lines[3].get_xydata()[0, 0] == pytest.approx(best)


def test_best_hole_of_another_box_is_not_given_away():
    ax = draw.blur_against_hole(300, 0.00055).axes[0]
    assert len(ax.lines) == 3  # two straight lines and their sum
    assert not ax.texts
    yours = draw.blur_against_hole(300, 0.00055, yours=0.5).axes[0]
    assert [text.get_text() for text in yours.texts] == ["your answer: d = 0.50 mm"]
    hole, spot = yours.lines[3].get_xydata()[0]
    assert (hole, spot) == pytest.approx((0.5, 0.5 + 2.44 * 0.00055 * 300 / 0.5))


def sharpness(picture):
    grey = np.asarray(picture, float).mean(axis=-1)
    return np.square(np.diff(grey, axis=0)).mean() + np.square(np.diff(grey, axis=1)).mean()


def test_sharpest_picture_of_the_series_is_that_of_the_hole_nearest_to_the_best():
    diameters = (2, 1, 0.6, 0.35, 0.15, 0.07)
    pictures = [ax.images[0].get_array() for ax in draw.hole_series(diameters).axes]
    values = [sharpness(picture) for picture in pictures]
    assert diameters[int(np.argmax(values))] == 0.35
    assert values[0] < values[1] < values[2] < values[3] > values[4] > values[5]


def test_equal_exposures_are_as_bright_as_the_holes_are_large():
    diameters = (2.0, 1.0, 0.5)
    pictures = [
        ax.images[0].get_array() for ax in draw.hole_series(diameters, same_exposure=True).axes[:3]
    ]
    # What a screen makes of grey values: about their 2.2nd power, in light.
    means = [float(np.mean(picture)) ** 2.2 for picture in pictures]
    assert means[1] / means[0] == pytest.approx(1 / 4, rel=0.03)
    assert means[2] / means[0] == pytest.approx(1 / 16, rel=0.03)


def test_fan_draws_the_angle_of_each_lens():
    texts = [text.get_text() for text in draw.lens_fan((24, 50)).axes[0].texts]
    assert any("50 mm, 39.6°" in text for text in texts)
    yours = [field_of_view(f, (36, 24)) for f in (24, 50)]
    dotted = draw.lens_fan((24, 50), yours=yours).axes[0].texts[-1].get_text()
    assert "your function" in dotted


def test_steps_have_their_exact_heights_in_the_picture():
    texts = [text.get_text() for text in draw.foreshortening(800, 1.6, 2).axes[1].texts]
    assert [text for text in texts if "px" in text] == [
        f"{800 * 1.6 * (1 / Z - 1 / (Z + 2)):.0f} px" for Z in (5, 7, 9, 11, 13)
    ]


def test_geometry_and_diffraction_have_the_colours_of_the_explorer():
    shadow, rings = draw.blur_against_hole().axes[0].lines[:2]
    assert (shadow.get_color(), rings.get_color()) == (ROLES["ray"], ROLES["image"])


def test_sensor_table_has_the_crop_factors():
    texts = " ".join(text.get_text() for text in draw.sensors_to_scale().axes[0].texts)
    for factor in ("1.00", "1.53", "2.00", "2.73"):
        assert f"crop factor {factor}" in texts


@pytest.mark.parametrize(("turn", "tilt"), [(14, 0), (-20, 8), (5, -6)])
def test_road_of_the_rendered_street_ends_in_the_vanishing_point(turn, tilt):
    camera = draw.street_view(turn, tilt)
    d = draw.road_direction(camera)
    meeting = vanishing_point(d, np.diag(camera.K)[:2], camera.K[:2, 2])
    far = camera.project((0, 1e7, 0))
    np.testing.assert_allclose(far, meeting, atol=1e-3)
    angle = np.degrees(np.arccos(d[2]))
    assert angle == pytest.approx(np.degrees(np.arccos(np.prod(np.cos(np.radians([turn, tilt]))))))


def test_facade_line_is_as_long_as_the_house_is_wide():
    ends = draw.facade(f=16, Z=12).axes[0].lines[0].get_xydata()
    assert ends[1, 0] - ends[0, 0] == pytest.approx(9 / 12 * 16 * 2048 / 27.6, rel=1e-3)


def test_dolly_zoom_keeps_the_chart_and_uses_the_students_lengths():
    titles = [ax.get_title(loc="left") for ax in draw.dolly_strip(24, (3, 6)).axes]
    assert titles[:2] == ["Z = 3 m, f = 24 mm", "Z = 6 m, f = 24 mm"]
    assert titles[2:] == ["Z = 3 m, f = ?", "Z = 6 m, f = ?"]  # the answer is not given away
    assert not [ax.images for ax in draw.dolly_strip(24, (3, 6)).axes[2:] if ax.images]
    wrong = draw.dolly_strip(24, (3, 6), yours=[24, 12]).axes
    assert wrong[-1].get_title(loc="left") == "Z = 6 m, f = 12 mm"
    assert "your lenses" in wrong[2].get_ylabel()


@pytest.mark.parametrize(
    ("yours", "words"),
    [
        ((300, 200), "your function"),
        ((-50, 200), "your function: outside of the picture"),
        ((np.nan, np.nan), "your function: no point (nan or inf)"),
    ],
)
def test_street_says_where_the_students_point_is(yours, words):
    legend = draw.street_lines(draw.street_view(14), yours=yours).axes[0].get_legend()
    assert words in [text.get_text() for text in legend.get_texts()]
