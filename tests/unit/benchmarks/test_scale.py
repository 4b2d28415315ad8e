# SPDX-License-Identifier: GPL-3.0-or-later
"""Growth of time and memory: stored numbers are within their limits and make up the page."""

import numpy as np
import pytest

from benchmarks.harness import Meter
from benchmarks.scale import cluster, jobs
from benchmarks.scale.page import STUDY, above, bytes_a_cell, caches, fits, growth, of, overall

STORED = STUDY.records()


@pytest.mark.parametrize("job", jobs.JOBS, ids=lambda job: job.function)
def test_stored_time_and_memory_keep_their_bounds(job):
    rows = of(STORED, job)
    assert rows[-1]["cells"] >= 900 * rows[0]["cells"]
    assert overall(rows) <= job.exponent
    assert bytes_a_cell(rows[-1]) <= job.stated


@pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
@pytest.mark.parametrize("job", jobs.JOBS, ids=lambda job: job.function)
def test_a_size_is_counted_as_stored(job):
    """Cells and, except for rounding, counters are independent of the machine."""
    stored = of(STORED, job)[0]
    found = getattr(jobs, job.function)(Meter(), job.sizes[0])
    assert found["cells"] == stored["cells"]
    for name in {"transforms", "volume_applications"} & set(stored):
        assert found[name] == pytest.approx(stored[name], rel=0.2)


def test_growth_is_the_exponent_of_the_last_decade():
    cells = 4.0 ** np.arange(3, 10)
    rows = [{"cells": n, "cpu_s": max(1e-3, 1e-8 * n**1.2)} for n in cells]
    assert growth(rows) == pytest.approx(1.2)


def made_up(power, cells=(64**2, 128**2, 256**2)):
    """Return rows of all jobs, with times that grow with this power of the cells."""
    return [
        {"of": job.function, "n": int(n**0.5), "cells": n, "cpu_s": n**power,
         "memory_MB": 1e-4 * n, "transforms": 10}
        for job in jobs.JOBS
        for n in cells
    ]  # fmt: skip


def test_sentences_follow_the_numbers():
    assert above(made_up(1.1)) == "No exponent is above 1.15 over all sizes."
    rows = made_up(1.1)
    for row in of(rows, jobs.JOBS[2]):
        row["cpu_s"] = row["cells"] ** 1.25
    assert above(rows) == f"Above 1.15 over all sizes: {jobs.JOBS[2].name} (exponent 1.25)."
    of(rows, jobs.JOBS[1])[2]["cpu_s"] *= 3
    assert caches(rows).startswith("from 128 × 128 to 256 × 256 cells")
    assert f"{3 * 4**0.1:.1f} times as long" in caches(rows)
    assert fits({"a": 1e11, "b": 2e13}).endswith("machine: a. The others do not.")
    assert fits({"a": 1e11}).endswith("machine: a.")
    assert fits({"a": 2e13}).startswith("None fits into 1 TB")


@pytest.mark.parametrize("padded", [False, True])
def test_a_transpose_sends_the_half_spectrum(padded):
    rows = np.fft.rfft(np.zeros((12, 24 if padded else 12)))
    assert cluster.bytes_of_a_transpose(12, padded) == rows.astype(complex).nbytes
    # each of four processes keeps a quarter of its quarter in both directions
    sent = cluster.bytes_of_a_rank(12, 4, padded)
    assert sent == pytest.approx(2 * 3 / 16 * rows.nbytes)
    assert 2 * 3 * cluster.message(12, 4, padded) == pytest.approx(sent)
