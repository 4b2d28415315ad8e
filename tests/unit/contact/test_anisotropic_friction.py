# SPDX-License-Identifier: GPL-3.0-or-later
"""Friction within an ellipse: Coulomb's law for a circle, the flow rule, forces, rolling."""

import math

import numpy as np
import pytest

import samcontact as sc

STEEL = sc.Material.elastic(210e9, 0.3)
BRASS = sc.Material.elastic(100e9, 0.2)
YIELDS = sc.Material.linear_hardening(210e9, 0.3, 1.2e9, 10e9)
GRID = sc.Grid(28, 28, 36e-6, 36e-6, dz=36e-6)
GAP = sc.surfaces.paraboloid(GRID, 7.5e-3)
LOAD = 300.0
LAW = sc.Anisotropic(0.4, 0.15, 0.6)
PATH = [
    {"load": 0.5 * LOAD},
    {"load": LOAD, "shift": (1e-6, 1e-6)},
    {"load": LOAD, "tangential_load": (-20.0, None), "twist": 1e-3},
]
FIELDS = ("pressure", "shear", "slip", "sticking")
dissimilar = pytest.mark.parametrize("body1", [STEEL, BRASS], ids=["identical", "dissimilar"])


def axes_of(law):
    """Matrix M with the half-axes of the ellipse per unit pressure."""
    turn = np.array(
        [[math.cos(law.angle), -math.sin(law.angle)], [math.sin(law.angle), math.cos(law.angle)]]
    )
    return turn @ np.diag([law.mu_x, law.mu_y]) @ turn.T


def require_flow_rule(found, law, slip, tol=1e-5):
    """|M^-1 s| <= p; no slip below the bound; at it, slip along the normal of the ellipse."""
    inverse = np.linalg.inv(axes_of(law))
    pressed = found.pressure > 0
    shear, moved = found.shear[:, pressed], slip[:, pressed]
    level = np.hypot(*(inverse @ shear)) / found.pressure[pressed]
    normal = inverse @ inverse @ shear
    scale = np.hypot(*moved).max()
    assert level.max() <= 1 + 1e-9
    sticks = found.sticking[pressed]
    np.testing.assert_allclose(level[~sticks], 1.0, rtol=1e-6)
    assert np.hypot(*moved[:, sticks]).max(initial=0.0) < tol * scale
    across = normal[0] * moved[1] - normal[1] * moved[0]
    assert np.abs(across / np.hypot(*normal))[~sticks].max() < tol * scale
    assert (
        (normal * moved).sum(axis=0)[~sticks] >= -tol * scale * np.hypot(*normal)[~sticks]
    ).all()


def walk(law, body1):
    solver, found = sc.ContactSolver(GRID, body1, STEEL, law), []
    for step in PATH:
        found.append(solver.solve(GAP, previous=found[-1] if found else None, **step))
    return found


@dissimilar
@pytest.mark.parametrize("angle", [0.0, 0.7])
def test_equal_coefficients_are_coulomb_friction(body1, angle):
    for one, other in zip(
        walk(sc.Coulomb(0.3), body1), walk(sc.Anisotropic(0.3, 0.3, angle), body1), strict=True
    ):
        assert all(np.array_equal(getattr(one, name), getattr(other, name)) for name in FIELDS)


@dissimilar
@pytest.mark.parametrize("law", [LAW, sc.Anisotropic(0.05, 0.6, -1.1)], ids=repr)
def test_cells_slip_along_the_normal_of_the_ellipse(body1, law):
    solver = sc.ContactSolver(GRID, body1, STEEL, law, tol=1e-10)
    shift = np.array([1.2e-6, 0.9e-6])
    found = solver.solve(GAP, load=LOAD, shift=shift)
    lower, upper = (solver.displacement(found.pressure, found.shear, body) for body in (2, 1))
    slip = shift[:, None, None] - (lower - upper)[:2]
    require_flow_rule(found, law, slip)
    assert 0.05 < found.sticking.sum() / np.count_nonzero(found.pressure) < 0.9
    assert found.friction_work > 0
    assert 0 <= found.energy_gap < 1e-6 * found.friction_work


def test_full_slip_has_the_largest_power_that_the_ellipse_permits():
    axes = axes_of(LAW)
    direction = np.array([0.6, 0.8])
    solver = sc.ContactSolver(GRID, STEEL, STEEL, LAW)
    found = solver.solve(GAP, load=LOAD, shift=1e-3 * direction)
    force = axes @ axes @ direction / math.hypot(*(axes @ direction)) * LOAD
    np.testing.assert_allclose(found.tangential_load, force, rtol=1e-3)
    assert not found.sticking.any()


def test_forces_up_to_the_ellipse_are_held():
    solver = sc.ContactSolver(GRID, STEEL, STEEL, LAW, tol=1e-10)
    largest = axes_of(LAW) @ np.array([0.8, -0.6]) * LOAD  # on the ellipse
    found = solver.solve(GAP, load=LOAD, tangential_load=0.9 * largest)
    np.testing.assert_allclose(found.tangential_load, 0.9 * largest, rtol=1e-8)
    limit = math.hypot(*largest)
    with pytest.raises(ValueError, match=f"tangential_load must be less than {limit:.4g}"):
        solver.solve(GAP, load=LOAD, tangential_load=1.01 * largest)
    # the force along y follows from the motion along y
    alone = math.hypot(*axes_of(LAW)[0]) * LOAD
    assert solver.solve(GAP, load=LOAD, tangential_load=(0.95 * alone, None)).converged
    with pytest.raises(ValueError, match=f"tangential_load must be less than {alone:.4g}"):
        solver.solve(GAP, load=LOAD, tangential_load=(1.01 * alone, None))
    with pytest.raises(ValueError, match="torque must be less in magnitude than"):
        solver.solve(GAP, load=LOAD, torque=0.4 * LOAD * 0.5e-3)


def test_turning_the_problem_turns_the_solution():
    def solve(law, shift):
        return sc.ContactSolver(GRID, STEEL, STEEL, law, tol=1e-11).solve(
            GAP, load=LOAD, shift=shift
        )

    one = solve(sc.Anisotropic(0.4, 0.15), (1e-6, 0.4e-6))
    other = solve(sc.Anisotropic(0.4, 0.15, math.pi / 2), (-0.4e-6, 1e-6))
    turned = np.stack([-np.rot90(one.shear[1]), np.rot90(one.shear[0])])
    np.testing.assert_allclose(other.shear, turned, atol=1e-6 * np.abs(one.shear).max())


@dissimilar
def test_rolling_obeys_the_flow_rule(body1):
    drive = {"creepage": (1e-3, 0.6e-3), "spin": 0.5}
    found = sc.rolling.steady(GRID, body1, STEEL, GAP, load=LOAD, friction=LAW, tol=1e-9, **drive)
    require_flow_rule(found, LAW, found.slip)
    one, other = (
        sc.rolling.steady(GRID, body1, STEEL, GAP, load=LOAD, friction=law, **drive)
        for law in (sc.Coulomb(0.3), sc.Anisotropic(0.3, 0.3, 1.0))
    )
    assert all(np.array_equal(getattr(one, name), getattr(other, name)) for name in FIELDS)


def test_a_simulation_of_elastic_bodies_is_the_elastic_solution():
    run, last = sc.Simulation(GRID, STEEL, STEEL, GAP, LAW, tol=1e-9), None
    solver = sc.ContactSolver(GRID, STEEL, STEEL, LAW, tol=1e-9)
    for step in PATH:
        state, last = run.step(**step), solver.solve(GAP, previous=last, **step)
    np.testing.assert_allclose(state.shear, last.shear, atol=1e-6 * np.abs(last.shear).max())


def test_friction_work_of_a_plastic_contact_increases():
    run = sc.Simulation(GRID, STEEL, YIELDS, GAP, LAW)
    work = [
        run.step(**step).friction_work for step in [*PATH, {"load": LOAD, "shift": (0.0, -2e-6)}]
    ]
    assert (np.diff([0.0, *work]) >= 0).all()
    assert work[-1] > 0


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((0.0, 0.3), "mu_x must be a finite number > 0, got 0"),
        ((0.3, math.inf), "mu_y must be a finite number > 0, got inf"),
        ((0.3, 0.2, 30.0), r"angle must be in \[-3.14"),
    ],
)
def test_refused_parameters(arguments, message):
    with pytest.raises(ValueError, match=f"^{message}"):
        sc.Anisotropic(*arguments)
