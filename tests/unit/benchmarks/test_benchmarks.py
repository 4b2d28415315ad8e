# SPDX-License-Identifier: GPL-3.0-or-later
"""Small benchmarks: generated surfaces, fits, measurements and tables."""

import importlib
import subprocess
import sys

import numpy as np
import pandas as pd
import pytest
from click.testing import CliRunner

from benchmarks import (
    accuracy,
    accuracy_cases,
    accuracy_cost,
    elastic_smooth,
    harness,
    operators,
    plastic_zones_large,
    plots,
    resolution,
    roughness,
    scaling,
    slip,
    tables,
    threads,
)
from benchmarks.__main__ import DEFAULT_PARTS, PARTS, main


class TestRoughness:
    def test_every_grid_samples_the_same_surface(self):
        waves = roughness.wave_amplitudes(6, 0.8, seed=2)
        coarse, fine = (roughness.heights(n, waves, 1e-6) for n in (20, 60))
        # each coarse cell centre is the centre of the middle one of three fine cells
        np.testing.assert_allclose(fine[1::3, 1::3], coarse, atol=1e-20)
        assert np.sqrt(np.mean(coarse**2)) == pytest.approx(1e-6, rel=1e-12)
        assert np.mean(coarse) == pytest.approx(0.0, abs=1e-20)

    def test_spectrum_is_self_affine(self):
        highest, hurst, n = 24, 0.8, 64
        surface = roughness.heights(n, roughness.wave_amplitudes(highest, hurst, seed=1), 1.0)
        power = np.abs(np.fft.fft2(surface)) ** 2
        k = n * np.hypot(*np.meshgrid(*[np.fft.fftfreq(n)] * 2, indexing="ij"))
        assert power[k > highest + 1e-9].max() < 1e-20 * power.max()
        off_axis = (k <= highest) & (k > 0)
        off_axis[:, 0] = False  # opposite waves interfere there
        slope, _ = np.polyfit(np.log(k[off_axis]), np.log(power[off_axis]), 1)
        assert slope == pytest.approx(-2 * (1 + hurst), abs=1e-9)

    def test_seeds(self):
        one, same, other = (roughness.wave_amplitudes(5, 0.8, seed=s) for s in (1, 1, 2))
        assert np.array_equal(one, same)
        assert not np.array_equal(one, other)

    def test_waves_need_cells(self):
        with pytest.raises(ValueError, match="n must be > 12"):
            roughness.heights(12, roughness.wave_amplitudes(6, 0.8, seed=1), 1.0)

    def test_block_means(self):
        field = np.arange(36.0).reshape(6, 6)
        assert roughness.block_means(field, 2)[0, 0] == field[:3, :3].mean()
        assert roughness.block_means(field, 3).mean() == field.mean()


@pytest.mark.filterwarnings("ignore::UserWarning")
def test_a_rough_contact_converges_as_its_page_says():
    rows = [point | row for point in resolution.points(True) for row in resolution.run(**point)]
    stored = resolution.STUDY.document_file.read_text(encoding="utf-8")
    for coarse, fine in resolution.by_load(rows).values():
        for line in resolution.area_table([coarse, fine]).splitlines()[2:]:
            cells_and_area = line.split(" | ")[:5]  # errors are against finer grids there
            assert " | ".join(cells_and_area) in stored
        wrong = coarse["area"] / fine["area"] - 1
        assert 0.5 < wrong / (coarse["uncertainty"] - fine["uncertainty"]) < 1.0
        assert coarse["pressure"] * coarse["area"] == pytest.approx(fine["pressure"] * fine["area"])
    parted = [row | {"of": "increments"} for row in rows[:2]]
    assert "python -m benchmarks.resolution --docs" in resolution.page(rows + parted)


@pytest.mark.filterwarnings("ignore::UserWarning")
def test_cost_compared_with_manual_grids():
    hand = accuracy_cost.by_hand("balls, 1500 N", range(3))
    mine = accuracy_cost.chosen("balls, 1500 N", 0.05)
    assert [one.error for one in hand] == sorted((one.error for one in hand), reverse=True)
    assert hand[-1].error < 0.01
    assert mine.error < 0.05


@pytest.mark.filterwarnings("ignore::UserWarning")
def test_stated_errors_cover_true_ones():
    name = "semi-axes 1:4"
    found = accuracy.judged(name, accuracy.closed_form(accuracy_cases.CASES[name]), 0.01)
    assert found["true"].keys() == {"max_pressure", "contact_area", "approach"}
    for quantity, true in found["true"].items():
        assert 0 < true < found["stated"][quantity] < 0.01


def test_exponent_of_a_power():
    cells = np.array([1e5, 3e5, 1e6])
    assert scaling.exponent(cells, 7e-6 * cells**1.25) == pytest.approx(1.25)
    rows = [
        {"method": "fast", "box_cells": n, "time_s": n**1.5, "memory_MB": n, **applied}
        for n, applied in zip((1e3, 2e5, 1e6), [{"volume_applications": 10}] * 3, strict=True)
    ]
    assert scaling.exponents(rows)["time per application"] == pytest.approx(1.5)
    assert scaling.exponents(rows)["peak memory"] == pytest.approx(1.0)
    assert scaling.exponents(rows[:2]) == {}


def test_thread_efficiency_is_stated_for_the_worst_case():
    rows = [
        {"case": "plastic subdomains", "method": "2 threads", "cells": cells, "time_ratio": ratio}
        for cells, ratio in ((1e3, 1.02), (2e5, 0.55), (1e6, 0.625))
    ]
    rows += [
        {"case": "plastic subdomains", "method": threads.BASE, "cells": 1e3, "time_ratio": 1.0}
    ]
    (text,) = threads.notes(rows)
    expected = (
        "- plastic subdomains: on two threads, the efficiency is at least 0.80 in large cases, and "
    )
    assert text.startswith(expected)


def test_sampled_strain_is_axisymmetric():
    """A known field in cylindrical components, sampled off the axis."""
    r, z = np.linspace(0, 1, 41), np.linspace(0.01, 0.99, 30)
    rr, tt, rz = 1 + r[:, None] * z, 1 - r[:, None] * z, r[:, None] * (1 + z)
    strain = np.zeros((6, r.size, z.size))
    strain[0], strain[1], strain[2], strain[4] = rr, tt, -rr - tt, rz
    grid = operators.sc.Grid(9, 9, 0.1, 0.1, 4, 0.2)
    found = operators.sample({"r": r, "z": z, "strain": strain}, grid)
    np.testing.assert_allclose(found[:3].sum(axis=0), 0, atol=1e-12)
    i, j, k = 7, 6, 2  # x = 0.3, y = 0.2
    np.testing.assert_allclose(found[4, i, j, k], 0.3 * (1 + grid.z[k]), rtol=1e-3)
    np.testing.assert_allclose(found[3, i, j, k], 0.2 * (1 + grid.z[k]), rtol=1e-3)
    rho = np.hypot(0.3, 0.2)
    expected = 2 * rho * grid.z[k] * 0.3 * 0.2 / rho**2
    np.testing.assert_allclose(found[5, i, j, k], expected, rtol=1e-3)


def test_the_meter_repeats_short_runs():
    calls = []
    meter = harness.Meter()
    assert meter(lambda: calls.append(1) or len(calls)) == 3
    assert 0 <= meter.time < harness.MAX_REPEATED_SECONDS


def test_the_meter_measures_memory():
    # in a new process, because this one may have used more memory before
    code = (
        "import numpy as np; from benchmarks.harness import Meter\n"
        "meter = Meter(); kept = meter(lambda: np.ones(3_000_000)); print(meter.memory)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=harness.ROOT, capture_output=True, text=True, check=True
    )
    assert 23e6 < int(done.stdout) < 30e6


@pytest.fixture(scope="module")
def rows(tmp_path_factory):
    tasks = elastic_smooth.tasks(True, tmp_path_factory.mktemp("data"))
    return harness.run_tasks([task for task in tasks if task.arguments["n"] <= 64])


def test_measurement_in_a_process_of_its_own(rows):
    assert len(rows) == 2 * len(elastic_smooth.METHODS)
    for row in rows:
        assert "failed" not in row
        assert row["time_s"] > 0
        assert row["memory_MB"] >= 0
        assert row["contact_iterations"] > 0
        assert row["time_ratio"] > 0
        assert row["error: largest pressure"] < 5e-3
    assert rows[0]["time_ratio"] == 1.0


def as_on_the_page(part, rows):
    """Counts and errors are independent of the machine, except for rounding."""
    page = (harness.ROOT / "docs" / "benchmarks.md").read_text(encoding="utf-8")
    stored = tables.rows_of(tables.section_of(page, part))
    key = ("case", "method", "cells")
    there = {tuple(one[name] for name in key): one for one in stored}
    shared = [row for row in rows if tuple(row[name] for name in key) in there]
    assert len(shared) > len(rows) / 2  # others are small forms of larger ones
    for row in shared:
        known = there[tuple(row[name] for name in key)]
        for name in known.keys() - {*key, *tables.TIMES, "time_ratio", "memory_MB"}:
            assert row[name] == pytest.approx(known[name], rel=0.2, abs=1.1), (row["case"], name)
        for name in [name for name in known if name.startswith("error: ")]:
            assert row[name] == pytest.approx(known[name], rel=0.1, abs=1e-5), (row["case"], name)


def test_small_sizes_are_those_of_the_page(rows):
    as_on_the_page(elastic_smooth, rows)


def test_table(rows):
    table = tables.frame(rows)
    assert list(table.columns[:6]) == list(tables.FIRST_COLUMNS)
    assert {"time_s", "time_ratio", "memory_MB", "contact_iterations"} <= set(table.columns)
    text = tables.report(table, [elastic_smooth])
    header = next(line for line in text.splitlines() if line.startswith("| case"))
    assert "| error: largest pressure |" in header
    assert "| time_s | time_ratio | memory_MB |" in header
    assert text.count("\n| Hertz |") == len(rows)
    for_docs = tables.report(table, [elastic_smooth], times=False)
    assert "time_s" not in for_docs
    assert "time_ratio" in for_docs


@pytest.mark.parametrize(
    ("value", "text"), [(1024.0, "1024"), (0.0012345, "0.00123"), (float("nan"), ""), ("a", "a")]
)
def test_cell(value, text):
    assert tables.cell(value) == text


def test_tables_go_between_the_markers_of_the_documentation():
    page = (harness.ROOT / "docs" / "benchmarks.md").read_text(encoding="utf-8")
    once = tables.between_markers(page, "new tables")
    assert "\nnew tables\n" in once
    assert tables.between_markers(once, "new tables") == once
    with pytest.raises(ValueError, match="measured: begin"):
        tables.between_markers("a page without", "text")


def test_tables_of_some_parts_replace_only_theirs():
    old = "old head\n\n### A\n\n| a |\n\nnote\n\n### C\n\n| c |"
    new = "new head\n\n### B\n\n| b |\n\n### C\n\n| d |\n"
    assert tables.with_sections(old, new, ["A", "B", "C", "D"]) == (
        "new head\n\n### A\n\n| a |\n\nnote\n\n### B\n\n| b |\n\n### C\n\n| d |\n"
    )
    page = (harness.ROOT / "docs" / "benchmarks.md").read_text(encoding="utf-8")
    titles = [importlib.import_module(f"benchmarks.{name}").TITLE for name in PARTS]
    inside = tables.inside_markers(page)
    assert tables.with_sections(inside, inside.split("###")[0], titles).strip() == inside


class TestSlip:
    """Work of the tangential problem: the bounds on the page hold on small grids."""

    @pytest.fixture(scope="class")
    @classmethod
    def rows(cls, tmp_path_factory):
        tasks = slip.tasks(True, tmp_path_factory.mktemp("data"))
        small = [t for t in tasks if t.arguments.get("n", 64) in (64, [72, 81])]
        with pytest.MonkeyPatch.context() as patch:  # the work is that of any process
            patch.setattr(harness, "measure", harness.run_here)
            return harness.run_tasks([t for t in small if t.case != "Q = 0.1 mu P"])

    def test_work_is_bounded(self, rows):
        assert not [row for row in rows if "failed" in row]
        for row in rows:
            if row["case"].startswith("Q = ") and row["method"] in ("tol 1e-4", "tol 1e-8"):
                assert row["shear_work"] <= (25 if row["method"] == "tol 1e-4" else 50)
                assert row["shear_applications"] <= 6
                assert row["error: tangential displacement"] < 1e-3
        (entry,) = [row for row in rows if row["case"] == slip.ENTRY]
        assert entry["max_applications_per_step"] <= 25
        (shifted,) = [row for row in rows if row["case"].endswith("tangential displacement")]
        assert shifted["error: force"] < 1e-3

    def test_they_are_those_of_the_page(self, rows):
        as_on_the_page(slip, [row for row in rows if row["case"] != slip.ENTRY])  # fewer steps

    def test_notes_state_the_maximum(self, rows):
        (note,) = slip.notes(rows)
        maximum = max(
            r["shear_work"] for r in rows if r["case"][0] == "Q" and r["method"] == "tol 1e-8"
        )
        assert f"{maximum:.0f} (tolerance 1e-8)" in note
        assert "CONTACT" not in note  # of its own grid only


def test_diagram(rows):
    figure = plots.diagram(pd.DataFrame(rows), elastic_smooth)
    labels = {axes.get_xlabel() for axes in figure.axes}
    assert {"time [s]", "peak memory [MB]"} < labels
    assert all(axes.get_xscale() == axes.get_yscale() == "log" for axes in figure.axes)
    assert plots.diagram(pd.DataFrame(rows[:1]), elastic_smooth) is None
    plots.plt.close(figure)


def test_a_failure_is_a_row():
    task = harness.Task("images", "none", "image_tol 1", "apply", {"box": "no such box"})
    (row,) = harness.run_tasks([task])
    assert "TypeError" in row["failed"]
    assert "time_ratio" not in row


@pytest.mark.parametrize("name", PARTS)
def test_parts_are_complete(name, tmp_path):
    part = importlib.import_module(f"benchmarks.{name}")
    assert name == part.NAME
    for quick in (True, False):
        tasks = part.tasks(quick, tmp_path)
        assert tasks
        for task in tasks:
            assert task.part == name
            assert callable(getattr(part, task.function))
            assert task.reference in {"", *(other.method for other in tasks)}
    assert f"`{name}`" in (harness.ROOT / "docs" / "benchmarks.md").read_text(encoding="utf-8")


def test_choice_of_parts():
    assert set(PARTS) - set(DEFAULT_PARTS) == {plastic_zones_large.NAME}
    done = CliRunner().invoke(main, ["nothing"])
    assert done.exit_code == 2
    assert "'nothing' is not one of 'elastic_smooth'" in done.output
