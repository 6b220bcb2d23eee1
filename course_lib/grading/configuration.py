"""nbgrader's options for a term of the course: what `nbgrader_config.py` there asks for."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from nbgrader.converters import Autograde
from nbgrader.preprocessors import ClearOutput, Execute, OverwriteCells
from traitlets.config import Config

from course_lib.authoring.options import find_scripts, release_options
from course_lib.grading.collecting import CollectFiles
from course_lib.grading.feedback_page import FeedbackPage
from course_lib.grading.labelling import LabelCells
from course_lib.grading.plugin import AnswerOutside
from course_lib.grading.receipts import write_receipts
from course_lib.grading.restoring import RestoreCells
from course_lib.grading.seeding import read_key


def configure(options: Config, key_file: str | Path) -> None:
    """Plug the course into nbgrader; its own commands and buttons stay as they are.

    Parameters
    ----------
    options : traitlets.config.Config
        ``c`` of ``nbgrader_config.py``; changed in place.
    key_file : path
        Where the term's key is.

    Raises
    ------
    SystemExit
        If there is no key. nbgrader would report any other error and go on without the course,
        and ``autograde --force`` would remove what was graded before it missed the key.
    """
    try:
        read_key(Path(key_file))
    except ValueError as error:
        raise SystemExit(f"nbgrader_config.py: {error}.") from error
    find_scripts()
    options.merge(release_options())
    options.AnswerOutside.key_file = str(key_file)
    usual = _usual("sanitize_preprocessors").put(RestoreCells, before=OverwriteCells)
    options.Autograde.sanitize_preprocessors = usual.put(LabelCells, before=ClearOutput)
    options.Autograde.autograde_preprocessors = _usual("autograde_preprocessors").swap(
        Execute, [AnswerOutside]
    )
    options.ExchangeFactory.collect = CollectFiles
    options.GenerateFeedback.pre_convert_hook = write_receipts
    options.GenerateFeedback.exporter_class = FeedbackPage


class _Steps(list[type]):
    """nbgrader's list of preprocessors, with ours among them."""

    def put(self, step: type, before: type) -> _Steps:
        return self.swap(before, [step, before])

    def swap(self, old: type, new: list[type]) -> _Steps:
        at = self.index(old)
        return _Steps([*self[:at], *new, *self[at + 1 :]])


def _usual(name: str) -> _Steps:
    steps: Any = Autograde.class_traits()[name].default()
    return _Steps(steps)
