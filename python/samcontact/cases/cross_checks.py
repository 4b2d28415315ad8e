# SPDX-License-Identifier: GPL-3.0-or-later
"""What a case gives must be used: a field without effect is a slip, and refused by its name."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from ..scene.heating import COLD
from .base import changed
from .sections import contact_law_of

if TYPE_CHECKING:
    from .bodies import BodySection


def require_all_used(case: Any) -> None:
    """Raise ValueError naming the first field of a `Case` that has no effect."""
    _require_accuracy(case)
    bodies = (("body1", case.body1), ("body2", case.body2))
    # a factor of 0 is a source that is off, on purpose
    if case.heat is None and all(segment.heat_factor is None for segment in case.path):
        require_cold(bodies, "give [heat] too")
    if case.wear is not None:
        require_no_layers(bodies, "[wear]")
    require_image_tol(case.contact)
    _require_zones(case)
    _require_law_of_friction(case)
    _require_law_of_contact(case)
    _require_cycle(case)
    _require_repeatable(case)
    given = changed(case.output, ("body", "volume"))
    if case.wear is not None:
        if changed(case, ["estimate_error"]):
            raise ValueError("estimate_error is not for a case with [wear]: leave it out")
        for name in sorted(given):
            raise ValueError(f"output.{name} is not for a case with [wear]: leave it out")
    if not case.has_volume and "volume" in given and case.output.volume != "none":
        raise ValueError(
            f"output.volume = {case.output.volume!r} needs a [grid] with dz: give it, or leave "
            "it out"
        )


def _require_cycle(case: Any) -> None:
    """What [fatigue] needs: stress, and moments."""
    if case.fatigue is None:
        return
    if case.wear is not None:
        raise ValueError("fatigue is not for a case with [wear]: leave one of them out")
    if not case.has_volume:
        raise ValueError("fatigue needs a [grid] with dz: give it, or leave it out")
    body = (case.body1, case.body2)[case.output.body - 1]
    judged = case.fatigue
    if judged.fatemi_socie is not None and judged.yield_stress is None and not body.is_plastic:
        raise ValueError(
            f"fatigue.yield_stress is needed: body{case.output.body} is elastic, and fatemi_socie "
            "divides by its yield stress"
        )
    if case.fatigue.passing is None and len(case.steps()) < 2:
        raise ValueError(
            "fatigue needs a path of at least 2 increments, which are its cycle; or give "
            'fatigue.passing = "x" where material passes through a steady contact'
        )


def _require_repeatable(case: Any) -> None:
    """What [shakedown] needs: a body that can yield, and a path that ends where it began."""
    if case.shakedown is None:
        return
    for name in ("wear", "accuracy"):
        if getattr(case, name) is not None:
            raise ValueError(f"shakedown is not for a case with {name}: leave one of them out")
    if not (case.body1.is_plastic or case.body2.is_plastic):
        raise ValueError("shakedown needs a body that can yield: give one, or leave it out")
    ways = [math.fsum(step.get("advance", (0.0, 0.0))[n] for step in case.steps()) for n in (0, 1)]
    if max(map(abs, ways)) > 1e-12:
        raise ValueError(
            f"shakedown needs a path that brings both bodies back, but they have moved on by "
            f"{tuple(ways)!r} m at its end: move them to and fro, or leave it out"
        )


def _require_law_of_friction(case: Any) -> None:
    """What drives along the surface, and wear by slip, go with bodies that stick and slip."""
    by_slip = case.wear is not None and case.wear.law != "threshold"
    if case.sticks:
        if case.wear is not None and not by_slip:
            raise ValueError(
                "wear.threshold is of gross sliding: give contact.friction as a number, or "
                "wear.energy in place of it"
            )
        return
    if case.wear is not None and by_slip:
        raise ValueError(
            f"wear.{case.wear.law} is for bodies that stick and slip: give [contact] friction = "
            "{coulomb = 0.3}, or wear.threshold in place of it"
        )
    for index, segment in enumerate(case.path):
        if segment.slips:
            raise ValueError(
                f"path[{index}]: {', '.join(segment.slips)} is for bodies that stick and slip: "
                "give [contact] friction = {coulomb = 0.3}, or leave it out"
            )


def _require_law_of_contact(case: Any) -> None:
    """Raise ValueError for tension without attraction, and for what attraction excludes."""
    law = contact_law_of(case.contact)
    if law.attracts:
        if case.wear is not None:
            raise ValueError(f"contact.contact_law must be hard with [wear], got {law!r}")
        law.require_possible(COLD if case.heat is None else case.heat.build(), {})
        if case.moves:
            raise ValueError(f"path must not move the bodies with contact.contact_law = {law!r}")
        return
    for index, segment in enumerate(case.path):
        if segment.load is not None and segment.load < 0:
            raise ValueError(
                f"path[{index}].load: must be a number >= 0 [N], got {segment.load!r}: bodies that "
                "do not attract each other bear no tension"
            )


def _require_accuracy(case: Any) -> None:
    """What is chosen must not be given, and what is of the choice must not be without it."""
    if case.accuracy is None:
        for name in sorted(changed(case, ("quantities", "max_memory", "max_time"))):
            raise ValueError(f"{name} is of accuracy: give that too, or leave it out")
        return
    if case.grid is not None:
        raise ValueError("grid is chosen where there is an accuracy: leave one of them out")
    if case.wear is not None:
        raise ValueError("wear needs a [grid]: accuracy is of one contact, leave it out")
    for index, segment in enumerate(case.path):
        if changed(segment, ("increments",)):
            raise ValueError(
                f"path[{index}].increments are chosen where there is an accuracy: leave them out"
            )


def require_no_layers(bodies: Iterable[tuple[str, BodySection]], section: str) -> None:
    """Raise ValueError for layers where a section has a use for homogeneous bodies only."""
    for name, body in bodies:
        if body.coating:
            raise ValueError(f"{name}.layers: {section} knows homogeneous bodies only")


def require_cold(bodies: Iterable[tuple[str, BodySection]], remedy: str) -> None:
    """Raise ValueError for thermal data of bodies without frictional heat."""
    for name, body in bodies:
        softening: Any = getattr(body, "softening", None)
        if getattr(body, "thermal", None) is not None:
            raise ValueError(f"{name}.thermal is of frictional heat: {remedy}")
        if softening is not None and softening.ambient <= softening.reference:
            raise ValueError(
                f"{name}.softening begins at reference = {softening.reference!r} K, and nothing is "
                f"warmer than ambient = {softening.ambient!r} K without frictional heat: {remedy}"
            )


def _require_zones(case: Any) -> None:
    bodies = case.body1, case.body2
    if any(b.coating and b.is_plastic for b in bodies) and changed(case.contact, ["zones"]):
        raise ValueError(
            "contact.zones is of homogeneous bodies: what yields in layers has one box, leave it "
            "out"
        )


def require_image_tol(contact: Any) -> None:
    """Raise ValueError for a tolerance that "exact" residual stress does not use."""
    if contact.residual_stress == "exact" and changed(contact, ["image_tol"]):
        raise ValueError('contact.image_tol is of residual_stress = "fast": leave it out')
