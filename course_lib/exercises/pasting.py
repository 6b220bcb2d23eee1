"""Turn a function of the library into text that stands on its own in a notebook cell."""

from __future__ import annotations

import ast
import builtins
import inspect
import re
import sys
import textwrap
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import ModuleType
from typing import Any

import numpy as np

BEGIN, END = "### BEGIN SOLUTION", "### END SOLUTION"
#: Sections of a docstring that a student does not need in order to write the function.
LEFT_OUT = ("Raises", "References")
INDENT = "    "
#: Where functions are that no notebook can import while it is graded.
EXERCISES = "course_lib.exercises"


@dataclass(frozen=True)
class Pasted:
    """A function in pieces: signature, docstring, and a body with the imports it needs."""

    signature: str
    docstring: str
    body: str

    def as_solution(self) -> str:
        """Return the function with its body marked for nbgrader to take out."""
        begin, end = INDENT + BEGIN, INDENT + END
        return "\n".join([self.signature, *self._docstring(), begin, self.body, end])

    def as_function(self) -> str:
        """Return the function as a student would write it into the cell, without marks."""
        return "\n".join([self.signature, *self._docstring(), self.body])

    def without_docstring(self) -> Pasted:
        """Return the same function without its docstring."""
        return Pasted(self.signature, "", self.body)

    def _docstring(self) -> list[str]:
        return [self.docstring] if self.docstring else []


def paste(function: Callable[..., Any], name: str = "", alone: bool = False) -> Pasted:
    """Take a function's source apart, so that it runs in a notebook.

    Parameters
    ----------
    function : callable
        A function defined in a module with ``def``; plain, without a closure.
    name : str, optional
        What it is called in the notebook; its own name unless told otherwise.
    alone : bool
        Whether its module is not to be had in the notebook: the functions of that module, or of
        other exercises, that it calls are then written into its body, as a student would, and so
        are constants.

    Returns
    -------
    Pasted
        Without annotations; with an import of each global name it uses. NumPy is expected to be
        there as ``np``.
    """
    source, definition = _parsed(function)
    documented = ast.get_docstring(definition, clean=False) is not None
    lines = source.splitlines()
    begins = definition.body[0].end_lineno if documented else _header_end(definition, lines)
    statements = "\n".join(lines[begins : definition.end_lineno])
    body = textwrap.indent(textwrap.dedent(statements).strip("\n"), INDENT)
    helpers = _helpers(function) if alone else {}
    used = {key: value for f in (function, *helpers.values()) for key, value in _used(f).items()}
    constants = _constants(used) if alone else {}
    used = {key: used[key] for key in used if key not in (helpers | constants)}
    lines = [*_imports(used, function), *constants.values()]
    sources = [_without_annotations(helper) for helper in helpers.values()]
    before = [textwrap.indent(text, INDENT) for text in ("\n".join(lines), *sources) if text]
    return Pasted(
        _signature(definition, name or function.__name__),
        _docstring(ast.get_docstring(definition) or ""),
        "\n\n".join([*before, body]),
    )


def _parsed(function: Callable[..., Any]) -> tuple[str, ast.FunctionDef]:
    """Return a function's source and its syntax tree."""
    source = textwrap.dedent(inspect.getsource(function))
    definition = ast.parse(source).body[0]
    assert isinstance(definition, ast.FunctionDef)
    return source, definition


def _without_annotations(function: Callable[..., Any]) -> str:
    """Return a function's source as a student would write it, without what only saves time."""
    source, definition = _parsed(function)
    lines = source.rstrip().splitlines()
    rest = lines[_header_end(definition, lines) :]
    return "\n".join([_signature(definition, definition.name), *rest])


def _used(function: Callable[..., Any]) -> dict[str, Any]:
    """Return the global names that a function uses, and what they stand for."""
    definition = _parsed(function)[1]
    given = [default for default in _defaults(definition) if default is not None]
    nodes = [node for part in (*given, *definition.body) for node in ast.walk(part)]
    plain = inspect.unwrap(function)
    own = {*plain.__code__.co_varnames, *plain.__code__.co_cellvars}  # they hide global names
    names = {node.id for node in nodes if isinstance(node, ast.Name)} - own
    scope = plain.__globals__
    return {name: scope[name] for name in names if name in scope and not hasattr(builtins, name)}


def _defaults(definition: ast.FunctionDef) -> list[ast.expr | None]:
    return [*definition.args.defaults, *definition.args.kw_defaults]


def _helpers(function: Callable[..., Any]) -> dict[str, Callable[..., Any]]:
    """Return the functions of its own module or of exercises that it calls, directly or not.

    Each comes after those that it calls: one of them may be the default of an argument.
    """
    found: dict[str, Callable[..., Any]] = {}
    seen = {function}

    def visit(one: Callable[..., Any]) -> None:
        for name, value in sorted(_used(one).items()):
            beside = inspect.isfunction(value) and _is_beside(value, function)
            if beside and value not in seen:
                seen.add(value)
                visit(value)
                found[name] = value

    visit(function)
    return found


def _is_beside(helper: Callable[..., Any], function: Callable[..., Any]) -> bool:
    """Return whether a function is to be had only where another one is."""
    return helper.__module__ == function.__module__ or helper.__module__.startswith(EXERCISES)


def _constants(used: Mapping[str, Any]) -> dict[str, str]:
    """Return the assignments of values that cannot be imported from a library."""
    plain = (bool, int, float, str, tuple, list, dict, np.ndarray)
    lines = {key: literal(value) for key, value in used.items() if isinstance(value, plain)}
    patterns = {key: value for key, value in used.items() if isinstance(value, re.Pattern)}
    lines |= {
        key: f'__import__("re").compile({value.pattern!r}, {int(value.flags)})'
        for key, value in patterns.items()
    }
    return {key: f"{key} = {line}" for key, line in lines.items()}


def _imports(used: Mapping[str, Any], function: Callable[..., Any]) -> list[str]:
    """Return the import lines for global names."""
    lines, by_module = [], dict[str, list[str]]()
    for name, value in sorted(used.items()):
        if isinstance(value, ModuleType):
            lines += [] if value is np else [_import_module(value.__name__, name)]
        else:
            home, there = _home(name, value, function)
            by_module.setdefault(home, []).append(there)
    return lines + [f"from {module} import {', '.join(by_module[module])}" for module in by_module]


def literal(value: Any) -> str:
    """Write given data as an expression: numbers, texts, tuples and arrays."""
    if isinstance(value, np.ndarray):
        return f"np.array({value.tolist()!r})"
    if isinstance(value, np.generic):
        return repr(value.item())
    if isinstance(value, tuple):
        return "(" + ", ".join(map(literal, value)) + ("," if len(value) == 1 else "") + ")"
    return repr(value)


def call(name: str, inputs: Mapping[str, Any]) -> str:
    """Write the call of a function with given data."""
    return f"{name}({', '.join(f'{key}={literal(value)}' for key, value in inputs.items())})"


def _home(name: str, value: Any, function: Callable[..., Any]) -> tuple[str, str]:
    """Return the module to import a name from, where it is defined or used; and as what."""
    defined, real = getattr(value, "__module__", None), getattr(value, "__name__", None)
    if defined and real == name:
        return defined, name
    if defined and hasattr(sys.modules.get(defined), str(real)):
        return defined, f"{real} as {name}"
    return function.__module__, name


def _import_module(module: str, name: str) -> str:
    package, _, leaf = module.rpartition(".")
    if leaf != name:
        return f"import {module} as {name}"
    return f"from {package} import {name}" if package else f"import {name}"


def _header_end(definition: ast.FunctionDef, lines: list[str]) -> int:
    """Return how many lines the header has; comments may follow before the first statement."""
    parts = [definition.returns, *ast.walk(definition.args)]
    last = max([definition.lineno, *(getattr(part, "end_lineno", 0) for part in parts)])
    rest = range(last, definition.body[0].lineno)
    return next((n for n in rest if lines[n - 1].split("#")[0].rstrip().endswith(":")), last)


def _signature(definition: ast.FunctionDef, name: str) -> str:
    arguments = definition.args
    everyone = [*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs]
    for argument in [*everyone, arguments.vararg, arguments.kwarg]:
        if argument is not None:
            argument.annotation = None
    return f"def {name}({ast.unparse(arguments)}):"


def _docstring(text: str) -> str:
    if not text:
        return ""
    quotes = 'r"""' if "\\" in text else '"""'
    lines = (quotes + _without_sections(text).rstrip()).splitlines()
    closing = ['"""'] if len(lines) > 1 else []
    lines[-1] += "" if closing else '"""'
    return "\n".join((INDENT + line).rstrip() for line in lines + closing)


def _without_sections(text: str) -> str:
    """Leave out whole sections of a numpydoc docstring."""
    lines, kept, keeping = text.splitlines(), [], True
    for line, following in zip(lines, [*lines[1:], ""], strict=True):
        if line.strip() and following.strip() and set(following.strip()) == {"-"}:
            keeping = line.strip() not in LEFT_OUT
        if keeping:
            kept.append(line)
    return "\n".join(kept)
