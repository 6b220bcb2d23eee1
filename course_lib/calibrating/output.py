"""The folder of a calibration: looked at before the work, and changed as a whole or not at all."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from course_lib.calibration_files import FORMS

REPORT = "report.html"
#: By these words of a report one knows that the files beside it are of an earlier run.
OURS = "<title>Calibration report</title>"


def check_output(folder: Path) -> None:
    """Raise unless files can be written in a folder, or it can be made; nothing is left behind.

    Raises
    ------
    OSError
        If not; the message says so in plain words.
    """
    there = next(f for f in (folder, *folder.absolute().parents) if f.exists())
    if not there.is_dir():
        raise OSError(f"--output {folder}: {there} is a file, and should be a folder")
    try:
        with tempfile.TemporaryDirectory(dir=there):
            pass
    except OSError as error:
        why = (error.strerror or "for an unknown reason").lower()
        raise OSError(
            f"nothing can be written in {there} ({why}): name another with --output"
        ) from None


@contextmanager
def written_together(folder: Path) -> Iterator[Path]:
    """Give an empty folder to write in; at the end, its files replace those of an earlier run.

    Whatever goes wrong before, `folder` stays as it was.
    """
    folder.mkdir(parents=True, exist_ok=True)
    draft = Path(tempfile.mkdtemp(prefix=".new-", dir=folder))
    try:
        yield draft
        new = sorted(draft.iterdir())
        for path in _of_earlier_run(folder):
            if path.name not in {file.name for file in new}:
                path.unlink()
        for path in new:
            os.replace(path, folder / path.name)
    finally:
        shutil.rmtree(draft, ignore_errors=True)


def _of_earlier_run(folder: Path) -> list[Path]:
    """Return the camera's files of an earlier run; somebody else's of the same names stay."""
    report = folder / REPORT
    if not report.is_file() or OURS not in report.read_text("utf-8", errors="replace")[:5000]:
        return []
    files = [folder / f"camera{ending}" for ending in FORMS.values()]
    return [path for path in files if path.is_file()]
