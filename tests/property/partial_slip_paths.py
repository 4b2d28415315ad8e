# SPDX-License-Identifier: GPL-3.0-or-later
"""Random contacts with partial slip, and random increments."""

import math

import numpy as np

import samcontact as sc


class Path:
    """A rough or smooth ball, identical or dissimilar to its flat, and its drive."""

    def __init__(self, seed):
        self.draw = np.random.default_rng(seed)
        cells = self.draw.integers(10, 25, 2)
        sides = 3.0 / cells * self.draw.uniform(0.8, 1.3, 2)
        self.grid = sc.Grid(int(cells[0]), int(cells[1]), *sides.tolist())
        different_bodies = self.draw.random() < 0.5
        nu = self.draw.uniform(0, 0.49, 2 if different_bodies else 1)
        moduli = 10 ** self.draw.uniform(-0.7, 0.7, nu.size)
        bodies = [sc.Material.elastic(E, v) for E, v in zip(moduli, nu, strict=True)]
        if different_bodies and self.draw.random() < 0.3:
            bodies[0] = sc.Material.rigid()
        self.bodies = bodies[0], bodies[-1]
        self.mu = float(self.draw.choice([0.01, 0.1, 0.3, 0.6, 1.0, math.inf]))
        if different_bodies:
            self.mu = min(self.mu, 1.0)
        self.modulus = sc.hertz.effective_modulus(*self.bodies)
        self.gap = sc.surfaces.paraboloid(self.grid, 1.0)
        rough = self.draw.choice([0.0, 0.0, 0.02, 0.1])
        self.gap = self.gap + rough * self.draw.random(self.grid.surface_shape)

    def step(self):
        """Draw an increment: a force, a motion or neither for each direction and the rotation."""
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
