# SPDX-License-Identifier: GPL-3.0-or-later
"""Values of a wrong type in every field of every section give a one-line message."""

import datetime
import math
import re
import sys
from collections import Counter
from pathlib import Path

import pytest

from samcontact.cases import ALL_KINDS, CaseError, kind_of, parse_case
from samcontact.cases.allowed import described, is_model, members, opened, tags

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

FOREIGN = re.compile(
    r"[Ii]nput should|constrained|validation|valid (dict|list|str|int|number)|instance of|pydantic"
    r"|<class|Errno|object has no|not iterable|broadcast|list\[|dict\[|Decimal|literal|Section\b"
)
"""Words of libraries that know nothing of contacts."""
MAX_CHARACTERS = 400
"""Characters of a line but for lists of what is allowed, which are as long as they are."""
WRONG = [
    math.nan, math.inf, -math.inf, 1e305, -1.0, 0, 10**400, -(10**400), True, "", "no", "0.3",
    "1e9999999999999999999 m", "1 parsec**9", "x" * 5000, "a\x1b[2J", [], [[]], {}, [{}],
    [math.nan], [True], [0.0] * 3, ["x" * 5000], {"x" * 1000: 1.0}, datetime.date(1979, 5, 27),
    datetime.time(7, 32),
]  # fmt: skip
BASE = {
    path.stem: tomllib.loads(path.read_text(encoding="utf-8"))
    for path in sorted((Path(__file__).parents[2] / "cases").glob("*.toml"))
}


MAX_CASES = 1
"""Cases in which a field is changed, for each type of its given value."""


def spoiled(model, content, replaced, attempts):
    """Yield copies of a section with one changed field, and its name and value.

    `tried` counts the cases of each field.
    """
    for name, field in model.model_fields.items():
        kind, _ = opened(field.annotation)
        inner = [opened(one)[0] for one in members(kind)]
        given = content.get(name)
        attempts[model, name, type(given)] += 1
        if attempts[model, name, type(given)] <= MAX_CASES:
            for wrong in WRONG:
                yield replaced({**content, name: wrong}), name, wrong
        if isinstance(given, dict) and all(map(is_model, inner)):
            yield from spoiled(
                chosen(inner, given),
                given,
                lambda new, n=name: replaced({**content, n: new}),
                attempts,
            )
        if isinstance(given, list) and given and isinstance(given[0], dict):
            models = [opened(one)[0] for one in members(opened(kind.__args__[0])[0])]
            yield from spoiled(
                chosen(models, given[0]),
                given[0],
                lambda new, n=name, old=given: replaced({**content, n: [new, *old[1:]]}),
                attempts,
            )


def chosen(models, given):
    """Return the variant of a section selected by its keyword."""
    words = {given.get(key) for key in ("law", "shape", "kind")}
    return next((model for model in models if words & set(tags(model))), models[0])


def test_every_field():
    refused, attempts = Counter(), Counter()
    for name, content in BASE.items():
        kind = kind_of(content)
        for case, field, wrong in spoiled(kind, content, lambda new: new, attempts):
            try:
                kind.model_validate(case)
            except CaseError as error:
                refused[name] += 1
                for line in str(error).split("\n"):
                    shown = re.sub(r"(one of|allowed here:) [^;]*", "", line)
                    assert not FOREIGN.search(line), (name, field, wrong, line)
                    assert len(shown) < MAX_CHARACTERS, (name, field, line)
                    assert re.match(r"[\w.\[\]' -]+(:| )", line), line
    assert refused.total() > 1500


def test_each_kind_of_value_is_described():
    """No field falls back to the name of a Python class."""
    found = set()
    waiting = list(ALL_KINDS)
    for model in waiting:
        for field in model.model_fields.values():
            marks = [*field.metadata, field]
            found.add(described(field.annotation, marks))
            waiting += [m for m in models_below(field.annotation) if m not in waiting]
    assert len(found) > 30
    assert [text for text in found if FOREIGN.search(text) or "typing" in text] == []


def models_below(annotation):
    if is_model(annotation):
        return [annotation]
    return [model for part in getattr(annotation, "__args__", ()) for model in models_below(part)]


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("nx = 16", f"nx = {'1' * 400}", ">= 1, got <int of about 400 digits>"),
        ("dx = 5e-6", 'dx = "1e9999999999999999999 m"', "must be within the range of floating"),
        ("dx = 5e-6", "dx = 1e305", "grid.dx: magnitude must be <= 1e+300, got 1e+305"),
        ("dx = 5e-6", 'dx = "1e302 km"', "grid.dx: magnitude must be <= 1e+300, got 1e+305"),
        ("dx = 5e-6", f"dx = 1{'0' * 305}", "grid.dx: magnitude must be <= 1e+300, got <int"),
        ("[[path]]", "[[path]]\nadvance = [0.0, -1e301]", "path[0].advance: magnitude must be <="),
        ("[surface]", "[roller]\nlength = 1e301\n[surface]", "roller.length: magnitude must be <="),
        ("[[path]]", "[output]\nbody = true\n[[path]]", "output.body: must be 1 or 2, got True"),
        ("[[path]]", "[output]\nfigures = 'no'\n[[path]]", "output.figures: must be true or false"),
        ('"Ball"', "1979-05-27", "title: must be text (not empty), got datetime.date"),
        ('"Ball"', '""', "title: must be text (not empty), got ''"),
        ("nx = 16", 'nx = "16"', "got '16': write it without quotes"),
        ("nx = 16", "nx = 16.0", "got 16.0: write it without a decimal point"),
    ],
)  # fmt: skip
def test_messages_of_wrong_kinds(old, new, message):
    text = SETUP.replace(old, new, 1)
    with pytest.raises(CaseError) as error:
        parse_case(text, "case.toml")
    assert message in str(error.value)
    assert "\n" not in str(error.value)


SETUP = """title = "Ball"
[grid]
nx = 16
ny = 16
dx = 5e-6
dy = 5e-6
[body1]
law = "rigid"
[body2]
law = "elastic"
E = 210e9
nu = 0.3
[surface]
shape = "paraboloid"
Rx = 1e-3
[[path]]
load = 0.2
increments = 1
"""
