"""nbgrader's plug-in: `nbgrader autograde` and formgrader's button judge outside, too."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from nbformat import NotebookNode
from nbgrader.preprocessors import NbGraderPreprocessor
from traitlets import Enum, Float, Unicode

from course_lib.grading.keeping import kept_judge
from course_lib.grading.marking import mark
from course_lib.grading.outside import Submitted
from course_lib.grading.seeding import grading_seed, read_key
from course_lib.grading.submissions import demand_size, files_beside, given_cells
from course_lib.sandbox.limits import allowance_for


class AnswerOutside(NbGraderPreprocessor):  # type: ignore[misc]
    """Run a submission behind walls and write verdicts into its checks, in place of `Execute`."""

    key_file = Unicode(help="The file with the term's key.").tag(config=True)
    isolation = Enum(
        ["bubblewrap", "none"],
        default_value="bubblewrap",
        help="How students' code is kept away from yours; 'none' lets it do what you can do.",
    ).tag(config=True)
    cell_seconds = Float(30.0, help="What one cell may compute.").tag(config=True)

    def preprocess(
        self, nb: NotebookNode, resources: dict[str, Any]
    ) -> tuple[NotebookNode, dict[str, Any]]:
        """Judge one notebook."""
        demand_size(nb)
        who = resources["nbgrader"]
        seed = grading_seed(read_key(Path(self.key_file)), who["student"], who["assignment"])
        root = Path(self.key_file).parent
        given = given_cells(root / "release" / who["assignment"] / f"{who['notebook']}.ipynb")
        folder = Path(str(resources.get("metadata", {}).get("path") or "."))
        judge = kept_judge(self.isolation, allowance_for(self.cell_seconds))
        outcome = judge.judge(Submitted(nb, seed, given, files_beside(folder)))
        if outcome.reason:
            self.log.warning("The submission of %s ended early: %s", who["student"], outcome.reason)
        mark(nb, outcome)
        return nb, resources
