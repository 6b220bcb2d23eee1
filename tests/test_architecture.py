"""The house rules: imports point one way, rooms stay small, importing costs little."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
MATHEMATICS = {
    "boards",
    "bundle",
    "calibration",
    "camera",
    "checks",
    "correspondences",
    "distortion",
    "epipolar",
    "homogeneous",
    "homography",
    "illumination",
    "least_squares",
    "measuring",
    "optics",
    "orientation",
    "planning",
    "reconstruction",
    "resection",
    "sensor",
    "similarity",
    "transforms",
    "triangulation",
}
#: Modules of data_generators that write submissions; they stand above the exercises.
CLASS_MAKERS = {"classes", "everyday_class", "mishaps", "typed_answers", "unusual"}
#: Which of the project's packages each may import; the mathematics is always allowed.
MAY_IMPORT = {
    "data_generators": set(),
    "data_generators.classes": {
        "data_generators",
        "course_lib.judging",
        "course_lib.exercises",
        "course_lib.authoring",
        "course_lib.notebook",
    },
    "course_lib.calibrating": {
        "course_lib.calibration_files",
        "course_lib.detection",
        "course_lib.page",
        "data_generators",
    },
    "course_lib.data": set(),
    "course_lib.lab": {
        "course_lib.calibrating",
        "course_lib.data",
        "course_lib.detection",
        "course_lib.display",
        "course_lib.drawing",
        "course_lib.page",
        "course_lib.remapping",
        "data_generators",
    },
    "course_lib.tie_points": {"course_lib.detection"},
    "course_lib.judging": set(),
    "course_lib.drawing": {
        "data_generators",
        "course_lib.data",
        "course_lib.detection",
        "course_lib.display",
        "course_lib.remapping",
        "course_lib.tie_points",
    },
    "course_lib.exercises": {"course_lib.judging", "course_lib.drawing"},
    "course_lib.widgets": {
        "course_lib.calibrating",
        "course_lib.detection",
        "course_lib.display",
        "course_lib.drawing",
        "course_lib.lab",
        "course_lib.remapping",
        "course_lib.tie_points",
        "data_generators",
    },
    "course_lib.environment": {"course_lib.display"},
    "course_lib.notebook": {"course_lib.judging", "course_lib.exercises", "course_lib.display"},
    "course_lib.authoring": {"course_lib.judging", "course_lib.exercises", "course_lib.notebook"},
    "course_lib.sandbox": {"course_lib.judging"},
    "course_lib.grading": {
        "course_lib.page",
        "course_lib.sandbox",
        "data_generators",
        "data_generators.classes",
        "course_lib.judging",
        "course_lib.exercises",
        "course_lib.notebook",
        "course_lib.authoring",
    },
}
OUTSIDE = {
    "course_lib.judging": {"jupyter", "IPython", "ipywidgets", "anywidget", "matplotlib", "cv2"},
    "mathematics": {"jupyter", "IPython", "ipywidgets", "matplotlib", "cv2", "skimage"},
}


def modules() -> list[Path]:
    """Return the project's own modules."""
    return [*ROOT.glob("course_lib/**/*.py"), *ROOT.glob("data_generators/**/*.py")]


def room_of(parts: list[str]) -> str:
    """Return the room of a dotted name: a package, or a module of course_lib."""
    if parts[0] == "data_generators":
        maker = len(parts) > 1 and parts[1] in CLASS_MAKERS
        return "data_generators.classes" if maker else "data_generators"
    return "mathematics" if parts[1] in MATHEMATICS else f"course_lib.{parts[1]}"


def room(path: Path) -> str:
    """Return the room that a file belongs to."""
    return room_of(list(path.relative_to(ROOT).with_suffix("").parts))


def imported(path: Path) -> set[str]:
    """Return the full names of the modules that a file imports, anywhere in it."""
    names = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            names |= {f"{node.module}.{alias.name}" for alias in node.names}
    return names


def own_room(name: str) -> str | None:
    """Return the room that an imported name belongs to, or None for another library."""
    parts = name.split(".")
    if parts[0] == "data_generators" or (parts[0] == "course_lib" and len(parts) > 1):
        return room_of(parts)
    return None


@pytest.mark.parametrize("path", modules(), ids=lambda p: str(p.relative_to(ROOT)))
def test_imports_point_one_way(path):
    here = room(path)
    if here in ("course_lib.cli", "course_lib.__init__", "course_lib.__main__"):
        return  # the top of the house
    rooms = {found for name in imported(path) if (found := own_room(name))}
    allowed = MAY_IMPORT.get(here, set()) | {"mathematics", here}
    assert rooms <= allowed, f"{here} must not import {sorted(rooms - allowed)}"


@pytest.mark.parametrize("path", modules(), ids=lambda p: str(p.relative_to(ROOT)))
def test_lower_rooms_know_no_front_end(path):
    heads = {name.partition(".")[0] for name in imported(path)}
    assert not heads & OUTSIDE.get(room(path), set())


def code_lines(function: ast.AST, source: list[str]) -> int:
    """Count the lines of a function's body without docstring, comments and blank lines."""
    body = function.body
    if isinstance(body[0], ast.Expr) and isinstance(body[0].value, ast.Constant):
        body = body[1:]
    if not body:
        return 0
    lines = source[body[0].lineno - 1 : body[-1].end_lineno]
    return sum(1 for line in lines if line.strip() and not line.strip().startswith("#"))


@pytest.mark.parametrize("path", modules(), ids=lambda p: str(p.relative_to(ROOT)))
def test_rooms_stay_small(path):
    text = path.read_text(encoding="utf-8")
    source = text.splitlines()
    assert len(source) <= 300, "split this module: the budget is 300 lines"
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.FunctionDef):
            assert code_lines(node, source) <= 25, f"{node.name}: the budget is 25 lines"


def test_importing_the_mathematics_loads_only_numpy():
    code = (
        "import sys, course_lib\n"
        f"from course_lib import {', '.join(sorted(MATHEMATICS))}\n"
        "heads = {name.partition('.')[0] for name in sys.modules}\n"
        "print(sorted(heads & {'cv2', 'matplotlib', 'IPython', 'ipywidgets', 'scipy', 'skimage',"
        " 'anywidget', 'jupyter_server', 'nbformat'}))"
    )
    result = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True
    )
    assert result.stdout.strip() == "[]"
