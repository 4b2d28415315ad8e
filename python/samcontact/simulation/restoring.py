# SPDX-License-Identifier: GPL-3.0-or-later
"""Creation of simulations from snapshots (pickles, copies, files) and from other setups."""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, TypeVar, cast

from ..restart.file import other_version, readable
from .checkpoint import read_checkpoint
from .given_strain import prepare
from .snapshot import Snapshot

if TYPE_CHECKING:
    from ..diagnostics.monitor import Monitor
    from ..heat import Heat
    from ..problem.domain import Domain
    from ..problem.grid import Grid
    from ..problem.setup import SimulationSetup
    from ..solutions.state import State
    from .engine import Engine, Preparation
    from .increment_errors import Repeat

Made = TypeVar("Made")
"""Type variable: a class of simulations."""


def restored(cls: type[Made], kept: Snapshot, first: Domain | None = None, gap: Any = None) -> Made:
    """Restore a simulation of class `cls` from a snapshot.

    first: domain before any enlargement; gap: function of a grid that returns the gap.
    """
    changes = {} if gap is None else {"gap": gap}
    simulation = cls(**kept.arguments | changes)
    engine: Engine = cast("Any", simulation).engine
    engine.restore(kept)
    if first is not None:
        engine.first = first
    return simulation


def reduced(cls: type[Any], engine: Engine, monitor: Monitor) -> tuple[Any, ...]:
    """Return the data of a simulation for a pickle or copy, including gap and relief functions."""
    kept, surfaces = engine.snapshot(), vars(engine.setup.surfaces)
    functions = {name: shape for name, shape in surfaces.items() if callable(shape)}
    kept = replace(kept, arguments=kept.arguments | functions)
    return restored, (cls, kept, engine.first), {"monitor": monitor}


def loaded(
    cls: type[Made], path: str | os.PathLike[str], softening: Sequence[Any], gap: Any = None
) -> Made:
    """Load a simulation from a checkpoint file; gap: function of a grid that returns the gap."""
    kept, tree = read_checkpoint(path, softening)
    if message := other_version(path, tree):
        warnings.warn(
            f"{message}: the last digits of further increments may differ from those of an "
            "uninterrupted run",
            stacklevel=3,
        )
    with readable(path):
        return restored(cls, kept, gap=gap)


def without_estimates(cls: type[Any], arguments: Mapping[str, Any]) -> Any:
    """Create a simulation of class `cls` that does not estimate errors due to its increments."""
    simulation = cls(**arguments)
    simulation.monitor.checks_increments = False
    return simulation


def repeat_with(cls: type[Any], preparation: Preparation | None = None) -> Repeat:
    """Return a function that runs a setup along a path, without error estimates.

    preparation: function that changes each simulation before its path.
    """

    def repeated(
        setup: SimulationSetup, grid: Grid, heat: Heat, path: Sequence[Mapping[str, Any]]
    ) -> list[State]:
        again = without_estimates(cls, setup.on_grid(grid, heat))
        prepare(again, preparation)
        found: list[State] = again.run(path, progress=False)
        return found

    return repeated
