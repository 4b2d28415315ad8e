# SPDX-License-Identifier: GPL-3.0-or-later
"""Largest stresses and strains of the matrix near inclusions, over a cycle of states."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from .._util.checks import BoolArray, FloatArray, choice, require_type
from .._util.display import HtmlTable, Rows, quantity
from .._util.frozen import FrozenDict
from .._util.short_text import in_short
from ..bodies.heterogeneous import Heterogeneous
from ..fatigue.criteria import dang_van, max_von_mises
from ..fatigue.cycle import Cycle, cycle, plastic_strain_in
from ..fatigue.field import FatigueField
from ..solutions.state import State
from .surroundings import Surroundings, checked_field, checked_within, names_near, surroundings

PERCENTILES = (50.0, 90.0, 99.0, 99.9)
"""Percentiles of the von Mises stress that `MatrixStatistics` contains."""


@dataclass(frozen=True)
class Peak(HtmlTable):
    """Largest value of a field in the matrix.

    Attributes
    ----------
    value : float
        Value, in the unit of the field.
    position : tuple of float
        Coordinates x, y and z [m].
    number : int
        Index of the nearest inclusion in `Heterogeneous.inclusions`; -1 if none is near, i.e.
        within the distance `within` of `peaks` or `statistics`.
    distance : float
        Distance from the centre of the nearest inclusion, in radii of this inclusion; infinite if
        none is near.
    angle : float
        Direction from this centre in the plane x-z [rad]: 0 along x, pi/2 towards the surface; NaN
        if no inclusion is near.
    """

    value: float
    position: tuple[float, float, float]
    number: int
    distance: float
    angle: float

    def _rows(self) -> Rows:
        return [
            ("value", quantity(self.value)),
            ("position", ", ".join(quantity(value, "m") for value in self.position)),
            ("inclusion", str(self.number) if self.number >= 0 else "none near"),
            ("distance from its centre", f"{self.distance:.3g} radii"),
            ("angle", f"{math.degrees(self.angle):.3g}°"),
        ]


@dataclass(frozen=True)
class MatrixStatistics(HtmlTable):
    """Largest stresses and strains of the matrix over a cycle, as computed by `statistics`.

    Attributes
    ----------
    near, anywhere : mapping of str to Peak
        Peaks near inclusions, and peaks in the whole matrix. The keys are "von_mises" [Pa],
        "dang_van" [Pa] if a slope was given, and "plastic_strain" (magnitude, [-]) if the matrix
        has yielded.
    percentiles : mapping of str to float
        Percentiles of the von Mises stress [Pa] of the matrix near inclusions, with the keys "50",
        "90", "99" and "99.9".
    cells : int
        Number of cells of the matrix near inclusions.
    """

    near: FrozenDict[Peak]
    anywhere: FrozenDict[Peak]
    percentiles: FrozenDict[float]
    cells: int

    def _rows(self) -> Rows:
        rows = []
        for place, peaks in (("near inclusions", self.near), ("anywhere", self.anywhere)):
            for name, peak in peaks.items():
                unit = "" if name == "plastic_strain" else "Pa"
                label = f"maximum {name.replace('_', ' ')} {place}"
                rows.append((label, quantity(peak.value, unit)))
        return [*rows, ("cells near inclusions", str(self.cells))]


def statistics(
    states: State | Sequence[State] | Cycle,
    body: int = 2,
    within: float = 1.5,
    slope: float | None = None,
) -> MatrixStatistics:
    """Largest von Mises stress, Dang Van stress and plastic strain of the matrix.

    Only cells that contain no part of an inclusion are considered, because the stress of a partly
    filled cell is a mean over both materials. The maxima depend on the number of cells per radius,
    so compare bodies on equal grids.

    Parameters
    ----------
    states : State, sequence of State, or samcontact.fatigue.Cycle
        States of a simulation with a heterogeneous body, e.g. of a rolling pass.
    body : {1, 2}, optional
        Number of the heterogeneous body. Ignored for a `Cycle`, which contains one body only.
        Default: 2.
    within : float, optional
        Distance from the centre up to which a cell counts as near an inclusion, in radii. Default:
        1.5.
    slope : float, optional
        Weight of the mean normal stress in `samcontact.fatigue.dang_van`. Default: the Dang Van
        stress is not computed.

    Returns
    -------
    MatrixStatistics

    Raises
    ------
    ValueError
        No cell of the matrix is near an inclusion, or an argument is outside its range.
    TypeError
        The body is not heterogeneous, or an argument has the wrong type.
    """
    ratio = checked_within(within)
    choice("body", body, (1, 2))
    of = _as_cycle(states, body)
    described = of.body
    require_type(f"body{body}", described, Heterogeneous)
    assert isinstance(described, Heterogeneous)
    fields = {"von_mises": max_von_mises(of)}
    if slope is not None:
        fields["dang_van"] = dang_van(of, slope=slope)
    axes = checked_field(fields["von_mises"], described)
    around = surroundings(axes, described, ratio)
    is_near = around.is_matrix & (around.number >= 0)
    if not is_near.any():
        raise ValueError(
            f"states must contain cells of the matrix within {ratio:g} radii of an inclusion, got "
            "none: check that the inclusions lie inside the grid"
        )
    values = {name: field.values for name, field in fields.items()}
    strain = _plastic_magnitude(of)
    if strain[around.is_matrix].any():
        values["plastic_strain"] = strain
    return MatrixStatistics(
        FrozenDict({n: _peak(v, is_near, axes, around, described) for n, v in values.items()}),
        FrozenDict(
            {n: _peak(v, around.is_matrix, axes, around, described) for n, v in values.items()}
        ),
        FrozenDict({f"{p:g}": float(np.percentile(values["von_mises"][is_near], p))
                    for p in PERCENTILES}),
        int(is_near.sum()),
    )  # fmt: skip


def peaks(field: FatigueField, body: Heterogeneous, within: float = 1.5) -> list[Peak]:
    """Largest value of a field in the matrix around each inclusion.

    Parameters
    ----------
    field : FatigueField
        Criterion over a cycle of states, with the axes x, y and z.
    body : Heterogeneous
        Body for which the field was computed.
    within : float, optional
        Distance from the centre up to which a cell counts as near an inclusion, in radii. Default:
        1.5.

    Returns
    -------
    list of Peak
        One peak for each inclusion with cells of the matrix near it, in the order of the
        inclusions.

    Raises
    ------
    ValueError
        The field has axes other than x, y and z, or `within` is outside its range.
    TypeError
        An argument has the wrong type.
    """
    ratio = checked_within(within)
    axes = checked_field(field, body)
    around = surroundings(axes, body, ratio)
    return [
        _peak(field.values, around.is_matrix & (around.number == n), axes, around, body)
        for n in names_near(around)
    ]


def _as_cycle(states: Any, body: int) -> Cycle:
    if isinstance(states, Cycle):
        return states
    if isinstance(states, State):
        return cycle([states, states], body)
    if not isinstance(states, Sequence):
        raise TypeError(
            f"states must be a State, a list of them or a Cycle, got {in_short(states)}"
        )
    return cycle(states if len(states) != 1 else [states[0], states[0]], body)


def _plastic_magnitude(of: Cycle) -> FloatArray:
    """Largest magnitude of the plastic strain e over a cycle, sqrt(2/3 e:e), at each point."""
    layers = []
    for k in range(of.points_shape[-1]):
        e = plastic_strain_in(of, slice(k, k + 1))
        square = (e[:, :3] ** 2).sum(axis=1) + 2 * (e[:, 3:] ** 2).sum(axis=1)
        layers.append(np.sqrt(2 / 3 * square.max(axis=0)).reshape(of.points_shape[:-1]))
    return np.stack(layers, axis=-1)


def _peak(
    values: FloatArray,
    where: BoolArray,
    axes: Sequence[FloatArray],
    around: Surroundings,
    body: Heterogeneous,
) -> Peak:
    """Return the largest value among the points that `where` selects."""
    flat = int(np.where(where, values, -np.inf).argmax())
    index = np.unravel_index(flat, values.shape)
    x, y, z = (float(axis[i]) for axis, i in zip(axes, index, strict=True))
    number = int(around.number[index])
    angle = math.nan
    if number >= 0:
        center = body.inclusions[number].center
        angle = math.atan2(center[2] - z, x - center[0])
    return Peak(float(values[index]), (x, y, z), number, float(around.distance[index]), angle)
