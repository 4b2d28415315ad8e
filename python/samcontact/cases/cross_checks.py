# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of a case: each field must have an effect, and no two fields may contradict each other."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from .._util.travels import along_x, both_axes
from ..problem.friction import has_history
from ..problem.grid import within_period
from ..problem.heating import NO_HEAT
from .base import changed
from .heat_checks import require_motion_of_heat, require_steps_of_cells
from .sections import contact_law_of

if TYPE_CHECKING:
    from .bodies import BodySection
    from .motion import Segment


def require_all_used(case: Any) -> None:
    """Raise ValueError for the first field that has no effect or contradicts another field."""
    _require_accuracy(case)
    bodies = (("body1", case.body1), ("body2", case.body2))
    # [[path]] heat_factor: 0 switches the heat source off on purpose
    if case.heat is None and all(segment.heat_factor is None for segment in case.path):
        require_cold(bodies, "omit it, or add [heat]")
    require_image_tol(case.contact)
    _require_zones(case)
    _require_law_of_friction(case)
    _require_law_of_contact(case)
    _require_cycle(case)
    _require_hardness(case)
    _require_repeatable(case)
    require_motion_of_heat(case)
    _require_free_along_y(case)
    _require_known_faces(case)
    _require_dentable(case)
    _require_inclusions_in_volume(case)
    given = changed(case.output, ("body", "volume"))
    if case.wear is not None:
        if changed(case, ["estimate_error"]):
            raise ValueError("estimate_error cannot be combined with [wear]: omit one of them")
        for name in sorted(given):
            raise ValueError(f"output.{name} cannot be combined with [wear]: omit one of them")
    if not case.has_volume and "volume" in given and case.output.volume != "none":
        raise ValueError(
            f"output.volume = {case.output.volume!r} requires grid.dz: set grid.dz, or omit "
            "output.volume"
        )


def _require_inclusions_in_volume(case: Any) -> None:
    """Raise ValueError for inclusions with [wear], [dents] or `accuracy`, or without grid.dz."""
    for name, body in (("body1", case.body1), ("body2", case.body2)):
        if not body.has_inclusions:
            continue
        field = f"{name}.{'inclusions' if body.inclusions is not None else 'random_inclusions'}"
        for other in ("wear", "dents"):
            if getattr(case, other) is not None:
                raise ValueError(f"{field} cannot be combined with {other}: omit one of them")
        if case.accuracy is not None:
            raise ValueError(
                f"{field} cannot be combined with accuracy: omit accuracy, and add [grid] with "
                "cells of an eighth to a quarter of the smallest inclusion radius"
            )
        if not case.has_volume:
            raise ValueError(f"{field} requires layers of cells below the surface: set grid.dz")


def path_with_loads(case: Any) -> list[Segment]:
    """Return the path of a `Case`, with all loads in newtons instead of `load_factor`."""
    grid = None if case.grid is None else case.grid.build()
    path = []
    for index, segment in enumerate(case.path):
        try:
            path.append(segment.with_load(case.surface.nominal_load(grid)))
        except ValueError as error:
            raise ValueError(f"path[{index}]: {error}") from error
    return path


def _require_cycle(case: Any) -> None:
    """Raise ValueError if the path does not provide the stress cycle that [fatigue] requires."""
    if case.fatigue is None:
        return
    if case.wear is not None:
        raise ValueError("fatigue cannot be combined with [wear]: omit one of them")
    if not case.has_volume:
        raise ValueError("fatigue requires grid.dz: set grid.dz, or omit [fatigue]")
    body = (case.body1, case.body2)[case.output.body - 1]
    judged = case.fatigue
    if judged.fatemi_socie is not None and judged.yield_stress is None and not body.is_plastic:
        raise ValueError(
            f"fatigue.yield_stress is required because body{case.output.body} is elastic and "
            "fatemi_socie divides by the yield stress: add yield_stress, or omit fatemi_socie"
        )
    if case.fatigue.steady_axis is None and len(case.steps()) < 2:
        raise ValueError(
            "fatigue requires a path of at least 2 increments, which form one cycle: add "
            'increments, or set fatigue.steady_axis = "x" for material that passes through a '
            "steady contact"
        )


def _require_hardness(case: Any) -> None:
    """Raise ValueError if a hardness has no effect, or is missing for [fatigue.exposure]."""
    judged = None if case.fatigue is None else case.fatigue.exposure
    if judged is not None and (case.body1, case.body2)[case.output.body - 1].profile is None:
        raise ValueError(
            f"fatigue.exposure requires the hardness of body{case.output.body}: add "
            f"[body{case.output.body}.hardness]"
        )
    bodies = (("body1", case.body1), ("body2", case.body2))
    require_hardness_used(bodies, None if judged is None else bodies[case.output.body - 1][1])


def require_hardness_used(
    bodies: Iterable[tuple[str, BodySection]], judged: BodySection | None = None
) -> None:
    """Raise ValueError if an elastic material, except that of section `judged`, has a hardness."""
    for name, body in bodies:
        for part in body.parts:
            if part.profile is not None and part.law == "elastic" and part is not judged:
                raise ValueError(
                    f"{name}: hardness has no effect on an elastic body: choose a hardening law, "
                    "omit hardness, or add [fatigue.exposure]"
                )


def require_durations(case: Any) -> None:
    """Raise ValueError if a segment of the path lacks a required duration or has an unused one."""
    relaxes = case.body1.relaxes or case.body2.relaxes
    heated = case.heat is not None and case.heat.is_timed
    timed = relaxes or heated or case.friction.needs_duration
    for index, segment in enumerate(case.path):
        name = segment.time_field
        causes = "heat.history, heat.partition, falling_coulomb friction or a body with relaxation"
        if timed and not segment.is_timed:
            raise ValueError(f"path[{index}]: {name} is required with {causes}: add {name}")
        if segment.is_timed and not timed:
            raise ValueError(f"path[{index}]: {name} has no effect without {causes}: omit {name}")


def _require_repeatable(case: Any) -> None:
    """Raise ValueError if [shakedown] lacks an elastic-plastic body or a closed path."""
    if case.shakedown is None:
        return
    if case.wear is not None:
        raise ValueError("shakedown cannot be combined with wear: omit one of them")
    _require_fixed_path(case, "shakedown", "may differ between cycles")
    if case.accuracy is not None and case.fatigue is not None:
        raise ValueError(
            "fatigue cannot be combined with both shakedown and accuracy, because these two store "
            "only the state after the last cycle: omit one of the three"
        )
    if not (case.body1.is_plastic or case.body2.is_plastic):
        raise ValueError(
            "shakedown requires an elastic-plastic body: set a hardening law in [body1] or "
            "[body2], or remove [shakedown]"
        )
    motions = [along_x(step.get("advance", (0.0, 0.0)), "with shakedown") for step in case.steps()]
    travels = [math.fsum(motion[n] for motion in motions) for n in (0, 1)]
    if case.grid is not None:
        grid = case.grid.build()
        travels = [within_period(grid, travel) for travel in travels]
    if max(map(abs, travels)) > 1e-12:
        raise ValueError(
            "shakedown requires a closed path, but over this path bodies 1 and 2 move in total by "
            f"{tuple(travels)!r} m along x: add motion that returns both bodies, or remove "
            "[shakedown]"
        )


def _require_free_along_y(case: Any) -> None:
    """Raise ValueError for motion along y if a body has free faces or a relief."""
    moved = (both_axes(step["advance"]) for step in case.steps() if "advance" in step)
    if not any(travels[:, 1].any() for travels in moved):
        return
    for number in (1, 2):
        if getattr(getattr(case, f"body{number}"), "free_faces", None) is not None:
            raise ValueError(f"with body{number}.free_faces, advance along y must be 0: omit one")
        if getattr(case, f"relief{number}") is not None:
            raise ValueError(f"with [relief{number}], advance along y must be 0: omit one")
    if case.grid is not None and has_history(case.friction, (case.body1, case.body2)):
        require_steps_of_cells(case, 1)


def _require_known_faces(case: Any) -> None:
    """Raise ValueError for [wear], `accuracy` or stress fields if a body has free faces."""
    for number, body in enumerate((case.body1, case.body2), 1):
        if getattr(body, "free_faces", None) is None:
            continue
        name = f"body{number}"
        for section in ("wear", "accuracy"):
            if getattr(case, section) is not None:
                raise ValueError(f"{section} cannot be combined with {name}.free_faces: omit one")
        if case.has_volume and case.output.body == number and case.output.volume != "none":
            raise ValueError(
                f"{name}.free_faces: stresses near a free face cannot be computed: omit grid.dz, "
                'set output.volume = "none", or select the other body with output.body'
            )


def _require_dentable(case: Any) -> None:
    """Raise ValueError for [dents] in an elastic body 2, with [wear], or on a periodic grid."""
    if case.dents is None:
        return
    if not case.body2.is_plastic:
        raise ValueError(
            "dents requires an elastic-plastic body2, because an elastic body keeps no dent: set "
            "a hardening law in [body2], or describe the dent by [relief2]"
        )
    if case.wear is not None:
        raise ValueError("dents cannot be combined with [wear]: omit one of them")
    if case.grid is not None and case.grid.periodic:
        raise ValueError("dents cannot be combined with grid.periodic: omit one of them")


def _require_law_of_friction(case: Any) -> None:
    """Raise ValueError if wear, motions or forces require partial slip but friction excludes it."""
    if case.sticks:
        return
    if case.wear is not None and case.wear.law != "threshold":
        raise ValueError(
            f"wear.{case.wear.law} requires Coulomb friction: set [contact] friction = "
            "{coulomb = 0.3}, or use wear.threshold instead"
        )
    for index, segment in enumerate(case.path):
        if segment.slips:
            names = ", ".join(segment.slips)
            raise ValueError(
                f"path[{index}]: {names} requires Coulomb friction: set [contact] friction = "
                f"{{coulomb = 0.3}}, or omit {names}"
            )


def _require_fixed_path(case: Any, section: str, reason: str) -> None:
    """Raise ValueError for a pull-off, whose number of increments depends on the solution."""
    for index, segment in enumerate(case.path):
        if segment.pull_off is not None:
            raise ValueError(
                f"path[{index}].pull_off cannot be combined with {section}, because the number of "
                f"increments of a pull-off {reason}: prescribe approach instead"
            )


def _require_no_passes(case: Any) -> None:
    """Raise ValueError for rolling or sliding passes of bodies that adhere at zero load."""
    for index, segment in enumerate(case.path):
        if segment.passes is not None:
            kind = "roll" if segment.roll is not None else "slide"
            raise ValueError(
                f"path[{index}]: {kind} cannot be combined with contact.adhesion, because adhering "
                "bodies do not separate at zero load: use advance"
            )


def _require_law_of_contact(case: Any) -> None:
    """Raise ValueError for a tensile load without adhesion, or fields not allowed with adhesion."""
    law = contact_law_of(case.contact)
    for index, segment in enumerate(case.path):
        if segment.pull_off is not None and not law.varies:
            raise ValueError(
                f"path[{index}].pull_off requires a law of adhesion: set [contact] adhesion, e.g. "
                'adhesion = {kind = "exponential", work = "50 mJ/m^2", range = "2 nm"}'
            )
    if law.attracts:
        if case.wear is not None:
            raise ValueError(f'contact.adhesion must be "hard" with [wear], got {law!r}')
        law.require_possible(NO_HEAT if case.heat is None else case.heat.build(), {})
        if case.moves and not law.may_move(case.sticks):
            raise ValueError(
                f"path: bodies must not roll or slide if contact.adhesion = {law!r}"
                f"{', with partial slip' if case.sticks else ''}: remove the motion, or use "
                'adhesion = "hard"'
            )
        _require_no_passes(case)
        return
    for index, segment in enumerate(case.path):
        if segment.load is not None and segment.load < 0:
            raise ValueError(
                f"path[{index}].load: must be a number >= 0 [N], got {segment.load!r}: without "
                "adhesion the contact transmits no tension"
            )


def _require_accuracy(case: Any) -> None:
    """Raise ValueError for fields that are allowed only with `accuracy`, or only without it."""
    if case.accuracy is None:
        for name in sorted(changed(case, ("quantities", "max_memory", "max_time"))):
            raise ValueError(f"{name} has no effect without accuracy: add accuracy, or omit {name}")
        return
    law = contact_law_of(case.contact)
    if law.is_of_grid:
        raise ValueError(
            f"with accuracy, contact.adhesion.range must be given, got {law!r}: the default range "
            "changes with the grid"
        )
    if case.grid is not None and not reason_for_grid(case):
        raise ValueError("grid cannot be combined with accuracy: omit one of them")
    _require_fixed_path(case, "accuracy", "differs between grids")
    for index, segment in enumerate(case.path):
        if changed(segment, ("increments",)):
            raise ValueError(f"path[{index}].increments cannot be combined with accuracy: omit one")


def reason_for_grid(case: Any) -> str:
    """Return the reason why `accuracy` requires [grid] in a case; "" if it does not."""
    if case.grid is not None and case.grid.periodic:
        return "grid.periodic prescribes the period"
    if case.wear is not None:
        return "wear changes the size of the contact"
    if contact_law_of(case.contact).attracts:
        return "attraction extends beyond the contact"
    if any(segment.tilting for segment in case.path):
        return "moments and tilts move the contact"
    if not case.surface.is_known:
        return "the surface is given by heights at sample points"
    for name in ("relief1", "relief2"):
        relief = getattr(case, name)
        if relief is not None and not relief.is_known:
            return f"{name} is given by heights at sample points"
    reason: str = case.surface.reason_for_grid
    return reason


def require_no_layers(bodies: Iterable[tuple[str, BodySection]], section: str) -> None:
    """Raise ValueError if a body has layers but `section` supports homogeneous bodies only."""
    for name, body in bodies:
        if body.coating:
            raise ValueError(
                f"{name}.layers: {section} does not support layered bodies: "
                f"remove the layers, or remove {section}"
            )


def require_cold(bodies: Iterable[tuple[str, BodySection]], remedy: str) -> None:
    """Raise ValueError for thermal constants or softening that have no effect without heat."""
    named = [(name + at, part) for name, body in bodies for at, part in body.sections.items()]
    for name, part in named:
        softening: Any = getattr(part, "softening", None)
        if getattr(part, "thermal", None) is not None:
            raise ValueError(f"{name}.thermal has no effect without [heat]: {remedy}")
        if softening is not None and softening.ambient <= softening.reference:
            raise ValueError(
                f"{name}.softening has no effect without [heat] unless ambient (now "
                f"{softening.ambient!r} K) is above reference ({softening.reference!r} K): {remedy}"
            )


def _require_zones(case: Any) -> None:
    bodies = case.body1, case.body2
    layered = any(b.coating and (b.is_plastic or b.has_inclusions) for b in bodies)
    if layered and changed(case.contact, ["zones"]):
        raise ValueError(
            "contact.zones has no effect on layered bodies with plastic flow or inclusions, whose "
            "plastic strain lies in a single subdomain: omit zones"
        )


def require_image_tol(contact: Any) -> None:
    """Raise ValueError if image_tol is given although residual_stress = "exact" ignores it."""
    if contact.residual_stress == "exact" and changed(contact, ["image_tol"]):
        raise ValueError('contact.image_tol has effect with residual_stress = "fast" only: omit it')
