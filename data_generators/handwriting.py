"""Ways to write one and the same function: what tells students' right answers apart.

Two students who work alone choose other names, take other steps at once and write products the
other way round. A student who copies changes names, comments and line breaks only.
"""

from __future__ import annotations

import ast
import builtins
from collections.abc import Sequence

from numpy.random import Generator

#: Names for what a function makes on the way, as students choose them.
NAMES = (
    "a", "b", "tmp", "x", "y", "val", "res", "out", "first", "second", "part", "value", "ratio",
    "scaled", "top", "bottom", "left", "right", "step1", "step2", "helper", "z", "q", "num", "den",
    "thing", "rows", "cols", "total", "answer", "my_x", "my_y", "inside", "factor", "stuff",
)  # fmt: skip
REMARKS = ("check units!", "see lecture", "this took me a while", "ok", "from the formula")


def rewrite(source: str, rng: Generator) -> str:
    """Write a function as another student would: the same results, other steps.

    Parameters
    ----------
    source : str
        A function.
    rng : numpy.random.Generator
        Whose hand it is.

    Returns
    -------
    str
        The function with names of its own, intermediate steps, and factors exchanged.
    """
    tree = _without_idle_imports(_Unchecked().visit(ast.parse(source)))
    function = tree.body[0]
    if not isinstance(function, ast.FunctionDef):
        raise ValueError(f"rewrite needs a function, got {type(function).__name__}")
    documented = ast.get_docstring(function) is not None
    head = function.body[:documented]
    body = function.body[documented:]
    hand = _Hand(rng)
    function.body = head + [new for node in body for new in hand.write(node)]
    return rename(ast.unparse(ast.fix_missing_locations(tree)), rng)


def copy_off(source: str, rng: Generator) -> str:
    """Copy a function as someone does who hides it: other names, remarks, blank lines.

    Parameters
    ----------
    source : str
        A function.
    rng : numpy.random.Generator
        Chooses the names.

    Returns
    -------
    str
        The same steps.
    """
    lines = rename(source, rng).splitlines()
    at = int(rng.integers(1, len(lines))) if '"""' not in source else len(lines) - 1
    return "\n".join([*lines[:at], f"    # {rng.choice(REMARKS)}", "", *lines[at:]])


def rename(source: str, rng: Generator) -> str:
    """Give the variables that a function makes other names; its arguments keep theirs."""
    tree = ast.parse(source)
    names = [node for node in ast.walk(tree) if isinstance(node, ast.Name)]
    arguments = {node.arg for node in ast.walk(tree) if isinstance(node, ast.arg)}
    made = {name.id for name in names if isinstance(name.ctx, ast.Store)} - arguments
    taken = _names_in(tree)
    fresh = [name for name in rng.permutation(NAMES) if name not in taken]
    chosen = dict(zip(sorted(made), map(str, fresh), strict=False))
    for name in names:
        name.id = chosen.get(name.id, name.id)
    return ast.unparse(tree)


def _names_in(tree: ast.AST) -> set[str]:
    used = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
    return used | {n.arg for n in ast.walk(tree) if isinstance(n, ast.arg)} | {*dir(builtins)}


class _Unchecked(ast.NodeTransformer):
    """Leaves the library's checks of one argument out: no student writes them."""

    def visit_Call(self, node: ast.Call) -> ast.expr:
        """Put `np.asarray(x)` for `check_something(x, "x")`."""
        self.generic_visit(node)
        checks = isinstance(node.func, ast.Name) and node.func.id.startswith("check_")
        checked = [a for a in node.args if not isinstance(a, ast.Constant)]
        if not checks or len(checked) != 1:
            return node
        return ast.parse(f"np.asarray({ast.unparse(checked[0])}, dtype=float)", mode="eval").body


def _without_idle_imports(tree: ast.Module) -> ast.Module:
    """Drop the imports of what is not used any more."""
    used = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom):
            node.names = [name for name in node.names if (name.asname or name.name) in used]
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef):
            node.body = [n for n in node.body if not isinstance(n, ast.ImportFrom) or n.names]
    return tree


class _Hand:
    """Rewrites statements: takes parts of them in steps of their own, exchanges factors."""

    def __init__(self, rng: Generator) -> None:
        self._rng, self._count = rng, 0

    def write(self, node: ast.stmt) -> Sequence[ast.stmt]:
        """Return a statement as this hand writes it, with the steps before it."""
        steps: list[ast.stmt] = []
        if isinstance(node, ast.Assign | ast.Return) and node.value is not None:
            node.value = self._expression(node.value, steps)
            if isinstance(node, ast.Return) and self._often():
                node.value = self._step(node.value, steps)
        return [*steps, node]

    def _often(self) -> bool:
        return bool(self._rng.random() < 0.5)

    def _step(self, value: ast.expr, steps: list[ast.stmt]) -> ast.expr:
        name = f"step_{self._count}"
        self._count += 1
        steps.append(ast.Assign([ast.Name(name, ast.Store())], value))
        return ast.Name(name, ast.Load())

    def _expression(self, node: ast.expr, steps: list[ast.stmt]) -> ast.expr:
        """Rewrite an expression from the inside; what is evaluated only at times is left alone."""
        if isinstance(node, ast.BinOp):
            node.left = self._part(node.left, steps)
            node.right = self._part(node.right, steps)
            if isinstance(node.op, ast.Mult | ast.Add) and self._often():
                node.left, node.right = node.right, node.left
        elif isinstance(node, ast.Call):
            node.args = [self._part(argument, steps) for argument in node.args]
        return node

    def _part(self, node: ast.expr, steps: list[ast.stmt]) -> ast.expr:
        rewritten = self._expression(node, steps)
        worth = isinstance(rewritten, ast.BinOp | ast.Call | ast.Subscript)
        return self._step(rewritten, steps) if worth and self._often() else rewritten
