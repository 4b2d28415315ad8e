# SPDX-License-Identifier: GPL-3.0-or-later
"""Tools of the gallery: tolerances, tables, and written pages."""

import re
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest
from matplotlib.figure import Figure
from PIL import Image

from gallery import moves, page, parts, stated
from gallery.__main__ import main

ROOT = Path(__file__).parents[3]
PAGES = ROOT / "docs" / "gallery"
NEAR_NUMBER = stated.Number("depth", 100.0, 104.0, "nm", "coarse")
FAR_NUMBER = stated.Number("depth", 100.0, 106.0, "nm", "coarse", remark="why")
STATED_CURVES = stated.Statement("curves", "coincide", "to 1 %", True, "fine")


def test_a_number_holds_within_its_tolerance():
    assert NEAR_NUMBER.holds
    assert not FAR_NUMBER.holds
    assert FAR_NUMBER.difference == pytest.approx(0.06)


def test_a_mesh_study_replaces_the_thesis_in_the_judgement_only():
    number = stated.Number("ratio", 6.0, 5.0, "", "fine", converged=5.1)
    assert number.holds
    assert number.difference == pytest.approx(-1 / 6)
    assert not stated.Number("ratio", 6.0, 6.0, "", "fine", converged=5.1).holds


def test_table():
    text = page.table(
        [NEAR_NUMBER, FAR_NUMBER, STATED_CURVES, stated.Number("cells", 23188, 23188, "", "")], {}
    )
    assert "| depth | 100 nm | 104 nm | +4.0 % | coarse |" in text
    assert "| depth [1] | 100 nm | 106 nm | +6.0 % | coarse |" in text
    assert "| curves | coincide | to 1 % | agrees | fine |" in text
    assert "| cells | 23188 | 23188 | 0.0 % |  |" in text
    assert text.endswith("\n1. why\n")


def test_a_table_says_how_much_values_move_with_the_mesh():
    moved = [moves.Moves("depth", [104.0], {"cells": moves.Move(2.345, own=False)})]
    text = page.table([NEAR_NUMBER, STATED_CURVES], moved)
    assert "| depth | 100 nm | 104 nm | +4.0 % | coarse | 2.3 % |" in text
    assert "| curves | coincide | to 1 % | agrees | fine |  |" in text
    assert moves.COARSE_MESH_NOTE in text


def test_moves_are_those_of_the_page_if_computed():
    def of(mesh, change, found, part="one"):
        kind = "values" if change == "none" else "moves"
        return {"of": part, "mesh": mesh, "change": change, kind: found}

    two, one = "load, k = 1, 2", "load, k = 1"
    records = [
        of("page", "none", {two: [1.0, 2.0], "width": []}),
        of("page", "layers", {two: 3.0, "width": 0.1}),
        of("coarse", "none", {one: [1.5], "width": []}),
        of("coarse", "cells", {one: 5.0}),
        of("coarse", "layers", {one: 50.0, "width": 7.0}),
        of("coarse", "increments", {one: 120.0}),
        of("coarse", "cells", {"width": 9.0}, part="other"),
    ]
    load, width = moves.of_part("one", records)
    assert load.values == [1.0, 2.0]
    coarse = {"cells": moves.Move(5.0, own=False), "increments": moves.Move(120.0, own=False)}
    assert load.by == coarse | {"layers": moves.Move(3.0, own=True)}
    assert moves.column([load, width]) == {"loadk": "(> 100 %)", "width": "0.1 %"}
    assert moves.note([load, width]) == moves.BOTH_MESHES_NOTE
    assert moves.note([width]) == moves.OWN_MESH_NOTE


def test_every_row_of_the_table_is_stated_once():
    """Each computed value has one row in the statements, in the order of the page."""
    for name, rows in stated.table().items():
        files = [
            file
            for file in (ROOT / "gallery").rglob("*.py")
            if name in (file.stem, file.parent.name)
        ]
        text = "".join(file.read_text(encoding="utf-8") for file in files)
        calls = re.findall(r'\.(number|trend)\(\s*"([^"]+)"', text)
        assert sorted(key for _, key in calls) == sorted(rows), name
        for kind, key in calls:
            assert (kind == "trend") == ("ours" in rows[key]), key
    assert stated.table().keys() == parts.PARTS.keys()


def test_a_row_is_filled(monkeypatch):
    rows = {"a": {"quantity": "a, {which}", "thesis": 2.0, "unit": "m", "mesh": "closed form"},
            "b": {"quantity": "b", "thesis": "more", "ours": "{} to {:.1f} %"},
            "c": {"quantity": "{at:g} N", "thesis": {"8": 1.0, "9.5": 2.0},
                  "remark": {"8": "c"}}}  # fmt: skip
    monkeypatch.setattr(stated, "table", lambda: {"part": rows})
    said = stated.Stated("part").on("coarse", which="k = 1")
    assert said.number("a", 2.1) == stated.Number("a, k = 1", 2.0, 2.1, "m", "closed form")
    assert said.number("a", 2.1, mesh="fine", thesis=3.0).difference == pytest.approx(-0.3)
    assert said.number("c", 1.1, at=8.0) == stated.Number("8 N", 1.0, 1.1, "", "coarse", remark="c")
    assert said.number("c", 1.1, at=9.5).thesis == said.values("c")[9.5] == 2.0
    found = said.trend("b", True, [1.0, 0.12345], 7.0, remark="why")
    assert found == stated.Statement("b", "more", "1, 0.123 to 7.0 %", True, "coarse", "why")


@pytest.mark.parametrize("name", parts.PARTS)
def test_the_column_of_a_page_is_that_of_the_kept_table(name):
    """A difference means that the page is older than the table, or that quantities were renamed."""
    found = moves.of_part(name, moves.kept())
    rows = (PAGES / f"{name}.md").read_text().splitlines()
    shown = {row.split(" | ")[-1].rstrip(" |") for row in rows if row.startswith("| ")}
    assert shown - {"", "sensitivity"} == set(moves.column(found).values())


def test_a_page_has_its_table_and_figures(tmp_path):
    part = SimpleNamespace(
        TITLE="Title",
        INTRODUCTION="\nIntroduction.\n",
        stated=lambda results: [NEAR_NUMBER, results],
        figures=lambda results: [page.Picture("name", "Caption.", Figure())],
    )
    assert page.write("part", part, STATED_CURVES, tmp_path / "new") == [NEAR_NUMBER, STATED_CURVES]
    text = (tmp_path / "new" / "part.md").read_text()
    assert "# Title\n\nIntroduction.\n\n| quantity" in text
    assert "![Caption.](name.png)\n\nCaption.\n" in text
    with Image.open(tmp_path / "new" / "name.png") as image:
        assert image.mode == "P"
        assert image.convert("RGB").getpixel((0, 0)) == (255, 255, 255)
        assert image.info["dpi"][0] == pytest.approx(80, rel=1e-3)


def test_parts_by_name_and_by_figure():
    assert parts.part_of("friction") == "friction"
    assert parts.part_of("2.12") == "flattening"
    assert parts.part_of("3.8") == "rolling"
    assert parts.part_of("2.14") == "nano_indentation"
    for name, text in (
        ("frction", "unknown part 'frction' of the gallery: did you mean friction"),
        ("zzz", "choose from nano_indentation"),
        ("1.1", "figure 1.1 is not in the gallery"),
    ):
        with pytest.raises(ValueError, match=text):
            parts.part_of(name)


def test_the_command_makes_a_part(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(
        page.Picture, "save", lambda self, folder: (folder / f"{self.name}.png").touch()
    )  # drawing takes long
    assert main(["2.14", "--quick", "--output", str(tmp_path)]) == 0
    assert "nano_indentation: " in capsys.readouterr().out
    assert "# Nano" in (tmp_path / "nano_indentation.md").read_text()
    assert list(tmp_path.glob("*.png"))


def test_the_command_lists_parts_and_refuses_others(capsys):
    assert main(["--list"]) == 0
    assert re.search(r"^asperities +4\.7 to 4\.11$", capsys.readouterr().out, re.MULTILINE)
    with pytest.raises(SystemExit, match="2"):
        main(["frction"])
    assert "did you mean friction" in capsys.readouterr().err


def test_the_command_fails_when_a_value_differs(tmp_path, monkeypatch):
    part = SimpleNamespace(
        TITLE="Title",
        INTRODUCTION="",
        compute=lambda quick: NEAR_NUMBER if quick else FAR_NUMBER,
        stated=lambda results: [results],
        figures=lambda results: [],
    )
    monkeypatch.setitem(sys.modules, "gallery.asperities", part)
    given = ["asperities", "--output", str(tmp_path)]
    assert [main(given), main([*given, "--quick"])] == [1, 0]


def test_every_part_has_its_figures_on_the_first_page():
    text = (Path(__file__).parents[3] / "docs" / "gallery.md").read_text()
    for name in parts.PARTS:
        assert re.search(rf"\(gallery/{name}\.md\) \| {parts.figures_of(name)} ", text), name
