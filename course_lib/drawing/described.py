"""A figure that says in words what it shows, for those who do not see it."""

from __future__ import annotations

from html import escape
from io import BytesIO

from matplotlib.figure import Figure

from course_lib.display import show_block


class DescribedFigure(Figure):
    """A Matplotlib figure with a text alternative.

    JupyterLab shows a PNG without the text that belongs to it, so a notebook gets the picture
    as HTML.

    Attributes
    ----------
    description : str
        One sentence or two: what the figure shows.
    """

    description: str = ""

    def html(self) -> str:
        """Return an ``img`` element: the figure as PNG, and its description."""
        from base64 import b64encode

        file = BytesIO()
        self.savefig(file, format="png", bbox_inches="tight")
        data = b64encode(file.getvalue()).decode("ascii")
        return f'<img alt="{escape(self.description)}" src="data:image/png;base64,{data}">'

    def _ipython_display_(self) -> None:
        """Show the picture in a notebook; say what it shows in a terminal."""
        show_block(self.html(), self.description)
