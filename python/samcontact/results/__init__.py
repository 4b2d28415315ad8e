# SPDX-License-Identifier: GPL-3.0-or-later
"""Labelled results of a simulation: an xarray dataset with units, stored as netCDF4 (HDF5).

Variables with names ending in _body1 or _body2 refer to body 1 or body 2. Tensor components are
labelled xx, yy, zz, yz, xz, xy; shear strains are tensor components (half the engineering strains).
"""

from .._util.tensors import COMPONENTS
from .dataset import to_dataset
from .file import open_results, save, scalars
from .films import films_dataset, films_of
from .pvd import to_pvd
from .vtk import to_vtk
from .zones import on_grid

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
