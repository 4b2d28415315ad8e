# SPDX-License-Identifier: GPL-3.0-or-later
"""Periodic surfaces: lattice sums, contact, plasticity, and refused arguments."""

import pickle

import numpy as np
import pytest

import samcontact as sc
from samcontact import operators, surfaces

STEEL, RIGID = sc.Material.elastic(210e9, 0.3), sc.Material.rigid()
HARD = sc.Material.linear_hardening(210e9, 0.3, 1e9, 10e9)
# cells, sides, periodic directions, and repetitions of the surface along x and y
TILINGS = [
    ((16, 16), (1.0, 1.0), "xy", (2, 3)),
    ((64, 2), (1.0, 1.0), "xy", (1, 32)),  # rows whose ends are far apart
    ((64, 1), (1.0, 1.0), "xy", (1, 64)),  # plane strain
    ((1, 64), (1.0, 1.0), "xy", (64, 1)),
    ((12, 128), (2.0, 1.3), "xy", (7, 1)),
    ((30, 4), (1.0, 0.5), "y", (1, 4)),
    ((6, 4), (15.0, 0.5), "y", (1, 6)),  # cells longer than the period
    ((4, 2), (1.0, 1.0), "xy", (2, 8)),
    ((6, 40), (2.0, 1.0), "x", (5, 1)),
    ((30, 1), (1.0, 0.5), "y", (1, 6)),
]
DEPTHS = [0.0, 0.1, 1.0, 5.0, 40.0]


def grids(cells, sides, periodic, tiles, nz=0):
    """Return a grid in metres, and a grid that also contains its repetitions."""
    dz = 1e-6 if nz else None
    return [
        sc.Grid(*(n * t for n, t in zip(cells, times, strict=True)),
                *(1e-6 * d for d in sides), nz, dz, periodic=periodic)
        for times in ((1, 1), tiles)
    ]  # fmt: skip


@pytest.fixture
def rng():
    return np.random.default_rng(1)


@pytest.mark.parametrize(("cells", "sides", "periodic", "tiles"), TILINGS)
def test_a_surface_and_its_repetitions_agree(cells, sides, periodic, tiles, rng):
    """Tables are computed by different methods for different shapes of the period."""
    loads = rng.normal(size=(3, *cells)) * 1e9
    one, many = grids(cells, sides, periodic, tiles)
    wide = np.tile(loads, (1, *tiles))
    solvers = [sc.ContactSolver(grid, STEEL, STEEL) for grid in (one, many)]
    inside = (..., *(slice(n) for n in cells))
    for load in range(3):
        few, all_ = np.zeros_like(loads), np.zeros_like(wide)
        few[load], all_[load] = loads[load], wide[load]
        found, expected = (solver.displacement(p[0], p[1:])
                           for solver, p in zip(solvers, (few, all_), strict=True))  # fmt: skip
        np.testing.assert_allclose(found, expected[inside], atol=3e-11 * np.abs(expected).max())
        depths = 1e-6 * np.array(DEPTHS)
        found, expected = (solver.stress(p[0], depths, shear=p[1:])
                           for solver, p in zip(solvers, (few, all_), strict=True))  # fmt: skip
        np.testing.assert_allclose(found, expected[(*inside, slice(None))], atol=1e-11 * 1e9)


@pytest.mark.parametrize("periodic", ["x", "y", "xy"])
def test_work_of_one_traction_on_the_displacement_of_another_is_mutual(periodic, rng):
    grid = sc.Grid(8, 6, 1e-6, 1.5e-6, periodic=periodic)
    solver = sc.ContactSolver(grid, STEEL, STEEL)
    loads = rng.normal(size=(2, 3, *grid.surface_shape))  # s_x, s_y, p
    moved = [solver.displacement(load[2], load[:2]) for load in loads]
    work = np.sum(loads[0] * moved[1])
    assert abs(work - np.sum(loads[1] * moved[0])) < 1e-12 * np.abs(loads[0] * moved[1]).sum()


@pytest.mark.parametrize(("cells", "sides", "periodic", "tiles"), TILINGS)
def test_strain_and_its_repetitions_agree(cells, sides, periodic, tiles, rng):
    one, many = grids(cells, sides, periodic, tiles, nz=4)
    strain = 1e-3 * rng.normal(size=(6, *one.volume_shape))
    for axis, name in enumerate("xy"):
        if name not in periodic:  # a free box with nothing at its ends
            ends = np.abs(np.arange(cells[axis]) + 0.5 - cells[axis] / 2) > cells[axis] / 4
            strain[(slice(None),) * (axis + 1) + (ends,)] = 0
    wide = np.tile(strain, (1, *tiles, 1))
    inside = tuple(slice(n) for n in cells)
    for axis in "xyz":
        moved, expected = (operators.residual_displacement(g, e, 0.3, axis=axis)
                           for g, e in ((one, strain), (many, wide)))  # fmt: skip
        np.testing.assert_allclose(moved, expected[inside], atol=1e-9 * np.abs(expected).max())
    for image_tol in (1e-6, 1e-3):
        stress, expected = (
            operators.residual_stress(g, e, 210e9, 0.3, method="fast", image_tol=image_tol)
            for g, e in ((one, strain), (many, wide))
        )
        largest = np.abs(expected).max()
        np.testing.assert_allclose(
            stress, expected[(slice(None), *inside)], atol=image_tol * largest
        )


def test_stress_below_the_surface_is_the_fourier_series(rng):
    n, z = 8, 2.0
    pressure, s_x = rng.normal(size=(2, n, n))
    grid = sc.Grid(n, n, 1.0, 1.0, periodic="xy")
    waves = 2 * np.pi / n * np.arange(-45, 46)
    kx, ky = np.meshgrid(waves, waves, indexing="ij")
    q = np.hypot(kx, ky)
    cos = np.divide(kx, q, out=np.zeros_like(q), where=q > 0)
    spectra = [
        np.fft.fft2(p)[np.ix_(*2 * (np.arange(-45, 46) % n,))] / n**2
        * np.sinc(kx / (2 * np.pi)) * np.sinc(ky / (2 * np.pi))
        for p in (pressure, s_x)
    ]  # fmt: skip
    decay, y = np.exp(-q * z), q * z
    szz = -(1 + y) * decay * spectra[0] + 1j * cos * y * decay * spectra[1]
    sxz = 1j * cos * y * decay * spectra[0] + (cos**2 * y - 1) * decay * spectra[1]
    along = np.exp(1j * np.outer(np.arange(n), waves))
    found = sc.ContactSolver(grid, STEEL, RIGID).stress(pressure, [z], 1, shear=-s_x)[..., 0]
    for component, spectrum in ((2, szz), (4, sxz)):
        exact = (along @ spectrum @ along.T).real
        np.testing.assert_allclose(found[component], exact, atol=1e-12)


def test_uniform_strain_and_pressure():
    """A half-space cannot stretch in its plane."""
    grid = sc.Grid(8, 8, 1e-6, 1e-6, 4, 1e-6, periodic="xy")
    E, nu = 210e9, 0.3
    strain = np.zeros((6, *grid.volume_shape))
    strain[:] = np.array([1e-3, -2e-3, 1.5e-3, 3e-4, -2e-4, 5e-4]).reshape(6, 1, 1, 1)
    stress = operators.residual_stress(grid, strain, E, nu, method="fast")[:, 0, 0, 0]
    plane = E / (1 - nu**2)
    exact = [-plane * (1e-3 - nu * 2e-3), -plane * (-2e-3 + nu * 1e-3), 0, 0, 0,
             -E / (1 + nu) * 5e-4]  # fmt: skip
    np.testing.assert_allclose(stress, exact, atol=1e-9 * plane)
    lift = operators.residual_displacement(grid, strain, nu)
    stretch = 1.5e-3 + nu / (1 - nu) * (1e-3 - 2e-3)
    np.testing.assert_allclose(lift, -4e-6 * stretch, rtol=1e-9)
    # The displacement relative to far below is the sum of the shear of the layers.
    for axis, shear in (("x", -2e-4), ("y", 3e-4)):
        moved = operators.residual_displacement(grid, strain, nu, axis=axis)
        np.testing.assert_allclose(moved, -2 * 4e-6 * shear, rtol=1e-9)
    solver = sc.ContactSolver(grid, STEEL, STEEL)
    np.testing.assert_allclose(
        solver.stress(np.full(grid.surface_shape, 1e9), [3e-6])[:, 0, 0, 0],
        np.array([-nu / (1 - nu), -nu / (1 - nu), -1, 0, 0, 0]) * 1e9, atol=1.0,
    )  # fmt: skip


def bumps(periodic, tiles, cells=(32, 32)):
    """Return simulations of one ball on a periodic plane, and of several equal balls."""
    d, radius, nz = 2e-6, 5e-4, 14
    flat = sc.Grid(*cells, d, d)
    gap = surfaces.paraboloid(flat, radius, radius if cells[1] > 1 else np.inf)
    for times in ((1, 1), tiles):
        grid = sc.Grid(*(n * t for n, t in zip(cells, times, strict=True)), d, d, nz, d,
                       periodic=periodic)  # fmt: skip
        yield grid, np.tile(gap, times)


SETUPS = {
    "both directions": ("xy", (2, 1), HARD, 0.0, 1e-9),
    "kinematic, sliding": ("xy", (1, 2), HARD.with_kinematic_hardening(20e9), 0.3, 1e-9),
    "two bodies, along y": ("y", (1, 2), HARD, 0.0, 1e-3),
    "sliding, along x": ("x", (2, 1), HARD, 0.2, 1e-3),
}


@pytest.mark.parametrize("problem", SETUPS)
def test_plastic_contact_and_its_repetitions_agree(problem):
    periodic, tiles, material, friction, rel = SETUPS[problem]
    upper = material if "two" in problem else RIGID
    results = []
    for grid, gap in bumps(periodic, tiles):
        simulation = sc.Simulation(grid, upper, material, gap, friction)
        times = np.prod(tiles) if grid.nx * grid.ny > 32 * 32 else 1
        loaded, unloaded = (simulation.step(load=load * times) for load in (1.2, 0.0))
        results.append([
            loaded.pressure, loaded.equivalent_plastic_strain(2),
            unloaded.residual_stress(2)[0], unloaded.residual_displacement(2),
        ])  # fmt: skip
    for found, expected in zip(*results, strict=True):
        part = expected[:32, :32]
        assert np.abs(part).max() > 0
        np.testing.assert_allclose(found, part, atol=rel * np.abs(part).max())


def test_rolling_of_a_plastic_line_contact():
    """Strain remains behind along the free direction; one cell and many cells agree."""
    prints = []
    for grid, gap in bumps("y", (1, 2), (48, 1)):
        simulation = sc.Simulation(grid, RIGID, HARD, gap)
        load = 0.08 * grid.ny
        simulation.step(load=load)
        for _ in range(3):
            state = simulation.step(load=load, advance=(2 * grid.dx, 2 * grid.dx))
        prints.append(state.equivalent_plastic_strain(2))
    assert prints[0].max() > 1e-3
    np.testing.assert_allclose(prints[0], prints[1][:, :1], atol=1e-9 * prints[0].max())


@pytest.mark.parametrize("hurst", [0.3, 0.8])
def test_near_full_contact_costs_no_more_than_half_of_it(hurst):
    grid = sc.Grid(128, 128, 1e-6, 1e-6, periodic="xy")
    heights = surfaces.rough_self_affine(grid, 1e-7, hurst, seed=3, wavelength_min=8e-6)
    solver = sc.ContactSolver(grid, STEEL, RIGID)
    gap = heights.max() - heights
    # in full contact the pressure variation is independent of the mean
    full = solver.solve(gap, load=1e3)
    minimum = full.load - full.pressure.min() * grid.cell_area * grid.nx * grid.ny
    found = [solver.solve(gap, load=share * minimum) for share in (0.15, 0.9, 1.001)]
    half, nearly, all_ = (np.mean(solution.pressure > 0) for solution in found)
    assert 0.3 < half < 0.6
    assert 0.98 < nearly < 1
    assert all_ == 1
    assert max(found[1].work, found[2].work) < 2 * found[0].work


@pytest.mark.parametrize(
    ("body1", "friction"),
    [(STEEL, 0.0), (STEEL, sc.Coulomb(0.3)), (RIGID, 0.3)],
)
@pytest.mark.parametrize("unevenness", [0.0, 1e-17, 1e-9])
@pytest.mark.parametrize("away", [0.0, 3e-6])
@pytest.mark.parametrize("shape", [(4, 14), (6, 22), (16, 16), (20, 22)])
def test_flat_surfaces_carry_a_uniform_pressure(shape, away, unevenness, body1, friction):
    """Displacements are close to rounding, so errors must not be measured relative to them."""
    grid = sc.Grid(*shape, 1e-6, 1e-6, periodic="xy")
    if away:
        unevenness = min(unevenness, 1e-17)  # otherwise digits are lost
    gap = away + 1e-6 * unevenness * np.random.default_rng(1).random(shape)
    solver = sc.ContactSolver(grid, body1, STEEL, friction, tol=1e-10)
    solution = solver.solve(gap, load=1e9 * grid.cell_area * gap.size)
    np.testing.assert_allclose(solution.pressure, 1e9, rtol=1e-12 + 1e3 * unevenness)
    assert solution.approach == pytest.approx(gap.mean(), abs=1e-20, rel=1e-14)


def test_coupling_of_dissimilar_flat_bodies_is_rounding():
    grid = sc.Grid(16, 16, 1e-6, 1e-6, periodic="xy")
    gap = 1e-23 * np.random.default_rng(1).random((16, 16))
    solver = sc.ContactSolver(grid, RIGID, STEEL, sc.Coulomb(0.3), tol=1e-10)
    solution = solver.solve(gap, load=1e9 * grid.cell_area * gap.size)
    np.testing.assert_allclose(solution.pressure, 1e9, rtol=1e-12)
    assert not solution.shear.any()


def test_approach_is_between_mean_planes():
    grid = sc.Grid(32, 32, 1e-6, 1e-6, periodic="xy")
    gap = 1e-7 * (1 - np.cos(2 * np.pi * grid.x / 32e-6))[:, None] + np.zeros(32)
    solver = sc.ContactSolver(grid, STEEL, RIGID)
    full = solver.solve(gap, load=100.0)
    assert full.approach == pytest.approx(gap.mean(), rel=1e-9)
    partial = solver.solve(gap, approach=0.5 * gap.mean())
    assert solver.solve(gap, load=partial.load).approach == pytest.approx(partial.approach)
    with pytest.raises(ValueError, match="approach must be less than the mean gap"):
        solver.solve(gap, approach=1.01 * gap.mean())


def test_a_contact_across_the_period_end_equals_one_in_the_middle():
    grid = sc.Grid(64, 64, 1e-6, 1e-6, periodic="xy")
    gap = surfaces.sphere(grid, 1e-4)
    solver = sc.ContactSolver(grid, STEEL, RIGID)
    middle = solver.solve(gap, load=0.05)
    seam = solver.solve(np.roll(gap, (32, 32), (0, 1)), load=0.05)
    np.testing.assert_allclose(np.roll(seam.pressure, (32, 32), (0, 1)), middle.pressure,
                               atol=1e-6 * middle.pressure.max())  # fmt: skip


def test_the_grid_keeps_its_directions(tmp_path):
    grid = sc.Grid(16, 1, 1e-6, 1e-6, 8, 1e-6, periodic="y")
    assert pickle.loads(pickle.dumps(grid)) == grid
    assert "periodic" in repr(grid)
    simulation = sc.Simulation(grid, RIGID, HARD, surfaces.paraboloid(grid, 1e-4, np.inf))
    simulation.step(load=1e-3)
    simulation.save(tmp_path / "line.h5")
    other = sc.Simulation.load(tmp_path / "line.h5")
    assert other.grid == grid
    states = [s.step(load=2e-3) for s in (simulation, other)]
    np.testing.assert_array_equal(states[0].pressure, states[1].pressure)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"periodic": "yx"}, "periodic must be one of '', 'x', 'y', 'xy', got 'yx'"),
        ({"periodic": None}, "periodic must be one of"),
        ({"nx": 15, "periodic": "x"}, "nx must be even, or 1, on .* along x, got 15"),
        ({"ny": 7, "periodic": "xy"}, "ny must be even, or 1"),
        ({"nx": 1, "ny": 1, "periodic": "xy"}, "nx or ny must be > 1"),
        ({"ny": 2, "dy": 1e-12, "periodic": "y"}, "dx must be at most 8 periods ny dy of the grid"),
    ],
)
def test_invalid_periodic_grids_are_refused(arguments, words):
    with pytest.raises(ValueError, match=words):
        sc.Grid(**({"nx": 16, "ny": 16, "dx": 1e-6, "dy": 1e-6} | arguments))


def test_options_unsupported_on_periodic_surfaces_are_refused():
    grid = sc.Grid(16, 16, 1e-6, 1e-6, 4, 1e-6, periodic="xy")
    gap = np.zeros(grid.surface_shape)
    hot = STEEL.with_thermal(46.0, 11e-6, 13e-6)
    with pytest.raises(ValueError, match=r"heat\.factor of body2 must be 0 on a periodic grid"):
        sc.ContactSolver(grid, STEEL, hot, heat=sc.Heat((0.0, 0.1)))
    with pytest.raises(ValueError, match=r'residual_stress must be "fast" on a periodic grid'):
        sc.Simulation(grid, RIGID, HARD, gap, residual_stress="exact")
    with pytest.raises(ValueError, match='method must be "fast"'):
        operators.residual_stress(grid, np.zeros((6, *grid.volume_shape)), 1.0, 0.3)
    with pytest.raises(ValueError, match=r"heat\.track must be None on a grid that is periodic"):
        sc.Simulation(grid, hot, hot, gap, heat=sc.Heat(0.1, history=(1e-6, 1e-3), track=1e-5))
