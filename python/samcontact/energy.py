# SPDX-License-Identifier: GPL-3.0-or-later
"""Energy of elastic-plastic contact: what flow dissipates, and what stays as residual stress."""

from __future__ import annotations

import numpy as np

from ._checks import FloatArray
from .material import Material
from .track import Track

__all__ = ["plastic_work", "residual_energy"]


def _cell_volume(track: Track) -> float:
    grid = track.grid
    return grid.dx * grid.dy * (grid.dz or 0.0)


def _common(before: Track, after: Track, field: str) -> tuple[FloatArray, FloatArray]:
    """A field of two tracks on the cells of both; beside either nothing has yielded."""
    tracks, corner, size = (before, after), [], []
    for axis in "xy":
        places = np.concatenate([getattr(track, axis) for track in tracks])
        step = getattr(after.grid, f"d{axis}")
        corner.append(places.min())
        size.append(round(np.ptp(places) / step) + 1)
    fields = []
    for track in tracks:
        values: FloatArray = getattr(track, field)()
        whole = np.zeros((*values.shape[:-3], *size, max(t.grid.nz for t in tracks)))
        i = round((track.x[0] - corner[0]) / track.grid.dx)
        j = round((track.y[0] - corner[1]) / track.grid.dy)
        nx, ny, nz = track.grid.volume_shape
        whole[..., i : i + nx, j : j + ny, :nz] = values
        fields.append(whole)
    return fields[0], fields[1]


def _product(a: FloatArray, b: FloatArray) -> float:
    """Sum of a:b over all cells; tensor components first."""
    return float(np.sum(a[:3] * b[:3]) + 2.0 * np.sum(a[3:] * b[3:]))


def plastic_work(material: Material, after: Track, before: Track | None = None) -> float:
    """Work of the stress on the plastic strain of a body, the integral of sigma : d eps^p [J].

    Isotropic hardening is integrated in closed form, so that it depends on the state alone. The
    backstresses of kinematic hardening are averaged between the two states (second order in the
    increment): add up increments then.

    Parameters
    ----------
    material : Material
        Of the body.
    after : Track
        The body now, from `State.track`.
    before : Track, optional
        The same body earlier; default before any flow.

    Returns
    -------
    float
        [J], >= 0 but for the error of the backstress; part of that of the backstress can be given
        back later.

    Raises
    ------
    ValueError
        A material with thermal softening, whose yield stress the state does not tell.
    """
    if material.softening is not None:
        raise ValueError("plastic_work needs a material without softening")
    if not material.is_plastic:
        return 0.0
    total = np.sum(material.plastic_work(after.equivalent_plastic_strain()))
    if before is not None:
        total -= np.sum(material.plastic_work(before.equivalent_plastic_strain()))
    if material.kinematic:
        total += _work_of_backstress(after, before)
    return float(total) * _cell_volume(after)


def _work_of_backstress(after: Track, before: Track | None) -> float:
    """Sum over cells of the mean backstress times the strain increment."""
    if before is None:
        return 0.5 * _product(after.backstress().sum(axis=0), after.plastic_strain())
    old, new = _common(before, after, "backstress")
    start, end = _common(before, after, "plastic_strain")
    return 0.5 * _product((old + new).sum(axis=0), end - start)


def residual_energy(track: Track) -> float:
    """Elastic energy of the residual stress of a body [J], -1/2 of the integral of sigma : eps^p.

    The residual stress is in equilibrium, without tractions, so that its work on the total strain
    vanishes and its elastic strain is as good as minus the plastic one. It can be released again,
    but not by contact alone. Mura, *Micromechanics of Defects in Solids* (1987), eq. (13.4).
    """
    return -0.5 * _product(track.residual_stress(), track.plastic_strain()) * _cell_volume(track)
