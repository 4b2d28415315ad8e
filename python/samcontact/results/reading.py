# SPDX-License-Identifier: GPL-3.0-or-later
"""Reading of grid, bodies and materials from a results dataset; errors for other datasets."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import numpy as np

from .._util.checks import choice
from ..bodies.depth_profiles import PROFILE_ARGUMENTS
from ..bodies.hardening_laws import LAWS
from ..bodies.layered import Body, names_of_materials
from ..bodies.layers import Layered
from ..bodies.material import Material
from ..problem.grid import Grid

if TYPE_CHECKING:
    import xarray as xr


@contextmanager
def parts_of_a_run() -> Iterator[None]:
    """Context manager that raises ValueError if parts of a dataset are missing or wrong."""
    try:
        yield
    except (LookupError, TypeError, AttributeError, ArithmeticError) as error:
        raise ValueError(
            "dataset must be the result of a run, but a part is missing or has the wrong type: "
            f"{type(error).__name__}: {error}"
        ) from error


def body_shown(dataset: xr.Dataset, body: int | None = None) -> int:
    """Return the number of the body to show: `body` or, if None, a default.

    The default is the body set in [output] of the case; if only the other body has volume fields,
    the default is that body.
    """
    if body is not None:
        return int(choice("body", body, (1, 2)))
    selected = int(dataset.attrs.get("body", 2))
    other = 3 - selected
    only_other = f"stress_body{selected}" not in dataset and f"stress_body{other}" in dataset
    return other if only_other else selected


def cell_size(dataset: xr.Dataset, axis: str) -> float:
    """Return the cell size along "x", "y" or "z" [m], from the cell centres if it is not stored."""
    given = dataset.attrs.get(f"d{axis}")
    if given is not None:
        return float(given)
    centres = dataset[axis].values
    if axis == "z":
        return 2.0 * float(centres[0])
    return float(centres[1] - centres[0])


def grid_of(dataset: xr.Dataset) -> Grid:
    """Return the grid of a results dataset or of the dataset of a track."""
    axes = [axis for axis in "xyz" if axis in dataset.sizes]
    cells = [dataset.sizes[axis] for axis in axes]
    sizes = [cell_size(dataset, axis) for axis in axes]
    if "z" not in axes:
        return Grid(cells[0], cells[1], sizes[0], sizes[1])
    return Grid(cells[0], cells[1], sizes[0], sizes[1], cells[2], sizes[2])


def graded_of(dataset: xr.Dataset, body: int) -> Body | None:
    """Return the body if its strength or stress varies with depth, otherwise None.

    Such a body has layers, a yield-stress profile or initial stress.
    """
    prefix = f"body{body}_"
    law = str(dataset.attrs.get(f"{prefix}law"))
    if law == Layered.law and f"{prefix}substrate_law" in dataset.attrs:
        thickness = np.atleast_1d(dataset.attrs[f"{prefix}thickness"]).tolist()
        *layers, substrate = (
            _material(dataset, f"{prefix}{name}_") for name in names_of_materials(len(thickness))
        )
        return Layered(tuple(zip(layers, thickness, strict=True)), substrate)
    if law not in LAWS or not any(
        f"{prefix}{kind}_z" in dataset.attrs for kind in PROFILE_ARGUMENTS
    ):
        return None
    return _material(dataset, prefix)


def _material(dataset: xr.Dataset, prefix: str) -> Material:
    law = str(dataset.attrs[f"{prefix}law"])
    relaxation: dict[str, Any] = {}
    kinds = [kind for kind in PROFILE_ARGUMENTS if f"{prefix}{kind}_z" in dataset.attrs]

    def given(name: str, many: bool) -> Any:
        value = np.atleast_1d(
            dataset.attrs[prefix + name]
        )  # files store lists of one value as numbers
        return value if many else float(value[0])

    if f"{prefix}relaxation_times" in dataset.attrs:
        times, shares = (given(f"relaxation_{name}", True) for name in ("times", "shares"))
        relaxation = {"relaxation_terms": (times.tolist(), shares.tolist())}
    constants = LAWS[law].constants
    parameters = {name: given(name, constant.many) for name, constant in constants.items()}
    profiles: dict[str, Any] = {
        kind: [given(f"{kind}_{part}", True) for part in PROFILE_ARGUMENTS[kind]] for kind in kinds
    }
    return Material(law, parameters, **profiles, **relaxation)
