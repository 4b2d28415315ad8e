# SPDX-License-Identifier: GPL-3.0-or-later
"""What the sections of a case file share: strict models, kinds of numbers, files of heights."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
from pydantic import AfterValidator, BaseModel, ConfigDict, Field, PrivateAttr

from ._checks import FloatArray


def _known_format(value: str) -> str:
    if Path(value).suffix.lower() not in (".npy", ".txt", ".csv", ".dat"):
        raise ValueError(f"must end in .npy, .txt, .dat or .csv, got {value!r}")
    return value


Positive = Annotated[float, Field(gt=0.0, allow_inf_nan=False)]
Radius = Annotated[float, Field(gt=0.0)]  # inf is straight
NonNegative = Annotated[float, Field(ge=0.0, allow_inf_nan=False)]
Finite = Annotated[float, Field(allow_inf_nan=False)]
Poisson = Annotated[float, Field(ge=0.0, lt=0.5)]
Count = Annotated[int, Field(ge=1)]
Pair = Annotated[list[Finite], Field(min_length=2, max_length=2)]
HeatFactor = NonNegative | Annotated[list[NonNegative], Field(min_length=2, max_length=2)]
Velocity = Pair | Annotated[list[Pair], Field(min_length=2, max_length=2)]
HeightsFile = Annotated[str, AfterValidator(_known_format)]


class CaseError(ValueError):
    """A case file that cannot be used; the message names the file, the field and the remedy."""


class Section(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)


class OutputPlace(Section):
    """Where results go."""

    directory: Annotated[str, Field(min_length=1)] | None = None
    figures: bool = True


class CaseFile(Section):
    """What every kind of case file has: where it came from, and where its results go."""

    if TYPE_CHECKING:  # the last field of each kind
        output: OutputPlace

    _source: Path = PrivateAttr(default=Path("case.toml"))
    _text: str = PrivateAttr(default="")

    @property
    def source(self) -> Path:
        """The file this case was read from."""
        return self._source

    @property
    def text(self) -> str:
        """The text of the case file, as stored with the results."""
        return self._text

    @property
    def output_directory(self) -> Path:
        """[output] directory, or results/<name of the case file>; relative to the working one."""
        return Path(self.output.directory or Path("results") / self._source.stem)


def read_heights(path: Path) -> FloatArray:
    """Rows of heights from a file; a ValueError that names the path where it cannot be read."""
    try:
        if path.suffix.lower() == ".npy":
            heights: Any = np.load(path, allow_pickle=False)
        else:
            delimiter = "," if path.suffix.lower() == ".csv" else None
            heights = np.loadtxt(path, delimiter=delimiter, ndmin=2)
    except (OSError, ValueError) as error:
        raise ValueError(f"path: cannot read heights from {path}: {error}") from error
    return np.asarray(heights)
