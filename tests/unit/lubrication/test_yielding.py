# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic-plastic bodies under a film: elastic limit, dry limit, and the imprint that remains."""

import numpy as np
import pytest

import samcontact as sc

R, LOAD = 0.01, 800.0
BALL = sc.Material.elastic(210e9, 0.3)
RACE = sc.Material.linear_hardening(210e9, 0.3, 1e9, 5e9)
OIL = sc.Lubricant.roelands(viscosity=0.04, pressure_viscosity=22e-9)
DX = 4.8 * sc.hertz.point(R, 115.4e9, load=LOAD).a / 48
GRID = sc.Grid(48, 48, DX, DX, dz=DX)
GAP = sc.surfaces.paraboloid(GRID, R)

pytestmark = [
    pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning"),
    pytest.mark.filterwarnings("ignore::samcontact.IncrementWarning"),
]


def press(race, speed, **more):
    simulation = sc.Simulation(GRID, BALL, race, GAP, on_border="warn")
    found = sc.lubrication.press(simulation, load=LOAD, speed=(speed, speed), lubricant=OIL, **more)
    return simulation, found


def test_a_strong_body_has_the_elastic_film():
    strong = sc.Material.linear_hardening(210e9, 0.3, 50e9, 5e9)
    _, found = press(strong, 2.0)
    film = sc.lubrication.steady(GRID, BALL, BALL, GAP, load=LOAD, speed=(2.0, 2.0), lubricant=OIL)
    np.testing.assert_allclose(found.film.film, film.film, rtol=1e-8)
    assert found.state.max_equivalent_plastic_strain(2) == 0.0


def test_without_speed_the_contact_is_the_dry_plastic_one():
    layer = sc.lubrication.Boundary(1e-9)
    simulation, found = press(RACE, 1e-6, boundary=layer, order=1)
    dry = sc.Simulation(GRID, BALL, RACE, GAP, on_border="warn")
    state = dry.step(load=LOAD)
    difference = np.linalg.norm(found.film.pressure - state.pressure)
    assert difference < 2e-3 * np.linalg.norm(state.pressure)
    strains = found.state.max_equivalent_plastic_strain(2), state.max_equivalent_plastic_strain(2)
    assert strains[0] == pytest.approx(strains[1], rel=3e-3)
    imprints = simulation.step(load=0.0), dry.step(load=0.0)
    depths = [np.ptp(s.residual_displacement(2)) for s in imprints]
    assert depths[0] == pytest.approx(depths[1], rel=3e-3)


def test_a_film_over_a_body_that_yields_agrees_with_its_pressure():
    """The gap contains the residual displacement that the pressure of the film causes."""
    simulation, found = press(RACE, 2.0, tol=1e-5)
    assert found.evaluations <= 12
    again = sc.Simulation(GRID, BALL, RACE, GAP, on_border="warn")
    state = again.step(pressure=found.film.pressure)
    moved = state.residual_displacement(2)
    assert np.abs(found.film.gap - GAP - moved).max() < 1e-3 * found.film.central_film
    assert found.film.pressure.max() < 0.85 * 2.74e9
    assert found.film.minimum_film < found.film.central_film
    assert simulation.state.load == pytest.approx(LOAD, rel=1e-4)


def test_an_error_keeps_the_state():
    simulation = sc.Simulation(GRID, BALL, RACE, GAP, on_border="warn")
    simulation.step(load=100.0)
    given = {"load": LOAD, "speed": (2.0, 2.0), "lubricant": OIL, "max_iterations": 1}
    with pytest.raises(sc.ConvergenceError):
        sc.lubrication.press(simulation, **given)
    assert simulation.state.load == pytest.approx(100.0)
    moving = sc.Simulation(GRID, BALL, RACE, GAP, relief2=sc.Relief(np.zeros((4, 48))))
    with pytest.raises(ValueError, match="must not have reliefs"):
        sc.lubrication.press(moving, load=LOAD, speed=(2.0, 2.0), lubricant=OIL)


def test_a_film_excludes_friction_heat_and_adhesion():
    """None of them is ignored silently."""
    warm = [body.with_thermal(50.0, 12e-6, 14e-6) for body in (BALL, RACE)]
    for bodies, settings, name in (
        ((BALL, RACE), {"friction": 0.1}, "friction"),
        ((BALL, RACE), {"friction": sc.Coulomb(0.1)}, "friction"),
        (warm, {"heat": sc.Heat(factor=0.1, velocity=(1.0, 0.0))}, "heat"),
        ((BALL, RACE), {"adhesion": sc.TensileLimit(1e6)}, "adhesion"),
    ):
        simulation = sc.Simulation(GRID, *bodies, GAP, on_border="warn", **settings)
        with pytest.raises(ValueError, match=f"simulation must not have {name} under a film"):
            sc.lubrication.press(simulation, load=LOAD, speed=(1.0, 1.0), lubricant=OIL)
