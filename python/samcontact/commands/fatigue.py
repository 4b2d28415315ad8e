# SPDX-License-Identifier: GPL-3.0-or-later
"""Fatigue results of a case with a section [fatigue]: table, file and figures."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import xarray as xr

from .. import results
from .._util.display import quantity
from .._util.version import version
from .tables import Sheet

if TYPE_CHECKING:
    from ..cases import Case
    from ..fatigue import Exposure, FatigueField, Life
    from ..solutions.state import State
    from .tables import Printer


def write_fatigue(
    case: Case, states: list[State], directory: Path, console: Printer, *, figures: bool
) -> list[Path]:
    """Print the maximum of each criterion, write fatigue.nc and figures, and return their paths."""
    assert case.fatigue is not None
    body = case.output.body
    with console.status("fatigue"):
        fields = case.fatigue.fields(states, body)
        profile = (case.body1, case.body2)[body - 1].profile
        exposed = case.fatigue.exposed(states, body, profile)
        life = case.fatigue.life_of(fields)
    limits = {name: getattr(case.fatigue.limit, name) for name in case.fatigue.criteria}
    if fields:
        console.print(_sheet(fields, limits, body))
    parts = [field.to_dataset() for field in fields]
    for field, part in zip(fields, parts, strict=True):
        if (limit := limits[field.criterion]) is not None:
            part[field.criterion].attrs["limit"] = limit
    attributes = {"title": case.title, "body": body, "samcontact_version": version}
    if exposed is not None:
        console.print(_exposure_sheet(exposed, body))
        parts.append(exposed.to_dataset())
        attributes |= parts[-1].attrs
    if life is not None:
        console.print(f"Life ({life.model}): {_life_text(life)}")
        attributes |= {f"life_{name}": value for name, value in life_values(life).items()}
    dataset = xr.merge(parts, combine_attrs="override")
    written = [directory / "fatigue.nc"]
    results.save(dataset.assign_attrs(attributes), written[0])
    return written + (_figures(fields, limits, exposed, directory) if figures else [])


def life_values(life: Life) -> dict[str, float]:
    """Return the two numbers by which lives are compared: life integral and Weibull slope."""
    return {"log_integral": life.log_integral, "weibull": life.constants["weibull"]}


def _life_text(life: Life) -> str:
    return (
        f"logarithm of the integral {life.log_integral:.6g}, Weibull slope "
        f"{life.constants['weibull']:.4g}; ratio of this life to the life of a reference: "
        "exp((logarithm of the reference - this logarithm)/slope)"
    )


def _exposure_sheet(exposed: Exposure, body: int) -> Sheet:
    names = list(exposed.values)
    governs = ["governs" if name == exposed.criterion else "" for name in names]
    sheet = Sheet(f"Exposure of body {body} over depth: stress / local strength")
    sheet.add("criterion", [name.replace("_", " ") for name in names])
    sheet.add("maximum", [f"{exposed.max_value(name):.4g}" for name in names])
    sheet.add("depth\n[µm]", [f"{exposed.depth(name) * 1e6:.4g}" for name in names])
    sheet.add("", governs)
    return sheet


def _sheet(fields: list[FatigueField], limits: dict[str, float | None], body: int) -> Sheet:
    sheet = Sheet(f"Fatigue of body {body} over {fields[0].moments} instants")
    sheet.add("criterion", [field.name for field in fields])
    sheet.add("maximum", [_text(field, field.max_value) for field in fields])
    for axis in fields[0].coordinates:
        sheet.add(f"{axis}\n[µm]", [f"{field.position[axis] * 1e6 + 0.0:.4g}" for field in fields])
    bounds = [(field, limits[field.criterion]) for field in fields]
    if any(bound is not None for _, bound in bounds):
        sheet.add("limit", ["-" if b is None else _text(field, b) for field, b in bounds])
        sheet.add(
            "margin\n[%]",
            ["-" if b is None else f"{100 * field.margin(b):.1f}" for field, b in bounds],
        )
    return sheet


def _text(field: FatigueField, value: float) -> str:
    return quantity(value, "" if field.unit == "-" else field.unit)


def _figures(
    fields: list[FatigueField],
    limits: dict[str, float | None],
    exposed: Exposure | None,
    directory: Path,
) -> list[Path]:
    """Draw the fatigue figures, and return their paths.

    These are depth profiles (one figure for stress criteria, one for strain criteria), a section of
    the first criterion, and the exposure over depth.
    """
    from ..plotting.fatigue import exposure_depth, fatigue_depth, fatigue_section
    from ..plotting.parts import new_figure, save

    drawn = {}
    for unit, name in (("Pa", "fatigue_depth"), ("-", "fatigue_strain")):
        shown = [field for field in fields if field.unit == unit]
        if shown:
            drawn[name] = new_figure()
            limit = limits[shown[0].criterion] if len(shown) == 1 else None
            fatigue_depth(shown, drawn[name].subplots(), limit=limit)
    if fields:
        drawn["fatigue_section"] = new_figure()
        fatigue_section(fields[0], drawn["fatigue_section"].subplots())
    if exposed is not None:
        drawn["fatigue_exposure"] = new_figure()
        exposure_depth(exposed, drawn["fatigue_exposure"].subplots())
    return [save(figure, directory / f"{name}.png") for name, figure in drawn.items()]
