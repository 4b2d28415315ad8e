# SPDX-License-Identifier: GPL-3.0-or-later
"""Reports of asperity collisions and wear: numbers equal the dataset, and checks can fail."""

import re
from types import SimpleNamespace

import numpy as np
import pytest
import xarray as xr

from case_texts import ASPERITIES, MINIMAL, WEAR
from command import invoke
from samcontact import report, results
from samcontact.report.asperities import checks
from samcontact.report.tables import parameters


def run_and_report(text, folder):
    file = folder / "case.toml"
    file.write_text(text)
    assert invoke("run", file, "--output", folder / "out", "--no-figures").exit_code == 0
    outcome = invoke("report", folder / "out")
    assert outcome.exit_code == 0, outcome.output
    assert outcome.stdout == f"{folder / 'out' / 'report.html'}\n"
    return folder / "out", outcome


@pytest.fixture(scope="module")
def collision(tmp_path_factory):
    text = ASPERITIES.replace("increments = 8", "increments = 12")
    text = 'description = "Steel, as ground."\n' + text
    return run_and_report(text, tmp_path_factory.mktemp("asperities"))


@pytest.fixture(scope="module")
def wear(tmp_path_factory):
    return run_and_report(WEAR, tmp_path_factory.mktemp("wear"))


def page(folder):
    return (folder / "report.html").read_text(encoding="utf-8")


def rows(text, table):
    """Return the numbers of the rows of a table."""
    body = re.search(rf'<table id="{table}">.*?<tbody>(.*?)</tbody>', text, re.DOTALL).group(1)
    return [
        [float(value) for value in re.findall(r'<data value="([^"]+)"', row)]
        for row in body.split("</tr>")[:-1]
    ]


def captions(text):
    return re.findall(r"<figcaption>(.*?)</figcaption>", text)


def test_description(collision):
    assert '<p class="description">Steel, as ground.</p>' in page(collision[0])


def test_passes(collision):
    folder, _ = collision
    text = page(folder)
    with results.open_results(folder / "series.nc") as data:
        for index, row in enumerate(rows(text, "passes-table")):
            one = data.isel({"pass": index})
            prints = one["residual_displacement"].values
            names = ("net_energy", "dissipation", "residual_energy", "energy_imbalance")
            expected = [float(one[name]) for name in names]
            force_x, force_z = one["force_x"], one["force_z"]
            expected += [*prints, force_x.max(), force_x.min(), force_z.max()]
            cells = one["cells_across_contact"][int(one["normal_force"].argmax("increment"))]
            layers = float(one["layers_across_plastic_zone"].sel(body=2).max())
            pressure = one["max_pressure"].max()
            np.testing.assert_array_equal(row, [*expected, pressure, cells, layers])
        assert index == 1
    assert captions(text) == [
        "Tangential force versus offset of the spheres",
        "Normal force versus offset of the spheres",
        "Ratio of tangential to normal force versus offset of the spheres",
        "Energy of the passes",
    ]
    assert len(re.findall('<img src="data:image/png;base64,', text)) == 4
    assert '<h2 id="convergence">' not in text
    assert "Worst values of all passes." in text
    assert "interference</th><td>600 µm</td>" in text


def test_too_few_increments_fail_a_check(collision):
    """The energy imbalance with 12 increments is a tenth or more."""
    folder, outcome = collision
    assert "check failed: energy balance: unaccounted energy" in outcome.stderr
    with results.open_results(folder / "series.nc") as data:
        energy, exchanged, release, cells, layers = report.checks(data)
        ratio = np.abs(data["energy_imbalance"] / data["net_energy"]).max()
        assert energy.value == pytest.approx(float(ratio))
        assert energy.value > energy.limit
        assert exchanged.passed
        assert release.passed
        assert cells.passed
        assert (layers.value, layers.passed) == (3.0, False)
        held = data.load().copy(deep=True)
    held["normal_force"][0, -1] = 1e3
    assert not report.checks(held)[2].passed


@pytest.mark.parametrize("study", ["collision", "wear"])
@pytest.mark.parametrize("name", ["cells_across_contact", "layers_across_plastic_zone"])
def test_coarse_cells_and_layers_fail_a_check(study, name, request):
    folder, _ = request.getfixturevalue(study)
    with results.open_results(
        folder / ("series.nc" if study == "collision" else "wear.nc")
    ) as data:
        fine, coarse = (data.load().assign({name: data[name] * 0 + n}) for n in (4, 3))
    failed = [[v.name for v in report.checks(one) if not v.passed] for one in (fine, coarse)]
    (message,) = set(failed[1]) - set(failed[0])
    assert message.split()[0] == name.split("_")[0]


def test_energy_imbalance_of_nearly_elastic_passes():
    """The imbalance is relative to the exchanged energy, not to a net energy close to zero.

    Energies [J] are similar to those of the shipped case of three passes.
    """
    series = xr.Dataset(
        {
            "work": (("pass", "increment"), [[-7558.0, 5032.0], [-2860.0, 43.9], [-2816.0, -12.5]]),
            "normal_force": (("pass", "increment"), [[1e5, 0.0]] * 3),
            "net_energy": ("pass", [5032.0, 43.9, -12.5]),
            "dissipation": ("pass", [4426.5, 71.2, 3.8]),
            "residual_energy": ("pass", [705.6, 697.1, 696.6]),
            "energy_imbalance": ("pass", [-100.1, -18.8, -15.9]),
            "cells_across_contact": (("pass", "increment"), [[12.0, np.nan]] * 3),
            "layers_across_plastic_zone": (
                ("pass", "increment", "body"),
                [[[np.nan, 9.0]] * 2] * 3,
            ),
        },
        coords={"body": [1, 2]},
    )

    def passed(name, values):
        return [v.passed for v in checks(series.assign({name: ("pass", values)}))][:3]

    assert passed("energy_imbalance", [-100.1, -18.8, -15.9]) == [True, True, True]
    assert passed("energy_imbalance", [-300.0, -18.8, -15.9]) == [False, False, True]
    assert passed("energy_imbalance", [-100.1, 60.0, -15.9]) == [True, False, True]
    # elastic spheres give back all that a pass takes
    elastic = series.assign(
        {name: ("pass", np.zeros(3)) for name in ("dissipation", "residual_energy")}
    )
    checks_found = checks(elastic.assign(net_energy=("pass", [1.0, 2.0, 3.0])))
    assert [v.passed for v in checks_found][:2] == [True, True]
    checks_found = checks(elastic.assign(energy_imbalance=("pass", [1.0, 2.0, 300.0])))
    assert [v.passed for v in checks_found][:2] == [False, True]


def test_cycles(wear):
    folder, outcome = wear
    assert outcome.stderr == ""
    text = page(folder)
    with results.open_results(folder / "wear.nc") as data:
        names = ("volume", "depth", "surface_strain", "max_equivalent_plastic_strain",
                 "max_pressure", "max_von_mises", "contact_area", "cells_across_contact",
                 "layers_across_plastic_zone")  # fmt: skip
        expected = [[float(data[name].values.flat[0]) for name in names]]
        np.testing.assert_array_equal(rows(text, "cycles-table"), expected)
        volume, *_ = report.checks(data)
        assert volume.passed
        spoilt = data.assign(lost_volume=data["lost_volume"] * 1.01)
    assert not report.checks(spoilt)[0].passed
    assert captions(text) == [
        "Worn volume of each cycle",
        "Heights of body 2 along x, after several cycles",
        "Heights of body 2 along y, after several cycles",
        "Heights of body 2 after cycle 1",
    ]


def test_a_series_without_a_case(collision, tmp_path, undrawn):
    folder, _ = collision
    with results.open_results(folder / "series.nc") as data:
        plain = data.load().drop_attrs().assign_attrs(R1=1.0, R2=2.0, interference=6e-4)
    text = report.write(plain, tmp_path / "report.html").read_text(encoding="utf-8")
    assert '<td>run</td><th scope="row">interference</th><td>0.0006</td>' in text


def test_choice_of_the_file_in_a_folder(tmp_path, collision, wear, undrawn):
    outcome = invoke("report", tmp_path)
    assert outcome.exit_code == 2
    names = "results.nc, series.nc, wear.nc, film.nc, sliding.nc"
    assert f"must contain one of {names}, got none" in outcome.stderr
    for folder, name in ((collision[0], "series.nc"), (wear[0], "wear.nc")):
        (tmp_path / name).write_bytes((folder / name).read_bytes())
    outcome = invoke("report", tmp_path)
    assert outcome.exit_code == 2
    assert "got series.nc, wear.nc: specify the file" in outcome.stderr
    assert invoke("report", tmp_path / "wear.nc").exit_code == 0


def test_parameters_of_nested_sections():
    text = MINIMAL + "\n[body2.kinematic]\nmodulus = [2e9, 1e9]\nrecovery = 30\n"
    rows = parameters(SimpleNamespace(attrs={"case": text}))
    assert ("body2, kinematic", "modulus", "2 GPa, 1 GPa") in rows
    assert ("body2, kinematic", "recovery", "30") in rows


def test_start_has_the_unit_of_its_target():
    text = MINIMAL + "\n[[path]]\napproach = 6e-9\nstart = -14e-9\n[[path]]\nload = 2\nstart = 1\n"
    rows = parameters(SimpleNamespace(attrs={"case": text}))
    assert [row[2] for row in rows if row[1] == "start"] == ["-14 nm", "1 N"]
