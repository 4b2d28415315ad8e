# SPDX-License-Identifier: GPL-3.0-or-later
"""Physical limits: what steps need, counted independently; stored times are above the limit."""

import math

import numpy as np
import pytest

from benchmarks.harness import Meter
from benchmarks.roofline import jobs, machine, needs
from benchmarks.roofline.page import STUDY, above, largest, limit, rates, ratio, transform_ratio

STORED = STUDY.records()


def lines_of(plane):
    """Return the lines of a plane that are not zero, counted by a loop over them."""
    return sum(bool(line.any()) for line in plane)


@pytest.mark.parametrize("padded", [False, True])
def test_a_transform_counts_the_lines_that_are_not_zero(padded):
    n = 16
    size = 2 * n if padded else n
    plane = np.zeros((size, size))
    plane[:n, :n] = 1 + np.random.default_rng(1).random((n, n))
    rows = lines_of(plane) * 2.5 * size * math.log2(size)
    half = np.fft.rfft(plane, axis=1)
    columns = lines_of(half.T) * 5 * size * math.log2(size)
    need = needs.transform(n, n, padded=padded)
    assert need.flops == pytest.approx(rows + columns)
    stored = half[:n].nbytes
    assert need.bytes == n * n * 8 + 2 * stored
    assert needs.spectrum(n, n, padded=padded) == half.size


def test_a_volume_needs_more_than_its_transforms_and_less_than_all_pairs_of_layers():
    box = (32, 32, 16)
    plane = needs.transform(32, 32, padded=True)
    need = needs.volume(box, padded=True)
    assert need.flops > 16 * 11 * plane.flops
    pairs = 16 * 16 * 30 * 2 * needs.spectrum(32, 32, padded=True)
    assert need.flops < 16 * 13 * plane.flops + pairs
    assert needs.volume((32, 32, 32), padded=True).flops == pytest.approx(2 * need.flops, rel=0.02)


def test_nested_dissection_grows_with_the_power_three_halves():
    assert needs.dissection(4 * 64**2).flops == 8 * needs.dissection(64**2).flops
    assert needs.substitution(64**2).flops < 0.1 * needs.dissection(64**2).flops


def test_a_box_around_cells():
    cells = np.zeros((8, 9), dtype=bool)
    assert jobs.box_around(cells) == (1, 1)
    cells[2, 3] = cells[6, 5] = True
    assert jobs.box_around(cells) == (5, 3)


@pytest.mark.filterwarnings("ignore::UserWarning")
@pytest.mark.parametrize("name", ["smooth", "film", "ball", "viscoelastic"])
def test_a_job_needs_what_is_stored(name):
    job = jobs.BY_NAME[name]
    found = job.solve(Meter(), job.sizes[0])
    (row,) = (row for row in STORED if row["of"] == name and row["n"] == job.sizes[0])
    assert found.need.flops == pytest.approx(row["flops"], rel=0.1)
    assert found.need.bytes == pytest.approx(row["bytes"], rel=0.1)


def test_no_job_is_faster_than_the_machine():
    assert {row["of"] for row in STORED} == set(jobs.BY_NAME)
    for row in STORED:
        assert ratio(row) >= transform_ratio(row) > 1
        assert limit(row) >= row["flops"] / rates(row).product


def test_rates_are_of_the_right_size():
    """A product of matrices is at least as fast as a transform."""
    found = machine.measured(2.0**18)
    assert found.product > found.transform > 1e7
    assert found.copy > 1e8
    assert found.best(machine.Machine(0.0, math.inf, 0.0)).transform == math.inf


def test_the_sentence_lists_the_largest_ratios_first():
    rows = [dict(row, seconds=2 * limit(row)) for row in STORED]
    assert "no job takes more than 4 times" in above(rows)
    slow = largest(rows)["film"]
    slow["seconds"] *= 1000
    assert ": film (" in above(rows)
