# SPDX-License-Identifier: GPL-3.0-or-later
"""Paths of increasing, decreasing and constant load or approach."""

from __future__ import annotations

from collections.abc import Container, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import (
    FloatArray,
    choice,
    exactly_one,
    finite,
    load_or_approach,
    non_negative,
    number,
    positive,
    step_count,
    value_per_body,
)
from .._util.travels import both_axes, plain

Path = list[dict[str, Any]]


def fractions(increments: int, spacing: str, exponent: float) -> FloatArray:
    """Return the fractions of a ramp that are reached after each step; the last is exactly 1."""
    choice("spacing", spacing, ("linear", "power"))
    count = step_count("increments", increments)
    parts = np.arange(1, count + 1, dtype=np.float64) / count
    if spacing == "power":
        parts = parts ** positive("exponent", exponent)
    return parts


def start_unit(targets: Container[str]) -> str:
    """Return the unit of `start` of a ramp: N if the target is a load, m if it is an approach."""
    return "N" if "load" in targets else "m"


def _steps(name: str, start: float, end: float, parts: FloatArray) -> Path:
    values = start * (1.0 - parts) + end * parts
    return [{name: float(value)} for value in values]


def _with_parts(
    steps: Path,
    advance: ArrayLike | None,
    duration: float | None,
    heat_factor: float | Sequence[float] | None,
    first_duration: float | None = None,
) -> Path:
    """Divide travel and duration among steps, and add the heat factor to the first step."""
    if advance is not None:
        each = plain(both_axes(advance) / len(steps))
        steps = [{**step, "advance": each} for step in steps]
    if first_duration is not None:
        total = positive("duration", number("duration", duration))
        parts = _growing("first_duration", first_duration, total, len(steps))
        steps = [{**step, "duration": part} for step, part in zip(steps, parts, strict=True)]
    elif duration is not None:
        part = non_negative("duration", duration) / len(steps)
        steps = [{**step, "duration": part} for step in steps]
    if heat_factor is not None:
        value_per_body("heat_factor", heat_factor)
        steps[0] = {**steps[0], "heat_factor": heat_factor}
    return steps


def _growing(name: str, first: float, total: float, count: int) -> list[float]:
    start = positive(name, first)
    if not (start < total and count > 1):
        raise ValueError(
            f"{name} must be < duration ({total!r} s), with increments >= 2, got {start!r} s and "
            f"{count} increments"
        )
    durations: list[float] = growing_durations(total, start, count).tolist()
    return durations


def growing_durations(total: float, first: float, count: int) -> FloatArray:
    """Return durations [s] whose running sums form a geometric sequence from `first` to `total`."""
    times = np.geomspace(first, total, count)
    return np.diff(times, prepend=0.0)


def hold(
    *,
    load: float | None = None,
    approach: float | None = None,
    increments: int = 1,
    advance: ArrayLike | None = None,
    duration: float | None = None,
    heat_factor: float | Sequence[float] | None = None,
    first_duration: float | None = None,
) -> Path:
    """Hold load or approach constant while the bodies move, creep or relax, or heat flows.

    Parameters
    ----------
    load, approach : float
        Constant load [N], >= 0, or approach [m]. Exactly one must be given.
    increments : int
        Number of steps, from 1 to 100000.
    advance : pair of floats, or pair of pairs, optional
        Total displacement of the surfaces of bodies 1 and 2 along +x in all steps [m], or along x
        and y, see `Simulation.step`.
    duration : float, optional
        Total duration of all steps [s], for a simulation with heat.history or a viscoelastic body
        (0: elastic steps).
    heat_factor : float or pair of floats, optional
        Heat flux per unit pressure from the first step on [m/s]; 0 switches the source off.
    first_duration : float, optional
        Duration of the first step [s]; the times since the start of the path then form a geometric
        sequence, which suits creep over several decades of time. Default: equal durations.

    Returns
    -------
    list of dict
        Steps for `Simulation.run`.

    Raises
    ------
    ValueError
        Both or neither of load and approach are given, or a value is outside its range.
    """
    name, value = load_or_approach(load, approach)
    count = step_count("increments", increments)
    steps: Path = [{name: value} for _ in range(count)]
    return _with_parts(steps, advance, duration, heat_factor, first_duration)


def ramp(
    *,
    load: float | None = None,
    approach: float | None = None,
    increments: int = 10,
    start: float = 0.0,
    spacing: str = "linear",
    exponent: float = 2.0,
    advance: ArrayLike | None = None,
    duration: float | None = None,
    heat_factor: float | Sequence[float] | None = None,
) -> Path:
    """Change load or approach from `start` to a target, which the last step reaches exactly.

    Parameters
    ----------
    load, approach : float
        Target load [N] (< 0 only with attraction) or approach [m]. Exactly one must be given.
    increments : int
        Number of steps, from 1 to 100000.
    start : float
        Load [N] or approach [m] before the first step.
    spacing : {"linear", "power"}
        "power" uses fractions (i/increments)^exponent: small steps first for exponent > 1.
    exponent : float
        Exponent of the power spacing, > 0 [-].
    advance, duration, heat_factor : optional
        As in `hold`.

    Returns
    -------
    list of dict
        Steps for `Simulation.run`, e.g. ``[{"load": 100.0}, {"load": 200.0}]``.

    Raises
    ------
    ValueError
        Both or neither of load and approach are given, or a value is outside its range.

    Examples
    --------
    >>> ramp(load=300.0, increments=3)
    [{'load': 100.0}, {'load': 200.0}, {'load': 300.0}]
    """
    name = exactly_one(load=load, approach=approach)
    end, begin = finite(name, load if approach is None else approach), finite("start", start)
    if begin == end:
        raise ValueError(f"start must differ from {name}, got {begin!r} for both")
    steps = _steps(name, begin, end, fractions(increments, spacing, exponent))
    return _with_parts(steps, advance, duration, heat_factor)


def load_unload(
    *,
    load: float | None = None,
    approach: float | None = None,
    increments: int = 10,
    unload_increments: int | None = None,
    end: float = 0.0,
    spacing: str = "linear",
    exponent: float = 2.0,
) -> Path:
    """Increase load or approach from zero to a maximum, then decrease it to `end`.

    Parameters
    ----------
    load, approach : float
        Maximum load [N] or approach [m]. Exactly one must be given.
    increments, unload_increments : int
        Numbers of loading and unloading steps, from 1 to 100000. Default of `unload_increments`:
        `increments`.
    end : float
        Load [N] or approach [m] of the last step, below the maximum; a load < 0 only with
        attraction.
    spacing, exponent
        As in `ramp`. Unloading mirrors loading, so that the small steps are near zero load.

    Returns
    -------
    list of dict
        Steps for `Simulation.run`.

    Raises
    ------
    ValueError
        Both or neither of load and approach are given, or a value is outside its range.
    """
    name, peak = load_or_approach(load, approach)
    last = finite("end", end)
    if not peak > max(last, 0.0):
        raise ValueError(f"{name} must be > {max(last, 0.0)!r}, got {peak!r}")
    up = fractions(increments, spacing, exponent)
    count = increments if unload_increments is None else unload_increments
    step_count("unload_increments", count)
    mirrored = np.append(fractions(count, spacing, exponent)[::-1][1:], 0.0)
    return _steps(name, 0.0, peak, up) + _steps(name, last, peak, mirrored)
