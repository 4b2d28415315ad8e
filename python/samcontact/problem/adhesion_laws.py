# SPDX-License-Identifier: GPL-3.0-or-later
"""Laws of adhesion: attraction between surfaces that decreases with the gap."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, fields, replace
from functools import lru_cache
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from .. import _core
from .._util.checks import choice, finite_array, positive, require_type
from .._util.display import MAX_REPR_CHARACTERS, UNIT_OF_FIELD, HtmlTable, Rows, quantity
from .._util.short_text import in_short
from ..bodies.layered import Body, require_bodies
from ..bodies.viscoelastic import relaxed
from .contact_law import ContactLaw, HardContact, TensileLimit
from .grid import Grid

RESOLVED = 0.5
"""Resolution number kappa (see `Adhesion`) for which the range is chosen if none is given."""
RESOLVED_DROP = 0.4
"""Resolution number kappa for which the drop of `Adhesion.dugdale` is chosen; it is smaller than
`RESOLVED`, because a drop has a sharper edge."""
MAX_RESOLVED, MAX_SOLVABLE = 0.6, 1.0
"""Resolution numbers kappa above which a warning is issued, and above which a law is rejected."""


FRICTION_ON = ("repulsion", "compression")
"""Pressures on which friction between adhering surfaces may depend."""


@dataclass(frozen=True, repr=False)
class Adhesion(ContactLaw):
    """Adhesion, for `ContactSolver` and `Simulation`: an attraction a(g) across the gap g.

    The pressure is p = r - a(g). The repulsion r is >= 0 where the gap is zero, and 0 elsewhere.
    The integral of a over g is the work of adhesion w [J/m^2]. Several states may be in
    equilibrium: a solution follows the branch of its initial state, and jumps where this branch
    ends (pull-in, pull-off). Use one of the constructors `exponential`, `dugdale`, `lennard_jones`,
    `tabulated` and `jkr`.

    The grid resolves a law if kappa = K0 s <= 0.6, where K0 is the displacement of a cell due to a
    unit pressure on it, and s is the steepest decrease of the attraction with the gap. With larger
    kappa, single cells jump into or out of contact. If kappa exceeds 0.6, a ResolutionWarning is
    issued; if it exceeds 1, the law is rejected. With range=None, the range is chosen so that
    kappa = 0.5; this range is called the shortest range that the grid resolves.

    All constructors have the argument `friction_on`, the pressure on which friction depends. With
    "repulsion", friction depends on r: under the load W, the force of Coulomb friction in full
    sliding is mu (W + total attraction), as in the law of Derjaguin (1934, doi:10.1007/BF01333114).
    With "compression", friction depends on p where p > 0; cells under tension transmit no shear.
    """

    friction_on: str = field(
        default="repulsion", kw_only=True, metadata={"choices": FRICTION_ON, "unit": ""}
    )
    """Pressure on which friction depends, "repulsion" or "compression"."""

    def __post_init__(self) -> None:
        checked = choice("friction_on", self.friction_on, FRICTION_ON)
        object.__setattr__(self, "friction_on", checked)

    @staticmethod
    def exponential(
        w: float, range: float | None = None, *, friction_on: str = "repulsion"
    ) -> ExponentialAdhesion:
        """Return the law a = w/range exp(-g/range).

        w: work of adhesion [J/m^2]; range [m], None: the shortest range that the grid resolves;
        friction_on: see `Adhesion`. Raises ValueError for values that are not > 0. Source: Rey,
        Anciaux & Molinari (2017, doi:10.1007/s00466-017-1392-5).
        """
        return ExponentialAdhesion(positive("w", w), range, friction_on=friction_on)

    @staticmethod
    def jkr(w: float, *, friction_on: str = "repulsion") -> ExponentialAdhesion:
        """Return the exponential law with the shortest range that the grid resolves.

        w: work of adhesion [J/m^2]. In the limit of small cells, the contact is that of Johnson,
        Kendall & Roberts (1971, doi:10.1098/rspa.1971.0141).
        """
        return ExponentialAdhesion(positive("w", w), friction_on=friction_on)

    @staticmethod
    def dugdale(w: float, stress: float, *, friction_on: str = "repulsion") -> DugdaleAdhesion:
        """Return Maugis' law of constant attraction (1992, doi:10.1016/0021-9797(92)90285-T).

        w: work of adhesion [J/m^2]; stress: constant attraction [Pa] up to a gap near w/stress;
        friction_on: see `Adhesion`. Near this gap the attraction falls to zero, as half a cosine
        wave, over the shortest distance that the grid resolves.
        """
        return DugdaleAdhesion(positive("w", w), stress, friction_on=friction_on)

    @staticmethod
    def lennard_jones(
        w: float, z0: float, *, friction_on: str = "repulsion"
    ) -> LennardJonesAdhesion:
        """Return a = 8 w/(3 z0) [(1 + g/z0)^-3 - (1 + g/z0)^-9], with a hard wall at g = 0.

        w: work of adhesion [J/m^2]; z0: equilibrium distance of the half-spaces [m];
        friction_on: see `Adhesion`.
        """
        return LennardJonesAdhesion(positive("w", w), z0, friction_on=friction_on)

    @staticmethod
    def tabulated(
        gap: ArrayLike, stress: ArrayLike, *, friction_on: str = "repulsion"
    ) -> TabulatedAdhesion:
        """Return a law in which the attraction is a piecewise linear function of the gap.

        gap: increasing gaps that start with 0 [m]; stress: attraction >= 0 at these gaps [Pa], 0 at
        the last gap; friction_on: see `Adhesion`. Raises ValueError for other values.
        """
        return TabulatedAdhesion(gap, stress, friction_on=friction_on)

    def on(self, grid: Grid, body1: Body, body2: Body) -> ResolvedAdhesion:
        """Return the law as it is solved on a grid, with the range, kappa and the Tabor number.

        For viscoelastic bodies, the long-time moduli are used, which require the smallest cells.
        Raises TypeError if an argument is not a grid or a body, ValueError for a
        viscoelastic body without a long-time modulus.
        """
        require_type("grid", grid, Grid)
        require_bodies(body1, body2, inclusions=True)
        influence, modulus = _of_cell(grid, body1, body2)
        law = self._refined(influence)
        return ResolvedAdhesion(law, influence * law.steepest_fall, law != self, modulus, grid)

    def _refined(self, influence: float) -> Adhesion:
        """Return the law with the shortest range that the grid resolves, if no range is given.

        influence: displacement of a cell due to a unit pressure on it [m/Pa].
        """
        return self

    @property
    def attracts(self) -> bool:
        """Whether the surfaces attract each other, which is always true."""
        return True

    @property
    def varies(self) -> bool:
        """Whether the attraction depends on the gap, which is always true."""
        return True

    def resolved(self, grid: Grid, body1: Body, body2: Body) -> ContactLaw:
        """Return the law as it is solved on a grid, with the chosen range if none is given.

        Raises ValueError if the cells are so large that single cells would jump into contact.
        """
        found = self.on(grid, body1, body2)
        if found.kappa > MAX_SOLVABLE:
            raise ValueError(
                f"adhesion must be resolved by the grid (kappa <= {MAX_SOLVABLE:g}), got kappa = "
                f"{found.kappa:.3g} for {self!r}: use cells with dx, dy <= {found.finer}, a longer "
                "range, or range=None, i.e. the shortest range that this grid resolves"
            )
        return found.law

    def to_core(self) -> _core.ContactLaw:
        """Return the law as an object of the compiled core; raise ValueError without a range."""
        missing = [item.name for item in fields(self) if getattr(self, item.name) is None]
        if missing:
            raise ValueError(
                f"{missing[0]} must be a number, got None: use law.on(grid, body1, body2).law, "
                "which has the shortest range that this grid resolves"
            )
        return _core.ContactLaw(self.kind, self._parameters(), self.rubs_by_compression)

    def _parameters(self) -> list[float]:
        """Return the parameters of the law in the order of the compiled core."""
        return [getattr(self, name) for name in self._own_names()]

    def _own_names(self) -> list[str]:
        return [item.name for item in fields(self) if item.name != "friction_on"]

    @property
    def rubs_by_compression(self) -> bool:
        """Whether friction depends on the compressive part of the pressure, not on repulsion."""
        return self.friction_on == "compression"

    def to_tree(self) -> dict[str, Any]:
        """Return the kind and the parameters of the law; `friction_on` only if not the default."""
        tree = super().to_tree()
        if not self.rubs_by_compression:
            del tree["friction_on"]
        return tree

    def __repr__(self) -> str:
        names = [*self._own_names(), *(["friction_on"] if self.rubs_by_compression else [])]
        given = (f"{name}={in_short(getattr(self, name), MAX_REPR_CHARACTERS)}" for name in names)
        return f"{type(self).__name__}({', '.join(given)})"

    def _rows(self) -> Rows:
        rows = [
            (name, quantity(getattr(self, name), UNIT_OF_FIELD[name])) for name in self._own_names()
        ]
        return [*rows, ("friction on", self.friction_on)] if self.rubs_by_compression else rows

    @property
    def steepest_fall(self) -> float:
        """Steepest decrease of the attraction with the gap [Pa/m]."""
        return float(self.to_core().steepest_fall)

    @property
    def peak(self) -> float:
        """Largest attraction [Pa]."""
        return float(self.to_core().largest_attraction)


@dataclass(frozen=True, repr=False)
class ExponentialAdhesion(Adhesion):
    """Exponential law of adhesion; see `Adhesion.exponential`."""

    kind: ClassVar[str] = "exponential"
    work: float = field(metadata={"unit": "J/m^2"})
    range: float | None = field(default=None, metadata={"unit": "m"})

    def __post_init__(self) -> None:
        super().__post_init__()
        object.__setattr__(self, "work", positive("work", self.work))
        if self.range is not None:
            object.__setattr__(self, "range", positive("range", self.range))

    @property
    def is_of_grid(self) -> bool:
        """Whether the range of the attraction is chosen for the grid."""
        return self.range is None

    def _refined(self, influence: float) -> Adhesion:
        if self.range is not None:
            return self
        return replace(self, range=math.sqrt(self.work * influence / RESOLVED))


@dataclass(frozen=True, repr=False)
class DugdaleAdhesion(Adhesion):
    """Law of constant attraction; see `Adhesion.dugdale`."""

    kind: ClassVar[str] = "dugdale"
    work: float = field(metadata={"unit": "J/m^2"})
    stress: float = field(metadata={"unit": "Pa"})
    drop: float | None = field(default=None, metadata={"unit": "m"})
    """Increase of the gap over which the attraction falls to zero [m]."""

    def __post_init__(self) -> None:
        super().__post_init__()
        for name in ("work", "stress"):
            object.__setattr__(self, name, positive(name, getattr(self, name)))
        if self.drop is not None:
            object.__setattr__(self, "drop", positive("drop", self.drop))

    def _refined(self, influence: float) -> Adhesion:
        if self.drop is not None:
            return self
        drop = 0.5 * math.pi * influence * self.stress / RESOLVED_DROP
        return replace(self, drop=min(drop, 2.0 * self.work / self.stress))


@dataclass(frozen=True, repr=False)
class LennardJonesAdhesion(Adhesion):
    """9-3 law of adhesion; see `Adhesion.lennard_jones`."""

    kind: ClassVar[str] = "lennard_jones"
    work: float = field(metadata={"unit": "J/m^2"})
    z0: float = field(metadata={"unit": "m"})

    def __post_init__(self) -> None:
        super().__post_init__()
        for name in ("work", "z0"):
            object.__setattr__(self, name, positive(name, getattr(self, name)))


@dataclass(frozen=True, repr=False)
class TabulatedAdhesion(Adhesion):
    """Piecewise linear law of adhesion; see `Adhesion.tabulated`."""

    kind: ClassVar[str] = "tabulated"
    gap: ArrayLike = field(metadata={"unit": "m", "many": True})
    stress: ArrayLike = field(metadata={"unit": "Pa", "many": True})

    def __post_init__(self) -> None:
        super().__post_init__()
        gaps = finite_array("gap", self.gap)
        if gaps.ndim != 1 or gaps.size < 2:
            raise ValueError(
                f"gap must be a list of at least two numbers, got an array of shape {gaps.shape}"
            )
        stresses = finite_array("stress", self.stress, gaps.shape)
        object.__setattr__(self, "gap", tuple(gaps.tolist()))
        object.__setattr__(self, "stress", tuple(stresses.tolist()))
        self.to_core()

    def _parameters(self) -> list[float]:
        points: list[float] = np.ravel(np.stack([self.gap, self.stress], axis=1)).tolist()
        return points


@dataclass(frozen=True)
class ResolvedAdhesion(HtmlTable):
    """Law of adhesion as it is solved on a grid; created by `Adhesion.on`.

    Attributes
    ----------
    law : Adhesion
        The law as it is solved, with its range.
    kappa : float
        Resolution number K0 s [-]; at most 0.6 if the grid resolves the law.
    is_refined : bool
        Whether the range was chosen for the grid, because none was given.
    modulus : float
        Contact modulus E* at the scale of a cell [Pa]; for layered bodies, the modulus near the
        surface.
    grid : Grid
    """

    law: Adhesion
    kappa: float
    is_refined: bool
    modulus: float
    grid: Grid

    @property
    def range(self) -> float:
        """Range of the attraction [m], i.e. its peak divided by its steepest decrease."""
        return self.law.peak / self.law.steepest_fall

    @property
    def finer(self) -> str:
        """Cell size for which kappa would be 0.5, as text with its unit."""
        return quantity(max(self.grid.dx, self.grid.dy) * RESOLVED / self.kappa, "m")

    @property
    def work(self) -> float:
        """Work of adhesion w [J/m^2]."""
        return float(self.law.to_core().work)

    def tabor(self, radius: float) -> float:
        """Return the Tabor number (R w^2/(E*^2 z^3))^(1/3) for a radius R of the surfaces [m].

        The length z is w divided by the peak attraction; for the exponential law, z is the range.
        `samcontact.adhesion.tabor` states which theory applies to a Tabor number. Raises ValueError
        if the radius is not > 0.
        """
        length = self.work / self.law.peak
        radius = positive("radius", radius)
        return float(np.cbrt(radius * self.work**2 / (self.modulus**2 * length**3)))

    def _rows(self) -> Any:
        return [
            ("law", repr(self.law)),
            ("resolution number kappa", quantity(self.kappa)),
            ("range", quantity(self.range, "m")),
            ("range chosen for the grid", "yes" if self.is_refined else "no"),
        ]


@lru_cache(maxsize=8)  # on periodic grids, the influence takes as long as a small contact
def _of_cell(grid: Grid, body1: Body, body2: Body) -> tuple[float, float]:
    """Return the displacement of a cell under unit pressure [m/Pa], and the contact modulus [Pa].

    The modulus is E* of homogeneous half-spaces in which the displacement of the cell is equal.
    """
    cores = relaxed(body1)._core, relaxed(body2)._core
    alone = Grid(1, 1, grid.dx, grid.dy)
    ratio = grid.dy / grid.dx
    shape = grid.dx * math.asinh(ratio) + grid.dy * math.asinh(1.0 / ratio)
    modulus = 2.0 * shape / (math.pi * _core.self_influence(alone._core, *cores))
    return float(_core.self_influence(grid._core, *cores)), modulus


def resolved_of(law: ContactLaw, grid: Grid, body1: Body, body2: Body) -> ResolvedAdhesion | None:
    """Return a law of adhesion as it is solved on a grid; None for other contact laws."""
    return law.on(grid, body1, body2) if isinstance(law, Adhesion) else None


LAWS: tuple[type[ContactLaw], ...] = (
    HardContact, TensileLimit, ExponentialAdhesion, DugdaleAdhesion, LennardJonesAdhesion,
    TabulatedAdhesion,
)  # fmt: skip
"""Contact laws that case files and checkpoints may contain."""


def law_of(tree: Mapping[str, Any]) -> ContactLaw:
    """Return the contact law that `ContactLaw.to_tree` has stored as a dictionary.

    Raises ValueError for an unknown kind of law, and TypeError for wrong parameters.
    """
    parameters = dict(tree)
    kind = parameters.pop("kind")
    for law in LAWS:
        if law.kind == kind:
            return law(**parameters)
    raise ValueError(f"kind of law must be one of {[law.kind for law in LAWS]}, got {kind!r}")
