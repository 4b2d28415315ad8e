# SPDX-License-Identifier: GPL-3.0-or-later
"""Periodic surfaces against closed forms and published numbers: wavy surfaces, a line contact.

Westergaard (1939), J. Appl. Mech. 6, A49, as in Johnson (1985), section 13.2; the numbers of the
wave in two directions are those of Johnson, Greenwood & Higginson (1985), Int. J. Mech. Sci. 27,
383, and of Yastrebov, Anciaux & Molinari (2014), Tribology Letters 56, 171.
"""

import numpy as np
import pytest

import samcontact as sc
from samcontact import hertz, surfaces

BODY, RIGID = sc.Material.elastic(210e9, 0.3), sc.Material.rigid()
E_STAR = hertz.effective_modulus(BODY, RIGID)
PERIOD, AMPLITUDE = 1e-3, 1e-6
TABLE = "Periodic surfaces"


def wave_grid(n, ny=None):
    return sc.Grid(n, ny or n, PERIOD / n, PERIOD / n, periodic="xy")


def westergaard(x, share):
    """Return half-width and maximum pressure over p* of a wave at a fraction of p*."""
    if share >= 1:
        return PERIOD / 2, share + np.cos(2 * np.pi * x / PERIOD)
    half = PERIOD / np.pi * np.arcsin(np.sqrt(share))
    inside = np.maximum(np.sin(np.pi * half / PERIOD) ** 2 - np.sin(np.pi * x / PERIOD) ** 2, 0)
    crest = 2 * share * np.cos(np.pi * x / PERIOD) / np.sin(np.pi * half / PERIOD) ** 2
    return half, crest * np.sqrt(inside)


@pytest.mark.parametrize("ny", [1, 4])
@pytest.mark.parametrize("share", [0.1, 0.5, 0.9, 1.2])
def test_wave(share, ny, measured):
    grid = wave_grid(256, ny)
    gap = AMPLITUDE * (1 - np.cos(2 * np.pi * grid.x / PERIOD))[:, None] + np.zeros(ny)
    full = np.pi * E_STAR * AMPLITUDE / PERIOD
    load = share * full * PERIOD * ny * grid.dy
    pressure = sc.ContactSolver(grid, BODY, RIGID).solve(gap, load=load).pressure / full
    assert np.ptp(pressure, axis=1).max() < 1e-7
    half, exact = westergaard(grid.x, share)
    rms = np.sqrt(np.mean((pressure[:, 0] - exact) ** 2))
    assert abs(np.count_nonzero(pressure[:, 0]) - 2 * half / grid.dx) <= 1
    if ny == 1:
        measured.close(TABLE, f"wave, p/p* = {share}: rms error of p/p*", rms, 0.0, abs=2e-3,
                       mesh="L/256")  # fmt: skip


JGH = {0.05: (0.113, None), 0.2: (0.345, 1.0955), 0.5: (0.704, 1.4793), 0.9: (0.951, None)}


@pytest.mark.parametrize("share", JGH)
def test_wave_in_two_directions(share, measured):
    n = 512
    grid = wave_grid(n)
    gap = -AMPLITUDE * np.outer(*(np.cos(2 * np.pi * s / PERIOD) for s in (grid.x, grid.y)))
    full = np.sqrt(2) * np.pi * E_STAR * AMPLITUDE / PERIOD
    solver = sc.ContactSolver(grid, BODY, RIGID)
    solution = solver.solve(gap - gap.min(), load=share * full * PERIOD**2)
    pressure, area = solution.pressure, solution.contact_area / PERIOD**2
    known, largest = JGH[share]
    case = f"wave in x and y, p/p* = {share}"
    measured.close(TABLE, f"{case}: real contact area / nominal area", area, known, rel=5e-3,
                   mesh="L/512")  # fmt: skip
    if largest is not None:
        measured.close(TABLE, f"{case}: maximum pressure over p*", pressure.max() / full, largest,
                       rel=5e-3, mesh="L/512")  # fmt: skip


def test_line_contact(measured):
    radius, line_load, cells = 10e-3, 2e5, 64
    half = 2 * np.sqrt(line_load * radius / (np.pi * E_STAR))
    n = 4 * cells
    grid = sc.Grid(n, 1, half / cells, 1e-3, periodic="y")
    solver = sc.ContactSolver(grid, BODY, RIGID)
    gap = surfaces.paraboloid(grid, radius, np.inf)
    found = solver.solve(gap, load=line_load * grid.dy)
    peak = 2 * line_load / (np.pi * half)
    measured.close(TABLE, "line contact: maximum pressure", found.pressure.max() * 1e-9,
                   peak * 1e-9, unit="GPa", rel=1e-3, mesh="a/64")  # fmt: skip
    # a line load displaces nothing at the distance n dx
    approach = line_load / (np.pi * E_STAR) * (2 * np.log(2 * n * grid.dx / half) + 1)
    measured.close(TABLE, "line contact: approach", found.approach * 1e6, approach * 1e6,
                   unit="µm", rel=1e-3, mesh="a/64")  # fmt: skip
    again = solver.solve(gap, approach=found.approach)
    assert again.load == pytest.approx(found.load, rel=1e-6)
    depth = 0.78 * half
    stress = solver.stress(found.pressure, [depth], 1)[:, n // 2, 0, 0]
    # largest shear stress, 0.30 p0 at 0.78 a (Johnson 1985, eq. 4.47)
    assert 0.5 * (stress[0] - stress[2]) == pytest.approx(0.3003 * peak, rel=2e-3)


def test_tends_to_the_free_contact_as_the_period_grows():
    radius, load = 10e-3, 50.0
    a = hertz.point(radius, E_STAR, load=load).a
    errors = []
    for periods in (4, 8, 16):
        n = 12 * periods
        free, joined = (sc.Grid(n, n, a / 12, a / 12, periodic=p) for p in ("", "xy"))
        gap = surfaces.sphere(free, radius)
        peaks = [sc.ContactSolver(g, BODY, RIGID).solve(gap, load=load).pressure.max()
                 for g in (free, joined)]  # fmt: skip
        errors.append(peaks[1] / peaks[0] - 1)
    # the neighbours' pressure is missing in the curvature that they give: 1/r^3
    assert 0 < errors[1] < 3e-3
    assert np.log2(np.array(errors[:-1]) / errors[1:]) == pytest.approx([3, 3], abs=0.15)
