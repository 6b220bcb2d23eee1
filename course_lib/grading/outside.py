"""Judge a submission outside of its process: run it behind walls, ask it, compare here."""

from __future__ import annotations

import ast
import os
import shutil
import time
from collections.abc import Iterable, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory, gettempdir
from typing import Any

from nbformat import NotebookNode

from course_lib.grading.answering_library import hidden_functions, make_library, source_of
from course_lib.grading.isolation import Isolation, demand
from course_lib.grading.planning import Plan, plan
from course_lib.grading.servers import Conversation, Job, Server, ServerGoneError
from course_lib.grading.vetting import compare, crashed, vet
from course_lib.judging import Answer, Case, Exercise, Verdict, pose, seed_for
from course_lib.sandbox import wire
from course_lib.sandbox.limits import Allowance

#: Imported before the first submission comes, whatever its notebook imports.
USUAL = ("numpy", "scipy.linalg", "scipy.optimize", "matplotlib.pyplot", "cv2")
#: Folders with copies of the library; the number of the process that made one follows.
PREFIX = "course-grade-"
#: Servers that are kept: one for each notebook of an assignment.
MOST_SERVERS = 4


@dataclass(frozen=True)
class Submitted:
    """A submission as it is judged.

    Attributes
    ----------
    notebook : nbformat.NotebookNode
        Sanitized: labels and checks are the source's.
    seed : str
        From `grading_seed`.
    given : tuple of str
        Sources of the cells without a label that students were given.
    files : mapping of str to bytes
        What lies beside the notebook.
    """

    notebook: NotebookNode
    seed: str
    given: tuple[str, ...] = ()
    files: Mapping[str, bytes] = field(default_factory=dict)


@dataclass(frozen=True)
class Outcome:
    """What came of a submission.

    Attributes
    ----------
    verdicts : mapping of int to Verdict or None
        By the check's cell; None where Python had ended before.
    outputs : mapping of int to mapping
        What cells wrote, as it came: not vetted yet.
    reason : str
        Why it ended early; empty if it did not.
    seconds : mapping of int to float
        How long the answers of each check took, judging included.
    """

    verdicts: Mapping[int, Verdict | None]
    outputs: Mapping[int, Mapping[str, Any]]
    reason: str
    seconds: Mapping[int, float] = field(default_factory=dict)


class Judge:
    """Judges submissions, one after the other, with servers of its own.

    Parameters
    ----------
    isolation : str
        ``"bubblewrap"``, or ``"none"``.
    allowance : Allowance
        What a submission may use.
    number : int
        Which of several judges it is.
    """

    def __init__(
        self,
        isolation: Isolation = "bubblewrap",
        allowance: Allowance | None = None,
        number: int = 0,
    ) -> None:
        demand(isolation)
        self._isolation, self._allowance = isolation, allowance or Allowance()
        self._number = number
        self._open = ExitStack()
        _sweep()
        folder = TemporaryDirectory(prefix=f"{PREFIX}{os.getpid()}-")
        self._folder = Path(self._open.enter_context(folder))
        self._folder.chmod(0o755)  # another user reads the library in it
        self._servers: dict[frozenset[str], Server] = {}

    def __enter__(self) -> Judge:
        return self

    def __exit__(self, *_: object) -> None:
        self._open.close()

    def judge(self, submitted: Submitted) -> Outcome:
        """Run a submission and judge its answers.

        Parameters
        ----------
        submitted : Submitted
            What was handed in.

        Returns
        -------
        Outcome
            Verdicts and outputs.

        Raises
        ------
        ServerGoneError
            If the isolated Python ended twice; the submission is not judged then.
        """
        todo = plan(submitted.notebook, submitted.given)
        try:
            return self._judge(submitted, todo)
        except ServerGoneError:
            self._stop(_hidden(todo))
            return self._judge(submitted, todo)

    def _judge(self, submitted: Submitted, todo: Plan) -> Outcome:
        server = self._server(_hidden(todo), submitted)
        deadline = time.perf_counter() + self._allowance.total_seconds
        lines = _lines(submitted.notebook)
        verdicts: dict[int, Verdict | None] = {}
        again: list[int] = []
        seconds: dict[int, float] = {}
        with self._running(server, Job(todo.steps, submitted.files, todo.draws)) as conversation:
            for number, check in enumerate(todo.checks):
                start = time.perf_counter()
                asked = self._ask(conversation, number, check.exercise, submitted.seed, lines)
                verdicts[check.cell] = asked[0] if asked else None
                seconds[check.cell] = time.perf_counter() - start
                again += [number] if asked and asked[1] & _hidden(todo) else []
            reason = conversation.reason
        for number in again:  # something that this exercise may use was hidden
            if time.perf_counter() < deadline:
                verdicts[todo.checks[number].cell] = self._alone(server, submitted, todo, number)
        return Outcome(verdicts, conversation.outputs, reason, seconds)

    def _running(self, server: Server, job: Job) -> Any:
        return server.run(job, self._allowance, str(self._folder))

    def _alone(
        self, server: Server, submitted: Submitted, todo: Plan, number: int
    ) -> Verdict | None:
        """Ask one exercise where only its own reference is hidden."""
        exercise, lines = todo.checks[number].exercise, _lines(submitted.notebook)
        others = _hidden(todo) - hidden_functions([exercise])
        given_back = {name: source for name in others if (source := source_of(name))}
        job = Job(todo.steps, submitted.files, todo.draws, given_back)
        with self._running(server, job) as conversation:
            asked = self._ask(conversation, number, exercise, submitted.seed, lines)
        return asked[0] if asked else None

    def _ask(
        self,
        conversation: Conversation,
        number: int,
        exercise: Exercise,
        seed: str,
        lines: Sequence[str],
    ) -> tuple[Verdict, frozenset[str]] | None:
        """Ask all questions of a check; also return what else the answers missed."""
        if number not in conversation.reached:
            return None
        cases = pose(exercise, seed_for(seed, exercise.name))
        answers: list[Answer] = []
        missed: frozenset[str] = frozenset()
        for case in cases:
            if answers and answers[-1] == crashed():
                answers.append(crashed())
            elif conversation.seconds_left <= 0 or any(a.status == "time limit" for a in answers):
                answers.append(Answer("time limit"))
            else:
                allowance = self._allowance
                answer, more = _answer(conversation, number, exercise, case, lines, allowance)
                answers.append(answer)
                missed |= more
        return compare(exercise, cases, answers), missed

    def _server(self, hidden: frozenset[str], submitted: Submitted) -> Server:
        if hidden not in self._servers:
            if len(self._servers) >= MOST_SERVERS:  # each holds 150 MB
                self._servers.pop(list(self._servers)[1]).stop()
            library = make_library(self._folder, hidden)
            preload = [*USUAL, *imported(submitted.notebook)]
            place = 100 * self._number + len(self._servers)  # whose user may be taken again
            server = Server(library, preload, self._isolation, place)
            self._servers[hidden] = self._open.enter_context(server)
        return self._servers[hidden]

    def _stop(self, hidden: frozenset[str]) -> None:
        if hidden in self._servers:
            self._servers[hidden].stop()


def _hidden(todo: Plan) -> frozenset[str]:
    return hidden_functions(check.exercise for check in todo.checks)


def _sweep() -> None:
    """Remove the folders of judges that were killed."""
    for folder in Path(gettempdir()).glob(f"{PREFIX}*"):
        number = folder.name.removeprefix(PREFIX).partition("-")[0]
        own = folder.is_dir() and folder.lstat().st_uid == os.getuid()
        if own and number.isdecimal() and not _is_alive(int(number)):
            shutil.rmtree(folder, ignore_errors=True)


def _is_alive(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except PermissionError:
        return True
    return True


def _answer(
    conversation: Conversation,
    number: int,
    exercise: Exercise,
    case: Case,
    lines: Sequence[str],
    allowance: Allowance,
) -> tuple[Answer, frozenset[str]]:
    seconds, clock = allowance.answer_seconds, allowance.answer_clock
    question = {"part": case.part, "inputs": case.inputs, "seconds": seconds, "clock": clock}
    try:
        return vet(exercise, case, conversation.ask(number, question), lines, seconds)
    except wire.Late:
        return Answer("time limit", message=f"{seconds:g}"), frozenset()
    except wire.MalformedMessageError:
        return Answer("too large", message="too many bytes"), frozenset()
    except wire.Closed:
        return crashed(), frozenset()


def _lines(notebook: NotebookNode) -> list[str]:
    code = [cell.source for cell in notebook.cells if cell.cell_type == "code"]
    return [line.strip() for source in code for line in source.splitlines()]


def imported(notebook: NotebookNode) -> Iterable[str]:
    """Return the modules that the locked cells of a notebook import."""
    for cell in notebook.cells:
        if cell.cell_type == "code" and cell.metadata.get("nbgrader", {}).get("locked"):
            for node in ast.walk(ast.parse(cell.source)):
                if isinstance(node, ast.Import):
                    yield from (alias.name for alias in node.names)
                elif isinstance(node, ast.ImportFrom) and node.module:
                    yield node.module
                    yield from (f"{node.module}.{alias.name}" for alias in node.names)
