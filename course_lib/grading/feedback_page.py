"""A student's feedback page: nbgrader's own, with the names of the exercises in its contents."""

from __future__ import annotations

import re
from typing import Any

from nbconvert.exporters import HTMLExporter
from nbformat import NotebookNode

#: What nbgrader calls every check in the list at the top of the page.
_TEST_CELL = re.compile(r'(<a href="#([^"]+)-check">)Test cell</a>')


class FeedbackPage(HTMLExporter):  # type: ignore[misc]
    """Make the page with nbgrader's template, and put the exercises' names into its contents.

    A template of ours would not do: formgrader's button insists on nbgrader's.
    """

    def from_notebook_node(
        self, nb: NotebookNode, resources: Any = None, **kwargs: Any
    ) -> tuple[str, Any]:
        """Make the page of one notebook."""
        page, resources = super().from_notebook_node(nb, resources, **kwargs)
        return name_exercises(page), resources


def name_exercises(page: str) -> str:
    """Write the names of the exercises where nbgrader writes "Test cell".

    Parameters
    ----------
    page : str
        HTML.

    Returns
    -------
    str
        HTML; the same if nothing in it says "Test cell".
    """
    return _TEST_CELL.sub(lambda m: f"{m[1]}<code>{m[2].replace('-', '.', 1)}</code></a>", page)
