# SPDX-License-Identifier: GPL-3.0-or-later
"""State of a simulation at the end of an increment."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from .._util import memory
from .._util.cached_property import cached_property
from .._util.checks import MAX_CELLS_ALONG_AXIS, FloatArray, axis_number, choice, integer
from .._util.display import HtmlTable, Rows, quantity
from .._util.field_cache import kept
from .._util.frozen import FixedAttributes
from .._util.tensors import von_mises
from ..heat import Heat
from ..problem.domain import Domain
from ..problem.heating import softening_of
from ..problem.setup import SimulationSetup
from .inclusion_state import InclusionState
from .interface_stress import layered_body, stress_at_interfaces
from .moving_state import MovingState, require_path_along_x, rows_of_travel
from .surface_state import SurfaceState, rows_along_surface
from .track import Track
from .zone import Zone, ZoneStress

_VOLUME_FIELDS = (
    "stress", "residual_stress", "initial_stress", "eigenstress", "eigenstrain", "plastic_strain",
    "disturbance", "equivalent_plastic_strain", "backstress", "temperature",
    "matrix_plastic_strain", "inclusion_plastic_strain", "inclusion_equivalent_strain",
)  # fmt: skip


def on_common_grid(states: Sequence[State]) -> list[State]:
    """Return the states of a simulation on the largest of their grids."""
    if not states:
        return []
    largest = max(states, key=lambda state: state.grid.nx * state.grid.ny)
    return [s if s.grid == largest.grid else s._padded_to(largest) for s in states]


class State(SurfaceState, MovingState, InclusionState, FixedAttributes, HtmlTable):
    """Fields and scalars at the end of one increment, in SI units.

    Volume fields are computed on access. Tensor components are xx, yy, zz, yz, xz, xy in the frame
    of the body (z into it); tension is positive. Methods take body = 1 or 2; methods for volume
    fields raise ValueError for a rigid body, or a grid without `dz`. The nz layers of volume
    fields lie at `depths`. Fields are read-only, and the most recent ones are cached. A pickled or
    copied state contains all data of its simulation, and does not depend on the original.
    """

    domain: Domain
    heat: Heat
    """Heating that applies to the next increment."""
    counters: Callable[[], dict[str, int]]
    """Function that returns counts of the computing work of the simulation so far."""
    _given_layers: int | None
    _tracks: dict[tuple[int, int], Track]

    def __init__(
        self,
        core: Any,
        setup: SimulationSetup,
        domain: Domain,
        heat: Heat,
        counters: Callable[[], dict[str, int]],
        layers: int | None = None,
    ) -> None:
        tracks: dict[tuple[int, int], Track] = {}
        vars(self).update(
            setup=setup, domain=domain, grid=domain.grid, heat=heat, counters=counters,
            _given_layers=layers, _tracks=tracks, _core=core,
        )  # fmt: skip

    @cached_property
    def depths(self) -> FloatArray:
        """Mid-layer depths of the volume fields [m], shape (nz,).

        The grid gives nz. By default, nz is at least 8, and so large that the layers cover all
        plastic strain of both bodies so far, and the stress to a depth of 1.5 contact radii.
        """
        return self.grid.depths(self.layers)

    @property
    def layers(self) -> int:
        """Number of layers of the volume fields."""
        return self._core.layers() if self._given_layers is None else self._given_layers

    def at_layers(self, layers: int) -> State:
        """Return this state with volume fields that have `layers` layers, >= 1."""
        integer("layers", layers, 1)
        if layers == self.layers:
            return self
        return State(self._core, self.setup, self.domain, self.heat, self.counters, layers)

    def _padded_to(self, window: State) -> State:
        """Return this state on the larger grid of another state."""
        core, layers = self._core.widened(window._core), self._given_layers
        return State(core, self.setup, window.domain, self.heat, self.counters, layers)

    @property
    def time(self) -> float:
        """Time since the start [s]; 0 unless there is `heat.history` or a viscoelastic body."""
        return float(self._core.time)

    @property
    def heat_factor(self) -> tuple[float, float]:
        """Heat flux into each body per unit pressure [m/s]; with heat.partition, fractions [-]."""
        return self._core.heat_factor1, self._core.heat_factor2

    @property
    def origin(self) -> float:
        """Position of the contact origin (x = 0) relative to the grid centre [m].

        The distance is at most half a cell. Cells of the grid coincide with cells of the
        elastic-plastic body (body 2 if both yield). The contact origin is displaced from the grid
        centre by the fraction of a cell that remains of the travel of this body.
        """
        return float(self._core.origin) * self.grid.dx

    def offset(self, body: int = 2) -> float:
        """Offset of the volume fields of a body from the cells of the grid along x [m].

        The offset is at most half a cell. It is zero unless two elastic-plastic bodies moved by
        different fractions of a cell.
        """
        return -float(self._core.offset[choice("body", body, (1, 2)) - 1]) * self.grid.dx

    def track(self, body: int = 2, margin: int | None = None) -> Track:
        """Return residual fields along the whole track of the contact on a body.

        Parameters
        ----------
        body : {1, 2}
        margin : int, optional
            Cells added at both ends of the strained part; none if periodic along x. Default: nx/4.

        Returns
        -------
        Track
            Fields are computed on access; MemoryError if the available memory is too small.
        """
        require_path_along_x(self, choice("body", body, (1, 2)))
        cells = self.grid.nx // 4 if margin is None else integer("margin", margin, 0)
        if cells > MAX_CELLS_ALONG_AXIS // 4:
            raise ValueError(f"margin must be <= {MAX_CELLS_ALONG_AXIS // 4} cells, got {cells}")
        if (key := (body, cells)) not in self._tracks:
            material = self.setup.bodies[body - 1]
            self._tracks[key] = Track(self._core, self.grid, body, cells, self.layers, material)
        return self._tracks[key]

    def zones(self, body: int = 2) -> tuple[Zone, ...]:
        """Return the non-overlapping subdomains that contain all plastic strain of a body.

        Parameters
        ----------
        body : {1, 2}

        Returns
        -------
        tuple of Zone
            Subdomains in which the plastic strain was computed, if there are several (see
            `Simulation`); otherwise a single subdomain, or none if there is no plastic strain. The
            fields of a Zone require memory for its own cells only, not for the whole grid.
        """
        found = ZoneStress(self._core, choice("body", body, (1, 2)))
        return tuple(Zone(self.grid, body, number, found) for number in range(len(found.boxes)))

    @property
    def converged(self) -> bool:
        """Whether contact and plastic flow have converged to the tolerance."""
        return bool(self._core.converged)

    @property
    def iterations(self) -> int:
        """Fixed-point iterations for the plastic strain in this increment; 0 if elastic."""
        return int(self._core.iterations)

    @property
    def contact_iterations(self) -> int:
        """Number of conjugate-gradient iterations in this increment."""
        return int(self._core.contact_iterations)

    @property
    def substeps(self) -> int:
        """Number of sub-increments of this increment; 1 if it was not subdivided."""
        return int(self._core.substeps)

    @property
    def plastic_strain_residual(self) -> float:
        """Relative change of the plastic strain increment at convergence [-]."""
        return float(self._core.plastic_residual)

    @property
    def yield_violation(self) -> float:
        """Maximum of (von Mises stress - yield stress)/yield stress at convergence [-]."""
        return float(self._core.yield_excess)

    def stress(self, body: int = 2) -> FloatArray:
        """Total stress [Pa], shape (6, nx, ny, nz)."""
        return self._field("stress", body)

    def residual_stress(self, body: int = 2) -> FloatArray:
        """Residual stress [Pa], shape (6, nx, ny, nz).

        It is the stress due to plastic strain plus `initial_stress` and `eigenstress`, without the
        stress due to tractions and heat. Loaded inclusions of different stiffness contribute to it.
        """
        return self._field("residual_stress", body)

    def initial_stress(self, body: int = 2) -> FloatArray:
        """Initial (residual) stress [Pa], shape (6, nx, ny, nz).

        It is given by `Material.with_residual_stress`; 0 without it.
        """
        return self._field("initial_stress", body)

    def eigenstress(self, body: int = 2) -> FloatArray:
        """Self-equilibrated stress due to the `eigenstrain` alone [Pa], shape (6, nx, ny, nz)."""
        return self._field("eigenstress", body)

    def eigenstrain(self, body: int = 2) -> FloatArray:
        """Sum of the strains added by `Simulation.add_eigenstrain` [-], shape (6, nx, ny, nz).

        It is not part of `plastic_strain`. For a `Heterogeneous` body, it includes the strain that
        represents the inclusions (their plastic strain, misfit and, under load, stiffness) in a
        homogeneous body of the matrix material. In a void, this strain is not unique.
        """
        return self._field("eigenstrain", body)

    def interface_stress(self, body: int = 2) -> FloatArray:
        """Total stress on both sides of the interfaces of a layered body [Pa].

        The shape is (2, 6, nx, ny, m): above and below each of m interfaces (`Layered.interfaces`).
        The components zz, yz and xz are continuous up to the grid error; xx, yy and xy jump. Stress
        due to tractions is exact at the interface; stress due to plastic strain and inclusions is
        extrapolated from three cells on each side (fewer in thinner layers), so it is inaccurate
        within three cells of an inclusion. Raises ValueError for a body without layers, or with an
        `offset`.
        """
        return self._field("interface_stress", body, lambda: self._at_interfaces(body))

    def _at_interfaces(self, body: int) -> FloatArray:
        layered = layered_body(self.setup.bodies, body, self.offset(body))
        tractions = self.pressure, self.shear if body == 2 else -self.shear

        def residual(layers: int) -> FloatArray:
            deep = self.at_layers(layers)
            return deep.residual_stress(body) - deep.initial_stress(body)

        strained = self.max_plastic_strain_magnitude(body) > 0 or self.has_eigenstrain(body)
        strained = strained or bool(np.any(self.share(body)))
        return stress_at_interfaces(self.grid, layered, tractions, residual if strained else None)

    def von_mises(self, body: int = 2) -> FloatArray:
        """Von Mises stress [Pa], shape (nx, ny, nz)."""
        return self._field("von_mises", body, lambda: von_mises(self.stress(body)))

    def hydrostatic(self, body: int = 2) -> FloatArray:
        """Mean normal stress [Pa], shape (nx, ny, nz)."""
        return self._field("hydrostatic", body, lambda: self.stress(body)[:3].mean(axis=0))

    def plastic_cells(self) -> int:
        """Number of cells of both bodies that have yielded, inside and outside the grid."""
        return int(self._core.plastic_cells(0)) + int(self._core.plastic_cells(1))

    def plastic_strain(self, body: int = 2) -> FloatArray:
        """Plastic strain [-], tensor components, shape (6, nx, ny, nz)."""
        return self._field("plastic_strain", body)

    def equivalent_plastic_strain(self, body: int = 2) -> FloatArray:
        """Accumulated equivalent plastic strain [-], shape (nx, ny, nz)."""
        return self._field("equivalent_plastic_strain", body)

    def backstress(self, body: int = 2) -> FloatArray:
        """Backstresses of kinematic hardening [Pa], shape (terms, 6, nx, ny, nz).

        Their sum is the centre of the yield surface. Without kinematic hardening, terms is 0.
        """
        return self._field("backstress", body)

    @cached_property
    def max_strains(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """`max_equivalent_plastic_strain` and `max_plastic_strain_magnitude` of each body [-]."""
        of, core = [], self._core
        for body in (0, 1):
            accumulated = core.max_equivalent_plastic_strain(body)
            of.append((float(accumulated), float(core.max_plastic_strain_magnitude(body))))
        return of[0], of[1]

    def max_equivalent_plastic_strain(self, body: int = 2) -> float:
        """Maximum accumulated equivalent plastic strain [-]; 0 for a body that cannot yield."""
        return self.max_strains[choice("body", body, (1, 2)) - 1][0]

    def max_plastic_strain_magnitude(self, body: int = 2) -> float:
        """Maximum magnitude sqrt(2/3 e:e) of the plastic strain e [-]; not cumulative.

        Defined by eq. (2.163) of Boucly (2008); 0 if elastic. Reversed flow decreases it, but
        increases the equivalent plastic strain. The small-strain theory requires values below 5 %.
        """
        return self.max_strains[choice("body", body, (1, 2)) - 1][1]

    def has_eigenstrain(self, body: int = 2) -> bool:
        """Whether an eigenstrain has been added to a body."""
        return bool(self._core.has_eigenstrain(choice("body", body, (1, 2)) - 1))

    def relief(self, body: int = 2) -> FloatArray:
        """Heights of a body's relief (moving topography) [m], shape (nx, ny); 0 without relief."""
        return self._field("relief", body)

    def residual_displacement(self, body: int = 2, axis: str = "z") -> FloatArray:
        """Residual normal displacement [m], shape (nx, ny), positive into the body.

        It is due to plastic strain and `eigenstrain`, and in viscoelastic bodies to creep that is
        not yet recovered. On a periodic grid, it is relative to great depth. With axis="x" or "y",
        it is the tangential displacement, positive along +x or +y of the grid for either body.
        """
        number = axis_number(axis)
        core, index = self._core, choice("body", body, (1, 2)) - 1
        return self._field(
            f"residual_displacement along {axis}", body,
            lambda: core.residual_displacement(index, number),
        )  # fmt: skip

    def surface_displacement(self, body: int = 2) -> FloatArray:
        """Normal surface displacement under load [m], shape (nx, ny), positive into the body."""
        return self._field("surface_displacement", body)

    def temperature(self, body: int = 2) -> FloatArray:
        """Temperature rise at the mid-layer depths [K], shape (nx, ny, nz)."""
        return self._field("temperature", body)

    def surface_temperature(self, body: int = 2) -> FloatArray:
        """Temperature rise of the surface (flash temperature) [K], shape (nx, ny)."""
        return self._field("surface_temperature", body)

    def softening(self, body: int = 2) -> FloatArray:
        """Factor on the yield stress due to thermal softening [-], shape (nx, ny, nz)."""
        known = self._core.softening(choice("body", body, (1, 2)) - 1)
        factor = np.ones((*self.grid.surface_shape, self.layers))
        if known is None:
            return factor
        layers = min(self.layers, known.shape[2])
        factor[:, :, :layers] = known[:, :, :layers]
        law = softening_of(self.setup.bodies[body - 1], self.grid.dz)
        if layers < self.layers and law is not None:
            factor[:, :, layers:] = law(self.temperature(body)[:, :, layers:], layers)
        return factor

    def _field(
        self, name: str, body: int, compute: Callable[[], FloatArray] | None = None
    ) -> FloatArray:
        """Return a field from the cache or else from `compute` (default: the compiled core)."""
        index = choice("body", body, (1, 2)) - 1
        return kept(self, (name, index), compute or (lambda: self._core_field(name, index)))

    def _core_field(self, name: str, index: int) -> FloatArray:
        if name in _VOLUME_FIELDS:
            strained = self._core.max_plastic_strain_magnitude(index) > 0
            exact = strained and self.setup.settings.residual_stress == "exact"
            cell = memory.EXACT_RESIDUAL_BYTES if exact else memory.VOLUME_FIELD_BYTES
            what = f"the field {name}"
            needed = memory.volume(self.grid, cell, self.layers)
            memory.require_for_grid(what, self.grid, needed)
            field: FloatArray = getattr(self._core, name)(index, self.layers)
        else:
            field = getattr(self._core, name)(index)
        return field

    def _rows(self) -> Rows:
        """Return the table rows of all quantities that need no volume field."""
        rows = [
            ("load", quantity(self.load, "N")),
            ("approach", quantity(self.approach, "m")),
            ("maximum pressure", quantity(float(self.pressure.max()), "Pa")),
            ("contact area", quantity(self.contact_area, "m²")),
        ]
        for body in (1, 2):
            strain = self.max_equivalent_plastic_strain(body=body)
            if strain > 0:
                name = f"maximum equivalent plastic strain, body {body}"
                rows.append((name, f"{100 * strain:.4g} %"))
        rows += rows_along_surface(self)
        rows += rows_of_travel(self)
        rows += [("time", quantity(self.time, "s"))] if self.time > 0 else []
        return [
            *rows,
            ("plastic iterations", str(self.iterations)),
            ("plastic residual", quantity(self.plastic_strain_residual)),
            ("yield violation", quantity(self.yield_violation)),
            ("converged", "yes" if self.converged else "no"),
        ]

    def __repr__(self) -> str:
        return (
            f"State(load={self.load:.6g} N, approach={self.approach:.6g} m, "
            f"max_pressure={self.pressure.max():.6g} Pa, iterations={self.iterations})"
        )
