# SPDX-License-Identifier: GPL-3.0-or-later
"""All increments as VTK files, and the collections by which ParaView shows them one after another.

A collection (.pvd) is a list of files with their times: https://www.paraview.org/Wiki/ParaView/Data_formats.
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
    """Write every increment as `to_vtk` does, and collections of them.

    Parameters
    ----------
    dataset : xarray.Dataset
        From `samcontact.results.to_dataset` or `open_results`.
    path : str or Path
        Collection of the volume fields, of those increments that have some; that of the surface, of
        all increments, goes beside it, to ``*_surface.pvd``. The files of the increments have their
        number in five digits behind the name, ``*_00001.vtr`` (or .vtu), ``*_00001_surface.vtr``.
        The ending .pvd is added where it is missing. The directory must exist.
    body : {1, 2}, optional
        Whose volume fields and print are written; default that of [output], or the one that has
        volume fields.

    Returns
    -------
    list of Path
        The collections, then the files of each increment, then those of a track. The time of an
        increment is that of its end [s] in a run with heat of a `history`, else its number.

    Raises
    ------
    ValueError
        An unknown body.
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
    volumes = dataset["volume_increment"].values.tolist() if volume_names(dataset, body) else []
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
