"""The commands of start.py: open the course, test it, renew its lock files."""

import argparse
import os
import subprocess
import sys
from pathlib import Path

from course_lib.starting import locks
from course_lib.starting.environment import Environment, variables
from course_lib.starting.installing import prepare
from course_lib.starting.trouble import Trouble, explain_os_error
from course_lib.starting.work_folder import update

ROOT = Path(__file__).resolve().parents[2]
FIRST = "00_welcome/00_welcome.ipynb"
DESCRIPTION = "Open the course in JupyterLab, in your browser. The first start sets it up."
EPILOG = """\
other commands:
  start.py setup        set up, and open nothing
  start.py test [...]   run the course's own tests; [...] goes to pytest,
                        for instance: -m "not slow", -k pinhole, -n 0
  start.py lock [...]   for authors: pin the packages of pyproject.toml anew;
                        [...] goes to uv, for instance: --upgrade

Your notebooks are copies in the work folder. An update of the course never
overwrites one that you changed: it puts the new version beside it.
"""


def main(arguments: list[str]) -> int:
    """Do what the command line asks.

    Parameters
    ----------
    arguments : list of str
        Without the program's name.

    Returns
    -------
    int
        The exit code: 0 if all went well.
    """
    for stream in (sys.stdout, sys.stderr):  # a terminal may lack letters that a path has
        stream.reconfigure(errors="replace")  # type: ignore[union-attr]
    try:
        return dispatch(arguments)
    except Trouble as trouble:
        complaint = str(trouble)
    except OSError as error:
        complaint = explain_os_error(error, ROOT)
    except KeyboardInterrupt:
        complaint = "Stopped. Nothing is broken; the same command goes on."
    print(complaint, file=sys.stderr)
    return 1


def dispatch(arguments: list[str]) -> int:
    """Run one command; return its exit code."""
    env = Environment(ROOT)
    if arguments[:1] == ["test"]:
        prepare(env, "test", say)
        workers = str(min(os.cpu_count() or 1, 4))
        return hand_over(env, ["-m", "pytest", "-n", workers, *arguments[1:]], ROOT)
    if arguments[:1] == ["setup"]:
        prepare(env, "run", say)
        say(f"The course is set up in {env.folder}.")
        return 0
    if arguments[:1] == ["lock"]:
        return locks.renew(ROOT, arguments[1:])
    options = parse(arguments)
    prepare(env, "run", say)
    return open_lab(env, options)


def parse(arguments: list[str]) -> argparse.Namespace:
    """Read the options of a start; what follows ``--`` is for JupyterLab."""
    parser = argparse.ArgumentParser(
        prog="start.py",
        usage="python3 start.py [options] [-- options of JupyterLab]",
        description=DESCRIPTION,
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument(
        "--work",
        metavar="FOLDER",
        type=Path,
        default=ROOT / "work",
        help="your own folder with your copies of the notebooks (default: work, beside start.py)",
    )
    parser.add_argument("--no-browser", action="store_true", help="print the address only")
    parser.add_argument("--port", type=int, help="of JupyterLab (default: first free from 8888)")
    end = arguments.index("--") if "--" in arguments else len(arguments)
    options = parser.parse_args(arguments[:end])
    options.lab = arguments[end + 1 :]
    return options


def open_lab(env: Environment, options: argparse.Namespace) -> int:
    """Update the student's copies and open JupyterLab on the first chapter."""
    work = options.work.expanduser().resolve()
    for saying in update(ROOT / "notebooks", work):
        say(saying)
    say(f"Opening JupyterLab in {work}; Ctrl-C here ends it.")
    lab = ["-m", "jupyterlab", "--log-level=WARN", f"--ServerApp.root_dir={work}"]
    if (work / FIRST).exists():
        lab.append(f"--LabApp.default_url=/lab/tree/{FIRST}")
    if options.port:
        lab.append(f"--ServerApp.port={options.port}")
    if options.no_browser:
        lab.append("--no-browser")
    return hand_over(env, [*lab, *options.lab], work)


def hand_over(env: Environment, arguments: list[str], folder: Path) -> int:
    """Let the environment's Python go on in place of this one; return its exit code."""
    command = [str(env.python), *arguments]
    if os.name == "posix":
        os.chdir(folder)
        os.execve(command[0], command, variables(env))
    process = subprocess.Popen(command, env=variables(env), cwd=folder)
    while True:
        try:
            return process.wait()
        except KeyboardInterrupt:  # it got the Ctrl-C too and decides what that means
            continue


def say(sentence: str) -> None:
    """Tell the user, at once."""
    print(sentence, flush=True)
