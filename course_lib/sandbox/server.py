"""A server that has imported everything already: for each submission it forks.

It runs inside bubblewrap and never runs a student's code itself. For each job it forks a guard;
the guard's child leaves the others (`walls`), and only the grandchild becomes the notebook. The
guard watches time and memory from outside, and ends everything of the submission at once.
"""

from __future__ import annotations

import gc
import importlib
import os
import select
import signal
import socket
import sys
import time
from contextlib import suppress
from typing import Any, NoReturn

from course_lib.sandbox import calls, walls, wire
from course_lib.sandbox.limits import Allowance
from course_lib.sandbox.memory import MemoryWatch

#: Seconds between two looks at the memory.
LOOK = 0.05
MOST_LINES = 200


def main(number: int) -> None:
    """Serve jobs until the grader closes the line.

    Parameters
    ----------
    number : int
        The file descriptor of the line.
    """
    line = socket.socket(fileno=number)
    settings = wire.receive(line, trusted=True)
    if settings["user"]:
        walls.become(settings["user"])
    _preload(settings["preload"])
    nests = settings["nests"] and walls.can_nest()
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # the kernel takes ended guards away
    wire.send(line, {"nests": nests})
    gc.collect()
    gc.freeze()
    while True:
        message, ends, _, _ = socket.recv_fds(line, 1, MOST_LINES)
        if message != wire.BEGIN:
            return
        if os.fork() == 0:
            line.close()
            _guard([socket.socket(fileno=end) for end in ends], nests, settings["walled"])
        for end in ends:
            os.close(end)


def _preload(modules: list[str]) -> None:
    """Import what notebooks import; a module that is not there is the notebook's own trouble."""
    from course_lib.sandbox import notebook

    notebook.make_shell()
    for name in modules:
        with suppress(Exception):
            importlib.import_module(name)


def _guard(lines: list[socket.socket], nests: bool, walled: bool) -> NoReturn:
    """Start a submission and watch over it; end it when the grader has gone or it does harm."""
    life, *others = lines
    try:
        walls.die_with_parent()
        signal.signal(signal.SIGCHLD, signal.SIG_DFL)
        allowance = Allowance(**wire.receive(life, 10, trusted=True))
        child = os.fork()
        if child == 0:
            life.close()
            _enter(others, allowance, nests, walled)
        for line in others:
            line.close()
        reason = _watch(life, child, allowance, walled)
        with suppress(ProcessLookupError):
            os.kill(child if walled else -child, signal.SIGKILL)
        os.waitpid(child, 0)
        wire.send(life, reason)
    except (wire.Closed, wire.Late):
        pass
    finally:
        os._exit(0)


def _watch(life: socket.socket, child: int, allowance: Allowance, walled: bool) -> str:
    """Return why a submission must end now: it is finished, or the name of a limit."""
    start = time.monotonic()
    own = (os.getpid(), os.getppid(), child)
    memory = MemoryWatch(allowance.memory, own) if walled else None
    grader = select.poll()
    grader.register(life, select.POLLIN | select.POLLHUP)
    while not grader.poll(int(LOOK * 1000)):
        if os.waitid(os.P_PID, child, os.WEXITED | os.WNOHANG | os.WNOWAIT):
            return "finished"
        if time.monotonic() - start > allowance.total_seconds:
            return "time"
        if memory and memory.is_too_much():
            return "memory"
    return "stopped"


def _enter(lines: list[socket.socket], allowance: Allowance, nests: bool, walled: bool) -> NoReturn:
    """Go behind the inner walls, and run the notebook there."""
    try:
        walls.die_with_parent()
        user = os.getuid()
        if not walled:
            os.setpgid(0, 0)  # all that can be ended together
        if nests:
            walls.leave_the_others()
            if os.fork():
                _wait_for_all(lines)
            walls.die_with_parent()
            walls.settle(allowance, user)
        walls.adopt()
        walls.limit(allowance)
        if walled:
            calls.forbid()
        if os.fork() == 0:
            _become_notebook(lines, allowance)
        _wait_for_all(lines)
    except BaseException as error:
        with suppress(Exception):
            wire.send(lines[0], {"trouble": f"{type(error).__name__}: {error}"})
    finally:
        os._exit(0)


def _wait_for_all(lines: list[socket.socket]) -> NoReturn:
    """Wait until no child is left; the first process of a namespace is the parent of all."""
    for line in lines:
        line.close()
    walls.hide()
    with suppress(ChildProcessError):
        while True:
            os.wait()
    os._exit(0)


def _become_notebook(lines: list[socket.socket], allowance: Allowance) -> NoReturn:
    from course_lib.sandbox.notebook import run_notebook

    talk, *questions = lines
    try:
        job: dict[str, Any] = wire.receive(talk, 20, trusted=True)
        run_notebook(job, talk, questions, allowance)
    finally:
        os._exit(0)


if __name__ == "__main__":
    main(int(sys.argv[1]))
