# SPDX-License-Identifier: GPL-3.0-or-later
"""Inclusions: spheres and ellipsoids of another material in a body, and voids."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, finite_array, positive, real_array, require_type
from .._util.display import HtmlTable, Rows, lengths, quantity
from .._util.short_text import in_short
from .display import material_in_short
from .material import Material

Vector = tuple[float, float, float]
Axes = tuple[Vector, Vector, Vector]

PARALLEL: Axes = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
"""Principal axes along x, y and z."""
NO_MISFIT = (0.0,) * 6
MAX_MISFIT = 0.1
"""Largest allowed magnitude of a misfit strain, because the theory assumes small strains."""
_AXES_TOLERANCE = 1e-6  # of the scalar products of the axes
_UNUSED_PROPERTIES = ("yield_profile", "residual_stress", "free_faces", "relaxation_terms")


def checked_phase(name: str, material: Any) -> Material | None:
    """Check the material of an inclusion; None stands for a void."""
    if material is None:
        return None
    require_type(name, material, Material)
    for part in _UNUSED_PROPERTIES:
        if getattr(material, part) is not None:
            raise ValueError(
                f"{name} must not have {part}, got {in_short(getattr(material, part))}: this "
                "property is not supported in an inclusion"
            )
    checked: Material = material
    if checked.softening is not None:
        raise ValueError(
            f"{name} must not have a softening law, got {in_short(checked.softening)}: it is not "
            "supported in an inclusion"
        )
    return checked


def checked_misfit(misfit: ArrayLike, material: Material | None) -> tuple[float, ...]:
    """Check a misfit strain, and return its six components."""
    given = real_array("misfit", misfit)
    if given.shape not in ((), (6,)):
        raise ValueError(
            "misfit must be one number or the six components xx, yy, zz, yz, xz, xy, got an array "
            f"of shape {given.shape}"
        )
    values = finite_array("misfit", given)
    six = np.array([1.0, 1, 1, 0, 0, 0]) * values if values.ndim == 0 else values
    if np.abs(six).max() > MAX_MISFIT:
        raise ValueError(
            f"misfit must be at most {MAX_MISFIT:g} in magnitude, got {in_short(misfit)}: it is a "
            "strain, not a percentage"
        )
    if material is None and six.any():
        raise ValueError(f"misfit must be 0 in a void (material = None), got {in_short(misfit)}")
    return tuple(float(value) + 0.0 for value in six)


def _vector(name: str, given: ArrayLike) -> Vector:
    x, y, z = (float(value) + 0.0 for value in finite_array(name, given, (3,)))
    return x, y, z


def _checked_axes(given: ArrayLike | None) -> Axes:
    if given is None:
        return PARALLEL
    rows = finite_array("axes", given, (3, 3))
    if np.abs(rows @ rows.T - np.eye(3)).max() > _AXES_TOLERANCE:
        raise ValueError(
            "axes must be three perpendicular unit vectors, one row for each radius, got "
            f"{rows.tolist()}"
        )
    first, second, third = (_vector("axes", row) for row in rows)
    return first, second, third


@dataclass(frozen=True, repr=False, init=False)
class Inclusion(HtmlTable):
    """Sphere or ellipsoid of another material in a body, or a void.

    Create it with `Inclusion.sphere`, `Inclusion.ellipsoid` or `Inclusion.void`. The inclusion is
    perfectly bonded to the matrix. Model an inclusion that has separated from the matrix as a void
    if the gap stays open.

    Attributes
    ----------
    center : tuple of float
        Coordinates x, y and z of the centre [m] in the frame of the grid, z into the body.
    radii : tuple of float
        Principal radii [m].
    axes : tuple of tuples of float
        Directions of the principal radii, one unit vector for each.
    material : Material or None
        Material of the inclusion; None for a void.
    misfit : tuple of float
        Strain xx, yy, zz, yz, xz, xy [-] that the inclusion would have if it were free.
    """

    center: Vector
    radii: Vector
    axes: Axes
    material: Material | None
    misfit: tuple[float, ...]
    void: ClassVar[VoidShapes]

    def __init__(
        self,
        center: ArrayLike,
        radii: ArrayLike,
        axes: ArrayLike | None,
        material: Material | None,
        misfit: ArrayLike = 0.0,
    ) -> None:
        place = _vector("center", center)
        sizes = _vector("radii", radii)
        for size in sizes:
            positive("radii", size)
        checked_phase("material", material)
        values = (place, sizes, _checked_axes(axes), material, checked_misfit(misfit, material))
        for name, value in zip((f.name for f in fields(self)), values, strict=True):
            object.__setattr__(self, name, value)
        self._require_below_surface()

    def _require_below_surface(self) -> None:
        depth, half = self.center[2], self.extent[2]
        if depth + half <= 0.0:
            raise ValueError(
                f"center must be so deep that the inclusion reaches below the surface, got z = "
                f"{depth!r} m: z is positive into the body"
            )
        if self.is_void and depth - half <= 0.0:
            raise ValueError(
                f"center of a void must be deeper than {half!r} m, got z = {depth!r} m: a void "
                "must not reach the surface; model an open pore as a dent in the gap"
            )

    @classmethod
    def sphere(
        cls, center: ArrayLike, radius: float, material: Material, misfit: ArrayLike = 0.0
    ) -> Inclusion:
        """Spherical inclusion.

        Parameters
        ----------
        center : array_like, shape (3,)
            Coordinates x, y and z of the centre [m] in the frame of the grid, z into the body.
        radius : float
            Radius [m], > 0.
        material : Material
            Elastic or elastic-plastic material. `Material.rigid()` is computed with 1000 times the
            moduli of the matrix.
        misfit : float or array_like, shape (6,), optional
            Strain [-] that the inclusion would have if it were free: a number for an isotropic
            strain, or the components xx, yy, zz, yz, xz, xy. See
            `samcontact.inclusions.thermal_misfit`. Default: 0.

        Returns
        -------
        Inclusion

        Raises
        ------
        ValueError
            A value is outside its range, or the whole inclusion is above the surface.
        TypeError
            An argument is not a number, or the material is not a `Material`.
        """
        require_type("material", material, Material)
        size = positive("radius", radius)
        return cls(center, (size,) * 3, None, material, misfit)

    @classmethod
    def ellipsoid(
        cls,
        center: ArrayLike,
        radii: ArrayLike,
        material: Material,
        misfit: ArrayLike = 0.0,
        axes: ArrayLike | None = None,
    ) -> Inclusion:
        """Ellipsoidal inclusion.

        Parameters
        ----------
        center : array_like, shape (3,)
            Coordinates x, y and z of the centre [m] in the frame of the grid, z into the body.
        radii : array_like, shape (3,)
            Principal radii [m], > 0.
        material, misfit
            As in `sphere`; the components of a misfit refer to x, y and z, not to the principal
            axes.
        axes : array_like, shape (3, 3), optional
            Directions of the principal radii: one unit vector in each row, perpendicular to each
            other. Default: x, y and z.

        Returns
        -------
        Inclusion

        Raises
        ------
        ValueError, TypeError
            As `sphere`, or the axes are not perpendicular unit vectors.
        """
        require_type("material", material, Material)
        return cls(center, radii, axes, material, misfit)

    @property
    def is_void(self) -> bool:
        """Whether the inclusion is a void."""
        return self.material is None

    @property
    def is_sphere(self) -> bool:
        """Whether all radii are equal."""
        return len(set(self.radii)) == 1

    @property
    def volume(self) -> float:
        """Volume [m^3], including any part above the surface."""
        return 4 / 3 * math.pi * math.prod(self.radii)

    @property
    def extent(self) -> Vector:
        """Half of the extent of the inclusion along x, y and z [m]."""
        if self.is_sphere:
            return self.radii
        x, y, z = np.sqrt((np.array(self.radii) ** 2) @ np.array(self.axes) ** 2).tolist()
        return x, y, z

    def metric(self) -> FloatArray:
        """Matrix Q [1/m^2], shape (3, 3): (p - center) Q (p - center) <= 1 for points p inside."""
        rows = np.array(self.axes)
        scaled = rows / np.array(self.radii)[:, None]
        return np.asarray(scaled.T @ scaled)

    def _rows(self) -> Rows:
        size = quantity(self.radii[0], "m") if self.is_sphere else lengths(*self.radii)
        shown = "void" if self.material is None else material_in_short(self.material)
        rows = [
            ("center", ", ".join(quantity(value, "m") for value in self.center)),
            ("radius" if self.is_sphere else "radii", size),
            ("material", shown),
        ]
        if any(self.misfit):
            rows.append(("misfit", ", ".join(f"{value:.4g}" for value in self.misfit)))
        return rows

    def __repr__(self) -> str:
        values = (self.center, self.radii, self.axes, self.material, self.misfit)
        return f"Inclusion({', '.join(map(repr, values))})"


class VoidShapes:
    """Voids: `Inclusion.void.sphere`, `Inclusion.void.ellipsoid`, or ``Inclusion.void(...)``."""

    def __call__(
        self, center: ArrayLike, radius: float | Sequence[float], axes: ArrayLike | None = None
    ) -> Inclusion:
        """Spherical void of one radius [m], or ellipsoidal void of three principal radii [m].

        Raises ValueError if the void reaches the surface.
        """
        if np.ndim(radius) == 0:
            if axes is not None:
                raise ValueError(
                    f"axes must not be given for a sphere, which has one radius, got "
                    f"{in_short(axes)}: omit axes, or give three radii"
                )
            return self.sphere(center, radius)  # type: ignore[arg-type]
        return self.ellipsoid(center, radius, axes)

    def sphere(self, center: ArrayLike, radius: float) -> Inclusion:
        """Spherical void, see `Inclusion.sphere`.

        Raises ValueError if the void reaches the surface.
        """
        return Inclusion(center, (positive("radius", radius),) * 3, None, None)

    def ellipsoid(
        self, center: ArrayLike, radii: ArrayLike, axes: ArrayLike | None = None
    ) -> Inclusion:
        """Ellipsoidal void, see `Inclusion.ellipsoid`.

        Raises ValueError if the void reaches the surface.
        """
        return Inclusion(center, radii, axes, None)

    def __repr__(self) -> str:
        return "Inclusion.void"


Inclusion.void = VoidShapes()
