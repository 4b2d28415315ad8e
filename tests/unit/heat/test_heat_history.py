# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields of past heat against superposition in time of tables for one heated cell."""

import numpy as np
import pytest
from scipy.signal import fftconvolve

import samcontact as sc
from samcontact import _core

E, NU, K, ALPHA, KAPPA = 210e9, 0.3, 50.0, 1.2e-5, 1.4e-5
DX = 20e-6
UNIT = DX**2 / KAPPA  # the time in which heat crosses a cell
DEPTHS = [0.0, 0.5 * DX, 3 * DX, 10 * DX]


def grid_of(nx=16, ny=12, dx=DX, dy=1.25 * DX):
    return sc.Grid(nx=nx, ny=ny, dx=dx, dy=dy)


def history(grid, shortest=UNIT, longest=1e4 * UNIT, tolerance=1e-6, in_depth=True, **other):
    speed = other.get("speed", (0.0, 0.0))
    heating = _core.Heating(
        1.0,
        [(other.get("k", K), ALPHA, other.get("kappa", KAPPA))],
        [],
        *speed,
        np.inf,
        1.0,
        False,
    )
    elastic = _core.Stack(_core.Elastic.isotropic(other.get("E", E), NU))
    return _core.operators.HeatHistory(
        grid._core, heating, elastic, shortest, longest, tolerance, in_depth
    )


class Superposition:
    def __init__(self, grid, speed=(0.0, 0.0)):
        self.x = np.arange(-(grid.nx - 1), grid.nx) * grid.dx
        self.y = np.arange(-(grid.ny - 1), grid.ny) * grid.dy
        self.cell = grid.dx / 2, grid.dy / 2
        self.speed = speed[0] / KAPPA, speed[1] / KAPPA
        self.tables = {}

    def table(self, what, age, z):
        key = what, age, z
        if age == 0:
            return np.zeros((6 if what == "stress" else 1, self.x.size, self.y.size))
        if key not in self.tables:
            tail = KAPPA * age, self.speed, 1e-9
            k, at = _core.kernels, (self.x, self.y)
            if what == "temperature":
                table = k.heat_temperature(*at, z, *self.cell, *tail) / K
            elif what == "displacement":
                table = k.heat_displacement(*at, *self.cell, *tail) * ALPHA * (1 + NU) / K
            else:
                table = k.heat_stress(*at, z, *self.cell, NU, *tail) * E * ALPHA / (1 - NU) / K
            self.tables[key] = table
        return self.tables[key]

    def __call__(self, what, steps, ahead, z=0.0):
        """Return the field, component first; steps = [(flux, dt), ...] end at the present time."""
        age, field = ahead, 0.0
        for flux, dt in reversed(steps):
            influence = self.table(what, age + dt, z) - self.table(what, age, z)
            field = field + np.array([fftconvolve(t, flux, mode="valid") for t in influence])
            age += dt
        return field


def random_steps(grid, durations, seed=1):
    rng = np.random.default_rng(seed)
    return [(rng.random((grid.nx, grid.ny)), dt) for dt in durations]


def feed(past, steps):
    for flux, dt in steps:
        past.add(flux, dt)
    return past


def worst_errors(past, reference, steps, ahead, depths):
    """Errors of temperature, displacement and stress, relative to their maxima."""
    expected = [reference("temperature", steps, ahead, z)[0] for z in depths]
    error = np.abs(past.temperature(ahead, depths) - np.stack(expected, axis=-1)).max()
    errors = [error / np.abs(expected).max()]
    u = reference("displacement", steps, ahead)[0]
    errors.append(np.abs(past.displacement(ahead) - u).max() / np.abs(u).max())
    expected = np.stack([reference("stress", steps, ahead, z) for z in depths], axis=-1)
    got = past.stress(ahead, depths)
    errors.append(np.abs(got - expected).max() / np.abs(expected).max())
    return errors


@pytest.mark.parametrize("shortest", [0.01, 0.1, 1.0, 30.0, 1000.0])
def test_matches_superposition(shortest):
    grid = grid_of()
    dt = shortest * UNIT
    steps = random_steps(grid, [3 * dt, 0.3 * dt, dt, 2 * dt])
    past = feed(history(grid, dt, 1e3 * dt), steps)
    reference = Superposition(grid)
    assert max(worst_errors(past, reference, steps, dt, DEPTHS)) < 5e-6
    assert max(worst_errors(past, reference, steps, 7 * dt, DEPTHS[:2])) < 5e-6


@pytest.mark.parametrize("shortest", [0.05, 1.0, 100.0])
@pytest.mark.parametrize(("nx", "ny", "dy"), [(32, 4, 1.0), (3, 10, 4.0), (12, 12, 0.3)])
def test_elongated_grids_and_cells(nx, ny, dy, shortest):
    grid = grid_of(nx, ny, dy=dy * DX)
    dt = shortest * UNIT
    steps = random_steps(grid, [dt, 3 * dt])
    past = feed(history(grid, dt, 1e3 * dt), steps)
    assert max(worst_errors(past, Superposition(grid), steps, dt, DEPTHS[:3])) < 5e-6


def test_flux_newer_than_the_shortest_time_uses_tables():
    grid = grid_of()
    steps = random_steps(grid, [2 * UNIT, UNIT])
    past = feed(history(grid), steps)
    reference = Superposition(grid)
    for ahead in (0.0, 0.1 * UNIT):
        assert max(worst_errors(past, reference, steps, ahead, DEPTHS[:2])) < 5e-6


@pytest.mark.parametrize(
    ("peclet", "durations"),
    [((1.0, 0.0), [3, 0.3, 1, 2]), ((4.0, 3.0), [9, 1, 4, 1, 6, 2]), ((0.0, -5.0), [40, 1, 1])],
)
def test_moving_body(peclet, durations):
    """Heat carried several grid lengths away does not return by periodicity."""
    grid = grid_of(12, 10, dy=DX)
    speed = peclet[0] * KAPPA / DX, peclet[1] * KAPPA / DX
    steps = random_steps(grid, [UNIT * d for d in durations])
    past = feed(history(grid, speed=speed), steps)
    errors = worst_errors(past, Superposition(grid, speed), steps, UNIT, DEPTHS[:3])
    assert max(errors) < 5e-6


def test_a_moving_body_loses_heat_independently_of_the_steps():
    grid = grid_of(12, 10, dy=DX)
    speed = (5 * KAPPA / DX, KAPPA / DX)
    flux = random_steps(grid, [UNIT])[0][0]
    once = feed(history(grid, speed=speed), [(flux, 200 * UNIT)])
    often = feed(history(grid, speed=speed), [(flux, 5 * UNIT)] * 40)
    for name in ("temperature", "stress"):
        a, b = (getattr(past, name)(UNIT, DEPTHS) for past in (once, often))
        np.testing.assert_allclose(a, b, rtol=0, atol=1e-6 * np.abs(b).max())


def test_tends_to_the_steady_state():
    grid = grid_of(dy=DX)
    flux = random_steps(grid, [1.0])[0][0]
    past = history(grid, longest=1e9 * UNIT)
    dt = UNIT
    for _ in range(30):
        past.add(flux, dt)
        dt *= 2
    steady = _core.Heating(1.0, [(K, ALPHA, KAPPA)], [], 0.0, 0.0, np.inf, 1.0, False)
    body = sc.Material.elastic(E, NU)._core
    zero = np.zeros_like(flux)
    expected = _core.operators.temperature(grid._core, steady, DEPTHS, flux)
    got = past.temperature(0.0, DEPTHS)
    assert np.abs(got - expected).max() < 1e-4 * expected.max()
    both, alone = (
        _core.operators.surface_stress(grid._core, body, heating, DEPTHS, flux, None, None)
        for heating in (steady, _core.Heating())
    )
    expected = both - alone
    assert np.abs(past.stress(0.0, DEPTHS) - expected).max() < 1e-4 * np.abs(expected).max()
    # The displacement has a steady shape, but its level decreases without limit.
    x, y = Superposition(grid).x, Superposition(grid).y
    corner = np.meshgrid(x, y, indexing="ij")
    table = _core.kernels.steady_heat_displacement(
        corner[0].ravel(), corner[1].ravel(), DX / 2, DX / 2, 1.0
    ).reshape(x.size, y.size)
    shape = ALPHA * (1 + NU) / K * fftconvolve(table, flux, mode="valid")
    difference = past.displacement(0.0) - shape
    assert np.ptp(difference) < 1e-4 * np.ptp(shape)
    past.add(zero, 1e3 * dt)
    assert past.temperature(UNIT, [0.0]).max() < 1e-4 * got.max()


def test_cooling_does_not_drift():
    """Cooling obeys the law of an instantaneous source, T ~ t^-3/2, without a remainder."""
    grid = grid_of()
    past = feed(history(grid, longest=1e8 * UNIT), random_steps(grid, [UNIT] * 3))
    times = UNIT * 10.0 ** np.arange(4, 9)
    hottest = [past.temperature(t, [0.0]).max() for t in times]
    np.testing.assert_allclose(
        np.array(hottest) * times**1.5, hottest[0] * times[0] ** 1.5, rtol=1e-2
    )
    lifted = np.array([np.abs(past.displacement(t)).max() for t in times])
    np.testing.assert_allclose(lifted * times, lifted[0] * times[0], rtol=1e-2)


def test_a_step_may_be_split_and_steps_may_change():
    grid = grid_of()
    (flux, _), (last, _) = random_steps(grid, [1, 1])
    whole = feed(history(grid), [(flux, 5 * UNIT), (last, UNIT)])
    parts = feed(history(grid), [(flux, 4.5 * UNIT), (flux, 0.5 * UNIT), (last, UNIT)])
    a, b = whole.stress(UNIT, DEPTHS), parts.stress(UNIT, DEPTHS)
    np.testing.assert_allclose(a, b, rtol=0, atol=1e-11 * np.abs(a).max())
    np.testing.assert_allclose(
        whole.displacement(UNIT), parts.displacement(UNIT), rtol=1e-11, atol=0
    )
    # No time and no heat change nothing.
    before = whole.displacement(2 * UNIT)
    whole.add(last, 0.0)
    np.testing.assert_array_equal(whole.displacement(2 * UNIT), before)
    whole.add(np.zeros_like(last), UNIT)
    np.testing.assert_allclose(whole.displacement(UNIT), before, rtol=1e-11)


@pytest.mark.parametrize(
    ("shortest", "speed"),
    [
        (0.1, (3.0, 1.0)),
        (1.0, (0.0, 0.0)),
        pytest.param(0.1, (0.0, 0.0), marks=pytest.mark.slow),
        pytest.param(1.0, (3.0, 1.0), marks=pytest.mark.slow),
    ],
)
def test_a_restored_state_continues_with_identical_bits(shortest, speed):
    grid = grid_of(8, 8, dy=DX)
    speed = tuple(v * KAPPA / DX for v in speed)
    steps = random_steps(grid, [UNIT * d for d in (1, 2, 9, 1, 3)])
    first = feed(history(grid, shortest * UNIT, speed=speed), steps[:3])
    second = history(grid, shortest * UNIT, speed=speed)
    second.set_state(first.state())
    copied = first.copy()
    for past in (first, second, copied):
        feed(past, steps[3:])
    for other in (second, copied):
        np.testing.assert_array_equal(first.state(), other.state())
        for ahead in (0.0, UNIT):
            np.testing.assert_array_equal(first.stress(ahead, [DX]), other.stress(ahead, [DX]))
            np.testing.assert_array_equal(first.displacement(ahead), other.displacement(ahead))
    with pytest.raises(ValueError, match="number of values in the heat state must be"):
        second.set_state(first.state()[1:])


def test_memory_does_not_grow():
    grid = grid_of(8, 8)
    past = history(grid)
    size = past.size, past.state().size
    feed(past, random_steps(grid, [UNIT] * 50))
    assert (past.size, past.state().size) == size


def test_without_depth_the_surface_is_the_same():
    grid = grid_of()
    steps = random_steps(grid, [UNIT, 2 * UNIT])
    deep, flat = (feed(history(grid, in_depth=d), steps) for d in (True, False))
    assert flat.size < 0.6 * deep.size
    for name in ("temperature", "stress"):
        a, b = (getattr(past, name)(UNIT, [0.0]) for past in (deep, flat))
        np.testing.assert_allclose(a, b, rtol=0, atol=2e-6 * np.abs(a).max())
    with pytest.raises(ValueError, match="depth"):
        flat.temperature(UNIT, [DX])


@pytest.mark.parametrize("speed", [(0.0, 0.0), (1.0, 2.0)])
def test_no_traction_at_the_surface(speed):
    grid = grid_of(8, 8)
    speed = tuple(v * KAPPA / DX for v in speed)
    past = feed(history(grid, speed=speed), random_steps(grid, [UNIT, UNIT]))
    stress = past.stress(UNIT, [0.0, 1e-3 * DX])
    assert not stress[2:5, :, :, 0].any()
    assert np.abs(stress[2:5, :, :, 1]).max() < 3e-3 * np.abs(stress).max()


def test_results_are_independent_of_units():
    """Results in millimetres and milliseconds agree with SI units."""
    a, b = grid_of(), grid_of(dx=1e3 * DX, dy=1.25e3 * DX)
    steps = random_steps(a, [UNIT, 2 * UNIT])
    metres = feed(history(a), steps)
    # W/mm^2, W/(mm K), mm^2/ms, N/mm^2.
    other = history(b, 1e3 * UNIT, 1e7 * UNIT, k=K * 1e-3, kappa=KAPPA * 1e3, E=E * 1e-6)
    for flux, dt in steps:
        other.add(1e-6 * flux, 1e3 * dt)
    depths = [1e3 * z for z in DEPTHS]
    pairs = [
        (metres.temperature(UNIT, DEPTHS), other.temperature(1e3 * UNIT, depths)),
        (metres.displacement(UNIT), 1e-3 * other.displacement(1e3 * UNIT)),
        (metres.stress(UNIT, DEPTHS), 1e6 * other.stress(1e3 * UNIT, depths)),
    ]
    for p, q in pairs:
        np.testing.assert_allclose(p, q, rtol=0, atol=1e-11 * np.abs(p).max())


@pytest.mark.parametrize(
    "change", [{"shortest": 0.0}, {"longest": 0.1 * UNIT}, {"tolerance": 0.1}, {"tolerance": 0.0}]
)
def test_settings_are_checked(change):
    with pytest.raises(ValueError, match=next(iter(change))):
        history(grid_of(4, 4), **change)


def test_arguments_are_checked():
    grid = grid_of(4, 4)
    past = history(grid)
    with pytest.raises(ValueError, match="dt"):
        past.add(np.zeros((4, 4)), -1.0)
    with pytest.raises(ValueError, match="ahead"):
        past.displacement(-1.0)
    with pytest.raises(ValueError, match="depth"):
        past.temperature(UNIT, [-DX])
