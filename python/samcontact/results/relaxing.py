# SPDX-License-Identifier: GPL-3.0-or-later
"""Variables and attributes of the results dataset for viscoelastic bodies."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ..bodies.relaxation import RelaxationTerms
from ..bodies.viscoelastic import relaxation_of
from .motion import add

if TYPE_CHECKING:
    import xarray as xr

    from ..simulation.simulation import Simulation
    from ..solutions.state import State

_SURFACE = ("increment", "x", "y")


def add_relaxing(dataset: xr.Dataset, simulation: Simulation, states: Sequence[State]) -> None:
    """Add imprint, equivalent pressure and viscous work of each viscoelastic body.

    The imprint (variable `residual_displacement`) recovers with time. The equivalent pressure is
    the pressure that would give an elastic body the same displacement.
    """
    for body, material in enumerate((simulation.body1, simulation.body2), 1):
        if relaxation_of(material) is None:
            continue
        prints = np.stack([s.residual_displacement(body=body) for s in states])
        add(dataset, "residual_displacement", _SURFACE, prints, body)
        add(dataset, "imprint_depth", "increment", prints.max(axis=(1, 2)), body)
        pressures = np.stack([s.equivalent_pressure(body=body) for s in states])
        add(dataset, "equivalent_pressure", _SURFACE, pressures, body)
        work = [state.viscous_work(body=body) for state in states]
        add(dataset, "viscous_work", "increment", np.array(work), body)


def relaxation_attributes(prefix: str, terms: RelaxationTerms | None) -> dict[str, Any]:
    """Return relaxation times and shares as dataset attributes named with `prefix`."""
    if terms is None:
        return {}
    named = zip(("times", "shares"), terms, strict=True)
    return {f"{prefix}relaxation_{name}": list(values) for name, values in named}
