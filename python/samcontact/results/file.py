# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of datasets: netCDF4 with a digest behind its end."""

from __future__ import annotations

import warnings
from datetime import datetime, timezone
from pathlib import Path
from typing import TYPE_CHECKING

import h5netcdf
import h5py
import numpy as np
import xarray as xr

from .._util.version import version
from ..files.atomic import replacing_hdf5
from ..files.checksum import check_seal
from ..restart.file import DAMAGED, require_self_contained
from .reading import parts_of_a_run
from .trial import try_to_read

if TYPE_CHECKING:
    import pandas as pd

CONVENTIONS = "CF-1.11"


def save(dataset: xr.Dataset, path: str | Path) -> Path:
    """Write a dataset as compressed netCDF4, atomically.

    The file appears under its name only when it is complete; an existing one is replaced. It gets
    the attributes `Conventions` (CF) and `history`, to which each file adds a line.

    Parameters
    ----------
    dataset : xarray.Dataset
        From `to_dataset`.
    path : str or Path
        The file, customarily ending in .nc; its directory must exist.

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    OSError
        The directory is missing or cannot be written.
    """
    target = Path(path)
    encoding = {
        name: {"zlib": True, "complevel": 1, "shuffle": True}
        for name, variable in dataset.data_vars.items()
        if variable.ndim > 1
    }
    told = dataset.assign_attrs(Conventions=CONVENTIONS, history=_history(dataset))
    with replacing_hdf5(target) as opened, h5netcdf.File(opened, "w") as file:
        # to_netcdf would let HDF5 write to the disk itself
        told.dump_to_store(xr.backends.H5NetCDFStore(file), encoding=encoding)
    return target


def _history(dataset: xr.Dataset) -> str:
    """What was done when, a line each, oldest first as CF has it."""
    now = datetime.now(timezone.utc).isoformat(timespec="seconds")
    before = dataset.attrs.get("history")
    return (f"{before}\n" if before else "") + f"{now}: written by samcontact {version}"


def open_results(path: str | Path) -> xr.Dataset:
    """Open a results file; fields are read when they are used.

    The bytes of a file by `save` are compared with its digest. One that another program has written
    since has none, and is read as a whole by a process of its own first: HDF5 may crash on damaged
    metadata, or never end.

    Parameters
    ----------
    path : str or Path
        A file written by `save`.

    Returns
    -------
    xarray.Dataset
        Close it, or use it in a ``with`` statement.

    Raises
    ------
    FileNotFoundError
        There is no such file.
    ValueError
        The file is not a results file of this package, is damaged, or has links to other files.
    """
    source = Path(path)
    if not source.is_file():
        raise FileNotFoundError(f"no results file at {source}")
    try:
        if not check_seal(source):  # other programs have written it on purpose, or damaged it
            try_to_read(source)
        _check_structure(source)
        _try(source)
        dataset = xr.open_dataset(source, engine="h5netcdf")
    except PermissionError:
        raise
    except (*DAMAGED, xr.SerializationWarning) as error:
        # without what h5netcdf advises, which is for its own arguments
        told = next(iter(str(error).splitlines()), type(error).__name__).strip()
        raise ValueError(f"path must be a netCDF4 file, got {source}: {told}") from error
    if "samcontact_version" not in dataset.attrs or "format_version" in dataset.attrs:
        found = dataset.attrs.get("format", "of another program")
        dataset.close()
        raise ValueError(
            f"path must be a results file written by samcontact, got {source}: {found}"
        )
    return dataset


def _check_structure(path: Path) -> None:
    """Refuse values in other files, and links of dimensions to what are none.

    HDF5 follows what links dimensions without a look at its type: other numbers crash it.
    """

    def check(name: str, part: h5py.Group | h5py.Dataset) -> None:
        for link, is_one in (("DIMENSION_LIST", _is_list), ("REFERENCE_LIST", _is_table)):
            if link in part.attrs:
                found = part.attrs.get_id(link)
                fits = found.shape == (part.ndim,) if is_one is _is_list else len(found.shape) == 1
                if not (is_one(found.dtype) and fits):
                    raise ValueError(f"the attribute {link} of {name} does not link dimensions")

    with h5py.File(path, "r") as file:
        require_self_contained(file)
        file.visititems(check)


def _is_list(dtype: np.dtype[np.generic]) -> bool:
    linked = h5py.check_vlen_dtype(dtype)
    return linked is not None and h5py.check_ref_dtype(linked) is h5py.Reference


def _is_table(dtype: np.dtype[np.generic]) -> bool:
    if dtype.fields is None or len(dtype.fields) != 2:
        return False
    first, *_ = dtype.fields.values()
    return h5py.check_ref_dtype(first[0]) is h5py.Reference


def _try(path: Path) -> None:
    """Read what is read at once; xarray would leave a file open that it cannot use."""
    with (
        h5netcdf.File(path, "r", decode_vlen_strings=True) as file,  # as xarray does
        warnings.catch_warnings(),
    ):
        warnings.simplefilter("error", xr.SerializationWarning)  # it would drop what does not fit
        xr.open_dataset(xr.backends.H5NetCDFStore(file))


def scalars(dataset: xr.Dataset) -> pd.DataFrame:
    """Table of the quantities that have one value per increment.

    Parameters
    ----------
    dataset : xarray.Dataset
        From `to_dataset` or `open_results`.

    Returns
    -------
    pandas.DataFrame
        Indexed by increment, SI units.
    """
    names = [
        name for name, variable in dataset.data_vars.items() if variable.dims == ("increment",)
    ]
    with parts_of_a_run():
        return dataset[names].to_dataframe()
