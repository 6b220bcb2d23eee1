"""What the handbook tells an instructor to type is understood, and its links lead somewhere."""

import re
import shlex
from pathlib import Path

import pytest

from course_lib.cli import _parser

DOCS = Path(__file__).resolve().parents[1] / "docs"
HANDBOOK = (DOCS / "teaching.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"(?ms)^```\n(.*?)^```", HANDBOOK)
LINES = [line for block in BLOCKS for line in block.splitlines()]
SPANS = re.findall(r"`([^`\n]+)`", re.sub(r"(?ms)^ *```.*?^ *```", "", HANDBOOK))
TYPED = [part.split("#")[0].strip() for text in (*LINES, *SPANS) for part in text.split(" && ")]
COMMANDS = {
    text.replace("…", "DIR").removeprefix(".venv/bin/course ").removeprefix("course ")
    for text in TYPED
    if text.startswith((".venv/bin/course ", "course "))
}


def test_every_command_for_a_term_occurs():
    assert {command.split()[0] for command in COMMANDS} == {
        *("demo", "term", "grade", "report", "export")
    }


@pytest.mark.parametrize("command", sorted(COMMANDS))
def test_commands_are_understood(command):
    assert _parser().parse_args(shlex.split(command)).run


def test_links_lead_somewhere():
    for file, place in re.findall(r"\]\((\w+\.md)(?:#([\w-]+))?\)", HANDBOOK):
        text = (DOCS / file).read_text(encoding="utf-8")
        heads = {head.lower().replace(" ", "-") for head in re.findall(r"(?m)^#+ (.*)$", text)}
        assert not place or place in heads, place
