# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes of parts in [surface]: indenters, gear flanks, cams, wheel and rail."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from pydantic import Field, model_validator

from .. import parts
from .._util.checks import FloatArray
from ..measured.plain import plain_heights
from ..parts.indenters import BERKOVICH_HALF_ANGLE, VICKERS_HALF_ANGLE
from .base import Finite, Length, NonNegative, Pair, Position, Positive, Radius
from .converted import Unit
from .surface_shape import SurfaceShape

if TYPE_CHECKING:
    from ..problem.grid import Grid

Angle = Annotated[Finite, Unit("rad")]
Rounding = Annotated[NonNegative, Unit("m")]
Lengths = Annotated[list[Positive], Field(min_length=2, max_length=2), Unit("m")]
Depths = Annotated[list[NonNegative], Field(min_length=2, max_length=2), Unit("m")]


class _Indenter(SurfaceShape):
    @property
    def reason_for_grid(self) -> str:
        return "Hertz theory does not apply to the contact of an indenter"


class FlatPunchSurface(_Indenter):
    """Circular punch with a flat end."""

    shape: Literal["flat_punch"]
    radius: Length
    edge_radius: Rounding = 0.0

    @model_validator(mode="after")
    def _rounded_within(self) -> FlatPunchSurface:
        if self.edge_radius > self.radius:
            raise ValueError(
                f"edge_radius must be <= radius = {self.radius!r}, got {self.edge_radius!r}"
            )
        return self

    def shape_gap(self, grid: Grid, folder: Path, cells: Grid | None = None) -> FloatArray:
        return parts.flat_punch(grid, self.radius, self.edge_radius)


class ConeSurface(_Indenter):
    """Cone with a sharp or spherical tip."""

    shape: Literal["cone"]
    half_angle: Angle
    tip_radius: Rounding = 0.0

    def shape_gap(self, grid: Grid, folder: Path, cells: Grid | None = None) -> FloatArray:
        return parts.cone(grid, self.half_angle, self.tip_radius)


class BerkovichSurface(_Indenter):
    """Pyramid with three faces."""

    shape: Literal["berkovich"]
    tip_radius: Rounding = 0.0
    angle: Angle = 0.0
    half_angle: Angle = BERKOVICH_HALF_ANGLE

    def shape_gap(self, grid: Grid, folder: Path, cells: Grid | None = None) -> FloatArray:
        return parts.berkovich(grid, self.tip_radius, self.angle, self.half_angle)


class VickersSurface(_Indenter):
    """Pyramid with four faces."""

    shape: Literal["vickers"]
    tip_radius: Rounding = 0.0
    angle: Angle = 0.0
    half_angle: Angle = VICKERS_HALF_ANGLE

    def shape_gap(self, grid: Grid, folder: Path, cells: Grid | None = None) -> FloatArray:
        return parts.vickers(grid, self.tip_radius, self.angle, self.half_angle)


class GearSurface(SurfaceShape):
    """Flanks of a pair of spur gears, see `parts.GearPair`."""

    shape: Literal["gear"]
    module: Length
    teeth: Annotated[list[int], Field(min_length=2, max_length=2)]
    face_width: Length
    pressure_angle: Angle = parts.GearPair.pressure_angle
    profile_shift: Pair | None = None
    centre_distance: Length | None = None
    tip_diameter: Lengths | None = None
    crowning: Rounding = 0.0
    tip_relief: Depths | None = None
    relief_length: Lengths | None = None
    relief_exponent: Positive = 1.0
    position: Position | Literal["A", "B", "C", "D", "E"] = "C"
    torque: Annotated[Positive, Unit("N*m")] | None = None
    sharing: Literal["equal", "linear"] = "equal"

    @model_validator(mode="after")
    def _meshes(self) -> GearSurface:
        if None not in (self.profile_shift, self.centre_distance, self.tip_diameter):
            raise ValueError(
                "profile_shift has no effect with both centre_distance and tip_diameter: omit it"
            )
        self.contact()
        return self

    def contact(self) -> parts.FlankContact:
        """Return the contact of the flanks at `position`."""
        own = {"position", "torque", "sharing", "shape", "roughness"}
        return parts.GearPair(**self.model_dump(exclude=own, exclude_none=True)).at(self.position)

    def radii(self) -> tuple[float, float] | None:
        """Radii along x and y at the contact [m]; None without crowning or with tip relief."""
        if self.crowning == 0.0 or self.tip_relief is not None:
            return None
        return self.contact().radius, self.face_width**2 / (8.0 * self.crowning)

    @property
    def straight(self) -> tuple[float, float] | None:
        if self.crowning > 0.0 or self.tip_relief is not None:
            return None
        return self.contact().radius, self.face_width

    def surface_speeds(self, rates: Mapping[str, float]) -> tuple[float, float] | None:
        return self.contact().speeds(rates["pinion_speed"]) if "pinion_speed" in rates else None

    @property
    def reason_for_grid(self) -> str:
        if self.tip_relief is not None:
            return "Hertz theory does not apply to a flank with tip relief"
        return super().reason_for_grid

    def nominal_load(self, grid: Grid | None) -> float | None:
        """Load on the tooth pair [N]; on a grid periodic along y, the load within the grid."""
        if self.torque is None:
            return None
        load = self.contact().load(self.torque, self.sharing)
        if grid is not None and grid.along_y:
            return load * grid.ny * grid.dy / self.face_width
        return load

    def shape_gap(self, grid: Grid, folder: Path, cells: Grid | None = None) -> FloatArray:
        return self.contact().surface(grid)


class CamSurface(SurfaceShape):
    """Cam on a flat-faced tappet at a given cam angle, see `parts.Cam`."""

    shape: Literal["cam"]
    base_radius: Length
    eccentricity: Rounding | None = None
    max_lift: Length | None = None
    event_angle: Angle | None = None
    lift_angle: Annotated[list[Finite], Field(min_length=5), Unit("rad")] | None = None
    lift: Annotated[list[NonNegative], Field(min_length=5), Unit("m")] | None = None
    cam_angle: Angle = 0.0
    crown_radius: Radius = math.inf

    @model_validator(mode="after")
    def _follows(self) -> CamSurface:
        self.contact()
        return self

    @property
    def cam(self) -> parts.Cam:
        """Cam of this section; raises ValueError unless its lift is given in exactly one form."""
        harmonic = self.max_lift, self.event_angle
        table = self.lift_angle, self.lift
        forms = [self.eccentricity is not None, any(v is not None for v in harmonic),
                 any(v is not None for v in table)]  # fmt: skip
        if sum(forms) != 1 or (forms[1] and None in harmonic) or (forms[2] and None in table):
            raise ValueError(
                "exactly one of eccentricity, max_lift with event_angle, or lift_angle with lift "
                "must be given"
            )
        if self.eccentricity is not None:
            return parts.Cam.eccentric(self.base_radius + self.eccentricity, self.eccentricity)
        if self.max_lift is not None and self.event_angle is not None:
            return parts.Cam.harmonic(self.base_radius, self.max_lift, self.event_angle)
        return parts.Cam.table(self.base_radius, self.lift_angle or (), self.lift or ())

    def contact(self) -> parts.TappetContact:
        """Return the contact of cam and tappet at `cam_angle`."""
        return self.cam.at(self.cam_angle)

    def radii(self) -> tuple[float, float] | None:
        """Radii at the contact along x and y [m]; the latter is infinite without a crown."""
        return self.contact().radius, self.crown_radius

    def shape_gap(self, grid: Grid, folder: Path, cells: Grid | None = None) -> FloatArray:
        return self.contact().surface(grid, self.crown_radius)


class WheelRailSurface(SurfaceShape):
    """Wheel and rail with profiles from files, see `parts.WheelRail`."""

    shape: Literal["wheel_rail"]
    rail: Annotated[str, Field(min_length=1)]
    wheel: Annotated[str, Field(min_length=1)]
    wheel_radius: Length
    unit: Literal["m", "mm"] = "m"
    shift: Position = 0.0
    yaw: Angle = 0.0
    roll: Angle = 0.0
    smoothing: Rounding = 0.0

    @property
    def files(self) -> dict[str, str]:
        """Names of the files that the section reads, by field name."""
        return {"rail": self.rail, "wheel": self.wheel}

    @property
    def reason_for_grid(self) -> str:
        return "Hertz theory does not apply to the contact of two profiles"

    def contact(self, folder: Path) -> parts.WheelRail:
        """Return the contact of the profiles; ValueError if a file or the contact is invalid."""
        factor = 1.0 if self.unit == "m" else 1e-3
        return parts.WheelRail(
            factor * plain_heights(folder / self.rail),
            factor * plain_heights(folder / self.wheel),
            self.wheel_radius,
            shift=self.shift,
            yaw=self.yaw,
            roll=self.roll,
            smoothing=self.smoothing,
        )

    def shape_gap(self, grid: Grid, folder: Path, cells: Grid | None = None) -> FloatArray:
        return self.contact(folder).surface(grid)


PartSurface = (
    FlatPunchSurface
    | ConeSurface
    | BerkovichSurface
    | VickersSurface
    | GearSurface
    | CamSurface
    | WheelRailSurface
)
