# SPDX-License-Identifier: GPL-3.0-or-later
"""Increments of paths with retractions; the number of increments depends on the solution."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from .._util.checks import require_type, step_list
from ..paths.pull_off import Retraction, require_speed, retraction_increments
from .steps import STEP_ARGUMENTS

if TYPE_CHECKING:
    from ..solutions.state import State
    from .engine import Engine

_STEP_PER_LENGTH = 0.25
"""Default step of a retraction, divided by the ratio of work of adhesion to peak attraction."""

Path = Sequence[Mapping[str, Any]]


def run_list(name: str, path: Any) -> list[dict[str, Any]]:
    """Return a path as a list of dictionaries, after checking their keys.

    Raises TypeError or ValueError for an invalid path.
    """
    retractions: dict[int, dict[str, Any]] = {}

    def steps() -> Iterator[Any]:
        """Iterate over the steps; replace each retraction by a plain step, and store it."""
        for n, step in enumerate(path):
            if not isinstance(step, Mapping) or "pull_off" not in step:
                yield step
                continue
            if len(step) > 1:
                others = ", ".join(str(key) for key in step if key != "pull_off")
                raise ValueError(
                    f"increment {n + 1} of {name}: pull_off cannot be combined with {others}"
                )
            require_type(f"pull_off of increment {n + 1} of {name}", step["pull_off"], Retraction)
            retractions[n] = dict(step)
            yield {"approach": 0.0}

    several = isinstance(path, Iterable) and not isinstance(path, (Mapping, str, bytes))
    several = several and getattr(path, "ndim", 1) > 0
    found = step_list(name, steps() if several else path, STEP_ARGUMENTS)
    for n, step in retractions.items():
        found[n] = step
    return found


def unfolded(
    path: Path, engine: Engine, current: Callable[[], State]
) -> Iterator[Mapping[str, Any]]:
    """Iterate over the arguments of increments; each must be solved before the next is requested.

    current: function that returns the state after the increments so far. Raises ValueError without
    adhesion, or if a retraction does not separate the surfaces.
    """
    for step in path:
        retraction = step.get("pull_off")
        if retraction is None:
            yield step
        else:
            length = _step_of(retraction, engine)
            yield from retraction_increments(
                retraction, current, length, engine.setup.settings.stiffness
            )


def solved_path(path: Path, engine: Engine, states: Sequence[State]) -> list[Mapping[str, Any]]:
    """Return the arguments of those increments of a path whose states a run has returned.

    Raises ValueError if the path begins with a retraction, because its initial state is unknown.
    """
    if path and "pull_off" in path[0]:
        raise ValueError("path must begin with increments that make contact, got pull_off first")
    found: list[Mapping[str, Any]] = []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # they were issued by the run
        for step in unfolded(path, engine, lambda: states[len(found) - 1]):
            if len(found) == len(states):  # the run ended early
                break
            found.append(step)
    return found


def largest_count(path: Path) -> int:
    """Return the largest number of increments of a path."""
    return sum(1 if (given := step.get("pull_off")) is None else given.max_steps for step in path)


def count_text(path: Path) -> str:
    """Return the number of increments of a path as text, e.g. "40" or "at most 440"."""
    is_open = any("pull_off" in step for step in path)
    return f"{'at most ' if is_open else ''}{largest_count(path)}"


def _step_of(retraction: Retraction, engine: Engine) -> float:
    """Return the step of a retraction [m]; ValueError if it is unknown, or without adhesion."""
    law = engine.setup.resolved_adhesion(engine.domain.grid)
    if not law.attracts:
        raise ValueError(
            f"pull_off requires adhesion, got adhesion = {engine.setup.adhesion!r}: without "
            "attraction, the largest tension is 0"
        )
    require_speed(retraction, engine.setup.needs_duration)
    if retraction.step is not None:
        return retraction.step
    if not law.varies:
        raise ValueError(
            f"step of pull_off is required with adhesion = {law!r}, whose attraction has no range "
            "from which a default could follow: give the step [m]"
        )
    core = law.to_core()
    return float(_STEP_PER_LENGTH * core.work / core.largest_attraction)
