# SPDX-License-Identifier: GPL-3.0-or-later
"""Simulations and states for pickle and copy: what a checkpoint holds, and laws of softening."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .checkpoint import Softening, from_bytes, to_bytes

if TYPE_CHECKING:
    from .simulation import Simulation
    from .state import State


def laws(simulation: Simulation) -> Softening:
    """Of both bodies; a checkpoint has only those of `samcontact.softening`."""
    return simulation.body1.softening, simulation.body2.softening


def reduced(simulation: Simulation, state: State | None = None) -> tuple[Any, ...]:
    """What makes the simulation again, standing at an earlier state of it where one is given."""
    return type(simulation), to_bytes(simulation, state), laws(simulation)


def stand_at(simulation: Simulation, state: State) -> None:
    """Take a simulation back to an earlier state of it."""
    _, saved = from_bytes(to_bytes(simulation, state), laws(simulation))
    simulation._core.restore(saved)


def restored(cls: type[Simulation], content: bytes, softening: Softening) -> Simulation:
    """The simulation from what `reduced` has returned."""
    arguments, saved = from_bytes(content, softening)
    simulation = cls(**arguments)
    simulation._core.restore(saved)
    return simulation


def restored_state(cls: type[Simulation], content: bytes, softening: Softening) -> State:
    """The state of it."""
    return restored(cls, content, softening).state
