"""Plain words for exceptions of the code itself: types, names, indices, calls."""

from __future__ import annotations

import re

POWER = "In Python `^` is no power: write `f**2`."
BESIDE = (
    "In Python `|` puts nothing side by side: `np.column_stack([a, b])` does. Between conditions "
    "each needs its bracket: `(a < 0) | (b < 0)`."
)
ROWS = "The rows of a matrix come as one list, with brackets of its own: `np.array([[…], […]])`."
NONE = "Something here is None. Has a search found nothing, or does a function lack its `return`?"
HYPOT = "`np.hypot` takes the two sides one by one: `np.hypot(a, b)`, or `np.hypot(*sides)`."
LIST = "A list or a tuple cannot be computed with. Make it an array: `np.array(…)`."
TEXT = "A text cannot be computed with: `float(…)` makes a number of one like '12.5'."
INDEX = "What counts rows is a whole number: `int(…)` makes one, and `//` divides without a rest."
WHOLE = (
    "A whole number belongs here, such as a count or an axis: `int(…)` makes one. The smaller of "
    "two numbers is `np.minimum(a, b)`."
)
ONE_BY_ONE = "This is made one by one, and has neither length nor places. Make a list: `list(…)`."
PARTS = "One number has no parts that `[…]` could pick."
CALL = "A function stands here and not its result: round brackets call it, as in `np.sqrt(2)`."
ONE = "This works for one number only; NumPy has it for arrays too."
SEVERAL = "A function gave several values, and they have one name together. Name each: `a, b = …`."
SHAPE = "The sizes of an array come as one, with brackets of their own: `np.zeros((3, 4, 2))`."

ON_CODE: tuple[tuple[str, str | re.Pattern[str], str], ...] = (
    ("TypeError", "for ^", POWER),
    ("TypeError", "'bitwise_xor'", POWER),
    ("TypeError", "for |", BESIDE),
    ("TypeError", "'bitwise_or'", BESIDE),
    ("TypeError", "NoneType", NONE),
    ("AttributeError", "NoneType", NONE),
    (
        "TypeError",
        "'module'",
        "A module does nothing itself. Which of its functions is meant, as in `np.linalg.norm(a)`?",
    ),
    (
        "TypeError",
        "object is not callable",
        "A number or an array stands right before a bracket, so Python takes it for a function. "
        "Is a `*` missing, or are square brackets meant?",
    ),
    (
        "TypeError",
        re.compile("(operand|between).*'(function|.*_method|.*Dispatcher|.*ufunc)'"),
        CALL,
    ),
    ("TypeError", re.compile("(function|_method|Dispatcher|ufunc)' object is not subs"), CALL),
    ("TypeError", "Field elements", ROWS),
    ("TypeError", "array() takes", ROWS),
    ("TypeError", "'tuple'", LIST),
    ("TypeError", "'list'", LIST),
    ("TypeError", "multiply sequence", LIST),
    ("AttributeError", "'list'", LIST),
    ("AttributeError", "'tuple'", SEVERAL),
    (
        "TypeError",
        "indices must be integers or slices, not tuple",
        "A list has no columns: `[0, 1]` picks from an array only. Make it one: `np.array(…)`.",
    ),
    ("TypeError", "indices must be integers", INDEX),
    ("TypeError", "'str'", TEXT),
    ("TypeError", "concatenate str", TEXT),
    (
        "TypeError",
        "unpack non-iterable",
        "One number cannot be taken apart. A loop over a single point of shape (3,) gives its "
        "numbers, one by one.",
    ),
    ("TypeError", "hypot() takes", HYPOT),
    (
        "TypeError",
        "arctan2() takes",
        "`np.arctan2` takes the two sides one by one, the opposite one first: `np.arctan2(a, b)`.",
    ),
    ("TypeError", "only 0-dim", ONE),
    ("TypeError", "only length-1", ONE),
    ("TypeError", "as a data type", SHAPE),
    (
        "TypeError",
        "object is not iterable",
        "A loop cannot go through a single number. Over a count it goes with `range(n)`; and most "
        "formulas of NumPy take one number or an array, without any loop.",
    ),
    ("TypeError", "cannot be interpreted as an integer", WHOLE),
    ("TypeError", "sequence of integers", WHOLE),
    ("KeyError", "", "The dictionary has no such key. Print those that it has: `print(list(…))`."),
    (
        "TypeError",
        re.compile("'(zip|map|filter|generator|set|dict_.*)' (object|has no len)"),
        ONE_BY_ONE,
    ),
    ("TypeError", "not subscriptable", PARTS),
    ("IndexError", "invalid index to scalar", PARTS),
    ("IndexError", "valid indices", INDEX),
    ("IndexError", "must be of integer", INDEX),
    ("TypeError", "has no len()", "One number has no length. Print what stands in the brackets."),
    (
        "AttributeError",
        "module '",
        "The module has nothing of this name. Is it misspelt, or is it in a part of the module, as "
        "`norm` in `np.linalg.norm`?",
    ),
    (
        "AttributeError",
        "'numpy.ndarray'",
        "An array has nothing of this name behind its dot. Is it misspelt, or a function that "
        "takes the array, as `np.cross(a, b)`?",
    ),
    (
        "AttributeError",
        re.compile("'(int|float)'"),
        "A plain number has neither `.T` nor `.shape`. With `np.asarray(…)` it has.",
    ),
    (
        "TypeError",
        "stack() takes",
        "Arrays to put together come as one list, with brackets of its own: "
        "`np.column_stack([a, b])`.",
    ),
    (
        "TypeError",
        "concatenate() ",
        "Arrays to put together come as one list, with brackets of its own: "
        "`np.concatenate([a, b], axis=-1)`.",
    ),
    (
        "TypeError",
        "only integer scalar arrays",
        "An array stands where a whole number belongs. Arrays to put together need brackets of "
        "their own: `np.concatenate([a, b], axis=-1)`.",
    ),
    (
        "TypeError",
        "unexpected keyword argument",
        "The function has no argument of this name. Is it misspelt? Many of NumPy's take `axis=`.",
    ),
    ("TypeError", "positional argument", "Is the number of arguments the one in the exercise?"),
    (
        "NameError",
        "",
        "Python does not know this name. Is it misspelt, or never assigned, or does its module "
        "lack in front, as `np` in `np.sqrt`?",
    ),
    ("UnboundLocalError", "", "This name is used before it is assigned in the function."),
    (
        "IndexError",
        "too many indices",
        "The array has fewer axes than that. With `…[..., 0]` a single point works like rows.",
    ),
    (
        "AxisError",
        "out of bounds",
        "There is no such axis: print the shape. A mask of pixels, as in `a[a < 5]`, leaves one "
        "long row; to keep whole pictures, use one True or False for each of them.",
    ),
    (
        "IndexError",
        "boolean index did not match",
        "This list of True and False has not one entry for each row. Which rows has it asked: all, "
        "or only some of them, as those of a sample?",
    ),
    ("IndexError", "", "There are fewer entries than the index needs; the first has index 0."),
    ("ZeroDivisionError", "", "The divisor is zero here. What should the answer be then?"),
    ("RecursionError", "", "The function calls itself without end."),
)
