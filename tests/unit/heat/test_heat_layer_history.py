# SPDX-License-Identifier: GPL-3.0-or-later
"""Heat history of layered bodies: pulses, equal layers, contacts, storage."""

import json
import math
from pathlib import Path

import numpy as np
import pytest

import samcontact as sc
from samcontact import _core

REFERENCE = json.loads((Path(__file__).parents[2] / "oracles" / "heat_layers.json").read_text())


def body_of(name):
    """Return a body of the reference data."""
    made = [
        sc.Material.elastic(layer["E"], layer["nu"]).with_thermal(
            *(layer[n] for n in ("conductivity", "expansion", "diffusivity"))
        )
        for layer in REFERENCE[name]["layers"]
    ]
    thickness = [layer["thickness"] for layer in REFERENCE[name]["layers"][:-1]]
    return sc.Layered(list(zip(made[:-1], thickness, strict=True)), made[-1])


def halves(material, h, k=1.0):
    """Return layers whose constants differ by rounding only: all the code of layers is used."""
    almost = material.with_thermal(k * (1 + 1e-13), *material.thermal[1:])
    return sc.Layered([(almost, h)], material)


def heating(body, time=np.inf, velocity=(0.0, 0.0), period=(0.0, 0.0)):
    layered = isinstance(body, sc.Layered)
    thermal = body.thermal if layered else [body.thermal]
    thickness = [h for _, h in body.layers] if layered else []
    return _core.Heating(1.0, thermal, thickness, *velocity, time, 1.0, False, period)


def period_of(grid):
    return tuple(
        n * d if axis in grid.periodic else 0.0
        for axis, n, d in (("x", grid.nx, grid.dx), ("y", grid.ny, grid.dy))
    )


def history(grid, body, shortest, longest, tolerance=1e-6, velocity=(0.0, 0.0)):
    return _core.operators.HeatHistory(
        grid._core, heating(body, velocity=velocity), body._core.stack, shortest, longest,
        tolerance, True,
    )  # fmt: skip


def since(grid, body, time, flux, depths, velocity=(0.0, 0.0)):
    """Return temperature, stress and displacement due to a flux that has acted for a time."""
    acting = heating(body, time, velocity, period_of(grid))
    T = _core.operators.temperature(grid._core, acting, depths, flux)
    found = []
    for at in (acting, _core.Heating()):
        stress = _core.operators.surface_stress(
            grid._core, body._core, at, depths, flux, None, None
        )
        u = _core.operators.surface_displacement(grid._core, body._core, at, flux, None, None, 2)
        found.append((stress, u))
    (hot, u), (cold, elastic) = found
    return T, hot - cold, u - elastic


def fields(past, ahead, depths):
    return past.temperature(ahead, depths), past.stress(ahead, depths), past.displacement(ahead)


def assert_superposed(body, grid, durations, depths, velocity=(0.0, 0.0)):
    """Compare a history with sums of fields of constant fluxes that were switched on and off."""
    rng = np.random.default_rng(1)
    steps = [(rng.random((grid.nx, grid.ny)), dt) for dt in durations]
    past = history(grid, body, 0.5, 1e4, velocity=velocity)
    for flux, dt in steps:
        past.add(flux, dt)
    ahead = 0.5
    expected, age = [0.0, 0.0, 0.0], ahead
    for flux, dt in reversed(steps):
        older, newer = (since(grid, body, t, flux, depths, velocity) for t in (age + dt, age))
        expected = [e + o - n for e, o, n in zip(expected, older, newer, strict=True)]
        age += dt
    for found, known in zip(fields(past, ahead, depths), expected, strict=True):
        assert np.abs(found - known).max() < 5e-6 * np.abs(known).max()


@pytest.mark.parametrize("name", ["coating", pytest.param("three layers", marks=pytest.mark.slow)])
@pytest.mark.parametrize("periodic", ["", pytest.param("x", marks=pytest.mark.slow), "xy"])
def test_a_history_is_a_sum_of_constant_fluxes(name, periodic):
    body = body_of(name)
    interface = body.interfaces[0]
    depths = [0.0, 0.4 * interface, np.nextafter(interface, 0.0), 2 * interface]
    grid = sc.Grid(12, 10, 1.0, 1.25, periodic=periodic)
    assert_superposed(body, grid, (3.0, 0.5, 60.0), depths)


@pytest.mark.parametrize(
    "velocity", [(0.8, 0.0), pytest.param((-0.3, 0.5), marks=pytest.mark.slow)]
)
def test_a_history_in_motion_is_a_sum_of_constant_fluxes(velocity):
    assert_superposed(body_of("coating"), sc.Grid(9, 6, 1.0, 1.0), (4.0,), [0.0, 1.0], velocity)


def test_heat_in_motion_for_a_time_is_between_rest_and_the_steady_state():
    body, grid = body_of("coating"), sc.Grid(9, 5, 1.0, 1.0)
    flux = np.zeros((9, 5))
    flux[3, 2] = 1.0
    for time, velocity, limit in (
        (20.0, (1e-7, -1e-7), (20.0, (0.0, 0.0))),
        (3e3, (0.0, 0.5), (np.inf, (0.0, 0.5))),
    ):
        found, known = (
            since(grid, body, *(t, flux, [0.0, 1.0], v)) for t, v in ((time, velocity), limit)
        )
        for a, b in zip(found[:2], known[:2], strict=True):
            assert np.abs(a - b).max() < 1e-5 * np.abs(b).max()
        a, b = (u - u[-1, -1] for u in (found[2], known[2]))
        assert np.abs(a - b).max() < 1e-4 * np.abs(b).max()


def test_uniform_heating_of_a_periodic_surface():
    # Expansion per heat is equal in both materials, so that u_z is proportional to the heat.
    nu, k, kappa, h, t = (0.25, 0.4), (0.3, 2.0), (0.5, 1.5), 2.0, 7.0
    made = [
        sc.Material.elastic(E, n).with_thermal(c, 0.1 * (1 - n) / (1 + n) * c / d, d)
        for E, n, c, d in zip((3.0, 1.0), nu, k, kappa, strict=True)
    ]
    body, grid = sc.Layered([(made[0], h)], made[1]), sc.Grid(6, 4, 1.0, 1.0, periodic="xy")
    effusivity = [c / np.sqrt(d) for c, d in zip(k, kappa, strict=True)]
    ratio = (effusivity[0] - effusivity[1]) / sum(effusivity)
    spread = np.sqrt(kappa[0] * t)
    images = np.arange(1, 60)
    x = images * h / spread
    erfc = np.vectorize(math.erfc)
    sum_ = (ratio**images * (np.exp(-x * x) / np.sqrt(np.pi) - x * erfc(x))).sum()
    T = 2 * spread / k[0] * (1 / np.sqrt(np.pi) + 2 * sum_)
    past = history(grid, body, t, 10 * t)
    flux = np.ones((6, 4))
    past.add(flux, 1.0)
    past.add(flux, t - 2.0)
    past.add(flux, 1.0)
    alpha = made[0].thermal[1]
    for rise, stress, u in (since(grid, body, t, flux, [0.0]),):
        assert rise == pytest.approx(np.full((6, 4, 1), T), rel=1e-7)
        assert stress[:2] == pytest.approx(np.full((2, 6, 4, 1), -3.0 * alpha / 0.75 * T), rel=2e-6)
        assert u == pytest.approx(np.full((6, 4), -0.1 * t), rel=1e-7)
    rise, _, u = fields(past, t, [0.0])
    older, newer = (since(grid, body, time, flux, [0.0]) for time in (2 * t, t))
    assert rise == pytest.approx(older[0] - newer[0], rel=1e-5)
    assert u == pytest.approx(np.full((6, 4), -0.1 * t), rel=1e-5)


def test_a_pulse_of_a_gaussian_flux_equals_hankel_integrals():
    first, last = (REFERENCE["Gaussian flux on the coating"][n] for n in (0, 2))
    pair = sorted((first, last), key=lambda known: known["t"])
    t = [known["t"] for known in pair]
    found = []
    for size in (0.3, 0.15):
        n = round(4.5 / size)
        grid = sc.Grid(2 * n + 1, 2 * n + 1, size, size)
        edges = size * (np.arange(2 * n + 2) - n - 0.5)
        mean = np.diff([np.sqrt(np.pi) / 2 * math.erf(x) for x in edges]) / size
        past = history(grid, body_of("coating"), t[0], 10 * t[1])
        past.add(np.outer(mean, mean), t[1] - t[0])
        u = past.displacement(t[0])[n, n]
        stress = past.stress(t[0], [np.nextafter(2.0, 0.0), 2.0])[:, n, n]
        found.append([past.temperature(t[0], [0.0])[n, n, 0], u, *(stress[0] + stress[1])])
    names = ["T_surface", "u_z", "s_rr_plus_s_tt_interface_above", "s_rr_plus_s_tt_interface_below"]
    expected = np.array([pair[1][name] - pair[0][name] for name in names])
    coarse, fine = np.array(found)
    assert (4 * fine - coarse) / 3 == pytest.approx(expected, rel=1e-3)


def test_equal_layers_have_the_history_of_the_homogeneous_body():
    steel = sc.Material.elastic(2.0, 0.3).with_thermal(1.0, 1.0, 1.0)
    grid, depths = sc.Grid(10, 8, 1.0, 1.0), [0.0, 1.0, 3.0]
    rng = np.random.default_rng(2)
    both = [history(grid, body, 1.0, 1e3, 1e-9) for body in (halves(steel, 1.5), steel)]
    for dt in (1.0, 20.0, 3.0):
        flux = rng.random((10, 8))
        for past in both:
            past.add(flux, dt)
    largest = [np.abs(known).max() for known in fields(both[1], 1.0, depths)]
    for ahead in (1.0, 300.0):
        found, known = (fields(past, ahead, depths) for past in both)
        for a, b, scale in zip(found, known, largest, strict=True):
            assert np.abs(a - b).max() < 1e-8 * scale


# Contacts.

GRID = sc.Grid(11, 11, 50e-6, 50e-6, nz=6, dz=40e-6)
GAP = sc.surfaces.paraboloid(GRID, 7.5e-3)
BALL = sc.Material.elastic(210e9, 0.3)
STEEL = sc.Material.linear_hardening(210e9, 0.3, 0.5e9, 10e9).with_thermal(50.2, 11.7e-6, 1.367e-5)
CERAMIC = sc.Material.elastic(380e9, 0.25).with_thermal(2.0, 7e-6, 1e-6)
COATED = sc.Layered([(CERAMIC, 80e-6)], BALL.with_thermal(*STEEL.thermal))
STEP = 1e-3


def simulated(body=COATED, **heat):
    return sc.Simulation(GRID, BALL, body, GAP, 0.3, heat=sc.Heat((0.0, 0.02), **heat))


def test_steps_of_constant_pressure_equal_one_of_the_whole_time():
    pressure = sc.hertz.point(7.5e-3, sc.hertz.effective_modulus(BALL, BALL), load=100.0).pressure(
        GRID.x[:, None], GRID.y
    )
    simulation = simulated(history=(STEP, 1.0))
    for part in (1, 3, 2):
        state = simulation.step(pressure=pressure, duration=part * STEP)
    once = simulated(time=6 * STEP).step(pressure=pressure)
    assert once.temperature().max() > 100
    for name in ("temperature", "surface_temperature", "stress", "surface_displacement"):
        found, expected = (getattr(each, name)() for each in (state, once))
        assert np.abs(found - expected).max() < 1e-5 * np.abs(expected).max()


def test_a_yielding_coated_body_cools_and_is_stored(tmp_path):
    soft = STEEL.with_softening(sc.softening.JohnsonCook(melting=1800.0, m=1.0))
    simulation = simulated(sc.Layered([(CERAMIC, 80e-6)], soft), history=(STEP, 1.0))
    for load in (40.0, 80.0):
        hot = simulation.step(load=load, duration=2 * STEP)
    assert hot.equivalent_plastic_strain().max() > 1e-4
    assert hot.softening()[..., 2:].min() < 0.99
    path = tmp_path / "state.ckpt"
    simulation.save(path)
    again = sc.Simulation.load(path, softening=(None, (None, soft.softening)))
    cool, repeated = (
        each.step(load=0.0, duration=3 * STEP, heat_factor=0.0) for each in (simulation, again)
    )
    assert 1 < cool.temperature().max() < 0.5 * hot.temperature().max()
    for name in ("temperature", "stress", "surface_displacement"):
        assert np.array_equal(getattr(cool, name)(), getattr(repeated, name)())
    # Waiting at once equals waiting in parts, and what remains is the stress of plastic strain.
    for _ in range(3):
        parts = again.step(load=0.0, duration=30 * STEP)
    whole = simulation.step(load=0.0, duration=90 * STEP)
    assert parts.temperature() == pytest.approx(
        whole.temperature(), abs=1e-6 * hot.temperature().max()
    )
    assert whole.temperature().max() < 0.03 * hot.temperature().max()


@pytest.mark.slow
def test_a_return_of_a_coated_body_equals_motion_at_once_and_waiting():
    size = GRID.dx
    heat = {"history": (STEP, 1.0), "track": 6 * size}
    runs = [simulated(**heat) for _ in range(2)]
    for run in runs:
        run.step(load=60.0, advance=(0.0, -size), duration=STEP)
        run.step(load=0.0, duration=STEP)
    away = {"load": 0.0, "advance": (0.0, size)}
    runs[0].step(**away, duration=2 * STEP)
    runs[1].step(**away, duration=0.0)
    runs[1].step(load=0.0, duration=2 * STEP)
    known, found = (run.step(load=60.0, duration=STEP) for run in runs)
    for name in ("surface_temperature", "stress", "surface_displacement"):
        a, b = (getattr(state, name)() for state in (found, known))
        assert np.abs(a - b).max() < 1e-5 * np.abs(b).max()
