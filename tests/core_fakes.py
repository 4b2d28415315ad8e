# SPDX-License-Identifier: GPL-3.0-or-later
"""Stand-ins for computed objects, with fields known in closed form."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np

from samcontact import Grid, HardContact, Material, hertz
from samcontact.solutions.contact_area import contact_area

ELASTIC = Material.elastic(210e9, 0.3)
RIGID = Material.rigid()
SWIFT = Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)


def make_grid(nx=11, ny=9, dx=1e-4, dy=1.2e-4, nz=0, dz=None):
    return Grid(nx, ny, dx, dy, nz, dz)


class FakeState:
    """State with a Hertz pressure, and volume fields equal to the load times simple patterns."""

    def __init__(self, grid, load):
        self.grid, self.load, self.time = grid, load, 0.0
        self.travel, self.heat_factor = (0.0, 0.0), (0.0, 0.0)
        self.lateral_travel = (0.0, 0.0)
        self.tilt = self.moment = (0.0, 0.0)
        shape = (grid.nx, grid.ny)
        self.shear, self.gap = np.zeros((2, *shape)), np.zeros(shape)
        self.domain = SimpleNamespace(grid=grid, initial_gap=self.gap, reliefs=(None, None))
        self.setup = SimpleNamespace(bodies=(ELASTIC, ELASTIC))
        self.converged, self.iterations, self.contact_iterations, self.substeps = True, 3, 20, 1
        self.plastic_strain_residual, self.yield_violation = 1e-8, 2e-9
        if load > 0:
            contact = hertz.point(7.5e-3, 115384615384.6154, load=load)
            self.pressure = contact.pressure(grid.x[:, None], grid.y[None, :])
            self.approach = contact.approach
        else:
            self.pressure, self.approach = np.zeros(shape), 0.0
        self.contact_area = contact_area(self.pressure, grid.cell_area)

    @property
    def repulsion(self):
        return self.pressure

    @property
    def in_contact(self):
        return self.pressure > 0

    @property
    def depths(self):
        return self.grid.z

    def at_layers(self, layers):
        assert layers == self.grid.nz
        return self

    def _pattern(self):
        grid = self.grid
        i = np.arange(grid.nx)[:, None, None]
        j = np.arange(grid.ny)[None, :, None]
        return 1.0 + i + 100.0 * j + 10000.0 * np.arange(grid.nz)

    def von_mises(self, body=2):
        return self._pattern() * self.load * body

    def hydrostatic(self, body=2):
        return -self._pattern() * self.load * body

    def stress(self, body=2):
        factors = np.arange(1.0, 7.0).reshape(6, 1, 1, 1)
        return factors * self._pattern() * self.load * body

    def residual_stress(self, body=2):
        return self.stress(body=body) * 0.1

    def plastic_strain(self, body=2):
        return self.stress(body=body) * 1e-12

    def equivalent_plastic_strain(self, body=2):
        return self._pattern() * 1e-9 * body

    def zones(self, body=2):
        strain = self.equivalent_plastic_strain(body)
        whole = {"first": (0, 0), "shape": strain.shape}
        return (SimpleNamespace(**whole, equivalent_plastic_strain=lambda: strain),)

    def max_plastic_strain_magnitude(self, body=2):
        return self.max_equivalent_plastic_strain(body)

    def max_equivalent_plastic_strain(self, body=2):
        return float(self.equivalent_plastic_strain(body=body).max())

    def residual_displacement(self, body=2):
        return np.broadcast_to(1e-7 * body * np.arange(self.grid.nx)[:, None], self.pressure.shape)

    def surface_temperature(self, body=2):
        return self.pressure * 1e-7 * body

    def temperature(self, body=2):
        return self._pattern() * self.load * 1e-7 * body


def make_simulation(nz=4, body1=ELASTIC, body2=SWIFT):
    grid = make_grid(nz=nz, dz=1e-4 if nz else None)
    gap = np.zeros((grid.nx, grid.ny))
    return SimpleNamespace(
        grid=grid,
        body1=body1,
        body2=body2,
        initial_gap=gap,
        friction=0.0,
        adhesion=HardContact(),
        tol=1e-6,
        reach=1e-3,
        heat_factor=(0.0, 0.0),
        counters={},
    )
