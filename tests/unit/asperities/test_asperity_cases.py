# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files of asperity collisions, and the output of the command."""

import numpy as np
import pandas as pd
import pytest
import xarray as xr

import samcontact as sc
from case_texts import ASPERITIES
from command import check_failure, invoke
from samcontact.asperities import Collision, collide
from samcontact.cases import AsperityCase, CaseError, load_case

GRID = "[grid]\nnx = 41\nny = 41\ndx = 3e-3\ndy = 3e-3\nnz = 20\ndz = 3e-3\n"


@pytest.fixture
def case_file(tmp_path):
    path = tmp_path / "spheres.toml"
    path.write_text(ASPERITIES)
    return path


def test_a_case_gives_the_results_of_the_equivalent_call(case_file):
    case = load_case(case_file)
    assert isinstance(case, AsperityCase)
    which = Collision(1.0, 2.0, 6e-4)
    bodies = (
        sc.Material.elastic(200e9, 0.32),
        sc.Material.perfect_plastic(200e9, 0.32, 0.9e9),
    )
    expected = collide(which, *bodies, which.grid(8), passes=2, back_and_forth=True, tol=1e-7,
                   progress=False)  # fmt: skip
    xr.testing.assert_identical(case.solve(progress=False).series, expected.series)


def test_with_a_grid_and_a_relief(case_file):
    text = ASPERITIES.replace("increments = 8\n", "")
    relief = '[relief2]\nkind = "dent"\ndepth = 1e-4\nradius = 2e-2\n'
    case_file.write_text(text + GRID + relief)
    result = load_case(case_file).solve(progress=False)
    assert result.simulation.grid.nx == 41
    assert result.simulation.relief2.heights.min() == pytest.approx(-1e-4, rel=0.1)


def test_the_command_writes_series_and_figures(case_file, tmp_path, undrawn):
    outcome = invoke("run", case_file, "--output", tmp_path / "out", "--resume")
    assert outcome.exit_code == 0, outcome.output
    names = [
        ".samcontact-files",
        "series.nc",
        "series.csv",
        "force_x.png",
        "force_z.png",
        "load_ratio.png",
    ]
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == sorted(names)
    with xr.open_dataset(tmp_path / "out" / "series.nc", engine="h5netcdf") as series:
        assert series.sizes == {"pass": 2, "increment": series.sizes["increment"], "body": 2}
        assert series.attrs["case"] == ASPERITIES
        assert series.force_x.attrs["units"] == "N"
        net = series.net_energy.values
        table = pd.read_csv(tmp_path / "out" / "series.csv")
        np.testing.assert_allclose(
            table[table["pass"] == 1].force_x, series.force_x.sel({"pass": 1}).dropna("increment")
        )
    assert f"{net[0]:.5g}" in outcome.stdout


def test_no_figures_and_no_animation(case_file, tmp_path):
    assert invoke("run", case_file, "--output", tmp_path, "--no-figures").exit_code == 0
    assert not list(tmp_path.glob("*.png"))
    check_failure(invoke("run", case_file, "--animate"), 2, "--animate cannot be combined with")


@pytest.mark.parametrize(
    ("old", "new", "text"),
    [
        (
            "6e-4",
            "1.5",
            r"asperities: interference must be less than the smaller radius \(1.0 m\), got 1.5",
        ),
        ("R1 = 1.0", "R1 = -1.0", r"asperities.R1: must be a finite number > 0 \[m\]"),
        ("passes = 2", "pases = 2", r"asperities.pases: unknown field; allowed here: R1, R2"),
        ("[contact]", "[contact]\nfriction = 0.1", r"contact.friction: unknown field"),
        (
            "[contact]",
            GRID + "[contact]",
            r"asperities: increments and \[grid\] both set the grid",
        ),
        ('"elastic"', '"rigid"', r"body1"),
        ("increments = 8", "increments = 2", r"asperities.increments: must be a whole number >= 4"),
    ],
)
def test_errors_name_field_and_remedy(case_file, old, new, text):
    case_file.write_text(ASPERITIES.replace(old, new))
    with pytest.raises(CaseError, match=text):
        load_case(case_file)


def test_a_relief_of_wrong_width_is_refused(case_file):
    np.save(case_file.parent / "h.npy", np.zeros((5, 3)))
    case_file.write_text(ASPERITIES + '[relief1]\nkind = "file"\npath = "h.npy"\n')
    with pytest.raises(CaseError, match=r"\[relief1\] relief1 must have heights of shape"):
        load_case(case_file).solve(progress=False)
