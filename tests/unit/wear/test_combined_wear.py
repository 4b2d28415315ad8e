# SPDX-License-Identifier: GPL-3.0-or-later
"""Wear with plasticity, heat of slip, partial slip, layers and a grid that grows."""

import numpy as np
import pytest

import samcontact as sc
from samcontact import report

STEEL = sc.Material.elastic(210e9, 0.3)
OUT_OF_REACH = sc.Material.perfect_plastic(210e9, 0.3, 1e11)
SOFT = sc.Material.linear_hardening(210e9, 0.3, 0.4e9, 20e9)
SWIFT = sc.Material.swift(210e9, 0.3, 1e9, 16.0, 0.067)
WEAK = sc.Material.linear_hardening(210e9, 0.3, 0.15e9, 1e9)
MU = sc.Coulomb(0.5)
RADIUS, LOAD, CELL = 5e-3, 8.0, 8e-6


def ball(grid):
    return sc.surfaces.paraboloid(grid, RADIUS)


def grid_of(cells, **layers):
    return sc.Grid(cells, cells, CELL, CELL, **layers)


def loop(amplitude=0.3 * LOAD, **more):
    """Return a path that loads, applies a force, reverses it and returns to it."""
    return [{"load": LOAD, "tangential_load": (q * amplitude, 0.0)} | more for q in (0, 1, -1, 1)]


def frets(body1=STEEL, body2=STEEL, grid=None, gap=ball, **changes):
    given = {"cycle": loop(), "friction": MU, "energy": 1e-14, "cycles": 2, "repeats": 25_000}
    given |= {"progress": False} | changes
    return sc.wear.fretting(grid or grid_of(18), body1, body2, gap, **given)


def wears(body2, friction=0.0, grid=None, **changes):
    given = {"cycle": [{"load": 700.0}, {"load": 0.0}], "threshold": 2e-3, "window": 3}
    given |= {"order": 1, "cycles": 2, "friction": friction, "progress": False} | changes
    grid = grid or sc.Grid(15, 15, 60e-6, 60e-6, dz=30e-6)
    return sc.wear.run(
        grid, STEEL, body2, lambda grid: sc.surfaces.paraboloid(grid, 7.5e-3), **given
    )


def frets_softly(**changes):
    """Fretting of two bodies that wear, one of which yields."""
    given = {"body2": SOFT, "energy": (1e-14, 3e-14), "repeats": 3000, "cycles": 2}
    given |= {"grid": sc.Grid(16, 16, CELL, CELL, dz=1.5 * CELL), "cycle": loop(0.1 * LOAD)}
    return frets(**(given | changes))


@pytest.fixture(scope="module")
def elastic():
    return frets(tol=1e-8)


@pytest.fixture(scope="module")
def yielding():
    return frets_softly()


def assert_equal_scars(one, other, tolerance):
    depth = np.abs(other.profile()).max()
    assert depth > 0
    np.testing.assert_allclose(one.profile(), other.profile(), atol=tolerance * depth, rtol=0)
    pressures = [result.last[-1].pressure for result in (one, other)]
    np.testing.assert_allclose(*pressures, atol=tolerance * pressures[1].max(), rtol=0)


def test_a_body_that_does_not_yield_frets_as_an_elastic_one(elastic):
    found = frets(body2=OUT_OF_REACH, grid=grid_of(18, nz=6, dz=CELL), tol=1e-8)
    assert found.cycles[0].parts > 1
    assert_equal_scars(found, elastic, 1e-8)
    assert found.cycles[-1].max_equivalent_plastic_strain == (0.0,)


def test_scars_of_yielding_bodies_do_not_depend_on_their_numbers(yielding):
    """The shear on body 2 has the opposite sign if the bodies are exchanged."""
    swapped = frets_softly(body1=SOFT, body2=STEEL, energy=(3e-14, 1e-14), cycle=loop(-0.1 * LOAD))
    scale = np.abs(yielding.profile(body=2)).max()
    for body in (1, 2):
        np.testing.assert_allclose(
            yielding.profile(body=body), swapped.profile(body=3 - body), atol=1e-6 * scale
        )
    one, other = yielding.cycles[-1], swapped.cycles[-1]
    strain = one.max_equivalent_plastic_strain
    assert strain[1] > 1e-3
    assert strain == pytest.approx(other.max_equivalent_plastic_strain[::-1], rel=1e-5)


def test_heat_without_expansion_changes_nothing_and_is_the_friction_work(elastic):
    """Far below, the temperature is that of a point source of the frictional power."""
    conductivity, depth, duration = 50.0, 1e-2, 1e-3
    body = STEEL.with_thermal(conductivity, 0.0, 1e-5)
    given = {"cycle": loop(duration=duration), "heat": sc.Heat(partition=1.0), "tol": 1e-8}
    assert_equal_scars(frets(body, body, **given), elastic, 1e-12)
    grid = grid_of(18, nz=1, dz=2 * depth)
    once = frets(STEEL, body, grid, **given, repeats=1, cycles=1)
    below = [state.temperature()[8:10, 8:10, 0].mean() for state in once.last]
    power = 2 * np.pi * conductivity * depth * np.array(below)
    assert power.sum() * duration == pytest.approx(once.cycles[0].friction_work, rel=1e-4)


def test_frictionless_partial_slip_wears_as_full_sliding_without_friction():
    one, other = (wears(SWIFT, friction, threshold=4e-5) for friction in (sc.Coulomb(0.0), 0.0))
    assert one.cycles[0].max_equivalent_plastic_strain[0] > 1e-3
    assert one.cycles == other.cycles
    np.testing.assert_array_equal(one.profile(), other.profile())


def test_partial_slip_of_similar_bodies_leaves_the_pressure():
    pulled = {"load": 700.0, "tangential_load": (150.0, 0.0)}
    one = wears(OUT_OF_REACH, MU, cycle=[pulled, {"load": 0.0}])
    other = wears(OUT_OF_REACH)
    a, b = (result.last[0].pressure for result in (one, other))
    np.testing.assert_allclose(a, b, atol=1e-6 * b.max(), rtol=0)
    assert one.last[0].tangential_load[0] == pytest.approx(150.0)


def test_shear_of_partial_slip_wears_the_surface():
    law, free = sc.Coulomb(0.35), {"load": 0.0}
    sheared, pressed = (
        wears(SWIFT, law, cycle=[{"load": 500.0} | drive, free], cycles=1, threshold=1e-3)
        for drive in ({"shift": (1e-5, 0.0)}, {})
    )
    assert sheared.cycles[0].volume[0] > 0
    assert pressed.cycles[0].volume[0] == 0


def test_equal_layers_wear_as_a_homogeneous_body(elastic, yielding):
    coated = sc.Layered([(STEEL, 12e-6)], STEEL)
    found = frets(coated, coated, tol=1e-8)
    assert_equal_scars(found, elastic, 1e-8)
    shares = [cycle.coating_worn_share[0] for cycle in found.cycles]
    assert shares[-1] == pytest.approx(-found.profile().min() / 12e-6)
    soft = sc.Layered([(SOFT, 1.5 * CELL)], SOFT)
    assert_equal_scars(frets_softly(body2=soft), yielding, 1e-6)


def test_a_coating_that_wears_thin_is_told_and_one_worn_through_is_refused():
    coated = sc.Layered([(STEEL, 0.02e-6)], STEEL)
    with (
        pytest.warns(sc.WornCoatingWarning, match="it reaches 31% on body 2 after cycl"),
        pytest.raises(ValueError, match="top layer of body2 must not be worn through") as caught,
    ):
        frets(body2=coated, cycles=20, repeats=10_000)
    done = caught.value.result
    shares = [cycle.coating_worn_share[0] for cycle in done.cycles]
    assert shares == sorted(shares)
    assert 0.8 < shares[-1] < 1.0
    assert done.to_dataset()["coating_worn_share"].values[-1, 0] == shares[-1]


def test_plastic_flow_that_does_not_cease_is_told():
    grid = sc.Grid(33, 1, CELL, CELL, dz=CELL, periodic="y")
    load = 0.3e9 * np.pi / 2 * 9 * CELL * CELL
    cycle = [{"load": load, "tangential_load": (q * load, 0.0)} for q in (0, 0.48, -0.48, 0.48)]
    given = {"cycle": cycle, "cycles": 1, "repeats": 2, "body2": WEAK, "tol": 1e-3}
    gap = sc.surfaces.paraboloid(grid, 20e-3, np.inf)
    with pytest.warns(sc.IncrementWarning, match="have not shaken down"):
        found = frets(grid=grid, gap=gap, **given)
    assert found.cycles[0].plastic_flow > 1e-4


def test_a_grid_that_grows_gives_the_scar_of_a_large_grid(tmp_path):
    """The scar reaches the edge of the grid after a few parts, and again after a restart."""
    given = {"repeats": 60_000, "tol": 1e-8, "cycle": loop(0.47 * LOAD)}
    kept = given | {"checkpoint": tmp_path / "scar.h5"}
    frets(**kept, cycles=1)
    found = frets(**kept, cycles=2)
    assert found.last[-1].grid.nx == found.grid.nx > 18
    again = frets(**given)
    assert again.first[-1].grid.nx == 18
    np.testing.assert_array_equal(found.profile(), again.profile())
    assert_equal_scars(found, frets(grid=found.grid, **given), 1e-8)
    with pytest.raises(sc.GridTooSmallError):
        frets(gap=ball(grid_of(18)), **given)


def test_plastic_strain_and_grid_are_continued_from_a_checkpoint(yielding, tmp_path):
    frets_softly(checkpoint=tmp_path / "scar.h5", cycles=1)
    again = frets_softly(checkpoint=tmp_path / "scar.h5")
    assert again.cycles == yielding.cycles
    np.testing.assert_array_equal(again.profile(), yielding.profile())


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
def test_a_grid_grows_for_the_filter_too():
    """The contact and the smoothed wear reach the sides of the grid.

    Differences: the periodic images of the residual stress have other distances.
    """
    given = {"friction": 0.35, "threshold": 1e-3, "window": 5, "tol": 1e-7}
    given["cycle"] = [{"load": 500.0}, {"load": 0.0}]
    found = wears(SWIFT, grid=sc.Grid(9, 9, 60e-6, 60e-6, dz=30e-6), **given)
    assert found.last[0].grid.nx > 9
    assert found.grid.ny > found.grid.nx
    large = wears(SWIFT, grid=found.grid, **given)
    assert large.cycles[-1].volume[0] > 0
    depth = np.abs(large.profile()).max()
    np.testing.assert_allclose(found.profile(), large.profile(), atol=1e-5 * depth, rtol=0)


def test_the_report_judges_the_worn_share_of_a_coating():
    coated = sc.Layered([(STEEL, 0.03e-6)], STEEL)
    thin = frets(body2=coated, repeats=10_000, cycles=1).to_dataset()
    shares = {c.name: c for c in report.checks(thin)}
    judged = shares["maximum worn share of a top layer"]
    assert judged.passed
    assert judged.value == thin["coating_worn_share"].values.max() > 0.05
