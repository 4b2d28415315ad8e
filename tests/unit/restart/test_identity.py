# SPDX-License-Identifier: GPL-3.0-or-later
"""The identity of a run depends on everything that affects its numbers, and on nothing else."""

import functools
import subprocess
import sys
import threading
from dataclasses import dataclass
from types import ModuleType

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

import samcontact as sc
from samcontact.restart.dependencies import UnidentifiedError
from samcontact.restart.identity import canonical, differences, digest, identity, require_identified

STEEL = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (1, 1.0),
        (np.float64(0.1), 0.1),
        ((1, 2), [1.0, 2.0]),
        ({"a": 1, "b": 2}, {"b": 2, "a": 1}),
        (np.zeros((2, 3)), np.zeros((2, 3), order="F")),
        (sc.Heat(0.1), sc.Heat([0.0, 0.1])),
    ],
)
def test_equal_runs_have_equal_identities(one, other):
    assert canonical(one) == canonical(other)


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (0.1, np.nextafter(0.1, 1.0)),
        (1, True),
        (1, "1"),
        (None, False),
        (["a", "b"], ["a, b"]),
        ([[1], 2], [1, [2]]),
        (np.zeros((2, 3)), np.zeros((3, 2))),
        (STEEL, STEEL.with_kinematic_hardening(3e10, 50.0)),
        (sc.softening.JohnsonCook(1800.0, 1.0), sc.softening.JohnsonCook(1800.0, 1.1)),
        (lambda rise: 1.0 + 0 * rise, lambda rise: 0.5 + 0 * rise),
    ],
)
def test_different_runs_have_different_identities(one, other):
    assert canonical(one) != canonical(other)
    assert digest(identity(it=one)) != digest(identity(it=other))


def test_differences_are_named():
    before = identity(friction=0.1, gap=np.zeros(3), grid="same")
    now = identity(friction=0.2, gap=np.ones(3), grid="same", heat=0.0)
    message = "friction 0.2 instead of 0.1, different gap, heat 0.0 instead of nothing"
    assert differences(now, before) == message


def test_in_another_process():
    code = "import sys; sys.path.insert(0, sys.argv[1]); from checkpoint_setups import halved"
    code += (
        "; from samcontact.restart.identity import canonical; print(canonical([halved, {'a': 1}]))"
    )
    from checkpoint_setups import halved

    folder = halved.__code__.co_filename.rpartition("/")[0]
    found = subprocess.run([sys.executable, "-c", code, folder], capture_output=True, check=True)
    assert found.stdout.decode().strip() == canonical([halved, {"a": 1}])


def by_closure(c):
    return lambda rise: 1.0 - c * rise


def by_default(c):
    def law(rise, c=c):
        return 1.0 - c * rise

    return law


def by_keyword_default(c):
    def law(rise, *, c=c):
        return 1.0 - c * rise

    return law


def by_nested_function(c):
    inner = by_closure(c)

    def law(rise):
        return [inner(one) for one in rise]

    return law


def by_a_changing_container(c):
    constants = {"of": [0.0, {"steel": c}]}
    return lambda rise: 1.0 - constants["of"][1]["steel"] * rise


class Law:
    def __init__(self, c):
        self.c = c

    def __repr__(self):
        return "Law"

    def __call__(self, rise):
        return 1.0 - self.c * rise

    def method(self, rise):
        return self(rise)


class Slotted:
    __slots__ = ("c",)

    def __init__(self, c):
        self.c = c

    def __call__(self, rise):
        return 1.0 - self.c * rise


@dataclass(frozen=True)
class Data:
    c: float

    def __call__(self, rise):
        return 1.0 - self.c * rise


def by_class(c):
    class Made:
        factor = c

        def __call__(self, rise):
            return 1.0 - self.factor * rise

    return Made()


def by_global(c):
    scope = {"C": c}
    exec("def helper(rise): return 1.0 - C * rise", scope)
    exec("def law(rise): return helper(rise)", scope)
    return scope["law"]


def by_module(c):
    """Return a law whose constants are in a separate module of the user."""
    module = ModuleType("of_the_user")
    module.inner = ModuleType("of_the_user.inner")
    module.inner.C = c
    scope = {"of_the_user": module}
    exec("def law(rise): return 1.0 - of_the_user.inner.C * rise", scope)
    return scope["law"]


def by_itself(c):
    def law(rise):
        return c if rise < 0.0 else law(rise - 1.0)

    return law


def by_identity(c):
    law = Law(threading.Lock())
    law.identity = ("measured", c)
    return law


FORMS = {
    "closure": by_closure,
    "default": by_default,
    "keyword default": by_keyword_default,
    "nested function": by_nested_function,
    "container": by_a_changing_container,
    "bound method": lambda c: Law(c).method,
    "instance": Law,
    "slots": Slotted,
    "dataclass": Data,
    "attribute of a class": by_class,
    "partial": lambda c: functools.partial(lambda rise, k: 1.0 - k * rise, k=c),
    "cached": lambda c: functools.cache(by_closure(c)),
    "vectorised": lambda c: np.vectorize(by_closure(c)),
    "spline": lambda c: CubicSpline([0.0, 1.0, 2.0], [1.0, c, 0.1]),
    "polynomial": lambda c: np.poly1d([c, 1.0]),
    "global of a helper": by_global,
    "module of the user": by_module,
    "recursion": by_itself,
    "array": lambda c: by_closure(np.array([c, "text", None], dtype=object)),
    "set": lambda c: by_closure({"a", "b", c}),
    "stated": by_identity,
}


@pytest.mark.parametrize("make", FORMS.values(), ids=FORMS)
def test_functions_are_identified_by_everything_they_depend_on(make):
    one, same, other = canonical(make(1e-4)), canonical(make(1e-4)), canonical(make(3e-4))
    assert one == same
    assert one != other


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (lambda rise: rise.min(), lambda rise: rise.max()),
        (lambda rise: rise + (1.0, 2.0)[1], lambda rise: rise + (1.0, 3.0)[1]),
        (lambda rise: [x + 1 for x in rise], lambda rise: [x + 2 for x in rise]),
        (np.sin, np.cos),
        (Law(1.0), Law(1.0).method),
        (2**53 + 1, 2**53),
        (np.array([2**53 + 1]), np.array([2**53])),
        ({1: "a"}, {"1": "a"}),
    ],
)
def test_small_differences(one, other):
    assert canonical(one) != canonical(other)


@pytest.mark.parametrize(
    "hidden", [threading.Lock(), (n for n in ()), memoryview(b"1")], ids=lambda v: type(v).__name__
)
def test_unreadable_state_is_not_guessed(hidden):
    with pytest.raises(UnidentifiedError):
        canonical(by_closure(hidden))
    who = identity(law=by_closure(hidden), load=1.0)
    with pytest.raises(UnidentifiedError, match=r"law cannot be identified.* law\.identity = "):
        require_identified(who)


def test_a_run_is_not_continued_with_another_law(tmp_path):
    """Another law, or a law that cannot be identified, is refused before any solve."""
    steel = sc.Material.perfect_plastic(210e9, 0.3, 1e9).with_thermal(50.0, 1e-5, 1.3e-5)
    grid, elastic = sc.Grid(4, 4, 1e-4, 1e-4, 2, 1e-4), sc.Material.elastic(210e9, 0.3)

    def run(law, checkpoint):
        scene = sc.Simulation(grid, elastic, steel.with_softening(law), np.ones((4, 4)))
        return scene.run([{"approach": -1.0}], progress=False, checkpoint=checkpoint)

    for _ in range(2):
        run(by_closure(1e-4), tmp_path / "known")
    with pytest.raises(sc.CheckpointError, match="different softening law of body 2"):
        run(by_closure(3e-4), tmp_path / "known")
    lock = threading.Lock()

    def hidden(rise):
        return np.full_like(rise, float(not lock.locked()))

    run(hidden, None)
    with pytest.raises(ValueError, match=r"softening law of body 2 cannot be identified"):
        run(hidden, tmp_path / "hidden")


def test_checkpoints_of_another_version_are_refused(tmp_path, monkeypatch):
    elastic = sc.Material.elastic(210e9, 0.3)
    scene = sc.Simulation(sc.Grid(4, 4, 1e-4, 1e-4), elastic, elastic, np.ones((4, 4)))

    def run():
        return scene.run([{"approach": -1.0}], progress=False, checkpoint=tmp_path)

    from samcontact.restart import file

    with monkeypatch.context() as older:
        older.setattr(file._core, "version", "0.0.9")
        run()
    with pytest.raises(sc.CheckpointError, match=r"was written by samcontact 0\.0\.9, not "):
        run()
    with pytest.warns(UserWarning, match=r"was written by samcontact 0\.0\.9, not "):
        sc.Simulation.load(tmp_path / "increment_00001.h5")
