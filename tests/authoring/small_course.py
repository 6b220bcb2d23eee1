"""A course of short lessons with the real exercises: quick to build, run and grade."""

import subprocess
import sys
from pathlib import Path

from course_lib.exercises import CHAPTERS, all_exercises
from course_lib.judging import Explain

HEAD = """\
---
jupytext:
  text_representation:
    extension: .md
    format_name: myst
kernelspec:
  display_name: Python 3
  language: python
  name: python3
---
"""
SETUP = """\
```{code-cell} ipython3
import numpy as np

from course_lib.notebook import check
```
"""


def exercise_cell(name: str) -> str:
    return f"```{{code-cell}} ipython3\n:tags: [exercise]\n\n{name}\n```\n"


def question_cell(name: str) -> str:
    return f'+++ {{"tags": ["explain"], "exercise": "{name}"}}\n\nWhy is that so?\n\n+++\n'


def lesson(*blocks: str) -> str:
    return "\n".join([HEAD, *blocks])


def chapter_lesson(chapter: str) -> str:
    blocks = [f"# {chapter.capitalize()}\n\nSome *text*.\n", SETUP]
    for exercise in all_exercises(chapter):
        words = isinstance(exercise, Explain)
        blocks.append(question_cell(exercise.name) if words else exercise_cell(exercise.name))
        blocks.append(f"This was `{exercise.name}`.\n")
    return lesson(*blocks)


def write_course(root: Path) -> Path:
    (root / "lessons").mkdir(parents=True)
    for chapter, name in CHAPTERS.items():
        (root / "lessons" / f"{name}.md").write_text(chapter_lesson(chapter), encoding="utf-8")
    return root


def run(*command: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    """Run one of the environment's programs, as at a prompt."""
    program = [str(Path(sys.executable).with_name(command[0])), *map(str, command[1:])]
    return subprocess.run(program, cwd=cwd, capture_output=True, text=True, timeout=600)
