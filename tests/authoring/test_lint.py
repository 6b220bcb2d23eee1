import pytest
from small_course import SETUP, chapter_lesson, exercise_cell

from course_lib.authoring.lesson import read_lesson
from course_lib.authoring.lint import LONGEST_CELL, lint, pictures


def problems(tmp_path, extra="", chapter="welcome", name="00_welcome", drop=""):
    path = tmp_path / f"{name}.md"
    text = chapter_lesson(chapter).replace(drop, "") if drop else chapter_lesson(chapter)
    path.write_text(f"{text}\n{extra}", encoding="utf-8")
    return [str(problem) for problem in lint(path)]


def code(lines):
    return "```{code-cell} ipython3\n" + "x = 1\n" * lines + "```\n"


@pytest.mark.parametrize(
    ("extra", "message"),
    [
        (code(LONGEST_CELL + 1), f"a code cell of {LONGEST_CELL + 1} lines"),
        ("# Again\n", "a second title '# Again'"),
        (exercise_cell("welcome.image_centre"), "stands in the lesson twice"),
        (exercise_cell("pinhole.dolly_zoom"), "is an exercise of another chapter"),
        (exercise_cell("welcome.image_center"), "did you mean welcome.image_centre"),
        ("![](picture.png)\n", "the picture picture.png has no text alternative"),
        ("![A lens.](lost.png)\n", "there is no file lost.png beside the lesson"),
        ('<img src="picture.png">\n', "an <img> has no text alternative"),
        ('<img src="picture.png" alt="">\n', "an <img> has no text alternative"),
    ],
)
def test_each_rule(tmp_path, extra, message):
    (tmp_path / "picture.png").write_bytes(b"")
    found = problems(tmp_path, extra)
    assert len(found) == 1
    assert message in found[0]


@pytest.mark.parametrize(
    "extra",
    [
        code(LONGEST_CELL),
        "## Section\n",
        "```\n# not a title\n![](not a picture)\n```\n",
        "![A lens.](picture.png)\n",
        '![A lens.](picture.png "with a title")\n',
        '<img src="https://example.org/a.png" alt="A lens.">\n',
    ],
)
def test_what_is_well_formed_passes(tmp_path, extra):
    (tmp_path / "picture.png").write_bytes(b"")
    assert problems(tmp_path, extra) == []


def test_no_title(tmp_path):
    assert problems(tmp_path, drop="# Welcome") == [
        f"{tmp_path.name}/00_welcome.md:1: the lesson has no title; begin it with a line `# Title`"
    ]


def test_an_exercise_left_out(tmp_path):
    found = problems(tmp_path, drop=exercise_cell("welcome.image_centre"))
    assert len(found) == 1
    assert "leaves out the exercise welcome.image_centre" in found[0]


def test_problems_name_their_line(tmp_path):
    extra = "One.\nTwo.\n![](https://example.org/three.png)\n"
    text = chapter_lesson("welcome") + "\n" + extra
    line = text.splitlines().index("![](https://example.org/three.png)") + 1
    assert problems(tmp_path, extra)[0].startswith(f"{tmp_path.name}/00_welcome.md:{line}: ")


def test_pictures_are_those_in_files(tmp_path):
    path = tmp_path / "00_welcome.md"
    text = "# T\n\n![a](b/c.png) ![d](https://example.org/e.png)\n\n![f](b/c.png)\n"
    path.write_text(SETUP + text, encoding="utf-8")
    assert pictures(read_lesson(path)) == ["b/c.png"]
