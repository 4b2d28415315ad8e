# SPDX-License-Identifier: GPL-3.0-or-later
"""Dents as the start of a pass: what is carried over, translation, superposition, the rim."""

import math

import numpy as np
import pytest

import samcontact as sc
from samcontact.overrolling import Particle, indent, particles, roll_over

pytestmark = pytest.mark.filterwarnings("ignore::samcontact.IncrementWarning")

STEEL = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
BALL = sc.Material.elastic(210e9, 0.3)
CELL = 6e-6
GRID = sc.Grid(25, 21, CELL, CELL, dz=6e-6)
PARTICLE = {"radius": 200e-6, "approach": 2.5e-6}


def gap(grid):
    return sc.surfaces.paraboloid(grid, 4e-3)


def passed(dented, middle):
    return roll_over(
        GRID, BALL, STEEL, dented, gap, load=4.0, distance=24 * CELL, step=3 * CELL, middle=middle,
        increments=2,
    )  # fmt: skip


@pytest.fixture(scope="module")
def dented():
    return indent(GRID, STEEL, [Particle(**PARTICLE)], increments=4)


@pytest.fixture(scope="module")
def rolled(dented):
    return passed(dented, 0.0)


def test_the_pass_starts_from_the_dent(dented, rolled):
    """The unloaded body has the imprint and the residual stress of the indentation."""
    simulation = sc.Simulation(GRID, BALL, STEEL, gap(GRID))
    sc.overrolling.start_from(simulation, dented)
    start = simulation.step(load=0.0).track(2)
    for name in ("residual_displacement", "residual_stress", "equivalent_plastic_strain"):
        before, after = getattr(dented, name)(), getattr(start, name)()
        assert np.abs(after).max() == pytest.approx(np.abs(before).max(), rel=1e-4)
    assert rolled.dented is dented


def test_the_pressure_peaks_at_the_rim(dented, rolled):
    """Away from the dent it is Hertzian; over the dent it is largest at the rim, symmetrically."""
    E_star = sc.hertz.effective_modulus(BALL, STEEL)
    hertz = sc.hertz.point(4e-3, E_star, load=4.0)
    x, y = rolled.peak_place
    depth = dented.residual_displacement()
    rim = abs(dented.x[np.argmin(depth[:, depth.shape[1] // 2])])
    assert 0.5 * rim < math.hypot(x, y) < 2.0 * rim
    assert rolled.max_pressure.max() > 1.1 * hertz.p0
    loaded = rolled.max_pressure[[state.load == 4.0 for state in rolled.states]]
    assert len(loaded) == 9
    assert loaded == pytest.approx(loaded[::-1], rel=2e-2)
    assert rolled.states[-1].load == 0.0
    worst = rolled.dang_van(0.3)
    assert math.hypot(worst.position["x"], worst.position["y"]) < 3.0 * rim


def test_a_dent_elsewhere_is_the_same_dent(rolled):
    """Both the dent and the path are moved by whole cells."""
    shift = 3 * CELL
    moved = passed(indent(GRID, STEEL, [Particle(**PARTICLE, x=shift)], increments=4), shift)
    assert moved.max_pressure == pytest.approx(rolled.max_pressure, rel=1e-3)
    assert moved.position == pytest.approx(rolled.position + shift, abs=1e-12)


@pytest.mark.parametrize("more", [-4, 6])
def test_a_grid_of_another_length_leaves_the_dents_in_place(dented, more):
    """Residual displacement of the unloaded start, by position on the body."""
    grid = sc.Grid(GRID.nx + more, GRID.ny, CELL, CELL, dz=6e-6)
    simulation = sc.Simulation(grid, BALL, STEEL, gap)
    sc.overrolling.start_from(simulation, dented)
    start = simulation.step(load=0.0).track(2)
    before, after = dented.residual_displacement(), start.residual_displacement()
    common = np.intersect1d(np.round(dented.x / CELL), np.round(start.x / CELL))
    rows = [np.isin(np.round(x / CELL), common) for x in (dented.x, start.x)]
    assert common.size >= GRID.nx - 4
    np.testing.assert_allclose(after[rows[1]], before[rows[0]], atol=1e-4 * before.max())


def test_a_shift_by_half_a_cell_is_refused(dented):
    even = sc.Grid(GRID.nx + 1, GRID.ny, CELL, CELL, dz=6e-6)
    with pytest.raises(ValueError, match=r"^nx must be odd, as on the grid of dented, got 26"):
        roll_over(even, BALL, STEEL, dented, gap, load=1.0, distance=4 * CELL, step=CELL)


def test_errors_of_a_prescribed_strain_are_refused(dented):
    """A repetition on coarser cells would begin without the dents."""
    simulation = sc.Simulation(GRID, BALL, STEEL, gap)
    sc.overrolling.start_from(simulation, dented)
    path = [{"load": 1.0}]
    states = simulation.run(path)
    with pytest.raises(ValueError, match="run must be a simulation without a plastic strain"):
        sc.estimate_errors(simulation, path, states)


@pytest.mark.slow
def test_distant_dents_do_not_interact(dented):
    """The second particle finds the first dent; far away, imprints add up."""
    wide = sc.Grid(49, 15, CELL, CELL, dz=6e-6)
    two = [Particle(**PARTICLE, x=x * CELL) for x in (-14.0, 14.0)]
    depth = indent(wide, STEEL, two, increments=4).residual_displacement()
    single = dented.residual_displacement().max()
    assert depth[:25].max() == pytest.approx(single, rel=0.03)
    assert depth[25:].max() == pytest.approx(single, rel=0.03)


def test_particles_follow_their_distribution():
    found = particles(2e-3, 1e-3, 1e9, 5e-6, spread=0.3, depth_ratio=0.1, seed=3)
    assert found == particles(2e-3, 1e-3, 1e9, 5e-6, spread=0.3, depth_ratio=0.1, seed=3)
    assert len(found) == pytest.approx(2000, abs=5 * math.sqrt(2000))
    logarithm = np.log([one.radius for one in found])
    assert logarithm.mean() == pytest.approx(math.log(5e-6), abs=5 * 0.3 / math.sqrt(2000))
    assert logarithm.std() == pytest.approx(0.3, rel=0.08)
    x, y = np.array([(one.x, one.y) for one in found]).T
    assert 0.9e-3 < np.abs(x).max() <= 1e-3
    assert 0.45e-3 < np.abs(y).max() <= 0.5e-3
    assert all(one.approach == pytest.approx(0.1 * one.radius) for one in found)


def test_unusable_arguments_are_refused(dented):
    with pytest.raises(ValueError, match="approach must be < radius"):
        Particle(1e-6, approach=1e-6)
    with pytest.raises(ValueError, match="particles must contain at least one"):
        indent(GRID, STEEL, [])
    other = sc.Grid(25, 21, CELL, CELL, dz=5e-6)
    with pytest.raises(ValueError, match="as the grid of dented"):
        roll_over(other, BALL, STEEL, dented, gap, load=1.0, distance=6e-5, step=6e-6)
    with pytest.raises(ValueError, match=r"body2 must be elastic-plastic, .* no dent remains"):
        indent(GRID, BALL, [Particle(**PARTICLE)])
    outside = Particle(**PARTICLE, x=80e-6)
    with pytest.raises(ValueError, match=r"^x of particles\[1\] must be between -7\.5e-05 and 7"):
        indent(GRID, STEEL, [Particle(**PARTICLE), outside])
    harder = sc.Material.swift(210e9, 0.3, 1280e6, 4.0, 0.095)
    with pytest.raises(ValueError, match=r"body2 must be the body with the dents, .* got Material"):
        roll_over(GRID, BALL, harder, dented, gap, load=1.0, distance=6e-5, step=6e-6)
    with pytest.raises(ValueError, match="must be at most 10000 particles"):
        particles(1.0, 1.0, 1e9, 5e-6, seed=1)


@pytest.mark.parametrize(
    "changed", [{"distance": 3.3 * CELL}, {"step": 1.5 * CELL}, {"middle": 0.5 * CELL}]
)
def test_parts_of_cells_are_refused(changed):
    track = sc.Simulation(GRID, BALL, STEEL, np.zeros(GRID.surface_shape)).state.track()
    given = {"distance": 4 * CELL, "step": CELL, "middle": 0.0} | changed
    with pytest.raises(ValueError, match=f"^{next(iter(changed))} must be a whole number of cells"):
        roll_over(GRID, BALL, STEEL, track, np.zeros(GRID.surface_shape), load=1.0, **given)
