# SPDX-License-Identifier: GPL-3.0-or-later
"""Inclusions: filled shares of cells, mixed moduli, refused places and sizes."""

import copy
import pickle
import warnings

import numpy as np
import pytest

import samcontact as sc
from samcontact.bodies.inclusion_cells import blocks_on, box_of

STEEL = sc.Material.elastic(210e9, 0.3)
ALUMINA = sc.Material.elastic(390e9, 0.25)
SULPHIDE = sc.Material.elastic(120e9, 0.3)
PLACE = (0.3e-6, -0.2e-6, 20.1e-6)
GRID = sc.Grid(31, 29, 1e-6, 1e-6, dz=1e-6)
TURNED = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))[0]


def body(*inclusions, matrix=STEEL):
    return sc.Heterogeneous(matrix, list(inclusions))


def sphere(radius=8e-6, material=ALUMINA, center=PLACE, **kind):
    return sc.Inclusion.sphere(center, radius, material, **kind)


@pytest.mark.parametrize(
    ("inclusion", "size"),
    [
        (sphere(), (1e-6, 1e-6, 1e-6)),
        (sphere(), (1e-6, 1.7e-6, 0.6e-6)),
        (
            sc.Inclusion.ellipsoid(PLACE, (8e-6, 6e-6, 5e-6), ALUMINA, axes=TURNED),
            (1e-6, 0.8e-6, 1.2e-6),
        ),
    ],
)
def test_shares_have_the_volume_and_centre_of_the_ellipsoid(inclusion, size):
    grid = sc.Grid(41, 41, size[0], size[1], dz=size[2])
    share = body(inclusion).fraction_on(grid)
    volume = np.prod(size) * share.sum()
    assert volume == pytest.approx(inclusion.volume, rel=1e-10)
    centres = (grid.x[:, None, None], grid.y[:, None], grid.depths(share.shape[2]))
    found = [(share * at).sum() / share.sum() for at in centres]
    assert found == pytest.approx(inclusion.center, abs=2e-3 * size[0])
    assert share.min() == 0.0
    assert share.max() == 1.0


def test_shares_of_single_cells_agree_with_caps_and_slabs():
    """Cells as wide as the sphere: the shares of its layers are volumes of spherical segments."""
    R = 4e-6
    grid = sc.Grid(1, 1, 8e-6, 8e-6, dz=1e-6)
    inclusion = sc.Inclusion.sphere((0.0, 0.0, 5.5e-6), R, ALUMINA)
    cells = body(sphere(32e-6, center=(0.0, 0.0, 40e-6)))  # the grid below is coarse for R only
    assert cells.cells_per_radius(grid) == pytest.approx(4.0)
    box = box_of(grid, [inclusion])
    ((_, _, share),) = blocks_on(grid, box, [inclusion])
    edges = np.clip(np.arange(1, 11) * 1e-6 - 5.5e-6, -R, R)
    segment = np.pi * np.diff(R**2 * edges - edges**3 / 3)
    assert share[0, 0] * 64e-18 == pytest.approx(segment, rel=1e-9)


def test_shares_of_cut_cells_agree_with_points():
    R, grid = 4e-6, sc.Grid(13, 13, 1e-6, 1e-6, dz=1e-6)
    inclusion = sc.Inclusion.ellipsoid((0.2e-6, 0.0, 6.1e-6), (R, R, 5e-6), ALUMINA, axes=TURNED)
    share = body(inclusion).fraction_on(grid)
    cut = np.argwhere((share > 0) & (share < 1))[::9]
    fine = (np.arange(50) + 0.5) / 50 - 0.5
    points = 1e-6 * np.stack(np.meshgrid(fine, fine, fine, indexing="ij"), -1).reshape(-1, 3)
    for i, j, k in cut:
        middle = np.array([grid.x[i], grid.y[j], (k + 0.5) * 1e-6])
        at = points + middle - np.array(inclusion.center)
        counted = (np.einsum("ni,ij,nj->n", at, inclusion.metric(), at) <= 1).mean()
        assert share[i, j, k] == pytest.approx(counted, abs=3e-3)


@pytest.mark.parametrize("axes", [None, TURNED])
def test_mirrored_inclusions_have_mirrored_cells(axes):
    """To every digit if the axes are those of the grid."""
    inclusion = sc.Inclusion.ellipsoid(PLACE, (7e-6, 5e-6, 6e-6), ALUMINA, axes=axes)
    flip = np.array([-1.0, 1.0, 1.0])
    mirrored = sc.Inclusion.ellipsoid(
        flip * inclusion.center, inclusion.radii, ALUMINA, axes=inclusion.axes * flip
    )
    first, second = (body(one).fraction_on(GRID) for one in (inclusion, mirrored))
    np.testing.assert_allclose(first[::-1], second, atol=0.0 if axes is None else 2e-12)


def moduli(material):
    return material.E / 3 / (1 - 2 * material.nu), material.E / 2 / (1 + material.nu)


@pytest.mark.parametrize("material", [ALUMINA, SULPHIDE, sc.Material.elastic(220e9, 0.1)])
def test_cells_are_mixed_by_voigt_and_reuss(material):
    """The last material has a smaller bulk modulus and a larger shear modulus than the matrix."""
    cells = body(sphere(material=material, misfit=-2e-3)).cells_on(GRID)
    f = cells.share
    for found, inner, outer in zip(
        (cells.bulk, cells.shear), moduli(material), moduli(STEEL), strict=True
    ):
        a = inner / outer
        expected = 1 + f * (a - 1) if a < 1 else 1 / (1 + f * (1 / a - 1))
        np.testing.assert_allclose(found, expected, rtol=1e-12)
    a = moduli(material)[0] / moduli(STEEL)[0]
    weight = f * a / (1 + f * (a - 1)) if a < 1 else f
    np.testing.assert_allclose(cells.misfit[:3], np.broadcast_to(-2e-3 * weight, (3, *f.shape)))
    assert not cells.misfit[3:].any()
    assert cells.laws == (material,)


def test_voids_have_no_stiffness_and_rigid_inclusions_a_thousandfold():
    apart = (0.0, 0.0, 40e-6)
    void = sc.Inclusion.void.sphere(PLACE, 8e-6)
    assert void == sc.Inclusion.void(PLACE, 8e-6)
    assert sc.Inclusion.void(PLACE, (8e-6, 7e-6, 6e-6)) == sc.Inclusion.void.ellipsoid(
        PLACE, (8e-6, 7e-6, 6e-6)
    )
    cells = body(void, sphere(center=apart, material=sc.Material.rigid())).cells_on(GRID)
    inside = cells.share == 1.0
    np.testing.assert_array_equal(cells.bulk[inside & (cells.phase == 0)], 0.0)
    np.testing.assert_allclose(cells.shear[inside & (cells.phase == 1)], 1e3, rtol=1e-12)
    np.testing.assert_array_equal(cells.law, cells.phase)
    assert cells.laws == (None, sc.Material.rigid())
    assert not cells.is_deformed[cells.share == 0].any()
    assert (cells.is_cut == ((cells.share > 0) & ~inside)).all()


def test_an_inclusion_of_the_matrix_changes_nothing():
    cells = body(sphere(material=STEEL)).cells_on(GRID)
    assert not cells.is_deformed.any()
    assert cells.share.max() == 1.0


def test_a_later_inclusion_replaces_an_earlier_one():
    near = tuple(PLACE + np.array([9e-6, 0.0, 0.0]))
    first, second = sphere(), sphere(center=near, material=SULPHIDE)
    cells = body(first, second).cells_on(GRID)
    alone = body(second).cells_on(GRID)
    full = alone.over_grid(alone.share, (31, 29, 30)) == 1.0
    phase = cells.over_grid(cells.phase, (31, 29, 30), -1)
    assert (phase[full] == 1).all()
    assert cells.share.max() == 1.0
    shear = cells.over_grid(cells.shear, (31, 29, 30), 1.0)
    np.testing.assert_allclose(shear[full], moduli(SULPHIDE)[1] / moduli(STEEL)[1])
    with pytest.raises(ValueError, match=r"inclusions\[0\] must not lie within a later"):
        body(sphere(4e-6), sphere()).cells_on(GRID)


def test_inclusions_continue_in_the_next_period():
    grid = sc.Grid(32, 32, 1e-6, 1e-6, dz=1e-6, periodic="x")
    middle, edge = (body(sphere(center=(x, 0.0, 20e-6))).fraction_on(grid) for x in (0.0, 16e-6))
    np.testing.assert_allclose(np.roll(middle, 16, axis=0), edge, atol=2e-12)


def test_inclusions_may_cross_the_sides_and_the_surface():
    crossing = body(sphere(center=(15.5e-6, 0.0, 2e-6)))
    cells = crossing.cells_on(GRID)
    assert cells.first == (23, 6, 0)
    assert cells.share.shape == (16, 17, 10)
    R, h = 8.0, 6.0  # the cap above the surface, in micrometres
    below = 4 / 3 * np.pi * R**3 - np.pi * h**2 * (R - h / 3)
    assert cells.share.sum() == pytest.approx(below, rel=1e-9)
    assert crossing.fraction_on(GRID).sum() == pytest.approx(below / 2, rel=1e-9)


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (lambda: sphere(0.0), "radius must be a finite number > 0"),
        (lambda: sphere(center=(0.0, 0.0, -2e-5)), "reaches below the surface, got.*z is pos"),
        (lambda: sphere(center=(0.0, 0.0)), r"center must have shape \(3,\)"),
        (lambda: sphere(misfit=-2.0), "misfit must be at most 0.1.*not a percentage"),
        (lambda: sphere(misfit=[1e-3] * 3), "misfit must be one number or the six"),
        (lambda: sc.Inclusion.void(PLACE, 21e-6), "void must not reach the surface"),
        (lambda: sc.Inclusion.void(PLACE, 1e-6, TURNED), "axes must not be given for a sphere"),
        (
            lambda: sc.Inclusion.ellipsoid(PLACE, (1e-6,) * 3, ALUMINA, axes=np.ones((3, 3))),
            "axes must be three perpendicular unit vectors",
        ),
        (
            lambda: sphere(material=STEEL.with_residual_stress([0.0], [1e8])),
            "material must not have residual_stress",
        ),
        (lambda: body(), "inclusions must contain at least one"),
        (lambda: body(sphere(), matrix=sc.Material.rigid()), "matrix must not be rigid"),
        (lambda: body(sphere(1.9e-6)).cells_on(GRID), "at least 2 cells per radius, got 1.9"),
        (lambda: body(sphere()).cells_on(sc.Grid(9, 9, 1e-6, 1e-6)), "grid must have dz"),
        (
            lambda: body(sphere()).cells_on(sc.Grid(9, 9, 1e-6, 1e-6, nz=10, dz=1e-6)),
            "must reach into the 10 layers of the grid, got none",
        ),
        (
            lambda: body(sphere(center=(1e-3, 0.0, 2e-5))).cells_on(GRID),
            "at least one inclusion must lie in the grid, within x = ±15.5 µm",
        ),
        (
            lambda: body(sphere()).cells_on(sc.Grid(8, 40, 1e-6, 1e-6, dz=1e-6, periodic="x")),
            r"inclusions\[0\] must not be wider than the period",
        ),
    ],
)
def test_invalid_inclusions_are_refused(make, text):
    with pytest.raises(ValueError, match=text):
        make()


def test_wrong_types_are_refused():
    with pytest.raises(TypeError, match=r"material must be a samcontact.Material"):
        sphere(material="alumina")
    with pytest.raises(TypeError, match=r"inclusions must be a list of samcontact.Inclusion"):
        sc.Heterogeneous(STEEL, [ALUMINA])
    with pytest.raises(TypeError, match=r"grid must be a samcontact.Grid"):
        body(sphere()).cells_on(3)


def test_few_cells_per_radius_give_a_warning():
    with pytest.warns(sc.ResolutionWarning, match="3 cells per radius .3 µm.: use cells of at mo"):
        body(sphere(3e-6)).fraction_on(GRID)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        body(sphere(4e-6)).fraction_on(GRID)


def test_heterogeneous_bodies_are_values():
    hard = sc.Material.linear_hardening(210e9, 0.3, 1e9, 1e10)
    made = body(sphere(misfit=1e-3), sc.Inclusion.void((0, 0, 4e-5), 5e-6), matrix=hard)
    for again in (copy.deepcopy(made), pickle.loads(pickle.dumps(made))):
        assert again == made
        assert hash(again) == hash(made)
    assert (made.E, made.nu, made.is_plastic, made.is_rigid) == (210e9, 0.3, True, False)
    assert made.min_yield_stress == 1e9
    assert "inclusions" in made._repr_html_()
    assert "misfit" in made.inclusions[0]._repr_html_()
    names = {name: getattr(sc, name) for name in sc.__all__}
    assert eval(repr(made.inclusions[1]), names) == made.inclusions[1]
