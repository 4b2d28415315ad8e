# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs to an accuracy: estimated errors exceed the true ones, or a remedy is named."""

import json
import math
import warnings
from pathlib import Path

import numpy as np
import pytest

import samcontact as sc
from samcontact import results
from samcontact.accuracy import estimate, increments
from samcontact.accuracy.refinable_case import GridRun, RefinableCase
from samcontact.cases import Case as SectionsOfCase
from samcontact.cases import CaseError
from samcontact.simulation import error_controlled_quantities

REFERENCE = Path(__file__).parents[3] / "reference"
STEEL = {"law": "elastic", "E": 210e9, "nu": 0.3}
SWIFT = {"law": "swift", "E": 210e9, "nu": 0.3, "B": 945e6, "C": 20.0, "n": 0.121}
BALL = {"shape": "paraboloid", "Rx": 7.5e-3}
ELASTIC = {"body1": STEEL, "body2": STEEL, "surface": BALL, "path": [{"load": 1500.0}]}
YIELDING = ELASTIC | {"body2": SWIFT, "path": [{"load": 1500.0}, {"load": 0.0}]}
ROUGH = {"kind": "self_affine", "rms_height": 1e-8, "hurst": 0.7, "seed": 1}


@pytest.mark.parametrize("ratio", [1.0, 5.0])
def test_hertz_contact_is_closer_than_the_stated_error(ratio):
    case = ELASTIC | {"surface": BALL | {"Ry": 7.5e-3 * ratio}}
    found = sc.to_accuracy(case, 0.01)
    body = sc.Material.elastic(210e9, 0.3)
    hertz = sc.hertz.elliptic(
        7.5e-3, 7.5e-3 * ratio, sc.hertz.effective_modulus(body, body), load=1500.0
    )
    truth = {
        "max_pressure": hertz.p0,
        "approach": hertz.approach,
        "contact_area": math.pi * hertz.a_x * hertz.a_y,
    }
    assert "load" not in found.values  # which is given
    assert found.reached
    for name, exact in truth.items():
        assert found.errors[name] <= 0.01 * abs(found.values[name])
        assert abs(found.values[name] - exact) <= found.errors[name] + 1e-9 * exact
    # of the smallest windows and grids, each of which costs a part of the last
    cells = [nx * ny for nx, ny, *_ in found.runs]
    assert cells == sorted(cells)
    assert cells[-1] < 10_000


@pytest.mark.parametrize(
    "name", ["4_1", pytest.param("0.25_0.1", marks=pytest.mark.slow), "thin_stiff"]
)
def test_coated_bodies_are_closer_than_the_stated_error(name):
    """Against solutions of the integral equation of a ball on a layer."""
    case = json.loads((REFERENCE / "layers" / "coated.json").read_text())[name]
    *layers, (E, nu, _) = case["layers"]
    E_star = E / (1 - nu**2)
    coated = {
        "law": "elastic", "E": E * 1e11, "nu": nu,
        "layers": [{"E": e * 1e11, "nu": n, "thickness": h} for e, n, h in layers],
    }  # fmt: skip
    found = sc.to_accuracy(
        {
            "body1": {"law": "rigid"}, "body2": coated,
            "surface": {"shape": "paraboloid", "Rx": 2 * E_star / math.pi},
            "path": [{"load": 2 / 3 * math.pi * 1e11}],
        },
        0.005,
    )  # fmt: skip
    assert found.reached
    # Stress jumps at interfaces, so it is not among the reported values.
    assert set(found.values) == {"max_pressure", "approach", "contact_area"}
    truth = {
        "max_pressure": case["p_max"] * 1e11,
        "approach": case["approach"] * math.pi / (2 * E_star),
    }
    for quantity, exact in truth.items():
        error = abs(found.values[quantity] - exact)
        assert error <= found.errors[quantity] + 1e-6 * exact
        assert found.errors[quantity] <= 0.005 * exact
    assert found.values["contact_area"] == pytest.approx(math.pi * case["a"] ** 2, rel=0.005)
    assert found.to_dataset().sizes["x"] == found.runs[-1][0]


def layered(*thicknesses, E=400e9):
    layers = [{"law": "elastic", "E": E, "nu": 0.25, "thickness": h} for h in thicknesses]
    return SWIFT | {"layers": layers}


def test_yield_below_a_coating_is_closer_than_the_stated_error():
    """Against finite elements, whose cells are a quarter of the finest here."""
    known = json.loads((REFERENCE / "layers" / "yielding" / "case.json").read_text())
    found = sc.to_accuracy(
        {
            "body1": {"law": "rigid"}, "body2": layered(known["coating"]["thickness_m"]),
            "surface": {"shape": "paraboloid", "Rx": known["R_m"]},
            "path": [{"load": known["W_N"]}],
        },
        0.2,
        quantities=["max_pressure", "approach", "max_equivalent_plastic_strain_body2"],
    )  # fmt: skip
    assert found.reached
    truth = known["summary"]
    exact = truth["p_center_Pa"], truth["approach_max_m"], truth["gamma_p_max_anywhere"]
    for (name, value), expected in zip(found.values.items(), exact, strict=True):
        assert abs(value - expected) <= found.errors[name] <= 0.01 * expected
    # The coating bends: its stress is largest at the interface, and jumps there.
    inside, *faces, below, top = error_controlled_quantities.parts(
        found.states[-1], "max_von_mises_body2"
    )
    assert inside < max(faces) == pytest.approx(truth["loaded"]["max_vm_Pa"], rel=5e-3)
    assert top < below == pytest.approx(2.6094e9, rel=2e-3)


def test_elastic_plastic_layers_end_between_cells_on_all_grids():
    bodies = {"body1": layered(1e-4), "body2": layered(6e-5, 5e-5)}
    case = SectionsOfCase.model_validate({"title": "x", "accuracy": 0.1, **ELASTIC, **bodies})
    problem = RefinableCase(case)
    depths = [problem.on(level, 1).grid.dz for level in range(9)]
    for dz in depths:
        cells = np.array([6e-5, 1e-4, 11e-5]) / dz
        assert cells == pytest.approx(np.round(cells), abs=1e-9)
    shrink = np.array(depths[1:]) / depths[:-1]
    assert shrink[:4] == pytest.approx(math.sqrt(0.5), rel=0.1)
    assert shrink[4:] == pytest.approx(math.sqrt(0.5), rel=0.03)


def test_elastic_plastic_balls_agree_with_a_run_on_the_finest_grid():
    found = sc.to_accuracy(YIELDING, 0.05)
    assert found.reached
    # of T1 with 512 increments on a grid that is four times as fine
    truth = {
        "max_pressure": 3.9806e9,
        "approach": 2.33646e-5,
        "contact_area": 5.525e-7,
        "max_von_mises_body2": 2.3506e9,
        "max_equivalent_plastic_strain_body2": 1.845e-3,
        "max_residual_von_mises_body2": 1.3355e8,
        "imprint_depth_body2": 2.999e-7,
    }
    for name, exact in truth.items():
        assert abs(found.values[name] - exact) <= found.errors[name] <= 0.05 * exact
    simulation, path = found.case.build()
    assert simulation.grid == found.case.grid.build()
    states = simulation.run(path, progress=False)
    for mine, theirs in zip(states, found.states, strict=True):
        assert np.array_equal(mine.pressure, theirs.pressure)
    depth = error_controlled_quantities.value(states[-1], "imprint_depth_body2")
    assert abs(depth / found.values["imprint_depth_body2"] - 1) < 0.05
    dataset = found.to_dataset()
    end = dataset.isel(increment=-1)
    assert float(end["imprint_depth_body2_best"]) == found.series["imprint_depth_body2"][-1]
    assert float(end["imprint_depth_body2_error"]) == found.series_errors["imprint_depth_body2"][-1]
    assert results.scalars(dataset)["max_residual_von_mises_body2_best"].notnull().sum() == 2


def test_a_graded_body_agrees_with_finer_grids():
    """The body has a hardened case with residual compression along the surface."""
    graded = SWIFT | {
        "yield_profile": {"z": [0.0, 1.2e-4, 2.4e-4], "factor": [1.4, 1.3, 1.0]},
        "residual_stress": {"z": [0.0, 1e-4, 2e-4], "sxx": [-4e8, -3e8, 0.0]},
    }
    found = sc.to_accuracy(YIELDING | {"body2": graded}, 0.05)
    assert found.reached
    # of the same case to 0.01, whose last grid has 257 x 257 cells
    truth = {
        "max_pressure": 4.0326e9,
        "approach": 2.33482e-5,
        "contact_area": 5.513e-7,
        "max_residual_von_mises_body2": 4.786e8,
        "imprint_depth_body2": 1.6514e-7,
    }
    for name, exact in truth.items():
        assert abs(found.values[name] - exact) <= found.errors[name] <= 0.05 * exact
    # Kinks of strength lie between layers; maxima there are known only to the prescribed accuracy.
    assert found.values["max_von_mises_body2"] == pytest.approx(2.4347e9, rel=0.005)
    assert found.values["max_equivalent_plastic_strain_body2"] == pytest.approx(1.683e-3, rel=0.05)


def test_only_segments_with_plastic_flow_have_many_increments():
    path = [{"approach": 2.5e-5}, {"load": 900.0, "start": 1800.0}, {"load": 0.0}]
    case = SectionsOfCase.model_validate({"title": "x", "accuracy": 0.1, **YIELDING, "path": path})
    problem = RefinableCase(case)
    run = problem.run(0, 2)
    problem.settle(run)
    # from 1800 N, which the approach does not reach, it is loaded on
    counts = [segment.increments for segment in problem.on(1, 4).path]
    assert counts == [4, 32, 1]
    assert case.contact.tol == problem.on(1, 4).contact.tol == 1e-6
    problem.accept(0.01)
    assert problem.on(1, 4).contact.tol == 1e-4


def test_corrections_of_first_order_hold_on_other_grids():
    doubled = np.array([1.0, 1.0, 1.0, 0.0])
    more = np.array([2.0, 9.0, -2.0, 0.5])
    assert np.array_equal(estimate.irregular(more, doubled), [0.0, 7.0, 4.0, 0.5])


def test_corrections_come_from_the_grid_that_resolves_the_value():
    # in n increments: 0.5 + 1/n on the coarsest grid, which has half of the value; else 1 - 1/n
    def run(grid, n):
        value = 0.5 + 1.0 / n if grid == 1 else 1.0 - 1.0 / n
        return GridRun(grid, n, (9, 9), np.array([[value]]), (1.0, 1.0), [], 0.0, 0.0)

    runs = {(1, n): run(1, n) for n in (2, 4, 8)} | {(3, 2): run(3, 2)}
    finest = runs[3, 2].values
    wrong = increments.correction(runs, 2, finest)
    missing = 1.0 - finest - wrong.values
    assert abs(missing) > 2 * wrong.errors  # the series itself does not show this
    assert abs(missing) <= np.sum(wrong.by_grid)
    runs |= {(3, n): run(3, n) for n in (4, 8)}
    found = increments.correction(runs, 2, finest)
    assert found.doublings == [(2, 3), (4, 3)]
    assert found.values == pytest.approx(1.0 - finest, rel=1e-12)
    assert np.sum(found.by_grid) == pytest.approx(0.03 * abs(found.values), rel=1e-12)


THERMAL = {"conductivity": 50.2, "expansion": 11.7e-6, "diffusivity": 1.367e-5}
ROLLED = {"load": 1500.0, "roll": {"distance": 1.5e-4, "step": 1e-6, "unload_increments": 1}}
HEATED = {
    "body2": SWIFT | {"thermal": THERMAL},
    "heat": {"factor": 0.05, "history": [1e-3, 10.0]},
    "path": [{"load": 1500.0, "duration": 0.01}],
}


@pytest.mark.parametrize(
    ("change", "marks"),
    [
        ({"body1": SWIFT, "contact": {"friction": 0.1}, "path": [{"load": 1500.0}]}, (1,)),
        ({"path": [{"approach": 2.3e-5}]}, (1,)),
        ({"path": [ROLLED]}, (6, 7)),  # in steps of a cell
        (HEATED, (1,)),
    ],
    ids=["friction", "approach", "rolling", "heat"],
)
def test_all_kinds_of_cases_have_values_at_their_marks(change, marks):
    found = sc.to_accuracy(YIELDING | change, 0.3, quantities=["max_pressure", "contact_area"])
    assert found.reached
    assert found.increments == marks
    loads = [found.states[m].load for m in marks]
    assert loads[0] > 1400.0
    # plastic flow lowers the pressure below Hertz's 4.1 GPa on a larger area; heat has a bulge
    assert 3.5e9 < found.values["max_pressure"] < 5e9
    assert np.all(found.series["max_pressure"][1:] == 0.0)


def test_the_memory_limit_returns_the_best_values_so_far():
    with pytest.warns(sc.AccuracyWarning, match=r"contact_area is .* would require about .* GB"):
        found = sc.to_accuracy(ELASTIC, 1e-4, quantities=["contact_area"], max_memory=2e7)
    assert not found.reached
    assert list(found.values) == ["contact_area"]
    assert 1e-4 < found.relative_errors["contact_area"] < 0.1


def test_a_zero_time_limit_still_gives_errors_from_three_grids():
    with pytest.warns(sc.AccuracyWarning, match="finer grids would require"):
        found = sc.to_accuracy(ELASTIC, 1e-5, max_time=1e-9)
    assert len(found.runs) == 3
    assert 1e-5 < max(found.relative_errors.values()) < 0.1


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (
            {"surface": {"shape": "file", "path": "h.npy"}},
            "surface is given by heights at sample points.*add .grid.",
        ),
        ({"surface": BALL | {"roughness": ROUGH}}, "surface is given by heights at sample points"),
        ({"relief2": ROUGH}, "relief2 is given by heights at sample points.*requires .grid."),
        ({"surface": {"shape": "cylinder", "R": 1e-3}}, "surface.shape = 'cylinder'.*periodic"),
        ({"path": [{"approach": -1e-6}]}, "path: at least one load"),
        ({"path": [{"load": 1.0, "increments": 3}]}, r"path\[0\].increments cannot be"),
        ({"accuracy": {"print": 0.1}}, "quantities must be any of.*got 'print'"),
        ({"accuracy": 2.0}, "accuracy"),
        ({"body2": layered(1e-5, math.pi * 1e-5)}, "layers: the depths.*multiples of a"),
        ({"body1": layered(1e-8)}, "layers: the depths .* 1e-08 m.* >= .*e-06 m"),
    ],
)
def test_unsupported_cases_are_refused_by_name(change, message):
    with pytest.raises(ValueError, match=message):
        sc.to_accuracy({"accuracy": 0.01} | ELASTIC | change)


def test_a_case_needs_a_grid_or_an_accuracy():
    grid = {"nx": 8, "ny": 8, "dx": 1e-4, "dy": 1e-4}
    with pytest.raises(CaseError, match=r"grid: \[grid\] is missing: add"):
        sc.to_accuracy(ELASTIC)
    with pytest.raises(CaseError, match="grid cannot be combined with accuracy"):
        sc.to_accuracy(ELASTIC | {"grid": grid, "accuracy": 0.01})
    with pytest.raises(CaseError, match="max_time has no effect without accuracy"):
        sc.to_accuracy(ELASTIC | {"grid": grid, "max_time": 1.0}, 0.01)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert sc.to_accuracy(ELASTIC | {"grid": grid}, 0.1).grid.dx < 1e-4


@pytest.mark.parametrize("order", [1.0, 1.5, 2.0])
def test_orders_are_recognised_and_noise_is_not_extrapolated(order):
    cells = 2.0 ** (0.5 * np.arange(6))
    clean = estimate.extrapolate_grids(3.0 + 0.7 * cells**-order)
    assert clean.extrapolated
    assert abs(clean.values - 3.0) < 1e-12
    assert clean.errors > 0
    noisy = 3.0 + 0.7 * cells**-order * np.array([1.0, -0.4, 1.2, 0.6, -0.8, 1.0])
    found = estimate.extrapolate_grids(noisy)
    assert not found.extrapolated
    assert found.values == noisy[-1]
    assert abs(found.values - 3.0) < found.errors
    halves = 2.0 ** np.arange(4)
    more = estimate.extrapolate_increments(np.diff(5.0 + 2.0 / halves), used=1)
    assert more.values == pytest.approx(-1.0, rel=1e-12)
