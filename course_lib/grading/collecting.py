"""`nbgrader collect` without following links: they would be read with the instructor's rights.

Whatever a link in the exchange leads to, nbgrader copies it into the submission, where the
student's own notebook can read it: the term's key, say, or the gradebook. And it ends with a stack
trace, having collected nothing, where a student gave a folder or a time a form that it never has.
"""

from __future__ import annotations

import os
import shutil
from datetime import datetime
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from nbgrader.exchange.default import ExchangeCollect

from course_lib.grading.parcels import shown
from course_lib.grading.submissions import handed_in_at


class CollectFiles(ExchangeCollect):  # type: ignore[misc]
    """Collects files and folders only; what cannot be collected stops nobody else's."""

    src_records: list[dict[str, Any]]

    def init_src(self) -> None:
        """Look for what was handed in; whatever `nbgrader submit` cannot have made is left out."""
        super().init_src()
        self.src_records = [record for record in self.src_records if record["username"]]

    def _path_to_record(self, path: str) -> dict[str, Any]:
        try:
            _demand_folder(path)
            found: dict[str, Any] = super()._path_to_record(path)
        except (OSError, ValueError, ArithmeticError, TypeError) as error:
            self._leave(path, error)
            return {"username": "", "filename": "", "timestamp": datetime.min}  # it is nobody's
        return found

    def do_copy(self, src: str, dest: str, log: Any = None) -> None:
        """Copy a submission from the exchange.

        Parameters
        ----------
        src, dest : str
            Folders; the second does not exist yet.
        log : object
            As nbgrader has it.
        """
        parent = Path(dest).parent
        try:
            _demand_folder(src)
            with TemporaryDirectory(prefix=".collect-", dir=parent) as folder:
                self._copy_files(src, Path(folder, "copy"))
                super().do_copy(os.path.join(folder, "copy"), dest, log)
        except (OSError, RuntimeError) as error:
            self._leave(src, error)

    def _leave(self, src: str, error: Exception) -> None:
        self.log.error("Not collected: %s (%s)", shown(src), shown(str(error)[:300]))

    def _copy_files(self, src: str, copy: Path) -> None:
        if self.get_size(src) > 1000 * self.coursedir.max_dir_size:
            raise RuntimeError("it is too large")
        try:
            shutil.copytree(src, copy, symlinks=True)
        except shutil.Error as error:  # all else is copied
            self.log.warning("Not all of %s is a file: %s", src, str(error)[:300])
        for path in copy.rglob("*"):
            if path.is_symlink():
                self.log.warning("Left out, because it is a link: %s in %s", path.name, src)
                path.unlink()
        stamp = copy / "timestamp.txt"
        if stamp.exists() and not handed_in_at(copy):
            self.log.warning("Left out, because it is no time: %s in %s", stamp.name, src)
            shutil.rmtree(stamp) if stamp.is_dir() else stamp.unlink()


def _demand_folder(path: str) -> None:
    if os.path.islink(path) or not os.path.isdir(path):
        raise OSError("it is no folder")
