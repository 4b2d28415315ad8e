# SPDX-License-Identifier: GPL-3.0-or-later
"""Tangential quantities of states, by their names in results files."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from .._util.checks import FloatArray

if TYPE_CHECKING:
    from ..solutions.state import State

ROUNDING_ERROR = 1e-8
"""Relative value below which a force or a motion counts as zero."""


def along_surface(states: Sequence[State]) -> dict[str, FloatArray]:
    """Return forces, motions and frictional work by name, for states with partial slip."""
    given: dict[str, list[float]] = {}
    for state in states:
        (force_x, force_y), (x, y) = state.tangential_load, state.shift
        values = {
            "tangential_load_x": force_x,
            "tangential_load_y": force_y,
            "torque": state.torque,
            "shift_x": x,
            "shift_y": y,
            "twist": state.twist,
            "friction_work": state.friction_work,
        }
        for name, value in values.items():
            given.setdefault(name, []).append(float(value))
    return {name: np.array(values) for name, values in given.items()}


TANGENTIAL_QUANTITIES = (
    "tangential_load_x",
    "tangential_load_y",
    "torque",
    "shift_x",
    "shift_y",
    "twist",
)


def not_rounding(
    values: Mapping[str, FloatArray], load: FloatArray, approach: FloatArray, area: FloatArray
) -> list[str]:
    """Return the names of forces and motions that are larger than rounding errors."""
    p, d, a = (float(np.nanmax(np.abs(v), initial=0.0)) for v in (load, approach, area))
    size = a**0.5
    scales = (p, p, p * size, d, d, d / size if size > 0 else 0.0)
    return [
        name
        for name, scale in zip(TANGENTIAL_QUANTITIES, scales, strict=True)
        if float(np.max(np.abs(values[name]))) > ROUNDING_ERROR * scale
    ]
