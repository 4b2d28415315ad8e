# SPDX-License-Identifier: GPL-3.0-or-later
"""Depth profiles of yield and residual stress: closed forms, finite elements, other routes."""

import copy
import pickle

import numpy as np
import pytest

import samcontact as sc
from reference import fem
from rough_setups import (
    CELLS,
    GRID,
    LAYERS,
    PERCENT,
    PERFECT,
    RIGID,
    SIZE,
    assert_few_errors,
    simulation,
    zone_counts,
)
from samcontact import energy
from samcontact._util.tensors import von_mises
from samcontact.simulation.error_controlled_quantities import value as certified_value

E, NU, Y = 210e9, 0.3, 1e9
ELASTIC = sc.Material.elastic(E, NU)
PLAIN = sc.Material.perfect_plastic(E, NU, Y)
SOFT = sc.Material.linear_hardening(E, NU, Y, 0.1 * E)
WEAK = ([0.0, 20e-6, 30e-6, 60e-6], [1.0, 1.0, 0.5, 1.0])
PULLED = ([0.0, 40e-6], [200e6, -100e6])


def periodic(nz, dz=4e-6, n=8):
    return sc.Grid(n, n, 10e-6, 10e-6, nz=nz, dz=dz, periodic="xy")


def pressed_evenly(material, pressure, nz=0):
    """Press a half-space uniformly, so that each depth deforms independently."""
    grid = periodic(nz)
    sim = sc.Simulation(grid, RIGID, material, np.zeros(grid.surface_shape))
    return sim.step(pressure=np.full(grid.surface_shape, pressure))


@pytest.mark.parametrize("nz", [0, 3, 25])
@pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
def test_each_depth_flows_by_its_own_yield_stress(nz):
    """Zero lateral strain: e_zz = -2 (1 - nu)/E (|p (1 - 2 nu)/(1 - nu) + s0| - f Y)."""
    material = PLAIN.with_yield_profile(*WEAK).with_residual_stress(*PULLED)
    pressure = 1.2e9
    state = pressed_evenly(material, pressure, nz)
    z = (np.arange(25) + 0.5) * 4e-6
    driven = pressure * (1 - 2 * NU) / (1 - NU) + np.interp(z, *PULLED)
    flow = np.maximum(0.0, driven - Y * np.interp(z, *WEAK))
    assert 0 < np.count_nonzero(flow) < 5  # a zone of its own
    expected = -2 * (1 - NU) / E * flow
    strain = state.plastic_strain()
    shown = strain.shape[-1]
    for cell in np.ndindex(8, 8):
        np.testing.assert_allclose(strain[2][cell], expected[:shown], atol=1e-6 * 1e-3)
    # Flow that fields do not show is there all the same.
    assert state.max_equivalent_plastic_strain() == pytest.approx(-expected.min(), rel=1e-6)
    assert state.max_plastic_strain_magnitude() == pytest.approx(-expected.min(), rel=1e-6)


def test_a_constant_profile_is_another_yield_stress():
    grid = sc.Grid(21, 21, 60e-6, 60e-6, 12, 60e-6)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    half = sc.Material.perfect_plastic(E, NU, 0.5 * Y)
    found, expected = (
        sc.Simulation(grid, ELASTIC, body, gap).run(sc.paths.load_unload(load=600.0, increments=3))
        for body in (half.with_yield_profile([0.0, 1e-3], [2.0, 2.0]), PLAIN)
    )
    assert found[-1].max_equivalent_plastic_strain() > 1e-3
    for one, other in zip(found, expected, strict=True):
        np.testing.assert_allclose(one.pressure, other.pressure, rtol=1e-9, atol=1.0)
        np.testing.assert_allclose(one.stress(), other.stress(), rtol=1e-9, atol=1.0)


def test_residual_stress_equals_that_of_an_eigenstrain():
    """A uniform e_xx = e_yy = e(z) causes the stress -E/(1 - nu) e, independent of the contact."""
    grid = periodic(12, 15e-6, n=20)
    x = 2 * np.pi * np.arange(20) / 20
    gap = 0.8e-6 * (2 - np.cos(x)[:, None] - np.cos(x)[None, :])
    depth = grid.z
    stress = -600e6 * np.exp(-depth / 40e-6)
    given = sc.Simulation(grid, RIGID, SOFT.with_residual_stress(depth, stress), gap)
    strained = sc.Simulation(grid, RIGID, SOFT, gap)
    strain = np.zeros((6, *grid.volume_shape))
    strain[:2] = -(1 - NU) / E * stress
    strained.set_plastic_strain(2, strain)
    for load in (0.5, 1.0, 0.0):
        one, other = (sim.step(load=load * 60.0) for sim in (given, strained))
        scale = max(one.pressure.max(), 1e6)
        np.testing.assert_allclose(one.pressure, other.pressure, atol=1e-6 * scale)
        np.testing.assert_allclose(
            one.plastic_strain(), other.plastic_strain() - strain, atol=1e-6 * 2e-3
        )
        for name in ("stress", "residual_stress", "von_mises", "hydrostatic"):
            fields = [getattr(state, name)() for state in (one, other)]
            np.testing.assert_allclose(*fields, atol=1e-5 * Y, err_msg=name)
    assert one.max_equivalent_plastic_strain() > 1e-3


def test_an_elastic_body_only_shows_residual_stress():
    grid = sc.Grid(9, 9, 60e-6, 60e-6, 5, 40e-6)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    z, sxx, syy, sxy = [0.0, 100e-6], [-3e8, 0.0], [1e8, 2e8], [5e7, -5e7]
    body = ELASTIC.with_residual_stress(z, sxx, syy, sxy)
    plain, given = (sc.Simulation(grid, RIGID, b, gap).step(load=20.0) for b in (ELASTIC, body))
    np.testing.assert_array_equal(given.pressure, plain.pressure)
    expected = np.zeros((6, *grid.volume_shape))
    for c, values in ((0, sxx), (1, syy), (5, sxy)):
        expected[c] = np.interp(grid.z, z, values)
    np.testing.assert_allclose(given.initial_stress(), expected, rtol=1e-15)
    np.testing.assert_allclose(given.residual_stress(), expected, rtol=1e-15)
    np.testing.assert_allclose(given.stress() - plain.stress(), expected, atol=1e-3)


def hertz_pressure(grid, radius, p0):
    """Return the Hertz pressure averaged over the cells."""
    inner = (np.arange(10) - 4.5) / 10 * grid.dx
    x, y = (c[:, None] + inner for c in (grid.x, grid.y))
    r2 = x[:, :, None, None] ** 2 + y[None, None] ** 2
    return p0 * np.sqrt(np.maximum(0, 1 - r2 / radius**2)).mean(axis=(1, 3))


def rms(values):
    return float(np.sqrt(np.mean(np.square(values))))


def test_a_hardened_case_with_residual_stress_agrees_with_finite_elements():
    """Agreement at 16 cells per radius; half the difference is that of finer grids."""
    case, a, cells, steps = fem.load("graded"), 1e-3, 16, 16
    z = np.linspace(0.0, 2 * a, 201)
    body = sc.Material.swift(E, NU, 700e6, 20.0, 0.1)
    body = body.with_yield_profile(z, 1 + 0.6 * np.exp(-((z / 0.5e-3) ** 2)))
    body = body.with_residual_stress(z, -400e6 * np.exp(-((z / 0.4e-3) ** 2)))
    n = 2 * int(1.4 * cells) + 1
    grid = sc.Grid(n, n, a / cells, a / cells, int(2.2 * cells), a / cells)
    pressure = hertz_pressure(grid, a, 4e9)
    sim = sc.Simulation(grid, ELASTIC, body, np.zeros((n, n)))
    for k in range(1, steps + 1):
        loaded = sim.step(pressure=pressure * k / steps)
    unloaded = sim.step(pressure=0 * pressure)
    middle, depth = (n // 2, n // 2), grid.z
    for state, table in ((loaded, case.axis_loaded), (unloaded, case.axis_unloaded)):
        rows = (depth > table["z_m"][1]) & (depth < 1.8 * a)
        scale = np.abs(table["srr_Pa"]).max()
        for c, column in ((0, "srr_Pa"), (2, "szz_Pa")):
            reference = np.interp(depth[rows], table["z_m"], table[column])
            found = state.stress()[c][middle][rows]
            assert rms(found - reference) < 3e-3 * scale, column
        reference = np.interp(depth, table["z_m"], table["gamma_p"])
        found = state.equivalent_plastic_strain()[middle]
        assert rms(found - reference) < 4e-3 * reference.max()
        assert found.max() == pytest.approx(reference.max(), rel=0.01)
        # Deeper than in a body alike all over.
        assert depth[found.argmax()] == pytest.approx(0.64 * a, abs=0.04 * a)
    centre = loaded.surface_displacement()[middle], unloaded.residual_displacement()[middle]
    assert centre[0] == pytest.approx(case.summary["uz_center_loaded_m"], rel=2e-3)
    assert centre[1] == pytest.approx(case.summary["uz_center_residual_m"], rel=0.01)


CASE = ([0.0, 0.2e-3, 0.3e-3], [3.0, 3.0, 1.0])
LAYER = ([0.0, 0.5e-3, 0.505e-3, 0.54e-3, 0.545e-3], [3.0, 3.0, 0.6, 0.6, 3.0])


@pytest.mark.parametrize("nz", [0, 6, 40])
@pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
@pytest.mark.parametrize("profile", [CASE, LAYER], ids=["case", "layer"])
def test_flow_below_a_strong_case_is_found(profile, nz):
    """Flow is found below the active box and below the layers of the grid."""
    grid = sc.Grid(41, 41, 25e-6, 25e-6, nz, 20e-6)
    body, flat = SOFT.with_yield_profile(*profile), np.zeros(grid.surface_shape)
    sim = sc.Simulation(grid, ELASTIC, body, flat)
    pressure = hertz_pressure(grid, 0.4e-3, 3.2e9)
    for part in (0.25, 0.5, 0.75, 1.0):
        state = sim.step(pressure=part * pressure)
    z = (np.arange(60) + 0.5) * 20e-6
    stress, strain = (
        getattr(state._core, name)(1, 60) for name in ("stress", "equivalent_plastic_strain")
    )
    flown = strain.max(axis=(0, 1)) > 0
    strong = np.interp(z, *profile)
    assert flown.any()
    assert not flown[strong > 2.0].any()
    assert (von_mises(stress) <= strong * SOFT.yield_stress(strain) * (1 + 2e-3)).all()


def test_a_weak_layer_between_strong_ones_flows_alone():
    grid = sc.Grid(41, 41, 25e-6, 25e-6, dz=20e-6)
    pressure, flat = hertz_pressure(grid, 0.4e-3, 2.0e9), np.zeros(grid.surface_shape)
    weak, strong = (
        sc.Simulation(grid, ELASTIC, SOFT.with_yield_profile(*profile), flat).step(
            pressure=pressure
        )
        for profile in (LAYER, ([0.0], [3.0]))
    )
    assert strong.max_equivalent_plastic_strain() == 0.0
    flown = weak.equivalent_plastic_strain().max(axis=(0, 1)) > 0
    np.testing.assert_allclose(weak.depths[flown], [0.51e-3, 0.53e-3])


def test_subdomains_of_a_rough_surface_agree_with_one_box():
    body = PERFECT.with_yield_profile([0.0, 2e-6, 6e-6], [1.3, 1.3, 0.9])
    body = body.with_residual_stress([0.0, 3e-6], [-300e6, 0.0])
    sims = [simulation(RIGID, body, zones=zones) for zones in ("auto", "one")]
    for percent in (1, 2, 0.5):
        zones, one = (sim.step(load=percent * PERCENT) for sim in sims)
        assert_few_errors(zones, one, [2], 1e-3)
    assert zone_counts(sims[0])[1] > 1 == zone_counts(sims[1])[1]
    # The stress of the start is in the zones too.
    found, expected = (
        certified_value(state, "max_residual_von_mises_body2") for state in (zones, one)
    )
    assert found == pytest.approx(expected, rel=2e-3)


def test_subdomains_of_two_balls_contain_flow_above_and_below_the_case():
    """The core yields separately from the surface."""
    grid = sc.Grid(96, 64, SIZE, SIZE, 18, SIZE)
    x, y, radius = grid.x[:, None], grid.y, 200e-6
    gap = np.minimum(
        ((x + 22e-6) ** 2 + (y + 11e-6) ** 2) / (2 * radius),
        ((x - 18e-6) ** 2 + (y - 9e-6) ** 2) / (1.6 * radius),
    )
    hard = sc.Material.linear_hardening(210e9, 0.3, 0.7e9, 20e9)
    body = hard.with_yield_profile([0.0, 8e-6, 12e-6], [2.2, 2.2, 1.0])
    sims = [simulation(RIGID, body, grid=grid, gap=gap, zones=zones) for zones in ("auto", "one")]
    for load in (0.3, 0.6, 0.05):
        zones, one = (sim.step(load=load) for sim in sims)
        assert_few_errors(zones, one, [2], 1e-3)
    flows = zones.equivalent_plastic_strain().max(axis=(0, 1)) > 0
    assert flows[[0, 9, 12]].tolist() == [True, False, True]
    assert [zone_counts(sim)[1] for sim in sims] == [2, 1]


def test_large_and_small_surfaces_yield_at_the_same_place():
    """The bound of the stress and the stress itself give equal columns."""
    z, factor = [0.0, 2e-6, 6e-6], [1.3, 1.3, 0.9]
    body = PERFECT.with_yield_profile(z, factor).with_residual_stress([0.0, 3e-6], [-300e6, 0.0])
    wide = sc.Grid(280, 280, SIZE, SIZE, LAYERS, SIZE)
    pressure = np.zeros(GRID.surface_shape)
    pressure[20:26, 20:26] = pressure[40:44, 30:38] = 3.5e9
    edge = (280 - CELLS) // 2
    states = [
        simulation(RIGID, body, grid=grid, gap=np.zeros(grid.surface_shape)).step(pressure=p)
        for grid, p in ((GRID, pressure), (wide, np.pad(pressure, edge)))
    ]
    strain, inside = states[0].equivalent_plastic_strain(), slice(edge, -edge)
    found = states[1].equivalent_plastic_strain()
    assert strain.max() > 1e-3
    assert rms(found[inside, inside] - strain) < 1e-3 * rms(strain)
    assert found.sum() == pytest.approx(strain.sum(), rel=2e-3)


BODY = SOFT.with_yield_profile(*CASE)
BODY = BODY.with_residual_stress([0.0, 0.5e-3, 0.8e-3], [-5e8, -5e8, 0.0], [-2e8, -2e8, 0.0])
BALL = sc.Grid(21, 21, 60e-6, 60e-6, 16, 50e-6)


def ball(*bodies, **options):
    return sc.Simulation(BALL, *bodies, sc.surfaces.paraboloid(BALL, 7.5e-3), **options)


def test_the_work_of_a_contact_is_dissipated_or_stored():
    """Residual energy includes the initial stress, which plastic strain releases."""
    sim = ball(RIGID, BODY, tol=1e-8)
    path = sc.paths.load_unload(load=1200.0, increments=16)
    states = [sim.state, *sim.run(path, progress=False)]
    load, approach = (np.array([getattr(s, n) for s in states]) for n in ("load", "approach"))
    work = np.sum(0.5 * (load[1:] + load[:-1]) * np.diff(approach))
    track = states[-1].track(margin=10)
    left = energy.plastic_work(BODY, track) + energy.residual_energy(track)
    released = np.sum(track.initial_stress()[:2] * track.plastic_strain()[:2])
    assert abs(released) * BALL.dx * BALL.dy * BALL.dz > 0.02 * work  # ten times what is allowed
    # Of the trapezoidal sum and of backward Euler, of second and first order in the increments.
    assert left == pytest.approx(work, rel=2e-3)


@pytest.mark.parametrize("kept", ["checkpoint", "pickle", "copy"])
def test_continuation_from_a_checkpoint_changes_no_digit(kept, tmp_path):
    sim = ball(ELASTIC, BODY)
    sim.step(load=900.0)
    if kept == "checkpoint":
        sim.save(tmp_path / "state.h5")
        again = sc.Simulation.load(tmp_path / "state.h5")
    else:
        again = pickle.loads(pickle.dumps(sim)) if kept == "pickle" else copy.deepcopy(sim)
    assert again.body2 == BODY
    assert hash(again.body2) == hash(BODY) != hash(SOFT)
    for load in (1200.0, 0.0):
        one, other = sim.step(load=load), again.step(load=load)
        np.testing.assert_array_equal(one.stress(), other.stress())
    assert one.max_equivalent_plastic_strain() > 0


def test_bodies_with_different_profiles_are_not_identical():
    """Bodies that differ only in their profile are not identical."""
    strong = SOFT.with_yield_profile([0.0], [3.0])
    both = ball(BODY, BODY).step(load=1200.0)
    np.testing.assert_array_equal(*(both.equivalent_plastic_strain(body) for body in (1, 2)))
    assert both.max_equivalent_plastic_strain(1) > 1e-4
    upper, lower = ball(BODY, strong).step(load=1200.0), ball(strong, BODY).step(load=1200.0)
    assert upper.max_equivalent_plastic_strain(2) == 0 < upper.max_equivalent_plastic_strain(1)
    np.testing.assert_allclose(
        upper.equivalent_plastic_strain(1), lower.equivalent_plastic_strain(2), rtol=1e-5, atol=1e-9
    )


def test_kinematic_hardening_includes_the_profile():
    """Purely kinematic hardening loads like isotropic hardening, at each depth."""
    kinematic = PLAIN.with_kinematic_hardening(E / 9)  # E Et/(E - Et) of Et = 0.1 E
    states = [
        pressed_evenly(body.with_yield_profile(*WEAK).with_residual_stress(*PULLED), 1.2e9)
        for body in (SOFT, kinematic)
    ]
    assert states[0].max_equivalent_plastic_strain() > 1e-4
    # The factor scales the hardening modulus of the isotropic law.
    half = PLAIN.with_kinematic_hardening(E / 18)
    weakest = pressed_evenly(half.with_yield_profile(*WEAK).with_residual_stress(*PULLED), 1.2e9)
    k = 7  # f = 0.5 but for the place of the layer's middle
    factor = np.interp((k + 0.5) * 4e-6, *WEAK)
    assert factor == pytest.approx(0.5, abs=1e-9)
    strain = [s.equivalent_plastic_strain()[0, 0, k] for s in (states[0], weakest)]
    assert strain[0] == pytest.approx(strain[1], rel=1e-6)


@pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
@pytest.mark.parametrize("hot", ["past heat", "softening"])
@pytest.mark.parametrize("nz", [0, 8])
def test_a_weak_layer_below_a_heated_surface_is_found(hot, nz):
    """Fields below the layers with past heat, and at the softened surface."""
    z, factor = [0.0, 100e-6, 105e-6, 160e-6, 165e-6], [2.0, 2.0, 0.6, 0.6, 2.0]
    body = SOFT.with_thermal(45.0, 12e-6, 12e-6).with_yield_profile(z, factor)
    body = body.with_residual_stress([0.0, 200e-6], [-3e8, 0.0])
    step, heat = {}, sc.Heat([0.0, 0.05])
    if hot == "softening":
        body = body.with_softening(sc.softening.JohnsonCook(1800.0, 1.0))
    else:
        step, heat = {"duration": 1e-3}, sc.Heat([0.0, 2e-3], history=(1e-4, 1e-2))
    grid = sc.Grid(25, 25, 30e-6, 30e-6, nz=nz, dz=15e-6)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    sim = sc.Simulation(grid, ELASTIC, body, gap, friction=0.1, heat=heat)
    for load in (60.0, 120.0, 180.0):
        state = sim.step(load=load, **step)
    depth = (np.arange(25) + 0.5) * 15e-6
    strain = state._core.equivalent_plastic_strain(1, 25)
    flown = (strain > 0).any(axis=(0, 1))
    assert strain.max() > 1e-3
    assert (np.interp(depth[flown], z, factor) < 1).all()
    # No cell is above what it bears without softening.
    limit = SOFT.yield_stress(strain) * np.interp(depth, z, factor)
    assert (von_mises(state._core.stress(1, 25)) <= limit * (1 + 1e-5)).all()
