"""Keep in a check's output what the check itself says."""

from __future__ import annotations

from typing import Any

from nbformat import NotebookNode
from nbgrader.preprocessors import NbGraderPreprocessor
from nbgrader.utils import is_grade

#: What the HTML of a verdict is known by.
VERDICT = '<section class="course-verdict'


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
        return cell, resources


def _belongs(output: NotebookNode) -> bool:
    if output.output_type == "display_data":
        return VERDICT in "".join(output.data.get("text/html", ""))
    return str(output.output_type) != "stream"
