# SPDX-License-Identifier: GPL-3.0-or-later
"""Grid errors estimated from cells twice as large agree with the true errors."""

import math
import warnings

import numpy as np
import pytest

import samcontact as sc
from case_texts import MINIMAL, SWIFT
from command import fields, invoke
from samcontact import report, results
from samcontact.cases import parse_case
from samcontact.problem.moving_topography import heights_over
from samcontact.simulation import coarsening
from samcontact.simulation.repeated import coarsened

STEEL = sc.Material.elastic(210e9, 0.3)
R, LOAD = 7.5e-3, 1500.0
HERTZ = sc.hertz.point(R, sc.hertz.effective_modulus(STEEL, STEEL), load=LOAD)
TRUTH = {
    "approach": HERTZ.approach,
    "max_pressure": HERTZ.p0,
    "contact_area": math.pi * HERTZ.a**2,
    "max_von_mises_body2": HERTZ.max_von_mises(0.3)[0],
}


def pressed(cells, odd, known=True):
    """Estimate the errors of an elastic ball; `known`: the gap is a function of the grid."""
    n, d = 2 * math.ceil(1.3 * cells) + odd, HERTZ.a / cells
    grid = sc.Grid(n, n, d, d, dz=d)
    gap = sc.surfaces.paraboloid(grid, R)
    run = sc.Simulation(
        grid, STEEL, STEEL, (lambda g: sc.surfaces.paraboloid(g, R)) if known else gap
    )
    path = [{"load": LOAD}]
    return sc.estimate_errors(run, path, run.run(path, progress=False))


def test_true_errors_are_below_those_stated():
    shares = []
    for cells in (6.0, 8.5, 12.2, 16.0):
        for odd in (0, 1):
            found = pressed(cells, odd)
            for name, truth in TRUTH.items():
                error = float(found.errors[name][0])
                assert error < 0.06 * truth
                shares.append(abs(float(found.values[name][0]) - truth) / error)
    assert max(shares) < 3.0
    assert np.mean(np.array(shares) < 1.0) > 0.9
    assert np.median(shares) > 0.2


@pytest.mark.parametrize("odd", [0, 1])
def test_heights_of_one_grid_give_the_errors_of_a_function(odd):
    known, given = pressed(8.0, odd), pressed(8.0, odd, known=False)
    for name in ("approach", "max_pressure"):
        assert given.errors[name] == pytest.approx(known.errors[name], rel=0.02)
    assert math.isnan(given.slope_beyond)


@pytest.mark.parametrize(("n", "first", "periodic"), [(8, 1, False), (7, -4, False), (9, 3, True)])
def test_a_relief_is_averaged_at_its_position(n, first, periodic):
    fine = sc.Grid(n, 5, 1e-6, 1e-6)
    grid = coarsening.coarser_grid(fine)
    heights = np.random.default_rng(3).normal(size=(6, 5))
    relief = sc.Relief(heights, first, periodic)
    coarse = coarsening._relief(relief, fine, grid)
    quarters = np.repeat(heights_over(relief, -24, n + 48, fine), 2, 0)  # halves of cells, around
    middle = 24 * 2 + n
    for row in range(-4, grid.nx + 4):
        at = middle + round(4 * (row - 0.5 * grid.nx))
        expected = quarters[at : at + 4].mean(0)
        (found,) = heights_over(coarse, row, 1, grid)
        assert found[1:-1] == pytest.approx(
            [0.5 * expected[2] + 0.25 * (expected[1] + expected[3])]
        )


def test_increments_that_move_by_a_cell_become_one_of_two():
    roll = {"load": 1.0, "advance": (1e-6, 1e-6)}
    path = [{"load": 1.0}, roll, roll, roll, {"load": 0.0}]
    steps, which = coarsening.coarser_path(path, (1e-6, None))
    assert [step.get("advance") for step in steps] == [None, (2e-6, 2e-6), (1e-6, 1e-6), None]
    assert which == [0, 1, 1, 2, 3]


def test_unresolved_slope_is_that_of_short_waves():
    x = np.arange(128.0)
    waves = np.cos(2 * np.pi * x / 16)[:, None] + 0.2 * np.cos(2 * np.pi * x / 3)[None, :]
    # slopes are as heights over lengths
    share = (0.2 / 3) ** 2 / ((0.2 / 3) ** 2 + (1 / 16) ** 2)
    smooth = 0.01 * (x[:, None] ** 2 + x[None, :] ** 2)
    found = coarsening.slope_beyond(waves + smooth, 1.0, 1.0)
    assert found == pytest.approx(share, rel=1e-2)
    assert math.isnan(coarsening.slope_beyond(smooth, 1.0, 1.0))


def run(folder, text):
    """Run the command; return its output and results."""
    file = folder / "case.toml"
    file.write_text(text, encoding="utf-8")
    outcome = invoke("run", file, "--no-figures", "--output", folder)
    assert outcome.exit_code == 0, outcome.output
    return outcome.stdout, fields(folder)


def test_a_run_of_a_case_has_errors_and_changes_nothing_else(tmp_path):
    stated, on = run(tmp_path, MINIMAL)
    assert "Estimated grid errors" in stated
    more = {name for name in on if name.endswith("_error")}
    assert {"max_pressure_error", "contact_area_error", "imprint_depth_body2_error"} <= more
    case = parse_case(MINIMAL)
    simulation, path = case.build()
    plain = results.to_dataset(simulation, simulation.run(path, progress=False), case)
    for name in plain:
        np.testing.assert_array_equal(on[name].values, plain[name].values)
    names = [check.name for check in report.checks(on)]
    assert any("maximum estimated relative" in name for name in names)


def test_errors_that_are_disabled_or_cannot_be_estimated(tmp_path):
    elastic = MINIMAL.replace(SWIFT, 'law = "elastic"\nE = 210e9\nnu = 0.3')
    stated, _ = run(tmp_path, f"estimate_error = false\n{elastic}")
    assert "Estimated grid errors" not in stated
    assert "could not estimate" not in stated
    stated, _ = run(tmp_path, elastic.replace("ny = 13", 'ny = 14\nperiodic = "y"'))
    assert "could not estimate the grid errors: on a periodic grid, ny must be a multiple" in stated


@pytest.mark.parametrize(("ends", "deeper"), [((2,), 2), ((3,), 3), ((5, 15), 2.5), ((3, 4), 1)])
def test_elastic_plastic_layers_end_between_the_coarser_cells(ends, deeper):
    """Layer boundaries fit the coarser cells only if they are multiples of a deeper cell; otherwise
    the errors exclude the depth."""
    soft, dz = sc.Material.perfect_plastic(210e9, 0.3, 1.5e9), 10e-6
    thicknesses = np.diff([0, *ends]) * dz
    body = sc.Layered([(soft, thickness) for thickness in thicknesses], soft)
    grid = sc.Grid(28, 28, 25e-6, 25e-6, dz=dz)
    run = sc.Simulation(grid, STEEL, body, sc.surfaces.paraboloid(grid, R))
    assert coarsened(run, run.heat).grid.dz == pytest.approx(deeper * dz)
    path = [{"load": 250.0}]
    with warnings.catch_warnings(record=True) as stated:
        warnings.simplefilter("always")
        found = sc.estimate_errors(run, path, run.run(path, progress=False))
    assert np.isfinite(found.errors["imprint_depth_body2"]).all()
    assert any("exclude the effect of dz" in str(w.message) for w in stated) == (deeper == 1)


def test_unresolved_roughness_is_reported(tmp_path):
    rough = '[surface.roughness]\nkind = "self_affine"\nrms_height = 1e-7\nhurst = 0.5\nseed = 1\n'
    elastic = MINIMAL.replace(SWIFT, 'law = "elastic"\nE = 210e9\nnu = 0.3')
    stated, dataset = run(tmp_path, elastic.replace("[[path]]", f"{rough}[[path]]", 1))
    assert "of the mean-square slope of the surface is at wavelengths below" in stated
    (check,) = [c for c in report.checks(dataset) if "mean-square slope" in c.name]
    assert check.value == dataset.attrs["slope_beyond"] > check.limit
