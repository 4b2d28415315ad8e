# SPDX-License-Identifier: GPL-3.0-or-later
"""Results files: datasets stored as netCDF4 files, each with a digest appended."""

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
from ..restart.file import READ_ERRORS, require_self_contained
from .isolated_read import try_to_read
from .reading import parts_of_a_run

if TYPE_CHECKING:
    import pandas as pd

CONVENTIONS = "CF-1.11"


def save(dataset: xr.Dataset, path: str | Path) -> Path:
    """Write a dataset as a compressed netCDF4 file.

    The file appears under its name only when it is complete; an existing file is replaced. The
    attributes `Conventions` (CF) and `history` are added; each save adds a line to the history.

    Parameters
    ----------
    dataset : xarray.Dataset
        Result of `to_dataset`.
    path : str or Path
        File to write, customarily ending in .nc, in an existing folder.

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    OSError
        The folder is missing or cannot be written.
    """
    target = Path(path)
    encoding = {
        name: {"zlib": True, "complevel": 1, "shuffle": True}
        for name, variable in dataset.data_vars.items()
        if variable.ndim > 1
    }
    labelled = dataset.assign_attrs(Conventions=CONVENTIONS, history=_history(dataset))
    with replacing_hdf5(target) as opened, h5netcdf.File(opened, "w") as file:
        # in memory: to_netcdf would let HDF5 write directly to disk
        labelled.dump_to_store(xr.backends.H5NetCDFStore(file), encoding=encoding)
    return target


def _history(dataset: xr.Dataset) -> str:
    """Return the history by the CF conventions: one line per operation, the oldest first."""
    now = datetime.now(timezone.utc).isoformat(timespec="seconds")
    before = dataset.attrs.get("history")
    return (f"{before}\n" if before else "") + f"{now}: written by samcontact {version}"


def open_results(path: str | Path) -> xr.Dataset:
    """Open a results file; each field is read from the file when it is first used.

    The bytes of a file written by `save` are compared with its digest. A file modified by another
    program has no digest and is first read completely by a separate process, because HDF5 may
    crash on damaged metadata, or not terminate.

    Parameters
    ----------
    path : str or Path
        File written by `save`.

    Returns
    -------
    xarray.Dataset
        Dataset. Close it after use, or use it in a ``with`` statement.

    Raises
    ------
    FileNotFoundError
        The file does not exist.
    ValueError
        The file is not a results file of this package, is damaged, or links to other files.
    """
    source = Path(path)
    if not source.is_file():
        raise FileNotFoundError(f"no results file at {source}")
    try:
        unchanged = check_seal(source)
        if not unchanged:  # modified by another program, or damaged
            try_to_read(source)
        _check_structure(source)
        if not unchanged:
            _try(source)
        dataset = xr.open_dataset(source, engine="h5netcdf")
    except PermissionError:
        raise
    except (*READ_ERRORS, xr.SerializationWarning) as error:
        # without the advice of h5netcdf, which concerns its own arguments
        text = next(iter(str(error).splitlines()), type(error).__name__).strip()
        raise ValueError(f"path must be a netCDF4 file, got {source}: {text}") from error
    if "samcontact_version" not in dataset.attrs or "format_version" in dataset.attrs:
        found = dataset.attrs.get("format", "a file of another program")
        dataset.close()
        raise ValueError(
            f"path must be a results file written by samcontact, got {source}: {found}"
        )
    return dataset


def _check_structure(path: Path) -> None:
    """Raise ValueError if a file stores values in other files, or has invalid dimension links.

    HDF5 follows dimension links without checking their type, and crashes if they are plain numbers.
    """

    def check(name: str, part: h5py.Group | h5py.Dataset) -> None:
        for link, is_one in (("DIMENSION_LIST", _is_list), ("REFERENCE_LIST", _is_table)):
            if link in part.attrs:
                found = part.attrs.get_id(link)
                fits = found.shape == (part.ndim,) if is_one is _is_list else len(found.shape) == 1
                if not (is_one(found.dtype) and fits):
                    raise ValueError(f"the attribute {link} of {name} must link to dimensions only")

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
    """Read the metadata of a file, so that errors in them are raised at once.

    The file is closed in any case, whereas `xarray.open_dataset` leaves an invalid file open.
    """
    with (
        h5netcdf.File(path, "r", decode_vlen_strings=True) as file,  # as in xarray
        warnings.catch_warnings(),
    ):
        warnings.simplefilter("error", xr.SerializationWarning)  # xarray would drop invalid parts
        xr.open_dataset(xr.backends.H5NetCDFStore(file))


def scalars(dataset: xr.Dataset) -> pd.DataFrame:
    """Return a table of all quantities that have one value per increment.

    Parameters
    ----------
    dataset : xarray.Dataset
        Result of `to_dataset` or `open_results`.

    Returns
    -------
    pandas.DataFrame
        Table indexed by increment, in SI units.
    """
    names = [
        name for name, variable in dataset.data_vars.items() if variable.dims == ("increment",)
    ]
    with parts_of_a_run():
        return dataset[names].to_dataframe()
