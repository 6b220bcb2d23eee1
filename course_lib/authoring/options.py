"""How nbgrader makes student notebooks of the course: options for `course build` and a term."""

from __future__ import annotations

import os
import sysconfig
from typing import Any

from nbformat import NotebookNode
from nbgrader.converters import GenerateAssignment
from nbgrader.preprocessors import ClearSolutions, NbGraderPreprocessor
from traitlets.config import Config

from course_lib.authoring.expansion import VALUES

CODE_STUB = "# Your code here\nraise NotImplementedError"
TEXT_STUB = "*Write your answer here.*"


class ClearValues(NbGraderPreprocessor):  # type: ignore[misc]
    """Take the function stub out of a cell that holds variables: they are None, and stay so."""

    def preprocess_cell(
        self, cell: NotebookNode, resources: dict[str, Any], cell_index: int
    ) -> tuple[NotebookNode, dict[str, Any]]:
        """Clear one cell, if it holds variables."""
        if VALUES in cell.metadata.get("tags", []):
            cell.source = cell.source.replace(CODE_STUB, "").rstrip()
            del cell.metadata["tags"]
        return cell, resources


def find_scripts() -> None:
    """Put this Python's scripts on the path: a new gradebook makes nbgrader call ``alembic``.

    Without it, nbgrader works in an activated environment only.
    """
    scripts, path = sysconfig.get_path("scripts"), os.environ.get("PATH", "")
    if scripts not in path.split(os.pathsep):
        os.environ["PATH"] = os.pathsep.join([scripts, path])


def release_options() -> Config:
    """Return nbgrader's options for `generate_assignment`.

    Returns
    -------
    traitlets.config.Config
        Stubs in a beginner's words; rubrics allowed in read-only question cells.
    """
    options = Config()
    options.ClearSolutions.code_stub = {"python": CODE_STUB}
    options.ClearSolutions.text_stub = TEXT_STUB
    options.ClearMarkScheme.enforce_metadata = False
    usual = GenerateAssignment.class_traits()["preprocessors"].default()
    after = usual.index(ClearSolutions) + 1
    options.GenerateAssignment.preprocessors = [*usual[:after], ClearValues, *usual[after:]]
    return options
