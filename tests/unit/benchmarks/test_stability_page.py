# SPDX-License-Identifier: GPL-3.0-or-later
"""Stability page: stored numbers are within their limits; one row per table is reproduced."""

import pytest

from benchmarks.stability.page import STUDY, TABLES
from benchmarks.stability.table import COUNT, ROUNDING, VALUE, Column
from benchmarks.study import by_group

STORED = {
    name: {row["row"]: row for row in rows} for name, rows in by_group(STUDY.records()).items()
}
by_table = pytest.mark.parametrize("known", TABLES, ids=lambda known: known.name)


def beyond(known, rows):
    return [
        (row, column.key, found[column.key])
        for row, found in rows.items()
        for column in known.columns
        if column.at_most is not None and (found.get(column.key) or 0.0) > column.at_most
    ]


@by_table
def test_stored_numbers_are_within_their_limits(known):
    assert beyond(known, STORED[known.name]) == []


@by_table
@pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
def test_a_stored_row_is_reproduced(known):
    found, stored = known.solve(known.retested_row), STORED[known.name][known.retested_row]
    assert beyond(known, {known.retested_row: found}) == []
    for column in known.columns:
        pair = found.get(column.key), stored.get(column.key)
        assert column.agree(*pair), (column.key, pair)


def test_agreement_of_columns():
    assert Column("", "", COUNT).agree(12, 10)
    assert not Column("", "", COUNT).agree(50, 10)
    assert Column("", "", VALUE).agree(1.00001, 1.0)
    assert not Column("", "", VALUE).agree(1.001, 1.0)
    assert Column("", "", ROUNDING).agree(1e-16, 3e-15)
    assert not Column("", "", VALUE).agree(None, 1.0)
