"""The lock files: every package with its version and hashes, for all systems, no addresses."""

import shutil
import subprocess
from pathlib import Path

from course_lib.starting.environment import LOCKS
from course_lib.starting.trouble import Trouble

# The course is installed without build isolation, so what builds it is pinned as well.
BUILD = "hatchling\neditables\n"
OPTIONS = [
    "--universal",
    "--generate-hashes",
    "--no-header",
    "--no-annotate",
    "--python-version=3.11",
    "--quiet",
]


def renew(root: Path, arguments: list[str]) -> int:
    """Write both lock files from pyproject.toml, with ``uv``.

    Versions that the files pin already stay, unless the arguments (for ``uv pip compile``) say
    otherwise, for instance ``--upgrade`` or ``--upgrade-package numpy``.
    """
    uv = shutil.which("uv")
    if uv is None:
        raise Trouble("uv makes the lock files. Install it, for instance with `pipx install uv`.")
    compile_lock = [uv, "pip", "compile", *OPTIONS, "pyproject.toml", "-"]
    # The tests' file is held to the first one: it may add packages, never change a version.
    extra = ["--extra=test", f"--constraint={LOCKS['run']}"]
    for lock, own in ((LOCKS["run"], arguments), (LOCKS["test"], [*arguments, *extra])):
        command = [*compile_lock, *own, f"--output-file={lock}"]
        code = subprocess.run(command, cwd=root, input=BUILD, text=True, check=False).returncode
        if code:
            return code
    return 0
