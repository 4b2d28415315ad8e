# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files of friction over velocity: closed form, files, interruption and errors."""

import numpy as np
import pandas as pd
import pytest
import xarray as xr

import samcontact as sc
from command import check_failure, invoke
from samcontact import report
from samcontact.cases import CaseError, SlidingCase, load_case, parse_case
from samcontact.sliding import speeds

WAVE = """title = "a wave in full contact"
[sliding]
mean_pressure = 5e4
velocities = [0.01, 0.1, "1 m/s", 10.0]
[grid]
nx = 64
ny = 2
dx = "0.1 mm"
dy = "0.1 mm"
periodic = "xy"
[body1]
law = "rigid"
[body2]
law = "elastic"
E = 1e6
nu = 0.3
relaxation = {times = [1e-3], shares = [0.8]}
[surface]
shape = "file"
path = "wave.txt"
"""
LENGTH, AMPLITUDE, PRESSURE = 6.4e-3, 1e-5, 5e4


@pytest.fixture
def case_file(tmp_path):
    x = (np.arange(64) - 31.5) * 1e-4
    heights = AMPLITUDE * np.cos(2 * np.pi * x / LENGTH)[:, None] * np.ones(2)
    np.savetxt(tmp_path / "wave.txt", heights)
    path = tmp_path / "wave.toml"
    path.write_text(WAVE)
    return path


def test_the_command_writes_the_friction_of_a_wave(case_file, tmp_path, undrawn):
    """Closed form of a wave in full contact: a² q² Im E*(q V)/4 per area."""
    out = tmp_path / "out"
    outcome = invoke("run", case_file, "--output", out)
    assert outcome.exit_code == 0, outcome.output
    names = {path.name for path in out.iterdir()} - {".samcontact-files"}
    pictures = {"friction_over_velocity.png", "pressure_over_velocity.png"}
    assert names == {"sliding.nc", "sliding.csv", *pictures}
    q = 2 * np.pi / LENGTH
    with xr.open_dataset(out / "sliding.nc", engine="h5netcdf") as found:
        speed = found.velocity.values
        rubber = sc.Material.elastic(1e6, 0.3).with_relaxation([1e-3], [0.8])
        exact = AMPLITUDE**2 * q**2 * rubber.loss(q * speed) / (1 - 0.3**2) / 4 / PRESSURE
        assert found.friction.values == pytest.approx(exact, rel=2e-3)
        assert found.power.values == pytest.approx(found.friction_force.values * speed)
        assert (found.contact_share.values == 1.0).all()
        assert found.velocity.attrs["units"] == "m/s"
        assert found.pressure.dims == ("point", "x", "y")
        assert all(check.passed for check in report.checks(found))
        table = pd.read_csv(out / "sliding.csv")
        np.testing.assert_array_equal(table.friction, found.friction.values)
    assert invoke("report", out).exit_code == 0
    check_failure(invoke("export", out / "sliding.nc", "--vtk"), 2, "no contact fields to export")


def test_an_interrupted_run_continues_bit_identically(case_file, tmp_path):
    case = load_case(case_file)
    assert isinstance(case, SlidingCase)
    whole = case.solve(progress=False)
    kept = tmp_path / "kept"
    case.solve(progress=False, checkpoint=kept)
    files = sorted(kept.glob("*.h5"))
    assert len(files) == 4
    files[1].unlink()
    files[2].write_bytes(files[2].read_bytes()[:-40])
    with pytest.warns(UserWarning, match="is damaged.*solved again"):
        again = case.solve(progress=False, checkpoint=kept)
    for one, other in zip(whole.solutions, again.solutions, strict=True):
        np.testing.assert_array_equal(one.pressure, other.pressure)
        assert one.friction == other.friction
        assert one.converged is other.converged is True
    other = parse_case(WAVE.replace("5e4", "4e4"), case_file)
    with pytest.raises(ValueError, match=r"is a checkpoint of another run \(load"):
        other.solve(progress=False, checkpoint=kept)


def test_velocities_before_an_error_are_written(case_file, tmp_path, monkeypatch):
    def fails(*given, velocity, **named):
        if velocity == 1.0:
            raise sc.ConvergenceError("not solved at 1 m/s")
        return sc.sliding.steady(*given, velocity=velocity, **named)

    out = tmp_path / "out"
    with monkeypatch.context() as patch:
        patch.setattr(speeds, "steady", fails)
        outcome = invoke("run", case_file, "--output", out)
    assert outcome.exit_code == 1
    assert "2 of 4 velocities" in outcome.output
    with xr.open_dataset(out / "sliding.nc", engine="h5netcdf") as found:
        assert found.sizes["point"] == 2
        assert not report.checks(found)[0].passed
        assert "velocities" in report.checks(found)[0].name
    assert invoke("resume", out).exit_code == 0
    with xr.open_dataset(out / "sliding.nc", engine="h5netcdf") as found:
        np.testing.assert_array_equal(
            found.friction, load_case(case_file).solve(progress=False).friction
        )


def test_a_grid_that_is_too_small_is_enlarged():
    text = WAVE.replace("mean_pressure = 5e4", "load = 1.0").replace('periodic = "xy"\n', "")
    text = text.replace("ny = 2", "ny = 64").replace(
        'shape = "file"\npath = "wave.txt"', 'shape = "sphere"\nR = 20e-3'
    )
    curve = parse_case(text).solve(progress=False)
    found = curve.to_dataset()
    assert "contact_share" not in found  # the area of the grid is arbitrary
    carried = found.pressure.sum(("x", "y")).values * 1e-8
    assert carried == pytest.approx(1.0, rel=1e-9)
    assert found.sizes["x"] == max(s.grid.nx for s in curve.solutions)
    assert found.sizes["x"] > min(s.grid.nx for s in curve.solutions) >= 64


@pytest.mark.parametrize(
    ("old", "new", "text"),
    [
        ("mean_pressure = 5e4", "", "exactly one of load and mean_pressure"),
        ("mean_pressure = 5e4", "mean_pressure = 5e4\nload = 1.0", "exactly one of load and mean"),
        ('periodic = "xy"', "", r'sliding.mean_pressure requires grid.periodic = "xy"'),
        ('velocities = [0.01, 0.1, "1 m/s", 10.0]', "slowest = 1.0", "velocities, or slowest and"),
        ("velocities =", "slowest = 1.0\nvelocities =", "velocities, or slowest and fastest"),
        ('velocities = [0.01, 0.1, "1 m/s", 10.0]', "slowest = 2\nfastest = 1", "slowest must be"),
        ("relaxation", "#", "body2.relaxation must be given"),
        ('[body1]\nlaw = "rigid"', '[body1]\nlaw = "perfect_plastic"\nE = 1e9\nnu = 0.3\n'
         "yield_stress = 1e6", "body1.law must be"),
        ("nu = 0.3", "nu = 0.3\nthermal = {conductivity = 1, expansion = 1e-4, diffusivity = 1e-7}",
         "body2.thermal has no effect with"),
        ('dx = "0.1 mm"', 'dx = "0.1 mm"\ndz = 1e-4', "grid.dz has no effect"),
        ('[surface]', '[contact]\nfriction = 0.2\n[surface]', "contact.friction: unknown field"),
    ],
)  # fmt: skip
def test_errors_name_field_and_remedy(old, new, text):
    with pytest.raises(CaseError, match=text):
        parse_case(WAVE.replace(old, new))


def test_a_sweep_has_the_values_of_each_velocity(case_file):
    found = sc.sweeps.sweep(case_file, {"sliding.mean_pressure": [5e4, 6e4]}, progress=False)
    assert found.friction.dims == ("sliding.mean_pressure", "point")
    ratio = found.friction.values[0] / found.friction.values[1]
    assert ratio == pytest.approx(1.2, rel=1e-9)  # the same force in full contact


def test_the_command_shows_the_maxima_of_a_sweep(case_file, tmp_path):
    outcome = invoke(
        "sweep", case_file, "--set", "sliding.mean_pressure=5e4,6e4", "--output", tmp_path / "swept"
    )
    assert outcome.exit_code == 0, outcome.output
    assert "Maxima" in outcome.stdout
    largest = load_case(case_file).solve(progress=False).friction.max()
    assert f"{largest:.4f}" in outcome.stdout
