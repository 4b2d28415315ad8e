# SPDX-License-Identifier: GPL-3.0-or-later
"""Thousands of random cases are solved within the laws and in balance, or refused with a reason.

`python tests/fuzz/test_fuzz_setups.py 2000 3000` solves the cases with these numbers and prints the
outcome of each, which `setup_counts.py` counts.
"""

import sys
import traceback
import warnings
from collections import Counter
from functools import partial

import pytest
from balances import assert_energy, assert_increment
from drawn_paths import drawn_case
from drawn_studies import STUDIES
from fuzzing import INPUTS, tried

import samcontact as sc
from samcontact.cases import Case, CaseError

MIN_SETUPS, MAX_SETUPS = INPUTS["drawn cases"]
SETUPS_PER_PART = 250
"""Number of cases in one slow test."""
EXPECTED = (
    sc.ResolutionWarning, sc.ElasticStrainWarning, sc.PlasticStrainWarning,
    sc.GridTooSmallWarning, sc.UnitWarning, sc.IncrementWarning, sc.shakedown.NotSteadyWarning,
)  # fmt: skip
REFUSALS = {
    "border": (sc.GridTooSmallError, "enlarge"),
    "convergence": (sc.ConvergenceError, "tol"),
    "unbounded flow": (ValueError, "plastic zone of body"),  # of the whole half-space
    "parts": (ValueError, "would require"),  # more than an increment is divided into
    "heat steps": (CaseError, "heat.history must"),  # too short for the cells
    "strain beyond": (ValueError, "grid must contain the plastic strain"),  # in cycles to shakedown
}
"""Type of each refusal, and a part of its message."""
FOUND = {
    2274: "heat steps", 2369: "solved", 2832: "solved", 3291: "solved", 4508: "solved",
    7906: "convergence", 7921: "solved",
}  # fmt: skip
"""Numbers of cases that once failed, and their outcome."""
MUCH_MISSING, FALLS = 0.6, 0.75
"""Missing fraction of the work input that requires a second run with twice the increments, and the
largest allowed ratio of the second missing fraction to the first."""
REFUSING = tuple({kind for kind, _ in REFUSALS.values()})


def refusal(error):
    """Kind of an error, if its message states a remedy."""
    for name, (kind, text) in REFUSALS.items():
        if type(error) is kind and text in str(error):
            return name
    raise error


def study(name, seed):
    """Outcome of a study, or AssertionError."""
    try:
        STUDIES[name](seed)
    except REFUSING as error:
        return refusal(error)
    return "solved"


def solve(seed):
    """Outcome of all increments of a problem, or AssertionError."""
    came_to, missing = followed(drawn_case(seed))
    if missing is not None and missing >= MUCH_MISSING:
        # The work of a segment solved in one increment is that of its mean force.
        case = drawn_case(seed)
        for segment in case["path"]:
            segment["increments"] *= 2
        again, less = followed(case)
        assert again != "solved" or less < FALLS * missing
    return came_to


def followed(drawn):
    """Outcome of a case, and the fraction of its energy that is missing."""
    case = Case.model_validate(drawn)
    try:
        simulation, path = case.build()
    except CaseError as error:
        return refusal(error), None
    states = [simulation.state]
    for step in path:
        try:
            states.append(simulation.step(**step))
        except REFUSING as error:
            assert simulation.state.load == states[-1].load
            return refusal(error), None
        assert_increment(simulation, *states[-2:], step)
    return "solved", assert_energy(simulation, states)


def outcomes(seeds, solve=solve):
    """Number of problems by outcome; the first failure states its number."""
    count = Counter()
    with warnings.catch_warnings():
        for category in EXPECTED:
            warnings.simplefilter("ignore", category)
        for seed in seeds:
            try:
                count[solve(seed)] += 1
            except Exception as error:
                raise AssertionError(f"drawn scene {seed}") from error
    return count


@pytest.mark.parametrize(("number", "outcome"), FOUND.items())
def test_problems_that_once_failed_are_solved(number, outcome):
    assert outcomes([number]) == {outcome: 1}


def test_random_problems_are_solved_in_balance():
    count = outcomes(range(MIN_SETUPS))
    assert count["solved"] >= 0.8 * MIN_SETUPS


@pytest.mark.slow
@pytest.mark.parametrize("first", range(MIN_SETUPS, MAX_SETUPS + MIN_SETUPS, SETUPS_PER_PART))
def test_ten_thousand_random_problems(first):
    count = outcomes(range(first, first + SETUPS_PER_PART))
    assert count["solved"] >= 0.8 * SETUPS_PER_PART
    assert count["convergence"] <= 0.1 * SETUPS_PER_PART


@tried("studies")
@pytest.mark.parametrize("name", STUDIES)
def test_random_studies_are_solved_in_balance(name, count):
    found = outcomes(range(count), partial(study, name))
    assert found["solved"] >= 0.8 * count


if __name__ == "__main__":
    total = Counter()
    warnings.simplefilter("error")
    for number in range(int(sys.argv[1]), int(sys.argv[2])):
        try:
            total += (found := outcomes([number]))
            print(number, *found, flush=True)
        except AssertionError as failure:
            total["FAILED"] += 1
            cause = failure.__cause__
            line = traceback.extract_tb(cause.__traceback__)[-1]
            place = f"{line.filename.rpartition('/')[2]}:{line.lineno} {line.line}"
            print(number, "FAILED", type(cause).__name__, str(cause)[:200], place, flush=True)
    print(dict(total))
