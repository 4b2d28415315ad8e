# SPDX-License-Identifier: GPL-3.0-or-later
"""Increment errors, estimated and true, for the table in docs/theory/accuracy.md.

The cases are also used by tests/unit/simulation/test_increment_errors.py.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np

import samcontact as sc

from .study import table

STEEL = sc.Material.elastic(210e9, 0.3)
ALUMINIUM = sc.Material.elastic(70e9, 0.2)
RIGID = sc.Material.rigid()
SWIFT = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
HARDENING = sc.Material.linear_hardening(210e9, 0.3, 1e9, 10e9)
PERFECT = sc.Material.perfect_plastic(210e9, 0.3, 1e9)
R = 7.5e-3
CELLS_ROLLED = 12  # cells

Path = list[dict[str, Any]]
Friction = float | sc.Coulomb


def ball(
    body1: sc.Material,
    body2: sc.Material,
    load: float,
    friction: Friction = 0.0,
    cells: int = 12,
    **options: Any,
) -> sc.Simulation:
    """Return a simulation of a ball on a flat, with `cells` cells across the elastic contact."""
    moduli = [(1 - body.nu**2) / body.E for body in (body1, body2) if body is not RIGID]
    half_width = (0.75 * load * R * sum(moduli)) ** (1 / 3)
    size, n = 2 * half_width / cells, int(1.5 * cells) | 1
    volume = {"dz": size} if body2.is_plastic else {}
    grid = sc.Grid(n, n, size, size, **volume)
    return sc.Simulation(
        grid, body1, body2, lambda g: sc.surfaces.paraboloid(g, R), friction, **options
    )


def pressed(load: float, count: int) -> Path:
    """Return a load path of `count` increments."""
    return [{"load": load * n / count} for n in range(1, count + 1)]


def shaken(load: float, force: float, count: int) -> Path:
    """Return a path: loading, then a tangential force that is applied, reversed and reapplied."""
    shares = np.arange(1, count + 1) / count
    forces = np.concatenate([shares, 1 - 2 * shares, -1 + 2 * shares]) * force
    return pressed(load, count) + [
        {"load": load, "tangential_load": (float(q), 0.0)} for q in forces
    ]


def rolled(load: float, size: float, count: int) -> Path:
    """Return a path: loading, then rolling over `CELLS_ROLLED` cells in `count` increments."""
    distance = CELLS_ROLLED / count * size
    return pressed(load, count) + [{"load": load, "advance": (distance, distance)}] * count


class Setup(NamedTuple):
    """Contact case: a body pressed, fretted or rolled on another."""

    cells: int
    """Number of cells across the elastic contact."""
    make: Callable[[int], sc.Simulation]
    """Function that returns the simulation for a number of cells."""
    path: Callable[[sc.Simulation, int], Path]
    """Function that returns the load path, for a number of increments in each segment."""
    fields: tuple[str, ...]
    """Names of the fields with increment errors."""
    counts: tuple[int, ...] = (1, 4, 16)
    many: int = 64


STRAIN = "equivalent_plastic_strain_body2"
SETUPS = {
    "rigid ball on an elastic body, μ = 0.3 (Coulomb)": Setup(
        16, lambda n: ball(RIGID, ALUMINIUM, 50.0, sc.Coulomb(0.3), n),
        lambda sim, n: pressed(50.0, n), ("pressure", "shear"),
    ),
    "fretting loop of dissimilar bodies, μ = 0.5 (Coulomb)": Setup(
        12, lambda n: ball(STEEL, ALUMINIUM, 50.0, sc.Coulomb(0.5), n),
        lambda sim, n: shaken(50.0, 15.0, n), ("pressure", "shear"),
    ),
    "rigid ball on elastic-plastic steel, μ = 0.3 (Coulomb)": Setup(
        12, lambda n: ball(RIGID, SWIFT, 1000.0, sc.Coulomb(0.3), n),
        lambda sim, n: pressed(1000.0, n), ("shear", STRAIN),
    ),
    "rigid ball on a perfectly plastic body": Setup(
        12, lambda n: ball(RIGID, PERFECT, 2000.0, cells=n),
        lambda sim, n: pressed(2000.0, n), ("pressure", STRAIN),
    ),
    "two steel balls": Setup(
        12, lambda n: ball(STEEL, SWIFT, 1500.0, cells=n),
        lambda sim, n: pressed(1500.0, n), (STRAIN,),
    ),
    "rolling pass over 12 cells with plastic flow, μ = 0.1": Setup(
        12, lambda n: ball(STEEL, HARDENING, 600.0, 0.1, n),
        lambda sim, n: rolled(600.0, sim.grid.dx, n), ("pressure", STRAIN), (3, 6, 12), 48,
    ),
}  # fmt: skip


def solved(setup: Setup, count: int) -> tuple[sc.Simulation, Path, list[sc.State]]:
    """Solve a case with `count` increments in each segment of its path."""
    simulation = setup.make(setup.cells)
    path = setup.path(simulation, count)
    return simulation, path, simulation.run(path, progress=False)


def true_error(name: str, states: Sequence[sc.State], finer: Sequence[sc.State]) -> float:
    """Return the maximum relative difference of a field from a run with more increments.

    Strains are compared in the last state, other fields in all states.
    """

    def of(state: sc.State) -> np.ndarray:
        field, _, body = name.partition("_body")
        found = getattr(state, field)
        return np.asarray(found(int(body)) if body else found)

    every = len(finer) // len(states)
    pairs = [*zip(map(of, states), map(of, finer[every - 1 :: every]), strict=True)]
    pairs = pairs[-1:] if "strain" in name else pairs
    largest = max(np.abs(one).max() for one, _ in pairs)
    return float(max(np.abs(_difference(*pair)).max() for pair in pairs) / largest)


def _difference(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Return the difference of two fields in their common layers."""
    layers = slice(min(one.shape[-1], other.shape[-1]))
    return np.asarray(one[..., layers] - other[..., layers])


def errors(setup: Setup, counts: Sequence[int], many: int) -> dict[str, list[tuple[float, float]]]:
    """Return true and estimated relative errors of each field for each number of increments."""
    found: dict[str, list[tuple[float, float]]] = {name: [] for name in setup.fields}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", sc.IncrementWarning)
        finer = solved(setup, many)[2]
        for count in counts:
            simulation, path, states = solved(setup, count)
            stated = sc.estimate_errors(simulation, path, states).increments
            assert stated is not None
            for name, pairs in found.items():
                pairs.append((true_error(name, states, finer), stated.fields[name]))
    return found


def stated_errors(names: Sequence[str] = tuple(SETUPS), runs: int | None = None) -> str:
    """Return true increment errors, and their ratio to the estimated errors.

    runs: number of increment counts to run for each case; None for all counts.
    """
    rows = []
    for name in names:
        setup = SETUPS[name]
        counts = setup.counts[:runs]
        for field, pairs in errors(setup, counts, setup.many).items():
            rows.append(
                [
                    name,
                    str(setup.cells),
                    f"{_listed(counts)} against {setup.many}",
                    "plastic strain" if "strain" in field else field,
                    _listed(float(f"{100 * true:.2g}") for true, _ in pairs),
                    _listed(float(f"{true / stated:.2g}") for true, stated in pairs),
                ]
            )
    heading = ["case", "cells across the contact", "increments in a segment", "field"]
    return table([*heading, "true error [%]", "true error / estimated error"], rows)


def _listed(numbers: Iterable[float]) -> str:
    return ", ".join(f"{number:g}" for number in numbers)
