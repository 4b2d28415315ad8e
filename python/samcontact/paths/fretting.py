# SPDX-License-Identifier: GPL-3.0-or-later
"""Paths of tangential forces and displacements in contacts with partial slip."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, finite_array, load_or_approach, non_negative, step_count
from .._util.short_text import in_short
from .ramps import Path


def tangential(
    *,
    load: float | None = None,
    approach: float | None = None,
    force: Sequence[float] | None = None,
    shift: Sequence[float] | None = None,
    start: Sequence[float] = (0.0, 0.0),
    increments: int = 10,
) -> Path:
    """Increase a tangential force or displacement in equal steps under constant load or approach.

    Parameters
    ----------
    load, approach : float
        Constant load [N], >= 0, or approach [m]. Exactly one must be given.
    force : pair of float
        Force on body 2 at the end, along x and y [N]. Cannot be combined with `shift`.
    shift : pair of float
        Total tangential rigid-body displacement of body 1 relative to body 2, along x and y [m].
        Cannot be combined with `force`.
    start : pair of float
        Force before the first step [N]; only with `force`.
    increments : int
        Number of steps, from 1 to 100000.

    Returns
    -------
    list of dict
        Steps for `Simulation.run` with ``friction=samcontact.Coulomb(mu)``.

    Raises
    ------
    ValueError
        Both or neither of load and approach, or of force and shift, are given; or a value is
        outside its range.

    Examples
    --------
    >>> tangential(load=100.0, force=(20.0, 0.0), increments=2)[0]
    {'load': 100.0, 'tangential_load': (10.0, 0.0)}
    """
    name, end = _force_or_shift(force, shift)
    count = step_count("increments", increments)
    if name == "shift":
        if np.any(finite_array("start", start, (2,))):
            raise ValueError(
                f"start must be 0 if shift is given, got {in_short(start)}: start is a force"
            )
        return _to(_pressed(load, approach), name, [end / count] * count)
    first = finite_array("start", start, (2,))
    fractions = np.arange(1, count + 1)[:, None] / count
    return _to(_pressed(load, approach), name, first + fractions * (end - first))


def fretting_loop(
    *,
    load: float | None = None,
    approach: float | None = None,
    force: Sequence[float] | None = None,
    shift: Sequence[float] | None = None,
    cycles: int = 1,
    increments: int = 10,
) -> Path:
    """Cycle a tangential force or displacement under constant load or approach.

    The path first increases from 0 to the amplitude. Each cycle then goes to the opposite amplitude
    and back.

    Parameters
    ----------
    load, approach : float
        Constant load [N], >= 0, or approach [m]. Exactly one must be given.
    force : pair of float
        Amplitude of the force on body 2 along x and y [N]. Cannot be combined with `shift`.
    shift : pair of float
        Amplitude of the tangential rigid-body displacement of body 1 relative to body 2, along x
        and y [m]. Cannot be combined with `force`.
    cycles : int
        Number of cycles, from 1 to 100000.
    increments : int
        Number of steps from 0 to the amplitude; a cycle has four times as many steps.

    Returns
    -------
    list of dict
        Steps for `Simulation.run` with ``friction=samcontact.Coulomb(mu)``.

    Raises
    ------
    ValueError
        Both or neither of load and approach, or of force and shift, are given; or a value is
        outside its range.
    """
    name, amplitude = _force_or_shift(force, shift)
    quarter, count = step_count("increments", increments), step_count("cycles", cycles)
    up = np.arange(1, quarter + 1) / quarter
    cycle = np.concatenate([1 - up, -up, up - 1, up])
    share = np.concatenate([up, np.tile(cycle, count)])
    if name == "shift":
        share = np.diff(share, prepend=0.0)
    return _to(_pressed(load, approach), name, share[:, None] * amplitude)


def _pressed(load: float | None, approach: float | None) -> dict[str, Any]:
    name, value = load_or_approach(load, approach)
    return {name: non_negative("load", value) if name == "load" else value}


def _force_or_shift(
    force: Sequence[float] | None, shift: Sequence[float] | None
) -> tuple[str, FloatArray]:
    """Return the name of the step argument (force or displacement), and its x and y values."""
    if force is not None and shift is None:
        return "tangential_load", finite_array("force", force, (2,))
    if shift is not None and force is None:
        return "shift", finite_array("shift", shift, (2,))
    raise ValueError(
        f"exactly one of force and shift must be given, got force={in_short(force)} and "
        f"shift={in_short(shift)}"
    )


def _to(pressed: dict[str, Any], name: str, pairs: ArrayLike) -> Path:
    return [{**pressed, name: (float(x), float(y))} for x, y in np.asarray(pairs)]
