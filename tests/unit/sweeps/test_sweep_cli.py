# SPDX-License-Identifier: GPL-3.0-or-later
"""The command ``samcontact sweep``: values from the command line, its table, files, exit codes."""

import csv
import os
import signal
import subprocess
import sys
import time

import matplotlib.image as plt
import pytest

import samcontact as sc
from case_texts import MINIMAL
from command import check_failure, invoke
from comparing import assert_stored
from samcontact import results
from samcontact.cases import load_case
from samcontact.commands.solve_sweep import parse_settings
from samcontact.sweeps import worker


def test_settings_of_the_command():
    text = ["body2.yield_stress=1e9, 2e9", "body1.law=elastic,rigid", "contact.friction=0,1.,.5"]
    assert parse_settings([*text, "heat.velocity=[1,0],[2,0]"]) == {
        "body2.yield_stress": [1e9, 2e9],
        "body1.law": ["elastic", "rigid"],
        "contact.friction": [0, 1.0, 0.5],
        "heat.velocity": [[1, 0], [2, 0]],
    }


@pytest.fixture
def case_file(tmp_path):
    path = tmp_path / "case.toml"
    path.write_text(MINIMAL)
    return path


def test_the_command_end_to_end(case_file, tmp_path):
    out = tmp_path / "out"
    outcome = invoke(
        "sweep", case_file, "--set", "path[0].load=300,600", "--set", "contact.friction=0.1",
        "--output", out, "--jobs", 2,
    )  # fmt: skip
    assert outcome.exit_code == 0, outcome.output
    assert outcome.stdout.splitlines()[-1] == str(out / "sweep.nc")
    assert "path[0]." in outcome.stdout
    assert outcome.stdout.count("done") == 2
    with open(out / "sweep.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [row["path[0].load [N]"] for row in rows] == ["300.0", "600.0"]
    assert plt.imread(out / "sweep.png").shape[2] == 4
    with results.open_results(out / "sweep.nc") as found:
        assert found.sizes == {"path[0].load": 2, "contact.friction": 1, "increment": 3}
        # the table shows the peak, not the end
        peak = float(found["max_pressure"].sel({"path[0].load": 300.0, "increment": 2})[0])
        assert f"{peak * 1e-6:.1f}" in outcome.stdout
        assert float(rows[0]["max_pressure [Pa]"]) == peak
        expected = sc.sweep(
            load_case(case_file),
            {"path[0].load": [300, 600], "contact.friction": [0.1]},
            progress=False,
        )
        assert_stored(found, expected)


def test_the_command_reports_failed_cases(case_file, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    outcome = invoke("sweep", case_file, "--set", "path[0].load=300,9e13", "--quiet")
    assert outcome.exit_code == 1
    written = [f"results/case/sweep/sweep.{ending}" for ending in ("csv", "nc")]
    assert outcome.stdout.splitlines() == written  # one case is no curve
    assert outcome.stderr.startswith("1 of 2 cases failed\n  GridTooSmallError: at load ")
    with results.open_results("results/case/sweep/sweep.nc") as found:
        assert found["status"].values.tolist() == ["done", "failed"]


def test_the_command_interrupted(case_file, tmp_path, monkeypatch):
    def stopped(content, source):
        raise KeyboardInterrupt

    monkeypatch.setattr(worker, "solve_case", stopped)
    setting = ("--set", "path[0].load=300,600", "--output", tmp_path, "--quiet")
    outcome = invoke("sweep", case_file, *setting)
    assert outcome.exit_code == 130
    assert outcome.stderr == "2 of 2 cases cancelled\n"


def test_ctrl_c_also_ends_the_workers(case_file, tmp_path):
    loads = ",".join(str(300 + i) for i in range(400))
    command = [sys.executable, "-m", "samcontact", "sweep", str(case_file), "--jobs", "1"]
    command += ["--set", f"path[0].load={loads}", "--output", str(tmp_path), "--quiet"]
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    # as in a terminal, Ctrl-C goes to the command and all its workers
    with subprocess.Popen(command, start_new_session=True, **pipes) as process:
        while process.poll() is None and not list(tmp_path.glob("cases/*.h5")):
            time.sleep(0.02)
        os.killpg(process.pid, signal.SIGINT)
        _, errors = process.communicate()  # until all that share the pipes have gone
    assert process.returncode == 130
    done = len(list(tmp_path.glob("cases/*.h5")))
    assert done >= 1
    assert errors.splitlines()[-1] == f"{400 - done} of 400 cases cancelled"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--set", "body2.yield=1e9"), "body2.yield: unknown field; did you mean"),
        (("--set", "body2.B"), "--set must be FIELD=VALUE,VALUE,..., got 'body2.B'"),
        (("--set", "body2.B=1", "--set", "body2.B=2"), "got body2.B twice"),
        (
            ("--set", "body2.B=1", "--jobs", "1", "--dask", "tcp://x"),
            "--jobs and --dask cannot be combined",
        ),
    ],
)
def test_bad_use_of_the_command(case_file, arguments, message):
    check_failure(invoke("sweep", case_file, *arguments, "--quiet"), 2, message)


BEARING = """title = "bearing"
[bearing]
designation = "6208"
radial_load = 1e3
[body1]
material = "52100"
[body2]
material = "52100"
hardness = {surface = 390.0, core = 250.0, depth = 1e-3, limit = 320.0}
[fatigue]
steady_axis = "x"
exposure = {}
[output]
figures = false
"""


def test_fields_of_a_bearing_and_of_its_hardness_with_units(tmp_path):
    file, out = tmp_path / "case.toml", tmp_path / "out"
    file.write_text(BEARING)
    outcome = invoke(
        "sweep", file, "--set", "bearing.radial_load=9 kN,18 kN", "--set",
        "body2.hardness.depth=1 mm,2e-3", "--output", out, "--quiet",
    )  # fmt: skip
    assert outcome.exit_code == 0, outcome.output
    with results.open_results(out / "sweep.nc") as found:
        loads, depths = (found[n] for n in ("bearing.radial_load", "body2.hardness.depth"))
        assert (loads.values.tolist(), loads.attrs["units"]) == ([9e3, 18e3], "N")
        assert (depths.values.tolist(), depths.attrs["units"]) == ([1e-3, 2e-3], "m")
        peak = found["load"].max("increment")
        assert peak.values[:, 0] == pytest.approx([5e3, 10e3])  # 5/9 on one ball
        exposure = found["exposure_yield"].values
        assert exposure[0, 0] > exposure[0, 1]  # a deeper case is stronger
    wrong = invoke("sweep", file, "--set", "bearing.radial_laod=1e3,2e3", "--output", out)
    assert "bearing.radial_laod: unknown field; did you mean bearing.radial_load?" in wrong.stderr
    assert not (out / "sweep.png").exists()
