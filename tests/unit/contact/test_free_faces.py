# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic bodies that end at free faces across y."""

import numpy as np
import pytest
from contact_setups import RADIUS, RIGID, STEEL

import samcontact as sc
from samcontact import results, surfaces

pytestmark = pytest.mark.filterwarnings("ignore::samcontact.SingularPressureWarning")
GRID = sc.Grid(24, 20, 10e-6, 10e-6)
FACE = 60e-6
LOAD = 20.0
ENDED = STEEL.with_free_faces(high=FACE)
OTHER = sc.Material.elastic(70e9, 0.33)


def ball(grid):
    return surfaces.paraboloid(grid, RADIUS)


def love(x, y, dx, dy):
    """Return pi E* u_z at a distance from a cell under unit pressure (Love 1929)."""
    total = 0.0
    for sx in (-1, 1):
        for sy in (-1, 1):
            X, Y = x + sx * dx / 2, y + sy * dy / 2
            total += sx * sy * (X * np.arcsinh(Y / abs(X)) + Y * np.arcsinh(X / abs(Y)))
    return total


@pytest.mark.parametrize("side", ["low", "high"])
def test_the_factor_on_mirrored_pressure(side):
    """The gap is the direct sum over all cells and their images, Guilbault (2011)."""
    grid = sc.Grid(12, 9, 10e-6, 12e-6)
    face = 18e-6 if side == "high" else -18e-6  # five rows are beyond the face or next to it
    body = OTHER.with_free_faces(**{side: face}, method="factor")
    found = sc.ContactSolver(grid, STEEL, body).solve(ball(grid), load=0.05)
    beyond = grid.y > face if side == "high" else grid.y < face
    assert np.all(found.gap[:, beyond] == np.inf)
    assert not found.pressure[:, beyond].any()
    factor = 1.29 - (0.08 - 0.5 * 0.33) / (1 - 0.33)
    x, y = (axis.ravel() for axis in np.meshgrid(grid.x, grid.y, indexing="ij"))
    across = x[:, None] - x
    direct = love(across, y[:, None] - y, grid.dx, grid.dy)
    image = love(across, y[:, None] - (2 * face - y), grid.dx, grid.dy)
    p = found.pressure.ravel()
    of_steel, of_other = ((1 - b.nu**2) / b.E / np.pi for b in (STEEL, OTHER))
    u = of_steel * direct @ p + of_other * (direct + factor * image) @ p
    gap = ball(grid) + u.reshape(grid.surface_shape) - found.approach
    error = np.abs(found.gap - gap)[:, ~beyond] / found.approach
    next_to_face = -1 if side == "high" else 0  # the mean over the cell, not its centre
    assert error[:, next_to_face].max() < 1e-2
    assert np.delete(error, next_to_face, axis=1).max() < 1e-3


@pytest.mark.parametrize("method", ["exact", "factor"])
def test_a_distant_face_leaves_the_half_space(method):
    """The pressure tends to the one of half-spaces; the approach grows by that of the images."""
    face = 4e-3
    body = STEEL.with_free_faces(high=face, method=method)
    whole, ended = (sc.ContactSolver(GRID, RIGID, b).solve(ball, load=LOAD) for b in (STEEL, body))
    np.testing.assert_allclose(ended.pressure, whole.pressure, atol=1e-3 * whole.pressure.max())
    image = LOAD * (1 - STEEL.nu**2) / (np.pi * STEEL.E * 2 * face)
    assert 1.2 * image < ended.approach - whole.approach < 1.8 * image


def test_two_faces():
    """The effect of a distant second face decreases; equal distances give a symmetric pressure."""
    near = sc.ContactSolver(GRID, RIGID, ENDED).solve(ball, load=LOAD).pressure
    change = []
    for low in (-4e-3, -8e-3):
        both = STEEL.with_free_faces(low=low, high=FACE)
        found = sc.ContactSolver(GRID, RIGID, both).solve(ball, load=LOAD).pressure
        change.append(abs(found - near).max() / near.max())
    assert change[1] < 0.3 * change[0] < 0.0003
    equal = STEEL.with_free_faces(low=-FACE, high=FACE)
    found = sc.ContactSolver(GRID, RIGID, equal).solve(ball, load=LOAD)
    np.testing.assert_allclose(
        found.pressure[:, ::-1], found.pressure, atol=1e-7 * found.pressure.max()
    )


def test_mirror_and_exchange_of_bodies():
    """A low face mirrors a high face; with one body at each end the bodies may be exchanged."""
    first = sc.ContactSolver(GRID, OTHER, ENDED).solve(ball, load=LOAD)
    low = STEEL.with_free_faces(low=-FACE)
    for bodies in ((OTHER, low), (low, OTHER)):
        second = sc.ContactSolver(GRID, *bodies).solve(ball, load=LOAD)
        np.testing.assert_allclose(
            second.pressure[:, ::-1], first.pressure, atol=1e-7 * first.pressure.max()
        )
        assert second.approach == pytest.approx(first.approach, rel=1e-8)


def test_the_approach_that_gives_the_load():
    """Load and approach control agree, on cells that are coarsened for the start as well."""
    grid = sc.Grid(64, 80, 4e-6, 4e-6)
    solver = sc.ContactSolver(grid, ENDED, ENDED)
    first = solver.solve(ball(grid), load=LOAD)
    second = solver.solve(ball(grid), approach=first.approach)
    assert second.load == pytest.approx(LOAD, rel=1e-6)
    assert first.iterations < 100


def test_simulation_checkpoint_and_results(tmp_path):
    """A simulation gives the contact, and its files hold the faces."""
    expected = sc.ContactSolver(GRID, OTHER, ENDED).solve(ball, load=LOAD)
    simulation = sc.Simulation(GRID, OTHER, ENDED, ball)
    state = simulation.step(load=LOAD)
    np.testing.assert_allclose(
        state.pressure, expected.pressure, atol=1e-7 * expected.pressure.max()
    )
    simulation.save(tmp_path / "saved.h5")
    loaded = sc.Simulation.load(tmp_path / "saved.h5", gap=ball)
    assert loaded.body2 == ENDED
    np.testing.assert_array_equal(loaded.state.pressure, state.pressure)
    attributes = results.to_dataset(simulation, [state]).attrs
    assert attributes["body2_free_faces_high"] == FACE
    assert attributes["body2_free_faces_method"] == "exact"


def test_a_plastic_half_space_under_a_body_that_ends():
    """The other body may yield; two faces that are mirrored give symmetric fields."""
    grid = sc.Grid(16, 16, 20e-6, 20e-6, dz=20e-6)
    soft = sc.Material.linear_hardening(210e9, 0.3, 0.8e9, 20e9)
    strains = []
    for faces in ({"low": -100e-6, "high": 100e-6}, {"high": 100e-6}):
        simulation = sc.Simulation(grid, STEEL.with_free_faces(**faces), soft, ball)
        state = simulation.step(load=150.0)
        strains.append(state.equivalent_plastic_strain(2))
    both, one = strains
    assert both.max() > 1e-4
    np.testing.assert_allclose(both[:, ::-1], both, atol=1e-6 * both.max())
    assert np.abs(one[:, ::-1] - one).max() > 1e-3 * one.max()


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: STEEL.with_free_faces(), "low face, a high face or both"),
        (lambda: STEEL.with_free_faces(1e-3, -1e-3), "low of free_faces must be less than high"),
        (lambda: STEEL.with_free_faces(0.0, method="fast"), "method of free_faces"),
        (lambda: RIGID.with_free_faces(0.0), "requires an elastic material"),
        (
            lambda: sc.Material.perfect_plastic(2e11, 0.3, 1e9).with_free_faces(0.0),
            "requires an elastic material",
        ),
        (lambda: sc.Layered([(STEEL, 1e-3)], ENDED), "substrate must not have free_faces"),
        (
            lambda: sc.ContactSolver(GRID, STEEL, STEEL.with_free_faces(high=61e-6)).solve(
                ball, load=1.0
            ),
            "edges of cells",
        ),
        (
            lambda: sc.ContactSolver(
                GRID, STEEL.with_free_faces(high=-FACE), STEEL.with_free_faces(low=FACE)
            ).solve(ball, load=1.0),
            "common range of y",
        ),
        (lambda: sc.ContactSolver(GRID, OTHER, ENDED, 0.1), "friction or heat"),
        (lambda: sc.Simulation(GRID, OTHER, ENDED, ball, 0.1), "friction or heat"),
        (lambda: sc.ContactSolver(GRID, OTHER, ENDED, sc.Coulomb(0.1)), "due to shear"),
        (
            lambda: sc.Simulation(sc.Grid(8, 8, 1e-5, 1e-5, periodic="x"), OTHER, ENDED, ball),
            "cannot be combined with grid.periodic",
        ),
        (
            lambda: sc.ContactSolver(GRID, OTHER, ENDED).stress(np.zeros((24, 20)), [1e-5]),
            "stress is not known in a body with free faces",
        ),
        (
            lambda: sc.ContactSolver(GRID, OTHER, ENDED).displacement(np.zeros((24, 20))),
            "is not known in a body with free faces",
        ),
    ],
)
def test_what_is_not_known_is_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()


def test_stress_at_several_depths_is_refused():
    """Each thread computes a depth; an error that left the loop over them would end the process."""
    grid = sc.Grid(24, 20, 10e-6, 10e-6, 3, 10e-6)
    state = sc.Simulation(grid, OTHER, ENDED, ball).step(load=LOAD)
    with pytest.raises(ValueError, match="stress is not known in a body with free faces"):
        state.stress(2)


def test_faces_in_millimetres_are_refused():
    with pytest.raises(ValueError, match=r"free_faces must be within 2 m .* y = -5\.0 m: milli"):
        sc.Material.elastic(210e9, 0.3).with_free_faces(-5.0, 5.0)


def test_a_grid_that_ends_at_a_face_is_given_more_rows():
    grid = sc.Grid(40, 12, 10e-6, 10e-6)
    ended = STEEL.with_free_faces(-FACE, FACE)
    remedy = r"a row of cells beyond the free face at y = -60 µm and y = 60 µm: use ny = 14 with dy"
    with pytest.raises(sc.GridTooSmallError, match=remedy) as caught:
        sc.ContactSolver(grid, ended, ended).solve(ball(grid), load=LOAD)
    assert "detrend" not in str(caught.value)
    wider = sc.Grid(40, 14, 10e-6, 10e-6)
    assert sc.ContactSolver(wider, ended, ended).solve(ball(wider), load=LOAD).load == LOAD
