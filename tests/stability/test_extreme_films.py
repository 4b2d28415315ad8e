# SPDX-License-Identifier: GPL-3.0-or-later
"""Films of any load, speed and layer, in and beyond the range of the theory, end well.

They bear the load, or a named error says why they do not.
"""

import math

import numpy as np
import pytest

import samcontact as sc

pytestmark = pytest.mark.filterwarnings("ignore::UserWarning", "ignore::RuntimeWarning")
NAMED = (sc.ConvergenceError, ValueError)
STEEL = sc.Material.elastic(210e9, 0.3)
IN_CI, ALL = 12, 300


def contact_of(draw):
    """Grid, bodies, gap and load of a random Hertz contact, and its size."""
    is_line, n = draw.random() < 0.2, int(draw.choice([20, 28]))
    R, stretch = 10 ** draw.uniform(-3, -1), 1.0
    soft = draw.random() < 0.3
    body = sc.Material.elastic(10 ** draw.uniform(7, 11.5) if soft else 210e9, 0.3)
    E_star = sc.hertz.effective_modulus(body, STEEL)
    peak = min(10 ** draw.uniform(-4, -1.4) * E_star, 4e9)
    size = (2.0 if is_line else math.pi / 2) * peak * R / E_star
    step = draw.uniform(3.5, 7) * size / n
    if not is_line and draw.random() < 0.4:
        stretch = 10 ** draw.uniform(0, 0.6)
    grid = sc.Grid(n, 1, step, step, periodic="y") if is_line else sc.Grid(n, n, step, step)
    x = grid.x[:, None] + draw.uniform(-0.7, 0.3) * size
    y = 0.0 if is_line else grid.y[None, :]
    gap = np.broadcast_to(0.5 * x**2 / R + 0.5 * y**2 / (R * stretch), grid.surface_shape).copy()
    load = peak * size * (math.pi / 2 * step if is_line else 2 / 3 * math.pi * size * stretch**0.5)
    return grid, body, gap, load, size


def flow_of(draw, grid, size):
    """Lubricant, speeds and numerical settings."""
    viscosity, coefficient = 10 ** draw.uniform(-3, 0), 10 ** draw.uniform(-8.5, -7.5)
    law = sc.Lubricant.roelands if draw.random() < 0.7 else sc.Lubricant.barus
    mean, slip = 10 ** draw.uniform(-3, 1.5), draw.uniform(-1, 1)
    speed = np.array([mean * (1 + slip), mean * (1 - slip)])
    settings = {"order": int(draw.integers(1, 4))}
    if grid.ny > 1 and draw.random() < 0.2:
        angle = draw.uniform(0, math.pi)
        speed = np.outer(speed, [math.cos(angle), math.sin(angle)])
    if draw.random() < 0.5:
        settings["boundary"] = sc.lubrication.Boundary(10 ** draw.uniform(-9, -6.5))
    if draw.random() < 0.2:
        settings["supply"] = 10 ** draw.uniform(-7.5, -5.5)
    if grid.ny > 1 and draw.random() < 0.2:
        settings["spin"] = mean / size * draw.uniform(-0.3, 0.3)
    oil = law(viscosity=viscosity, pressure_viscosity=coefficient)
    return {"lubricant": oil, "speed": speed, **settings}


def solved(number):
    """Solve a random contact; return the film, or the error."""
    draw = np.random.default_rng(number)
    grid, body, gap, load, size = contact_of(draw)
    settings = flow_of(draw, grid, size)
    if draw.random() < 0.2:
        gap = gap + 10 ** draw.uniform(-9, -7) * draw.standard_normal(gap.shape)
        settings.setdefault("boundary", sc.lubrication.Boundary(2e-9))
    try:
        film = sc.lubrication.steady(grid, body, STEEL, gap, load=load, **settings)
    except NAMED as error:
        return error
    assert np.isfinite(film.pressure).all()
    assert film.fluid_pressure.min() >= 0
    assert film.film.min() > (0.0 if film.boundary is None else film.boundary.thickness)
    assert film.filling.min() >= 0
    assert film.filling.max() <= 1
    assert film.pressure.sum() * grid.cell_area == pytest.approx(load, rel=1e-5)
    assert film.residual <= 1e-6
    return film


def test_extreme_films():
    ends = [solved(number) for number in range(IN_CI)]
    assert sum(isinstance(end, sc.lubrication.FilmSolution) for end in ends) >= IN_CI // 2


@pytest.mark.slow
def test_many_extreme_films():
    ends = [solved(number) for number in range(IN_CI, ALL)]
    assert sum(isinstance(end, sc.lubrication.FilmSolution) for end in ends) >= ALL // 2
