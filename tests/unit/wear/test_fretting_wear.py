# SPDX-License-Identifier: GPL-3.0-or-later
"""Wear by slip: volume, laws, termination, checkpoints, refusals."""

from itertools import pairwise

import numpy as np
import pytest

import samcontact as sc
from samcontact import report, results

STEEL = sc.Material.elastic(210e9, 0.3)
MU = sc.Coulomb(0.5)
CELL = 4e-6
RADIUS = 5e-3
LINE = sc.Grid(33, 1, CELL, CELL, periodic="y")
CYLINDER = sc.surfaces.paraboloid(LINE, RADIUS, np.inf)
# nine cells of half width
LOAD = 0.25 * np.pi * sc.hertz.effective_modulus(STEEL, STEEL) * (9 * CELL) ** 2 / RADIUS * CELL
BALL_GRID = sc.Grid(24, 24, 8e-6, 8e-6)
BALL = sc.surfaces.paraboloid(BALL_GRID, RADIUS)
BALL_LOAD = 8.0


def to_and_fro(load, amplitude):
    """Return a path that loads, applies the force amplitude, reverses it and returns to it."""
    return [{"load": load, "tangential_load": (q * amplitude, 0.0)} for q in (0, 1, -1, 1)]


def frets(gap=BALL, grid=BALL_GRID, **changes):
    given = {"cycle": to_and_fro(BALL_LOAD, 0.6 * 0.5 * BALL_LOAD), "friction": MU, "cycles": 2}
    given |= {"energy": 1e-14, "repeats": 2000, "progress": False}
    return sc.wear.fretting(grid, STEEL, STEEL, gap, **(given | changes))


@pytest.fixture(scope="module")
def worn():
    return frets(energy=(1e-14, 3e-14), repeats=10000)


def test_worn_volume_follows_from_the_friction_work(worn):
    for cycle in worn.cycles:
        assert cycle.parts > 1
        assert cycle.volume == pytest.approx(np.array([1e-14, 3e-14]) * cycle.friction_work)
        assert cycle.lost_volume == pytest.approx(cycle.volume, rel=1e-12)
    np.testing.assert_allclose(worn.profile(body=2), 3 * worn.profile(body=1), rtol=1e-12)
    simulation = sc.Simulation(BALL_GRID, STEEL, STEEL, BALL, MU)
    before, *_, after = simulation.run(to_and_fro(BALL_LOAD, 0.3 * BALL_LOAD), progress=False)[1:]
    once = frets(repeats=1, cycles=1).cycles[0]
    assert once.friction_work == pytest.approx(after.friction_work - before.friction_work)


def test_the_stick_zone_does_not_wear(worn):
    sticking = (worn.last[-1].pressure > 0) & ~np.any([s.slip for s in worn.last], axis=(0, 1))
    assert 20 < np.count_nonzero(sticking) < 0.7 * np.count_nonzero(worn.last[-1].pressure)
    assert not worn.profile()[sticking].any()
    assert (worn.profile()[(worn.last[-1].pressure > 0) & ~sticking] < 0).all()


@pytest.mark.parametrize("amplitude", [2e-7, 2e-5])
def test_both_wear_laws_agree_for_equal_friction(amplitude):
    """Both laws agree with little slip and with full slip."""
    cycle = [{"load": BALL_LOAD, "shift": (d * amplitude, 0.0)} for d in (0, 1, -2, 2)]
    one = frets(cycle=cycle, energy=None, archard=1e-16, cycles=1)
    other = frets(cycle=cycle, energy=1e-16 / MU.coefficient, cycles=1)
    assert (one.cycles[0].stick_area == 0.0) == (amplitude == 2e-5)
    depth = -one.profile().min()
    np.testing.assert_allclose(one.profile(), other.profile(), atol=1e-5 * depth)


@pytest.mark.parametrize("loops", [0, 2])
def test_the_initial_loading_does_not_wear(loops):
    """Shear of the initial loading has no effect after one cycle."""
    cycle = to_and_fro(BALL_LOAD, 0.3 * BALL_LOAD)
    changed = cycle[1:] + loops * cycle[2:]
    found, expected = (frets(cycle=one, cycles=1).cycles[0] for one in (changed, cycle))
    assert found.friction_work == pytest.approx((1 + loops) * expected.friction_work, rel=1e-3)


def test_wear_ceases_when_the_stick_zone_carries_all():
    """Ciavarella & Hills (1999): the stick zone does not change, and the slip zone separates.

    The final contact is that of the initial surface on the cells of the stick zone.
    """
    cycle = to_and_fro(LOAD, 0.7 * 0.5 * LOAD)
    result = frets(CYLINDER, LINE, cycle=cycle, repeats=200_000, cycles=40)
    assert result.stopped
    pressure = result.last[-1].pressure
    stuck = pressure > 0
    areas = [one.stick_area for one in result.cycles]
    assert areas == pytest.approx([np.count_nonzero(stuck) * LINE.cell_area] * len(areas))
    assert np.count_nonzero(stuck) < 0.62 * result.cycles[0].contact_area / LINE.cell_area
    solver = sc.ContactSolver(LINE, STEEL, STEEL)
    with pytest.warns(sc.SingularPressureWarning):  # at the border of stick
        only = solver.solve(np.where(stuck, CYLINDER, 1e-3), load=LOAD)
    np.testing.assert_allclose(pressure, only.pressure, atol=1e-6 * pressure.max())


def test_error_due_to_the_cycle_jumps_is_of_first_order(monkeypatch):
    """The error due to the parts is of first order, and below 2 % of the depth."""
    scars = []
    for part in (1.0, 0.5, 0.25):
        monkeypatch.setattr("samcontact.wear.by_slip._MAX_PRESSURE_CHANGE", part)
        scars.append(frets(repeats=120_000, cycles=1))
    counts = [scar.cycles[0].parts for scar in scars]
    coarse, fine = (np.linalg.norm(a.profile() - b.profile()) for a, b in pairwise(scars))
    assert counts[0] > 4
    assert counts[2] == pytest.approx(4 * counts[0], abs=4)
    assert coarse / fine == pytest.approx(2.0, rel=0.1)
    assert coarse < 1.5e-2 * np.linalg.norm(scars[2].profile())


def test_a_contact_at_constant_distance_is_lost_by_wear():
    """At a constant approach the bodies finally separate."""
    grid = sc.Grid(12, 1, 8e-6, 8e-6, periodic="y")
    gap = sc.surfaces.paraboloid(grid, RADIUS, np.inf)
    cycle = [{"approach": 5e-8, "shift": (d * 1e-6, 0.0)} for d in (0, 1, -2, 2)]
    result = frets(gap, grid, cycle=cycle, repeats=1_000_000, cycles=20)
    assert result.stopped
    assert not result.last[-1].pressure.any()
    np.testing.assert_allclose(-result.profile()[gap < 4e-8], (5e-8 - gap)[gap < 4e-8], rtol=0.05)


def test_continuation_from_a_checkpoint_gives_equal_results(worn, tmp_path):
    more = {"energy": (1e-14, 3e-14), "repeats": 10000, "checkpoint": tmp_path / "scar.h5"}
    frets(**more, cycles=2)
    again = frets(**more, cycles=3)
    straight = frets(**(more | {"checkpoint": None}), cycles=3)
    np.testing.assert_array_equal(again.profile(), straight.profile())
    assert again.cycles == straight.cycles
    np.testing.assert_array_equal(again.first[-1].pressure, straight.first[-1].pressure)
    with pytest.raises(ValueError, match="repeats"):
        frets(**(more | {"repeats": 5}), cycles=4)


def test_a_gap_may_be_a_function_of_the_grid(worn):
    made = frets(
        lambda grid: sc.surfaces.paraboloid(grid, RADIUS), energy=(1e-14, 3e-14), repeats=10000
    )
    np.testing.assert_array_equal(made.profile(), worn.profile())


def test_dataset_and_report(worn, tmp_path, undrawn):
    data = worn.to_dataset()
    assert {v.attrs["units"] for v in data.data_vars.values()} == {"m3", "m", "m2", "J", "Pa", "1"}
    results.save(data, tmp_path / "wear.nc")
    with results.open_results(tmp_path / "wear.nc") as kept:
        np.testing.assert_array_equal(kept["friction_work"], data["friction_work"])
        checks_found = report.checks(kept)
        assert all(check.passed for check in checks_found)
        report.write(kept, tmp_path / "report.html")
    assert "stick area" in (tmp_path / "report.html").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("changes", "text"),
    [
        ({"energy": None}, "exactly one of energy, archard"),
        ({"archard": 1e-14}, "exactly one of energy, archard"),
        ({"energy": -1.0}, "energy must be"),
        ({"energy": (0.0, 0.0)}, "energy must be > 0"),
        ({"energy": (1.0, 1.0, 1.0)}, r"a pair \(body 1, body 2\), got \(1.0, 1.0, 1.0\)"),
        ({"friction": sc.Coulomb(np.inf)}, "friction must be > 0 and finite"),
        ({"repeats": 0}, "repeats must be"),
        ({"cycle": to_and_fro(8.0, 2.0)[:2]}, "must end with the load"),
        ({"cycle": []}, "at least one step"),
        ({"energy": 1e-5}, "energy and repeats are too large: .* at most 10000 contact solutions"),
        ({"cycle": [{"load": 0.0}]}, "must bring the bodies into contact"),
        ({"cycle": [{"load": 8.0, "shift": (0.0, 0.0), "tangential_load": (1.0, 0.0)}]}, "both"),
    ],
)
def test_what_is_refused(changes, text):
    with pytest.raises(ValueError, match=text):
        frets(**changes)


def test_rolling_bodies_and_full_sliding_are_refused():
    with pytest.raises(TypeError, match="unknown argument 'advance'"):
        frets(cycle=[{"load": 8.0, "advance": (1e-6, 1e-6)}])
    with pytest.raises(TypeError, match="friction"):
        frets(friction=0.5)
