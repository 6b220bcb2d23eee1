"""What the explorers are measured with: their sliders, and the peers that draw the same."""

import importlib
import io

import matplotlib.pyplot as plt
import pytest

from benchmarks.explorers import EXPLORERS
from benchmarks.peers import _plot
from course_lib.drawing.explorers.frame import Label, Picture


@pytest.mark.parametrize("chapter", EXPLORERS)
def test_rows_name_explorers_and_their_sliders(chapter):
    module = importlib.import_module(f"course_lib.widgets.{chapter}")
    for _, make, title, *sliders in EXPLORERS[chapter]:
        spec = getattr(module, make)().spec
        assert spec["title"] == title
        found = {c["name"] for c in spec["controls"] if c["kind"] == "slider"}
        assert found >= set(sliders)


def test_words_of_a_peer_s_picture_do_not_enlarge_it():
    table = Picture("Table", "A word.", (470, 320), labels=(Label("word", (400, 310)),))
    figure, axes = plt.subplots(figsize=(4.7, 3.2), dpi=100)
    _plot(axes, table)
    plt.close(figure)
    png = io.BytesIO()
    figure.savefig(png, format="png", bbox_inches="tight")
    height, width, _ = plt.imread(io.BytesIO(png.getvalue())).shape
    assert width < 600
    assert height < 400
