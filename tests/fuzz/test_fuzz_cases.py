# SPDX-License-Identifier: GPL-3.0-or-later
"""Arbitrary texts as case files are read, or refused with a CaseError that names the file."""

import re
from functools import partial
from pathlib import Path

import pytest
from fuzzing import try_all, unless_refused, with_trials
from hypothesis import strategies as st

from samcontact import Grid
from samcontact.cases import Case, CaseError, load_case, parse_case
from samcontact.cases.kinds import KINDS

CASES = {
    path.stem: path.read_text(encoding="utf-8")
    for path in sorted((Path(__file__).parents[2] / "cases").glob("*.toml"))
}
ASSIGNMENT = re.compile(r"^(\s*[\w.]+\s*=\s*)(.+)$", re.MULTILINE)
INLINE = re.compile(r"(\w+ = )([^,{}\n]+)(?=[,}])")
numbers = st.one_of(
    st.integers(-(2**70), 2**70).map(str),
    st.floats().map(repr),
    st.sampled_from(["0", "-1", "1", "-0.0", "1e308", "5e-324", "1e-300", "nan", "-inf", "inf"]),
)
units = st.sampled_from(["m", "um", "GPa", "kN", "s", "K", "parsec", "m**1000", "2", "", "mm/0"])
values = st.one_of(
    numbers,
    st.tuples(numbers, units).map(lambda pair: f'"{pair[0]} {pair[1]}"'),
    st.lists(numbers, max_size=4).map(lambda items: f"[{', '.join(items)}]"),
    st.sampled_from(
        ["true", '""', "{}", "[]", "[[1, 2], [3]]", "{a = 1}", "1979-05-27", "07:32:00"]
    ),
    st.sampled_from(['"elastic"', '"rigid"', '"swift"', '"file"', '"/dev/null"', '"../cases"']),
    st.text(alphabet="abc {}[]()*/%\\é.\x00\n", max_size=8).map(
        lambda text: "'" + text.replace("'", "").replace("\n", "").replace("\x00", "") + "'"
    ),
)
scraps = st.one_of(
    st.text(max_size=6),
    st.sampled_from(
        ["[grid]", "[[path]]", "[asperities]", "[wear]", " = ", "\n", '"""', "{", "inf"]
    ),
    values,
)


def read(text):
    """Return the case, or None if it is refused correctly."""
    case = unless_refused(lambda: parse_case(text, "case.toml"), CaseError, "case.toml: ")
    assert case is None or isinstance(case, (Case, *KINDS.values()))
    return case


@st.composite
def mangled(draw):
    """Draw an example case with a few changes anywhere in its text."""
    text = draw(st.sampled_from(sorted(CASES.values())))
    for _ in range(draw(st.integers(1, 4))):
        begin = draw(st.integers(0, len(text)))
        end = min(len(text), begin + draw(st.sampled_from([0, 0, 1, 5, 40])))
        text = text[:begin] + draw(scraps) + text[end:]
    return text


def times_power(kind, number, power):
    return repr(kind(number * 10**power))


def scaled(value):
    """Draw the number times a power of ten; an integer remains an integer."""
    for kind in (int, float):
        try:
            number = kind(value)
        except ValueError:
            continue
        powers = st.integers(0 if kind is int else -15, 15)
        return powers.map(partial(times_power, kind, number))
    return values


@st.composite
def wild(draw):
    """Draw an example case with other values in some of its fields."""
    text = draw(st.sampled_from(sorted(CASES.values())))
    for _ in range(draw(st.integers(1, 3))):
        places = [*ASSIGNMENT.finditer(text), *INLINE.finditer(text)]
        place = draw(st.sampled_from(places))
        value = draw(st.one_of(values, scaled(place[2])))
        text = text[: place.start(2)] + value + text[place.end(2) :]
    return text


@with_trials("texts of case files")
def test_any_text(count):
    try_all(read, count, text=st.one_of(mangled(), mangled(), st.text(max_size=200)))


@with_trials("cases with extreme values")
def test_wild_values(count):
    def check(text):
        case = read(text)
        if isinstance(case, Case):
            assert len(case.steps()) >= 1

    try_all(check, count, text=wild())


@with_trials("construction of simulations from cases")
def test_wild_cases_are_built_or_refused(count):
    """Cases with small grids; large grids are covered by the memory tests."""

    def check(text):
        case = read(text)
        if not isinstance(case, Case):
            return
        cells = case.grid.nx * case.grid.ny * max(case.grid.nz, 1)
        if cells > 300_000:
            return
        made = unless_refused(case.build, CaseError, "case.toml: [")
        assert made is None or (isinstance(made[0].grid, Grid) and made[1] == case.steps())

    try_all(check, count, text=wild())


@pytest.mark.parametrize("content", [b"\xff\xfe\x00", b"\x00" * 100, b"title = '\xc3('"])
def test_an_empty_text(tmp_path, content):
    path = tmp_path / "case.toml"
    path.write_bytes(content)
    with pytest.raises(CaseError, match=r"case\.toml: "):
        load_case(path)


def test_a_folder(tmp_path):
    with pytest.raises(CaseError, match="cannot read the case file"):
        load_case(tmp_path)
