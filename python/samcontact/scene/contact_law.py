# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact laws: how far the pressure may fall at a gap, and which cells are in contact.

Nothing else compares a pressure with zero.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, astuple, dataclass, field
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import _core
from .._util.cached_property import cached_property
from .._util.checks import non_negative, require_type
from .._util.display import Shown
from .._util.short_text import in_short
from ..heat import Heat


@dataclass(frozen=True)
class ContactLaw(Shown):
    """A contact law, with its parameters as fields.

    The pressure is p = r - a(g), with a repulsion r >= 0 that closed cells carry and an attraction
    a(g) >= 0 across the gap g. Where the law attracts, friction goes with the repulsion, the
    grid is not enlarged, a simulation starts with the bodies apart, under the largest tension, and
    `advance`, prescribed pressure and heat are refused. The unit of a parameter is metadata of its
    field.
    """

    kind: ClassVar[str]
    """Name of the law in case files, results and the core."""

    def to_core(self) -> _core.ContactLaw:
        """The law in the core."""
        return _core.ContactLaw(self.kind, list(astuple(self)))

    @cached_property
    def attracts(self) -> bool:
        """Whether surfaces attract each other."""
        return self.to_core().attracts

    def to_tree(self) -> dict[str, Any]:
        """Kind and parameters by name."""
        return {"kind": self.kind, **asdict(self)}

    def require_possible(self, heat: Heat, given: Mapping[str, Any]) -> None:
        """Raise ValueError for what an attraction has no part in.

        Parameters
        ----------
        heat : Heat
            Frictional heat.
        given : mapping
            Arguments of `Simulation.step` or `ContactSolver.solve`.

        Raises
        ------
        ValueError, TypeError
            Something that the law excludes, or an argument of the wrong kind.
        """
        if not self.attracts:
            return
        require_type("heat", heat, Heat)
        require_type("given", given, Mapping)
        if any(heat.factor) or heat.partition is not None:
            raise ValueError(
                f"heat must be left out with contact_law = {self!r}, got {in_short(heat)}"
            )
        if given.get("pressure") is not None:
            raise ValueError(
                f"pressure must be left out with contact_law = {self!r}: no contact is solved then"
            )
        ways: Sequence[float] = given.get("advance", (0.0, 0.0))
        if np.any(ways):
            raise ValueError(
                f"advance must be (0, 0) with contact_law = {self!r}, got {tuple(ways)!r}: the "
                "surfaces that attract each other do not leave the grid"
            )


@dataclass(frozen=True)
class HardContact(ContactLaw):
    """Hard contact, for `ContactSolver` and `Simulation`: p >= 0, without attraction."""

    kind: ClassVar[str] = "hard"


@dataclass(frozen=True)
class TensileLimit(ContactLaw):
    """Constant tensile limit, for `ContactSolver` and `Simulation`: p >= -limit.

    Surfaces part where the tension reaches the limit, and open cells go on to carry it at any gap:
    an attraction of infinite range, Dugdale's (1960, doi:10.1016/0022-5096(60)90013-2) without an
    end. So does a gap that is evacuated, or filled by a liquid whose pressure is lower by the
    limit, as capillary pressure is; for attraction across gaps it is the limit of a range that is
    large against them, as in Derjaguin, Muller and Toporov's theory of adhesion. The solution is
    unique: it does not depend on the path. The force of the attraction is the limit times the area
    of the grid; on one that is not periodic it grows with the grid, and bends the surfaces.

    Attributes
    ----------
    limit : float
        Tensile limit [Pa], >= 0; 0 is hard contact.

    Raises
    ------
    ValueError, TypeError
        A limit that is negative or not finite, or no number.
    """

    kind: ClassVar[str] = "tensile_limit"
    limit: float = field(metadata={"unit": "Pa"})

    def __post_init__(self) -> None:
        object.__setattr__(self, "limit", non_negative("limit", self.limit))


LAWS: tuple[type[ContactLaw], ...] = (HardContact, TensileLimit)
"""Contact laws of case files and checkpoints."""


def law_of(tree: Mapping[str, Any]) -> ContactLaw:
    """Contact law of a tree from `ContactLaw.to_tree`.

    Raises ValueError for an unknown kind, TypeError for parameters of another one.
    """
    parameters = dict(tree)
    kind = parameters.pop("kind")
    for law in LAWS:
        if law.kind == kind:
            return law(**parameters)
    raise ValueError(f"kind must be one of {[law.kind for law in LAWS]}, got {kind!r}")


def require_law(name: str, value: Any) -> ContactLaw:
    """The value, if it is a contact law; TypeError otherwise."""
    require_type(name, value, ContactLaw)
    law: ContactLaw = value
    return law


def in_contact(repulsion: ArrayLike) -> NDArray[np.bool_]:
    """Whether cells are in contact, from their repulsion; that of hard contact is the pressure."""
    found: NDArray[np.bool_] = np.asarray(repulsion) > 0
    return found
