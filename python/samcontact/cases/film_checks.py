# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of film cases: bodies, heat, plastic flow and motion must be compatible."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..bodies.hardening_laws import LAWS
from .base import changed

if TYPE_CHECKING:
    from .film_description import FilmDescription

_UNUSED = ("softening", "relaxation", "free_faces", "inclusions", "random_inclusions")
"""Sections of a body that have no effect on a film."""
_OF_YIELD = ("hardness", "residual_stress")
"""Sections of a body that have an effect on elastic-plastic bodies only."""
_NOT_WITH_YIELD = {
    "speeds": "such a film is solved at one speed",
    "spin": "", "supply": "", "approach": "prescribe the load", "transient": "",
    "tol": "sc.lubrication.press_loads chooses the tolerance of film and plastic flow",
}  # fmt: skip
_NOT_IN_TIME = {
    "speeds": "prescribe film.transient.speed_factors", "approach": "prescribe the load",
    "thermal": "the surface temperatures are computed for steady heating only",
}  # fmt: skip


def require_possible(case: FilmDescription) -> None:
    """Raise ValueError for fields of a case that have no effect or contradict each other."""
    if all(body.is_rigid for body in (case.body1, case.body2)):
        raise ValueError("body1 and body2 are both rigid: at least one must be deformable")
    _require_used_bodies(case)
    _require_constants(case)
    if case.yields:
        law = next(iter([*case.body2.inelastic_laws, *case.body1.inelastic_laws]))
        _refuse(case, _NOT_WITH_YIELD, f"an elastic-plastic body (law {law!r})")
    else:
        for name in sorted(changed(case.film, ["increments"])):
            raise ValueError(f"film.{name} has no effect without an elastic-plastic body: omit it")
        for name in sorted(changed(case.grid, ["nz", "dz"])):
            raise ValueError(f"grid.{name} has no effect without an elastic-plastic body: omit it")
    _require_motion(case)


def _require_used_bodies(case: FilmDescription) -> None:
    """Raise ValueError for sections of body 1 or 2 that have no effect on a film."""
    for name, body in (("body1", case.body1), ("body2", case.body2)):
        for part in body.parts:
            yields = LAWS[part.law].yields
            for field in (*_UNUSED, *(() if yields else _OF_YIELD)):
                if getattr(part, field, None) is not None:
                    raise ValueError(f"{name}.{field} has no effect on a film: omit it")
            if getattr(part, "thermal", None) is not None and not case.film.thermal:
                raise ValueError(
                    f"{name}.thermal has no effect unless the film is heated: omit it, or add "
                    "film.thermal = true"
                )


def _require_constants(case: FilmDescription) -> None:
    """Raise ValueError if only one of lubricant.thermal and film.thermal is given."""
    if case.film.thermal and case.lubricant.thermal is None:
        raise ValueError(
            "film.thermal requires lubricant.thermal: add thermal = {conductivity = 0.14, "
            "capacity = 1.7e6} to [lubricant], with the values of the oil"
        )
    if case.lubricant.thermal is not None and not case.film.thermal:
        raise ValueError(
            "lubricant.thermal has no effect unless the film is heated: omit it, or add "
            "film.thermal = true"
        )


def _refuse(case: FilmDescription, fields: dict[str, str], what: str) -> None:
    for name in changed(case.film, fields):
        reason = f": {fields[name]}" if fields[name] else ""
        raise ValueError(f"film.{name} cannot be combined with {what}{reason}; omit film.{name}")


def _require_motion(case: FilmDescription) -> None:
    """Raise ValueError for a relief or [film.transient] that is not supported or has no effect."""
    course, velocities = case.film.transient, case.velocities
    reliefs = [name for name in ("relief1", "relief2") if getattr(case, name) is not None]
    for name in reliefs:
        u, v = velocities[int(name[-1]) - 1]
        if v != 0.0:
            raise ValueError(
                f"film: the velocity of body {name[-1]} along y must be 0 with [{name}], got "
                f"{v:g} m/s: omit the relief, or move along x"
            )
        if course is None and u != 0.0:
            raise ValueError(
                f"{name} moves with body {name[-1]} at {u:g} m/s: add film.transient with its "
                "duration, or set the velocity of this body to 0"
            )
    if course is None:
        return
    _refuse(case, _NOT_IN_TIME, "film.transient")
    if not reliefs and course.times is None:
        raise ValueError(
            "film.transient has no effect without relief1, relief2, load_factors or "
            "speed_factors: add one of them, or omit film.transient"
        )
    if case.film.spin and course.speed_factors is not None:
        raise ValueError("film.spin cannot be combined with film.transient.speed_factors: omit one")
    if course.steps is None and not any(map(any, velocities)):
        raise ValueError("film.transient.steps is required if the surfaces do not move: add it")
