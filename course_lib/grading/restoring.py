"""Give a submission back the cells that it must have: checks, questions, the first imports."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from nbformat import NotebookNode
from nbformat.v4 import new_code_cell, new_markdown_cell
from nbgrader.api import Gradebook, SourceCell
from nbgrader.preprocessors import NbGraderPreprocessor


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
        which = resources["nbgrader"]
        with Gradebook(which["db_url"]) as gradebook:
            notebook = gradebook.find_notebook(which["notebook"], which["assignment"])
            worth = {cell.name: cell.max_score for cell in notebook.grade_cells}
            answers = {cell.name for cell in notebook.solution_cells}
            given = list(notebook.source_cells)
            restored = [_cell(c, worth.get(c.name), c.name in answers) for c in given]
        needed = [cell.metadata.nbgrader for cell in restored]
        for index, cell in enumerate(restored):
            flags = needed[index]
            if _position(nb, flags.grade_id) is None and (flags.locked or flags.grade):
                self.log.warning("Putting back the cell '%s', which was missing", flags.grade_id)
                nb.cells.insert(_place(nb, [flags.grade_id for flags in needed], index), cell)
        return nb, resources


def _position(nb: NotebookNode, grade_id: str) -> int | None:
    names = [cell.metadata.get("nbgrader", {}).get("grade_id") for cell in nb.cells]
    return names.index(grade_id) if grade_id in names else None


def _place(nb: NotebookNode, names: Sequence[str], index: int) -> int:
    """Return where a cell goes: after its neighbour, or at the end, where answers are defined."""
    if index == 0:
        return 0
    before = _position(nb, names[index - 1])
    return len(nb.cells) if before is None else before + 1


def _cell(source: SourceCell, points: float | None, is_answer: bool) -> NotebookNode:
    new = new_code_cell if source.cell_type == "code" else new_markdown_cell
    flags = {
        "cell_type": source.cell_type,
        "checksum": source.checksum,
        "grade": points is not None,
        "grade_id": source.name,
        "locked": source.locked,
        "schema_version": 3,
        "solution": is_answer,
        "task": False,
    }
    worth = {} if points is None else {"points": points}
    metadata = {"nbgrader": flags | worth}
    return new(source.source, id=source.name[:56], metadata=metadata)
