# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of a report: parameters of the case, values of each increment, comparison with Hertz."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from .._util.checks import FloatArray
from .._util.display import counts, lengths, quantity
from .._util.quantities import CONTACT, Quantity
from ..accuracy.error_rows import error_rows
from ..accuracy.grid_errors import increments_note
from ..bodies.depth_profiles import PROFILE_ARGUMENTS
from ..cases.field_units import field_unit
from ..paths.ramps import start_unit
from ..problem.friction import law_of_attributes
from ..results.against_hertz import hertz_rows
from ..results.slipping import balance_of, moved_along

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

if TYPE_CHECKING:
    import xarray as xr

    from ..energy import EnergyBalance
    from ..plotting.contact import HertzContact

# Units that take a prefix; others are written as they are.
_PREFIXED_UNITS = ("m", "Pa", "N", "s", "m/s")
_MAX_LISTED_VALUES = 8
"""Maximum number of values of a list that is shown in full."""


_ROUNDING_ERROR = 1e-13  # relative to the maximum of a column


class Row(NamedTuple):
    """Parameter of a case: section, field name, and value with unit."""

    section: str
    name: str
    value: str


class Cell(NamedTuple):
    """Cell of a table: number as displayed, and number with all digits in SI units."""

    shown: str
    exact: str


class Table(NamedTuple):
    """Table with column headings; each row has a label (number or name) and cells."""

    headings: list[str]
    rows: list[tuple[str, list[Cell]]]
    first: str = "increment"
    """Heading of the first column."""
    note: str = ""


def parameters(dataset: xr.Dataset) -> list[Row]:
    """Return the parameters of the stored case or, without a case, the attributes of the run."""
    text = dataset.attrs.get("case", "")
    if not text:
        return _from_attributes(dataset)
    content = tomllib.loads(text)
    rows = _grid_rows(dataset) if "accuracy" in content else []  # the chosen grid
    for section, fields in content.items():
        if section == "output" or not isinstance(
            fields, (dict, list)
        ):  # not a section of parameters
            continue
        if isinstance(fields, dict):
            rows += _rows(section, fields)
        elif isinstance(fields[0], dict):
            for number, ramp in enumerate(fields, 1):
                rows += _rows(f"{section}, part {number}", ramp)
        else:
            rows.append(Row("case", section, _value(fields, "")))
    return rows


def _rows(section: str, fields: dict[str, Any]) -> list[Row]:
    top = section.partition(",")[0]
    plain, nested = [], []
    for name, value in fields.items():
        parts = value if isinstance(value, list) else [value]
        if not isinstance(parts[0], dict):
            is_start = top == "path" and name == "start"
            unit = start_unit(fields) if is_start else field_unit(f"{top}.{name}")
            plain.append(Row(section, name, _value(value, unit)))
            continue
        for number, part in enumerate(parts, 1):
            of = f"{name}, part {number}" if parts is value else name
            nested += _rows(f"{section}, {of}", part)
    return [*plain, *nested]


def _value(value: Any, unit: str) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, list) and len(value) > _MAX_LISTED_VALUES:
        first, last = (_value(end, unit) for end in (value[0], value[-1]))
        return f"{len(value)} values, from {first} to {last}"
    if isinstance(value, list):
        return ", ".join(_value(entry, unit) for entry in value)
    if not isinstance(value, (int, float)):
        return str(value)
    if unit in _PREFIXED_UNITS:
        return quantity(value, unit, digits=6)
    return f"{value:.6g} {unit}".strip()


def _grid_rows(dataset: xr.Dataset) -> list[Row]:
    axes = [axis for axis in "xyz" if axis in dataset.sizes]
    sizes = [float(dataset.attrs[f"d{axis}"]) for axis in axes if f"d{axis}" in dataset.attrs]
    cells = Row("grid", "cells", counts(*(dataset.sizes[axis] for axis in axes)))
    return [cells, Row("grid", "cell size", lengths(*sizes))]


def _from_attributes(dataset: xr.Dataset) -> list[Row]:
    if "x" not in dataset.sizes:  # no contact fields: show numerical attributes
        plain = {str(k): v for k, v in dataset.attrs.items() if not isinstance(v, str)}
        return [Row("run", name, _value(float(value), "")) for name, value in plain.items()]
    rows = _grid_rows(dataset)
    for body in (1, 2):
        prefix = f"body{body}_"
        for name, value in dataset.attrs.items():
            if str(name).startswith(prefix):
                field = str(name).removeprefix(prefix)
                plain = value.tolist() if isinstance(value, (np.ndarray, np.generic)) else value
                for section in ("kinematic", "relaxation", *PROFILE_ARGUMENTS):
                    field = field.removeprefix(f"{section}_")
                constant = re.sub(r"^(layer\d+|substrate)_", "", field)
                unit = field_unit(f"body{body}.{constant}")
                rows.append(Row(f"body{body}", field.replace("_", " "), _value(plain, unit)))
    if (law := law_of_attributes(dataset.attrs)) is not None:
        rows.append(Row("contact", "friction law", law.law))
        for parameter, allowed in law.constants.items():
            value = _value(getattr(law, parameter), allowed.unit)
            rows.append(Row("contact", f"friction {parameter}", value))
    if "tol" in dataset.attrs:
        rows.append(Row("contact", "tol", _value(float(dataset.attrs["tol"]), "")))
    return rows


# names without the body
_SCALARS = (
    "load", "approach", "tilt_x", "tilt_y", "moment_x", "moment_y", "max_pressure", "contact_area",
    "max_von_mises", "max_equivalent_plastic_strain", "imprint_depth", "viscous_work",
    "attraction_energy", "load_work",
    "max_temperature", "travel", "lateral_travel", "time",
)  # fmt: skip
_CONVERGENCE = (
    "iterations", "plastic_strain_residual", "yield_violation", "contact_iterations", "substeps",
    "falling_number", "joint_steps", "converged", "contact_edge_distance", "cells_across_contact",
    "sharp_edge_cells", "area_uncertainty", "layers_across_plastic_zone", "plastic_edge_distance",
)  # fmt: skip


def scalars_table(dataset: xr.Dataset) -> Table:
    """Return a table of the scalar results of each increment."""
    return values_table(dataset, "increment", CONTACT, _SCALARS)


def results_table(dataset: xr.Dataset) -> Table:
    """Return a table of the maximum of each scalar result; used if errors were not estimated."""
    table = maxima_table(dataset, "increment", CONTACT, _SCALARS[:-2])
    return table._replace(note=f"{table.note} Errors were not estimated.")


def maxima_table(
    dataset: xr.Dataset, dim: str, quantities: Mapping[str, Quantity], names: Sequence[str]
) -> Table:
    """Return a table of the maximum magnitude of each variable along a dimension."""
    numbers, rows = dataset[dim].values, []
    for name in names:
        if quantities[name].shown in ("cells", "layers"):  # of the resolution
            continue
        for body, values in _values_by_body(dataset, name):
            sizes = np.where(np.isfinite(values), np.abs(values), -1.0)
            at = int(sizes.argmax())
            if sizes[at] > 0:
                shown = quantities[name].fitting(float(sizes[at]))
                cells = [cell(numbers[at], 1.0), cell(values[at], shown.factor)]
                rows.append((shown.of(body), cells))
    return Table(
        [dim, "value"], rows, "quantity", f"Maximum magnitude, and the {dim} in which it occurs."
    )


def slipping_tables(dataset: xr.Dataset) -> list[tuple[str, str, Table]]:
    """Return the tables of partial slip: results of each increment, and energy balance.

    Each table has a name and a title. For full sliding, the list is empty.
    """
    names = moved_along(dataset)
    if not names:
        return []
    along = values_table(dataset, "increment", CONTACT, names)
    found = [("slipping", "Partial slip", along)]
    if (balance := balance_of(dataset)) is not None:
        found.append(("energy", "Energy balance", _energy_table(balance)))
    return found


def _energy_table(balance: EnergyBalance) -> Table:
    parts = {
        "net external work": balance.net_external_work,
        "elastic energy of tractions": balance.elastic_energy,
        "elastic energy of residual stress": balance.residual_energy,
        "frictional work": balance.friction_work,
        "plastic dissipation": balance.plastic_work,
        "unaccounted for": balance.imbalance * balance.work_input,
    }
    if balance.expansion_work != 0:
        parts = {"work of thermal expansion": balance.expansion_work} | parts
    reference = balance.work_input or 1.0
    rows = [
        (name, [cell(value, 1.0), _percent(value / reference)]) for name, value in parts.items()
    ]
    note = (
        f"Energy budget after the last increment. The work input since the start is "
        f"{balance.work_input:.6g} J; the part that exceeds the net external work was recovered."
    )
    return Table(["value [J]", "fraction of work input [%]"], rows, "energy", note)


def errors_table(dataset: xr.Dataset) -> Table:
    """Return a table of maximum values with estimated errors; it is empty without estimates."""
    found = error_rows(dataset)
    more = {
        heading: [getattr(row, name) for row in found]
        for heading, name in (
            ("target [%]", "target"),
            ("increment error [%]", "by_increments"),
        )
        if any(getattr(row, name) is not None for row in found)
    }
    rows = []
    for n, row in enumerate(found):
        cells = [
            cell(row.increment, 1.0),
            Cell(row.shown, ""),
            Cell(row.percent, repr(row.relative)),
        ]
        cells += [_percent(shares[n]) for shares in more.values()]
        rows.append((row.label, cells))
    has_target = any(row.target is not None for row in found)
    note = (
        "Best values at the ends of the path segments, extrapolated from all grids and numbers of "
        "increments. Figures and increments are those of the finest grid."
        if has_target
        else "Estimated grid errors, relative to the value, from a grid coarsened by 2. Volume "
        "quantities are compared only at the increment of maximum stress and at the last increment."
    )
    if by_increments := increments_note(dataset.attrs):
        note += f" {by_increments[0].upper()}{by_increments[1:]}."
    heading = "error [%]" if has_target else "grid error [%]"
    return Table(["increment", "value", heading, *more], rows, "quantity", note)


def _percent(share: float | None) -> Cell:
    if share is None:
        return Cell("", "")
    return Cell(f"{100 * share:.2g}", repr(share))


def convergence_table(dataset: xr.Dataset) -> Table:
    """Return a table of iterations, residuals and resolution of each increment."""
    return values_table(dataset, "increment", CONTACT, _CONVERGENCE)


def values_table(
    dataset: xr.Dataset, dim: str, quantities: Mapping[str, Quantity], names: Sequence[str]
) -> Table:
    """Return a table of variables, with one row for each value of the dimension `dim`.

    A variable that is stored for each body has one column for each body.
    """
    found = []
    for name in names:
        for body, values in _values_by_body(dataset, name):
            shown = quantities[name].fitting(float(values.max()))
            found.append((shown.of(body), values, shown.factor))
    columns = [(heading, values, factor, _ROUNDING_ERROR * np.nanmax(np.abs(values), initial=0.0))
               for heading, values, factor in found]  # fmt: skip
    rows = [
        (str(number), [cell(values[index], factor, small) for _, values, factor, small in columns])
        for index, number in enumerate(dataset[dim].values)
    ]
    return Table([heading for heading, *_ in columns], rows, dim)


def _values_by_body(dataset: xr.Dataset, name: str) -> Iterator[tuple[int | None, FloatArray]]:
    """Iterate over the values of a variable as pairs (body, values).

    The body is None for a variable that does not refer to a body.
    """
    if name in dataset and "body" not in dataset[name].dims:
        yield None, dataset[name].values
    elif name in dataset:
        for body in dataset["body"].values.tolist():
            yield body, dataset[name].sel(body=body).values
    for body in (1, 2):
        if f"{name}_body{body}" in dataset:
            yield body, dataset[f"{name}_body{body}"].values


def cell(value: Any, factor: float, small: float = 0.0) -> Cell:
    """Return a table cell for a value in SI units.

    factor: factor to the displayed unit. A value with a magnitude below `small` is shown as "0".
    """
    number = float(value)
    if not np.isfinite(number):
        return Cell("none", "")
    return Cell("0" if abs(number) < small else f"{number * factor:.6g}", repr(number))


def hertz_table(
    dataset: xr.Dataset, peak: int, reference: HertzContact, body: int
) -> list[tuple[str, str, str, str]]:
    """Return table rows as texts: quantity, Hertz value, simulated value and difference in %.

    peak: index of the increment, from 0. reference: Hertz contact at the load of the increment.
    """
    return [
        (
            row.heading,
            quantity(exact, row.unit.replace("2", "²"), 6),
            quantity(here, row.unit.replace("2", "²"), 6),
            f"{100 * (here / exact - 1):+.3g} %",
        )
        for row, exact, here in hertz_rows(dataset, peak, reference, body)
    ]
