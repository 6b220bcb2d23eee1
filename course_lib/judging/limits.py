"""Bounds on what a student's function may do while it answers: time, output, size of the result."""

from __future__ import annotations

import ctypes
import io
import signal
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from types import FrameType
from typing import Any

import numpy as np


class TimeLimitReached(BaseException):
    """The answer took too long. Not an Exception, so that ``except Exception`` lets it through."""


class NotPlainError(TypeError):
    """A result that is not made of arrays, numbers, texts, tuples, lists and dictionaries."""


class TooLargeError(ValueError):
    """A result with more bytes or items than an exercise can need."""


@dataclass(frozen=True)
class Limits:
    """What an answer may use: seconds per call, characters of output, bytes of result."""

    seconds: float = 5.0
    characters: int = 2000
    bytes: int = 20_000_000


class BoundedText(io.TextIOBase):
    """A text stream that keeps the beginning of what is written and lets the rest go."""

    def __init__(self, limit: int) -> None:
        self._room = limit
        self._parts: list[str] = []

    def writable(self) -> bool:
        """Say that the stream takes text."""
        return True

    def write(self, text: str) -> int:
        """Keep what fits of a text."""
        if self._room > 0:
            self._parts.append(text[: self._room])
            self._room -= len(self._parts[-1])
        return len(text)

    def text(self) -> str:
        """Return what was kept, and say so where something was left out."""
        return "".join(self._parts) + (" … (more was printed)" if self._room <= 0 else "")


@contextmanager
def time_limit(seconds: float) -> Iterator[None]:
    """Raise `TimeLimitReached` inside the ``with`` block after some seconds.

    With POSIX signals in the main thread, sleeping and waiting are interrupted too; elsewhere
    (Windows, other threads) the running Python code is. The exception comes again and again, so
    that a bare ``except:`` in a loop does not swallow it for good.
    """
    main = threading.current_thread() is threading.main_thread()
    by_signal = main and hasattr(signal, "setitimer")
    with _alarm(seconds) if by_signal else _watchdog(seconds):
        yield


@contextmanager
def _alarm(seconds: float) -> Iterator[None]:
    def ring(signum: int, frame: FrameType | None) -> None:
        raise TimeLimitReached

    before = signal.signal(signal.SIGALRM, ring)
    try:
        signal.setitimer(signal.ITIMER_REAL, seconds, 0.05)
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


@contextmanager
def _watchdog(seconds: float) -> Iterator[None]:
    thread = threading.get_ident()
    over, turn, rang = threading.Event(), threading.Lock(), threading.Event()

    def watch() -> None:
        wait = seconds
        while not over.wait(wait):
            with turn:
                if not over.is_set():
                    rang.set()
                    _raise_in(thread)
            wait = 0.05

    threading.Thread(target=watch, daemon=True).start()
    try:
        yield
    finally:
        _call_off(thread, over, turn, rang)


def _call_off(
    thread: int, over: threading.Event, turn: threading.Lock, rang: threading.Event
) -> None:
    """Stop a watchdog, and take an exception that it sent but that was not delivered yet."""
    last_one_sent = False
    while True:
        try:
            over.set()
            with turn:
                if not rang.is_set():
                    return
                last_one_sent = True
                _raise_in(thread)  # takes the place of one that is still on its way
            while True:
                time.sleep(0.001)
        except TimeLimitReached:
            if last_one_sent:
                return


def _raise_in(thread: int) -> None:
    identifier, error = ctypes.c_ulong(thread), ctypes.py_object(TimeLimitReached)
    ctypes.pythonapi.PyThreadState_SetAsyncExc(identifier, error)


def plain(value: Any, limit: int, depth: int = 4) -> Any:
    """Copy a result as plain data: what can cross a process boundary without a pickle.

    Parameters
    ----------
    value : object
        What a student's function returned.
    limit : int
        Bytes (for arrays and texts) or items (for containers) that are still accepted.
    depth : int
        How deep containers may be nested.

    Returns
    -------
    None, bool, int, float, complex, str, numpy.ndarray, tuple, list or dict
        Subclasses are reduced to their plain type.

    Raises
    ------
    NotPlainError
        For any other type, or containers nested too deep.
    TooLargeError
        For a result over the limit.
    """
    if isinstance(value, np.ndarray | np.generic):
        return _plain_array(np.asarray(value), limit)
    if isinstance(value, str | tuple | list | dict) and len(value) > limit:
        raise TooLargeError(f"{len(value)} items")
    if value is None or type(value) in (bool, int, float, complex, str):
        return value
    if depth and isinstance(value, tuple | list):  # a named tuple, too
        base: Any = tuple if isinstance(value, tuple) else list
        return base(plain(item, limit, depth - 1) for item in base.__iter__(value))
    if depth and isinstance(value, dict) and all(type(key) in (str, int) for key in value):
        return {key: plain(item, limit, depth - 1) for key, item in dict.items(value)}
    raise NotPlainError(type(value).__name__)


def _plain_array(value: np.ndarray[Any, Any], limit: int) -> Any:
    if value.nbytes > limit or value.size > limit:
        raise TooLargeError(f"{value.nbytes} bytes")
    array = np.array(value, subok=False)
    if array.dtype.kind == "O":
        return plain(array.tolist(), limit)
    if array.dtype.kind not in "biufcU":
        raise NotPlainError(f"array of {array.dtype}")
    if array.dtype == np.longdouble:
        array = array.astype(float)
    return array if array.ndim else array.item()
