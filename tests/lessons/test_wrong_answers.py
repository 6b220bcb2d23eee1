"""Whatever a student's function returns, the cells that use it run to their end."""

import ast
import re
from functools import cache

import matplotlib as mpl
import numpy as np
import pytest
from lesson_text import lesson_text

from course_lib.exercises import CHAPTERS, all_exercises
from course_lib.judging import Exercise, ValuesExercise

mpl.use("Agg")  # as a test has no screen

#: All but that of chapter 00, whose answer no cell uses.
FUNCTIONS = [
    e
    for e in all_exercises()
    if isinstance(e, Exercise) and not isinstance(e, ValuesExercise) and e.chapter != "welcome"
]


def cells(chapter):
    """Return the code of a lesson, without exercises and explorers."""
    code = re.findall(r"```\{code-cell\} ipython3\n(.*?)```", lesson_text(CHAPTERS[chapter]), re.S)
    return [cell for cell in code if "[exercise]" not in cell and "explorer()" not in cell]


def student(exercise, function):
    """Return a function under the exercise's name, as a notebook has it."""

    def answer(*inputs, **named):
        return function(*inputs, **named)

    answer.__name__ = exercise.function_name
    return answer


def run(cell, scope):
    """Run a cell, and draw its figure as Jupyter would."""
    tree = ast.parse(cell)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "cell", "exec"), scope)
    shown = eval(compile(ast.Expression(last.value), "cell", "eval"), scope) if last else None
    if hasattr(shown, "canvas"):
        shown.draw_without_rendering()


def filled(exercise, number):
    """Return a function whose answers have the right shape and one number everywhere."""

    def fill(value):
        return tuple(map(fill, value)) if isinstance(value, tuple) else np.full_like(value, number)

    return lambda *inputs, **named: fill(exercise.reference(*inputs, **named))


@cache
def answered(chapter):
    """Return a chapter's cells, and its variables after all of them, answered rightly."""
    own = [e for e in FUNCTIONS if e.chapter == chapter]
    scope = {e.function_name: student(e, e.reference) for e in own}
    for cell in cells(chapter):
        run(cell, scope)
    return cells(chapter), scope


@pytest.mark.filterwarnings("ignore::RuntimeWarning")  # what Python says of a student's division
@pytest.mark.parametrize("exercise", FUNCTIONS, ids=lambda e: e.name)
def test_cells_survive_wrong_answers(exercise):
    code, scope = answered(exercise.chapter)
    name = exercise.function_name
    using = [cell for cell in code if re.search(rf"\b{name}\b", cell)]
    assert using
    wrong = [v for m in exercise.misconceptions for v in (m.variant, *m.also)]
    wrong += [filled(exercise, number) for number in (0.0, np.nan, 1e100, -1e-300)]
    for function in wrong:
        for cell in using:
            run(cell, scope | {name: student(exercise, function)})
