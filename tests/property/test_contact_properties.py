# SPDX-License-Identifier: GPL-3.0-or-later
"""Properties of every elastic contact: complementarity, equilibrium, scaling, symmetry."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import samcontact as sc

few = settings(derandomize=True, max_examples=20, deadline=None, database=None)

E, RADIUS, CELL = 210e9, 7.5e-3, 1.5e-5
TOL = 1e-9
RIGID = sc.Material.rigid()
counts = st.integers(8, 32)
ratios = st.floats(0.4, 2.5)
poisson = st.floats(0.0, 0.499)
frictions = st.one_of(st.just(0.0), st.floats(0.0, 1.0))
loads = st.floats(-3.0, 2.0).map(lambda decade: 10.0**decade)
seeds = st.integers(0, 2**32 - 1)
problems = st.fixed_dictionaries(
    {
        "nx": counts,
        "ny": counts,
        "ratio": ratios,
        "bodies": st.one_of(
            st.tuples(poisson.map(lambda nu: sc.Material.elastic(E, nu)), st.just(RIGID)),
            st.tuples(st.just(RIGID), poisson.map(lambda nu: sc.Material.elastic(E, nu))),
            st.tuples(*[st.builds(sc.Material.elastic, st.floats(1e9, 4e11), poisson)] * 2),
        ),
        "friction": frictions,
        "seed": seeds,
        "roughness": st.sampled_from([0.0, 1e-8, 3e-7]),
    }
)


class Problem:
    """A rough ball on a flat, of any materials, on any grid."""

    def __init__(self, nx, ny, ratio, bodies, friction, seed, roughness):
        self.grid = sc.Grid(nx, ny, CELL, ratio * CELL)
        self.bodies, self.friction = bodies, friction
        heights = np.random.default_rng(seed).random(self.grid.surface_shape)
        self.gap = sc.surfaces.paraboloid(self.grid, RADIUS) + roughness * heights

    def solver(self, grid=None, bodies=None, tol=TOL):
        return sc.ContactSolver(
            grid or self.grid, *(bodies or self.bodies), self.friction, tol=tol, on_border="warn"
        )

    def displacement(self, pressure):
        """Return the sum of u_z of both bodies, from the operators of one half-space [m]."""
        total = np.zeros(self.grid.surface_shape)
        for body, sign in zip(self.bodies, (-1.0, 1.0), strict=True):
            if not body.is_rigid:
                total += sc.operators.surface_displacement(
                    self.grid, pressure, body.E, body.nu, sign * self.friction * pressure
                )
        return total


def close(actual, expected, tolerance):
    return np.abs(actual - expected).max() <= tolerance * np.abs(expected).max()


border = pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")


@border
@few
@given(given_problem=problems, load=loads, by_approach=st.booleans())
def test_complementarity_and_equilibrium(given_problem, load, by_approach):
    """p >= 0, g >= 0, p g = 0 with g from the operators; the pressure carries the load."""
    problem = Problem(**given_problem)
    solver = problem.solver()
    found = solver.solve(problem.gap, load=load)
    if by_approach:
        found = solver.solve(problem.gap, approach=found.approach)
        assert found.load == pytest.approx(load, rel=1e-5)
    p, u = found.pressure, problem.displacement(found.pressure)
    g, scale = problem.gap + u - found.approach, np.abs(u).max()
    slack = TOL + 1e-13  # rounding of u
    assert p.min() >= 0
    assert g.min() >= -slack * scale
    assert np.minimum(p / p.max(), g / scale).max() <= slack
    assert np.abs(found.gap - g).max() <= slack * scale
    assert p.sum() * problem.grid.cell_area == pytest.approx(found.load, rel=1e-12)


@border
@few
@given(given_problem=problems, load=loads, factor=st.floats(1e-6, 1e6))
def test_scaling_laws(given_problem, load, factor):
    """Pressure scales with the modulus, gap with the load, and all lengths with the length unit."""
    problem = Problem(**given_problem)
    found = problem.solver().solve(problem.gap, load=load)
    higher = problem.solver().solve(factor * problem.gap, load=factor * load)
    assert close(higher.pressure / factor, found.pressure, 1e-6)
    stiffer = [b if b.is_rigid else sc.Material.elastic(factor * b.E, b.nu) for b in problem.bodies]
    stiff = problem.solver(bodies=stiffer).solve(problem.gap, load=factor * load)
    assert close(stiff.pressure / factor, found.pressure, 1e-6)
    grid = problem.grid
    large = sc.Grid(grid.nx, grid.ny, factor * grid.dx, factor * grid.dy)
    grown = problem.solver(grid=large).solve(factor * problem.gap, load=factor**2 * load)
    assert close(grown.pressure, found.pressure, 1e-6)
    for other in (higher.approach, stiff.approach * factor, grown.approach):
        assert other / factor == pytest.approx(found.approach, rel=1e-6)


@border
@few
@given(given_problem=problems, load=loads)
def test_mirror_symmetry(given_problem, load):
    """Solutions are mirrored with the gap: along y, and along x if the bodies are swapped too."""
    problem = Problem(**given_problem)
    found = problem.solver().solve(problem.gap, load=load)
    along_y = problem.solver().solve(problem.gap[:, ::-1], load=load)
    assert close(along_y.pressure[:, ::-1], found.pressure, 1e-6)
    along_x = problem.solver(bodies=problem.bodies[::-1]).solve(problem.gap[::-1], load=load)
    assert close(along_x.pressure[::-1], found.pressure, 1e-6)


@border
@few
@given(given_problem=problems, load=loads, seed=seeds)
def test_the_initial_pressure_does_not_matter(given_problem, load, seed):
    problem = Problem(**given_problem)
    solver = problem.solver()
    found = solver.solve(problem.gap, load=load)
    start = np.random.default_rng(seed).exponential(1e9, problem.grid.surface_shape)
    again = solver.solve(problem.gap, load=load, initial_pressure=start)
    assert close(again.pressure, found.pressure, 1e-6)
    assert again.approach == pytest.approx(found.approach, rel=1e-7)


@border
@pytest.mark.filterwarnings("ignore::samcontact.SingularPressureWarning")  # random steps
@few
@given(given_problem=problems, load=loads, more=st.floats(1.01, 100.0))
def test_approach_grows_with_load(given_problem, load, more):
    """Monotone: (P2 - P1)(d2 - d1) > 0 and, for a convex energy, its slope is the approach."""
    problem = Problem(**{**given_problem, "friction": 0.0})
    one, other = (problem.solver().solve(problem.gap, load=part) for part in (load, more * load))
    assert other.approach > one.approach

    def energy(found):
        p = found.pressure
        work = p * (0.5 * problem.displacement(p) + problem.gap)
        return work.sum() * problem.grid.cell_area

    rise = energy(other) - energy(one)
    slack = 1e-6 * other.approach * more * load
    assert (more - 1) * load * one.approach <= rise + slack
    assert rise <= (more - 1) * load * other.approach + slack


@border
@pytest.mark.filterwarnings("ignore::samcontact.SingularPressureWarning")  # where a problem is cut
@few
@given(given_problem=problems, load=loads, shift=st.tuples(st.integers(0, 5), st.integers(0, 5)))
def test_translation_by_whole_cells(given_problem, load, shift):
    problem = Problem(**given_problem)
    i, j = shift
    found = problem.solver().solve(problem.gap, load=load)
    nx, ny = problem.grid.surface_shape
    large = sc.Grid(nx + 5, ny + 5, problem.grid.dx, problem.grid.dy)
    gap = np.full(large.surface_shape, 1.0)
    gap[i : i + nx, j : j + ny] = problem.gap
    moved = problem.solver(grid=large).solve(gap, load=load)
    assert close(moved.pressure[i : i + nx, j : j + ny], found.pressure, 1e-6)
    assert moved.approach == pytest.approx(found.approach, rel=1e-7)
