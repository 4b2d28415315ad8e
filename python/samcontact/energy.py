# SPDX-License-Identifier: GPL-3.0-or-later
"""Energy of elastic-plastic contact: plastic dissipation and energy of residual stress."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ._util.checks import FloatArray, require_list, require_type
from ._util.display import HtmlTable, Rows, percent, quantity
from ._util.short_text import in_short
from .bodies.layered import Body, backstresses_of, materials_at
from .contact.solver import ContactSolver
from .problem.friction import friction_law
from .solutions.common_cells import on_common_cells
from .solutions.track import Track

if TYPE_CHECKING:
    from .simulation.simulation import Simulation
    from .solutions.state import State

__all__ = ["EnergyBalance", "balance", "eigenstrain_energy", "plastic_work", "residual_energy"]


def _cell_volume(track: Track) -> float:
    grid = track.grid
    return grid.dx * grid.dy * (grid.dz or 0.0)


def _product(a: FloatArray, b: FloatArray) -> float:
    """Return the sum of a:b over all cells; the first axis contains the tensor components."""
    return float(np.sum(a[:3] * b[:3]) + 2.0 * np.sum(a[3:] * b[3:]))


def plastic_work(material: Body, after: Track, before: Track | None = None) -> float:
    """Plastic work of a body, the integral of sigma : d eps^p [J].

    The work of the isotropic yield stress is integrated in closed form and depends only on the
    states `before` and `after`. The work of the backstress is computed with the mean backstress of
    both states. The error of this mean is of second order in the size of the increment, so add up
    the work of all increments.

    Parameters
    ----------
    material : Material or Layered
        Material of the body.
    after : Track
        Track of the body in the current state, from `State.track`.
    before : Track, optional
        Track of the body in an earlier state. Default: before any plastic flow.

    Returns
    -------
    float
        Plastic work [J], >= 0 except for the error due to the mean backstress. Work of the
        backstress is partly recoverable.

    Raises
    ------
    ValueError
        The material has thermal softening: the yield stress does not follow from the state alone.
    """
    if not isinstance(material, Body):
        raise TypeError(
            f"material must be a samcontact.Material or samcontact.Layered, got "
            f"{in_short(material)}"
        )
    for name, track in (("after", after), ("before", after if before is None else before)):
        require_type(name, track, Track)
    if material.softening is not None:
        raise ValueError(
            "material must have no thermal softening: pass a material without softening"
        )
    if not material.is_plastic:
        return 0.0
    total = _isotropic_work(material, after)
    if before is not None:
        total -= _isotropic_work(material, before)
    if backstresses_of(material) > 0:
        total += _work_of_backstress(after, before)
    return float(total) * _cell_volume(after)


def _isotropic_work(body: Body, track: Track) -> float:
    """Return the work of the isotropic yield stress, summed over cells [J/m^3]."""
    factor, strain = track.yield_factor(), track.equivalent_plastic_strain()
    return sum(
        float(np.sum(factor[..., there] * material.plastic_work(strain[..., there])))
        for material, there in materials_at(body, track.z)
    )


def _work_of_backstress(after: Track, before: Track | None) -> float:
    """Return the work of the mean backstress on the strain increment, summed over cells [J/m^3]."""
    if before is None:
        return 0.5 * _product(after.backstress().sum(axis=0), after.plastic_strain())
    old, new = on_common_cells(before, after, "backstress")
    start, end = on_common_cells(before, after, "plastic_strain")
    return 0.5 * _product((old + new).sum(axis=0), end - start)


def residual_energy(track: Track) -> float:
    """Elastic energy of the residual stress of a body [J], -1/2 of the integral of sigma : eps^p.

    The residual stress is in equilibrium without tractions. The work of this stress on the total
    strain therefore vanishes, and in the integral of the elastic energy the elastic strain can be
    replaced by minus the plastic strain. This energy can be released, but not by contact alone.
    Mura, *Micromechanics of Defects in Solids* (1987), eq. (13.4).

    For a body with initial stress or eigenstrain, the result is the change of elastic energy due to
    plastic strain; this change may be negative. The work of the initial stress on the plastic
    strain enters without the factor 1/2.
    """
    require_type("track", track, Track)
    stress = track.residual_stress() + track.initial_stress() + track.eigenstress()
    return -0.5 * _product(stress, track.plastic_strain()) * _cell_volume(track)


def eigenstrain_energy(track: Track) -> float:
    """Elastic energy of a body under its prescribed eigenstrain alone [J], >= 0.

    The energy is -1/2 of the integral of sigma : eps, with the eigenstrain eps and the stress sigma
    due to this eigenstrain, as in `residual_energy`. Tractions do not change this energy, because
    the stress due to tractions does practically no work on the elastic strain due to the
    eigenstrain.
    """
    require_type("track", track, Track)
    return -0.5 * _product(track.eigenstress(), track.eigenstrain()) * _cell_volume(track)


@dataclass(frozen=True)
class EnergyBalance(HtmlTable):
    """Energy balance of two bodies: external work, stored energies and dissipation.

    Attributes
    ----------
    work_input : float
        Work input: sum over the increments with positive work [J].
    net_external_work : float
        Net external work: work input minus the work recovered in increments with negative work [J].
    elastic_energy : float
        Elastic energy due to the current tractions [J].
    residual_energy : float
        Elastic energy of the residual stress [J].
    friction_work, plastic_work : float
        Energy dissipated by friction, and by plastic flow [J].
    eigenstrain_energy : float
        Elastic energy of prescribed eigenstrain alone [J]; not part of the external work.
    expansion_work : float
        Work of thermal expansion [J]: against the pressure, which heated surfaces push back, and of
        the thermal stress on the plastic strain. Heat supplies it.
    """

    work_input: float
    net_external_work: float
    elastic_energy: float
    residual_energy: float
    friction_work: float
    plastic_work: float
    eigenstrain_energy: float = 0.0
    expansion_work: float = 0.0

    @property
    def imbalance(self) -> float:
        """(Net work of forces and expansion - stored - dissipated energy)/(work input) [-]."""
        found = self.elastic_energy + self.residual_energy + self.friction_work + self.plastic_work
        supplied = self.net_external_work + self.expansion_work
        return (supplied - found) / self.work_input if self.work_input > 0 else 0.0

    def _rows(self) -> Rows:
        parts = [
            "work_input", "net_external_work", "elastic_energy", "residual_energy",
            "friction_work", "plastic_work",
        ]  # fmt: skip
        parts += ["eigenstrain_energy"] if self.eigenstrain_energy > 0 else []
        parts += ["expansion_work"] if self.expansion_work != 0 else []
        rows = [(name.replace("_", " "), quantity(getattr(self, name), "J")) for name in parts]
        return [*rows, ("imbalance", percent(self.imbalance))]


def balance(simulation: Simulation, states: Sequence[State]) -> EnergyBalance:
    """Return the energy balance of a contact with partial slip and without rolling.

    The work of an increment is the mean force times the motion. The mean load is computed for a
    load proportional to the power 3/2 of the approach, which is exact for elastic balls under
    normal load. `EnergyBalance.imbalance` decreases with the size of the increments. The energy of
    the first state is part of the work input. Bodies may be heated; the work of their expansion is
    the mean pressure of an increment times the change of the thermal displacement, plus the mean
    thermal stress times the plastic strain increment.

    Parameters
    ----------
    simulation : Simulation
        Simulation with friction=`Coulomb`.
    states : sequence of State
        Successive increments.

    Returns
    -------
    EnergyBalance

    Raises
    ------
    ValueError
        The friction is a number (full sliding); the contact rolls or is adhesive; a body has
        thermal softening; the eigenstrain changes; tractions are prescribed; or there are no
        states.
    """
    from .simulation.simulation import Simulation
    from .solutions.state import State

    require_type("simulation", simulation, Simulation)
    require_list("states", states, State)
    reason = no_balance(simulation, states)
    if reason:
        raise ValueError(reason)
    first, last = (_energies(simulation, states[:n]) for n in (1, len(states)))
    before, work = sum(first.values()) - first["eigenstrain_energy"], _work(states)
    given_back = float(work[work < 0].sum())
    net = before + float(work.sum())
    expansion = float(_expansion_work(simulation, states))
    return EnergyBalance(
        work_input=net - given_back, net_external_work=net, expansion_work=expansion, **last
    )


def _energies(simulation: Simulation, states: Sequence[State]) -> dict[str, float]:
    """Return the energies of the last state [J], by the names of attributes of `EnergyBalance`."""
    residual = plastic = given = 0.0
    for number, body in enumerate((simulation.body1, simulation.body2), 1):
        if states[-1].has_eigenstrain(number):
            given += eigenstrain_energy(states[-1].track(number, margin=0))
        if not body.is_plastic:
            continue
        if states[-1].max_plastic_strain_magnitude(number) > 0:
            residual += residual_energy(states[-1].track(number, margin=0))
            plastic += _plastic_work_of(body, number, states)
    elastic, friction = _elastic_energy(simulation, states[-1]), states[-1].friction_work
    return {
        "elastic_energy": elastic,
        "residual_energy": residual,
        "friction_work": friction,
        "plastic_work": plastic,
        "eigenstrain_energy": given,
    }


def _plastic_work_of(material: Body, body: int, states: Sequence[State]) -> float:
    """Return the plastic work up to the last state [J]; with backstress, summed over increments."""
    if backstresses_of(material) == 0:
        return plastic_work(material, states[-1].track(body, margin=0))
    before = states[0].track(body, margin=0)
    total = plastic_work(material, before)
    for state in states[1:]:
        if state.iterations > 0:
            after = state.track(body, margin=0)
            total += plastic_work(material, after, before)
            before = after
    return total


def no_balance(simulation: Simulation, states: Sequence[State]) -> str:
    """Return the reason why no energy balance can be computed; "" if it can be computed."""
    if not states:
        return "states must contain at least one state, got none"
    if not friction_law(simulation.friction).sticks:
        return (
            f"friction must be samcontact.Coulomb(mu), got {simulation.friction!r}: full sliding "
            "leaves the tangential motion undefined"
        )
    if simulation.contact_law.attracts:
        return (
            f"contact_law must not attract, got {simulation.contact_law!r}: the energy stored by "
            "attraction is not included in the balance"
        )
    if any(any(state.travel) for state in states):
        return "states must have no travel: the energy balance does not support rolling"
    if not all(_have_equal_eigenstrain(states[0], state) for state in states):
        return (
            "states must have equal eigenstrain: the work of adding eigenstrain is not included in "
            "the balance"
        )
    if not all(np.isfinite(state.approach) for state in states):
        return "states must be from load or approach control, got prescribed tractions"
    for body in (simulation.body1, simulation.body2):
        if body.softening is not None:
            return f"bodies must have no thermal softening, got {body!r}"
    return ""


def _have_equal_eigenstrain(one: State, other: State) -> bool:
    """Whether the eigenstrain of each body is the same in two states."""
    bodies = [n for n in (1, 2) if one.has_eigenstrain(n) or other.has_eigenstrain(n)]
    if not bodies:
        return True
    layers = max(one.layers, other.layers)
    a, b = one.at_layers(layers), other.at_layers(layers)
    return all(np.array_equal(a.eigenstrain(body), b.eigenstrain(body)) for body in bodies)


def _work(states: Sequence[State]) -> FloatArray:
    """Return the work of forces and moments in each increment after the first [J]."""
    rows = [
        (s.load, s.approach, *s.tangential_load, s.torque, *s.moment, *s.shift, s.twist, *s.tilt)
        for s in states
    ]
    values = np.array(rows)
    load, approach = values[:, 0], values[:, 1]
    forces, motions = values[:, 2:7], values[:, 7:]
    along: FloatArray = np.sum(0.5 * (forces[1:] + forces[:-1]) * np.diff(motions, axis=0), axis=1)
    normal: FloatArray = _mean_load(load[:-1], load[1:]) * np.diff(approach)
    return along + normal


def _mean_load(first: FloatArray, second: FloatArray) -> FloatArray:
    """Return the mean load between two states [N], with load^(2/3) linear in the approach."""
    a, b = (np.maximum(load, 0.0) ** (2 / 3) for load in (first, second))
    nearly_equal = np.abs(b - a) <= 1e-3 * np.maximum(a, b)
    change = np.where(nearly_equal, 1.0, b - a)
    return np.where(nearly_equal, 0.5 * (first + second), 0.4 * (b**2.5 - a**2.5) / change)


def _expansion_work(simulation: Simulation, states: Sequence[State]) -> float:
    """Return the work of thermal expansion on the pressure and on the plastic strain [J]."""
    total = 0.0
    for number, body in enumerate((simulation.body1, simulation.body2), 1):
        if body.thermal is None or not any(np.any(s.surface_temperature(number)) for s in states):
            continue
        grid = states[-1].grid
        layers = max(state.layers for state in states) if body.is_plastic else 0
        before = None
        for state in states:
            now = _expansion(simulation, state, number, layers)
            if before is not None:
                mean = [0.5 * (a + b) for a, b in zip(before, now, strict=True)]
                change = [b - a for a, b in zip(before, now, strict=True)]
                total -= grid.cell_area * float(np.sum(mean[0] * change[1]))
                total += grid.cell_area * (grid.dz or 0.0) * _product(mean[2], change[3])
            before = now
    return total


def _expansion(
    simulation: Simulation, state: State, body: int, layers: int
) -> tuple[FloatArray, ...]:
    """Return pressure, thermal displacement, thermal stress and plastic strain of a body.

    layers: number of layers of stress and strain; 0 for an elastic body, which needs neither.
    """
    solver, pressure, shear = _elastic_solver(simulation, state), state.pressure, state.shear
    cold = solver.displacement(pressure, shear, body)[2] + state.residual_displacement(body)
    risen = state.surface_displacement(body) - cold
    if layers == 0:
        return pressure, risen, np.zeros(6), np.zeros(6)
    deep = state.at_layers(layers)
    stress = solver.stress(pressure, deep.depths, body, shear=shear) + deep.residual_stress(body)
    return pressure, risen, deep.stress(body) - stress, deep.plastic_strain(body)


def _elastic_solver(simulation: Simulation, state: State) -> ContactSolver:
    bodies = simulation.body1, simulation.body2
    return ContactSolver(state.grid, *bodies, simulation.friction, on_border="warn")


def _elastic_energy(simulation: Simulation, state: State) -> float:
    """Return half the work [J] of the tractions on the elastic displacement that they cause."""
    solver = _elastic_solver(simulation, state)
    pressure, shear = state.pressure, state.shear
    first, second = (solver.displacement(pressure, shear, body) for body in (1, 2))
    done = np.sum(pressure * (first[2] + second[2])) + np.sum(shear * (second - first)[:2])
    return float(0.5 * state.grid.cell_area * done)
