# SPDX-License-Identifier: GPL-3.0-or-later
# Written by: python scripts/stubs.py
from __future__ import annotations

import numpy
import numpy.typing

__all__: list[str] = [
    "eigenstrain_displacement",
    "eigenstrain_stress",
    "heat_displacement",
    "heat_stress",
    "heat_temperature",
    "steady_heat_displacement",
    "steady_heat_stress",
    "steady_heat_temperature",
    "traction_displacement",
    "traction_stress",
]

def eigenstrain_displacement(
    axis: int,
    X: numpy.typing.NDArray[numpy.float64],
    Y: numpy.typing.NDArray[numpy.float64],
    zc: float,
    a: float,
    b: float,
    c: float,
    nu: float,
) -> numpy.typing.NDArray[numpy.float64]: ...
def eigenstrain_stress(
    X: numpy.typing.NDArray[numpy.float64],
    Y: numpy.typing.NDArray[numpy.float64],
    z: numpy.typing.NDArray[numpy.float64],
    zc: float,
    a: float,
    b: float,
    c: float,
    E: float,
    nu: float,
) -> numpy.typing.NDArray[numpy.float64]: ...
def heat_displacement(
    x: numpy.typing.NDArray[numpy.float64],
    y: numpy.typing.NDArray[numpy.float64],
    a: float,
    b: float,
    heated: float,
    speed: tuple[float, float],
    tol: float,
) -> numpy.typing.NDArray[numpy.float64]: ...
def heat_stress(
    x: numpy.typing.NDArray[numpy.float64],
    y: numpy.typing.NDArray[numpy.float64],
    z: float,
    a: float,
    b: float,
    nu: float,
    heated: float,
    speed: tuple[float, float],
    tol: float,
) -> numpy.typing.NDArray[numpy.float64]: ...
def heat_temperature(
    x: numpy.typing.NDArray[numpy.float64],
    y: numpy.typing.NDArray[numpy.float64],
    z: float,
    a: float,
    b: float,
    heated: float,
    speed: tuple[float, float],
    tol: float,
) -> numpy.typing.NDArray[numpy.float64]: ...
def steady_heat_displacement(
    X: numpy.typing.NDArray[numpy.float64],
    Y: numpy.typing.NDArray[numpy.float64],
    a: float,
    b: float,
    r0: float,
) -> numpy.typing.NDArray[numpy.float64]: ...
def steady_heat_stress(
    X: numpy.typing.NDArray[numpy.float64],
    Y: numpy.typing.NDArray[numpy.float64],
    z: numpy.typing.NDArray[numpy.float64],
    a: float,
    b: float,
) -> numpy.typing.NDArray[numpy.float64]: ...
def steady_heat_temperature(
    X: numpy.typing.NDArray[numpy.float64],
    Y: numpy.typing.NDArray[numpy.float64],
    z: numpy.typing.NDArray[numpy.float64],
    a: float,
    b: float,
) -> numpy.typing.NDArray[numpy.float64]: ...
def traction_displacement(
    traction: int,
    axis: int,
    X: numpy.typing.NDArray[numpy.float64],
    Y: numpy.typing.NDArray[numpy.float64],
    a: float,
    b: float,
    E: float,
    nu: float,
) -> numpy.typing.NDArray[numpy.float64]: ...
def traction_stress(
    traction: int,
    X: numpy.typing.NDArray[numpy.float64],
    Y: numpy.typing.NDArray[numpy.float64],
    z: numpy.typing.NDArray[numpy.float64],
    a: float,
    b: float,
    nu: float,
) -> numpy.typing.NDArray[numpy.float64]: ...
