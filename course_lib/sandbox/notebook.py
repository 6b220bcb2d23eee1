"""Run a submitted notebook from top to bottom, and keep what each check would have met.

At each check the process forks, and the copy waits: it holds the functions and variables as they
are at that place. Only when all cells have run and nothing more is taken from them, the grader
asks the copies. So no cell ever sees a hidden input, and what an answer prints goes nowhere.
"""

from __future__ import annotations

import base64
import io
import os
import sys
import time
import warnings
from collections.abc import Mapping, Sequence
from contextlib import nullcontext, suppress
from pathlib import Path
from socket import socket
from typing import Any

from IPython.core.displayhook import DisplayHook
from IPython.core.displaypub import DisplayPublisher
from IPython.core.interactiveshell import InteractiveShell
from traitlets import Type
from traitlets.config import Config

from course_lib.judging.limits import Bell, BoundedText, TimeLimitReached, time_limit
from course_lib.sandbox import hidden, wire
from course_lib.sandbox.answers import answer_questions
from course_lib.sandbox.limits import Allowance

#: Where a notebook runs.
FOLDER = "/tmp/notebook"
LATE = "This cell was stopped after {:g} seconds of computing, or {:g} by the clock."
ALL_LATE = (
    "This cell was stopped after all cells together had taken {:g} seconds by the clock. Which of "
    "them takes so long?"
)


class _Publisher(DisplayPublisher):  # type: ignore[misc]
    """Keeps what a cell displays."""

    def publish(self, data: Mapping[str, Any], *_: Any, **__: Any) -> None:
        """Keep the plain text, and the picture where one is wanted."""
        _record(self.shell, "display_data", data)


class _Hook(DisplayHook):  # type: ignore[misc]
    """Keeps the value of a cell's last line."""

    def __call__(self, result: Any = None) -> None:
        """Keep the plain text, and the picture where one is wanted."""
        self.check_for_underscore()
        if result is not None and not self.quiet():
            self.update_user_ns(result)
            _record(self.shell, "execute_result", self.compute_format_data(result)[0])


class _Shell(InteractiveShell):  # type: ignore[misc]
    """An IPython whose cells' values and displays are kept, not printed."""

    display_pub_class = Type(_Publisher)
    displayhook_class = Type(_Hook)


def _record(shell: Any, kind: str, data: Mapping[str, Any]) -> None:
    kept = {key: str(data[key]) for key in ("text/plain",) if key in data}
    picture = data.get("image/png")
    if shell.draws and picture:
        kept["image/png"] = (
            base64.b64encode(picture).decode() if isinstance(picture, bytes) else str(picture)
        )
    if kept:
        shell.kept.append({"output_type": kind, "data": kept})


def make_shell() -> InteractiveShell:
    """Make the IPython in which notebooks run; it keeps no history and draws nothing."""
    options = Config()
    options.HistoryManager.enabled = False
    options.HistoryManager.hist_file = ":memory:"
    options.InteractiveShell.colors = "NoColor"
    options.InteractiveShell.xmode = "Plain"
    shell = _Shell.instance(config=options)
    shell.kept, shell.draws = [], False
    shell.ask_exit = lambda: None  # exit() in a cell ends nothing, as in a graded kernel
    shell._showtraceback = lambda kind, error, lines: shell.kept.append(_error(kind, error, lines))
    shell.register_magic_function(lambda line: None, "line", "matplotlib")
    formatter = shell.display_formatter
    formatter.active_types = ["text/plain"]
    formatter.ipython_display_formatter.enabled = False
    shell._tee = lambda channel: nullcontext()  # IPython would keep all that is printed, too
    for source in ("1", "1 / 0"):  # load now what the first cell and the first error would load
        shell.run_cell(source)
    shell.reset()
    return shell


def _error(kind: type[BaseException], error: BaseException, lines: Sequence[str]) -> dict[str, Any]:
    text = str(error)[:2000]
    traceback = [line[:5000] for line in list(lines)[-30:]]
    return {"output_type": "error", "ename": kind.__name__, "evalue": text, "traceback": traceback}


def run_notebook(
    job: Mapping[str, Any], talk: socket, questions: Sequence[socket], allowance: Allowance
) -> None:
    """Run the cells of a job and report the outputs of each.

    Parameters
    ----------
    job : mapping
        ``steps``: cells (place and source) and checks (what is asked, and number), in order;
        ``files``: what lies beside the notebook, by name; ``draws``: whether pictures are kept;
        ``given_back``: for `hidden.give_back`.
    talk : socket
        Where outputs are reported.
    questions : sequence of socket
        Where the copies are asked, one for each check.
    allowance : Allowance
        Limits of time and output.
    """
    shell = InteractiveShell.instance()
    _settle(shell, job)
    hidden.give_back(job["given_back"])
    deadline = time.monotonic() + allowance.notebook_seconds
    for step in job["steps"]:
        if "cell" in step:
            outputs = _run_cell(shell, step["source"], allowance, deadline - time.monotonic())
            count = shell.execution_count - 1
            wire.send(talk, {"cell": step["cell"], "outputs": outputs, "count": count})
        else:
            _fork_a_copy(shell, step, talk, questions)
    wire.send(talk, "done")


def _settle(shell: Any, job: Mapping[str, Any]) -> None:
    """Move to a folder of the notebook's own, and point the standard streams to nowhere."""
    nowhere = os.open(os.devnull, os.O_RDWR)
    for stream in (0, 1, 2):
        os.dup2(nowhere, stream)
    folder = Path(FOLDER if job["walls"] else job["folder"])
    for name, content in job["files"].items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    folder.mkdir(parents=True, exist_ok=True)
    os.chdir(folder)
    sys.path.insert(0, str(folder))
    shell.draws = job["draws"]
    if job["draws"]:
        shell.display_formatter.active_types = ["text/plain", "image/png"]
    warnings.filterwarnings("ignore", message="FigureCanvasAgg is non-interactive")


def _run_cell(shell: Any, source: str, allowance: Allowance, left: float) -> list[dict[str, Any]]:
    """Run one cell; return its outputs, none of them longer than allowed."""
    shell.kept, characters = [], allowance.output
    streams = {"stdout": BoundedText(characters), "stderr": BoundedText(characters)}
    before = sys.stdout, sys.stderr
    sys.stdout, sys.stderr = streams["stdout"], streams["stderr"]
    end, clock = time.monotonic() + left, max(min(allowance.cell_clock, left), 0.01)
    bell = Bell()
    try:
        with time_limit(allowance.cell_seconds, clock) as bell:
            shell.run_cell(source, store_history=True)
    except TimeLimitReached:
        pass
    except BaseException as error:  # what IPython itself could not bear
        shell.kept.append(_error(type(error), error, []))
    finally:
        sys.stdout, sys.stderr = before
    if bell.rang:
        late = TimeLimitReached(_why_late(allowance, time.monotonic() >= end))
        shell.kept = [*shell.kept[:20], _error(TimeLimitReached, late, [])]
    _finish_figures(shell)
    said = [
        {"output_type": "stream", "name": name, "text": text}
        for name, stream in streams.items()
        if (text := stream.text())
    ]
    return said + [_short(output, characters) for output in shell.kept[:50]]


def _why_late(allowance: Allowance, all_late: bool) -> str:
    if all_late:
        return ALL_LATE.format(allowance.notebook_seconds)
    return LATE.format(allowance.cell_seconds, allowance.cell_clock)


def _short(output: dict[str, Any], characters: int) -> dict[str, Any]:
    data = output.get("data", {})
    if "text/plain" in data:
        data["text/plain"] = data["text/plain"][:characters]
    if len(data.get("image/png", "")) > 20 * characters:
        del data["image/png"]
    return output


def _finish_figures(shell: Any) -> None:
    """Close the figures of a cell, as a notebook does; keep them where a person needs them."""
    pyplot = sys.modules.get("matplotlib.pyplot")
    if pyplot is None:
        return
    with suppress(Exception):
        for number in pyplot.get_fignums() if shell.draws else ():
            file = io.BytesIO()
            pyplot.figure(number).savefig(file, format="png", dpi=60)
            _record(shell, "display_data", {"image/png": file.getvalue()})
        pyplot.close("all")


def _fork_a_copy(
    shell: Any, check: Mapping[str, Any], talk: socket, questions: Sequence[socket]
) -> None:
    """Leave a copy of this process behind that waits for the questions of one check."""
    number = check["check"]
    try:
        copy = os.fork()
    except OSError:  # the student's processes have used up what there is
        return
    if copy == 0:
        try:
            talk.close()
            for other, line in enumerate(questions):
                if other != number:
                    line.close()
            answer_questions(check, questions[number], shell.user_ns)
        except BaseException:
            pass  # the grader sees that nobody answers
        finally:
            os._exit(0)
    questions[number].close()
    wire.send(talk, {"check": number})
