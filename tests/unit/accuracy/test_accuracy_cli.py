# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files with a prescribed accuracy: values and errors in output, results and reports."""

import numpy as np
import pytest

import samcontact as sc
from command import check_failure, fields, invoke
from samcontact import report

TEXT = """title = "ball to an accuracy"
accuracy = {max_pressure = "X", contact_area = 0.1}

[body1]
law = "rigid"

[body2]
law = "elastic"
E = 210e9
nu = 0.3

[surface]
shape = "paraboloid"
Rx = 7.5e-3

[[path]]
load = 100.0

[[path]]
load = 400.0
"""


@pytest.fixture
def case(tmp_path):
    file = tmp_path / "ball.toml"
    file.write_text(TEXT.replace('"X"', "0.02"))
    return file


def test_values_come_with_errors(case, tmp_path, undrawn):
    outcome = invoke("run", case, "--output", tmp_path / "out", "--no-figures")
    assert outcome.exit_code == 0, outcome.output
    assert "Estimated errors" in outcome.stdout
    data = fields(tmp_path / "out")
    ratio = data["max_pressure_best"][1] / data["max_pressure_best"][0]
    assert float(ratio) == pytest.approx(4 ** (1 / 3), rel=2e-3)  # Hertz
    assert np.all(data["max_pressure_error"] <= 0.02 * data["max_pressure_best"].max())
    # all solved values are of one kind, from which the checks are computed
    assert np.array_equal(data["max_pressure"], data["pressure"].max(("x", "y")))
    assert all(check.passed for check in report.checks(data))
    assert data["max_pressure_error"].attrs["accuracy"] == 0.02
    assert "approach_error" not in data
    checks = [v for v in report.checks(data) if v.name.startswith("estimated relative error")]
    assert [check.limit for check in checks] == [0.02, 0.1]
    assert all(check.passed for check in checks)
    report.write(data, tmp_path / "report.html")
    assert "Results with estimated errors" in (tmp_path / "report.html").read_text(encoding="utf-8")


def test_invalid_accuracies_are_refused(case, tmp_path):
    case.write_text(TEXT)
    outcome = invoke("run", case, "--output", tmp_path / "out")
    check_failure(outcome, 2, "accuracy: must be a relative error in (0, 1)", "got 'X'")


def test_a_sweep_has_errors_of_all_its_cases(case):
    case.write_text(TEXT.replace('"X"', "0.02"))
    swept = sc.sweep(case, {"path[1].load": [200.0, 800.0]}, progress=False)
    assert list(swept["status"].values) == ["done", "done"]
    last = swept.isel(increment=1)
    ratio = last["max_pressure_best"].values[1] / last["max_pressure_best"].values[0]
    assert ratio == pytest.approx(4 ** (1 / 3), rel=2e-3)
    assert np.all(last["max_pressure_error"] < 0.02 * last["max_pressure_best"])
