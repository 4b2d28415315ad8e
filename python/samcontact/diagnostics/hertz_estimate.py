# SPDX-License-Identifier: GPL-3.0-or-later
"""What Hertz expects of a scene, before it is solved and beside what comes out."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import hertz
from .._core import ConvergenceError, GridTooSmallError
from .._util.cached_property import cached_property
from .._util.display import lengths
from ..bodies.layered import Layered, softest
from . import plausibility
from .expected_contact import Expected

if TYPE_CHECKING:
    from .._util.checks import FloatArray
    from ..bodies.layered import Body
    from ..bodies.material import Material
    from ..heat import Heat
    from ..scene.grid import Grid

SMOOTH = 0.03
"""How far a gap may be from a paraboloid, relative to its height: a sphere differs by (r/R)^2/4."""
_POINTS = 17  # a side, to which a paraboloid is fitted
_ASK = ', or ask for a warning with on_border="warn"'


FailedChecks = tuple[plausibility.Doubt, ...]


class ContactSetup:
    """A gap between two bodies, with what Hertz says where the gap is a paraboloid.

    relieved: there is something else between the bodies, and Hertz says nothing.
    """

    def __init__(
        self,
        grid: Grid,
        gap: FloatArray,
        bodies: tuple[Body, Body],
        relieved: bool = False,
    ) -> None:
        self.grid, self.gap, self.bodies = grid, gap, bodies
        # the neighbours of a contact that repeats itself press as well
        self.relieved = relieved or bool(grid.periodic)
        self._known: dict[tuple[float | None, float | None], Expected | None] = {}
        self._of_bodies: tuple[Heat, FailedChecks, FailedChecks] | None = None

    @cached_property
    def _solids(self) -> tuple[Material, Material]:
        """Bodies, or what is most compliant of their layers."""
        return softest(self.bodies[0]), softest(self.bodies[1])

    @property
    def radii(self) -> tuple[float, float] | None:
        """Larger and smaller principal radius [m]; None unless the gap is a convex paraboloid."""
        return None if self._paraboloid is None else self._paraboloid[:2]

    @cached_property
    def _paraboloid(self) -> tuple[float, float, float] | None:
        """Its radii [m], and the cosine of the angle between the larger one's plane and x."""
        shape = self.grid.surface_shape
        if min(shape) < 3 or self.relieved:
            return None
        rows, columns = (np.linspace(0, n - 1, min(n, _POINTS), dtype=int) for n in shape)
        a, b = np.abs(self.grid.x).max(), np.abs(self.grid.y).max()
        grids = np.meshgrid(self.grid.x[rows] / a, self.grid.y[columns] / b, indexing="ij")
        x, y = (v.ravel() for v in grids)
        heights = self.gap[np.ix_(rows, columns)].ravel()
        if np.isinf(self.gap).any():  # a body that ends is no paraboloid
            return None
        lowest, highest = float(heights.min()), float(heights.max())
        if not 0 < highest - lowest < math.inf:
            return None
        heights = (heights - lowest) / (highest - lowest)
        basis = np.stack([np.ones_like(x), x, y, 0.5 * x * x, x * y, 0.5 * y * y])
        found = np.linalg.solve(basis @ basis.T, basis @ heights)  # well conditioned in x/a, y/b
        if not np.max(np.abs(found @ basis - heights)) <= SMOOTH:
            return None
        xx, xy, yy = (found[3:] / (a * a, a * b, b * b)).tolist()
        mean, half = 0.5 * (xx + yy), math.hypot(0.5 * (xx - yy), xy)
        least, most = mean - half, mean + half
        if not least > 1e-9 * most:  # a cylinder, a saddle, a hollow
            return None
        scale = highest - lowest
        turn = math.sin(0.5 * math.atan2(2.0 * xy, xx - yy))  # of the most curved plane
        return 1.0 / (scale * least), 1.0 / (scale * most), turn

    def extent(
        self, load: float | None = None, approach: float | None = None
    ) -> tuple[float, float]:
        """How far the Hertz contact reaches from its middle along x and y [m]; 0 without one."""
        expected = self.hertz(load, approach)
        if expected is None or self._paraboloid is None:
            return 0.0, 0.0
        (a, b), c = expected.semi_axes, self._paraboloid[2]
        s = math.sqrt(max(0.0, 1.0 - c * c))
        return math.hypot(a * c, b * s), math.hypot(a * s, b * c)

    @cached_property
    def _E_star(self) -> float:
        return hertz.effective_modulus(*self._solids)

    def hertz(self, load: float | None = None, approach: float | None = None) -> Expected | None:
        """Hertz contact under a load [N] or an approach [m]; None where there is none."""
        drive = load, approach
        if drive not in self._known:
            self._known = {drive: self._hertz(load, approach)}  # the same is asked several times
        return self._known[drive]

    def _hertz(self, load: float | None, approach: float | None) -> Expected | None:
        if approach is not None:
            approach -= float(self.gap.min())
        drive = load if approach is None else approach
        if drive is None or not 0 < drive < math.inf or self.radii is None:
            return None
        if any(isinstance(body, Layered) for body in self.bodies):
            return None
        try:
            if math.isclose(*self.radii, rel_tol=1e-6):
                found = hertz.point(self.radii[0], self._E_star, load=load, approach=approach)
                return Expected(found)
            return Expected(hertz.elliptic(*self.radii, self._E_star, load=load, approach=approach))
        except (ValueError, ArithmeticError):  # beyond the range of numbers
            return None

    def doubted(
        self, heat: Heat, target: Mapping[str, Any], *, stacklevel: int
    ) -> plausibility.Doubt | None:
        """Warn of the first quantity that is probably in a wrong unit, and return its check."""
        if self._of_bodies is None or self._of_bodies[0] is not heat:
            self._of_bodies = heat, *plausibility.failed_of_bodies(self.bodies, heat)
        _, before, after = self._of_bodies
        expected = self.hertz(**target)
        of_contact: list[plausibility.Doubt] = []
        if expected is not None:
            driver = "approach" if target.get("load") is None else "load"
            contact = plausibility.Contact(expected, self.extent(**target), driver)
            found = plausibility.doubts_of_contact(contact, self.grid, self.bodies, heat)
            of_contact = [doubt for doubt in found if not doubt.verdict.passed]
        for doubt in (*before, *of_contact, *after):
            plausibility.warn_of(doubt, stacklevel=stacklevel + 1)
            return doubt
        return None

    def require_room(self, load: float | None = None, approach: float | None = None) -> None:
        """Raise GridTooSmallError when the Hertz contact does not fit.

        Before a solve that would end so after a while: the contact of bodies that yield is not
        smaller than that of elastic ones.
        """
        expected, grid = self.hertz(load, approach), self.grid
        if expected is None:
            return
        where = f"at load {load:.6g} N" if approach is None else f"at approach {approach:.6g} m"
        long, short = expected.semi_axes
        sides = grid.nx * grid.dx, grid.ny * grid.dy
        # an elliptic contact may lie any way round
        if 2 * short > min(sides) or 2 * long > max(sides):
            raise GridTooSmallError(
                f"{where} the contact touches the border of the grid ({lengths(*sides)}). "
                f"{expected}: enlarge nx dx and ny dy to {lengths(2.5 * long, 2.5 * short)} or more"
                f"{_ASK}"
            )

    @contextmanager
    def beside(self, load: float | None = None, approach: float | None = None) -> Iterator[None]:
        """What Hertz expects, added to a GridTooSmallError; a gap that lies far away."""
        try:
            yield
        except ConvergenceError as error:
            far, height = (
                float(np.abs(self.gap).max()),
                float(self.gap.max()) - float(self.gap.min()),
            )
            if not 1e-16 * far > 1e-11 * height > 0:
                raise
            error.args = (
                f"{error}. The gap lies {far:.6g} m away with heights of {height:.3g} m, which "
                "costs their digits: subtract its minimum",
            )
            raise
        except GridTooSmallError as error:
            expected = self.hertz(load, approach)
            if expected is None or str(expected) in str(error):
                raise
            error.args = (f"{error}. {expected}",)
            raise
