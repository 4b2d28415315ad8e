# SPDX-License-Identifier: GPL-3.0-or-later
"""What must hold along any path of bodies that stick and slip: forces, motions and turns."""

import math

import numpy as np
import pytest

import samcontact as sc

TOL = 1e-7
QUICK, ALL = range(60), range(1000)
pytestmark = [
    pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning"),
    pytest.mark.filterwarnings("ignore::samcontact.ElasticStrainWarning"),
]


class Path:
    """A rough or smooth ball, alike or unlike its flat, and where it is driven."""

    def __init__(self, seed):
        self.draw = np.random.default_rng(seed)
        cells = self.draw.integers(10, 25, 2)
        sides = 3.0 / cells * self.draw.uniform(0.8, 1.3, 2)
        self.grid = sc.Grid(int(cells[0]), int(cells[1]), *sides.tolist())
        unlike = self.draw.random() < 0.5
        nu = self.draw.uniform(0, 0.49, 2 if unlike else 1)
        moduli = 10 ** self.draw.uniform(-0.7, 0.7, nu.size)
        bodies = [sc.Material.elastic(E, v) for E, v in zip(moduli, nu, strict=True)]
        if unlike and self.draw.random() < 0.3:
            bodies[0] = sc.Material.rigid()
        self.bodies = bodies[0], bodies[-1]
        self.mu = float(self.draw.choice([0.01, 0.1, 0.3, 0.6, 1.0, math.inf]))
        if unlike:
            self.mu = min(self.mu, 1.0)
        self.modulus = sc.hertz.effective_modulus(*self.bodies)
        self.gap = sc.surfaces.paraboloid(self.grid, 1.0)
        rough = self.draw.choice([0.0, 0.0, 0.02, 0.1])
        self.gap = self.gap + rough * self.draw.random(self.grid.surface_shape)

    def step(self):
        """Arguments of an increment: of each direction and the turn a force, a motion, or none."""
        load = 4 / 3 * self.modulus * 10 ** self.draw.uniform(-2, -0.3)
        most = 0.7 * min(self.mu, 1.0) * load  # along one, with the other within the bound
        shift, force = [None, None], [None, None]
        for k in range(2):
            kind = self.draw.integers(3)
            if kind == 0:
                shift[k] = float(self.draw.normal() * 0.1 * min(self.mu, 1.0))
            elif kind == 1:
                force[k] = float(self.draw.uniform(-1, 1) * 0.9 * most)
        step = {"load": float(load), "shift": shift, "tangential_load": force}
        turn = self.draw.integers(4)
        if turn == 0:
            step["twist"] = float(self.draw.normal() * 0.1 * min(self.mu, 1.0))
        elif turn == 1 and force == [None, None]:
            step["torque"] = float(self.draw.uniform(-1, 1) * 0.1 * most * (load / self.modulus))
        return step


def follow(seed):
    """Walks a path; how many increments were solved, and how many ended in a ConvergenceError."""
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
            if "friction holds" not in str(error):
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
def test_paths_keep_to_the_law():
    walk(QUICK)


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
def test_a_thousand_paths_keep_to_the_law():
    walk(ALL)
