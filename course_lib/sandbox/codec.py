"""Plain values as bytes, and back: what passes between the grader and a student's process.

A message is the length of its text and of its numbers, then a JSON text, then the arrays' bytes.
Nothing in it can run: no pickles, no names of functions. What comes from a student's process is
checked in every respect before it is used.
"""

from __future__ import annotations

import importlib
import json
import math
import struct
from collections.abc import Callable
from dataclasses import fields, is_dataclass
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

#: Bytes of a message's text and of its arrays that are still accepted.
TEXT_LIMIT, ARRAY_LIMIT = 8_000_000, 24_000_000
#: How deep values may be nested, in a message and its envelope together.
DEPTH = 12
#: How many whole numbers as keys may be larger than Python tells apart at once: among keys with the
#: same hash it looks through all.
MOST_LARGE_KEYS, LARGE_KEY = 100, 1 << 60
HEAD = struct.Struct("!4sII")
_MAGIC = b"cam1"
#: Kinds and sizes of arrays that may pass; text arrays besides.
_DTYPES = {"b1", "i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8", "f2", "f4", "f8", "c8", "c16"}


class MalformedMessageError(ValueError):
    """What came is no message, or one that is too large."""


def encode(value: Any) -> bytes:
    """Write a plain value as a message.

    Parameters
    ----------
    value : object
        None, booleans, numbers, texts, bytes, arrays, tuples, lists, dictionaries with texts or
        whole numbers as keys; also NumPy's numbers and generators, and frozen dataclasses of the
        course (`SensorModel`), which only the grader sends.

    Returns
    -------
    bytes
        The message with its head.

    Raises
    ------
    TypeError
        If a value cannot be sent.
    """
    arrays: list[bytes] = []
    text = json.dumps(_pack(value, arrays), separators=(",", ":")).encode("ascii")
    blob = b"".join(arrays)
    return HEAD.pack(_MAGIC, len(text), len(blob)) + text + blob


def _pack(value: Any, arrays: list[bytes]) -> Any:
    """Return a value as JSON knows it; what it does not know is a list that begins with a name."""
    if value is None or type(value) in (bool, int, float, str):
        return value
    if isinstance(value, np.ndarray):
        return _pack_array(value, arrays)
    if type(value) in (tuple, list):
        return [type(value).__name__, *(_pack(item, arrays) for item in value)]
    if type(value) is dict:
        pairs = [[key, _pack(item, arrays)] for key, item in value.items()]
        return ["dict", *pairs]
    if type(value) is complex:
        return ["complex", value.real, value.imag]
    if type(value) is bytes:
        return ["bytes", _pack_array(np.frombuffer(value, np.uint8), arrays)]
    return _pack_sent(value, arrays)


def _pack_sent(value: Any, arrays: list[bytes]) -> Any:
    """Return what only the grader sends: numbers of NumPy, generators, the course's dataclasses."""
    if isinstance(value, np.generic):
        return ["scalar", _pack_array(np.asarray(value), arrays)]
    if isinstance(value, np.random.Generator):
        state = value.bit_generator.state
        return ["generator", type(value.bit_generator).__name__, _pack(state, arrays)]
    kind = type(value)
    if is_dataclass(kind) and kind.__module__.startswith("course_lib."):
        content = {field.name: getattr(value, field.name) for field in fields(kind)}
        return ["object", kind.__module__, kind.__name__, _pack(content, arrays)]
    raise TypeError(f"a {kind.__name__} cannot be sent to a student's process")


def _pack_array(value: NDArray[Any], arrays: list[bytes]) -> Any:
    if value.dtype.kind == "f" and value.dtype.itemsize > 8:
        value = value.astype(np.float64)
    elif value.dtype.kind == "c" and value.dtype.itemsize > 16:
        value = value.astype(np.complex128)
    value = value.astype(value.dtype.newbyteorder("<"), copy=False)
    arrays.append(value.tobytes())
    kind = f"{value.dtype.kind}{value.dtype.itemsize}"
    return ["array", kind, list(value.shape), len(arrays[-1])]


def decode(message: bytes, *, trusted: bool = False) -> Any:
    """Read a message.

    Parameters
    ----------
    message : bytes
        With its head.
    trusted : bool
        Whether it comes from the grader: only then may it hold generators and dataclasses.

    Returns
    -------
    object
        The value.

    Raises
    ------
    MalformedMessageError
        If it is not a message that `encode` could have written.
    """
    if len(message) < HEAD.size:
        raise MalformedMessageError("a message is cut off")
    size, space = sizes(message[: HEAD.size])
    if len(message) != HEAD.size + size + space:
        raise MalformedMessageError("a message has another length than it says")
    body = memoryview(message)[HEAD.size :]
    try:
        tree = json.loads(bytes(body[:size]))
        reader = _Reader(body[size:], trusted)
        value = reader.read(tree, DEPTH)
    except MalformedMessageError:
        raise
    except (ValueError, TypeError, LookupError, RecursionError, OverflowError) as error:
        raise MalformedMessageError(f"a message cannot be read: {type(error).__name__}") from None
    if reader.place != space:
        raise MalformedMessageError("a message holds bytes that belong to nothing")
    return value


class _Reader:
    """Reads values; arrays come one after the other."""

    def __init__(self, blob: memoryview, trusted: bool) -> None:
        self.blob, self.trusted, self.place = blob, trusted, 0

    def read(self, tree: Any, depth: int) -> Any:
        """Return the value that a piece of JSON stands for."""
        if isinstance(tree, dict):
            raise MalformedMessageError("a message holds a bare object")
        if not isinstance(tree, list):
            return tree
        if depth < 0 or not tree:
            raise MalformedMessageError("a message is nested too deep, or empty")
        name, *content = tree
        readers = self._trusted_readers if self.trusted else self._readers
        if type(name) is not str or name not in readers:
            raise MalformedMessageError("a message holds a kind of value that is not allowed")
        return readers[name](self, content, depth - 1)

    def _list(self, content: list[Any], depth: int) -> list[Any]:
        return [self.read(item, depth) for item in content]

    def _tuple(self, content: list[Any], depth: int) -> tuple[Any, ...]:
        return tuple(self._list(content, depth))

    def _dict(self, content: list[Any], depth: int) -> dict[Any, Any]:
        if any(type(key) not in (str, int) for key, _ in content):
            raise MalformedMessageError("a key is neither a text nor a whole number")
        if sum(type(key) is int and abs(key) >= LARGE_KEY for key, _ in content) > MOST_LARGE_KEYS:
            raise MalformedMessageError("too many keys are large numbers")
        return {key: self.read(item, depth) for key, item in content}

    def _complex(self, content: list[Any], _: int) -> complex:
        real, imaginary = content
        return complex(float(real), float(imaginary))

    def _bytes(self, content: list[Any], depth: int) -> bytes:
        ((name, *array),) = content
        if name != "array":
            raise MalformedMessageError("bytes are an array of bytes")
        return bytes(self._array(array, depth))

    def _array(self, content: list[Any], _: int) -> NDArray[Any]:
        kind, shape, size = content
        if type(kind) is not str or not (kind in _DTYPES or _is_text(kind)):
            raise MalformedMessageError("an array has a type that is not allowed")
        if len(shape) > 32 or any(type(n) is not int or n < 0 for n in shape):
            raise MalformedMessageError("an array has a shape that is none")
        dtype = np.dtype("<" + ("U" + str(int(kind[1:]) // 4) if kind[0] == "U" else kind))
        if type(size) is not int or size != math.prod(shape) * dtype.itemsize:
            raise MalformedMessageError("an array has another size than its shape")
        if size > len(self.blob) - self.place:
            raise MalformedMessageError("an array is cut off")
        data = bytes(self.blob[self.place : self.place + size])
        self.place += size
        return _checked(data, dtype).reshape(shape)

    def _scalar(self, content: list[Any], depth: int) -> Any:
        return self.read(content[0], depth)[()]

    def _generator(self, content: list[Any], depth: int) -> np.random.Generator:
        bits = getattr(np.random, content[0])()
        bits.state = self.read(content[1], depth)
        return np.random.Generator(bits)

    def _object(self, content: list[Any], depth: int) -> Any:
        module, kind, values = content
        return getattr(importlib.import_module(module), kind)(**self.read(values, depth))

    _readers: ClassVar[dict[str, Callable[..., Any]]] = {
        "array": _array,
        "bytes": _bytes,
        "complex": _complex,
        "dict": _dict,
        "list": _list,
        "tuple": _tuple,
    }
    #: Only the grader sends these.
    _trusted_readers: ClassVar[dict[str, Callable[..., Any]]] = {
        **_readers,
        "generator": _generator,
        "object": _object,
        "scalar": _scalar,
    }


def _is_text(kind: str) -> bool:
    return kind[:1] == "U" and kind[1:].isdecimal() and 0 < int(kind[1:]) < 1_000_000


def _checked(data: bytes, dtype: np.dtype[Any]) -> NDArray[Any]:
    """Return an array whose every entry is one that NumPy itself could have written."""
    if dtype.kind == "b":
        return np.frombuffer(data, np.uint8).astype(bool)
    if dtype.kind == "U":
        letters = np.frombuffer(data, "<u4")
        if letters.size and (letters.max() > 0x10FFFF or np.any((letters >> 11) == 0x1B)):
            raise MalformedMessageError("a text holds letters that are none")
    array: NDArray[Any] = np.frombuffer(bytearray(data), dtype)
    return array


def sizes(head: bytes) -> tuple[int, int]:
    """Return how long a message's text and arrays are, by its head.

    Raises
    ------
    MalformedMessageError
        If it is no head, or the message is too large.
    """
    magic, size, space = HEAD.unpack(head)
    if magic != _MAGIC:
        raise MalformedMessageError("what came is no message")
    if size > TEXT_LIMIT or space > ARRAY_LIMIT:
        raise MalformedMessageError(f"a message is too large: {size + space} bytes")
    return size, space
