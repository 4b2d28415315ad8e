# SPDX-License-Identifier: GPL-3.0-or-later
"""Random lubricated contacts: drawn setups, and checks of their films."""

import warnings

import numpy as np
import pytest

import samcontact as sc

NAMED = (sc.ConvergenceError, sc.GridTooSmallError, ValueError)
"""Errors that a contact may end in; a ValueError names the argument that is out of range."""


def lubricant_of(draw):
    """Return a random lubricant."""
    eta, alpha = 10 ** draw.uniform(-3, 0), 10 ** draw.uniform(-8.5, -7.5)
    kind = draw.integers(4)
    if kind == 0:
        return sc.Lubricant.roelands(viscosity=eta, pressure_viscosity=alpha)
    if kind == 1:
        return sc.Lubricant.barus(eta, 10 ** draw.uniform(-9, -8), density=None)
    if kind == 2:
        return sc.Lubricant.roelands(eta, alpha, density=None).with_eyring(5e6)
    return sc.lubricants.iso_vg(int(draw.choice([32, 68, 220]))).lubricant(T=draw.uniform(300, 380))


def setup(seed):
    """Return arguments of a steady film, with Moes numbers M from 3 to 200."""
    draw = np.random.default_rng(seed)
    hard = sc.Material.elastic(207e9, 0.3)
    lower = hard if draw.random() < 0.6 else sc.Material.elastic(10 ** draw.uniform(6.5, 9), 0.45)
    modulus = sc.hertz.effective_modulus(hard, lower)
    R, p0 = 10 ** draw.uniform(-3, -1), modulus * 10 ** draw.uniform(-3.2, -2)
    line = draw.random() < 0.2
    oil = lubricant_of(draw)
    if line:
        load = np.pi * R * p0**2 / modulus  # per length
        a, group, power = 2 * load / (np.pi * p0), load / (2 * modulus * R), 2
    else:
        load = np.pi**3 * p0**3 * R**2 / (6 * modulus**2)
        a = sc.hertz.point(R, modulus, load=load).a
        group, power = load / (2 * modulus * R**2), 4 / 3
    U = 0.5 * (group / 10 ** draw.uniform(0.5, 2.3)) ** power
    u = U * 2 * modulus * R / float(oil.viscosity(0.0))
    n = 48 if line else int(draw.choice([24, 32]))
    d = draw.uniform(4.5, 6.5) * a / n
    grid = sc.Grid(n, 1, d, d, periodic="y") if line else sc.Grid(n, n, d, d)
    x, y = grid.x[:, None] - 0.16 * n * d, grid.y[None, :]
    gap = 0.5 * (x**2 + (0 if line else draw.uniform(0.3, 1.5)) * y**2) / R
    if draw.random() < 0.3:
        gap = gap + 1e-3 * a**2 / R * np.sin(2 * np.pi * x / (12 * d)) + 0.0 * y
    slide = u * draw.uniform(-1, 1)
    given = {"speed": (u + 0.5 * slide, u - 0.5 * slide), "lubricant": oil}
    given |= {"load": load * (d if line else 1.0), "order": int(draw.integers(1, 4))}
    if draw.random() < 0.3:
        given["boundary"] = sc.lubrication.Boundary(1e-3 * a**2 / R, draw.uniform(0, 0.2))
    if draw.random() < 0.2:
        given["supply"] = a**2 / R * 10 ** draw.uniform(-2, 1)
    return (grid, hard, lower, gap), given


def solved(seed):
    """Solve a random contact; return the film, or the error. Wrong films raise an error."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            problem, given = setup(seed)
            film = sc.lubrication.steady(*problem, **given)
        except NAMED as error:
            return error
    check(film, given)
    return film


def check(film, given):
    """Assert the balance of the load, and cavitation without pressure."""
    p, filling = film.fluid_pressure, film.filling
    for field in (p, filling, film.film, film.boundary_pressure):
        assert np.isfinite(field).all()
    assert film.converged
    assert film.residual <= 1e-6
    assert p.min() >= 0.0
    assert film.boundary_pressure.min() >= 0.0
    assert film.film.min() > 0.0
    assert 0.0 < filling.min() <= filling.max() <= 1.0
    assert not p[filling < 1.0].any()
    assert film.load == pytest.approx(given["load"], rel=1e-5)
    assert film.pressure.sum() * film.grid.cell_area == pytest.approx(film.load, rel=1e-9)
