# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases of all kinds with long texts."""

from samcontact.cases import parse_case

CASE = """
title = "{title}"
description = "{long}"
{asperities}
[body1]
law = "rigid"
[body2]
law = "elastic"
E = 1e9
nu = 0.3
"""
CONTACT = """
[grid]
nx = 4
ny = 4
dx = 1e-6
dy = 1e-6
[surface]
shape = "sphere"
R = 1.0
[[path]]
load = 1.0
"""
FILM = """title = "{title}"
description = "{long}"
[lubricant]
grade = "ISO VG 68"
temperature = 343.0
[film]
load = 20.0
entrainment = 1.0
[body1]
law = "elastic"
E = 210e9
nu = 0.3
[body2]
law = "rigid"
[surface]
shape = "sphere"
R = 0.01
"""
ASPERITIES = "[asperities]\nR1 = 1.0\nR2 = 1.0\ninterference = 1e-3"


def long_cases():
    fields = {"title": "t" * 500, "long": "d" * 5000}
    made = [parse_case(CASE.format(asperities=kind, **fields)) for kind in (CONTACT, ASPERITIES)]
    return [*made, parse_case(FILM.format(**fields))]
