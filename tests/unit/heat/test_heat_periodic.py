# SPDX-License-Identifier: GPL-3.0-or-later
"""Transient heat of periodic surfaces against closed forms."""

import math

import numpy as np
import pytest
import scipy
from heat_setups import ALPHA, COLD, KAPPA, NU, WARM, E, K

import samcontact as sc

SIZE = 50e-6
PRESSURE, FACTOR = 1e8, 0.05
FLUX = FACTOR * PRESSURE
SOURCES = ("time", "history")


def flat(grid, source, time, parts=4):
    """Return a function that heats two flat bodies, the lower one for a time, by a pressure."""
    given = {"time": time} if source == "time" else {"history": (time / parts, time)}
    heat = sc.Heat(FACTOR, **given)
    run = sc.Simulation(grid, COLD, WARM, np.zeros(grid.surface_shape), heat=heat, on_border="warn")

    def heated(pressure):
        if source == "time":
            return run.step(pressure=pressure)
        for _ in range(parts):
            state = run.step(pressure=pressure, duration=time / parts)
        return state

    return heated


@pytest.mark.parametrize("source", SOURCES)
@pytest.mark.parametrize("shape", [(6, 4), (6, 1)])
def test_uniform_heat_warms_a_laterally_held_half_space(source, shape):
    """Carslaw & Jaeger (1959), section 2.9; uniaxial strain along z."""
    grid = sc.Grid(*shape, SIZE, 2 * SIZE, 3, SIZE, periodic="xy")
    time = 5e-3
    heated = flat(grid, source, time)
    state = heated(np.full(shape, PRESSURE))
    width = 2.0 * math.sqrt(KAPPA * time)
    surface = FLUX / K * width / math.sqrt(math.pi)
    np.testing.assert_allclose(state.surface_temperature(2), surface, rtol=2e-6)
    z = state.depths / width
    rise = FLUX / K * width * (np.exp(-(z**2)) / math.sqrt(math.pi) - z * scipy.special.erfc(z))
    for column in state.temperature(2).reshape(-1, len(z)):
        np.testing.assert_allclose(column, rise, rtol=0, atol=2e-6 * surface)
    held = -E * ALPHA / (1.0 - NU) * rise
    found = state.stress(2) - sc.Simulation(
        grid, COLD, WARM, np.zeros(shape), on_border="warn"
    ).step(pressure=np.full(shape, PRESSURE)).stress(2)
    for component, expected in enumerate((held, held, 0.0, 0.0, 0.0, 0.0)):
        difference = found[component] - np.broadcast_to(expected, found[component].shape)
        assert np.abs(difference).max() < 5e-6 * np.abs(held).max()
    expansion = ALPHA * (1.0 + NU) / (1.0 - NU) * FLUX * KAPPA * time / K
    np.testing.assert_allclose(state.surface_displacement(2), -expansion, rtol=2e-6)


@pytest.mark.parametrize("source", SOURCES)
@pytest.mark.parametrize("periodic", ["xy", "x"])
def test_a_wave_of_heat_has_its_closed_form(source, periodic):
    """Temperature q/(k w) erf(w sqrt(kappa t)); displacement by the integral over the depth."""
    cells = 32
    grid = sc.Grid(cells, 1, SIZE, SIZE, periodic="xy") if periodic == "xy" else sc.Grid(
        cells, 300, SIZE, 8 * SIZE, periodic="x"
    )  # fmt: skip
    w = 2.0 * math.pi / (cells * SIZE)
    wave = np.cos(w * grid.x)[:, None] * np.ones(grid.ny)
    time = 4e-3
    states = [flat(grid, source, time)(PRESSURE * (1.0 + sign * wave)) for sign in (1.0, -1.0)]
    middle = grid.ny // 2
    shape = np.sinc(1.0 / cells)  # of a flux that is constant in each cell

    def amplitude(of):
        difference = 0.5 * (of(states[0]) - of(states[1]))[:, middle]
        return 2.0 / cells * float(difference @ wave[:, middle])

    reach = w * math.sqrt(KAPPA * time)
    expected = shape * FLUX / (K * w) * math.erf(reach)
    rise = amplitude(lambda s: s.surface_temperature(2))
    # A quarter of the error is due to shorter waves of the flux in cells, which appear as this one.
    assert rise == pytest.approx(expected, rel=3e-3)

    def depth_profile(z):
        root = math.sqrt(KAPPA * time)
        return (
            math.exp(-w * z) * math.erfc(z / (2 * root) - reach)
            - math.exp(w * z) * math.erfc(z / (2 * root) + reach)
        ) / (2.0 * w)

    integral, _ = scipy.integrate.quad(
        lambda z: math.exp(-w * z) * depth_profile(z), 0.0, 5.0 / w, limit=200
    )
    expected = -shape * 2.0 * ALPHA * (1.0 + NU) * FLUX / K * integral
    elastic = shape * 2.0 * (1.0 - NU**2) / E * PRESSURE / w
    bulge = amplitude(lambda s: s.surface_displacement(2)) - elastic
    assert bulge == pytest.approx(expected, rel=3e-3, abs=1e-3 * elastic)


@pytest.mark.parametrize("periodic", ["x", "y", "xy"])
@pytest.mark.parametrize("source", SOURCES)
def test_a_long_period_tends_to_a_single_source(periodic, source):
    cells = 40
    spot = np.zeros((cells, cells))
    middle = slice(cells // 2 - 3, cells // 2 + 3)
    spot[middle, middle] = PRESSURE
    found, single = (
        flat(sc.Grid(cells, cells, SIZE, SIZE, 2, SIZE, periodic=axes), source, 2e-3, 2)(spot)
        for axes in (periodic, "")
    )
    for of, tol in ((lambda s: s.temperature(2), 1e-5), (lambda s: s.stress(2), 1e-2)):
        expected = of(single)[..., middle, middle, :]
        near = of(found)[..., middle, middle, :]
        np.testing.assert_allclose(near, expected, rtol=0, atol=tol * np.abs(expected).max())


def test_contact_of_a_heated_periodic_surface():
    """Marched and constant heat agree, and the pressed surfaces touch."""
    grid = sc.Grid(16, 16, SIZE, SIZE, periodic="xy")
    wave = 2.0 * math.pi / (16 * SIZE)
    gap = 4e-6 * (2.0 - np.cos(wave * grid.x)[:, None] - np.cos(wave * grid.y))
    load, time = 20.0, 1e-3
    once = sc.Simulation(grid, COLD, WARM, gap, heat=sc.Heat(FACTOR, time=time), tol=1e-9)
    expected = once.step(load=load)
    march = sc.Simulation(
        grid, COLD, WARM, gap, heat=sc.Heat(FACTOR, history=(time, 10.0)), tol=1e-9
    )
    state = march.step(load=load, duration=time)
    np.testing.assert_allclose(
        state.pressure, expected.pressure, rtol=0, atol=1e-6 * expected.pressure.max()
    )
    cold = sc.Simulation(grid, COLD, WARM, gap).step(load=load)
    assert state.pressure.max() > 1.02 * cold.pressure.max()
    left = gap - state.approach + sum(state.surface_displacement(body) for body in (1, 2))
    touches = state.pressure > 0
    assert 4 < touches.sum() < 200
    assert np.abs(left[touches]).max() < 1e-6 * np.abs(left).max()
    cooled = march.step(load=0.0, duration=time)
    mean = cooled.surface_temperature(2).mean()
    flux = FACTOR * load / (16 * SIZE) ** 2
    rate = 2.0 * flux / K * math.sqrt(KAPPA / math.pi)
    assert mean == pytest.approx(rate * (math.sqrt(2 * time) - math.sqrt(time)), rel=1e-5)


@pytest.mark.parametrize(
    ("heat", "text"),
    [
        (sc.Heat(FACTOR), "has no steady state; set heat.time or heat.history"),
        (sc.Heat(FACTOR, (0.1, 0.0), time=1.0), "heat.velocity of body 2 along x must be 0"),
    ],
)
def test_heat_without_a_state_is_refused(heat, text):
    with pytest.raises(ValueError, match=text):
        sc.Simulation(sc.Grid(4, 4, 1e-5, 1e-5, periodic="xy"), COLD, WARM, np.zeros((4, 4)),
                      heat=heat)  # fmt: skip
