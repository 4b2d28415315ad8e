# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments of a solver cannot be changed afterwards through any attribute or method."""

import copy
import pickle
from collections.abc import Mapping

import numpy as np
import pytest

import samcontact as sc
from samcontact._util.frozen import FrozenDict

GRID = sc.Grid(12, 10, 5e-6, 5e-6, nz=4, dz=5e-6)
HEIGHTS = 1e-7 * np.random.default_rng(2).standard_normal((12, 10))
STEEL = (
    sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
    .with_kinematic_hardening([1e9], [10.0])
    .with_thermal(46.0, 11e-6, 13e-6)
    .with_softening(sc.softening.JohnsonCook(1800.0, 1.0))
)
GLASS = sc.Material.elastic(70e9, 0.2)
GAP = sc.surfaces.paraboloid(GRID, 1e-3)


def simulation(**settings):
    relief = sc.Relief(HEIGHTS)
    return sc.Simulation(GRID, sc.Material.rigid(), STEEL, GAP, relief2=relief, **settings)


KINDS = (
    "grid", "heat", "layered", "material", "softening", "relief", "measured", "solver",
    "simulation", "state", "track", "collision", "hertz",
)  # fmt: skip


def objects():
    moved = simulation(friction=sc.Coulomb(0.1))  # described completely by a state
    state = moved.step(load=0.5)
    return {
        "grid": GRID,
        "heat": sc.Heat(0.1),
        "layered": sc.Layered([(sc.Material.elastic(1e9, 0.3), 1e-6)], GLASS),
        "material": STEEL,
        "softening": STEEL.softening,
        "relief": sc.Relief(HEIGHTS),
        "measured": sc.measured.MeasuredSurface(HEIGHTS, 5e-6, attrs={"source": "s.sur"}),
        "solver": sc.ContactSolver(GRID, sc.Material.rigid(), STEEL, 0.1, heat=sc.Heat(0.0)),
        "simulation": moved,
        "state": state,
        "track": state.track(),
        "collision": sc.asperities.Collision(1e-3, 1e-3, 1e-6),
        "hertz": sc.hertz.point(1e-3, 1e11, load=1.0),
    }


@pytest.fixture(scope="module")
def made():
    return objects()


@pytest.mark.parametrize("kind", KINDS)
def test_attributes_cannot_be_changed(made, kind):
    thing = made[kind]
    names = [name for name in dir(thing) if not name.startswith("_")]
    assert len(names) > 2
    for name in names:
        value = getattr(thing, name)
        with pytest.raises(AttributeError):
            setattr(thing, name, value)
        with pytest.raises(AttributeError):
            delattr(thing, name)
        if isinstance(value, np.ndarray) and value.size:
            again = getattr(thing, name)
            assert not value.flags.writeable or not np.shares_memory(value, again), name
        if isinstance(value, Mapping) and value is getattr(thing, name):
            with pytest.raises(TypeError):
                value["E"] = 70e9
            for change in ("update", "pop", "clear", "setdefault"):
                assert not hasattr(value, change)
        assert not isinstance(value, (list, dict, set)) or value is not getattr(thing, name), name
    with pytest.raises(AttributeError):
        thing.anything = 1.0


def test_array_arguments_are_copied():
    heights, gap, attrs = np.array(HEIGHTS), np.array(GAP), {"source": "a"}
    constants = {"E": 210e9, "nu": 0.3}
    steel = sc.Material("elastic", constants)
    run = sc.Simulation(GRID, sc.Material.rigid(), steel, gap, heat=sc.Heat(0.0, v := np.ones(2)))
    relief, surface = sc.Relief(heights), sc.measured.MeasuredSurface(heights, 1e-6, attrs=attrs)
    for array in (heights, gap, v):
        array[...] = 7.0
    constants["E"], attrs["source"] = 70e9, "b"
    np.testing.assert_array_equal(run.initial_gap, GAP)
    assert run.heat.velocity == ((0.0, 0.0), (1.0, 1.0))
    np.testing.assert_array_equal(relief.heights, HEIGHTS)
    np.testing.assert_array_equal(surface.heights, HEIGHTS)
    assert (steel.parameters["E"], surface.attrs) == (210e9, {"source": "a"})


def test_zero_dimensional_arrays_become_numbers():
    time = np.array(2.0)
    heat = sc.Heat(0.0, time=time, reference=time)
    time[...] = 9.0
    assert heat == sc.Heat(0.0, time=2.0, reference=2.0)


def test_a_step_changes_the_heat_factor_of_later_steps():
    cool, hot = sc.Heat(1e-3, (1.0, 0.0)), sc.Heat(5e-2, (1.0, 0.0))
    run, other = simulation(heat=cool), simulation(heat=hot)
    first = run.step(load=0.5, heat_factor=5e-2)
    assert run.heat == hot
    assert first.heat_factor == (0.0, 5e-2)
    for state in (first, run.step(load=0.4)):
        same = other.step(load=state.load)
        np.testing.assert_array_equal(state.surface_temperature(), same.surface_temperature())
    cooler = simulation(heat=cool).step(load=0.5)
    assert first.surface_temperature().max() > 10 * cooler.surface_temperature().max()
    with pytest.raises(ValueError, match="heat_factor must be a finite number >= 0, got -1"):
        run.step(load=0.5, heat_factor=-1.0)
    with pytest.raises(ValueError, match=r"heat.factor must be 0 for rigid body1"):
        run.step(load=0.5, heat_factor=(0.1, 0.0))
    assert run.heat == hot


@pytest.mark.parametrize("kind", ["grid", "material", "relief", "measured"])
def test_frozen_objects_can_be_copied_and_pickled(made, kind):
    thing = made[kind]
    for twin in (copy.deepcopy(thing), copy.copy(thing), pickle.loads(pickle.dumps(thing))):
        assert repr(twin) == repr(thing)
        if kind in ("grid", "material"):
            assert twin == thing
            assert hash(twin) == hash(thing)
        with pytest.raises(AttributeError):
            twin.anything = 1.0


def test_frozen_dictionaries_are_values():
    constants = FrozenDict({"E": 1.0, "nu": 0.3})
    assert constants == {"nu": 0.3, "E": 1.0} == constants
    assert hash(constants) == hash(FrozenDict({"nu": 0.3, "E": 1.0}))
    assert constants != FrozenDict({"E": 2.0, "nu": 0.3})
    assert {**constants} == dict(constants)
    with pytest.raises(AttributeError):
        constants._items = {}


def test_relief_is_periodic_or_not():
    for wrong in ("no", 2, np.ones(2)):
        with pytest.raises(TypeError, match="periodic must be True or False"):
            sc.Relief(HEIGHTS, periodic=wrong)
