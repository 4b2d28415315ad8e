# SPDX-License-Identifier: GPL-3.0-or-later
"""Labelled results of a simulation: an xarray dataset with units, stored as netCDF4 (HDF5).

Variables with names ending in _body1 or _body2 refer to body 1 or body 2. Tensor components are
labelled xx, yy, zz, yz, xz, xy; shear strains are tensor components (half the engineering strains).
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from .._util.short_text import in_short
from .._util.tensors import COMPONENTS
from .dataset import to_dataset
from .file import open_results, save, scalars
from .zones import on_grid

if TYPE_CHECKING:
    from .films import films_dataset, films_of
    from .pvd import to_pvd
    from .vtk import to_vtk

__all__ = [
    "COMPONENTS",
    "films_dataset",
    "films_of",
    "on_grid",
    "open_results",
    "save",
    "scalars",
    "to_dataset",
    "to_pvd",
    "to_vtk",
]

_PLACES = {"films_dataset": "films", "films_of": "films", "to_pvd": "pvd", "to_vtk": "vtk"}
"""Module of each function that is imported on first use."""


def __getattr__(name: str) -> Any:
    if name not in _PLACES:
        raise AttributeError(f"module {__name__!r} has no attribute {in_short(name)}")
    return getattr(importlib.import_module(f".{_PLACES[name]}", __name__), name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
