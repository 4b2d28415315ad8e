# SPDX-License-Identifier: GPL-3.0-or-later
"""Variables of the results dataset for partial slip: forces, motions, slip, energy balance."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from .. import energy
from .._util.checks import FloatArray
from .._util.quantities import CONTACT
from ..energy.balancing import no_balance
from ..problem.friction import friction_law
from ..solutions.tangential_quantities import (
    ROUNDING_ERROR,
    TANGENTIAL_QUANTITIES,
    along_surface,
    not_rounding,
)
from .motion import add

if TYPE_CHECKING:
    from ..simulation.simulation import Simulation
    from ..solutions.state import State

_BALANCE = (
    "work_input", "net_external_work", "elastic_energy", "residual_energy", "plastic_work",
)  # fmt: skip
_EXPANSION = "expansion_work"
_SURFACE = ("increment", "x", "y")
_FLAGS = {"flag_values": np.array([0, 1], np.int8), "flag_meanings": "no_stick stick"}
"""Attributes of the variable `sticking`, by the CF conventions, section 3.5."""


def add_slipping(
    dataset: xr.Dataset, simulation: Simulation, states: Sequence[State], volume: bool
) -> None:
    """Add the variables of partial slip: forces, motions, frictional work, slip, energy balance.

    Nothing is added for full sliding. For elastic-plastic bodies, the energy balance requires
    volume fields and is added only if `volume` is True. For moving bodies it is not added, because
    it would require the displacements of each increment.
    """
    law = friction_law(simulation.friction)
    if not law.sticks:
        return
    for name, values in along_surface(states).items():
        add(dataset, name, "increment", values)
    for number, direction in enumerate("xy"):
        add(dataset, f"slip_{direction}", _SURFACE, np.stack([s.slip[number] for s in states]))
    add(dataset, "stick_fraction", "increment", [_share(state) for state in states])
    add(dataset, "sticking", _SURFACE, np.stack([s.sticking for s in states]).astype(np.int8))
    dataset["sticking"].attrs |= _FLAGS
    if law.needs_duration:
        add(dataset, "slip_rate", _SURFACE, np.stack([s.slip_rate for s in states]))
        add(dataset, "falling_number", "increment", [s.falling_number for s in states])
    if law.hardens:
        add(dataset, "plastic_slip", _SURFACE, np.stack([s.plastic_slip for s in states]))
    if any(state.joint_steps for state in states):
        add(dataset, "joint_steps", "increment", [state.joint_steps for state in states])
    if not all(state.converged for state in states):
        add(dataset, "converged", "increment", [int(state.converged) for state in states])
    inelastic = simulation.body1.is_plastic or simulation.body2.is_plastic
    at_rest = not any(state.has_travelled for state in states)
    if at_rest and (volume or not inelastic) and not no_balance(simulation, states):
        _add_balance(dataset, energy.balance(simulation, states))


def _add_balance(dataset: xr.Dataset, found: energy.EnergyBalance) -> None:
    for name in _BALANCE if found.expansion_work == 0 else (*_BALANCE, _EXPANSION):
        dataset[name] = CONTACT[name].variable((), getattr(found, name))


def balance_of(dataset: xr.Dataset) -> energy.EnergyBalance | None:
    """Return the energy balance stored in a results dataset, or None if none is stored."""
    if "work_input" not in dataset:
        return None
    given = {n: float(dataset[n]) for n in (*_BALANCE, _EXPANSION) if n in dataset}
    return energy.EnergyBalance(**given, friction_work=float(dataset["friction_work"][-1]))


def _share(state: State) -> float:
    cells = np.count_nonzero(state.in_contact)
    return float(state.sticking.sum() / cells) if cells else float("nan")


def moved_along(dataset: xr.Dataset) -> list[str]:
    """Return the names of the tangential results to show, or [] for full sliding.

    These are the frictional work, the stick fraction, and all forces and motions that exceed
    rounding errors.
    """
    if "friction_work" not in dataset:
        return []
    values = {name: dataset[name].values for name in TANGENTIAL_QUANTITIES}
    sizes = (dataset[name].values for name in ("load", "approach", "contact_area"))
    return [*not_rounding(values, *sizes), "friction_work", "stick_fraction"]


def without_rounding(values: FloatArray) -> FloatArray:
    """Return values in which rounding errors, relative to the maximum magnitude, are set to 0."""
    small = ROUNDING_ERROR * np.nanmax(np.abs(values), initial=0.0)
    return np.where(np.abs(values) < small, 0.0, values)
