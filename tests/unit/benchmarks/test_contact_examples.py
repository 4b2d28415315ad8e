# SPDX-License-Identifier: GPL-3.0-or-later
"""Page on the examples of CONTACT: made from stored numbers, which are those of this version."""

import pytest

from benchmarks import contact_examples as examples
from benchmarks.contact_examples import as_printed, units_off

PAGE = examples.STUDY.document_file.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("printed", "value", "shown", "off"),
    [
        ("1.998E-02", 0.0199849, "1.998E-02", 0),
        ("1.998E-02", 0.019991, "1.999E-02", 1),
        ("-1.774E-02", -0.01776, "-1.776E-02", 2),
        ("921", 917.0, "917", 4),
        ("82.43", 82.4352, "82.44", 1),
    ],
)
def test_numbers_are_compared_in_their_last_digit(printed, value, shown, off):
    assert as_printed(printed, value) == shown
    assert units_off(printed, value) == off


def test_the_page_is_made_from_the_stored_numbers():
    records = examples.STUDY.records()
    assert [record["of"] for record in records] == list(examples.EXAMPLES)
    assert examples.page(records) == PAGE


@pytest.mark.parametrize(
    "name",
    [name if name in examples.QUICK_EXAMPLES else pytest.param(name, marks=pytest.mark.slow)
     for name in examples.EXAMPLES],
)  # fmt: skip
def test_the_stored_numbers_are_those_of_this_version(name):
    (stored,) = (r["rows"] for r in examples.STUDY.records() if r["of"] == name)
    for (quantity, printed, value), row in zip(examples.run(name)["rows"], stored, strict=True):
        assert [quantity, printed] == row[:2]
        assert value == pytest.approx(row[2], rel=1e-5)
