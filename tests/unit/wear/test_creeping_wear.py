# SPDX-License-Identifier: GPL-3.0-or-later
"""Wear of viscoelastic bodies and of their partners, against an equation of a single wave."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import samcontact as sc

MU = 0.1
TIMES, SHARES = np.array([0.7, 6.0]), np.array([0.35, 0.3])
HARD, SOFT = sc.Material.elastic(4e7, 0.3), sc.Material.elastic(1e7, 0.4)
RUBBER = SOFT.with_relaxation(TIMES, SHARES)
LENGTH, CELLS, HEIGHT = 1e-3, 16, 1e-6
GRID = sc.Grid(CELLS, 2, LENGTH / CELLS, LENGTH / CELLS, periodic="xy")
WAVE = np.cos(2 * np.pi * GRID.x / LENGTH)[:, None] * np.ones((1, 2))
AREA = GRID.nx * GRID.ny * GRID.cell_area
SLIP, DURATION = 1e-4, 0.25
pytestmark = pytest.mark.filterwarnings(
    "ignore::samcontact.UnitWarning", "ignore::samcontact.ElasticStrainWarning",
    "ignore::samcontact.ResolutionWarning", "ignore::samcontact.IncrementWarning",
)  # fmt: skip


def compliance(body):
    """Displacement of a wave over its pressure [m/Pa]."""
    return 2 * (1 - body.nu**2) / body.E / (2 * np.pi / LENGTH)


def to_and_fro(load, slip=SLIP, duration=DURATION):
    held = {"load": load, "duration": duration}
    return [held, *(held | {"shift": (0.0, s * slip)} for s in (1, 1, -1, -1))]


def wave_of_heights(coefficient, loops):
    """Height of the wave after each loop [m] by the differential equation of both bodies.

    Body 1 is elastic, body 2 relaxes; both are closed: k1 p + k2 T = h, with the equivalent
    pressure T. The wear of a loop changes h in the first step of the next loop.
    """
    k1, k2 = compliance(HARD), compliance(SOFT)
    rest, h, state = 1 - SHARES.sum(), HEIGHT, np.zeros(3)
    found = [h]

    def rates(_, y, rise):
        force = (rise + k1 * (SHARES * y[1:] / TIMES).sum()) / (k1 + k2)
        return [force, *(force - y[1:] / TIMES)]

    def advance(rise):
        nonlocal state
        given = {"args": (rise / DURATION,), "rtol": 1e-10, "atol": 1e-3}
        state = solve_ivp(rates, (0.0, DURATION), state, **given).y[:, -1]
        return rest * state[0] + (SHARES * state[1:]).sum()

    advance(h)  # the lead-in
    rise = 0.0
    for _ in range(loops):
        swept = 0.0
        for step in range(4):
            swept += advance(rise if step == 0 else 0.0) * SLIP
        rise = -coefficient * swept
        h += rise
        found.append(h)
    return np.array(found)


def frets(worn, cycles, **changes):
    load = 2.0 * np.pi * SOFT.E * HEIGHT / LENGTH * AREA
    given = {"cycle": to_and_fro(load), "friction": sc.Coulomb(MU), "cycles": cycles}
    given |= {"archard": worn, "progress": False, "tol": 1e-8} | changes
    bodies = given.pop("bodies", (HARD, RUBBER))
    return sc.wear.fretting(GRID, *bodies, given.pop("gap", HEIGHT * (1 - WAVE)), **given)


@pytest.mark.parametrize("share", [0.0, 0.5, 1.0])
def test_a_wave_wears_while_it_creeps(share):
    """Wear of the elastic body, of both, or of the viscoelastic body, in time."""
    coefficient, loops = 6e-9, 6
    found = frets((coefficient * (1 - share), coefficient * share), loops)
    removed = sum(found.heights[b] - found.heights[b][:1] for b in found.worn)
    wave = HEIGHT + 2 * (removed * WAVE).mean(axis=(1, 2))
    expected = wave_of_heights(coefficient, loops)
    assert 0.1 < 1 - expected[-1] / HEIGHT < 0.5
    np.testing.assert_allclose(wave, expected, atol=1e-3 * HEIGHT)
    elastic = frets((coefficient, 0.0), loops, bodies=(HARD, SOFT), cycle=without_time())
    other = HEIGHT + 2 * ((elastic.heights[1] - elastic.heights[1][:1]) * WAVE).mean(axis=(1, 2))
    assert abs(other[-1] - expected[-1]) > 0.02 * HEIGHT


def test_loops_with_negligible_wear_are_one_path():
    """The state continues bit by bit, except for the restart of the solver."""
    load = 2.0 * np.pi * SOFT.E * HEIGHT / LENGTH * AREA
    lead, *loop = to_and_fro(load)
    gap = HEIGHT * (1 - WAVE)
    path = sc.Simulation(GRID, HARD, RUBBER, gap, sc.Coulomb(MU), tol=1e-8)
    states = path.run([lead, *3 * loop], progress=False)
    last = frets((1e-25, 0.0), 3).last[-1]
    assert last.time == pytest.approx(states[-1].time, rel=1e-14)
    for name in ("pressure", "shear", "slip"):
        found, expected = getattr(last, name), getattr(states[-1], name)
        np.testing.assert_allclose(found, expected, atol=1e-7 * np.abs(expected).max())
    assert last.viscous_work() == pytest.approx(states[-1].viscous_work(), rel=1e-6)


def without_time():
    load = 2.0 * np.pi * SOFT.E * HEIGHT / LENGTH * AREA
    return [{name: v for name, v in s.items() if name != "duration"} for s in to_and_fro(load)]


def test_wear_in_slow_and_in_fast_loops_is_elastic():
    """Long-time moduli in slow loops, instantaneous ones in fast loops, also with repeats."""
    relaxed = sc.Material.elastic(SOFT.E * (1 - SHARES.sum()), SOFT.nu)
    load = 2.0 * np.pi * SOFT.E * HEIGHT / LENGTH * AREA
    for duration, body, repeats in ((1e9, relaxed, 1), (0.0, SOFT, 1), (1e9, relaxed, 30)):
        given = {"repeats": repeats, "cycles": 2}
        cycle = to_and_fro(load, duration=duration)
        creeping = frets((1e-11, 0.0), cycle=cycle, **given)
        elastic = frets((1e-11, 0.0), cycle=without_time(), bodies=(HARD, body), **given)
        # with repeats=1 the first loop wears, in which elastic bodies wear after a repetition only
        share = 2e-3 if repeats == 1 else 2e-6
        np.testing.assert_allclose(
            creeping.heights[1], elastic.heights[1], atol=share * np.ptp(elastic.heights[1])
        )


def test_repeats_wear_in_the_periodic_response():
    """The loop goes on until further creep is negligible; a hold before it makes that short."""
    load = 2.0 * np.pi * SOFT.E * HEIGHT / LENGTH * AREA
    held = to_and_fro(load)
    held.insert(1, {"load": load, "duration": 1e4})
    crept, long = (frets((1e-12, 0.0), 1, repeats=100, cycle=c) for c in (to_and_fro(load), held))
    lost = [2 * ((f.heights[1][-1] - f.heights[1][0]) * WAVE).mean() for f in (crept, long)]
    assert lost[0] == pytest.approx(lost[1], rel=0.03)  # 1 % of the largest pressure
    fast = frets((1e-10, 0.0), 1)
    assert 2 * (fast.heights[1][-1] * WAVE).mean() < 1.2 * lost[0]  # the first loop, not yet crept
    with pytest.raises(ValueError, match=r"repeats must be 1 because body2 is a visc"):
        frets((1e-10, 0.0), 1, repeats=2, bodies=(HARD, SOFT.with_relaxation([1.0], [1.0])))
    with pytest.raises(ValueError, match=r"archard must be at most .* hardly changes the pressure"):
        frets((1e-6, 0.0), 1)
    slow = SOFT.with_relaxation([1e3], [0.5])
    with pytest.raises(ValueError, match="hold the load for a long time in the lead-in"):
        frets((1e-12, 0.0), 1, repeats=2, bodies=(HARD, slow))


def test_a_run_continues_from_a_checkpoint_with_equal_bits(tmp_path):
    whole = frets((1e-10, 1e-10), 4)
    frets((1e-10, 1e-10), 2, checkpoint=tmp_path / "wear.h5")
    # a finished run keeps the start of its last cycle
    again = frets((1e-10, 1e-10), 4, checkpoint=tmp_path / "wear.h5")
    for body in (1, 2):
        np.testing.assert_array_equal(again.heights[body], whole.heights[body])


def test_a_metal_that_yields_wears_against_a_creeping_ball():
    """Cycles continue the creep of the ball: without wear they are one path of a simulation."""
    metal = sc.Material.linear_hardening(3e7, 0.3, 1e5, 3e6)
    ball = sc.Material.elastic(1e7, 0.4).with_relaxation([1.0, 20.0], [0.3, 0.3])
    grid = sc.Grid(16, 16, 3e-5, 3e-5, 8, 3e-5)

    def gap(grid):
        return sc.surfaces.paraboloid(grid, 5e-3)

    cycle = [{"load": 0.02, "duration": 0.5}, {"load": 0.0, "duration": 0.2}]
    given = {"cycle": cycle, "smoothing_length": 3.5e-5, "progress": False, "friction": 0.4}
    kept = sc.wear.run(grid, ball, metal, gap, threshold=0.04, cycles=3, **given)
    path = sc.Simulation(grid, ball, metal, gap, friction=0.4)
    states = path.run(cycle, progress=False)
    assert kept.stopped
    assert len(kept.cycles) == 1
    peak = kept.last[0]
    np.testing.assert_allclose(peak.pressure, states[0].pressure, atol=1e-6 * peak.pressure.max())
    worn = sc.wear.run(grid, ball, metal, gap, threshold=4e-4, cycles=2, **given)
    assert worn.cycles[0].volume[0] > 0
    peak = worn.last[0]
    assert peak.time == pytest.approx(1.2)
    left = peak.equivalent_pressure(1)[peak.pressure == 0]  # where the first cycle pressed
    assert left.max() > 0.02 * peak.pressure.max()
    assert peak.viscous_work(1) > worn.first[0].viscous_work(1)


def test_a_case_file_wears_a_creeping_body():
    body = {"law": "elastic", "E": 1e7, "nu": 0.4}
    relaxation = {"times": [1.0], "shares": [0.5]}
    held = {"load": 0.02, "duration": 1.0}
    case = sc.cases.Case.model_validate(
        {
            "title": "a rubber ball frets",
            "grid": {"nx": 16, "ny": 16, "dx": 3e-5, "dy": 3e-5},
            "body1": body | {"relaxation": relaxation},
            "body2": body | {"E": 5e7},
            "surface": {"shape": "paraboloid", "Rx": 5e-3},
            "contact": {"friction": {"coulomb": 0.3}},
            "path": [held, held | {"fret": {"shift_x": 2e-6}}],
            "wear": {"archard": 1e-11, "cycles": 2},
        }
    )
    simulation, path = case.build()
    found = case.wear.solve(simulation, path, None, False)
    assert found.cycles[1].volume[0] > 0
    assert found.cycles[0].friction_work > 0
