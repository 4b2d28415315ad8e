# SPDX-License-Identifier: GPL-3.0-or-later
"""Input decks and output of CalculiX, and the page of comparison with finite elements."""

from typing import NamedTuple

import numpy as np
import pytest

from benchmarks.finite_elements import balls, balls_deck, calculix, tables, wave, wave_deck
from benchmarks.finite_elements import page as finite_elements

STORED_RECORDS = finite_elements.STUDY.records()


class Deck(NamedTuple):
    """Parsed deck: nodes and elements by number, sets and faces by name, the rest by heading."""

    nodes: dict
    elements: dict
    sets: dict
    faces: dict
    others: dict


def read(path):
    deck = Deck({}, {}, {}, {}, {})
    text = path.read_text().replace(",\n", ", ").replace(", *", "\n*")  # joins lines of elements
    for line in text.splitlines():
        if line.startswith("*"):
            heading, kind = line, line.split(",")[0]
            name = line.split("NAME=")[-1].split("SET=")[-1].split(",")[0]
            continue
        words = [word for word in line.replace(" ", "").split(",") if word]
        if kind == "*NODE":
            deck.nodes[int(words[0])] = np.array([float(word) for word in words[1:]])
        elif kind == "*ELEMENT":
            deck.elements[int(words[0])] = [int(word) for word in words[1:]]
        elif kind == "*SURFACE":
            deck.faces.setdefault(name, []).append((int(words[0]), int(words[1][1])))
        elif kind in ("*NSET", "*ELSET"):
            deck.sets.setdefault(name, []).extend(int(word) for word in words)
        else:
            deck.others.setdefault(heading, []).append(words)
    return deck


class TestBalls:
    def test_contact_faces_are_the_surfaces(self, tmp_path):
        balls_deck.write(tmp_path / "deck.inp", per_radius=5)
        deck = read(tmp_path / "deck.inp")
        for corners in deck.elements.values():  # counter-clockwise
            (x0, y0), (x1, y1), _, (x3, y3) = (deck.nodes[n] for n in corners[:4])
            assert (x1 - x0) * (y3 - y0) > (x3 - x0) * (y1 - y0)
        assert set(deck.faces) == {"ABOVE", "BELOW"}
        for name, sides in deck.faces.items():
            for element, side in sides:
                corners, middles = deck.elements[element][:4], deck.elements[element][4:]
                for n in (corners[side - 1], corners[side % 4], middles[side - 1]):
                    x, y = deck.nodes[n]
                    height = x**2 / (2 * balls_deck.RADIUS) if name == "ABOVE" else 0.0
                    assert y == pytest.approx(height, abs=1e-9)

    def test_printed_numbers(self, tmp_path):
        stress = " stresses (elem, integ.pnt.,sxx,syy,szz,sxy,sxz,syz) for set AXIAL and time "
        strain = " equivalent plastic strain (elem, integ.pnt.,pe)for set AXIAL and time "
        moved = " displacements (vx,vy,vz) for set APEX and time "
        force = " total force (fx,fy,fz) for set TOP and time "
        text = ""
        for time, load in (("0.1000000E+01", 3.0), ("0.2000000E+01", 0.0)):
            text += f"{force}{time}\n\n  0. {-load} 0.\n\n{stress}{time}\n\n"
            text += f" 1 1 {load} 0. 0. 0. 0. 0.\n 1 2 0. 0. 0. 0. {1 + load} 0.\n\n"
            text += f"{strain}{time}\n\n 1 1 0.\n 1 2 0.125\n\n{moved}{time}\n\n 1 0. -2. 0.\n"
        (tmp_path / "deck.dat").write_text(text)
        assert balls.numbers_of(tmp_path / "deck.dat") == {
            "load": 540.0,
            "von_mises": pytest.approx(4e6 * np.sqrt(3)),
            "plastic_strain": 0.125,
            "residual_von_mises": pytest.approx(1e6 * np.sqrt(3)),
            "print": pytest.approx(2e-3),
        }


LOWER_FACE, UPPER_FACE = (0, 1, 2, 3, 8, 9, 10, 11), (4, 5, 6, 7, 12, 13, 14, 15)


class TestWave:
    @pytest.fixture
    def deck(self, tmp_path):
        self.count = wave_deck.write(tmp_path / "deck.inp", 4)
        return read(tmp_path / "deck.inp")

    def test_elements_fill_the_quarter(self, deck):
        volume = 0.0
        for number, own in deck.elements.items():
            at = np.array([deck.nodes[n] for n in own])
            edges = at[[1, 3, 4]] - at[0]
            assert np.linalg.det(edges) > 0  # right-handed
            if number <= self.count:
                volume += np.linalg.det(edges)
                for middle, (a, b) in zip(at[8:16], wave_deck.EDGES[:8], strict=True):
                    np.testing.assert_allclose(middle, (at[a] + at[b]) / 2, atol=1e-12)
                np.testing.assert_allclose(at[16:], (at[:4] + at[4:8]) / 2, atol=1e-12)
        assert volume == pytest.approx(0.5**2 * wave_deck.DEPTH * wave_deck.PERIOD**3)
        depths = wave_deck.depths(4)
        assert depths[[1, 2, -1]] == pytest.approx([0.125, 0.25, 1.0])
        thick = np.diff(depths[2:])
        assert thick[1:] / thick[:-1] == pytest.approx(1.3)

    def test_contact_faces_are_the_surfaces(self, deck):
        assert {name: len(sides) for name, sides in deck.faces.items()} == {
            "BELOW": 16,
            "ABOVE": 36,
        }
        for name, sides in deck.faces.items():
            for element, side in sides:
                for place in (LOWER_FACE, UPPER_FACE)[side - 1]:
                    x, y, z = deck.nodes[deck.elements[element][place]]
                    height = 4e-3 * (2 - np.cos(2 * np.pi * x) - np.cos(2 * np.pi * y)) - 1e-4
                    assert z == pytest.approx(height if name == "ABOVE" else 0.0, abs=1e-9)

    def test_sides_slide_and_the_upper_body_is_rigid(self, deck):
        lower = {n for element in range(1, self.count + 1) for n in deck.elements[element]}
        for name, axis, *places in (
            ("ACROSSX", 0, 0.0, 0.5),
            ("ACROSSY", 1, 0.0, 0.5),
            ("BOTTOM", 2, -1.0),
            ("TOP", 2, 0.0),
        ):
            there = {n for n in lower if np.abs(deck.nodes[n][axis] - places).min() < 1e-12}
            assert set(deck.sets[name]) == there, name
        (pushed,) = deck.sets["PUSHED"]
        equations = [words for words in deck.others["*EQUATION"] if len(words) > 1]
        moved = {int(first) for first, *_ in equations} | {pushed}
        assert moved == set(deck.nodes) - lower
        assert {tuple(words[1:]) for words in equations} == {("3", "1.", str(pushed), "3", "-1.")}
        assert deck.others["*CLOAD"] == [[str(pushed), "3", "-290"]]  # a quarter of 1160 N

    def test_printed_numbers(self, tmp_path):
        (tmp_path / "deck.dat").write_text(self.printed(left=0.0))
        compression = 1160 / (210e3 * 0.7 / (1.3 * 0.4))  # of 1 mm, that cannot stretch
        assert wave.numbers_of(tmp_path / "deck.dat") == {
            "approach": pytest.approx(1e-3 * (0.01 + 1e-4 - compression)),
            "von_mises": pytest.approx(4e6 * np.sqrt(3)),
            "plastic_strain": 0.125,
            "residual_von_mises": pytest.approx(1e6 * np.sqrt(3)),
            "print": pytest.approx(2.5e-6),
        }
        (tmp_path / "deck.dat").write_text(self.printed(left=-1.0))
        with pytest.raises(RuntimeError, match=r"after release, but -0\.00345 of it remains"):
            wave.numbers_of(tmp_path / "deck.dat")

    def printed(self, left):
        """Output of CalculiX with the load `left` after release."""
        stress = " stresses (elem, integ.pnt.,sxx,syy,szz,sxy,sxz,syz) for set ZONE and time "
        strain = " equivalent plastic strain (elem, integ.pnt.,pe)for set ZONE and time "
        text = ""
        for time, load, s in (("0.1000000E+01", 290.0, 3.0), ("0.2000000E+01", left, 0.0)):
            text += f" displacements (vx,vy,vz) for set PUSHED and time {time}\n\n 9 0. 0. -.01\n\n"
            text += f" total force (fx,fy,fz) for set BOTTOM and time {time}\n\n 0. 0. {load}\n\n"
            text += f"{stress}{time}\n\n 1 1 {s} 0. 0. 0. 0. 0.\n 1 2 0. 0. 0. 0. {1 + s} 0.\n\n"
            text += f"{strain}{time}\n\n 1 1 0.\n 1 2 0.125\n\n"
            text += f" displacements (vx,vy,vz) for set TOP and time {time}\n\n"
            text += " 1 0. 0. -.002\n 2 0. 0. .0005\n"
        return text


def test_errors_are_those_of_a_known_limit():
    runs = {str(n): {"seconds": 1.0 * n, "a": 2.0 + 8.0 / n**2, "b": 1.0} for n in (2, 4, 8)}
    quantities = {"a": ("a", 1.0), "b": ("b", 1.0)}
    assert tables.limit(runs, "a") == pytest.approx(2.0)
    assert tables.points(runs, quantities) == [pytest.approx((4.0 / n**2, n)) for n in (2, 4, 8)]
    cheaper = {"a grid": [(1.0, 0.1), (0.25, 0.2)]}
    assert tables.ratios(runs, quantities, cheaper).splitlines() == [
        f"- At an error of {error} %, CalculiX takes 20 times as long as samcontact with a grid "
        "chosen by the user."
        for error in ("1e+02", "25")
    ]


def test_both_codes_agree():
    for name, worst in (("balls", 0.045), ("wave", 0.045)):
        theirs, ours = tables.both(finite_elements.runs_of(STORED_RECORDS, name)).values()
        for quantity in finite_elements.PROBLEMS[name].QUANTITIES:
            limit = tables.limit(theirs, quantity)
            assert tables.limit(ours, quantity) == pytest.approx(limit, rel=worst), quantity


def test_a_missing_calculix_is_reported(tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(calculix.NotInstalledError, match="calculix-ccx"):
        wave.finite_elements(tmp_path, 4)
