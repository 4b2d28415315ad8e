# SPDX-License-Identifier: GPL-3.0-or-later
"""Random microstructures under a contact: drawn setups, and checks of their solutions."""

import warnings

import numpy as np
import pytest

import samcontact as sc

CELL = 5e-6
MATRICES = (
    sc.Material.elastic(210e9, 0.3),
    sc.Material.elastic(3e9, 0.45),
    sc.Material.linear_hardening(210e9, 0.3, 900e6, 20e9),
    sc.Material.perfect_plastic(70e9, 0.33, 300e6),
)


def inclusion_material(random, matrix):
    """Void, elastic with a ratio of moduli from 1e-3 to 1e3, or elastic-plastic."""
    kind = random.integers(4)
    ratio = 10 ** random.uniform(*((-3, 3) if kind == 1 else (-0.6, 1)))
    nu = random.uniform(0.0, 0.45)
    if kind == 0:
        return None
    if kind == 3:
        return sc.Material.linear_hardening(ratio * matrix.E, nu, 0.004 * matrix.E, 0.0)
    return sc.Material.elastic(ratio * matrix.E, nu)


def setup(seed):
    """Simulation and path of a random problem."""
    random = np.random.default_rng(seed)
    matrix = MATRICES[random.integers(len(MATRICES))]
    material = inclusion_material(random, matrix)
    periodic = ("", "", "", "xy")[random.integers(4)]
    count = int(random.integers(9, 12)) * 2
    grid = sc.Grid(count, count, CELL, CELL, dz=CELL, periodic=periodic)
    side, radius = 0.5 * count * CELL, random.uniform(2.0, 4.0) * CELL
    limits = (2 * CELL, 5 * CELL)
    body = sc.Heterogeneous.random(
        matrix, material, random.uniform(0.02, 0.25), (np.clip(radius, *limits), 0.1),
        ((-side, side), (-side, side), (0.0, 1.5 * side)), seed, cover=random.choice([0.0, CELL]),
        misfit=0.0 if material is None else random.choice([0.0, 1e-3, -2e-3]),
        radius_limits=limits,
    )  # fmt: skip
    friction = (0.0, 0.0, 0.2, sc.Coulomb(0.3))[random.integers(4)]
    gap = sc.surfaces.paraboloid(grid, 1e-3)
    a = 0.35 * side
    load = 4 / 3 * matrix.E / (1 - matrix.nu**2) * a**3 / 1e-3
    simulation = sc.Simulation(grid, sc.Material.rigid(), body, gap, friction, tol=1e-3)
    path = [{"load": 0.5 * load}, {"load": load}]
    if random.integers(2) and periodic == "" and friction == 0.0:
        path.append({"load": load, "advance": (0.0, -CELL)})
    return simulation, [*path, {"load": 0.0}], load


def solved(seed):
    """Solve a random problem; return whether it has an answer. Wrong answers raise an error."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            simulation, path, load = setup(seed)
        except ValueError:  # no inclusion is drawn, or one finds no place
            return False
        try:
            states = [simulation.step(**step) for step in path]
        except sc.ConvergenceError:
            return False
        except ValueError as error:
            if "the plastic zone of body 2 is unbounded" not in str(error):
                raise
            return False
        largest = max(np.abs(state.stress(2)).max() for state in states)
        for state, step in zip(states, path, strict=True):
            total = state.pressure.sum() * state.grid.cell_area
            assert total == pytest.approx(step["load"], abs=1e-6 * load)
            assert state.pressure.min() >= 0.0
            stress = state.stress(2)
            assert np.isfinite(stress).all()
            void = (state.share(2) == 1.0) & np.isin(state.phase(2), voids(state))
            if void.any() and state.converged:
                assert np.sqrt(np.mean(stress[:, void] ** 2)) <= 0.01 * largest
                void[[0, -1]] = False  # cells that the end of the grid may cut
                assert np.abs(stress[:, void]).max(initial=0.0) <= 0.05 * largest
    return True


def voids(state):
    """Numbers of the inclusions that are voids."""
    return [n for n, one in enumerate(state.setup.bodies[1].inclusions) if one.is_void]
