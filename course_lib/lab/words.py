"""What the lab says, a line or more that fit on the page of a notebook."""

from __future__ import annotations

import re
import textwrap

WIDTH = 88  # characters


def say(text: str) -> None:
    """Print lines, each folded between words."""
    for line in text.split("\n"):
        print(textwrap.fill(line, WIDTH, subsequent_indent="    ", break_long_words=False))


def sentence(reason: object) -> str:
    """Return a reason as a sentence, as `in_notebook`."""
    text = in_notebook(str(reason).rstrip("."))
    return text[0].upper() + text[1:] + "."


def in_notebook(text: str) -> str:
    """Return what is said to who types a command as a notebook's reader knows it.

    Examples
    --------
    >>> in_notebook("is it --board 9x6? Squares of another size than --square")
    'is it Checkerboard(9, 6)? Squares of another size than `square`'
    """
    text = re.sub(r"--board (\d+)x(\d+)", r"Checkerboard(\1, \2)", text)
    return re.sub(r"--(\w+)", r"`\1`", text)
