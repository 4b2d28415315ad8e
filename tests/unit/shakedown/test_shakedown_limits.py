# SPDX-License-Identifier: GPL-3.0-or-later
"""Shakedown limits against published values and unabridged optimisation."""

import math

import numpy as np
import pytest
from scipy.optimize import minimize, minimize_scalar

import samcontact as sc
from samcontact import shakedown

# Johnson (1985), section 9.2: p0/k of a line contact by friction.
MELAN = {0.0: 4.000, 0.1: 3.564, 0.2: 3.202, 0.3: 2.900, 0.35: 2.767, 0.4: 2.500, 0.5: 2.000}
CONTACT = sc.hertz.line(R=1.0, E_star=2.0, p0=1.0)  # half-width 1
POINT = sc.hertz.point(R=1.0, E_star=0.5 * math.pi, p0=1.0)  # radius 1
PASSING = np.linspace(-8.0, 8.0, 1601)


@pytest.mark.parametrize(("friction", "ratio"), MELAN.items())
def test_line_contact_by_melan(friction, ratio):
    limit = shakedown.line(friction)
    assert limit.ratio == pytest.approx(ratio, rel=5e-4)
    assert limit.kind == "exact"
    assert (limit.depth == 0.0) == (friction > 0.36)


def as_tensors(stress):
    xx, yy, zz, yz, xz, xy = stress
    return np.moveaxis(np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]), -1, 0)


def asked(stress, criterion):
    """Return the required k for each stress, from its principal values."""
    principal = np.linalg.eigvalsh(as_tensors(stress))
    if criterion == "tresca":
        return 0.5 * np.ptp(principal, axis=1)
    return np.linalg.norm(principal - principal.mean(axis=1)[:, None], axis=1) / math.sqrt(2.0)


@pytest.mark.parametrize("criterion", ["tresca", "von_mises"])
@pytest.mark.parametrize(("friction", "nu"), [(0.0, 0.3), (0.25, 0.3), (0.4, 0.1), (0.5, 0.0)])
def test_the_limit_is_optimal_over_residual_stresses(friction, nu, criterion):
    """A search over both residual stresses gives the limit; other depths require less."""
    limit = shakedown.line(friction, nu, criterion)
    for depth in (limit.depth, 0.0, 0.2, 0.5, 0.9):
        stress = CONTACT.stress(PASSING[::4], depth, nu, friction)

        def largest(residual, stress=stress):
            moved = stress.copy()
            moved[:2] += residual[:, None]
            return asked(moved, criterion).max()

        found = minimize(
            largest, (0.1, 0.1), method="Nelder-Mead",
            options={"xatol": 1e-8, "fatol": 1e-10, "maxiter": 500},
        )  # fmt: skip
        again = minimize(largest, found.x, method="Nelder-Mead", options={"fatol": 1e-10})
        if depth == limit.depth:
            assert again.fun * limit.ratio == pytest.approx(1.0, rel=1e-3)
        else:
            assert again.fun * limit.ratio < 1.001


def test_kinematic_hardening_raises_the_limit_of_unreversed_friction():
    assert shakedown.line_kinematic().ratio == pytest.approx(4.0, rel=1e-4)
    for friction in (0.1, 0.3, 0.5):
        perfect = shakedown.line(friction, criterion="von_mises").ratio
        assert shakedown.line_kinematic(friction).ratio > 1.02 * perfect


@pytest.mark.parametrize("friction", [0.0, 0.2, 0.35])
def test_the_limit_of_a_circle_is_determined_at_its_middle(friction):
    """A search over all five components shows that no other point of the path requires more."""
    limit = shakedown.point_kinematic(friction)
    for y, z in ((0.0, limit.depth), (0.15, 0.33), (0.2, 0.02), (0.4, 0.3), (0.6, 0.1)):
        stress = POINT.stress(PASSING[::4], y, z, 0.3, friction)

        def largest(centre, stress=stress):
            return asked(stress - np.array([*centre[:2], 0.0, *centre[2:]])[:, None], "von_mises")

        found = minimize(
            lambda centre: np.sum(largest(centre) ** 60) ** (1 / 60), np.zeros(5), method="BFGS"
        )
        assert largest(found.x).max() * limit.ratio < (1.03 if y == 0.0 else 1.0)
    assert 4.6 < shakedown.point(0.0).ratio == pytest.approx(4.675, rel=2e-4)
    assert shakedown.point(friction).ratio <= limit.ratio * (1 + 1e-12)


@pytest.mark.parametrize("friction", [0.0, 0.25, 0.5])
def test_the_lower_bound_of_a_circle_is_safe(friction):
    """Below the bound, sigma_xx alone makes the passage elastic at every transverse position."""
    safe = shakedown.point_lower_bound(friction)
    first = math.sqrt(3.0) * sc.critical.onset_sliding(1.0, 1.0, 0.3, 1.0, friction).C
    assert first < safe.ratio <= shakedown.point(friction).ratio * (1 + 1e-12)
    for y in (0.0, 0.2, 0.5, 0.8, 0.98, 1.1):
        for z in (safe.depth, 0.0, 0.1, 0.3, 0.5, 0.8):
            stress = POINT.stress(PASSING[::4], y, z, 0.3, friction)

            def largest(residual, stress=stress):
                moved = stress.copy()
                moved[0] += residual
                return asked(moved, "von_mises").max()

            needed = minimize_scalar(largest, bounds=(-2.0, 2.0), method="bounded").fun
            assert needed * safe.ratio < 1.0 + 1e-6


def test_ellipses_between_line_and_circle():
    assert 1.0 / shakedown.elliptic(1.0).ratio == pytest.approx(0.21389, abs=5e-6)
    assert 1.0 / shakedown.elliptic(5.0).ratio == pytest.approx(0.24759, abs=5e-6)
    assert shakedown.elliptic(1e9).ratio == pytest.approx(4.0, rel=1e-12)
    assert shakedown.elliptic(1.0).depth == pytest.approx(shakedown.point().depth, rel=1e-3)
    shear = POINT.stress(PASSING, 0.0, shakedown.elliptic(1.0).depth, 0.3)[4]
    assert shear.max() * shakedown.elliptic(1.0).ratio == pytest.approx(1.0, rel=1e-4)
    ratios = [shakedown.elliptic(k).ratio for k in (0.01, 0.1, 1.0, 10.0, 100.0)]
    assert all(np.diff(ratios) < 0)
    assert shakedown.elliptic(2.0, 0.5) == shakedown.ShakedownLimit(2.0, 0.0, "upper")


def test_ellipse_against_the_pressure_on_cells():
    """Orthogonal shear below an ellipse of 2.25 to 1, from its pressure alone."""
    ellipse = sc.hertz.elliptic(1.0, 3.377, 1.0, p0=1.0)
    cell = ellipse.a_x / 16
    grid = sc.Grid(45, 93, cell, cell)
    pressure = ellipse.pressure(grid.x[:, None], grid.y[None, :])
    solver = sc.ContactSolver(grid, sc.Material.elastic(1.0, 0.3), sc.Material.rigid())
    limit = shakedown.elliptic(ellipse.k)
    depths = limit.depth * ellipse.a_x * np.array([0.8, 1.0, 1.2])
    shear = np.abs(solver.stress(pressure, z=depths, body=1)[4, :, grid.ny // 2]).max(axis=0)
    assert shear[1] * limit.ratio == pytest.approx(1.0, rel=5e-3)
    assert shear.argmax() == 1


def test_first_yield_is_below_shakedown():
    assert shakedown.first_yield().ratio == pytest.approx(1 / 0.300, rel=2e-3)
    onset = sc.critical.onset_cylinder(1.0, 1.0, 0.3, math.sqrt(3.0)).C * math.sqrt(3.0)
    assert shakedown.first_yield(criterion="von_mises").ratio == pytest.approx(onset, rel=1e-4)
    for friction in (0.1, 0.3):
        for criterion in ("tresca", "von_mises"):
            first = shakedown.first_yield(friction, criterion=criterion).ratio
            assert first < shakedown.line(friction, criterion=criterion).ratio


def test_refuses():
    with pytest.raises(ValueError, match="criterion must be"):
        shakedown.line(0.1, criterion="mises")
    with pytest.raises(ValueError, match="friction must be"):
        shakedown.point(-0.1)
    with pytest.raises(ValueError, match="percent"):
        shakedown.elliptic(1.0, friction=30)
    with pytest.raises(ValueError, match="k must be"):
        shakedown.elliptic(1e-60)
    assert dict(shakedown.line()._rows()) == {"p0/k": "4", "where": "0.5 half-widths deep"}
    assert "p0/k (upper bound)" in dict(shakedown.point()._rows())
