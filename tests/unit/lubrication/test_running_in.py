# SPDX-License-Identifier: GPL-3.0-or-later
"""Wear by the boundary layer: Archard's volume, path independence of the film, smoothing."""

import warnings

import numpy as np
import pytest

import samcontact as sc

STEEL = sc.Material.elastic(207e9, 0.3)
OIL = sc.Lubricant.roelands(viscosity=0.04, pressure_viscosity=20e-9).with_eyring(5e6)
R, LOAD, LENGTH = 0.01, 100.0, 1e-3  # a line contact of 0.77 GPa
B = sc.hertz.line(R, 113.7e9, load_per_length=LOAD / LENGTH).b
GRID = sc.Grid(128, 1, 4.5 * B / 128, LENGTH, periodic="y")
X = GRID.x - 0.75 * B
LAYER = sc.lubrication.Boundary(4e-9, 0.12, pressure=0.8e9)


def gap(roughness):
    waves = roughness * (1 - np.cos(2 * np.pi * X / (0.4 * B)))
    return (0.5 * X**2 / R + waves)[:, None]


def mixed(gap, speeds):
    """Return the film at the last of several speeds of body 1, from the dry contact."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return sc.lubrication.stribeck(
            GRID, STEEL, STEEL, gap, load=LOAD, speeds=[0.5 * u for u in speeds], order=1,
            slide_to_roll=2.0, lubricant=OIL, boundary=LAYER,
        ).solutions[-1]  # fmt: skip


def test_a_nearly_dry_contact_wears_by_archards_law():
    """The volume is the coefficient times load and distance, where the layer bears all."""
    film = mixed(gap(0.0), [2e-5])
    assert film.boundary_share > 0.99
    worn = sc.lubrication.running_in(film, archard=1e-15, duration=2e4, steps=12)
    assert worn.volume[-1] == pytest.approx(1e-15 * LOAD * 2e-5 * 2e4, rel=1e-2)
    np.testing.assert_allclose(worn.time, np.linspace(0.0, 2e4, 13))
    shares = worn.boundary_share[:-1]
    assert worn.volume[-1] == pytest.approx(
        float(1e-15 * 2e-5 * (2e4 / 12) * (shares * LOAD).sum()), rel=1e-5
    )


def test_a_rough_surface_runs_in():
    """Peaks wear, and the fluid takes over; the film is that of the worn gap from the dry side."""
    rough, speeds = gap(30e-9), [1e-4, 1e-3, 4e-3]
    film = mixed(rough, speeds)
    assert 0.2 < film.boundary_share < 0.9
    worn = sc.lubrication.running_in(film, archard=1e-15, duration=24.0, steps=12)
    share = worn.boundary_share
    assert np.all(np.diff(share) < 0)
    assert share[-1] < 0.9 * share[0]
    inside = np.abs(X) < B
    peaks = (rough - 0.5 * X[:, None] ** 2 / R)[:, 0] < 5e-9
    depth = worn.depth[-1][:, 0]
    assert depth[inside & peaks].mean() > 1.3 * depth[inside & ~peaks].mean()
    again = mixed(rough + worn.depth[-1], speeds)
    assert again.boundary_share == pytest.approx(share[-1], rel=1e-3)
    np.testing.assert_allclose(again.film, worn.films[-1].film, rtol=1e-4)


def test_wrong_arguments_are_refused():
    film = mixed(gap(0.0), [2e-5])
    given = {"archard": 1e-15, "duration": 2e4, "steps": 12}
    with pytest.raises(ValueError, match="body 1, which wears, must be at rest"):
        sc.lubrication.running_in(film, worn=1, **given)
    with pytest.raises(ValueError, match=r"steps must be at least \d+, so that each"):
        sc.lubrication.running_in(film, **given | {"archard": 1e-12})
    with pytest.raises(ValueError, match="worn must be"):
        sc.lubrication.running_in(film, worn=3, **given)
