# SPDX-License-Identifier: GPL-3.0-or-later
"""Shear thinning in the flow of a film: closed forms, quadrature over the film, and limits."""

import warnings

import numpy as np
import pytest
import scipy.optimize

import samcontact as sc
from samcontact.lubricants.shear import Carreau, Eyring
from samcontact.lubrication.through_film import HEIGHTS, flow_tensor

E_STAR, R, ETA, ALPHA = 113.74e9, 0.01, 0.04, 22e-9
STEEL = sc.Material.elastic(2 * E_STAR * 0.91, 0.3)
OIL = sc.Lubricant.roelands(ETA, ALPHA)
STRESS = 5e6
films = sc.lubrication


def steady(oil, velocities, M=20.0, L=10.0, n=48, **more):
    """Return the film of a ball on a square grid that suits every direction of the flow."""
    group = (L / (ALPHA * 2 * E_STAR)) ** 4
    load = M * 2 * E_STAR * R**2 * group**0.75
    a = (0.75 * load * R / E_STAR) ** (1 / 3)
    u = 0.5 * group * 2 * E_STAR * R / ETA
    grid = sc.Grid(n, n, 6 * a / n, 6 * a / n)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return films.steady(
            grid, STEEL, STEEL, sc.surfaces.paraboloid(grid, R), load=load,
            speed=u * np.asarray(velocities), lubricant=oil, **more,
        )  # fmt: skip


def test_eyring_flow_has_the_closed_form_of_conry():
    """Conry, Wang & Cusano (1987): cosh(tau_m/tau_0) 3 (s cosh s - sinh s)/s^3."""
    newtonian, gradient = np.array([1e6, 3e7, 5e9]), np.array([2e6, -8e6, 3e7])
    s = gradient / STRESS
    middle = np.arcsinh(newtonian / STRESS * s / np.sinh(s))
    expected = np.cosh(middle) * 3 * (s * np.cosh(s) - np.sinh(s)) / s**3
    zero, even = np.zeros(3), np.ones((HEIGHTS.size, 3))
    found = flow_tensor(
        Eyring(STRESS), np.array([newtonian, zero]), np.array([gradient, zero]), even
    )
    np.testing.assert_allclose(found.xx, expected, rtol=1e-6)
    assert np.abs(found.xy).max() < 1e-12
    # a small gradient across the sliding meets the ratio of Newtonian to true stress
    across = flow_tensor(
        Eyring(STRESS), np.array([newtonian, zero]), np.array([zero, 1e-3 * gradient]), even
    )
    expected = newtonian / STRESS / np.arcsinh(newtonian / STRESS)
    np.testing.assert_allclose(across.yy, expected, rtol=1e-6)


@pytest.mark.parametrize("law", [Eyring(STRESS), Carreau(STRESS, 0.4)])
@pytest.mark.parametrize(("newtonian", "gradient"), [((3e8, 1e7), (8e6, 3e6)), ((0, 0), (2e7, 0))])
def test_flow_agrees_with_quadrature_over_the_film(law, newtonian, gradient):
    t = np.linspace(-1, 1, 8001)
    weights = np.full(t.size, 1.0 / (t.size - 1))
    weights[[0, -1]] *= 0.5
    given, w = np.array(newtonian, float), np.array(gradient, float)

    def warm(height):
        return (np.cosh(0.7) / np.cosh(0.7 * height)) ** 2

    def rate(middle):
        stress = 1e6 * middle[:, None] + w[:, None] * t
        return law.fluidity(np.hypot(*stress))[0] * stress * warm(t)

    start = 1e-6 * given / max(np.hypot(*given), 1.0) * law.stress(np.hypot(*given))
    if given.any():
        start = scipy.optimize.fsolve(
            lambda m: 1e-6 * (rate(m) @ weights - given), start, xtol=1e-12
        )
    middle = start
    flow = 3 * rate(middle) @ (weights * t)
    found = flow_tensor(law, given[:, None], w[:, None], warm(HEIGHTS)[:, None])
    matrix = np.array([[found.xx[0], found.xy[0]], [found.xy[0], found.yy[0]]])
    np.testing.assert_allclose(matrix @ w, flow, rtol=1e-3, atol=1e-6 * np.hypot(*flow))
    x = np.logspace(4, 8, 9)
    np.testing.assert_allclose(law.fluidity(law.stress(x))[0] * law.stress(x), x, rtol=1e-12)


def test_large_eyring_stress_and_pure_rolling_give_the_newtonian_film():
    fast = ((1.25, 0.0), (0.75, 0.0))
    newtonian = steady(OIL, fast)
    stiff = steady(OIL.with_eyring(1e13), fast, shear_thinning=True)
    np.testing.assert_allclose(stiff.film, newtonian.film, rtol=1e-6)
    rolling = steady(OIL.with_eyring(STRESS), ((1.0, 0.0), (1.0, 0.0)), shear_thinning=True)
    # without sliding, only steep pressure gradients thin the oil
    assert rolling.central_film == pytest.approx(newtonian.central_film, rel=2e-3)
    assert rolling.pressure.max() < newtonian.pressure.max()


def test_thinning_depends_on_the_sliding_not_on_the_axes():
    oil, how = OIL.with_eyring(1e6), {"shear_thinning": True, "n": 32}
    along = steady(oil, ((1.5, 0.0), (0.5, 0.0)), **how)
    back = steady(oil, ((-0.5, 0.0), (-1.5, 0.0)), **how)
    assert np.abs(along.pressure - back.pressure[::-1]).max() < 1e-5 * along.pressure.max()
    across = steady(oil, ((0.0, 1.5), (0.0, 0.5)), **how)
    assert np.abs(along.pressure - across.pressure.T).max() < 1e-5 * along.pressure.max()
    half = 0.5**0.5
    slanted = steady(oil, ((1.5 * half,) * 2, (0.5 * half,) * 2), **how)
    newtonian = steady(OIL, ((1.5 * half,) * 2, (0.5 * half,) * 2), n=32)
    plain = steady(OIL, ((1.5, 0.0), (0.5, 0.0)), n=32)
    thinner = along.central_film / plain.central_film
    assert thinner < 0.97
    assert slanted.central_film / newtonian.central_film == pytest.approx(thinner, rel=5e-3)


def test_flow_of_a_line_contact_is_the_same_through_every_section():
    """Eyring, by the closed form of Conry between the cells, not by the factors of the solver."""
    p0, u, slide, stress = 0.5e9, 1.0, 1.0, 1e6
    b = 2 * R * p0 / E_STAR
    grid = sc.Grid(512, 1, 8 * b / 512, 1e-3, periodic="y")
    oil = sc.Lubricant.roelands(ETA, ALPHA, density=None).with_eyring(stress)
    film = films.steady(
        grid, STEEL, STEEL, sc.surfaces.paraboloid(grid, R, np.inf),
        load=0.5 * np.pi * b * p0 * 1e-3, speed=(u + slide / 2, u - slide / 2), lubricant=oil,
        shear_thinning=True, order=2,
    )  # fmt: skip
    p, h = film.fluid_pressure[:, 0], film.film[:, 0]
    full = np.flatnonzero(film.filling[:, 0] == 1)[2:-2]
    between = 0.5 * (h[1:] + h[:-1])
    viscosity = oil.viscosity(0.5 * (p[1:] + p[:-1]))
    s = np.diff(p) / grid.dx * between / 2 / stress
    s = np.where(np.abs(s) < 1e-3, 1e-3, s)
    rate = viscosity * slide / between / stress
    middle = np.arcsinh(rate * s / np.sinh(s))
    factor = np.cosh(middle) * 3 * (s * np.cosh(s) - np.sinh(s)) / s**3
    flow = u * between - factor * between**3 / 12 / viscosity * np.diff(p) / grid.dx
    # the inlet, where the flow due to the pressure is a tenth of the whole at least
    part = [i for i in full[:-1] if 0.1 < (u * between[i] - flow[i]) / flow[i] < 5 and i < 256]
    assert len(part) > 10
    np.testing.assert_allclose(flow[part], flow[part].mean(), rtol=0.02)
    assert factor[part].max() > 1.3
    thick = films.steady(
        grid, STEEL, STEEL, sc.surfaces.paraboloid(grid, R, np.inf),
        load=0.5 * np.pi * b * p0 * 1e-3, speed=(u, u), lubricant=oil,
    )  # fmt: skip
    assert film.central_film < 0.95 * thick.central_film


@pytest.mark.parametrize(
    ("oil", "more", "error", "words"),
    [
        (OIL, {"shear_thinning": True}, ValueError, "with_eyring or with_carreau"),
        (OIL, {"shear_thinning": 1}, TypeError, "True or False"),
    ],
)
def test_wrong_arguments_are_refused(oil, more, error, words):
    with pytest.raises(error, match=words):
        steady(oil, ((1.0, 0.0), (1.0, 0.0)), **more)
