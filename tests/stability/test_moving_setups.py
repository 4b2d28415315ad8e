# SPDX-License-Identifier: GPL-3.0-or-later
"""Random rolling and sliding contacts of materials with little hardening are all solved."""

import math

import numpy as np
import pytest

import samcontact as sc

E, NU = 210e9, 0.3


def draw(seed):
    """Draw bodies and a problem of 2000 to 8192 cells; p0 is 1.8 to 6 times the yield stress."""
    draws = np.random.default_rng(seed)
    yield_stress = draws.uniform(0.4e9, 2e9)
    law = draws.choice(["perfect", "weak", "kinematic"])
    if law == "weak":
        modulus = E * 10 ** draws.uniform(-4, math.log10(0.05))
        body = sc.Material.linear_hardening(E, NU, yield_stress, modulus)
    else:
        body = sc.Material.perfect_plastic(E, NU, yield_stress)
    if law == "kinematic":
        body = body.with_kinematic_hardening([E * draws.uniform(0.01, 0.1)])
    other = draws.choice([sc.Material.elastic(E, NU), sc.Material.rigid(), body])
    p0 = draws.uniform(1.8, 6.0) * yield_stress
    radius, modulus = 1e-2, sc.hertz.effective_modulus(other, body)
    half = math.pi * p0 * radius / (2 * modulus)
    # the contact area is about the load over 2.8 times the yield stress
    reach = half * max(1.0, math.sqrt(2 / 3 * p0 / (2.8 * yield_stress)))
    cell = reach / draws.uniform(4.0, 6.0)
    nx, ny = (2 * math.ceil(draws.uniform(1.9, 2.3) * reach / cell) + 1 for _ in range(2))
    nz = max(int(draws.integers(2000, 8193)) // (nx * ny), 6)
    grid = sc.Grid(nx, ny, cell, cell, nz, 3.2 * reach / nz)
    ways = [(cell, cell), (0.0, cell), (cell, -cell), (0.5 * cell, 0.5 * cell)]
    return body, other, grid, radius, 2 / 3 * math.pi * half**2 * p0, ways[draws.integers(4)]


@pytest.mark.parametrize(
    "seeds",
    [
        *(range(n, n + 3) for n in range(0, 12, 3)),
        *(pytest.param(range(n, n + 10), marks=pytest.mark.slow) for n in range(0, 200, 10)),
    ],
    ids=lambda seeds: f"{seeds.start} to {seeds.stop - 1}",
)
@pytest.mark.filterwarnings(
    "ignore::samcontact.PlasticStrainWarning", "ignore::samcontact.GridTooSmallWarning"
)
def test_random_moving_contacts_are_solved(seeds):
    for seed in seeds:
        body, other, grid, radius, load, way = draw(seed)
        gap = sc.surfaces.paraboloid(grid, radius)
        bodies = sc.Simulation(grid, other, body, gap, on_border="warn")
        states = [bodies.step(load=load / 2), bodies.step(load=load)]
        states += [bodies.step(load=load, advance=way) for _ in range(5)]
        states.append(bodies.step(load=0.0))
        strain = [state.max_equivalent_plastic_strain(2) for state in states]
        assert 1e-4 < strain[-1] < 0.3, seed
        assert states[-2].plastic_strain_residual < 1e-6, seed
