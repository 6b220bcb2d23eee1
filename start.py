"""Set the course up and open it: python3 start.py; run its tests: python3 start.py test.

Every Python, however old, must be able to read this one file, so that an old one can say
what is missing instead of failing on grammar it does not know. What it starts is in
course_lib/starting and, like this file, needs nothing but the standard library.
"""

import os
import subprocess
import sys

OLDEST = (3, 11)
CANDIDATES = [["python3." + minor] for minor in ("13", "12", "11", "14")] + [["py", "-3"]]


def is_new_enough(command):
    """Return whether the command starts a Python that can set the course up."""
    question = "import sys, ensurepip; sys.exit(sys.version_info < " + str(OLDEST) + ")"
    with open(os.devnull, "w") as nowhere:
        try:
            arguments = command + ["-c", question]  # noqa: RUF005 - Python 2 knows no [*command]
            return not subprocess.call(arguments, stdout=nowhere, stderr=nowhere)
        except OSError:
            return False


def advice_for_old_python():
    """Return what was expected, what came, and what to type or install instead."""
    problem = "The course needs Python 3.11 or newer; this is Python " + sys.version.split()[0]
    for command in CANDIDATES:
        if is_new_enough(command):
            line = " ".join(command + sys.argv)
            return problem + ".\nThis machine has a newer one. Type:  " + line
    return (
        problem
        + " ("
        + sys.executable
        + ").\nInstall Python 3.13 from python.org or with your system's packages, open a new\n"
        + "terminal, and type the same command with the new Python."
    )


if __name__ == "__main__":
    if sys.version_info < OLDEST:
        sys.exit(advice_for_old_python())
    from course_lib.starting.command import main

    sys.exit(main(sys.argv[1:]))
