# SPDX-License-Identifier: GPL-3.0-or-later
"""VTK files for ParaView: fields of one increment, and residual fields of tracks.

The files are written by the package vtk (extra ``vtk``), with names of tensor components and with
units.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from .._util.checks import FloatArray, integer
from ..files.atomic import replacing, with_ending
from .motion import track_of
from .reading import body_shown, cell_size, parts_of_a_run
from .zones import cells_of

# Order of the components of symmetric tensors in VTK, which differs from this package.
VTK_COMPONENTS = ("xx", "yy", "zz", "xy", "yz", "xz")
_VOXEL = 11  # number of this cell type in VTK
_SURFACE_VARIABLES = (
    "pressure", "repulsion", "gap", "shear_x", "shear_y", "slip_x", "slip_y", "sticking",
    "initial_gap", "adhesion_stress",
)  # fmt: skip


def to_vtk(
    dataset: xr.Dataset, path: str | Path, increment: int = -1, body: int | None = None
) -> list[Path]:
    """Write the fields of one increment as VTK XML files of rectilinear grids (.vtr).

    If the plastic strain of a body is computed in several subdomains (separate parts of the grid),
    its volume fields are written only for the cells with plastic strain, as an unstructured grid
    (.vtu).

    For a body that has moved, the residual fields along its whole track at the end of the run are
    also written; x = 0 is the initial contact position on the body.

    Axes x and y are the axes of the contact; z points upwards, out of body 2. Body 2 is at z < 0
    and body 1 at z > 0, so both bodies can be shown together. Shear components xz and yz of body 2
    refer to these axes: their sign is opposite to the sign in the dataset. Values are cell values
    in SI units.

    Parameters
    ----------
    dataset : xarray.Dataset
        Result of `samcontact.results.to_dataset` or `open_results`.
    path : str or Path
        File of the volume fields. Surface fields are written to ``*_surface.vtr``, a track to
        ``*_track.vtr`` and ``*_track_surface.vtr``. The folder must exist. The suffix .vtr is added
        if missing.
    increment : int, optional
        Number of the increment, from 1. Negative numbers count back from the last increment with
        volume fields or, if none are stored, from the last increment.
    body : {1, 2}, optional
        Body for which volume fields and residual imprint are written; their names in the file have
        no suffix "_body1" or "_body2". Default: the body set in [output] of the case; if only the
        other body has volume fields, that body.

    Returns
    -------
    list of Path
        Files of the volume (if volume fields are stored), of the surface, and of the track (if
        there is one).

    Raises
    ------
    ValueError
        The body is unknown, or the increment is not stored.
    ModuleNotFoundError
        VTK is not installed.
    OSError
        A file cannot be written.
    """
    body = body_shown(dataset, body)
    target = with_ending(path, ".vtr")
    with parts_of_a_run():
        return _write_all(dataset, target, increment, body)


def _write_all(dataset: xr.Dataset, target: Path, increment: int, body: int) -> list[Path]:
    volume = bool(volume_names(dataset, body))
    number = stored_number(dataset, increment, volume)
    written = [write_volume(dataset, target, number, body)] if volume else []
    surface = target.with_name(f"{target.stem}_surface.vtr")
    written.append(write_surface(dataset, surface, number, body))
    return [*written, *write_track(dataset, target, body)]


def write_volume(dataset: xr.Dataset, target: Path, number: int, body: int) -> Path:
    """Write the volume fields of a body in increment `number`, and return the path."""
    fields = dataset[volume_names(dataset, body)].sel(output_increment=number)
    edges = _volume_edges(dataset, number, body)
    cells = cells_of(next(iter(fields.data_vars.values())), dataset)
    if cells is None:
        grid = _rectilinear(edges)
    else:
        target, grid = target.with_suffix(".vtu"), _voxels(edges, cells, body)
        rows = {axis: xr.DataArray(at, dims="cell") for axis, at in zip("xyz", cells, strict=True)}
        fields = fields.assign(
            {name: field.isel(rows) for name, field in fields.items() if "x" in field.dims}
        )
    _write(target, grid, fields, body, number)
    return target


def write_surface(dataset: xr.Dataset, target: Path, number: int, body: int) -> Path:
    """Write the surface fields of increment `number`, and return the path."""
    fields = dataset[_surface_names(dataset, body)].sel(increment=number)
    edges = [_edges(dataset, "x"), _edges(dataset, "y"), np.zeros(1)]
    _write(target, _rectilinear(edges), fields, body, number)
    return target


def write_track(dataset: xr.Dataset, target: Path, body: int) -> list[Path]:
    """Write the residual fields along the stored track of a body, and return the paths.

    Nothing is written if the dataset contains no track of the body.
    """
    track = track_of(dataset, body)
    if track is None:
        return []
    volume = [name for name in track.data_vars if "z" in track[name].dims]
    surface = [name for name in track.data_vars if "z" not in track[name].dims]
    last = int(dataset["increment"][-1])
    plane = [_edges(track, "x"), _edges(track, "y")]
    written = []
    if volume:
        depth = _edges(track, "z")
        written.append(target.with_name(f"{target.stem}_track.vtr"))
        edges = [*plane, depth if body == 1 else -depth[::-1]]
        _write(written[-1], _rectilinear(edges), track[volume], body, last)
    written.append(target.with_name(f"{target.stem}_track_surface.vtr"))
    edges = [*plane, np.zeros(1)]
    _write(written[-1], _rectilinear(edges), track[surface], body, last)
    return written


def volume_names(dataset: xr.Dataset, body: int) -> list[str]:
    """Return the names of all variables that are volume fields of a body."""
    return [
        str(name)
        for name, field in dataset.data_vars.items()
        if "output_increment" in field.dims and str(name).endswith(f"_body{body}")
    ]


def _surface_names(dataset: xr.Dataset, body: int) -> list[str]:
    own = (f"residual_displacement_body{body}", f"surface_temperature_body{body}")
    return [name for name in (*_SURFACE_VARIABLES, *own) if name in dataset]


def stored_number(dataset: xr.Dataset, increment: int, volume: bool) -> int:
    stored = dataset["output_increment" if volume else "increment"].values.tolist()
    integer("increment", increment)
    if -len(stored) <= increment < 0:
        return int(stored[increment])
    if increment not in stored:
        what = "increments with volume fields" if volume else "increments of the file"
        listed = ", ".join(str(number) for number in stored)
        raise ValueError(f"increment must be one of the {what} ({listed}), got {increment}")
    return increment


def _edges(dataset: xr.Dataset, axis: str) -> FloatArray:
    centres, step = dataset[axis].values, cell_size(dataset, axis)
    return np.append(centres - 0.5 * step, centres[-1] + 0.5 * step)


def _volume_edges(dataset: xr.Dataset, number: int, body: int) -> list[FloatArray]:
    x, depth = _edges(dataset, "x"), _edges(dataset, "z")
    if f"offset_body{body}" in dataset:
        x = x + float(dataset[f"offset_body{body}"].sel(increment=number))
    # coordinates must increase: the deepest layer of body 2 comes first
    return [x, _edges(dataset, "y"), depth if body == 1 else -depth[::-1]]


def _values(field: xr.DataArray, body: int) -> FloatArray:
    """Return cell values in the order of VTK, in which x varies fastest.

    The shape is (cells,), or (cells, 6) for a tensor.
    """
    upside_down = body == 2 and "z" in field.dims
    axes = [axis for axis in "zyx" if axis in field.dims]
    if "component" in field.dims:
        ordered = field.sel(component=list(VTK_COMPONENTS))
        tensor = ordered.transpose(*axes, ..., "component").values
        if upside_down:
            tensor = tensor[::-1]
        if body == 2:
            # components with one z change sign with the axis
            tensor = tensor * np.array([1.0, 1.0, 1.0, 1.0, -1.0, -1.0])
        return np.ascontiguousarray(tensor.reshape(-1, len(VTK_COMPONENTS)))
    scalar = field.transpose(*axes, ...).values
    return np.ascontiguousarray(scalar[::-1] if upside_down else scalar).ravel()


def _rectilinear(edges: list[FloatArray]) -> Any:
    vtk = _modules()
    grid = vtk["RectilinearGrid"]()
    grid.SetDimensions(*(len(axis) for axis in edges))
    for name, axis in zip("XYZ", edges, strict=True):
        getattr(grid, f"Set{name}Coordinates")(vtk["array"](axis, deep=True))
    return grid


def _voxels(edges: list[FloatArray], cells: NDArray[np.int64], body: int) -> Any:
    """Return the given cells of a grid as a VTK unstructured grid.

    edges: cell edges along x, y, z [m]. cells: indices i, j, k of the cells, shape (3, cells).
    """
    vtk = _modules()
    counts = [len(axis) for axis in edges]
    i, j, k = cells
    first = np.array([i, j, k if body == 1 else counts[2] - 2 - k])
    # x first: order of the corners of a VTK voxel
    steps = np.array([(n & 1, n >> 1 & 1, n >> 2) for n in range(8)])
    corners = np.ravel_multi_index(tuple(first[:, :, None] + steps.T[:, None]), counts)
    used, numbers = np.unique(corners, return_inverse=True)
    places = np.unravel_index(used, counts)
    coordinates = np.stack([axis[at] for axis, at in zip(edges, places, strict=True)], axis=1)
    points, voxels, grid = vtk["Points"](), vtk["CellArray"](), vtk["UnstructuredGrid"]()
    points.SetData(vtk["array"](coordinates, deep=True))
    offsets, connected = 8 * np.arange(i.size + 1), numbers.ravel()
    voxels.SetData(*(vtk["ids"](a.astype(np.int64), deep=True) for a in (offsets, connected)))
    grid.SetPoints(points)
    grid.SetCells(_VOXEL, voxels)
    return grid


def _write(target: Path, grid: Any, fields: xr.Dataset, body: int, increment: int) -> None:
    vtk = _modules()
    for name, field in fields.data_vars.items():
        array = vtk["array"](_values(field, body), deep=True)
        array.SetName(str(name).removesuffix(f"_body{body}"))
        # VTK reads this name as the unit of the array
        array.GetInformation().Set(array.UNITS_LABEL(), field.attrs["units"])
        if array.GetNumberOfComponents() > 1:
            for index, component in enumerate(VTK_COMPONENTS):
                array.SetComponentName(index, component)
        grid.GetCellData().AddArray(array)
    for label, value in (("increment", increment), ("body", body)):
        array = vtk["array"](np.array([value], dtype=np.int64), deep=True)
        array.SetName(label)
        grid.GetFieldData().AddArray(array)
    writer = vtk["Unstructured" if grid.IsA("vtkUnstructuredGrid") else "Rectilinear"]()
    writer.SetInputData(grid)
    # VTK prints to stderr instead of raising, and accepts fewer file names
    writer.WriteToOutputStringOn()
    writer.Write()
    with replacing(target) as part:
        part.write_text(writer.GetOutputString(), encoding="utf-8")


def _modules() -> dict[str, Any]:
    """Return the required classes and functions of VTK, by short name.

    Only their modules are imported, because importing all of VTK takes seconds.
    """
    try:
        import vtkmodules.vtkCommonCore as core
        import vtkmodules.vtkCommonDataModel as data
        import vtkmodules.vtkIOXML as files
        from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    except ModuleNotFoundError as error:
        raise ModuleNotFoundError(
            f"VTK files require the package vtk ({error}): pip install samcontact[vtk]"
        ) from error
    return {
        "array": numpy_to_vtk,
        "ids": numpy_to_vtkIdTypeArray,
        "Points": core.vtkPoints,
        "CellArray": data.vtkCellArray,
        "RectilinearGrid": data.vtkRectilinearGrid,
        "UnstructuredGrid": data.vtkUnstructuredGrid,
        "Rectilinear": files.vtkXMLRectilinearGridWriter,
        "Unstructured": files.vtkXMLUnstructuredGridWriter,
    }
