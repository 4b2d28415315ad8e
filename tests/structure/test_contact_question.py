# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether a cell is in contact is decided only by the contact law, in Python and in C++."""

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "python" / "samcontact"
MODULES = sorted(set(PACKAGE.rglob("*.py")) - {PACKAGE / "problem" / "contact_law.py"})
CORE = [
    file for folder in ("include/samcontact", "src") for room in ("contact", "simulation")
    for file in sorted((ROOT / "cpp" / folder / room).rglob("*.?pp"))
    if file.name != "contact_law.hpp"
]  # fmt: skip

COUNTS = {"count_nonzero", "flatnonzero", "nonzero"}
FIELDS = {"pressure", "repulsion", "pressed"}
IN_CPP = re.compile(
    r"\b(?:p|p_|pressure|repulsion)\b(?:\[[^;]*?\])?\s*(?:>|<=)\s*0(?:\.0)?(?![\w.])"
)


def field_of(node):
    """Return the field of an expression: itself, some of its cells, or its maximum."""
    while True:
        if isinstance(node, ast.Subscript):
            node = node.value
        elif isinstance(node, ast.Call) and getattr(node.func, "id", None) == "in_contact":
            return None
        elif isinstance(node, ast.Call) and node.args:
            node = node.args[0]
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            node = node.func.value
        else:
            return getattr(node, "attr", None) or getattr(node, "id", None)


def is_zero(node):
    return isinstance(node, ast.Constant) and node.value == 0


def questions_in(text):
    """Return lines that compare a pressure field with zero, or count its non-zero cells."""
    for node in ast.walk(ast.parse(text)):
        asked = None
        if isinstance(node, ast.Compare) and isinstance(node.ops[0], (ast.Gt, ast.LtE)):
            asked = node.left if is_zero(node.comparators[0]) else None
        elif isinstance(node, ast.Call) and getattr(node.func, "attr", None) in COUNTS:
            asked = node.args[0] if node.args else None
        if asked is not None and field_of(asked) in FIELDS:
            yield node.lineno


@pytest.mark.parametrize(
    "text",
    [
        "a = pressure > 0",
        "a = state.pressure[i] > 0.0",
        "a = np.max(pressure, axis=0) > 0",
        "a = state.repulsion.max() <= 0",
        "a = np.count_nonzero(state.pressure)",
    ],
)
def test_a_comparison_with_zero_pressure_is_found(text):
    assert list(questions_in(text)) == [1]


@pytest.mark.parametrize(
    "text", ["if (p[i] > 0) {", "return pressure[at] > 0 || x;", "p_[i] <= 0;"]
)
def test_a_comparison_with_zero_pressure_is_found_in_the_core(text):
    assert IN_CPP.search(text)


def test_python_uses_the_contact_law():
    found = [
        f"{file.relative_to(ROOT)}:{line}" for file in MODULES
        for line in questions_in(file.read_text())
    ]  # fmt: skip
    assert not found, f"use problem.contact_law.in_contact, or in_contact of a state: {found}"


def test_the_core_uses_the_contact_law():
    found = [
        f"{file.relative_to(ROOT)}:{number}" for file in CORE
        for number, line in enumerate(file.read_text().splitlines(), 1)
        if IN_CPP.search(line.partition("//")[0])
    ]  # fmt: skip
    assert not found, f"use in_contact of contact_law.hpp: {found}"
