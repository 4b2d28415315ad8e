# SPDX-License-Identifier: GPL-3.0-or-later
"""Rolling of viscoelastic bodies with friction: digits of CONTACT, the track on a grid, limits."""

import numpy as np
import pytest

import samcontact as sc
from moving_bodies import RUBBER, crept

G, NU, RADIUS, LOAD, MU = 1143e6, 0.4, 0.05, 6e5, 0.3
GLASS = sc.Material.elastic(2 * G * (1 + NU), NU)
MIDDLE = -0.08e-3
"""Centre of the rollers: the first cell of CONTACT is at -7.92 mm."""


@pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
@pytest.mark.parametrize(
    ("creep_time", "speed", "creepage", "contact", "sticking", "power"),
    [
        (0.009, 0.0, 1.378e-2, 80, 51, 1438.0),
        (0.009, 1.0, 1.365e-2, 62, 37, 913.7),
        (0.045, 1.0, 1.152e-2, 57, 36, 952.0),
        (2.0, 1.0, 9.932e-3, 56, 35, 1010.0),
    ],
)
def test_rollers_of_contact(creep_time, speed, creepage, contact, sticking, power):
    """visc_cylindr of CONTACT with its printed digits: 0.6 of the friction limit."""
    grid = sc.Grid(99, 1, 0.16e-3, 1.0)
    gap = (grid.x - MIDDLE)[:, None] ** 2 / (2 * RADIUS)
    body = GLASS.with_relaxation(times=[creep_time / 2], shares=[0.5])
    found = sc.rolling.steady(
        grid, body, body, gap, load=LOAD, friction=sc.Coulomb(MU), speed=speed,
        tangential_load=(-0.6 * MU * LOAD, 0.0), on_border="warn",
    )  # fmt: skip
    assert found.creepage[0] == pytest.approx(-creepage, rel=4e-4)  # half of the last digit
    assert np.count_nonzero(found.pressure) == contact
    assert np.count_nonzero(found.sticking) == sticking
    assert found.friction_work_per_distance == pytest.approx(power, rel=4e-4)  # at 1 m/s
    assert found.error < 1e-8


def test_slip_follows_from_the_track():
    """Different bodies in 3-D, one elastic, with creepage and spin, which couple all tractions."""
    grid, speed = sc.Grid(20, 12, 1e-3, 1.3e-3), 0.05
    gap = sc.surfaces.paraboloid(grid, 0.1)
    glass, rigid = sc.Material.elastic(3e7, 0.2), sc.Material.rigid()
    xi, eta, phi = 4e-3, -2e-3, 0.5
    found = sc.rolling.steady(
        grid, glass, RUBBER, gap, load=3.0, friction=sc.Coulomb(MU), speed=speed,
        creepage=(xi, eta), spin=phi,
    )  # fmt: skip
    cells, pace = 700, speed / grid.dx
    acting = [crept(t, cells, RUBBER, pace) for t in (found.pressure, *found.shear)]
    track = sc.Grid(len(acting[0]), grid.ny, grid.dx, grid.dy)
    lower = sc.ContactSolver(track, rigid, sc.Material.elastic(RUBBER.E, RUBBER.nu))
    upper = sc.ContactSolver(grid, glass, rigid)
    u = lower.displacement(acting[0], np.stack(acting[1:]))[:, cells:]
    x, y, z = upper.displacement(found.pressure, found.shear, body=1)
    u = u + np.stack([-x, -y, z])
    assert np.ptp(found.gap - gap - u[2]) < 1e-7 * np.abs(u[2]).max()
    touching = found.pressure[:-1] > 0
    strain = (u[:2, :-1] - u[:2, 1:]) / grid.dx
    # Kalker's rule for the place of a particle in its step to the next cell
    x, y = np.meshgrid(grid.x[:-1] + grid.dx / 6, grid.y, indexing="ij")
    expected = np.stack([xi - phi * y, eta + phi * x]) - strain
    np.testing.assert_allclose(
        found.slip[:, :-1][:, touching], expected[:, touching], atol=1e-6 * xi
    )
    sticking = np.count_nonzero(found.sticking)
    assert 5 < sticking < np.count_nonzero(found.pressure) - 5
    # the work of the drive is lost by friction and in the material
    drive = found.tangential_load @ [xi, eta] + found.torque * phi
    assert 0 < found.friction_work_per_distance < drive


@pytest.mark.parametrize(("speed", "modulus"), [(1e9, 1e7), (0.0, 1e6)])
def test_fast_and_slow_rolling_is_elastic(speed, modulus):
    """The limits are those of elastic bodies, also if nine tenths of the modulus relax."""
    grid = sc.Grid(24, 16, 1e-3, 1e-3)
    given = {
        "gap": sc.surfaces.paraboloid(grid, 0.1), "approach": 2e-4, "friction": sc.Coulomb(MU),
        "creepage": (3e-3, 1e-3), "tol": 1e-9,
    }  # fmt: skip
    relaxing = [
        sc.Material.elastic(1e7, nu).with_relaxation(times=[1e-2, 1.0], shares=[0.5, 0.4])
        for nu in (0.2, 0.45)
    ]
    elastic = [sc.Material.elastic(modulus, nu) for nu in (0.2, 0.45)]
    found = sc.rolling.steady(grid, *relaxing, speed=speed, **given)
    expected = sc.rolling.steady(grid, *elastic, **given)
    for one, other in ((found.pressure, expected.pressure), (found.shear, expected.shear)):
        np.testing.assert_allclose(one, other, atol=1e-6 * np.abs(other).max())


@pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
def test_no_friction_work_is_gained():
    """Random materials that relax to a hundredth, between both limits, also with falling laws."""
    rng = np.random.default_rng(3)
    grid = sc.Grid(24, 10, 1e-3, 1.5e-3)
    gap = sc.surfaces.paraboloid(grid, 0.1)
    for number in range(6):
        shares = rng.dirichlet(np.ones(3)) * rng.choice([0.6, 0.9, 0.99])
        times = np.sort(10.0 ** rng.uniform(-4, 0, 3))
        body = sc.Material.elastic(1e7, 0.35).with_relaxation(times, shares)
        law = sc.FallingCoulomb(0.2, 0.1, 1e-3) if number % 2 else sc.Coulomb(MU)
        one = (sc.Material.rigid(), body, sc.Material.elastic(2e7, 0.3))[number % 3]
        found = sc.rolling.steady(
            grid, one, body, gap, load=3.0, friction=law, creepage=rng.normal(0, 2e-2, 2),
            speed=10.0 ** rng.uniform(-2, 0), on_border="warn",
        )  # fmt: skip
        assert found.friction_work_per_distance >= 0
        assert found.pressure.min() >= 0
        bound = law.kinetic + law.drop if number % 2 else MU
        assert np.all(np.hypot(*found.shear) <= bound * found.pressure * (1 + 1e-9))


def test_bad_input():
    grid = sc.Grid(8, 8, 1e-3, 1e-3)
    given = {"gap": sc.surfaces.paraboloid(grid, 0.1), "load": 0.05, "friction": sc.Coulomb(MU)}
    with pytest.raises(ValueError, match="speed must be given with viscoelastic"):
        sc.rolling.steady(grid, RUBBER, RUBBER, **given)
    with pytest.raises(ValueError, match="body2 must be a solid"):
        sc.rolling.steady(grid, GLASS, RUBBER.with_relaxation([1.0], [1.0]), speed=1.0, **given)
    with pytest.raises(ValueError, match=r"creepage must be None with friction = 0\.0"):
        sc.rolling.steady(
            grid, RUBBER, RUBBER, speed=1.0, creepage=(1e-3, 0.0), **given | {"friction": 0.0}
        )
