# SPDX-License-Identifier: GPL-3.0-or-later
"""The increments of a run, one after the other: log, progress and checkpoints."""

from __future__ import annotations

import logging
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Protocol, cast

from .._util.checks import boolean, step_list
from .._util.progress import progress_bar
from ..solutions.state import State, in_one_window
from .domain import Windowed
from .increment_errors import History, warn_of
from .journal import Resumed, journal_of
from .steps import STEP, largest_cold_load, largest_target

if TYPE_CHECKING:
    from .simulation import Simulation

_logger = logging.getLogger("samcontact")


class Stepped(Resumed, Protocol):
    """A simulation, as far as a run knows it."""

    @property
    def step(self) -> Callable[..., State]: ...


def _log(state: State, number: int, count: int) -> None:
    """One increment of a run."""
    if not _logger.isEnabledFor(logging.INFO):
        return
    _logger.info(
        "increment %d of %d: load %.6g N, approach %.6g m, largest pressure %.6g Pa",
        number, count, state.load, state.approach, state.pressure.max(),
    )  # fmt: skip
    _logger.debug(
        "increment %d: %d plastic and %d contact iterations in %d parts, residual %.2g",
        number, state.iterations, state.contact_iterations, state.substeps, state.plastic_residual,
    )  # fmt: skip


def run_into(
    states: list[State],
    simulation: Stepped,
    steps: Sequence[Mapping[str, Any]],
    progress: bool,
    checkpoint: str | os.PathLike[str] | None,
    *,
    leave: bool,
) -> None:
    """Append the state of each increment as soon as it is done; leave: the progress when it is."""
    with (
        journal_of(checkpoint, simulation, path=steps) as journal,
        progress_bar(len(steps), "increment", shown=progress, leave=leave) as bar,
    ):
        for arguments in steps:
            state = journal.next() if journal else None
            kept = state is not None
            try:
                states.append(simulation.step(**arguments) if state is None else state)
            except Warning:  # made an error by a filter: the increment is done
                states.append(simulation.state)
                raise
            finally:
                if journal and not kept and len(states) > journal.count:
                    journal.add()
            _log(states[-1], len(states), len(steps))
            bar.update()
            if progress:
                strain = max(map(states[-1].max_equivalent_plastic_strain, (1, 2)))
                bar.set_postfix(iterations=states[-1].iterations, plastic_strain=f"{strain:.3g}")


class Running(Windowed):
    """Runs along paths."""

    step: Any
    counters: Any
    residual_stress: str
    _history: History

    def run(
        self,
        path: Iterable[Mapping[str, Any]],
        *,
        progress: bool = True,
        checkpoint: str | os.PathLike[str] | None = None,
    ) -> list[State]:
        """Run a list of step() arguments, e.g. ``[{"load": 300.0}, {"load": 0.0}]``.

        Parameters
        ----------
        path : iterable of dict
            See `samcontact.paths` for helpers.
        progress : bool, optional
            Show a progress bar; where there is no terminal, ten lines at most.
        checkpoint : path, optional
            Folder in which to keep each increment. The same call of a new simulation goes on from
            it, with the same bits. Remove it when it is no longer needed.

        Returns
        -------
        list of State
            One per increment. When an increment fails or is interrupted (Ctrl-C), the error is
            raised with those before it in the attribute `states`, and the simulation stands at the
            last good one. The logger "samcontact" tells each (INFO) and its iterations (DEBUG).

        Raises
        ------
        ValueError
            `checkpoint` holds those of another run or of another version of this package, or a
            softening law has no identity (see `Material.with_softening`); and as `step`. A contact
            that does not fit into the grid by far is refused before the first increment.

        Warns
        -----
        UnitWarning, ResolutionWarning
            Before the first increment; at the end, of the largest load: a contact fewer than 8
            cells across, an area of spots uncertain by 10 %, a plastic zone fewer than 8 layers
            high or layers too thick to see.
        IncrementWarning
            At the end, once in a simulation: more increments would change pressure, shear or
            equivalent plastic strain by more than 5 % of the largest. The path since the start is
            solved again with half as many increments, or twice as many where neighbours do not go
            on in the same direction, on cells twice, four or eight times as large where 6 (without
            flow 16) stay across the contact. Skipped where increments have no part: of bodies that
            do not yield, or under control of `increment_tol`, unless they stick and slip; and where
            the past is not known (prescribed tractions, `set_plastic_strain`, checkpoints), or
            where the warning is ignored (`warnings.simplefilter("ignore", sc.IncrementWarning)`).
        """
        boolean("progress", progress)
        states: list[State] = []
        try:
            self._run_into(states, step_list("path", path, STEP), progress, checkpoint)
            warn_of(cast("Simulation", self), in_one_window(states), 2, stacklevel=2)
        except BaseException as error:  # Ctrl-C too
            error.states = states  # type: ignore[attr-defined]
            raise
        return in_one_window(states)

    def _run_into(
        self,
        states: list[State],
        steps: Sequence[Mapping[str, Any]],
        progress: bool,
        checkpoint: str | os.PathLike[str] | None,
        *,
        leave: bool = True,
    ) -> None:
        """Append the state of each increment as soon as it is done."""
        self._told.doubt(self._scene, self._heat, largest_target(steps), stacklevel=3)
        if not any(self._heat.shares) and (load := largest_cold_load(steps)) is not None:
            self._make_room(load)
        with self._told.as_a_whole():
            run_into(states, self, steps, progress, checkpoint, leave=leave)
        self._told.warn_of_run(states, self._scene, stacklevel=3)
