# SPDX-License-Identifier: GPL-3.0-or-later
"""Coulomb friction with a shear limit: Coulomb below it, Tresca above."""

import math

import numpy as np
import pytest

import samcontact as sc

STEEL = sc.Material.elastic(210e9, 0.3)
BRASS = sc.Material.elastic(100e9, 0.2)
YIELDS = sc.Material.linear_hardening(210e9, 0.3, 1.2e9, 10e9)
GRID = sc.Grid(28, 28, 36e-6, 36e-6, dz=36e-6)
GAP = sc.surfaces.paraboloid(GRID, 7.5e-3)
MU, LOAD = 0.3, 300.0
PATH = [
    {"load": 0.5 * LOAD},
    {"load": LOAD, "shift": (2e-6, 1e-6)},
    {"load": LOAD, "tangential_load": (-20.0, None), "twist": 1e-3},
    {"load": 0.8 * LOAD, "shift": (1e-3, 0.0)},
]
FIELDS = ("pressure", "shear", "slip", "sticking")
dissimilar = pytest.mark.parametrize("body1", [STEEL, BRASS], ids=["alike", "dissimilar"])


def walk(law, body1, body2=STEEL):
    solver, found = sc.ContactSolver(GRID, body1, body2, law), []
    for step in PATH:
        found.append(solver.solve(GAP, previous=found[-1] if found else None, **step))
    return found


def same(one, other):
    return all(np.array_equal(getattr(one, name), getattr(other, name)) for name in FIELDS)


@dissimilar
def test_an_unreached_shear_limit_changes_no_digit(body1):
    coulomb = walk(sc.Coulomb(MU), body1)
    most = max(found.pressure.max() for found in coulomb)
    for limit in (1.01 * MU * most, math.inf):
        capped = walk(sc.CappedCoulomb(MU, limit), body1)
        assert all(map(same, coulomb, capped))
        assert [c.shift.tolist() for c in coulomb] == [c.shift.tolist() for c in capped]
    capped = walk(sc.CappedCoulomb(MU, 0.9 * MU * most), body1)
    assert not same(coulomb[-1], capped[-1])


def test_an_unreached_shear_limit_changes_no_digit_in_plastic_contact():
    runs = [
        sc.Simulation(GRID, STEEL, YIELDS, GAP, law)
        for law in (sc.Coulomb(MU), sc.CappedCoulomb(MU, 1e12))
    ]
    for step in PATH:
        one, other = (run.step(**step) for run in runs)
        assert same(one, other)
        assert np.array_equal(one.plastic_strain(2), other.plastic_strain(2))


@dissimilar
def test_gross_slip_is_coulomb_below_the_limit_and_tresca_above(body1):
    limit = 0.6 * MU * walk(sc.Coulomb(MU), body1)[-1].pressure.max()
    *_, found = walk(sc.CappedCoulomb(MU, limit), body1)
    assert not found.sticking.any()
    length, expected = np.hypot(*found.shear), np.minimum(MU * found.pressure, limit)
    np.testing.assert_allclose(length, expected, rtol=1e-12)
    below = MU * found.pressure < limit
    assert 0.2 < np.count_nonzero(below & (length > 0)) / np.count_nonzero(length) < 0.8


def test_force_at_full_sliding_with_a_shear_limit():
    forces = [
        math.hypot(*walk(law, STEEL)[-1].tangential_load)
        for law in (sc.CappedCoulomb(MU, 2.5e8), sc.Coulomb(MU), sc.Tresca(2.5e8))
    ]
    assert 0 < forces[0] < min(forces[1:])


def test_rolling_is_coulomb_where_no_cell_reaches_the_limit():
    def roll(law):
        drive = {"creepage": (2e-3, 0.0), "spin": 0.5}
        return sc.rolling.steady(GRID, STEEL, BRASS, GAP, load=LOAD, friction=law, **drive)

    assert same(roll(sc.Coulomb(MU)), roll(sc.CappedCoulomb(MU, 1e12)))
    law = sc.CappedCoulomb(MU, 1e8)
    found = roll(law)
    assert (np.hypot(*found.shear) <= law.bound(found.pressure) * (1 + 1e-12)).all()
    assert np.hypot(*found.shear).max() == pytest.approx(1e8)


def test_an_infinite_coefficient_is_refused():
    with pytest.raises(ValueError, match=r"^coefficient must be a finite number >= 0, got inf"):
        sc.CappedCoulomb(math.inf, 1e8)
