# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of inclusions show the places, shares and lives that they are given."""

import numpy as np
import pytest
from matplotlib.figure import Figure

import samcontact as sc
from samcontact import plotting
from samcontact.inclusions import ButterflyMap

STEEL = sc.Material.elastic(210e9, 0.3)
TURNED = np.array([[0.8, 0.0, 0.6], [0.0, 1.0, 0.0], [-0.6, 0.0, 0.8]])
BODY = sc.Heterogeneous(
    STEEL,
    [
        sc.Inclusion.ellipsoid((1e-5, 2e-6, 4e-5), (2e-5, 1e-5, 1.2e-5), STEEL, axes=TURNED),
        sc.Inclusion.void((-3e-5, 0.0, 3e-5), 1e-5),
        sc.Inclusion.void((0.0, 5e-5, 3e-5), 1e-5),
    ],
)
GRID = sc.Grid(40, 20, 2.5e-6, 2.5e-6, nz=24, dz=2.5e-6)


def panel():
    ax = Figure().subplots()
    ax.set(xlim=(-50, 50), ylim=(60, 0))
    return ax


@pytest.mark.parametrize("position", [0.0, 5e-6])
def test_outlines_are_the_sections_of_the_ellipsoids(position):
    ax = plotting.inclusion_outlines(BODY, panel(), position=position)
    assert len(ax.lines) == 2  # the third is off the section
    for line, inclusion in zip(ax.lines, BODY.inclusions, strict=False):
        x, z = line.get_data()
        points = np.stack([x * 1e-6, np.full_like(x, position), z * 1e-6], axis=1)
        apart = points - np.array(inclusion.center)
        metric = np.einsum("ni,ij,nj->n", apart, inclusion.metric(), apart)
        np.testing.assert_allclose(metric, 1.0, rtol=1e-9)
    assert ax.lines[0].get_linestyle() == "-"
    assert ax.lines[1].get_linestyle() != "-"
    assert ax.get_xlim() == (-50, 50)


def test_the_plane_x_and_the_surface_cut_an_inclusion():
    body = sc.Heterogeneous(STEEL, [sc.Inclusion.sphere((0.0, 0.0, 5e-6), 1e-5, STEEL)])
    ax = plotting.inclusion_outlines(body, panel(), plane="x")
    y, z = ax.lines[0].get_data()
    assert np.nanmin(z) >= 0.0
    assert np.nanmax(np.abs(y)) == pytest.approx(10.0, rel=1e-3)
    assert np.isnan(z).any()


def test_partly_filled_cells_are_hatched():
    share = BODY.fraction_on(GRID)
    ax = plotting.inclusion_outlines(BODY, panel(), position=1e-6, share=share, grid=GRID)
    (hatched,) = (c for c in ax.collections if c.get_hatch() or getattr(c, "hatches", [None])[0])
    row = int(np.abs(GRID.y - 1e-6).argmin())
    cut = (share[:, row] > 0) & (share[:, row] < 1)
    path = hatched.get_paths()[0]
    for i, k in np.argwhere(cut)[::5]:
        assert path.contains_point((GRID.x[i] * 1e6, (k + 0.5) * 2.5))
    for i, k in np.argwhere(share[:, row] == 0)[::97]:
        assert not path.contains_point((GRID.x[i] * 1e6, (k + 0.5) * 2.5))


def test_a_butterfly_map_shows_places_and_the_criterion():
    angle = -np.pi + 2 * np.pi * (np.arange(8) + 0.5) / 8
    of = ButterflyMap(angle, np.array([0, 3, 0, 0, 1, 0, 0, 0]), np.linspace(0.6, 1.0, 8), (0,) * 4)
    ax = plotting.butterfly(of)
    assert [bar.get_height() for bar in ax.patches] == [0, 1, 0, 0, 1 / 3, 0, 0, 0]
    np.testing.assert_array_equal(ax.lines[0].get_ydata()[:-1], of.relative)
    with pytest.raises(TypeError, match="ax must be polar axes"):
        plotting.butterfly(of, panel())


def test_weibull_paper_makes_the_distribution_a_line():
    fits = {
        "clean": sc.inclusions.weibull_fit([3e6, 5e6, 9e6, 2e7]),
        "dirty": sc.inclusions.weibull_fit([1e6, 2e6, 2.5e6, 6e6]),
    }
    ax = plotting.weibull(fits, label="passes")
    assert ax.get_xlabel() == "passes"
    for fit, line in zip(fits.values(), ax.lines[1::2], strict=True):
        x, y = line.get_data()
        slope = np.diff(y) / np.diff(np.log(x))
        np.testing.assert_allclose(slope, fit.shape, rtol=1e-9)
    points = ax.lines[0].get_data()
    np.testing.assert_array_equal(points[0], [3e6, 5e6, 9e6, 2e7])
    shown = [text.get_text() for text in ax.get_legend().get_texts()]
    assert shown[0].startswith("clean, slope")
    assert "slope" in plotting.weibull(fits["clean"]).get_legend().get_texts()[0].get_text()


@pytest.mark.parametrize(
    ("make", "error", "text"),
    [
        (lambda: plotting.inclusion_outlines(STEEL, panel()), TypeError, "body must be a"),
        (
            lambda: plotting.inclusion_outlines(BODY, panel(), share=np.zeros((2, 2, 2))),
            ValueError,
            "grid must be the grid of share",
        ),
        (
            lambda: plotting.inclusion_outlines(
                BODY, panel(), share=np.zeros((2, 2, 2)), grid=GRID
            ),
            ValueError,
            r"share must have shape \(40, 20, nz\)",
        ),
        (lambda: plotting.butterfly(STEEL), TypeError, "of must be a"),
        (lambda: plotting.weibull([STEEL]), TypeError, "fits must be a"),
    ],
)
def test_invalid_arguments_are_refused(make, error, text):
    with pytest.raises(error, match=text):
        make()
