# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of the commands contain every number unbroken at any width."""

import io
import math
from dataclasses import fields
from types import SimpleNamespace

import numpy as np
import pytest
import xarray as xr
from hypothesis import given, settings
from hypothesis import strategies as st
from rich.console import Console

from samcontact import hertz
from samcontact.asperities.series import BY_INCREMENT, BY_PASS
from samcontact.commands import solve_contact, solve_study, sweep_summary, tables
from samcontact.commands.tables import MIN_WIDTH, UNLIMITED_WIDTH, Sheet, new_console, numbers
from samcontact.wear import Cycle, FrettingCycle

SIZES = (1e-12, 1e-6, 1.0, 1e6, 1e12)
CASE = SimpleNamespace(study="", output=SimpleNamespace(body=2))


def values(count, generator):
    """Draw values of either sign, from 1e-12 to 1e12 as in other systems of units."""
    return generator.choice(SIZES, count) * generator.normal(size=count)


def contact(generator, count=7):
    of_a_body = ("max_von_mises", "max_equivalent_plastic_strain", "max_temperature", "travel")
    names = [name for name in tables.CONTACT_COLUMNS if name not in of_a_body]
    names += [f"{name}_body2" for name in of_a_body] + ["iterations", "contact_area"]
    return xr.Dataset(
        {name: ("increment", values(count, generator)) for name in names},
        {"increment": np.arange(1, count + 1)},
        {"body2_nu": 0.3},
    )


def collision(generator, count=4):
    data = {name: ("pass", values(count, generator)) for name in BY_PASS}
    for name in BY_INCREMENT:
        data[name] = (("pass", "increment"), values(2 * count, generator).reshape(count, 2))
    data["residual_displacement"] = (
        ("pass", "body"),
        values(2 * count, generator).reshape(count, 2),
    )
    return xr.Dataset(data, {"pass": np.arange(1, count + 1), "body": [1, 2]})


def wear(generator, count=5, record=Cycle):
    data = {}
    for name in (item.name for item in fields(record) if item.name != "number"):
        shape = (count, 2) if name in record.PER_BODY else (count,)
        given = values(math.prod(shape), generator).reshape(shape)
        data[name] = ("cycle", "body")[: len(shape)], given
    return xr.Dataset(data, {"cycle": np.arange(1, count + 1), "body": [1, 2]})


def sweep(generator):
    names = ["contact.friction", "surface.roughness.amplitude"]
    shape = {name: values(2, generator) for name in names}
    one = contact(generator).drop_vars(["iterations", "contact_area"])
    whole = one.expand_dims({name: 2 for name in names}).copy().assign_coords(shape)
    whole["status"] = (tuple(names), [["done", "done"], ["done", "cancelled"]])
    return sweep_summary.summary_of(whole, names, CASE).sheet()


def all_tables(seed):
    generator = np.random.default_rng(seed)
    reference = hertz.point(7.5e-3, 1e11, load=float(abs(values(1, generator)[0])))
    return [
        solve_contact._summary(contact(generator), 2),
        solve_contact._comparison(contact(generator), 3, reference, 2),
        solve_study._passes_sheet(collision(generator)),
        solve_study._cycles_sheet(wear(generator)),
        solve_study._cycles_sheet(wear(generator, record=FrettingCycle)),
        sweep(generator),
    ]


def printed(sheet, width):
    """Return the lines for a terminal of this width, or for a pipe (None)."""
    console = new_console()
    console.file = io.StringIO()
    if width is not None:
        console = Console(file=io.StringIO(), width=width)
    console.print(sheet)
    return [line.rstrip() for line in console.file.getvalue().splitlines()]


def cells(lines, name):
    """Return all further cells of the rows whose first cell has this text, over all parts."""
    found = []
    for line in lines:
        row = [cell.strip() for cell in line.split("│")[1:-1]]
        if row and row[0] == name:
            found += row[1:]
    return found


@settings(max_examples=25, deadline=None)
@given(seed=st.integers(0, 2**32 - 1), width=st.integers(40, 200) | st.none())
def test_every_number_of_every_table_is_whole(seed, width):
    for sheet in all_tables(seed):
        lines = printed(sheet, width)
        assert max(map(len, lines)) <= (width or UNLIMITED_WIDTH)
        assert "…" not in "".join(lines)
        for place, name in enumerate(sheet.columns[0][1]):
            whole = [column[place] for _, column in sheet.columns[1:]]
            if width is None:
                assert cells(lines, name) == whole
            elif " " not in name:
                # only text may wrap, such as the name of a row
                assert cells(lines, name) == whole


def test_a_wide_table_continues_below():
    sheet = Sheet("Numbers")
    sheet.add("", ["1"])
    for column in range(12):
        sheet.add(f"column {column}", ["123456.789"])
    lines = printed(sheet, 60)
    titles = [line.strip() for line in lines if "Numbers" in line]
    assert titles == ["Numbers", *["Numbers, continued"] * 2]
    assert len({len(line.rstrip()) for line in lines if "┏" in line}) == 1  # parts of like width
    assert len(printed(sheet, None)) < len(lines)  # a file has room


def test_the_console_takes_the_width_of_a_terminal_only(monkeypatch):
    monkeypatch.setenv("COLUMNS", "66")
    assert new_console().width == UNLIMITED_WIDTH
    monkeypatch.setenv("FORCE_COLOR", "1")  # rich takes it for a terminal
    assert new_console().width == 66
    monkeypatch.setenv("COLUMNS", "20")
    assert new_console().width == MIN_WIDTH


@pytest.mark.parametrize(
    ("column", "texts"),
    [
        ([118812.3, -52147.2], ["118812", "-52147"]),
        ([1500.0, 375.0, 0.0], ["1500", "375", "0"]),
        ([23.3157, 4.83014, -1e-12, -0.0], ["23.316", "4.830", "-1e-12", "0.000"]),
        ([1e3, 1e-3], ["1000", "0.001"]),  # each with its own digits
        ([1.23456789e12, 5.0], ["1.2346e+12", "5"]),
        ([3.7e-9, 1.25e-9], ["3.7e-09", "1.25e-09"]),
        ([np.nan, 2.5], ["-", "2.5"]),
        ([np.nan, np.inf], ["-", "-"]),
        ([0.0, -0.0], ["0", "0"]),
        ([], []),
    ],
)
def test_digits_of_a_column(column, texts):
    assert numbers(column) == texts


@given(st.lists(st.floats(-1e300, 1e300), min_size=1))
def test_a_column_distinguishes_its_values(column):
    for text, value in zip(numbers(column), column, strict=True):
        assert float(text) == pytest.approx(value, rel=0.051)
        assert len(text) <= 24
        assert not text.startswith("-0") or float(text) != 0
