# SPDX-License-Identifier: GPL-3.0-or-later
"""The frame of the gallery: what holds, what the table says, what is written."""

from types import SimpleNamespace

import pytest
from matplotlib.figure import Figure

from gallery import __main__, page

NEAR = page.Number("depth", 100.0, 104.0, "nm", "coarse")
FAR = page.Number("depth", 100.0, 106.0, "nm", "coarse", remark="why")
SAID = page.Statement("curves", "coincide", "to 1 %", True, "fine")


def test_a_number_holds_within_its_tolerance():
    assert NEAR.holds
    assert not FAR.holds
    assert FAR.difference == pytest.approx(0.06)


def test_a_mesh_study_replaces_the_thesis_in_the_judgement_only():
    number = page.Number("ratio", 6.0, 5.0, "", "fine", converged=5.1)
    assert number.holds
    assert number.difference == pytest.approx(-1 / 6)
    assert not page.Number("ratio", 6.0, 6.0, "", "fine", converged=5.1).holds


def test_table():
    text = page.table([NEAR, FAR, SAID, page.Number("cells", 23188, 23188, "", "")])
    assert "| depth | 100 nm | 104 nm | +4.0 % | coarse |" in text
    assert "| depth [1] | 100 nm | 106 nm | +6.0 % | coarse |" in text
    assert "| curves | coincide | to 1 % | agrees | fine |" in text
    assert "| cells | 23188 | 23188 | +0.0 % |  |" in text
    assert text.endswith("\n1. why\n")


def test_a_page_has_its_table_and_figures(tmp_path):
    part = SimpleNamespace(
        TITLE="Title",
        INTRODUCTION="\nIntroduction.\n",
        stated=lambda results: [NEAR, results],
        figures=lambda results: [page.Picture("name", "Caption.", Figure())],
    )
    assert page.write("part", part, SAID, tmp_path / "new") == [NEAR, SAID]
    text = (tmp_path / "new" / "part.md").read_text()
    assert "# Title\n\nIntroduction.\n\n| quantity" in text
    assert "![Caption.](name.png)\n\nCaption.\n" in text
    assert (tmp_path / "new" / "name.png").stat().st_size > 0


def test_unknown_parts_are_refused(capsys):
    assert __main__.arguments([]).parts == list(__main__.PARTS)
    with pytest.raises(SystemExit):
        __main__.arguments(["frction"])
    assert "unknown part frction: choose from nano_indentation" in capsys.readouterr().err
