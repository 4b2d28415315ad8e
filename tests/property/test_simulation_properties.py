# SPDX-License-Identifier: GPL-3.0-or-later
"""Properties of every elastic-plastic problem."""

import warnings

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

import samcontact as sc

few = settings(max_examples=6, deadline=None, derandomize=True)

E, NU, RADIUS = 210e9, 0.3, 7.5e-3
ELASTIC = sc.Material.elastic(E, NU)


def hardening(name, stress=1.0):
    if name == "swift":
        return sc.Material.swift(E * stress, NU, 945e6 * stress, 20.0, 0.121)
    if name == "linear":
        return sc.Material.linear_hardening(E * stress, NU, 1.2e9 * stress, 21e9 * stress)
    return sc.Material.perfect_plastic(E * stress, NU, 1.4e9 * stress)


laws = st.sampled_from(["swift", "linear", "perfect"])
# Loads below 1e-75 N are refused.
paths = st.lists(st.just(0.0) | st.floats(1e-9, 900.0), min_size=2, max_size=5)


def scene(body2, nx=21, ny=19, dx=60e-6, dy=65e-6, body1=ELASTIC, gap=None, length=1.0, **rest):
    grid = sc.Grid(nx, ny, dx * length, dy * length, 14, 60e-6 * length)
    if gap is None:
        gap = sc.surfaces.paraboloid(grid, RADIUS * length, 1.2 * RADIUS * length)
    return sc.Simulation(grid, body1, body2, gap, **rest)


@few
@given(law=laws, load=st.floats(400, 900))  # the hardest yields at 320
def test_load_balance_flow_rule_and_dissipation(law, load):
    simulation = scene(hardening(law))
    before = np.zeros(simulation.grid.volume_shape)
    for target in (0.5 * load, load, 0.2 * load, 0.0, 0.8 * load):
        state = simulation.step(load=target)
        total = state.pressure.sum() * simulation.grid.cell_area
        assert abs(total - target) < 1e-9 * load
        assert state.pressure.min() >= 0
        g = state.equivalent_plastic_strain()
        assert (g >= before).all()  # dissipation is never negative
        before = g
        # Plastic strain is isochoric, and no stress is above the yield stress.
        strain = state.plastic_strain()
        assert np.abs(strain[:3].sum(axis=0)).max() <= 1e-12 * max(np.abs(strain).max(), 1e-30)
        yielded = state.von_mises() / simulation.body2.yield_stress(g) - 1
        assert yielded.max() < 1e-5
    assert before.max() > 0


@few
@given(
    law=laws,
    length=st.sampled_from([1e3, 1 / 60e-6, 0.37]),
    stress=st.sampled_from([1e-6, 1 / 210e9, 12.3]),
)
def test_results_are_independent_of_units(law, length, stress):
    """SI units, millimetres and megapascals, and dimensionless numbers give equal digits."""
    reference = scene(hardening(law), tol=1e-10).step(load=700.0)
    scaled = scene(
        hardening(law, stress=stress),
        body1=sc.Material.elastic(E * stress, NU),
        length=length,
        tol=1e-10,
    ).step(load=700.0 * length**2 * stress)
    # Rounding differences grow until the tolerance ends the iteration. The tolerance bounds the
    # residual; the error is up to a hundred times larger for weak hardening.
    g, p = reference.equivalent_plastic_strain(), reference.pressure
    assert np.abs(scaled.equivalent_plastic_strain() - g).max() < 1e-8 * g.max()
    assert np.abs(scaled.pressure / stress - p).max() < 1e-9 * p.max()


@few
@given(law=laws, seed=st.integers(0, 1000))
def test_exchange_of_x_and_y(law, seed):
    grid = sc.Grid(21, 19, 60e-6, 65e-6, 14, 60e-6)
    rough = 0.2e-6 * np.random.default_rng(seed).random(grid.surface_shape)
    gap = sc.surfaces.paraboloid(grid, RADIUS) + rough
    one = scene(hardening(law), gap=gap).step(load=600.0)
    other = scene(hardening(law), nx=19, ny=21, dx=65e-6, dy=60e-6, gap=gap.T).step(load=600.0)
    assert np.abs(one.pressure - other.pressure.T).max() < 1e-5 * one.pressure.max()
    g = one.equivalent_plastic_strain()
    assert g.max() > 0
    swapped = other.equivalent_plastic_strain().transpose(1, 0, 2)
    assert np.abs(g - swapped).max() < 1e-5 * g.max()
    # xx <-> yy, yz <-> xz
    strain = other.plastic_strain().transpose(0, 2, 1, 3)[[1, 0, 2, 4, 3, 5]]
    assert np.abs(one.plastic_strain() - strain).max() < 1e-5 * np.abs(strain).max()


@few
@given(law=laws, friction=st.floats(0.0, 0.4))
def test_symmetry_in_y_is_kept(law, friction):
    state = scene(hardening(law), friction=friction).step(load=500.0)
    g = state.equivalent_plastic_strain()
    assert np.abs(g - g[:, ::-1]).max() < 1e-7 * max(g.max(), 1e-12)
    assert np.abs(state.pressure - state.pressure[:, ::-1]).max() < 1e-8 * state.pressure.max()


@few
@given(law=laws, friction=st.floats(0.0, 0.6), path=paths)
def test_equilibrium_and_complementarity_with_friction(law, friction, path):
    """On any path the pressure carries the load, and the gap is zero under pressure."""
    simulation = scene(hardening(law), friction=friction, on_border="warn")
    grid = simulation.grid
    for load in path:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # border and plastic strain of random loads
            state = simulation.step(load=load)
        assert abs(state.pressure.sum() * grid.cell_area - load) <= 1e-9 * load
        np.testing.assert_allclose(state.shear[0], friction * state.pressure, rtol=1e-12)
        assert not state.shear[1].any()
        if load == 0:
            continue
        # the gap from the bodies' displacement, not from the solver
        u = sum(state.surface_displacement(body) for body in (1, 2))
        g = simulation.initial_gap + u - state.approach
        scale = np.abs(u).max()
        assert g.min() >= -1e-6 * scale
        p = state.pressure
        assert np.minimum(p / p.max(), g / scale).max() <= 1e-6


@few
@given(law=laws, path=paths)
def test_dissipation_is_never_negative(law, path):
    """Dissipation is not negative; the work of a closed path is dissipated or stored."""
    material = hardening(law)
    simulation = scene(material, tol=1e-8, on_border="warn")
    before, done, external = simulation.state, 0.0, 0.0
    ends = [part * load for load in path for part in (0.5, 1.0)]
    for load in [*ends, 0.0]:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            state = simulation.step(load=load)
        tracks = [moment.track(2, margin=0) for moment in (state, before)]
        spent = sc.energy.plastic_work(material, *tracks)
        assert spent >= 0
        done += spent
        external += 0.5 * (state.load + before.load) * (state.approach - before.approach)
        before = state
    if done > 0:
        stored = sc.energy.residual_energy(before.track(2, margin=0))
        assert 0 <= stored < done


@few
@given(
    law=laws, load=st.floats(300.0, 900.0), shift=st.tuples(st.integers(0, 4), st.integers(0, 4))
)
def test_translation_by_whole_cells(law, load, shift):
    """A shifted ball gives shifted fields."""
    i, j = shift
    base = sc.surfaces.paraboloid(sc.Grid(21, 19, 60e-6, 65e-6), RADIUS)
    fields = []
    for a, b in ((0, 0), (i, j)):
        gap = np.full((25, 23), 1e-3)
        gap[a : a + 21, b : b + 19] = base
        state = scene(hardening(law), nx=25, ny=23, gap=gap, tol=1e-9).step(load=load)
        inside = slice(a, a + 21), slice(b, b + 19)
        fields.append((state.pressure[inside], state.equivalent_plastic_strain()[inside]))
    for one, other in zip(*fields, strict=True):
        assert np.abs(one - other).max() <= 1e-6 * max(np.abs(one).max(), 1e-12)
