# SPDX-License-Identifier: GPL-3.0-or-later
"""Part of the results dataset that only bodies have which stick and slip."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from ..friction import Coulomb
from .motion import add

if TYPE_CHECKING:
    from ..simulation import Simulation
    from ..state import State

_SURFACE = ("increment", "x", "y")


def add_slipping(dataset: xr.Dataset, simulation: Simulation, states: Sequence[State]) -> None:
    """Add forces and motions along the surface, friction work, slip, and which cells stick.

    Nothing is added where friction is a number.
    """
    if not isinstance(simulation.friction, Coulomb):
        return
    for number, direction in enumerate("xy"):
        force = [state.tangential_load[number] for state in states]
        add(dataset, f"tangential_load_{direction}", "increment", force)
        add(dataset, f"shift_{direction}", "increment", [s.shift[number] for s in states])
        add(dataset, f"slip_{direction}", _SURFACE, np.stack([s.slip[number] for s in states]))
    for name in ("torque", "twist", "friction_work"):
        add(dataset, name, "increment", [getattr(state, name) for state in states])
    add(dataset, "sticking", _SURFACE, np.stack([s.sticking for s in states]).astype(np.int8))
