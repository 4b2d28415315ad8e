# SPDX-License-Identifier: GPL-3.0-or-later
"""Steady sliding over viscoelastic bodies: closed forms, limits, symmetry and force."""

import numpy as np
import pytest

import samcontact as sc
from moving_bodies import RUBBER, displaced_by_creep

RIGID = sc.Material.rigid()
UNIT = sc.Material.elastic(1.0, 0.0)
"""Elastic body with E* = 1 on a rigid one."""


def rough(n, seed=5):
    """Return a grid of unit side and the gap under a rough surface of slope 0.1 with long waves."""
    rng = np.random.default_rng(seed)
    k = np.fft.fftfreq(n, 1 / n)
    q = np.hypot(k[:, None], k)
    amplitude = np.where((q >= 2) & (q <= n / 4), np.maximum(q, 1e-9) ** -1.8, 0.0)
    z = np.fft.ifft2(amplitude * np.exp(2j * np.pi * rng.random((n, n)))).real
    z *= 0.1 / (n * np.sqrt(sum(((np.roll(z, -1, a) - z) ** 2).mean() for a in (0, 1))))
    return sc.Grid(n, n, 1 / n, 1 / n, periodic="xy"), z.max() - z


def wave(n, velocity, periodic="xy", sides=(1, 0)):
    """Return the friction force per area of a wave in full contact, and the closed form."""
    body = UNIT.with_relaxation(times=[1.0], shares=[0.9])
    cells = [n if side else 1 for side in sides]
    grid = sc.Grid(*cells, 1 / n, 1 / n, periodic=periodic)
    q, amplitude, mean = 2 * np.pi, 1e-3, 0.05
    gap = amplitude * (1 - np.cos(q * grid.x))[:, None] * np.ones(cells)
    load = mean * grid.cell_area * np.prod(cells)
    found = sc.sliding.steady(grid, RIGID, body, gap, load=load, velocity=velocity)
    assert found.in_contact.all()
    exact = amplitude**2 * q**2 * body.loss(q * abs(velocity)) / 4
    return found.friction * mean, exact


@pytest.mark.parametrize("velocity", [0.01, 0.1, 1.0, -1.0, 100.0])
def test_wave_in_full_contact(velocity):
    """Second order: the pressure is uniform in each cell."""
    coarse, fine = (wave(n, velocity) for n in (32, 64))
    errors = [force / exact - 1 for force, exact in (coarse, fine)]
    assert abs(errors[1]) < 2e-3
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.05)


@pytest.mark.parametrize("periodic", ["", "y"])
@pytest.mark.parametrize(("velocity", "share"), [(0.0, 0.2), (1e-7, 0.2), (1e12, 1.0)])
def test_limits_of_the_velocity_are_elastic(velocity, share, periodic):
    """The approach in plane strain has no limit, because the track is infinitely long."""
    grid = sc.Grid(24, 16, 1e-3, 1e-3, periodic=periodic)
    x, y = grid.x[:, None], grid.y
    gap = (x**2 + (y**2 if not periodic else 0.0)) / 0.2
    gap = gap + 2e-5 * np.sin(700 * x + 2 * np.pi * y / 8e-3)
    found = sc.sliding.steady(grid, RIGID, RUBBER, gap, load=0.5, velocity=velocity)
    body = sc.Material.elastic(share * RUBBER.E, RUBBER.nu)
    elastic = sc.ContactSolver(grid, RIGID, body).solve(gap, load=0.5)
    assert np.abs(found.pressure - elastic.pressure).max() < 1e-5 * elastic.pressure.max()
    assert abs(found.friction) < 1e-4
    if not periodic:
        assert found.approach == pytest.approx(elastic.approach, rel=1e-5)


def test_fast_sliding_of_a_periodic_surface():
    """Ridges along the sliding direction press the same material all the time."""
    grid, gap = rough(32)
    body = UNIT.with_relaxation(times=[0.02, 0.2], shares=[0.45, 0.45])
    found = sc.sliding.steady(grid, RIGID, body, gap, load=0.01, velocity=1e9)
    p = np.fft.fft2(found.pressure)
    q = 2 * np.pi * np.hypot(*np.meshgrid(*[np.fft.fftfreq(32, 1 / 32)] * 2))
    soft = np.zeros_like(p)
    soft[0] = 9 * p[0] * np.divide(2.0, q[0], out=np.zeros(32), where=q[0] > 0)
    ridges = np.fft.ifft2(soft).real
    elastic = sc.ContactSolver(grid, RIGID, UNIT).solve(gap + ridges, load=0.01)
    assert np.abs(found.pressure - elastic.pressure).max() < 0.02 * elastic.pressure.max()


def test_friction_of_a_rough_surface_over_four_decades():
    """Numbers of an independent program with a band-limited kernel; cost of the solution."""
    grid, gap = rough(64)
    body = UNIT.with_relaxation(times=[0.02, 0.2], shares=[0.45, 0.45])
    curve = sc.sliding.over_speed(
        grid, RIGID, body, gap, load=0.01, velocities=[0.01, 0.1, 1.0, 10.0, 100.0]
    )
    assert curve.friction == pytest.approx(
        [0.0110, 0.0426, 0.0284, 0.0073, 0.0009], rel=0.03, abs=2e-4
    )
    cells = [s.in_contact.mean() for s in curve.solutions]
    assert cells == pytest.approx([0.953, 0.572, 0.303, 0.238, 0.236], rel=0.03)
    assert (np.diff(curve.contact_area) < 0).all()
    assert (np.diff(curve.max_pressure) > 0).all()
    for v in curve.velocity:
        alone = sc.sliding.steady(grid, RIGID, body, gap, load=0.01, velocity=v)
        assert alone.error <= 1e-8
        assert alone.operator_applications <= 220


@pytest.mark.parametrize("periodic", ["", "xy"])
def test_force_is_that_of_the_pressure_on_the_slopes(periodic):
    """The force follows from the slope of the displacement; here from the slope of the gap."""
    grid = sc.Grid(64, 64, 5e-4, 5e-4, periodic=periodic)
    x, y = grid.x[:, None], grid.y
    q = 2 * np.pi / 32e-3
    gap = 2e-4 * (2 - np.cos(q * x) - np.cos(q * y)) + 2e-5 * np.sin(3 * q * x) * np.cos(q * y)
    slope = 2e-4 * q * np.sin(q * x) + 6e-5 * q * np.cos(3 * q * x) * np.cos(q * y)
    found = sc.sliding.steady(grid, RIGID, RUBBER, gap, load=0.5, velocity=0.5)
    force = (found.pressure * slope).sum() * grid.cell_area
    assert found.tangential_load[0] == pytest.approx(force, rel=0.03)
    assert found.power == pytest.approx(0.5 * force, rel=0.03)
    assert found.friction > 0.001


@pytest.mark.parametrize("periodic", ["", "xy"])
def test_reversal_mirrors_the_contact(periodic):
    grid = sc.Grid(24, 16, 1e-3, 1e-3, periodic=periodic)
    x, y = grid.x[:, None], grid.y
    gap = (x**2 + y**2) / 0.2 + 2e-5 * np.sin(700 * x + 300 * y)
    there = sc.sliding.steady(grid, RIGID, RUBBER, gap, load=0.5, velocity=0.05)
    back = sc.sliding.steady(grid, RIGID, RUBBER, gap[::-1], load=0.5, velocity=-0.05)
    assert np.abs(back.pressure[::-1] - there.pressure).max() < 1e-6 * there.pressure.max()
    assert back.friction == pytest.approx(there.friction, rel=1e-6)
    assert back.tangential_load[0] == pytest.approx(-there.tangential_load[0], rel=1e-6)


@pytest.mark.parametrize("periodic", ["", "y"])
def test_track_on_a_longer_grid(periodic):
    """The elastic displacement of the crept pressure on a grid with the whole track."""
    grid = sc.Grid(20, 12, 1e-3, 1e-3, periodic=periodic)
    gap = (grid.x[:, None] ** 2 + 0 * grid.y) / 0.2 + (grid.y**2 / 0.3 if not periodic else 0.0)
    found = sc.sliding.steady(grid, RIGID, RUBBER, gap, load=0.3, velocity=0.05)
    u = displaced_by_creep(found, RUBBER, 0.05)
    rest = found.gap - gap - u
    assert np.ptp(rest) < 1e-6 * np.abs(u).max()


def test_approach_gives_the_load_back():
    grid = sc.Grid(24, 16, 1e-3, 1e-3)
    gap = sc.surfaces.paraboloid(grid, 0.1)
    loaded = sc.sliding.steady(grid, RIGID, RUBBER, gap, load=0.5, velocity=0.05)
    given = {"approach": loaded.approach, "velocity": 0.05}
    held = sc.sliding.steady(grid, RIGID, RUBBER, gap, **given)
    assert held.load == pytest.approx(0.5, rel=1e-6)
    again = sc.sliding.steady(grid, RIGID, RUBBER, gap, **given, start=loaded)
    assert again.iterations < held.iterations


def test_a_slider_of_rubber_rests_in_its_contact():
    """The material of body 1 does not move through the contact: long-time modulus, no friction."""
    grid = sc.Grid(24, 16, 1e-3, 1e-3)
    gap = sc.surfaces.paraboloid(grid, 0.1)
    with pytest.warns(UserWarning, match="body 1 is viscoelastic and rests.*long-time modulus"):
        found = sc.sliding.steady(grid, RUBBER, RIGID, gap, load=0.5, velocity=0.05)
    soft = sc.Material.elastic(RUBBER.E * RUBBER.relaxation(1e9), RUBBER.nu)
    elastic = sc.ContactSolver(grid, soft, RIGID).solve(gap, load=0.5)
    assert np.abs(found.pressure - elastic.pressure).max() < 1e-6 * elastic.pressure.max()
    assert abs(found.friction) < 1e-6


def test_grid_is_enlarged_for_a_function():
    grid = sc.Grid(8, 8, 1e-3, 1e-3)
    found = sc.sliding.steady(
        grid, RIGID, RUBBER, lambda g: sc.surfaces.paraboloid(g, 0.1), load=2.0, velocity=0.05
    )
    assert found.grid.nx > 8
    assert found.friction > 0


def test_separated_bodies():
    grid = sc.Grid(8, 8, 1e-3, 1e-3)
    gap = sc.surfaces.paraboloid(grid, 0.1)
    found = sc.sliding.steady(grid, RIGID, RUBBER, gap, load=0.0, velocity=0.05)
    assert (found.pressure == 0).all()
    assert found.friction == found.power == 0.0


@pytest.mark.parametrize(
    ("change", "error", "text"),
    [
        ({"velocity": np.inf}, ValueError, "velocity must be"),
        ({"velocity": None}, TypeError, "velocity must be"),
        ({"body2": RUBBER.with_relaxation([1.0], [1.0])}, ValueError, "body2 must be a solid"),
        ({"body2": 1.0}, TypeError, "body2 must be a samcontact.Material, samcontact.Layered or"),
        ({"body2": RIGID}, ValueError, "both rigid"),
        ({"load": None}, ValueError, "load"),
        ({"start": 1.0}, TypeError, "start must be"),
    ],
)
def test_bad_input(change, error, text):
    grid = sc.Grid(8, 8, 1e-3, 1e-3)
    arguments = {
        "grid": grid, "body1": RIGID, "body2": RUBBER, "gap": sc.surfaces.paraboloid(grid, 0.1),
        "load": 0.5, "velocity": 0.05,
    } | change  # fmt: skip
    with pytest.raises(error, match=text):
        sc.sliding.steady(**arguments)


def test_white_noise_on_nearly_liquid_rubber_is_continued_from_higher_velocities():
    """The reference converges without continuation, in 1143 iterations."""
    n = 32
    grid = sc.Grid(n, n, 1e-3 / n, 1e-3 / n, periodic="xy")
    gap = 1e-6 * np.random.default_rng(0).standard_normal((n, n))
    body = sc.Material.elastic(1e8, 0.4).with_relaxation(times=[1e-3, 0.1], shares=[0.4995] * 2)
    given = grid, sc.Material.elastic(2e11, 0.3), body, gap
    drive = {"load": 0.1, "velocity": 1e-4}
    direct = sc.sliding.steady(*given, **drive)
    found = sc.sliding.steady(*given, **drive, max_iterations=900)
    assert found.friction == pytest.approx(direct.friction, rel=1e-7)
    assert np.abs(found.pressure - direct.pressure).max() < 1e-6 * found.pressure.max()
    with pytest.raises(sc.ConvergenceError, match=r"did not converge at load 0\.1 N"):
        sc.sliding.steady(*given, **drive, max_iterations=5)


def test_wave_on_a_coated_body():
    """In full contact each wave has the compliance of the layers times the factor of creep."""
    relaxing = {"times": [2e-2], "shares": [0.6]}
    grid = sc.Grid(64, 1, 0.1 / 64, 0.1, periodic="xy")
    q, speed, height = 20 * np.pi, 0.4, 1e-4
    gap = height * (1 - np.cos(q * grid.x))[:, None]
    elastic = sc.Layered([(sc.Material.elastic(1e7, 0.4), 1e-2)], sc.Material.elastic(5e7, 0.3))
    layers = [(material.with_relaxation(**relaxing), h) for material, h in elastic.layers]
    coated = sc.Layered(layers, elastic.substrate.with_relaxation(**relaxing))
    found = sc.sliding.steady(grid, RIGID, coated, gap, load=900.0, velocity=speed)
    assert (found.pressure > 0).all()
    top = layers[0][0]
    loss = top.loss(q * speed) / top.E / elastic.wave_compliance(q)
    expected = 0.5 * q * height**2 * loss * 0.01
    assert found.tangential_load[0] == pytest.approx(float(expected), rel=1e-3)
