import subprocess
import sys

import pytest

from course_lib.exercises import CHAPTERS, all_exercises
from course_lib.grading.answering_library import all_hidden, hidden_functions, make_library
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
