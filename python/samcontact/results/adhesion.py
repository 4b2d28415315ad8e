# SPDX-License-Identifier: GPL-3.0-or-later
"""Variables and attributes of the results dataset for a contact with adhesion."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ..diagnostics.hertz_estimate import ContactSetup
from ..problem.adhesion_laws import ResolvedAdhesion, resolved_of
from .motion import add

if TYPE_CHECKING:
    import xarray as xr

    from ..simulation.simulation import Simulation
    from ..solutions.state import State

_SURFACE = ("increment", "x", "y")
_MAX_ELLIPTICITY = 1.02
"""Maximum ratio of the two radii of a paraboloid that counts as a sphere."""


def add_adhesion(dataset: xr.Dataset, simulation: Simulation, states: Sequence[State]) -> None:
    """Add the variables of adhesion to the dataset; add nothing for a contact without adhesion.

    These variables are the repulsion and the energy of the attraction. If the attraction depends on
    the gap, the adhesion stress and the work of the load are added too. The work is summed from the
    first increment by the trapezoidal rule. When the approach has returned to its initial value,
    this work is the energy lost in jumps and plastic flow.
    """
    if not simulation.adhesion.attracts:
        return
    add(dataset, "repulsion", _SURFACE, np.stack([s.repulsion for s in states]))
    add(dataset, "attraction_energy", "increment", [s.attraction_energy for s in states])
    if not simulation.adhesion.varies:
        return
    add(dataset, "adhesion_stress", _SURFACE, np.stack([s.adhesion_stress for s in states]))
    load, approach = dataset["load"].values, dataset["approach"].values
    steps = 0.5 * (load[1:] + load[:-1]) * np.diff(approach)
    add(dataset, "load_work", "increment", np.append(0.0, np.cumsum(steps)))


def adhesion_attributes(simulation: Simulation, states: Sequence[State]) -> dict[str, Any]:
    """Return the attributes of adhesion: law and constants used on the grid, and pull-off force."""
    law = simulation.adhesion
    if not law.attracts:
        return {}
    tree = law.to_tree()
    found = {"adhesion": tree.pop("kind")}
    found |= {f"adhesion_{name}": value for name, value in tree.items()}
    domain, bodies = states[0].domain, (simulation.body1, simulation.body2)
    resolved = resolved_of(law, domain.grid, *bodies)
    if resolved is None:
        return found
    loads = np.array([state.load for state in states])
    if loads.min() < 0:
        found["pull_off"] = float(-loads.min())
        found["pull_off_increment"] = int(loads.argmin()) + 1
    relieved = any(relief is not None for relief in domain.reliefs)
    setup = ContactSetup(domain.grid, np.asarray(domain.initial_gap), bodies, relieved)
    return found | _resolved_attributes(resolved, setup.radii)


def _resolved_attributes(
    resolved: ResolvedAdhesion, radii: tuple[float, float] | None
) -> dict[str, Any]:
    found = {
        "kappa": resolved.kappa,
        "range_used": resolved.range,
        "work_used": resolved.work,
        "peak_used": resolved.law.peak,
        "modulus_used": resolved.modulus,
    }
    if radii is not None and radii[0] <= _MAX_ELLIPTICITY * radii[1]:
        radius = float(np.sqrt(radii[0] * radii[1]))
        found |= {"radius_used": radius, "tabor": resolved.tabor(radius)}
    return found
