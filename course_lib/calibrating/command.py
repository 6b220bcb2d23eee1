"""The commands ``course calibrate`` and ``course target``."""

from __future__ import annotations

import argparse
import shlex
import sys
from collections import Counter
from collections.abc import Sequence
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

from course_lib.boards import Board
from course_lib.calibrating.options import add_board_options, board_of, coefficients_of, lengths_of

if TYPE_CHECKING:
    from course_lib.calibrating.looking import Photo

EXAMPLE = """examples:
  course target target.pdf --board 9x6 --square 25    print this at 100 %, glue it on something flat
  course target small.pdf --board 9x6 --square 15 --beside    and this to measure a thing beside it
  course calibrate photos/ --board 9x6 --square 25    a folder with 10 to 30 photographs of it
  course calibrate IMG_*.JPG --board 10x7 --square 25 --kind dots --diameter 15

The exit code is 0 if all is well, 1 if there is something to do, 2 if there is no camera to tell.

Take the photographs with one camera whose zoom and focus stay as they are. Hold the board tilted
by 20 to 45 degrees, each time another way, near and far, and into every corner of the picture.
"""


def add_calibrate_command(commands: Any) -> None:
    """Add ``course calibrate``."""
    command = commands.add_parser(
        "calibrate",
        help="calibrate a camera from your own photographs of a board",
        description="Calibrate a camera from photographs of a board: find the board in each, "
        "estimate the camera, judge the result in plain words, and write a report.",
        epilog=EXAMPLE,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    command.add_argument("photos", nargs="+", metavar="PHOTO", help="files, folders or patterns")
    add_board_options(command)
    command.add_argument(
        "--coefficients",
        default="k1,k2,p1,p2,k3",
        metavar="k1,k2,…",
        help="which numbers of distortion to estimate, or none (%(default)s)",
    )
    command.add_argument(
        "--output",
        type=Path,
        default=Path("calibration"),
        metavar="DIR",
        help="folder for report.html and the camera's files (%(default)s)",
    )
    command.set_defaults(run=_calibrate)


def add_target_command(commands: Any) -> None:
    """Add ``course target``."""
    command = commands.add_parser(
        "target",
        help="write a board to print, as a PDF of exact size",
        description="Write a board to print, as a PDF page of exact size. Print it at 100 % (not "
        "'fit to page'), measure its bars, and glue it on something flat.",
    )
    command.add_argument("file", type=Path, metavar="FILE.pdf")
    add_board_options(command)
    command.add_argument("--page", default="A4", help="A4, A3, A2, A1 or letter (%(default)s)")
    command.add_argument(
        "--beside",
        action="store_true",
        help="leave room at the right of the board, for an object that is measured there",
    )
    command.set_defaults(run=_target)


def say(text: str) -> None:
    """Print a line at once; a terminal that lacks a character shows a question mark for it."""
    encoding = sys.stdout.encoding or "utf-8"
    print(text.encode(encoding, "replace").decode(encoding), flush=True)


def _target(options: argparse.Namespace) -> int:
    from data_generators.printable import save_board

    board = board_of(options)
    if options.file.suffix.lower() != ".pdf":
        raise ValueError(f"{options.file} must end in .pdf: a board is written as a PDF")
    save_board(options.file, board, options.page, options.beside)
    say(f"Wrote {options.file}: {board.name}. Print it at 100 % and measure its bars.")
    return 0


def _calibrate(options: argparse.Namespace) -> int:
    from course_lib.calibrating.finding import find_photos, left_out
    from course_lib.calibrating.judgement import judge
    from course_lib.calibrating.looking import look_at_photos
    from course_lib.calibrating.output import check_output
    from course_lib.calibrating.report import write_report
    from course_lib.calibrating.solving import solve
    from course_lib.calibration import CameraModel

    board = board_of(options)
    model = CameraModel(coefficients=coefficients_of(options.coefficients))
    paths, others = find_photos(options.photos), left_out(options.photos)
    check_output(options.output)
    for line in others:
        say(line)
    say(f"Looking for {board.name}, {lengths_of(board)}, in {len(paths)} photographs:")
    photos = look_at_photos(paths, board, say)
    _check_enough(photos, board)
    solved = solve(photos, board, model)
    judgement = judge(solved)
    files = write_report(options.output, solved, judgement, [*_told(options), *others])
    say("")
    for statement in judgement.statements:
        say(f"{statement.sign} {statement.text}")
    say("\nWrote " + ", ".join(str(file) for file in files))
    say(f"Next: open {files[0]}; it also shows how to straighten a photograph.")
    return 0 if judgement.fine else 1


def _told(options: argparse.Namespace) -> list[str]:
    """Return the command, and when and where it was run."""
    now, typed = datetime.now().astimezone(), shlex.join(["course", *options.typed])
    return [typed, f"{now:%d %B %Y, %H:%M}, in {Path.cwd()}"]


def _check_enough(photos: Sequence[Photo], board: Board) -> None:
    """Raise unless the board was found in three photographs, and no other in most."""
    from course_lib.calibrating.looking import check_board
    from course_lib.calibrating.photographs import KINDS

    used = [photo for photo in photos if photo.used]
    check_board(photos, board)
    if len(used) >= 3:
        return
    kinds = Counter(photo.problem for photo in photos if not photo.used)
    told = ", ".join(f"{count} {KINDS.get(kind, kind)}" for kind, count in kinds.most_common())
    of_others = f". Of the others: {told}; the lines above say what to do" if told else ""
    raise ValueError(
        f"the board was found in {len(used)} of {len(photos)} photographs; 3 are needed, 10 to 30 "
        f"are good{of_others}"
    )
