# SPDX-License-Identifier: GPL-3.0-or-later
"""Load search for a bearing: cases of both races, load on the bearing, static rating by ISO 76."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from .._util.display import percent, quantity, rows_of
from ..bearings.bearing import RACES

if TYPE_CHECKING:
    from ..accuracy.load_search import FoundLoad
    from ..cases import Case

_IN_DIAMETERS = re.compile(r"(.*[\d.])\s*D\s*")


def cases_by_race(case: Case) -> dict[str, Case]:
    """Return the cases that a load search must solve, by name of the race.

    For a bearing whose `race` is not given, these are the cases of both races. Any other case is
    returned under the name "".
    """
    from ..cases.part_grid import grid_of_part

    surface: Any = case.surface
    if surface.shape != "bearing" or surface.race is not None:
        return {"": case}
    found = {}
    for race in RACES:
        changed = case.model_copy(update={"surface": surface.model_copy(update={"race": race})})
        if "grid" not in case.model_fields_set and case.accuracy is None:
            changed = changed.model_copy(update={"grid": grid_of_part(changed)})
        found[race] = changed
    return found


def unit_of(name: str) -> str:
    """Return the SI unit of a target quantity of a load search, "1" for a pure number."""
    from .._util.quantities import CONTACT
    from ..accuracy.load_search_cases import PERMANENT_DEFORMATION

    kind = name.strip().partition("_body")[0]
    return CONTACT[kind].unit if kind in CONTACT else "m" if kind == PERMANENT_DEFORMATION else "1"


def diameter_of(target: str, case: Case) -> float | None:
    """Return the diameter D of the rolling element [m] if the value in `target` has the unit D.

    An example of such a target is "permanent_deformation=1e-4 D"; for any other, return None.
    """
    match = _IN_DIAMETERS.fullmatch(target)
    if match is None:
        return None
    surface: Any = case.surface
    if surface.shape not in ("bearing", "roller"):
        raise ValueError(
            "QUANTITY=VALUE: the unit D (diameter of the rolling element) requires [bearing] or "
            "[roller] in the case: use a unit of length, e.g. um"
        )
    name = match[1].partition("=")[0]
    if unit_of(name) != "m":
        raise ValueError(
            "QUANTITY=VALUE: the unit D (diameter of the rolling element) applies to lengths only, "
            f"e.g. permanent_deformation, got {name}: use a unit of {name}"
        )
    bearing = getattr(surface, "bearing", None)
    return float(surface.diameter if bearing is None else bearing.element_diameter)


def in_metres(target: str, case: Case) -> str:
    """Return a target with its value converted from D to metres; return other targets unchanged."""
    diameter = diameter_of(target, case)
    if diameter is None:
        return target
    name, _, value = target.strip().removesuffix("D").partition("=")
    return f"{name}={float(value) * diameter!r}"


def largest_contact_load(case: Case, largest_load: float | None) -> float | None:
    """Return the contact load [N] that corresponds to `largest_load`, the upper limit of a search.

    For a bearing, `largest_load` is the radial load on the bearing or, without a radial load, the
    axial load [N]. It is converted to the load of the most heavily loaded element. For any other
    case, `largest_load` is the contact load.
    """
    surface: Any = case.surface
    if largest_load is None or surface.shape != "bearing" or not largest_load > 0.0:
        return largest_load
    radial, axial, moment = surface.loads
    factor = largest_load / (radial or axial)
    turned = None if moment is None else factor * moment
    return float(surface.bearing.max_element_load(factor * radial, factor * axial, turned))


def load_on_bearing(case: Case, found: FoundLoad) -> float:
    """Return the radial load on the bearing [N] that causes the contact load `found.load`.

    Without a radial load, return the axial load.
    """
    surface: Any = case.surface
    radial, axial, _ = surface.loads
    return float(surface.bearing.load_factor(found.load, *surface.loads) * (radial or axial))


def table(
    founds: Mapping[str, FoundLoad], cases: Mapping[str, Case], diameter: float | None = None
) -> dict[str, dict[str, str]]:
    """Return the columns of the results table by heading; each column holds cells by row label.

    founds: result of the search for each race. cases: case of each race. diameter: diameter of the
    rolling element [m], shown if the target was given in this unit.
    """
    columns = {}
    for race, found in founds.items():
        case = cases[race]
        rows = dict(rows_of(found))
        surface: Any = case.surface
        if surface.shape == "bearing":
            rows = {"contact load" if label == "load" else label: v for label, v in rows.items()}
            rows |= _rows_of_bearing(case, found)
        if diameter is not None:
            rows["D, diameter of the rolling element"] = quantity(diameter, "m", 6)
        columns[f"{race or getattr(surface, 'race', None) or 'result'}"] = rows
    return columns


def _rows_of_bearing(case: Case, found: FoundLoad) -> dict[str, str]:
    """Return the table rows of a bearing: its loads, static load rating C0, safety factor s0."""
    surface: Any = case.surface
    factor = surface.bearing.load_factor(found.load, *surface.loads)
    radial, axial = (factor * load for load in surface.loads[:2])
    error = percent(found.load_error / found.load)
    rows = {}
    for name, load in (("radial load", radial), ("axial load", axial)):
        if load > 0.0:
            rows[f"{name} on the bearing"] = f"{quantity(load, 'N', 4)} ± {error}"
    if surface.moment:
        rows["moment on the bearing"] = quantity(factor * surface.moment, "N m", 4)
    rows["static load rating C0 (ISO 76)"] = quantity(surface.bearing.static_load_rating, "N", 4)
    rows["s0 at this load"] = f"{surface.bearing.static_safety(radial, axial):.3g}"
    return rows
