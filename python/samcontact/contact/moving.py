# SPDX-License-Identifier: GPL-3.0-or-later
"""Steady contact of viscoelastic bodies whose material moves through the contact."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from .. import _core
from .._util import memory
from .._util.checks import MAX_STRESS, FloatArray, finite, require_type
from ..bodies.free_faces import require_endless
from ..bodies.layered import Body, require_bodies
from ..bodies.relaxation import creep_terms
from ..bodies.viscoelastic import instantaneous, relaxation_of, vibrating
from ..problem.grid import Grid
from ..solutions.contact_solution import ContactSolution
from .solver import ContactSolver
from .tangential_drive import Pressing, TangentialDriver

_HIGHER = [2.0**power for power in range(13, 0, -1)]
"""Speeds of the successive solutions in `_from_above`, as multiples of the given speeds."""

Finish = Callable[[Grid, FloatArray, dict[str, Any]], ContactSolution]
"""Function that creates the solution. Its arguments are the grid, the displacement [m]
that `MovingContactSolver._delayed` returns, and the fields of a ContactSolution."""


class MovingContactSolver(ContactSolver):
    """Solver for the steady contact of bodies that move along x without friction.

    Parameters
    ----------
    grid : Grid
    bodies : pair of bodies
        Upper and lower body, viscoelastic, elastic or rigid.
    speeds : pair of float
        Velocity of the material of each body along +x relative to the contact [m/s].
    finish : callable
        Function that creates the solution from the computed fields.
    settings
        `tol`, `on_border` and `max_iterations` of `ContactSolver`.
    """

    def __init__(
        self,
        grid: Grid,
        bodies: tuple[Body, Body],
        speeds: tuple[float, float],
        finish: Finish,
        **settings: Any,
    ) -> None:
        self._moving = bodies, speeds, finish
        upper, lower = (_effective(body, v, grid) for body, v in zip(bodies, speeds, strict=True))
        super().__init__(grid, upper, lower, **settings)

    def _new_core(self) -> Any:
        return self._core_at(1.0)

    def _core_at(self, factor: float) -> Any:
        """Return the contact of the compiled core for the given speeds times `factor`."""
        bodies, speeds, _ = self._moving
        needed = memory.surface(self.grid, memory.MOVING_CONTACT_BYTES)
        memory.require_for_grid("a moving viscoelastic contact", self.grid, needed)
        elastic = (instantaneous(body)._core for body in bodies)
        creeps = (moving_creep(body, factor * v) for body, v in zip(bodies, speeds, strict=True))
        return _core.CreepingContact(self.grid._core, *elastic, *creeps)

    def _over(self, counts: Sequence[int]) -> MovingContactSolver:
        grid = replace(self.grid, nx=counts[0], ny=counts[1])
        given = "tol", "on_border", "max_iterations"
        settings = {name: getattr(self, name) for name in given}
        return MovingContactSolver(grid, *self._moving, **settings)

    def _solved(
        self, contact: Pressing, drive: TangentialDriver, start: FloatArray | None
    ) -> tuple[ContactSolution, str]:
        settings = self.tol, self.max_iterations, self.on_border == "error"
        try:
            found = self._core.solve(*contact, start, *settings)
        except _core.ConvergenceError:
            higher = None if start is not None else self._from_above(contact, settings)
            if higher is None:
                raise
            found = self._core.solve(*contact, higher, *settings)
        complaint = found.pop("border_complaint")
        return self._moving[2](self.grid, self._delayed(found["pressure"]), found), complaint

    def _from_above(self, contact: Pressing, settings: Sequence[Any]) -> FloatArray | None:
        """Return a pressure [Pa] to start from, found at twice the given speeds; None if not found.

        The speeds are halved repeatedly, beginning with speeds at which the bodies have nearly
        their instantaneous moduli. Each solution starts from the previous pressure.
        """
        pressure = None
        for factor in _HIGHER if any(self._moving[1]) else ():
            try:
                pressure = self._core_at(factor).solve(*contact, pressure, *settings)["pressure"]
            except _core.ConvergenceError:
                return None
        return pressure

    def _delayed(self, pressure: FloatArray) -> FloatArray:
        """Return the part of the displacement that depends on the direction of motion [m].

        It is half of the difference between the displacements in the given and in reversed motion,
        due to the same pressure. The other part is due to a symmetric operator, and thus causes no
        force along x.
        """
        reversed_pressure = np.ascontiguousarray(pressure[::-1])
        mirrored = self._core.displacement(reversed_pressure)[::-1]
        delayed: FloatArray = 0.5 * (self._core.displacement(pressure) - mirrored)
        return delayed


def speed_of(name: str, value: Any) -> float:
    """Return a velocity [m/s]; raise TypeError or ValueError unless it is a finite number."""
    given = finite(name, value)
    if abs(given) > MAX_STRESS:  # products with times and wavenumbers stay finite
        raise ValueError(
            f"{name} must be a velocity of magnitude <= {MAX_STRESS:g} m/s, got {given!r}"
        )
    return given


def pressure_of(start: Any, kind: type[ContactSolution]) -> FloatArray:
    """Return the pressure of a solution `start`; raise TypeError unless it is of type `kind`."""
    require_type("start", start, kind)
    pressure: FloatArray = start.pressure
    return pressure


def moving_creep(body: Body, speed: float) -> _core.MovingCreep:
    """Return the creep of a body as a function of the distance moved, for the compiled core."""
    terms = relaxation_of(body)
    if terms is None:
        return _core.MovingCreep([], [], speed > 0)
    shares, times, _ = creep_terms(terms)
    return _core.MovingCreep(shares.tolist(), (abs(speed) * times).tolist(), speed > 0)


def _effective(body: Body, speed: float, grid: Grid) -> Body:
    """Return an elastic body with the modulus for waves half as long as the grid.

    The waves pass at `speed` [m/s].
    The body is used only for estimates of the contact and for warnings.
    """
    return vibrating(body, 4 * np.pi * abs(speed) / (grid.nx * grid.dx))


def require_moving(body1: Any, body2: Any) -> tuple[Body, Body]:
    """Return both bodies; raise TypeError or ValueError unless they can move steadily."""
    require_bodies(body1, body2)
    require_endless("ends of bodies are not supported", body1, body2)
    for number, body in ((1, body1), (2, body2)):
        terms = relaxation_of(body)
        if terms is not None and creep_terms(terms)[2] > 0:
            raise ValueError(
                f"in steady motion, body{number} must be a solid (sum of relaxation shares < 1), "
                f"got shares = {list(terms[1])!r}: the contact of a fluid never becomes steady, "
                "because a fluid flows without limit"
            )
    return body1, body2
