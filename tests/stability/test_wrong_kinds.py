# SPDX-License-Identifier: GPL-3.0-or-later
"""Values of a wrong type for any argument of any public call are refused by name."""

import datetime
import re
import warnings

import numpy as np
import pytest
from public_calls import CALLS, is_named, names_in

FOREIGN = re.compile(
    r"incompatible function arg|pybind11|constrained|Input should|broadcast|has no attribute"
    r"|not iterable|not subscriptable|has no len|not callable$|argument after|unsupported operand"
    r"|not supported between|inhomogeneous|could not convert|cannot be interpreted|invalid literal"
    r"|must be real number|unexpected keyword|missing \d+ required|list index|tuple index"
    r"|truth value of an array|cannot convert|unhashable|<class|Errno|object at 0x"
)
"""Words of Python, NumPy and the binding layer."""
MAX_CHARACTERS = 500
PLACES = {"path", "checkpoint", "output"}


class Broken:
    """Object whose conversion to text fails."""

    def __repr__(self):
        raise RuntimeError("no text")


WRONG = {
    "True": True,
    "np.True_": np.True_,
    "long text": "x" * 100_000,
    "digits": "12",
    "complex": 1j,
    "0-d complex": np.array(1j),
    "0-d text": np.array("x"),
    "date": datetime.date(1979, 5, 27),
    "bytes": b"12",
    "broken": Broken(),
    "float": 0.37,
    "huge": 10**400,
    "beyond": 1e305,
    "empty list": [],
    "list of None": [None, None],
    "list of True": [True, 1.0],
    "dict": {},
    "function": lambda *given, **named: None,
    "None": None,
    "ragged": [[1.0], [1.0, 2.0]],
}


def check(name, function, arguments, argument):
    """A value of a wrong kind is accepted as an equivalent valid one, or refused by name."""
    problems = []
    for kind, wrong in WRONG.items():
        if argument in PLACES and isinstance(wrong, str):
            continue  # a file that may be there or not
        try:
            with warnings.catch_warnings(), np.errstate(all="ignore"):
                warnings.simplefilter("ignore")
                function(**{**arguments, argument: wrong})
        except (ValueError, TypeError) as error:
            text = str(error)
            # a number of the right type may be incompatible with another argument
            names = arguments if kind == "float" else names_in(argument, arguments[argument])
            names = {*names, "heat.factor"} if argument == "heat_factor" else names
            shared = re.match(r"(?:\w, )+\w(?= must)", text)  # by coordinates
            named = any(is_named(n, text) or (shared and n in shared[0]) for n in names)
            if FOREIGN.search(text) or len(text) > MAX_CHARACTERS or not named:
                problems.append(f"{name}({argument}={kind}): {type(error).__name__}: {text[:200]}")
        except Exception as error:
            problems.append(f"{name}({argument}={kind}): {type(error).__name__}: {error!s:.200}")
    return problems


@pytest.mark.parametrize(
    ("name", "function", "arguments"),
    [pytest.param(*call, id=f"{call[0]}-{n}") for n, call in enumerate(CALLS)],
)
def test_a_bad_argument_is_refused_by_name(name, function, arguments, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)  # texts are names of files
    found = [text for one in arguments for text in check(name, function, arguments, one)]
    assert found == [], "\n".join(found)


NUMBERS = (True, np.False_, "12", 1j, np.array(True), np.array(1j), datetime.date(1979, 5, 27))
FLAGS = ("no", "false", "", 1, 0, 1.0, None, np.array(1), [])


@pytest.mark.parametrize(
    ("name", "function", "arguments"),
    [pytest.param(*call, id=f"{call[0]}-{n}") for n, call in enumerate(CALLS)],
)
def test_numbers_and_booleans_are_not_interchangeable(name, function, arguments):
    taken = []
    for argument, value in arguments.items():
        kinds = FLAGS if isinstance(value, bool) else NUMBERS
        for wrong in kinds if isinstance(value, (bool, int, float)) else ():
            try:
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore")
                    function(**{**arguments, argument: wrong})
            except (ValueError, TypeError):
                continue
            taken.append((argument, wrong))
    assert taken == []
