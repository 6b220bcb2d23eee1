"""Right answers in unusual forms: cells of the student's own, functions that are made, libraries.

Whoever answers so understood the exercise, and must get full points.
"""

from __future__ import annotations

import ast
import itertools
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import nbformat
from nbformat.v4 import new_code_cell
from numpy.random import Generator

from course_lib.authoring.building import notebook_bytes
from course_lib.authoring.expansion import grade_id
from course_lib.judging import Exercise, ValuesExercise
from data_generators.classes import Simulation, Submission
from data_generators.handwriting import rewrite
from data_generators.pasting_mishaps import by_label
from data_generators.typed_answers import Typed, right

#: How an answer is made of the helper ``my_{name}``; ``{taken}`` are its parameters.
FORMS: Sequence[str] = (
    "def {name}({parameters}):\n    return my_{name}({taken})",
    "{name} = my_{name}",
    "{name} = lambda {parameters}: my_{name}({taken})",
    "from functools import partial\n\n{name} = partial(my_{name})",
    "class Mine:\n    def __call__(self, {parameters}):\n        return my_{name}({taken})\n\n\n"
    "{name} = Mine()",
    "from functools import wraps\n\n\ndef told(function):\n    @wraps(function)\n"
    "    def tell(*arguments):\n        print(function.__name__, arguments)\n"
    "        return function(*arguments)\n\n    return tell\n\n\n{name} = told(my_{name})",
    "tools = {{'mine': my_{name}}}\n\n\ndef {name}({parameters}):\n"
    "    global called\n    called = True\n    return tools['mine']({taken})",
    "def {name}(*arguments, **named):\n    return my_{name}(*arguments, **named)",
)
#: Answers that use other libraries, by exercise.
BORROWED: Mapping[str, str] = {
    "pinhole.best_pinhole_diameter": """\
from scipy.optimize import brentq

@np.vectorize
def best_pinhole_diameter(image_distance, wavelength):
    airy = 2.44 * wavelength * image_distance
    return brentq(lambda d: 1 - airy / d**2, 1e-9, 1e9 * airy, xtol=1e-15)
""",
    "pinhole.pixel_focal_length": """\
from statistics import linear_regression

def pixel_focal_length(f, sensor_size, image_size):
    both = zip(sensor_size, image_size)
    return tuple(f * linear_regression([0, mm], [0, px]).slope for mm, px in both)
""",
    "pinhole.field_of_view": """\
import math

def field_of_view(f, sensor_size):
    return [2 * math.atan2(mm, 2 * f) for mm in (*sensor_size, math.dist((0, 0), sensor_size))]
""",
    "pinhole.equivalent_focal_length": """\
from decimal import Decimal

def equivalent_focal_length(f, sensor_size):
    across, down = map(Decimal, map(float, sensor_size))
    ratio = (Decimal(36**2 + 24**2) / (across**2 + down**2)).sqrt()
    return float(Decimal(float(f)) * ratio)
""",
    "pinhole.vanishing_point": """\
from scipy.linalg import block_diag

def vanishing_point(direction, f, c):
    K = block_diag(np.diag(np.broadcast_to(f, 2)), 1.0)
    K[:2, 2] = c
    far = np.asarray(direction, float) @ K.T
    with np.errstate(divide='ignore', invalid='ignore'):
        seen = far[..., :2] / far[..., 2:]
    return np.where(np.asarray(direction)[..., 2:] == 0, np.nan, seen)
""",
    "pinhole.dolly_zoom": """\
from scipy.interpolate import make_interp_spline

def dolly_zoom(f, Z, Z_new):
    return make_interp_spline([0, Z], [0, f], k=1)(Z_new)
""",
}
#: Put before a function and at the beginning of its body: the first call takes so long.
SLOW = "import time\n\nslept = []\n\n"
SLEEP = "    if not slept:\n        slept.append(time.sleep({seconds}))"


def unusual_class(simulation: Simulation, rng: Generator) -> Iterator[Submission]:
    """Make submissions whose answers are right in unusual forms.

    Parameters
    ----------
    simulation : Simulation
        The notebook that students got.
    rng : numpy.random.Generator
        Chance.

    Yields
    ------
    Submission
        From ``"helpers"``, who works in cells above the answers and tidies up at the end;
        ``"borrower"``, who uses other libraries; ``"slow"``, whose answer takes 2.5 s.
    """
    yield _helpers(simulation, rng)
    own = {e.name: right(e) for e in simulation.exercises}
    borrowed = {name: replace(own[name], source=BORROWED[name]) for name in own if name in BORROWED}
    yield simulation.hand_in("borrower", own | borrowed)
    last = simulation.exercises[-1]
    yield simulation.hand_in("slow", own | {last.name: _slow(own[last.name], 2.5)})


def _helpers(simulation: Simulation, rng: Generator) -> Submission:
    """Define what answers in a cell above each; take it away when all is checked."""
    functions = [e for e in simulation.exercises if not isinstance(e, ValuesExercise)]
    whole = simulation.hand_in("helpers", {e.name: right(e) for e in simulation.exercises})
    notebook = nbformat.reads(whole.content.decode("utf-8"), as_version=4)
    cells = by_label(notebook)
    for exercise, form in zip(functions, itertools.cycle(FORMS), strict=False):
        cell = cells[grade_id(exercise.name)]
        helper, cell.source = _in_two(exercise, cell.source, form, rng)
        notebook.cells.insert(notebook.cells.index(cell), new_code_cell(helper))
    names = ", ".join(f"my_{e.function_name}" for e in functions)
    notebook.cells.append(new_code_cell(f"del {names}\ntools = None"))
    return replace(whole, content=notebook_bytes(notebook))


def _in_two(exercise: Exercise, source: str, form: str, rng: Generator) -> tuple[str, str]:
    """Return a helper in a student's hand, and the answer that is made of it."""
    name = exercise.function_name
    tree = ast.parse(rewrite(source, rng))
    function = tree.body[0]
    assert isinstance(function, ast.FunctionDef)
    function.name = f"my_{name}"
    taken = ", ".join(argument.arg for argument in function.args.args)
    parameters = ast.unparse(function.args)
    return ast.unparse(tree), form.format(name=name, parameters=parameters, taken=taken)


def _slow(typed: Typed, seconds: float) -> Typed:
    """Let the first call of an answer take some seconds."""
    tree = ast.parse(typed.source)
    function = tree.body[0]
    assert isinstance(function, ast.FunctionDef)
    lines = typed.source.splitlines()
    first = function.body[1].lineno - 1 if ast.get_docstring(function) else 1
    body = [*lines[:first], SLEEP.format(seconds=seconds), *lines[first:]]
    return replace(typed, source=SLOW + "\n".join(body))
