# SPDX-License-Identifier: GPL-3.0-or-later
"""Plastic dissipation of a body, and elastic energy of its residual stress and eigenstrain."""

from __future__ import annotations

import numpy as np

from .._util.checks import FloatArray, require_type
from .._util.short_text import in_short
from ..bodies.layered import Body, backstresses_of, materials_at
from ..solutions.common_cells import on_common_cells
from ..solutions.state import State
from ..solutions.track import Track
from .motion import over_grid


def cell_volume(track: Track) -> float:
    grid = track.grid
    return grid.dx * grid.dy * (grid.dz or 0.0)


def product(a: FloatArray, b: FloatArray) -> float:
    """Return the sum of a:b over all cells; the first axis contains the tensor components."""
    return float(np.sum(a[:3] * b[:3]) + 2.0 * np.sum(a[3:] * b[3:]))


def plastic_work(material: Body, after: Track, before: Track | None = None) -> float:
    """Plastic work of a body, the integral of sigma : d eps^p [J].

    The work of the isotropic yield stress is integrated in closed form and depends only on the
    states `before` and `after`. The work of the backstress is computed with the mean backstress of
    both states. The error due to this mean is of second order in the size of the increment: compute
    the work of each increment, and add up the results.

    Parameters
    ----------
    material : Material or Layered
        Material of the body.
    after : Track
        Track of the body in the current state, from `State.track`.
    before : Track, optional
        Track of the body in an earlier state. Default: no plastic flow.

    Returns
    -------
    float
        Plastic work [J], >= 0 except for the error due to the mean backstress. Work of the
        backstress is partly recoverable.

    Raises
    ------
    ValueError
        The material has thermal softening: the yield stress does not follow from the state alone.
    """
    if not isinstance(material, Body):
        raise TypeError(
            f"material must be a samcontact.Material or samcontact.Layered, got "
            f"{in_short(material)}"
        )
    for name, track in (("after", after), ("before", after if before is None else before)):
        require_type(name, track, Track)
    if material.softening is not None:
        raise ValueError(
            "material must have no thermal softening: pass a material without softening"
        )
    if not material.is_plastic:
        return 0.0
    total = float(np.sum(isotropic_work(material, after)))
    if before is not None:
        total -= float(np.sum(isotropic_work(material, before)))
    if backstresses_of(material) > 0:
        total += work_of_backstress(after, before)
    return float(total) * cell_volume(after)


def isotropic_work(body: Body, track: Track, state: State | None = None) -> FloatArray:
    """Return the work of the isotropic yield stress [J/m^3], shape (nx, ny, nz).

    The result covers the cells of the track or, if a state is given, of the grid of the state.
    Thermal softening is not included.
    """
    factor, strain = (
        getattr(track, name)() if state is None else over_grid(track, name, state)
        for name in ("yield_factor", "equivalent_plastic_strain")
    )
    work = np.zeros(strain.shape)
    for material, there in materials_at(body, track.z):
        work[..., there] = factor[..., there] * material.plastic_work(strain[..., there])
    return work


def work_of_backstress(after: Track, before: Track | None) -> float:
    """Return the work of the mean backstress on the strain increment, summed over cells [J/m^3]."""
    if before is None:
        return 0.5 * product(after.backstress().sum(axis=0), after.plastic_strain())
    old, new = on_common_cells(before, after, "backstress")
    start, end = on_common_cells(before, after, "plastic_strain")
    return 0.5 * product((old + new).sum(axis=0), end - start)


def residual_energy(track: Track) -> float:
    """Elastic energy of the residual stress of a body [J], -1/2 of the integral of sigma : eps^p.

    The residual stress is in equilibrium without tractions. The work of this stress on the total
    strain therefore vanishes, and in the integral of the elastic energy the elastic strain can be
    replaced by minus the plastic strain. This energy can be released, but not by contact alone.
    Mura, *Micromechanics of Defects in Solids* (1987), eq. (13.4).

    For a body with initial stress or eigenstrain, the result is the change of elastic energy due to
    plastic strain; this change may be negative. The work of the initial stress on the plastic
    strain enters without the factor 1/2.
    """
    require_type("track", track, Track)
    stress = track.residual_stress() + track.initial_stress() + track.eigenstress()
    return -0.5 * product(stress, track.plastic_strain()) * cell_volume(track)


def eigenstrain_energy(track: Track) -> float:
    """Elastic energy of a body under its prescribed eigenstrain alone [J], >= 0.

    The energy is -1/2 of the integral of sigma : eps, with the eigenstrain eps and the stress sigma
    due to this eigenstrain, as in `residual_energy`. Tractions do not change this energy, because
    the stress due to tractions does practically no work on the elastic strain due to the
    eigenstrain.
    """
    require_type("track", track, Track)
    return -0.5 * product(track.eigenstress(), track.eigenstrain()) * cell_volume(track)
