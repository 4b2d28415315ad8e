# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies with inclusions in a simulation, against closed forms and equivalent cases."""

import pickle

import numpy as np
import pytest

import samcontact as sc
import spheres_in_stress

STEEL = sc.Material.elastic(210e9, 0.3)
YIELDING = sc.Material.linear_hardening(210e9, 0.3, 1.5e9, 9.5e9)
STIFF = sc.Material.elastic(400e9, 0.25)
SOFT = sc.Material.elastic(60e9, 0.33)
RIGID = sc.Material.rigid()
R, H = 1e-4, 25e-6
GRID = sc.Grid(25, 25, H, H, dz=H)
LOAD = 60.0


def sphere(material, x=0.0, misfit=0.0, z=2e-4):
    return sc.Inclusion.sphere((x, 0.0, z), R, material, misfit=misfit)


def simulation(body, body1=RIGID, grid=GRID, **more):
    gap = sc.surfaces.paraboloid(grid, 5e-3)
    return sc.Simulation(grid, body1, body, gap, on_border="warn", **({"tol": 1e-4} | more))


@pytest.mark.parametrize("material", [STEEL, YIELDING])
def test_inclusion_of_the_material_of_the_matrix(material):
    """Digits are those of the homogeneous body."""
    same = sc.Heterogeneous(material, [sphere(material)])
    a, b = (simulation(body).step(load=LOAD) for body in (material, same))
    np.testing.assert_array_equal(a.pressure, b.pressure)
    np.testing.assert_array_equal(a.stress(2), b.stress(2))
    assert b.share(2).max() == 1.0


# Root mean square error of the matrix within 1.5 radii, relative to the disturbance there, and of
# the mean stress of the sphere, relative to its deviation.
SPHERES = [
    (0.0, 4, 0.085, 0.03),
    (0.3, 4, 0.075, 0.04),
    (2.0, 4, 0.062, 0.06),
    pytest.param(0.0, 8, 0.06, 0.02, marks=pytest.mark.slow),
    pytest.param(0.3, 8, 0.045, 0.025, marks=pytest.mark.slow),
    pytest.param(2.0, 8, 0.036, 0.035, marks=pytest.mark.slow),
]


@pytest.mark.parametrize("matrix", [STEEL, YIELDING])
def test_evaluations_at_a_modulus_ratio_of_ten(matrix):
    """Each increment takes at most nine; plastic flow starts next to the sphere."""
    body = sc.Heterogeneous(matrix, [sphere(sc.Material.elastic(2100e9, 0.25))])
    sim = simulation(body, tol=1e-3)
    states = [sim.step(load=load) for load in (0.2 * LOAD, 0.4 * LOAD, LOAD)]
    assert (states[-1].max_equivalent_plastic_strain(2) > 0) == (matrix is YIELDING)
    assert max(state.iterations + 1 for state in states) <= 9


@pytest.mark.parametrize(("ratio", "per_radius", "matrix", "inside"), SPHERES)
def test_sphere_in_uniform_stress(ratio, per_radius, matrix, inside):
    """Eshelby's sphere and Goodier's void, four radii below a surface that carries no traction."""
    around, within = spheres_in_stress.errors(ratio, per_radius)
    assert around < matrix
    assert within < inside


@pytest.mark.parametrize(("per_radius", "mean", "largest"), [(4, 1e-3, 4e-3), (8, 1e-4, 5e-4)])
def test_misfit_sphere(per_radius, mean, largest):
    """Surface of a dilating sphere: Mindlin and Cheng (1950), doi:10.1063/1.1699785."""
    h = R / per_radius
    n = 8 * per_radius + 1
    grid = sc.Grid(n, n, h, h, dz=h)
    strain, depth = 1e-3, 1.5 * R
    body = sc.Heterogeneous(STEEL, [sphere(STEEL, misfit=strain, z=depth)])
    found = simulation(body, grid=grid, image_tol=1e-5).state.residual_displacement(2)
    r2 = grid.x[:, None] ** 2 + grid.y**2
    expected = -4 / 3 * 1.3 * strain * R**3 * depth / (r2 + depth**2) ** 1.5
    error = found - expected
    assert np.linalg.norm(error) < mean * np.linalg.norm(expected)
    assert np.abs(error).max() < largest * np.abs(expected).max()


@pytest.mark.parametrize("matrix", [STEEL, YIELDING])
def test_swapped_and_mirrored_bodies(matrix):
    """The upper body with an inclusion at x gives the mirrored stress of the lower one at -x."""
    one = sc.Heterogeneous(matrix, [sphere(STIFF, x=6e-5)])
    other = sc.Heterogeneous(matrix, [sphere(SOFT, x=-3e-5)])
    a = simulation(other, body1=one).step(load=LOAD)
    b = simulation(one, body1=other).step(load=LOAD)
    scale = np.abs(a.stress(1)).max()
    np.testing.assert_allclose(a.stress(1), b.stress(2), rtol=0, atol=1e-9 * scale)
    image = sc.Heterogeneous(matrix, [sphere(STIFF, x=-6e-5)])
    c = simulation(sc.Heterogeneous(matrix, [sphere(SOFT, x=3e-5)]), body1=image).step(load=LOAD)
    np.testing.assert_allclose(c.pressure[::-1], a.pressure, rtol=0, atol=1e-9 * a.pressure.max())


def test_voxels_of_a_sphere():
    """Voxels with the shares of a sphere give its digits."""
    body = sc.Heterogeneous(STEEL, [sphere(STIFF)])
    share = body.fraction_on(GRID)
    corner = (-12.5 * H, -12.5 * H, 0.0)
    voxels = sc.Heterogeneous.voxels(STEEL, STIFF, share, H, corner)
    a, b = (simulation(one).step(load=LOAD) for one in (body, voxels))
    np.testing.assert_allclose(
        b.stress(2), a.stress(2), rtol=0, atol=1e-9 * np.abs(a.stress(2)).max()
    )


def test_units():
    """Micrometres, with all stresses in units of TPa."""
    body = sc.Heterogeneous(YIELDING, [sphere(STIFF)])
    scaled = sc.Heterogeneous(
        sc.Material.linear_hardening(0.21, 0.3, 1.5e-3, 9.5e-3),
        [sc.Inclusion.sphere((0.0, 0.0, 200.0), 100.0, sc.Material.elastic(0.4, 0.25))],
    )
    grid = sc.Grid(25, 25, 25.0, 25.0, dz=25.0)
    gap = sc.surfaces.paraboloid(grid, 5e3)
    a = simulation(body).step(load=LOAD)
    b = sc.Simulation(grid, RIGID, scaled, gap, on_border="warn", tol=1e-4).step(load=LOAD)
    np.testing.assert_allclose(1e12 * b.pressure, a.pressure, rtol=1e-9, atol=1e-3)


def test_history_and_restart(tmp_path):
    """The strain before unloading is restored to every digit, and a copy of a state keeps it."""
    body = sc.Heterogeneous(
        YIELDING,
        [sphere(SOFT, misfit=5e-4), sc.Inclusion.void((0.0, 1e-4, 4e-4), 9e-5)],
    )
    sim = simulation(body, tol=1e-3)
    start = np.abs(sim.state.residual_stress(2)).max()
    assert start > 1e7
    loaded = sim.step(load=LOAD)
    sim.save(tmp_path / "kept")
    again = sc.Simulation.load(tmp_path / "kept")
    assert again.body2 == body
    a, b = (one.step(load=0.0) for one in (sim, again))
    np.testing.assert_array_equal(a.stress(2), b.stress(2))
    np.testing.assert_array_equal(a.plastic_strain(2), b.plastic_strain(2))
    np.testing.assert_array_equal(pickle.loads(pickle.dumps(a)).stress(2), a.stress(2))
    np.testing.assert_array_equal(a.disturbance(2), a.residual_stress(2))
    assert np.array_equal(loaded.phase(2) >= 0, loaded.share(2) > 0)


def test_unloaded_elastic_body():
    """Without misfit and yield nothing remains."""
    sim = simulation(sc.Heterogeneous(STEEL, [sphere(STIFF), sphere(SOFT, x=2.5e-4)]))
    loaded = sim.step(load=LOAD)
    rest = sim.step(load=0.0)
    assert np.abs(rest.stress(2)).max() < 1e-5 * np.abs(loaded.stress(2)).max()
    assert rest.max_plastic_strain_magnitude(2) == 0.0


def test_inclusion_moves_with_its_body():
    """A rolled-over inclusion acts like one that lies there."""
    body = sc.Heterogeneous(STEEL, [sphere(STIFF, x=-4 * H)])
    sim = simulation(body, tol=1e-6)
    sim.step(load=LOAD)
    moved = sim.step(load=LOAD, advance=(0.0, 4 * H))
    placed = simulation(sc.Heterogeneous(STEEL, [sphere(STIFF)]), tol=1e-6).step(load=LOAD)
    scale = np.abs(placed.stress(2)).max()
    np.testing.assert_array_equal(moved.phase(2), placed.phase(2))
    np.testing.assert_allclose(moved.stress(2), placed.stress(2), rtol=0, atol=1e-3 * scale)


def test_sliding_and_partial_slip():
    """The limits of partial slip: full sliding, and equilibrium of a smaller force."""
    body = sc.Heterogeneous(STEEL, [sphere(STIFF, x=5e-5)])
    sliding = simulation(body, friction=0.3).step(load=LOAD)
    slip = simulation(body, friction=sc.Coulomb(0.3))
    slip.step(load=LOAD)
    held = slip.step(load=LOAD, tangential_load=(0.1 * LOAD, 0.0))
    assert held.tangential_load[0] == pytest.approx(0.1 * LOAD, rel=1e-6)
    full = slip.step(load=LOAD, shift=(1e-3, None))
    assert np.hypot(*full.shear).sum() * H**2 == pytest.approx(0.3 * LOAD, rel=1e-6)
    scale = sliding.pressure.max()
    np.testing.assert_allclose(full.pressure, sliding.pressure, rtol=0, atol=1e-3 * scale)


def test_refusals():
    body = sc.Heterogeneous(STEEL, [sphere(STIFF)])
    with pytest.raises(ValueError, match='residual_stress = "exact" is not supported with them'):
        simulation(body, residual_stress="exact")
    with pytest.raises(ValueError, match="which only Simulation supports"):
        sc.ContactSolver(GRID, RIGID, body)
    hard = YIELDING.with_kinematic_hardening((5e9, 50.0))
    with pytest.raises(ValueError, match=r"phases\[0\] must not have kinematic hardening"):
        simulation(sc.Heterogeneous(STEEL, [sphere(hard)]))
    with pytest.raises(ValueError, match="must not have kinematic hardening if an inclusion"):
        simulation(sc.Heterogeneous(hard, [sphere(YIELDING)]))
    relaxing = STEEL.with_relaxation(times=[1.0], shares=[0.5])
    with pytest.raises(ValueError, match="inclusions in viscoelastic bodies"):
        simulation(sc.Heterogeneous(relaxing, [sphere(STIFF)]))


def test_prescribed_pressure_on_an_inclusion_off_the_axis():
    """A symmetric pressure does not make the inclusion symmetric."""
    body = sc.Heterogeneous(STEEL, [sphere(STIFF, x=6e-5, misfit=1e-3)])
    pressed = simulation(body).step(load=LOAD)
    given = simulation(body).step(pressure=0.5 * (pressed.pressure + pressed.pressure[::-1]))
    share = given.share(2)
    strained = np.abs(given.eigenstrain(2)).max(axis=0) > 0
    assert not strained[share == 0].any()
    assert strained[share > 0].all()
