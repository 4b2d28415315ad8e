# SPDX-License-Identifier: GPL-3.0-or-later
"""Type of all bodies, and functions that apply to each kind of body."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from .._util.checks import BoolArray, FloatArray, require_type
from .._util.short_text import in_short
from .free_faces import require_endless
from .heterogeneous import Heterogeneous
from .layers import Layered, layers_at
from .material import Material

Body = Material | Layered | Heterogeneous


def matrix_of(body: Body) -> Material | Layered:
    """Return the matrix of a heterogeneous body; return any other body unchanged."""
    return body.matrix if isinstance(body, Heterogeneous) else body


def require_bodies(*bodies: Any, inclusions: bool = False) -> None:
    """Raise TypeError for an object that is not a body.

    inclusions: whether heterogeneous bodies are supported. If not, a heterogeneous body raises
    ValueError.
    """
    for n, body in enumerate(bodies, 1):
        if not isinstance(body, Body):
            raise TypeError(
                f"body{n} must be a samcontact.Material, samcontact.Layered or "
                f"samcontact.Heterogeneous, got {in_short(body)}"
            )
        if isinstance(body, Heterogeneous) and not inclusions:
            raise ValueError(
                f"body{n} must be a Material or Layered, got a body with inclusions, which only "
                "Simulation supports: use its matrix, or a Simulation"
            )


def require_homogeneous(reason: str, *bodies: Any) -> None:
    """Raise an error unless each body is a Material without free faces.

    A layered or heterogeneous body raises ValueError with `reason` in the message, a body with free
    faces raises ValueError, and any other object raises TypeError.
    """
    for n, body in enumerate(bodies, 1):
        if isinstance(body, Heterogeneous):
            raise ValueError(f"body{n} must be a Material, got a body with inclusions: {reason}")
        if isinstance(body, Layered):
            raise ValueError(
                f"body{n} must be a Material, got a body with {len(body.layers)} layer(s): {reason}"
            )
        require_type(f"body{n}", body, Material)
    require_endless("ends of bodies are not supported", *bodies)


def top_thickness(body: Body) -> float:
    """Thickness of the top layer [m]; infinite for a body without layers."""
    body = matrix_of(body)
    return body.layers[0][1] if isinstance(body, Layered) else math.inf


def homogeneous_for_wave(body: Body, wavenumber: float) -> Material:
    """Return the homogeneous body that is as compliant as `body` under a sinusoidal pressure.

    wavenumber: wavenumber 2 pi/wavelength of the pressure [1/m].
    """
    body = matrix_of(body)
    if isinstance(body, Material):
        return body
    nu = body.layers[0][0].nu
    compliance = float(body.wave_compliance(wavenumber))
    return Material.elastic(2 * (1 - nu**2) / (wavenumber * compliance), nu)


def elastic(body: Body) -> Body:
    """Return an elastic body with the elastic constants of `body`, without its inclusions."""
    body = matrix_of(body)
    *layers, substrate = (
        material if material.is_rigid else Material.elastic(material.E, material.nu)
        for material in materials_of(body)
    )
    if isinstance(body, Material):
        return substrate
    thickness = [h for _, h in body.layers]
    return Layered(list(zip(layers, thickness, strict=True)), substrate)


def materials_of(body: Body) -> list[Material]:
    """All materials of a body (without inclusions), from the surface down."""
    if isinstance(body, Material):
        return [body]
    return materials_of(body.matrix) if isinstance(body, Heterogeneous) else list(body.materials)


def thermal_of(body: Body) -> tuple[tuple[float, float, float], ...] | None:
    """Return the thermal constants of all materials of a body from the surface down.

    Returns None unless all of them have thermal constants. Inclusions are ignored.
    """
    if isinstance(body, Heterogeneous):
        body = body.matrix
    if isinstance(body, Material):
        return None if body.thermal is None else (body.thermal,)
    return body.thermal


def without_softening(body: Body) -> Body:
    """Return a copy of a body without the softening laws of its materials."""
    if isinstance(body, Heterogeneous):
        matrix = without_softening(body.matrix)
        assert not isinstance(matrix, Heterogeneous)
        return Heterogeneous(matrix, body.inclusions, body.measured)
    if isinstance(body, Material):
        return replace(body, softening=None)
    *layers, substrate = (replace(material, softening=None) for material in body.materials)
    thickness = [h for _, h in body.layers]
    return Layered(list(zip(layers, thickness, strict=True)), substrate)


def names_of_materials(layers: int) -> list[str]:
    """Names by which results files refer to the materials of a body.

    layers: number of layers of the body.
    """
    return [*(f"layer{n}" for n in range(1, layers + 1)), "substrate"]


def materials_at(body: Body, depths: FloatArray) -> Iterator[tuple[Material, BoolArray]]:
    """Iterate over a body's materials, each with a mask of the given depths [m] that lie in it."""
    body = matrix_of(body)
    if isinstance(body, Layered):
        yield from layers_at(body, depths)
    else:
        yield body, np.ones(np.shape(depths), dtype=bool)


def interfaces_of(body: Body) -> FloatArray:
    """Depth of the bottom of each layer of a body [m]; empty without layers."""
    body = matrix_of(body)
    return body.interfaces if isinstance(body, Layered) else np.empty(0)


def interfaces_on_cells(body: Body) -> FloatArray:
    """Depths of the interfaces that must coincide with cell boundaries [m], shape (n,).

    In a layered body that can yield or has inclusions, these are all interfaces. Otherwise there
    are none.
    """
    strained = body.is_plastic or isinstance(body, Heterogeneous)
    return interfaces_of(body) if strained else np.empty(0)


def backstresses_of(body: Body) -> int:
    """Number of backstresses of a body: the maximum over its materials."""
    return max(len(material.kinematic) for material in materials_of(body))


def softest(body: Body) -> Material:
    """Most compliant material of a body, for order-of-magnitude estimates."""
    if isinstance(body, Material):
        return body
    return max(materials_of(body), key=plane_compliance)


def plane_compliance(material: Material) -> float:
    """Reciprocal of the plane strain modulus, (1 - nu^2)/E [1/Pa]; 0 for a rigid body."""
    return (1.0 - material.nu**2) / material.E
