# SPDX-License-Identifier: GPL-3.0-or-later
"""Conversion of solutions of lubricated contacts to one labelled dataset, and back."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from datetime import datetime, timezone
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from .._util.checks import require_type
from .._util.film_quantities import FILMS
from .._util.version import version
from ..lubricants import Lubricant
from ..lubricants.stored import restored, stored
from ..lubrication import Boundary, FilmHeat, FilmLevel, FilmSolution, friction, lambda_ratio
from ..lubrication.balance import (
    cells_per_radius,
    flow_imbalance,
    inlet_pressure,
    outlet_pressure,
    storage_imbalance,
)
from ..lubrication.film_solution import FilmPast
from ..problem.grid import Grid
from .dataset import completeness
from .reading import parts_of_a_run

if TYPE_CHECKING:
    from ..cases import FilmCase

_HEAT_FIELDS = {
    "film_rise": "middle_rise", "surface_rise": "surface_rise", "heat_flux": "flux",
    "heating_depth": "depth",
}  # fmt: skip
"""Attribute of `FilmHeat` for each variable of the dataset."""
MAX_SHARE_OF_FORMULA = 0.01
"""Fraction of the load on the boundary layer [-], up to which a film is compared with a formula."""
_FIELDS = {
    "pressure": "pressure", "boundary_pressure": "boundary_pressure", "film": "film",
    "filling": "filling", "undeformed_gap": "gap",
}  # fmt: skip
"""Attribute of `FilmSolution` for each variable of the dataset."""


def films_dataset(
    films: Sequence[FilmSolution], case: FilmCase | None = None, *, stopped_by: str = ""
) -> xr.Dataset:
    """Collect the solutions of one lubricated contact in one labelled dataset.

    Parameters
    ----------
    films : sequence of FilmSolution
        Solutions on one grid with one lubricant: from `lubrication.stribeck` or `press_loads`, or
        the initial film and all steps from `lubrication.transient`.
    case : FilmCase, optional
        Case whose text is stored. It also provides the roughness and the film formula with which
        the films are compared.
    stopped_by : str, optional
        Reason why not all films were solved. The attribute ``complete`` is then 0.

    Returns
    -------
    xarray.Dataset
        Dimensions increment (the number of the speed, load or instant), x and y. Every variable has
        ``units`` (SI) and ``long_name``. The attributes contain the constants of lubricant and
        boundary layer.

    Raises
    ------
    ValueError, TypeError
        `films` is empty or contains objects that are not films, or the films have different grids,
        lubricants or boundary layers.
    """
    if not films:
        raise ValueError("films must contain at least one solution, got none")
    for film in films:
        require_type("films", film, FilmSolution)
    first = films[0]
    for name in ("grid", "lubricant", "boundary"):
        if any(getattr(film, name) != getattr(first, name) for film in films):
            raise ValueError(f"films must share one {name}, got several: write one file for each")
    rows = [_scalars(film, case) for film in films]
    if is_history(films):
        for row, value in zip(rows, storage_imbalance(films), strict=True):
            row["flow_imbalance"] = float(value)
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
    if first.heat is not None:
        coordinates["body"] = FILMS["body"].variable("body", np.array([1, 2]))
        variables |= _heat_fields(films)
    if first.past is not None:
        variables["smooth_gap"] = FILMS["smooth_gap"].variable(("x", "y"), first.smooth_gap)
    if films[-1].plasticity is not None:
        coordinates["body"] = FILMS["body"].variable("body", np.array([1, 2]))
        coordinates["z"] = FILMS["z"].variable("z", films[-1].plasticity.z)
        variables |= _plastic_fields(films)
    return xr.Dataset(variables, coordinates, _attributes(films, case, stopped_by))


def is_history(films: Sequence[FilmSolution]) -> bool:
    """Whether films are a solution over time: the initial film and steps at increasing times."""
    times = [film.time for film in films]
    return films[-1].past is not None and all(b > a for a, b in pairwise(times))


def _plastic_fields(films: Sequence[FilmSolution]) -> dict[str, Any]:
    """Return the variables of elastic-plastic bodies.

    The residual displacement is stored for each load. Stress and plastic strain are stored for the
    last load only.
    """
    found, last = {}, films[-1].plasticity
    assert last is not None
    imprints = np.stack([film.plasticity.residual_displacement for film in films])  # type: ignore[union-attr]
    name = "residual_displacement"
    found[name] = FILMS[name].variable(("increment", "body", "x", "y"), imprints)
    found["initial_gap"] = FILMS["initial_gap"].variable(("x", "y"), last.initial_gap)
    for name in ("von_mises", "residual_von_mises", "equivalent_plastic_strain"):
        found[name] = FILMS[name].variable(("body", "x", "y", "z"), getattr(last, name))
    return found


def _heat_fields(films: Sequence[FilmSolution]) -> dict[str, Any]:
    """Return the variables of heated films: temperature rises and heat fluxes."""
    fields = {}
    for name, attribute in _HEAT_FIELDS.items():
        values = np.stack([getattr(film.heat, attribute) for film in films])
        of_bodies = ("body",) if values.ndim == 4 else ()
        fields[name] = FILMS[name].variable(("increment", *of_bodies, "x", "y"), values)
    return fields


def _scalars(film: FilmSolution, case: FilmCase | None) -> dict[str, float]:
    """Return the scalar results of one film, by variable name."""
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
        "flow_imbalance": (flow_imbalance(film, order, supply) if film.past is None else math.nan),
        "inlet_pressure": inlet_pressure(film),
        "outlet_pressure": outlet_pressure(film),
        "cells_per_radius": cells_per_radius(film.pressure, film.grid),
    }
    if film.boundary is not None:
        found["boundary_share"] = film.boundary_share
        if film.share_error is not None:
            found["share_uncertainty"] = film.share_error
    if film.past is not None:
        found["time"] = film.time
    found |= _plastic_scalars(film)
    if film.heat is not None:
        found["heat"], found["max_film_rise"] = film.heat.power, film.heat.max_rise
        found["max_surface_rise"] = float(film.heat.surface_rise.max())
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


def _plastic_scalars(film: FilmSolution) -> dict[str, float]:
    """Return the scalar results of elastic-plastic bodies: maxima, imprint and gap mismatch.

    The imprint is the range of the residual displacement. The gap mismatch is the maximum
    difference between the gap of the film and the gap of the plastically deformed bodies, relative
    to the central film thickness.
    """
    bodies = film.plasticity
    if bodies is None:
        return {}
    moved = bodies.residual_displacement.sum(axis=0)
    mismatch = np.abs(film.gap - bodies.initial_gap - moved).max() / film.central_film
    return {
        "max_von_mises": float(bodies.von_mises.max()),
        "max_plastic_strain": float(bodies.equivalent_plastic_strain.max()),
        "max_residual_stress": float(bodies.residual_von_mises.max()),
        "imprint": float(np.ptp(moved)),
        "gap_mismatch": float(mismatch),
    }


def _friction(film: FilmSolution) -> dict[str, float]:
    """Return friction coefficient, rolling resistance and power.

    Friction coefficient and power are NaN if a Newtonian lubricant gives an impossibly high
    friction.
    """
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
        "shear_thinning": int(film.shear_thinning),
        "order": film.order,
        "supply": film.supply,
        "dx": film.grid.dx,
        "dy": film.grid.dy,
        "periodic": film.grid.periodic,
        **completeness(stopped_by),
    }
    if is_history(films):
        pasts = [one.past for one in films if one.past is not None]
        found["ways"] = np.stack([past.ways for past in pasts]).ravel()
        found["start_peak"] = pasts[0].peak
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
    """Return the solutions stored in a dataset of `films_dataset`.

    The plastic deformation of bodies is not restored. Raises ValueError for other datasets.
    """
    with parts_of_a_run():
        attributes = dataset.attrs
        grid = Grid(
            dataset.sizes["x"], dataset.sizes["y"], float(attributes["dx"]),
            float(attributes["dy"]), periodic=str(attributes["periodic"]),
        )  # fmt: skip
        velocities = np.reshape(attributes["velocities"], (-1, 2, 2))
        oil, boundary = restored(str(attributes["lubricant"])), _boundary(attributes)
        made: list[FilmSolution] = []
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
                spin=float(attributes["spin"]), heat=_heat(one, oil, grid),
                shear_thinning=bool(attributes["shear_thinning"]), order=int(attributes["order"]),
                supply=float(attributes["supply"]), **fields,
            )  # fmt: skip
            if "share_uncertainty" in one and not np.isnan(one["share_uncertainty"]):
                solution = replace(solution, share_error=float(one["share_uncertainty"]))
            if "time" in one:
                solution = replace(solution, past=_past(dataset, n, made[-1] if n else solution))
            made.append(solution)
    return tuple(made)


def _past(dataset: xr.Dataset, n: int, before: FilmSolution) -> FilmPast:
    """Return the data of earlier instants (the attribute `past`) of film n, counted from 0.

    before: film at the preceding instant.
    """
    attributes, time = dataset.attrs, float(dataset["time"][n])
    ways = np.reshape(attributes["ways"], (-1, 2, 2))[n]
    gap = dataset["smooth_gap"].values
    return FilmPast(time, ways, before.content, gap, float(attributes["start_peak"]))


def _heat(one: xr.Dataset, oil: Lubricant, grid: Grid) -> FilmHeat | None:
    """Return the attribute `heat` of one film, or None if the film was solved without heat."""
    if "film_rise" not in one:
        return None
    assert oil.heat is not None
    fields = {attribute: one[name].values for name, attribute in _HEAT_FIELDS.items()}
    return FilmHeat(constants=oil.heat, cell_area=grid.cell_area, **fields)


def _boundary(attributes: dict[Any, Any]) -> Boundary | None:
    if "boundary_thickness" not in attributes:
        return None
    thickness, mu = (float(attributes[f"boundary_{n}"]) for n in ("thickness", "friction"))
    pressure = attributes.get("boundary_reference_pressure")
    return Boundary(thickness, mu, None if pressure is None else float(pressure))
