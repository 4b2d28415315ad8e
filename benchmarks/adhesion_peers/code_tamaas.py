# SPDX-License-Identifier: GPL-3.0-or-later
"""tamaas: Polonsky and Keer's solver with the gap as primal variable, on periodic surfaces.

It solves the same discrete problem as the others: the response of its operators to each wave is
that of constant pressure on cells.
"""

from __future__ import annotations

import numpy as np
import tamaas as tm

from ..peers.code_tamaas import iterations_logged
from .problems import Path, State


class Contact:
    """Each step starts from the gap of the preceding one."""

    tolerances = (1e-6, 1e-7, 1e-8, 1e-9)

    def __init__(self, path: Path, tol: float) -> None:
        if not path.periodic:
            raise NotImplementedError("the solver with adhesion is periodic")
        self.path = path
        n = path.n
        self.model = tm.ModelFactory.createModel(tm.model_type.basic_2d, [1.0, 1.0], [n, n])
        self.model.E, self.model.nu = 1.0, 0.0
        surface = np.ascontiguousarray(-path.gap)
        gap = tm.PolonskyKeerRey.gap
        self.solver = tm.PolonskyKeerRey(self.model, surface, tol, gap, gap)
        self.solver.max_iter = 10000
        self.solver.dump_freq = 1
        self.attraction = tm.ExponentialAdhesionFunctional(surface)
        self.attraction.parameters = {"rho": path.range, "surface_energy": path.work}
        self.solver.addFunctionalTerm(self.attraction)
        self._set_operators()

    def _set_operators(self) -> None:
        spectrum = self.path.spectrum
        inverse = np.divide(1.0, spectrum, out=np.zeros_like(spectrum), where=spectrum > 0)
        for name, values in (("neumann", spectrum), ("dirichlet", inverse)):
            operator = self.model.operators[f"westergaard_{name}"]
            np.asarray(operator["influence"])[...] = values

    def solve(self) -> list[State]:
        found = []
        for distance in self.path.distances:
            mean = -self.path.approach(distance) + self.path.gap.mean()
            count = iterations_logged(lambda mean=mean: self.solver.solve(mean))
            pressure = np.array(self.model.traction).squeeze()
            moved = np.array(self.model.displacement).squeeze()
            found.append(State(self.path.gap + moved, pressure, count))
        return found
