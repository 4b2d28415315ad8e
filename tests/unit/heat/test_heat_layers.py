# SPDX-License-Identifier: GPL-3.0-or-later
"""Steady frictional heat in layered bodies: modes, coefficients, contacts, refused input."""

import json
import math
from pathlib import Path

import numpy as np
import pytest

import samcontact as sc
from samcontact import _core

REFERENCE = json.loads((Path(__file__).parents[2] / "oracles" / "heat_layers.json").read_text())
STACKS = ("coating", "three layers")
INF = np.inf


def material(E=1.0, nu=0.3, k=1.0, alpha=1.0, kappa=1.0):
    return sc.Material.elastic(E, nu).with_thermal(k, alpha, kappa)


def body_of(stack):
    """Return a body of the reference data."""
    made = [
        material(*(layer[n] for n in ("E", "nu", "conductivity", "expansion", "diffusivity")))
        for layer in stack["layers"]
    ]
    thickness = [layer["thickness"] for layer in stack["layers"][:-1]]
    return sc.Layered(list(zip(made[:-1], thickness, strict=True)), made[-1])


def heating(body, velocity=(0.0, 0.0), time=INF):
    """Return a heating for the core with unit flux per unit pressure."""
    layered = isinstance(body, sc.Layered)
    thermal = body.thermal if layered else [body.thermal]
    thickness = [h for _, h in body.layers] if layered else []
    return _core.Heating(1.0, thermal, thickness, *velocity, time, 1.0, False)


class Cell:
    """Fields around one heated cell of unit size with unit flux, without its pressure."""

    def __init__(self, body, nx=8, ny=8, velocity=(0.0, 0.0), at=(0, 0), time=INF, size=1.0):
        self.grid, self.body = sc.Grid(nx, ny, size, size), body
        self.heating = heating(body, velocity, time)
        self.flux = np.zeros((nx, ny))
        self.flux[at] = 1.0

    def temperature(self, z):
        return _core.operators.temperature(self.grid._core, self.heating, [z], self.flux)[..., 0]

    def stress(self, z):
        of = _core.operators.surface_stress
        hot, cold = (
            of(self.grid._core, self.body._core, h, [z], self.flux, None, None)[..., 0]
            for h in (self.heating, _core.Heating())
        )
        return hot - cold

    def displacement(self):
        of = _core.operators.surface_displacement
        hot, cold = (
            of(self.grid._core, self.body._core, h, self.flux, None, None, 2)
            for h in (self.heating, _core.Heating())
        )
        return hot - cold


@pytest.mark.parametrize("name", STACKS)
def test_modes_equal_those_of_a_transfer_matrix(name):
    body = body_of(REFERENCE[name])
    tops = [0.0, *body.interfaces]
    worst = np.zeros(3)
    for mode in REFERENCE[name]["modes"]:
        fields, expected = [], []
        for field in mode["fields"]:
            z = tops[field["layer"]] + field["below_its_top"]
            if field["layer"] < len(body.layers) and z >= tops[field["layer"] + 1]:
                z = np.nextafter(tops[field["layer"] + 1], 0.0)
            wave = _core.operators.heated_wave(
                body._core.stack, heating(body), [mode["q"]], [complex(*mode["rate"])], z
            )
            fields.append(wave[:5, 0])
            expected.append([complex(*v) for v in field["values"]])
            u = complex(*mode["u_z"])
            worst[2] = max(worst[2], abs(wave[5, 0] / u - 1))
        error = np.abs(np.array(fields) - expected)
        largest = np.abs(expected).max(axis=0)
        worst[0] = max(worst[0], (error[:, 0] / largest[0]).max())
        worst[1] = max(worst[1], error[:, 1:].max() / largest[1:].max())
    assert (worst < [1e-12, 1e-11, 1e-11]).all(), worst


@pytest.mark.parametrize("name", STACKS)
def test_steady_coefficients_equal_hankel_integrals(name):
    reference = REFERENCE[name]
    body, offsets = body_of(reference), np.array(reference["offsets"])
    cell = Cell(body, 41, 41)
    at = tuple(offsets.T)
    known = np.array(reference["T_surface"])
    assert np.abs(cell.temperature(0.0)[at] - known).max() < 1e-6 * known[0]
    u = cell.displacement()[at]
    known = np.array(reference["u_z_less_last"])
    assert np.abs(u - u[-1] - known).max() < 1e-8 * np.abs(known).max()
    for depth in reference["depths"][1:3]:  # both sides of the first interface
        z = depth["z"] if depth["layer"] else np.nextafter(depth["z"], 0.0)
        T, s = cell.temperature(z)[at], cell.stress(z)
        assert np.abs(T - depth["T"]).max() < 1e-6 * max(depth["T"])
        largest = np.abs(depth["s_xx"]).max()
        assert np.abs(s[0][at] - depth["s_xx"]).max() < 1e-7 * largest
        assert np.abs(s[2][at] - depth["s_zz"]).max() < 1e-7 * largest


def images(cell, ratio, h, z, count):
    """Return the temperature of a layer on a substrate by images of the source.

    ratio: (k_1 - k_s)/(k_1 + k_s) with the conductivities of layer and substrate.
    """
    k = cell.body.thermal[0][0]
    x, y = np.meshgrid(np.arange(cell.grid.nx), np.arange(cell.grid.ny), indexing="ij")
    a, b = 0.5 * cell.grid.dx, 0.5 * cell.grid.dy

    def of(depth):
        return sc.heat_kernels.steady_temperature(
            x * cell.grid.dx, y * cell.grid.dy, depth, a, b, conductivity=k
        )

    terms = [
        ratio**n * (of(2 * n * h + z) + (of(2 * n * h - z) if n else 0.0)) for n in range(count)
    ]
    sums = np.cumsum(terms, axis=0)
    while ratio < 0 and len(sums) > 1:  # Euler's transformation of an alternating series
        sums = 0.5 * (sums[1:] + sums[:-1])
    return sums[-1]


@pytest.mark.parametrize(
    ("substrate", "h", "count"),
    [(0.05, 2.0, 300), (20.0, 2.0, 40), (20.0, 0.2, 60), (1e13, 0.7, 60), (0.2, 0.2, 60)],
    ids=["conducting", "insulating", "thin, insulating", "cold substrate", "thin, conducting"],
)
def test_temperature_of_one_layer_equals_that_of_images(substrate, h, count):
    body = sc.Layered([(material(E=3.0, kappa=0.1), h)], material(k=substrate))
    cell = Cell(body, 6, 5)
    ratio = (1 - substrate) / (1 + substrate)
    for z in (0.0, 0.6 * h):
        expected = images(cell, ratio, h, z, count)
        error = np.abs(cell.temperature(z) - expected).max()
        assert error < 1e-7 * np.abs(images(cell, ratio, h, 0.0, count)).max(), (z, error)


def gaussian_fields(time, size):
    """Return T, u_z, and s_xx + s_yy at three depths at the centre of the flux exp(-r^2)."""
    n = round(4.5 / size)
    cell = Cell(body_of(REFERENCE["coating"]), 2 * n + 1, 2 * n + 1, time=time, size=size)
    edges = size * (np.arange(2 * n + 2) - n - 0.5)
    mean = np.diff([np.sqrt(np.pi) / 2 * math.erf(x) for x in edges]) / size
    cell.flux = np.outer(mean, mean)
    found = [cell.temperature(0.0), cell.displacement()]
    for z in (0.0, np.nextafter(2.0, 0.0), 2.0):
        stress = cell.stress(z)
        found.append(stress[0] + stress[1])
    return np.array([field[n, n] for field in found])


@pytest.mark.parametrize("number", [0, pytest.param(1, marks=pytest.mark.slow), 2])
def test_fields_since_a_time_equal_hankel_integrals(number):
    known = REFERENCE["Gaussian flux on the coating"][number]
    stress = "s_rr_plus_s_tt_"
    names = ["T_surface", "u_z", *(stress + at for at in ("surface", "interface_above",
             "interface_below"))]  # fmt: skip
    expected = np.array([known[name] for name in names])
    coarse, fine = (gaussian_fields(known["t"], size) for size in (0.3, 0.15))
    error = np.abs((4 * fine - coarse) / 3 - expected)
    largest = np.abs(expected)[[0, 1, 2, 2, 2]]
    # The cells represent the flux at the surface to the fourth order of their size.
    assert (error < np.array([3e-3, 3e-3, 3e-3, 1e-5, 1e-5]) * largest).all(), error / largest


def test_heat_since_a_long_time_is_that_of_the_steady_state():
    steady, late = (Cell(body_of(REFERENCE["coating"]), time=time) for time in (INF, 1e10))
    for of in (lambda c: c.temperature(1.0), lambda c: c.stress(1.0), lambda c: c.stress(2.0)):
        known = of(steady)
        assert np.abs(of(late) - known).max() < 1e-5 * np.abs(known).max()


COATED = sc.Layered([(material(4.0, 0.25, 0.05, 0.6, 0.02), 2.0)], material())


def test_coefficients_turn_with_the_direction_of_motion():
    along_x = Cell(COATED, 9, 3, (3.0, 0.0), at=(4, 1))
    against_y = Cell(COATED, 3, 9, (0.0, -3.0), at=(1, 4))

    def of(cell):
        return [cell.temperature(1.0), cell.displacement(), *cell.stress(1.0)]

    fields = of(along_x)
    # Mirrored in x, then x and y exchanged: odd are xz and xy.
    order, signs = [0, 1, 3, 2, 4, 6, 5, 7], [1, 1, 1, 1, 1, -1, 1, -1]
    for found, n, sign in zip(of(against_y), order, signs, strict=True):
        assert np.abs(found - sign * fields[n][::-1].T).max() < 1e-12 * np.abs(fields[2]).max()


def graded(highest, extent, least, nodes=12):
    """Return Gauss panels on (0, highest), halved towards zero until `least`."""
    edges = [highest]
    while edges[-1] > least:
        edges.append(max(edges[-1] / 2, edges[-1] - 12 / extent))
    edges = np.array([*edges, 0.0])[::-1]
    at, weight = np.polynomial.legendre.leggauss(nodes)
    half = np.diff(edges)[:, None] / 2
    return (edges[:-1, None] + half * (at + 1)).ravel(), (half * weight).ravel()


@pytest.mark.parametrize(
    "speed",
    [pytest.param(0.02, marks=pytest.mark.slow), 20.0, pytest.param(2e3, marks=pytest.mark.slow)],
)
def test_moving_coefficients_equal_plain_sums_over_wavenumbers(speed):
    # The whole modes below the surface, without closed forms: another quadrature in both axes.
    x, y, z = np.array([-4.0, -1.0, 0.0, 1.0, 4.0]), np.array([0.0, 1.0]), 2.5
    kx, wx = graded(42 / z, 6.0, 1e-9)
    ky, wy = graded(42 / z, 6.0, 1e-6)
    KX, KY = (k.ravel() for k in np.meshgrid(kx, ky, indexing="ij"))
    q = np.hypot(KX, KY)
    wave = _core.operators.heated_wave(COATED._core.stack, heating(COATED), q, 1j * speed * KX, z)
    spread = np.sinc(KX / (2 * np.pi)) * np.sinc(KY / (2 * np.pi)) * np.outer(wx, wy).ravel()
    c2 = (KX / q) ** 2
    modes = [wave[0], wave[1] * c2 + wave[2] * (1 - c2), wave[3], -1j * wave[4] * KX / q]
    turn, fy = np.exp(1j * np.outer(x, kx)), np.cos(np.outer(ky, y))
    known = [(turn @ (spread * m).reshape(len(kx), -1) @ fy).real / np.pi**2 for m in modes]
    cell = Cell(COATED, 9, 3, (speed, 0.0), at=(4, 0))
    T, s = cell.temperature(z), cell.stress(z)
    at = np.ix_((x + 4).astype(int), y.astype(int))
    top = cell.temperature(0.0).max()
    assert np.abs(T[at] - known[0]).max() < 2e-7 * top
    largest = np.abs(s).max()
    for found, expected in zip((s[0], s[2], s[4]), known[1:], strict=True):
        assert np.abs(found[at] - expected).max() < 1e-6 * largest


@pytest.mark.parametrize(
    "velocity", [(0.02, 0.05), pytest.param((-3.0, 0.4), marks=pytest.mark.slow)]
)
def test_coefficients_in_oblique_motion_equal_polar_sums_over_wavenumbers(velocity):
    """The angle is graded towards the direction across the motion; the axes are those of it."""
    x, y, z = np.array([-4.0, -1.0, 0.0, 2.0]), np.array([-2.0, 0.0, 1.0]), 2.5
    speed = np.hypot(*velocity)
    c, s = velocity / speed
    q, wq = graded(42 / z, 6.0, 1e-6)
    turn, wt = graded(np.pi / 2, 12.0, 1e-5)
    along = np.concatenate([np.sin(turn), np.sin(turn)])
    across = np.concatenate([np.cos(turn), -np.cos(turn)])
    Q, U = (k.ravel() for k in np.meshgrid(q, along, indexing="ij"))
    W = np.outer(q, across).ravel()
    U *= Q
    KX, KY = c * U - s * W, s * U + c * W
    weight = np.outer(wq * q, np.concatenate([wt, wt])).ravel() / (2 * np.pi**2)
    weight = weight * np.sinc(KX / (2 * np.pi)) * np.sinc(KY / (2 * np.pi))
    wave = _core.operators.heated_wave(COATED._core.stack, heating(COATED), Q, 1j * speed * U, z)
    cx, cy = KX / Q, KY / Q
    modes = [wave[0], wave[1] * cx**2 + wave[2] * cy**2, wave[3], -1j * wave[4] * cx]
    modes += [-1j * wave[4] * cy, cx * cy * (wave[1] - wave[2])]
    cell = Cell(COATED, 9, 5, velocity, at=(4, 2))
    T, stress = cell.temperature(z), cell.stress(z)
    found = [T, stress[0], stress[2], stress[4], stress[3], stress[5]]
    scales = [cell.temperature(0.0).max(), *[np.abs(stress).max()] * 5]
    for i, j in [(0, 0), (1, 1), (3, 2)]:
        phase = weight * np.exp(1j * (KX * x[i] + KY * y[j]))
        for field, mode, scale in zip(found, modes, scales, strict=True):
            value = field[int(x[i] + 4), int(y[j] + 2)]
            assert abs(value - (phase * mode).sum().real) < 1e-6 * scale


def test_slow_motion_is_rest_and_fast_motion_keeps_heat_in_the_coating():
    rest = Cell(COATED, 6, 3)
    slow = Cell(COATED, 11, 3, (1e-9, 0.0), at=(5, 0))
    scale = rest.temperature(0.0).max()
    assert np.abs(slow.temperature(1.0)[5:] - rest.temperature(1.0)).max() < 1e-6 * scale
    u = [cell.displacement() for cell in (rest, slow)]
    u = [v - v[-1, -1] for v in u]
    assert np.abs(u[1][5:] - u[0]).max() < 1e-5 * np.abs(u[0]).max()
    fast = Cell(COATED, 11, 3, (10.0, 0.0), at=(5, 0)).temperature(0.0)
    own = Cell(COATED.layers[0][0], 11, 3, (10.0, 0.0), at=(5, 0)).temperature(0.0)
    assert np.abs(fast - own).max() < 1e-9 * own.max()
