# SPDX-License-Identifier: GPL-3.0-or-later
"""Fatigue results of a case with a section [fatigue]: table, file and figures."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import xarray as xr
from rich.console import Console

from .. import results
from .._util.display import quantity
from .._util.version import version
from .tables import Sheet

if TYPE_CHECKING:
    from ..cases import Case
    from ..fatigue import FatigueField
    from ..solutions.state import State


def write_fatigue(
    case: Case, states: list[State], directory: Path, console: Console, *, figures: bool
) -> list[Path]:
    """Print the maximum of each criterion, write fatigue.nc and figures, and return the files."""
    assert case.fatigue is not None
    body = case.output.body
    with console.status("fatigue"):
        fields = case.fatigue.fields(states, body)
    limits = {name: getattr(case.fatigue.limit, name) for name in case.fatigue.criteria}
    console.print(_sheet(fields, limits, body))
    dataset = xr.merge([field.to_dataset() for field in fields], combine_attrs="override")
    written = [directory / "fatigue.nc"]
    attributes = {"title": case.title, "body": body, "samcontact_version": version}
    results.save(dataset.assign_attrs(attributes), written[0])
    return written + (_figures(fields, limits, directory) if figures else [])


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
    fields: list[FatigueField], limits: dict[str, float | None], directory: Path
) -> list[Path]:
    """Draw depth profiles (one figure for each unit) and a section of the first criterion."""
    from ..plotting.fatigue import fatigue_depth, fatigue_section
    from ..plotting.parts import new_figure, save

    drawn = {}
    for unit, name in (("Pa", "fatigue_depth"), ("-", "fatigue_strain")):
        shown = [field for field in fields if field.unit == unit]
        if shown:
            drawn[name] = new_figure()
            limit = limits[shown[0].criterion] if len(shown) == 1 else None
            fatigue_depth(shown, drawn[name].subplots(), limit=limit)
    drawn["fatigue_section"] = new_figure()
    fatigue_section(fields[0], drawn["fatigue_section"].subplots())
    return [save(figure, directory / f"{name}.png") for name, figure in drawn.items()]
