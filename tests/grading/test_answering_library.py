import subprocess
import sys

import pytest

from course_lib.exercises import CHAPTERS, all_exercises, find
from course_lib.grading.answering_library import (
    all_hidden,
    hidden_functions,
    make_library,
    source_of,
)
from course_lib.judging import Exercise


def python(library, code):
    command = [sys.executable, "-P", "-c", code]
    return subprocess.run(
        command, env={"PYTHONPATH": str(library)}, cwd="/", capture_output=True, text=True
    )


def test_a_hidden_function_refuses_and_the_rest_works(tmp_path):
    library = make_library(tmp_path, all_hidden("pinhole"))
    code = (
        f"import course_lib\nassert course_lib.__file__.startswith({str(library)!r})\n"
        "from course_lib import camera, transforms\nfrom course_lib.drawing import pinhole\n"
        "from course_lib.sandbox import hidden\n"
        "assert transforms.rotation_x(0.0).shape == (3, 3)\n"
        "try:\n    camera.dolly_zoom(1, 2, 3)\nexcept hidden.ReadyMadeError as error:\n"
        "    print(error, hidden.called)"
    )
    done = python(library, code)
    assert done.returncode == 0, done.stderr
    assert "course_lib.camera.pinhole.dolly_zoom is an exercise here" in done.stdout
    assert "{'course_lib.camera.pinhole.dolly_zoom'}" in done.stdout


def test_what_is_given_back_works_wherever_it_was_imported(tmp_path):
    every = all_hidden("epipolar")
    own = hidden_functions([find("epipolar.eight_point")])
    given_back = {name: source for name in every - own if (source := source_of(name))}
    code = (
        "import numpy as np\nfrom course_lib.sandbox import hidden\n"
        "from course_lib import epipolar\nfrom course_lib.epipolar import skew as mine\n"
        f"hidden.give_back({given_back!r})\n"
        "print(mine(np.array([1.0, 2, 3]))[0].tolist())\n"
        "try:\n    epipolar.eight_point(np.ones((8, 2)), np.ones((8, 2)))\n"
        "except hidden.ReadyMadeError as error:\n    print(error)"
    )
    done = python(make_library(tmp_path, every), code)
    assert done.stdout.startswith("[0.0, -3.0, 2.0]\n"), done.stderr
    assert "eight_point is an exercise here" in done.stdout


@pytest.mark.parametrize("chapter", CHAPTERS)
def test_all_that_is_hidden_can_be_given_back(chapter):
    for name in all_hidden(chapter):
        module, _, function = name.rpartition(".")
        if not module.startswith("course_lib.exercises"):
            assert source_of(name).startswith(f"def {function}("), name


def test_every_module_can_be_loaded_where_all_references_are_hidden(tmp_path):
    library = make_library(tmp_path, frozenset().union(*map(all_hidden, CHAPTERS)))
    files = [path.relative_to(library) for path in library.rglob("*.py")]
    names = [".".join(file.with_suffix("").parts).removesuffix(".__init__") for file in files]
    assert {"course_lib.epipolar.refinement", "course_lib.drawing.bundle"} <= {*names}
    done = python(library, f"import importlib\nfor n in {names!r}: importlib.import_module(n)")
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("module", ["exercises", "grading", "authoring", "cli"])
def test_what_no_submission_needs_is_not_there(tmp_path, module):
    library = make_library(tmp_path, frozenset())
    done = python(library, f"import course_lib.{module}")
    assert f"No module named 'course_lib.{module}'" in done.stderr
    assert not [path for path in library.rglob("*") if path.name.startswith(f"{module}.")]


@pytest.mark.parametrize("chapter", CHAPTERS)
def test_no_compiled_copy_of_a_hidden_function_is_left(tmp_path, chapter):
    hidden = all_hidden(chapter)
    library = make_library(tmp_path, hidden)
    for name in hidden:
        module, _, _ = name.rpartition(".")
        path = library.joinpath(*module.split(".")).with_suffix(".py")
        if path.exists():
            assert f"ready_made({name!r})" in path.read_text(encoding="utf-8")
            assert not list((path.parent / "__pycache__").glob(f"{path.stem}.*"))


def test_every_reference_of_a_chapter_is_hidden():
    for exercise in all_exercises("calibration"):
        if isinstance(exercise, Exercise):
            names = hidden_functions([exercise])
            assert f"{exercise.reference.__module__}.{exercise.function_name}" in names
            assert {name for name in exercise.forbidden if name.startswith("course_lib")} <= names


def test_a_class_or_a_missing_function_cannot_be_hidden(tmp_path):
    with pytest.raises(ValueError, match="is no function of its module"):
        make_library(tmp_path, frozenset({"course_lib.camera.pinhole.nothing"}))


def test_the_copy_is_made_once(tmp_path):
    hidden = all_hidden("pinhole")
    assert make_library(tmp_path, hidden) == make_library(tmp_path, hidden)
    assert len(list(tmp_path.iterdir())) == 1
