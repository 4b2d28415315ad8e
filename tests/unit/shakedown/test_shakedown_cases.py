# SPDX-License-Identifier: GPL-3.0-or-later
"""[shakedown] of a case file: output of the command against results from Python."""

import re

import numpy as np
import pytest
import xarray as xr

import samcontact as sc
from case_texts import BODIES, MINIMAL, MOVING
from command import check_failure, invoke, pressed
from samcontact import cases, report, results, shakedown
from samcontact.commands.folder import is_own

SHAKEDOWN = "[shakedown]\ncycles = 4\ntol = 0.002\n"


@pytest.fixture
def run(tmp_path):
    def run(text, *options):
        path = tmp_path / "case.toml"
        path.write_text(text)
        return invoke("run", path, "--output", tmp_path / "out", *options), tmp_path / "out"

    return run


def test_the_path_is_repeated(run, undrawn, monkeypatch):
    monkeypatch.setattr("samcontact.report.contact.contact_figures", lambda *_: [])
    outcome, folder = run(f"estimate_error = false\n{MINIMAL}\n{SHAKEDOWN}")
    assert outcome.exit_code == 0, outcome.output
    simulation, path = cases.parse_case(MINIMAL).build()
    expected = shakedown.run(simulation, path, cycles=4, tol=0.002, progress=False)
    assert len(expected.cycles) > 1
    with results.open_results(folder / "shakedown.nc") as found:
        assert found.attrs["response"] == expected.response
        np.testing.assert_array_equal(found["flow"], [c.flow for c in expected.cycles])
        np.testing.assert_array_equal(found["net"], [c.net for c in expected.cycles])
        np.testing.assert_array_equal(found["cycle"], [c.number for c in expected.cycles])
    assert expected.response in outcome.stdout
    assert (folder / "shakedown.png").exists()
    # so that a later run without it leaves nothing of it behind
    assert all(is_own(folder / name) for name in ("shakedown.nc", "shakedown.png"))
    page = invoke("report", folder)
    assert page.exit_code in (0, 1), page.output
    text = (folder / "report.html").read_text(encoding="utf-8")
    assert f"{expected.response} after {expected.cycles[-1].number} cycles" in text
    (table,) = re.findall(r'<table id="shakedown-table">.*?</table>', text, re.DOTALL)
    stored = re.findall(r'<data value="([^"]*)">', table)
    assert [float(value) for value in stored] == [
        value for cycle in expected.cycles for value in (cycle.flow, cycle.net)
    ]
    with (
        results.open_results(folder / "results.nc") as other,
        pytest.raises(ValueError, match=r"shakedown must be .* but has no flow, net, cycle"),
    ):
        report.write(other, folder / "other.html", shakedown=other)
    assert not (folder / "other.html").exists()


@pytest.mark.usefixtures("steps_alone")
def test_cycles_are_stored_however_the_run_ends(run, monkeypatch):
    text = f"estimate_error = false\n{MINIMAL}\n{SHAKEDOWN}"
    step, left = sc.Simulation.step, [3 + 3 + 1]  # path, first cycle

    def counted(self, **arguments):
        left[0] -= 1
        if left[0] == 0:
            pressed()
        return step(self, **arguments)

    with monkeypatch.context() as patch:
        patch.setattr(sc.Simulation, "step", counted)
        outcome, folder = run(text, "--no-figures")
        assert outcome.exit_code == 130
        assert "samcontact resume" in outcome.stderr
        left[0] = 3 + 1  # only the second cycle is solved
        assert invoke("resume", folder, "--quiet", "--no-figures").exit_code == 0
    simulation, path = cases.parse_case(MINIMAL).build()
    expected = shakedown.run(simulation, path, cycles=4, tol=0.002, progress=False)
    with xr.open_dataset(folder / "shakedown.nc") as found:
        np.testing.assert_array_equal(found["flow"], [c.flow for c in expected.cycles])
    assert not (folder / "checkpoints").exists()


ELASTIC = MINIMAL.replace(BODIES, BODIES[: BODIES.index("[body2]")] + """[body2]
law = "elastic"
E = 210e9
nu = 0.3
[surface]
shape = "paraboloid"
Rx = 7.5e-3""")  # fmt: skip


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (ELASTIC, "requires an elastic-plastic body"),
        (MOVING, "requires a closed path"),
        (f"{MINIMAL}\n[wear]\nthreshold = 0.002\n", "cannot be combined with wear"),
    ],
)  # fmt: skip
def test_unrepeatable_paths_are_refused_before_the_run(run, text, message):
    outcome, _ = run(f"{text}\n{SHAKEDOWN}")
    check_failure(outcome, 2, "shakedown", message)
