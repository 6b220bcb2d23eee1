"""The student's own copies of the notebooks; what a student wrote is never overwritten.

A small file in the work folder remembers the content that was copied last. A copy that still
has it was not edited and follows the course's updates; any other stays, and the new version
is put beside it. To run a notebook is not to edit it: only what stands in its cells counts.
"""

import hashlib
import json
import os
from collections.abc import Iterator
from pathlib import Path

from course_lib.starting.trouble import Trouble

RECORD = ".course.json"


def update(notebooks: Path, work: Path) -> list[str]:
    """Bring the student's copies up to date.

    Parameters
    ----------
    notebooks : Path
        The course's notebooks; only read.
    work : Path
        The student's folder; made if it is not there.

    Returns
    -------
    list of str
        A sentence for each file that an update touched, and one for those that are new.
    """
    if work.resolve().is_relative_to(notebooks.resolve()):
        raise Trouble(
            f"{work} holds the course's own notebooks, which an update replaces.\n"
            "Choose another folder with --work."
        )
    record = _read_record(work)
    sayings = []
    added = 0
    for name in _files(notebooks):
        new = (notebooks / name).read_bytes()
        added += not (work / name).exists()
        sayings += _update_one(work / name, new, record.setdefault(name, {}))
    _write(work / RECORD, json.dumps(record, indent=1).encode())
    return ([f"{_count(added)} copied to {work}"] if added else []) + sayings


def _update_one(target: Path, new: bytes, memory: dict[str, str]) -> list[str]:
    old = target.read_bytes() if target.exists() else None
    if old is not None and _digest(old) == _digest(new):
        memory["copied"] = _digest(new)
        return []  # the same cells; what they printed stays
    if old is None:
        saying = []
    elif _digest(old) == memory.get("copied"):
        saying = [f"{target.name}: updated (you had not changed it)."]
    elif _digest(new) in memory.values():
        return []  # the student's own version, and no update since it was last looked at
    else:
        return _offer(target, new, memory)
    _write(target, new)
    memory["copied"] = _digest(new)
    return saying


def _offer(target: Path, new: bytes, memory: dict[str, str]) -> list[str]:
    """Put a new version beside the student's; only an untouched earlier offer is replaced."""
    for beside in _names_beside(target):
        if not beside.exists() or _digest(beside.read_bytes()) == memory.get("offered"):
            _write(beside, new)
        if _digest(beside.read_bytes()) == _digest(new):
            break
    memory["offered"] = _digest(new)
    return [f"{target.name}: yours was kept; the course's update is beside it as {beside.name}"]


def _names_beside(target: Path) -> Iterator[Path]:
    number = 1
    while True:
        suffix = f" {number}" if number > 1 else ""
        yield target.with_name(f"{target.stem} (new version{suffix}){target.suffix}")
        number += 1


def _files(notebooks: Path) -> list[str]:
    paths = (path.relative_to(notebooks) for path in notebooks.rglob("*"))
    visible = (path for path in paths if not any(part.startswith(".") for part in path.parts))
    return sorted(path.as_posix() for path in visible if (notebooks / path).is_file())


def _read_record(work: Path) -> dict[str, dict[str, str]]:
    try:
        record = json.loads((work / RECORD).read_text("utf-8"))
    except (OSError, ValueError):
        return {}  # then every changed file counts as edited, which is the safe side
    entries = record.items() if isinstance(record, dict) else ()
    return {name: memory for name, memory in entries if isinstance(memory, dict)}


def _write(path: Path, content: bytes) -> None:
    # In one stroke, so that a full disk or a kill leaves the old file or the new one.
    path.parent.mkdir(parents=True, exist_ok=True)
    new = path.with_name(f".{path.name}.{os.getpid()}.new")
    try:
        new.write_bytes(content)
        new.replace(path)
    finally:
        new.unlink(missing_ok=True)


def _digest(content: bytes) -> str:
    return hashlib.sha256(_what_is_written(content)).hexdigest()


def _what_is_written(content: bytes) -> bytes:
    """Return the cells of a notebook without what running it adds; any other file as it is."""
    try:
        cells = json.loads(content)["cells"]
        kept = [
            {
                "type": cell["cell_type"],
                "source": "".join(cell["source"]),
                "attachments": cell.get("attachments"),
                "nbgrader": cell["metadata"].get("nbgrader"),
            }
            for cell in cells
        ]
    except (ValueError, KeyError, TypeError, AttributeError):
        return content
    return json.dumps(kept, sort_keys=True).encode()


def _count(added: int) -> str:
    return "One file was" if added == 1 else f"{added} files were"
