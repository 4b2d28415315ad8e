# SPDX-License-Identifier: GPL-3.0-or-later
"""Stress of the matrix at the interface of an inclusion, and tractions that open the interface.

At a bonded interface, the traction and the strain within the plane of the interface are continuous
(Hadamard). The stress of the matrix therefore follows from the stress and the total strain inside
the inclusion (interface operator of Hill, 1983, doi:10.1017/S0305004100061478). For an ellipsoid,
the mean values inside approximate the uniform fields of Eshelby's solution.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, choice, finite_array, integer, require_type
from .._util.display import HtmlTable, Rows, quantity
from .._util.short_text import in_short
from .._util.tensors import von_mises
from ..bodies.heterogeneous import Heterogeneous, material_around
from ..bodies.inclusion import Inclusion
from ..bodies.material import Material
from ..solutions.state import State
from .tensors import as_matrix, as_six, fibonacci_directions, strain_of

DIRECTIONS = 2000
"""Number of points at which the tractions of an interface are computed."""


def interface_stress(
    stress: ArrayLike, eigenstrain: ArrayLike, normal: ArrayLike, matrix: Material
) -> FloatArray:
    """Stress of the matrix at the interface of an inclusion.

    Parameters
    ----------
    stress : array_like, shape (6,)
        Stress inside the inclusion at the interface, or mean stress of the inclusion [Pa].
    eigenstrain : array_like, shape (6,)
        Equivalent eigenstrain [-], which in a homogeneous body has the effect of the inclusion, see
        `State.eigenstrain`.
    normal : array_like, shape (3, n)
        Unit normals of the interface.
    matrix : Material
        Material of the matrix, which is assumed to be elastic at the interface.

    Returns
    -------
    ndarray, shape (6, n)
        Stress of the matrix at the interface, for each normal [Pa].

    Raises
    ------
    ValueError
        A shape is wrong, or a normal is not a unit vector.
    TypeError
        An argument is not a number or not a material.
    """
    require_type("matrix", matrix, Material)
    inner = finite_array("stress", stress, (6,))
    n = finite_array("normal", normal)
    if n.ndim != 2 or len(n) != 3 or np.abs((n**2).sum(axis=0) - 1.0).max(initial=0.0) > 1e-6:
        raise ValueError(
            f"normal must contain n unit vectors as columns, shape (3, n), got {in_short(normal)}"
        )
    E, nu = matrix.E, matrix.nu
    total = strain_of(inner, E, nu) + finite_array("eigenstrain", eigenstrain, (6,))
    plane = np.eye(3)[..., None] - n[:, None] * n[None]  # projector onto the interface
    traction = as_matrix(inner) @ n
    across = (n * traction).sum(axis=0)
    strain = np.einsum("ikn,kl,ljn->ijn", plane, as_matrix(total), plane)
    trace = np.einsum("iin->n", strain)
    # plane stress of the interface plus the effect of the normal stress
    within = (
        E / (1 + nu) * (strain + nu / (1 - nu) * trace * plane) + nu / (1 - nu) * across * plane
    )
    outer = n[:, None] * traction[None]
    return as_six(outer + outer.swapaxes(0, 1) - across * n[:, None] * n[None] + within)


@dataclass(frozen=True)
class Interface(HtmlTable):
    """Largest tractions at the interface of one inclusion, as computed by `interfaces`.

    Attributes
    ----------
    number : int
        Index of the inclusion in `Heterogeneous.inclusions`.
    max_tension : float
        Largest normal stress at the interface [Pa]; negative if the interface is compressed
        everywhere.
    tension_normal : tuple of float
        Outward normal at the place of the largest normal stress.
    max_shear : float
        Largest shear stress at the interface [Pa].
    max_von_mises : float
        Largest von Mises stress of the matrix at the interface [Pa].
    von_mises_normal : tuple of float
        Outward normal at the place of the largest von Mises stress.
    """

    number: int
    max_tension: float
    tension_normal: tuple[float, ...]
    max_shear: float
    max_von_mises: float
    von_mises_normal: tuple[float, ...]

    def _rows(self) -> Rows:
        return [
            ("inclusion", str(self.number)),
            ("maximum tension", quantity(self.max_tension, "Pa")),
            ("maximum shear stress", quantity(self.max_shear, "Pa")),
            ("maximum von Mises stress of the matrix", quantity(self.max_von_mises, "Pa")),
        ]


def normals_of(inclusion: Inclusion, count: int = DIRECTIONS) -> FloatArray:
    """Outward unit normals of an ellipsoid, shape (3, count), at evenly distributed points."""
    axes, radii = np.array(inclusion.axes), np.array(inclusion.radii)
    scaled = axes.T @ (fibonacci_directions(count) / radii[:, None])
    return np.asarray(scaled / np.linalg.norm(scaled, axis=0))


def interface_of(
    number: int, inclusion: Inclusion, stress: FloatArray, eigenstrain: FloatArray, matrix: Material
) -> Interface:
    """Return the largest tractions at the interface of an inclusion.

    stress, eigenstrain: mean values inside the inclusion, shape (6,).
    """
    normal = normals_of(inclusion)
    inner = np.zeros(6) if inclusion.is_void else stress
    outside = von_mises(interface_stress(inner, eigenstrain, normal, matrix))
    traction = as_matrix(inner) @ normal
    across = (normal * traction).sum(axis=0)
    shear = np.linalg.norm(traction - across * normal, axis=0)
    opened, worst = int(across.argmax()), int(outside.argmax())
    return Interface(
        number,
        float(across[opened]),
        tuple(normal[:, opened].tolist()),
        float(shear.max()),
        float(outside[worst]),
        tuple(normal[:, worst].tolist()),
    )


def interfaces(
    state: State, body: int = 2, numbers: Sequence[int] | None = None
) -> list[Interface]:
    """Largest tractions at the interface of each inclusion in a body, for one state.

    The tractions follow from the mean stress inside each inclusion and from the mean of its
    eigenstrain. Tension can open an interface: compare `max_tension` with the strength of the bond.

    Parameters
    ----------
    state : State
        State of a simulation. The body may have moved by a whole number of cells.
    body : {1, 2}, optional
        Number of the heterogeneous body. Default: 2.
    numbers : sequence of int, optional
        Indices of the inclusions. Default: all inclusions that lie entirely within the grid.

    Returns
    -------
    list of Interface

    Raises
    ------
    ValueError
        The body has moved by a distance that is not a whole number of cells, or an inclusion in
        `numbers` does not lie entirely within the grid.
    TypeError
        The body is not heterogeneous.
    """
    require_type("state", state, State)
    which = choice("body", body, (1, 2))
    described = state.setup.bodies[which - 1]
    require_type(f"body{which}", described, Heterogeneous)
    assert isinstance(described, Heterogeneous)
    if abs(state.offset(which)) > 0.0:
        raise ValueError(
            f"fields of body{which} must lie on the cells of the grid, got an offset of "
            f"{state.offset(which):.3g} m: move the body by a whole number of cells"
        )
    means = MeanFields(described, state, which)
    if numbers is not None and not isinstance(numbers, (list, tuple, range)):
        raise TypeError(f"numbers must be a list of integers, got {in_short(numbers)}")
    found = []
    for number in range(len(described.inclusions)) if numbers is None else numbers:
        at = integer("numbers", number, 0)
        if at >= len(described.inclusions):
            raise ValueError(f"numbers must be indices < {len(described.inclusions)}, got {at}")
        if not means.contains(at):
            if numbers is None:
                continue
            raise ValueError(
                f"numbers must be indices of inclusions that lie entirely within the grid, got "
                f"{at}: omit this index, or enlarge the grid"
            )
        around = material_around(described, at)
        found.append(interface_of(at, described.inclusions[at], *means.of(at), around))
    return found


class MeanFields:
    """Mean stress and mean eigenstrain of each inclusion of a body, from the fields of a state."""

    def __init__(self, body: Heterogeneous, state: State, which: int) -> None:
        cells = body.cells_on(state.grid, check=False)
        layers = cells.first[2] + cells.phase.shape[2]
        state = state.at_layers(max(layers, len(state.depths)))
        self.share = np.asarray(state.share(which))
        self.phase = np.asarray(state.phase(which))
        self.stress = np.asarray(state.stress(which))
        self.eigenstrain = np.asarray(state.eigenstrain(which))
        self.plastic = np.asarray(state.plastic_strain(which))
        count = len(body.inclusions) + 1
        every = np.bincount(cells.phase.ravel() + 1, minlength=count)
        inside = np.bincount(self.phase.ravel() + 1, minlength=count)
        self.complete = (every == inside)[1:]

    def contains(self, number: int) -> bool:
        """Whether an inclusion lies entirely within the grid."""
        return bool(self.complete[number])

    def of(self, number: int) -> tuple[FloatArray, FloatArray]:
        """Mean stress [Pa] of the cells completely in an inclusion, and mean eigenstrain [-].

        The mean eigenstrain of the inclusion is the sum over completely and partly filled cells,
        divided by the filled volume. This sum does not include the plastic strain of the matrix in
        partly filled cells. The mean eigenstrain is more accurate than a mean over the completely
        filled cells and, in contrast to such a mean, unique in a void.
        """
        mine = self.phase == number
        share = self.share[mine]
        full = share >= 1.0
        if not full.any():
            raise ValueError(
                f"inclusions[{number}] must fill at least one cell completely, got none: use "
                "smaller cells"
            )
        inner = self.stress[:, mine][:, full].mean(axis=1)
        of_matrix = (1.0 - share) * self.plastic[:, mine]
        total = (self.eigenstrain[:, mine] - of_matrix).sum(axis=1) / share.sum()
        return inner, total
