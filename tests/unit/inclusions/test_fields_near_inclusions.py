# SPDX-License-Identifier: GPL-3.0-or-later
"""Peaks, butterflies and lives of the matrix, on the exact field around a sphere."""

import math
from dataclasses import replace

import numpy as np
import pytest

import samcontact as sc
from samcontact.fatigue import FatigueField

STEEL = sc.Material.elastic(210e9, 0.3)
ALUMINA = sc.Material.elastic(390e9, 0.25)
GRID = sc.Grid(33, 29, 1e-6, 1e-6, dz=1e-6)
CENTER = np.array([1.2e-6, -0.3e-6, 16.1e-6])
BODY = sc.Heterogeneous(STEEL, [sc.Inclusion.sphere(CENTER, 8e-6, ALUMINA)])
DEPTHS = np.asarray(GRID.depths(32))
AXES = {"x": np.asarray(GRID.x), "y": np.asarray(GRID.y), "z": DEPTHS}


def points():
    mesh = np.meshgrid(*AXES.values(), indexing="ij")
    return [axis - c for axis, c in zip(mesh, CENTER, strict=True)]


def exact_field(stress):
    sphere = sc.inclusions.eshelby_sphere(STEEL, ALUMINA, stress, radius=8e-6)
    of = sphere.stress(*points())
    values = sc.fatigue.max_von_mises(np.stack([of, of])).values
    return FatigueField("max_von_mises", {}, values, "Pa", AXES, 2)


TENSION = exact_field([0, 0, 1e8, 0, 0, 0])


def test_peaks_are_in_the_matrix_near_the_inclusion():
    (peak,) = sc.inclusions.peaks(TENSION, BODY)
    share = BODY.fraction_on(GRID)
    mesh = np.stack(points())
    apart = np.linalg.norm(mesh, axis=0) / 8e-6
    matrix = np.ones(TENSION.values.shape, dtype=bool)
    matrix[:, :, : share.shape[2]] = share == 0.0
    masked = np.where(matrix & (apart <= 1.5), TENSION.values, 0.0)
    at = np.unravel_index(masked.argmax(), masked.shape)
    assert peak.value == masked.max()
    assert peak.position == tuple(AXES[name][i] for name, i in zip("xyz", at, strict=True))
    assert peak.number == 0
    assert peak.distance == pytest.approx(apart[at])
    assert peak.angle == pytest.approx(math.atan2(-mesh[2][at], mesh[0][at]))
    assert 1.0 < peak.distance < 1.35


def test_the_field_of_the_matrix_excludes_all_filled_cells():
    matrix = sc.inclusions.matrix_field(TENSION, BODY)
    share = BODY.fraction_on(GRID)
    filled = np.zeros(TENSION.values.shape, dtype=bool)
    filled[:, :, : share.shape[2]] = share > 0.0
    np.testing.assert_array_equal(matrix.values == 0.0, filled)
    np.testing.assert_array_equal(matrix.values[~filled], TENSION.values[~filled])
    near = sc.inclusions.matrix_field(TENSION, BODY, within=1.5)
    assert 0 < (near.values > 0).sum() < (matrix.values > 0).sum()


def test_voxels_are_excluded_like_the_inclusion():
    origin = GRID.x[0] - 0.5e-6, GRID.y[0] - 0.5e-6, 0.0
    measured = sc.Heterogeneous.voxels(STEEL, ALUMINA, BODY.fraction_on(GRID), 1e-6, origin)
    expected, found = (sc.inclusions.matrix_field(TENSION, body) for body in (BODY, measured))
    np.testing.assert_array_equal(found.values, expected.values)


def test_butterflies_of_shear_have_four_wings_at_the_axes_and_of_tension_two():
    """Under shear xz, the principal directions are at 45 degrees; a stiff sphere has its poles of
    largest von Mises stress there. Under tension along z they are above and below."""
    shear = exact_field([0, 0, 0, 0, 1e8, 0])
    found = sc.inclusions.butterflies(shear, BODY, sectors=24)
    turned = exact_field([-1e8, 0, 1e8, 0, 0, 0])  # the same, turned by 45 degrees
    other = sc.inclusions.butterflies(turned, BODY, sectors=24)
    np.testing.assert_allclose(np.roll(found.relative, 3), other.relative, atol=0.08)
    for wings in (found, other):
        np.testing.assert_allclose(wings.relative, np.roll(wings.relative, 6), atol=0.08)
        assert wings.count.sum() == 1
    upright = sc.inclusions.butterflies(TENSION, BODY, sectors=24)
    best = np.degrees(upright.angle[upright.count.argmax()])
    assert abs(abs(best) - 90.0) < 60.0
    assert "wings" in upright._repr_html_()


def test_a_cleaner_body_lives_longer():
    """Life of the matrix against the uniform stress, by the integral of Zaretsky."""
    clean = replace(TENSION, values=np.full_like(TENSION.values, 1e8))
    clean = sc.inclusions.matrix_field(clean, BODY)
    with_sphere = sc.inclusions.matrix_field(TENSION, BODY)
    lives = [sc.fatigue.life(field, "zaretsky") for field in (with_sphere, clean)]
    matrix = clean.values > 0
    ratio = ((TENSION.values[matrix] / 1e8) ** (100 / 9)).sum() / matrix.sum()
    assert lives[0].relative_to(lives[1]) == pytest.approx(ratio**-0.9, rel=1e-9)
    assert lives[0].relative_to(lives[1]) < 0.95


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (lambda: sc.inclusions.peaks(TENSION, BODY, within=1.0), "within must be above 1"),
        (
            lambda: sc.inclusions.peaks(replace(TENSION, coordinates={}), BODY),
            "field must have the axes x, y and z, got a stress array",
        ),
        (lambda: sc.inclusions.butterflies(TENSION, BODY, sectors=400), "sectors must be at most"),
        (
            lambda: sc.inclusions.butterflies(
                TENSION, sc.Heterogeneous(STEEL, [sc.Inclusion.void((1e-3, 0, 1e-4), 8e-6)])
            ),
            "field must be > 0 in at least one cell of the matrix around an inclusion",
        ),
    ],
)
def test_invalid_arguments_are_refused(make, text):
    with pytest.raises(ValueError, match=text):
        make()


def test_wrong_types_are_refused():
    with pytest.raises(TypeError, match=r"body must be a samcontact.Heterogeneous"):
        sc.inclusions.matrix_field(TENSION, STEEL)
    with pytest.raises(TypeError, match=r"body2 must be a samcontact.Heterogeneous"):
        sc.inclusions.statistics(sc.fatigue.cycle(np.zeros((2, 6, 3, 3, 3))))
