# SPDX-License-Identifier: GPL-3.0-or-later
"""Increments of a small contact under a film of oil, and checks of the film."""

from __future__ import annotations

from typing import Any

import numpy as np

import samcontact as sc

OIL = sc.Lubricant.roelands(viscosity=1.0, pressure_viscosity=15e-9)
SPEEDS = 2.0, 1.8
"""Viscous oil and high speeds [m/s]: a film that large cells resolve."""
TOL = 1e-6


def film_faults(simulation: sc.Simulation, path: list[dict[str, Any]]) -> list[str]:
    """Press a contact under a film along a path, unload it, and return the violated conditions.

    Raises ValueError for increments that a film does not allow.
    """
    found: set[str] = set()
    for step in path[:-1]:
        try:
            pressed = sc.lubrication.press(simulation, speed=SPEEDS, lubricant=OIL, order=1, **step)
        except TypeError as error:  # `press` has no argument for this motion
            raise ValueError(str(error)) from error
        found |= _violated(pressed.film, step["load"])
    simulation.step(**path[-1])
    return sorted(found)


def _violated(film: sc.lubrication.FilmSolution, load: float) -> set[str]:
    conditions = {
        "film > 0": bool(film.film.min() > 0.0),
        "pressure of the fluid >= 0": bool(film.fluid_pressure.min() >= 0.0),
        "no pressure in cavitated cells": not film.fluid_pressure[film.filling < 1.0].any(),
        "load": abs(film.pressure.sum() * film.grid.cell_area / load - 1.0) <= TOL,
        "flow": film.residual <= TOL and bool(np.isfinite(film.film).all()),
    }
    return {name for name, holds in conditions.items() if not holds}
