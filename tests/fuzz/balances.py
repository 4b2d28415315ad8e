# SPDX-License-Identifier: GPL-3.0-or-later
"""Conditions on any increment: finite fields, force and energy balance, contact and flow laws."""

import math

import numpy as np

import samcontact as sc


def assert_finite(**fields):
    for name, field in fields.items():
        assert np.isfinite(field).all(), name


def assert_increment(simulation, before, state, step):
    """Check one increment against the laws of contact and friction, from its public fields."""
    tol = simulation.tol
    assert state.converged
    assert state.substeps >= 1
    p, gap, area = state.pressure, state.gap, simulation.grid.cell_area
    area = state.grid.cell_area
    assert_finite(pressure=p, gap=gap, shear=state.shear, load=state.load)
    assert p.min() >= 0
    total = p.sum() * area
    assert abs(total - state.load) <= 1e-9 * state.load
    if "load" in step:
        assert abs(state.load - step["load"]) <= 1e-9 * step["load"]
    force = state.shear.sum(axis=(1, 2)) * area
    assert np.abs(force - state.tangential_load).max() <= 1e-9 * abs(state.shear).sum() * area
    assert_contact(state, tol)
    assert_friction(simulation, before, state, step)
    for body, material in ((1, simulation.body1), (2, simulation.body2)):
        if state.grid.has_volume and not material.is_rigid:
            assert_body(simulation, before, state, body, material)


def assert_contact(state, tol):
    """Assert that there is no overlap, and no gap under pressure."""
    p, gap = state.pressure, state.gap
    if p.max() == 0:
        assert gap.min() >= -1e-9 * np.abs(gap).max()
        return
    scale = max(np.abs(gap).max(), abs(state.approach))
    if math.isfinite(scale):
        assert gap.min() >= -30 * tol * scale - 1e-12 * scale
        assert (np.abs(gap[p > 0.01 * p.max()]) <= 30 * tol * scale + 1e-12 * scale).all()


def assert_friction(simulation, before, state, step):
    law, p = simulation.friction, state.pressure
    length = np.hypot(*state.shear)
    if not isinstance(law, sc.Coulomb):
        np.testing.assert_allclose(length, law * p, rtol=1e-12)
        return
    mu = law.coefficient
    assert_finite(slip=state.slip, shift=state.shift, twist=state.twist, torque=state.torque)
    slipped = np.hypot(*state.slip)
    if math.isinf(mu):
        # no slip, except for the tolerance
        assert (slipped[state.sticking] == 0).all()
    else:
        most = mu * p.max() + 1e-300
        assert (length <= mu * p + 1e-6 * most).all()
        slides = (p > 0) & ~state.sticking
        one = state.substeps == 1 and simulation.increment_tol is None  # of which slip is
        if one and slides.any() and slipped.max() > 0:
            far = slides & (slipped > 1e-3 * slipped.max())
            assert (length[far] >= mu * p[far] - 1e-4 * most).all()
            along = np.einsum("kxy,kxy->xy", state.shear, state.slip)
            assert (along[far] >= (1 - 1e-3) * (length * slipped)[far] - 1e-6 * most).all()
    lost = 1e-9 * state.load * (abs(state.shift).max() + slipped.max())
    assert state.friction_work >= before.friction_work - lost
    if "tangential_load" in step and state.load > 0:
        for wanted, found in zip(step["tangential_load"], state.tangential_load, strict=True):
            assert wanted is None or abs(wanted - found) <= 1e-4 * state.load


def assert_body(simulation, before, state, body, material):
    stress = state.stress(body)
    assert_finite(stress=stress)
    if simulation.grid.periodic == "xy" and simulation.heat.factor == (0.0, 0.0):
        assert_planes_in_balance(state, body, stress)
    hot = state.heat_factor[body - 1]
    if hot > 0:
        warm = state.temperature(body)
        surface = state.surface_temperature(body)
        assert_finite(temperature=warm, surface=surface)
        if simulation.heat.time is None and state.pressure.max() > 0:
            assert min(warm.min(), surface.min()) >= -1e-6 * max(surface.max(), warm.max())
    if not material.is_plastic:
        return
    strain, amount = state.plastic_strain(body), state.equivalent_plastic_strain(body)
    assert_finite(strain=strain, amount=amount)
    assert amount.min() >= 0
    largest = state.max_equivalent_plastic_strain(body)
    assert largest >= before.max_equivalent_plastic_strain(body) * (1 - 1e-12)
    assert np.abs(strain[:3].sum(axis=0)).max(initial=0) <= 1e-12 * np.abs(strain).max(initial=0)
    assert state.yield_violation <= 1e-3
    assert_finite(print=state.residual_displacement(body), residual=state.residual_stress(body))


def assert_planes_in_balance(state, body, stress):
    """Assert that each horizontal plane of a period carries the surface tractions."""
    p = state.pressure
    mean, scale = stress.mean(axis=(1, 2)), p.mean() + np.abs(stress).max()
    pull = (-1 if body == 1 else 1) * state.shear.mean(axis=(1, 2))
    expected = np.array([-p.mean(), -pull[1], -pull[0]])
    initial = state.initial_stress(body).mean(axis=(1, 2))
    found = (mean - initial)[2:5]
    assert np.abs(found - expected[:, None]).max() <= 2e-2 * scale


def assert_energy(simulation, states):
    """Assert that no part of the energy balance is negative; return the imbalance, which
    decreases with the increments, or None without a balance."""
    bodies = simulation.body1, simulation.body2
    moved = any(any(state.travel) for state in states)
    if not isinstance(simulation.friction, sc.Coulomb) or moved or simulation.heat.partition:
        return None
    if any(getattr(body, "softening", None) is not None for body in bodies):
        return None
    energy = sc.energy.balance(simulation, states[1:])  # the bodies need not touch at the start
    scale = max(energy.work_input, abs(energy.net_external_work))
    assert_finite(
        **{name: getattr(energy, name) for name in ("work_input", "net_external_work", "imbalance")}
    )
    for name in ("elastic_energy", "friction_work"):
        assert getattr(energy, name) >= -1e-6 * scale, name
    # infinite friction: opening edges release energy; periodic surfaces may be in full contact
    if math.isfinite(simulation.friction.coefficient) and not simulation.grid.periodic:
        return abs(energy.imbalance)
    return None
