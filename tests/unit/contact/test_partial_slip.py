# SPDX-License-Identifier: GPL-3.0-or-later
"""Partial slip against exact superpositions, closed forms and digits of CONTACT."""

import math

import numpy as np
import pytest
from scipy import special

import samcontact as sc

SOFT = sc.Material.elastic(2.0, 0.0)  # E* = 1 with itself
MU = 0.3


def two_balls(n, contact_radius, nu=0.0, tol=1e-8, mu=MU):
    """Return solver, gap, load and sum of (2 - nu)/G of a ball of radius 1 m on 1 m x 1 m."""
    grid = sc.Grid(n, n, 1 / n, 1 / n)
    body = sc.Material.elastic(2 * (1 - nu * nu), nu)
    solver = sc.ContactSolver(grid, body, body, sc.Coulomb(mu), tol=tol)
    load = 4 / 3 * contact_radius**3
    return solver, sc.surfaces.paraboloid(grid, 1.0), load, 2 * (2 - nu) * (1 + nu) / (1 - nu * nu)


def frictionless(solver, gap, load, tol=1e-11):
    bodies = solver.body1, solver.body2
    pressed = sc.ContactSolver(solver.grid, *bodies, tol=tol, on_border=solver.on_border)
    return pressed.solve(gap, load=load)


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
@pytest.mark.parametrize("cells", [(64, 64, 1 / 64, 1 / 64), (40, 72, 1 / 40, 1 / 90)])
def test_loops_are_superpositions_of_frictionless_contacts(cells):
    """Theorem of Jaeger and Ciavarella, exact on any grid if slip has no transverse effect."""
    grid = sc.Grid(*cells)
    heights = sc.surfaces.rough_self_affine(grid, 2e-3, 0.8, seed=7)
    gap = sc.surfaces.paraboloid(grid, 2.0) + heights - heights.min()
    solver = sc.ContactSolver(grid, SOFT, SOFT, sc.Coulomb(MU), tol=1e-8, on_border="warn")
    load, top, back = 0.01, 0.6, -0.2
    whole, outer, inner = (
        frictionless(solver, gap, load * share) for share in (1, 1 - top, 1 - (top - back) / 2)
    )
    ratio = 1.0  # of tangential to normal compliance at nu = 0: E* c_G/2

    def force(share):
        return {"tangential_load": (share * MU * load, 0.0)}

    first = solver.solve(gap, load=load, **force(top))
    scale = MU * whole.pressure.max()
    expected = MU * (whole.pressure - outer.pressure)
    assert np.abs(first.shear[0] - expected).max() < 1e-7 * scale
    assert np.abs(first.shear[1]).max() < 1e-7 * scale
    shift = MU * ratio * (whole.approach - outer.approach)
    assert first.shift == pytest.approx([shift, 0.0], rel=1e-7, abs=1e-9 * abs(shift))
    assert np.array_equal(first.sticking, (outer.pressure > 0) & (whole.pressure > 0))

    second = solver.solve(gap, load=load, **force(back), previous=first)
    expected -= 2 * MU * (whole.pressure - inner.pressure)
    assert np.abs(second.shear[0] - expected).max() < 1e-7 * scale
    shift -= 2 * MU * ratio * (whole.approach - inner.approach)
    assert second.shift[0] == pytest.approx(shift, rel=1e-6)
    # the loop closes where it began
    third = solver.solve(gap, load=load, **force(top), previous=second)
    assert np.abs(third.shear - first.shear).max() < 1e-7 * scale
    assert third.shift == pytest.approx(first.shift, rel=1e-6, abs=1e-9 * abs(shift))


@pytest.mark.parametrize(("nu", "tolerance"), [(0.0, 1.6e-3), (0.3, 1.6e-3)])
def test_cattaneo_and_mindlin(nu, tolerance):
    solver, gap, load, softness = two_balls(64, 0.4, nu)
    for share in (0.1, 0.5, 0.9):
        found = solver.solve(gap, load=load, tangential_load=(share * MU * load, 0.0))
        shift = 3 * MU * load * softness / (16 * 0.4) * (1 - (1 - share) ** (2 / 3))
        assert found.shift[0] == pytest.approx(shift, rel=tolerance)
        stick = math.sqrt(found.sticking.sum() * solver.grid.cell_area / math.pi)
        assert stick == pytest.approx(0.4 * (1 - share) ** (1 / 3), rel=0.03)
        assert found.tangential_load == pytest.approx([share * MU * load, 0.0], abs=1e-9 * load)
        assert found.tangential_error <= 1e-8
        assert np.hypot(*found.shear).max() <= MU * found.pressure.max() * (1 + 1e-12)


def test_work_of_a_loop():
    """Work agrees with Mindlin and Deresiewicz at 26 cells per radius."""
    solver, gap, load, softness = two_balls(64, 0.4, tol=1e-7)
    f, state, works = 0.9, None, []
    for share in (f, -f, f, -f, f):
        drive = {"tangential_load": (share * MU * load, 0.0)}
        state = solver.solve(gap, load=load, **drive, previous=state)
        works.append(state.friction_work)
    loop = 1 - (1 - f) ** (5 / 3) - 5 * f / 6 * (1 + (1 - f) ** (2 / 3))
    expected = 9 * MU**2 * load**2 * softness / (10 * 0.4) * loop
    assert works[2] - works[0] == pytest.approx(expected, rel=1e-3)
    assert works[4] - works[2] == pytest.approx(works[2] - works[0], rel=1e-6)


def test_torsion_of_a_ball():
    """Lubkin's solution for any Poisson's ratio, with prescribed moment and prescribed rotation."""
    solver, gap, load, _ = two_balls(64, 0.4, 0.3)
    a = 0.4
    peak, softness = 1.5 * load / (math.pi * a * a), 2 * 2 * 1.3 / (2 * 0.91)

    def slipped(t):
        modulus = 1 - (t / a) ** 2
        return a * (special.ellipk(modulus) - special.ellipe(modulus))

    for c in (0.8 * a, 0.5 * a, 0.3 * a):
        t = c + (a - c) * (np.polynomial.legendre.leggauss(40)[0] + 1) / 2
        weights = np.polynomial.legendre.leggauss(40)[1] * (a - c) / 2
        moment = 8 * MU * peak / (3 * a) * (c**3 * slipped(c) + 3 * weights @ (t**2 * slipped(t)))
        twist = MU * peak * softness / (2 * a) * slipped(c)
        moved = solver.solve(gap, load=load, tangential_load=(0.0, 0.0), torque=moment)
        assert moved.twist == pytest.approx(twist, rel=1.5e-3)
    assert moved.torque == pytest.approx(moment, rel=1e-8)
    rotated = solver.solve(gap, load=load, twist=moved.twist)
    assert rotated.torque == pytest.approx(moment, rel=1e-6)
    assert np.abs(rotated.shear - moved.shear).max() < 1e-6 * MU * peak


def test_full_sliding_is_the_limit_of_a_large_shift():
    for nu, tolerance in ((0.0, 1e-12), (0.3, 1e-3)):
        solver, gap, load, _ = two_balls(32, 0.4, nu)
        found = solver.solve(gap, load=load, shift=(3.0, 4.0))
        bound = MU * found.pressure
        expected = np.multiply.outer((0.6, 0.8), bound)
        assert np.abs(found.shear - expected).max() < tolerance * bound.max()
        assert not found.sticking.any()
        assert np.allclose(np.hypot(*found.shear), bound, rtol=1e-12)
        upper, lower = (solver.displacement(found.pressure, found.shear, b)[:2] for b in (1, 2))
        slip = np.array([[[3.0]], [[4.0]]]) - (lower - upper)
        work = np.sum(found.shear * slip) * solver.grid.cell_area
        assert found.friction_work == pytest.approx(work, rel=1e-12)


def test_no_slip_is_infinite_friction():
    """Mindlin's stiffness 8 a/S without slip, up to the edge where the shear has no limit."""
    solver, gap, load, softness = two_balls(64, 0.4, mu=math.inf)
    found = solver.solve(gap, load=load, tangential_load=(1e-3, 0.0))
    assert found.shift[0] == pytest.approx(1e-3 * softness / (8 * 0.4), rel=0.01)
    assert found.friction_work == 0.0
    assert np.array_equal(found.sticking, found.pressure > 0)
    assert math.isnan(found.energy_gap)


def test_ball_agrees_with_contact():
    """Cattaneo's problem of the examples of CONTACT, to its printed digits."""
    grid = sc.Grid(19, 19, 0.13333, 0.13333)
    body = sc.Material.elastic(2 * 200 * 1.42, 0.42)
    solver = sc.ContactSolver(grid, body, body, sc.Coulomb(0.4))
    gap = sc.surfaces.paraboloid(grid, 50.0)
    load = 9.1954
    found = solver.solve(gap, load=load, tangential_load=(0.875 * 0.4 * load, 0.0))
    assert np.count_nonzero(found.pressure) == 177
    assert np.count_nonzero(found.sticking) == 45
    assert found.shift[0] == pytest.approx(8.155e-3, abs=5e-7)
    assert found.approach == pytest.approx(1.998e-2, abs=5e-6)
    assert found.pressure.max() == pytest.approx(4.393, abs=5e-4)
    assert found.friction_work == pytest.approx(2.750e-3, abs=1e-6)  # mm N; printed in J
    upper, lower = (solver.displacement(found.pressure, found.shear, b) for b in (1, 2))
    moved = [lower[0] - upper[0], lower[1] - upper[1], lower[2] + upper[2]]
    elastic = 0.5 * grid.cell_area * np.sum([*found.shear, found.pressure] * np.array(moved))
    assert elastic == pytest.approx(8.525e-2, abs=5e-5)
    size = np.hypot(*found.shear)[2:10, 9]
    assert size == pytest.approx([0.575, 1.06, 1.31, 1.49, 1.09, 0.948, 0.895, 0.879], rel=5e-3)


@pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
@pytest.mark.parametrize("share", [0.3, 0.64, 0.9])
def test_line_contact_agrees_with_contact(share):
    """Carter's cylinders of the examples of CONTACT, pressed and pulled; one row of long cells."""
    grid = sc.Grid(55, 1, 0.04, 200.0)
    body = sc.Material.elastic(2 * 82000 * 1.28, 0.28)
    solver = sc.ContactSolver(grid, body, body, sc.Coulomb(0.3), on_border="warn")
    gap = 0.001 * (np.asarray(grid.x)[:, None] + 0.07) ** 2
    load = 35780.0
    pressed = solver.solve(gap, load=load)
    assert np.count_nonzero(pressed.pressure) == 50
    assert pressed.pressure.max() == pytest.approx(113.9, abs=0.05)
    assert pressed.approach == pytest.approx(6.492e-3, abs=5e-7)
    force = (share * 0.3 * load, 0.0)
    pulled = solver.solve(gap, load=load, tangential_load=force, previous=pressed)
    # plane strain: C = K E* c_G/2, but for the ends of the cells
    outer = frictionless(solver, gap, (1 - share) * load)
    expected = 0.3 * (pressed.pressure - outer.pressure)
    assert np.abs(pulled.shear[0] - expected).max() < 1e-4 * expected.max()
    assert np.array_equal(pulled.sticking, outer.pressure > 0)
    assert pulled.tangential_applications <= 8


SMALL_GRID = sc.Grid(16, 16, 1 / 16, 1 / 16)
BALL = sc.surfaces.paraboloid(SMALL_GRID, 1.0)


def test_the_grid_is_enlarged_with_the_contact():
    """The gap is a function; previous shear is transferred to the enlarged grid."""

    def gap(grid):
        return sc.surfaces.paraboloid(grid, 1.0)

    drive = {"load": 0.05, "shift": (0.01, 0.0)}
    results = []
    for cells in (16, 32):
        grid = sc.Grid(cells, cells, 1 / 32, 1 / 32)
        solver = sc.ContactSolver(grid, SOFT, SOFT, sc.Coulomb(MU))
        first = solver.solve(gap, load=0.01, shift=(0.004, 0.001))
        results.append(solver.solve(gap, **drive, previous=first))
    grown, whole = results
    assert grown.grid.nx > 16
    margin = (whole.grid.nx - grown.grid.nx) // 2
    inner = slice(margin, margin + grown.grid.nx)
    assert grown.shear == pytest.approx(whole.shear[:, inner, inner], abs=1e-9)
    assert grown.tangential_load == pytest.approx(whole.tangential_load)


def test_periodic_surfaces():
    """A wave under load and shear in plane strain; full stick in full contact."""
    grid = sc.Grid(64, 1, 1 / 64, 1.0, periodic="xy")
    solver = sc.ContactSolver(grid, SOFT, SOFT, sc.Coulomb(MU))
    gap = 0.01 * (1 - np.cos(2 * np.pi * np.asarray(grid.x)))[:, None]
    found = solver.solve(gap, load=0.01, tangential_load=(0.5 * MU * 0.01, 0.0))
    outer = frictionless(solver, gap, 0.005)
    whole = frictionless(solver, gap, 0.01)
    assert np.abs(found.shear[0] - MU * (whole.pressure - outer.pressure)).max() < 1e-6 * MU
    assert 0 < found.sticking.sum() < np.count_nonzero(found.pressure)


@pytest.mark.parametrize(
    ("friction", "arguments", "error", "words"),
    [
        (0.3, {"shift": (1e-3, 0.0)}, ValueError, "shift is not supported.*Coulomb"),
        (sc.Coulomb(0.3), {"shift": 1e-3}, TypeError, "shift must be two numbers"),
        (sc.Coulomb(0.3), {"shift": (1e-3,)}, ValueError, "shift must be two numbers.*got 1"),
        (
            sc.Coulomb(0.3),
            {"shift": (1e-3, None), "tangential_load": (1e-3, None)},
            ValueError,
            "shift and tangential_load along x cannot both be given",
        ),
        (sc.Coulomb(0.3), {"twist": 1e-3, "torque": 0.0}, ValueError, "twist and torque"),
        (
            sc.Coulomb(0.3),
            {"tangential_load": (0.003, 0.0)},
            ValueError,
            "than 0.003 N.*shift",
        ),
        (sc.Coulomb(0.3), {"tangential_load": (0.0, -1.0)}, ValueError, "tangential_load must be"),
        (
            sc.Coulomb(0.3),
            {"torque": 1.0},
            ValueError,
            r"torque must be less in magnitude than [0-9.e-]{7,12} N m,",
        ),
        (sc.Coulomb(0.0), {"tangential_load": (1e-3, 0.0)}, ValueError, "tangential_load"),
        (
            sc.Coulomb(0.3),
            {"previous": 3},
            TypeError,
            "previous must be a samcontact.PartialSlipSolution",
        ),
    ],
)
@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
def test_invalid_drives_are_refused(friction, arguments, error, words):
    solver = sc.ContactSolver(SMALL_GRID, SOFT, SOFT, friction)
    with pytest.raises(error, match=words):
        solver.solve(BALL, load=0.01, **arguments)


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
def test_invalid_friction_is_refused():
    with pytest.raises(ValueError, match="coefficient must be a number >= 0"):
        sc.Coulomb(-0.1)
    warm = SOFT.with_thermal(1.0, 1e-5, 1.0)
    with pytest.raises(ValueError, match=r"heat\.factor must be 0 in a ContactSolver with"):
        sc.ContactSolver(SMALL_GRID, warm, warm, sc.Coulomb(0.1), heat=sc.Heat(0.1))
    solver = sc.ContactSolver(SMALL_GRID, SOFT, SOFT, sc.Coulomb(0.1))
    found = solver.solve(BALL, load=0.01)
    with pytest.raises(ValueError, match="shear is required with friction = Coulomb"):
        solver.stress(found.pressure, 0.1)
    assert solver.stress(found.pressure, 0.1, shear=found.shear).shape == (6, 16, 16, 1)
    other = sc.Grid(16, 16, 1 / 8, 1 / 16)
    moved = sc.ContactSolver(other, SOFT, SOFT, sc.Coulomb(0.1))
    with pytest.raises(ValueError, match="previous must be a solution on the given grid"):
        moved.solve(sc.surfaces.paraboloid(other, 1.0), load=0.01, previous=found)


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
@pytest.mark.parametrize("increments", [1, 3])
@pytest.mark.parametrize(("nu", "tolerance"), [(0.0, 1e-6), (0.3, 6e-3)])
def test_oblique_loading_does_not_slip(increments, nu, tolerance):
    """Mindlin and Deresiewicz: Q = eta P with eta < mu from the beginning, s = eta p everywhere.

    Cells that close in an increment slip from their first contact; exact if C and K are equal,
    otherwise as in a circular contact; 12 cells per radius.
    """
    solver, gap, load, _ = two_balls(30, 0.4, nu)
    eta, found = 0.2 * np.array([0.8, 0.6]), solver.solve(gap, load=0.0)
    untouched = found.approach
    for k in range(1, increments + 1):
        now = load * k / increments
        found = solver.solve(gap, load=now, tangential_load=eta * now, previous=found)
        slips = (found.pressure > 0) & ~found.sticking
        assert slips.sum() <= (0 if nu == 0 else 8)
        error = np.abs(found.shear - eta[:, None, None] * found.pressure)
        assert error.max() < tolerance * found.pressure.max()
    ratio = (2 - nu) / (2 * (1 - nu))
    assert found.shift == pytest.approx(
        ratio * eta * (found.approach - untouched), rel=max(1e-6, 0.2 * tolerance)
    )
    assert found.friction_work <= (0.0 if nu == 0 else 1e-8 * load * found.approach)


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
def test_increments_of_a_path_converge_at_first_order():
    """Simultaneous loading, shift and rotation: twice the increments halve the error."""
    solver, gap, load, _ = two_balls(20, 0.4, tol=1e-7)
    ends = []
    for increments in (2, 4, 8, 16):
        found = solver.solve(gap, load=0.0)
        for k in range(1, increments + 1):
            drive = {"shift": (0.05 / increments, 0.0), "twist": 0.1 / increments}
            found = solver.solve(gap, load=load * k / increments, **drive, previous=found)
        ends.append((found.tangential_load[0], found.torque, found.friction_work))
    steps = np.abs(np.diff(ends, axis=0))
    assert (steps[:-1] > 1.4 * steps[1:]).all()


@pytest.mark.parametrize(("tol", "work"), [(1e-4, 20), (1e-8, 50)])
def test_shear_costs_few_exact_displacements(tol, work):
    for share in (0.1, 0.9):
        solver, gap, load, _ = two_balls(128, 0.4, 0.3, tol=tol)
        found = solver.solve(gap, load=load, tangential_load=(share * MU * load, 0.0))
        assert found.tangential_applications <= 6
        assert found.tangential_work <= work


def test_shear_on_fine_cells_starts_from_coarse_cells():
    """A rectangular box under a cylinder, 1600 cells across its contact."""
    grid = sc.Grid(2048, 32, 1 / 2048, 1 / 2048, periodic="y")
    body = sc.Material.elastic(2 * (1 - 0.3**2), 0.3)
    gap = np.repeat(np.square(grid.x)[:, None] / 2, grid.ny, axis=1)
    load = math.pi / 4 * 0.4**2 * grid.ny * grid.dy
    solver = sc.ContactSolver(grid, body, body, sc.Coulomb(MU), tol=1e-6)
    found = solver.solve(gap, load=load, tangential_load=(0.5 * MU * load, 0.0))
    assert found.tangential_error <= 1e-6
    assert found.tangential_applications <= 3


@pytest.mark.parametrize("shift", [1e-7, 1e-4, 1e-2, 1.0])
@pytest.mark.parametrize("roughness", [1e-3, 1e-2])
def test_a_periodic_surface_in_full_contact_slips_by_its_shift(shift, roughness):
    """Uniform shear causes no displacement: the mean slip is the shift, and the law holds."""
    grid = sc.Grid(8, 12, 1 / 8, 1 / 8, periodic="xy")
    gap = roughness * np.random.default_rng(1).random(grid.surface_shape)
    solver = sc.ContactSolver(grid, SOFT, SOFT, sc.Coulomb(MU), tol=1e-9)
    pressed = solver.solve(gap, load=0.5)
    assert pressed.pressure.min() > 0
    direction = np.array([0.6, -0.8])
    found = solver.solve(gap, load=0.5, shift=tuple(shift * direction), previous=pressed)
    np.testing.assert_allclose(
        found.slip.mean(axis=(1, 2)), shift * direction, rtol=0, atol=1e-6 * shift
    )
    bound = MU * found.pressure
    length = np.hypot(*found.shear)
    assert (length <= bound * (1 + 1e-9)).all()
    slides = ~found.sticking
    assert slides.any()
    assert slides.all() or shift < 1e-2
    np.testing.assert_allclose(length[slides], bound[slides], rtol=1e-6)
    along = np.einsum("kxy,kxy->xy", found.shear, found.slip)
    scale = bound * np.hypot(*found.slip)
    assert np.abs(along - scale).max() <= 1e-6 * scale.max()
