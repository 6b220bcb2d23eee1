"""The secret of a term: a key, and a seed for each student and assignment derived from it."""

from __future__ import annotations

import hashlib
import hmac
import os
import secrets
from pathlib import Path


def write_key(path: Path) -> None:
    """Write a new random key that only its owner can read.

    Parameters
    ----------
    path : pathlib.Path
        A file that does not exist yet.
    """
    descriptor = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
    with os.fdopen(descriptor, "w", encoding="ascii") as file:
        file.write(secrets.token_hex(32) + "\n")


def read_key(path: Path) -> bytes:
    """Read a term's key.

    Parameters
    ----------
    path : pathlib.Path
        Written by `write_key`.

    Returns
    -------
    bytes
        The key.

    Raises
    ------
    ValueError
        If there is no key, or too little of it to be one.
    """
    text = path.read_text(encoding="ascii").strip() if path.is_file() else ""
    if len(text) < 32:
        raise ValueError(
            f"no key in {path}: without it nothing can be graded. Restore it from a backup; "
            "a new one gives students other hidden inputs than before"
        )
    return text.encode()


def grading_seed(key: bytes, student: str, assignment: str) -> str:
    """Return the seed of a student's hidden inputs in an assignment.

    Parameters
    ----------
    key : bytes
        The term's key.
    student, assignment : str
        As nbgrader names them.

    Returns
    -------
    str
        64 hexadecimal digits (HMAC-SHA256): the same each time, and no way back to the key.
    """
    words = "\x1f".join([student, assignment]).encode()
    return hmac.new(key, words, hashlib.sha256).hexdigest()
