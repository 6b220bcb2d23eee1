"""What README and handbook tell people to type is understood, and their links lead somewhere."""

import re
import runpy
import shlex
from pathlib import Path

import pytest

from course_lib.cli import _parser
from course_lib.exercises import CHAPTERS, all_exercises
from course_lib.judging import Explain

ROOT = Path(__file__).resolve().parents[1]
NAMES = ("README.md", "docs/teaching.md", "docs/grading.md")
TEXTS = {name: (ROOT / name).read_text(encoding="utf-8") for name in NAMES}
FENCED = r"(?ms)^ *```.*?^ *```"


def commands(text):
    """Return what follows ``course`` in all that a text tells to type."""
    lines = [line for block in re.findall(FENCED, text) for line in block.splitlines()]
    spans = re.findall(r"`([^`\n]+)`", re.sub(FENCED, "", text))
    typed = [part.split("#")[0].strip() for given in (*lines, *spans) for part in given.split("&&")]
    found = (re.match(r" *(?:\.venv/bin/)?course (.*)", part) for part in typed)
    return {match[1].replace("…", "DIR") for match in found if match}


COMMANDS = {name: commands(text) for name, text in TEXTS.items()}


def test_every_command_occurs():
    first = {name: {command.split()[0] for command in found} for name, found in COMMANDS.items()}
    assert first["docs/teaching.md"] == {"demo", "term", "grade", "report", "export"}
    assert first["README.md"] == {"build", "calibrate", "demo", "grade", "target", "term"}
    assert first["docs/grading.md"] == {"export", "grade", "report", "term"}


@pytest.mark.parametrize("command", sorted(set.union(*COMMANDS.values())))
def test_commands_are_understood(command):
    words = shlex.split(command)
    if len(words) > 1:
        assert _parser().parse_args(words).run
    else:  # only named, in a sentence
        with pytest.raises(SystemExit, match=r"^0$"):
            _parser().parse_args([*words, "--help"])


def test_links_lead_somewhere():
    link = r"\]\((?!https?://)([^)#]*)(?:#([^)]+))?\)"
    links = [(name, *found) for name in NAMES for found in re.findall(link, TEXTS[name])]
    assert len(links) > 10
    for name, file, head in links:
        path = (ROOT / name).parent / file if file else ROOT / name
        assert path.exists(), file
        assert not head or head in heads(path.read_text(encoding="utf-8")), head


def heads(text):
    """Return what the headings of a text are called in links."""
    found = re.findall(r"(?m)^#+ (.*)$", re.sub(FENCED, "", text))
    return {re.sub(r"[^\w\- ]", "", head.lower()).replace(" ", "-") for head in found}


def test_the_picture_of_a_verdict_shows_what_the_readme_says():
    made = runpy.run_path(str(ROOT / "docs/make_pictures.py"))
    verdict = made["example_verdict"]()
    assert (verdict.points, verdict.possible) == (4, 6)
    assert [part.points == part.possible for part in verdict.parts] == [True, True, True, False]
    assert "three parts are right, one is not; a hint asks whether light" in TEXTS["README.md"]
    assert "light from behind the camera reach the picture" in verdict.hints[0]


def test_every_picture_is_shown():
    shown = set(re.findall(r"\(docs/pictures/([^)]+)\)", TEXTS["README.md"]))
    assert shown == {path.name for path in (ROOT / "docs/pictures").iterdir()}


def test_the_readme_names_every_package():
    named = set(re.findall(r"`(?:course_lib/)?(\w+)`", TEXTS["README.md"]))
    packages = {path.parent.name for path in ROOT.glob("course_lib/*/__init__.py")}
    assert packages - named == set()


@pytest.mark.parametrize("module", CHAPTERS)
def test_the_readme_tells_of_every_chapter(module):
    name = CHAPTERS[module]
    row = re.search(rf"(?m)^\| {name[:2]} \|.*\| (.*) \| (.*) \|$", TEXTS["README.md"])
    words = sum(isinstance(e, Explain) for e in all_exercises(module))
    graded = len(all_exercises(module)) - words
    practice = module == "welcome"
    said = f"{graded} for practice" if practice else f"{graded}, and {words} in words"
    assert row[2] == (said if graded else f"{words} in words")
    lesson = (ROOT / f"lessons/{name}.md").read_text(encoding="utf-8")
    time = re.search(r"(?s)\*\*Time:\*\*.*?\n\n", lesson)
    if time and module != "pinhole":  # which gives its two halves as one
        main_line = re.findall(r"\d+", row[1].partition(";")[0])
        assert set(main_line) <= set(re.findall(r"\d+", time[0]))
