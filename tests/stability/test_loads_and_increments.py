# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads over many decades, and increments from the whole load to a ten-thousandth of it."""

import numpy as np
import pytest

import samcontact as sc

E, NU, RADIUS = 210e9, 0.3, 7.5e-3
STEEL = sc.Material.elastic(E, NU)
SOFT = sc.Material.linear_hardening(E, NU, 1e9, 0.1 * E)
E_STAR = sc.hertz.effective_modulus(STEEL, STEEL)
DECADES = [n for n in range(-4, 5) if n != 0]


def self_similar(decade, body2, length_power, friction=0.3):
    """Solve a contact with 10^decade times the load, in units of its own length and pressure."""
    length = 10.0 ** (decade * length_power)
    pressure = 10.0**decade / length**2
    # constant radius if the pressure grows with the contact; otherwise the radius grows with it
    radius = RADIUS * (length / pressure)
    grid = sc.Grid(21, 19, 4e-5 * length, 4.5e-5 * length, 8, 6e-5 * length)
    gap = sc.surfaces.paraboloid(grid, radius)
    simulation = sc.Simulation(grid, STEEL, body2, gap, friction, tol=1e-11, on_border="warn")
    states = [simulation.step(load=load * 10.0**decade) for load in (300.0, 0.0, 200.0)]
    return {
        "pressure": np.stack([state.pressure for state in states]) / pressure,
        "approach": np.array([state.approach for state in states]) / (length * pressure),
        "stress": states[-1].stress() / pressure,
        "strain": states[-1].plastic_strain() / pressure,
    }


def assert_same(found, expected, tolerance):
    for name, values in found.items():
        scale = np.abs(expected[name]).max()
        assert np.abs(values - expected[name]).max() <= tolerance * scale, name


@pytest.mark.parametrize("decade", DECADES)
def test_elastic_contact_is_self_similar(decade):
    """Lengths and pressures of one ball scale as P^(1/3) (Hertz)."""
    elastic = self_similar(0, STEEL, 1 / 3)
    assert_same(self_similar(decade, STEEL, 1 / 3), elastic, 1e-12)


@pytest.mark.parametrize("decade", DECADES)
def test_plastic_contact_is_self_similar(decade):
    """Balls scaled with the contact, P^(1/2), have equal pressure, strain and flow."""
    plastic = self_similar(0, SOFT, 1 / 2)
    assert plastic["strain"].max() > 1e-3
    assert_same(self_similar(decade, SOFT, 1 / 2), plastic, 1e-12)


@pytest.fixture(scope="module")
def fixed_grid():
    """Solve loads with one to sixty cells across the contact, each from the start."""
    grid = sc.Grid(127, 127, 4e-6, 4e-6)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    solver = sc.ContactSolver(grid, STEEL, STEEL)
    loads = 10.0 ** np.arange(-14, 2.5, 0.5)
    return grid, loads, [solver.solve(gap, load=load) for load in loads]


def test_sixteen_decades_of_load_on_one_grid(fixed_grid):
    grid, loads, found = fixed_grid
    assert all(solution.converged and solution.error <= 1e-8 for solution in found)
    totals = [solution.pressure.sum() * grid.cell_area for solution in found]
    assert totals == pytest.approx(loads, rel=1e-12)
    cells = [np.count_nonzero(solution.pressure) for solution in found]
    approach = [solution.approach for solution in found]
    assert cells[0] == 1
    assert cells[-1] > 5000
    assert (np.diff(cells) >= 0).all()
    assert (np.diff(approach) > 0).all()


def test_hertz_on_one_grid(fixed_grid):
    """The approach error decreases with the cells across the contact, to 1e-4 at sixty."""
    grid, loads, found = fixed_grid
    for load, solution in zip(loads, found, strict=True):
        exact = sc.hertz.point(RADIUS, E_STAR, load=load)
        if exact.a > 2 * grid.dx:
            error = abs(solution.approach / exact.approach - 1)
            assert error < 0.05 * (grid.dx / exact.a) ** 1.5


EXACT = sc.hertz.point(RADIUS, E_STAR, p0=2.4e9)


def loaded(count, law=SOFT, friction=0.0, **settings):
    """Return the state at full load after this many increments."""
    size = 3.2 * EXACT.a / 11
    grid = sc.Grid(11, 11, size, size, 7, 0.28 * EXACT.a)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    simulation = sc.Simulation(grid, STEEL, law, gap, friction, tol=1e-9, **settings)
    for n in range(count):
        state = simulation.step(load=EXACT.load * (n + 1) / count)
    return state


def differences(counts, reference, **scene):
    """Return the errors of the plastic strain, relative to its maximum."""
    found = []
    for count in counts:
        strain = loaded(count, **scene).plastic_strain() - reference
        found.append(np.abs(strain).max() / np.abs(reference).max())
    return found


LAWS = {
    "linear": SOFT,
    "Swift": sc.Material.swift(E, NU, 600e6, 20.0, 0.121),
    "kinematic": sc.Material.perfect_plastic(E, NU, 1e9).with_kinematic_hardening(20e9, 30.0),
}


@pytest.mark.parametrize("friction", [0.0, 0.3])
@pytest.mark.parametrize("law", LAWS)
def test_smaller_increments_converge(law, friction):
    """Backward Euler converges with first order; 128 increments are the reference."""
    scene = {"law": LAWS[law], "friction": friction, "on_border": "warn"}
    reference = loaded(128, **scene).plastic_strain()
    one, four, sixteen = differences((1, 4, 16), reference, **scene)
    assert one < 0.1
    assert sixteen < 0.012
    assert sixteen < 0.35 * four


def test_automatic_subincrements_are_as_accurate_as_many_increments():
    reference = loaded(256).equivalent_plastic_strain()
    for tol in (1e-2, 1e-3):
        strain = loaded(1, increment_tol=tol).equivalent_plastic_strain()
        assert np.abs(strain - reference).max() < tol * reference.max()


def test_a_ten_thousandth_of_the_load():
    """Very small increments follow the slope between larger ones without drift."""
    size = 3.2 * EXACT.a / 11
    grid = sc.Grid(11, 11, size, size, 7, 0.28 * EXACT.a)
    simulation = sc.Simulation(grid, STEEL, SOFT, sc.surfaces.paraboloid(grid, RADIUS), tol=1e-9)
    before = simulation.step(load=0.99 * EXACT.load)
    tiny = [simulation.step(load=EXACT.load * (0.99 + 1e-4 * n)) for n in range(1, 101)]
    whole = sc.Simulation(grid, STEEL, SOFT, sc.surfaces.paraboloid(grid, RADIUS), tol=1e-9)
    whole.step(load=0.99 * EXACT.load)
    once = whole.step(load=EXACT.load)
    added = once.plastic_strain() - before.plastic_strain()
    assert np.abs(added).max() > 1e-5
    difference = tiny[-1].plastic_strain() - once.plastic_strain()
    assert np.abs(difference).max() < 0.02 * np.abs(added).max()
    largest = [state.max_equivalent_plastic_strain() for state in tiny]
    steps = np.diff(largest)
    assert (steps > 0).all()
    assert steps.max() < 1.5 * steps.min()
    strain = tiny[-1].plastic_strain()
    for n in range(100):  # unloading is elastic, however small its steps
        state = simulation.step(load=EXACT.load * (1 - 1e-4 * (n + 1)))
    np.testing.assert_array_equal(state.plastic_strain(), strain)


@pytest.mark.slow
def test_ten_thousand_increments():
    """10 000 increments of 1e-4 accumulate no error."""
    finest = loaded(10_000).plastic_strain()
    errors = differences((64, 256, 1024), finest)
    for error, count in zip(errors, (64, 256, 1024), strict=True):
        assert error * count == pytest.approx(errors[0] * 64, rel=0.4)
