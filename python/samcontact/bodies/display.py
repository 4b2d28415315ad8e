# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts and tables that show the law and constants of a material."""

from __future__ import annotations

import math
from typing import Any

from .._util.display import Rows, quantity, rows_of
from .hardening_laws import LAWS


def material_rows(material: Any) -> Rows:
    """Table rows (name, value with unit) for the law and all constants of a material."""
    if material.law not in LAWS:  # layers of materials
        return list(rows_of(material))
    constants = LAWS[material.law].constants
    rows = [("law", material.law.replace("_", " "))]
    for name, value in material.parameters.items():
        unit = constants[name].unit
        if constants[name].many:
            span = f"{quantity(min(value), unit)} to {quantity(max(value), unit)}"
            rows.append((name, f"{len(value)} values, {span}"))
        elif unit == "microstrain":
            rows.append((name, f"{value:.4g} {unit}"))  # without a prefix
        else:
            rows.append((name, quantity(value, unit)))
    for number, (modulus, recovery) in enumerate(material.kinematic, 1):
        text = f"modulus {quantity(modulus, 'Pa')}, recovery {recovery:.4g}"
        rows.append((f"backstress {number}", text))
    if material.thermal is not None:
        conductivity, expansion, diffusivity = material.thermal
        rows.append(("conductivity", f"{conductivity:.4g} W/(m K)"))
        rows.append(("thermal expansion", f"{expansion * 1e6:.4g} µm/(m K)"))
        rows.append(("diffusivity", f"{diffusivity * 1e6:.4g} mm²/s"))
    if material.softening is not None:
        rows.append(("softening", repr(material.softening)))
    if material.yield_profile is not None:
        z, factor = material.yield_profile
        rows.append(("yield profile", _over_depth(z, factor, "")))
    if material.residual_stress is not None:
        z, *stresses = material.residual_stress
        for name, values in zip(("sxx", "syy", "sxy"), stresses, strict=True):
            rows.append((f"residual {name}", _over_depth(z, values, "Pa")))
    if material.free_faces is not None:
        *places, method = material.free_faces
        named = zip(("low", "high"), places, strict=True)
        shown = [f"{name} {quantity(y, 'm')}" for name, y in named if math.isfinite(y)]
        rows.append(("free faces", f"y: {', '.join(shown)}, {method}"))
    if material.relaxation_terms is not None:
        for number, (time, share) in enumerate(zip(*material.relaxation_terms, strict=True), 1):
            rows.append((f"relaxation {number}", f"{share:.4g} E in {quantity(time, 's')}"))
    return rows


def _over_depth(z: tuple[float, ...], values: tuple[float, ...], unit: str) -> str:
    span = " to ".join(dict.fromkeys(quantity(v, unit) for v in (values[0], values[-1])))
    inside = [quantity(edge, unit) for edge in (min(values), max(values))]
    range_text = "" if set(inside) <= set(span.split(" to ")) else f", within {' to '.join(inside)}"
    return f"{span} from {quantity(z[0], 'm')} to {quantity(z[-1], 'm')}{range_text}"


def material_in_short(material: Any) -> str:
    """One-line description of a material, for tables of objects that contain it."""
    rows = material_rows(material)
    constants = ", ".join(f"{name} = {value}" for name, value in rows[1:])
    return f"{rows[0][1]} ({constants})" if constants else rows[0][1]
