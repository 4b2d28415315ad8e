# SPDX-License-Identifier: GPL-3.0-or-later
"""Simulations and states for pickle and copy: what a checkpoint holds, and laws of softening."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from .checkpoint import Snapshot, Softening, from_bytes, to_bytes
from .grid import Grid
from .material import Material


class Kept(Protocol):
    """A simulation, as far as checkpoints and copies know it."""

    grid: Grid
    body1: Material
    body2: Material

    def _snapshot(self, state: Any = None) -> Snapshot: ...

    def _resume(self, kept: tuple[dict[str, Any], dict[str, Any]]) -> None: ...


def laws(simulation: Kept) -> Softening:
    """Of both bodies; a checkpoint has only those of `samcontact.softening`."""
    return simulation.body1.softening, simulation.body2.softening


def reduced(simulation: Kept, state: Any = None) -> tuple[Any, ...]:
    """What makes the simulation again, standing at an earlier state of it where one is given."""
    return type(simulation), to_bytes(simulation._snapshot(state)), laws(simulation)


def stand_at(simulation: Kept, state: Any) -> None:
    """Take a simulation back to an earlier state of it."""
    simulation._resume(from_bytes(to_bytes(simulation._snapshot(state)), laws(simulation)))


def restored(cls: Callable[..., Any], content: bytes, softening: Softening) -> Any:
    """The simulation from what `reduced` has returned."""
    kept = from_bytes(content, softening)
    simulation = cls(**kept[0])
    simulation._resume(kept)
    return simulation


def restored_state(cls: Callable[..., Any], content: bytes, softening: Softening) -> Any:
    """The state of it."""
    return restored(cls, content, softening).state
