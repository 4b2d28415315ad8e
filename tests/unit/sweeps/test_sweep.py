# SPDX-License-Identifier: GPL-3.0-or-later
"""Many cases: the same bits whoever solves them, failures and deaths, going on, bad parameters."""

import json
import os
import signal
from concurrent.futures import BrokenExecutor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context

import numpy as np
import pytest
import xarray as xr
from distributed import Client, LocalCluster
from sweep_cases import BASE, CASE
from watched import Watched

import samcontact as sc
from case_texts import MINIMAL
from command import invoke
from comparing import assert_stored
from samcontact import results
from samcontact.cases import AsperityCase, Case, CaseError
from samcontact.sweeps import run, store, worker

# 24 cases with paths of one and of three increments; those of 9e13 N do not fit on the grid
LARGE_SWEEP = {
    "body2.yield_stress": [1.5e9, 2e9, 3e9, 1e10],
    "contact.friction": [0, 0.1],
    "path[0].load": np.array([300.0, 600.0, 9e13]),
}
FAILING_SWEEP = {"path[0].load": [300.0, 9e13, 600.0]}


@pytest.fixture(scope="module")
def serial():
    return sc.sweep(CASE, LARGE_SWEEP, progress=False)


@pytest.fixture(scope="module")
def client():
    # one worker: each imports the packages; results that overtake others are those of threads
    options = {"n_workers": 1, "threads_per_worker": 1, "dashboard_address": None}
    with LocalCluster(**options) as cluster, Client(cluster) as one:
        yield one


@pytest.fixture(scope="module")
def forked():
    """Start processes that need not import the packages; the command spawns its own."""
    context = get_context("forkserver")
    context.set_forkserver_preload(["samcontact.sweeps.worker", "samcontact.simulation"])
    return context


@pytest.fixture
def calls(monkeypatch):
    """The loads of the cases that are solved in this process."""
    loads, solve = [], worker.solve_case

    def counted(content, source):
        loads.append(content["path"][0]["load"])
        return solve(content, source)

    monkeypatch.setattr(worker, "solve_case", counted)
    return loads


def test_one_dataset_with_what_single_runs_give(serial):
    assert serial.sizes == {
        "body2.yield_stress": 4,
        "contact.friction": 2,
        "path[0].load": 3,
        "increment": 2,
    }
    assert serial["body2.yield_stress"].attrs == {"units": "Pa"}
    assert serial["contact.friction"].values.tolist() == [0.0, 0.1]
    assert json.loads(serial.attrs["case"]) == BASE
    assert serial.attrs["samcontact_version"] == sc.__version__
    content = BASE | {
        "body2": BASE["body2"] | {"yield_stress": 3e9},
        "contact": {"friction": 0.1},
        "path": [{"load": 600.0, "increments": 2}],
    }
    case = Case.model_validate(content)
    simulation, path = case.build()
    alone = results.to_dataset(simulation, simulation.run(path, progress=False), case)
    one = serial.sel({"body2.yield_stress": 3e9, "contact.friction": 0.1, "path[0].load": 600.0})
    table = results.scalars(alone)
    assert len(table.columns) >= 9
    for name in table:
        np.testing.assert_array_equal(one[name].values, table[name].values)
        assert one[name].attrs == alone[name].attrs
    good = serial.isel({"path[0].load": [0, 1]})
    assert (good["status"] == "done").all()
    assert (good["error"] == "").all()


def test_failures_are_recorded_among_good_cases(serial):
    bad = serial.sel({"path[0].load": 9e13})
    assert (bad["status"] == "failed").all()
    assert np.isnan(bad["load"]).all()
    for text in bad["error"].values.flat:
        assert text.startswith("GridTooSmallError: at load ")
        assert "reaches the edge of the grid" in text


def test_shorter_paths_end_in_nan_and_zip_goes_along():
    given = {"path[0].increments": [1, 3], "body1.E": [210e9, 300e9], "body1.law": ["elastic"] * 2}
    found = sc.sweep(CASE, given, progress=False, mode="zip")
    assert found.sizes == {"case": 2, "increment": 3}
    assert found["case"].values.tolist() == [1, 2]
    assert found["body1.E"].dims == ("case",)
    np.testing.assert_allclose(
        found["load"], [[500.0, np.nan, np.nan], [500 / 3, 1000 / 3, 500.0]], rtol=1e-12
    )


def test_sections_may_be_swept():
    bodies = [{"law": "rigid"}, BASE["body1"], BASE["body1"] | {"E": np.float64(3e11)}]
    found = sc.sweep(CASE, {"body1": bodies}, progress=False)
    assert json.loads(found["body1"].values[0]) == {"law": "rigid"}
    stiff = found["max_pressure"].isel(increment=-1).values
    assert stiff[0] > stiff[2] > stiff[1]


def test_dask_cluster_gives_the_same_bits(client, serial):
    xr.testing.assert_identical(
        sc.sweep(CASE, LARGE_SWEEP, executor=client, progress=False), serial
    )


def test_dask_cluster_survives_the_death_of_a_worker(client, serial):
    pids, scheduler = client.run(os.getpid), client.cluster.scheduler
    killed = []

    def kill():  # in the thread of the scheduler: nothing moves meanwhile
        busy = next(w for w in scheduler.workers.values() if w.processing)
        os.kill(pids[busy.address], signal.SIGKILL)
        killed.append(pids[busy.address])

    executor = Watched(client.get_executor(pure=False), 5, kill)
    found = sc.sweep(CASE, LARGE_SWEEP, executor=executor, progress=False)
    xr.testing.assert_identical(found, serial)
    assert len(killed) == 1
    client.wait_for_workers(1)
    assert killed[0] not in client.run(os.getpid).values()


def test_processes_give_the_same_bits(serial, forked):
    with ProcessPoolExecutor(2, forked) as pool:
        found = sc.sweep(CASE, LARGE_SWEEP, executor=pool, progress=False)
    xr.testing.assert_identical(found, serial)


def test_threads_give_the_same_bits(serial):
    with ThreadPoolExecutor(2) as pool:
        found = sc.sweep(CASE, LARGE_SWEEP, executor=pool, progress=False)
    xr.testing.assert_identical(found, serial)


def test_death_of_a_process_is_recorded_and_made_good_later(serial, forked, tmp_path, request):
    with ProcessPoolExecutor(1, forked) as pool:
        pid = pool.submit(os.getpid).result()
        executor = Watched(pool, 4, lambda: os.kill(pid, signal.SIGKILL))
        broken = sc.sweep(CASE, LARGE_SWEEP, executor=executor, output=tmp_path, progress=False)
    errors = broken["error"].values.ravel().tolist()
    done = broken["status"].values.ravel().tolist().count("done")
    assert done >= 2
    assert sum(text.startswith("BrokenProcessPool: ") for text in errors) >= 10
    calls = request.getfixturevalue("calls")
    whole = sc.sweep(CASE, LARGE_SWEEP, output=tmp_path, progress=False)
    xr.testing.assert_identical(whole, serial)
    assert len(calls) == 24 - done


def test_a_pool_that_is_broken_already_is_recorded():
    class Broken:
        def submit(self, *_):
            raise BrokenExecutor("no more workers")

    found = sc.sweep(CASE, FAILING_SWEEP, executor=Broken(), progress=False)
    assert set(found["error"].values) == {"BrokenExecutor: no more workers"}


def test_cancelled_by_the_executor_is_a_failure():
    class Cancels:
        def submit(self, *_):
            future = Future()
            future.cancel()
            future.set_running_or_notify_cancel()
            return future

    found = sc.sweep(CASE, FAILING_SWEEP, executor=Cancels(), progress=False)
    assert all(text.startswith("CancelledError") for text in found["error"].values)


def test_a_resumed_sweep_solves_only_missing_cases(tmp_path, calls):
    first = sc.sweep(CASE, FAILING_SWEEP, output=tmp_path, progress=False)
    assert calls == [300.0, 9e13, 600.0]
    assert len(list((tmp_path / "cases").iterdir())) == 2
    with results.open_results(tmp_path / "sweep.nc") as stored:
        assert_stored(stored, first)
    calls.clear()
    again = sc.sweep(CASE, FAILING_SWEEP, output=tmp_path, progress=False)
    assert calls == [9e13]
    xr.testing.assert_identical(again, first)
    calls.clear()
    # more values, and a title that no number depends on
    more = {"path[0].load": [300.0, 400.0, 600.0], "title": ["renamed"]}
    found = sc.sweep(CASE, more, output=tmp_path, progress=False)
    assert calls == [400.0]
    xr.testing.assert_equal(
        found["approach"].isel(title=0).sel({"path[0].load": [300.0, 600.0]}).drop_vars("title"),
        first["approach"].sel({"path[0].load": [300.0, 600.0]}),
    )


@pytest.mark.parametrize("kept", [0.0, 0.1, 0.5, 0.9, 0.999])
def test_the_case_of_a_truncated_file_is_solved_again(tmp_path, calls, kept):
    given = {"path[0].load": [300.0]}
    first = sc.sweep(CASE, given, output=tmp_path, progress=False)
    (file,) = (tmp_path / "cases").iterdir()
    content = file.read_bytes()
    file.write_bytes(content[: int(kept * len(content))])
    xr.testing.assert_identical(sc.sweep(CASE, given, output=tmp_path, progress=False), first)
    assert calls == [300.0, 300.0]
    xr.testing.assert_identical(sc.sweep(CASE, given, output=tmp_path, progress=False), first)
    assert calls == [300.0, 300.0]


def test_a_changed_bit_is_found(tmp_path, calls):
    given = {"path[0].load": [300.0]}
    first = sc.sweep(CASE, given, output=tmp_path, progress=False)
    (file,) = (tmp_path / "cases").iterdir()
    content = bytearray(file.read_bytes())
    place = content.index(first["max_pressure"].values.tobytes())
    content[place] ^= 1
    file.write_bytes(content)
    xr.testing.assert_identical(sc.sweep(CASE, given, output=tmp_path, progress=False), first)
    assert len(calls) == 2


def test_other_heights_in_the_same_file_are_another_case(tmp_path, calls):
    case_file = tmp_path / "rough.toml"
    case_file.write_text(
        MINIMAL.replace('"paraboloid"', '"file"\npath = "heights.npy"').replace("600.0", "300.0")
    )
    given = {"path[0].load": [300.0]}
    with pytest.raises(CaseError, match=r"surface\.path: cannot read heights from .*No such file"):
        sc.sweep(case_file, given, progress=False)
    found = []
    for height in (0.0, 1e-7, 0.0):
        heights = np.zeros((15, 13))
        heights[7, 6] = height
        np.save(tmp_path / "heights.npy", heights)
        found.append(sc.sweep(case_file, given, output=tmp_path / "out", progress=False))
    assert len(calls) == 2
    assert found[0].attrs["case"] == case_file.read_text()
    assert (found[1]["max_pressure"].isel(increment=1) > found[0]["max_pressure"]).all()
    xr.testing.assert_identical(found[2], found[0])


def test_equal_cases_are_solved_once(calls):
    found = sc.sweep(CASE, {"path[0].load": [300.0, 300.0]}, progress=False, mode="zip")
    assert calls == [300.0]
    np.testing.assert_array_equal(found["approach"][0], found["approach"][1])


def test_an_interrupt_keeps_finished_cases(tmp_path, monkeypatch, calls):
    counted = worker.solve_case

    def stopped(content, source):
        if content["path"][0]["load"] == 600.0:
            raise KeyboardInterrupt
        return counted(content, source)

    given = {"path[0].load": [300.0, 600.0, 700.0]}
    with monkeypatch.context() as patch:
        patch.setattr(worker, "solve_case", stopped)
        with pytest.raises(sc.SweepInterrupted) as caught:
            sc.sweep(CASE, given, output=tmp_path, progress=False)
    part = caught.value.dataset
    assert part["status"].values.tolist() == ["done", "cancelled", "cancelled"]
    with results.open_results(tmp_path / "sweep.nc") as stored:
        assert_stored(stored, part)
    calls.clear()
    whole = sc.sweep(CASE, given, output=tmp_path, progress=False)
    assert calls == [600.0, 700.0]
    assert (whole["status"] == "done").all()


def test_an_interrupt_waits_for_an_open_file(tmp_path, monkeypatch):
    write = store.write

    def disturbed(*arguments):
        signal.raise_signal(signal.SIGINT)
        write(*arguments)

    monkeypatch.setattr(store, "write", disturbed)
    with pytest.raises(sc.SweepInterrupted) as caught:
        sc.sweep(CASE, {"path[0].load": [300.0, 400.0]}, output=tmp_path, progress=False)
    assert caught.value.dataset["status"].values.tolist() == ["done", "cancelled"]
    assert len(list((tmp_path / "cases").iterdir())) == 1


def test_an_interrupt_cancels_waiting_tasks(monkeypatch):
    submitted = []

    class Slow:
        """Executor that runs only the first task; then the user interrupts."""

        def submit(self, task, *arguments):
            submitted.append(Future())
            if len(submitted) == 1:
                submitted[0].set_result(task(*arguments))
            return submitted[-1]

    def impatient(futures):
        raise KeyboardInterrupt

    monkeypatch.setattr(run, "as_completed", impatient)
    with pytest.raises(sc.SweepInterrupted) as caught:
        sc.sweep(CASE, FAILING_SWEEP, executor=Slow(), progress=False)
    assert caught.value.dataset["status"].values.tolist() == ["done", "cancelled", "cancelled"]
    assert [future.cancelled() for future in submitted] == [False, True, True]


def test_asperity_cases_in_a_sweep():
    elastic = {"law": "elastic", "E": 200e9, "nu": 0.32}
    case = AsperityCase.model_validate(
        {
            "title": "two spheres",
            "asperities": {
                "R1": 1.0,
                "R2": 1.0,
                "interference": 1e-4,
                "increments": 6,
                "depth": 0.5,
            },
            "body1": elastic,
            "body2": elastic,
            "contact": {"tol": 1e-6},
        }
    )
    found = sc.sweep(case, {"asperities.passes": [1, 2]}, progress=False)
    assert (found["status"] == "done").all()
    assert found["force_x"].dims == ("asperities.passes", "pass", "increment")
    assert found["residual_displacement"].dims == ("asperities.passes", "pass", "body")
    assert np.isnan(found["force_x"][0, 1]).all()
    np.testing.assert_array_equal(found["force_x"][0, 0], found["force_x"][1, 0])


def test_the_command_on_a_cluster(tmp_path, client, undrawn):
    case_file = tmp_path / "case.toml"
    case_file.write_text(MINIMAL)
    outcome = invoke(
        "sweep", case_file, "--set", "path[0].load=300,600", "--set", "path[1].increments=1,2",
        "--zip", "--dask", client.scheduler.address, "--output", tmp_path, "--quiet",
    )  # fmt: skip
    assert outcome.exit_code == 0, outcome.output
    with results.open_results(tmp_path / "sweep.nc") as found:
        assert found.sizes == {"case": 2, "increment": 4}
