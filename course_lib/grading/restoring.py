"""Give a submission back the cells that it must have: checks, questions, the first imports."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from nbformat import NotebookNode
from nbformat.v4 import new_code_cell, new_markdown_cell
from nbgrader.preprocessors import NbGraderPreprocessor

from course_lib.grading.labelling import GivenCell, read_given


class RestoreCells(NbGraderPreprocessor):  # type: ignore[misc]
    """Put missing locked and graded cells back, in the order of the source.

    nbgrader's own ``OverwriteCells.add_missing_cells`` stops with an error when the cell before
    the missing one is missing too, or is read-only, and a copy of the answers in a new notebook
    has no nbgrader cells at all.
    """

    def preprocess(
        self, nb: NotebookNode, resources: dict[str, Any]
    ) -> tuple[NotebookNode, dict[str, Any]]:
        """Restore the cells of one notebook."""
        for name in restore_cells(nb, read_given(resources)):
            self.log.warning("Putting back the cell '%s', which was missing", name)
        return nb, resources


def restore_cells(nb: NotebookNode, given: Mapping[str, GivenCell]) -> list[str]:
    """Put missing locked and graded cells back.

    Parameters
    ----------
    nb : nbformat.NotebookNode
        A labelled submission; changed in place.
    given : mapping of str to GivenCell
        From `read_given`.

    Returns
    -------
    list of str
        The labels of the cells that were missing.
    """
    missing, names = [], list(given)
    for index, (name, cell) in enumerate(given.items()):
        needed = cell.flags["locked"] or cell.flags["grade"]
        if needed and _position(nb, name) is None:
            missing.append(name)
            nb.cells.insert(_place(nb, names, index), _cell(cell))
    return missing


def _position(nb: NotebookNode, grade_id: str) -> int | None:
    names = [cell.metadata.get("nbgrader", {}).get("grade_id") for cell in nb.cells]
    return names.index(grade_id) if grade_id in names else None


def _place(nb: NotebookNode, names: Sequence[str], index: int) -> int:
    """Return where a cell goes: after its neighbour, or at the end, where answers are defined."""
    if index == 0:
        return 0
    before = _position(nb, names[index - 1])
    return len(nb.cells) if before is None else before + 1


def _cell(given: GivenCell) -> NotebookNode:
    new = new_code_cell if given.flags["cell_type"] == "code" else new_markdown_cell
    name = str(given.flags["grade_id"])
    return new(given.source, id=name[:56], metadata={"nbgrader": dict(given.flags)})
