"""The small pieces that the still figures are drawn with."""

import re
from base64 import b64decode
from html import unescape
from io import BytesIO

import matplotlib.pyplot as plt
import numpy as np
import pytest
from IPython.core.formatters import DisplayFormatter
from matplotlib.figure import Figure

from course_lib.drawing import diagrams
from course_lib.drawing.style import RC


@pytest.fixture
def ax():
    fig, ax = plt.subplots()
    yield ax
    plt.close(fig)


def test_figure_is_drawn_in_the_courses_style_and_closed():
    @diagrams.figure
    def example(size):
        """Say something."""
        fig, _ = diagrams.panels(1, 1, (size, 2))
        assert plt.rcParams["font.size"] == RC["font.size"]
        return fig

    before = plt.rcParams["font.size"]
    assert example(3).get_size_inches().tolist() == [3, 2]
    assert plt.rcParams["font.size"] == before
    assert not plt.get_fignums()
    assert (example.__name__, example.__doc__) == ("example", "Say something.")


def drawn_by(decorator, make=lambda: plt.subplots()[0]):
    @decorator
    def example(f=50.0, name="a {b}"):
        """Show nothing, with {braces}.

        More.
        """
        return make()

    return example(f=85)


def test_a_figure_is_described_by_its_sentence_and_arguments():
    decorator = diagrams.figure("An <empty> figure, f = {f:g} mm, {name}.")
    for make in (lambda: plt.subplots()[0], lambda: diagrams.panels(1, 2, (4, 2))[0], Figure):
        drawn = drawn_by(decorator, make)
        assert isinstance(drawn, Figure)
        assert drawn.description == "An <empty> figure, f = 85 mm, a {b}."
    assert not plt.get_fignums()


def test_a_figure_without_a_sentence_is_described_by_its_docstring():
    assert drawn_by(diagrams.figure).description == "Show nothing, with {braces}."


def test_a_notebook_gets_the_picture_with_its_text_alternative():
    drawn = drawn_by(diagrams.figure('5 < 6 & "so on".'))
    (alt, data) = re.fullmatch(
        r'<img alt="([^"]*)" src="data:image/png;base64,([^"]*)">', drawn.html()
    ).groups()
    assert unescape(alt) == '5 < 6 & "so on".'
    picture = plt.imread(BytesIO(b64decode(data)))
    assert picture.shape[2] == 4
    assert picture.min() == 0  # the axes are drawn


def test_a_terminal_gets_the_words(capsys):
    shell = DisplayFormatter()
    assert shell.format(drawn_by(diagrams.figure("A figure."))) == ({}, {})
    assert capsys.readouterr().out == "A figure.\n"


@pytest.mark.parametrize("height", [2.0, -2.0])
def test_tree_stands_on_its_foot_or_on_its_head(ax, height):
    diagrams.tree(ax, (1, 3), height)
    points = np.vstack([patch.get_xy() for patch in ax.patches])
    tip = points[np.abs(points[:, 1] - 3).argmax()]
    np.testing.assert_allclose(tip, (1, 3 + height))


def test_hole_in_a_wall_leaves_the_hole_open(ax):
    diagrams.hole_in_wall(ax, x=2, d=0.5, reach=3, thickness=0.2)
    spans = [collection.get_datalim(ax.transData).intervaly for collection in ax.collections]
    assert sorted(span.tolist() for span in spans) == [[-3, -0.25], [0.25, 3]]


def test_dimension_has_its_label_in_the_middle(ax):
    diagrams.dimension(ax, (0, 1), (4, 1), "f")
    assert ax.texts[-1].get_position() == (2, 1)
    assert ax.texts[-1].get_text() == "f"


def test_picture_frame_has_the_middle_of_pixel_0_at_0(ax):
    diagrams.picture_frame(ax, (640, 480))
    assert ax.get_xlim() == (-0.5, 639.5)
    assert ax.get_ylim() == (479.5, -0.5)


@pytest.mark.parametrize("yours", [None, [1, 2], "left", {}, [[1, 2], [3]], 4])
def test_other_shapes_are_not_drawn(yours):
    assert diagrams.same_shape(yours, np.zeros((2, 2))) is None


def test_the_same_shape_is_drawn():
    drawn = diagrams.same_shape([[1, 2], [3, 4]], np.zeros((2, 2)))
    np.testing.assert_array_equal(drawn, [[1, 2], [3, 4]])


@pytest.mark.parametrize(
    ("number", "words"),
    [(12.344, "12.34"), (-3.0, "-3.00"), (1e100, "1.0e+100"), (-2e7, "-2.0e+07")],
)
def test_a_huge_number_is_as_short_as_another(number, words):
    assert diagrams.in_figures(number, 2) == words
