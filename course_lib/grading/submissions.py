"""Read what was handed in: a notebook and what lies beside it, whatever state it is in."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from functools import cache
from itertools import islice
from pathlib import Path
from typing import Any

import nbformat
from nbformat import NotebookNode
from nbgrader.utils import parse_utc

#: Bytes of a notebook, and of all files beside it, that are still read.
MOST_NOTEBOOK, MOST_FILES = 30_000_000, 15_000_000
#: Cells, and letters in them, that are still graded: the grader reads them all with nobody to stop
#: it. The course's notebooks have a tenth of it.
MOST_CELLS, MOST_LETTERS = 2000, 500_000
#: Where a cell has its letters; the second in files of before 2014.
TEXTS = ("source", "input")
#: Files beside a notebook that are still looked at, and bytes of one that tell versions apart.
MOST_BESIDE, MOST_COMPARED = 1000, 100_000_000
#: What nbgrader leaves out when it copies a submission.
NOT_COPIED = {"__pycache__", ".ipynb_checkpoints"}
#: What nbgrader puts beside a notebook; it concerns no program.
RECEIPTS = {"timestamp.txt", "submission_secret.txt"}
#: Bytes of a time.
MOST_TIME = 100
#: Pictures of the text; no program reads them.
PICTURES = {".png", ".jpg", ".jpeg", ".svg", ".gif"}


class UnreadableError(ValueError):
    """A submission cannot be graded; the message is a sentence for the student."""


def read_content(path: Path) -> bytes:
    """Read a submitted notebook's file.

    Parameters
    ----------
    path : pathlib.Path
        The file.

    Returns
    -------
    bytes
        What is in it.

    Raises
    ------
    UnreadableError
        If it is no file, too large or empty; the message says so and what to do.
    """
    if path.is_symlink() or not path.is_file():
        raise UnreadableError("The notebook is no ordinary file. Please hand in the file itself.")
    if path.stat().st_size > MOST_NOTEBOOK:
        size = path.stat().st_size / 1e6
        raise UnreadableError(
            f"The notebook has {size:.0f} MB, which is too much to grade. Please clear its outputs "
            "(menu Edit, Clear Outputs of All Cells), save it and hand it in again."
        )
    content = path.read_bytes()
    if not content.strip():
        raise UnreadableError("The file is empty. Please hand in the notebook again.")
    return content


def read_notebook(content: bytes) -> NotebookNode:
    """Read a submitted notebook.

    Parameters
    ----------
    content : bytes
        From `read_content`.

    Returns
    -------
    nbformat.NotebookNode
        In the current format.

    Raises
    ------
    UnreadableError
        If it is no notebook; the message says what is wrong and what to do.
    """
    try:
        return _parsed(content)
    except UnreadableError:
        raise
    except Exception as error:  # a file may hold anything
        raise UnreadableError(_what_is_wrong(error)) from None


def _parsed(content: bytes) -> NotebookNode:
    text = content.decode("utf-8-sig")
    tree = json.loads(text)
    if not isinstance(tree, dict) or "nbformat" not in tree:
        raise UnreadableError(
            "The file is no Jupyter notebook. Please hand in the .ipynb file that you were given."
        )
    demand_size(tree)
    json.dumps(tree, ensure_ascii=False).encode()  # half letters cannot be written
    notebook = nbformat.convert(nbformat.reader.reads(text), 4)
    notebook.nbformat_minor = max(int(notebook.get("nbformat_minor", 0)), 5)
    _, notebook = nbformat.validator.normalize(notebook, strip_invalid_metadata=True)
    nbformat.validate(notebook)
    return notebook


def demand_size(notebook: Mapping[str, Any]) -> None:
    """Make sure that a notebook is not so long that it keeps the grader from the others.

    Parameters
    ----------
    notebook : mapping
        As in its file, whatever is in it, or read already.

    Raises
    ------
    UnreadableError
        If it has too many cells or letters; the message says so and what to do.
    """
    sheets = [notebook, *(s for s in _items(notebook, "worksheets") if isinstance(s, Mapping))]
    cells = [cell for sheet in sheets for cell in _items(sheet, "cells")]
    letters = sum(len(str(c.get(k, ""))) for c in cells if isinstance(c, Mapping) for k in TEXTS)
    if len(cells) > MOST_CELLS or letters > MOST_LETTERS:
        raise UnreadableError(
            f"The notebook has {len(cells)} cells with {letters} letters, which is too much to "
            "grade. Please keep your answers and remove what is not needed, and hand it in again."
        )


def _items(part: Mapping[str, Any], name: str) -> Sequence[Any]:
    found = part.get(name)
    return found if isinstance(found, list) else ()


def _what_is_wrong(error: Exception) -> str:
    if isinstance(error, json.JSONDecodeError):
        return (
            f"The notebook's file is damaged (line {error.lineno} is not what it should be), "
            "perhaps because it was not saved or copied to its end. Please open it in JupyterLab, "
            "save it and hand it in again."
        )
    if isinstance(error, UnicodeDecodeError):
        return (
            "The notebook's file is damaged: it holds bytes that are no text. Please save it in "
            "JupyterLab and hand it in again."
        )
    return (
        "The notebook's file is damaged: its cells are not what JupyterLab writes. Please open it "
        "in JupyterLab, save it and hand it in again."
    )


@cache
def given_cells(released: Path) -> tuple[str, ...]:
    """Return the sources of the cells without a label that students were given.

    Parameters
    ----------
    released : pathlib.Path
        The notebook in the term's ``release``; without it nothing counts as given.
    """
    if not released.is_file():
        return ()
    notebook = nbformat.read(released, as_version=4)
    code = (cell for cell in notebook.cells if cell.cell_type == "code")
    return tuple(cell.source for cell in code if not cell.metadata.get("nbgrader"))


def files_beside(folder: Path) -> dict[str, bytes]:
    """Read what a program may want to read beside its notebook, up to a size.

    Parameters
    ----------
    folder : pathlib.Path
        A submission's folder. Links are not followed: they could lead anywhere.

    Returns
    -------
    dict of str to bytes
        By path in the folder.
    """
    found: dict[str, bytes] = {}
    left = MOST_FILES
    for path in all_beside(folder):
        name = path.relative_to(folder)
        hidden = any(part.startswith(".") for part in name.parts[:-1])
        if hidden or path.name in RECEIPTS or path.suffix.lower() in PICTURES:
            continue
        left -= path.stat().st_size
        if left < 0:
            return found
        found[name.as_posix()] = path.read_bytes()
    return found


def all_beside(folder: Path) -> Iterator[Path]:
    """Return the files beside the notebooks of a folder, in the folders below it, too.

    Parameters
    ----------
    folder : pathlib.Path
        A submission's, or the source's. Links are left out: they could lead anywhere.

    Returns
    -------
    iterator of pathlib.Path
        In the same order for the same files; one more than `MOST_BESIDE` at most.
    """
    return islice(_everything_beside(folder), MOST_BESIDE + 1)


def _everything_beside(folder: Path) -> Iterator[Path]:
    for place, folders, names in os.walk(folder):
        folders[:] = sorted(name for name in folders if name not in NOT_COPIED)
        for name in sorted(names):
            path = Path(place, name)
            if path.suffix != ".ipynb" and not path.is_symlink() and path.is_file():
                yield path


def handed_in_at(folder: Path) -> str:
    """Return when a submission was handed in, as nbgrader noted it.

    Parameters
    ----------
    folder : pathlib.Path
        The submission's.

    Returns
    -------
    str
        Nothing if that is no time, or no ordinary file: students can write it, too.
    """
    path = folder / "timestamp.txt"
    if path.is_symlink() or not path.is_file() or path.stat().st_size > MOST_TIME:
        return ""
    try:
        text = path.read_text(encoding="utf-8").strip()
        parse_utc(text)
    except (ValueError, ArithmeticError, TypeError):
        return ""
    return text


def fingerprint(folder: Path, notebooks: Iterable[str]) -> str:
    """Return what tells one version of a submission from another; when it came does not count.

    Parameters
    ----------
    folder : pathlib.Path
        The submission's.
    notebooks : iterable of str
        Names of the notebooks that are graded.

    Returns
    -------
    str
        A hash of the notebooks and of what lies beside them.
    """
    digest = hashlib.sha256()
    files = [(name, folder / f"{name}.ipynb") for name in sorted(notebooks)]
    beside = [path for path in all_beside(folder) if path.name not in RECEIPTS]
    files += [(path.relative_to(folder).as_posix(), path) for path in beside]
    for name, path in files:
        with suppress(OSError):  # who grades it says what is wrong with it
            _digest(digest, name, path)
    return digest.hexdigest()


def _digest(digest: Any, name: str, path: Path) -> None:
    if path.is_file() and not path.is_symlink():
        digest.update(f"{name}\x1f{path.stat().st_size}\x1f".encode())
        with path.open("rb") as file:
            while file.tell() < MOST_COMPARED and (part := file.read(1 << 20)):
                digest.update(part)
