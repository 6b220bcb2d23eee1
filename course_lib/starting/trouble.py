"""What can go wrong while the course starts, in sentences that say what to do."""

import errno
import re
import shutil
import sys
import sysconfig
import tempfile
from pathlib import Path

GIGABYTES_NEEDED = 1.5


class Trouble(Exception):
    """A reason why the course cannot start, told as a sentence and a way out."""


ADVICE = {
    "disk": (
        r"No space left on device|Errno 28\b|WinError 112|not enough space on the disk|Disk quota",
        "The disk is full. {space}\nMake room and start again; nothing half-done was left.",
    ),
    "long path": (
        r"Long Path support|File name too long",
        "The path of the course's folder is too long for this system: {root}\n"
        "Move the folder nearer to the top of the disk and start again.",
    ),
    "separator": (
        r"contains the PATH separator",
        "Python cannot work in a folder with this name: {root}\n"
        "Rename it without ':' or ';' and start again.",
    ),
    "hash": (
        r"DO NOT MATCH THE HASHES",
        "A downloaded package is not the one that the course was made with, so it was refused.\n"
        "Most often a download was cut short or a proxy changed it. Set the variable\n"
        "PIP_NO_CACHE_DIR to 1 and start again, on another network if it stays.",
    ),
    "permission": (
        r"Permission denied|Errno 13\b|Access is denied|WinError (5|32)\b|Read-only file system",
        "Something may not be written, or another program holds it open.\n"
        "Close JupyterLab if it is open. The course's folder must be your own: {root}\n"
        "If it is not, copy it to your home folder and start there.",
    ),
    "certificate": (
        r"CERTIFICATE_VERIFY_FAILED|SSLError|SSLCertVerificationError",
        "The network answers with a certificate that Python does not trust, as proxies of\n"
        "companies and universities do. Ask there for the certificate's file and name it:\n"
        "set the variable PIP_CERT to its path, then start again.",
    ),
    "network": (
        r"name resolution|NewConnectionError|Max retries exceeded|ProxyError|Timeout(Error)?\b"
        r"|timed out|Network is unreachable|getaddrinfo failed|Connection (refused|reset|aborted)"
        r"|No route to host|Remote end closed|IncompleteRead|Name or service not known",
        "The packages could not be downloaded: is this machine connected to the internet?\n"
        "Behind a proxy, set the variable HTTPS_PROXY to its address. Then start again;\n"
        "what was downloaded already is kept and not fetched twice.",
    ),
    "no package": (
        r"No matching distribution found|is not a supported wheel|from versions: none",
        "A package does not exist ready-made for this machine ({python}).\n"
        "The course is made for 64-bit Python 3.11, 3.12 and 3.13: install one of these and\n"
        "start again with it.",
    ),
    "no pip": (
        r"ensurepip is not available|No module named '?(venv|ensurepip)",
        "This machine's Python lacks the part that makes private environments (venv).\n"
        "On Debian and Ubuntu install it with `sudo apt install python3-venv`;\n"
        "elsewhere install Python 3.13 from python.org. Then start again.",
    ),
}
ORDER = list(ADVICE)  # a later kind of trouble can be the consequence of an earlier one


def kind_of(log: str) -> str | None:
    """Return the name of the trouble that a log of pip or venv tells of, None if unknown."""
    return next((kind for kind in ORDER if re.search(ADVICE[kind][0], log)), None)


def advice(kind: str, root: Path) -> str:
    """Return what happened and what to do, for one kind of trouble.

    Parameters
    ----------
    kind : str
        A key of `ADVICE`.
    root : Path
        The course's folder.
    """
    python = f"Python {sys.version.split()[0]}, {sysconfig.get_platform()}"
    return ADVICE[kind][1].format(root=root, python=python, space=_free_space(root))


def explain_log(log: str, step: str, log_file: Path, root: Path) -> str:
    """Return why a step of the set-up failed, by what its program printed."""
    kind = kind_of(log)
    errors = [line for line in log.splitlines() if re.match(r"\s*(ERROR|error|\w*Error)\b", line)]
    told = "\n".join(errors[-3:]) or "It gave no reason."
    reason = advice(kind, root) if kind else told
    return f"{step} did not work.\n{reason}\nEverything that was printed is in {log_file}"


def explain_os_error(error: OSError, root: Path) -> str:
    """Return why the system refused a file, and what to do."""
    kinds = {errno.ENOSPC: "disk", errno.EDQUOT: "disk", errno.ENAMETOOLONG: "long path"}
    kinds |= dict.fromkeys((errno.EACCES, errno.EPERM, errno.EROFS), "permission")
    kind = kinds.get(error.errno or 0)
    return f"{error}\n{advice(kind, root)}" if kind else f"The system said: {error}"


def _free_space(root: Path) -> str:
    places = dict.fromkeys([root, Path(tempfile.gettempdir())])
    free = [f"{shutil.disk_usage(place).free / 1e9:.1f} GB in {place}" for place in places]
    return f"The course needs about {GIGABYTES_NEEDED} GB.\nFree are {' and '.join(free)}."
