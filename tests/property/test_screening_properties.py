# SPDX-License-Identifier: GPL-3.0-or-later
"""Quick preliminary checks miss no warning of the full checks."""

import math
import warnings
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import samcontact as sc
from samcontact.diagnostics import hertz_estimate, resolution
from samcontact.solutions import outline

PERIODIC = st.sampled_from(["", "x", "y", "xy"])
SHAPES = st.tuples(st.integers(1, 14), st.integers(1, 14))


def spots(seed, shape):
    """Draw a pressure of spots and single cells, or of noise."""
    rng = np.random.default_rng(seed)
    noise = rng.random(shape)
    if seed % 3 == 0:
        return np.where(rng.random(shape) < rng.random(), noise, 0.0)
    i, j = np.indices(shape)
    field = np.zeros(shape)
    for _ in range(rng.integers(1, 4)):
        centre, size = rng.random(2) * shape, rng.uniform(0.5, 8.0, 2)
        r = ((i - centre[0]) / size[0]) ** 2 + ((j - centre[1]) / size[1]) ** 2
        field = np.maximum(field, np.sqrt(np.maximum(1 - r, 0.0)))
    return field * (0.9 + 0.2 * noise if seed % 3 == 1 else 1.0)


@settings(max_examples=300)
@given(st.integers(0, 10**6), SHAPES, PERIODIC)
def test_the_outline_count_includes_all_sides(seed, shape, periodic):
    pressure = spots(seed, shape)
    inside = pressure > 0
    found = outline.outline_of(pressure, periodic)
    sides = list(outline.sides_of(inside, periodic))
    assert found.cells == np.count_nonzero(inside)
    assert found.sides == sum(len(one.i) for one in sides)
    assert found.rises == any(outline._rising(one, pressure).any() for one in sides)
    assert found.largest == pressure.max()
    i, j = np.unravel_index(pressure.argmax(), shape)
    reaches = [
        n for n in range(1, 9)
        if n <= i <= shape[0] - n and n <= j <= shape[1] - n
        and inside[i - n : i + n, j].all() and inside[i, j - n : j + n].all()
    ]  # fmt: skip
    assert min(found.reach, 8) == max(reaches, default=0)


@settings(max_examples=200)
@given(st.integers(0, 10**6), SHAPES, PERIODIC)
def test_a_gap_without_steps_has_no_step_next_to_any_cell(seed, shape, periodic):
    rng = np.random.default_rng(seed)
    i, j = np.indices(shape)
    gap = (0.01 * (i - rng.random() * shape[0])) ** 2 + (0.01 * j) ** 2 * rng.random()
    gap += np.where(rng.random() < 0.5, (i > shape[0] // 2) * 10 ** rng.uniform(-6, 0), 0.0)
    gap += 10 ** rng.uniform(-9, -2) * rng.standard_normal(shape) * rng.integers(0, 2)
    everywhere = np.ones(shape, dtype=bool)
    steps = any(
        outline.steps_beside(one, gap, periodic)[0].any()
        for sides in outline.sides_between(everywhere, everywhere, periodic)
        for one in [outline.away_from_border(sides, shape, periodic)]
    )
    assert outline.may_have_steps(gap, periodic) or not steps


def test_smooth_gaps_have_no_steps():
    grid = sc.Grid(25, 31, 1e-5, 1e-5)
    for gap in (sc.surfaces.paraboloid(grid, 1e-2), sc.surfaces.sphere(grid, 1e-2)):
        assert not outline.may_have_steps(gap, "")
        assert outline.may_have_steps(gap + np.where(grid.x > 0, 1e-7, 0.0)[:, None], "")


@settings(max_examples=300)
@given(st.integers(0, 10**6), SHAPES, PERIODIC, st.sampled_from([4, 8]))
def test_a_wide_contact_is_not_reported_as_coarse(seed, shape, periodic, few):
    pressure = spots(seed, shape)
    even = [
        n + n % 2 if name in periodic and n > 1 else n for n, name in zip(shape, "xy", strict=True)
    ]
    pressure = np.pad(pressure, [(0, m - n) for n, m in zip(shape, even, strict=True)])
    if periodic == "xy" and pressure.size == 1:
        return
    grid = sc.Grid(*pressure.shape, 1e-5, 1e-5, periodic=periodic)
    solution = SimpleNamespace(
        repulsion=pressure, outline=outline.outline_of(pressure, periodic), load=1.0
    )
    scene = SimpleNamespace(grid=grid, hertz=lambda load: None)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = resolution.warn_of_contact(solution, scene, few, stacklevel=1)
    share = resolution.area_uncertainty(pressure, periodic)
    thin = share > (resolution.AREA_ERROR_WARNING if few == 8 else resolution.AREA_ERROR_LIMIT)
    narrow = resolution.cells_across(pressure, periodic) < few
    assert found == (thin or (narrow and not resolution._is_wide(pressure)))


@settings(max_examples=60)
@given(
    st.floats(-2.5, 0.5), st.floats(0.3, 3.0), st.floats(-7, 0), st.floats(4, 13),
    st.sampled_from([None, 1e-9, 1e-5]), st.booleans(), st.booleans(),
)  # fmt: skip
def test_loads_accepted_by_the_quick_check_pass_the_full_check(
    radius, ratio, cell, modulus, dz, yields, heated
):
    """Spheres and ellipsoids under loads over twelve decades, and their approaches."""
    grid = sc.Grid(17, 21, 10**cell, 1.3 * 10**cell, dz=dz)
    E = 10**modulus
    body = sc.Material.perfect_plastic(E, 0.3, 4e-3 * E) if yields else sc.Material.elastic(E, 0.3)
    body = body.with_thermal(50.0, 1e-5, 1e-5)
    heat = sc.Heat(3e-2, velocity=((0.0, 0.0), (1.0, 0.0))) if heated else sc.Heat(0.0)
    gap = sc.surfaces.paraboloid(grid, 10**radius, ratio * 10**radius)
    scene = hertz_estimate.ContactSetup(grid, gap, (sc.Material.elastic(E, 0.3), body))
    least, most = scene.passing_loads(heat)
    room = scene.largest_load_with_room
    if scene.radii is None:
        return
    around = most if math.isfinite(most) else room
    for load in np.geomspace(1e-10 * around, 1e2 * around, 49):
        if least < load < most:
            assert scene.failed_checks(heat, load) == []
        if load <= room:
            hertz = scene.hertz(load)
            assert max(2 * hertz.semi_axes[0] / (21 * grid.dy), 0.0) <= 1
            approach = hertz.contact.approach + gap.min()
            assert scene.load_of(approach=approach) == pytest.approx(load, rel=1e-5)
