# SPDX-License-Identifier: GPL-3.0-or-later
"""Mixed lubrication: dry limit of smooth and rough surfaces, and the error of small shares."""

import warnings

import numpy as np
import pytest

import samcontact as sc

E_STAR, R, ETA, ALPHA = 113.74e9, 0.01, 0.04, 22e-9
STEEL = sc.Material.elastic(2 * E_STAR * 0.91, 0.3)
OIL = sc.Lubricant.roelands(ETA, ALPHA)
LOAD = 36.2974  # M 200, L 10 at 0.453 m/s
RADIUS = (0.75 * LOAD * R / E_STAR) ** (1 / 3)
PEAK = 1.5 * LOAD / (np.pi * RADIUS**2)
films = sc.lubrication


def ball(cells):
    grid = sc.Grid(cells, cells, 4 * RADIUS / cells, 4 * RADIUS / cells)
    return grid, 0.5 * (grid.x[:, None] ** 2 + grid.y**2) / R


def egg_box(grid):
    waves = (np.cos(4 * np.pi * s / RADIUS) for s in (grid.x[:, None], grid.y))
    return 1e-7 * np.prod(np.broadcast_arrays(*waves), axis=0)


def self_affine(grid, rms, fewest=8):
    """Return heights with a Hurst exponent of 0.8 and waves of at least a number of cells [m]."""
    n = grid.nx
    k = np.fft.fftfreq(n) * n
    waves = np.hypot(k[:, None], k)
    inside = (waves >= 2) & (waves <= n / fewest)
    amplitude = np.where(inside, np.maximum(waves, 1.0) ** -1.8, 0.0)
    noise = np.random.default_rng(1).standard_normal((n, n))
    heights = np.fft.ifft2(amplitude * np.fft.fft2(noise)).real
    return rms * heights / heights.std()


def curve(grid, gap, speeds, thickness, order=1, load=LOAD, pressure=None):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return films.stribeck(
            grid, STEEL, STEEL, gap, load=load, speeds=speeds, lubricant=OIL, order=order,
            boundary=films.Boundary(thickness, pressure=pressure),
        )  # fmt: skip


def difference(found, number=0):
    """Return the relative difference of a pressure to that of the dry contact."""
    dry = found.dry_pressure
    return np.linalg.norm(found.solutions[number].pressure - dry) / np.linalg.norm(dry)


def test_a_rough_ball_opens_from_the_dry_contact():
    """Egg-box roughness of 0.1 um; shares and differences to dry of other code, order 1."""
    grid, smooth = ball(32)
    speeds = [4.533e-7, 3.305e-4, 9.914e-4, 8.922e-3]
    found = curve(grid, smooth + egg_box(grid), speeds, 1e-9, pressure=PEAK)
    np.testing.assert_allclose(found.boundary_share, [1.0, 0.9529, 0.8426, 0.1968], atol=1e-3)
    differences = [difference(found, n) for n in range(4)]
    np.testing.assert_allclose(differences, [3.699e-3, 3.692e-3, 3.68e-3, 0.04667], rtol=2e-3)
    mean = [film.film[found.dry_pressure > 0].mean() for film in found.solutions]
    assert np.all(np.diff(mean) > 0)


def dry_limit(cells, rms, speeds):
    """Require the dry pressure for layers that become thin, and films that grow with speed."""
    grid, smooth = ball(cells)
    gap = smooth + self_affine(grid, rms)
    found = curve(grid, gap, speeds, 1e-9)
    thin, thick = (difference(curve(grid, gap, speeds[:1], h)) for h in (0.5e-9, 1e-9))
    assert found.boundary_share[0] > 0.999
    assert difference(found) == pytest.approx(thick, rel=1e-3)
    assert thick < 5e-3
    # the compliance of the layer is all that is left: extrapolated to no layer, the dry pressure
    assert thin / thick == pytest.approx(0.53, abs=0.04)
    assert abs(2 * thin - thick) < 0.1 * thick
    mean = [film.film[found.dry_pressure > 0].mean() for film in found.solutions]
    assert np.all(np.diff(mean) > 0)
    assert np.all(np.diff(found.boundary_share) < 0)
    return found


@pytest.mark.parametrize("rms", [5e-8, 3e-7])
def test_a_self_affine_surface_becomes_dry_as_the_speed_falls(rms):
    found = dry_limit(32, rms, [4.5e-7, 1e-4, 3e-3, 1e-2, 3e-2])
    assert np.any((found.boundary_share > 0.01) & (found.boundary_share < 0.3))


def line(cells, waves=0.0):
    """Return grid, gap and load of a line contact of 0.97 GPa; waves: amplitude [m]."""
    p0 = 0.97e9
    b = 2 * R * p0 / E_STAR
    grid = sc.Grid(cells, 1, 4 * b / cells, 1e-3, periodic="y")
    x = grid.x[:, None]
    gap = 0.5 * x**2 / R + waves * np.cos(2 * np.pi * x / (0.4 * b))
    return grid, gap, 0.5 * np.pi * b * p0 * 1e-3


@pytest.mark.parametrize(("waves", "truth"), [(0.0, (0.0133, 0.00095)), (3e-8, (0.0328, 0.00205))])
@pytest.mark.parametrize("order", [1, 3])
def test_errors_of_small_shares_are_stated(waves, truth, order):
    """The true shares are those of third order for thin films too, extrapolated from 768 cells."""
    for cells in (48, 96, 192):
        grid, gap, load = line(cells, waves)
        found = curve(grid, gap, [1e-4, 0.01, 0.03], 2e-9, order, load)
        assert np.isnan(found.share_error[0])
        for share, error, true in zip(
            found.boundary_share[1:], found.share_error[1:], truth, strict=True
        ):
            if share >= 1e-3:
                assert abs(share - true) <= error
            else:
                assert np.isnan(error)
    data = sc.results.films_dataset(found.solutions)
    back = sc.results.films_of(data)
    assert back[1].share_error == found.solutions[1].share_error
    assert back[0].share_error is None
    assert "±" in str(dict(found.solutions[1]._rows())["share of the boundary layer"])


def test_an_uncertain_share_is_told():
    grid, gap, load = line(96)
    with pytest.warns(sc.ResolutionWarning, match="the boundary layer bears"):
        film = films.steady(
            grid, STEEL, STEEL, gap, load=load, speed=(0.01, 0.01), lubricant=OIL,
            boundary=films.Boundary(2e-9),
        )  # fmt: skip
    assert film.share_error > 0.1 * film.boundary_share
    data = sc.results.films_dataset([film])
    (check,) = [c for c in sc.report.checks(data) if "share of the boundary layer" in c.name]
    assert not check.passed


def test_a_thick_layer_takes_few_linear_steps():
    """The fluid under a layer of 30 nm is a small difference of large pressures."""
    grid = sc.Grid(50, 48, 4.5 * RADIUS / 50, 4.35 * RADIUS / 48)
    gap = 0.5 * ((grid.x[:, None] - 0.75 * RADIUS) ** 2 + grid.y**2) / R
    found = curve(grid, gap, [0.1], 30e-9, order=3)
    (film,) = found.solutions
    assert 0.5 < film.boundary_share < 0.9
    assert film.levels[-1].krylov_steps < 25 * film.iterations
