# SPDX-License-Identifier: GPL-3.0-or-later
"""First steps of a new user: the case file of the tutorial, then another ball and load."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

from command import check_failure, invoke
from samcontact import results

ROOT = Path(__file__).parents[2]
CASE = re.search(r"```toml\n(.*?)```", (ROOT / "docs" / "tutorial.md").read_text(), re.DOTALL)[1]
FIGURES = {
    "axis_stress.png",
    "gap_map.png",
    "load_approach.png",
    "pressure.png",
    "pressure_map.png",
    "imprint.png",
    "imprint_map.png",
    "residual.png",
    "sections.png",
}


def command(folder, *words):
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        return invoke(*words)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Run the case of the tutorial and one with another ball and load; return the folder."""
    folder = tmp_path_factory.mktemp("user")
    (folder / "ball.toml").write_text(CASE)
    own = CASE.replace("Rx = 7.5e-3", 'Rx = "6.35 mm"').replace("load = 1500.0", 'load = "1.2 kN"')
    assert own.count('"1.2 kN"') == 1
    (folder / "own.toml").write_text(own)
    for name, words, figures in (("ball", ["--no-figures"], set()), ("own", [], FIGURES)):
        outcome = command(folder, "run", f"{name}.toml", *words)
        assert outcome.exit_code == 0, outcome.stderr
        files = {path.name for path in (folder / "results" / name).glob("[!.]*")}
        assert files == figures | {"results.nc"}
        assert all(f"results/{name}/{file}" in outcome.stdout for file in files)
    return folder


def test_another_ball_and_load_give_other_numbers(folder):
    with (
        results.open_results(folder / "results" / "ball" / "results.nc") as first,
        results.open_results(folder / "results" / "own" / "results.nc") as second,
    ):
        assert float(second["load"].max()) == pytest.approx(1200.0, rel=1e-12)
        # elastic pressure grows by 4 %, as (load/radius^2)^(1/3); plastic flow reduces the increase
        ratio = float(second["max_pressure"].max() / first["max_pressure"].max())
        assert 1.005 < ratio < 1.04
        # the load at first yield falls with the radius squared, so plastic strain increases
        strain = "max_equivalent_plastic_strain_body2"
        assert float(second[strain].max()) > float(first[strain].max())


def test_the_report_has_the_values_of_the_run(folder, undrawn):
    outcome = command(folder, "report", "results/own")
    assert (outcome.exit_code, outcome.stderr) == (0, "")
    page = (folder / "results" / "own" / "report.html").read_text()
    assert "Rx</th><td>6.35 mm</td>" in page
    assert "✗ failed" not in page


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("Rx = 7.5e-3", "Rxx = 7.5e-3", ("surface", "Rxx", "Rx")),
        ("Rx = 7.5e-3", 'Rx = "7.5 s"', ("surface.", "Rx", "7.5 s")),
        ("load = 1500.0\n", "", ("path", "load")),
        ("nx = 41", 'nx = "many"', ("grid.nx", "whole number", "many")),
        ('law = "swift"', 'law = "swfit"', ("body2", "swfit", "'swift'")),
    ],
    ids=["unknown key", "wrong unit", "missing field", "wrong type", "unknown word"],
)
def test_mistakes_are_named(folder, old, new, message):
    (folder / "wrong.toml").write_text(CASE.replace(old, new, 1))
    check_failure(invoke("run", folder / "wrong.toml"), 2, *message)


def test_the_doctor_passes():
    words = [sys.executable, "-m", "samcontact", "doctor"]
    outcome = subprocess.run(words, cwd=ROOT, capture_output=True, text=True)
    assert outcome.returncode == 0, outcome.stdout
    assert "failed" not in outcome.stdout
