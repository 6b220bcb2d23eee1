"""Keep in a check's output what the check itself says, and say why where it could say nothing."""

from __future__ import annotations

from typing import Any

from nbformat import NotebookNode
from nbformat.v4 import new_output
from nbgrader.preprocessors import NbGraderPreprocessor
from nbgrader.utils import is_grade

#: What the HTML of a verdict is known by.
VERDICT = '<section class="course-verdict'


REPLACED = (
    "This was not the course's check. Is another function or variable called `check` in this "
    "notebook? Give it another name."
)
STOPPED = (
    "Python stopped before it came to this check: a cell above ended it, for example by using "
    "too much memory."
)


class KeepVerdicts(NbGraderPreprocessor):  # type: ignore[misc]
    """Remove from checks what a student's code wrote past them.

    A logging handler or a thread can write to a stream that was opened before the check. nbgrader
    gives 0 for anything on stderr in a check, and what is written may hold hidden inputs.
    """

    def preprocess_cell(
        self, cell: NotebookNode, resources: dict[str, Any], cell_index: int
    ) -> tuple[NotebookNode, dict[str, Any]]:
        """Tidy the outputs of one cell, if it is a check."""
        if cell.cell_type == "code" and is_grade(cell):
            cell.outputs = [output for output in cell.outputs if _belongs(output)]
            kinds = {str(output.output_type) for output in cell.outputs}
            if "error" not in kinds and kinds != {"display_data", "execute_result"}:
                cell.outputs = [no_points("CheckReplaced", REPLACED)]
        return cell, resources


def no_points(name: str, reason: str) -> NotebookNode:
    """Make the output of a check that could not be run: nbgrader gives 0 for an error.

    It gives full marks for a check without any output.
    """
    return new_output("error", ename=name, evalue=reason, traceback=[f"{name}: {reason}"])


def _belongs(output: NotebookNode) -> bool:
    if output.output_type == "display_data":
        return VERDICT in "".join(output.data.get("text/html", ""))
    return str(output.output_type) != "stream"
