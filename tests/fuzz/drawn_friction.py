# SPDX-License-Identifier: GPL-3.0-or-later
"""Random contacts with each friction law: drawn histories, and checks of their shear."""

import math

import numpy as np

import samcontact as sc

NAMED = (sc.ConvergenceError, ValueError)
GRID = sc.Grid(14, 12, 5e-5, 5e-5)


def law_of(draw):
    kind, mu = draw.integers(5), float(10 ** draw.uniform(-2, 0.3))
    ratio = float(10 ** draw.uniform(-1, 0))
    if kind == 0:
        return sc.Anisotropic(mu, mu * ratio, draw.uniform(-math.pi, math.pi))
    if kind == 1:
        table = mu * draw.uniform(0, 1, (3, 2)) * (draw.random((3, 2)) < 0.8)
        return sc.MappedCoulomb(
            table, x=[-2e-4, 0.0, 1e-4], y=[-1e-4, 2e-4], body=draw.integers(1, 3)
        )
    if kind == 2:
        memory = 0.0 if draw.random() < 0.5 else float(10 ** draw.uniform(-7, -4))
        return sc.FallingCoulomb(mu * ratio, mu * (1 - ratio), 10 ** draw.uniform(-4, 1), memory)
    if kind == 3:
        hardening = 0.0 if draw.random() < 0.5 else 10 ** draw.uniform(9, 14)
        return sc.ThirdBody(
            mu, 10 ** draw.uniform(6, 10), 10 ** draw.uniform(7, 11), 1e-6, hardening
        )
    return sc.MappedCoulomb(mu * draw.uniform(0.1, 1, 3), y=[-2e-4, 0.0, 1e-4])


def body_of(draw):
    return sc.Material.elastic(10 ** draw.uniform(9, 11.5), draw.uniform(0, 0.49))


def level(law, state):
    """Largest shear relative to the bound of the law in the direction of the shear."""
    shear, pressed = state.shear, state.pressure > 0
    if isinstance(law, sc.Anisotropic):
        c, s = math.cos(law.angle), math.sin(law.angle)
        first, second = c * shear[0] + s * shear[1], c * shear[1] - s * shear[0]
        shear = np.stack([first / law.mu_x, second / law.mu_y]) * max(law.mu_x, law.mu_y)
    bound = law.bound(state.pressure)
    return (np.hypot(*shear)[pressed] / np.maximum(bound[pressed], 1e-300)).max(initial=0.0)


def run(number):
    """Run a random history; return the number of states, or the error."""
    draw = np.random.default_rng(number)
    law, lower = law_of(draw), body_of(draw)
    upper = lower if draw.random() < 0.4 else body_of(draw)
    gap = sc.surfaces.paraboloid(GRID, 10 ** draw.uniform(-3, -1))
    gap = gap + 10 ** draw.uniform(-9, -6.5) * draw.standard_normal(gap.shape)
    states, work = 0, 0.0
    try:
        simulation = sc.Simulation(GRID, upper, lower, gap, law, on_border="warn")
        for _ in range(4):
            size = 10 ** draw.uniform(-9, -5)
            step = {"approach": gap.min() + 10 ** draw.uniform(-7.5, -5.5)}
            step["shift"] = tuple(size * draw.uniform(-1, 1, 2))
            if draw.random() < 0.3:
                step["twist"] = size / 5e-4
            if draw.random() < 0.3 and states:
                step["advance"] = (-GRID.dx, -GRID.dx)
            if law.needs_duration:
                step["duration"] = 10 ** draw.uniform(-8, 0)
            state = simulation.step(**step)
            states += 1
            assert np.isfinite(state.shear).all()
            assert level(law, state) <= 1 + 1e-5
            assert state.friction_work >= work * (1 - 1e-9) - 1e-15
            work = state.friction_work
    except NAMED as error:
        return error
    return states
