# SPDX-License-Identifier: GPL-3.0-or-later
"""Response to repeated cycles against shakedown limits, with and without extrapolation."""

import dataclasses
import pickle

import numpy as np
import pytest

import samcontact as sc
from samcontact import shakedown
from samcontact._util.tensors import von_mises
from samcontact.shakedown.jumps import Trend

E, NU, K, WIDTH = 210e9, 0.3, 50e6, 1e-4
STEEL = sc.Material.elastic(E, NU)
SOFT = sc.Material.perfect_plastic(E, NU, np.sqrt(3.0) * K)


def rollers(ratio, body=SOFT, friction=0.0, cells=10):
    """Return a train of rollers with p0/k = ratio, 6 half-widths apart, and one pass."""
    grid = sc.Grid(6 * cells, 1, WIDTH / cells, 1e-3, nz=3 * cells, dz=WIDTH / cells, periodic="xy")
    E_star = sc.hertz.effective_modulus(STEEL, body)
    contact = sc.hertz.line(0.5 * WIDTH * E_star / (ratio * K), E_star, p0=ratio * K)
    simulation = sc.Simulation(
        grid, STEEL, body, np.zeros(grid.surface_shape), friction, residual_stress="fast"
    )
    pressure = contact.pressure(grid.x)[:, None]
    return simulation, shakedown.passes(grid, pressure, cells=2)


def repeated(*arguments, cells=10, friction=0.0, **settings):
    simulation, cycle = rollers(*arguments, cells=cells, friction=friction)
    return shakedown.run(simulation, cycle, progress=False, **settings)


@pytest.fixture(scope="module")
def ratcheting():
    """Return a simulation of rollers that ratchet with friction, its result, and its cycle."""
    simulation, cycle = rollers(3.4, friction=0.2, cells=6)
    return simulation, shakedown.run(simulation, cycle, progress=False), cycle


GRIDS = [10, pytest.param(20, marks=pytest.mark.slow)]


@pytest.mark.parametrize("cells", GRIDS)
def test_rollers_below_the_limit_stop_straining(cells):
    """Melan's limit is 4 k on any grid that resolves the subsurface shear."""
    result = repeated(3.9, cells=cells)
    assert result.response == "elastic shakedown"
    assert result.shakes_down
    assert result.flow <= 1e-3 * result.yield_strain
    assert result.cycles[0].flow > 0.5 * result.yield_strain
    # Melan's proof: with what is left, the elastic stress of the passage is nowhere beyond yield.
    grid, pressure = result.state.grid, result.state.pressure
    elastic = sc.ContactSolver(grid, STEEL, SOFT).stress(pressure, z=result.state.depths)
    residual = result.residual_stress()
    assert np.abs(residual).max() > 0.3 * K
    for cells in range(0, grid.nx, 2):
        total = von_mises(np.roll(elastic, cells, axis=1) + residual)
        assert total.max() < 1.002 * np.sqrt(3.0) * K


@pytest.mark.parametrize("cells", GRIDS)
def test_rollers_above_the_limit_ratchet(cells):
    result = repeated(4.1, cells=cells)
    assert result.response == "ratcheting"
    assert not result.shakes_down
    assert result.rate > 0.01 * result.yield_strain
    # It is shear of layers over each other, which leaves no residual stress.
    added = result.strain_per_cycle()
    assert np.abs(added[4]).max() > 3.0 * np.abs(added[[0, 1, 2]]).max()
    assert len(result.cycles) < result.cycles[-1].number - 10


@pytest.mark.filterwarnings("ignore::samcontact.PlasticStrainWarning")
def test_kinematic_hardening_prevents_ratcheting():
    """At 4.1 k with friction both bodies are above their limits of elastic shakedown."""
    friction, ratio = 0.2, 4.1
    assert shakedown.line_kinematic(friction).ratio < ratio
    hard = SOFT.with_kinematic_hardening(0.2 * E)
    ratchets = repeated(ratio, SOFT, friction=friction, cells=6)
    closes = repeated(ratio, hard, friction=friction, cells=6)
    assert (ratchets.response, closes.response) == ("ratcheting", "plastic shakedown")
    assert ratchets.rate > ratchets.yield_strain
    assert closes.rate <= 1e-3 * closes.yield_strain < 0.05 * closes.flow
    below = repeated(3.7, hard, friction=friction, cells=6)
    assert below.response == "elastic shakedown"


def test_extrapolation_changes_only_the_number_of_cycles(ratcheting):
    """Extrapolation agrees within the stated error, with less than half the work."""
    simulation, result, cycle = ratcheting
    step_by_step, _ = rollers(3.4, friction=0.2, cells=6)
    for _ in range(result.cycles[-1].number):
        state = step_by_step.run(cycle, progress=False)[-1]
    assert result.response == "ratcheting"
    assert 2 * result.solved < result.cycles[-1].number
    difference = np.abs(result.state.plastic_strain() - state.plastic_strain()).max()
    assert difference < result.error
    assert difference < 0.02 * np.abs(state.plastic_strain()).max()
    counts = [s.counters["plastic_iterations"] for s in (step_by_step, simulation)]
    assert counts[0] > 2 * counts[1]


def test_extrapolation_is_exact_for_geometric_convergence():
    rng = np.random.default_rng(1)
    for limit, factor in ((1.0, 0.7), (0.0, 0.5), (1.0, 0.0)):
        steady, rest = limit * rng.normal(size=(6, 3, 2, 2)), rng.normal(size=(6, 3, 2, 2))
        changes = [steady + factor**n * rest for n in range(60)]
        trend = Trend(*([change] for change in changes[:3]))
        assert trend.factor == pytest.approx(factor, abs=1e-12)
        count = trend.safe_cycles(20)
        assert count == (20 if limit else 4)  # one that dies down is left to cycles at last
        np.testing.assert_allclose(trend.summed(20)[0], sum(changes[3:23]), atol=1e-12)
        np.testing.assert_allclose(trend.later(21)[0], changes[23], atol=1e-12)
    noise = Trend(*([rng.normal(size=(6, 3, 2, 2))] for _ in range(3)))
    assert noise.safe_cycles(20) == 0


def test_an_unconfirmed_extrapolation_is_discarded(monkeypatch):
    monkeypatch.setattr("samcontact.shakedown.jumps.Trend.safe_cycles", lambda *_: 15)
    wild = repeated(3.9, cells=8)
    monkeypatch.undo()
    plain = repeated(3.9, cells=8, accelerate=False)
    assert wild.rejected > 0
    assert wild.solved == len(wild.cycles) + wild.rejected
    assert wild.response == plain.response
    difference = np.abs(wild.state.plastic_strain() - plain.state.plastic_strain()).max()
    assert difference <= wild.error + 2e-3 * plain.yield_strain


def ball(body=SOFT, load=8.0, **settings):
    grid = sc.Grid(19, 19, 20e-6, 20e-6, dz=20e-6)
    gap = sc.surfaces.paraboloid(grid, 50e-3)
    return sc.Simulation(grid, STEEL, body, gap, **settings), sc.paths.load_unload(
        load=load, increments=2
    )


def test_a_reloaded_ball_stays_elastic():
    simulation, cycle = ball()
    first = simulation.run(cycle, progress=False)[-1]
    simulation, _ = ball()
    result = shakedown.run(simulation, cycle, progress=False)
    assert result.response == "elastic shakedown"
    assert result.cycles[1].flow < 0.05 * result.cycles[0].flow
    np.testing.assert_allclose(
        result.state.residual_displacement(), first.residual_displacement(), rtol=0.1, atol=1e-9
    )


def test_a_substrate_below_a_coating():
    """The yield strain is that of the substrate, which is elastic-plastic."""
    simulation, cycle = ball(sc.Layered([(STEEL, 20e-6)], SOFT))
    result = shakedown.run(simulation, cycle, progress=False)
    assert result.yield_strain == pytest.approx(np.sqrt(3.0) * K / E)
    assert (result.response, result.solved) == ("elastic shakedown", 2)


def test_a_cycle_without_yield_is_elastic():
    simulation, cycle = ball(load=0.5)
    result = shakedown.run(simulation, cycle, progress=False)
    assert (result.response, result.flow, result.rate, result.solved) == ("elastic", 0.0, 0.0, 1)
    assert result.shakes_down
    with pytest.raises(dataclasses.FrozenInstanceError):
        result.response = "ratcheting"
    with pytest.raises(ValueError, match="read-only"):
        result.strain_per_cycle()[0] = 1.0
    again = pickle.loads(pickle.dumps(result))
    assert again.cycles == result.cycles
    np.testing.assert_array_equal(again.residual_stress(), result.residual_stress())


def test_cycles_of_a_rolling_ball():
    """The track moves through the grid; a cycle ends where it began."""
    body = sc.Material.linear_hardening(E, NU, np.sqrt(3.0) * K, 0.1 * E)
    simulation, _ = ball(body)
    travel = 80e-6
    steps = sc.paths.rolling(load=8.0, distance=travel, step=20e-6, increments=1)
    with pytest.raises(ValueError, match=r"append \{'load': 0.0, 'advance': \(8"):
        shakedown.run(simulation, steps, progress=False)
    back = {"load": 0.0, "advance": (travel, travel)}
    result = shakedown.run(simulation, [*steps, back], progress=False, cycles=20)
    assert result.response == "elastic shakedown"
    assert result.strain_per_cycle().shape == result.state.track(2, margin=0).plastic_strain().shape


def test_an_interrupted_run_resumes_with_identical_bits(ratcheting, tmp_path, monkeypatch):
    whole = ratcheting[1]
    simulation, cycle = rollers(3.4, cells=6, friction=0.2)
    solve, count = sc.Simulation.step, iter(range(7 * len(cycle) + 5))

    def interrupted(self, **given):
        if next(count, None) is None:
            raise KeyboardInterrupt
        return solve(self, **given)

    monkeypatch.setattr(sc.Simulation, "step", interrupted)
    with pytest.raises(KeyboardInterrupt) as stopped:
        shakedown.run(simulation, cycle, progress=False, checkpoint=tmp_path)
    monkeypatch.undo()
    assert stopped.value.result.response == "undecided"
    assert len(list(tmp_path.glob("*.h5"))) == stopped.value.result.solved == 7

    again, _ = rollers(3.4, cells=6, friction=0.2)
    result = shakedown.run(again, cycle, progress=False, checkpoint=tmp_path)
    assert result.cycles == whole.cycles
    assert (result.error, result.solved) == (whole.error, whole.solved)
    np.testing.assert_array_equal(result.state.plastic_strain(), whole.state.plastic_strain())
    other, _ = rollers(3.4, cells=6, friction=0.2)
    with pytest.raises(sc.CheckpointError, match="tol"):
        shakedown.run(other, cycle, tol=1e-2, progress=False, checkpoint=tmp_path)


def test_an_unclear_response_is_reported():
    with pytest.warns(shakedown.NotSteadyWarning, match="increase cycles, which is 3"):
        result = repeated(4.1, cells=8, cycles=3)
    assert result.response == "undecided"
    assert not result.shakes_down
    simulation, cycle = rollers(3.4, cells=6, friction=0.2)
    with pytest.warns(shakedown.NotSteadyWarning):  # a jump follows the fourth, which none confirms
        last = shakedown.run(simulation, cycle, progress=False, cycles=4)
    np.testing.assert_array_equal(simulation.state.plastic_strain(), last.state.plastic_strain())
    rows = dict(result._rows())
    assert rows["cycles"] == "3, 3 of which solved"
    assert "response='undecided'" in repr(result)


def test_refuses():
    simulation, cycle = rollers(3.9, cells=8)
    grid = simulation.grid
    for given, text in (
        ({"cycle": []}, "cycle"), ({"tol": 0.5}, "tol"), ({"cycles": 1}, "cycles"),
    ):  # fmt: skip
        with pytest.raises(ValueError, match=text):
            shakedown.run(simulation, **{"cycle": cycle, "progress": False} | given)
    with pytest.raises(ValueError, match="must have an elastic-plastic body"):
        shakedown.run(ball(STEEL)[0], cycle, progress=False)
    with pytest.raises(TypeError, match="simulation must be"):
        shakedown.run(grid, cycle)
    with pytest.raises(ValueError, match="cells must be a divisor"):
        shakedown.passes(grid, np.zeros(grid.surface_shape), cells=7)
    with pytest.raises(ValueError, match="periodic along x"):
        shakedown.passes(sc.Grid(4, 4, 1e-6, 1e-6), np.zeros((4, 4)))
    # Fields of a grid that is too shallow do not show all that flows.
    shallow = sc.Grid(grid.nx, 1, grid.dx, grid.dy, nz=4, dz=grid.dx, periodic="xy")
    hidden = sc.Simulation(shallow, STEEL, SOFT, np.zeros(shallow.surface_shape))
    with pytest.raises(ValueError, match="omit nz"), pytest.warns(sc.GridTooSmallWarning):
        shakedown.run(hidden, cycle, progress=False)
    with pytest.raises(ValueError, match="body must be"):
        repeated(3.0, cells=8).strain_per_cycle(1)
