# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts with steady heat of layered bodies: equal layers, interfaces, input, storage."""

import numpy as np
import pytest

import samcontact as sc

THERMAL = (50.2, 11.7e-6, 1.367e-5)
GRID = sc.Grid(16, 16, 40e-6, 40e-6, nz=8, dz=40e-6)
GAP = sc.surfaces.paraboloid(GRID, 7.5e-3)
BALL = sc.Material.elastic(210e9, 0.3)
STEEL = sc.Material.linear_hardening(210e9, 0.3, 0.5e9, 10e9)
CERAMIC = sc.Material.elastic(380e9, 0.25).with_thermal(2.0, 7e-6, 1e-6)


def halves(material):
    """Return layers whose constants differ by rounding only: all the code of layers is used."""
    k, alpha, kappa = THERMAL
    almost = material.with_thermal(k * (1 + 1e-13), alpha, kappa)
    return sc.Layered([(almost, 80e-6)], material.with_thermal(*THERMAL))


def run(body, time=None):
    heat = sc.Heat((0.0, 0.03), time=time, reference=None if time else 0.01)
    return sc.Simulation(GRID, BALL, body, GAP, 0.3, heat=heat)


def check_equal(found, expected, fields):
    for of in fields:
        known = np.asarray(of(expected))
        assert np.abs(of(found) - known).max() < 1e-8 * np.abs(known).max()


@pytest.mark.parametrize("time", [None, 2e-3])
def test_heat_in_equal_layers_at_rest_is_that_of_the_homogeneous_body(time):
    one, layered = run(STEEL.with_thermal(*THERMAL), time), run(halves(STEEL), time)
    expected, state = one.step(load=150.0), layered.step(load=150.0)
    assert expected.surface_temperature(2).max() > 90
    assert expected.equivalent_plastic_strain(2).max() > 1e-5
    check_equal(
        state,
        expected,
        (
            lambda s: s.pressure,
            lambda s: s.approach,
            lambda s: s.surface_temperature(2),
            lambda s: s.temperature(2),
            lambda s: s.surface_displacement(2),
            lambda s: s.stress(2),
            lambda s: s.equivalent_plastic_strain(2),
        ),
    )


@pytest.mark.parametrize(
    "velocity",
    [
        pytest.param((0.4, 0.0), marks=pytest.mark.slow),
        (0.0, -40.0),
        pytest.param((0.2, -0.7), marks=pytest.mark.slow),
    ],
)
def test_moving_heat_in_equal_layers_is_that_of_the_homogeneous_body(velocity):
    heat = sc.Heat((0.0, 0.03), velocity=velocity)
    solved = []
    for body in (halves(BALL), BALL.with_thermal(*THERMAL)):
        solver = sc.ContactSolver(GRID, BALL, body, friction=0.3, heat=heat)
        solution = solver.solve(GAP, load=150.0)
        solved.append((solver, solution, solution.pressure))
    check_equal(
        *solved,
        (
            lambda s: s[2],
            lambda s: s[1].approach,
            lambda s: s[0].temperature(s[2], [0.0]),
            lambda s: s[0].stress(s[2], [100e-6]),
        ),
    )


def test_tractions_and_temperature_are_continuous_at_an_interface():
    body = sc.Layered([(CERAMIC, 60e-6)], BALL.with_thermal(*THERMAL))
    solver = sc.ContactSolver(GRID, BALL, body, friction=0.3, heat=sc.Heat((0.0, 0.03)))
    solution = solver.solve(GAP, load=150.0)
    assert solution.pressure.sum() * GRID.cell_area == pytest.approx(150.0)
    z = [np.nextafter(60e-6, 0.0), 60e-6]
    stress = solver.stress(solution.pressure, z)
    largest = np.abs(stress).max()
    assert np.abs(stress[2:5, ..., 0] - stress[2:5, ..., 1]).max() < 1e-8 * largest
    assert np.abs(stress[0, ..., 0] - stress[0, ..., 1]).max() > 0.1 * largest
    T = solver.temperature(solution.pressure, z)
    assert T.max() > 10
    assert np.abs(T[..., 0] - T[..., 1]).max() < 1e-7 * T.max()
    # The poor conductor carries most of the drop of temperature.
    assert T.max() < 0.8 * solver.temperature(solution.pressure, [0.0]).max()


HARDER = sc.Material.linear_hardening(210e9, 0.3, 0.8e9, 20e9)
JOHNSON_COOK = sc.softening.JohnsonCook(melting=2500.0, m=1.0)


def test_softening_follows_the_law_of_each_layer(tmp_path):
    soft = halves(HARDER.with_softening(JOHNSON_COOK))
    expected = run(HARDER.with_thermal(*THERMAL).with_softening(JOHNSON_COOK)).step(load=150.0)
    state = run(soft).step(load=150.0)
    fields = (lambda s: s.softening(2), lambda s: s.equivalent_plastic_strain(2))
    check_equal(state, expected, fields)
    # Only the substrate softens.
    (coating, h), substrate = soft.layers[0], soft.substrate
    hard = HARDER.with_thermal(*coating.thermal)
    body = sc.Layered([(hard, h)], substrate.with_softening(lambda rise: 1 - 3e-4 * rise))
    simulation = run(body)
    simulation.step(load=100.0)
    path = tmp_path / "state.ckpt"
    simulation.save(path)
    with pytest.raises(ValueError, match="a list of laws for a layered body"):
        sc.Simulation.load(path)
    again = sc.Simulation.load(path, softening=(None, body.softening))
    state, repeated = (each.step(load=150.0) for each in (simulation, again))
    assert np.array_equal(repeated.stress(2), state.stress(2))
    assert np.array_equal(repeated.temperature(2), state.temperature(2))
    factor = state.softening(2)
    assert (factor[..., :2] == 1).all()
    # The factor is that of the first solution of the increment.
    assert factor[..., 2:] == pytest.approx(1 - 3e-4 * state.temperature(2)[..., 2:], abs=1e-3)
    assert factor.min() < 0.98


def test_a_layer_out_of_reach_of_yield_is_elastic():
    hard = sc.Material.perfect_plastic(380e9, 0.25, 1e12)
    below = BALL.with_thermal(*THERMAL)
    plastic, elastic = (
        sc.Layered([(each.with_thermal(*CERAMIC.thermal), 40e-6)], below)
        for each in (hard, sc.Material.elastic(380e9, 0.25))
    )
    found, expected = (run(body).step(load=150.0) for body in (plastic, elastic))
    fields = (lambda s: s.pressure, lambda s: s.stress(2), lambda s: s.temperature(2))
    check_equal(found, expected, fields)


@pytest.mark.parametrize(
    ("body", "heat", "message"),
    [
        (
            sc.Layered([(CERAMIC, 5e-12)], BALL.with_thermal(*THERMAL)),
            {},
            r"layers\[0\] of heated body2 must be >= 4e-10 m.* got 5e-12 m: thicknesses",
        ),
        (sc.Layered([(BALL, 1e-6)], CERAMIC), {}, r"without thermal constants of layers\[0\], got"),
        (sc.Layered([(CERAMIC, 1e-6)], sc.Material.rigid()), {}, r"whose substrate is rigid, got"),
    ],
)
def test_unsupported_heat_is_refused_by_name(body, heat, message):
    with pytest.raises(ValueError, match=message):
        sc.Simulation(GRID, BALL, body, GAP, 0.3, heat=sc.Heat((0.0, 0.03), **heat))
