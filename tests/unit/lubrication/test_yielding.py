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


def test_a_strong_body_has_the_heated_film():
    """Heat and shear thinning of an elastic film, from `steady`; softening is refused."""
    thermal = {"conductivity": 46.0, "expansion": 12e-6, "diffusivity": 12.5e-6}
    strong = sc.Material.linear_hardening(210e9, 0.3, 50e9, 5e9).with_thermal(**thermal)
    ball, oil = BALL.with_thermal(**thermal), OIL.with_eyring(5e6).with_thermal(0.14, 1.7e6, 0.04)
    cell = 4.2 * sc.hertz.point(R, 115.4e9, load=100.0).a / 32
    grid = sc.Grid(32, 28, cell, cell, dz=cell)
    gap = sc.surfaces.paraboloid(grid, R)
    how = {"lubricant": oil, "speed": (2.2, 1.8), "shear_thinning": True, "thermal": True,
           "order": 1}  # fmt: skip
    simulation = sc.Simulation(grid, ball, strong, gap, on_border="warn")
    found = sc.lubrication.press(simulation, load=100.0, **how)
    film = sc.lubrication.steady(grid, ball, ball, gap, load=100.0, **how)
    np.testing.assert_allclose(found.film.film, film.film, rtol=1e-8)
    np.testing.assert_allclose(found.film.heat.middle_rise, film.heat.middle_rise, rtol=1e-8)
    assert film.heat.max_rise > 5.0
    soft = RACE.with_thermal(**thermal).with_softening(
        sc.softening.JohnsonCook(melting=1800.0, m=1.0)
    )
    warm = sc.Simulation(grid, ball, soft, gap, on_border="warn")
    with pytest.raises(ValueError, match="must not have thermal softening"):
        sc.lubrication.press(warm, load=100.0, **how)


def test_loads_are_increments_that_keep_their_state(tmp_path):
    """`press_loads` is `press` at each load; kept increments are those solved."""
    loads = [0.5 * LOAD, LOAD]
    grid = sc.Grid(32, 24, 1.7 * DX, 1.7 * DX, dz=2 * DX)
    gap = sc.surfaces.paraboloid(grid, R)
    how = {"speed": (3.0, 3.0), "lubricant": OIL, "order": 1, "tol": 1e-3}
    alone = sc.Simulation(grid, BALL, RACE, gap, on_border="warn")
    pressed = [sc.lubrication.press(alone, load=load, **how) for load in loads]
    for _ in range(2):  # solved, then read
        simulation = sc.Simulation(grid, BALL, RACE, gap, on_border="warn")
        films = sc.lubrication.press_loads(
            simulation, loads=loads, checkpoint=tmp_path / "run", **how
        )
        for film, one in zip(films, pressed, strict=True):
            np.testing.assert_array_equal(film.film, one.film.film)
        strain = simulation.state.equivalent_plastic_strain(2)
        np.testing.assert_array_equal(strain, alone.state.equivalent_plastic_strain(2))
        np.testing.assert_array_equal(films[-1].plasticity.equivalent_plastic_strain[1], strain)
        unloaded = films[-1].plasticity.residual_von_mises[1].max()
        assert 0.1 < unloaded / films[-1].plasticity.von_mises[1].max() < 1.0
    other = sc.Simulation(grid, BALL, RACE, gap, on_border="warn")
    with pytest.raises(ValueError, match="is a checkpoint of another run"):
        sc.lubrication.press_loads(other, loads=[1.0, LOAD], checkpoint=tmp_path / "run", **how)
    with pytest.raises(ValueError, match="loads must be a list of positive numbers"):
        sc.lubrication.press_loads(other, loads=[0.0], **how)


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
    with pytest.raises(ValueError, match="must not have relief1 or relief2"):
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
