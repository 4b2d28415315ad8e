# SPDX-License-Identifier: GPL-3.0-or-later
"""Energy balance of bodies with inclusions."""

import functools
import warnings

import numpy as np
import pytest

import samcontact as sc

STEEL = sc.Material.elastic(210e9, 0.3)
GRID = sc.Grid(25, 25, 25e-6, 25e-6, dz=25e-6)
PLACE = (0.0, 5e-5, 2e-4), 1e-4


@pytest.mark.parametrize(
    "inclusion",
    [
        sc.Inclusion.sphere(*PLACE, sc.Material.elastic(600e9, 0.2)),
        sc.Inclusion.sphere(*PLACE, sc.Material.elastic(70e9, 0.33), misfit=1e-3),
        sc.Inclusion.void(*PLACE),
    ],
)
def test_the_work_of_the_load_is_elastic_energy(inclusion):
    """Both the mismatch and the misfit count: without them the error is ten times as large."""
    body = sc.Heterogeneous(STEEL, [inclusion])
    gap = sc.surfaces.paraboloid(GRID, 5e-3)
    sim = sc.Simulation(GRID, sc.Material.rigid(), body, gap, on_border="warn", tol=1e-4)
    states = [sim.step(load=load) for load in np.linspace(2.0, 60.0, 10)]
    balance = sc.energy.balance(sim, states)
    assert abs(balance.imbalance) < 1.5e-3


@pytest.mark.parametrize("E", [600e9, 70e9])
def test_the_initial_stress_works_on_the_mismatch(E):
    """Without its work the error is 2 %."""
    stressed = STEEL.with_residual_stress([0.0, 1e-3], [-1e9, -1e9])
    inclusion = sc.Inclusion.sphere(*PLACE, sc.Material.elastic(E, 0.3))
    _, _, balance = yielding(inclusion, matrix=stressed)
    assert abs(balance.imbalance) < 1.5e-3


HARDENING = sc.Material.linear_hardening(210e9, 0.3, 800e6, 10e9)
SOFT = sc.Material.linear_hardening(70e9, 0.33, 300e6, 5e9)


@functools.cache
def yielding(*inclusions, matrix=HARDENING, unload=False):
    body = sc.Heterogeneous(matrix, inclusions) if inclusions else matrix
    gap = sc.surfaces.paraboloid(GRID, 5e-3)
    sim = sc.Simulation(GRID, sc.Material.rigid(), body, gap, on_border="warn", tol=1e-4)
    loads = [*np.linspace(2.0, 250.0, 10), *([120.0, 30.0, 1e-3] if unload else [])]
    with warnings.catch_warnings():
        for kind in (sc.PlasticStrainWarning, sc.ResolutionWarning, sc.IncrementWarning):
            warnings.simplefilter("ignore", kind)
        states = [sim.step(load=load) for load in loads]
    return sim, states, sc.energy.balance(sim, states)


@pytest.mark.parametrize(
    "inclusion",
    [
        sc.Inclusion.sphere(*PLACE, sc.Material.elastic(600e9, 0.2), misfit=-1e-3),
        sc.Inclusion.sphere(*PLACE, SOFT, misfit=1e-3),
        sc.Inclusion.void(*PLACE),
    ],
)
@pytest.mark.parametrize("unload", [False, True])
def test_the_work_of_the_load_is_stored_and_dissipated(inclusion, unload):
    """The error of the body without inclusion is 0.4 % with these cells.

    The strain next to voids has a tolerance ten times as large.
    """
    _, _, clean = yielding(unload=unload)
    _, states, balance = yielding(inclusion, unload=unload)
    assert abs(clean.imbalance) < 6e-3
    assert balance.plastic_work > 0.3 * balance.work_input
    other = 4e-3 if inclusion.material is None else 2e-3
    assert abs(balance.imbalance - clean.imbalance) < other
    assert states[-1].max_equivalent_plastic_strain(2) > 0.01


def test_plastic_work_of_an_inclusion_in_an_elastic_matrix():
    inclusion = sc.Inclusion.sphere(*PLACE, SOFT)
    _, states, balance = yielding(inclusion, matrix=STEEL)
    strain = states[-1].phase_strains(2).inclusion_equivalent
    work = np.sum(states[-1].share(2) * SOFT.plastic_work(strain)) * GRID.cell_area * GRID.dz
    assert balance.plastic_work == pytest.approx(work, rel=1e-12)
    assert balance.plastic_work > 0.01 * balance.work_input
    assert abs(balance.imbalance) < 2e-3


def test_backstress_of_the_matrix():
    kinematic = sc.Material.perfect_plastic(210e9, 0.3, 800e6).with_kinematic_hardening(10e9)
    _, _, clean = yielding(matrix=kinematic)
    for inclusion in (
        sc.Inclusion.sphere(*PLACE, sc.Material.elastic(600e9, 0.2)),
        sc.Inclusion.void(*PLACE),
    ):
        _, _, balance = yielding(inclusion, matrix=kinematic)
        assert abs(balance.imbalance - clean.imbalance) < 2e-3


def test_phases_of_partly_filled_cells():
    """The mean of both phases is the plastic strain of the cell."""
    _, states, _ = yielding(sc.Inclusion.sphere(*PLACE, SOFT))
    share, strains = states[-1].share(2), states[-1].phase_strains(2)
    mean = (1 - share) * strains.matrix + share * strains.inclusion
    found = states[-1].plastic_strain(2)
    assert np.abs(mean - found).max() < 1e-12
    cut = (share > 0) & (share < 1)
    assert np.abs(strains.matrix - strains.inclusion)[:, cut].max() > 1e-3
    np.testing.assert_array_equal(strains.matrix[:, ~cut], strains.inclusion[:, ~cut])


def test_refused():
    yielding = sc.Material.perfect_plastic(210e9, 0.3, 1e9).with_thermal(50.0, 1.2e-5, 1e-5)
    body = sc.Heterogeneous(yielding, [sc.Inclusion.void(*PLACE)])
    gap = sc.surfaces.paraboloid(GRID, 5e-3)
    sim = sc.Simulation(
        GRID, sc.Material.rigid(), body, gap, friction=0.2, on_border="warn", tol=1e-3,
        heat=sc.Heat(factor=0.1, velocity=(-1.0, 0.0)),
    )  # fmt: skip
    states = [sim.step(load=1.0), sim.step(load=2.0)]
    with pytest.raises(ValueError, match="body2 must not be heated if it has inclusions and can"):
        sc.energy.balance(sim, states)
