# SPDX-License-Identifier: GPL-3.0-or-later
"""VTK files of all increments, with PVD collections that ParaView shows as a time series.

A collection (.pvd) is a list of files with times: https://www.paraview.org/Wiki/ParaView/Data_formats.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING
from xml.etree import ElementTree

from ..files.atomic import replacing, with_ending
from .reading import body_shown, parts_of_a_run
from .vtk import volume_names, write_surface, write_track, write_volume

if TYPE_CHECKING:
    import xarray as xr


def to_pvd(dataset: xr.Dataset, path: str | Path, body: int | None = None) -> list[Path]:
    """Write all increments to VTK files, and collections of these files for ParaView.

    Parameters
    ----------
    dataset : xarray.Dataset
        Result of `samcontact.results.to_dataset` or `open_results`.
    path : str or Path
        File that lists the volume fields of all increments for which they are stored (a PVD
        collection). The collection ``*_surface.pvd`` lists the surface fields of all increments.
        The file names of each increment contain the increment number with five digits:
        ``*_00001.vtr`` (or .vtu), ``*_00001_surface.vtr``. The suffix .pvd is added if missing. The
        folder must exist.
    body : {1, 2}, optional
        Body for which volume fields and residual imprint are written. Default: the body set in
        [output] of the case; if only the other body has volume fields, that body.

    Returns
    -------
    list of Path
        Paths of the collections, of the files of each increment, and of the files of a track. The
        time in a collection is the end of the increment [s] if the dataset has the variable `time`,
        otherwise the number of the increment.

    Raises
    ------
    ValueError
        The body is unknown.
    ModuleNotFoundError
        VTK is not installed.
    OSError
        A file cannot be written.
    """
    body = body_shown(dataset, body)
    target = with_ending(path, ".pvd")
    with parts_of_a_run():
        return _write_all(dataset, target, body)


def _write_all(dataset: xr.Dataset, target: Path, body: int) -> list[Path]:
    numbers = dataset["increment"].values.tolist()
    volumes = dataset["output_increment"].values.tolist() if volume_names(dataset, body) else []
    time = "time" if "time" in dataset else "increment"
    when = dict(zip(numbers, dataset[time].values.tolist(), strict=True))

    def file(number: int, suffix: str = "") -> Path:
        return target.with_name(f"{target.stem}_{number:05d}{suffix}.vtr")

    inside = {n: write_volume(dataset, file(n), n, body) for n in volumes}
    outside = {n: write_surface(dataset, file(n, "_surface"), n, body) for n in numbers}
    collections = {target.with_name(f"{target.stem}_surface.pvd"): outside}
    if inside:
        collections = {target: inside} | collections
    for collection, files in collections.items():
        _collect(collection, [(when[n], name) for n, name in files.items()])
    track = write_track(dataset, target, body)
    return [*collections, *inside.values(), *outside.values(), *track]


def _collect(target: Path, files: list[tuple[float, Path]]) -> None:
    root = ElementTree.Element("VTKFile", type="Collection", version="0.1")
    collection = ElementTree.SubElement(root, "Collection")
    for time, file in files:
        ElementTree.SubElement(collection, "DataSet", timestep=repr(time), file=file.name)
    ElementTree.indent(root)
    with replacing(target) as part:
        ElementTree.ElementTree(root).write(part, encoding="utf-8", xml_declaration=True)
