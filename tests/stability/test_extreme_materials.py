# SPDX-License-Identifier: GPL-3.0-or-later
"""Hardening from zero to 0.9 E, yield starting at the surface, friction up to one."""

import itertools

import numpy as np
import pytest

import samcontact as sc

E, NU, RADIUS = 210e9, 0.3, 7.5e-3
STEEL = sc.Material.elastic(E, NU)
EXACT = sc.hertz.point(RADIUS, sc.hertz.effective_modulus(STEEL, STEEL), p0=2.4e9)
HARDENING = (0.0, 1e-6, 1e-3, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9)

pytestmark = pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")


def law(share, yield_stress=1e9):
    """Return a law by tangent modulus over E; kinematic: added to perfect plasticity."""
    if share == 0:
        return sc.Material.perfect_plastic(E, NU, yield_stress)
    return sc.Material.linear_hardening(E, NU, yield_stress, share * E)


def kinematic(share, yield_stress=1e9):
    return law(0.0, yield_stress).with_kinematic_hardening(E * share / (1 - share))


def simulate(body2, friction=0.0, gap=None, body1=STEEL, **settings):
    grid = sc.Grid(15, 15, 3.2 * EXACT.a / 15, 3.2 * EXACT.a / 15, 10, 0.2 * EXACT.a)
    surface = sc.surfaces.paraboloid(grid, RADIUS) if gap is None else gap(grid)
    settings = {"on_border": "warn", "tol": 1e-7, **settings}
    return sc.Simulation(grid, body1, body2, surface, friction, **settings)


def assert_at_yield(simulation, state):
    """Assert that no cell is beyond yield, flowing cells are at yield, and the load is carried."""
    assert state.converged
    area = simulation.grid.cell_area
    assert state.pressure.sum() * area == pytest.approx(state.load, rel=1e-9)
    assert state.pressure.min() >= 0
    strain = state.plastic_strain()
    assert np.abs(strain[:3].sum(axis=0)).max() <= 1e-12 * np.abs(strain).max()
    if not simulation.body2.kinematic:
        limit = simulation.body2.yield_stress(state.equivalent_plastic_strain())
        assert (state.von_mises() <= limit * (1 + 1e-6)).all()


@pytest.mark.parametrize("friction", [0.0, 0.5])
@pytest.mark.parametrize("make", [law, kinematic])
def test_plastic_flow_decreases_with_hardening(make, friction):
    """Hardening from zero to 0.9 E: less flow and more pressure at each step, without a jump."""
    flows, peaks = [], []
    for share in HARDENING if make is law else HARDENING[1:]:
        simulation = simulate(make(share), friction)
        state = simulation.step(load=0.7 * EXACT.load)
        assert_at_yield(simulation, state)
        flows.append(state.equivalent_plastic_strain().sum())
        peaks.append(state.pressure.max())
        strain = state.plastic_strain()
        np.testing.assert_array_equal(simulation.step(load=0.0).plastic_strain(), strain)
    assert all(less <= more * (1 + 1e-6) for more, less in itertools.pairwise(flows))
    assert all(more >= less * (1 - 1e-6) for less, more in itertools.pairwise(peaks[-6:]))
    assert 0 < flows[-1] < 0.1 * flows[0]


def test_vanishing_hardening_tends_to_perfect_plasticity():
    """The difference is proportional to the modulus: 1e-6 E agrees within 1e-4."""
    perfect, almost = (simulate(law(s)).step(load=0.7 * EXACT.load) for s in (0.0, 1e-6))
    strain = perfect.plastic_strain()
    difference = np.abs(almost.plastic_strain() - strain).max()
    assert 0 < difference < 1e-3 * np.abs(strain).max()


def test_the_stiffest_hardening_is_nearly_elastic():
    """At 0.99 E the pressure is that of Hertz on these cells, except for the effect of yield."""
    elastic = simulate(STEEL).step(load=EXACT.load)
    state = simulate(law(0.99)).step(load=EXACT.load)
    assert state.max_equivalent_plastic_strain() > 0
    assert np.abs(state.pressure - elastic.pressure).max() < 5e-3 * elastic.pressure.max()


@pytest.mark.parametrize("share", [0.0, 0.1, 0.9])
@pytest.mark.parametrize("friction", [0.5, 0.7, 1.0])
def test_yield_begins_at_the_surface(friction, share):
    """Above mu = 0.3 the first layer yields first, at the onset of the closed form."""
    body = law(share)
    onset = sc.critical.onset_sliding(RADIUS, EXACT.E_star, NU, 1e9, friction)
    assert onset.z == 0.0
    size = onset.a / 8
    grid = sc.Grid(27, 27, size, size, 10, 0.2 * size)
    simulation = sc.Simulation(
        grid, STEEL, body, sc.surfaces.paraboloid(grid, RADIUS), friction, on_border="warn"
    )
    for load in onset.load * np.linspace(0.8, 1.4, 13):
        state = simulation.step(load=load)
        flow = state.equivalent_plastic_strain()
        if flow.any():
            break
    # half a layer below the surface, and between cells
    assert 0.9 < load / onset.load < 1.35
    i, j, k = np.argwhere(flow).T
    assert set(k) == {0}
    assert np.hypot(grid.x[i], grid.y[j]).max() < 1.2 * onset.a
    assert_at_yield(simulation, simulation.step(load=1.1 * load))
    assert_at_yield(simulation, simulation.step(load=0.0))


@pytest.mark.parametrize("friction", [0.0, 0.3, 0.6, 1.0])
@pytest.mark.parametrize("share", [0.0, 0.1])
@pytest.mark.parametrize("nu", [0.0, 0.499])
def test_friction_up_to_one_between_dissimilar_bodies(nu, share, friction):
    """Contacts with normal-tangential coupling, with hardening and perfectly plastic."""
    simulation = simulate(law(share), friction, body1=sc.Material.elastic(E, nu))
    for load in (0.1, 0.2, 0.05):
        state = simulation.step(load=load * EXACT.load)
        assert_at_yield(simulation, state)
    np.testing.assert_allclose(state.shear[0], friction * state.pressure, rtol=1e-12)


@pytest.mark.parametrize("melting", [1000.0, 2000.0])
def test_heat_that_melts_the_surface(melting):
    """Molten material keeps the minimum yield stress; the load is carried around it."""
    soft = law(0.1).with_softening(sc.softening.JohnsonCook(melting, 1.0, floor=0.05))
    soft = soft.with_thermal(50.0, 0.0, 1.4e-5)  # without expansion, to melt before it seizes
    simulation = simulate(soft, 0.3, heat=sc.Heat(3.0, (1.0, 0.0)), tol=1e-6)
    for load in (0.02, 0.05):
        state = simulation.step(load=load * EXACT.load)
    factor = state.softening()
    assert (factor.min() == 0.05) == (melting == 1000.0)
    assert factor.min() < 0.4
    strain = state.equivalent_plastic_strain()
    assert np.unravel_index(strain.argmax(), strain.shape)[2] == 0
    limit = factor * soft.yield_stress(strain)
    assert (state.von_mises() <= limit * (1 + 1e-5)).all()
    assert state.pressure.sum() * simulation.grid.cell_area == pytest.approx(state.load, rel=1e-9)


def flat(grid):
    return np.zeros(grid.surface_shape)


def punch(grid):
    return np.where(np.hypot(grid.x[:, None], grid.y) < 0.8 * EXACT.a, 0.0, 1e-4)


def stepped(grid):
    ball = sc.surfaces.paraboloid(grid, RADIUS)
    return ball + np.where(grid.x[:, None] > 0, 3e-7, 0.0)


@pytest.mark.filterwarnings("ignore::samcontact.SingularPressureWarning")
@pytest.mark.parametrize("share", [0.0, 0.1, 0.9])
@pytest.mark.parametrize("friction", [0.0, 0.5])
@pytest.mark.parametrize(("gap", "peak"), [(flat, 1.2), (punch, 0.6), (stepped, 0.8)])
def test_sharp_edges_and_full_contact_flow(gap, peak, friction, share):
    simulation = simulate(law(share), friction, gap=gap)
    for part in (0.5, 1.0, 0.3):
        state = simulation.step(load=part * peak * EXACT.load)
        assert_at_yield(simulation, state)
    if gap is flat:
        assert (state.pressure > 0).mean() > 0.5
    if gap is punch:
        outside = gap(simulation.grid) > 0
        assert not state.pressure[outside].any()
    assert state.max_equivalent_plastic_strain() > 0


@pytest.mark.parametrize("yield_stress", [1.0, 1e3, 1e6])
def test_a_body_of_vanishing_strength(yield_stress):
    """Problems are self-similar in stress: soft bodies need as many iterations as steel."""
    scale = yield_stress / 1e9
    soft = sc.Material.linear_hardening(E * scale, NU, yield_stress, 0.1 * E * scale)
    scaled = simulate(soft, body1=sc.Material.elastic(E * scale, NU))
    state = scaled.step(load=0.7 * EXACT.load * scale)
    expected = simulate(law(0.1)).step(load=0.7 * EXACT.load)
    strain = expected.plastic_strain()
    assert np.abs(state.plastic_strain() - strain).max() < 1e-10 * np.abs(strain).max()
