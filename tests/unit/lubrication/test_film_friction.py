# SPDX-License-Identifier: GPL-3.0-or-later
"""Friction of films: shear laws, balance of power, boundary share."""

import functools
from dataclasses import replace

import numpy as np
import pytest

import samcontact as sc

E_STAR, R, ETA, ALPHA = 113.74e9, 0.01, 0.04, 22e-9
BODY = sc.Material.elastic(2 * E_STAR * 0.91, 0.3)
OIL = sc.Lubricant.roelands(ETA, ALPHA)
films = sc.lubrication


@functools.cache
def ball(compressible=True, boundary=None):
    """Return the film of a ball, M = 20 and L = 10, p_H = 0.45 GPa."""
    oil = OIL if compressible else sc.Lubricant.roelands(ETA, ALPHA, density=None)
    group = (10 / (ALPHA * 2 * E_STAR)) ** 4
    u = 0.5 * group * 2 * E_STAR * R / ETA
    load = 20 * 2 * E_STAR * R**2 * group**0.75
    a = (0.75 * load * R / E_STAR) ** (1 / 3)
    grid = sc.Grid(64, 64, 6 * a / 64, 6 * a / 64)
    x, y = grid.x[:, None] - 1.5 * a, grid.y[None, :]
    return films.steady(
        grid, BODY, BODY, 0.5 * (x**2 + y**2) / R, load=load, speed=(u, u), lubricant=oil,
        boundary=boundary,
    )  # fmt: skip


def sliding(film, ratio, oil=None):
    mean = film.velocities.mean(axis=0)
    speeds = np.array([mean * (1 + ratio / 2), mean * (1 - ratio / 2)])
    return replace(film, velocities=speeds, lubricant=oil or film.lubricant)


def test_traction_has_the_values_of_another_solution():
    """Finite volumes of other code, 96 x 96: 0.0449 Newtonian, 0.0161 with Eyring stress 5 MPa."""
    film = ball()
    newtonian = films.friction(sliding(film, 0.1))
    thin = films.friction(sliding(film, 0.1, OIL.with_eyring(5e6)))
    assert newtonian.coefficient == pytest.approx(0.044887, rel=0.1)
    assert thin.coefficient == pytest.approx(0.016098, rel=0.03)
    assert thin.traction[1] == 0.0
    assert thin.fluid_shear.sum(axis=(1, 2)) * film.grid.cell_area == pytest.approx(thin.traction)


def test_the_power_of_rolling_is_that_of_the_pressure_flow():
    """Without compression, film and gradient do the work h^3/(12 eta) |grad p|^2 of the flow."""
    film = ball(compressible=False)
    found = films.friction(film)
    slopes = np.gradient(film.fluid_pressure, film.grid.dx, film.grid.dy)
    fluidity = film.film**3 / (12 * film.lubricant.viscosity(np.maximum(film.fluid_pressure, 0)))
    flow = (fluidity * sum(s**2 for s in slopes)).sum() * film.grid.cell_area
    assert found.power == pytest.approx(flow, rel=0.05)
    assert found.coefficient == 0.0
    u = film.velocities[0, 0]
    assert found.rolling_resistance == pytest.approx(found.power / 2 / u, rel=1e-12)


def test_a_traction_curve_is_odd_and_rises_to_the_limiting_shear():
    film = sliding(ball(), 0.0, OIL.with_eyring(5e6).with_limiting_shear(0.03))
    curve = films.traction_curve(film, [-0.1, 0.0, 0.1, 1e4])
    assert curve.coefficient[0] == pytest.approx(-curve.coefficient[2])
    assert curve.coefficient[1] == 0.0
    assert curve.coefficient[3] == pytest.approx(0.03, rel=0.02)


def test_the_friction_of_the_boundary_layer_is_its_share_of_the_load():
    layer = sc.lubrication.Boundary(thickness=2e-9, friction=0.12)
    film = ball()
    half = 0.5 * film.fluid_pressure
    mixed = replace(film, fluid_pressure=half, boundary_pressure=half, boundary=layer)
    found = films.friction(sliding(mixed, 1e-9))
    assert found.coefficient == pytest.approx(0.06, rel=1e-3)
    assert found.boundary_share == pytest.approx(1.0, rel=1e-3)


def test_an_impossible_newtonian_friction_is_refused():
    with pytest.raises(ValueError, match="with_eyring"):
        films.friction(sliding(ball(), 2.0))
