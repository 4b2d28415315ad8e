# SPDX-License-Identifier: GPL-3.0-or-later
"""The command: a small run from end to end, its output and exit codes."""

import os
import re
import resource
import subprocess
import sys

import pytest

import samcontact
from case_texts import ASPERITIES, MINIMAL, SWIFT
from command import check_failure, invoke
from samcontact import hertz, results

# Without a volume, for few figures.
SURFACES = MINIMAL.replace(SWIFT, 'law = "elastic"\nE = 210e9\nnu = 0.3').replace(
    "nz = 12\ndz = 60e-6", ""
)


@pytest.fixture
def case_file(tmp_path):
    path = tmp_path / "case.toml"
    path.write_text(MINIMAL)
    return path


def test_run_writes_results_figures_and_tables(case_file, tmp_path, undrawn):
    outcome = invoke("run", case_file, "--output", tmp_path / "out")
    assert outcome.exit_code == 0, outcome.output
    text = outcome.stdout
    assert "two balls" in text
    assert "Increments" in text
    assert "Comparison with elastic Hertz contact, increment 2, 600 N" in text
    assert "contact area [mm²]" in text
    files = [line for line in text.splitlines() if line.startswith(str(tmp_path))]
    assert [f.rsplit("/", 1)[1] for f in files] == [
        "results.nc",
        "pressure.png",
        "pressure_map.png",
        "gap_map.png",
        "axis_stress.png",
        "sections.png",
        "load_approach.png",
        "imprint.png",
        "imprint_map.png",
        "residual.png",
    ]
    with results.open_results(tmp_path / "out" / "results.nc") as data:
        assert data["load"].values.tolist() == pytest.approx([300.0, 600.0, 0.0])
        assert data.attrs["case"] == MINIMAL
        # the table shows what is stored
        assert f"{float(data['max_pressure'][1]) * 1e-6:.1f}" in text


@pytest.mark.parametrize("text", [SURFACES, ASPERITIES], ids=["contact", "asperities"])
def test_figures_for_print(text, tmp_path):
    """Figures have the format and width of [output]; a later run without them removes them."""
    file = tmp_path / "case.toml"
    file.write_text(text + '[output]\nformat = "svg"\ncolumn = "single"\n')
    assert invoke("run", file, "--output", tmp_path / "out", "--quiet").exit_code == 0
    drawn = list((tmp_path / "out").glob("*.svg"))
    assert len(drawn) >= 3
    assert not list((tmp_path / "out").glob("*.png"))
    for figure in drawn:
        width = float(re.search(r'width="([\d.]+)pt"', figure.read_text()).group(1))
        assert width / 72 * 25.4 == pytest.approx(88.0, abs=0.2)
    outcome = invoke("run", file, "--output", tmp_path / "out", "--quiet", "--no-figures")
    assert outcome.exit_code == 0
    assert not list((tmp_path / "out").glob("*.svg"))


def test_run_quietly_without_figures_into_the_default_directory(case_file, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    outcome = invoke("run", case_file, "--no-figures", "--quiet")
    assert outcome.exit_code == 0, outcome.output
    assert outcome.stdout == "results/case/results.nc\n"
    assert outcome.stderr == ""
    assert [p.name for p in (tmp_path / "results/case").iterdir()] == ["results.nc"]


def test_bad_case_is_exit_code_2(case_file, tmp_path):
    case_file.write_text(MINIMAL.replace("nx = 15", "nx = -15"))
    check_failure(invoke("run", case_file), 2, "case.toml: grid.nx:", "got -15")
    check_failure(invoke("run", tmp_path / "none.toml"), 2, "none.toml: cannot read", "No such")


def test_load_beyond_the_grid_is_exit_code_2(case_file, tmp_path):
    text = MINIMAL.replace(SWIFT, 'law = "elastic"\nE = 210e9\nnu = 0.3')
    case_file.write_text(text.replace("load = 600.0", "load = 5e14"))
    outcome = invoke("run", case_file, "--output", tmp_path / "out", "--quiet")
    check_failure(outcome, 2, "border")


def test_no_convergence_is_exit_code_1(case_file, tmp_path, monkeypatch):
    def diverge(self, **_):
        raise samcontact.ConvergenceError("residual 0.1 after 200 iterations")

    monkeypatch.setattr(samcontact.Simulation, "step", diverge)
    outcome = invoke("run", case_file, "--output", tmp_path / "out", "--quiet")
    check_failure(outcome, 1, "did not converge: residual 0.1")


def test_unwritable_output_fails_before_the_computation(case_file, tmp_path, monkeypatch):
    monkeypatch.setattr(samcontact.Simulation, "step", lambda *_, **__: pytest.fail("was run"))
    (tmp_path / "file").write_text("")
    check_failure(invoke("run", case_file, "--output", tmp_path / "file" / "out"), 1, "file")


def test_an_empty_output_is_refused(case_file):
    outcome = invoke("run", case_file, "--output", "")
    assert outcome.exit_code == 2
    assert "'--output': must be the name of a file or folder, got ''" in outcome.stderr


def test_the_command_ignores_the_backend_of_the_environment(case_file, tmp_path):
    case_file.write_text(f"estimate_error = false\n{SURFACES}")
    environment = os.environ | {"MPLBACKEND": "none such"}
    command = [sys.executable, "-m", "samcontact", "run", case_file, "--output", tmp_path / "out"]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "out" / "pressure.png").is_file()


def test_version():
    outcome = invoke("--version")
    assert outcome.exit_code == 0
    assert outcome.stdout == f"samcontact {samcontact.__version__}\n"


def test_hertz_point_and_elliptic():
    common = ("hertz", "--R", "7.5e-3", "--E-star", "115384615384.6154")
    outcome = invoke(*common, "--load", 1500, "--nu", 0.3)
    assert outcome.exit_code == 0, outcome.output
    values = {line[:40].strip(): float(line[40:]) for line in outcome.stdout.splitlines()}
    assert values["maximum pressure p0 [Pa]"] == pytest.approx(4095642673.4, rel=1e-8)
    assert values["maximum von Mises stress [Pa]"] == pytest.approx(
        0.62004 * 4095642673.4, rel=1e-5
    )
    outcome = invoke(*common, "--Ry", "37.5e-3", "--p0", "1e9")
    values = {line[:40].strip(): float(line[40:]) for line in outcome.stdout.splitlines()}
    assert values["ellipticity a_y/a_x [-]"] == pytest.approx(2.890181, abs=1e-6)


def hertz_values(*arguments):
    outcome = invoke("hertz", "--R", "7.5e-3", "--E-star", "115e9", *arguments)
    assert outcome.exit_code == 0, outcome.output
    return {line[:40].strip(): float(line[40:]) for line in outcome.stdout.splitlines()}


def test_hertz_line():
    line = hertz.line(7.5e-3, 115e9, load_per_length=1e5)
    values = hertz_values("--load", "1 kN", "--length", "10 mm", "--nu", 0.3)
    assert values["maximum pressure p0 [Pa]"] == pytest.approx(line.p0, rel=1e-8)
    assert values["half-width b [m]"] == pytest.approx(line.b, rel=1e-8)
    assert values["depth of maximum von Mises stress [m]"] == pytest.approx(
        line.max_von_mises(0.3)[1], rel=1e-8
    )
    same = hertz_values("--load-per-length", "100 N/mm", "--nu", 0.3)
    assert {**same, "load [N]": 1000.0} == values
    by_pressure = hertz_values("--p0", line.p0, "--length", 0.01)
    assert by_pressure["load [N]"] == pytest.approx(1000.0, rel=1e-8)


def test_hertz_stress_on_the_axis():
    shapes = {
        (): hertz.point(7.5e-3, 115e9, p0=1e9),
        ("--Ry", "30 mm"): hertz.elliptic(7.5e-3, 30e-3, 115e9, p0=1e9),
        ("--length", "10 mm"): hertz.line(7.5e-3, 115e9, p0=1e9),
    }
    for options, contact in shapes.items():
        depth = contact.max_von_mises(0.3)[1]
        values = hertz_values(*options, "--p0", "1 GPa", "--nu", 0.3, "--depth", depth)
        normal = contact.axis_stress(depth, 0.3)
        found = [values[f"sigma_{name} at {depth:.5g} m [Pa]"] for name in ("xx", "yy", "zz")]
        expected = normal if len(normal) == 3 else (normal[0], *normal)
        assert found == pytest.approx(expected, rel=1e-8)
        largest = values["maximum von Mises stress [Pa]"]
        assert values[f"von Mises stress at {depth:.5g} m [Pa]"] == pytest.approx(largest, rel=1e-8)


def test_hertz_errors():
    common = ("hertz", "--R", "1", "--E-star", "1")
    check_failure(invoke(*common), 2, "exactly one of load, approach, p0 must be given, got none")
    check_failure(invoke(*common, "--load", "-1"), 2, "load must be a finite number > 0, got -1.0")
    check_failure(invoke(*common, "--load", "1", "--nu", "2"), 2, "nu must be in [0, 0.5]")
    check_failure(invoke(*common, "--load", "1", "--depth", "1"), 2, "nu is required")
    common = (*common, "--length", "1")
    check_failure(
        invoke(*common), 2, "exactly one of load, load_per_length, p0 must be given, got none"
    )
    check_failure(
        invoke(*common, "--approach", "1"), 2, "approach is not supported for a line contact"
    )
    check_failure(
        invoke(*common, "--load", "1", "--Ry", "1"), 2, "Ry cannot be combined with a line contact"
    )


def test_module_is_the_same_command():
    outcome = subprocess.run(
        [sys.executable, "-m", "samcontact", "--version"],
        capture_output=True,
        text=True,
        check=True,
    )
    assert outcome.stdout == f"samcontact {samcontact.__version__}\n"


def test_a_system_error_names_the_folder_without_its_number(case_file, tmp_path):
    done = subprocess.run(
        [sys.executable, "-m", "samcontact", "run", case_file, "--output", "out", "--quiet"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (0, 0)),
    )
    assert done.returncode == 1
    assert done.stderr.startswith("error: cannot write to the folder out: File too large")
    assert list((tmp_path / "out").iterdir()) == []
