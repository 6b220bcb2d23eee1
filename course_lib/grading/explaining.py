"""Say what holds on this machine while submissions are graded: tried out, not claimed."""

from __future__ import annotations

import os
import platform
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from course_lib.grading.answering_library import make_library
from course_lib.grading.isolation import why_not
from course_lib.grading.servers import Job, Server, ServerGoneError
from course_lib.sandbox.calls import FORBIDDEN
from course_lib.sandbox.limits import Allowance

#: What is tried inside, as a submission could: a question, code that leaves `held`, what it means.
TRIALS = (
    ("the network", "import socket; socket.create_connection(('1.1.1.1', 53), 0.5)", OSError),
    ("the machine that runs a virtual one", "import socket; socket.socket(40, 1)", OSError),
    ("the kernel's keys", "import ctypes; assert ctypes.CDLL(None).syscall({keys}, 0, -3, 0) < 0",
     None),
    ("your files", "open({secret!r}).read()", OSError),
    ("writing to the system", "open('/usr/written', 'w')", OSError),
    ("writing to the course", "open('/course/written', 'w')", OSError),
    ("seeing your processes", "import os; os.kill({grader}, 0)", OSError),
    ("becoming another user", "import os; os.setuid(0)", OSError),
    ("mounting", "import ctypes; assert ctypes.CDLL(None).mount(b'x', b'/tmp', b'tmpfs', 0, None)",
     None),
    ("more memory than allowed", "bytearray({memory})", MemoryError),
    ("more files than allowed", "open('/tmp/large', 'wb').write(bytes({files}))", OSError),
    ("more processes than allowed", "{fork}", OSError),
    ("the references", "import course_lib.exercises", ImportError),
)  # fmt: skip
_FORK = (
    "import os, time\n"
    "for _ in range({processes} + 20):\n"
    "    if os.fork() == 0:\n"
    "        time.sleep(30); os._exit(0)\n"
)


def explain_isolation() -> str:
    """Try what a submission must not be able to do, and say what came of it.

    Returns
    -------
    str
        Sentences and a list.
    """
    reason = why_not()
    if reason:
        return (
            f"Nothing holds here: {reason}.\n`course grade` refuses to run students' code on this "
            "machine; `--isolation none` overrides that, if you trust every submission."
        )
    who = "a user of its own that owns nothing" if os.getuid() == 0 else "your user, in a namespace"
    allowance = Allowance()
    lines = [
        f"Submissions run behind bubblewrap, as {who}. Tried on this machine just now:",
        *(f"  {'held  ' if held else 'BROKEN'}  {name}" for name, held in try_out(allowance)),
        "",
        f"Limits: {allowance.cell_seconds:g} s of computing a cell, {allowance.answer_seconds:g} s "
        f"an answer; by the clock {allowance.cell_clock:g} s a cell, {allowance.answer_clock:g} s "
        f"an answer, {allowance.notebook_seconds:g} s a notebook, "
        f"{allowance.total_seconds:g} s in all; "
        f"{allowance.memory / 1e9:g} GB of memory, {allowance.processes} processes, "
        f"{allowance.files / 1e6:g} MB of temporary files.",
        "References, hidden inputs, other submissions, the key and the gradebook are not in sight.",
        "Not promised: protection from errors in the kernel of this machine. Keep it up to date.",
    ]
    return "\n".join(lines)


def try_out(allowance: Allowance, nests: bool = True) -> list[tuple[str, bool]]:
    """Try what a submission must not be able to do.

    Parameters
    ----------
    allowance : Allowance
        The limits to try.
    nests : bool
        Whether walls inside the walls are used, if this system allows them.

    Returns
    -------
    list of (str, bool)
        What was tried, and whether it was prevented.
    """
    with TemporaryDirectory() as name:
        folder = Path(name)
        folder.chmod(0o755)
        (folder / "secret").write_text("secret")
        words = {
            "secret": str(folder / "secret"),
            "grader": os.getpid(),
            "memory": allowance.memory * 2,
            "files": allowance.files * 2,
            "keys": FORBIDDEN["keyctl"][platform.machine() == "aarch64"],
            "fork": _FORK.format(processes=allowance.processes),
        }
        steps = [
            {"cell": place, "source": _trial(code.format(**words), error)}
            for place, (_, code, error) in enumerate(TRIALS)
        ]
        library = make_library(folder, frozenset())
        with Server(library, ["numpy"], "bubblewrap", 0, nests) as server:
            try:
                with server.run(Job(steps), allowance) as conversation:
                    outputs = conversation.outputs
            except ServerGoneError as error:
                return [(f"starting: {error}", False)]
    return [(name, _held(outputs.get(place, {}))) for place, (name, *_) in enumerate(TRIALS)]


def _trial(code: str, error: type[BaseException] | None) -> str:
    body = "".join(f"    {line}\n" for line in code.splitlines())
    expected = "pass" if error else "held = True"
    refused = (error or ZeroDivisionError).__name__
    return (
        f"held = False\ntry:\n{body}    {expected}\nexcept {refused}:\n    held = True\nprint(held)"
    )


def _held(said: dict[str, Any]) -> bool:
    return any("True" in str(output.get("text", "")) for output in said.get("outputs", ()))
