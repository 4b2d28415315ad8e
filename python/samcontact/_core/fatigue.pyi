# SPDX-License-Identifier: GPL-3.0-or-later
# Written by: python scripts/stubs.py
from __future__ import annotations

import numpy
import numpy.typing

__all__: list[str] = ["crossland", "dang_van", "fatemi_socie", "findley"]

def crossland(
    stress: numpy.typing.NDArray[numpy.float64], slope: float
) -> numpy.typing.NDArray[numpy.float64]: ...
def dang_van(
    stress: numpy.typing.NDArray[numpy.float64], slope: float
) -> numpy.typing.NDArray[numpy.float64]: ...
def fatemi_socie(
    shear: numpy.typing.NDArray[numpy.float64],
    stress: numpy.typing.NDArray[numpy.float64],
    k: float,
) -> tuple[numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.float64]]: ...
def findley(
    stress: numpy.typing.NDArray[numpy.float64], k: float
) -> tuple[numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.float64]]: ...
