"""The secret of a term: a key, and a seed for each student and assignment derived from it."""

from __future__ import annotations

import hashlib
import hmac
import os
import secrets
from pathlib import Path
from typing import Any

from nbclient.exceptions import DeadKernelError
from nbformat import NotebookNode
from nbgrader.preprocessors import Execute
from nbgrader.utils import is_grade
from traitlets import List, Unicode

from course_lib.grading.verdicts import STOPPED, no_points
from course_lib.notebook import GRADING_SEED

#: Without it, exit() in a cell ends the kernel a tenth of a second later, and the score depends on
#: how many cells are faster than that.
NO_EXIT = "--IPKernelApp.exec_lines=get_ipython().ask_exit = lambda: None"


def write_key(path: Path) -> None:
    """Write a new random key that only its owner can read.

    Parameters
    ----------
    path : pathlib.Path
        A file that does not exist yet.
    """
    descriptor = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
    with os.fdopen(descriptor, "w", encoding="ascii") as file:
        file.write(secrets.token_hex(32) + "\n")


def read_key(path: Path) -> bytes:
    """Read a term's key.

    Parameters
    ----------
    path : pathlib.Path
        Written by `write_key`.

    Returns
    -------
    bytes
        The key.

    Raises
    ------
    ValueError
        If there is no key, or too little of it to be one.
    """
    text = path.read_text(encoding="ascii").strip() if path.is_file() else ""
    if len(text) < 32:
        raise ValueError(
            f"no key in {path}: without it nothing can be graded. Restore it from a backup; "
            "a new one gives students other hidden inputs than before"
        )
    return text.encode()


def grading_seed(key: bytes, student: str, assignment: str) -> str:
    """Return the seed of a student's hidden inputs in an assignment.

    Parameters
    ----------
    key : bytes
        The term's key.
    student, assignment : str
        As nbgrader names them.

    Returns
    -------
    str
        64 hexadecimal digits (HMAC-SHA256): the same each time, and no way back to the key.
    """
    words = "\x1f".join([student, assignment]).encode()
    return hmac.new(key, words, hashlib.sha256).hexdigest()


class ExecuteWithSeed(Execute):  # type: ignore[misc]
    """Execute a submission while `GRADING_SEED` holds the student's seed.

    The kernel inherits the seed, never the key; afterwards the variable is gone again, also from
    a JupyterLab in which formgrader runs.
    """

    key_file = Unicode(help="The file with the term's key.").tag(config=True)
    extra_arguments = List([NO_EXIT]).tag(config=True)

    def preprocess(
        self, nb: NotebookNode, resources: dict[str, Any], km: Any = None
    ) -> tuple[NotebookNode, dict[str, Any]]:
        """Execute one notebook."""
        who = resources["nbgrader"]
        seed = grading_seed(read_key(Path(self.key_file)), who["student"], who["assignment"])
        os.environ[GRADING_SEED] = seed
        try:
            super().preprocess(nb, resources, km)  # changes the notebook in place
        except DeadKernelError:
            self.log.warning("The submission of %s stopped its own kernel", who["student"])
            _say_what_was_not_reached(nb)
        finally:
            del os.environ[GRADING_SEED]
        return nb, resources


def _say_what_was_not_reached(nb: NotebookNode) -> None:
    for cell in nb.cells:
        if cell.cell_type == "code" and is_grade(cell) and not cell.outputs:
            cell.outputs = [no_points("PythonStopped", STOPPED)]
