"""A figure that says in words what it shows, for those who do not see it."""

from __future__ import annotations

from io import BytesIO

from matplotlib.figure import Figure

from course_lib.display import described_picture, show_block


class DescribedFigure(Figure):
    """A Matplotlib figure with a text alternative.

    Attributes
    ----------
    description : str
        One sentence or two: what the figure shows.
    """

    description: str = ""

    def html(self) -> str:
        """Return an ``img`` element: the figure as PNG, and its description."""
        file = BytesIO()
        self.savefig(file, format="png", bbox_inches="tight")
        return described_picture(file.getvalue(), self.description)

    def _ipython_display_(self) -> None:
        """Show the picture in a notebook; say what it shows in a terminal."""
        show_block(self.html(), self.description)
