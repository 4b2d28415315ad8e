# SPDX-License-Identifier: GPL-3.0-or-later
"""Computations of a sweep for one case: path, wear, shakedown, fatigue, film or load search."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from .._util.checks import require_type
from .._util.short_text import in_short
from .._util.sweep_quantities import SWEEP
from ..shakedown.results import ELASTIC, PLASTIC, RATCHETING, SHAKEDOWN, UNDECIDED

if TYPE_CHECKING:
    import xarray as xr

    from ..cases import Case, FilmCase
    from ..solutions.state import State

RESPONSES = (ELASTIC, SHAKEDOWN, PLASTIC, RATCHETING, UNDECIDED)
"""Possible responses to repeated cycles. A sweep stores the index of the response in this tuple."""
MEANINGS = " ".join(response.replace(" ", "_") for response in RESPONSES)
"""Attribute `flag_meanings` of the stored responses, by the CF conventions, section 3.5."""
_SEARCH_ARGUMENTS = ("quantity", "value", "tolerance", "largest_load")


def checked_search(search: Any, cases: list[Any]) -> dict[str, Any] | None:
    """Return the arguments of a load search, after checking them for all cases of a sweep."""
    from ..accuracy.load_search_cases import max_load, require_known
    from ..cases import Case

    if search is None:
        return None
    require_type("find", search, Mapping)
    unknown = [name for name in search if name not in _SEARCH_ARGUMENTS]
    if unknown or "quantity" not in search:
        raise ValueError(
            "find must have the key 'quantity', and may have 'value', 'tolerance' and "
            f"'largest_load', got {in_short(dict(search))}"
        )
    for case in cases:
        if not isinstance(case, Case):
            raise ValueError(f"find requires a case of one contact, got {case.KIND}")
        max_load(case)
    require_known(search["quantity"])
    return dict(search)


def search_results(case: Case, search: Mapping[str, Any]) -> xr.Dataset:
    """Return the load found by a load search, the value of the quantity, and the error of each."""
    from ..accuracy.load_search import find_load

    found = find_load(case, **search, progress=False)
    return _of_case(
        {
            "found_load": found.load,
            "found_load_error": found.load_error,
            "found_value": found.value,
            "found_value_error": found.error,
        }
    )


def solved(case: Case) -> xr.Dataset:
    """Return all results of a case that have one value per increment, cycle or case."""
    from .. import results
    from ..accuracy.prescribed import to_accuracy

    if case.wear is not None:
        return _of_wear(case)
    if case.accuracy is not None:
        accurate = to_accuracy(case, progress=False)
        states, dataset = accurate.states, accurate.to_dataset(volume="none")
    else:
        simulation, path = case.build()
        states = simulation.run(path, progress=False)
        dataset = results.to_dataset(simulation, states, case, volume="none")
    names = [name for name, field in dataset.data_vars.items() if field.dims == ("increment",)]
    found: xr.Dataset = dataset[names]
    found.update(_of_case(_of_fatigue(case, states) | _of_shakedown(case)))
    if "shakedown_response" in found:
        found["shakedown_response"].attrs["flag_meanings"] = MEANINGS
    return found


def film_scalars(case: FilmCase) -> xr.Dataset:
    """Return all results of a lubricated contact that have one value per speed, load or instant."""
    from ..results.films import films_dataset

    dataset = films_dataset(case.solve(), case)
    names = [name for name, field in dataset.data_vars.items() if field.dims == ("increment",)]
    found: xr.Dataset = dataset[names]
    return found


def _of_case(values: Mapping[str, float]) -> xr.Dataset:
    import xarray as xr

    return xr.Dataset({name: SWEEP[name].variable((), value) for name, value in values.items()})


def _of_wear(case: Case) -> xr.Dataset:
    """Return the results of each wear cycle, with separate variables for the two bodies."""
    from ..accuracy.prescribed import to_accuracy

    assert case.wear is not None
    if case.accuracy is not None:
        dataset = to_accuracy(case, progress=False).to_dataset()
    else:
        dataset = case.wear.solve(*case.build(), None, False).to_dataset()
    found: xr.Dataset = dataset[[n for n, f in dataset.data_vars.items() if f.dims == ("cycle",)]]
    for name, field in dataset.data_vars.items():
        if field.dims == ("cycle", "body"):
            for body in dataset["body"].values.tolist():
                found[f"{name}_body{body}"] = field.sel(body=body, drop=True).variable
                found[f"{name}_body{body}"].attrs["long_name"] += f", body {body}"
    own: xr.Dataset = found.drop_vars([n for n in found.coords if n != "cycle"])
    return own


def _of_fatigue(case: Case, states: list[State]) -> dict[str, float]:
    """Return the results that the section [fatigue] of a case requests, e.g. maxima and margins."""
    if case.fatigue is None:
        return {}
    found = {}
    body = case.output.body
    fields = case.fatigue.fields(states, body)
    for field in fields:
        found[f"fatigue_{field.criterion}"] = field.max_value
        limit = getattr(case.fatigue.limit, field.criterion)
        if limit is not None:
            found[f"fatigue_margin_{field.criterion}"] = field.margin(limit)
    exposed = case.fatigue.exposed(states, body, (case.body1, case.body2)[body - 1].profile)
    if exposed is not None:
        for name in exposed.values:
            found[f"exposure_{name}"] = exposed.max_value(name)
            found[f"exposure_depth_{name}"] = exposed.depth(name)
    life = case.fatigue.life_of(fields)
    if life is not None:
        found["life_log_integral"] = life.log_integral
    return found


def _of_shakedown(case: Case) -> dict[str, float]:
    """Return the results for the section [shakedown] of a case: response to the repeated path."""
    if case.shakedown is None:
        return {}
    found = case.shakedown.solve(*case.build(), False)
    return {
        "shakedown_response": float(RESPONSES.index(found.response)),
        "shakedown_rate": found.rate,
        "shakedown_flow": found.flow,
        "shakedown_cycles": float(found.cycles[-1].number),
        "shakedown_yield_strain": found.yield_strain,
    }
