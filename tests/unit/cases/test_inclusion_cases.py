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
