# SPDX-License-Identifier: GPL-3.0-or-later
"""Rolling with creepage against Kalker's coefficients, Carter and digits of CONTACT."""

import math

import numpy as np
import pytest

import samcontact as sc

BODY = sc.Material.elastic(2 * 1.28, 0.28)
MU = 0.4013
LOAD = 0.4705


def wheel(n=33):
    """Return two balls of an example of CONTACT, with cells of 0.25 on its finest grid."""
    grid = sc.Grid(n, n, 8.25 / n, 8.25 / n)
    return grid, sc.surfaces.paraboloid(grid, 1 / (2 * 0.002963))


def roll(grid, gap, bodies=(BODY, BODY), mu=MU, **drive):
    return sc.rolling.steady(grid, *bodies, gap, load=LOAD, friction=sc.Coulomb(mu), **drive)


def require_law(found, mu):
    """Assert Coulomb's law, and that no cell has negative friction work."""
    bound = mu * found.pressure
    assert (np.hypot(*found.shear) <= bound * (1 + 1e-12)).all()
    power = (found.shear * found.slip).sum(axis=0)
    assert power.min() >= -1e-9 * max(power.max(), 1e-300)
    slipping = (found.pressure > 0) & ~found.sticking
    assert np.allclose(np.hypot(*found.shear)[slipping], bound[slipping], rtol=1e-5)


def test_linear_coefficients_of_kalker():
    """Circular contact, nu = 0.25, G = 1, area of the counted cells; first-order errors."""
    body = sc.Material.elastic(2.5, 0.25)
    found = []
    for n in (44, 88):
        grid = sc.Grid(n, n, 2 / 0.9 / n, 2 / 0.9 / n)
        gap = sc.surfaces.paraboloid(grid, 1.0)
        load = 4 / 3 * 2.5 / (2 * (1 - 0.25**2))
        columns = []
        for creepage, spin in (((1e-4, 0), 0), ((0, 1e-4), 0), ((0, 0), 1e-4)):
            state = sc.rolling.steady(
                grid, body, body, gap, load=load, friction=sc.Coulomb(math.inf),
                creepage=creepage, spin=spin,
            )  # fmt: skip
            assert state.sticking[state.pressure > 0].all()
            columns.append((*(state.tangential_load / 1e-4), state.torque / 1e-4))
        ab = np.count_nonzero(state.pressure) * grid.cell_area / math.pi
        (c11, *_), (_, c22, c32), (_, c23, c33) = columns
        found.append([c11 / ab, c22 / ab, -c32 / ab**1.5, c23 / ab**1.5, c33 / ab**2])
    limit = 2 * np.array(found[1]) - found[0]
    assert limit[:4] == pytest.approx([4.12, 3.67, 1.47, 1.47], rel=5e-3)
    assert limit[4] == pytest.approx(1.19, rel=1e-2)


def test_carter_agrees_with_contact():
    """CONTACT's example of a line contact: 200 wide, 50 cells in contact."""
    grid = sc.Grid(55, 1, 0.04, 200.0)
    gap = 0.001 * (-1.05 + 0.04 * np.arange(55.0)[:, None]) ** 2
    steel = sc.Material.elastic(2 * 82000 * 1.28, 0.28)
    with pytest.warns(sc.GridTooSmallWarning):
        found = sc.rolling.steady(
            grid, steel, steel, gap, load=35780.0, friction=sc.Coulomb(0.3),
            creepage=(2.4e-4, 0.0), on_border="warn",
        )  # fmt: skip
    assert np.count_nonzero(found.pressure) == 50
    assert np.count_nonzero(found.sticking) == 30
    assert found.sticking.nonzero()[0].max() == found.pressure.nonzero()[0].max()
    assert found.tangential_load[0] == pytest.approx(6955, abs=0.5)
    assert found.pressure.max() == pytest.approx(113.9, abs=0.05)
    assert found.approach == pytest.approx(6.492e-3, abs=5e-7)
    require_law(found, 0.3)


def test_from_cattaneo_to_carter():
    """A tangentially loaded ball starts to roll: creepages and stick counts agree with CONTACT."""
    grid, gap = wheel()
    solver = sc.ContactSolver(grid, BODY, BODY, sc.Coulomb(MU))
    force = {"load": LOAD, "tangential_load": (-0.657 * MU * LOAD, 0.0)}
    now = solver.solve(gap, **force)
    assert np.count_nonzero(now.sticking) == 305
    assert now.shift[0] == pytest.approx(-1.774e-2, abs=5e-6)
    creepages, sticking = [], []
    for _ in range(15):
        before, now = now, solver.solve(gap, **force, previous=now, advance=(-0.25, -0.25))
        creepages.append(-(now.shift - before.shift)[0] / 0.25)
        sticking.append(np.count_nonzero(now.sticking))
        assert now.tangential_applications <= 25
        assert now.friction_work > before.friction_work
        require_law(now, MU)
    printed = [1.824e-3, 1.882e-3, 1.955e-3, 2.050e-3, 2.140e-3, 2.221e-3, 2.334e-3]
    assert creepages[:7] == pytest.approx(printed, abs=5.1e-7)
    assert creepages[12:] == pytest.approx([3.184e-3, 3.403e-3, 3.402e-3], abs=5.1e-7)
    assert sticking[:7] == [422, 420, 416, 406, 405, 395, 390]
    assert sticking[12:] == [323, 319, 330]


STEEL_ON_SOFT = (sc.Material.elastic(20.0, 0.3), sc.Material.elastic(2.0, 0.1))


@pytest.mark.parametrize("bodies", [(BODY, BODY), STEEL_ON_SOFT], ids=["identical", "dissimilar"])
def test_steps_tend_to_steady_rolling(bodies):
    grid, gap = wheel(24)
    d, (xi, eta), spin = grid.dx, (2e-3, -1e-3), 3e-4
    steady = roll(grid, gap, bodies, creepage=(xi, eta), spin=spin, tol=1e-9)
    require_law(steady, MU)
    solver = sc.ContactSolver(grid, *bodies, sc.Coulomb(MU), tol=1e-9)
    scale = MU * steady.pressure.max()
    step = {
        "advance": (-d * (1 - xi / 2), -d * (1 + xi / 2)),
        "shift": (0.0, eta * d),
        "twist": spin * d,
    }
    one = solver.solve(gap, load=LOAD, previous=steady, **step)
    assert np.abs(one.shear - steady.shear).max() < 1e-6 * scale
    assert one.friction_work == pytest.approx(steady.friction_work_per_distance * d, rel=1e-5)
    assert one.shift == pytest.approx([xi * d, eta * d])
    if bodies is STEEL_ON_SOFT:
        return
    now = solver.solve(gap, load=LOAD)
    for _ in range(300):
        before, now = now, solver.solve(gap, load=LOAD, previous=now, **step)
        if np.abs(now.shear - before.shear).max() < 1e-7 * scale:
            break
    assert np.abs(now.shear - steady.shear).max() < 1e-5 * scale


@pytest.mark.parametrize(
    "forces",
    [
        {"tangential_load": (0.95 * MU * LOAD, 0.0)},
        {"tangential_load": (None, 0.0), "spin": 2e-3},
        {"tangential_load": (0.05, -0.05), "torque": 0.05},
        {"tangential_load": (None, 0.01), "torque": -0.02},
        {"tangential_load": (0.999 * MU * LOAD, None)},
    ],
)
def test_creepages_follow_from_forces(forces):
    grid, gap = wheel()
    found = roll(grid, gap, **forces)
    expected = forces["tangential_load"]
    for force, value in zip(found.tangential_load, expected, strict=True):
        assert value is None or force == pytest.approx(value, abs=1e-7 * MU * LOAD)
    assert found.torque == pytest.approx(forces.get("torque", found.torque), abs=1e-7)
    again = roll(grid, gap, creepage=found.creepage, spin=found.spin)
    assert again.tangential_load == pytest.approx(found.tangential_load, abs=1e-6 * MU * LOAD)
    warm = roll(grid, gap, **forces, start=found)
    assert warm.creepage == pytest.approx(found.creepage, rel=1e-6, abs=1e-10)


def rollers(mu, pair, n=64, **options):
    """Return rollers in plane strain with an equivalent radius of 25 mm, under 16 kN/m."""
    grid = sc.Grid(n, 1, 240e-6 / n, 1.0, periodic="y")
    return {
        "grid": grid, "body1": pair[0], "body2": pair[1], "friction": sc.Coulomb(mu),
        "gap": sc.surfaces.paraboloid(grid, 25e-3, math.inf), "load": 16e3, **options,
    }  # fmt: skip


def of_shear_modulus(G, nu):
    return sc.Material.elastic(2 * G * (1 + nu), nu)


STEEL = of_shear_modulus(82e9, 0.28)
DISSIMILAR = (of_shear_modulus(23e9, 0.31), STEEL)
RIGID = (sc.Material.rigid(), of_shear_modulus(23e9, 0.31))


@pytest.mark.parametrize("part", [0.1, 0.5, -0.9, 0.999])
def test_rollers_in_plane_strain_agree_with_carter(part):
    """Carter (1926): xi = mu a/R (1 - sqrt(1 - F/(mu P))); Johnson (1985), equation 8.50."""
    mu = 0.3
    E_star = STEEL.E / (2 * (1 - STEEL.nu**2))
    a = math.sqrt(4 * 16e3 * 25e-3 / (math.pi * E_star))
    carter = math.copysign(mu * a / 25e-3 * (1 - math.sqrt(1 - abs(part))), part)
    drive = {"tangential_load": (part * mu * 16e3, None)}
    found = sc.rolling.steady(**rollers(mu, (STEEL, STEEL), 2048), **drive)
    assert found.creepage[0] == pytest.approx(carter, rel=1e-3)


def test_plane_strain_is_the_same_for_any_number_of_rows():
    one = rollers(0.3, DISSIMILAR)
    grid = sc.Grid(64, 4, one["grid"].dx, 0.25, periodic="y")
    four = one | {"grid": grid, "gap": sc.surfaces.paraboloid(grid, 25e-3, math.inf)}
    drive = {"tangential_load": (1e3, 2e3), "tol": 1e-10}
    single, several = (sc.rolling.steady(**problem, **drive) for problem in (one, four))
    assert several.creepage == pytest.approx(single.creepage, rel=1e-7)
    assert np.abs(several.shear - single.shear).max() < 1e-7 * np.abs(single.shear).max()


def test_a_row_of_rollers_tends_to_one_roller():
    """Marched on a period, against steady rolling: as the square of the inverse period."""
    cell, width, mu, creepage = 1e-6, 1e-5, 0.3, 2e-3
    body, radius = sc.Material.elastic(210e9, 0.3), 1e-4
    E_star = sc.hertz.effective_modulus(body, body)
    load = 0.25 * math.pi * E_star * (8 * cell) ** 2 / radius * width  # half-width of 8 cells
    off = []
    for n in (32, 64):
        grids = [sc.Grid(n, 1, cell, width, periodic=along) for along in ("y", "xy")]
        gap, law = sc.surfaces.cylinder(grids[0], radius), sc.Coulomb(mu)
        steady = sc.rolling.steady(
            grids[0], body, body, gap, load=load, friction=law, creepage=(creepage, 0.0)
        )
        row = sc.Simulation(grids[1], body, body, gap, law, on_border="warn")
        row.step(load=load)
        for _ in range(48):
            state = row.step(load=load, advance=(-cell, -cell), shift=(creepage * cell, 0.0))
        off.append(abs(state.tangential_load[0] / steady.tangential_load[0] - 1))
    assert off[0] < 0.2
    assert off[1] < 0.3 * off[0]


@pytest.mark.parametrize("across", [None, 0.0])
def test_dissimilar_rollers_agree_with_contact(across):
    """CONTACT's example of Bentall & Johnson's rollers, its cases 2, 4, 5 and 6; x is reversed."""
    grid = sc.Grid(216, 1, 1e-6, 1.0)
    gap, load = sc.surfaces.paraboloid(grid, 25e-3, math.inf), 16201.9
    for mu, part, printed in (
        (1e-4, 0.0, 5.260e-4), (0.05, 0.0, 4.294e-4), (0.05, 0.75, 2.108e-4),
        (0.05, -0.75, 5.392e-4),
    ):  # fmt: skip
        with pytest.warns(sc.GridTooSmallWarning):
            found = sc.rolling.steady(
                grid, *DISSIMILAR, gap, load=load, friction=sc.Coulomb(mu),
                tangential_load=(part * mu * load, across), on_border="warn",
            )  # fmt: skip
        assert -found.creepage[0] == pytest.approx(printed, abs=1.5e-7)
        assert found.tangential_applications < 1000


@pytest.mark.parametrize(
    "pair", [(STEEL, STEEL), DISSIMILAR, RIGID], ids=["identical", "dissimilar", "rigid"]
)
@pytest.mark.parametrize("mu", [1e-4, 0.05, 0.6])
def test_forces_are_found_from_any_start(pair, mu):
    """Starts from zero and from full sliding, for forces from the maximum to zero."""
    problem, maximum = rollers(mu, pair), mu * 16e3
    sliding = sc.rolling.steady(**problem, creepage=(0.01, 0.0))
    assert not sliding.sticking.any()
    for part in (0.0, 1e-6, -0.5, 0.9999):
        drive = {"tangential_load": (part * maximum, None)}
        found = sc.rolling.steady(**problem, **drive)
        assert found.tangential_load[0] == pytest.approx(part * maximum, abs=1e-7 * maximum)
        require_law(found, mu)
        again = sc.rolling.steady(**problem, creepage=found.creepage)
        assert again.tangential_load[0] == pytest.approx(part * maximum, abs=1e-5 * maximum)
        warm = sc.rolling.steady(**problem, **drive, start=sliding)
        assert warm.creepage[0] == pytest.approx(found.creepage[0], rel=1e-5, abs=1e-9)


@pytest.mark.parametrize(
    "pair", [(STEEL, STEEL), DISSIMILAR, RIGID], ids=["identical", "dissimilar", "rigid"]
)
@pytest.mark.parametrize("mu", [1e-4, 0.05])
def test_increments_find_forces_from_full_sliding(pair, mu):
    problem, maximum = rollers(mu, pair), mu * 16e3
    grid = problem.pop("grid")
    solver = sc.ContactSolver(grid, problem["body1"], problem["body2"], problem["friction"])
    sliding = solver.solve(problem["gap"], load=16e3, shift=(1e-4, 0.0))
    assert not sliding.sticking.any()
    for part in (0.0, 0.5, 0.99, -0.9):
        found = sliding
        for _ in range(2):
            found = solver.solve(
                problem["gap"], load=16e3, tangential_load=(part * maximum, None), previous=found,
                advance=(-grid.dx, -grid.dx),
            )  # fmt: skip
            assert found.tangential_load[0] == pytest.approx(part * maximum, abs=1e-6 * maximum)
            assert (np.hypot(*found.shear) <= mu * found.pressure * (1 + 1e-9)).all()


def test_impossible_forces_are_refused():
    grid, gap = wheel(24)
    with pytest.raises(
        ValueError, match=r"tangential_load must be less than .*: prescribe creepage instead"
    ):
        roll(grid, gap, tangential_load=(1.1 * MU * LOAD, 0.0))
    with pytest.raises(
        ValueError, match=r"torque must be less in magnitude than .*: prescribe spin"
    ):
        roll(grid, gap, torque=1.0)
    with pytest.raises(ValueError, match="must be below the friction limit together"):
        roll(grid, gap, tangential_load=(0.9 * MU * LOAD, 0.0), torque=0.3)
    with pytest.raises(ValueError, match="start must be a solution on the given grid"):
        roll(grid, gap, creepage=(0.0, 0.0), start=roll(*wheel(20), creepage=(0.0, 0.0)))
    with pytest.raises(ValueError, match="creepage and tangential_load along x"):
        roll(grid, gap, creepage=(1e-3, 0.0), tangential_load=(0.1, None))
    for periodic, drive, message in (
        ("x", {"creepage": (0.0, 0.0)}, "must be '' or 'y'"),
        ("y", {"creepage": (0.0, 0.0), "spin": 1.0}, "spin must be None"),
        ("y", {"torque": 0.0}, "torque must be None"),
    ):
        with pytest.raises(ValueError, match=message):
            roll(sc.Grid(24, 24, grid.dx, grid.dy, periodic=periodic), gap, **drive)
    with pytest.raises(TypeError, match="friction"):
        sc.rolling.steady(grid, BODY, BODY, gap, load=LOAD, friction=0.3)
    solver = sc.ContactSolver(grid, BODY, BODY, sc.Coulomb(MU))
    pressed = solver.solve(gap, load=LOAD)
    d = grid.dx
    for drive, message in (
        ({"advance": (0.4 * d, 0.4 * d)}, "whole number of cells"),
        ({"advance": (3 * d, d)}, "differ by at most one cell"),
        ({"advance": (9 * d, 9 * d)}, "so that it stays on the grid, got 9 cells"),
        (
            {"advance": (1.01 * d, 0.99 * d), "tangential_load": (0.1, None)},
            "equal for both",
        ),
        ({"advance": (d, d), "torque": 0.01}, "torque with advance requires"),
    ):
        with pytest.raises(ValueError, match=message):
            solver.solve(gap, load=LOAD, previous=pressed, **drive)
    with pytest.raises(ValueError, match="solve the normal contact"):
        solver.solve(gap, load=LOAD, advance=(d, d))
    with pytest.raises(ValueError, match="advance is not supported in full sliding"):
        sc.ContactSolver(grid, BODY, BODY).solve(gap, load=LOAD, advance=(d, d))
