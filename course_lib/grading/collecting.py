"""`nbgrader collect` without following links: they would be read with the instructor's rights.

Whatever a link in the exchange leads to, nbgrader copies it into the submission, where the
student's own notebook can read it: the term's key, say, or the gradebook.
"""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from nbgrader.exchange.default import ExchangeCollect


class CollectFiles(ExchangeCollect):  # type: ignore[misc]
    """Collects files and folders only; what cannot be collected stops nobody else's."""

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
            if os.path.islink(src):
                raise OSError("it is a link")
            with TemporaryDirectory(prefix=".collect-", dir=parent) as folder:
                self._copy_files(src, Path(folder, "copy"))
                super().do_copy(os.path.join(folder, "copy"), dest, log)
        except (OSError, RuntimeError) as error:
            self.log.error("Not collected: %s (%s)", src, str(error)[:300])

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
