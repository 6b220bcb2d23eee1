"""Write into a submission what came of it: outputs of its cells, verdicts in its checks."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from nbformat import NotebookNode
from nbformat.v4 import new_output
from nbgrader.utils import is_grade, is_solution

from course_lib.grading.harmless import disarm
from course_lib.grading.outside import Outcome
from course_lib.grading.planning import CHECK
from course_lib.judging import Verdict
from course_lib.judging.html import to_html
from course_lib.judging.text import to_text

CRASH = (
    "Python stopped before it came to this check: a cell above ended it (as os._exit or a crash in "
    "compiled code does), or left it no processes."
)
#: Why a check could not be run, by what ended the notebook.
REASONS = {
    "crash": CRASH,
    "memory": (
        "The notebook was stopped before it came to this check, because it used too much memory."
    ),
    "time": (
        "The notebook was stopped before it came to this check, because it took too long. Does a "
        "cell above never end?"
    ),
    "output": (
        "The notebook was stopped before it came to this check, because it printed far too much."
    ),
}
BASE64 = re.compile(r"[A-Za-z0-9+/=\n]*")


def mark(notebook: NotebookNode, outcome: Outcome) -> None:
    """Put outputs and verdicts into a notebook, and leave nothing in it that a browser would run.

    Parameters
    ----------
    notebook : nbformat.NotebookNode
        The sanitized submission; changed in place.
    outcome : Outcome
        From `Judge.judge`.
    """
    why = REASONS.get(outcome.reason, CRASH)
    for index, cell in enumerate(notebook.cells):
        if cell.cell_type != "code":
            continue
        said = outcome.outputs.get(index)
        cell.outputs = [] if said is None else _outputs(said)
        cell.execution_count = None
        if index in outcome.verdicts:
            verdict = outcome.verdicts[index]
            cell.outputs = [_not_run(why)] if verdict is None else shown(verdict)
        elif said is None and is_grade(cell) and not is_solution(cell):
            cell.outputs = [_not_run(why)]  # a test cell of the instructor's own
    disarm(notebook)


def shown(verdict: Verdict) -> list[NotebookNode]:
    """Return a check's output: the verdict, and the points where nbgrader looks for them."""
    data = {"text/html": to_html(verdict), "text/plain": to_text(verdict)}
    points = {"text/plain": repr(float(verdict.points))}
    return [
        new_output("display_data", data=data),
        new_output("execute_result", data=points, execution_count=None),
    ]


def points_of(cell: NotebookNode) -> float | None:
    """Return the points that a marked check of the course holds; None for any other cell."""
    if not CHECK.fullmatch(cell.source) or not is_grade(cell):
        return None
    results = [o for o in cell.outputs if o.output_type == "execute_result"]
    return float(results[0].data["text/plain"]) if results else 0.0


def _not_run(reason: str) -> NotebookNode:
    """Make the output of a check that could not be run: nbgrader gives 0 for an error.

    It gives full marks for a check without any output.
    """
    name = "NotReached"
    return new_output("error", ename=name, evalue=reason, traceback=[f"{name}: {reason}"])


def _outputs(said: Mapping[str, Any]) -> list[NotebookNode]:
    """Return the outputs of a cell, as far as they are what outputs should be."""
    reported = said.get("outputs")
    found = [_output(item) for item in reported] if isinstance(reported, list) else []
    return [output for output in found if output is not None]


def _output(item: Any) -> NotebookNode | None:
    """Return one output with texts and pictures only: no HTML and no scripts reach the grader."""
    if not isinstance(item, Mapping):
        return None
    kind = item.get("output_type")
    if kind == "stream":
        name = "stderr" if item.get("name") == "stderr" else "stdout"
        return new_output("stream", name=name, text=_text(item.get("text")))
    if kind == "error":
        lines = item.get("traceback")
        traceback = [_text(line) for line in lines] if isinstance(lines, list) else []
        name, value = _text(item.get("ename"))[:200], _text(item.get("evalue"))
        shown = traceback or [f"{name}: {value}" if value else name]  # pages show nothing else
        return new_output("error", ename=name, evalue=value, traceback=shown)
    if kind in ("display_data", "execute_result") and isinstance(item.get("data"), Mapping):
        data = {"text/plain": _text(item["data"].get("text/plain"))}
        picture = _text(item["data"].get("image/png"))
        if picture and BASE64.fullmatch(picture):
            data["image/png"] = picture
        count = {"execution_count": None} if kind == "execute_result" else {}
        return new_output(kind, data=data, **count)
    return None


def _text(value: Any) -> str:
    text = value if isinstance(value, str) else ""
    return text.encode("utf-8", "replace").decode("utf-8")
