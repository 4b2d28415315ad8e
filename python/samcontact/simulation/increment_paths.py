# SPDX-License-Identifier: GPL-3.0-or-later
"""Paths with twice and with half as many increments."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from .._util.checks import FloatArray
from .._util.travels import AT_REST, both_axes, plain

if TYPE_CHECKING:
    from ..heat import Heat
    from ..solutions.state import State

Step = Mapping[str, Any]
Sizes = tuple[float, float | None]
"""Cell sizes along x and y [m]; None for y if bodies may move along y by fractions of a cell."""
Ends = list[tuple[int, int]]
"""Pairs of indices (from 0) of increments in two paths that end at equal targets."""
_TARGETS = ("load", "approach", "torque")
_PAIRS = ("tangential_load", "moment", "tilt")
"""Targets with two components, along or about x and y; each component may be None."""
_MOTIONS = ("twist", "duration")
_MAX_SIZE_RATIO = 3.0
_MAX_REMAINING_FRACTION = 0.65
"""Maximum fraction of increments that may remain after merging."""


def _is_by_cells(changes: FloatArray, sizes: Sizes) -> bool:
    """Whether displacements [body][axis] are multiples of the cell sizes where they must be."""
    if sizes[1] is None and changes[:, 1].any():  # bodies without a history
        return True
    return are_multiples(changes, sizes)


def are_multiples(changes: FloatArray, sizes: Sizes) -> bool:
    """Whether displacements [body][axis] are multiples of the cell sizes.

    If sizes[1] is None, only the displacements along x are checked.
    """
    axes = 1 if sizes[1] is None else 2
    cells = changes[:, :axes] / np.array(sizes[:axes])
    return bool(np.allclose(cells, np.round(cells), atol=1e-6))


def cleaned(step: Step) -> dict[str, Any]:
    """Return the arguments of a step without those that are None and without an advance of zero."""
    kept = dict(step)
    for name, value in step.items():
        if name == "advance" and value is not None and value is not AT_REST:
            kept[name] = plain(both_axes(value))
        if value is None or (name == "advance" and kept[name] == AT_REST):
            del kept[name]
    return kept


def doubled(
    path: Sequence[Step], states: Sequence[State], start: float, sizes: Sizes, heat: Heat
) -> tuple[list[dict[str, Any]], Ends]:
    """Split each increment into two halves, if motion and heating allow it.

    An increment is not split if the bodies would move by a fraction of a cell in each half, or if a
    half would be shorter than the heat history allows.

    start: approach at first contact [m].
    """
    steps: list[dict[str, Any]] = []
    ends = []
    for number, step in enumerate(path):
        steps += _halves(step, _before(number, path, states, start), sizes, heat)
        ends.append((number, len(steps) - 1))
    return steps, ends


def halved(
    path: Sequence[Step], states: Sequence[State], start: float
) -> tuple[list[dict[str, Any]], Ends] | None:
    """Merge neighbouring increments that continue in one direction; keep all other increments.

    Return None if a comparison would not be meaningful: only few increments can be merged, or an
    unmerged increment is larger than all merged increments.
    """
    steps: list[dict[str, Any]] = []
    ends: Ends = []
    sizes: dict[bool, dict[str, float]] = {True: {}, False: {}}
    number = 0
    while number < len(path):
        step = path[number]
        before = _before(number, path, states, start)
        joins = number + 1 < len(path) and _continues(before, step, path[number + 1])
        if joins:
            step = _merged(step, path[number + 1])
            number += 1
        for name, size in _sizes(before, step).items():
            sizes[joins][name] = max(size, sizes[joins].get(name, 0.0))
        steps.append(dict(step))
        ends.append((number, len(steps) - 1))
        number += 1
    larger = any(size > sizes[True].get(name, 0.0) for name, size in sizes[False].items())
    return None if larger or len(steps) > _MAX_REMAINING_FRACTION * len(path) else (steps, ends)


def _sizes(before: Step, step: Step) -> dict[str, float]:
    """Return the magnitude of the change of each load and motion in an increment."""
    found = {name: abs(step[name] - before[name]) for name in _TARGETS if name in step}
    if "twist" in step:
        found["twist"] = abs(step["twist"])
    if "advance" in step:
        found["advance"] = float(abs(both_axes(step["advance"])).max())
    for name in (*_PAIRS, "shift"):
        if name in step:
            starts = before[name] if name in _PAIRS else (0.0, 0.0)
            changes = [0.0 if q is None else q - p for p, q in zip(starts, step[name], strict=True)]
            found[name] = max(map(abs, changes))
    return found


def _before(
    number: int, path: Sequence[Step], states: Sequence[State], start: float
) -> dict[str, Any]:
    """Return load, approach and other targets before an increment, prescribed or computed."""
    if number == 0:
        pairs = dict.fromkeys(_PAIRS, (0.0, 0.0))
        return {"load": 0.0, "approach": start, "torque": 0.0, **pairs}
    step, state = path[number - 1], states[number - 1]
    approach = state.approach if state.load > 0 else start
    found: dict[str, Any] = {"load": state.load, "approach": approach, "torque": state.torque}
    forces = zip(step.get("tangential_load", (None, None)), state.tangential_load, strict=True)
    rounding = 1e-9 * state.load
    held = ((given, q if abs(q) > rounding else 0.0) for given, q in forces)
    found["tangential_load"] = tuple(q if given is None else given for given, q in held)
    for name in {"moment", "tilt"} & path[number].keys():
        reached = zip(step.get(name, (None, None)), getattr(state, name), strict=True)
        found[name] = tuple(float(q) if given is None else given for given, q in reached)
    return found | {name: step[name] for name in _TARGETS if name in step}


def _halves(step: Step, before: Step, sizes: Sizes, heat: Heat) -> list[dict[str, Any]]:
    first, second = dict(step), dict(step)
    if "advance" in step:
        changes = 0.5 * both_axes(step["advance"])
        if not _is_by_cells(changes, sizes):
            return [first]
        first["advance"] = second["advance"] = plain(changes)
    if heat.history is not None and 0.5 * step["duration"] < heat.history[0]:
        return [first]
    for name in _TARGETS:
        if name in step:
            first[name] = 0.5 * (before[name] + step[name])
    for name in _MOTIONS:
        if name in step:
            first[name] = second[name] = 0.5 * step[name]
    for name in _PAIRS:
        if name in step:
            first[name] = tuple(
                None if q is None else 0.5 * (p + q)
                for p, q in zip(before[name], step[name], strict=True)
            )
    if "shift" in step:
        first["shift"] = second["shift"] = tuple(
            None if s is None else 0.5 * s for s in step["shift"]
        )
    return [first, second]


def _continues(before: Step, step: Step, after: Step) -> bool:
    """Whether two successive increments change all loads and motions in one direction."""
    if step.keys() != after.keys():
        return False
    changes = [(before[name], step[name], after[name]) for name in _TARGETS if name in step]
    for name in _PAIRS:
        if name in step:
            changes += zip(before[name], step[name], after[name], strict=True)
    changes += [(0.0, step[n], step[n] + after[n]) for n in ("twist",) if n in step]
    motions = [
        pair for name in ("shift", "advance") if name in step for pair in _pairs(name, step, after)
    ]
    changes += [(0.0, s, None if s is None or t is None else s + t) for s, t in motions]
    same_heat = step.get("heat_factor") == after.get("heat_factor")
    return same_heat and all(_is_monotonic(*change) for change in changes)


def _pairs(name: str, step: Step, after: Step) -> list[tuple[float | None, float | None]]:
    """Return, for each component of a motion, its values in two increments."""
    if name == "shift":
        return list(zip(step[name], after[name], strict=True))
    one, other = (both_axes(each[name]).ravel().tolist() for each in (step, after))
    return list(zip(one, other, strict=True))


def _is_monotonic(a: float, b: float | None, c: float | None) -> bool:
    """Whether the changes from a to b and from b to c have equal signs and similar magnitudes."""
    if b is None or c is None:
        return b is None and c is None
    return a == b == c or (b != a and 1 / _MAX_SIZE_RATIO <= (c - b) / (b - a) <= _MAX_SIZE_RATIO)


def _merged(step: Step, after: Step) -> dict[str, Any]:
    merged = dict(after)
    for name in _MOTIONS:
        if name in step:
            merged[name] = step[name] + after[name]
    if "shift" in step:
        merged["shift"] = tuple(
            None if s is None else s + t for s, t in zip(step["shift"], after["shift"], strict=True)
        )
    if "advance" in step:
        merged["advance"] = plain(both_axes(step["advance"]) + both_axes(after["advance"]))
    return merged
