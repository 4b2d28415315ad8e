# SPDX-License-Identifier: GPL-3.0-or-later
"""Execution of the increments of a run, with log, progress and checkpoints."""

from __future__ import annotations

import logging
import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from .._util.progress import progress_bar
from ..diagnostics.monitor import Monitor
from ..solutions.state import State
from .engine import Engine
from .journal import journal_of
from .steps import largest_cold_load, largest_target
from .unfolding import count_text, largest_count, unfolded

_logger = logging.getLogger("samcontact")


def _log(state: State, number: int, count: str) -> None:
    """Write one increment of a run to the log."""
    if not _logger.isEnabledFor(logging.INFO):
        return
    _logger.info(
        "increment %d of %s: load %.6g N, approach %.6g m, maximum pressure %.6g Pa",
        number, count, state.load, state.approach, state.pressure.max(),
    )  # fmt: skip
    _logger.debug(
        "increment %d: %d plastic and %d contact iterations in %d sub-increments, residual %.2g",
        number, state.iterations, state.contact_iterations, state.substeps,
        state.plastic_strain_residual,
    )  # fmt: skip


def run_into(
    states: list[State],
    engine: Engine,
    monitor: Monitor,
    step: Callable[..., State],
    steps: Sequence[Mapping[str, Any]],
    progress: bool,
    checkpoint: str | os.PathLike[str] | None,
    *,
    leave: bool = True,
) -> None:
    """Run a path, appending each state to `states`. leave: whether the bar remains at the end."""
    monitor.warn_of_units(engine.estimate, engine.heat, largest_target(steps), stacklevel=3)
    if not any(engine.heat.shares) and (load := largest_cold_load(steps)) is not None:
        engine.make_room(load)
    with (
        monitor.deferred_resolution_checks(),
        journal_of(checkpoint, engine, path=steps) as journal,
        progress_bar(largest_count(steps), "increment", shown=progress, leave=leave) as bar,
    ):
        for arguments in unfolded(steps, engine, lambda: engine.state):
            state = journal.next() if journal else None
            kept = state is not None
            try:
                states.append(step(**arguments) if state is None else state)
            except Warning:  # made an error by a filter: the increment is done
                states.append(engine.state)
                raise
            finally:
                if journal and not kept and len(states) > journal.count:
                    journal.add()
            _log(states[-1], len(states), count_text(steps))
            bar.update()
            if progress:
                strain = max(map(states[-1].max_equivalent_plastic_strain, (1, 2)))
                bar.set_postfix(iterations=states[-1].iterations, plastic_strain=f"{strain:.3g}")
    monitor.warn_of_run(states, engine.estimate, stacklevel=3)
