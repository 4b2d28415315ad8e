# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts of rolling bearings, loaded once and unloaded: imprint depths of both bodies, summed."""

from __future__ import annotations

import math
import warnings
from typing import NamedTuple

import numpy as np

import samcontact as sc
from samcontact import bearings, hertz

ALLOWED = 1e-4
"""Permissible permanent deformation, divided by the ball diameter."""
FLAT = "ball on a flat"
INCREMENTS = 12
PRESSURES = (3.0e9, 3.4e9, 3.8e9, 4.2e9, 4.6e9, 5.0e9, 5.5e9, 6.0e9)
LENGTH = 1e-3  # length of a slice of a straight roller [m]

BALL, PITCH, BALLS = 12.7e-3, 65e-3, 9  # a deep groove bearing 209
SELF_ALIGNING, ITS_PITCH = 9.525e-3, 48e-3
ROLLER, ITS = 10e-3, 65e-3


class Contact(NamedTuple):
    """Contact, diameter of its ball or roller [m], and Hertz pressure of ISO 76 [Pa]."""

    race: bearings.RaceContact
    diameter: float
    pressure: float


def _contacts() -> dict[str, Contact]:
    inner = bearings.ball_on_race(BALL, PITCH, conformity=0.52)
    outer = bearings.ball_on_race(BALL, PITCH, conformity=0.53, race="outer")
    sphere = 0.5 * SELF_ALIGNING * (1.0 + SELF_ALIGNING / ITS_PITCH)
    return {
        "deep groove, inner race": Contact(inner, BALL, 4.2e9),
        "deep groove, outer race": Contact(outer, BALL, 4.2e9),
        "self-aligning, outer race": Contact(
            bearings.RaceContact(sphere, sphere), SELF_ALIGNING, 4.6e9
        ),
        "straight roller, inner race": Contact(bearings.roller_on_race(ROLLER, ITS), ROLLER, 4.0e9),
        FLAT: Contact(bearings.RaceContact(BALL / 2, BALL / 2), BALL, 4.2e9),
    }


CONTACTS = _contacts()


def swift(B: float, C: float, n: float) -> sc.Material:
    return sc.Material.swift(210e9, 0.3, B=B, C=C, n=n)


def _steels() -> dict[str, sc.Material]:
    steel = swift(945e6, 20.0, 0.121)
    first, conventional = (float(steel.yield_stress(strain)) for strain in (0.0, 2e-3))
    return {
        "AISI 52100": steel,
        "M50": swift(1280e6, 4.0, 0.095),
        "52100, all stresses 10 % lower": swift(0.9 * 945e6, 20.0, 0.121),
        "52100, all stresses 10 % higher": swift(1.1 * 945e6, 20.0, 0.121),
        "52100, half the exponent n": swift(first / 20.0**0.0605, 20.0, 0.0605),
        "perfectly plastic, stress at first yield": sc.Material.perfect_plastic(210e9, 0.3, first),
        "perfectly plastic, 0.2 % proof stress": sc.Material.perfect_plastic(
            210e9, 0.3, conventional
        ),
    }


STEELS = _steels()
STEEL = "AISI 52100"
E_STAR = hertz.effective_modulus(STEELS[STEEL], STEELS[STEEL])


class Pressed(NamedTuple):
    """Results at a Hertz pressure [Pa]: load [N], deformation / diameter, and maximum strain."""

    pressure: float
    load: float
    deformation: float
    strain: float
    palmgren: float
    """Palmgren's permanent deformation divided by the diameter [-]; NaN for line contacts."""


def press(contact: Contact, steel: sc.Material, pressure: float, cells: int = 12) -> Pressed:
    """Load and unload two bodies of this steel, with `cells` cells per semi-axis."""
    race, half = contact.race, int(1.25 * cells)
    line = math.isinf(race.Ry)
    if line:
        hertz_line = hertz.line(race.Rx, E_STAR, p0=pressure)
        a_x, load = hertz_line.b, hertz_line.load_per_length * LENGTH
        grid = sc.Grid(2 * half + 1, 1, a_x / cells, LENGTH, dz=a_x / cells, periodic="y")
    else:
        ellipse = hertz.elliptic(race.Rx, race.Ry, E_STAR, p0=pressure)
        a_x, load = ellipse.a_x, ellipse.load
        dx, dy = a_x / cells, ellipse.a_y / cells
        grid = sc.Grid(2 * half + 1, 2 * half + 1, dx, dy, dz=dx)
    simulation = sc.Simulation(
        grid, steel, steel, lambda any_grid: sc.surfaces.paraboloid(any_grid, race.Rx, race.Ry)
    )
    path = sc.paths.load_unload(load=load, increments=INCREMENTS, unload_increments=1)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # strain outside the grid is included
        last = simulation.run(path, progress=False)[-1]
    prints = sum(float(last.residual_displacement(body).max()) for body in (1, 2))
    strain = max(last.max_equivalent_plastic_strain(body) for body in (1, 2))
    by_formula = (
        math.nan
        if line
        else bearings.palmgren_deformation(race, load, contact.diameter) / contact.diameter
    )
    return Pressed(pressure, load, prints / contact.diameter, strain, by_formula)


def reaches(rows: list[Pressed], values: list[float]) -> float:
    """Return the pressure [Pa] at which `values` reach the permissible value; NaN if never."""
    logs = np.log(np.maximum(values, 1e-12))
    if not values[0] < ALLOWED < values[-1]:
        return math.nan
    pressures = np.log([row.pressure for row in rows])
    return float(np.exp(np.interp(math.log(ALLOWED), logs, pressures)))
