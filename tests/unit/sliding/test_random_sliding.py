# SPDX-License-Identifier: GPL-3.0-or-later
"""Random viscoelastic contacts in steady sliding: all are solved, and none gains energy."""

import numpy as np
import pytest

import samcontact as sc

pytestmark = [
    pytest.mark.filterwarnings(f"ignore::samcontact.{name}Warning")
    for name in ("ElasticStrain", "GridTooSmall", "Resolution", "SingularPressure", "Unit")
]

AT_REST = pytest.mark.filterwarnings("ignore:body 1 is viscoelastic and rests:UserWarning")


def drawn(seed):
    """Return the arguments of a contact with noise in each cell and up to five times."""
    rng = np.random.default_rng(seed)
    periodic = str(rng.choice(["", "x", "y", "xy"]))
    nx, ny = (int(rng.choice(n)) for n in ([8, 16, 24, 32], [8, 16, 24]))
    d = 10 ** rng.uniform(-7, -3)
    grid = sc.Grid(nx, ny, d, d * 10 ** rng.uniform(-0.5, 0.5), periodic=periodic)
    count = int(rng.integers(1, 6))
    times = 10 ** rng.uniform(-6, 3, count)
    shares = rng.dirichlet(np.ones(count)) * (1 - 10 ** rng.uniform(-2, -0.1))
    E = 10 ** rng.uniform(5, 10)
    body = sc.Material.elastic(E, rng.uniform(0, 0.49)).with_relaxation(times, shares)
    slider = [sc.Material.rigid(), sc.Material.elastic(10 * E, 0.3), body][rng.integers(3)]
    side = nx * d
    shape = (grid.x[:, None] ** 2 + grid.y**2) / side * 10 ** rng.uniform(-3, -1)
    noise = rng.uniform(0, 1e-3) * side * rng.normal(size=(nx, ny))
    return {
        "grid": grid, "body1": slider, "body2": body,
        "gap": noise if periodic == "xy" else shape + noise,
        "load": E * 10 ** rng.uniform(-5, -2) * nx * ny * grid.cell_area,
        "velocity": 10 ** rng.uniform(-4, 4) * side / np.sqrt(times.min() * times.max()),
    }  # fmt: skip


def solve(seed):
    given = drawn(seed)
    found = sc.sliding.steady(**given, on_border="warn")
    assert found.error <= 1e-8
    assert found.pressure.min() >= 0
    assert found.pressure.sum() * found.grid.cell_area == pytest.approx(given["load"])
    assert found.friction >= -1e-9


@AT_REST
@pytest.mark.parametrize("seed", range(12))
def test_random_contacts(seed):
    solve(seed)


@AT_REST
@pytest.mark.slow
@pytest.mark.parametrize("seed", range(100, 400))
def test_many_random_contacts(seed):
    solve(seed)
