"""The outer walls: bubblewrap's command line, and what can be promised on this machine."""

from __future__ import annotations

import os
import shutil
import site
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Literal

Isolation = Literal["bubblewrap", "none"]
#: Users that own nothing: who a submission is when root grades. Each server takes another.
FIRST_USER, USERS = 60_500, 4_500
#: Where the library lies behind the walls.
LIBRARY = "/course"
#: What a program needs of the system, where it is there.
SYSTEM = ("/usr", "/lib", "/lib32", "/lib64", "/bin", "/sbin", "/etc/ld.so.cache", "/etc/fonts")
SYSTEM_TOO = ("/etc/localtime", "/etc/alternatives", "/etc/ssl/openssl.cnf")
#: Folders of which every submission has its own; nothing else can be seen in them.
COVERED = ("/tmp", "/dev", "/proc")
#: What a submission finds in its environment, and nothing else.
ENVIRONMENT = {
    "HOME": "/tmp",
    "PATH": "/usr/bin:/bin",
    "LANG": "C.UTF-8",
    "MPLBACKEND": "agg",
    "MPLCONFIGDIR": "/tmp/matplotlib",
    "OPENBLAS_NUM_THREADS": "1",
    "OMP_NUM_THREADS": "1",
    "PYTHONDONTWRITEBYTECODE": "1",
    "PYTHONUNBUFFERED": "1",
    "USER": "student",
    "COURSE_DATA_DIR": "/nowhere",
}
INHERITED = ("OPENBLAS_CORETYPE", "OPENBLAS_L2_SIZE")


class NoIsolationError(RuntimeError):
    """Submissions cannot be kept apart on this machine, and nobody said to go on without."""


@dataclass(frozen=True)
class Walls:
    """How a server is started: its command, environment, and the user it becomes."""

    command: tuple[str, ...]
    environment: dict[str, str]
    user: int
    walled: bool


@cache
def why_not() -> str:
    """Return why bubblewrap cannot be used here, in a sentence; nothing if it can."""
    if not sys.platform.startswith("linux"):
        return "bubblewrap exists on Linux only"
    program = shutil.which("bwrap")
    if program is None:
        return "bubblewrap is not installed (apt install bubblewrap, or dnf install bubblewrap)"
    import subprocess

    inner = ["--unshare-all", "--die-with-parent", "--ro-bind", "/", "/", "--proc", "/proc"]
    trial = subprocess.run(
        [program, *inner, "/bin/true"], capture_output=True, text=True, check=False, timeout=20
    )
    return "" if trial.returncode == 0 else f"bubblewrap does not work here: {trial.stderr.strip()}"


def demand(isolation: Isolation) -> None:
    """Make sure that submissions are kept as asked.

    Raises
    ------
    NoIsolationError
        If they should be isolated and cannot be.
    """
    if isolation == "none":
        if not hasattr(os, "fork"):
            raise NoIsolationError("grading needs Linux or macOS; on Windows, use WSL")
        return
    reason = why_not()
    if reason:
        raise NoIsolationError(
            f"{reason}. Without it, students' code would run with your rights: it could read and "
            "change your files and the gradebook. Grade on a machine that has it; or, if you trust "
            "every submission, ask for `--isolation none`"
        )


def build_walls(isolation: Isolation, library: Path, line: int, number: int) -> Walls:
    """Return how to start a server.

    Parameters
    ----------
    isolation : str
        ``"bubblewrap"``, or ``"none"``.
    library : pathlib.Path
        From `make_library`.
    line : int
        File descriptor of the server's end of its line.
    number : int
        Which of the servers it is.
    """
    environment = ENVIRONMENT | {k: os.environ[k] for k in INHERITED if k in os.environ}
    module = ("-P", "-m", "course_lib.sandbox.server", str(line))
    if isolation == "none":
        own = {"PYTHONPATH": str(library), "MPLCONFIGDIR": str(library), "HOME": str(library)}
        return Walls((sys.executable, *module), environment | own, 0, walled=False)
    root = os.getuid() == 0
    bwrap = (shutil.which("bwrap") or "bwrap", *_rights(root), *_sight(library))
    environment |= {"PYTHONPATH": LIBRARY}
    user = FIRST_USER + (13 * os.getpid() + number) % USERS if root else 0
    return Walls((*bwrap, "--", behind(sys.executable), *module), environment, user, True)


def _rights(root: bool) -> Iterator[str]:
    """Root keeps what it takes to become another user; anybody else has nothing to give up."""
    yield from ("--unshare-pid", "--unshare-net", "--unshare-ipc", "--unshare-uts")
    yield from ("--unshare-cgroup-try", "--die-with-parent", "--new-session")
    if root:
        yield from ("--cap-drop", "ALL")
        for power in ("SYS_ADMIN", "SETUID", "SETGID"):
            yield from ("--cap-add", f"CAP_{power}")
        yield from ("--dir", "/proc")
    else:
        yield from ("--unshare-user", "--proc", "/proc")


def _sight(library: Path) -> Iterator[str]:
    """Everything that can be seen, all of it read-only but the temporary folders."""
    for path in (*SYSTEM, *SYSTEM_TOO):
        if os.path.islink(path):
            yield from ("--symlink", os.readlink(path), path)
        elif os.path.exists(path):
            yield from ("--ro-bind", path, path)
    for folder in _python_folders():
        if not folder.startswith("/usr/"):
            for above in reversed(Path(behind(folder)).parents):  # bubblewrap makes them private
                yield from ("--perms", "0755", "--dir", str(above))
            yield from ("--ro-bind", folder, behind(folder))
    for package in map(behind, _own_packages()):
        yield from ("--tmpfs", package, "--remount-ro", package)
    yield from ("--ro-bind", str(library), LIBRARY)
    anybody = ("--perms", "1777")
    yield from ("--dev", "/dev", *anybody, "--size", "50000000", "--tmpfs", "/tmp")
    yield from (*anybody, "--dir", ENVIRONMENT["MPLCONFIGDIR"])
    for cache_file in _font_lists():
        target = f"{ENVIRONMENT['MPLCONFIGDIR']}/{cache_file.name}"
        yield from ("--ro-bind", str(cache_file), target)
    yield from ("--remount-ro", "/dev", "--remount-ro", "/", "--chdir", "/")


def _python_folders() -> Sequence[str]:
    """Return where this Python and its packages are, without folders inside each other."""
    real = Path(os.path.realpath(sys.executable)).parents[1]
    found = {sys.prefix, sys.base_prefix, sys.exec_prefix, str(real), *site.getsitepackages()}
    folders = sorted(os.path.abspath(folder) for folder in found if os.path.isdir(folder))
    return [f for f in folders if not any(f.startswith(f"{other}/") for other in folders)]


def behind(path: str) -> str:
    """Return where a path of this Python lies behind the walls.

    It stays where it is, unless that is in a folder of which every submission has its own.
    """
    for number, folder in enumerate(_python_folders()):
        if path == folder or path.startswith(f"{folder}/"):
            covered = any(folder.startswith(f"{own}/") for own in COVERED)
            return f"/python{number}{path.removeprefix(folder)}" if covered else path
    return path


def _own_packages() -> Iterator[str]:
    """Yield where the whole course lies in folders that can be seen: it is covered there."""
    for folder in site.getsitepackages():
        for package in ("course_lib", "data_generators"):
            if os.path.isdir(os.path.join(folder, package)):
                yield os.path.join(folder, package)


def _font_lists() -> Sequence[Path]:
    """Return Matplotlib's lists of fonts, which take seconds to make anew."""
    import matplotlib

    return sorted(Path(matplotlib.get_cachedir()).glob("fontlist-v*.json"))
