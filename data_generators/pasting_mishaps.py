"""What goes wrong with a student's cells as a whole: copies of them, and strange labels."""

from __future__ import annotations

import copy
import itertools
from collections.abc import Mapping, Sequence
from typing import Any

from nbformat import NotebookNode
from nbformat.v4 import new_code_cell

#: What other programs leave in nbgrader's labels.
ODD_LABELS: Sequence[Mapping[str, Any]] = (
    {"schema_version": 99},
    {"schema_version": 0, "points": 100},
    {"locked": False, "solution": True},
    {"nbgrader": {}},
)


def label_of(cell: NotebookNode) -> str:
    """Return nbgrader's name of a cell, empty if it has none."""
    return str(cell.metadata.get("nbgrader", {}).get("grade_id", ""))


def by_label(notebook: NotebookNode) -> dict[str, NotebookNode]:
    """Return the cells that have a label."""
    return {label_of(cell): cell for cell in notebook.cells if label_of(cell)}


def paste_below(notebook: NotebookNode, cell: NotebookNode, source: str) -> None:
    """Paste a cell below itself as JupyterLab does, with its label, and edit the copy."""
    notebook.cells.insert(notebook.cells.index(cell) + 1, _copy_of(cell, source))


def paste_at_end(notebook: NotebookNode, cell: NotebookNode, source: str) -> None:
    """Paste a cell at the end of the notebook, with its label, and edit the copy."""
    notebook.cells.append(_copy_of(cell, source))


def label_oddly(notebook: NotebookNode) -> None:
    """Leave in every cell's label something that does not belong there."""
    for cell, odd in zip(notebook.cells, itertools.cycle(ODD_LABELS), strict=False):
        cell.metadata.get("nbgrader", cell.metadata).update(odd)


def _copy_of(cell: NotebookNode, source: str) -> NotebookNode:
    metadata = copy.deepcopy(cell.metadata)
    return new_code_cell(source, id=f"{cell.id[:56]}-pasted", metadata=metadata)
