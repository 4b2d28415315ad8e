# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed forms: sphere in an infinite body under uniform stress; misfit sphere in a half-space."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from .._util.cached_property import cached_property
from .._util.checks import FloatArray, finite_array, number, positive, require_type, together
from .._util.display import HtmlTable, Rows, quantity
from .._util.tensors import von_mises
from ..bodies.inclusion import checked_misfit
from ..bodies.material import Material
from ..bodies.phase_mixing import relative_phase
from .tensors import as_matrix, as_six, deviator, fibonacci_directions, mean, stress_of

MAX_DIRECTIONS = 20_000  # at which the largest stress of the interface is sought


def thermal_misfit(inclusion: Material, matrix: Material, temperature_change: float) -> float:
    """Misfit strain of an inclusion due to a uniform temperature change [-].

    Parameters
    ----------
    inclusion, matrix : Material
        Materials with thermal constants, see `Material.with_thermal`.
    temperature_change : float
        Present temperature minus the stress-free temperature [K].

    Returns
    -------
    float
        Expansion coefficient of the inclusion minus that of the matrix, times the temperature
        change.

    Raises
    ------
    ValueError
        A material has no thermal constants.
    TypeError
        An argument is not a material or not a number.
    """
    change = float(finite_array("temperature_change", temperature_change, ()))
    expansion = []
    for name, material in (("inclusion", inclusion), ("matrix", matrix)):
        require_type(name, material, Material)
        if material.thermal is None:
            raise ValueError(
                f"{name} must have thermal constants, got {material!r}: use Material.with_thermal"
            )
        expansion.append(material.thermal[1])
    return (expansion[0] - expansion[1]) * change


@dataclass(frozen=True, repr=False, eq=False)
class EshelbySphere(HtmlTable):
    """Spherical inclusion or void in an infinite body under uniform stress; see `eshelby_sphere`.

    Attributes
    ----------
    matrix : Material
        Material of the infinite body.
    remote_stress : ndarray, shape (6,)
        Stress far from the sphere [Pa].
    eigenstrain : ndarray, shape (6,)
        Equivalent uniform eigenstrain of the sphere [-]: in a homogeneous body it has the same
        effect as the sphere.
    radius : float
        Radius [m].
    """

    matrix: Material
    remote_stress: FloatArray
    eigenstrain: FloatArray
    radius: float

    @cached_property
    def interior_stress(self) -> FloatArray:
        """Uniform stress in the sphere [Pa], shape (6,)."""
        bulk, shear = eshelby_factors(self.matrix.nu)
        e = self.eigenstrain
        strain = (bulk - 1) * mean(e) + (shear - 1) * deviator(e)
        return np.asarray(self.remote_stress + stress_of(strain, self.matrix.E, self.matrix.nu))

    def stress(self, x: ArrayLike, y: ArrayLike, z: ArrayLike) -> FloatArray:
        """Stress at points [Pa], shape (6, ...); coordinates from the centre of the sphere [m].

        At points on the interface, the stress is that of the matrix. Ju and Sun (1999),
        doi:10.1115/1.2791090.
        """
        points = np.stack(together(x=x, y=y, z=z))
        distance = np.linalg.norm(points, axis=0)
        inside = distance < self.radius * (1 - 1e-12)
        at = np.where(inside, self.radius, np.maximum(distance, self.radius))
        normal = points / np.where(distance > 0.0, distance, 1.0)
        strain = exterior_strain(self.eigenstrain, normal, self.radius / at, self.matrix.nu)
        outside = stress_of(strain, self.matrix.E, self.matrix.nu)
        expand = (slice(None), *([None] * inside.ndim))
        total = self.remote_stress[expand] + outside
        return np.where(inside, self.interior_stress[expand], total)

    @cached_property
    def max_von_mises(self) -> float:
        """Maximum von Mises stress of the matrix at the interface [Pa]."""
        directions = self.radius * fibonacci_directions(MAX_DIRECTIONS)
        return float(von_mises(self.stress(*directions)).max())

    @property
    def concentration(self) -> float:
        """Maximum von Mises stress of the matrix, divided by the value far from the sphere [-].

        Infinite if the von Mises stress far from the sphere is 0.
        """
        remote = float(von_mises(self.remote_stress))
        return self.max_von_mises / remote if remote > 0.0 else float("inf")

    def _rows(self) -> Rows:
        return [
            ("radius", quantity(self.radius, "m")),
            ("von Mises stress inside", quantity(float(von_mises(self.interior_stress)), "Pa")),
            ("maximum von Mises stress of the matrix", quantity(self.max_von_mises, "Pa")),
        ]

    def __repr__(self) -> str:
        return f"EshelbySphere(radius={self.radius!r}, eigenstrain={self.eigenstrain.tolist()})"


def eshelby_factors(nu: float) -> tuple[float, float]:
    """Factors by which Eshelby's tensor of a sphere scales the mean and deviator of a strain."""
    return (1 + nu) / (3 * (1 - nu)), 2 * (4 - 5 * nu) / (15 * (1 - nu))


def eshelby_sphere(
    matrix: Material,
    material: Material | None,
    stress: ArrayLike,
    misfit: ArrayLike = 0.0,
    radius: float = 1.0,
) -> EshelbySphere:
    """Spherical inclusion or void in an infinite elastic body under uniform stress.

    Eshelby (1957), doi:10.1098/rspa.1957.0133; void: Goodier (1933).

    Parameters
    ----------
    matrix : Material
        Material of the body.
    material : Material or None
        Material of the sphere; None for a void. Only the elastic constants are used.
    stress : array_like, shape (6,)
        Stress far from the sphere [Pa], with the components xx, yy, zz, yz, xz, xy.
    misfit : float or array_like, shape (6,), optional
        Misfit strain, see `Inclusion.sphere`. Default: 0.
    radius : float, optional
        Radius [m]. Default: 1.

    Returns
    -------
    EshelbySphere

    Raises
    ------
    ValueError
        The matrix is rigid, or a value is outside its range.
    TypeError
        An argument is not a material or not a number.
    """
    require_type("matrix", matrix, Material)
    if matrix.is_rigid:
        raise ValueError("matrix must not be rigid: it must deform around the sphere")
    if material is not None:
        require_type("material", material, Material)
    remote = finite_array("stress", stress, (6,))
    size = positive("radius", radius)
    phase = relative_phase(matrix, material, checked_misfit(misfit, material))
    own = np.array(phase.misfit)
    bulk, shear = matrix.E / (1 - 2 * matrix.nu), matrix.E / (1 + matrix.nu)
    factors = eshelby_factors(matrix.nu)
    e = _equivalent(mean(remote) / bulk, mean(own), phase.bulk, factors[0])
    e = e + _equivalent(deviator(remote) / shear, deviator(own), phase.shear, factors[1])
    return EshelbySphere(matrix, remote, e, size)


def _equivalent(strain: FloatArray, misfit: FloatArray, ratio: float, factor: float) -> FloatArray:
    """Mean or deviator x of the equivalent eigenstrain.

    It solves ratio (e + S x - misfit) = e + S x - x, where e is the remote strain (`strain`),
    `ratio` the modulus of the inclusion divided by that of the matrix, and S the factor of
    Eshelby's tensor (`factor`).
    """
    return (strain * (1 - ratio) + misfit * ratio) / (1 + factor * (ratio - 1))


def exterior_strain(
    eigenstrain: FloatArray, normal: FloatArray, ratio: FloatArray, nu: float
) -> FloatArray:
    """Strain outside of a sphere with a uniform eigenstrain in an infinite body.

    Parameters
    ----------
    eigenstrain : ndarray, shape (6,)
        Uniform eigenstrain of the sphere [-].
    normal : ndarray, shape (3, ...)
        Unit vectors from the centre to the points.
    ratio : ndarray, shape (...)
        Radius of the sphere divided by the distance of the points, <= 1.
    nu : float
        Poisson's ratio.

    Returns
    -------
    ndarray, shape (6, ...)
    """
    e = as_matrix(eigenstrain)
    trace = np.trace(e)
    along = np.einsum("ij,j...->i...", e, normal)
    both = np.einsum("i...,i...->...", normal, along)
    square = ratio**2
    unit = np.eye(3).reshape(3, 3, *([1] * ratio.ndim))
    nn = normal[:, None] * normal[None]
    mixed = normal[:, None] * along[None] + along[:, None] * normal[None]
    strain = (
        ((3 * square + 10 * nu - 5) * trace + 15 * (1 - square) * both) * unit
        + (15 * (1 - 2 * nu - square) * trace + 15 * (7 * square - 5) * both) * nn
        + 2 * (3 * square - 10 * nu + 5) * e.reshape(unit.shape)
        + 30 * (nu - square) * mixed
    )
    return as_six(ratio**3 / (30 * (1 - nu)) * strain)


@dataclass(frozen=True)
class MisfitSphere:
    """Sphere with an isotropic misfit strain in a half-space of the same elastic constants.

    R. D. Mindlin, D. H. Cheng (1950), doi:10.1063/1.1699785.

    Parameters
    ----------
    E, nu : float
        Young's modulus [Pa] and Poisson's ratio of half-space and sphere.
    misfit : float
        Misfit strain along each direction [-], not the volumetric strain.
    radius : float
        Radius [m], > 0.
    depth : float
        Depth of the centre below the surface [m], at least the radius.

    Raises
    ------
    ValueError
        A value is outside its range, or the sphere cuts the surface.
    TypeError
        An argument is not a number.
    """

    E: float
    nu: float
    misfit: float
    radius: float
    depth: float

    def __post_init__(self) -> None:
        material = Material.elastic(self.E, self.nu)
        checked_misfit(number("misfit", self.misfit), material)
        if not positive("depth", self.depth) >= positive("radius", self.radius):
            raise ValueError(
                f"depth must be at least the radius {self.radius!r} m, got {self.depth!r}: the "
                "sphere must not cut the surface"
            )

    @property
    def _strength(self) -> float:
        """Strength of the sphere as a point source of displacement [m^3].

        Around a sphere in an infinite body, the radial displacement is this strength divided by the
        square of the distance from the centre.
        """
        return (1 + self.nu) / (3 * (1 - self.nu)) * self.misfit * self.radius**3

    def surface_displacement(self, distance: ArrayLike) -> FloatArray:
        """Normal displacement of the surface [m], positive into the body.

        distance: distance along the surface from the point above the centre of the sphere [m].
        """
        r = finite_array("distance", distance)
        strength = 4 * (1 - self.nu) * self._strength
        return np.asarray(-strength * self.depth / (r**2 + self.depth**2) ** 1.5)

    def stress(self, x: ArrayLike, y: ArrayLike, z: ArrayLike) -> FloatArray:
        """Stress at points [Pa], shape (6, ...).

        x and y are measured from the centre of the sphere, z from the surface into the body [m].
        """
        points = np.stack(together(x=x, y=y, z=z))
        z_axis = np.array([0.0, 0.0, 1.0]).reshape(3, *([1] * (points.ndim - 1)))
        own = points - self.depth * z_axis
        inside = np.linalg.norm(own, axis=0) < self.radius
        second, _ = _derivatives(np.where(inside, self.radius, own))
        mirrored, third = _derivatives(points + self.depth * z_axis)
        turned = z_axis[:, None] * mirrored[2][None]
        nu, strength = self.nu, self._strength
        image = (3 - 4 * nu) * mirrored + 2 * points[2] * third
        image = image + (4 * nu - 2) * (turned + turned.swapaxes(0, 1))
        elastic = (strength / self.radius**3 - self.misfit) * _unit(points.ndim - 1)
        strain = np.where(inside, elastic, -strength * second) - strength * image
        return stress_of(as_six(strain), self.E, self.nu)


def _derivatives(points: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Second derivatives of 1/R, shape (3, 3, ...), and their derivatives along z.

    R is the distance of the points from the origin.
    """
    distance = np.linalg.norm(points, axis=0)
    n = points / distance
    unit = _unit(distance.ndim)
    nn = n[:, None] * n[None]
    z_row = np.zeros((3, 3, *([1] * distance.ndim)))
    z_row[2, 2] = 1.0
    rows = n[:, None] * z_row[2][None]
    third = 3 * (unit * n[2] + rows + rows.swapaxes(0, 1)) - 15 * nn * n[2]
    return (3 * nn - unit) / distance**3, third / distance**4


def _unit(axes: int) -> FloatArray:
    return np.eye(3).reshape(3, 3, *([1] * axes))
