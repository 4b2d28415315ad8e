# SPDX-License-Identifier: GPL-3.0-or-later
"""Rollers and bearings in [surface]."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import BeforeValidator, Field, PrivateAttr, model_validator

from .. import bearings, hertz, surfaces
from .._util.checks import FloatArray
from .._util.short_text import in_short
from ..bearings.rating import STEEL_CONTACT_MODULUS
from ..bodies.layered import softest
from .base import Count, Finite, Length, NonNegative, Radius
from .converted import Unit
from .errors import SHORT_FORMS
from .surface_shape import FirstGrid, SurfaceShape

if TYPE_CHECKING:
    from ..bodies.layered import Body
    from ..problem.grid import Grid

Angle = Annotated[Finite, Unit("rad")]
Race = Literal["inner", "outer"]
_REFINED = 80.0
"""Factor on the number of cells along a roller, because the pressure at its ends varies within a
few per cent of its length."""


class _RollingSurface(SurfaceShape):
    @property
    def reason_for_grid(self) -> str:
        return ""


class RollerSurface(_RollingSurface):
    """Roller of finite length on a raceway, see `surfaces.roller`."""

    shape: Literal["roller"]
    diameter: Length
    length: Length
    pitch_diameter: Length | None = None
    race: Race = "inner"
    profile: Literal["straight", "crowned", "logarithmic", "lundberg", "table"] = "logarithmic"
    crown_radius: Radius | None = None
    straight_length: Annotated[NonNegative, Unit("m")] | None = None
    design_load: Annotated[NonNegative, Unit("N")] | None = None
    profile_y: Annotated[list[Finite], Field(min_length=2), Unit("m")] | None = None
    profile_drop: Annotated[list[Finite], Field(min_length=2), Unit("m")] | None = None
    tilt: Angle = 0.0
    skew: Angle = 0.0

    _E_star: float = PrivateAttr(default=STEEL_CONTACT_MODULUS)

    @model_validator(mode="after")
    def _complete(self) -> RollerSurface:
        if self.pitch_diameter is None and "race" in self.model_fields_set:
            raise ValueError("race requires pitch_diameter: add it, or omit race for a flat race")
        for name in ("profile_y", "profile_drop"):
            if (self.profile == "table") != (getattr(self, name) is not None):
                raise ValueError(f'{name} must be given if, and only if, profile = "table"')
        from ..problem.grid import Grid

        self.shape_gap(Grid(1, 3, 0.1 * self.diameter, 0.4 * self.length), Path())
        return self

    def on_bodies(self, *bodies: Body) -> None:
        self._E_star = hertz.effective_modulus(*map(softest, bodies))

    @property
    def race_radius(self) -> float:
        """Radius of the race in the plane of rolling [m], negative if concave, inf if flat."""
        if self.pitch_diameter is None:
            return math.inf
        sign = -1.0 if self.race == "inner" else 1.0
        return -sign * 0.5 * (self.pitch_diameter + sign * self.diameter)

    def shape_gap(self, grid: Grid, folder: Path, cells: Grid | None = None) -> FloatArray:
        more: dict[str, Any] = {}
        for name in ("crown_radius", "straight_length", "design_load"):
            if getattr(self, name) is not None:
                more[name] = getattr(self, name)
        if self.profile == "lundberg":
            more["E_star"] = self._E_star
        if self.profile == "logarithmic":
            more["diameter"] = self.diameter
        profile: Any = (
            (self.profile_y, self.profile_drop) if self.profile == "table" else self.profile
        )
        return surfaces.roller(
            grid, 0.5 * self.diameter, self.length, profile, race_radius=self.race_radius,
            tilt=self.tilt, skew=self.skew, **more,
        )  # fmt: skip

    def first_grid(self, load: float, E_star: float) -> FirstGrid | None:
        R = 1.0 / (2.0 / self.diameter + 1.0 / self.race_radius)
        return _grid_of_roller(R, self.length, load, E_star)


def _grid_of_roller(R: float, length: float, load: float, E_star: float) -> FirstGrid:
    return FirstGrid((hertz.line(R, E_star, load / length).b, 0.5 * length), _REFINED)


@lru_cache(maxsize=16)
def _max_element_load(
    bearing: bearings.Bearing, radial_load: float, axial_load: float, moment: float | None
) -> float:
    return bearing.max_element_load(radial_load, axial_load, moment)


@lru_cache(maxsize=16)
def _misalignment(
    bearing: bearings.Bearing, radial_load: float, axial_load: float, moment: float | None
) -> float:
    """Misalignment of the rings at the most heavily loaded element [rad]."""
    return bearing.element_loads(radial_load, axial_load, moment).tilt


def _as_text(given: Any) -> Any:
    """Return a designation without quotes, e.g. 6208, as text."""
    return str(given) if type(given) is int else given


class BearingSurface(_RollingSurface):
    """Most heavily loaded element of a bearing, see `bearings.Bearing`."""

    shape: Literal["bearing"]
    designation: Annotated[str | None, BeforeValidator(_as_text)] = None
    bore: Length | None = None
    outside_diameter: Length | None = None
    kind: Literal["deep_groove", "angular_contact", "cylindrical_roller"] | None = None
    element_diameter: Length | None = None
    pitch_diameter: Length | None = None
    elements: Count | None = None
    contact_angle: Angle | None = None
    inner_conformity: Finite | None = None
    outer_conformity: Finite | None = None
    length: Length | None = None
    profile: Literal["straight", "logarithmic"] | None = None
    clearance: Annotated[NonNegative, Unit("m")] | None = None
    rows: Count | None = None
    race: Race | None = None
    radial_load: Annotated[NonNegative, Unit("N")] | None = None
    axial_load: Annotated[NonNegative, Unit("N")] | None = None
    moment: Annotated[Finite, Unit("N*m")] | None = None

    @model_validator(mode="after")
    def _buildable(self) -> BearingSurface:
        if self.bearing.has_rollers and self.axial_load:
            raise ValueError("axial_load must be 0 for cylindrical rollers: omit it")
        if self.moment is not None and not self.has_loads:
            raise ValueError("moment requires radial_load or axial_load > 0: add one of them")
        if self.has_loads and not self.element_load > 0.0:
            raise ValueError("no element is loaded: change radial_load, axial_load or moment")
        return self

    @property
    def has_loads(self) -> bool:
        """Whether the loads on the bearing are given; if not, the path gives the contact load."""
        return bool(self.radial_load or self.axial_load)

    @property
    def bearing(self) -> bearings.Bearing:
        """Bearing that the section describes."""
        boundary = {n: getattr(self, n) for n in ("bore", "outside_diameter")}
        sizes = {
            name: getattr(self, name)
            for name in (
                "element_diameter", "pitch_diameter", "elements", "contact_angle",
                "inner_conformity", "outer_conformity", "length", "profile", "rows",
            )
            if getattr(self, name) is not None
        }  # fmt: skip
        ways = {
            "designation": self.designation is not None,
            "bore and outside_diameter": None not in boundary.values(),
            "kind": self.kind is not None,
        }
        if sum(ways.values()) != 1 or (any(boundary.values()) and not all(boundary.values())):
            raise ValueError(
                "exactly one of designation, bore and outside_diameter, or kind with the sizes of "
                "the elements must be given"
            )
        if self.kind is None:
            if sizes:
                raise ValueError(f'{", ".join(sizes)} requires kind, e.g. kind = "deep_groove"')
            if self.designation is not None:
                return bearings.standard(self.designation, self.clearance)
            return bearings.from_boundary(
                self.bore or 0.0, self.outside_diameter or 0.0, self.clearance
            )
        for name in ("element_diameter", "pitch_diameter", "elements"):
            if name not in sizes:
                raise ValueError(f'{name} is required with kind = "{self.kind}"')
        return bearings.Bearing(self.kind, clearance=self.clearance, **sizes)

    @property
    def loads(self) -> tuple[float, float, float | None]:
        """Radial and axial load [N], moment [N m]; 1 N radial load if none is given."""
        radial = (self.radial_load or 0.0) if self.has_loads else 1.0
        return radial, self.axial_load or 0.0, self.moment

    @property
    def element_load(self) -> float:
        """Load of the most heavily loaded element [N]."""
        return _max_element_load(self.bearing, *self.loads)

    @property
    def solved_race(self) -> str:
        """Race whose contact is solved; by default, the race with the higher Hertz pressure."""
        return self.bearing.governing_race if self.race is None else self.race

    @property
    def _tilt(self) -> float:
        """Tilt of the most loaded roller on a race [rad], half the misalignment of the rings."""
        if not self.bearing.has_rollers or self.moment is None:
            return 0.0
        return 0.5 * _misalignment(self.bearing, *self.loads)

    def radii(self) -> tuple[float, float] | None:
        if self.bearing.has_rollers:
            return None
        contact = self.bearing.race(self.solved_race)
        return contact.Rx, contact.Ry

    def shape_gap(self, grid: Grid, folder: Path, cells: Grid | None = None) -> FloatArray:
        return self.bearing.gap(self.solved_race, self._tilt)(grid)

    def first_grid(self, load: float, E_star: float) -> FirstGrid | None:
        length = self.bearing.length
        if length is None:
            return None
        return _grid_of_roller(self.bearing.race(self.solved_race).Rx, length, load, E_star)

    def surface_speeds(self, rates: Mapping[str, float]) -> tuple[float, float] | None:
        if "pinion_speed" in rates:
            return None
        inner, outer = rates.get("inner_speed", 0.0), rates.get("outer_speed", 0.0)
        from ..lubrication import bearing_speeds  # for films only

        return bearing_speeds(self.bearing, inner, outer)

    def nominal_load(self, grid: Grid | None) -> float | None:
        """Load of the most heavily loaded element [N]; None if the bearing has no loads."""
        return self.element_load if self.has_loads else None

    def require_path(self, loads: Sequence[float | None]) -> None:
        if self.has_loads and any(loads):
            raise ValueError(
                "load must be 0 or omitted with loads on the bearing (radial_load, axial_load): "
                "use load_factor, which multiplies the load of the most heavily loaded element"
            )


def _tables(given: Any) -> list[Any]:
    """Return the tables of a list of sections; [] for a value of another type."""
    return given if isinstance(given, list) else []


def with_surface(content: Any) -> Any:
    """Return the content of a case file, with [roller] or [bearing] rewritten as [surface]."""
    if not isinstance(content, Mapping):
        return content
    found: dict[str, Any] = dict(content)
    given = [name for name in ("surface", *SHORT_FORMS) if name in found]
    if len(given) > 1:
        raise ValueError(f"only one section may describe the surfaces, got {' and '.join(given)}")
    for name in SHORT_FORMS:
        part = found.pop(name, None)
        if isinstance(part, Mapping):
            found["surface"] = {"shape": name, **part}
        elif part is not None:
            remedy = f": write [{name}] instead of [[{name}]]" if isinstance(part, list) else ""
            raise ValueError(f"{name}: must be a table, got {in_short(part)}{remedy}")
    return found


def in_full(content: Any) -> Any:
    """Return the result of `with_surface`; a bearing without [[path]] receives a default path.

    The default path loads the contact; elastic-plastic bodies are also unloaded.
    """
    found = with_surface(content)
    if not isinstance(found, dict):
        return found
    surface = found.get("surface")
    if "path" in found or not isinstance(surface, Mapping) or surface.get("shape") != "bearing":
        return found
    laws = [
        part.get("law", "elastic")
        for name in ("body1", "body2")
        if isinstance(body := found.get(name), Mapping)
        for part in (body, *_tables(body.get("layers")))
        if isinstance(part, Mapping)
    ]
    if all(law in ("elastic", "rigid") for law in laws):
        once = {} if found.get("accuracy") is not None else {"increments": 1}
        return found | {"path": [{"load_factor": 1.0} | once]}
    return found | {"path": [{"load_factor": 1.0}, {"load": 0.0}]}


def short_places(message: str, content: Any) -> str:
    """Return an error message with [surface] renamed to [roller] or [bearing], as in the file."""
    for name in SHORT_FORMS:
        if isinstance(content, Mapping) and name in content:
            return re.sub(r"^surface\b", name, message, flags=re.MULTILINE)
    return message
