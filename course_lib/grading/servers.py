"""The grader's side of the walls: start servers, run submissions in them, put the questions."""

from __future__ import annotations

import os
import socket
import subprocess
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NoReturn

from course_lib.grading.isolation import Isolation, build_walls
from course_lib.sandbox import wire
from course_lib.sandbox.limits import Allowance

#: Seconds to start, and what a message may take longer than what it waits for.
START, GRACE = 60.0, 2.0
#: Bytes of outputs that are kept of one submission.
MOST_OUTPUT = 3_000_000


class ServerGoneError(RuntimeError):
    """A server has ended; what it was doing is lost, and must be done again."""


@dataclass(frozen=True)
class Job:
    """What a submission is to do.

    Attributes
    ----------
    steps : sequence of mapping
        Cells (``cell``: place, ``source``) and checks (``check``: number, ``function``,
        ``variables``, ``forbidden``), from top to bottom.
    files : mapping of str to bytes
        What lies beside the notebook.
    draws : bool
        Whether figures are drawn and kept.
    given_back : mapping of str to str
        Hidden functions that are to be had after all: their definitions by full names.
    """

    steps: Sequence[Mapping[str, Any]]
    files: Mapping[str, bytes] = field(default_factory=dict)
    draws: bool = False
    given_back: Mapping[str, str] = field(default_factory=dict)

    @property
    def checks(self) -> int:
        """How many checks there are."""
        return sum("check" in step for step in self.steps)


class Conversation:
    """A submission that runs: first its outputs, then its answers.

    Its guard ends it after `total_seconds`; a little before that, nothing more is asked.
    """

    def __init__(
        self,
        life: socket.socket,
        talk: socket.socket,
        asks: Sequence[socket.socket],
        total_seconds: float,
    ) -> None:
        self._life, self._talk, self._asks = life, talk, asks
        self._end = time.monotonic() + total_seconds - GRACE
        self.outputs: dict[int, dict[str, Any]] = {}
        self.reached: set[int] = set()
        self.finished = False
        self.reason = ""

    def listen(self, seconds: float) -> None:
        """Take the outputs of the cells until the last has run, or time is over."""
        deadline, taken = time.monotonic() + seconds, 0
        try:
            while taken < MOST_OUTPUT:
                message = wire.receive_message(self._talk, deadline - time.monotonic())
                said = wire.decode(message)
                if isinstance(said, str) and said == "done":
                    self.finished = True
                    return
                taken += len(message)
                self._note(said)
            self.reason = "output"
        except wire.Late:
            self.reason = "time"
        except wire.Closed:
            self.reason = self._why_ended()
        except (wire.MalformedMessageError, TypeError, AttributeError, LookupError, ValueError):
            self.reason = "confused"

    def _note(self, said: Mapping[str, Any]) -> None:
        if "trouble" in said and not self.outputs and not self.reached:
            raise ServerGoneError(f"a submission could not be started: {said['trouble']}")
        if "check" in said:
            self.reached.add(int(said["check"]))
        else:
            self.outputs[int(said["cell"])] = dict(said)

    def _why_ended(self) -> str:
        """Return what the guard says of the end, if it was the guard."""
        with suppress(wire.Late, wire.Closed, wire.MalformedMessageError):
            return str(wire.receive(self._life, 0.3))
        return "crash"

    @property
    def seconds_left(self) -> float:
        """How long questions may still take, by the clock."""
        return self._end - time.monotonic()

    def ask(self, check: int, question: Mapping[str, Any]) -> Any:
        """Put one question to the copy that waits at a check.

        Parameters
        ----------
        check : int
            Its number.
        question : mapping
            ``part``, ``inputs``; ``seconds`` of the processor, and ``clock``, for the answer.

        Raises
        ------
        wire.Closed, wire.Late, wire.MalformedMessageError
            If there is no answer.
        """
        line, clock = self._asks[check], max(min(question["clock"], self.seconds_left), 0.01)
        wire.send(line, {**question, "clock": clock})
        return wire.receive(line, clock + GRACE)


class Server:
    """One bubblewrap with an interpreter in it that has imported everything.

    Where a system forbids walls inside the walls, each submission gets a server of its own.
    """

    def __init__(
        self,
        library: Path,
        preload: Sequence[str],
        isolation: Isolation,
        number: int,
        nests: bool = True,
    ) -> None:
        self._settings = (library, tuple(preload), isolation, number)
        self._asked_to_nest, self.nests = nests, False
        self._process: subprocess.Popen[bytes] | None = None
        self._line: socket.socket | None = None
        self._walled = True

    def __enter__(self) -> Server:
        return self

    def __exit__(self, *_: object) -> None:
        self.stop()

    def start(self) -> None:
        """Start the server and wait until it is ready.

        Raises
        ------
        ServerGoneError
            If it does not start; with what it said.
        """
        library, preload, isolation, number = self._settings
        self._line, its = socket.socketpair()
        walls = build_walls(isolation, library, its.fileno(), number)
        self._process = subprocess.Popen(
            walls.command,
            env=walls.environment,
            pass_fds=[its.fileno()],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            cwd="/",
        )
        its.close()
        self._walled = walls.walled
        nests = walls.walled and self._asked_to_nest
        settings = {"user": walls.user, "preload": preload, "nests": nests, "walled": self._walled}
        try:
            wire.send(self._line, settings)
            self.nests = bool(wire.receive(self._line, START)["nests"])
        except (wire.Closed, wire.Late):
            self._say_why_not_started()

    def _say_why_not_started(self) -> NoReturn:
        assert self._process is not None
        assert self._process.stderr is not None
        self._process.kill()
        said = self._process.stderr.read().decode("utf-8", "replace").strip()
        self.stop()
        raise ServerGoneError(f"the isolated Python did not start: {said[-500:]}")

    def stop(self) -> None:
        """End the server and everything in it."""
        if self._line is not None:
            self._line.close()
        if self._process is not None:
            self._process.kill()
            self._process.wait()
            if self._process.stderr:
                self._process.stderr.close()
        self._process = self._line = None

    @contextmanager
    def run(self, job: Job, allowance: Allowance, folder: str = "") -> Iterator[Conversation]:
        """Run a submission; when the block is left, everything of it is ended.

        Parameters
        ----------
        job : Job
            What to do.
        allowance : Allowance
            What it may use.
        folder : str
            Where it runs if there are no walls.

        Raises
        ------
        ServerGoneError
            If the server is gone; start it again.
        """
        if self._process is None or self._process.poll() is not None:
            self.stop()
            self.start()
        try:
            with ExitStack() as ends:
                life, talk, *asks = self._begin(ends, 2 + job.checks)
                try:
                    wire.send(life, allowance.as_dict())
                    wire.send(talk, self._order(job, folder))
                except wire.Closed as error:
                    raise ServerGoneError(str(error)) from None
                conversation = Conversation(life, talk, asks, allowance.total_seconds)
                conversation.listen(allowance.notebook_seconds + GRACE)
                yield conversation
        finally:
            if self._walled and not self.nests:  # what was left behind shares the server
                self.stop()

    def _begin(self, ends: ExitStack, number: int) -> list[socket.socket]:
        """Send a job's ends of some lines to the server; return the other ends."""
        assert self._line is not None
        pairs = [socket.socketpair() for _ in range(number)]
        mine = [ends.enter_context(pair[0]) for pair in pairs]
        try:
            socket.send_fds(self._line, [wire.BEGIN], [pair[1].fileno() for pair in pairs])
        except OSError as error:
            raise ServerGoneError(str(error)) from None
        finally:
            for pair in pairs:
                pair[1].close()
        return mine

    def _order(self, job: Job, folder: str) -> dict[str, Any]:
        return {
            "steps": [dict(step) for step in job.steps],
            "files": dict(job.files),
            "draws": job.draws,
            "given_back": dict(job.given_back),
            "walls": self._walled,
            "folder": folder or os.getcwd(),
        }
