"""Label the cells of a submission as the source has them, each label once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from nbformat import NotebookNode
from nbformat.v4 import new_markdown_cell
from nbgrader.api import Gradebook
from nbgrader.preprocessors import ClearMarkScheme, NbGraderPreprocessor


@dataclass(frozen=True)
class GivenCell:
    """A cell of the source that nbgrader knows: what it holds, and how it is labelled."""

    source: str
    flags: Mapping[str, Any]

    @property
    def is_check(self) -> bool:
        """Whether the cell gives points and holds nothing of the student's."""
        return bool(self.flags["grade"] and not self.flags["solution"])


def read_given(resources: Mapping[str, Any]) -> dict[str, GivenCell]:
    """Read the labelled cells of a notebook from the gradebook.

    Parameters
    ----------
    resources : mapping
        What nbgrader gives to a preprocessor.

    Returns
    -------
    dict of str to GivenCell
        By label (nbgrader's ``grade_id``), in the order of the source.
    """
    which = resources["nbgrader"]
    with Gradebook(which["db_url"]) as gradebook:
        return given_in(gradebook.find_notebook(which["notebook"], which["assignment"]))


def given_in(notebook: Any) -> dict[str, GivenCell]:
    """Return the labelled cells of a notebook in the gradebook, by label."""
    worth = {cell.name: cell.max_score for cell in notebook.grade_cells}
    answers = {cell.name for cell in notebook.solution_cells}
    return {
        cell.name: GivenCell(cell.source, _flags(cell, worth.get(cell.name), answers))
        for cell in notebook.source_cells
    }


def _flags(cell: Any, points: float | None, answers: set[str]) -> dict[str, Any]:
    flags = {
        "cell_type": cell.cell_type,
        "checksum": cell.checksum,
        "grade": points is not None,
        "grade_id": cell.name,
        "locked": cell.locked,
        "schema_version": 3,
        "solution": cell.name in answers,
        "task": False,
    }
    return flags if points is None else flags | {"points": points}


class LabelCells(NbGraderPreprocessor):  # type: ignore[misc]
    """Keep one cell for each label, and give it the label as the source has it.

    JupyterLab's copy and paste copies nbgrader's label too. nbgrader 0.9.6 empties all of such
    labels but one, takes the empty ones for an old format, and then stops, for all students.

    No cell is moved, changed or removed: run from top to bottom, the notebook does what it did
    for the student. What is chosen is only which copy counts.
    """

    def preprocess(
        self, nb: NotebookNode, resources: dict[str, Any]
    ) -> tuple[NotebookNode, dict[str, Any]]:
        """Label the cells of one notebook."""
        copied = label_cells(nb, read_given(resources))
        if copied:
            who = resources["nbgrader"].get("student", "somebody")
            text = "%s handed in more than one copy of: %s. One of each counts."
            self.log.warning(text, who, ", ".join(copied))
        return nb, resources


def label_cells(nb: NotebookNode, given: Mapping[str, GivenCell]) -> list[str]:
    """Keep one cell for each label, and give it the label as the source has it.

    Parameters
    ----------
    nb : nbformat.NotebookNode
        A submission; its labels are changed in place.
    given : mapping of str to GivenCell
        From `read_given`.

    Returns
    -------
    list of str
        The labels that were there more than once.
    """
    found: dict[str, list[int]] = {}
    for index, cell in enumerate(nb.cells):
        name = _take_label(cell)
        if name in given:
            found.setdefault(name, []).append(index)
    for name, index in _choose(nb, given, found).items():
        nb.cells[index].metadata["nbgrader"] = NotebookNode(given[name].flags)
        _show_rubric(nb.cells[index], given[name])
    return [name for name, copies in found.items() if len(copies) > 1]


def _show_rubric(cell: NotebookNode, given: GivenCell) -> None:
    """Give an unchanged question its rubric: nbgrader would call it a changed one."""
    question = new_markdown_cell(given.source)
    if given.flags["locked"] and given.flags["cell_type"] == "markdown":
        step = ClearMarkScheme(enforce_metadata=False)
        if step.preprocess_cell(question, {}, 0)[0].source == cell.source:
            cell.source = given.source


def _take_label(cell: NotebookNode) -> str:
    """Remove a cell's label, in whatever state it is, and return its name."""
    label = cell.metadata.pop("nbgrader", None)
    return str(label.get("grade_id", "")) if isinstance(label, Mapping) else ""


def _choose(
    nb: NotebookNode, given: Mapping[str, GivenCell], found: Mapping[str, Sequence[int]]
) -> dict[str, int]:
    """Return which copy counts of each cell that is there."""
    chosen, names = {}, list(given)
    for index, name in enumerate(names):
        if name not in found or given[name].is_check:
            continue
        copies = found[name]
        if not given[name].flags["solution"]:  # text and imports of ours: all are alike
            chosen[name] = copies[0]
            continue
        # A copy that is still the stub is no answer; of several answers the last one counts.
        written = [k for k in copies if nb.cells[k].source.strip() != given[name].source.strip()]
        chosen[name] = (written or copies[:1])[-1]
        check = names[index + 1] if index + 1 < len(names) else ""
        if check in found and given[check].is_check:
            # The check that this answer met: the first after it. If none comes after it, the
            # last check there is, and the last answer before that one, which is what it ran.
            after = [k for k in found[check] if k > chosen[name]]
            chosen[check] = (after or found[check][-1:])[0]
            met = [k for k in written if k < chosen[check]]
            chosen[name] = met[-1] if met else chosen[name]
    loose = {n: at[-1] for n, at in found.items() if given[n].is_check and n not in chosen}
    return chosen | loose
