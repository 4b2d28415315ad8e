# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields of a body due to the tractions of an elastic contact."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .. import _core
from .._util import memory
from .._util.checks import FloatArray, choice, finite_array, real_array, require_type
from ..bodies.layered import Body
from ..heat import Heat
from ..problem.cell_fields import depths_of, shear_components
from ..problem.contact_law import rubbing_pressure
from ..problem.friction import FrictionLaw
from ..problem.grid import Grid
from ..problem.settings import Configured
from ..solutions.contact_solution import ContactSolution, ShearedSolution
from ..solutions.stress_at_points import require_closed_forms, stress_at_points


class ContactFields(Configured):
    """Methods of a contact solver for stress, displacement and temperature in the bodies."""

    grid: Grid
    body1: Body
    body2: Body
    friction: Any
    heat: Heat
    _core: Any
    _law: FrictionLaw
    _heating: Any

    def stress(
        self,
        pressure: ArrayLike,
        z: ArrayLike,
        body: int = 2,
        *,
        shear: ArrayLike | None = None,
    ) -> FloatArray:
        """Elastic and thermal stress in a body at given depths [Pa], without initial stress.

        Parameters
        ----------
        pressure : array_like, shape (nx, ny)
            Contact pressure [Pa].
        z : array_like, shape (m,)
            Depths [m], >= 0.
        body : {1, 2}, optional
        shear : array_like, shape (nx, ny) or (2, nx, ny), optional
            Shear traction s_x, or (s_x, s_y), on body 2 [Pa] (reversed on body 1). Default:
            friction times pressure; required with `Coulomb`.

        Returns
        -------
        ndarray, shape (6, nx, ny, m)
            Components xx, yy, zz, yz, xz, xy [Pa], tension positive, in the body's own frame.
        """
        material = self.body1 if choice("body", body, (1, 2)) == 1 else self.body2
        if material.is_rigid:
            raise ValueError(f"body {body} is rigid and has no stress")
        layers = real_array("z", z).size
        needed = memory.volume(self.grid, memory.TRACTION_STRESS_BYTES, layers)
        memory.require_for_grid(f"the stress at {layers} depths", self.grid, needed)
        stress: FloatArray = _core.operators.surface_stress(
            self.grid._core,
            material._core,
            self._heating[body - 1],
            depths_of(z).tolist(),
            *self._tractions_on(body, pressure, shear),
        )
        return stress

    def displacement(
        self, pressure: ArrayLike, shear: ArrayLike | None = None, body: int = 2
    ) -> FloatArray:
        """Elastic surface displacement of a body due to tractions [m], along x, y and z.

        Parameters
        ----------
        pressure : array_like, shape (nx, ny)
            Contact pressure [Pa], positive in compression.
        shear : array_like, shape (nx, ny) or (2, nx, ny), optional
            Shear traction s_x, or (s_x, s_y), on body 2 [Pa] (reversed on body 1). Default:
            friction times pressure; required with `Coulomb`.
        body : {1, 2}, optional

        Returns
        -------
        ndarray, shape (3, nx, ny)
            u_x, u_y, u_z [m] at the cell centres, zero far away (see Grid for periodic grids). Both
            bodies share the axes x and y; u_z is positive into the body. Shear s_x > 0 on body 2
            displaces the surface of body 2 towards +x; pressure draws the surrounding surface
            towards the contact. Thermal expansion is not included. The displacement of a rigid body
            is zero.

        Raises
        ------
        ValueError, TypeError
            An argument has an invalid value or type.

        Notes
        -----
        Boussinesq's and Cerruti's solutions for point forces (Johnson 1985, sections 3.2 and 3.6)
        are integrated over each cell. The relative tangential displacement is the displacement of
        body 2 minus the displacement of body 1; the normal displacements of both bodies add up to
        the approach of the surfaces.
        """
        material = self.body1 if choice("body", body, (1, 2)) == 1 else self.body2
        needed = 3 * memory.surface(self.grid, memory.DISPLACEMENT_BYTES)
        memory.require_for_grid("a displacement", self.grid, needed)
        loads = self._tractions_on(body, pressure, shear)
        along = _core.operators.surface_displacement
        return np.stack(
            [
                along(self.grid._core, material._core, _core.Heating(), *loads, axis)
                for axis in range(3)
            ]
        )

    def _tractions_on(
        self, body: int, pressure: ArrayLike, shear: ArrayLike | None
    ) -> tuple[FloatArray, FloatArray | None, FloatArray | None]:
        """Return pressure, s_x and s_y [Pa] on a body from the tractions on body 2.

        If `shear` is None, s_x and s_y follow from the friction law.
        """
        p = np.ascontiguousarray(finite_array("pressure", pressure, self.grid.surface_shape))
        attracted = self.adhesion.attracts and self.friction != 0
        if shear is None and not (attracted or self._law.sticks):
            shear = self._core.shear(p)
        elif shear is None:
            law = f" and adhesion {self.adhesion!r}" if attracted else ""
            raise ValueError(
                f"shear is required with friction = {self.friction!r}{law}, got None: the pressure "
                "does not determine the shear; use the shear of a solution"
            )
        parts = shear_components(self.grid, shear)
        s_x, s_y = parts if body == 2 else (None if s is None else -s for s in parts)
        return p, s_x, s_y

    def temperature(self, pressure: ArrayLike, z: ArrayLike = 0.0, body: int = 2) -> FloatArray:
        """Temperature rise in a body at given depths [K].

        Parameters
        ----------
        pressure : array_like, shape (nx, ny)
            Contact pressure [Pa].
        z : array_like, shape (m,), optional
            Depths [m], >= 0. Default: the surface (flash temperature).
        body : {1, 2}, optional

        Returns
        -------
        ndarray, shape (nx, ny, m)
            Temperature rise [K]; zero in a body that is not heated.
        """
        index = choice("body", body, (1, 2)) - 1
        p = np.ascontiguousarray(finite_array("pressure", pressure, self.grid.surface_shape))
        layers = real_array("z", z).size
        needed = memory.volume(self.grid, memory.TEMPERATURE_BYTES, layers)
        memory.require_for_grid(f"the temperature at {layers} depths", self.grid, needed)
        rise: FloatArray = _core.operators.temperature(
            self.grid._core, self._heating[index], depths_of(z).tolist(), p
        )
        return rise

    def stress_at(
        self, solution: ContactSolution, x: ArrayLike, y: ArrayLike, z: ArrayLike, body: int = 2
    ) -> FloatArray:
        """Elastic stress of a solution at arbitrary points [Pa], on and off the grid.

        Parameters
        ----------
        solution : ContactSolution
            Solution from which pressure and shear are taken; in full sliding, the shear is friction
            times pressure.
        x, y, z : array_like
            Points [m], with shapes that broadcast; z >= 0 is the depth in the body.
        body : {1, 2}, optional

        Returns
        -------
        ndarray, shape (6, ...)
            Components xx, yy, zz, yz, xz, xy [Pa], tension positive, in the body's own frame. The
            tractions are uniform in each cell, so stress at the surface z = 0 jumps between cells,
            and single cells remain visible to a depth of about one cell. At the surface,
            the stress on an edge between loaded cells is infinite; the result there is the mean of
            the values half a cell away on both sides.

        Raises
        ------
        ValueError, TypeError
            The body is layered, rigid or heated, the grid is periodic, or points are not finite or
            lie above the surface.

        Notes
        -----
        The closed-form stresses of all loaded cells are added (Love 1929; Johnson 1985, section
        3.4). At cell centres the result equals the result of `stress` to within rounding. The
        evaluation takes a few microseconds per point and loaded cell.
        """
        require_type("solution", solution, ContactSolution)
        number = choice("body", body, (1, 2))
        given = self.body1 if number == 1 else self.body2
        material = require_closed_forms(
            solution.grid, given, number, heated=self.heat.factor[number - 1] > 0
        )
        p = solution.pressure
        if isinstance(solution, ShearedSolution):
            s_x, s_y = solution.shear
        elif self._law.sticks:
            raise ValueError(
                "solution must be a partial-slip solution because friction = "
                f"{self.friction!r}, got a solution of full sliding: pass a solution of "
                "this solver"
            )
        else:
            rubbing = rubbing_pressure(solution.repulsion, p, self.adhesion.rubs_by_compression)
            s_x, s_y = self._law.sliding_ratio * rubbing, 0.0 * p
        sign = 1.0 if number == 2 else -1.0
        tractions = p, sign * s_x, sign * s_y
        return stress_at_points(solution.grid, tractions, material.nu, (x, y, z))
