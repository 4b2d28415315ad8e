# SPDX-License-Identifier: GPL-3.0-or-later
"""Films in time: steady cases, order in time, waves that pass, restart."""

import warnings

import numpy as np
import pytest

import samcontact as sc

E_STAR, R = 113.74e9, 0.01
BODY = sc.Material.elastic(2 * E_STAR * 0.91, 0.3)
OIL = sc.Lubricant.roelands(viscosity=0.04, pressure_viscosity=22e-9)
U, LOAD, A = 0.45330408, 36.29740, 1.33764e-4  # M 200, L 10


def steady(n, width=4.0, **more):
    grid = sc.Grid(n, n, width * A / n, width * A / n)
    x, y = grid.x[:, None] - 0.25 * A, grid.y[None, :]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return sc.lubrication.steady(
            grid, BODY, BODY, 0.5 * (x**2 + y**2) / R, load=LOAD,
            **{"speed": (U, U), "lubricant": OIL} | more,
        )  # fmt: skip


def test_a_steady_film_stays():
    film = steady(32)
    history = sc.lubrication.transient(film, duration=3 * film.grid.dx / U, steps=3, tol=1e-9)
    np.testing.assert_allclose(history.film[-1], film.film, rtol=1e-6)


def test_steps_are_of_second_order_and_continue_exactly():
    film = steady(32, tol=1e-9)
    duration = 16 * film.grid.dx / U

    def march(start, steps, share=1.0):
        return sc.lubrication.transient(
            start, duration=share * duration, steps=steps, tol=1e-9,
            load=lambda t: LOAD * (1 + 0.2 * np.sin(np.pi * t / duration) ** 3),
            speed=lambda t: (U * (1 - 0.3 * (t / duration) ** 3),) * 2,
        )  # fmt: skip

    coarse, middle, fine = (march(film, n).film[-1] for n in (16, 32, 64))
    norm = np.linalg.norm
    assert norm(coarse - middle) / norm(middle - fine) == pytest.approx(4.0, abs=1.2)
    whole = march(film, 8)
    half = march(film, 4, 0.5)
    rest = march(half.solutions[-1], 4, 0.5)
    np.testing.assert_array_equal(whole.film[4:], rest.film)
    np.testing.assert_array_equal(whole.time[4:], rest.time)
    assert whole.solutions[-1].load == pytest.approx(LOAD, rel=1e-6)


def test_a_starved_film_stays():
    """The supply of the start arrives at the inlet at all times."""
    film = steady(32, supply=2e-7, tol=1e-9)
    assert film.central_film < 0.9 * steady(32).central_film
    history = sc.lubrication.transient(film, duration=3 * film.grid.dx / U, steps=3, tol=1e-9)
    np.testing.assert_allclose(history.film[-1], film.film, rtol=1e-6)


def test_shear_thins_a_film_in_time():
    """After the sliding has changed and the oil has passed, the film is the steady one."""
    thin = OIL.with_eyring(3e6)
    n, slide = 24, 0.8
    film = steady(n, lubricant=thin, shear_thinning=True, order=1, tol=1e-8)
    dx, passing = film.grid.dx, 3.0 * film.grid.nx
    same = sc.lubrication.transient(film, duration=2 * dx / U, steps=2, order=1, tol=1e-8)
    np.testing.assert_allclose(same.film[-1], film.film, rtol=1e-5)
    fast = {"speed": (U * (1 + slide / 2), U * (1 - slide / 2))}
    history = sc.lubrication.transient(
        film, duration=passing * dx / U, steps=int(passing), order=1, tol=1e-5,
        speed=lambda t: fast["speed"],
    )  # fmt: skip
    sliding = steady(n, lubricant=thin, shear_thinning=True, order=1, tol=1e-8, **fast)
    assert sliding.central_film < 0.97 * film.central_film
    np.testing.assert_allclose(history.film[-1], sliding.film, rtol=2e-3)


def wave(amplitude, length):
    """Transverse waves that have not yet entered the contact at time 0."""

    def heights(x, y):
        x = x - 0.25 * A
        ramp = np.clip((-2.0 * A - x) / (0.5 * length), 0, 1)
        return amplitude * np.cos(2 * np.pi * x / length) * ramp**2 * (3 - 2 * ramp) + 0 * y

    return heights


@pytest.mark.slow
def test_a_wave_is_flattened_as_measured():
    """Amplitude reduction 1/(1 + 0.15 r + 0.015 r^2) at r = 4.47, wavelength a."""
    film = steady(96, 3.5)
    dx = film.grid.dx
    height = 0.1 * film.central_film
    steps = int(np.ceil(3.4 * A / dx))
    history = sc.lubrication.transient(
        film, duration=steps * dx / U, steps=steps, relief1=wave(height, A), tol=1e-5
    )
    i = int(np.argmin(np.abs(film.grid.x - 0.25 * A)))
    last = history.film[-int(np.ceil(A / dx)) :, i, 48]
    assert np.ptp(last) / (2 * height) == pytest.approx(0.5075, rel=0.02)


def test_an_error_keeps_the_solutions_so_far():
    film = steady(32)

    def load(t):
        if t > 1.5 * film.grid.dx / U:
            raise KeyboardInterrupt
        return LOAD

    with pytest.raises(KeyboardInterrupt) as caught:
        sc.lubrication.transient(film, duration=4 * film.grid.dx / U, steps=4, load=load)
    assert len(caught.value.history.solutions) == 1
    with pytest.raises(TypeError, match="relief1 must be a function"):
        sc.lubrication.transient(film, duration=1.0, steps=1, relief1=np.zeros((32, 32)))
