# SPDX-License-Identifier: GPL-3.0-or-later
"""Plausibility checks for unit errors in bodies, grids and loads."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Iterable, Iterator
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

from .._util.check import Check
from .._util.display import quantity
from .._util.errors import UnitWarning, is_ignored
from ..bodies.layered import materials_of, matrix_of, softest
from ..bodies.layers import Layered

if TYPE_CHECKING:
    from ..bodies.depth_profiles import Profile
    from ..bodies.layered import Body
    from ..bodies.material import Material
    from ..heat import Heat
    from ..problem.grid import Grid
    from .expected_contact import ExpectedExtent

MAX_HALF_WIDTH_RATIO = 0.55
"""Maximum ratio of contact half-width to radius of curvature. At this ratio, a sphere is 15 %
stiffer than a paraboloid."""
MAX_GRID_WIDTHS, MIN_CELLS_ACROSS, MAX_LAYERS = 4.0, 2.0, 1e3
"""Limits of the Hertz contact: maximum width relative to a side of the grid, minimum width in
cells, maximum half-width relative to the depth dz of a layer of cells."""
MIN_SOLVABLE_CELLS = 1e-3
"""Minimum width of a Hertz contact in cells; a narrower contact is a single cell at any load."""
MIN_YIELD_STRAIN = 1e-6
"""Minimum ratio of yield stress to E; pure single crystals have 4e-6."""
MAX_YIELD_STRAIN = 0.2
"""Maximum ratio of yield stress to E; no atomic bond is stronger."""
MAX_YIELD_FACTOR = 20.0
"""Maximum ratio of local to nominal yield stress: case hardening gives 2 to 3."""
MAX_PROFILE_DEPTH = 0.1
"""Maximum depth of hardening, residual stress or layers [m]; mill rolls are hardened to 0.1 m."""
MIN_STRESS_RATIO = 1e-7
"""Minimum ratio of residual stress, or of backstress modulus, to E. For steel, this is 0.02 MPa."""
MAX_BACKSTRESS_MODULUS_RATIO = 1e4
"""Maximum ratio of backstress modulus to E. The modulus is E Et/(E - Et) for a tangent modulus Et,
and becomes large for Et near E."""
MAX_SPEED = 1e3
"""Maximum speed of a surface through a contact [m/s]: no bearing reaches 300 m/s."""
MAX_WEAR_COEFFICIENT = 1e-9
"""Maximum wear volume per work, or per load and distance [1/Pa], as of rubber on abrasive paper."""
MIN_STRESS_LIMIT = 1e4
"""Minimum fatigue limit or yield stress of a solid [Pa]: gels have about 1e4."""
HEAT_CAPACITY_RANGE = 1e5, 1e7
"""Range of the volumetric heat capacity [J/(m^3 K)]: solids without pores have 1e6 to 4e6."""
MAX_EXPANSION = 2e-3
"""Maximum thermal expansion [1/K]: rubber has up to 7e-4."""
MAX_TEMPERATURE_RISE = 3e5
"""Maximum temperature rise [K]: above all melting points, because melting is not modelled."""
_THERMAL_UNITS = "W/(m K) for conductivity and m^2/s for diffusivity"
_MIN_CELLS_AFTER_CORRECTION = 6.0  # minimum width in cells after correction of a unit
_MAX_CONTACT_MODULUS = 2e12  # E* of two diamonds is 0.6e12
_CELLS_ACROSS = "width of the Hertz contact in cells"
_UNIT_ERROR_FACTORS = {"m": (1e-3, 1e-6, 1e-9), "N": (1e-3, 1e-6, 1e-9), "Pa": (1e3, 1e6, 1e9)}


class PlausibilityCheck(NamedTuple):
    """Plausibility check of a quantity, with the remedy for a failed check."""

    check: Check
    remedy: Callable[[], str]
    """Function that returns the remedy as text; it is called only if a warning is issued."""
    of_contact: bool = False
    """Whether a Hertz contact is checked. If this check fails, later checks of the solution are
    skipped."""


FailedChecks = tuple[PlausibilityCheck, ...]


def plausibility_checks(
    contact: ExpectedExtent | None, grid: Grid, bodies: tuple[Body, Body], heat: Heat
) -> Iterator[PlausibilityCheck]:
    """Iterate over all plausibility checks before a solution; `grid` is the initial grid."""
    yield from _body_and_heat_checks(bodies, heat)
    if contact is not None:
        yield from contact_plausibility_checks(contact, grid, bodies, heat)
    yield from _failed_strength_checks(bodies)


class BodyChecks:
    """Failed checks of two bodies and their heat, which are kept until the heat changes."""

    def __init__(self, bodies: tuple[Body, Body]) -> None:
        self._bodies = bodies
        self._of_heat: tuple[Heat, tuple[FailedChecks, FailedChecks]] | None = None

    def failed(self, heat: Heat) -> tuple[FailedChecks, FailedChecks]:
        """Return the failed checks that are reported before, and after, the contact checks."""
        if self._of_heat is None or self._of_heat[0] is not heat:
            before = tuple(_failed(_body_and_heat_checks(self._bodies, heat)))
            self._of_heat = heat, (before, tuple(_failed_strength_checks(self._bodies)))
        return self._of_heat[1]


def _body_and_heat_checks(bodies: tuple[Body, Body], heat: Heat) -> Iterator[PlausibilityCheck]:
    for number, whole in enumerate(bodies, 1):
        body = softest(whole)
        if body.is_plastic:
            name, ratio = f"yield stress / E of body {number}", body.min_yield_stress / body.E
            check = Check(name, ratio, MIN_YIELD_STRAIN, at_least=True)
            yield PlausibilityCheck(check, lambda: "Use Pa for both")
        yield from _failed(_body_checks(f"body {number}", whole))
    for number, materials in _heated(bodies, heat):
        for material in materials:
            yield from _thermal_checks(number, material)
        speed = math.hypot(*heat.velocity[number - 1])
        check = Check(f"heat.velocity of body {number}", speed, MAX_SPEED, unit="m/s")
        yield from _failed([PlausibilityCheck(check, lambda: "Use m/s")])


def _failed_strength_checks(bodies: tuple[Body, Body]) -> Iterator[PlausibilityCheck]:
    """Iterate over failed checks of the yield stress, which are reported after contact checks."""
    for number, whole in enumerate(bodies, 1):
        if whole.is_plastic:
            plastic = [material for material in materials_of(whole) if material.is_plastic]
            yield from _failed(_strength_check(number, material) for material in plastic)


def contact_plausibility_checks(
    contact: ExpectedExtent, grid: Grid, bodies: tuple[Body, Body], heat: Heat
) -> list[PlausibilityCheck]:
    """Return the checks of the size of a Hertz contact and of the temperature rise."""
    checks = _contact_checks(contact, grid, (softest(bodies[0]), softest(bodies[1])))
    for number, materials in _heated(bodies, heat):
        # The lowest estimate of the temperature is that of the best conductor.
        body = max(materials, key=lambda material: (material.thermal or (0.0,))[0])
        checks.append(_temperature_check(contact, number, heat.factor[number - 1], body, heat))
    return checks


def passing_loads(
    contact: ExpectedExtent, grid: Grid, bodies: tuple[Body, Body], heat: Heat
) -> tuple[float, float]:
    """Return the minimum and maximum load [N] for which all checks of a contact pass.

    Both limits are scaled from the load of `contact`. Contact size and pressure grow as the cube
    root of the load. Two quantities grow faster: the temperature rise, at most like the power 2/3
    of the load, and the size of plastically flattened contacts, at most like the power 1/2.
    """
    load = contact.expected.contact.load
    checks = [finding.check for finding in contact_plausibility_checks(contact, grid, bodies, heat)]
    checks += [finding.check for finding in _layer_check(contact, grid, map(softest, bodies))]
    lower, upper = 0.0, math.inf
    for check in checks:
        share = max(check.value, 1e-30 * check.limit) / check.limit
        if check.at_least:
            lower = max(lower, load * share ** (-2.0 if share > 1 else -3.0))
        else:
            upper = min(upper, load * share ** (-1.5 if share < 1 else -3.0))
    return lower, upper


def _heated(bodies: tuple[Body, Body], heat: Heat) -> list[tuple[int, list[Material]]]:
    """Return the numbers and materials of the heated bodies."""
    if not any(heat.shares):
        return []
    return [
        (number, materials_of(body))
        for number, (body, share) in enumerate(zip(bodies, heat.shares, strict=True), 1)
        if share > 0 and body.thermal is not None
    ]


def _failed(findings: Iterable[PlausibilityCheck]) -> Iterator[PlausibilityCheck]:
    """Iterate over the failed checks."""
    return (finding for finding in findings if not finding.check.passed)


def warn_if_implausible(finding: PlausibilityCheck, *, stacklevel: int) -> None:
    """Issue a `UnitWarning` if a check has failed."""
    check = finding.check
    if not check.passed:
        text = f"likely unit error: {check.name} is {check.shown} ({check.condition} expected)"
        warnings.warn(f"{text}. {finding.remedy()}", UnitWarning, stacklevel=stacklevel + 1)


def require_solvable(finding: PlausibilityCheck) -> None:
    """Raise ValueError for a contact much narrower than a cell, unless UnitWarning is ignored."""
    check = finding.check
    too_small = check.name == _CELLS_ACROSS and check.value < MIN_SOLVABLE_CELLS
    if too_small and not is_ignored(UnitWarning):
        raise ValueError(
            f"{check.name} must be at least {MIN_SOLVABLE_CELLS:g}, got {check.value:.4g}: "
            f"{finding.remedy()}. To solve this contact anyway, switch this check off with "
            "warnings.simplefilter('ignore', samcontact.UnitWarning)"
        )


def wear_coefficient(name: str, value: float) -> PlausibilityCheck:
    """Check of a wear coefficient [1/Pa]: wear volume per work, or per load and distance."""
    check = Check(name, value, MAX_WEAR_COEFFICIENT, unit="1/Pa")
    return PlausibilityCheck(check, lambda: "Use 1/Pa, m³ per joule: 1e-6 mm³/(N m) is 1e-15 1/Pa")


def strength(name: str, value: float) -> PlausibilityCheck:
    """Check of a fatigue limit [Pa], or of a yield stress [Pa] that is not part of a material."""
    check = Check(name, value, MIN_STRESS_LIMIT, at_least=True, unit="Pa")
    return PlausibilityCheck(check, lambda: "Use Pa: 300 MPa is 300e6")


def _body_checks(name: str, body: Body) -> Iterator[PlausibilityCheck]:
    body = matrix_of(body)
    if isinstance(body, Layered):
        return _layer_checks(name, body)
    return _material_checks(name, body)


def _layer_checks(name: str, body: Layered) -> Iterator[PlausibilityCheck]:
    for place, (material, thickness) in enumerate(body.layers):
        layer = f"layers[{place}] of {name}"
        check = Check(f"thickness of {layer}", thickness, MAX_PROFILE_DEPTH, unit="m")
        yield PlausibilityCheck(check, lambda: "Use m")
        yield from _material_checks(layer, material)
    yield from _material_checks(f"the substrate of {name}", body.substrate)


def _material_checks(name: str, body: Material) -> Iterator[PlausibilityCheck]:
    for modulus, _ in body.kinematic:
        label = f"modulus of kinematic hardening / E of {name}"
        for limit, at_least in ((MIN_STRESS_RATIO, True), (MAX_BACKSTRESS_MODULUS_RATIO, False)):
            check = Check(label, modulus / body.E, limit, at_least)
            yield PlausibilityCheck(check, lambda: "Use Pa for both")
    if body.yield_profile is not None:
        max_factor = max(body.yield_profile[1])
        check = Check(f"maximum yield factor of {name}", max_factor, MAX_YIELD_FACTOR)
        yield PlausibilityCheck(
            check, lambda: "The yield factor is the ratio of local hardness to core hardness"
        )
        yield _depth_check(f"depth of the yield profile of {name}", body.yield_profile)
    if body.residual_stress is not None:
        largest = max(abs(v) for values in body.residual_stress[1:] for v in values)
        if largest > 0:
            label = f"maximum residual stress / E of {name}"
            check = Check(label, largest / body.E, MIN_STRESS_RATIO, at_least=True)
            yield PlausibilityCheck(check, lambda: "Use Pa for both: -800 MPa is -800e6")
        yield _depth_check(f"depth of the residual stress of {name}", body.residual_stress)


def _strength_check(number: int, body: Material) -> PlausibilityCheck:
    """Check of the ratio of maximum yield stress to E, without the factors of a yield profile."""
    given = body.parameters
    of_law = float(body.yield_stress(0.0)), given.get("saturation_stress", 0.0)
    largest = max(*of_law, *given.get("stress", ()))
    name = f"maximum yield stress / E of body {number}"
    check = Check(name, largest / body.E, MAX_YIELD_STRAIN)
    return PlausibilityCheck(check, lambda: "Use Pa for both: 210 GPa is 210e9")


def _depth_check(name: str, profile: Profile) -> PlausibilityCheck:
    """Check of the depth [m] below which a yield or stress profile is constant."""
    z = profile[0]
    deepest = 0.0
    for above, below in pairwise(range(len(z))):
        if any(values[above] != values[below] for values in profile[1:]):
            deepest = z[below]
    return PlausibilityCheck(Check(name, deepest, MAX_PROFILE_DEPTH, unit="m"), lambda: "Use m")


def _thermal_checks(number: int, body: Material) -> Iterator[PlausibilityCheck]:
    conductivity, expansion, diffusivity = body.thermal or (1.0, 0.0, 1.0)
    name = f"volumetric heat capacity (conductivity over diffusivity) of body {number}"
    for limit, at_least in zip(HEAT_CAPACITY_RANGE, (True, False), strict=True):
        check = Check(name, conductivity / diffusivity, limit, at_least, "J/(m³ K)")
        yield PlausibilityCheck(check, lambda: f"Solids have 1e6 to 4e6: use {_THERMAL_UNITS}")
    check = Check(f"thermal expansion of body {number}", expansion, MAX_EXPANSION, unit="1/K")
    yield PlausibilityCheck(check, lambda: "Steel has 1.2e-5 1/K")


def _temperature_check(
    contact: ExpectedExtent, number: int, factor: float, body: Material, heat: Heat
) -> PlausibilityCheck:
    """Check of the temperature rise [K], estimated as flux/conductivity times a length."""
    conductivity, _, diffusivity = body.thermal or (1.0, 0.0, 1.0)
    size = math.sqrt(math.prod(contact.expected.semi_axes))
    age = heat.time if heat.history is None else heat.history[1]
    if age is not None:
        size = min(size, math.sqrt(diffusivity * age))
    if (speed := math.hypot(*heat.velocity[number - 1])) > 0:
        size = min(size, math.sqrt(diffusivity * size / speed))
    rise = factor * contact.expected.contact.p0 * size / conductivity
    name = f"estimated frictional temperature rise of body {number}"
    check = Check(name, rise, MAX_TEMPERATURE_RISE, unit="K")
    return PlausibilityCheck(check, lambda: f"Use m/s for heat.factor, {_THERMAL_UNITS}")


def part_of_radius(
    contact: ExpectedExtent, remedy: Callable[[], str] | None = None
) -> PlausibilityCheck:
    """Check of the ratio of half-width to radius of curvature of a Hertz contact.

    remedy: function that returns the first sentence of the remedy. By default, this sentence is the
    text of the Hertz estimate.
    """
    first = remedy or (lambda: str(contact.expected))
    name = "half-width of the Hertz contact / radius of curvature"
    check = Check(name, contact.part_of_radius, MAX_HALF_WIDTH_RATIO)
    taken = "The theory assumes half-spaces, and paraboloids in place of spheres"
    return PlausibilityCheck(check, lambda: f"{first()}. {taken}", True)


def _contact_checks(
    contact: ExpectedExtent, grid: Grid, bodies: tuple[Material, Material]
) -> list[PlausibilityCheck]:
    expected, (along_x, along_y) = contact.expected, contact.extent

    def remedy() -> str:
        return f"{expected}. {likely_unit_errors(contact, grid)}"

    windows = max(2 * along_x / (grid.nx * grid.dx), 2 * along_y / (grid.ny * grid.dy))
    name = "width of the Hertz contact relative to the grid"
    width = Check(name, windows, MAX_GRID_WIDTHS)
    cells = _flattened(contact, bodies) * min(2 * along_x / grid.dx, 2 * along_y / grid.dy)
    across = Check(_CELLS_ACROSS, cells, MIN_CELLS_ACROSS, at_least=True)
    sizes = [PlausibilityCheck(width, remedy, True), PlausibilityCheck(across, remedy, True)]
    checks = [part_of_radius(contact, remedy), *sizes]
    plastic = [body for body in bodies if body.is_plastic]
    if plastic and expected.contact.p0 > min(body.min_yield_stress for body in plastic):
        checks += _layer_check(contact, grid, bodies)
    return checks


def _layer_check(
    contact: ExpectedExtent, grid: Grid, bodies: Iterable[Material]
) -> Iterator[PlausibilityCheck]:
    """Check of the half-width of the Hertz contact, divided by the depth dz of a layer of cells."""
    dz = grid.dz
    if dz is not None:
        name = "half-width of the Hertz contact in layers"
        half = _flattened(contact, bodies) * contact.expected.semi_axes[1]
        check = Check(name, half / dz, MAX_LAYERS)
        yield PlausibilityCheck(check, lambda: f"Use m: dz = {quantity(dz, 'm')}")


def _flattened(contact: ExpectedExtent, bodies: Iterable[Material]) -> float:
    """Ratio of contact width at a mean pressure of 3 yield stresses to the elastic width; >= 1."""
    plastic = [3.0 * body.min_yield_stress for body in bodies if body.is_plastic]
    mean = contact.expected.contact.p0 / 1.5
    if not plastic or not math.isfinite(mean):
        return 1.0
    return math.sqrt(max(1.0, mean / min(plastic)))


def likely_unit_errors(contact: ExpectedExtent, grid: Grid) -> str:
    """Describe which quantity, in another unit, would make the contact fit the grid."""
    hertz, by_approach = contact.expected.contact, contact.driver == "approach"
    # value, unit, and exponents: a factor on the value scales contact width, radius and cell size
    given = {
        "E* =": (hertz.E_star, "Pa", 0.0 if by_approach else -1 / 3, 0.0, 0.0),
        "radii of": (contact.radii[0], "m", 0.5 if by_approach else 1 / 3, 1.0, 0.0),
        "cells of": (max(grid.dx, grid.dy), "m", 0.0, 0.0, 1.0),
        "a load of": (hertz.load, "N", 0.0 if by_approach else 1 / 3, 0.0, 0.0),
        "an approach of": (hertz.approach, "m", 0.5 if by_approach else 0.0, 0.0, 0.0),
    }
    fits, unusual = [], []
    for name, (value, unit, *powers) in given.items():
        for factor in _UNIT_ERROR_FACTORS[unit] if any(powers) else ():
            wider, larger, coarser = (factor**power for power in powers)
            if factor * value < _MAX_CONTACT_MODULUS and _fits(
                contact, grid, wider, wider / larger, coarser
            ):
                fits.append(f"{name} {quantity(factor * value, unit)}")
                unusual += fits[-1:] if _is_unusual(name, value) else []
                break
    text = ", or ".join(unusual or fits)
    if not text:
        return "Use m, N and Pa"
    return f"The contact would be plausible with {text}: use m, N and Pa"


def _is_unusual(name: str, value: float) -> bool:
    if name.startswith("E*"):
        return value < 1e6
    return value > {"radii of": 1.0, "cells of": 1e-3, "a load of": 1e6}.get(name, math.inf)


def _fits(contact: ExpectedExtent, grid: Grid, wider: float, steeper: float, cells: float) -> bool:
    """Whether a contact would fit the grid if its size and the cell size were scaled.

    wider, steeper, cells: factors on the contact width, on the ratio of width to radius, and on
    the cell size.
    """
    sides = zip(contact.extent, (grid.nx, grid.ny), (grid.dx, grid.dy), strict=True)
    across = [(2 * wider * e / (cells * d), n) for e, n, d in sides]
    inside = all(_MIN_CELLS_AFTER_CORRECTION <= share <= MAX_GRID_WIDTHS * n for share, n in across)
    return inside and steeper * contact.part_of_radius <= MAX_HALF_WIDTH_RATIO
