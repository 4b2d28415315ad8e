# SPDX-License-Identifier: GPL-3.0-or-later
"""Bounds on the values that a load search can reach, checked before the search."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

from .._util.display import quantity
from ..bodies.heterogeneous import Heterogeneous
from ..bodies.layers import Layered
from ..bodies.material import Material
from ..problem.friction import friction_law
from .load_search_cases import PERMANENT_DEFORMATION, YIELD, label_and_unit

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ..bodies.layered import Body
    from ..diagnostics.expected_contact import ExpectedContact
    from ..simulation.simulation import Simulation

_ESTIMATE_MARGIN = 3.0
"""Safety factor on bounds that are estimated from Hertz theory or from the yield stress of
elastic-plastic bodies. Hertz theory is used for gaps that deviate by up to 3 % from a paraboloid.
"""
_UNIT_ERROR_FACTORS = {
    "m": {"µm": 1e-6, "mm": 1e-3, "nm": 1e-9},
    "m²": {"mm²": 1e-6, "µm²": 1e-12},
    "Pa": {"GPa": 1e9, "MPa": 1e6, "kPa": 1e3},
    "": {"%": 1e-2, "x 1e-6": 1e-6},
}
"""For each SI unit, the units that the user may have meant instead, likeliest first, and their
values in the SI unit."""
_DEPTH_QUANTITIES = ("approach", "imprint_depth", PERMANENT_DEFORMATION)


class _Limit(NamedTuple):
    """Upper bound of a quantity, in its SI unit, and a description of the bound."""

    value: float
    of: str


def require_attainable(name: str, target: float, simulation: Simulation, max_load: float) -> None:
    """Raise ValueError if no load up to `max_load` can give the target value.

    The target value is compared with bounds, which follow from Hertz theory for a parabolic gap,
    from the yield stress, and from the size of the grid. A target within the bounds may still turn
    out to be unattainable during the search.

    Parameters
    ----------
    name : str
        Name of the quantity, as returned by `load_search_cases.resolved`.
    target : float
        Target value in SI units.
    simulation : Simulation
        Simulation for the largest load.
    max_load : float
        Largest load [N].
    """
    kind = name.partition(",")[0].partition("_body")[0]
    _, unit = label_and_unit(name)
    largest = _upper_bound(name, simulation, max_load)
    shown = f"value = {target!r} of {name.replace(',', ' or ')}"

    def unit_hint() -> str:
        """Return text that suggests the likeliest unit in which the target would be attainable."""
        for other, factor in _UNIT_ERROR_FACTORS.get(unit, {}).items() if kind != YIELD else ():
            value = factor * target
            if (largest is None or value <= largest.value) and not _reason_too_small(
                kind, value, simulation
            ):
                return (
                    f"; values are in SI units: {target:g} {other} is {value:.6g} {unit}".rstrip()
                )
        return ""

    if largest is not None and target > largest.value:
        raise ValueError(
            f"{shown} cannot be reached: at loads up to {max_load:.6g} N the value is below "
            f"{largest.value:.6g} ({largest.of}){unit_hint()}"
        )
    if reason := _reason_too_small(kind, target, simulation):
        raise ValueError(f"{shown} is too small for the grid: {reason}{unit_hint()}")


def _upper_bound(name: str, simulation: Simulation, max_load: float) -> _Limit | None:
    """Return the upper bound of a quantity for loads up to `max_load` [N], or None if unknown."""
    first = name.partition(",")[0]
    kind, _, number = first.partition("_body")
    both = simulation.body1, simulation.body2
    bodies = [both[int(number) - 1]] if number and first == name else list(both)
    expected = simulation.engine.estimate.hertz(load=max_load)
    found = [
        _strain_bound(kind),
        _strength_bound(kind, bodies),
        _grid_bound(kind, simulation),
        None if expected is None else _hertz_bound(kind, simulation, expected),
    ]
    return min((limit for limit in found if limit is not None), default=None)


def _strain_bound(kind: str) -> _Limit | None:
    if kind != "max_equivalent_plastic_strain":
        return None
    return _Limit(1.0, "far beyond the small-strain limit")


def _strength_bound(kind: str, bodies: Sequence[Body]) -> _Limit | None:
    """Return the yield stress at a plastic strain of 1, an upper bound of the von Mises stress."""
    if kind not in ("max_von_mises", "max_residual_von_mises"):
        return None
    strengths = []
    for body in bodies:
        if isinstance(body, (Layered, Heterogeneous)) or not body.is_plastic:
            return None
        if body.kinematic or body.softening:
            return None
        factor = 1.0 if body.yield_profile is None else max(body.yield_profile[1])
        strengths.append(factor * float(body.yield_stress(1.0)))
    return _Limit(max(strengths), "the yield stress at a plastic strain of 1")


def _grid_bound(kind: str, simulation: Simulation) -> _Limit | None:
    """Return the upper bound that the size of the grid sets, or None without such a bound.

    For a depth, the bound is the width of the grid. For the contact area, the bound is the area of
    the grid, unless the grid can be enlarged.
    """
    grid = simulation.grid
    if kind in _DEPTH_QUANTITIES:
        side = max(grid.nx * grid.dx, grid.ny * grid.dy)
        return _Limit(side, "the width of the grid")
    if kind == "contact_area" and not simulation.engine.setup.surfaces.are_known:
        return _Limit(grid.nx * grid.ny * grid.cell_area, "the area of the grid")
    return None


def _hertz_bound(kind: str, simulation: Simulation, expected: ExpectedContact) -> _Limit | None:
    """Return a bound estimated from the yield stress and from the Hertz contact at maximum load."""
    contact, both = expected.contact, (simulation.body1, simulation.body2)
    bodies = [body for body in both if isinstance(body, Material)]
    if len(bodies) < len(both) or any(body.softening for body in bodies):
        return None
    weakest = min(body.min_yield_stress for body in bodies)
    crushed = contact.load / weakest  # area at a mean pressure equal to the yield stress
    a, b = expected.semi_axes
    radius = math.sqrt(math.prod(simulation.engine.estimate.radii or (math.inf, math.inf)))
    depth = max(contact.approach, crushed / (2 * math.pi * radius))
    is_stressed = any(body.residual_stress is not None for body in bodies)
    sliding = (1 + friction_law(simulation.friction).ratio(contact.p0)) * contact.p0
    largest = {
        **dict.fromkeys(_DEPTH_QUANTITIES, depth),
        "contact_area": max(math.pi * a * b, crushed),
        "max_pressure": contact.p0,
        "max_von_mises": math.inf if is_stressed else sliding,
        YIELD: math.inf if is_stressed else sliding / weakest,
    }.get(kind, math.inf)
    return _Limit(
        _ESTIMATE_MARGIN * largest,
        f"{_ESTIMATE_MARGIN:.0f} times the estimate from Hertz theory and yield stress",
    )


def _reason_too_small(kind: str, target: float, simulation: Simulation) -> str | None:
    """Return why `target` is too small for the grid, as text, or None if it is large enough."""
    grid, estimate = simulation.grid, simulation.engine.estimate
    if kind == "contact_area" and target < grid.cell_area:
        return f"one cell has an area of {quantity(grid.cell_area, 'm²')}"
    radii = estimate.radii
    if kind not in ("max_pressure", "max_von_mises", "approach") or radii is None:
        return None
    if kind == "approach":
        expected = estimate.hertz(approach=target + float(estimate.gap.min()))
    else:
        like = estimate.hertz(load=1.0)
        if like is None:
            return None
        # the pressure of a Hertz contact grows as the cube root of the load
        expected = estimate.hertz(load=(target / like.contact.p0) ** 3)
    if expected is None or 2 * expected.semi_axes[0] >= max(grid.dx, grid.dy):
        return None
    across = quantity(2 * expected.semi_axes[0], "m")
    return f"the Hertz contact would be {across} wide, less than one cell"
