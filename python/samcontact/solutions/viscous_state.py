# SPDX-License-Identifier: GPL-3.0-or-later
"""Quantities of viscoelastic bodies in a state."""

from __future__ import annotations

from typing import Any

from .._util.checks import FloatArray, choice


class ViscousState:
    """Base class of `State` with quantities that depend on the history of viscoelastic bodies."""

    _core: Any

    def equivalent_pressure(self, body: int = 2) -> FloatArray:
        """Pressure that would give an elastic body the same displacement [Pa], shape (nx, ny).

        The displacement of a viscoelastic body depends on the history of the pressure. An elastic
        body with the instantaneous modulus has an equal displacement under the equivalent pressure.
        For a body that does not relax, the equivalent pressure is the pressure. Where the contact
        has been before, the equivalent pressure exceeds the pressure and decreases with time.
        """
        field: FloatArray = self._core.equivalent_pressure(choice("body", body, (1, 2)) - 1)
        field.flags.writeable = False
        return field

    def viscous_work(self, body: int = 2) -> float:
        """Energy dissipated by the viscosity of a body since the start [J]; 0 if it is elastic.

        It is the work of the tractions on the surface of the body minus the elastic energy of the
        body. It is exact if the equivalent tractions (see `equivalent_pressure`) are linear in time
        in each step. The elastic energy requires one convolution for each relaxation time and is
        computed on access. Negative results are set to 0 if their magnitude is below 1e-12 of the
        elastic energy.
        """
        return float(self._core.viscous_work(choice("body", body, (1, 2)) - 1))

    def stored_energy(self, body: int = 2) -> float:
        """Elastic energy of a viscoelastic body [J]; 0 for other bodies, see `energy.balance`."""
        memory = getattr(self._core, f"traction_memory{choice('body', body, (1, 2))}")
        return 0.0 if memory is None else float(memory["supplied"]) - self.viscous_work(body)
