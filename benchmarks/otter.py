"""otter-grader, a peer for grading: the same notebook, answers and cases, as its own assignment.

It lives in an environment of its own, made when it is first needed.
"""

from __future__ import annotations

import subprocess
import sys
import sysconfig
from pathlib import Path

import nbformat
from nbformat import NotebookNode
from nbformat.v4 import new_code_cell, new_notebook, new_raw_cell

from benchmarks.processes import clean_environment
from course_lib.authoring.expansion import grade_id
from course_lib.exercises import all_exercises
from course_lib.exercises.pasting import literal
from course_lib.judging import Exercise, Raises, ValuesExercise, pose
from course_lib.judging.answering import expected_answer
from data_generators.typed_answers import right

FOLDER = Path(__file__).resolve().parents[1] / ".venv.otter"
CONFIG = """# ASSIGNMENT CONFIG
tests:
  ok_format: false
export_cell: false
run_tests: false
check_all_cell: false"""
#: Cases are those of this seed.
SEED = 1


def program() -> Path:
    """Return otter's program; install it, with this course beside it, if it is not there."""
    found = FOLDER / "bin/otter"
    if not found.exists():
        subprocess.run([sys.executable, "-m", "venv", str(FOLDER)], check=True)
        install = [str(FOLDER / "bin/python"), "-m", "pip", "install", "--quiet"]
        subprocess.run([*install, "otter-grader>=6", "ipykernel"], check=True)
        version = f"python{sys.version_info[0]}.{sys.version_info[1]}"
        beside = FOLDER / "lib" / version / "site-packages/course.pth"
        ours = sysconfig.get_path("purelib")
        beside.write_text(f"import site; site.addsitedir({ours!r})\n", encoding="utf-8")
    return found


def assign(released: NotebookNode, chapter: str, folder: Path) -> tuple[Path, NotebookNode]:
    """Make otter's assignment of a chapter.

    Parameters
    ----------
    released : nbformat.NotebookNode
        What students get of ours.
    chapter : str
        Its module of exercises.
    folder : pathlib.Path
        Where to work.

    Returns
    -------
    archive : pathlib.Path
        What otter grades with.
    student : nbformat.NotebookNode
        What otter's students get; each answer's cell begins with ``# answer NAME``.
    """
    exercises = {grade_id(e.name): e for e in all_exercises(chapter) if isinstance(e, Exercise)}
    cells = [new_raw_cell(CONFIG)]
    for cell in released.cells:
        label = cell.metadata.get("nbgrader", {})
        if label.get("grade_id") in exercises:
            cells += _question(exercises[label["grade_id"]])
        elif not (cell.cell_type == "code" and label.get("grade")):
            cells.append(nbformat.from_dict({**cell, "metadata": {}}))
    metadata = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    nbformat.write(new_notebook(cells=cells, metadata=metadata), folder / "master.ipynb")
    _run([str(program()), "assign", "master.ipynb", "dist"], folder)
    (archive,) = (folder / "dist/autograder").glob("*.zip")
    return archive, nbformat.read(folder / "dist/student/master.ipynb", as_version=4)


def _question(exercise: Exercise) -> list[NotebookNode]:
    """Return the cells of one exercise: its settings, a right answer, hidden tests."""
    source = f"# answer {exercise.name}\n# BEGIN SOLUTION\n{right(exercise).source}\n# END SOLUTION"
    name = exercise.name.replace(".", "_")
    return [
        new_raw_cell(f"# BEGIN QUESTION\nname: {name}\npoints: {exercise.points}"),
        new_raw_cell("# BEGIN SOLUTION"),
        new_code_cell(source),
        new_raw_cell("# END SOLUTION"),
        new_raw_cell("# BEGIN TESTS"),
        *_tests(exercise),
        new_raw_cell("# END TESTS"),
        new_raw_cell("# END QUESTION"),
    ]


def _tests(exercise: Exercise) -> list[NotebookNode]:
    """Return a test for each case that has an answer."""
    cases = [(case, expected_answer(exercise, case)) for case in pose(exercise, SEED)]
    asked = [(case, value) for case, value in cases if not isinstance(value, Raises)]
    cells = []
    for number, (case, expected) in enumerate(asked):
        values = isinstance(exercise, ValuesExercise)
        name = case.part if values else exercise.function_name
        inputs = "" if values else f"({', '.join(map(literal, case.inputs.values()))})"
        config = '""" # BEGIN TEST CONFIG\nhidden: true\n'
        near = 1e-3 if values else 1e-6  # numbers that a student typed may be rounded
        compare = (
            f"    np.testing.assert_allclose({name}{inputs}, {literal(expected)}, rtol={near})"
        )
        head = f'""" # END TEST CONFIG\ndef test_{number}({name}):\n    import numpy as np\n'
        head += "    from numpy import array, nan, inf\n"
        cells.append(new_code_cell(config + head + compare))
    return cells


def filled_in(student: NotebookNode, submission: NotebookNode) -> NotebookNode:
    """Return otter's notebook with the answers of a submission to ours."""
    answers = {c.metadata.get("nbgrader", {}).get("grade_id"): c.source for c in submission.cells}
    notebook = nbformat.from_dict(student)
    for cell in notebook.cells:
        head, _, _ = cell.source.partition("\n")
        if head.startswith("# answer "):
            cell.source = answers[grade_id(head.removeprefix("# answer "))]
    return notebook


def grade(archive: Path, notebook: Path) -> None:
    """Grade one notebook as ``otter run`` does; its results lie in ``results.json`` beside it."""
    command = [str(program()), "run", "-a", str(archive), notebook.name, "-o", "."]
    _run(command, notebook.parent)


def _run(command: list[str], folder: Path) -> None:
    done = subprocess.run(command, cwd=folder, env=clean_environment(), capture_output=True)
    if done.returncode:
        said = done.stderr.decode("utf-8", "replace")[-2000:]
        raise RuntimeError(f"{' '.join(command)} failed: {said}")
