# SPDX-License-Identifier: GPL-3.0-or-later
"""Paths of rolling and sliding passes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from .._util.checks import (
    MAX_INCREMENTS_OF_PATH,
    boolean,
    choice,
    finite,
    load_or_approach,
    non_negative,
    number,
    positive,
    step_count,
    value_per_body,
)

Steps = list[dict[str, Any]]

# Fraction of a step below which the rest of a distance is a rounding error, not a further step.
_ROUNDING_ERROR = 1e-9


@dataclass(frozen=True)
class CreepageInput:
    """Lateral creepage [-], spin [1/m] and longitudinal force [N] of a rolling contact."""

    lateral: float = 0.0
    spin: float = 0.0
    force_x: float | None = None

    def over(self, length: float) -> dict[str, Any]:
        """Return the tangential arguments of a step in which the contact travels `length` [m]."""
        given: dict[str, Any] = {}
        if self.lateral != 0.0:
            given["shift"] = (None if self.force_x is not None else 0.0, self.lateral * length)
        if self.spin != 0.0:
            given["twist"] = self.spin * length
        if self.force_x is not None:
            given["tangential_load"] = (self.force_x, None)
        return given


@dataclass(frozen=True)
class RollingPasses:
    """One or more passes over a track; see `paths.rolling` for the arguments.

    `shares`: displacement of bodies 1 and 2 towards -x per distance travelled by the contact.
    """

    quantity: str
    value: float
    distance: float
    step: float
    passes: int
    increments: int
    unload_increments: int | None
    shares: tuple[float, float]
    back_and_forth: bool
    speed: float | None
    heat_factor: float | Sequence[float] | None
    creep: CreepageInput
    return_time: float | None

    def steps(self) -> Steps:
        lengths = _lengths(self.distance, self.step)
        count = step_count("passes", self.passes)
        if not self.value > 0.0:
            raise ValueError(f"{self.quantity} must be > 0, got {self.value!r}")
        up = step_count("increments", self.increments)
        down = up
        if self.unload_increments is not None:
            down = step_count("unload_increments", self.unload_increments)
        step_count("number of increments of all passes", count * (len(lengths) + up + down + 1))
        self._require_speed()
        loading = [self._still(self.value * ((i + 1) / up)) for i in range(up)]
        # load = 0, not approach = 0: a hot or flattened surface may touch at approach 0
        unloading = [self._still(self.value * ((down - i) / down)) for i in range(1, down)]
        unloading.append(self._timed({"load": 0.0}, self.step))

        steps: Steps = []
        if boolean("back_and_forth", self.back_and_forth):
            steps += loading
            for number in range(count):
                sign = 1.0 if number % 2 == 0 else -1.0
                steps += [self._moved(sign * length) for length in lengths]
            steps += unloading
        else:
            back = -math.fsum(lengths)
            for number in range(count):
                if number > 0:
                    steps.append(self._returned(back))
                steps += [*loading, *map(self._moved, lengths), *unloading]
        if self.heat_factor is not None:
            value_per_body("heat_factor", self.heat_factor)
            steps[0] = {**steps[0], "heat_factor": self.heat_factor}
        return [dict(step) for step in steps]

    def _advance(self, length: float) -> tuple[float, float]:
        first, second = self.shares
        return 0.0 - first * length, 0.0 - second * length  # 0.0 - 0.0 avoids minus zero

    def _moved(self, length: float) -> dict[str, Any]:
        step = {self.quantity: self.value, "advance": self._advance(length)}
        return self._timed(step | self.creep.over(length), length)

    def _still(self, value: float) -> dict[str, Any]:
        return self._timed({self.quantity: value}, self.step)

    def _returned(self, length: float) -> dict[str, Any]:
        """Create the step in which the unloaded bodies move back to the start."""
        step: dict[str, Any] = {"load": 0.0, "advance": self._advance(length)}
        if self.return_time is None:
            return self._timed(step, length)
        return step | {"duration": self.return_time}

    def _require_speed(self) -> None:
        """Raise ValueError if `return_time` is invalid, or is given without `speed`."""
        if self.return_time is None:
            return
        non_negative("return_time", self.return_time)
        if self.speed is None:
            raise ValueError(
                f"return_time requires speed, got {self.return_time!r}: set speed, or omit "
                "return_time"
            )

    def _timed(self, step: dict[str, Any], length: float) -> dict[str, Any]:
        """Return a step with the duration in which the contact travels `length` [m]."""
        if self.speed is not None:
            step["duration"] = abs(length) / positive("speed", self.speed)
        return step


def _lengths(distance: float, step: float) -> list[float]:
    """Divide a signed distance [m] into full steps and a remainder with the same sign."""
    total, whole = finite("distance", distance), positive("step", step)
    if total == 0.0:
        raise ValueError("distance must not be 0")
    if whole > abs(total) * (1.0 + _ROUNDING_ERROR):
        raise ValueError(f"step must be <= the distance, {abs(total)!r}, got {whole!r}")
    if abs(total) > MAX_INCREMENTS_OF_PATH * whole:
        raise ValueError(
            f"step must be >= distance/{MAX_INCREMENTS_OF_PATH} = "
            f"{abs(total) / MAX_INCREMENTS_OF_PATH!r}, got {whole!r}"
        )
    count = math.floor(abs(total) / whole + _ROUNDING_ERROR)
    rest = abs(total) - count * whole
    lengths = [math.copysign(whole, total)] * count
    if rest > _ROUNDING_ERROR * whole:
        lengths.append(math.copysign(rest, total))
    return lengths


def rolling(
    *,
    load: float | None = None,
    approach: float | None = None,
    distance: float,
    step: float,
    passes: int = 1,
    increments: int = 10,
    unload_increments: int | None = None,
    slide_to_roll: float = 0.0,
    lateral_creepage: float = 0.0,
    spin: float = 0.0,
    tangential_load_x: float | None = None,
    back_and_forth: bool = False,
    speed: float | None = None,
    heat_factor: float | Sequence[float] | None = None,
    return_time: float | None = None,
) -> Steps:
    """Load, roll over both bodies and unload, once per pass.

    Each pass starts at the initial position. The path begins and ends unloaded. After the last
    pass, the contact does not return to the initial position.

    Parameters
    ----------
    load, approach : float
        Load [N] or approach [m] while rolling, > 0. Exactly one must be given.
    distance : float
        Distance that the contact travels over the bodies in a pass [m]: positive towards +x. With
        `slide_to_roll`, the mean of the distances over the two bodies.
    step : float
        Length of a step [m], > 0; preferably a whole number of cells dx. The last step of a pass is
        shorter if the steps do not divide the distance.
    passes : int
        Number of passes, >= 1. Between two passes the unloaded bodies return in one step.
    increments, unload_increments : int
        Number of steps of each loading and of each unloading; the contact does not travel in these
        steps. Default of `unload_increments`: `increments`.
    slide_to_roll : float
        Slide-to-roll ratio (u1 - u2)/((u1 + u2)/2) of the surface speeds u1, u2 of the bodies
        through the contact, in [-2, 2] [-]: bodies 1 and 2 move (1 + slide_to_roll/2) and (1 -
        slide_to_roll/2) times the distance. With full sliding, body 1 must slide towards +x:
        distance and slide_to_roll then have opposite signs. With `Coulomb`, both signs are allowed;
        slide_to_roll is minus the creepage of `samcontact.rolling.steady`.
    lateral_creepage, spin : float
        With `Coulomb`: motion of body 1 relative to body 2 along y [-], and rotation about z [1/m],
        per distance that the contact travels towards +x, as in `samcontact.rolling.steady`.
    tangential_load_x : float, optional
        With `Coulomb`: force on body 2 while rolling [N], which determines the creepage.
    back_and_forth : bool
        Whether the direction of the passes alternates. The contact is then not unloaded between
        passes.
    speed : float, optional
        Speed of the contact over the bodies [m/s], > 0, for a simulation with heat.history: the
        duration of each rolling or return step is its length divided by the speed, and each load
        increment lasts as long as a full step. Set `velocity` of the heat to the velocities of the
        bodies: for distance > 0, -speed (1 + slide_to_roll/2) and -speed (1 - slide_to_roll/2). For
        bodies that return or roll back and forth, set `track` of the heat instead.
    heat_factor : float or pair of floats, optional
        Heat flux per unit pressure from the first step on [m/s].
    return_time : float, optional
        Only with `speed`: duration of the return between two passes [s], in which the bodies cool;
        0: they return at once. Default: they return at `speed`.

    Returns
    -------
    list of dict
        Steps for `Simulation.run`.

    Raises
    ------
    ValueError
        Both or neither of load and approach are given; a value is outside its range; or
        slide_to_roll is combined with tangential_load_x.

    Examples
    --------
    >>> for step in rolling(load=300.0, distance=1e-4, step=5e-5, increments=1):
    ...     print(step)
    {'load': 300.0}
    {'load': 300.0, 'advance': (-5e-05, -5e-05)}
    {'load': 300.0, 'advance': (-5e-05, -5e-05)}
    {'load': 0.0}
    """
    if not -2.0 <= number("slide_to_roll", slide_to_roll) <= 2.0:
        raise ValueError(f"slide_to_roll must be in [-2, 2], got {slide_to_roll!r}")
    shares = (1.0 + 0.5 * slide_to_roll, 1.0 - 0.5 * slide_to_roll)
    if tangential_load_x is not None:
        finite("tangential_load_x", tangential_load_x)
        if slide_to_roll != 0.0:
            raise ValueError(
                f"slide_to_roll must be 0 with tangential_load_x, got {slide_to_roll!r}: "
                "the creepage follows from the force"
            )
    creep = CreepageInput(
        finite("lateral_creepage", lateral_creepage), finite("spin", spin), tangential_load_x
    )
    name, value = load_or_approach(load, approach)
    return RollingPasses(
        name,
        value,
        distance,
        step,
        passes,
        increments,
        unload_increments,
        shares,
        back_and_forth,
        speed,
        heat_factor,
        creep,
        return_time,
    ).steps()


def sliding(
    *,
    load: float | None = None,
    approach: float | None = None,
    distance: float,
    step: float,
    slider: int = 1,
    passes: int = 1,
    increments: int = 10,
    unload_increments: int | None = None,
    back_and_forth: bool = False,
    speed: float | None = None,
    heat_factor: float | Sequence[float] | None = None,
    return_time: float | None = None,
) -> Steps:
    """Load, slide one body over the other and unload, once per pass.

    Each pass starts at the initial position. The contact stays at one place on the slider. With
    full sliding, body 1 must slide towards +x: distance > 0 with slider 1, distance < 0 with
    slider 2.

    Parameters
    ----------
    load, approach : float
        Load [N] or approach [m] while sliding, > 0. Exactly one must be given.
    distance : float
        Distance that the slider travels over the other body in a pass [m]: positive towards +x.
    step, passes, increments, unload_increments, back_and_forth, heat_factor, return_time : optional
        As in `rolling`.
    slider : {1, 2}
        Body on which the contact stays in place.
    speed : float, optional
        Sliding speed [m/s], > 0, as in `rolling`. Set `velocity` of the heat to 0 for the slider
        and, for distance > 0, to -speed for the other body, or set `track` of the heat.

    Returns
    -------
    list of dict
        Steps for `Simulation.run`.

    Raises
    ------
    ValueError
        Both or neither of load and approach are given, or a value is outside its range.

    Examples
    --------
    >>> for step in sliding(load=300.0, distance=8e-5, step=4e-5, increments=1):
    ...     print(step)
    {'load': 300.0}
    {'load': 300.0, 'advance': (0.0, -4e-05)}
    {'load': 300.0, 'advance': (0.0, -4e-05)}
    {'load': 0.0}
    """
    shares = (0.0, 1.0) if choice("slider", slider, (1, 2)) == 1 else (1.0, 0.0)
    name, value = load_or_approach(load, approach)
    return RollingPasses(
        name,
        value,
        distance,
        step,
        passes,
        increments,
        unload_increments,
        shares,
        back_and_forth,
        speed,
        heat_factor,
        CreepageInput(),
        return_time,
    ).steps()
