# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects that refer to themselves through the core are garbage-collected."""

import copy
import gc
import pickle
import weakref

import numpy as np
import pytest

import samcontact as sc

GRID = sc.Grid(16, 16, 4e-5, 4e-5, 4, 4e-5)
ELASTIC = sc.Material.elastic(210e9, 0.3)
STEEL = sc.Material.perfect_plastic(210e9, 0.3, 1.4e9).with_thermal(50.0, 1e-5, 1e-5)


class Study:
    """Object that owns a simulation and whose method is the softening law."""

    def __init__(self):
        self.calls = 0
        gap = sc.surfaces.paraboloid(GRID, 7.5e-3)
        self.simulation = sc.Simulation(
            GRID, ELASTIC, STEEL.with_softening(self.law), gap, friction=0.1, heat=sc.Heat(0.01),
            on_border="warn",
        )  # fmt: skip

    def law(self, rise):
        self.calls += 1
        return np.full_like(rise, 0.9)


@pytest.mark.filterwarnings("ignore::UserWarning")
def test_a_softening_law_may_refer_to_its_simulation():
    study = Study()
    state = study.simulation.step(load=20.0)
    assert study.calls > 0
    known = weakref.ref(study), weakref.ref(study.simulation)
    del study, state
    gc.collect()
    assert [reference() for reference in known] == [None, None]


def halved(rise):
    return np.full_like(rise, 0.5)


@pytest.mark.filterwarnings("ignore::UserWarning")
@pytest.mark.parametrize("another", [copy.deepcopy, lambda s: pickle.loads(pickle.dumps(s))])
def test_a_copy_keeps_its_law_after_deletion_of_the_original(another):
    gap = sc.surfaces.paraboloid(GRID, 7.5e-3)
    scene = dict(friction=0.1, heat=sc.Heat(0.01), on_border="warn")
    simulation = sc.Simulation(GRID, ELASTIC, STEEL.with_softening(halved), gap, **scene)
    copied = another(simulation)
    expected = simulation.step(load=30.0).pressure.copy()
    del simulation
    gc.collect()
    np.testing.assert_array_equal(copied.step(load=30.0).pressure, expected)
