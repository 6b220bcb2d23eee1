"""Pieces of figures in space are where the course's own camera sees them."""

import matplotlib as mpl
import numpy as np
import pytest

mpl.use("Agg")  # as a test has no screen

import matplotlib.pyplot as plt

from course_lib.drawing.space import (
    onlooker,
    show_arrow,
    show_axes,
    show_face,
    show_frustum,
    show_path,
)
from course_lib.drawing.style import ROLES

VIEW = onlooker((4, -6, 3), (0, 0, 0.5), 900)
SMALL = onlooker((0, 0, 1), (1, 4, 1), 700)
TRIANGLE = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]])


@pytest.fixture
def ax():
    figure, axes = plt.subplots()
    yield axes
    plt.close(figure)


def test_the_target_is_in_the_middle():
    np.testing.assert_allclose(VIEW.project((0, 0, 0.5)), [319.5, 239.5])


def test_paths_and_faces_are_projected(ax):
    show_path(ax, VIEW, TRIANGLE, "camera")
    show_face(ax, VIEW, TRIANGLE, "object")
    np.testing.assert_allclose(ax.lines[0].get_xydata(), VIEW.project(TRIANGLE))
    np.testing.assert_allclose(ax.lines[1].get_xydata(), VIEW.project(TRIANGLE[[0, 1, 2, 0]]))
    assert [line.get_color() for line in ax.lines] == [ROLES["camera"], ROLES["object"]]


def test_an_arrow_leads_from_start_to_end(ax):
    show_arrow(ax, VIEW, TRIANGLE[0], TRIANGLE[1], "ray")
    (arrow,) = ax.texts
    np.testing.assert_allclose(arrow.xyann, VIEW.project(TRIANGLE[0]))
    np.testing.assert_allclose(arrow.xy, VIEW.project(TRIANGLE[1]))


def test_axes_have_names_beyond_their_tips(ax):
    show_axes(ax, VIEW, (0, 0, 0), np.eye(3), "XYZ", "guide", "world")
    names = {text.get_text(): np.array(text.get_position()) for text in ax.texts}
    start = VIEW.project((0, 0, 0))
    for name, tip in zip(("$X$", "$Y$", "$Z$"), VIEW.project(np.eye(3)), strict=True):
        beyond = np.linalg.norm(names[name] - start) - np.linalg.norm(tip - start)
        assert beyond == pytest.approx(13)
    assert "world" in names


def test_the_corners_of_a_frustum_are_those_of_the_picture(ax):
    show_frustum(ax, VIEW, SMALL, depth=2.0, name="")
    rays = SMALL.pixel_ray([[-0.5, -0.5], [639.5, -0.5], [639.5, 479.5], [-0.5, 479.5]])
    corners = SMALL.centre + 2.0 * rays / (rays @ SMALL.R[2])[:, None]
    outline = ax.lines[0].get_xydata()
    np.testing.assert_allclose(outline[:4], VIEW.project(corners))
    for line, corner in zip(ax.lines[1:], corners, strict=True):
        np.testing.assert_allclose(line.get_xydata(), VIEW.project([SMALL.centre, corner]))
    assert not ax.texts
