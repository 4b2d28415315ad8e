# SPDX-License-Identifier: GPL-3.0-or-later
"""Limits on the length of files and functions."""

import ast
from pathlib import Path

ROOT = Path(__file__).parents[2]
FOLDERS = ("benchmarks", "cpp", "docs", "gallery", "python", "scripts", "tests")
FILES = sorted(
    file
    for folder in FOLDERS
    for file in (ROOT / folder).rglob("*")
    if file.suffix in (".py", ".hpp", ".cpp", ".sh", ".cmake")  # stubs are generated
)
# Lines; docstrings of functions do not count. clang-tidy has the same limit for C++.
FILE, FUNCTION = 400, 60


def length(function):
    """Return the number of lines from `def` to the end, without the docstring."""
    lines = function.end_lineno - function.lineno + 1
    if ast.get_docstring(function) is not None:
        message = function.body[0]
        lines -= message.end_lineno - message.lineno + 1
    return lines


def functions(text):
    kinds = (ast.FunctionDef, ast.AsyncFunctionDef)
    return [node for node in ast.walk(ast.parse(text)) if isinstance(node, kinds)]


def test_lengths_are_counted():
    text = 'def f(\n    given,\n):\n    """Says\n    much."""\n    return given\n'
    assert [length(function) for function in functions(text)] == [4]


def test_files_are_short():
    lines = {str(file.relative_to(ROOT)): len(file.read_text().splitlines()) for file in FILES}
    assert {"python/samcontact/problem/grid.py", "cpp/src/fft/rows.cpp", "scripts/setup.sh"} <= set(
        lines
    )
    assert {name: n for name, n in lines.items() if n > FILE} == {}


def test_functions_are_short():
    found = {
        f"{file.relative_to(ROOT)}: {function.name}": length(function)
        for file in FILES
        if file.suffix == ".py"
        for function in functions(file.read_text())
    }
    assert len(found) > 1000
    assert not {name: n for name, n in found.items() if n > FUNCTION}
