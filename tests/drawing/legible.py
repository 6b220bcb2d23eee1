"""What every figure of the course owes its reader, whatever the chapter."""

import re

import matplotlib.pyplot as plt
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure


def luminance(text):
    """Return how light a text is, 0 to 1."""
    red, green, blue = to_rgb(text.get_color())
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


class Legible:
    """The tests of one figure, a fixture of the module that inherits them."""

    UNITS = ("px", "mm", "m")
    WHITE_ON_DARK = False  # whether a figure may write in white on something dark
    SLANTED = False  # whether texts may be slanted; the boxes around those say nothing

    def test_is_shown_once_and_leaves_nothing_open(self, figure):
        assert isinstance(figure, Figure)
        assert not plt.get_fignums()

    def test_is_described_in_a_sentence_of_its_own(self, figure):
        words = figure.description
        assert re.fullmatch(r"[A-Zf][^{}]{30,}\.", words), words
        assert not words.startswith("Show")

    def test_axes_with_numbers_have_labels_with_units(self, figure):
        unit = re.compile(rf"\((?:{'|'.join(self.UNITS)})\)")
        for ax in (ax for ax in figure.axes if ax.axison):
            for label, axis in ((ax.get_xlabel(), ax.xaxis), (ax.get_ylabel(), ax.yaxis)):
                numbered = any(tick.get_text() for tick in axis.get_ticklabels())
                assert not numbered or unit.search(label), f"{label!r} has no unit"

    def test_no_text_runs_out_of_the_figure(self, figure):
        frame = figure.bbox
        for text in (text for ax in figure.axes for text in ax.texts if text.get_text()):
            box = text.get_window_extent()
            assert frame.x0 <= box.x0 < box.x1 <= frame.x1, text.get_text()
            assert frame.y0 <= box.y0 < box.y1 <= frame.y1, text.get_text()

    def test_no_two_texts_overlap(self, figure):
        for ax in figure.axes:
            texts = [t for t in ax.texts if t.get_text()]
            if self.SLANTED:
                texts = [t for t in texts if t.get_rotation() % 90 == 0]
            boxes = [(t.get_text(), t.get_window_extent()) for t in texts]
            for k, (first, box) in enumerate(boxes):
                for second, other in boxes[k + 1 :]:
                    assert not box.overlaps(other), f"{first!r} and {second!r}"

    def test_text_is_dark_enough_to_read(self, figure):
        for text in (text for ax in figure.axes for text in ax.texts):
            white = self.WHITE_ON_DARK and text.get_color() == "white"
            assert white or luminance(text) < 0.55, text.get_text()
