import inspect
import linecache
import math

import numpy as np
import pytest
from second_solutions import second_solutions

from course_lib import camera, optics
from course_lib.exercises import all_exercises
from course_lib.exercises.pasting import call, literal, paste
from course_lib.judging import Exercise, ValuesExercise, answer, judge, pose

FACTOR = 2.0
FUNCTIONS = [
    e for e in all_exercises() if isinstance(e, Exercise) and not isinstance(e, ValuesExercise)
]


def helper(x):
    return x + 1


def documented(x: float, *rest: int, scale: float = FACTOR, **more: str) -> float:
    r"""Return \alpha of x.

    Parameters
    ----------
    x : float
        In mm.

    Raises
    ------
    ValueError
        If x is bad.

    References
    ----------
    A book.

    Examples
    --------
    >>> documented(1)
    1
    """
    # a reason
    return FACTOR * helper(x) + optics.np.sum(rest) + math.pi * np.pi * len(more)


def one_line(x):
    """Return x."""
    return x


def hiding(helper, scale=2):
    """Return helper times scale."""
    one_line = helper * scale
    return (lambda: one_line)()


def bare(
    x: dict[str, int] = {},  # noqa: B006
) -> list[int]:
    # why
    y = [helper(x) for x in range(3)]
    return y


def run(source, name):
    """Run a cell as Jupyter does, which keeps its text for messages."""
    scope = {"np": np}
    linecache.cache["cell"] = len(source), None, source.splitlines(True), "cell"
    exec(compile(source, "cell", "exec"), scope)
    return scope[name]


def test_signature_has_no_annotations():
    assert paste(documented).signature == "def documented(x, *rest, scale=FACTOR, **more):"


def test_its_own_names_are_not_imported():
    source = paste(hiding).as_function()
    assert "import" not in source
    assert run(source, "hiding")(4) == 8


def test_name_can_be_changed():
    assert paste(one_line, "other").signature == "def other(x):"


def test_docstring_keeps_what_a_student_needs():
    text = paste(documented).docstring
    assert text.startswith('    r"""Return \\alpha of x.')
    assert "Parameters" in text
    assert ">>> documented(1)" in text
    assert "Raises" not in text
    assert "ValueError" not in text
    assert "A book." not in text


def test_short_docstring_stays_on_one_line():
    assert paste(one_line).docstring == '    """Return x."""'


def test_body_imports_what_it_uses():
    lines = paste(documented).body.splitlines()
    module = documented.__module__
    assert lines[:3] == [
        "    import math",
        "    from course_lib import optics",
        f"    from {module} import FACTOR, helper",
    ]
    assert "    # a reason" in lines


def test_names_inside_comprehensions_are_found():
    assert f"from {bare.__module__} import helper" in paste(bare).body
    assert "    # why" in paste(bare).body.splitlines()


def test_solution_is_marked():
    lines = paste(one_line).as_solution().splitlines()
    assert lines[-3:] == ["    ### BEGIN SOLUTION", "    return x", "    ### END SOLUTION"]


@pytest.mark.parametrize("exercise", FUNCTIONS, ids=lambda e: e.name)
def test_pasted_reference_is_a_right_answer(exercise):
    function = run(paste(exercise.reference).as_solution(), exercise.function_name)
    cases = pose(exercise, 3)
    verdict = judge(exercise, cases, answer(exercise, function, cases))
    assert verdict.points == verdict.possible


@pytest.mark.parametrize("exercise", FUNCTIONS, ids=lambda e: e.name)
def test_what_is_pasted_alone_needs_nothing_of_its_module(exercise):
    second = second_solutions(exercise.chapter)[exercise.function_name]
    source = paste(second, exercise.function_name, alone=True).as_function()
    assert "second_solutions" not in source
    cases = pose(exercise, 3)
    verdict = judge(exercise, cases, answer(exercise, run(source, exercise.function_name), cases))
    assert verdict.points == verdict.possible


@pytest.mark.parametrize("exercise", FUNCTIONS, ids=lambda e: e.name)
def test_pasted_misconceptions_stay_what_they_are(exercise):
    for misconception in exercise.misconceptions:
        source = paste(misconception.variant, exercise.function_name, alone=True).as_function()
        assert "course_lib.exercises" not in source
        function = run(source, exercise.function_name)
        cases = pose(exercise, 3)
        verdict = judge(exercise, cases, answer(exercise, function, cases))
        assert verdict.misconceptions == (misconception.name,)


@pytest.mark.parametrize("exercise", FUNCTIONS, ids=lambda e: e.name)
def test_signature_is_the_references(exercise):
    pasted = run(paste(exercise.reference).as_function(), exercise.function_name)
    ours = inspect.signature(exercise.reference).parameters.values()
    theirs = inspect.signature(pasted).parameters.values()
    assert [(p.name, p.kind, p.default) for p in theirs] == [
        (p.name, p.kind, p.default) for p in ours
    ]


@pytest.mark.parametrize(
    "value", [1, 2.5, "a", (1.0, 2), (3,), [1, 2], np.float64(0.1), np.arange(6).reshape(2, 3)]
)
def test_literal_reads_back(value):
    back = eval(literal(value), {"np": np})
    assert np.array_equal(back, value)
    assert isinstance(back, tuple) == isinstance(value, tuple)


def test_call():
    assert call("f", {"a": 1.5, "b": (2, 3)}) == "f(a=1.5, b=(2, 3))"


def test_library_functions_paste_without_their_errors():
    assert "TypeError" not in paste(camera.project_pinhole).docstring
