# SPDX-License-Identifier: GPL-3.0-or-later
"""Pressure on which friction between adhering bodies depends: repulsion or compression."""

import numpy as np
import pytest
from scipy.optimize import brentq

import samcontact as sc
from case_texts import BODIES, GRID
from samcontact.cases import CaseError, parse_case

pytestmark = pytest.mark.filterwarnings("ignore:the attraction at the edge")
W, MU, R, E = 0.05, 0.3, 1e-6, 1e9
SOFT = sc.Material.elastic(2 * E, 0.3)  # equal bodies: shear causes no normal displacement
E_STAR = E / (1 - 0.3**2)
FORCE = np.pi * W * R
JKR = sc.adhesion.jkr(R, W, E_STAR)


def tip(law, cells, width, friction, **more):
    grid = sc.Grid(cells, cells, width / cells, width / cells)
    gap = sc.surfaces.paraboloid(grid, R)
    return sc.Simulation(grid, SOFT, SOFT, gap, friction=friction, adhesion=law, **more)


def sliding(simulation, **given):
    """Return the state and the force of a contact that slides fully."""
    state = simulation.step(**given)
    if simulation.friction != MU:
        state = simulation.step(**given, shift=(1e-7, 0.0))
    return state, total(np.hypot(*state.shear), state)


def total(field, state):
    return float(field.sum() * state.grid.cell_area)


@pytest.mark.parametrize("friction", [MU, sc.Coulomb(MU)])
@pytest.mark.parametrize("transition", [0.3, 1.0])
def test_the_attraction_adds_to_the_load(transition, friction):
    """Maugis: full sliding with the force mu (W + stress pi c^2), also without load."""
    stress = 0.5 * transition * np.cbrt(np.pi * W * (4 * E_STAR / 3) ** 2 / R)
    theory = sc.adhesion.maugis(R, W, E_STAR, stress)
    free = brentq(theory.load, 0.5 * JKR.radius_at_pull_off, JKR.radius(0.0))
    for radius in (free, 1.5 * free):
        c = float(theory.outer_radius(radius))
        simulation = tip(sc.Adhesion.dugdale(W, stress), 64, 2.6 * c, friction)
        state, found = sliding(simulation, approach=float(theory.approach(radius)))
        expected = float(theory.load(radius)) + stress * np.pi * c**2
        assert found == pytest.approx(MU * expected, rel=2e-3)
        assert found == pytest.approx(MU * (state.load + total(state.adhesion_stress, state)))


def test_compression_is_that_of_jkr_without_load():
    """JKR without load: the positive part of the pressure is 4/3^(1/2) pi w R."""
    found = []
    for cells in (32, 64):
        law = sc.Adhesion.jkr(W, friction_on="compression")
        simulation = tip(law, cells, 4.6 * JKR.radius_at_pull_off, sc.Coulomb(MU))
        simulation.step(approach=1e-10)
        state, force = sliding(simulation, load=0.0)
        pressed = np.where(state.in_contact, np.maximum(state.pressure, 0.0), 0.0)
        np.testing.assert_allclose(
            np.hypot(*state.shear), MU * pressed, atol=1e-8 * MU * pressed.max()
        )
        found.append(force / (MU * FORCE))
    assert 2 * found[1] - found[0] == pytest.approx(4 / np.sqrt(3), rel=0.01)


def test_a_stiff_tip_without_load_slides_with_twice_pi_w_r():
    """Long-range attraction across the gap of Hertz: the adhesive load tends to 2 pi w R."""
    span = (R * W**2 / (E_STAR**2 * 0.03**3)) ** (1 / 3)  # Tabor number 0.03
    peak = W / span

    def attraction(load):
        a = np.cbrt(0.75 * load * R / E_STAR)
        r = np.linspace(a, a + 12 * np.sqrt(2 * R * span), 4000)
        m = r / a
        gap = a**2 / (np.pi * R) * (np.sqrt(m**2 - 1) - (2 - m**2) * np.arccos(1 / m))
        return peak * (np.pi * a**2 + np.trapezoid(2 * np.pi * r * np.exp(-gap / span), r))

    expected = brentq(lambda load: attraction(load) - load, FORCE, 4 * FORCE)
    simulation = tip(sc.Adhesion.exponential(W, span), 96, 12 * np.sqrt(2 * R * span), MU)
    simulation.step(approach=0.0)
    _, force = sliding(simulation, load=0.0)
    assert force == pytest.approx(MU * expected, rel=0.01)
    assert expected == pytest.approx(2 * FORCE, rel=0.08)


RIGID, MAP = sc.Material.rigid(), sc.MappedCoulomb([0.1, 0.5], x=[-3e-8, 3e-8])
PRESSED = sc.Adhesion.exponential(W, 4e-9, friction_on="compression")
CELLS = sc.Grid(40, 40, 4e-9, 4e-9)


@pytest.mark.filterwarnings("ignore:under-resolved contact")
@pytest.mark.parametrize(
    ("friction", "bound"),
    [
        (0.4, lambda p: 0.4 * p),
        (sc.Coulomb(0.4), lambda p: 0.4 * p),
        (sc.CappedCoulomb(0.4, 2e7), lambda p: np.minimum(0.4 * p, 2e7)),
        (sc.Tresca(3e7), lambda p: np.where(p > 0, 3e7, 0.0)),
        (MAP, lambda p: np.interp(CELLS.x, [-3e-8, 3e-8], [0.1, 0.5])[:, None] * p),
    ],
)
def test_dissimilar_bodies_slide_with_the_bound_of_their_compression(friction, bound):
    gap = sc.surfaces.paraboloid(CELLS, 2e-7)
    soft = sc.Material.elastic(2e9, 0.2)
    simulation = sc.Simulation(CELLS, RIGID, soft, gap, friction=friction, adhesion=PRESSED)
    state = simulation.step(load=1e-8)
    if friction != 0.4:
        state = simulation.step(load=1e-8, shift=(6e-9, 0.0))
        assert not state.sticking.any()
    pressure = np.where(state.in_contact, np.maximum(state.pressure, 0.0), 0.0)
    assert 0 < np.sum(pressure > 0) < np.sum(state.in_contact)
    expected = bound(pressure)
    np.testing.assert_allclose(np.hypot(*state.shear), expected, atol=1e-6 * expected.max())


def test_dissimilar_bodies_slide_fully_without_load():
    """The load is zero, but the bodies touch: their repulsion balances the attraction."""
    gap = sc.surfaces.paraboloid(CELLS, 2e-7)
    law = sc.Adhesion.exponential(W, 4e-9)
    simulation = sc.Simulation(CELLS, RIGID, SOFT, gap, friction=MU, adhesion=law)
    simulation.step(load=1e-8)
    state = simulation.step(load=0.0)
    np.testing.assert_allclose(state.shear[0], MU * state.repulsion, rtol=1e-12)
    assert total(state.repulsion, state) == pytest.approx(total(state.adhesion_stress, state))


def test_gross_sliding_is_that_of_a_solver_with_its_stress():
    gap = sc.surfaces.paraboloid(CELLS, 2e-7)
    soft = sc.Material.elastic(2e9, 0.2)
    solver = sc.ContactSolver(CELLS, soft, soft, friction=0.4, adhesion=PRESSED, on_border="warn")
    solution = solver.solve(gap, load=1e-8)
    shear = 0.4 * np.where(solution.in_contact, np.maximum(solution.pressure, 0.0), 0.0)
    expected = solver.stress(solution.pressure, [8e-9], shear=(shear, 0.0 * shear))[:, 20, 20, 0]
    found = solver.stress_at(solution, CELLS.x[20], CELLS.y[20], 8e-9)
    np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-9 * np.abs(expected).max())


def test_a_contact_under_tension_only_has_no_friction():
    """Close to pull-off, no cell in contact carries a compressive pressure."""
    stress, radius = 3e7, 2e-8
    law = sc.Adhesion.dugdale(W, stress, friction_on="compression")
    theory = sc.adhesion.maugis(R, W, E_STAR, stress)
    simulation = tip(law, 64, 2.6 * float(theory.outer_radius(radius)), sc.Coulomb(MU))
    simulation.step(approach=float(theory.approach(3e-8)))
    state, force = sliding(simulation, approach=float(theory.approach(radius)))
    assert np.sum(state.in_contact) > 200
    assert state.load < -FORCE
    assert force < 1e-8 * MU * FORCE


def test_friction_that_depends_on_the_cells_is_announced():
    law = sc.Adhesion.jkr(W)
    simulation = tip(law, 32, 4.6 * JKR.radius_at_pull_off, sc.Coulomb(MU))
    with pytest.warns(sc.ResolutionWarning, match="the friction depends on the cell size"):
        simulation.step(approach=0.0)
    tip(law, 32, 4.6 * JKR.radius_at_pull_off, sc.Tresca(1e7)).step(approach=0.0)


@pytest.mark.parametrize("friction", [sc.Coulomb(np.inf), sc.ThirdBody(0.3, 1e8, 1e9, 1e-9, 1e12)])
def test_friction_without_a_bound_by_pressure_is_refused(friction):
    with pytest.raises(ValueError, match=r'friction_on must be "repulsion" with friction'):
        sc.ContactSolver(CELLS, RIGID, SOFT, friction=friction, adhesion=PRESSED)


def test_the_choice_reaches_case_files_results_and_checkpoints(tmp_path):
    setting = 'adhesion = {kind = "exponential", work = 20, range = "1 um", friction_on = "%s"}'
    text = f'title = "t"\n{GRID}\n{BODIES}\n[contact]\nfriction = 0.2\n{setting}\n'
    case = parse_case(text % "compression" + '[[path]]\napproach = "1 um"\nincrements = 1')
    simulation, _ = case.build()
    assert simulation.adhesion == sc.Adhesion.exponential(20, 1e-6, friction_on="compression")
    with pytest.raises(CaseError, match=r"friction_on: must be .*repulsion"):
        parse_case(text % "pressure" + '[[path]]\napproach = "1 um"')
    with pytest.raises(ValueError, match="friction_on must be one of 'repulsion', 'compression'"):
        sc.Adhesion.jkr(W, friction_on="pressure")
    assert "friction_on" not in sc.Adhesion.jkr(W).to_tree()
    simulation = tip(PRESSED, 16, 1.6e-7, sc.Coulomb(MU))
    state = simulation.step(approach=0.0)
    simulation.save(tmp_path / "tip.npz")
    assert sc.Simulation.load(tmp_path / "tip.npz").adhesion == PRESSED
    found = sc.results.to_dataset(simulation, [state])
    assert found.attrs["adhesion_friction_on"] == "compression"
