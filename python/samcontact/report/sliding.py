# SPDX-License-Identifier: GPL-3.0-or-later
"""Report of steady sliding: friction, contact area and pressure at each velocity."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import plotting
from .._util.check import Check
from .._util.sliding_quantities import SLIDING
from .figures import ReportFigure, embedded
from .tables import maxima_table, values_table

if TYPE_CHECKING:
    import xarray as xr

REQUIRED_VARIABLES = ("velocity", "friction", "friction_force", "max_pressure")
MIN_FRICTION = -1e-3
"""Limit of the smallest friction coefficient, relative to the largest. A negative coefficient would
mean that sliding generates energy."""
ROUNDING_ERROR = 1e-9
"""Limit of the relative error of the load, unless the tolerance of the solver is larger."""
_VARIABLES = (
    "velocity", "load", "friction", "friction_force", "power", "contact_area", "contact_share",
    "max_pressure", "approach", "iterations", "error",
)  # fmt: skip


def content(dataset: xr.Dataset) -> dict[str, Any]:
    """Return the variables of the page template for sliding."""
    answers = maxima_table(dataset, "point", SLIDING, _VARIABLES[2:8])
    values = values_table(dataset, "point", SLIDING, _VARIABLES)
    return {
        "file": "sliding.nc",
        "answers": [("results", "Results", answers)],
        "values": [("velocities", "Velocities", values)],
        "figures": list(_figures(dataset)),
    }


def checks(dataset: xr.Dataset) -> Iterator[Check]:
    tol = float(dataset.attrs["tol"])
    if "pressure" in dataset:
        area = float(dataset.attrs["dx"]) * float(dataset.attrs["dy"])
        carried = dataset["pressure"].sum(("x", "y")).values * area
        name = "load balance: relative difference between integrated pressure and load"
        error = float(np.max(np.abs(carried / dataset["load"].values - 1)))
        yield Check(name, error, max(tol, ROUNDING_ERROR))
    name = "complementarity error: max |min(p/p_max, gap/u_max)|"
    yield Check(name, float(dataset["error"].max()), tol)
    friction = dataset["friction"].values
    largest = max(float(friction.max()), np.finfo(float).tiny)
    name = "smallest friction coefficient, relative to the largest"
    yield Check(name, float(friction.min()) / largest, MIN_FRICTION, at_least=True)


def _figures(dataset: xr.Dataset) -> Iterator[ReportFigure]:
    made = plotting.sliding.figures(dataset)
    speed, friction = dataset["velocity"].values, dataset["friction"].values
    peak = int(np.argmax(friction))
    text = "Friction coefficient and contact area versus the velocity. The largest coefficient is "
    text += f"{friction[peak]:.4g}, at {speed[peak]:.4g} m/s."
    yield embedded("Friction versus velocity", text, made["friction_over_velocity"])
    if "pressure_over_velocity" in made:
        text = "Pressure at the lowest velocity, at the largest friction and at the highest "
        text += "velocity. Body 1 slides towards +x if the velocity is positive."
        yield embedded("Pressure at three velocities", text, made["pressure_over_velocity"])
