# SPDX-License-Identifier: GPL-3.0-or-later
"""Random and measured microstructures."""

import math
import pickle

import numpy as np
import pytest

import samcontact as sc

STEEL = sc.Material.elastic(210e9, 0.3)
ALUMINA = sc.Material.elastic(390e9, 0.25)
CARBIDE = sc.Material.elastic(600e9, 0.25)
BOX = ((-5e-5, 5e-5), (-5e-5, 5e-5), (0.0, 8e-5))
VOLUME = 8e-13
GRID = sc.Grid(31, 29, 1e-6, 1e-6, dz=1e-6)


def drawn(fraction=0.05, radius=(5e-6, 0.3), seed=1, **kind):
    return sc.Heterogeneous.random(STEEL, ALUMINA, fraction, radius, BOX, seed, **kind)


def arrays(body):
    centers = np.array([one.center for one in body.inclusions])
    return centers, np.array([one.radii[0] for one in body.inclusions])


@pytest.mark.parametrize("kind", [{}, {"cluster": (5.0, 1e-5)}])
def test_spheres_keep_their_distance_and_cover(kind):
    centers, radii = arrays(drawn(gap=0.2, cover=2e-6, **kind))
    apart = np.linalg.norm(centers[:, None] - centers, axis=-1) + 1e9 * np.eye(len(radii))
    assert (apart >= (radii[:, None] + radii) * 1.1 * (1 - 1e-12)).all()
    assert (centers[:, 2] - radii).min() >= 2e-6
    assert (np.diff(radii) <= 0).all()
    low, high = np.array(BOX).T
    assert ((centers >= low) & (centers <= high)).all()


def test_clusters_are_denser_than_random_places():
    def nearest(**kind):
        centers, _ = arrays(drawn(0.01, (3e-6, 0.0), **kind))
        apart = np.linalg.norm(centers[:, None] - centers, axis=-1) + 1e9 * np.eye(len(centers))
        return np.median(apart.min(axis=1))

    assert nearest(cluster=(8.0, 6e-6)) < 0.75 * nearest()


def test_equal_seeds_give_equal_bodies():
    assert drawn() == drawn() != drawn(seed=2)
    assert pickle.loads(pickle.dumps(drawn())) == drawn()


@pytest.mark.parametrize("limits", [None, (4e-6, 7e-6)])
def test_the_mean_fraction_is_the_expected_one(limits):
    """Mean over 40 seeds of about 40 inclusions each, within three standard errors."""
    shares = [
        drawn(0.04, (5e-6, 0.35), seed, radius_limits=limits).volume_in(BOX) / VOLUME
        for seed in range(40)
    ]
    error = np.std(shares) / math.sqrt(len(shares))
    assert np.mean(shares) == pytest.approx(0.04, abs=3 * error)
    assert error < 0.003


def test_the_cells_have_the_fraction_of_the_spheres():
    body = drawn(0.03, (6e-6, 0.1), cover=0.0)
    grid = sc.Grid(121, 121, 1e-6, 1e-6, dz=1e-6)
    assert body.fraction_on(grid).sum() * 1e-18 == pytest.approx(body.volume_in(BOX), rel=1e-9)


def test_voxels_of_a_sphere_equal_the_sphere_of_the_same_shares_to_every_digit():
    sphere = sc.Heterogeneous(STEEL, [sc.Inclusion.sphere((0, 1e-7, 1.5e-5), 8e-6, ALUMINA)])
    expected = sphere.cells_on(GRID)
    origin = GRID.x[0] - 0.5e-6, GRID.y[0] - 0.5e-6, 0.0
    measured = sc.Heterogeneous.voxels(STEEL, ALUMINA, sphere.fraction_on(GRID), 1e-6, origin)
    found = measured.cells_on(GRID)
    shape = (31, 29, found.share.shape[2])
    for name in ("share", "bulk", "shear", "phase", "law"):
        outside = {"share": 0.0, "bulk": 1.0, "shear": 1.0}.get(name, -1)
        np.testing.assert_array_equal(
            found.over_grid(getattr(found, name), shape, outside),
            expected.over_grid(getattr(expected, name), shape, outside),
        )


def test_fine_voxels_converge_to_the_sphere():
    sphere = sc.Inclusion.sphere((1.3e-6, 0.4e-6, 1.5e-5), 6e-6, ALUMINA)
    exact = sc.Heterogeneous(STEEL, [sphere]).fraction_on(GRID)
    errors = []
    for size in (0.7e-6, 0.23e-6):
        count = math.ceil(14e-6 / size)
        origin = np.array(sphere.center) - count * size / 2
        at = (np.arange(count) + 0.5 - count / 2) * size
        labels = at[:, None, None] ** 2 + at[:, None] ** 2 + at**2 <= 36e-12
        body = sc.Heterogeneous.voxels(STEEL, [ALUMINA], labels, size, origin)
        share = body.fraction_on(GRID)[:, :, : exact.shape[2]]
        assert share.sum() * 1e-18 == pytest.approx(labels.sum() * size**3, rel=1e-9)
        errors.append(np.abs(share - exact[:, :, : share.shape[2]]).max())
    assert errors[1] < 0.1 < errors[0]


def test_voxels_of_several_materials_and_an_inclusion_on_top():
    labels = np.zeros((20, 20, 10), dtype=int)
    labels[:10], labels[10:, :, 5:] = 1, 2
    block = sc.Heterogeneous.voxels(STEEL, [CARBIDE, None], labels, 1e-6, (-1e-5, -1e-5, 5e-6))
    grid = sc.Grid(20, 20, 1e-6, 1e-6, dz=1e-6)
    cells = block.cells_on(grid)
    assert cells.laws == (CARBIDE, None)
    np.testing.assert_array_equal(cells.law, labels - 1)
    np.testing.assert_array_equal(cells.bulk[labels == 2], 0.0)
    sphere = sc.Inclusion.sphere((-5e-6, 0.0, 1e-5), 4e-6, ALUMINA)
    both = sc.Heterogeneous(STEEL, [sphere], block.measured).cells_on(grid)
    assert both.laws == (ALUMINA, CARBIDE, None)
    alone = sc.Heterogeneous(STEEL, [sphere]).fraction_on(grid)[:, :, 5:]
    full = np.zeros(labels.shape, dtype=bool)
    full[:, :, : alone.shape[2]] = alone == 1.0
    np.testing.assert_array_equal(both.phase[full], 0)
    assert full.sum() > 100
    np.testing.assert_allclose(both.share[labels > 0], 1.0, rtol=1e-12)


def test_voxel_bodies_are_values():
    labels = np.zeros((4, 4, 4), dtype=int)
    labels[1, 1, 1] = 1
    first = sc.Heterogeneous.voxels(STEEL, [ALUMINA], labels, 1e-6, (0.0, 0.0, 1e-5))
    assert first == sc.Heterogeneous.voxels(STEEL, ALUMINA, labels, (1e-6,) * 3, [0, 0, 1e-5])
    assert hash(first) == hash(pickle.loads(pickle.dumps(first)))
    labels[2, 1, 1] = 1
    assert first != sc.Heterogeneous.voxels(STEEL, [ALUMINA], labels, 1e-6, (0.0, 0.0, 1e-5))
    assert "voxels" in first._repr_html_()
    assert math.isinf(first.cells_per_radius(GRID))


def voxels(labels, materials=(ALUMINA,), origin=(0.0, 0.0, 1e-5), **kind):
    return sc.Heterogeneous.voxels(STEEL, list(materials), labels, 1e-6, origin, **kind)


ONES = np.ones((2, 2, 2), dtype=int)


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (lambda: drawn(5.0), "fraction must be at most 0.3, got 5.0: it is a volume fraction"),
        (lambda: drawn(1e-9), "fraction must give at least one inclusion.*got none with seed 1"),
        (lambda: drawn(0.3, (8e-6, 0.0), gap=3.0), "fraction must leave room.*found no room"),
        (lambda: drawn(radius=(5e-6, 5e-6, 1)), r"radius must be a pair .median .m., standard dev"),
        (lambda: drawn(radius=(5e-6, 3.0)), r"spread of radius must be at most 2.*ln.radius"),
        (lambda: drawn(0.1, (1e-8, 0.0)), "fraction must give at most 100000 inclusions"),
        (lambda: drawn(radius_limits=(6e-6, 7e-6)), "radius_limits must enclose the median"),
        (lambda: drawn(cluster=(0.0, 1e-5)), "members of cluster must be a finite number > 0"),
        (lambda: drawn(seed=-1), "seed must be an integer >= 0"),
        (
            lambda: sc.Heterogeneous.random(STEEL, None, 0.1, 1e-6, ((0, 1), (1, 0), (0, 1)), 1),
            "box must have lower limits below the upper limits",
        ),
        (lambda: voxels(ONES[0]), "labels must be a three-dimensional array"),
        (lambda: voxels(2 * ONES), "labels must be from 0 .matrix. to 1, the number of mat"),
        (lambda: voxels(0 * ONES), "labels must contain at least one value other than 0"),
        (
            lambda: voxels(1.5 * ONES),
            "labels must be integers, or the filled fraction of each voxel, from 0 to 1",
        ),
        (
            lambda: voxels(0.5 * ONES, [ALUMINA, None]),
            "with 2 materials, labels must be integers",
        ),
        (lambda: voxels(ONES, [None], (0.0, 0.0, 0.0)), "labels must not have voids at the surf"),
        (lambda: voxels(ONES, origin=(0.0, 0.0, -1e-5)), "origin must be so deep"),
        (
            lambda: voxels(ONES, origin=(15e-6, 0, 1e-5)).cells_on(
                sc.Grid(30, 30, 1e-6, 1e-6, dz=1e-6, periodic="x")
            ),
            "voxels must lie within the period",
        ),
    ],
)
def test_invalid_microstructures_are_refused(make, text):
    with pytest.raises(ValueError, match=text):
        make()
