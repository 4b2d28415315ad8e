# SPDX-License-Identifier: GPL-3.0-or-later
"""Hertz estimate of a contact, for checks before and after it is solved."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from .. import hertz
from .._core import ConvergenceError, GridTooSmallError, magnitude_of
from .._util.cached_property import cached_property
from .._util.display import lengths
from ..bodies.layered import materials_of, softest
from ..bodies.layers import Layered
from ..solutions.outline import may_have_steps
from . import plausibility
from .expected_contact import ExpectedContact

if TYPE_CHECKING:
    from .._util.checks import FloatArray
    from ..bodies.layered import Body
    from ..bodies.material import Material
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
_FIT_POINTS_PER_SIDE = 17  # points per side of the grid for the fit of a paraboloid
_WARNING_HINT = ', or set on_border="warn"'


FailedChecks = tuple[plausibility.PlausibilityCheck, ...]


class PlasticBody(NamedTuple):
    """Body number, yield stresses and Young's moduli of an elastic-plastic body."""

    number: int
    weakest: float
    """Minimum initial yield stress [Pa]."""
    yielding: list[tuple[float, float]]
    """Young's modulus [Pa] and minimum yield stress [Pa] of each elastic-plastic material."""


class _Fit(NamedTuple):
    """Points of a grid at which a paraboloid is fitted, and values of its terms at these points."""

    chosen: tuple[Any, ...]
    """Index that selects the points from the cells."""
    half_lengths: tuple[float, float]
    """Largest |x| and |y| of the cell centres [m]."""
    basis: FloatArray
    """Values of the six terms at the points, computed from x and y divided by the half-lengths."""
    fitting: FloatArray
    """Matrix that gives the factors of the terms for heights at the points, by least squares."""


@lru_cache(maxsize=8)
def _fit_on(grid: Grid) -> _Fit:
    """Return the points and terms of fits on a grid, cached for further contacts on this grid."""
    rows, columns = (
        np.linspace(0, n - 1, min(n, _FIT_POINTS_PER_SIDE), dtype=int) for n in grid.surface_shape
    )
    a, b = np.abs(grid.x).max(), np.abs(grid.y).max()
    grids = np.meshgrid(grid.x[rows] / a, grid.y[columns] / b, indexing="ij")
    x, y = (v.ravel() for v in grids)
    basis = np.stack([np.ones_like(x), x, y, 0.5 * x * x, x * y, 0.5 * y * y])
    # Well conditioned in x/a and y/b.
    fitting = np.linalg.solve(basis @ basis.T, basis)
    return _Fit(np.ix_(rows, columns), (a, b), basis, fitting)


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

    def fits(self, expected: ExpectedContact) -> bool:
        """Whether a Hertz contact lies where the gap is close to the paraboloid.

        Also True if the contact is wide relative to its radii of curvature: the unit checks report
        such a contact.
        """
        if all(e <= r for e, r in zip(_extent_of(expected, self), self.reach, strict=True)):
            return True
        long, short = expected.semi_axes
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
        self._lowest = float(gap.min())
        self._known: dict[tuple[float | None, float | None], ExpectedContact | None] = {}
        self._of_heat: tuple[Heat, Any] | None = None

    def prepare(self, heat: Heat) -> None:
        """Compute, before the first increment, all values that do not depend on the load."""
        self._checked(heat)
        for name in ("E_star", "weakest", "may_have_steps", "largest_load_with_room"):
            getattr(self, name)
        self.load_of(approach=0.0)

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

    @cached_property
    def _solids(self) -> tuple[Material, Material]:
        """Material of each body; for a layered body, the most compliant material."""
        return softest(self.bodies[0]), softest(self.bodies[1])

    @property
    def radii(self) -> tuple[float, float] | None:
        """Larger and smaller principal radius [m]; None if the gap is not a convex paraboloid."""
        return None if self._paraboloid is None else self._paraboloid[:2]

    @cached_property
    def _paraboloid(self) -> Paraboloid | None:
        """Paraboloid of the gap; None if the gap is not a convex paraboloid."""
        if min(self.grid.surface_shape) < 3 or self.relieved:
            return None
        chosen, (a, b), basis, fitting = _fit_on(self.grid)
        _, is_finite = magnitude_of(self.gap)
        if not is_finite:  # a body with an end is no paraboloid
            return None
        heights = self.gap[chosen].ravel()
        lowest, highest = float(heights.min()), float(heights.max())
        if not 0 < highest - lowest < math.inf:
            return None
        heights = (heights - lowest) / (highest - lowest)
        found = fitting @ heights
        deviation = float(np.max(np.abs(found @ basis - heights)))
        if not deviation <= MAX_PARABOLOID_DEVIATION:
            return None
        xx, xy, yy = (found[3:] / (a * a, a * b, b * b)).tolist()
        mean, half = 0.5 * (xx + yy), math.hypot(0.5 * (xx - yy), xy)
        flattest, sharpest = mean - half, mean + half
        if not flattest > 1e-9 * sharpest:  # cylinder, saddle or hollow
            return None
        scale = highest - lowest
        sine = math.sin(0.5 * math.atan2(2.0 * xy, xx - yy))  # plane of maximum curvature
        allowed = MAX_EXTENDED_DEVIATION * 0.5 / max(deviation, 1e-30)
        reach = tuple(
            side * math.sqrt(max(allowed * float(part), 1.0))
            for side, part in ((a, found[3]), (b, found[5]))
        )
        return Paraboloid(
            1.0 / (scale * flattest), 1.0 / (scale * sharpest), sine, (reach[0], reach[1])
        )

    @cached_property
    def E_star(self) -> float:
        """Contact modulus [Pa]; for layered bodies, from the most compliant materials."""
        return hertz.effective_modulus(*self._solids)

    @cached_property
    def _is_hertzian(self) -> bool:
        """Whether Hertz theory applies to this gap and these bodies."""
        return self.radii is not None and not any(isinstance(b, Layered) for b in self.bodies)

    def hertz(
        self, load: float | None = None, approach: float | None = None
    ) -> ExpectedContact | None:
        """Hertz contact for a load [N] or an approach [m]; None if Hertz theory does not apply."""
        drive = load, approach
        if drive not in self._known:
            self._known = {drive: self._hertz(load, approach)}  # requested several times
        return self._known[drive]

    def _hertz(self, load: float | None, approach: float | None) -> ExpectedContact | None:
        if approach is not None:
            approach -= self._lowest
        drive = load if approach is None else approach
        if not self._is_hertzian or self.radii is None or drive is None or not 0 < drive < math.inf:
            return None
        radii, E_star = self.radii, self.E_star
        try:
            if math.isclose(*radii, rel_tol=1e-6):
                found = ExpectedContact(hertz.point(radii[0], E_star, load=load, approach=approach))
            else:
                found = ExpectedContact(
                    hertz.elliptic(*radii, E_star, load=load, approach=approach)
                )
        except (ValueError, ArithmeticError):  # floating-point overflow
            return None
        return found if self._paraboloid is not None and self._paraboloid.fits(found) else None

    def warn_of_units(
        self, heat: Heat, target: Mapping[str, Any], *, is_loaded: bool = False, stacklevel: int
    ) -> plausibility.PlausibilityCheck | None:
        """Warn of the first quantity that is probably in a wrong unit; return the failed check.

        Raises ValueError if the Hertz contact is far smaller than a cell, unless the bodies have
        been loaded before or a warning filter ignores `UnitWarning`.
        """
        before, after, (lowest, highest) = self._checked(heat)
        of_contact: list[plausibility.PlausibilityCheck] = []
        if target and self._is_hertzian and not lowest < self.load_of(**target) < highest:
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
        expected = self.hertz(load, approach)
        if expected is None:
            return []
        driver = "approach" if load is None else "load"
        contact = plausibility.ExpectedExtent(
            expected, _extent_of(expected, self._paraboloid), driver
        )
        found = plausibility.contact_plausibility_checks(contact, self.grid, self.bodies, heat)
        return [finding for finding in found if not finding.check.passed]

    def _checked(self, heat: Heat) -> tuple[FailedChecks, FailedChecks, tuple[float, float]]:
        """Return the failed checks of bodies and heat, and the range of plausible loads [N].

        All contact checks pass for loads inside this range.
        """
        if self._of_heat is None or self._of_heat[0] is not heat:
            before, after = plausibility.failed_of_bodies(self.bodies, heat)
            self._of_heat = heat, (before, after, self.passing_loads(heat))
        return self._of_heat[1]

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
    def _reference(self) -> plausibility.ExpectedExtent | None:
        """Hertz contact about a quarter as wide as the grid, from which others are scaled."""
        if not self._is_hertzian or self.radii is None:
            return None
        side = min(self.grid.nx * self.grid.dx, self.grid.ny * self.grid.dy)
        expected = self._hertz(None, self._lowest + (side / 8) ** 2 / self.radii[1])
        if expected is None:
            return None
        return plausibility.ExpectedExtent(expected, _extent_of(expected, self._paraboloid))

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
    expected = setup.hertz(load, approach)
    return (0.0, 0.0) if expected is None else _extent_of(expected, setup._paraboloid)


def _extent_of(expected: ExpectedContact, paraboloid: Paraboloid | None) -> tuple[float, float]:
    """Half-widths along x and y [m] of a contact ellipse in any orientation."""
    if paraboloid is None:
        return 0.0, 0.0
    (a, b), c = expected.semi_axes, paraboloid.cosine
    s = math.sqrt(max(0.0, 1.0 - c * c))
    return math.hypot(a * c, b * s), math.hypot(a * s, b * c)


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
