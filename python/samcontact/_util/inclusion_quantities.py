# SPDX-License-Identifier: GPL-3.0-or-later
"""Quantities of bodies with inclusions by name, with unit, description and display."""

from __future__ import annotations

from .quantity import Quantity as Q

INCLUSIONS = {
    "max_von_mises_matrix": Q("Pa", "maximum von Mises stress of cells without inclusions", "MPa",
                              "maximum von Mises stress of the matrix", "von Mises\nmatrix"),
    "max_equivalent_plastic_strain_matrix": Q(
        "1", "maximum equivalent plastic strain of cells without inclusions", "%",
        "maximum equivalent plastic strain of the matrix", "plastic strain\nmatrix", 4),
    "max_interface_tension": Q(
        "Pa", "maximum normal stress at the interfaces of inclusions, positive in tension", "MPa",
        "maximum tension at inclusions", "tension at\ninclusions"),
    "max_interface_von_mises": Q(
        "Pa", "maximum von Mises stress of the matrix at the interfaces of inclusions", "MPa",
        "maximum von Mises stress at inclusions", "von Mises at\ninclusions"),
    "inclusion_center": Q("m", "coordinates x, y, z of the centres of the inclusions"),
    "inclusion_radii": Q("m", "principal radii of the inclusions"),
    "inclusion_axes": Q("1", "directions of the principal radii of the inclusions"),
    "inclusion_E": Q("Pa", "Young's modulus of the inclusions; 0 for a void"),
}  # fmt: skip
