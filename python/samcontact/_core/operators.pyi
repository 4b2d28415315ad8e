# SPDX-License-Identifier: GPL-3.0-or-later
# Written by: python scripts/stubs.py
from __future__ import annotations

import collections.abc
import typing

import numpy
import numpy.typing

import samcontact._core

__all__: list[str] = [
    "HeatHistory",
    "ResidualBox",
    "heated_wave",
    "residual_displacement",
    "residual_stress",
    "surface_displacement",
    "surface_stress",
    "temperature",
    "zone_fields",
]

class HeatHistory:
    def __init__(
        self,
        grid: samcontact._core.Grid,
        heating: samcontact._core.Heating,
        elastic: samcontact._core.Stack,
        shortest: float,
        longest: float,
        tolerance: float,
        in_depth: bool,
        track: typing.Annotated[collections.abc.Sequence[float], "FixedSize(2)"] = [0.0, 0.0],
    ) -> None: ...
    def add(
        self,
        flux: numpy.typing.NDArray[numpy.float64],
        dt: float,
        speed: typing.Annotated[collections.abc.Sequence[float], "FixedSize(2)"] = [0.0, 0.0],
    ) -> None: ...
    def copy(self) -> HeatHistory: ...
    def displacement(self, ahead: float) -> numpy.typing.NDArray[numpy.float64]: ...
    def move(
        self, by: typing.Annotated[collections.abc.Sequence[float], "FixedSize(2)"]
    ) -> None: ...
    def set_state(self, state: numpy.typing.NDArray[numpy.float64]) -> None: ...
    def state(self) -> numpy.typing.NDArray[numpy.float64]: ...
    def stress(
        self, ahead: float, z: collections.abc.Sequence[float]
    ) -> numpy.typing.NDArray[numpy.float64]: ...
    def temperature(
        self, ahead: float, z: collections.abc.Sequence[float]
    ) -> numpy.typing.NDArray[numpy.float64]: ...
    @property
    def size(self) -> int: ...

class ResidualBox:
    def __init__(
        self,
        grid: samcontact._core.Grid,
        above: int,
        elastic: samcontact._core.Elastic,
        image_tol: float,
    ) -> None: ...
    def stress(
        self, strain: numpy.typing.NDArray[numpy.float64]
    ) -> numpy.typing.NDArray[numpy.float64]: ...

def heated_wave(
    body: samcontact._core.Stack,
    heating: samcontact._core.Heating,
    q: collections.abc.Sequence[float],
    rate: collections.abc.Sequence[complex | typing.SupportsComplex | float],
    z: float,
) -> numpy.typing.NDArray[numpy.complex128]: ...
def residual_displacement(
    grid: samcontact._core.Grid, strain: numpy.typing.NDArray[numpy.float64], nu: float, axis: int
) -> numpy.typing.NDArray[numpy.float64]: ...
def residual_stress(
    grid: samcontact._core.Grid,
    strain: numpy.typing.NDArray[numpy.float64],
    elastic: samcontact._core.Elastic,
    exact: bool,
    image_tol: float,
) -> numpy.typing.NDArray[numpy.float64]: ...
def surface_displacement(
    grid: samcontact._core.Grid,
    body: samcontact._core.Body,
    heating: samcontact._core.Heating,
    pressure: numpy.typing.NDArray[numpy.float64],
    shear_x: numpy.typing.NDArray[numpy.float64] | None,
    shear_y: numpy.typing.NDArray[numpy.float64] | None,
    axis: int,
) -> numpy.typing.NDArray[numpy.float64]: ...
def surface_stress(
    grid: samcontact._core.Grid,
    body: samcontact._core.Body,
    heating: samcontact._core.Heating,
    z: collections.abc.Sequence[float],
    pressure: numpy.typing.NDArray[numpy.float64],
    shear_x: numpy.typing.NDArray[numpy.float64] | None,
    shear_y: numpy.typing.NDArray[numpy.float64] | None,
) -> numpy.typing.NDArray[numpy.float64]: ...
def temperature(
    grid: samcontact._core.Grid,
    heating: samcontact._core.Heating,
    z: collections.abc.Sequence[float],
    pressure: numpy.typing.NDArray[numpy.float64],
) -> numpy.typing.NDArray[numpy.float64]: ...
def zone_fields(
    grid: samcontact._core.Grid,
    elastic: samcontact._core.Elastic,
    zones: collections.abc.Sequence[
        typing.Annotated[collections.abc.Sequence[int], "FixedSize(5)"]
    ],
    strain: numpy.typing.NDArray[numpy.float64],
    pressure: numpy.typing.NDArray[numpy.float64] | None,
    shear_x: numpy.typing.NDArray[numpy.float64] | None,
    shear_y: numpy.typing.NDArray[numpy.float64] | None,
    image_tol: float,
) -> tuple[numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.float64]]: ...
