"""Make the private environment, one step after the other; what fails leaves nothing half-done.

A step that is complete is written into the stamp. What was killed before is known by what
its stamp lacks, and is made again from nothing.
"""

import contextlib
import os
import re
import shutil
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

from course_lib.starting.environment import (
    LOCKS,
    Environment,
    found,
    is_foreign,
    needed,
    steps_to,
    variables,
    write_stamp,
)
from course_lib.starting.progress import Line, stage_of
from course_lib.starting.single import only_one
from course_lib.starting.trouble import Trouble, explain_log

SAYING = {
    "create": "Setting up the course in {}: once, a few minutes.",
    "test": "Adding what the tests need to {}.",
}


def prepare(env: Environment, wanted: str, say: Callable[[str], None]) -> None:
    """Make the environment complete; leave it untouched if it is.

    Parameters
    ----------
    env : Environment
        Where.
    wanted : {"run", "test"}
        For what.
    say : callable
        Told what goes on.

    Raises
    ------
    Trouble
        If a step fails; what was complete before stays so.
    """
    need = needed(env)
    if not steps_to(wanted, found(env), need):
        return
    with only_one(env.root / ".venv.lock", say) as lock:
        steps = steps_to(wanted, found(env), need)
        if "create" in steps and is_foreign(env):
            raise Trouble(
                f"There is a folder {env.folder} that start.py did not make.\n"
                "Rename it or remove it, and start again."
            )
        if steps and steps[0] in SAYING:
            say(SAYING[steps[0]].format(env.folder))
        for step in steps:
            _take(step, env, need, lock)


def _take(step: str, env: Environment, need: dict[str, str], lock: int) -> None:
    try:
        if step == "create":
            create(env, lock)
        elif step == "project":
            install_project(env, lock)
        else:
            install_packages(env, step, lock)
        done = {"create": ["place"], "test": ["run", "test"]}.get(step, [step])
        write_stamp(env, found(env) | {key: need[key] for key in done})
    except BaseException:
        if "run" not in found(env):
            with contextlib.suppress(OSError):  # else the next start removes it
                discard(env)
        raise


def discard(env: Environment) -> None:
    """Remove the environment: first out of the way in one stroke, then piece by piece."""
    old = env.root / ".venv.old"
    shutil.rmtree(old, ignore_errors=True)
    if env.folder.exists():
        env.folder.rename(old)
        shutil.rmtree(old, ignore_errors=True)


def create(env: Environment, lock: int) -> None:
    """Make an empty environment with this Python in place of what is there."""
    discard(env)
    env.folder.mkdir()
    env.stamp.write_text("{}", "utf-8")  # from here on the folder is known as ours
    env.log.write_bytes(b"")
    # Two programs, because venv keeps to itself what ensurepip complains of.
    venv = [sys.executable, "-m", "venv", "--without-pip", str(env.folder)]
    pip = [str(env.python), "-m", "ensurepip", "--upgrade", "--default-pip"]
    for command in (venv, pip):
        run_logged(env, command, "Making the environment", lock)


def install_packages(env: Environment, wanted: str, lock: int) -> None:
    """Install what a lock file pins, and nothing that it does not."""
    options = ["--require-hashes", "--no-deps", "--only-binary=:all:"]
    lock_file = env.root / LOCKS[wanted]
    pinned = len(re.findall(r"^[\w.-]+==", lock_file.read_text("utf-8"), re.MULTILINE))
    pip = [*_pip_install(env), *options, "-r", str(lock_file)]
    run_logged(env, pip, "Installing the packages", lock, pinned)


def install_project(env: Environment, lock: int) -> None:
    """Link the course's folder into the environment: an update of the course needs no install."""
    options = ["--no-deps", "--no-build-isolation", "--force-reinstall", "--editable"]
    run_logged(env, [*_pip_install(env), *options, str(env.root)], "Installing the course", lock)
    # Before Python 3.13 the link is read in the system's encoding: on Windows a folder with
    # letters outside it would not be found. The way from there to here has dots only.
    (link,) = env.packages.glob("*camera_course.pth")
    link.write_text(os.path.relpath(env.root, env.packages) + "\n", "ascii")


def _pip_install(env: Environment) -> list[str]:
    options = ["--no-input", "--no-color", "--progress-bar=off", "--disable-pip-version-check"]
    return [str(env.python), "-m", "pip", "install", *options]


def run_logged(env: Environment, command: list[str], step: str, lock: int, pinned: int = 0) -> None:
    """Run a program of the set-up, its output in the log.

    Parameters
    ----------
    env : Environment
        Where it runs.
    command : list of str
        The program and its arguments.
    step : str
        What it does, for the explanation if it fails.
    lock : int
        The descriptor that keeps other set-ups out; the program inherits it.
    pinned : int
        Number of packages it may install; 0 for no progress.
    """
    with env.log.open("ab") as log:
        start = log.tell()
        process = subprocess.Popen(
            command,
            stdout=log,
            stderr=subprocess.STDOUT,
            env=variables(env),
            pass_fds=() if os.name == "nt" else (lock,),
        )
        try:
            _watch(process, env, start, pinned)
        except BaseException:
            process.terminate()
            process.wait()
            raise
    if process.returncode:
        raise Trouble(explain_log(_printed(env.log, start), step, env.log, env.root))


def _watch(process: subprocess.Popen[bytes], env: Environment, start: int, pinned: int) -> None:
    before, line = _unpacked(env), Line()
    try:
        while process.poll() is None:
            if pinned:
                line.show(stage_of(_printed(env.log, start), pinned, _unpacked(env) - before))
            time.sleep(0.1)
    finally:
        line.clear()


def _printed(log: Path, start: int) -> str:
    return log.read_bytes()[start:].decode("utf-8", "replace")


def _unpacked(env: Environment) -> int:
    return sum(1 for _ in env.packages.glob("*.dist-info"))
