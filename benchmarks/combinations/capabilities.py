# SPDX-License-Identifier: GPL-3.0-or-later
"""Capabilities by name: each changes the description of a contact."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable

import numpy as np

import samcontact as sc

from .contact import LOAD, SIZE, SPEED, Contact, Law

Change = Callable[[Contact], None]
STEEL = sc.Material.linear_hardening(210e9, 0.3, 1e9, 20e9)
HARD = sc.Material.linear_hardening(400e9, 0.25, 3e9, 10e9)


def _yields(contact: Contact) -> None:
    if not contact.body2.is_plastic:
        contact.body2 = STEEL


def _kinematic(contact: Contact) -> None:
    _yields(contact)
    contact.body2 = contact.body2.with_kinematic_hardening(20e9)


def _softens(contact: Contact) -> None:
    _yields(contact)
    law = sc.softening.JohnsonCook(melting=1700.0, m=1.0, reference=293.15)
    contact.body2 = contact.body2.with_softening(law)
    contact.has_thermal_properties = True


def _graded(contact: Contact) -> None:
    _yields(contact)
    depths = [0.0, 1e-4, 3e-4]
    graded = contact.body2.with_yield_profile(depths, [1.4, 1.2, 1.0])
    contact.body2 = graded.with_residual_stress(depths, [-200e6, -100e6, 0.0])


def _ends(contact: Contact) -> None:
    contact.ends = True


def _relaxes(contact: Contact) -> None:
    contact.relaxes = True


def _both_yield(contact: Contact) -> None:
    contact.body1 = sc.Material.swift(210e9, 0.3, 700e6, 20.0, 0.1)


def _stiff_inclusion(contact: Contact) -> None:
    contact.inclusion = sc.Material.elastic(400e9, 0.25)


def _full_sliding(contact: Contact) -> None:
    if contact.law == 0.0:
        contact.law = 0.3


def _partial_slip(contact: Contact) -> None:
    contact.slips_partially()
    contact.pulls = 0.15


def _no_slip(contact: Contact) -> None:
    contact.law = sc.Coulomb(math.inf)
    contact.pulls = 0.1


def _with_law(law: Law) -> Change:
    def change(contact: Contact) -> None:
        contact.law = law
        contact.pulls = 0.1

    return change


def _slips_by_temperature(contact: Contact) -> None:
    contact.law = sc.ThermalCoulomb([0.0, 100.0], [0.3, 0.1])
    _heated_by_slip(contact)


def _shift(contact: Contact) -> None:
    contact.slips_partially()
    contact.drive["shift"] = (None if "tangential_load" in contact.drive else 0.0, 1e-6)


def _twist(contact: Contact) -> None:
    contact.slips_partially()
    contact.drive["twist"] = 1e-3


def _pull(contact: Contact) -> None:
    contact.slips_partially()
    if "shift" in contact.drive:
        contact.drive["shift"] = (None, contact.drive["shift"][1])
        contact.drive["tangential_load"] = (0.1 * LOAD, None)
    else:
        contact.drive["tangential_load"] = (0.1 * LOAD, 0.0)


def _heated(**heat: object) -> Change:
    def change(contact: Contact) -> None:
        contact.has_thermal_properties = True
        contact.heat |= {"factor": 0.05} | heat

    return change


def _heated_by_slip(contact: Contact) -> None:
    contact.has_thermal_properties = True
    contact.slips_partially()
    contact.heat |= {"partition": 0.5, "time": 2e-3}
    if contact.pulls is None and not contact.drive:
        contact.drive["shift"] = (2e-6, 0.0)


def _elastic_coating(contact: Contact) -> None:
    contact.coating = sc.Material.elastic(400e9, 0.25)


def _yielding_coating(contact: Contact) -> None:
    contact.coating = HARD
    _yields(contact)


def _periodic(directions: str) -> Change:
    def change(contact: Contact) -> None:
        contact.periodic = "".join(sorted({*contact.periodic, *directions}))

    return change


def _rolls(contact: Contact) -> None:
    contact.travels = (-SIZE, -SIZE)


def _slides(contact: Contact) -> None:
    contact.travels = (0.0, -SIZE)


def _rolls_across(contact: Contact) -> None:
    contact.travels = ((0.0, -SIZE), (0.0, -SIZE))


def _measured(contact: Contact) -> None:
    x = np.arange(-20, 21) * SIZE
    along, across = (np.cos(2 * np.pi * x / length) for length in (5e-4, 4e-4))
    contact.heights = 3e-7 * np.outer(along, across)


def _dented(contact: Contact) -> None:
    contact.settings["relief2"] = lambda grid: sc.dents.spherical(grid, 4e-7, 1.2e-4, x=6e-5)


def _particle(contact: Contact) -> None:
    _yields(contact)
    contact.is_dented = True


def _enlarged(contact: Contact) -> None:
    contact.is_enlarged = True


def _approach(contact: Contact) -> None:
    contact.prescribes_approach = True


def _adheres(contact: Contact) -> None:
    contact.settings["adhesion"] = sc.Adhesion.jkr(20.0)


def _moment(contact: Contact) -> None:
    contact.about["moment"] = (LOAD * SIZE, None)


def _tilt(contact: Contact) -> None:
    contact.about["tilt"] = (None, 4e-3) if "moment" in contact.about else (4e-3, None)


def _with_setting(name: str, value: object) -> Change:
    def change(contact: Contact) -> None:
        contact.settings[name] = value

    return change


def _lubricated(contact: Contact) -> None:
    contact.is_lubricated = True


VELOCITY = (-SPEED, 0.0)
CAPABILITIES: dict[str, Change] = {
    "plastic body": _yields,
    "kinematic hardening": _kinematic,
    "thermal softening": _softens,
    "two plastic bodies": _both_yield,
    "profiles of hardness and initial stress": _graded,
    "free face": _ends,
    "viscoelastic body": _relaxes,
    "elastic coating": _elastic_coating,
    "plastic coating and substrate": _yielding_coating,
    "inclusion": _stiff_inclusion,
    "full sliding": _full_sliding,
    "partial slip": _partial_slip,
    "no slip": _no_slip,
    "anisotropic friction": _with_law(sc.Anisotropic(0.3, 0.2, 0.5)),
    "friction that depends on the place": _with_law(
        sc.MappedCoulomb([0.2, 0.3], x=[-SIZE, SIZE], body=2)
    ),
    "friction that depends on the temperature": _slips_by_temperature,
    "friction that falls with the slip rate": _with_law(
        sc.FallingCoulomb(0.2, 0.1, 0.1, memory=1e-6)
    ),
    "layer of wear particles": _with_law(sc.ThirdBody(0.3, 1e9, 1e9, 1e-6)),
    "prescribed shift": _shift,
    "prescribed rotation": _twist,
    "tangential force": _pull,
    "steady heat": _heated(velocity=VELOCITY),
    "heat for a given time": _heated(time=2e-3),
    "heat history": _heated(history=(1e-4, 1.0)),
    "heat of slip": _heated_by_slip,
    "periodic along x": _periodic("x"),
    "periodic along y": _periodic("y"),
    "periodic in both directions": _periodic("xy"),
    "rolling": _rolls,
    "sliding": _slides,
    "motion along y": _rolls_across,
    "measured surface": _measured,
    "dent": _dented,
    "dent of a pressed particle": _particle,
    "enlarged grid": _enlarged,
    "prescribed approach": _approach,
    "adhesion": _adheres,
    "moment": _moment,
    "held tilt": _tilt,
    "automatic sub-increments": _with_setting("increment_tol", 0.01),
    'method "exact"': _with_setting("residual_stress", "exact"),
    "lubricant film": _lubricated,
}

ALTERNATIVES = (
    {"elastic coating", "plastic coating and substrate"},
    {
        "full sliding",
        "partial slip",
        "no slip",
        "anisotropic friction",
        "friction that depends on the place",
        "friction that depends on the temperature",
        "friction that falls with the slip rate",
        "layer of wear particles",
    },
    {
        "steady heat",
        "heat for a given time",
        "heat history",
        "heat of slip",
        "friction that depends on the temperature",
    },
    {"periodic along x", "periodic along y", "periodic in both directions"},
    {"rolling", "sliding", "motion along y"},
)
"""Capabilities of which a contact has only one."""
PAIRS = [
    (first, second)
    for first, second in itertools.combinations(CAPABILITIES, 2)
    if not any({first, second} <= group for group in ALTERNATIVES)
]


def contact_with(*names: str) -> Contact:
    """Return the description of a contact with some capabilities."""
    contact = Contact()
    for name in names:
        CAPABILITIES[name](contact)
    return contact
