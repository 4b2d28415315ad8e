# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact laws, i.e. lower bounds of the pressure at a given gap, and the contact condition.

A cell is in contact if its pressure exceeds the lower bound. This condition is defined in this
module only.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import _core
from .._util.cached_property import cached_property
from .._util.checks import FloatArray, boolean, non_negative, require_type
from .._util.display import HtmlTable
from .._util.short_text import in_short
from ..heat import Heat

if TYPE_CHECKING:
    from ..bodies.layered import Body
    from .grid import Grid


@dataclass(frozen=True)
class ContactLaw(HtmlTable):
    """Contact law; the dataclass fields are the parameters, with their units as metadata.

    The pressure is p = r - a(g). The repulsion r is >= 0 in cells without a gap and 0 elsewhere;
    a(g) >= 0 is the attraction across the gap g. With an attractive law (a > 0), friction depends
    on the repulsion (unless `friction_on` of `Adhesion` states otherwise), the grid is not
    enlarged, and a simulation starts with separated bodies under the maximum tension. An attractive
    law supports neither a prescribed pressure nor heat, and `advance` only if it is a law of
    `Adhesion` in full sliding.
    """

    kind: ClassVar[str]
    """Name of the law in case files, in results and in the compiled core."""

    def to_core(self) -> _core.ContactLaw:
        """Return the law as an object of the compiled core."""
        parameters: tuple[str, ...] = self.__match_args__
        return _core.ContactLaw(self.kind, [getattr(self, name) for name in parameters])

    @cached_property
    def attracts(self) -> bool:
        """Whether the surfaces attract each other."""
        return self.to_core().attracts

    def to_tree(self) -> dict[str, Any]:
        """Return the kind of the law and the parameters, as a dictionary."""
        return {"kind": self.kind, **asdict(self)}

    def may_move(self, sticks: bool) -> bool:
        """Whether bodies may move through the grid; sticks: whether friction allows partial slip.

        Adhering bodies may move only in full sliding with an attraction that depends on the gap.
        """
        return (not boolean("sticks", sticks) and self.varies) or not self.attracts

    @property
    def varies(self) -> bool:
        """Whether the attraction depends on the gap, so that several solutions may exist."""
        return False

    @property
    def rubs_by_compression(self) -> bool:
        """Whether friction depends on the compressive part of the pressure, not on repulsion."""
        return False

    @property
    def is_of_grid(self) -> bool:
        """Whether the range of the attraction is chosen for the grid, because none is given."""
        return False

    def resolved(self, grid: Grid, body1: Body, body2: Body) -> ContactLaw:
        """Return the law as it is solved on a grid between two bodies."""
        return self

    def require_possible(
        self, heat: Heat, given: Mapping[str, Any], *, sticks: bool = False
    ) -> None:
        """Raise ValueError for arguments that an attractive law does not support.

        Parameters
        ----------
        heat : Heat
            Frictional heat.
        given : mapping
            Arguments of `Simulation.step` or `ContactSolver.solve`.
        sticks : bool, optional
            Whether friction allows partial slip.

        Raises
        ------
        ValueError, TypeError
            The law does not support an argument, or an argument has the wrong type.
        """
        boolean("sticks", sticks)
        if not self.attracts:
            return
        require_type("heat", heat, Heat)
        require_type("given", given, Mapping)
        if any(heat.factor) or heat.partition is not None:
            raise ValueError(
                f"heat is not supported with adhesion = {self!r}, got {in_short(heat)}: omit "
                "heat, or use HardContact()"
            )
        if given.get("pressure") is not None:
            raise ValueError(
                f"pressure cannot be combined with adhesion = {self!r}: with a prescribed "
                "pressure there is no contact to solve"
            )
        travels: Sequence[float] = given.get("advance", (0.0, 0.0))
        if np.any(travels) and not self.may_move(sticks):
            slip = " and partial slip" if sticks else ""
            raise ValueError(
                f"advance must be (0, 0) with adhesion = {self!r}{slip}, got {tuple(travels)!r}: "
                "with attraction, bodies can move through the grid only if the law is one of "
                "Adhesion and friction is a number (full sliding)"
            )


@dataclass(frozen=True)
class HardContact(ContactLaw):
    """Hard contact, for `ContactSolver` and `Simulation`: p >= 0, without attraction."""

    kind: ClassVar[str] = "hard"


@dataclass(frozen=True)
class TensileLimit(ContactLaw):
    """Constant tensile limit, for `ContactSolver` and `Simulation`: p >= -limit.

    Surfaces separate where the tension reaches the limit, and open cells carry this tension at any
    gap. This is the attraction of Dugdale (1960, doi:10.1016/0022-5096(60)90013-2) with infinite
    range. The law describes an evacuated gap, and a gap filled with a liquid whose pressure is
    lower than the ambient pressure by the limit (capillary pressure). For adhesion, it is the
    limiting case of an attraction with a range much larger than the gaps, as in the theory of
    Derjaguin, Muller and Toporov. The solution is unique and independent of the loading path. The
    attractive force is the tensile limit times the area of the grid. On a grid that is not
    periodic, it therefore increases with the size of the grid and bends the surfaces.

    Attributes
    ----------
    limit : float
        Tensile limit [Pa], >= 0; 0 is hard contact.

    Raises
    ------
    ValueError, TypeError
        The limit is negative, not finite or not a number.
    """

    kind: ClassVar[str] = "tensile_limit"
    limit: float = field(metadata={"unit": "Pa"})

    def __post_init__(self) -> None:
        object.__setattr__(self, "limit", non_negative("limit", self.limit))


def require_law(name: str, value: Any) -> ContactLaw:
    """Return the value if it is a contact law; raise TypeError otherwise."""
    require_type(name, value, ContactLaw)
    law: ContactLaw = value
    return law


def in_contact(repulsion: ArrayLike) -> NDArray[np.bool_]:
    """Whether cells are in contact; `repulsion` is pressure plus attraction of each cell [Pa]."""
    found: NDArray[np.bool_] = np.asarray(repulsion) > 0
    return found


def rubbing_pressure(
    repulsion: FloatArray, pressure: FloatArray, by_compression: bool
) -> FloatArray:
    """Return the pressure on which the friction of cells depends [Pa], >= 0."""
    if not by_compression:
        return repulsion
    return np.where(in_contact(repulsion), np.maximum(pressure, 0.0), 0.0)
