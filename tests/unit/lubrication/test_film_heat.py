# SPDX-License-Identifier: GPL-3.0-or-later
"""Heated films: closed forms, balance of energy, limits, and traction curves."""

import functools
import warnings
from dataclasses import replace

import numpy as np
import pytest
import scipy.integrate
import scipy.optimize

import samcontact as sc
from samcontact.lubrication.film_heat import FLOW_SHARE, Conduction, shear_factor, warm_fluidity
from samcontact.lubrication.surface_heat import HeatedSurfaces, line_source
from samcontact.lubrication.through_film import HEIGHTS, WEIGHTS

E_STAR, R, ETA, ALPHA = 113.74e9, 0.01, 0.04, 22e-9
ELASTIC = sc.Material.elastic(2 * E_STAR * 0.91, 0.3)
STEEL = ELASTIC.with_thermal(46.0, 12e-6, 12.5e-6)
OIL = sc.Lubricant.roelands(ETA, ALPHA)
WARM = OIL.with_thermal(0.14, 1.7e6, 0.04).with_eyring(5e6)
LAYER = sc.lubrication.Boundary(5e-9, friction=0.1)
films = sc.lubrication


@functools.cache
def ball(oil=WARM, slide=0.5, body=STEEL, M=200.0, n=48, pace=1.0, **more):
    """Return the film of a ball, L = 10; pace: speed relative to that of L = 10."""
    group = (10 / (ALPHA * 2 * E_STAR)) ** 4
    u, load = 0.5 * group * 2 * E_STAR * R / ETA, M * 2 * E_STAR * R**2 * group**0.75
    a = (0.75 * load * R / E_STAR) ** (1 / 3)
    grid = sc.Grid(n, n, 4 * a / n, 4 * a / n)
    x, y = grid.x[:, None] - 0.5 * a, grid.y[None, :]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return films.steady(
            grid, body, body, 0.5 * (x**2 + y**2) / R, load=load,
            speed=(pace * u * (1 + slide / 2), pace * u * (1 - slide / 2)), lubricant=oil, **more,
        )  # fmt: skip


def test_couette_flow_with_heat_agrees_with_an_integration_over_the_film():
    """Newtonian, walls at the same temperature: k T'' = -eta e^(-beta T) (du/dz)^2."""
    heat, h, slide, p = WARM.heat, 2e-7, 5.0, 3e8
    eta = float(OIL.viscosity(p))
    oil = OIL.with_thermal(heat.conductivity, heat.capacity, heat.beta)
    film = Conduction(oil, np.array([p]), np.array([h]), np.ones(1), slide)
    depth = film.depth(np.zeros(1))
    tau, middle = film.shear(np.zeros(1), depth), film.middle_rise(np.zeros(1), depth)
    assert depth[0] > 1.0  # far from a parabola
    # y = T, T', u over t = z/(h/2) from the mid-plane, with the unknown stress as a parameter
    warmth = heat.beta * (h / 2) ** 2 / heat.conductivity

    def rates(t, y, s):
        shear = s[0] * 1e6 / eta * np.exp(y[0]) * h / 2
        return np.array([y[1], -warmth * s[0] * 1e6 * shear / (h / 2), shear])

    def ends(a, b, s):
        return np.array([a[1], b[0], a[2], b[2] - slide / 2])

    t = np.linspace(0, 1, 41)
    start = np.array([1 - t**2, -2 * t, slide / 2 * t])
    found = scipy.integrate.solve_bvp(rates, ends, t, start, p=[1e-6 * tau[0]], tol=1e-8)
    assert found.success
    assert tau[0] == pytest.approx(1e6 * found.p[0], rel=1e-5)
    assert middle[0] == pytest.approx(found.y[0, 0] / heat.beta, rel=1e-5)
    assert shear_factor(np.zeros(1)) == pytest.approx(1.0)


@pytest.mark.parametrize(("loss", "rel"), [(0.3, 1e-3), (3.0, 0.02)])
def test_heat_of_the_pressure_flow_increases_the_flow(loss, rel):
    """Integration over the film: theta'' = -g t^2 e^theta; loss: beta q h/(4 k)."""
    t = np.linspace(0, 1, 401)

    def warmed(t, y, g):
        heat = g[0] * t**2 * np.exp(y[0])
        return np.array([y[1], -heat, heat])

    found = scipy.integrate.solve_bvp(
        warmed, lambda a, b, g: np.array([a[1], b[0], a[2], b[2] - loss]), t,
        np.zeros((3, t.size)), p=[3 * loss],
    )  # fmt: skip
    exact = 3 * scipy.integrate.trapezoid(t**2 * np.exp(found.sol(t)[0]), t)
    flow = depth_of(4 * loss * FLOW_SHARE / 8)
    assert 3 * (WEIGHTS * HEIGHTS**2) @ warm_fluidity(flow)[:, 0] == pytest.approx(exact, rel=rel)


def depth_of(warming):
    """Return D with D tanh D = warming."""
    return np.array([scipy.optimize.brentq(lambda d: d * np.tanh(d) - warming, 0, 50)])


def test_line_source_is_the_limit_of_a_long_strip():
    """Surface of a half-space that moves through a strip; strip of 4000 widths."""
    x, a = np.linspace(-3e-4, 5e-4, 9), 2e-5
    for speed in (0.7, -3.0):
        strip = sc.heat_kernels.temperature(
            x, [0.0], 0.0, a, 4000 * a, conductivity=46.0, diffusivity=12.5e-6,
            velocity=(speed, 0.0),
        )  # fmt: skip
        found = line_source(x, a, 46.0, 12.5e-6, speed)
        np.testing.assert_allclose(found, strip[:, 0], rtol=1e-3, atol=1e-6 * found.max())


def test_heat_that_crosses_the_film_follows_from_the_temperatures():
    grid = sc.Grid(24, 20, 1e-5, 1e-5)
    cold = ELASTIC.with_thermal(400.0, 12e-6, 1e-4)
    surfaces = HeatedSurfaces(grid, (STEEL, cold), np.array([[0.5, 0.0], [2.0, 0.3]]))
    heat = 1e7 * np.maximum(1 - (grid.x[:, None] ** 2 + grid.y**2) / 64e-10, 0)
    resistance = np.full(heat.shape, 1.5e-7 / 0.14)
    flux, rise = surfaces.fluxes(heat, resistance)
    np.testing.assert_allclose(flux.sum(axis=0), heat, atol=1e-3)
    crossing = 0.5 * heat - flux[0]
    np.testing.assert_allclose(crossing, (rise[0] - rise[1]) / resistance, atol=1e-6 * heat.max())
    assert crossing[12, 10] > 0.1 * heat[12, 10]


def test_heat_of_both_bodies_is_the_power_of_the_friction():
    """Without compression; the power of the flow by the work of the pressure gradient."""
    oil = replace(WARM, density_law=sc.lubricants.Incompressible())
    for slide, rel in ((0.5, 2e-3), (0.0, 0.1)):
        film = ball(oil, slide, thermal=True)
        assert film.heat.power == pytest.approx(films.friction(film).power, rel=rel)
    assert film.heat.max_rise < 1.0


def test_the_boundary_layer_heats_the_surfaces():
    film = ball(n=32, pace=0.02, thermal=True, shear_thinning=True, boundary=LAYER)
    found = films.friction(film)
    assert 0.2 < film.boundary_share < 0.8
    assert found.boundary_share > 0.5
    assert film.heat.power == pytest.approx(found.power, rel=1e-3)


def test_films_over_the_speed_are_those_of_each_speed():
    alone = ball(n=32, pace=0.02, thermal=True, shear_thinning=True, boundary=LAYER)
    u = float(alone.velocities[:, 0].mean())
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        curve = films.stribeck(
            alone.grid, STEEL, STEEL, alone.gap, load=alone.load, speeds=[0.1 * u, u],
            slide_to_roll=0.5, lubricant=WARM, boundary=LAYER, thermal=True, shear_thinning=True,
        )  # fmt: skip
    np.testing.assert_allclose(curve.solutions[1].film, alone.film, rtol=1e-3)
    assert curve.solutions[1].heat.max_rise == pytest.approx(alone.heat.max_rise, rel=1e-3)
    assert curve.solutions[0].heat.max_rise < curve.solutions[1].heat.max_rise


def test_heat_thins_the_film_and_lowers_the_friction():
    plain, hot = ball(), ball(thermal=True, shear_thinning=True)
    assert hot.central_film < 0.995 * plain.central_film
    cooler = films.friction(hot).coefficient / films.friction(plain).coefficient
    assert 0.9 < cooler < 0.99
    rise = hot.heat.middle_rise
    assert 3 < rise.max() < 30
    # the wake of the slower body is the hotter one, and the film is hotter than the surfaces
    assert hot.heat.surface_rise[1].max() > hot.heat.surface_rise[0].max()
    assert np.all(rise >= hot.heat.wall_rise)


def test_great_conductivity_gives_the_isothermal_film():
    oil = WARM.with_thermal(10.0, 1.7e6, 0.04)
    copper = ELASTIC.with_thermal(1e12, 12e-6, 12.5e-6)
    plain, cold = ball(M=20.0), ball(oil, body=copper, M=20.0, thermal=True)
    assert cold.heat.max_rise < 0.1
    np.testing.assert_allclose(cold.film, plain.film, rtol=1e-3)
    insensitive = ball(WARM.with_thermal(0.14, 1.7e6, 0.0), M=20.0, thermal=True)
    np.testing.assert_allclose(insensitive.film, plain.film, rtol=1e-6)
    assert insensitive.heat.max_rise > 0.5


def test_a_traction_curve_with_heat_has_a_maximum():
    """A line contact, so that ten films take little time."""
    p0, u = 1e9, 5.0
    b = 2 * R * p0 / E_STAR
    grid = sc.Grid(128, 1, 6 * b / 128, 1e-3, periodic="y")
    scene = {
        "load": 0.5 * np.pi * b * p0 * 1e-3, "speed": (u, u), "shear_thinning": True,
    }  # fmt: skip
    gap = sc.surfaces.paraboloid(grid, R, np.inf)
    hot = films.steady(grid, STEEL, STEEL, gap, lubricant=WARM, thermal=True, **scene)
    cold = films.steady(grid, STEEL, STEEL, gap, lubricant=WARM, **scene)
    ratios = [0.0, 0.002, 0.1, 0.3, 1.0, -0.3]
    warm, isothermal = (films.traction_curve(film, ratios) for film in (hot, cold))
    assert np.all(np.diff(isothermal.coefficient[:5]) > 0)
    assert warm.coefficient[4] < warm.coefficient[3] < warm.coefficient[2]
    assert warm.coefficient[3] < 0.8 * isothermal.coefficient[3]
    assert np.all(np.diff(warm.max_rise[:5]) > 0)
    assert warm.central_film[4] < 0.95 * warm.central_film[0]
    assert warm.coefficient[5] == pytest.approx(-warm.coefficient[3], rel=1e-3)
    assert warm.coefficient[1] == pytest.approx(isothermal.coefficient[1], rel=0.02)
    assert warm.coefficient[0] == 0.0


def test_heat_of_the_inlet_thins_a_fast_rolling_film():
    """Line contact, L = 1.1: 0.862 by an integration over the inlet (Grubin), Murch & Wilson 0.784.

    The inlet of the integration is that of a rigid flat contact at 0.45 GPa.
    """
    p0, u = 0.45e9, 10.0
    b = 2 * R * p0 / E_STAR
    grid = sc.Grid(192, 1, 36 * b / 192, 1e-3, periodic="y")
    scene = {"load": 0.5 * np.pi * b * p0 * 1e-3, "speed": (u, u)}
    gap = sc.surfaces.paraboloid(grid, R, np.inf)
    oil = sc.Lubricant.barus(ETA, ALPHA, density=None).with_thermal(0.14, 1.7e6, 0.04)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", sc.ResolutionWarning)
        cold = films.steady(grid, STEEL, STEEL, gap, lubricant=oil, **scene)
        with pytest.warns(UserWarning, match="carries .* times the heat"):
            hot = films.steady(grid, STEEL, STEEL, gap, lubricant=oil, thermal=True, **scene)
    factor = hot.central_film / cold.central_film
    assert films.inlet_heating_factor((u, u), oil) == pytest.approx(0.784, abs=1e-3)
    assert factor == pytest.approx(0.862, abs=0.03)


@pytest.mark.parametrize(
    ("more", "error", "words"),
    [
        ({"oil": OIL, "thermal": True}, ValueError, "lubricant must have thermal constants"),
        ({"body": ELASTIC, "thermal": True}, ValueError, "body1 must have thermal constants"),
        ({"thermal": "yes"}, TypeError, "True or False"),
    ],
)
def test_wrong_arguments_are_refused(more, error, words):
    with pytest.raises(error, match=words):
        ball(**more)


def test_a_heated_film_does_not_start_a_transient_one():
    with pytest.raises(ValueError, match="start must be a film without"):
        films.transient(ball(M=20.0, n=24, thermal=True), duration=1e-6, steps=1)


def test_a_line_contact_needs_moving_bodies():
    grid = sc.Grid(64, 1, 1e-5, 1e-3, periodic="y")
    with pytest.raises(ValueError, match=r"speed of body2 .* must differ from 0"):
        films.steady(
            grid, STEEL, STEEL, sc.surfaces.paraboloid(grid, R, np.inf), load=10.0,
            speed=(1.0, 0.0), lubricant=WARM, thermal=True,
        )  # fmt: skip
