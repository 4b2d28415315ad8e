# SPDX-License-Identifier: GPL-3.0-or-later
"""Random rough surfaces that adhere: drawn setups, their paths, and the conditions of contact."""

import numpy as np

import samcontact as sc

NAMED = (sc.ConvergenceError, sc.GridTooSmallError)
"""Errors that a path may end in. A PullOffError is a ConvergenceError."""


def law_of(rng, kappa, influence):
    """Return a random law with a resolution number; influence: K0 [m/Pa]."""
    w = 10 ** rng.uniform(-3, 0)
    z = float(np.sqrt(w * influence / kappa))
    kind = rng.integers(4)
    if kind == 0:
        return sc.Adhesion.exponential(w, z)
    if kind == 1:
        return sc.Adhesion.lennard_jones(w, 1.12 * z)
    if kind == 2:
        return sc.Adhesion.dugdale(w, w / z)
    gaps = z * np.array([0.0, 0.5, 1.5, 3.0])
    return sc.Adhesion.tabulated(gaps, w / z * np.array([0.8, 0.7, 0.2, 0.0]))


def setup(seed):
    """Return a solver, a gap and the length of the attraction."""
    rng = np.random.default_rng(seed)
    n = 2 * int(rng.integers(6, 13))
    periodic = str(rng.choice(["", "xy"]))
    grid = sc.Grid(n, n, 1e-8, 1e-8, periodic=periodic)
    body = sc.Material.elastic(10 ** rng.uniform(7, 10), 0.3)
    if rng.random() < 0.3:
        coat = sc.Material.elastic(body.E * 10 ** rng.uniform(-0.7, 0.7), 0.3)
        body = sc.Layered([(coat, 2e-8)], body)
    modulus = (body.layers[0][0] if isinstance(body, sc.Layered) else body).E / 0.91
    law = law_of(rng, rng.uniform(0.05, 0.5), 1.12e-8 / modulus)
    z = sc.Adhesion.on(law, grid, sc.Material.rigid(), body).range
    rms = z * 10 ** rng.uniform(-0.7, 0.7)
    gap = (
        rms * rng.standard_normal((n, n))
        if rng.random() < 0.3
        else (sc.surfaces.rough_self_affine(grid, rms, 0.8, wavelength_min=4e-8, seed=seed))
    )
    if not periodic:
        gap = gap + sc.surfaces.paraboloid(grid, 10 ** rng.uniform(-7, -6))
    solver = sc.ContactSolver(grid, sc.Material.rigid(), body, adhesion=law, on_border="warn")
    return solver, gap - gap.min(), z, rng


def follow(seed):
    """Touch, press and pull off; check all states. Return the number of states, or an error."""
    solver, gap, z, rng = setup(seed)
    rms = float(np.std(gap))
    most = 0.7 * gap.mean() if solver.grid.periodic else 0.5 * min(rms, 10 * z)
    there = np.linspace(-6 * z, most, int(rng.integers(4, 9)))
    # Soft bodies may still adhere where the path begins: separate them, and come back.
    path = [*there, *there[::-1], 16 * there[0], there[0]]
    solution, found = None, []
    for approach in path:
        start = None if solution is None else solution.pressure
        try:
            solution = solver.solve(gap, approach=approach, initial_pressure=start)
        except NAMED as error:
            return error
        found.append(solution)
        check(solution)
    loads = np.array([s.load for s in found])
    steps, jumps = np.diff(path), np.abs(np.diff(loads))
    work = np.sum(0.5 * (loads[1:] + loads[:-1]) * steps)
    # A cycle gains no energy. Jumps lie anywhere within a step.
    assert work > -np.sum(0.5 * jumps * np.abs(steps))
    close = 1e-6 * float(np.abs(loads).max())
    np.testing.assert_allclose(loads[0], loads[-1], rtol=1e-3, atol=close)
    return len(found)


def check(solution, rounding=0.0):
    """Assert that repulsion and gap are not negative, and that one of them is zero.

    rounding: error of the gap [m]; 0 where the gap is the unknown.
    """
    repulsion, open_gap = solution.repulsion, solution.gap
    largest = max(float(np.abs(solution.pressure).max()), float(solution.adhesion_stress.max()))
    assert np.isfinite(solution.load)
    assert repulsion.min() >= -1e-6 * largest
    assert open_gap.min() >= -rounding
    assert np.all(open_gap[repulsion > 1e-5 * largest] <= rounding)


def simulated(seed):
    """Return a simulation with partial slip, creep or a machine, and the steps of its path."""
    rng = np.random.default_rng(seed)
    grid = sc.Grid(16, 16, 1e-8, 1e-8)
    body = sc.Material.elastic(10 ** rng.uniform(8, 10), 0.3)
    law = law_of(rng, rng.uniform(0.05, 0.3), 1.12e-8 / (body.E / 0.91))
    z = law.on(grid, sc.Material.rigid(), body).range
    gap = sc.surfaces.rough_self_affine(grid, 0.3 * z, 0.8, wavelength_min=4e-8, seed=seed)
    gap = gap + sc.surfaces.paraboloid(grid, 10 ** rng.uniform(-7, -6))
    more = {"friction": sc.Coulomb(rng.choice([0.3, np.inf]))} if rng.random() < 0.7 else {}
    creeps = rng.random() < 0.5
    if creeps:
        body = body.with_relaxation([1.0], [0.4])
    if rng.random() < 0.5:
        more["stiffness"] = body.E * 1e-8 * 10 ** rng.uniform(0, 2)
    simulation = sc.Simulation(
        grid, sc.Material.rigid(), body, gap - gap.min(), adhesion=law, on_border="warn", **more
    )
    there = np.linspace(-2 * z, 2 * z, 4)
    steps = [{"approach": approach} for approach in [*there, *there[::-1]]]
    for step in steps:
        if creeps:
            step["duration"] = 10 ** rng.uniform(-1, 1)
        if "friction" in more:
            step["shift"] = tuple(0.1 * z * rng.uniform(-1, 1, 2))
    return simulation, steps


def follow_simulated(seed):
    """Follow a path with slip, creep or a machine; return its last state, or an error."""
    simulation, steps = simulated(seed)
    try:
        for step in steps:
            state = simulation.step(**step)
            rounding = 1e-6 * steps[3]["approach"]
            check(state, rounding)
            if state.shear.any():
                # Without a limit of friction, cells in contact at zero pressure may transmit shear.
                unlimited = state.setup.friction.prevents_slip
                free = state.gap > rounding if unlimited else state.repulsion == 0
                assert not np.hypot(*state.shear)[free].any()
    except NAMED as error:
        return error
    return state
