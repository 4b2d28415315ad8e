# SPDX-License-Identifier: GPL-3.0-or-later
"""Values of arbitrary length reach messages only through `in_short`."""

import ast
from pathlib import Path

PACKAGE = Path(__file__).parents[2] / "python" / "samcontact"
SHORT_TYPES = {"float", "int", "bool"}
"""Annotations of arguments whose values are short."""


def raw_values(source):
    """Return (line, argument) of errors that show an argument by its full repr."""
    found = []

    def visit(node, arguments):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            given = [*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs]
            arguments = {a.arg: ast.unparse(a.annotation) for a in given if a.annotation}
        if isinstance(node, ast.Raise):
            for part in ast.walk(node):
                if isinstance(part, ast.FormattedValue) and part.conversion == ord("r"):
                    name = ast.unparse(part.value)
                    if arguments.get(name, "int") not in SHORT_TYPES:
                        found.append((node.lineno, name))
            return
        for inner in ast.iter_child_nodes(node):
            visit(inner, arguments)

    visit(ast.parse(source), {})
    return found


def test_values_are_shortened():
    # arguments checked before: a law, a keyword, a grid, a coefficient of friction
    checked = {"friction", "periodic", "law", "grid", "kind"}
    raw = {
        f"{path.relative_to(PACKAGE)}:{line}: {name}"
        for path in PACKAGE.rglob("*.py")
        for line, name in raw_values(path.read_text(encoding="utf-8"))
        if name not in checked
    }
    assert sorted(raw) == []


def test_an_unshortened_value_is_found():
    source = 'def f(x: Any, n: int):\n    raise ValueError(f"x must be 1, got {x!r} and {n!r}")\n'
    assert raw_values(source) == [(2, "x")]
