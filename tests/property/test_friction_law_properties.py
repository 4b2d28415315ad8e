# SPDX-License-Identifier: GPL-3.0-or-later
"""Conditions of any friction law along random paths of random contacts."""

import numpy as np
import pytest
from partial_slip_paths import Path

import samcontact as sc
from samcontact.problem.friction import LAWS

TOL = 1e-7
pytestmark = [
    pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning"),
    pytest.mark.filterwarnings("ignore::samcontact.ElasticStrainWarning"),
    pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning"),
]
BOUNDED = [
    law
    for law in LAWS.values()
    if law.sticks and {constant.unit for constant in law.constants.values()} <= {"", "Pa"}
]
"""Laws that limit the shear by the pressure alone."""


def drawn(kind, path, pressure):
    """Draw a law whose limits both matter: a coefficient [-] and a shear stress [Pa]."""
    scales = {"": 1.0, "Pa": 0.3 * pressure.max()}
    return kind(
        *(scales[c.unit] * 10 ** path.draw.uniform(-1.5, 0.0) for c in kind.constants.values())
    )


def follow(kind, seed):
    """Follow a path; count solved and unsolved increments."""
    path, solved, failed = Path(seed), 0, 0
    rests = sc.ContactSolver(path.grid, *path.bodies, tol=TOL, on_border="warn")
    law = drawn(kind, path, rests.solve(path.gap, load=0.3 * path.modulus).pressure)
    path.mu = law.ratio(0.3 * path.modulus)
    solver = sc.ContactSolver(path.grid, *path.bodies, law, tol=TOL, on_border="warn")
    before = solver.solve(path.gap, load=0.0)
    for _ in range(5):
        step = path.step()
        try:
            now = solver.solve(path.gap, previous=before, **step)
        except sc.ConvergenceError:
            failed += 1
            continue
        except ValueError as error:
            if "friction limit" not in str(error):  # most forces are below it
                raise
            continue
        require_law(law, now, before)
        before, solved = now, solved + 1
    return solved, failed


def require_law(law, now, before):
    """Assert shear within its bound (at it, along the slip, in slip zones) and work >= 0.

    A law with a constant shear strength admits shear in cells that touch without pressure.
    """
    touching = (now.pressure == 0) & (now.gap <= TOL * abs(now.approach))
    bound = law.bound(np.where(touching, np.finfo(float).tiny, now.pressure))
    length, slip = np.hypot(*now.shear), np.hypot(*now.slip)
    maximum = bound.max()
    assert (length <= bound * (1 + 1e-9)).all()
    assert not now.slip[:, now.sticking].any()
    far = slip > 1e-3 * max(slip.max(), 1e-300)
    far &= ~touching
    assert (length[far] >= bound[far] - 1e-4 * maximum).all()
    power = (now.shear * now.slip).sum(axis=0)
    assert (power[far] >= (1 - 1e-3) * (length * slip)[far] - 1e-6 * maximum * slip.max()).all()
    done = now.friction_work - before.friction_work
    rounding = np.spacing(now.friction_work)  # of a sum, whose last term `done` recovers
    assert done == pytest.approx(now.grid.cell_area * power.sum(), rel=1e-9, abs=rounding)
    assert done >= -TOL * maximum * now.contact_area * slip.max()


@pytest.mark.parametrize("kind", BOUNDED, ids=lambda kind: kind.law)
def test_random_contacts_satisfy_the_friction_law(kind):
    solved, failed = np.sum([follow(kind, seed) for seed in range(40)], axis=0)
    assert failed == 0
    assert solved > 100
    assert solved > 0.7 * 5 * 40
