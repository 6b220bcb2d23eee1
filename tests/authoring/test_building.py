import json
import shutil

import nbformat
import pytest
from small_course import write_course

from course_lib.authoring import building
from course_lib.authoring.building import build, built_files, check_built, find_lessons
from course_lib.authoring.expansion import check_id, grade_id
from course_lib.authoring.options import CODE_STUB, TEXT_STUB
from course_lib.exercises import CHAPTERS, all_exercises
from course_lib.judging import Exercise, Explain, ValuesExercise

PINHOLE = "notebooks/01_pinhole/01_pinhole.ipynb"


@pytest.fixture(scope="module")
def finished(tmp_path_factory):
    """A course whose notebooks were built once, for tests that change nothing."""
    root = write_course(tmp_path_factory.mktemp("finished") / "course")
    build(root)
    return root


@pytest.fixture
def built(finished, tmp_path, monkeypatch):
    """The finished course to change, in the working directory."""
    root = shutil.copytree(finished, tmp_path / "course")
    monkeypatch.chdir(root)
    return root


@pytest.fixture
def cells(finished):
    notebook = nbformat.read(finished / PINHOLE, as_version=4)
    nbformat.validate(notebook)
    return {cell.id: cell for cell in notebook.cells}


def test_stubs_end_in_not_implemented(cells):
    for exercise in all_exercises("pinhole"):
        source = cells[grade_id(exercise.name)].source
        if isinstance(exercise, ValuesExercise):
            assert source.splitlines() == [f"{v} = None  # {u}" for v, u in exercise.units.items()]
        elif isinstance(exercise, Exercise):
            assert source.startswith(f"def {exercise.function_name}(")
            assert source.endswith("    " + CODE_STUB.replace("\n", "\n    "))
        else:
            assert source == TEXT_STUB


def test_students_see_no_solution(finished):
    text = (finished / PINHOLE).read_text(encoding="utf-8")
    for question in (e for e in all_exercises("pinhole") if isinstance(e, Explain)):
        assert json.dumps(question.model_answer)[1:-1] not in text
        assert question.rubric[0][1] not in text
    for mark in ("SOLUTION", "MARK SCHEME", "Rubric", "course_lib.checks", "answers ="):
        assert mark not in text


def test_stubs_are_not_attempted_and_checks_are_read_only(cells):
    for exercise in all_exercises("pinhole"):
        if isinstance(exercise, Exercise):
            check = cells[check_id(exercise.name)]
            assert (check.metadata.editable, check.metadata.deletable) == (False, False)
            assert cells[grade_id(exercise.name)].metadata.get("editable", True)


def test_notebooks_have_no_outputs_and_no_trace_of_the_machine(finished):
    for path in finished.glob("notebooks/*/*.ipynb"):
        notebook = json.loads(path.read_text(encoding="utf-8"))
        assert notebook["metadata"]["language_info"] == {"name": "python"}
        assert notebook["metadata"]["kernelspec"]["name"] == "python3"
        code = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
        assert all(cell["outputs"] == [] and not cell["execution_count"] for cell in code)


def test_building_again_changes_nothing(built):
    before = {p: p.stat().st_mtime_ns for p in built.glob("notebooks/*/*")}
    assert build(built) == []
    assert {p: p.stat().st_mtime_ns for p in built.glob("notebooks/*/*")} == before


def test_building_one_leaves_the_others(course):
    assert [path.name for path in build(course, ["00_welcome"])] == ["00_welcome.ipynb"]
    assert not (course / PINHOLE).exists()


def test_a_change_of_one_line_is_a_diff_of_one_line(built):
    before = (built / PINHOLE).read_text(encoding="utf-8").splitlines()
    lesson = built / "lessons/01_pinhole.md"
    lesson.write_text(lesson.read_text().replace("Some *text*.", "Other *text*."))
    build(built)
    after = (built / PINHOLE).read_text(encoding="utf-8").splitlines()
    changed = [(a, b) for a, b in zip(before, after, strict=True) if a != b]
    assert [b.strip() for _, b in changed if '"id"' not in b] == ['"Other *text*."']
    assert len(changed) == 2  # the text, and the id that follows from it


def test_pictures_go_along(course):
    (course / "lessons/figures").mkdir()
    (course / "lessons/figures/lens.png").write_bytes(b"\x89PNG")
    lesson = course / "lessons/00_welcome.md"
    lesson.write_text(lesson.read_text() + "\n![A lens.](figures/lens.png)\n")
    build(course, ["00_welcome"])
    assert (course / "notebooks/00_welcome/figures/lens.png").read_bytes() == b"\x89PNG"
    assert check_built(course, ["00_welcome"]) == []


def test_fresh_notebooks_pass(built):
    assert check_built(built) == []


def test_stale(built):
    lesson = built / "lessons/01_pinhole.md"
    lesson.write_text(lesson.read_text().replace("Some", "Any"))
    assert check_built(built) == [
        f"{PINHOLE} is not what its lesson gives; run: course build 01_pinhole"
    ]


def test_missing(built):
    (built / PINHOLE).unlink()
    assert check_built(built) == [f"{PINHOLE} is missing; run: course build 01_pinhole"]


def test_outputs(built):
    notebook = nbformat.read(built / PINHOLE, as_version=4)
    code = next(cell for cell in notebook.cells if cell.cell_type == "code")
    code.outputs = [nbformat.v4.new_output("stream", text="hello")]
    nbformat.write(notebook, built / PINHOLE)
    assert check_built(built) == [f"{PINHOLE} has outputs; run: course build 01_pinhole"]


def test_a_notebook_that_is_none(built):
    (built / PINHOLE).write_text("")
    assert "is not what its lesson gives" in check_built(built)[0]


def test_lessons_and_notebooks_that_are_left_over(built):
    (built / "lessons/00_welcome.md").unlink()
    assert check_built(built) == [
        "lessons/00_welcome.md is missing",
        "notebooks/00_welcome/00_welcome.ipynb comes from no lesson; delete it",
    ]


def test_a_bad_lesson_comes_before_stale_notebooks(built):
    lesson = built / "lessons/01_pinhole.md"
    lesson.write_text(lesson.read_text() + "\n# Second title\n")
    (found,) = check_built(built)
    assert "a second title" in found


def test_unknown_lesson(course):
    with pytest.raises(ValueError, match="no lesson '02_x'; there are 00_welcome, 01_pinhole"):
        find_lessons(course, ["02_x"])


def test_no_lessons(tmp_path):
    with pytest.raises(ValueError, match="no lessons in"):
        find_lessons(tmp_path)


def test_nbgraders_refusal_is_told(course, monkeypatch):
    monkeypatch.setattr(
        building,
        "expand",
        lambda lesson: nbformat.v4.new_notebook(
            cells=[nbformat.v4.new_code_cell("### BEGIN SOLUTION")]
        ),
    )
    with pytest.raises(RuntimeError, match="could not release 00_welcome"):
        build(course)


def test_the_repositorys_lessons_have_the_chapters_names(course):
    assert [path.stem for path in find_lessons(course)] == list(CHAPTERS.values())
    assert len(built_files(course, find_lessons(course))) == len(CHAPTERS)
