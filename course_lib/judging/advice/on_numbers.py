"""Plain words for exceptions of the numbers: shapes that do not fit, matrices without an answer."""

from __future__ import annotations

import re

#: A table with as many rows as a list has numbers, as in ``shapes (4,3) (4,)``.
ONE_FOR_EACH_ROW = re.compile(r"shapes \((\d+),\d+\) \(\1,\)")
DOMAIN = (
    "A logarithm needs a number above 0, a root none below 0. Print what stands in it. Is a power "
    "`**` written as a `*`?"
)
INNER = (
    "The inner sizes of the matrix product do not fit. Points are rows here, so a matrix A moves "
    "them as `points @ A.T`; homogeneous points have one number more. Print both shapes."
)
ENTRY = "Several numbers do not fit into one entry. Print both shapes: is an axis missing?"
COLUMN = "Print both shapes. A single 1 is no column: a row each needs one, `np.ones(len(points))`."

EMPTY = (
    "No entries are left of which one could be the smallest or largest. What should the answer be "
    "then?"
)
LETTERS = (
    "In `einsum` each letter is one axis of one size, and each axis has its letter; what comes "
    "behind `->` stood before it. Print the shapes."
)
NO_NUMBER = "This text is not a number alone. Print it: are there letters or blanks in it?"
NOT_FINITE = "A number is NaN or infinite here. Print what goes in: where does it come from?"


def meets(count: str) -> str:
    """Say what a list of so many numbers does to a table of another width."""
    return (
        f"A list of {count} numbers meets a table that has not {count} columns. Print both shapes. "
        "A shift is added to points in rows as `+ t`; to points in columns, as from "
        "`R @ points.T`, it is `+ t[:, None]`."
    )


ON_NUMBERS: tuple[tuple[str, str | re.Pattern[str], str], ...] = (
    ("ValueError", re.compile(r"with a sequence\.$"), ENTRY),
    ("ValueError", re.compile("along dimension 0.* at index 1 has size 1$"), COLUMN),
    (
        "ValueError",
        "size 3 is different from 2",
        "There are two columns where three belong. Is the 1 appended? Or was a single point put "
        "together like a table of points? `column_stack` stands its numbers one below the other. "
        "Print both shapes: points are rows here, as in `points @ A.T`.",
    ),
    ("ValueError", "core dimension", INNER),
    ("ValueError", "not aligned", INNER),
    (
        "ValueError",
        "solve: Input operand 1",
        "The right side has one number for each equation. Is it zero? Then the zero vector solves "
        "it, which is of no use, and the vector that is meant is in the SVD.",
    ),
    ("ValueError", "math domain error", DOMAIN),
    ("ValueError", "expected a positive input", DOMAIN),
    (
        "ValueError",
        "must have shape (3,), got (3, 1)",
        "A column of shape (3, 1) stands where three numbers belong: `a[:, 3]` gives a list of "
        "numbers, `a[:, 3:]` a table with one column.",
    ),
    (
        "ValueError",
        "not have enough dimensions",
        "The sign `@` multiplies arrays. One of the two is a single number here: `*`?",
    ),
    (
        "ValueError",
        "concatenation axis",
        "The arrays do not fit together in this direction. Side by side is `axis=-1`; without it "
        "they go one below the other. Print both shapes.",
    ),
    (
        "ValueError",
        "same number of dimensions",
        "A table and a list of numbers, or a single number, cannot be put together: both need rows "
        "and columns. Print both shapes. `np.column_stack` makes a column of a list.",
    ),
    (
        "LinAlgError",
        "Singular matrix",
        "This matrix has no inverse: its columns depend on each other. Is one of them zero, or a "
        "multiple of another? If a vector is asked for that the matrix takes to zero, it is in its "
        "SVD: `np.linalg.solve` could give the zero vector only, which is of no use.",
    ),
    (
        "LinAlgError",
        "not positive definite",
        "Cholesky finds no factor of this matrix. Print it: is it symmetric, and is its diagonal "
        "positive? If so, check the numbers that it was made of.",
    ),
    (
        "LinAlgError",
        "1-dimensional array given",
        "A row of numbers is no table here. For one unknown it is a column, `a[:, None]`; for "
        "several, `np.column_stack([a, b])` puts their columns side by side.",
    ),
    (
        "LinAlgError",
        "Incompatible dimensions",
        "Table and right side do not fit. Print both shapes: the table has one row for each "
        "equation and one column for each unknown, the right side one number for each equation.",
    ),
    (
        "ValueError",
        "cannot reshape",
        "The new shape has not as many entries as the array. Which array is it? Print its shape.",
    ),
    ("LinAlgError", "infs or NaNs", NOT_FINITE),
    (
        "LinAlgError",
        "must be square",
        "Only a square matrix has a determinant or an inverse. Print its shape. Is a square part "
        "of it meant, or are there more equations than unknowns? Then it takes least squares.",
    ),
    (
        "ValueError",
        "R must have shape (3, 3), got (3,)",
        "Three numbers are no rotation. A shift alone has to be named: `rigid_matrix(t=…)`.",
    ),
    (
        "ValueError",
        "must be tangents",
        "Have these ever been pixels? If not, a loop has run away: print its first guesses. Do "
        "they move towards what is missing?",
    ),
    (
        "ValueError",
        "points are rows",
        "One point is one row: print the shape. Two tables become rows of points by "
        "`np.stack([x.ravel(), y.ravel()], axis=1)`, columns become rows by `.T`.",
    ),
    (
        "ValueError",
        "all input arrays must have the same shape",
        "Arrays that are stacked have one shape. Print both. For all pixels of a picture "
        "`np.meshgrid` makes two tables of one shape.",
    ),
    ("ValueError", ") (3,)", meets("three")),
    ("ValueError", ") (2,)", meets("two")),
    (
        "ValueError",
        ONE_FOR_EACH_ROW,
        "One number for each row meets a table, whose columns it does not fit. Make it a column: "
        "`a[:, 2:]` and not `a[:, 2]`, or `a[:, None]`, or `np.linalg.norm(…, keepdims=True)`.",
    ),
    ("ValueError", "remapped shapes", LETTERS),
    ("ValueError", "einstein sum", LETTERS),
    (
        "ValueError",
        "broadcast",
        "The shapes of the two arrays do not fit. Print both shapes. Matrices are multiplied "
        "with `@`, not with `*`. A column taken as `a[:, 2]` is one long row; `a[:, 2:]` and "
        "`a[:, 2, None]` stay columns.",
    ),
    (
        "ValueError",
        "inhomogeneous",
        "The entries of this array differ in length. For points in rows, `p[..., 0]` is the first "
        "number of each.",
    ),
    (
        "ValueError",
        "truth value",
        "An `if` needs one yes or no, and this is an array: print its shape. Should it be one "
        "number? Then an array before it has an axis too many. Comparisons of arrays are joined by "
        "`&`, each in brackets: `(a > 0) & (b > 0)`. To choose one by one there is `np.where`.",
    ),
    (
        "ValueError",
        "unpack",
        "The number of names on the left is not the number of values. A table comes apart into "
        "its rows; `p[..., 0]` is the first number of each. With `x, *_ =` the first of several "
        "values gets a name.",
    ),
    ("ValueError", "zero-size array to reduction", EMPTY),
    ("ValueError", "empty sequence", EMPTY),
    ("ValueError", "iterable argument is empty", EMPTY),  # from Python 3.12 on
    ("ValueError", "could not convert string", NO_NUMBER),
    ("ValueError", "invalid literal", NO_NUMBER),
    ("ValueError", "NaN to integer", NOT_FINITE),
    ("OverflowError", "infinity to integer", NOT_FINITE),
    ("LinAlgError", "did not converge", NOT_FINITE),
    (
        "ValueError",
        "negative integer powers",
        "NumPy gives whole numbers no negative powers: write `1 / a`, or make them decimals by "
        "`np.asarray(a, float)`.",
    ),
    (
        "UFuncTypeError",
        "output from",
        "An array of whole numbers cannot hold decimals, so `/=` and `+=` fail. Make a new array: "
        "`a = a / 2`.",
    ),
    (
        "TypeError",
        "numpy boolean",
        "True and False have no difference: `~a` turns them round, and `a.astype(int)` makes "
        "numbers of them.",
    ),
    (
        "ValueError",
        "Input must be 1- or 2-d",
        "`np.diag` takes one matrix, and this is a list of them. Take them one by one, or multiply "
        "with `np.eye`, which reaches all of them.",
    ),
)
