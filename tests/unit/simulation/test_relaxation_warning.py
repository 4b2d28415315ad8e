# SPDX-License-Identifier: GPL-3.0-or-later
"""Warning of a sudden load in an increment that is long for the relaxation; memory of a track."""

import pytest
from viscoelastic_setups import GRID, LOAD, SLS, SOFT, simulation

import samcontact as sc
from samcontact._util import memory

DURATION = 4 * SLS.relaxation_terms[0][0]


def loaded(body, *steps):
    sim = simulation(body)
    for load, duration in steps:
        sim.step(load=load * LOAD, duration=duration)


@pytest.mark.filterwarnings("ignore::samcontact.ElasticStrainWarning")
def test_a_sudden_load_in_a_long_increment_warns_once():
    """Not if the load continues to rise, is applied at once, or the body hardly relaxes."""
    with pytest.warns(sc.IncrementWarning, match="a sudden change with duration = 0") as found:
        loaded(
            SLS,
            (0.2, DURATION),
            (0.2, DURATION),
            (0.02, DURATION),
            (0.02, DURATION),
        )
    assert len(found) == 1
    loaded(SLS, (0.2, 0.0), (0.2, DURATION), (0.2, DURATION))
    loaded(SLS, (0.2, DURATION / 2), (0.2, DURATION))
    loaded(SLS, (0.1, DURATION), (0.15, DURATION), (0.2, DURATION), (0.2, DURATION))
    loaded(SOFT.with_relaxation([1.0], [0.005]), (0.2, DURATION), (0.2, DURATION))


@pytest.mark.filterwarnings("ignore::samcontact.ElasticStrainWarning")
def test_creep_within_a_cell_warns_once():
    """Not over more than a cell, or so fast that the body has its long-time modulus."""
    creep = SLS.relaxation_terms[0][0] / (1 - SLS.relaxation_terms[1][0])  # retardation time [s]

    def rolled(cells):
        sim = simulation(SLS, friction=0.0)
        sim.step(load=0.2 * LOAD, duration=0.0)
        step = {"advance": (0.0, -GRID.dx), "duration": creep / cells}
        for _ in range(3):
            sim.step(load=0.2 * LOAD, **step)

    with pytest.warns(sc.ResolutionWarning, match="creeps within") as found:
        rolled(0.3)
    assert len(found) == 1
    rolled(3.0)
    rolled(0.003)


@pytest.mark.filterwarnings("ignore::samcontact.IncrementWarning")
def test_a_long_track_requires_memory(monkeypatch):
    """The operators of the grid with the track are not built if they do not fit."""
    sim = simulation(SLS, friction=0.0)
    sim.step(load=0.1 * LOAD, duration=0.0)
    far = 40000 * GRID.dx
    monkeypatch.setattr(memory, "available", lambda: 1e8)
    with pytest.raises(MemoryError, match="track of a viscoelastic body"):
        sim.step(load=0.1 * LOAD, advance=(0.0, -far), duration=0.1)
    near = sim.step(load=0.1 * LOAD, advance=(0.0, -GRID.dx), duration=0.1)
    assert near.load == pytest.approx(0.1 * LOAD)
