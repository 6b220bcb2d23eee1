"""Ways to compare an answer with the truth. Each returns None or a `Mismatch` that says why.

A comparison is a frozen dataclass that is called with ``(got, expected)``. It checks in the order
type, shape, values, so that the first thing to mend comes first.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Mismatch:
    """Why an answer is not right, in words that give none of the values away."""

    kind: Literal["type", "shape", "values"]
    message: str


Comparison = Callable[[Any, Any], Mismatch | None]

#: What an array holds that is no number: one entry, and several.
KINDS = {
    "b": ("True or False", "truth values of "),
    "c": ("a complex number", "complex numbers of "),
    "U": ("a text", "texts of "),
    "O": ("an object, not a number", "objects, not numbers, of "),
}
#: Said where only one of two values is wrong, and where only one of several is.
OTHER_VALUES = ("The other one is right.", "The others are right.")
OTHER_ENTRIES = ("The other entry is right.", "The other entries are right.")


def describe(value: Any) -> str:
    """Name the type of a plain value as a student would: 'a number', 'an array of shape (4, 2)'."""
    if value is None:
        return "None"
    if isinstance(value, bool):
        return "True or False"
    if isinstance(value, int | float):
        return "a number"
    if isinstance(value, complex):
        return "a complex number"
    if isinstance(value, np.ndarray):
        one, many = KINDS.get(value.dtype.kind, ("a number", ""))
        return f"an array of {many}shape {value.shape}" if value.ndim else one
    if isinstance(value, tuple | list):
        return f"a {type(value).__name__} of {len(value)} value{'s' * (len(value) != 1)}"
    if isinstance(value, str | dict):
        return "a text" if isinstance(value, str) else "a dictionary"
    return f"a {type(value).__name__}"


def as_numbers(got: Any, expected: NDArray[Any]) -> NDArray[Any] | Mismatch:
    """Return `got` as a float array with the shape of `expected`, or say why it is not one."""
    if got is None:
        message = (
            f"The answer is None, and {describe(expected)} was expected. Is the `return` missing?"
        )
        return Mismatch("type", message)
    if isinstance(got, str | dict | bool):
        return _other_than(got, expected)
    if not expected.ndim and _has_decimal_comma(got):
        whole, part = got
        hint = f" Python writes decimals with a point: `{whole}.{part}`."
        return _other_than(got, expected, hint)
    try:
        array = np.asarray(got)
    except ValueError:  # rows of different length
        return _other_than(got, expected)
    if array.dtype.kind not in "iuf":
        return _other_than(got, expected)
    if array.shape != expected.shape:
        hint = " Points are rows here: is it transposed?" if _is_transposed(array, expected) else ""
        return Mismatch("shape", _other_than(got, expected, hint).message)
    return array.astype(float)


def _other_than(got: Any, expected: NDArray[Any], hint: str = "") -> Mismatch:
    """Say that an answer is of another type than the one expected."""
    message = f"The answer is {describe(got)}; {describe(expected)} was expected.{hint}"
    return Mismatch("type", message)


def close_to(array: NDArray[Any], truth: NDArray[Any], rtol: float, atol: float) -> NDArray[Any]:
    """Return what `np.isclose` does, with NaN equal to NaN, in a fraction of its time."""
    if truth.ndim:
        with np.errstate(invalid="ignore"):  # inf - inf
            near = np.abs(array - truth) <= atol + rtol * np.abs(truth)
        near &= np.isfinite(truth)
        return np.asarray(near | (array == truth) | (np.isnan(array) & np.isnan(truth)))
    got, wanted = float(array), float(truth)
    near = math.isfinite(wanted) and abs(got - wanted) <= atol + rtol * abs(wanted)
    return np.asarray(got == wanted or near or (math.isnan(got) and math.isnan(wanted)))


def _has_decimal_comma(got: Any) -> bool:
    """Whether an answer is what Python makes of a number like 12,5; longer ones nobody types."""
    pair = isinstance(got, tuple) and len(got) == 2
    return pair and all(type(part) is int and abs(part) < 10_000 for part in got)


def _is_transposed(array: NDArray[Any], expected: NDArray[Any]) -> bool:
    """Whether points stand in columns; a picture with its sides exchanged has longer rows."""
    points = array.ndim == 2 and min(array.shape) <= 4
    return points and array.shape == expected.shape[::-1]


@dataclass(frozen=True)
class Close:
    """Numbers and arrays of numbers that agree within a tolerance; NaN only where NaN is right.

    Tuples, lists and dictionaries of numbers are compared element by element.
    """

    rtol: float = 1e-6
    atol: float = 1e-9

    def __call__(self, got: Any, expected: Any) -> Mismatch | None:
        """Return why `got` is not `expected`, or None."""
        if isinstance(expected, dict):
            return self._keys(got, expected)
        if isinstance(expected, tuple):
            return self._elements(got, expected)
        if isinstance(expected, str):  # the text of a number is not the number
            return Exactly()(got, expected)
        truth = np.asarray(expected, dtype=float)
        array = as_numbers(got, truth)
        if isinstance(array, Mismatch):
            return array
        right = close_to(array, truth, self.rtol, self.atol)
        return None if right.all() else self._values(array, truth, right)

    def _values(self, array: NDArray[Any], truth: NDArray[Any], right: NDArray[Any]) -> Mismatch:
        if np.isnan(array[~right]).all() and not np.isnan(truth[~right]).any():
            return Mismatch("values", "Some values are NaN (not a number) that should be numbers.")
        if np.isnan(truth[~right]).all():
            return Mismatch("values", "Some values are numbers that should be NaN (no answer).")
        if np.isinf(truth[~right]).all():
            which = "Some values" if truth.ndim else "The value"
            return Mismatch("values", f"{which} should be infinite (`np.inf`) and not a number.")
        if close_to(array, truth, 3e-3, 0.0).all():
            nearly = "Nearly right, less than 0.3 % off. Is it rounded, or a small thing missing?"
            return Mismatch("values", nearly)
        if array.ndim == 0:
            return Mismatch("values", "The number is not the right one.")
        share = f"{np.count_nonzero(~right)} of {right.size}"
        return Mismatch("values", f"The shape is right, but {share} values are not.")

    def _keys(self, got: Any, expected: dict[Any, Any]) -> Mismatch | None:
        if not isinstance(got, dict) or set(got) != set(expected):
            names = ", ".join(map(str, expected))
            return Mismatch("type", f"A dictionary with the keys {names} was expected.")
        pairs = ((f"`{key}`", got[key], expected[key]) for key in expected)
        return self._first_wrong(pairs, OTHER_ENTRIES)

    def _elements(self, got: Any, expected: tuple[Any, ...]) -> Mismatch | None:
        several = isinstance(got, tuple | list) or (isinstance(got, np.ndarray) and got.ndim > 0)
        if not several or len(got) != len(expected):
            missing = " Is a `return` missing?" if got is None else ""
            wanted = f"{len(expected)} values were expected.{missing}"
            message = f"The answer is {describe(got)}; {wanted}"
            return Mismatch("type", message)
        names = (f"Value {i} of {len(expected)}" for i in range(1, len(expected) + 1))
        return self._first_wrong(zip(names, got, expected, strict=True), OTHER_VALUES)

    def _first_wrong(
        self, pairs: Iterable[tuple[str, Any, Any]], others: tuple[str, str]
    ) -> Mismatch | None:
        every = list(pairs)
        for i, (name, got, expected) in enumerate(every):
            if miss := self(got, expected):
                alone = len(every) > 1 and all(self(g, e) is None for _, g, e in every[i + 1 :])
                praise = others[len(every) > 2] if alone else ""
                return Mismatch(miss.kind, f"{name}: {miss.message} {praise}".rstrip())
        return None


@dataclass(frozen=True)
class Exactly:
    """The same value of the same kind: texts, truth values, whole numbers."""

    def __call__(self, got: Any, expected: Any) -> Mismatch | None:
        """Return why `got` is not `expected`, or None."""
        if describe(got) != describe(expected):
            message = f"The answer is {describe(got)}; {describe(expected)} was expected."
            return Mismatch("type", message)
        same = np.array_equal(got, expected) if isinstance(got, np.ndarray) else got == expected
        return None if same else Mismatch("values", "The answer is not the right one.")


@dataclass(frozen=True)
class YesOrNo:
    """One truth value, or an array or a list of them: True and False, not numbers."""

    def __call__(self, got: Any, expected: Any) -> Mismatch | None:
        """Return why `got` is not `expected`, or None."""
        truth = np.asarray(expected)
        missing = " Is the `return` missing?" if got is None else ""
        wrong_type = f"The answer is {describe(got)}; {describe(truth)} was expected.{missing}"
        try:
            array = np.asarray(got)
        except ValueError:  # rows of different length
            return Mismatch("type", wrong_type)
        if array.dtype.kind != "b":
            return Mismatch("type", wrong_type)
        if array.shape != truth.shape:
            return Mismatch("shape", wrong_type)
        wrong = np.count_nonzero(array != truth)
        if not wrong:
            return None
        share = f"{wrong} of {truth.size} answers are" if truth.ndim else "The answer is"
        return Mismatch("values", f"{share} not the right one{'s' * (truth.ndim > 0)}.")
