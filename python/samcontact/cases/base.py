# SPDX-License-Identifier: GPL-3.0-or-later
"""Base classes of case-file sections: strict validation, values with units, files of heights."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

from pydantic import (
    BaseModel,
    ConfigDict,
    Field,
    PrivateAttr,
    ValidationError,
)

from .. import measured
from .._util.checks import MAX_COUNT, FloatArray
from ..measured.files import has_columns
from ..measured.plain import is_plain, plain_heights
from ..measured.plausible import warn_of_size
from ..problem.grid import Grid
from .converted import Unit
from .errors import explained, refused_values

if TYPE_CHECKING:
    from typing_extensions import Self


Positive = Annotated[float, Field(gt=0.0, allow_inf_nan=False)]
Radius = Annotated[float, Field(gt=0.0), Unit("m")]  # inf: straight
NonNegative = Annotated[float, Field(ge=0.0, allow_inf_nan=False)]
Finite = Annotated[float, Field(allow_inf_nan=False)]
Length = Annotated[Positive, Unit("m")]
Position = Annotated[Finite, Unit("m")]
Count = Annotated[int, Field(ge=1, le=MAX_COUNT)]
BodyNumber = Annotated[int, Field(ge=1, le=2)]  # Literal[1, 2] would accept true as 1
Pair = Annotated[list[Finite], Field(min_length=2, max_length=2)]
HeatFactor = Annotated[
    NonNegative | Annotated[list[NonNegative], Field(min_length=2, max_length=2)], Unit("m/s")
]
Velocity = Annotated[Pair | Annotated[list[Pair], Field(min_length=2, max_length=2)], Unit("m/s")]


class CaseError(ValueError):
    """Error in a case file; the message names the file, the field and the remedy."""


class Section(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, defer_build=True)


def changed(section: Section, names: Iterable[str]) -> set[str]:
    """Return the names of the fields that differ from their defaults."""
    fields = type(section).model_fields
    return {name for name in names if getattr(section, name) != fields[name].default}


class OutputPlace(Section):
    """[output]: folder of the results, and format of the figures."""

    directory: Annotated[str, Field(min_length=1)] | None = None
    figures: bool = True
    format: Literal["png", "pdf", "svg"] = "png"
    column: Literal["screen", "single", "double"] = "screen"


class CaseFile(Section):
    """Base class of case files, with the path of the file and the folder of the results."""

    KIND: ClassVar[str] = "one contact"
    """Noun phrase for this kind of case in messages."""

    if TYPE_CHECKING:  # fields that each kind of case file has, first and last
        title: str
        output: OutputPlace

    @classmethod
    def model_validate(cls, obj: Any, **settings: Any) -> Self:
        """Create a case from a dictionary with the layout of a case file; numbers in SI units.

        Raises
        ------
        CaseError
            A field is missing, unknown or out of range; the message has one line for each error.
        """
        # not by a validator of the fields, which takes time to build for a thousand fields
        if errors := refused_values(obj):
            raise CaseError("\n".join(errors))
        try:
            return super().model_validate(obj, **settings)
        except ValidationError as error:
            raise CaseError("\n".join(explained(cls, error, obj))) from None

    _source: Path = PrivateAttr(default=Path("case.toml"))
    _text: str = PrivateAttr(default="")

    def written_in(self, source: Path, text: str = "") -> Self:
        """Store the path and text of the file from which the case was read; return the case."""
        self._source, self._text = source, text
        return self

    def __repr_args__(self) -> list[tuple[str | None, Any]]:
        """Show only title and file name: the full representation would be as long as the file."""
        return [("title", self.title[:60]), ("source", str(self._source))]

    @property
    def study(self) -> str:
        """Kind of study, e.g. "wear" or "film"; "" if the case only solves a loading path."""
        return ""

    @property
    def source(self) -> Path:
        """File from which the case was read."""
        return self._source

    @property
    def text(self) -> str:
        """Text of the case file, which is stored with the results."""
        return self._text

    @property
    def output_directory(self) -> Path:
        """Folder of the results, given in [output] or, by default, results/<name of the case file>.

        The path is relative to the current working folder.
        """
        return Path(self.output.directory or Path("results") / self._source.stem)


class HeightsFile(Section):
    """File with heights of a body: one number per cell of the grid, or a measured surface."""

    path: Annotated[str, Field(min_length=1)]
    format: str | None = None
    channel: int | str | None = None
    detrend: Literal["none", "center", "height", "slope", "curvature"] | None = None
    unit: str | None = None
    dx: Length | None = None
    dy: Length | None = None
    y: Position | None = None
    mirror: Literal["x", "y"] | None = None
    method: Literal["cubic", "linear"] | None = None
    average: bool | None = None
    fill: Position | None = None

    @property
    def files(self) -> dict[str, str]:
        """Names of the files that the section reads, by field name."""
        return {"path": self.path}

    def plain(self, grid: Grid, folder: Path) -> FloatArray | None:
        """Return heights [m] from a text file with one number per cell; None for other files."""
        path = folder / self.path
        if not changed(self, HeightsFile.model_fields) <= {"path"} or not is_plain(path):
            return None
        heights = plain_heights(path)
        if heights.shape[1] != grid.ny and has_columns(path):
            return None
        warn_of_size(heights, (grid.dx, grid.dy), self.path, stacklevel=2)
        return heights

    def surface(self, folder: Path) -> measured.MeasuredSurface:
        trend = "center" if self.detrend is None else self.detrend
        surface = measured.read(
            folder / self.path,
            format=self.format,
            channel=self.channel,
            detrend=None if trend == "none" else trend,
            dx=self.dx,
            dy=self.dy,
            unit=self.unit,
        )
        return surface if self.mirror is None else surface.mirrored(self.mirror)

    def placement(self) -> dict[str, Any]:
        """Return the given fields, except x, as arguments of `MeasuredSurface.on` or `.relief`."""
        names = ("y", "method", "average", "fill")
        return {n: getattr(self, n) for n in names if getattr(self, n) is not None}
