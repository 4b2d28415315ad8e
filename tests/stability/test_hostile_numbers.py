# SPDX-License-Identifier: GPL-3.0-or-later
"""NaN and infinity in any number of any public call raise an error that names the argument."""

import inspect
import math

import numpy as np
import pytest
from public_calls import CALLS, is_named, names_in

import samcontact as sc

# A gap of infinity is the sharp end of a body.
pytestmark = pytest.mark.filterwarnings("ignore::samcontact.SingularPressureWarning")
HOSTILE = (math.nan, math.inf, -math.inf)

MADE_BY_THE_PACKAGE = {
    "AccuracyResult", "ContactSolution", "FoundLoad", "GridErrors", "IncrementErrors",
    "State", "Track", "Adhesion",
    "adhesion.Jkr", "adhesion.Maugis", "adhesion.ProfileContact", "adhesion.WaveContact",
    "paths.PullOff",
    "asperities.CollisionResult",
    "bearings.ElementLoads", "bearings.LoadZone",
    "bearings.RaceContact", "critical.CriticalCylinder", "critical.CriticalCylinderOverDepth",
    "critical.CriticalSphereOverDepth",
    "critical.CriticalSlidingSphere", "critical.CriticalSphere", "energy.EnergyBalance",
    "fatigue.Cycle",
    "fatigue.Exposure", "fatigue.FatigueField", "fatigue.Life",
    "flattening.Flattening", "hertz.EllipticContact",
    "hertz.LineContact", "hertz.PointContact", "RollingSolution",
    "inclusions.ButterflyMap", "inclusions.EshelbySphere", "inclusions.FineBox",
    "inclusions.Interface", "inclusions.MatrixStatistics", "inclusions.Peak",
    "inclusions.WeibullFit",
    "materials.MaterialData", "materials.SourcedValue",
    "shakedown.Cycle", "shakedown.ShakedownLimit", "shakedown.ShakedownResult",
    "parts.Cam", "parts.FlankContact", "parts.TappetContact", "overrolling.Overrolling",
    "lubricants.LubricantTables", "lubrication.FilmEstimate", "lubrication.FilmFriction",
    "lubrication.FilmErrors", "lubrication.FilmHeat", "lubrication.FilmPlasticity",
    "lubrication.FilmHistory", "lubrication.FilmIncrement", "lubrication.FilmLevel",
    "lubrication.FilmSolution", "lubrication.FilmThickness", "lubrication.MoesNumbers",
    "lubrication.RunningIn",
    "lubrication.StribeckCurve", "lubrication.TractionCurve",
    "FreeRollingSolution", "PartialSlipSolution", "SlidingSolution", "sliding.FrictionCurve",
    "wear.Cycle",
    "wear.FrettingCycle", "wear.FrettingResult", "wear.WearResult", "Zone",
}  # fmt: skip
"""Results: only their methods take arguments of the user."""

INTENDED = {
    # straight profiles
    ("surfaces.paraboloid", "Rx", math.inf),
    ("surfaces.paraboloid", "Ry", math.inf),
    ("bearings.roller_on_race", "crown_radius", math.inf),
    ("parts.TappetContact.surface", "crown_radius", math.inf),
    ("surfaces.roller", "race_radius", math.inf),
    # no slip
    ("Coulomb", "coefficient", math.inf),
    ("Tresca", "limit", math.inf),
    ("CappedCoulomb", "limit", math.inf),
    ("ThirdBody", "strength", math.inf),
    # a steady state
    ("Material.relaxation", "t", math.inf),
    ("Material.creep", "t", math.inf),
    ("Material.storage", "omega", math.inf),
    ("Material.loss", "omega", math.inf),
    ("heat_kernels.temperature", "time", math.inf),
    ("heat_kernels.displacement", "time", math.inf),
    ("heat_kernels.stress", "time", math.inf),
    # a conversion, which computes nothing
    *(("units.si", "value", bad) for bad in HOSTILE),
    # points that an instrument did not see
    ("measured.MeasuredSurface", "heights", math.nan),
    # no body there
    ("ContactSolver.solve", "gap", math.inf),
    ("Simulation", "gap", math.inf),
    ("rolling.steady", "gap", math.inf),
    ("sliding.steady", "gap", math.inf),
    ("sliding.over_speed", "gap", math.inf),
    ("overrolling.roll_over", "gap", math.inf),
    ("surfaces.from_heights", "heights_lower", -math.inf),
    ("surfaces.from_heights", "heights_upper", math.inf),
    ("measured.MeasuredSurface.on", "fill", -math.inf),
}
"""Documented meanings of what is an error elsewhere."""


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def spoiled(value, bad):
    """Yield copies of an argument with one number replaced; for an array also the number alone."""
    if is_number(value):
        yield bad
    elif isinstance(value, np.ndarray) and value.dtype.kind == "f":
        copy = value.copy()
        copy.flat[copy.size // 2] = bad
        yield copy
        yield bad
    elif isinstance(value, (list, tuple)):
        for n, item in enumerate(value):
            for other in spoiled(item, bad):
                yield type(value)([*value[:n], other, *value[n + 1 :]])
        if isinstance(value, list) and all(map(is_number, value)):
            yield bad
    elif isinstance(value, dict):
        for key, item in value.items():
            for other in spoiled(item, bad):
                yield {**value, key: other}


def hostile(name, arguments, *, intended):
    """Yield (text, arguments, allowed names) for each number of a call that is replaced."""
    for argument, value in arguments.items():
        for bad in HOSTILE:
            has_meaning = (name, argument, bad) in INTENDED
            if intended and not has_meaning:
                continue
            for n, other in enumerate(spoiled(value, bad)):
                # never one number in place of an array
                replaced = isinstance(value, np.ndarray) and is_number(other)
                if (has_meaning and not replaced) == intended:
                    given = {**arguments, argument: other}
                    yield f"{argument}-{bad}-{n}", given, names_in(argument, value)


EACH = [pytest.param(*call, id=f"{call[0]}-{n}") for n, call in enumerate(CALLS)]


@pytest.mark.parametrize(("name", "function", "arguments"), EACH)
def test_each_listed_call_is_valid(name, function, arguments):
    function(**arguments)


@pytest.mark.parametrize(("name", "function", "arguments"), EACH)
def test_a_bad_argument_is_refused_by_name(name, function, arguments):
    problems = []
    for what, given, names in hostile(name, arguments, intended=False):
        try:
            function(**given)
        except (ValueError, TypeError) as error:
            if not any(is_named(known, str(error)) for known in names):
                problems.append(f"{what}: {error}")
        else:
            problems.append(f"{what}: accepted")
    assert problems == []


@pytest.mark.parametrize(
    ("function", "arguments"),
    [
        pytest.param(function, given, id=f"{name}-{what}-{n}")
        for n, (name, function, arguments) in enumerate(CALLS)
        for what, given, _ in hostile(name, arguments, intended=True)
    ],
)
def test_values_with_a_meaning_are_accepted(function, arguments):
    function(**arguments)


def public_calls():
    """Return every public function, class and method, by name."""
    for name in sc.__all__:
        thing = getattr(sc, name)
        members = {name: thing}
        if inspect.ismodule(thing):
            public = getattr(thing, "__all__", None) or [
                inner
                for inner, member in vars(thing).items()
                if not inner.startswith("_") and getattr(member, "__module__", "") == thing.__name__
            ]
            members = {f"{name}.{inner}": getattr(thing, inner) for inner in public}
        for full, member in members.items():
            if inspect.isclass(member) and not issubclass(member, BaseException):
                yield from calls_of_class(full, member)
            elif inspect.isfunction(member):
                yield full, member


def calls_of_class(name, kind):
    if name not in MADE_BY_THE_PACKAGE:
        yield name, kind
    for inner, method in inspect.getmembers(kind):
        if not (inspect.isfunction(method) or inspect.ismethod(method)):
            continue
        if not inner.startswith("_") or (inner == "__call__" and inner in vars(kind)):
            yield f"{name}.{inner}", method


def test_every_public_argument_is_in_the_table():
    table = {}
    for name, _, arguments in CALLS:
        table.setdefault(name, set()).update(arguments)
    expected = {}
    for name, function in public_calls():
        kinds = (inspect.Parameter.VAR_POSITIONAL, inspect.Parameter.VAR_KEYWORD)
        parameters = inspect.signature(function).parameters.values()
        expected[name] = {p.name for p in parameters if p.kind not in kinds} - {"self"}
    assert len(expected) > 100
    assert sorted(set(expected) - set(table)) == []
    assert {n: sorted(expected[n] - table[n]) for n in expected if expected[n] - table[n]} == {}
