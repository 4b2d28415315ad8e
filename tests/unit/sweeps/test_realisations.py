# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweeps over seeds: statistics of many realisations, and their figure."""

import csv
import os
import signal
import statistics

import numpy as np
import pytest
import xarray as xr
from watched import Watched

import samcontact as sc
from command import invoke
from samcontact import results
from samcontact._util.quantities import CONTACT
from samcontact.cases import load_case
from samcontact.commands import solve_sweep
from samcontact.commands.solve_sweep import parse_settings
from samcontact.commands.sweep_statistics import are_realisations, statistics_of
from samcontact.plotting.realisations import realisations_figure

ROUGH = """
title = "ball on a rough surface"
estimate_error = false
grid = {nx = 24, ny = 24, dx = 2e-6, dy = 2e-6}
body1 = {law = "rigid"}
body2 = {law = "elastic", E = 210e9, nu = 0.3}
path = [{load = 0.3, increments = 1}]
[surface]
shape = "paraboloid"
Rx = 200e-6
roughness = {kind = "self_affine", rms_height = 5e-8, hurst = 0.8, wavelength_min = 8e-6, seed = 0}
"""
SEED = "surface.roughness.seed"


@pytest.fixture
def case_file(tmp_path):
    path = tmp_path / "rough.toml"
    path.write_text(ROUGH)
    return path


def test_a_range_of_whole_numbers():
    assert parse_settings(["a.seed=-1..2, 7", "b=3..3"]) == {"a.seed": [-1, 0, 1, 2, 7], "b": [3]}
    assert parse_settings(["b=1..x,1...2"]) == {"b": ["1..x", "1...2"]}
    for wrong in ("2..1", "0..999999"):
        with pytest.raises(ValueError, match=rf"a range FIRST..LAST must .* got {wrong}"):
            parse_settings([f"b={wrong}"])


def test_only_seeds_are_realisations():
    seeds, loads = [1, 2, 3], [5.0, 6.0, 7.0]
    assert are_realisations({"dents.seed": seeds, "path[0].load": [5.0] * 3})
    assert not are_realisations({"dents.seed": seeds, "path[0].load": loads})
    assert not are_realisations({"dents.seed": [1, 2]})
    assert not are_realisations({"path[0].load": loads})


def test_statistics_are_those_of_the_standard_library():
    sample = np.random.default_rng(1).lognormal(size=101)
    mean, deviation, error, low, five, median, most, high = statistics_of(sample)
    twentieths = statistics.quantiles(sample, n=20, method="inclusive")
    assert mean == pytest.approx(statistics.fmean(sample), rel=1e-13)
    assert deviation == pytest.approx(statistics.stdev(sample), rel=1e-13)
    assert error == pytest.approx(deviation / 101**0.5, rel=1e-13)
    assert [five, median, most] == pytest.approx([twentieths[i] for i in (0, 9, 18)], rel=1e-13)
    assert (low, high) == (min(sample), max(sample))


def test_the_figure_counts_all_realisations():
    names = ("approach", "max_pressure")
    samples = {"approach": np.arange(1.0, 30.0) * 1e-6, "max_pressure": np.full(29, 1e9)}
    figure = realisations_figure({name: CONTACT[name] for name in names}, samples)
    (panel,) = (ax for ax in figure.axes if ax.get_visible())  # no panel for a constant
    assert sum(bar.get_height() for bar in panel.patches) == 29
    assert panel.get_xlabel() == "approach [µm]"
    assert panel.get_title() == "mean 15, deviation 8.51"
    deviation = statistics.stdev(range(1, 30))
    lines = [line.get_xdata()[0] for line in panel.lines]
    assert lines == pytest.approx([15.0, 15.0 - deviation, 15.0 + deviation])


def test_the_command_prints_statistics_and_writes_all_realisations(case_file, tmp_path, undrawn):
    outcome = invoke("sweep", case_file, "--set", f"{SEED}=0..3", "--output", tmp_path / "out")
    assert outcome.exit_code == 0, outcome.output
    with open(tmp_path / "out" / "sweep.csv", encoding="utf-8") as file:
        found = [float(row["approach [m]"]) * 1e6 for row in csv.DictReader(file)]
    assert len(set(found)) == 4
    (line,) = (row for row in outcome.stdout.splitlines() if "approach [µm]" in row and "│" in row)
    cells = [cell.strip() for cell in line.strip("│").split("│")]
    assert float(cells[1]) == pytest.approx(statistics.fmean(found), abs=1e-4)
    assert float(cells[2]) == pytest.approx(statistics.stdev(found), abs=1e-4)
    assert cells[-1] == "4"
    assert (tmp_path / "out" / "sweep.png").exists()


@pytest.mark.slow
def test_200_realisations_on_a_cluster_that_loses_a_worker(case_file, tmp_path, monkeypatch):
    from distributed import Client, LocalCluster

    killed, solve = [], sc.sweep
    options = {"n_workers": 2, "threads_per_worker": 1, "dashboard_address": None}
    with LocalCluster(**options) as cluster, Client(cluster) as client:
        pids, scheduler = client.run(os.getpid), cluster.scheduler

        def kill():  # in the thread of the scheduler
            busy = next(w for w in scheduler.workers.values() if w.processing)
            os.kill(pids[busy.address], signal.SIGKILL)
            killed.append(busy.address)

        def watched(*given, executor, **more):
            executor = Watched(executor.get_executor(pure=False), 50, kill)
            return solve(*given, executor=executor, **more)

        monkeypatch.setattr(solve_sweep, "sweep", watched)
        address = client.scheduler.address
        outcome = invoke("sweep", case_file, "--set", f"{SEED}=0..199", "--dask", address,
                         "--output", tmp_path / "out")  # fmt: skip
    assert outcome.exit_code == 0, outcome.output
    assert len(killed) == 1
    assert "│   200 │" in outcome.stdout
    serial = sc.sweep(load_case(case_file), {SEED: list(range(200))}, progress=False)
    with results.open_results(tmp_path / "out" / "sweep.nc") as found:
        for name in serial.data_vars:
            xr.testing.assert_equal(found[name], serial[name])
