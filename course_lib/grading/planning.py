"""What of a submission is run: what the student wrote, what that needs, and where checks stand.

A notebook has many cells that show figures and explorers. Nobody looks at them while a class is
graded, so a cell that students were given, and left as it was, is run only if it makes something
that other cells use. Its figures are not drawn. A report that a person must see is always shown.
"""

from __future__ import annotations

import ast
import re
import symtable
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from nbformat import NotebookNode
from nbgrader.utils import is_grade, is_solution

from course_lib.authoring.expansion import REPORT
from course_lib.exercises import find
from course_lib.judging import Exercise, ValuesExercise

CHECK = re.compile(r'\s*check\(\s*["\']([\w.]+)["\']\s*\)\s*')
MAGIC = re.compile(r"^\s*[%!?]|=\s*[%!]|\?\s*$", re.MULTILINE)
#: Packages whose functions show something.
SHOWING = ("course_lib.drawing", "course_lib.widgets")
#: Who uses one of these can use any variable.
SEES_ALL = {"exec", "eval", "globals", "locals", "vars", "dir", "get_ipython", "In", "Out", "_"}
#: Cells of which is remembered what they use: those that all were given, but not all answers.
MOST_CELLS = 512


@dataclass(frozen=True)
class Check:
    """A check of the course in a notebook: which cell, which exercise."""

    cell: int
    exercise: Exercise


@dataclass(frozen=True)
class Plan:
    """What to run, and which checks to judge."""

    steps: tuple[Mapping[str, Any], ...]
    checks: tuple[Check, ...]
    draws: bool


def plan(notebook: NotebookNode, given: Iterable[str]) -> Plan:
    """Decide what of a submission is run.

    Parameters
    ----------
    notebook : nbformat.NotebookNode
        A sanitized submission: its checks are the source's.
    given : iterable of str
        The sources of the cells without a label that students were given.

    Returns
    -------
    Plan
        Steps from top to bottom.
    """
    everything = any(_for_a_person(cell) for cell in notebook.cells)
    draws = everything or any(_is_report(cell) for cell in notebook.cells)
    untouched = {source.strip() for source in given}
    checks = _checks(notebook)
    places = {check.cell: number for number, check in enumerate(checks)}
    runs = {} if everything else _slices(notebook, untouched, set(places))
    steps: list[Mapping[str, Any]] = []
    for index, cell in enumerate(notebook.cells):
        if cell.cell_type != "code":
            continue
        if index in places:
            steps.append(_question(places[index], checks[places[index]].exercise))
        elif source := runs.get(index, cell.source):
            steps.append({"cell": index, "source": source})
    return Plan(tuple(steps), tuple(checks), draws)


def _for_a_person(cell: NotebookNode) -> bool:
    return bool(cell.cell_type == "code" and is_grade(cell) and is_solution(cell))


def _is_report(cell: NotebookNode) -> bool:
    return bool(cell.metadata.get("nbgrader", {}).get("grade_id") == REPORT)


def _checks(notebook: NotebookNode) -> list[Check]:
    found = []
    for index, cell in enumerate(notebook.cells):
        match = CHECK.fullmatch(cell.source) if cell.cell_type == "code" else None
        if match and is_grade(cell) and not is_solution(cell):
            exercise = find(match[1])
            if isinstance(exercise, Exercise):
                found.append(Check(index, exercise))
    return found


def _question(number: int, exercise: Exercise) -> dict[str, Any]:
    variables = list(exercise.units) if isinstance(exercise, ValuesExercise) else []
    return {
        "check": number,
        "function": exercise.function_name,
        "variables": variables,
        "forbidden": list(exercise.forbidden),
    }


def _slices(notebook: NotebookNode, untouched: set[str], checks: set[int]) -> dict[int, str]:
    """Return for each given cell what of it is run: all but what it shows, or nothing."""
    wanted: set[str] = set()
    cells = [(i, c) for i, c in enumerate(notebook.cells) if c.cell_type == "code"]
    showing = frozenset(name for _, cell in cells for name in _showing(cell.source))
    own = [cell.source for i, cell in cells if i not in checks and not _is_given(cell, untouched)]
    for source in own:
        wanted |= names_used(source)
    runs: dict[int, str] = {}
    everything = bool(wanted & SEES_ALL)
    for index, cell in reversed(cells):
        if index in checks or not _is_given(cell, untouched):
            continue
        rest = _without_figures(cell.source, showing)
        always = cell.metadata.get("nbgrader", {}).get("locked", False) or everything
        if always or _made(rest) & wanted:
            runs[index] = rest
            wanted |= names_used(rest)
        else:
            runs[index] = ""
    return runs


def _is_given(cell: NotebookNode, untouched: set[str]) -> bool:
    """Whether a cell is the course's own: locked, or without a label and as it was."""
    label = cell.metadata.get("nbgrader", {})
    if label:
        return bool(label.get("locked") and not label.get("grade"))
    return cell.source.strip() in untouched


@lru_cache(MOST_CELLS)
def names_used(source: str) -> frozenset[str]:
    """Return the names of variables that a cell does not make itself, or that it may change.

    Parameters
    ----------
    source : str
        Python as typed into a notebook, magics included.

    Returns
    -------
    frozenset of str
        In a cell that is no plain Python, every word; with magics, ``get_ipython`` too. (IPython
        would make Python of it, but takes minutes for a few hundred magics.)
    """
    try:
        tables = [symtable.symtable(source, "cell", "exec")]
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        magic = {"get_ipython"} if MAGIC.search(source) else set()
        return frozenset(re.findall(r"[^\W\d]\w*", source)) | magic
    names: set[str] = set()
    while tables:
        table = tables.pop()
        tables += table.get_children()
        module = table.get_type() == "module"
        names |= {s.get_name() for s in table.get_symbols() if module or s.is_global()}
    return frozenset(names)


@lru_cache(MOST_CELLS)
def _made(source: str) -> frozenset[str]:
    """Return the names that a given cell assigns, imports or defines; all it uses, if unsure."""
    try:
        table = symtable.symtable(source, "cell", "exec")
    except SyntaxError:
        return names_used(source)
    bound = (s.get_name() for s in table.get_symbols() if s.is_assigned() or s.is_imported())
    return frozenset([*bound, *(child.get_name() for child in table.get_children())])


@lru_cache(MOST_CELLS)
def _showing(source: str) -> frozenset[str]:
    """Return the names under which a cell imports what shows figures."""
    try:
        nodes = list(ast.walk(ast.parse(source)))
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return frozenset()
    return frozenset(
        alias.asname or alias.name
        for node in nodes
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith(SHOWING)
        for alias in node.names
    )


@lru_cache(MOST_CELLS)
def _without_figures(source: str, showing: frozenset[str]) -> str:
    """Return a given cell without the statements that only show something."""
    try:
        body = ast.parse(source).body
    except SyntaxError:
        return source
    shown = [node for node in body if _only_shows(node, showing)]
    lines: Sequence[str | None] = source.splitlines()
    gone = {n for node in shown for n in range(node.lineno - 1, node.end_lineno or node.lineno)}
    kept = [line for n, line in enumerate(lines) if n not in gone and line is not None]
    return "\n".join(kept).strip()


def _only_shows(node: ast.stmt, showing: frozenset[str]) -> bool:
    if not isinstance(node, ast.Expr) or not isinstance(node.value, ast.Call):
        return False
    function: ast.expr = node.value.func
    while isinstance(function, ast.Attribute | ast.Call):
        function = function.value if isinstance(function, ast.Attribute) else function.func
    return isinstance(function, ast.Name) and function.id in showing
