# SPDX-License-Identifier: GPL-3.0-or-later
"""Parameters of a sweep: refusals before any solve, and units of fields."""

import numpy as np
import pytest
from sweep_cases import CASE

import samcontact as sc
from samcontact.cases.field_units import field_unit
from samcontact.sweeps import worker


@pytest.fixture
def none_solved(monkeypatch):
    monkeypatch.setattr(worker, "solve_case", lambda *_: pytest.fail("a case was solved"))


@pytest.mark.parametrize(
    ("given", "mode", "message"),
    [
        (
            {"body2.yeild_stress": [1e9]},
            "product",
            r"body2\.yeild_stress: unknown field; did you mean body2\.yield_stress\?; allowed here",
        ),
        ({"boddy2.E": [1e9]}, "product", r"boddy2\.E: unknown field; did you mean body2\.E\?"),
        ({"friction": [0.1]}, "product", r"did you mean contact\.friction\?"),
        ({"path[1].load": [1.0]}, "product", r"path\[1\]\.load: unknown.*mean path\[0\]\.load\?"),
        ({"title.x": [1.0]}, "product", r"title\.x: unknown field; did you mean title\?"),
        (
            {"path[0].load": [300.0], "contact.friction": [0.1, -0.1]},
            "product",
            r"contact\.friction: .*>= 0, got -0\.1 "
            r"\(sweep: path\[0\]\.load = 300\.0, contact\.friction = -0\.1\)",
        ),
        ({"grid.nx": [15, 1.5]}, "product", r"grid\.nx: .*whole number >= 1, got 1\.5"),
        (
            {"body1.E": ["stiff"]},
            "product",
            r"body1\.E: .*number and a unit that converts to Pa, got 'stiff'",
        ),
        ({"grid.dz": [0.0]}, "product", r"grid\.dz: .*\(sweep: grid\.dz = 0\.0\)"),
        ({"body1.nu": list(np.arange(0.5, 0.9, 0.01))}, "product", r"\nand 30 more$"),
        ({"body1.E": [2e11], "body1.nu": [0.2, 0.3]}, "zip", r"body1\.E 1, body1\.nu 2"),
        ({"body1.E": [2e11]}, "grid", "mode must be one of 'product', 'zip', got 'grid'"),
        ({"body1.E": [1e11, 10**11]}, "product", r"values of body1\.E must be different"),
        ({"body1.E": []}, "product", r"body1\.E must have at least one value"),
        ({"body1.E": "1e9"}, "product", r"body1\.E must have a sequence of values, got '1e9'"),
        ({"body1.E": 1e9}, "product", r"body1\.E must have a sequence of values"),
        ({"body1 E": [1e9]}, "product", r"parameter names must be like .*got 'body1 E'"),
        ({}, "product", "parameters must map at least one field to values"),
    ],
)
def test_bad_parameters_are_refused_before_anything_runs(
    given, mode, message, none_solved, tmp_path
):
    with pytest.raises((ValueError, TypeError), match=message):
        sc.sweep(CASE, given, mode=mode, output=tmp_path / "out", progress=False)
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("executor", ["four", 0, True])
def test_bad_executors(executor, none_solved):
    with pytest.raises((ValueError, TypeError), match="executor must be"):
        sc.sweep(CASE, {"body1.nu": [0.3]}, executor=executor, progress=False)


@pytest.mark.parametrize(
    ("name", "unit"),
    [
        ("body2.yield_stress", "Pa"),
        ("body1.thermal.diffusivity", "m²/s"),
        ("body2.C", "microstrain"),
        ("heat.velocity[0]", "m/s"),
        ("path[3].roll.distance", "m"),
        ("path[0].load", "N"),
        ("asperities.depth", ""),
        ("relief1.depth", "m"),
        ("grid.nx", ""),
    ],
)
def test_units_are_those_of_the_models(name, unit):
    assert field_unit(name) == unit
