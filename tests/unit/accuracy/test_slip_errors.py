# SPDX-License-Identifier: GPL-3.0-or-later
"""Grid errors of forces, motions and friction work against closed forms and finer cells."""

import re
from pathlib import Path

import numpy as np
import pytest

import samcontact as sc

PAGES = (Path(__file__).parents[3] / "docs" / "theory").glob("*.md")
THEORY = " ".join(" ".join(page.read_text(encoding="utf-8") for page in PAGES).split())
STATED = re.search(
    r"relative to max μp, is ([^%]*) % with one increment, and ([^%]*) % with eight", THEORY
).groups()
MU, R, LOAD = 0.4, 7.5e-3, 300.0
E = 210e9


def run(nu, cells, path):
    """Run a path with `cells` cells per contact radius; return states, errors and the radius."""
    body = sc.Material.elastic(E, nu)
    radius = sc.hertz.point(R, sc.hertz.effective_modulus(body, body), load=LOAD).a
    grid = sc.Grid(2 * cells + 9, 2 * cells + 9, radius / cells, radius / cells)
    gap = sc.surfaces.paraboloid(grid, R)
    simulation = sc.Simulation(grid, body, body, gap, sc.Coulomb(MU))
    steps = path(grid)
    states = simulation.run(steps, progress=False)
    return states, sc.estimate_errors(simulation, steps, states), radius


def fretting(_):
    force = (0.6 * MU * LOAD, 0.0)
    return [{"load": LOAD}, *sc.paths.fretting_loop(load=LOAD, force=force, increments=3)]


def test_fretting_against_mindlin_and_deresiewicz():
    """Exact for nu = 0; the true error is at most the estimate, within a factor of two."""
    states, found, a = run(0.0, 12, fretting)
    soft = 2 * 2 / (E / 2)
    shift = 3 * MU * LOAD * soft / (16 * a) * (1 - 0.4 ** (2 / 3))
    loop = 1 - 0.4 ** (5 / 3) - 0.5 * (1 + 0.4 ** (2 / 3))
    work = 9 * MU**2 * LOAD**2 * soft / (10 * a) * loop
    value, error = found.values["shift_x"], found.errors["shift_x"]
    np.testing.assert_array_equal(value, [state.shift[0] for state in states])
    assert 0.5 * error[3] < 5e-3 * shift
    assert abs(value[3] - shift) < 2 * error[3]
    value, error = found.values["friction_work"], found.errors["friction_work"]
    assert abs(value[-1] - value[3] - work) < 2 * error[-1] < 0.1 * work
    # prescribed values have no error, and rounding is not reported
    assert not {"tangential_load_x", "tangential_load_y", "shift_y", "twist"} & set(found.errors)
    # where the shift passes through zero both grids agree by chance
    assert error.min() >= 0
    assert np.all(found.errors["shift_x"][4:] >= 0.2 * found.errors["shift_x"][3])
    assert {"tangential displacement, x", "frictional work"} <= set(dict(found._rows()))


def test_rolling_against_finer_cells():
    def rolls(grid):
        travels = (-grid.dx * 0.999, -grid.dx * 1.001)
        return [{"load": LOAD}] + [{"load": LOAD, "advance": travels}] * (5 * (grid.nx - 9) // 2)

    states, found, a = run(0.3, 12, rolls)
    body = sc.Material.elastic(E, 0.3)
    fine = sc.Grid(129, 129, a / 60, a / 60)
    exact = sc.rolling.steady(
        fine, body, body, sc.surfaces.paraboloid(fine, R), load=LOAD, friction=sc.Coulomb(MU),
        creepage=(2e-3, 0.0),
    ).tangential_load[0]  # fmt: skip
    error = found.errors["tangential_load_x"][-1]
    assert abs(states[-1].tangential_load[0] - exact) < 2 * error < 0.1 * exact


def test_missing_friction_work_of_rolling():
    """The missing work is that stated on the theory page, of first order in the cell size."""
    stated = re.search(
        r"force times creepage. With ([\d, ]+) and \d+ cells per contact radius, the computed "
        r"friction work is smaller by ([\d, ]+) and",
        THEORY,
    )
    cells, shares = ([int(n) for n in re.findall(r"\d+", numbers)] for numbers in stated.groups())
    body, creepage = sc.Material.elastic(E, 0.3), 2e-3
    radius = sc.hertz.point(R, sc.hertz.effective_modulus(body, body), load=LOAD).a
    for share, n in zip(shares, cells, strict=True):
        grid = sc.Grid(2 * n + 9, 2 * n + 9, radius / n, radius / n)
        gap = sc.surfaces.paraboloid(grid, R)
        rolls = sc.rolling.steady(
            grid, body, body, gap, load=LOAD, friction=sc.Coulomb(MU), creepage=(creepage, 0.0)
        )
        work = np.sum(rolls.shear * rolls.slip) * grid.cell_area
        assert round(100 * (1 - work / (rolls.tangential_load[0] * creepage))) == share


@pytest.mark.parametrize("number", range(3), ids=["ellipse", "rough", "dissimilar"])
def test_errors_of_oblique_loading_are_those_of_the_theory(number):
    """Errors relative to 64 increments are those stated in the theory."""
    steel, R, load = sc.Material.elastic(210e9, 0.3), 10e-3, 100.0
    other = sc.Material.elastic(70e9, 0.33) if number == 2 else steel
    Ry = 3 * R if number == 0 else R
    contact = sc.hertz.elliptic(R, Ry, sc.hertz.effective_modulus(steel, other), load=load)
    grid = sc.Grid(25, 25, contact.a_x / 10, contact.a_y / 10)
    gap = sc.surfaces.paraboloid(grid, R, Ry)
    if number == 1:
        gap = gap - sc.surfaces.rough_self_affine(
            grid, 1e-7, 0.8, seed=1, wavelength_min=4 * grid.dx
        )
    shears = {}
    for increments in (1, 8, 64):
        simulation = sc.Simulation(grid, steel, other, gap, sc.Coulomb(0.3))
        loads = load * np.arange(1, increments + 1) / increments
        path = [{"load": P, "tangential_load": (0.2 * P, 0.0)} for P in loads]
        state = simulation.run(path, progress=False)[-1]
        shears[increments] = state.shear[:, state.pressure > 0]
    maximum = 0.3 * state.pressure.max()
    for increments, text in zip((1, 8), STATED, strict=True):
        stated = re.findall(r"[\d.]+", text)[number]
        squares = np.sum((shears[increments] - shears[64]) ** 2, axis=0)
        found = 100 * np.sqrt(squares.mean()) / maximum
        assert f"{found:.1f}" == stated


def test_results_contain_slip_errors():
    states, found, _ = run(0.3, 8, fretting)
    body = sc.Material.elastic(E, 0.3)
    simulation = sc.Simulation(
        states[0].grid, body, body, sc.surfaces.paraboloid(states[0].grid, R), sc.Coulomb(MU)
    )
    dataset = sc.results.to_dataset(simulation, states)
    found.add_to(dataset)
    np.testing.assert_array_equal(dataset["shift_x_error"], found.errors["shift_x"])
    assert dataset["friction_work_error"].attrs["units"] == "J"


def test_full_sliding_has_no_slip_errors():
    body = sc.Material.elastic(E, 0.3)
    grid = sc.Grid(33, 33, 20e-6, 20e-6)
    simulation = sc.Simulation(grid, body, body, sc.surfaces.paraboloid(grid, R), MU)
    path = [{"load": LOAD}]
    found = sc.estimate_errors(simulation, path, simulation.run(path, progress=False))
    assert set(found.errors) == {"load", "approach", "max_pressure", "contact_area"}
