# SPDX-License-Identifier: GPL-3.0-or-later
"""Tilts and moments about x and y in a loading path."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, NamedTuple

from pydantic import model_validator

from .. import paths
from .base import Finite
from .converted import Unit
from .slipping import EndState, TangentialSection

_MOMENTS, _TILTS = ("moment_x", "moment_y"), ("tilt_x", "tilt_y")
TILTING_FIELDS = (*_MOMENTS, *_TILTS)

Moment = Annotated[Finite, Unit("N*m")]
Angle = Annotated[Finite, Unit("rad")]


class AboutAxis(NamedTuple):
    """Moment and tilt about one axis, reached at the end of a path segment; None means unknown."""

    moment: float | None = 0.0
    tilt: float | None = 0.0


class TiltingSection(TangentialSection):
    """Moments on body 2 and rotations of body 1 about x and y at the end of a segment."""

    moment_x: Moment | None = None
    moment_y: Moment | None = None
    tilt_x: Angle | None = None
    tilt_y: Angle | None = None

    @model_validator(mode="after")
    def _moment_or_tilt(self) -> TiltingSection:
        for moment, tilt in zip(_MOMENTS, _TILTS, strict=True):
            if getattr(self, moment) is not None and getattr(self, tilt) is not None:
                raise ValueError(
                    f"{moment} cannot be combined with {tilt}, because the tilt follows from the "
                    "moment: omit one of them"
                )
        return self

    @property
    def tilting(self) -> list[str]:
        """Names of the prescribed moments and tilts."""
        return [name for name in TILTING_FIELDS if getattr(self, name) is not None]

    def add_tilting(
        self, steps: paths.Path, fractions: Sequence[float], reached: EndState
    ) -> EndState:
        """Add moments and tilts to the steps; return the end state of the segment.

        fractions: position of the end of each step in the segment, 0 to 1. reached: load or
        approach at the end of the segment, and moments and tilts at its start.
        """
        if not self.tilting:
            return self._held(reached)
        given: dict[str, list[list[float | None]]] = {"moment": [], "tilt": []}
        ends = []
        for axis, start in zip("xy", reached.about, strict=True):
            before = AboutAxis(*start)
            for name, values in given.items():
                end, now = getattr(self, f"{name}_{axis}"), getattr(before, name)
                values.append(ramp(f"{name}_{axis}", now, end, fractions))
            moment, tilt = getattr(self, f"moment_{axis}"), getattr(self, f"tilt_{axis}")
            turns = moment is not None or tilt is not None
            ends.append(AboutAxis(moment, tilt if turns else before.tilt))
        for n, step in enumerate(steps):
            for name, (about_x, about_y) in given.items():
                pair = about_x[n], about_y[n]
                if pair != (None, None):
                    step[name] = pair
        return self._held(reached._replace(about=tuple(ends)))

    def _held(self, reached: EndState) -> EndState:
        """Return the end state, with None for moments that follow from the solution."""
        is_unloaded = reached[:2] == ("load", 0.0)
        ends = []
        for axis, now in zip("xy", reached.about, strict=True):
            moment, tilt = now
            if is_unloaded:
                moment = 0.0
            elif getattr(self, f"moment_{axis}") is None and (tilt != 0.0 or moment != 0.0):
                moment = None
            ends.append(AboutAxis(moment, tilt))
        return reached._replace(about=tuple(ends))


def ramp(
    name: str, start: float | None, end: float | None, fractions: Sequence[float]
) -> list[float | None]:
    """Return the values of a linear ramp at the end of each step; without `end`, all are None."""
    if end is None:
        return [None] * len(fractions)
    if start is None:
        if len(fractions) > 1:
            raise ValueError(
                f"{name} must not change in several increments here, because its initial value is "
                "unknown before the solution: insert a segment with increments = 1 that "
                f"prescribes {name} before this one"
            )
        return [end]
    return [end if f == 1.0 else start + f * (end - start) for f in fractions]
