# SPDX-License-Identifier: GPL-3.0-or-later
"""Pairs of capabilities work, or are refused, as the page on combinations says."""

import pytest

from benchmarks.combinations.page import STUDY

STORED = {(record["first"], record["second"]): record["refusal"] for record in STUDY.records()}


def check(point):
    assert STUDY.run(**point)["refusal"] == STORED[point["first"], point["second"]]


@pytest.mark.parametrize("point", STUDY.points(True), ids=lambda point: point["second"])
def test_pairs_of_each_kind(point):
    check(point)


@pytest.mark.slow
@pytest.mark.parametrize("point", STUDY.points(False), ids=lambda p: f"{p['first']}, {p['second']}")
def test_all_pairs(point):
    check(point)
