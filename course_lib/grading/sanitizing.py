"""Make a submission a notebook that can be graded: the source's checks, the student's answers.

These are the steps of nbgrader's own `Autograde.sanitize_preprocessors` with the course's among
them, for an assignment that was read from the gradebook once instead of at every step.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from nbformat import NotebookNode
from nbformat.v4 import new_code_cell, new_markdown_cell
from nbgrader.nbgraderformat import MetadataValidator

from course_lib.grading.labelling import GivenCell, given_in, label_cells
from course_lib.grading.restoring import restore_cells


@dataclass(frozen=True)
class GivenNotebook:
    """A notebook of an assignment: what nbgrader knows of it, and its other cells.

    Attributes
    ----------
    cells : mapping of str to GivenCell
        The labelled cells.
    kernelspec : mapping, optional
        The kernel that students were given.
    unlabelled : tuple of str
        The sources of the other cells of code.
    """

    cells: Mapping[str, GivenCell]
    kernelspec: Mapping[str, Any] | None = None
    unlabelled: tuple[str, ...] = ()


@dataclass(frozen=True)
class Sanitized:
    """A submission that can be graded, and what had to be done."""

    notebook: NotebookNode
    copied: list[str] = field(default_factory=list)
    restored: list[str] = field(default_factory=list)


def sanitize(notebook: NotebookNode, given: GivenNotebook) -> Sanitized:
    """Label, restore and overwrite what is not the student's, and remove all outputs.

    Parameters
    ----------
    notebook : nbformat.NotebookNode
        As handed in; changed in place.
    given : GivenNotebook
        What students were given.

    Returns
    -------
    Sanitized
        The same notebook.
    """
    copied = label_cells(notebook, given.cells)
    restored = restore_cells(notebook, given.cells)
    for index, cell in enumerate(notebook.cells):
        name = cell.metadata.get("nbgrader", {}).get("grade_id")
        if name in given.cells:
            notebook.cells[index] = _overwritten(cell, given.cells[name])
    for cell in notebook.cells:
        if cell.cell_type == "code":
            cell.outputs, cell.execution_count = [], None
    if given.kernelspec:
        notebook.metadata["kernelspec"] = NotebookNode(given.kernelspec)
    MetadataValidator().validate_nb(notebook)
    return Sanitized(notebook, copied, restored)


def _overwritten(cell: NotebookNode, given: GivenCell) -> NotebookNode:
    """Return a cell of the source's type, with the source's text where it is locked."""
    source = given.source if given.flags["locked"] else cell.source
    if cell.cell_type != given.flags["cell_type"]:
        new = new_code_cell if given.flags["cell_type"] == "code" else new_markdown_cell
        return new(source, id=cell.id, metadata=cell.metadata)
    cell.source = source
    return cell


def read_notebook_given(notebook: Any, unlabelled: tuple[str, ...]) -> GivenNotebook:
    """Take what is needed from a notebook in the gradebook."""
    import json

    kernelspec = json.loads(notebook.kernelspec) if notebook.kernelspec else None
    return GivenNotebook(given_in(notebook), kernelspec, unlabelled)
