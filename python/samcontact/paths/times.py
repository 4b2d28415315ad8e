# SPDX-License-Identifier: GPL-3.0-or-later
"""Paths over time for viscoelastic bodies: creep, stress relaxation, oscillation."""

from __future__ import annotations

import math

import numpy as np

from .._util.checks import choice, finite, non_negative, positive, step_count
from .ramps import Path, growing_durations

_DECADES = 6
"""Decades of time covered if the first time is not given."""
_MAX_DECADES = 40


def creep(load: float, until: float, per_decade: int = 8, first: float | None = None) -> Path:
    """Apply a load at once and hold it, in steps of increasing duration.

    Parameters
    ----------
    load : float
        Constant load [N], >= 0.
    until : float
        Time at the end [s], > 0.
    per_decade : int
        Number of steps per decade of time.
    first : float, optional
        Duration of the first step after loading [s], shorter than `until`. At most a tenth of the
        shortest relaxation time keeps the error of the first steps small. Default: 1e-6 times
        `until`.

    Returns
    -------
    list of dict
        Steps for `Simulation.run`: an elastic step (duration 0), then steps whose times since
        loading form a geometric sequence. Over many decades, the error is of first order in the
        logarithmic step. With 8 steps per decade, the error is below 1 % if the long-time modulus
        is 10 % of the instantaneous modulus, and 2.5 % if it is 0.1 %.

    Raises
    ------
    ValueError
        A value is outside its range.
    """
    return _held("load", non_negative("load", load), until, per_decade, first)


def stress_relaxation(
    approach: float, until: float, per_decade: int = 8, first: float | None = None
) -> Path:
    """Apply an approach at once and hold it, in steps of increasing duration.

    approach: constant approach [m]. Other arguments, result and errors as for `creep`.
    """
    return _held("approach", finite("approach", approach), until, per_decade, first)


def oscillation(
    mean: float,
    amplitude: float,
    frequency: float,
    periods: int,
    increments: int = 40,
    quantity: str = "load",
) -> Path:
    """Vary load or approach as mean + amplitude sin(2 pi frequency t), starting at the mean.

    Parameters
    ----------
    mean, amplitude : float
        Mean and amplitude > 0 of the load [N] or approach [m]. The load stays >= 0.
    frequency : float
        Frequency [Hz], > 0.
    periods : int
        Number of periods. The loop becomes steady after about the longest relaxation time, or from
        the beginning if the bodies are relaxed at the mean load first: ``sim.step(load=mean,
        duration=0.0)``, then ``sim.relax()``.
    increments : int
        Number of steps per period, >= 4. The error of the loss angle is of second order in the
        duration of a step.
    quantity : {"load", "approach"}

    Returns
    -------
    list of dict
        Steps for `Simulation.run`.

    Raises
    ------
    ValueError
        A value is outside its range.
    """
    name = choice("quantity", quantity, ("load", "approach"))
    middle, swing = finite("mean", mean), positive("amplitude", amplitude)
    if name == "load" and middle < swing:
        raise ValueError(
            f"amplitude must be <= mean ({middle!r} N) for a load >= 0, got {swing!r} N"
        )
    count, each = step_count("periods", periods), step_count("increments", increments)
    if each < 4:
        raise ValueError(f"increments must be >= 4 per period, got {each}")
    total = step_count("periods * increments", count * each)
    duration = 1.0 / (positive("frequency", frequency) * each)
    angles = 2.0 * math.pi * (np.arange(1, total + 1) % each) / each
    values = middle + swing * np.sin(angles)
    values[each - 1 :: each] = middle  # exact at the end of each period
    return [{name: float(value), "duration": duration} for value in values]


def _held(name: str, value: float, until: float, per_decade: int, first: float | None) -> Path:
    end = positive("until", until)
    start = positive("first", end * 10.0**-_DECADES if first is None else first)
    if not start < end:
        raise ValueError(f"first must be < until ({end!r} s), got {start!r} s")
    decades = math.log10(end / start)
    if decades > _MAX_DECADES:
        raise ValueError(
            f"first must be within {_MAX_DECADES} decades of until ({end!r} s), got {start!r} s"
        )
    steps = math.ceil(step_count("per_decade", per_decade) * decades * (1 - 1e-12)) + 1
    count = step_count("steps of all decades", steps)
    durations = [0.0, *growing_durations(end, start, count).tolist()]
    return [{name: value, "duration": duration} for duration in durations]
