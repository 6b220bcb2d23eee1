"""The ``course`` command: calibrate a camera, build notebooks, set a term up, grade it."""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Sequence
from pathlib import Path

import course_lib
from course_lib.calibrating import add_calibrate_command, add_target_command


class UsageError(Exception):
    """Something that the person at the keyboard can put right; its text is one sentence."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a ``course`` command.

    Parameters
    ----------
    arguments : sequence of str, optional
        What follows ``course`` on the command line.

    Returns
    -------
    int
        Exit code: 0 all is well, 1 a check found something, 2 it could not be done, 130
        it was stopped.
    """
    typed = sys.argv[1:] if arguments is None else list(arguments)
    options = _parser().parse_args(typed)
    options.typed = typed
    try:
        return int(options.run(options))
    except KeyboardInterrupt:
        print("course: stopped", file=sys.stderr)
        return 130
    except (UsageError, ValueError, OSError, RuntimeError) as error:
        print(f"course: {error}", file=sys.stderr)
        return 2


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="course",
        description="For your own camera (calibrate, target), and for authors and instructors of "
        "the camera course (build, term, grade, report, export, demo).",
    )
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    add_calibrate_command(commands)
    add_target_command(commands)
    _add_build(commands)
    _add_term(commands)
    _add_grade(commands)
    _add_report(commands)
    _add_export(commands)
    _add_demo(commands)
    return parser


def _add_build(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    command = commands.add_parser(
        "build",
        help="make the student notebooks from the lessons",
        description="Make notebooks/NN_topic/NN_topic.ipynb from lessons/NN_topic.md.",
    )
    command.add_argument("lessons", nargs="*", metavar="NN_topic", help="only these lessons")
    command.add_argument(
        "--check",
        action="store_true",
        help="change nothing; say what is wrong with lessons, and which notebooks are stale",
    )
    command.set_defaults(run=_build)


def _build(options: argparse.Namespace) -> int:
    from course_lib.authoring.building import build, check_built, find_lessons

    root = course_folder()
    if options.check:
        problems = check_built(root, options.lessons)
        print("\n".join(problems) or "All lessons are well formed, all notebooks fresh.")
        return 1 if problems else 0
    changed = build(root, options.lessons)
    for path in changed:
        print(f"wrote {path.relative_to(root).as_posix()}")
    if not changed:
        count = len(find_lessons(root, options.lessons))
        print(f"Nothing to do: {count} fresh notebook{'' if count == 1 else 's'}.")
    return 0


def _add_term(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    command = commands.add_parser(
        "term",
        help="make a course directory in which nbgrader works",
        description="Make a term's course directory for nbgrader, outside the course's own folder.",
    )
    option = command.add_argument
    option("directory", type=Path, metavar="DIR", help="a new folder")
    graded = "which lessons are graded (all but 00_welcome)"
    option("--chapters", nargs="+", default=[], metavar="NN_topic", help=graded)
    option("--course-id", default="", metavar="ID", help="the name of DIR")
    exchange = "where students fetch and submit with nbgrader (DIR/exchange)"
    option("--exchange", type=Path, metavar="DIR", help=exchange)
    database = "a database of PostgreSQL, without password (DIR/gradebook.db, a file of SQLite)"
    option("--gradebook", default="", metavar="URL", help=database)
    command.set_defaults(run=_term)


def _term(options: argparse.Namespace) -> int:
    from course_lib.grading.term import make_term, plan_term

    root = course_folder()
    places = (options.course_id, options.exchange, options.gradebook)
    term = plan_term(options.directory, root, options.chapters, *places)
    make_term(term, root)
    print(f"Made {term.directory} with {', '.join(term.chapters)}.")
    print(f"Next: cd there, read README.md, run: nbgrader generate_assignment {term.chapters[0]}")
    return 0


def _add_grade(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    command = commands.add_parser(
        "grade",
        help="grade what was handed in, behind walls, in a term's directory",
        description="Grade the submissions of an assignment. Run it in a term's directory.",
    )
    option = command.add_argument
    option("assignment", nargs="?", metavar="NN_topic", help="which assignment")
    option("--student", nargs="+", default=[], metavar="ID", help="only these")
    option("--force", action="store_true", help="grade again what was graded")
    _add_term_option(command)
    many = "how many at a time (one for each core, or worker of the cluster)"
    option("--workers", type=_number, metavar="N", help=many)
    option("--scheduler", metavar="ADDRESS", help="grade on this Dask cluster, not here")
    _add_isolation_option(command, "'none' trusts every submission")
    option("--explain-isolation", action="store_true", help="say what holds on this machine")
    command.set_defaults(run=_grade)


def _grade(options: argparse.Namespace) -> int:
    _demand_posix()
    from course_lib.grading.command import grade

    return grade(options)


def _add_report(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    command = commands.add_parser(
        "report",
        help="write a page on the class and one on each student",
        description="Write report/NN_topic/index.html and a page on each student, in a term's "
        "directory: scores, exercises, misconceptions, submissions that look alike.",
    )
    _add_assignments(command)
    command.set_defaults(run=_report)


def _report(options: argparse.Namespace) -> int:
    from course_lib.grading.report import report

    return report(options)


def _add_export(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    command = commands.add_parser(
        "export",
        help="write the points as Canvas, Moodle and nbgrader read them",
        description="Write export/canvas.csv, moodle.csv and nbgrader.csv in a term's directory.",
    )
    _add_assignments(command)
    option = command.add_argument
    roster = "a CSV file that Canvas or Moodle exported: write the table for it, matched to it"
    option("--roster", type=Path, metavar="FILE", help=roster)
    missing = "what who handed nothing in gets (an empty cell)"
    option("--missing", type=_points, metavar="POINTS", help=missing)
    command.set_defaults(run=_export)


def _export(options: argparse.Namespace) -> int:
    from course_lib.grading.export import export

    return export(options)


def _add_demo(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    command = commands.add_parser(
        "demo",
        help="show all of this on a simulated class, in about a minute",
        description="Make a term, let a simulated class hand in, grade, report and export.",
    )
    option = command.add_argument
    option("directory", nargs="?", type=Path, metavar="DIR", help="a new folder (a temporary one)")
    option("--chapter", default="01_pinhole", metavar="NN_topic", help="which (01_pinhole)")
    option("--students", type=_number, default=30, metavar="N", help="how many, 8 to 30 (30)")
    _add_isolation_option(command, "as in course grade")
    command.set_defaults(run=_demo)


def _demo(options: argparse.Namespace) -> int:
    _demand_posix()
    from course_lib.grading.demo import demo

    return demo(options)


def _add_assignments(command: argparse.ArgumentParser) -> None:
    command.add_argument("assignments", nargs="*", metavar="NN_topic", help="all, unless named")
    _add_term_option(command)


def _add_term_option(command: argparse.ArgumentParser) -> None:
    where = "the term's directory"
    command.add_argument("--term", type=Path, default=Path(), metavar="DIR", help=where)


def _add_isolation_option(command: argparse.ArgumentParser, meaning: str) -> None:
    command.add_argument("--isolation", choices=["bubblewrap", "none"], help=meaning)


def _demand_posix() -> None:
    if sys.platform == "win32":
        raise UsageError("grading needs Linux or macOS; on Windows, use WSL")


def _number(text: str) -> int:
    """Return how many, of what was typed."""
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"expected a number from 1, got {text!r}")
    return int(text)


def _points(text: str) -> float:
    """Return the points that were typed; never less than none, or what is no number."""
    if not re.fullmatch(r"\d+(\.\d*)?", text, re.ASCII):
        raise argparse.ArgumentTypeError(f"expected points, as 0 or 2.5, got {text!r}")
    return float(text)


def course_folder(start: Path | None = None) -> Path:
    """Return the course's folder: the working directory or one above it, or the library's own."""
    start = start or Path.cwd()
    candidates = [start, *start.parents, Path(course_lib.__file__).parents[1]]
    found = next((folder for folder in candidates if (folder / "lessons").is_dir()), None)
    if found is None:
        raise UsageError("there is no folder `lessons` here; run this in the course's folder")
    return found


if __name__ == "__main__":
    sys.exit(main())
