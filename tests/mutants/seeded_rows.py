"""Which rows draw from the seed of a run: to all others, a seed makes no difference.

Read from the text of the checks: a check draws when it, or a function of the checks
that it names, uses the generator of its context or generated examples.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator

from conformance.runner.execution import CHECKS

# The generator of a context, and what gives it to a library.
_SOURCES = {"for_all"}


def seeded_rows() -> frozenset[str]:
    """The ids of the rows whose checks draw from the seed."""
    functions = {function.name: function for function in _functions()}
    drawing = {name for name, function in functions.items() if _draws(function)}
    while more := {
        name
        for name, function in functions.items()
        if name not in drawing and drawing & _names_in(function)
    }:
        drawing |= more
    return frozenset(id_ for name in drawing for id_ in _rows_of(functions[name]))


def _functions() -> Iterator[ast.FunctionDef]:
    for path in sorted(CHECKS.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.FunctionDef):
                yield node


def _draws(function: ast.FunctionDef) -> bool:
    is_drawn = any(
        isinstance(node, ast.Attribute)
        and node.attr == "random"
        and isinstance(node.value, ast.Name)
        and node.value.id == "context"
        for node in ast.walk(function)
    )
    return is_drawn or bool(_SOURCES & _names_in(function))


def _names_in(function: ast.FunctionDef) -> set[str]:
    return {node.id for node in ast.walk(function) if isinstance(node, ast.Name)}


def _rows_of(function: ast.FunctionDef) -> Iterator[str]:
    for decorator in function.decorator_list:
        match decorator:
            case ast.Call(ast.Name("requirement"), [ast.Constant(str(id_)), *_]):
                yield id_
