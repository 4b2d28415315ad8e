# SPDX-License-Identifier: GPL-3.0-or-later
"""Simulations and states for checkpoints, pickle and copy: what makes them again."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields
from typing import TYPE_CHECKING, Any, Protocol

from ._settings import Settings
from .checkpoint import Snapshot, Softening, from_bytes, to_bytes

if TYPE_CHECKING:
    from ._checks import FloatArray
    from .grid import Grid
    from .heat import Heat
    from .material import Material

_SCENE = ("grid", "body1", "body2", "relief1", "relief2", *(item.name for item in fields(Settings)))
"""Arguments of a simulation that are attributes of the same name and kind."""
Kept = tuple[dict[str, Any], dict[str, Any]]
"""What a checkpoint gives: arguments of a simulation, and entries for the core."""


class Standing(Protocol):
    """A simulation, as far as copies and checkpoints know it."""

    grid: Grid
    body1: Material
    body2: Material
    initial_gap: FloatArray
    _core: Any
    _heat: Heat

    @property
    def counters(self) -> dict[str, int]: ...


class Moment(Protocol):
    """A state, as far as copies and checkpoints know it."""

    _core: Any
    _heat: Heat


def laws(simulation: Standing) -> Softening:
    """Of both bodies; a checkpoint has only those of `samcontact.softening`."""
    return simulation.body1.softening, simulation.body2.softening


def snapshot(simulation: Standing, state: Moment | None = None) -> Snapshot:
    """A simulation as it stands, or as it stood in an earlier state."""
    arguments = {name: getattr(simulation, name) for name in _SCENE}
    arguments["gap"] = simulation.initial_gap
    arguments["heat"] = simulation._heat if state is None else state._heat
    core = simulation._core.state if state is None else state._core
    return Snapshot(arguments, core, simulation.counters)


def resume(simulation: Standing, kept: Kept) -> None:
    """Make a simulation of the same scene stand as a checkpoint tells."""
    arguments, saved = kept
    simulation._core.restore(saved)
    simulation._heat = arguments["heat"]


def stand_at(simulation: Standing, state: Moment) -> None:
    """Take a simulation back to an earlier state of it."""
    resume(simulation, from_bytes(to_bytes(snapshot(simulation, state)), laws(simulation)))


def reduced(simulation: Standing, state: Moment | None = None) -> tuple[Any, ...]:
    """What makes the simulation again, standing at an earlier state of it where one is given."""
    return type(simulation), to_bytes(snapshot(simulation, state)), laws(simulation)


def restored(cls: Callable[..., Any], content: bytes, softening: Softening) -> Any:
    """The simulation from what `reduced` has returned."""
    kept = from_bytes(content, softening)
    simulation = cls(**kept[0])
    resume(simulation, kept)
    return simulation


def restored_state(cls: Callable[..., Any], content: bytes, softening: Softening) -> Any:
    """The state of it."""
    return restored(cls, content, softening).state
