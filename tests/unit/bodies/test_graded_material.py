# SPDX-License-Identifier: GPL-3.0-or-later
"""Depth profiles of a material: its description and refused arguments."""

import re

import numpy as np
import pytest
from pydantic import TypeAdapter, ValidationError

import samcontact as sc
from samcontact import plotting, results
from samcontact.results.reading import graded_of

E, NU, Y = 210e9, 0.3, 1e9
ELASTIC, RIGID = sc.Material.elastic(E, NU), sc.Material.rigid()
PLAIN = sc.Material.perfect_plastic(E, NU, Y)
SOFT = sc.Material.linear_hardening(E, NU, Y, 0.1 * E)
WEAK = ([0.0, 20e-6, 30e-6, 60e-6], [1.0, 1.0, 0.5, 1.0])


def test_material_properties_at_a_depth():
    body = PLAIN.with_yield_profile([1e-3, 2e-3], [2.0, 1.0])
    np.testing.assert_allclose(body.yield_factor([0.0, 1.5e-3, 1.0]), [2.0, 1.5, 1.0])
    np.testing.assert_array_equal(PLAIN.yield_factor([0.0, 1.0]), [1.0, 1.0])
    pulled = body.with_residual_stress([0.0, 1e-3], [1e8, 0.0], sxy=[0.0, 1e7])
    np.testing.assert_allclose(pulled.residual_stress_at(5e-4), [5e7, 5e7, 5e6])
    assert not body.residual_stress_at([0.0, 1.0]).any()
    assert eval(repr(pulled).replace("Material(", "make("), {"make": made}) == pulled
    with pytest.raises(ValueError, match=r"^z must be finite and >= 0, got -1.0"):
        body.yield_factor(-1.0)


def test_tables_show_the_profile():
    body = PLAIN.with_yield_profile(*WEAK).with_residual_stress([0.0, 1e-4], [-2e8, 0.0])
    table = body._repr_html_()
    for row in ("1 from 0 m to 60 µm, within 0.5 to 1", "-200 MPa to 0 Pa from 0 m to 100 µm"):
        assert row in table


CASE = PLAIN.with_yield_profile([0.0, 110e-6, 130e-6], [2.2, 2.0, 1.0])
PEENED = PLAIN.with_residual_stress([0.0, 200e-6], [-4e8, 0.0])


@pytest.mark.parametrize("body", [CASE, PEENED], ids=["case", "peened"])
def test_the_load_at_first_yield_agrees_with_the_closed_form(body):
    exact = sc.critical.onset_over_depth(7.5e-3, sc.hertz.effective_modulus(RIGID, body), body)

    def built(load):
        cell = exact.a / 12
        grid = sc.Grid(33, 33, cell, cell, 26, cell)
        return sc.Simulation(
            grid, RIGID, body, lambda grid: sc.surfaces.paraboloid(grid, 7.5e-3)
        ), [{"load": load}]

    found = sc.find_load(built, "yield", largest_load=3 * exact.load)
    assert abs(found.load - exact.load) < found.load_error < 0.2 * exact.load


def test_first_yield_below_the_grid_is_refused():
    body = PLAIN.with_yield_profile([0.0, 100e-6, 120e-6], [5.0, 5.0, 1.0])
    grid = sc.Grid(17, 17, 20e-6, 20e-6, 8, 15e-6)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)

    def built(load):
        return sc.Simulation(grid, RIGID, body, gap), [{"load": load}]

    with pytest.raises(
        ValueError, match=r"body2 first yields in or below the deepest layer .*: increase nz"
    ):
        sc.find_load(built, "yield", largest_load=100.0)


def made(law, yield_profile=None, residual_stress=None, **parameters):
    return sc.Material(
        law, parameters, yield_profile=yield_profile, residual_stress=residual_stress
    )


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (lambda: ELASTIC.with_yield_profile([0.0], [1.0]), "requires an elastic-plastic"),
        (
            lambda: RIGID.with_residual_stress([0.0], [1.0]),
            "residual stress cannot be set for a rigid body",
        ),
        (
            lambda: SOFT.with_yield_profile([0.0, 1e-3], [1.0]),
            "factor of yield_profile must have as many values",
        ),
        (
            lambda: SOFT.with_yield_profile([0.0, 0.0], [1.0, 2.0]),
            "z of yield_profile must be strictly ascending",
        ),
        (
            lambda: SOFT.with_yield_profile([-1e-3, 0.0], [1.0, 2.0]),
            "z of yield_profile must be >= 0",
        ),
        (
            lambda: SOFT.with_yield_profile([0.0], [0.0]),
            "factor of yield_profile must be from 1e-6 to 1e6",
        ),
        (lambda: SOFT.with_yield_profile([], []), "z of yield_profile must be a list of 1 to 4096"),
        (
            lambda: SOFT.with_yield_profile([0.0], [np.nan]),
            "factor of yield_profile must contain finite numbers",
        ),
        (
            lambda: SOFT.with_residual_stress([0.0], [1e8], [1e8, 2e8]),
            "syy of residual_stress must have as many",
        ),
        (
            lambda: SOFT.with_residual_stress([0.0], [1e12]),
            "sxx of residual_stress must be at most Young's modulus in magnitude",
        ),
        (lambda: SOFT.with_residual_stress([0.0, 2e-3], [-2e9, 0.0]), "at z = 0 m must be at"),
        (
            # The stress is below the constant yield stress, but not where the profile is weak.
            lambda: SOFT.with_yield_profile(
                [0.0, 1e-3, 2e-3], [1.0, 0.1, 1.0]
            ).with_residual_stress([0.0, 2e-3], [5e8, 5e8]),
            "at z = 0.001 m must be at most the yield stress there, 1e+08 Pa",
        ),
    ],
)
def test_unsupported_arguments_are_refused(make, text):
    with pytest.raises(ValueError, match=re.escape(text)):
        make()


def test_a_profile_beyond_the_countable_layers_is_refused():
    body = SOFT.with_yield_profile([0.0, 1.0], [1.0, 2.0])
    grid = sc.Grid(5, 5, 1e-6, 1e-6, dz=1e-7)
    with pytest.raises(
        ValueError, match="the maximum depth of a yield profile, residual stress or layers"
    ):
        sc.Simulation(grid, RIGID, body, np.zeros((5, 5)))


def test_a_case_file_gives_the_same_material():
    from samcontact.cases.bodies import BodySection

    read = TypeAdapter(BodySection).validate_python
    given = {"law": "perfect_plastic", "E": E, "nu": NU, "yield_stress": Y}
    profile = {"z": ["0 um", "20 um", "0.03 mm", 60e-6], "factor": WEAK[1]}
    stress = {"z": [0.0, "0.1 mm"], "sxx": ["-200 MPa", 0.0], "sxy": [1e7, 0.0]}
    body = read(given | {"yield_profile": profile, "residual_stress": stress}).build()
    expected = PLAIN.with_yield_profile(*WEAK)
    assert body == expected.with_residual_stress([0.0, 1e-4], [-2e8, 0.0], sxy=[1e7, 0.0])
    with pytest.raises(ValidationError, match="must be at most the yield stress there"):
        read(given | {"residual_stress": {"z": [0.0], "sxx": [2e9]}})


@pytest.mark.parametrize("profile", [WEAK, ([0.0], [2.0])], ids=["several", "one"])
def test_results_and_figures_show_the_profile(profile, tmp_path):
    body = sc.Material.tabulated(E, NU, [0.0, 1e-3], [Y, 2 * Y]).with_yield_profile(*profile)
    body = body.with_residual_stress([0.0, 1e-4], [-2e8, 0.0], [-1e8, 0.0])
    grid = sc.Grid(9, 9, 60e-6, 60e-6, 6, 40e-6)
    sim = sc.Simulation(grid, RIGID, body, sc.surfaces.paraboloid(grid, 7.5e-3))
    state = sim.step(load=20.0)
    results.save(results.to_dataset(sim, [state]), tmp_path / "results.nc")
    with results.open_results(tmp_path / "results.nc") as dataset:
        assert graded_of(dataset, 2) == body
        assert graded_of(dataset, 1) is None
    ax = plotting.axis_profile(state.stress(), grid, body=body)
    lines = {line.get_label(): line.get_xydata() for line in ax.lines}
    limit = lines["initial yield stress"]
    np.testing.assert_allclose(limit[:, 0], 1e-6 * Y * np.interp(limit[:, 1] * 1e-6, *profile))
    for name, at_surface in ((r"$\sigma_{xx}$", -200.0), (r"$\sigma_{yy}$", -100.0)):
        assert lines[f"initial {name}"][0] == pytest.approx([at_surface, 0.0])
