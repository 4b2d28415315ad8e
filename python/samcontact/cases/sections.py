# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections of a case file as pydantic models; each creates the corresponding object."""

from __future__ import annotations

from dataclasses import MISSING, fields
from functools import reduce
from operator import or_
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import Field, create_model, model_validator

from .. import measured, surfaces
from .._util.checks import FloatArray
from ..heat import Heat
from ..problem.adhesion_laws import LAWS, law_of
from ..problem.contact_law import ContactLaw, HardContact
from ..problem.friction import FrictionLaw, friction_law
from ..problem.settings import (
    Allowed,
    ChoiceSetting,
    ContactLawSetting,
    CountSetting,
    FrictionSetting,
    Settings,
)
from ..problem.settings import allowed as allowed_of
from .base import (
    BodyNumber,
    Count,
    Finite,
    HeatFactor,
    HeightsFile,
    Length,
    NonNegative,
    OutputPlace,
    Position,
    Positive,
    Radius,
    Section,
    Velocity,
)
from .converted import Unit
from .friction import FrictionField, friction_of
from .parts import PartSurface
from .rolling_parts import BearingSurface, RollerSurface
from .surface_shape import SurfaceShape

if TYPE_CHECKING:
    from ..problem.grid import Grid
    from .friction import FrictionSection


class GridSection(Section):
    """[grid]: cells of the surface, and layers of the volume for stresses and plasticity.

    The grid is enlarged if necessary, but not if heights from a file or random roughness are part
    of the gap or of a relief.
    """

    nx: Count
    ny: Count
    dx: Length
    dy: Length
    nz: Annotated[int, Field(ge=0)] = 0
    dz: Length | None = None
    periodic: Literal["", "x", "y", "xy"] = ""

    @model_validator(mode="after")
    def _volume_is_complete(self) -> GridSection:
        if self.nz > 0 and self.dz is None:
            raise ValueError(
                "nz requires dz: specify both, or only dz to let samcontact choose the "
                "number of layers"
            )
        return self

    def build(self) -> Grid:
        from ..problem.grid import Grid

        return Grid(**self.model_dump())


class ParaboloidSurface(SurfaceShape):
    """Paraboloid x^2/(2 Rx) + y^2/(2 Ry)."""

    shape: Literal["paraboloid"]
    Rx: Radius
    Ry: Radius | None = None

    def radii(self) -> tuple[float, float] | None:
        return self.Rx, self.Rx if self.Ry is None else self.Ry

    def shape_gap(self, grid: Grid, folder: Path, cells: Grid | None = None) -> FloatArray:
        return surfaces.paraboloid(grid, self.Rx, self.Ry)


class SphereSurface(SurfaceShape):
    """Sphere, without the approximation by a paraboloid."""

    shape: Literal["sphere"]
    R: Length

    def radii(self) -> tuple[float, float] | None:
        return self.R, self.R

    def shape_gap(self, grid: Grid, folder: Path, cells: Grid | None = None) -> FloatArray:
        return surfaces.sphere(grid, self.R)


class CylinderSurface(SurfaceShape):
    """Circular cylinder, without the approximation by a paraboloid."""

    shape: Literal["cylinder"]
    R: Length
    axis: Literal["x", "y"] = "y"

    def shape_gap(self, grid: Grid, folder: Path, cells: Grid | None = None) -> FloatArray:
        return surfaces.cylinder(grid, self.R, self.axis)


class FileSurface(SurfaceShape, HeightsFile):
    """Surface of body 2 with heights from a file; body 1 is a paraboloid."""

    shape: Literal["file"]
    x: Position | None = None
    fill: Annotated[float, Unit("m")] | None = None  # -inf: no material
    periodic: Literal["", "x", "y", "xy"] = ""
    Rx: Radius | None = None
    Ry: Radius | None = None

    @model_validator(mode="after")
    def _Ry_needs_Rx(self) -> FileSurface:
        if self.Ry is not None and self.Rx is None:
            raise ValueError(
                "Ry requires Rx: add Rx, or Rx = inf for a surface that is straight along x"
            )
        return self

    @property
    def is_known(self) -> bool:
        return False

    def shape_gap(self, grid: Grid, folder: Path, cells: Grid | None = None) -> FloatArray:
        heights = self._of_cells(grid if cells is None else cells, folder)
        if heights is None:
            x = 0.0 if self.x is None else self.x
            surface = self.surface(folder)
            heights = surface.on(grid, x, periodic=self.periodic, **self.placement())
        elif cells is not None:
            surface = measured.MeasuredSurface(heights, cells.dx, cells.dy)
            heights = surface.on(grid, periodic=cells.periodic)
        upper = None if self.Rx is None else surfaces.paraboloid(grid, self.Rx, self.Ry)
        return surfaces.from_heights(grid, heights, upper)

    def _of_cells(self, grid: Grid, folder: Path) -> FloatArray | None:
        return None if self.x is not None or self.periodic else self.plain(grid, folder)

    def sample_steps(self, grid: Grid, folder: Path) -> tuple[float, float]:
        """Return the distances between neighbouring heights in the file along x and y [m]."""
        given = self._of_cells(grid, folder) is not None
        return (grid.dx, grid.dy) if given else self.surface(folder).steps


SurfaceSection = Annotated[
    ParaboloidSurface
    | SphereSurface
    | CylinderSurface
    | FileSurface
    | RollerSurface
    | BearingSurface
    | PartSurface,
    Field(discriminator="shape"),
]


class _LawSection(Section):
    """Contact law with its constants, see `ContactLaw`."""

    kind: str

    def build(self) -> ContactLaw:
        return law_of(self.model_dump())


def _law_section(law: type[ContactLaw]) -> type[_LawSection]:
    """Create the section of a contact law; the constants must be non-negative."""
    parameters: Any = {}
    for item in fields(law):
        if "choices" in item.metadata:
            parameters[item.name] = (Literal[item.metadata["choices"]], item.default)
            continue
        value: Any = list[NonNegative] if item.metadata.get("many") else NonNegative
        value = Annotated[value, Unit(item.metadata["unit"])]
        parameters[item.name] = (value, ...) if item.default is MISSING else (value | None, None)
    kind: Any = (Literal[law.kind], ...)
    return create_model(
        f"{law.__name__}Section",
        __base__=_LawSection,
        __doc__=f"Contact law `{law.__name__}`.",
        __module__=__name__,
        kind=kind,
        **parameters,
    )


_LAW_SECTIONS = {law.kind: _law_section(law) for law in LAWS}
globals().update({section.__name__: section for section in _LAW_SECTIONS.values()})  # for pickling


def _contact_law_field() -> Any:
    sections: Any = reduce(or_, _LAW_SECTIONS.values())
    return Annotated[sections, Field(discriminator="kind")]


def _annotation(allowed: Allowed) -> Any:
    """Return the annotation of the case-file field for a setting of `Simulation`."""
    if isinstance(allowed, ContactLawSetting):
        return _contact_law_field()
    if isinstance(allowed, FrictionSetting):
        return FrictionField
    if isinstance(allowed, ChoiceSetting):
        return Literal[allowed.allowed]
    if isinstance(allowed, CountSetting):
        return Count
    limits = Field(gt=allowed.gt, ge=allowed.ge, lt=allowed.lt, le=allowed.le)
    return Annotated[(Finite, limits, Unit(allowed.unit)) if allowed.unit else (Finite, limits)]


def settings_section(name: str, module: str, without: tuple[str, ...] = (), **defaults: Any) -> Any:
    """Create a section [contact] whose fields are settings of `Simulation`.

    module: name of the module in which the section is defined, for pickling.
    without: settings to omit.
    defaults: default values that differ from the defaults of `Simulation`.
    """
    found: dict[str, Any] = {}
    for setting, allowed in allowed_of(Settings).items():
        if setting in without:
            continue
        default = defaults.get(setting, getattr(Settings, setting))
        if isinstance(allowed, ContactLawSetting):
            default = None  # hard contact
        annotation = _annotation(allowed)
        found[setting] = (annotation | None if default is None else annotation, default)
    docstring = "[contact]: solver settings."
    return create_model(name, __base__=Section, __doc__=docstring, __module__=module, **found)


if TYPE_CHECKING:

    class ContactSection(Section):
        friction: float | FrictionSection = 0.0
        adhesion: _LawSection | None = None
else:
    ContactSection = settings_section("ContactSection", __name__)


def settings_of(section: ContactSection) -> dict[str, Any]:
    """Return the settings in [contact] as keyword arguments of `Simulation`."""
    laws = {"friction": friction_of(section.friction), "adhesion": contact_law_of(section)}
    return section.model_dump() | laws


def law_of_section(section: ContactSection) -> FrictionLaw:
    """Return the friction law of a section [contact]."""
    return friction_law(settings_of(section)["friction"])


def contact_law_of(section: ContactSection) -> ContactLaw:
    """Return the contact law of a section [contact]."""
    return HardContact() if section.adhesion is None else section.adhesion.build()


class HeatSection(Section):
    """[heat]: frictional heat, see `Heat`."""

    factor: HeatFactor | None = None
    partition: Annotated[Finite, Field(ge=0.0, le=1.0)] | None = None
    velocity: Velocity | None = None
    time: Annotated[Positive, Unit("s")] | None = None
    history: Annotated[list[Positive], Field(min_length=2, max_length=2), Unit("s")] | None = None
    reference: Length | None = None
    track: (
        Annotated[
            Positive | Annotated[list[NonNegative], Field(min_length=2, max_length=2)], Unit("m")
        ]
        | None
    ) = None

    @model_validator(mode="after")
    def _go_together(self) -> HeatSection:
        if (self.factor is None) == (self.partition is None):
            raise ValueError("exactly one of factor and partition must be given")
        self.build()
        return self

    @property
    def is_timed(self) -> bool:
        """Whether the increments of the path need a duration."""
        return self.history is not None or self.partition is not None

    def build(self) -> Heat:
        return Heat(**self.model_dump(exclude_none=True))


class OutputSection(OutputPlace):
    """[output]: folder of the results and stored fields."""

    body: BodyNumber = 2
    volume: Literal["none", "last", "peak_and_last", "all"] = "peak_and_last"
