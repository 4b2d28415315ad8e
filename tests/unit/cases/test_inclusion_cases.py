# SPDX-License-Identifier: GPL-3.0-or-later
"""Inclusions of bodies in case files."""

import pytest

import samcontact as sc
from samcontact.cases import parse_case

TEXT = """
title = "Oxide in a coated body"
[grid]
nx = 16
ny = 16
dx = "2 um"
dy = "2 um"
dz = "2 um"
[surface]
shape = "sphere"
R = "2 mm"
[body1]
law = "rigid"
[body2]
law = "elastic"
E = "210 GPa"
nu = 0.3
[[body2.layers]]
E = "400 GPa"
nu = 0.2
thickness = "4 um"
[[body2.inclusions]]
center = [0.0, 0.0, "{depth} um"]
radius = "8 um"
E = "390 GPa"
nu = 0.25
[[path]]
load = 0.5
"""


def test_inclusion_below_a_coating():
    body = parse_case(TEXT.format(depth=14)).body2.build()
    assert isinstance(body, sc.Heterogeneous)
    assert body.matrix == sc.Layered(
        [(sc.Material.elastic(400e9, 0.2), 4e-6)], sc.Material.elastic(210e9, 0.3)
    )
    with pytest.raises(ValueError, match=r"inclusions\[0\] must lie within one layer"):
        parse_case(TEXT.format(depth=8))


THERMAL = """[body2{place}.thermal]
conductivity = {conductivity}
expansion = 8e-6
diffusivity = 1e-5
"""


def test_expansion_of_an_inclusion():
    own = THERMAL.format(place=".inclusions", conductivity=30.0)
    heated = TEXT.format(depth=14).replace("nu = 0.25\n", "nu = 0.25\n" + own)
    with pytest.raises(ValueError, match=r"body2.inclusions\[0\].thermal has no effect without"):
        parse_case(heated)
    for place, before in (("", "[[body2.layers]]"), (".layers", "[[body2.inclusions]]")):
        heated = heated.replace(before, THERMAL.format(place=place, conductivity=50.0) + before)
    heated += "[heat]\nfactor = [0.0, 1e-3]\nvelocity = [0.0, 1.0]\n[contact]\nfriction = 0.2\n"
    body = parse_case(heated).body2.build()
    assert body.phases[0].thermal == (30.0, 8e-6, 1e-5)
    assert len(body.thermal) == 2
    void = heated.replace("E = 390e9\n", "").replace('E = "390 GPa"\nnu = 0.25', 'law = "void"')
    with pytest.raises(ValueError, match='thermal must not be given with law = "void"'):
        parse_case(void)
