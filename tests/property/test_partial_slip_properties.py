# SPDX-License-Identifier: GPL-3.0-or-later
"""Properties along any path with partial slip: forces, motions and rotations."""

import math

import numpy as np
import pytest
from partial_slip_paths import Path

import samcontact as sc

TOL = 1e-7
QUICK_SEEDS, ALL = range(60), range(1000)
pytestmark = [
    pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning"),
    pytest.mark.filterwarnings("ignore::samcontact.ElasticStrainWarning"),
]


def follow(seed):
    """Follow a path; count solved increments and increments with a ConvergenceError."""
    path, solved, failed = Path(seed), 0, 0
    solver = sc.ContactSolver(
        path.grid, *path.bodies, sc.Coulomb(path.mu), tol=TOL, on_border="warn"
    )
    before = solver.solve(path.gap, load=0.0)
    for _ in range(5):
        step = path.step()
        try:
            now = solver.solve(path.gap, previous=before, **step)
        except sc.ConvergenceError:
            failed += 1
            continue
        except ValueError as error:
            if "friction limit" not in str(error):
                raise
            continue
        length = np.hypot(*now.shear)
        assert now.converged
        assert now.tangential_error <= TOL
        assert np.isfinite(now.shear).all()
        assert np.isfinite(now.slip).all()
        if math.isfinite(path.mu):
            assert (length <= path.mu * now.pressure * (1 + 1e-9)).all()
            done = now.friction_work - before.friction_work
            scale = path.mu * step["load"] * (abs(now.slip).max() + 1e-6)
            assert done >= -TOL * scale
        for k, wanted in enumerate(step["tangential_load"]):
            if wanted is not None:
                assert now.tangential_load[k] == pytest.approx(wanted, abs=1e-5 * step["load"])
        before, solved = now, solved + 1
    return solved, failed


def walk(seeds):
    solved, failed = np.sum([follow(seed) for seed in seeds], axis=0)
    assert failed == 0
    assert solved > 0.9 * 5 * len(seeds)


@pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
def test_paths_satisfy_coulombs_law():
    walk(QUICK_SEEDS)


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
def test_a_thousand_paths_satisfy_coulombs_law():
    walk(ALL)
