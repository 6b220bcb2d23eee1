"""Send and receive plain values over a pair of sockets."""

from __future__ import annotations

import math
import select
import socket
import time
from typing import Any

from course_lib.sandbox.codec import HEAD, MalformedMessageError, decode, encode, sizes

__all__ = [
    "BEGIN",
    "Closed",
    "Late",
    "MalformedMessageError",
    "decode",
    "receive",
    "receive_message",
    "send",
]

#: From the grader to a server: begin a job. With it come the ends of its lines: life, talk,
#: questions.
BEGIN = b"J"


class Closed(Exception):
    """The other side is gone."""


class Late(Exception):
    """Nothing, or not everything, came in time."""


def send(end: socket.socket, value: Any) -> None:
    """Send a value; wait until it is taken.

    Raises
    ------
    Closed
        If nobody is there.
    """
    try:
        end.sendall(encode(value))
    except OSError as error:
        raise Closed(str(error)) from None


def receive(end: socket.socket, seconds: float | None = None, *, trusted: bool = False) -> Any:
    """Receive a value.

    Parameters
    ----------
    end : socket.socket
        One end of a pair.
    seconds : float, optional
        How long the whole message may take.
    trusted : bool
        As for `decode`.

    Raises
    ------
    Closed
        If the other side is gone.
    Late
        If it took too long.
    MalformedMessageError
        If it is no message.
    """
    return decode(receive_message(end, seconds), trusted=trusted)


def receive_message(end: socket.socket, seconds: float | None = None) -> bytes:
    """Receive a message as it is, for whoever counts bytes; parameters and errors of `receive`."""
    deadline = None if seconds is None else time.monotonic() + seconds
    head = _exactly(end, HEAD.size, deadline)
    text, space = sizes(head)
    return head + _exactly(end, text + space, deadline)


def _exactly(end: socket.socket, size: int, deadline: float | None) -> bytes:
    parts, missing = [], size
    while missing:
        left = None if deadline is None else deadline - time.monotonic()
        if left is not None and (left <= 0 or not _readable(end, left)):
            raise Late
        try:
            part = end.recv(min(missing, 1 << 20))
        except OSError as error:
            raise Closed(str(error)) from None
        if not part:
            raise Closed("nobody is there")
        parts.append(part)
        missing -= len(part)
    return b"".join(parts)


def _readable(end: socket.socket, seconds: float) -> bool:
    waiting = select.poll()
    waiting.register(end, select.POLLIN)
    return bool(waiting.poll(math.ceil(seconds * 1000)))
