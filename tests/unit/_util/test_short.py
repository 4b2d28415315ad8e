# SPDX-License-Identifier: GPL-3.0-or-later
"""Values in messages are short, and lists of numbers contain numbers only."""

import datetime
import sys
import types
from decimal import Decimal

import numpy as np
import pytest

from samcontact import Grid, Heat, Material
from samcontact._util.checks import choice, real_array
from samcontact._util.short_text import MAX_CHARACTERS, in_short


class Broken:
    def __repr__(self):
        raise RuntimeError


class Long:
    def __repr__(self):
        return "x" * 1000


LONG_NAME = "name_of_a_field_that_is_as_long_as_this"
VALUES = [
    "x" * 10**6, "'" * 200, "\x1b[2J" * 40, b"\0" * 200, "line\nbreak", None, 1e305,
    10**100, 10**5000, -(10**400), [10**5000], [[1.0] * 9] * 9, dict.fromkeys(range(99)), {1, 2},
    np.zeros((3, 0)), np.full((9, 9), np.nan), np.array("x" * 500), np.zeros(3, [(LONG_NAME, "f")]),
    Broken(), Long(), [Broken()], datetime.date(1979, 5, 27),
]  # fmt: skip


@pytest.mark.parametrize("value", VALUES, ids=lambda value: type(value).__name__)
def test_any_value_is_short(value):
    text = in_short(value)
    assert 0 < len(text) <= MAX_CHARACTERS
    assert text.isprintable()


def test_short_values_are_shown_as_they_are():
    for value in ("210 GPa", [1, 2], {"load": 1.0}, 1e305, 2**70, (1.0, 2.0)):
        assert in_short(value) == repr(value)


@pytest.mark.parametrize(
    ("value", "named"),
    [
        ([True, 2.5], "Boolean values"),
        ([[1.0, 2.0], [3.0, np.True_]], "Boolean values"),
        ([1.0, None], "None"),
        ([datetime.date(1979, 5, 27)], "date"),
        ([[1.0], [1.0, 2.0]], r"\[\[1.0\], \[1.0, 2.0\]\]"),
        ([np.array([True]), np.array([1.0])], "Boolean values"),
        ({"a": 1.0}, "dict"),
    ],
)
def test_lists_hold_numbers_only(value, named):
    with pytest.raises(TypeError, match=f"height must be an array of numbers.*{named}"):
        real_array("height", value)


@pytest.mark.parametrize("value", [[1e305], [0.0, -2e300], [[10**400]], np.array([np.nan, 1e301])])
def test_numbers_beyond_the_range_of_products(value):
    with pytest.raises(ValueError, match=r"height must be .* of magnitude <= 1e\+300"):
        real_array("height", value)


def test_numbers_of_any_kind_are_taken():
    assert real_array("height", [1, 2.5, Decimal("0.5"), np.float32(1)]).tolist() == [
        1,
        2.5,
        0.5,
        1,
    ]
    assert np.isposinf(real_array("height", [np.inf, 1e300])[0])


def test_an_import_of_masked_arrays_by_another_thread_is_not_awaited(monkeypatch):
    monkeypatch.delattr(np, "ma")
    monkeypatch.setitem(sys.modules, "numpy.ma", types.ModuleType("numpy.ma"))  # not yet executed
    assert real_array("height", [1.0, 2.0]).tolist() == [1.0, 2.0]


def test_the_number_one_is_not_true():
    for wrong in (True, np.True_, 1 + 0j, "1", [1], np.array([1])):
        with pytest.raises(ValueError, match="body must be one of 1, 2, got"):
            choice("body", wrong, (1, 2))
    for right in (1, 1.0, np.int8(1), np.array(1)):
        assert choice("body", right, (1, 2)) == 1


@pytest.mark.parametrize(
    "call",
    [
        lambda: Heat([True, 0.1]),
        lambda: Grid(8, 8, True, 1e-5),
        lambda: Material.tabulated(2e11, 0.3, [0.0, 1e-3], [1e9, True]),
    ],
)
def test_truth_values_in_arguments(call):
    with pytest.raises(TypeError, match=r"(factor|dx|stress) must be"):
        call()
