# SPDX-License-Identifier: GPL-3.0-or-later
"""Quantities of wear by name, with unit, description and display."""

from __future__ import annotations

from .quantities import CONTACT, Q

WEAR = {
    "cycle": Q("1", "cycle number"),
    "body": Q("1", "number of the worn body"),
    "state": Q("1", "number of completed cycles"),
    "y": CONTACT["y"],
    # scalars of each cycle and body
    "volume": Q("m3", "volume of the removed material", "µm³", "removed volume", "removed\nvolume"),
    "lost_volume": Q("m3", "decrease of the volume below the surface"),
    "depth": Q("m", "maximum wear depth of the cycle", "µm", "wear depth", "wear\ndepth"),
    "surface_strain": Q(
        "1", "maximum plastic strain of the first layer before material is removed", "%",
        "plastic strain of the first layer",
    ),
    "max_equivalent_plastic_strain": Q(
        "1", "maximum equivalent plastic strain before material is removed", "%",
        "maximum plastic strain", "plastic\nstrain",
    ),
    "layers_across_plastic_zone": CONTACT["layers_across_plastic_zone"]._replace(
        long_name="thickness of the plastic zone before material is removed, in layers"
    ),
    "coating_worn_share": Q(
        "1", "maximum worn depth so far, relative to the thickness of the top layer", "%",
        "worn share of the top layer", "worn share of\ntop layer",
    ),
    # scalars of each cycle
    "parts": Q("1", "number of parts into which the repeats of the cycle were divided"),
    "friction_work": Q("J", "frictional work in the cycle", "J", "frictional work"),
    "slip_distance": Q(
        "m", "maximum sliding distance in one repeat", "µm", "maximum sliding distance per repeat",
        "sliding\ndistance",
    ),
    "plastic_flow": Q(
        "1", "maximum equivalent plastic strain added by the last computed loop", "%",
        "plastic strain per loop",
    ),
    "stick_area": Q(
        "m2", "contact area that sticks during a whole repeat", "µm²", "stick area",
        "stick\narea",
    ),
    "max_pressure": CONTACT["max_pressure"],
    "max_von_mises": CONTACT["max_von_mises"]._replace(
        long_name="maximum von Mises stress under load"
    ),
    "contact_area": CONTACT["contact_area"]._replace(
        long_name="contact area at maximum load", shown="µm²"
    ),
    "cells_across_contact": CONTACT["cells_across_contact"],
    "wear_rate": Q("m3", "worn volume per cycle", "µm³", "worn volume per cycle"),
    "worn_volume": Q("m3", "accumulated worn volume"),
    "x": Q("m", "x coordinate on body {body}"),
    "heights": Q("m", "height of body {body}, positive outwards", "µm", "height", kind="height"),
}  # fmt: skip
