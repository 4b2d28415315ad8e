# SPDX-License-Identifier: GPL-3.0-or-later
"""Partial slip of dissimilar bodies against a dense solver, CONTACT, and symmetries."""

import math

import numpy as np
import pytest

import samcontact as sc

ALUMINIUM = sc.Material.elastic(70.0, 0.33)
RUBBER = sc.Material.elastic(2.0, 0.1)


def dense_matrix(grid, body1, body2):
    """Coefficients of the relative u_x, u_y, u_z for s_x, s_y, p: Love and Cerruti."""
    softness = [0.0 if m.is_rigid else 2 * (1 + m.nu) / m.E for m in (body1, body2)]
    ratios = [0.0 if m.is_rigid else m.nu for m in (body1, body2)]
    total = sum(softness)
    crossed = sum(s * nu for s, nu in zip(softness, ratios, strict=True))
    beta = 0.5 * (softness[1] * (1 - 2 * ratios[1]) - softness[0] * (1 - 2 * ratios[0]))
    x, y = (c.ravel() for c in np.meshgrid(grid.x, grid.y, indexing="ij"))
    dx, dy = x[:, None] - x, y[:, None] - y

    def corners(function):
        ends = [(s, t) for s in (-0.5, 0.5) for t in (-0.5, 0.5)]
        terms = [4 * s * t * function(dx + s * grid.dx, dy + t * grid.dy) for s, t in ends]
        return sum(terms) / (2 * np.pi)

    along_x = corners(lambda x, y: x * np.arcsinh(y / abs(x)))
    along_y = corners(lambda x, y: y * np.arcsinh(x / abs(y)))
    across = -crossed * corners(np.hypot)

    def lifted(x, y):
        return y / 2 * np.log(x * x + y * y) + x * np.arctan(y / x)

    zx, zy = beta * corners(lifted), beta * corners(lambda x, y: lifted(y, x))
    return np.block(
        [
            [(total - crossed) * along_x + total * along_y, across, -zx],
            [across, total * along_x + (total - crossed) * along_y, -zy],
            [zx, zy, (total - crossed) * (along_x + along_y)],
        ]
    )


def dense_solution(matrix, gap, mu, approach, motion, before, sweeps=400):
    """Gauss-Seidel over cells, each projected on its cone's section: p, then s within mu p."""
    n = gap.size
    t = before.copy()
    slid = (matrix @ before)[: 2 * n]
    for _ in range(sweeps):
        last = t.copy()
        for i in range(n):
            u = matrix[2 * n + i] @ t
            stiffness = 1 / matrix[2 * n + i, 2 * n + i]
            t[2 * n + i] = max(0.0, t[2 * n + i] - (gap[i] + u - approach) * stiffness)
            rows = [i, n + i]
            w = motion[rows] - (matrix[rows] @ t - slid[rows])
            s = t[rows] + w / max(matrix[i, i], matrix[n + i, n + i])
            bound = mu * t[2 * n + i]
            t[rows] = s * min(1.0, bound / max(math.hypot(*s), 1e-300))
        if np.abs(t - last).max() < 1e-13 * t.max():
            break
    return t


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
@pytest.mark.parametrize("bodies", [(RUBBER, ALUMINIUM), (sc.Material.rigid(), RUBBER)])
def test_dense_solver_agrees(bodies):
    """Two increments of approach, shift and twist on 8 x 7 cells that are not square."""
    grid = sc.Grid(8, 7, 0.1, 0.12)
    gap = sc.surfaces.paraboloid(grid, 1.0, 1.5)
    solver = sc.ContactSolver(grid, *bodies, sc.Coulomb(0.4), tol=1e-11)
    matrix, n = dense_matrix(grid, *bodies), gap.size
    x, y = (c.ravel() for c in np.meshgrid(grid.x, grid.y, indexing="ij"))
    before, found = np.zeros(3 * n), None
    slipping = 0
    for approach, shift, twist in ((0.06, (0.004, -0.002), 0.01), (0.05, (-0.001, 0.006), -0.004)):
        motion = np.concatenate([shift[0] - twist * y, shift[1] + twist * x])
        before = dense_solution(matrix, gap.ravel(), 0.4, approach, motion, before)
        drive = {"approach": approach, "shift": shift, "twist": twist}
        found = solver.solve(gap, **drive, previous=found)
        ours = np.concatenate([found.shear.ravel(), found.pressure.ravel()])
        assert np.abs(ours - before).max() < 1e-9 * before.max()
        slipping += np.count_nonzero((found.pressure > 0) & ~found.sticking)
    assert found.sticking.any()
    assert slipping > 0
    assert found.sweeps > 1


def spence(cells, largest):
    """Return solver, gap and `count` increments of Spence's problem, an example of CONTACT."""
    grid = sc.Grid(cells, cells, 0.2, 0.2)
    soft, hard = sc.Material.elastic(1.0, 0.0), sc.Material.elastic(2e5, 0.0)
    solver = sc.ContactSolver(grid, soft, hard, sc.Coulomb(0.2986))
    gap, found = sc.surfaces.paraboloid(grid, 0.5 / 0.004116), [None]
    for k in range(1, largest + 1):
        found.append(solver.solve(gap, load=(k / 45) ** 3, previous=found[-1]))
    return solver, gap, found


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
def test_normal_loading_of_dissimilar_bodies():
    """Agreement with the digits printed by CONTACT; its 921 last cells barely touch."""
    solver, gap, path = spence(37, 35)
    for k, touching, sticking, approach, peak in (
        (6, 29, 5, 2.901e-3, 3.941e-3),
        (18, 241, 61, 2.610e-2, 1.220e-2),
        (35, 917, 225, 9.874e-2, 2.392e-2),
    ):
        found = path[k]
        assert np.count_nonzero(found.pressure) == touching
        assert np.count_nonzero(found.sticking) == sticking
        assert found.approach == pytest.approx(approach, rel=3e-4)
        assert found.pressure.max() == pytest.approx(peak, rel=3e-4)
    before, found = path[5:7]
    assert found.approach == pytest.approx(2.9017e-3, rel=3e-5)
    assert found.pressure.max() == pytest.approx(3.9408e-3, rel=3e-5)
    assert found.friction_work - before.friction_work == pytest.approx(2.712e-8, rel=1e-4)
    assert np.abs(found.tangential_load).max() < 1e-8 * found.load
    # a step without any change changes nothing
    again = solver.solve(gap, load=found.load, previous=found)
    assert np.abs(again.shear - found.shear).max() < 1e-7 * found.pressure.max()
    assert again.friction_work == pytest.approx(found.friction_work, rel=1e-6)
    assert again.friction_work >= found.friction_work


def history(solver, gap, rotation=lambda x, y: (x, y), sign=1.0, unit=1.0, stress=1.0):
    """Follow an oblique path with unloading and all kinds of drives; return the last increment."""
    found = None
    scale = stress * unit**2
    for load, along, across, twist in (
        (0.02, 0.002, 0.0, 0.0),
        (0.03, 0.003, -0.004, 0.0),
        (0.02, 0.001, 0.002, 0.004),
    ):
        q = [sign * scale * part for part in rotation(along, across)]
        drive = {"load": scale * load, "tangential_load": q, "twist": sign * twist}
        before = 0.0 if found is None else found.friction_work
        found = solver.solve(gap, **drive, previous=found)
        assert found.friction_work >= before
    return found


BUMPY_GRID = sc.Grid(24, 24, 0.05, 0.05)
BUMPS = sc.surfaces.paraboloid(BUMPY_GRID, 1.0, 2.0) + 2e-3 * np.outer(
    np.sin(7 * np.asarray(BUMPY_GRID.x)), np.cos(5 * np.asarray(BUMPY_GRID.y) + 1)
)


def close(a, b, found):
    return np.abs(a - b).max() < 2e-8 * found.pressure.max()


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
def test_symmetries():
    """Swapped, mirrored, rotated and scaled problems have correspondingly transformed solutions."""

    def solver(first, second, grid=BUMPY_GRID):
        return sc.ContactSolver(grid, first, second, sc.Coulomb(0.3), tol=1e-10, on_border="warn")

    stiff, soft = sc.Material.elastic(4.0, 0.4), sc.Material.elastic(2.0, 0.1)
    gap = BUMPS - BUMPS.min()
    found = history(solver(stiff, soft), gap)
    assert 0 < np.count_nonzero(found.sticking) < np.count_nonzero(found.pressure)
    # in the frame of the other body all motions are reversed
    swapped = history(solver(soft, stiff), gap, sign=-1.0)
    assert close(swapped.shear, -found.shear, found)
    assert swapped.shift == pytest.approx(-found.shift, rel=1e-7)
    # mirrored in y: forces along y and the rotation change sign
    mirrored = history(solver(stiff, soft), gap[:, ::-1], rotation=lambda x, y: (-x, y), sign=-1.0)
    assert close(mirrored.shear[0], found.shear[0][:, ::-1], found)
    assert close(mirrored.shear[1], -found.shear[1][:, ::-1], found)
    # a quarter turn from x to y
    rotated = history(solver(stiff, soft), np.rot90(gap), rotation=lambda x, y: (-y, x))
    assert close(rotated.shear[0], -np.rot90(found.shear[1]), found)
    assert close(rotated.shear[1], np.rot90(found.shear[0]), found)
    # other units
    grid = sc.Grid(24, 24, 0.05e-3, 0.05e-3)
    small = [sc.Material.elastic(1e9 * m.E, m.nu) for m in (stiff, soft)]
    scaled = history(solver(*small, grid), 1e-3 * gap, unit=1e-3, stress=1e9)
    assert close(scaled.shear / 1e9, found.shear, found)
    assert scaled.friction_work == pytest.approx(found.friction_work, rel=1e-7)


@pytest.mark.parametrize("tol", [1e-4, 1e-8])
@pytest.mark.parametrize("nu", [0.0, 0.3])
def test_sweeps_are_few_whatever_the_tolerance(tol, nu):
    """A rigid ball under normal, tangential, reversed and simultaneous loading."""
    grid = sc.Grid(64, 64, 1 / 64, 1 / 64)
    body = sc.Material.elastic(2 * (1 - nu * nu), nu)
    solver = sc.ContactSolver(grid, sc.Material.rigid(), body, sc.Coulomb(0.3), tol=tol)
    gap, load = sc.surfaces.paraboloid(grid, 1.0), 4 / 3 * 0.4**3
    pressed = solver.solve(gap, load=load)
    pulled = solver.solve(gap, load=load, tangential_load=(0.2 * load, 0.0), previous=pressed)
    back = solver.solve(gap, load=load, tangential_load=(-0.25 * load, 0.0), previous=pulled)
    more = solver.solve(gap, load=1.1 * load, tangential_load=(0.0, 0.2 * load), previous=back)
    drive = {"load": load, "tangential_load": (0.15 * load, 0.0)}
    once = solver.solve(gap, **drive)
    together = solver.solve(gap, **drive, previous=solver.solve(gap, load=0.0))
    for found in (pressed, pulled, back, more, once, together):
        assert found.sweeps <= 12
        assert found.operator_applications <= 24
        assert found.tangential_applications <= 40


@pytest.mark.filterwarnings(
    "ignore::samcontact.GridTooSmallWarning", "ignore::samcontact.ResolutionWarning"
)
def test_infinite_friction_may_need_cells_that_slide_at_zero_pressure():
    """Four edge cells slide in contact at zero pressure. Without this state, the worst cell changes
    sides without end."""
    body1, body2 = sc.Material.rigid(), sc.Material.elastic(210e9, 0.0)
    ball = sc.hertz.point(7.5e-3, sc.hertz.effective_modulus(body1, body2), load=300.0)
    grid = sc.Grid(13, 13, 3 * ball.a / 13, 3 * ball.a / 13)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)

    def sheared(mu):
        solver = sc.ContactSolver(grid, body1, body2, sc.Coulomb(mu), on_border="warn")
        pressed = solver.solve(gap, load=300.0)
        drive = {"approach": pressed.approach, "shift": (0.2 * ball.approach, 0.0)}
        return pressed, drive, lambda: solver.solve(gap, previous=pressed, **drive)

    pressed, drive, solve = sheared(math.inf)
    found = solve()
    sliding = (found.pressure == 0) & (np.hypot(*found.shear) > 0)
    assert found.joint_steps > 0
    assert np.argwhere(sliding).tolist() == [[5, 2], [5, 10], [6, 2], [6, 10]]
    n, matrix = gap.size, dense_matrix(grid, body1, body2)
    wanted = matrix @ np.concatenate([pressed.shear.ravel(), pressed.pressure.ravel()])
    wanted[:n] += drive["shift"][0]
    wanted[2 * n :] = pressed.approach - gap.ravel()
    t = np.concatenate([found.shear.ravel(), found.pressure.ravel()])
    *slip, apart = (matrix @ t - wanted).reshape(3, *grid.surface_shape) / ball.approach
    sticking, slip = found.pressure > 0, -np.array(slip)
    assert apart.min() > -1e-7
    assert np.abs(apart[sticking | sliding]).max() < 1e-7
    assert np.hypot(*slip)[sticking].max() < 1e-7
    along, directions = slip[:, sliding], found.shear[:, sliding] / np.hypot(*found.shear)[sliding]
    assert (along * directions).sum(axis=0) == pytest.approx(np.hypot(*along), rel=1e-6)
    touching, sets = pressed.pressure.ravel() > 0, []
    while touching.tobytes() not in sets:
        sets.append(touching.tobytes())
        t, rows = np.zeros(3 * n), np.flatnonzero(np.tile(touching, 3))
        t[rows] = np.linalg.solve(matrix[np.ix_(rows, rows)], wanted[rows])
        apart = (matrix @ t - wanted)[2 * n :]
        wrong = np.where(touching, t[2 * n :] / t.max(), apart / ball.approach)
        worst = wrong.argmin()
        assert wrong[worst] < -1e-6
        touching = touching.copy()
        touching[worst] ^= True
    assert len(sets) - sets.index(touching.tobytes()) == 4
    assert sheared(2.0)[2]().converged
