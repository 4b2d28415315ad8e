# SPDX-License-Identifier: GPL-3.0-or-later
"""Film formulas against their published limits, and against solutions of Reynolds' equation."""

import numpy as np
import pytest

import samcontact as sc
from samcontact.lubrication.groups import film_groups

E_STAR, R, ETA, ALPHA = 113.74e9, 0.01, 0.04, 22e-9
OIL = sc.Lubricant.roelands(ETA, ALPHA)
films = sc.lubrication


def point(M, L, D=1.0, oil=OIL):
    """Return a contact with Moes' numbers M and L, its speeds and Moes' scale of films."""
    modulus = 2 * E_STAR
    speed = (L / (ALPHA * modulus)) ** 4
    load = M * modulus * R**2 * speed**0.75
    contact = sc.hertz.elliptic(R, R / D, E_STAR, load=load)
    u = speed * modulus * R / ETA
    return contact, (0.7 * u, 0.3 * u), oil, R * speed**0.5


def line(M, L):
    modulus = 2 * E_STAR
    speed = (L / (ALPHA * modulus)) ** 4
    contact = sc.hertz.line(R, E_STAR, load_per_length=M * modulus * R * speed**0.5)
    u = speed * modulus * R / ETA
    return contact, (0.5 * u, 0.5 * u), OIL, R * speed**0.5


@pytest.mark.parametrize("case", [point(200.0, 10.0), line(100.0, 10.0)])
def test_moes_numbers_are_those_of_the_contact(case):
    expected = (200.0, 10.0) if hasattr(case[0], "Rx") else (100.0, 10.0)
    assert films.moes(*case[:3]) == pytest.approx(expected)


@pytest.mark.parametrize(
    ("M", "formula", "solved"),
    [(20, 4.7081, 4.6622), (200, 4.3803, 4.3046), (1000, 4.0346, 3.8854)],
)
def test_nijenbanning_agrees_with_solutions_for_incompressible_oil(M, formula, solved):
    """Solutions: incompressible, third order, 96 x 96 cells."""
    *case, scale = point(M, 10.0)
    found = films.nijenbanning(*case) / scale
    assert found == pytest.approx(formula, rel=2e-5)
    assert found == pytest.approx(solved, rel=0.04)


@pytest.mark.parametrize(
    ("M", "central", "minimum", "excess"),
    [(20, 4.184, 2.85, 0.91), (200, 3.638, 1.74, 1.26), (1000, 3.19, 1.11, 1.755)],
)
def test_hamrock_dowson_central_film_is_near_solutions(M, central, minimum, excess):
    """The minimum film is known to be too thick at heavy loads, by 76 % at M = 1000, L = 10."""
    *case, scale = point(M, 10.0)
    found = films.hamrock_dowson(*case)
    assert found.central / scale == pytest.approx(central, rel=0.1)
    assert found.minimum / scale / minimum == pytest.approx(excess, rel=0.01)


@pytest.mark.parametrize(("M", "minimum"), [(10, 4.0925), (100, 3.09), (200, 2.8242)])
def test_dowson_higginson_agrees_with_solutions_of_line_contacts(M, minimum):
    """Solutions: third order, 1024 cells, Dowson-Higginson density."""
    *case, scale = line(M, 10.0)
    assert films.dowson_higginson(*case) / scale == pytest.approx(minimum, rel=0.025)
    assert films.estimate(*case).minimum == films.dowson_higginson(*case)


def test_the_soft_film_agrees_with_a_solution():
    """M = 100, isoviscous: 1.149 on 96 x 96 cells; Nijenbanning, Venner & Moes 1.231."""
    water, speed = sc.Lubricant.barus(ETA, 0.0, density=None), 2e-8
    contact = sc.hertz.point(R, 5e6, load=100.0 * 1e7 * R**2 * speed**0.75)
    u = 0.5 * speed * 1e7 * R / ETA
    case, scale = (contact, (u, u), water), R * speed**0.5
    assert films.moes(*case) == pytest.approx((100.0, 0.0))
    assert films.nijenbanning(*case) / scale == pytest.approx(1.149, rel=0.08)
    soft = films.hamrock_dowson(*case, material="soft")
    assert soft.central / scale == pytest.approx(1.149, rel=0.08)
    assert films.estimate(*case).minimum == soft.minimum


def test_the_rigid_film_is_between_two_boundary_conditions():
    """A sphere: 113.6 (U/W)^2 R without suction (half Sommerfeld, exact); the formula has 140."""
    water = sc.Lubricant.barus(ETA, 0.0, density=None)
    *case, _ = point(0.05, 1.0, oil=water)
    found = film_groups(*case)
    assert films.regime(*case) == "rigid-isoviscous"
    # F = 12 eta u (2 R)^(3/2) h^(-1/2) pi/10, solved for h
    exact = R * 8 * (12 * np.pi / 10 * found.U / found.W) ** 2
    assert exact == pytest.approx(113.7 * R * (found.U / found.W) ** 2, rel=1e-3)
    assert films.rigid_isoviscous(*case) == pytest.approx(140 / 113.7 * exact, rel=2e-3)


@pytest.mark.parametrize(
    ("M", "L", "regime"),
    [
        (0.05, 0.01, "rigid-isoviscous"),
        (1e3, 0.01, "elastic-isoviscous"),
        (5.0, 20.0, "rigid-piezoviscous"),
        (20.0, 10.0, "elastic-piezoviscous"),
        (1e3, 10.0, "elastic-piezoviscous"),
    ],
)
def test_regimes(M, L, regime):
    assert films.regime(*point(M, L)[:3]) == regime


def test_a_bearing_has_a_film():
    """6208 at 3000 rpm: speeds as seen from the cage at both races, a film below a micrometre."""
    bearing = sc.bearings.standard("6208")
    omega = 2 * np.pi * 50
    u = films.bearing_speeds(bearing, omega)
    D, dm = bearing.element_diameter, bearing.pitch_diameter
    cage = omega / 2 * (1 - D / dm)
    assert u[0] == pytest.approx((omega - cage) * (dm - D) / 2)
    assert u[0] == pytest.approx(cage * (dm + D) / 2)
    found = films.estimate(bearing.hertz("inner", 1000.0, E_STAR), u, OIL)
    assert found.regime == "elastic-piezoviscous"
    assert 2e-7 < found.minimum < found.central < 2e-6
    assert found.lambda_ratio(1e-7, 1e-7) == pytest.approx(found.minimum / np.sqrt(2) / 1e-7)
    assert "Hamrock" in found._repr_html_()


@pytest.mark.parametrize(
    ("call", "error", "words"),
    [
        (lambda: films.moes(point(1, 1)[0], 1.0, OIL), TypeError, "same number twice"),
        (lambda: films.moes(point(1, 1)[0], (1.0, -1.0), OIL), ValueError, "must differ from 0"),
        (lambda: films.hamrock_dowson(*line(10, 10)[:3]), ValueError, "dowson_higginson"),
        (lambda: films.dowson_higginson(*point(10, 10)[:3]), ValueError, "hamrock_dowson"),
        (lambda: films.nijenbanning(*point(10, 10, 3.0)[:3]), ValueError, "Ry >= Rx"),
        (lambda: films.lambda_ratio(1e-6, 0.0), ValueError, "smooth"),
        (lambda: films.estimate(1.0, (1.0, 1.0), OIL), TypeError, "Hertz contact"),
    ],
)
def test_wrong_arguments_are_refused(call, error, words):
    with pytest.raises(error, match=words):
        call()


def soft_bodies(E_star, load, oil, R=0.01, u=1.0):
    return sc.hertz.point(R, E_star, load=load), (u, u), oil


def test_the_soft_formula_warns_of_hard_bodies():
    """The formula of Nijenbanning, Venner & Moes was fitted to all moduli."""
    water = sc.Lubricant.barus(1e-3, 0.0, density=None)
    hard = soft_bodies(E_STAR, 50.0, water)
    assert films.regime(*hard) == "elastic-isoviscous"
    with pytest.warns(UserWarning, match=r"[UW] should be near .* nijenbanning"):
        found = films.estimate(*hard)
    assert abs(found.central / films.nijenbanning(*hard) - 1.0) > 0.05
    rubber = soft_bodies(5e6, 1.0, water)  # warnings are errors
    assert films.regime(*rubber) == "elastic-isoviscous"
    assert films.estimate(*rubber).central == pytest.approx(films.nijenbanning(*rubber), rel=0.25)


@pytest.mark.parametrize(
    ("E_star", "alpha", "load", "regime", "formula"),
    [
        (E_STAR, 22e-9, 1e5, "elastic-piezoviscous", "Dowson & Higginson"),
        (5e6, 0.0, 1e3, "elastic-isoviscous", "Herrebrugh"),
        (E_STAR, 0.0, 1e5, "elastic-isoviscous", "Herrebrugh"),
        (E_STAR, 1e-10, 300.0, "rigid-isoviscous", "Martin"),
        (E_STAR, 22e-9, 1e4, "rigid-piezoviscous", "Blok"),
    ],
)
def test_the_regime_of_a_line_contact_chooses_the_formula(E_star, alpha, load, regime, formula):
    contact = sc.hertz.line(R, E_star, load_per_length=load)
    case = contact, (1.0, 1.0), sc.Lubricant.barus(ETA, alpha, density=None)
    found = films.estimate(*case)
    assert (found.regime, found.formula) == (regime, formula)
    assert films.regime(*case) == regime
    if formula == "Dowson & Higginson":
        assert found.minimum == films.dowson_higginson(*case)
    elif alpha > 0.0:
        with pytest.warns(UserWarning, match=f"got the regime {regime}"):
            films.dowson_higginson(*case)


def test_a_soft_line_contact_has_the_film_of_herrebrugh():
    """Isoviscous, incompressible: the formula against the solution of Reynolds' equation."""
    E, load, u = 10e6, 2e3, 1.0
    water = sc.Lubricant.barus(ETA, 0.0, density=None)
    contact = sc.hertz.line(R, E / 2 / 0.91, load_per_length=load)
    grid = sc.Grid(128, 1, 6 * contact.b / 128, 1e-3, periodic="y")
    rubber = sc.Material.elastic(E, 0.3)
    film = films.steady(
        grid, rubber, rubber, sc.surfaces.paraboloid(grid, R, np.inf), load=1e-3 * load,
        speed=(u, u), lubricant=water,
    )  # fmt: skip
    formula = films.estimate(contact, (u, u), water).minimum
    assert film.minimum_film == pytest.approx(formula, rel=0.15)
