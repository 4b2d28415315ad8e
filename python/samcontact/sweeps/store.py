# SPDX-License-Identifier: GPL-3.0-or-later
"""Storage of the results of a sweep: a file for each solved case, and a dataset of all cases."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from .._util.quantities import ASPERITIES, CONTACT, Quantity
from .._util.version import version
from .._util.wear_quantities import WEAR
from ..files.ownership import require_marked
from ..restart.file import READ_ERRORS, read, require_same, write

if TYPE_CHECKING:
    from ..cases.base import CaseFile
    from .plan import Plan
    from .worker import Outcome, Variables

CANCELLED = "cancelled"
_CHECKPOINT_KIND = "case"
_NUMBER_ATTRIBUTES = ("units", "flag_meanings")
_CASE_DIMENSIONS = ("pass", "increment", "cycle", "body")  # dimensions of a case, in order
_COUNT_QUANTITIES = {
    "increment": CONTACT["increment"],
    "pass": ASPERITIES["pass"],
    "cycle": WEAR["cycle"],
    "body": CONTACT["body"],
    "case": Quantity("1", "case number"),
}


class Store:
    """Storage of the solved cases in files, in the subfolder `cases` of the output folder.

    Parameters
    ----------
    folder : Path
        Output folder; created if missing.
    """

    def __init__(self, folder: Path) -> None:
        require_marked(folder / "sweep.nc", "move this file, or use another output")
        self.folder = folder / "cases"
        if os.path.lexists(self.folder) and not self.folder.is_dir():
            raise ValueError(
                f"output must have a folder for the cases, but {self.folder} is a file: move this "
                "file, or use another output"
            )
        self.folder.mkdir(parents=True, exist_ok=True)

    def file(self, key: str) -> Path:
        return self.folder / f"{key}.h5"

    def read(self, key: str) -> Variables | None:
        """Return the stored results of a case, or None if its file is missing or damaged.

        Raises ValueError for a file that this package did not write.
        """
        require_marked(self.file(key), "move this file, or use another output")
        try:
            tree = read(self.file(key), _CHECKPOINT_KIND)
            require_same(self.file(key), {"key": key}, tree)
            return {
                name: (
                    dims := tuple(part["dims"].split()),
                    part["values"] if dims else part["values"].reshape(()),
                    part["attributes"],
                )
                for name, part in tree["variables"].items()
            }
        except READ_ERRORS:
            return None

    def write(self, key: str, variables: Variables) -> None:
        """Write the results of a case to its file, which is created only when complete."""
        parts = {
            name: {
                "dims": " ".join(dims),
                # a file cannot compress a single number
                "values": np.atleast_1d(np.asarray(values, dtype=np.float64)),
                "attributes": attributes,
            }
            for name, (dims, values, attributes) in variables.items()
        }
        write(self.file(key), _CHECKPOINT_KIND, {"run": {"key": key}, "variables": parts})


def assemble(
    plan: Plan, keys: Sequence[str], outcomes: Mapping[str, Outcome], base: CaseFile
) -> xr.Dataset:
    """Assemble the results of all cases in one dataset.

    Parameters
    ----------
    plan : Plan
        Plan of the sweep, which contains the dimensions.
    keys : sequence of str
        Hash `case_key` of each case, in the order of the plan.
    outcomes : mapping
        Outcomes of the cases by their hash; a case without an outcome has been cancelled.
    base : CaseFile
        Base case; its title and text are stored.
    """
    shape = tuple(plan.dims.values())
    done = [outcomes.get(key, {}).get("variables", {}) for key in keys]
    inner: dict[str, int] = {}
    for dims, values, _ in (field for variables in done for field in variables.values()):
        for dim, size in zip(dims, values.shape, strict=True):
            inner[dim] = max(size, inner.get(dim, 0))
    dataset = xr.Dataset(coords=_coordinates(plan, inner))
    for name in dict.fromkeys(name for variables in done for name in variables):
        dataset[name] = _combined(plan, inner, [variables.get(name) for variables in done])
    status = [_status(outcomes.get(key)) for key in keys]
    error = [outcomes.get(key, {}).get("error", "") for key in keys]
    texts = {"status": "done, failed or cancelled", "error": "error of a failed case"}
    for (name, text), words in zip(texts.items(), (status, error), strict=True):
        array = np.array(words, dtype=object).reshape(shape)
        dataset[name] = xr.Variable(tuple(plan.dims), array, {"long_name": text})
    dataset.attrs = _attributes(base)
    return dataset


def _status(outcome: Outcome | None) -> str:
    if outcome is None:
        return CANCELLED
    return "failed" if "error" in outcome else "done"


def _coordinates(plan: Plan, inner: Mapping[str, int]) -> dict[str, Any]:
    counted = {dim: size for dim, size in plan.dims.items() if dim == "case"}
    counted |= {dim: inner[dim] for dim in _CASE_DIMENSIONS if dim in inner}
    coordinates: dict[str, Any] = {
        dim: _COUNT_QUANTITIES[dim].variable(dim, np.arange(1, size + 1))
        for dim, size in counted.items()
    }
    return coordinates | plan.coordinates


def _combined(plan: Plan, inner: Mapping[str, int], fields: Sequence[Any]) -> xr.Variable:
    """Combine the values of a variable from all cases in one array; missing values are NaN.

    Numbers that stand for words (attribute `flag_meanings`) are replaced by the words; a missing
    word is "". inner: sizes of the dimensions of a case. fields: variable of each case, or None.
    """
    dims, _, attributes = next(field for field in fields if field is not None)
    shape = tuple(plan.dims.values())
    if meanings := attributes.get("flag_meanings", "").split():
        words = ["" if f is None else meanings[int(f[1])].replace("_", " ") for f in fields]
        named = {name: text for name, text in attributes.items() if name not in _NUMBER_ATTRIBUTES}
        return xr.Variable(plan.dims, np.array(words, dtype=object).reshape(shape), named)
    table = np.full((len(fields), *(inner[dim] for dim in dims)), np.nan)
    for row, field in enumerate(fields):
        if field is not None:
            own = (slice(row, row + 1), *(slice(size) for size in field[1].shape))
            table[own] = field[1]
    whole = table.reshape((*shape, *table.shape[1:]))
    return xr.Variable((*plan.dims, *dims), whole, attributes)


def _attributes(base: CaseFile) -> dict[str, str]:
    text = base.text or json.dumps(base.model_dump(exclude_unset=True))
    attributes = {"title": "", "description": ""} | base.model_dump(
        include={"title", "description"}
    )
    return attributes | {"case": text, "samcontact_version": version}
