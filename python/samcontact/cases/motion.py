# SPDX-License-Identifier: GPL-3.0-or-later
"""Path segments of a case file, and reliefs (surface topography that moves with a body)."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

from pydantic import BeforeValidator, Field, model_validator

from .. import dents, measured, paths
from ..paths.ramps import fractions, start_unit
from ..problem.moving_topography import Relief
from .base import (
    BodyNumber,
    Count,
    Finite,
    HeatFactor,
    HeightsFile,
    Length,
    NonNegative,
    Pair,
    Position,
    Positive,
    Section,
    changed,
)
from .converted import Unit, convert
from .retracting import MAX_INCREMENTS, PullOff, settings_of_pull_off
from .slipping import TANGENTIAL_FIELDS, EndState, Force, Fretting
from .surface_shape import SelfAffineRoughness
from .tilting import TILTING_FIELDS, TiltingSection

if TYPE_CHECKING:
    from ..problem.grid import Grid


class _Passes(Section):
    distance: Position
    step: Length
    passes: Count = 1
    unload_increments: Count | None = None
    back_and_forth: bool = False
    speed: Annotated[Positive, Unit("m/s")] | None = None
    return_time: Annotated[NonNegative, Unit("s")] | None = None

    @model_validator(mode="after")
    def _moves(self) -> _Passes:
        if self.distance == 0.0:
            raise ValueError("distance must not be 0 [m], got 0")
        unused = sorted(changed(self, ("back_and_forth", "return_time")))
        if self.passes == 1 and unused:
            name = unused[0]
            raise ValueError(f"{name} has no effect on one pass: set passes, or omit {name}")
        return self


class Rolling(_Passes):
    """Passes of a rolling contact over both bodies, see `paths.rolling`."""

    slide_to_roll: Annotated[float, Field(ge=-2.0, le=2.0)] = 0.0
    lateral_creepage: Finite = 0.0
    spin: Annotated[Finite, Unit("1/m")] = 0.0
    tangential_load_x: Force | None = None

    def scaled(self, factor: float) -> Rolling:
        """Return a copy with the tangential force multiplied by a factor."""
        if self.tangential_load_x is None:
            return self
        return self.model_copy(update={"tangential_load_x": factor * self.tangential_load_x})

    @property
    def slips(self) -> list[str]:
        """Names of the given fields that require a law of partial slip."""
        names = ("lateral_creepage", "spin", "tangential_load_x")
        return [f"roll.{name}" for name in names if changed(self, [name])]


class Sliding(_Passes):
    """Sliding of one body over the other, see `paths.sliding`."""

    slider: BodyNumber = 1


class Segment(TiltingSection):
    """[[path]]: ramp of load or approach from the previous value, or passes at a constant value."""

    load: Annotated[Finite, Unit("N")] | None = None
    load_factor: NonNegative | None = None
    approach: Position | None = None
    increments: Count = 10
    start: Finite | None = None
    spacing: Literal["linear", "power"] = "linear"
    exponent: Positive = 2.0
    advance: (
        Annotated[Pair | Annotated[list[Pair], Field(min_length=2, max_length=2)], Unit("m")] | None
    ) = None
    roll: Rolling | None = None
    slide: Sliding | None = None
    fret: Fretting | None = None
    pull_off: Annotated[PullOff | None, BeforeValidator(settings_of_pull_off)] = None
    duration: Annotated[NonNegative, Unit("s")] | None = None
    first_duration: Annotated[Positive, Unit("s")] | None = None
    heat_factor: HeatFactor | None = None

    @model_validator(mode="before")
    @classmethod
    def _start_in_its_unit(cls, data: Any) -> Any:
        """Convert the text `start` to a number, in N with `load` and in m with `approach`."""
        if not isinstance(data, dict) or not isinstance(data.get("start"), str):
            return data
        try:
            return data | {"start": convert(data["start"], start_unit(data))}
        except ValueError as error:
            raise ValueError(f"start {error}") from error

    @model_validator(mode="after")
    def _one_target(self) -> Segment:
        if self.pull_off is not None:
            given = self.model_fields_set - {"pull_off", "increments"}
            names = sorted(name for name in given if getattr(self, name) is not None)
            if names:
                raise ValueError(f"pull_off cannot be combined with {', '.join(names)}: omit them")
            return self
        targets = [self.load, self.load_factor, self.approach]
        if targets.count(None) != 2:
            raise ValueError(
                "exactly one of load, approach and (for a machine part) load_factor must be given"
            )
        return self

    def with_load(self, nominal: float | None) -> Segment:
        """Return the segment with its load [N]: `load_factor` times the load `nominal` of the part.

        Raises ValueError if the part has no load.
        """
        if self.load_factor is None:
            return self
        if nominal is None:
            raise ValueError(
                "load_factor requires a part with a load, such as a gear with surface.torque: add "
                "such a load to [surface], or use load instead of load_factor"
            )
        loaded = self.model_copy(update={"load": self.load_factor * nominal})
        loaded.model_fields_set.discard("load")  # a sweep of the part computes the load again
        return loaded

    @model_validator(mode="after")
    def _one_movement(self) -> Segment:
        kinds = [kind for kind in ("roll", "slide", "fret") if getattr(self, kind) is not None]
        if len(kinds) > 1:
            raise ValueError(f"{' and '.join(kinds)} cannot be combined: use a [[path]] for each")
        if self.spacing == "linear" and changed(self, ["exponent"]):
            raise ValueError('exponent requires spacing = "power": set spacing, or omit exponent')
        if kinds:
            others = {
                "start",
                "spacing",
                "exponent",
                "advance",
                *TANGENTIAL_FIELDS,
                *TILTING_FIELDS,
            }
            others |= {"first_duration", "duration" if self.fret is None else "heat_factor"}
            given = sorted(changed(self, others))
            if given:
                names, kind = ", ".join(given), kinds[0]
                hint = f", and set {kind}.speed" if "duration" in given else ""
                raise ValueError(f"{kind} cannot be combined with {names}: omit {names}{hint}")
        if self.approach is not None and any(n.startswith("moment") for n in self.tilting):
            raise ValueError(
                "moment_x and moment_y cannot be combined with approach: prescribe load and "
                "moment, or approach and tilt"
            )
        if self.torque is not None and self.advance is not None:
            raise ValueError(
                "torque cannot be combined with advance: prescribe twist (angle in rad) instead"
            )
        return self

    @property
    def quantity(self) -> str:
        return "load" if self.load is not None else "approach"

    @property
    def passes(self) -> Rolling | Sliding | None:
        """Rolling or sliding passes of this segment; None for a ramp."""
        return self.slide if self.roll is None else self.roll

    @property
    def is_timed(self) -> bool:
        """Whether the steps of this segment have a duration."""
        return getattr(self.passes or self.pull_off or self, self.time_field) is not None

    @property
    def time_field(self) -> str:
        """Name of the field for the duration of steps, "speed" (passes, pull-off) or "duration"."""
        return "duration" if self.passes is None and self.pull_off is None else "speed"

    @property
    def slips(self) -> list[str]:
        """Names of the given fields that require a law of partial slip."""
        rolling = [] if self.roll is None else self.roll.slips
        return [*self.along, *rolling, *(["fret"] if self.fret is not None else [])]

    def scaled(self, factor: float) -> Segment:
        """Return a copy with all forces multiplied by a factor."""
        forces = (
            "load", "start", "tangential_load_x", "tangential_load_y", "torque", "moment_x",
            "moment_y",
        )  # fmt: skip
        return self.model_copy(
            update={name: factor * v for name in forces if (v := getattr(self, name)) is not None}
            | {n: part.scaled(factor) for n in ("roll", "fret") if (part := getattr(self, n))}
        )

    def steps(self, reached: EndState) -> tuple[paths.Path, EndState]:
        """Return the steps and the end state of this segment; `reached` is its initial state.

        Raises ValueError if the segment cannot start from the end of the previous segment.
        """
        if self.pull_off is not None:
            is_given = "increments" in self.model_fields_set
            return self.pull_off.steps(self.increments if is_given else MAX_INCREMENTS, reached)
        name, target = self.quantity, getattr(self, self.quantity)
        if self.fret is not None:
            fretting = self.fret.steps(name, target, self.increments, reached)
            if self.duration is not None:
                each = self.duration / len(fretting)
                fretting = [step | {"duration": each} for step in fretting]
            return fretting, self.fret.reached(reached)
        if self.passes is not None:
            if reached[1] != 0.0:
                kind = "roll" if self.roll is not None else "slide"
                raise ValueError(
                    f"{kind} must start unloaded, but the previous segment ends at {reached[0]} = "
                    f"{reached[1]!r}: unload first, or add advance to move under load"
                )
            options = {"increments": self.increments, "heat_factor": self.heat_factor}
            options |= self.passes.model_dump() | {name: target}
            make: Any = paths.rolling if self.roll is not None else paths.sliding
            return make(**options), reached._replace(
                quantity="load", value=0.0, forces=(0.0, 0.0, 0.0)
            )
        start = self.start
        if start is None:
            if reached[0] not in ("", name):
                raise ValueError(
                    f"start is required where the path changes from {reached[0]} to {name}: set it "
                    f"to the {name} at which this segment begins"
                )
            start = reached[1]
        common: dict[str, Any] = {
            name: target,
            "increments": self.increments,
            "advance": self.advance,
            "duration": self.duration,
            "heat_factor": self.heat_factor,
        }
        optional = (self.advance, self.duration, self.heat_factor)
        held = self.along or self.tilting or optional != (None, None, None)
        if self.first_duration is not None and not (target == start and self.duration):
            raise ValueError(
                f"first_duration requires a duration > 0 and a constant {name}: use a separate "
                f"[[path]] with the {name} at which the previous segment ends"
            )
        if target == start and held:
            if changed(self, ["spacing"]):
                raise ValueError(
                    f"spacing has no effect, because {name} remains {target!r}: omit spacing"
                )
            steps = paths.hold(**common, first_duration=self.first_duration)
        else:
            steps = paths.ramp(start=start, spacing=self.spacing, exponent=self.exponent, **common)
        parts = fractions(self.increments, self.spacing, self.exponent)
        ends = self.add_along(steps, parts.tolist(), reached._replace(quantity=name, value=target))
        return steps, self.add_tilting(steps, parts.tolist(), ends)


class FileRelief(HeightsFile):
    """Relief with heights from a file, positive outwards: ny along y, any number along x."""

    is_known: ClassVar[bool] = False  # not defined on every grid
    kind: Literal["file"]
    x: Position = 0.0
    periodic: bool = False

    def build(self, grid: Grid, folder: Path, cells: Grid | None = None) -> Relief:
        """Return the relief for a grid.

        cells: grid for which the file gives heights, if it differs from `grid`.
        """
        heights = self.plain(grid if cells is None else cells, folder)
        if heights is None:
            surface = self.surface(folder)
            return surface.relief(grid, self.x, periodic=self.periodic, **self.placement())
        if cells is not None:
            surface = measured.MeasuredSurface(heights, cells.dx, cells.dy)
            return surface.relief(grid, self.x, periodic=self.periodic)
        first = round(self.x / grid.dx + 0.5 * (grid.nx - heights.shape[0]))
        return Relief(heights, first, self.periodic)

    def sample_steps(self, grid: Grid, folder: Path) -> tuple[float, float]:
        """Return the distances between neighbouring heights in the file along x and y [m]."""
        given = self.plain(grid, folder) is not None
        return (grid.dx, grid.dy) if given else self.surface(folder).steps


class DentRelief(Section):
    """Spherical dent, see `dents.spherical`."""

    is_known: ClassVar[bool] = True  # defined on every grid
    kind: Literal["dent"]
    depth: Position
    radius: Length
    x: Position = 0.0
    y: Position = 0.0

    def build(self, grid: Grid, folder: Path, cells: Grid | None = None) -> Relief:
        return dents.spherical(grid, self.depth, self.radius, self.x, self.y)


class FurrowRelief(Section):
    """Furrow, see `dents.furrow`."""

    is_known: ClassVar[bool] = True  # defined on every grid
    kind: Literal["furrow"]
    depth: Position
    half_width: Length
    along: Literal["y", "x"] = "y"
    position: Position = 0.0

    def build(self, grid: Grid, folder: Path, cells: Grid | None = None) -> Relief:
        return dents.furrow(grid, self.depth, self.half_width, self.along, self.position)


class RoughRelief(Section):
    """Random roughness that repeats along x with the length of the grid."""

    is_known: ClassVar[bool] = False  # not defined on every grid
    kind: Literal["self_affine"]
    rms_height: Annotated[NonNegative, Unit("m")]
    hurst: Annotated[float, Field(ge=0.0, le=1.0)]
    wavelength_min: Length | None = None
    wavelength_max: Length | None = None
    roll_off: Length | None = None
    seed: Annotated[int, Field(ge=0)]

    @property
    def _roughness(self) -> SelfAffineRoughness:
        return SelfAffineRoughness.model_validate(self.model_dump())

    def build(self, grid: Grid, folder: Path, cells: Grid | None = None) -> Relief:
        return Relief(self._roughness.build(grid, cells), periodic=True)

    def sample_steps(self, grid: Grid, folder: Path) -> tuple[float, float]:
        """Return half the shortest wavelengths along x and y [m]."""
        return self._roughness.sample_steps(grid, folder)


ReliefSection = Annotated[
    FileRelief | DentRelief | FurrowRelief | RoughRelief, Field(discriminator="kind")
]
