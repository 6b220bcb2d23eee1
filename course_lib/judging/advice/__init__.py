"""Plain words for the exceptions that beginners meet most."""

from __future__ import annotations

from course_lib.judging.advice.on_code import ON_CODE
from course_lib.judging.advice.on_numbers import ON_NUMBERS

#: Name of the exception, a piece of its message, and what it means; the first that fits counts.
ADVICE = (*ON_CODE, *ON_NUMBERS)


def advice(error: str, message: str) -> str:
    """Return what an exception most often means.

    Parameters
    ----------
    error : str
        The exception's name.
    message : str
        Its text.

    Returns
    -------
    str
        A sentence that gives no input away, or nothing.
    """
    fitting = (
        words
        for name, piece, words in ADVICE
        if name == error and (piece in message if isinstance(piece, str) else piece.search(message))
    )
    return next(fitting, "")
