# SPDX-License-Identifier: GPL-3.0-or-later
"""Energy balance of two bodies over successive increments."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from .._util.checks import FloatArray, require_list, require_type
from .._util.display import HtmlTable, Rows, percent, quantity
from ..bodies.heterogeneous import Heterogeneous
from ..bodies.layered import Body, backstresses_of, matrix_of
from ..bodies.viscoelastic import instantaneous, relaxation_of
from ..contact.solver import ContactSolver
from ..problem.friction import friction_law
from ..solutions.state import State, on_common_grid
from .mismatch import mismatch_energy, not_balanced, work_with_inclusions
from .motion import Motion, have_equal_eigenstrain, over_grid
from .sliding import correction_of_sliding
from .work import (
    cell_volume,
    eigenstrain_energy,
    isotropic_work,
    plastic_work,
    product,
    residual_energy,
    work_of_backstress,
)

if TYPE_CHECKING:
    from ..simulation.simulation import Simulation


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
        Elastic energy due to the current tractions [J], including that stored in viscoelastic
        bodies. For a body with inclusions, its whole elastic energy.
    residual_energy : float
        Elastic energy of the residual stress of bodies without inclusions [J].
    friction_work, plastic_work : float
        Energy dissipated by friction, and by plastic flow [J].
    eigenstrain_energy : float
        Elastic energy due to prescribed eigenstrain alone [J]; it is not supplied by external work.
    expansion_work : float
        Work of thermal expansion, which the heat supplies [J]: work of the rising surfaces against
        the pressure, plus work of the thermal stress on the plastic strain.
    viscous_work : float
        Energy dissipated by the viscosity of both bodies [J].
    """

    work_input: float
    net_external_work: float
    elastic_energy: float
    residual_energy: float
    friction_work: float
    plastic_work: float
    eigenstrain_energy: float = 0.0
    expansion_work: float = 0.0
    viscous_work: float = 0.0

    @property
    def imbalance(self) -> float:
        """(Net external work + expansion work - stored - dissipated energy)/(work input) [-]."""
        found = self.elastic_energy + self.residual_energy + self.friction_work + self.plastic_work
        found += self.viscous_work
        supplied = self.net_external_work + self.expansion_work
        return (supplied - found) / self.work_input if self.work_input > 0 else 0.0

    def _rows(self) -> Rows:
        parts = [
            "work_input", "net_external_work", "elastic_energy", "residual_energy",
            "friction_work", "plastic_work",
        ]  # fmt: skip
        parts += ["eigenstrain_energy"] if self.eigenstrain_energy > 0 else []
        parts += ["expansion_work"] if self.expansion_work != 0 else []
        parts += ["viscous_work"] if self.viscous_work != 0 else []
        rows = [(name.replace("_", " "), quantity(getattr(self, name), "J")) for name in parts]
        return [*rows, ("imbalance", percent(self.imbalance))]


def balance(simulation: Simulation, states: Sequence[State]) -> EnergyBalance:
    """Return the energy balance of a contact that is pressed, moves, slides or rolls.

    The work of an increment is the mean force times the motion. For the mean load, the load is
    assumed to be proportional to the power 3/2 of the approach, which is exact for elastic balls
    under normal load. In an increment in which the whole contact comes to slide, the tangential
    force is assumed to reach the friction limit as for elastic balls under constant load, and then
    to remain at this limit. `EnergyBalance.imbalance` is smaller with smaller increments. The
    energy of the first state is part of the work input. The work of thermal expansion in an
    increment is the mean pressure times the change of the thermal displacement, plus the mean
    thermal stress times the plastic strain increment. If the surface of a body has a slope, the
    pressure does work when the body travels, e.g. the work of rolling resistance. In full sliding,
    the bodies move tangentially by their travel alone. The friction work follows from this motion
    and from the tangential displacement of the surfaces. With thermal softening, the mean of the
    yield stresses at the start and the end of an increment is used.

    Parameters
    ----------
    simulation : Simulation
    states : sequence of State
        Successive increments.

    Returns
    -------
    EnergyBalance

    Raises
    ------
    ValueError
        The contact is adhesive, the bodies slide against the direction of the friction, the
        eigenstrain changes, tractions are prescribed, or there are no states.
    """
    from ..simulation.simulation import Simulation

    require_type("simulation", simulation, Simulation)
    require_list("states", states, State)
    reason = no_balance(simulation, states)
    if reason:
        raise ValueError(reason)
    states = on_common_grid(states)
    first, last = (_energies(simulation, states[:n]) for n in (1, len(states)))
    before = sum(first.values()) - first["eigenstrain_energy"]
    work = _work(simulation, states)
    given_back = float(work[work < 0].sum())
    net = before + float(work.sum())
    expansion = float(_expansion_work(simulation, states))
    return EnergyBalance(
        work_input=net - given_back, net_external_work=net, expansion_work=expansion, **last
    )


def _energies(simulation: Simulation, states: Sequence[State]) -> dict[str, float]:
    """Return the energies of the last state [J], by the names of attributes of `EnergyBalance`."""
    residual = plastic = given = 0.0
    for number, body in enumerate(_bodies(simulation), 1):
        if states[-1].has_eigenstrain(number):
            given += eigenstrain_energy(states[-1].track(number, margin=0))
        if not body.is_plastic:
            continue
        if isinstance(body, Heterogeneous):
            plastic += work_with_inclusions(body, number, states)
        elif states[-1].max_plastic_strain_magnitude(number) > 0:
            residual += residual_energy(states[-1].track(number, margin=0))
            plastic += _plastic_work_of(body, number, states)
    return {
        "elastic_energy": _elastic_energy(simulation, states[-1]),
        "viscous_work": sum(states[-1].viscous_work(body) for body in (1, 2)),
        "residual_energy": residual,
        "friction_work": _friction_work(simulation, states),
        "plastic_work": plastic,
        "eigenstrain_energy": given,
    }


def _bodies(simulation: Simulation) -> tuple[Body, Body]:
    return simulation.body1, simulation.body2


def _slides_fully(simulation: Simulation) -> bool:
    return not friction_law(simulation.friction).sticks


def no_balance(simulation: Simulation, states: Sequence[State]) -> str:
    """Return the reason why no energy balance can be computed, or "" if it can be computed."""
    if not states:
        return "states must contain at least one state, got none"
    if friction_law(simulation.friction).compliance > 0:
        return (
            "an energy balance is not available with a layer between the bodies "
            f"(friction = {simulation.friction!r}), whose elastic energy is not computed"
        )
    if simulation.adhesion.attracts:
        return (
            f"adhesion must not attract, got {simulation.adhesion!r}: the energy stored by "
            "attraction is not included in the balance"
        )
    if reason := not_balanced(_bodies(simulation), states):
        return reason
    if not all(have_equal_eigenstrain(*pair) for pair in pairwise(states)):
        return (
            "states must have equal eigenstrain: the work of adding eigenstrain is not included in "
            "the balance"
        )
    if not all(np.isfinite(state.approach) for state in states):
        return "states must result from a load or an approach, got prescribed tractions"
    if any(any(state.lateral_travel) for state in states):
        return "states must not have moved along y: the balance omits the work of this motion"
    if _slides_fully(simulation):
        slid = np.diff([state.travel[0] - state.travel[1] for state in states])
        if np.any(slid * friction_law(simulation.friction).sliding_ratio < 0):
            return (
                f"friction must oppose the sliding, got {simulation.friction!r}: reverse its sign, "
                "or exchange the advance of body 1 and of body 2"
            )
    return ""


def _plastic_work_of(material: Body, body: int, states: Sequence[State]) -> float:
    """Return the plastic work up to the last state [J], summed over increments where necessary."""
    if material.softening is not None:
        return _softened_work(material, body, states)
    if backstresses_of(material) == 0:
        return plastic_work(material, states[-1].track(body, margin=0))
    before = states[0].track(body, margin=0)
    total = plastic_work(material, before)
    for state in states[1:]:
        if state.iterations > 0:
            after = state.track(body, margin=0)
            total += plastic_work(material, after, before)
            before = after
    return float(total)


def _softened_work(material: Body, body: int, states: Sequence[State]) -> float:
    """Return the plastic work of a body whose yield stress depends on the temperature [J].

    The factor on the yield stress is the mean of the factors at the start and the end of each
    increment; in the first increment, it is the factor at the end.
    """
    layers = max(state.layers for state in states)
    deep = [state.at_layers(layers) for state in states]
    tracks = [state.track(body, margin=0) for state in deep]
    total = np.sum(deep[0].softening(body) * isotropic_work(material, tracks[0], deep[0]))
    if backstresses_of(material) > 0:
        total += work_of_backstress(tracks[0], None)
    for (before, now), (track, new) in zip(pairwise(deep), pairwise(tracks), strict=True):
        if now.iterations == 0:
            continue
        softened = now.softening(body)
        earlier = Motion(before, now, body).convected(before.softening(body), softened)
        done = isotropic_work(material, new, now) - isotropic_work(material, track, now)
        total += np.sum(0.5 * (earlier + softened) * done)
        if backstresses_of(material) > 0:
            total += work_of_backstress(new, track)
    return float(total) * cell_volume(tracks[-1])


def _work(simulation: Simulation, states: Sequence[State]) -> FloatArray:
    """Return the work of forces, moments and travel in each increment after the first [J]."""
    values = np.array([_forces_and_motions(simulation, state) for state in states])
    load, approach = values[:, 0], values[:, 1]
    forces, motions = values[:, 2:7], values[:, 7:]
    along: FloatArray = np.sum(0.5 * (forces[1:] + forces[:-1]) * np.diff(motions, axis=0), axis=1)
    normal: FloatArray = _mean_load(load[:-1], load[1:]) * np.diff(approach)
    sliding = correction_of_sliding(friction_law(simulation.friction), states)
    return along + normal + sliding + _work_of_travel(simulation, states)


def _forces_and_motions(simulation: Simulation, state: State) -> tuple[float, ...]:
    """Return load, approach, the other forces and moments, and the motions on which these work."""
    forces = (state.load, state.approach, *state.tangential_load, state.torque, *state.moment)
    if _slides_fully(simulation):
        return *forces, state.travel[0] - state.travel[1], 0.0, 0.0, *state.tilt
    return *forces, *state.shift, state.twist, *state.tilt


def _work_of_travel(simulation: Simulation, states: Sequence[State]) -> FloatArray:
    """Return the work done on sloped surfaces that move through the pressure, by increment [J]."""
    work = np.zeros(len(states) - 1)
    if not any(any(state.travel) for state in states):
        return work
    for body, material in enumerate(_bodies(simulation), 1):
        depth = [_depth_of_surface(material, body, state) for state in states]
        for n, (before, after) in enumerate(pairwise(states)):
            pressures, surfaces = (before.pressure, after.pressure), (depth[n], depth[n + 1])
            found = Motion(before, after, body).work_of_travel(pressures, surfaces)
            work[n] += after.grid.cell_area * found
    return work


def _depth_of_surface(material: Body, body: int, state: State) -> FloatArray:
    """Return the depth of a deformed surface with its relief [m], shape (nx, ny)."""
    return state.surface_displacement(body) - state.relief(body)


def _friction_work(simulation: Simulation, states: Sequence[State]) -> float:
    """Return the energy dissipated by friction up to the last state [J].

    In full sliding, the work is counted from the first state. It is the work of the shear traction
    on the relative travel, minus the work of this traction on the tangential displacement of the
    surfaces.
    """
    if not _slides_fully(simulation):
        return states[-1].friction_work
    if friction_law(simulation.friction).is_frictionless:
        return 0.0
    total = 0.0
    for before, after in pairwise(states):
        force = 0.5 * (before.tangential_load[0] + after.tangential_load[0])
        total += force * sum(
            sign * (now - then)
            for sign, now, then in zip((1, -1), after.travel, before.travel, strict=True)
        )
    for body, sign in ((1, -1.0), (2, 1.0)):
        moved = [_tangential_displacement(simulation, state, body) for state in states]
        for n, (before, after) in enumerate(pairwise(states)):
            shear = sign * before.shear, sign * after.shear
            done = Motion(before, after, body).change(shear, (moved[n], moved[n + 1]))
            total -= after.grid.cell_area * done
    return float(total)


def _tangential_displacement(simulation: Simulation, state: State, body: int) -> FloatArray:
    """Return the tangential displacement of a surface [m], shape (2, nx, ny)."""
    solver = _elastic_solver(simulation, state)
    elastic = solver.displacement(state.pressure, state.shear, body)[:2]
    return elastic + np.stack([state.residual_displacement(body, axis) for axis in "xy"])


def _mean_load(first: FloatArray, second: FloatArray) -> FloatArray:
    """Return the mean load between two states [N] if load^(2/3) is linear in the approach."""
    a, b = (np.maximum(load, 0.0) ** (2 / 3) for load in (first, second))
    nearly_equal = np.abs(b - a) <= 1e-3 * np.maximum(a, b)
    change = np.where(nearly_equal, 1.0, b - a)
    return np.where(nearly_equal, 0.5 * (first + second), 0.4 * (b**2.5 - a**2.5) / change)


def _expansion_work(simulation: Simulation, states: Sequence[State]) -> float:
    """Return the work of thermal expansion against the pressure and on the plastic strain [J]."""
    total = 0.0
    for body, material in enumerate(_bodies(simulation), 1):
        if material.thermal is None or not any(
            np.any(state.surface_temperature(body)) for state in states
        ):
            continue
        area = states[-1].grid.cell_area
        risen = [_thermal_displacement(simulation, state, body) for state in states]
        for n, (before, after) in enumerate(pairwise(states)):
            pressures = before.pressure, after.pressure
            motion = Motion(before, after, body)
            total -= area * motion.change(pressures, (risen[n], risen[n + 1]))
        if material.is_plastic:
            total += _expansion_work_on_strain(simulation, states, body)
    return float(total)


def _thermal_displacement(simulation: Simulation, state: State, body: int) -> FloatArray:
    solver = _elastic_solver(simulation, state)
    cold = solver.displacement(state.pressure, state.shear, body)[2]
    risen: FloatArray = state.surface_displacement(body) - cold
    return risen - state.residual_displacement(body)


def _expansion_work_on_strain(simulation: Simulation, states: Sequence[State], body: int) -> float:
    """Return the work of the thermal stress on the plastic strain [J]."""
    total, layers = 0.0, max(state.layers for state in states)
    deep = [state.at_layers(layers) for state in states]
    stresses = [_thermal_stress(simulation, state, body) for state in deep]
    tracks = [state.track(body, margin=0) for state in deep]
    for n, (before, after) in enumerate(pairwise(deep)):
        earlier = Motion(before, after, body).convected(stresses[n], stresses[n + 1])
        mean = 0.5 * (earlier + stresses[n + 1])
        strains = (over_grid(track, "plastic_strain", after) for track in tracks[n : n + 2])
        then, now = strains
        total += product(mean, now - then)
    return total * cell_volume(tracks[-1])


def _thermal_stress(simulation: Simulation, state: State, body: int) -> FloatArray:
    solver = _elastic_solver(simulation, state)
    cold = solver.stress(state.pressure, state.depths, body, shear=state.shear)
    return state.stress(body) - cold - state.residual_stress(body)


def _elastic_solver(simulation: Simulation, state: State) -> ContactSolver:
    body1, body2 = map(instantaneous, map(matrix_of, _bodies(simulation)))
    return ContactSolver(state.grid, body1, body2, simulation.friction, on_border="warn")


def _elastic_energy(simulation: Simulation, state: State) -> float:
    """Return the elastic energy due to the tractions [J].

    For elastic bodies, it is half the work of the tractions on the elastic displacement that they
    cause. For viscoelastic bodies, it is the supplied work minus the viscous work. The change of
    energy due to inclusions is added.
    """
    solver = _elastic_solver(simulation, state)
    pressure, shear = state.pressure, state.shear
    relaxing = [relaxation_of(body) is not None for body in _bodies(simulation)]
    first, second = (
        np.zeros((3, *pressure.shape)) if relaxes else solver.displacement(pressure, shear, body)
        for body, relaxes in enumerate(relaxing, 1)
    )
    done = np.sum(pressure * (first[2] + second[2])) + np.sum(shear * (second - first)[:2])
    stored = sum(state.stored_energy(body) for body, relaxes in enumerate(relaxing, 1) if relaxes)
    stored += mismatch_energy(_bodies(simulation), state)
    return float(0.5 * state.grid.cell_area * done + stored)
