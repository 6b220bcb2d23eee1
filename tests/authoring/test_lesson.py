import pytest
from small_course import HEAD, SETUP, exercise_cell, lesson, question_cell

from course_lib.authoring.lesson import LessonError, read_lesson


def write(tmp_path, text):
    path = tmp_path / "01_pinhole.md"
    path.write_text(text, encoding="utf-8")
    return path


def test_roles_and_names(tmp_path):
    blocks = ["# T\n", SETUP, exercise_cell("pinhole.a"), question_cell("pinhole.b"), "Bye.\n"]
    read = read_lesson(write(tmp_path, lesson(*blocks)))
    assert [cell.role for cell in read.cells] == ["text", "code", "exercise", "explain", "text"]
    assert [cell.exercise for cell in read.named] == ["pinhole.a", "pinhole.b"]
    assert (read.name, read.chapter) == ("01_pinhole", "pinhole")


def test_cells_know_their_line(tmp_path):
    text = lesson("\n\n# Title\n", SETUP, question_cell("pinhole.b"), exercise_cell("pinhole.a"))
    read, lines = read_lesson(write(tmp_path, text)), text.splitlines()
    found = [lines[cell.line - 1] for cell in read.cells]
    fence = "```{code-cell} ipython3"
    assert found == ["# Title", fence, "Why is that so?", fence]


def test_a_chapter_without_exercises(tmp_path):
    path = tmp_path / "99_more.md"
    path.write_text(HEAD + "\n# More\n", encoding="utf-8")
    assert read_lesson(path).chapter == ""


@pytest.mark.parametrize(
    ("block", "message"),
    [
        (exercise_cell("pinhole.a\npinhole.b"), "holds one name"),
        (exercise_cell(""), "holds one name"),
        ('+++ {"tags": ["explain"]}\n\nWhy?\n', 'needs "exercise"'),
        ("+++ {not json}\n\nWhy?\n", "not a MyST notebook"),
    ],
)
def test_errors_name_file_and_line(tmp_path, block, message):
    with pytest.raises(LessonError, match=r"01_pinhole\.md:\d+: ") as caught:
        read_lesson(write(tmp_path, lesson("# Title\n", block)))
    assert message in str(caught.value)
