# SPDX-License-Identifier: GPL-3.0-or-later
"""Films of lubricated contacts as one labelled dataset, and back."""

from __future__ import annotations

import math
from collections.abc import Sequence
from datetime import datetime, timezone
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from .._util.checks import require_type
from .._util.film_quantities import FILMS
from .._util.version import version
from ..lubricants.stored import restored, stored
from ..lubrication import Boundary, FilmLevel, FilmSolution, friction, lambda_ratio
from ..lubrication.balance import (
    cells_per_radius,
    flow_imbalance,
    inlet_pressure,
    outlet_pressure,
)
from ..problem.grid import Grid
from .dataset import completeness
from .reading import parts_of_a_run

if TYPE_CHECKING:
    from ..cases import FilmCase

MAX_SHARE_OF_FORMULA = 0.01
"""Share of the boundary layer up to which a film is compared with a formula."""
_FIELDS = {
    "pressure": "pressure", "boundary_pressure": "boundary_pressure", "film": "film",
    "filling": "filling", "undeformed_gap": "gap",
}  # fmt: skip
"""Attributes of the solutions, by the names of the fields in the dataset."""


def films_dataset(
    films: Sequence[FilmSolution], case: FilmCase | None = None, *, stopped_by: str = ""
) -> xr.Dataset:
    """Collect films of one contact in one labelled dataset.

    Parameters
    ----------
    films : sequence of FilmSolution
        Solutions on one grid with one lubricant, e.g. those of `lubrication.stribeck`.
    case : FilmCase, optional
        Case whose text, roughness and formulas are stored.
    stopped_by : str, optional
        Reason why not all films were solved. The attribute ``complete`` is then 0.

    Returns
    -------
    xarray.Dataset
        Dimensions increment (the number of the speed), x and y. Every variable has ``units`` (SI)
        and ``long_name``. The attributes contain the constants of lubricant and boundary layer.

    Raises
    ------
    ValueError, TypeError
        There are no films, or they have several grids, lubricants or boundary layers.
    """
    if not films:
        raise ValueError("films must contain at least one solution, got none")
    for film in films:
        require_type("films", film, FilmSolution)
    first = films[0]
    for name in ("grid", "lubricant", "boundary"):
        if any(getattr(film, name) != getattr(first, name) for film in films):
            raise ValueError(f"films must have one {name}, got several: write one file for each")
    rows = [_scalars(film, case) for film in films]
    names = [name for name in FILMS if any(name in row for row in rows)]
    coordinates = {
        "increment": FILMS["increment"].variable("increment", np.arange(1, len(films) + 1)),
        "x": FILMS["x"].variable("x", first.grid.x),
        "y": FILMS["y"].variable("y", first.grid.y),
    }
    variables = {
        name: FILMS[name].variable("increment", [row.get(name, math.nan) for row in rows])
        for name in names
    }
    for name, attribute in _FIELDS.items():
        if name != "boundary_pressure" or first.boundary is not None:
            values = np.stack([getattr(film, attribute) for film in films])
            variables[name] = FILMS[name].variable(("increment", "x", "y"), values)
    return xr.Dataset(variables, coordinates, _attributes(films, case, stopped_by))


def _scalars(film: FilmSolution, case: FilmCase | None) -> dict[str, float]:
    """Return the values of a film by name."""
    order, supply = (3, None) if case is None else (case.film.order, case.film.supply)
    velocities = film.velocities
    found = {
        "speed": float(np.hypot(*velocities.mean(axis=0))),
        "load": film.load,
        "approach": film.approach,
        "max_pressure": float(film.pressure.max()),
        "central_film": film.central_film,
        "minimum_film": film.minimum_film,
        "iterations": float(film.iterations),
        "residual": film.residual,
        "flow_imbalance": flow_imbalance(film, order, supply),
        "inlet_pressure": inlet_pressure(film),
        "outlet_pressure": outlet_pressure(film),
        "cells_per_radius": cells_per_radius(film.pressure, film.grid),
    }
    if film.boundary is not None:
        found["boundary_share"] = film.boundary_share
    if len(film.levels) > 1:
        before = film.levels[-2].central_film
        found["film_change"] = abs(film.central_film - before) / film.central_film
    found |= _friction(film)
    if case is not None and case.film.roughness > 0.0:
        heights = case.film.roughness1, case.film.roughness2
        found["lambda_ratio"] = lambda_ratio(film.minimum_film, *heights)
    pairs: Any = tuple(map(tuple, velocities.tolist()))
    formula = None if case is None else case.estimate(film.load, pairs)
    if formula is None:
        return found
    found["load_number"], found["lubricant_number"] = formula.numbers
    if film.boundary_share <= MAX_SHARE_OF_FORMULA:
        found["formula_minimum_film"] = formula.minimum
        if formula.central is not None:
            found["formula_central_film"] = formula.central
    return found


def _friction(film: FilmSolution) -> dict[str, float]:
    """Return friction and losses; NaN for a Newtonian lubricant with an impossible friction."""
    try:
        lost = friction(film)
    except ValueError:
        return {"friction_coefficient": math.nan, "power": math.nan}
    return {
        "friction_coefficient": lost.coefficient, "rolling_resistance": lost.rolling_resistance,
        "power": lost.power,
    }  # fmt: skip


def _attributes(
    films: Sequence[FilmSolution], case: FilmCase | None, stopped_by: str
) -> dict[str, Any]:
    film = films[0]
    found: dict[str, Any] = {
        "title": "Lubricated contact" if case is None else case.title,
        "samcontact_version": version,
        "created": datetime.now(timezone.utc).isoformat(timespec="seconds"),
        "case": "" if case is None else case.text,
        "description": "" if case is None else case.description,
        "lubricant": stored(film.lubricant),
        "velocities": np.stack([one.velocities for one in films]).ravel(),
        "spin": film.spin,
        "dx": film.grid.dx,
        "dy": film.grid.dy,
        "periodic": film.grid.periodic,
        **completeness(stopped_by),
    }
    if film.boundary is not None:
        found["boundary_thickness"] = film.boundary.thickness
        found["boundary_friction"] = film.boundary.friction
        if film.boundary.pressure is not None:
            found["boundary_reference_pressure"] = film.boundary.pressure
    try:
        friction(film)
    except ValueError as error:
        found["friction_note"] = f"friction: {error}"
    if case is not None:
        found["tol"] = case.film.tol
        formula = case.estimate(film.load, case.velocities)
        if formula is not None:
            found["regime"], found["formula"] = formula.regime, formula.formula
    return found


def films_of(dataset: xr.Dataset) -> tuple[FilmSolution, ...]:
    """Return the films of a dataset from `films_dataset`, without their bodies.

    Raises ValueError for other datasets.
    """
    with parts_of_a_run():
        attributes = dataset.attrs
        grid = Grid(
            dataset.sizes["x"], dataset.sizes["y"], float(attributes["dx"]),
            float(attributes["dy"]), periodic=str(attributes["periodic"]),
        )  # fmt: skip
        velocities = np.reshape(attributes["velocities"], (-1, 2, 2))
        oil, boundary = restored(str(attributes["lubricant"])), _boundary(attributes)
        made = []
        for n in range(dataset.sizes["increment"]):
            one = dataset.isel(increment=n)
            layer = np.zeros(grid.surface_shape)
            if boundary is not None:
                layer = one["boundary_pressure"].values
            residual, count = float(one["residual"]), int(one["iterations"])
            level = FilmLevel(
                grid.surface_shape, count, 0, 0.0, residual, float(one["central_film"])
            )
            fields: dict[str, Any] = {
                "film": one["film"].values,
                "gap": one["undeformed_gap"].values,
                "filling": one["filling"].values,
                "fluid_pressure": one["pressure"].values - layer,
                "boundary_pressure": layer,
            }
            solution = FilmSolution(
                grid=grid, lubricant=oil, velocities=velocities[n], approach=float(one["approach"]),
                load=float(one["load"]), residual=residual, levels=(level,), boundary=boundary,
                spin=float(attributes["spin"]), **fields,
            )  # fmt: skip
            made.append(solution)
    return tuple(made)


def _boundary(attributes: dict[Any, Any]) -> Boundary | None:
    if "boundary_thickness" not in attributes:
        return None
    thickness, mu = (float(attributes[f"boundary_{n}"]) for n in ("thickness", "friction"))
    pressure = attributes.get("boundary_reference_pressure")
    return Boundary(thickness, mu, None if pressure is None else float(pressure))
