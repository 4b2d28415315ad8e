# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects of lubricants and films, whose reprs are tested."""

import warnings

import numpy as np

import samcontact as sc


def lubricants_and_films():
    """Return lubricants, film formulas and films."""
    oil = sc.Lubricant.roelands(0.04, 22e-9 / 3).with_thermal(0.14, 1.7e6, 0.04 / 3)
    tabulated = sc.Lubricant.tabulated([0.0, 1e8, 2e8], [0.04, 0.3, 2.0], [900.0, 940.0, 970.0])
    steel = sc.Material.elastic(210e9, 0.3)
    grid = sc.Grid(24, 24, 2e-5, 2e-5, dz=2e-5)
    gap = sc.surfaces.paraboloid(grid, 0.01)
    ball = sc.hertz.point(0.01, 1.1e11, load=20.0 / 3)
    case = (ball, (1.0, 0.8), oil)
    layer = sc.lubrication.Boundary(1e-9 / 3)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        film = sc.lubrication.steady(
            grid, steel, steel, gap, load=40.0, speed=(1.0, 0.9), lubricant=oil
        )
        warm = steel.with_thermal(46.0, 12e-6, 12.5e-6)
        heated = sc.lubrication.steady(
            grid, warm, warm, gap, load=40.0, speed=(1.0, 0.9), lubricant=oil.with_eyring(5e6),
            thermal=True, tol=1e-4,
        )  # fmt: skip
        history = sc.lubrication.transient(film, duration=1e-5, steps=1)
        pressed = sc.lubrication.press(
            sc.Simulation(grid, steel, steel, gap), load=40.0, speed=(1.0, 0.9), lubricant=oil
        )
        (loaded,) = sc.lubrication.press_loads(
            sc.Simulation(grid, steel, steel, gap), loads=[40.0], speed=(1.0, 0.9), lubricant=oil
        )
        rubbing = sc.lubrication.steady(
            grid, steel, steel, gap, load=40.0, speed=(1e-3, 0.0), lubricant=oil, order=1,
            boundary=sc.lubrication.Boundary(2e-9),
        )  # fmt: skip
        worn = sc.lubrication.running_in(rubbing, archard=1e-15 / 3, duration=0.1, steps=1)
    return [
        loaded.plasticity, worn, oil, tabulated, oil.density_law, tabulated.density_law, oil.heat,
        oil.tables(1e9),
        sc.lubricants.Incompressible(), sc.lubricants.Tait(1.2e9 / 3, 11.7),
        sc.lubricants.iso_vg(68), sc.lubrication.estimate(*case),
        sc.lubrication.hamrock_dowson(*case), sc.lubrication.moes(*case), layer, film, history,
        heated, heated.heat, sc.lubrication.FilmErrors(1e-9 / 3, 2e-9 / 3),
        film.levels[0], pressed, sc.lubrication.StribeckCurve((film,) * 50, np.array(gap)),
        sc.lubrication.friction(film), sc.lubrication.traction_curve(film, [0.0, 1 / 3]),
    ]  # fmt: skip
