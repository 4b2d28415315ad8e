# SPDX-License-Identifier: GPL-3.0-or-later
"""Surface quantities of a state."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._util.cached_property import cached_property
from .._util.checks import FloatArray, choice
from .._util.display import Rows, quantity
from ..problem.contact_law import in_contact
from ..problem.grid import Grid
from ..problem.setup import SimulationSetup
from .contact_area import contact_area
from .contact_solution import both, rows_of_tilt
from .outline import Outline, outline_of
from .stress_at_points import require_closed_forms, stress_at_points
from .viscous_state import ViscousState


class RigidMotionState:
    """Base class of `State` with normal rigid-body motion, and the moment of the pressure."""

    _core: Any

    @property
    def approach(self) -> float:
        """Rigid-body approach at the origin of the grid [m]; NaN under prescribed tractions."""
        return float(self._core.approach)

    @property
    def tilt(self) -> FloatArray:
        """Rotation of body 1 relative to body 2 about x and y [rad], shape (2,).

        Body 1 is lowered by ``approach + tilt[0] * y - tilt[1] * x``.
        """
        return np.array(self._core.tilt)

    @property
    def moment(self) -> FloatArray:
        """Moment of the pressure on body 2 about x and y at the origin [N m], shape (2,).

        It is the sum of ``p y`` and of ``-p x`` over the area.
        """
        return np.array(self._core.moment())


class SlipRateState(RigidMotionState):
    """Base class of `State` with results of the friction laws `FallingCoulomb` and `ThirdBody`."""

    grid: Grid

    @property
    def slip_rate(self) -> FloatArray:
        """Slip rate that determines the friction of each cell [m/s], shape (nx, ny).

        It is zero with friction that does not depend on the slip rate.
        """
        field = self._core.slip_rate
        shape = self.grid.surface_shape
        return np.zeros(shape) if field is None else field.reshape(shape)

    @property
    def plastic_slip(self) -> FloatArray:
        """Plastic slip accumulated in the layer between the bodies [m], shape (nx, ny).

        It is computed for a `ThirdBody` that hardens, and otherwise zero.
        """
        field = self._core.plastic_slip
        shape = self.grid.surface_shape
        return np.zeros(shape) if field is None else field.reshape(shape)

    @property
    def falling_number(self) -> float:
        """Maximum of -dmu/dv p C/t over all cells in the last increment [-], with `FallingCoulomb`.

        mu is the coefficient of friction at the slip rate v, p the pressure, C the displacement of
        a cell under its own unit shear, and t the duration of the increment.
        """
        return float(self._core.falling_number)


class AttractionState(SlipRateState):
    """Base class of `State` with the pressure and the attraction between the surfaces."""

    setup: SimulationSetup

    @cached_property
    def pressure(self) -> FloatArray:
        """Contact pressure [Pa], shape (nx, ny)."""
        field = self._surface("pressure")
        field.flags.writeable = False
        return field

    def _surface(self, name: str) -> FloatArray:
        """Return a surface field of the compiled core; zeros if the core has no such field."""
        shape = self.grid.nx, self.grid.ny
        field = getattr(self._core, name)
        return np.zeros(shape) if field is None else field.reshape(shape)

    @cached_property
    def repulsion(self) -> FloatArray:
        """Pressure plus the attraction of the contact law [Pa], shape (nx, ny).

        In hard contact it equals the pressure.
        """
        if not self.setup.adhesion.attracts:
            return self.pressure
        field: FloatArray = self._core.repulsion()
        field.flags.writeable = False
        return field

    @property
    def in_contact(self) -> NDArray[np.bool_]:
        """Whether each cell is in contact, shape (nx, ny)."""
        return in_contact(self.repulsion)

    @property
    def adhesion_stress(self) -> FloatArray:
        """Attraction between the surfaces, repulsion minus pressure [Pa], >= 0, shape (nx, ny)."""
        found: FloatArray = self.repulsion - self.pressure
        return found

    @property
    def attraction_energy(self) -> float:
        """Work against the attraction to open the gap from zero to its present height [J]."""
        return float(self._core.attraction_energy())


class SurfaceState(AttractionState, ViscousState):
    """Base class of `State` with tractions, gap and rigid-body motion."""

    setup: SimulationSetup

    @cached_property
    def outline(self) -> Outline:
        """Outline of the contact in cells of the grid."""
        return outline_of(self.repulsion, self.grid.periodic)

    @property
    def shear(self) -> FloatArray:
        """Shear tractions s_x, s_y on body 2 [Pa], shape (2, nx, ny)."""
        return np.stack([self._surface("shear_x"), self._surface("shear_y")])

    @property
    def slip(self) -> FloatArray:
        """Slip of body 1 relative to body 2 in the last increment [m], shape (2, nx, ny).

        The slip is zero in the stick zone. Raises ValueError in full sliding (friction given as a
        number), for which slip is not computed.
        """
        _require_sticking("slip", self.setup)
        shape = (2, *self.grid.surface_shape)
        field = self._core.slip
        return np.zeros(shape) if field is None else field.reshape(shape)

    @property
    def sticking(self) -> NDArray[np.bool_]:
        """Whether each cell is in contact without slip in the last increment, shape (nx, ny).

        Raises ValueError in full sliding.
        """
        return self.in_contact & ~self.slip.any(axis=0)

    @property
    def tangential_load(self) -> FloatArray:
        """Force of the shear along x and y on body 2 [N], shape (2,)."""
        return np.array(self._core.tangential_force()[:2])

    @property
    def torque(self) -> float:
        """Moment of the shear on body 2 about z at the origin of the grid [N m]."""
        return float(self._core.tangential_force()[2])

    @property
    def shift(self) -> FloatArray:
        """Accumulated tangential rigid-body displacement [m], shape (2,).

        It is the displacement of body 1 relative to body 2 along x and y, and includes the
        difference between the travels of both bodies. Raises ValueError in full sliding.
        """
        _require_sticking("shift", self.setup)
        return np.array(self._core.motion[:2])

    @property
    def twist(self) -> float:
        """Accumulated rotation of body 1 relative to body 2 about z [rad] (see also `shift`)."""
        _require_sticking("twist", self.setup)
        return float(self._core.motion[2])

    @property
    def friction_work(self) -> float:
        """Frictional dissipation since the start [J]; ValueError in full sliding."""
        _require_sticking("friction_work", self.setup)
        return float(self._core.friction_work)

    @property
    def joint_steps(self) -> int:
        """Number of Newton steps for pressure and shear together; 0 if none were needed."""
        return int(self._core.joint_steps)

    @cached_property
    def gap(self) -> FloatArray:
        """Separation [m], shape (nx, ny); with prescribed tractions, the approach is taken as 0."""
        field: FloatArray = self._core.gap()
        field.flags.writeable = False
        return field

    @property
    def load(self) -> float:
        """Normal load [N]."""
        return float(self._core.load)

    @property
    def contact_area(self) -> float:
        """Contact area [m^2], with the contact edge located within cells, see `contact_area`.

        Under prescribed tractions, it is the area under pressure.
        """
        repulsion, grid = self.repulsion, self.grid
        gap = self.gap if np.isfinite(self.approach) and self.outline.rises else None
        return contact_area(repulsion, grid.cell_area, grid.periodic, gap)

    def stress_at(self, x: ArrayLike, y: ArrayLike, z: ArrayLike, body: int = 2) -> FloatArray:
        """Elastic stress due to pressure and shear at arbitrary points [Pa], shape (6, ...).

        It does not include the stress due to plastic strain or the initial stress; for these, see
        `residual_stress`. `ContactSolver.stress_at` describes arguments, errors and method.
        """
        number = choice("body", body, (1, 2))
        heated = (self._core.heat_factor1, self._core.heat_factor2)[number - 1] > 0
        given = self.setup.bodies[number - 1]
        nu = require_closed_forms(self.grid, given, number, heated=heated).nu
        s_x, s_y = self.shear if number == 2 else -self.shear
        return stress_at_points(self.grid, (self.pressure, s_x, s_y), nu, (x, y, z))

    @property
    def mean_pressure(self) -> float:
        """Mean pressure, load over contact area [Pa]; 0 without contact."""
        area = self.contact_area
        return self.load / area if area > 0 else 0.0


def rows_along_surface(state: SurfaceState) -> Rows:
    """Return table rows of the tilt and, with partial slip, of tangential force and motion."""
    tilted = rows_of_tilt(state.tilt, state.moment)
    if not state.setup.friction.sticks:
        return tilted
    touching = int(np.count_nonzero(state.in_contact))
    rows = [
        ("tangential load", both(state.tangential_load, "N")),
        ("shift", both(state.shift, "m")),
        ("frictional work", quantity(state.friction_work, "J")),
        ("sticking cells", f"{np.count_nonzero(state.sticking)} of {touching} in contact"),
    ]
    if state.twist != 0.0:
        rotational = [("torque", state.torque, "N m"), ("twist", state.twist, "rad")]
        rows[2:2] = [(name, quantity(value, unit)) for name, value, unit in rotational]
    return [*tilted, *rows]


def _require_sticking(name: str, setup: SimulationSetup) -> None:
    """Raise ValueError in full sliding, for which the named quantity is not defined."""
    if not (friction := setup.friction).sticks:
        raise ValueError(
            f"{name} requires partial slip, got friction = {friction!r} (full sliding): use "
            "friction=samcontact.Coulomb(mu) in the simulation"
        )
