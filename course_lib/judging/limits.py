"""Bounds on what a student's function may do while it answers: time, output, size of the result."""

from __future__ import annotations

import ctypes
import io
import signal
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from types import FrameType
from typing import Any, NamedTuple

import numpy as np

#: Seconds after which a time that is over is said again.
AGAIN = 0.05


class TimeLimitReached(BaseException):
    """The answer took too long. Not an Exception, so that ``except Exception`` lets it through."""


class NotPlainError(TypeError):
    """A result that is not made of arrays, numbers, texts, tuples, lists and dictionaries."""


class TooLargeError(ValueError):
    """A result with more bytes or items than an exercise can need."""


@dataclass(frozen=True)
class Limits:
    """What an answer may use: seconds per call, characters of output, bytes of result.

    The seconds are the clock's or, if there is a `clock` to say how many of those, too, the
    processor's: see `time_limit`.
    """

    seconds: float = 5.0
    clock: float | None = None
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


class Bell:
    """Whether the time of a `time_limit` is over."""

    rang = False


@contextmanager
def time_limit(seconds: float, by_clock: float | None = None) -> Iterator[Bell]:
    """Raise `TimeLimitReached` inside the ``with`` block after some seconds.

    With POSIX signals in the main thread, sleeping and waiting are interrupted too; elsewhere
    (Windows, other threads) the running Python code is. The exception comes again and again, so
    that a bare ``except:`` in a loop does not swallow it for good. One limit may stand inside
    another.

    Parameters
    ----------
    seconds : float
        What the block may take: by the clock, or, if there is `by_clock`, of the processor, so
        that a busy machine takes nothing away. Without POSIX signals it is the clock always.
    by_clock : float, optional
        What it may take by the clock in any case, for a block that waits without computing.

    Yields
    ------
    Bell
        Says whether the time is over, for code that may have swallowed the exception.
    """
    bell = Bell()
    main = threading.current_thread() is threading.main_thread()
    if not (main and hasattr(signal, "setitimer")):
        with _watchdog(seconds if by_clock is None else by_clock, bell):
            yield bell
    elif by_clock is None:
        with _alarm(_CLOCK, seconds, bell):
            yield bell
    else:
        with _alarm(_CLOCK, by_clock, bell), _alarm(_PROCESSOR, seconds, bell):
            yield bell


class _Timer(NamedTuple):
    """A timer of the system: its name, that of its signal, and what it counts."""

    name: str
    signal: str
    now: Callable[[], float]


_CLOCK = _Timer("ITIMER_REAL", "SIGALRM", time.monotonic)
_PROCESSOR = _Timer("ITIMER_PROF", "SIGPROF", time.process_time)


@contextmanager
def _alarm(timer: _Timer, seconds: float, bell: Bell) -> Iterator[None]:
    which, number = getattr(signal, timer.name), getattr(signal, timer.signal)
    over = False

    def ring(signum: int, frame: FrameType | None) -> None:
        if not over:
            bell.rang = True
            raise TimeLimitReached

    before, start = signal.getsignal(number), timer.now()
    outer, interval = signal.getitimer(which)
    try:  # a short time may be over before the next line
        signal.signal(number, ring)
        signal.setitimer(which, min(seconds, outer or seconds), AGAIN)
        yield
    finally:
        over = True  # before all else, so that no ring gets into it
        signal.setitimer(which, 0)
        signal.signal(number, before)
        if outer:  # a limit around this one goes on
            signal.setitimer(which, max(outer - (timer.now() - start), 0.001), interval)


@contextmanager
def _watchdog(seconds: float, bell: Bell) -> Iterator[None]:
    thread = threading.get_ident()
    over, turn = threading.Event(), threading.Lock()

    def watch() -> None:
        wait = seconds
        while not over.wait(wait):
            with turn:
                if not over.is_set():
                    bell.rang = True
                    _raise_in(thread)
            wait = AGAIN

    threading.Thread(target=watch, daemon=True).start()
    try:
        yield
    finally:
        _call_off(thread, over, turn, bell)


def _call_off(thread: int, over: threading.Event, turn: threading.Lock, bell: Bell) -> None:
    """Stop a watchdog, and take an exception that it sent but that was not delivered yet."""
    last_one_sent = False
    while True:
        try:
            over.set()
            with turn:
                if not bell.rang:
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
