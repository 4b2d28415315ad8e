# SPDX-License-Identifier: GPL-3.0-or-later
"""Viscoelastic bodies in increments: closed forms, limits, energy."""

import pickle

import numpy as np
import pytest
from scipy.optimize import brentq
from viscoelastic_setups import (
    GRID,
    LOAD,
    NU,
    PLANE,
    POLYMER,
    RADII,
    RADIUS,
    RIGID,
    SLS,
    SOFT,
    E,
    ball,
    scaled,
    simulation,
)

import samcontact as sc

pytestmark = pytest.mark.filterwarnings(
    "ignore::samcontact.ResolutionWarning", "ignore::samcontact.IncrementWarning",
    "ignore::samcontact.UnitWarning", "ignore::samcontact.ElasticStrainWarning",
)  # fmt: skip


def triangle(until, steps, largest):
    times = until * np.arange(1, steps + 1) / steps
    heights = largest * np.minimum(2 * times / until, 2 - 2 * times / until)
    return [{"approach": float(h), "duration": until / steps} for h in heights], times


def ting(terms, largest, peak, t):
    """Load of a triangular approach [N], Ting (1966), J. Appl. Mech. 33, 845."""
    tau, share = map(np.array, terms)
    rest = 1 - share.sum()

    def integral(a, b):  # of the relaxation r(t - s) over s
        return (
            rest * (b - a) + (share * tau * (np.exp(-(t - b) / tau) - np.exp(-(t - a) / tau))).sum()
        )

    start = t
    if t > peak:
        found = [integral(s, peak) - integral(peak, t) for s in (0.0, peak)]
        if found[0] <= 0:
            return 0.0
        start = brentq(lambda s: integral(s, peak) - integral(peak, t), 0.0, peak)
    x, w = np.polynomial.legendre.leggauss(60)
    v = (x + 1) / 2 * np.sqrt(start)
    r = rest + (share * np.exp(-(t - v[:, None] ** 2) / tau)).sum(axis=1)
    rise = (largest / peak) ** 1.5 * 1.5 * np.sqrt(start) / 2 * np.sum(w * r * 2 * v**2)
    return 4 / 3 * PLANE * np.sqrt(RADIUS) * rise


def test_a_triangular_approach_agrees_with_ting():
    largest = 2 * RADII**2 / RADIUS
    grid = sc.Grid(48, 48, 4.4 * RADII / 48, 4.4 * RADII / 48)
    path, times = triangle(2.0, 40, largest)
    states = simulation(SLS, grid=grid).run(path, progress=False)
    loads = np.array([s.load for s in states])
    exact = np.array([ting(SLS.relaxation_terms, largest, 1.0, t) for t in times])
    assert np.abs(loads - exact).max() < 1e-3 * exact.max()
    np.testing.assert_allclose([s.time for s in states], times, rtol=1e-14)


def test_the_error_is_of_second_order_in_the_steps():
    largest = 2 * RADII**2 / RADIUS
    grid = sc.Grid(24, 24, 4.4 * RADII / 24, 4.4 * RADII / 24)
    ends = []
    for steps in (8, 16, 128):
        path, _ = triangle(2.0, steps, largest)
        ends.append(simulation(POLYMER, grid=grid).run(path[: steps // 2], progress=False)[-1].load)
    coarse, fine = np.abs(np.array(ends[:2]) - ends[2])
    assert 3.2 < coarse / fine < 5.0


@pytest.mark.parametrize("bodies", [(RIGID, SLS), (SLS, SOFT.with_relaxation([20.0], [0.6]))])
def test_creep_under_a_step_load_agrees_with_lee_and_radok(bodies):
    """The power 3/2 of the approach grows as the sum of the creep functions of both bodies."""
    body1, body2 = bodies
    steps = sc.paths.creep(0.2 * LOAD, until=30.0, per_decade=12, first=0.02)
    states = simulation(body2, body1).run(steps, progress=False)
    parts = [(1 - b.nu**2) / b.E * b.creep([s.time for s in states]) for b in bodies if b != RIGID]
    expected = (sum(parts) / sum(part[0] for part in parts)) ** (2 / 3)
    found = np.array([s.approach for s in states]) / states[0].approach
    np.testing.assert_allclose(found, expected, rtol=6e-3)
    assert np.all(np.diff(found) > 0)


def test_a_wave_in_full_contact_relaxes_without_loss_over_20_decades():
    """The equivalent pressure is constant, so that the pressure follows the modulus."""
    times = np.logspace(-10, 9, 20)
    shares = np.geomspace(1.0, 1e-3, 20)
    shares *= (1 - 1e-4) / shares.sum()
    body = SOFT.with_relaxation(times, shares)
    grid = sc.Grid(16, 2, 1e-3 / 16, 1e-3 / 16, periodic="xy")
    height = 1e-6 * np.cos(2 * np.pi * grid.x / 1e-3)[:, None] * np.ones((1, 2))
    sim = sc.Simulation(grid, RIGID, body, height, tol=1e-9)
    load = 2 * np.pi * PLANE * 1e-6 / 1e-3 * 1e-3 * 1.25e-4
    states = sim.run(sc.paths.creep(load, 1e11, per_decade=1, first=1e-12), progress=False)
    swing = [np.ptp(s.pressure) for s in states]
    expected = body.relaxation(np.array([s.time for s in states]))
    np.testing.assert_allclose(swing / swing[0], expected, atol=1e-9, rtol=1e-6)


def test_steps_longer_than_the_relaxation_do_not_ring():
    body = SOFT.with_relaxation([1.0], [0.999])
    sim = simulation(body)
    depth = RADII**2 / RADIUS
    loads = [sim.step(approach=depth, duration=10.0).load for _ in range(6)]
    first = 4 / 3 * PLANE * np.sqrt(RADIUS) * depth**1.5
    assert np.all(np.diff(loads) <= 1e-9 * first)
    np.testing.assert_allclose(np.array(loads[1:]) / first, 1e-3, rtol=0.05)


def test_a_body_that_hardly_relaxes_is_elastic():
    body = SOFT.with_relaxation([1.0, 10.0], [1e-15, 1e-15])
    for path in ([LOAD, 0.3 * LOAD, 0.0, 0.5 * LOAD],):
        found, elastic = simulation(body), simulation(SOFT)
        for load in path:
            one = found.step(load=load, duration=3.0)
            two = elastic.step(load=load)
            np.testing.assert_allclose(
                one.pressure, two.pressure, atol=1e-12 * (1.0 + two.pressure.max())
            )
            assert one.approach == pytest.approx(two.approach, rel=1e-12, abs=1e-20)


HISTORY = [
    {"load": 0.2 * LOAD, "duration": 0.3}, {"load": 0.05 * LOAD, "duration": 2.0},
    {"approach": 1.5e-5, "duration": 0.0}, {"load": 0.1 * LOAD, "duration": 30.0},
]  # fmt: skip


@pytest.mark.parametrize("friction", [0.0, 0.4])
def test_the_relaxed_state_is_elastic_with_long_time_moduli(friction):
    bodies = SOFT.with_relaxation([0.5, 50.0], [0.3, 0.4]), POLYMER
    sim = simulation(bodies[1], bodies[0], friction=friction)
    sim.run(HISTORY, progress=False)
    relaxed = sim.relax()
    others = scaled(SOFT, 0.1), scaled(SOFT, 0.3)
    elastic = simulation(*others, friction=friction).step(load=HISTORY[-1]["load"])
    peak = elastic.pressure.max()
    np.testing.assert_allclose(relaxed.pressure, elastic.pressure, atol=1e-8 * peak)
    assert relaxed.approach == pytest.approx(elastic.approach, rel=1e-8)
    np.testing.assert_allclose(relaxed.gap, elastic.gap, atol=1e-8 * elastic.gap.max())
    assert sim.relax("approach").load == pytest.approx(relaxed.load, rel=1e-7)


def test_layers_that_share_one_relaxation():
    stiff = sc.Material.elastic(5 * E, 0.3)
    terms = [2.0], [0.75]
    coated = sc.Layered(
        [(stiff.with_relaxation(*terms), 2e-4)], SOFT.with_relaxation(*terms)
    )  # fmt: skip
    sim = simulation(coated, sc.Material.elastic(3 * E, 0.2))
    sim.step(load=0.1 * LOAD, duration=0.7)
    relaxed = sim.step(load=0.2 * LOAD, duration=200.0)
    relaxed = sim.relax()
    long_time = sc.Layered([(scaled(stiff, 0.25), 2e-4)], scaled(SOFT, 0.25))
    elastic = simulation(long_time, sc.Material.elastic(3 * E, 0.2)).step(load=0.2 * LOAD)
    np.testing.assert_allclose(
        relaxed.pressure, elastic.pressure, atol=1e-8 * elastic.pressure.max()
    )
    with pytest.raises(ValueError, match="must have one relaxation"):
        sc.Layered([(stiff.with_relaxation([1.0], [0.75]), 2e-4)], SOFT.with_relaxation(*terms))


def test_the_print_recovers_and_is_the_gap_of_equivalent_pressure():
    sim = simulation(POLYMER)
    sim.step(load=LOAD, duration=1.0)
    loaded = sim.step(load=LOAD, duration=1.0)
    free = sim.step(load=0.0, duration=0.0)
    excess = free.equivalent_pressure()
    np.testing.assert_allclose(
        excess, loaded.equivalent_pressure() - loaded.pressure, atol=1e-9 * excess.max()
    )
    solver = sc.ContactSolver(GRID, RIGID, SOFT, on_border="warn")
    elastic = solver.displacement(excess, None, 2)[2]
    np.testing.assert_allclose(free.residual_displacement(), elastic, rtol=1e-9)
    np.testing.assert_allclose(loaded.residual_displacement(), elastic, atol=1e-9 * elastic.max())
    depths = [elastic.max()]
    for duration in (0.1, 1.0, 10.0, 100.0, 1e4, 1e7):
        depths.append(sim.step(load=0.0, duration=duration).residual_displacement().max())
    assert np.all(np.diff(depths) < 0)
    assert depths[-1] < 1e-5 * depths[0]


def test_stress_follows_the_present_pressure():
    grid = sc.Grid(20, 18, 3.2 * RADII / 20, 3.2 * RADII / 18, dz=RADII / 10)
    sim = simulation(POLYMER, grid=grid)
    sim.step(load=LOAD, duration=1.0)
    state = sim.step(load=0.5 * LOAD, duration=5.0)
    solver = sc.ContactSolver(grid, RIGID, SOFT, on_border="warn")
    expected = solver.stress(state.pressure, state.depths, 2)
    np.testing.assert_allclose(state.stress(), expected, atol=1e-9 * np.abs(expected).max())


def random_path(seed, steps=12):
    rng = np.random.default_rng(seed)
    path = []
    for _ in range(steps):
        drive = "load" if rng.random() < 0.6 else "approach"
        largest = 0.8 * LOAD if drive == "load" else 1.5 * RADII**2 / RADIUS
        value = largest * rng.choice([0.0, rng.random(), 1.0])
        path.append(
            {drive: value, "duration": float(rng.choice([0.0, 10.0 ** rng.uniform(-6, 6)]))}
        )
    return path


def random_body(rng):
    terms = rng.integers(1, 6)
    shares = rng.dirichlet(np.ones(terms + 1))[:terms] * rng.choice([0.5, 1.0, 0.999])
    return SOFT.with_relaxation(10.0 ** rng.uniform(-4, 4, terms), shares)


@pytest.mark.filterwarnings(
    "ignore::samcontact.GridTooSmallWarning", "ignore::samcontact.SingularPressureWarning"
)
@pytest.mark.parametrize("seeds", [range(20), pytest.param(range(500), marks=pytest.mark.slow)])
def test_random_histories(seeds):
    """No negative pressure, and viscous work that never decreases."""
    grid = sc.Grid(14, 12, 5 * RADII / 14, 5 * RADII / 12)
    for seed in seeds:
        rng = np.random.default_rng(1000 + seed)
        body1 = RIGID if rng.random() < 0.5 else random_body(rng)
        sim = simulation(random_body(rng), body1, grid, friction=0.3 * (rng.random() < 0.3))
        before, largest = [0.0, 0.0], 0.0
        for step in random_path(seed):
            state = sim.step(**step)
            assert np.isfinite(state.pressure).all()
            assert state.pressure.min() >= 0
            for body in (1, 2):
                now = state.viscous_work(body)
                largest = max(largest, state.stored_energy(body) + now)
                assert now >= before[body - 1] - 1e-9 * largest
                before[body - 1] = now


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_the_energy_balance_closes_with_viscous_work(friction):
    imbalance = []
    for steps in (20, 40):
        path, _ = triangle(2.0, steps, RADII**2 / RADIUS)
        other = sc.Material.elastic(2 * E, 0.2)
        sim = simulation(POLYMER, other, friction=friction, tol=1e-8)
        states = sim.run(path[:-1], progress=False)
        balance = sc.energy.balance(sim, states)
        assert balance.viscous_work > 0.1 * balance.work_input
        imbalance.append(abs(balance.imbalance))
    assert imbalance[1] < 2e-3


def test_work_of_an_oscillation_follows_from_the_loss_modulus():
    """Steady loop under an oscillating pressure, from the complex compliance."""
    omega = 2 * np.pi * 0.05
    grid = sc.Grid(30, 28, 3.2 * RADII / 30, 3.2 * RADII / 28)
    sim = simulation(SLS, grid=grid)
    shape = np.where((grid.x[:, None] ** 2 + grid.y**2) < RADII**2, 1.0, 0.0)
    steps, cycles = 60, 4
    sim.step(pressure=1e5 * shape, duration=1e7)
    work = []
    for n in range(1, cycles * steps + 1):
        pressure = 1e5 * shape * (1 + np.sin(2 * np.pi * n / steps))
        state = sim.step(pressure=pressure, duration=2 * np.pi / omega / steps)
        if n % steps == 0:
            work.append(state.viscous_work())
    # complex compliance 1/r
    r = complex(SLS.storage(omega), SLS.loss(omega)) / E
    solver = sc.ContactSolver(grid, RIGID, SOFT, on_border="warn")
    u = solver.displacement(1e5 * shape, None, 2)[2]
    per_cycle = -np.pi * (1 / r).imag * np.sum(1e5 * shape * u) * grid.cell_area
    assert work[-1] - work[-2] == pytest.approx(per_cycle, rel=5e-3)


def test_a_restart_is_bit_identical(tmp_path):
    sim = simulation(POLYMER, SLS, friction=0.2)
    sim.run(HISTORY[:2], progress=False)
    sim.save(tmp_path / "sim.h5")
    copies = sc.Simulation.load(tmp_path / "sim.h5"), pickle.loads(pickle.dumps(sim))
    ends = [s.run(HISTORY[2:], progress=False)[-1] for s in (sim, *copies)]
    for other in ends[1:]:
        assert np.array_equal(other.pressure, ends[0].pressure)
        assert np.array_equal(other.equivalent_pressure(1), ends[0].equivalent_pressure(1))
        assert other.time == ends[0].time
        assert other.viscous_work() == ends[0].viscous_work()
    assert sc.Simulation.load(tmp_path / "sim.h5").body2 == POLYMER


def test_an_enlarged_grid_keeps_the_memory():
    wide = simulation(POLYMER, grid=sc.Grid(48, 48, GRID.dx, GRID.dy), on_border="error")
    small = sc.Simulation(sc.Grid(16, 16, GRID.dx, GRID.dy), RIGID, POLYMER, ball, tol=1e-9)
    path = [{"load": 1e-3 * LOAD, "duration": 0.5}, {"load": 0.3 * LOAD, "duration": 0.5}]
    one, two = (sim.run(path, progress=False)[-1] for sim in (wide, small))
    assert small.grid.nx > 16
    assert two.approach == pytest.approx(one.approach, rel=1e-8)


def test_units_do_not_matter():
    """Millimetres, megapascals and milliseconds give the same digits as SI units."""
    fine = sc.Grid(GRID.nx, GRID.ny, 1e3 * GRID.dx, 1e3 * GRID.dy)
    body = sc.Material.elastic(1e-6 * E, NU).with_relaxation([1e3], [0.9])
    gap = sc.surfaces.paraboloid(fine, 1e3 * RADIUS)
    other = sc.Simulation(fine, RIGID, body, gap, on_border="warn", tol=1e-9)
    sim = simulation(SLS)
    for load, duration in ((0.1 * LOAD, 0.3), (0.3 * LOAD, 2.0)):
        one = sim.step(load=load, duration=duration)
        two = other.step(load=load, duration=1e3 * duration)
    np.testing.assert_allclose(1e6 * two.pressure, one.pressure, atol=1e-8 * one.pressure.max())


def test_a_plastic_body_against_a_viscoelastic_one():
    """Plastic flow of one body and relaxation of the other are solved together."""
    grid = sc.Grid(24, 24, 4 * RADII / 24, 4 * RADII / 24, dz=RADII / 10)
    metal = sc.Material.perfect_plastic(3 * E, 0.3, 0.012 * E)
    sim = simulation(POLYMER, metal, grid, tol=1e-7)
    states = [sim.step(load=0.35 * LOAD * n, duration=0.1) for n in (1, 2, 3)]
    assert states[-1].max_equivalent_plastic_strain(1) > 1e-3
    balance = sc.energy.balance(sim, states)
    assert balance.plastic_work > 0
    assert balance.viscous_work > 0
    assert abs(balance.imbalance) < 0.02
    hard = sc.Material.perfect_plastic(3 * E, 0.3, 1e3 * E)
    pair = [simulation(POLYMER, body, grid) for body in (hard, sc.Material.elastic(3 * E, 0.3))]
    one, two = (sim.step(load=LOAD, duration=0.2) for sim in pair)
    np.testing.assert_allclose(one.pressure, two.pressure, atol=1e-8 * two.pressure.max())


def test_refusals():
    sim = simulation(SLS)
    with pytest.raises(ValueError, match="duration is required because a body is viscoelastic"):
        sim.step(load=1.0)
    with pytest.raises(ValueError, match="duration must be a finite number >= 0"):
        sim.step(load=1.0, duration=-1.0)
    with pytest.raises(ValueError, match="a fluid flows without limit"):
        simulation(SOFT.with_relaxation([1.0], [1.0])).relax()
    with pytest.raises(ValueError, match="relax requires a viscoelastic body"):
        simulation(SOFT).relax()
    with pytest.raises(ValueError, match="body2 must not be viscoelastic, got 1 relaxation time"):
        sc.ContactSolver(GRID, RIGID, SLS)
    with pytest.raises(ValueError, match="duration has no effect without"):
        simulation(SOFT).step(load=1.0, duration=1.0)
