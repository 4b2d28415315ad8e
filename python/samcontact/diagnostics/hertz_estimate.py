# SPDX-License-Identifier: GPL-3.0-or-later
"""Hertz estimate of a contact, for checks before and after it is solved."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from .. import _core, hertz
from .._core import ConvergenceError, GridTooSmallError
from .._util.cached_property import cached_property
from .._util.display import lengths
from ..bodies.layered import materials_of, plane_compliance, softest
from ..bodies.layers import Layered
from ..solutions.outline import may_have_steps
from . import plausibility
from .expected_contact import ExpectedContact, ExpectedExtent

if TYPE_CHECKING:
    from .._util.checks import FloatArray
    from ..bodies.layered import Body
    from ..heat import Heat
    from ..problem.grid import Grid

MAX_PARABOLOID_DEVIATION = 0.03
"""Maximum deviation of a gap from a paraboloid, divided by the height range of the gap. For a
sphere of radius R on a grid of half-width r, this ratio is (r/R)^2/4."""
MAX_EXTENDED_DEVIATION = 0.1
"""Maximum deviation of a gap from a paraboloid at the ends of the Hertz contact, divided by the
height of the paraboloid there. If these ends lie beyond the grid, the deviation is assumed to grow
like the fourth power of the distance, because a gap may flatten or drop towards the end of a body.
"""
_ROUNDING_MARGIN = 1e-6
"""Relative margin for rounding errors, at both ends of the range of loads that pass all checks."""
_WARNING_HINT = ', or set on_border="warn"'


class PlasticBody(NamedTuple):
    """Body number, yield stresses and Young's moduli of an elastic-plastic body."""

    number: int
    weakest: float
    """Minimum initial yield stress [Pa]."""
    yielding: list[tuple[float, float]]
    """Young's modulus [Pa] and minimum yield stress [Pa] of each elastic-plastic material."""


class Paraboloid(NamedTuple):
    """Convex paraboloid that approximates a gap."""

    larger: float
    """Larger radius [m]."""
    smaller: float
    """Smaller radius [m]."""
    cosine: float
    """Cosine of the angle between x and the plane of the larger radius."""
    reach: tuple[float, float]
    """Distances along x and y [m] within which the gap is close to the paraboloid."""

    def extent_of(self, expected: ExpectedContact) -> tuple[float, float]:
        """Half-widths of a Hertz contact along x and y [m]."""
        (a, b), c = expected.semi_axes, self.cosine
        s = math.sqrt(max(0.0, 1.0 - c * c))
        return math.hypot(a * c, b * s), math.hypot(a * s, b * c)

    def fits(self, contact: ExpectedExtent) -> bool:
        """Whether a Hertz contact lies where the gap is close to the paraboloid.

        Also True if the contact is wide relative to its radii of curvature: the unit checks report
        such a contact.
        """
        if contact.extent[0] <= self.reach[0] and contact.extent[1] <= self.reach[1]:
            return True
        long, short = contact.expected.semi_axes
        limit = plausibility.MAX_HALF_WIDTH_RATIO
        return long > limit * self.larger or short > limit * self.smaller


class ContactSetup:
    """Gap between two bodies, with a Hertz estimate if the gap is a paraboloid.

    relieved: whether a body has a relief (moving topography), or the bodies attract each other. In
    both cases, there is no Hertz estimate.
    """

    def __init__(
        self,
        grid: Grid,
        gap: FloatArray,
        bodies: tuple[Body, Body],
        relieved: bool = False,
    ) -> None:
        self.grid, self.gap, self.bodies = grid, gap, bodies
        # Hertz theory does not include the periodic images
        self.relieved = relieved or bool(grid.periodic)
        self._has_reliefs = relieved
        self._known: dict[tuple[float | None, float | None], ExpectedExtent | None] = {}
        self._body_checks = plausibility.BodyChecks(bodies)
        self._passing: tuple[Heat | None, float, float] = None, math.inf, -math.inf

    def prepare(self, heat: Heat) -> None:
        """Compute, before the first increment, all values that do not depend on the load."""
        self._passing = heat, *self.passing_loads(heat)
        self._body_checks.failed(heat)
        for name in ("E_star", "weakest", "may_have_steps", "largest_load_with_room"):
            getattr(self, name)
        self.load_of(approach=0.0)

    @cached_property
    def _lowest(self) -> float:
        """Minimum gap [m]."""
        return float(self.gap.min())

    @cached_property
    def plastic(self) -> tuple[PlasticBody, ...]:
        """Elastic-plastic bodies."""
        return tuple(
            PlasticBody(
                number,
                body.min_yield_stress,
                [(m.E, m.min_yield_stress) for m in materials_of(body) if m.is_plastic],
            )
            for number, body in enumerate(self.bodies, 1)
            if body.is_plastic
        )

    @cached_property
    def weakest(self) -> float:
        """Minimum initial yield stress of both bodies [Pa]; infinite if both are elastic."""
        return min((body.weakest for body in self.plastic), default=math.inf)

    @cached_property
    def may_have_steps(self) -> bool:
        """Whether the initial gap may have steps; False if the bodies have reliefs."""
        return not self._has_reliefs and may_have_steps(self.gap, self.grid.periodic)

    @property
    def radii(self) -> tuple[float, float] | None:
        """Larger and smaller principal radius [m]; None if the gap is not a convex paraboloid."""
        return None if self._paraboloid is None else self._paraboloid[:2]

    @cached_property
    def _paraboloid(self) -> Paraboloid | None:
        """Paraboloid of the gap; None if the gap is not a convex paraboloid."""
        if self.relieved:
            return None
        limits = MAX_PARABOLOID_DEVIATION, MAX_EXTENDED_DEVIATION
        found = _core.paraboloid_of(self.gap, self.grid._core, *limits)
        return None if found is None else Paraboloid(*found)

    @cached_property
    def E_star(self) -> float:
        """Contact modulus [Pa]; for layered bodies, from the most compliant materials."""
        upper, lower = self.bodies
        return 1.0 / (plane_compliance(softest(upper)) + plane_compliance(softest(lower)))

    @cached_property
    def _is_hertzian(self) -> bool:
        """Whether Hertz theory applies to this gap and these bodies."""
        upper, lower = self.bodies
        layered = isinstance(upper, Layered) or isinstance(lower, Layered)
        return not layered and self._paraboloid is not None

    def hertz(
        self, load: float | None = None, approach: float | None = None
    ) -> ExpectedContact | None:
        """Hertz contact for a load [N] or an approach [m]; None if Hertz theory does not apply."""
        contact = self.expected(load, approach)
        return None if contact is None else contact.expected

    def expected(
        self, load: float | None = None, approach: float | None = None
    ) -> ExpectedExtent | None:
        """Hertz contact as of `hertz`, with its half-widths along x and y."""
        drive = load, approach
        if drive not in self._known:
            self._known = {drive: self._hertz(load, approach)}  # requested several times
        return self._known[drive]

    def _hertz(self, load: float | None, approach: float | None) -> ExpectedExtent | None:
        if approach is not None:
            approach -= self._lowest
        drive = load if approach is None else approach
        shape = self._paraboloid if self._is_hertzian else None
        if shape is None or drive is None or not 0 < drive < math.inf:
            return None
        radii, E_star = shape[:2], self.E_star
        try:
            if math.isclose(*radii, rel_tol=1e-6):
                found = ExpectedContact(hertz.point(radii[0], E_star, load=load, approach=approach))
            else:
                found = ExpectedContact(
                    hertz.elliptic(*radii, E_star, load=load, approach=approach)
                )
        except (ValueError, ArithmeticError):  # floating-point overflow
            return None
        driver = "load" if approach is None else "approach"
        contact = ExpectedExtent(found, shape.extent_of(found), driver)
        return contact if shape.fits(contact) else None

    def warn_of_units(
        self, heat: Heat, target: Mapping[str, Any], *, is_loaded: bool = False, stacklevel: int
    ) -> plausibility.PlausibilityCheck | None:
        """Warn of the first quantity that is probably in a wrong unit; return the failed check.

        Raises ValueError if the Hertz contact is far smaller than a cell, unless the bodies have
        been loaded before or a warning filter ignores `UnitWarning`.
        """
        before, after = self._body_checks.failed(heat)
        of_contact: list[plausibility.PlausibilityCheck] = []
        prepared, lowest, highest = self._passing
        if target and not (prepared is heat and lowest < self.load_of(**target) < highest):
            of_contact = self.failed_checks(heat, **target)
        for finding in (*before, *of_contact, *after):
            if not is_loaded:
                plausibility.require_solvable(finding)
            plausibility.warn_if_implausible(finding, stacklevel=stacklevel + 1)
            return finding
        return None

    def failed_checks(
        self, heat: Heat, load: float | None = None, approach: float | None = None
    ) -> list[plausibility.PlausibilityCheck]:
        """Return the failed plausibility checks of the Hertz contact; [] without Hertz contact."""
        contact = self.expected(load, approach)
        if contact is None:
            return []
        found = plausibility.contact_plausibility_checks(contact, self.grid, self.bodies, heat)
        return [finding for finding in found if not finding.check.passed]

    def passing_loads(self, heat: Heat) -> tuple[float, float]:
        """Return the load range [N] in which all contact checks pass; (inf, -inf) if unknown."""
        if self._reference is None:
            return math.inf, -math.inf
        try:
            found = plausibility.passing_loads(self._reference, self.grid, self.bodies, heat)
        except ArithmeticError:  # floating-point overflow
            return math.inf, -math.inf
        return found[0] * (1 + _ROUNDING_MARGIN), found[1] * (1 - _ROUNDING_MARGIN)

    @cached_property
    def _reference(self) -> ExpectedExtent | None:
        """Hertz contact about a quarter as wide as the grid, from which others are scaled."""
        if not self._is_hertzian or self.radii is None:
            return None
        side = min(self.grid.nx * self.grid.dx, self.grid.ny * self.grid.dy)
        return self._hertz(None, self._lowest + (side / 8) ** 2 / self.radii[1])

    @cached_property
    def _stiffness(self) -> float:
        """Ratio load/approach^1.5 of the Hertz contact [N/m^1.5]; NaN if unknown."""
        if self._reference is None:
            return math.nan
        contact = self._reference.expected.contact
        try:
            return float(contact.load / contact.approach**1.5)
        except ArithmeticError:  # floating-point overflow
            return math.nan

    def load_of(self, load: float | None = None, approach: float | None = None) -> float:
        """Load of the Hertz contact [N] for a load or an approach [m]; NaN if unknown."""
        if approach is None:
            return math.nan if load is None else load
        depth = min(max(approach - self._lowest, 0.0), 1e100)
        return self._stiffness * math.pow(depth, 1.5)

    @cached_property
    def largest_load_with_room(self) -> float:
        """Lower bound [N] of the maximum load at which the Hertz contact fits on the grid."""
        if self._reference is None:
            return math.nan
        share = max(_shares_of_grid(self._reference.expected, self.grid))
        return (
            self._reference.expected.contact.load * (1 - _ROUNDING_MARGIN) / max(share, 1e-30) ** 3
        )

    def require_room(self, load: float | None = None, approach: float | None = None) -> None:
        """Raise GridTooSmallError if the Hertz contact does not fit on the grid.

        The solver would fail for such a contact, which is even larger if it is elastic-plastic.
        """
        if not self._is_hertzian or self.load_of(load, approach) <= self.largest_load_with_room:
            return
        expected, grid = self.hertz(load, approach), self.grid
        if expected is None or max(_shares_of_grid(expected, self.grid)) <= 1:
            return
        where = f"at load {load:.6g} N" if approach is None else f"at approach {approach:.6g} m"
        long, short = expected.semi_axes
        sides = grid.nx * grid.dx, grid.ny * grid.dy
        raise GridTooSmallError(
            f"{where} the contact reaches the edge of the grid ({lengths(*sides)}). "
            f"{expected}: enlarge nx dx and ny dy to at least {lengths(2.5 * long, 2.5 * short)}"
            f"{_WARNING_HINT}"
        )


def extent(
    setup: ContactSetup, load: float | None = None, approach: float | None = None
) -> tuple[float, float]:
    """Half-widths of the Hertz contact along x and y [m]; 0 without Hertz contact."""
    contact = setup.expected(load, approach)
    return (0.0, 0.0) if contact is None else contact.extent


def _shares_of_grid(expected: ExpectedContact, grid: Grid) -> tuple[float, float]:
    """Contact widths divided by grid sides [-], with the longer axis along the longer side."""
    long, short = expected.semi_axes
    sides = grid.nx * grid.dx, grid.ny * grid.dy
    return 2 * short / min(sides), 2 * long / max(sides)


def explain_digits(error: ConvergenceError, gap: FloatArray) -> None:
    """Add a note to a solver error if a large offset of the gap causes cancellation."""
    far = float(np.abs(gap).max())
    height = float(gap.max()) - float(gap.min())
    if 1e-16 * far > 1e-11 * height > 0:
        error.args = (
            f"{error}. The gap has an offset of {far:.6g} m and heights of {height:.3g} m, which "
            "causes cancellation: subtract the minimum from the gap",
        )


def explain_size(error: GridTooSmallError, expected: ExpectedContact | None) -> None:
    """Add the Hertz estimate, if it is not None, to the message of a solver error."""
    if expected is not None and str(expected) not in str(error):
        error.args = (f"{error}. {expected}",)
