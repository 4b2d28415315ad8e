# SPDX-License-Identifier: GPL-3.0-or-later
"""Layered bodies: coatings on a substrate."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import accumulate
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from .. import _core
from .._util.cached_property import cached_property
from .._util.checks import FloatArray, finite, positive, real_array, require_type
from .._util.display import HtmlTable, Rows, quantity
from .._util.frozen import FrozenDict
from .._util.short_text import in_short
from .depth_profiles import checked_depths
from .display import material_in_short
from .free_faces import require_endless
from .heterogeneous import Heterogeneous
from .material import Material


def _require_endless(name: str, material: Material) -> None:
    """Raise ValueError for a material with free faces, which are not supported with layers."""
    if material.free_faces is not None:
        raise ValueError(
            f"{name} must not have free_faces, got {material.free_faces!r}: a free face of a "
            "layered body is not supported"
        )


def _checked_layers(given: Any) -> tuple[tuple[Material, float], ...]:
    if isinstance(given, (Material, str, np.ndarray)) or not isinstance(given, Iterable):
        raise TypeError(f"layers must be a list of (material, thickness), got {in_short(given)}")
    layers = []
    for n, layer in enumerate(given):
        if isinstance(layer, Material) or not isinstance(layer, Sequence) or len(layer) != 2:
            raise TypeError(f"layers[{n}] must be (material, thickness), got {in_short(layer)}")
        material, thickness = layer
        require_type(f"material of layers[{n}]", material, Material)
        if material.is_rigid:
            raise ValueError(f"layers[{n}] must not be rigid: only the substrate can be rigid")
        _require_endless(f"material of layers[{n}]", material)
        layers.append((material, positive(f"thickness of layers[{n}]", thickness)))
    if not layers:
        raise ValueError(
            "layers must contain at least one layer, got none: for a body without layers "
            "use the Material of the substrate"
        )
    return tuple(layers)


@dataclass(frozen=True, repr=False, init=False)
class Layered(HtmlTable):
    """Layers perfectly bonded to a substrate: a coated body, used like a `Material`.

    Parameters
    ----------
    layers : sequence of pairs
        Material and thickness [m] of each layer, from the surface down; any number.
    substrate : Material
        Half-space below the layers. `Material.rigid()` is allowed; the stress in a rigid substrate
        is unknown and stored as 0.

    Raises
    ------
    ValueError
        There is no layer, a layer is rigid, or a thickness is not a finite number > 0.
    TypeError
        An argument is not a material or not a number.

    Notes
    -----
    Each Fourier mode of the tractions is transmitted and reflected at the interfaces. The modes are
    computed by an impedance recursion, which is stable for thick and thin layers
    (docs/theory/layers.md). In-plane stresses jump
    at interfaces. A depth z exactly at an interface belongs to the material below it;
    ``np.nextafter(z, 0.0)`` belongs to the layer above.

    Each layer and the substrate has the hardening law, yield profile, residual stress and softening
    law of its material. The depths of these profiles are measured from the surface of the body. Use
    ``material.with_residual_stress([0.0], [s])`` for a uniform growth stress s in a coating.

    Layers that have thermal constants conduct frictional heat without contact resistance between
    them (docs/theory/heat.md).
    """

    layers: tuple[tuple[Material, float], ...]
    substrate: Material
    law: ClassVar[str] = "layered"

    def __init__(self, layers: Sequence[tuple[Material, float]], substrate: Material) -> None:
        object.__setattr__(self, "layers", _checked_layers(layers))
        if isinstance(substrate, Heterogeneous):
            raise ValueError(
                f"substrate must be a Material, got {in_short(substrate)}: inclusions in layered "
                "bodies are not supported"
            )
        require_type("substrate", substrate, Material)
        _require_endless("substrate", substrate)
        object.__setattr__(self, "substrate", substrate)
        self._core  # noqa: B018  (the core checks thicknesses)

    def _named_materials(self) -> list[tuple[str, Material]]:
        named = [(f"layers[{n}]", material) for n, (material, _) in enumerate(self.layers)]
        return [*named, ("substrate", self.substrate)]

    @cached_property
    def _core(self) -> Any:
        layers = [(material._core, h) for material, h in self.layers]
        return _core.Body(self.substrate._core, layers)

    @property
    def parameters(self) -> Mapping[str, tuple[float, ...]]:
        """E [Pa] and nu of all materials from the surface down, and all layer thicknesses [m]."""
        materials = materials_of(self)
        return FrozenDict(
            {
                "E": tuple(material.E for material in materials),
                "nu": tuple(material.nu for material in materials),
                "thickness": tuple(h for _, h in self.layers),
            }
        )

    @property
    def thermal(self) -> tuple[tuple[float, float, float], ...] | None:
        """Thermal constants of all materials from the surface down; None unless each has them.

        Each material has a tuple (conductivity, expansion, diffusivity), see
        `Material.with_thermal`.
        """
        return thermal_of(self)

    @property
    def softening(self) -> tuple[Callable[[FloatArray], ArrayLike] | None, ...] | None:
        """Softening laws of all materials from the surface down; None if none has a law."""
        laws = tuple(material.softening for material in materials_of(self))
        return laws if any(law is not None for law in laws) else None

    @property
    def min_yield_stress(self) -> float:
        """Minimum initial yield stress of all materials [Pa]; infinite if none can yield."""
        return min(material.min_yield_stress for material in materials_of(self))

    @property
    def interfaces(self) -> FloatArray:
        """Depth of the bottom of each layer [m], shape (number of layers,)."""
        return np.array(list(accumulate(h for _, h in self.layers)))

    @property
    def is_rigid(self) -> bool:
        """Always False, because the layers are deformable."""
        return False

    @property
    def is_plastic(self) -> bool:
        """Whether a layer or the substrate can yield."""
        return any(material.is_plastic for _, material in self._named_materials())

    def material_at(self, z: float) -> Material:
        """Return the material at depth z [m], z >= 0; at an interface, the material below."""
        depth = finite("z", z)
        if not depth >= 0:
            raise ValueError(f"z must be >= 0, got {z!r}")
        below = int(np.searchsorted(self.interfaces, depth, side="right"))
        return self._named_materials()[below][1]

    def yield_stress_at(self, z: ArrayLike) -> FloatArray:
        """Initial yield stress [Pa] at depths z [m], same shape; infinite in elastic materials.

        Raises ValueError if z is negative or not finite.
        """
        depths = checked_depths(z)
        return self._over_depth(depths, np.zeros_like(depths), Material.yield_stress_at)

    def residual_stress_at(self, z: ArrayLike) -> FloatArray:
        """Initial stresses sxx, syy and sxy [Pa] at depths z [m], each with the shape of z.

        0 without residual stress. Raises ValueError if z is negative or not finite.
        """
        depths = checked_depths(z)
        return self._over_depth(depths, np.zeros((3, *depths.shape)), Material.residual_stress_at)

    def _over_depth(
        self, depths: FloatArray, out: FloatArray, of: Callable[[Material, FloatArray], FloatArray]
    ) -> FloatArray:
        """Fill `out` with `of(material, depths)`; its last axes are the axes of `depths` [m]."""
        for material, there in materials_at(self, depths):
            out[..., there] = of(material, depths[there])
        return out

    def wave_compliance(self, wavenumber: ArrayLike) -> FloatArray:
        """Ratio of surface displacement u_z to pressure for a pressure wave cos(q x) [m/Pa].

        Parameters
        ----------
        wavenumber : array_like
            Wavenumber q = 2 pi/wavelength [1/m], > 0.

        Returns
        -------
        ndarray
            Compliance, in the shape of `wavenumber`. Its limit is 2 (1 - nu^2)/(E q), with the
            constants of the substrate for long waves and of the top layer for short waves.
        """
        q = real_array("wavenumber", wavenumber)
        bad = ~(np.isfinite(q) & (q > 0))
        if bad.any():
            raise ValueError(f"wavenumber must be finite and > 0, got {float(q[bad].flat[0])!r}")
        found = self._core.stack.wave_compliance(np.ascontiguousarray(q).ravel())
        return np.asarray(found).reshape(q.shape)

    def _rows(self) -> Rows:
        rows = [("law", self.law)]
        rows += [
            (f"layer {n}", f"{quantity(h, 'm')} of {material_in_short(material)}")
            for n, (material, h) in enumerate(self.layers, 1)
        ]
        return [*rows, ("substrate", material_in_short(self.substrate))]

    def __repr__(self) -> str:
        return f"Layered({list(self.layers)!r}, {self.substrate!r})"

    def __getstate__(self) -> dict[str, Any]:
        return {"layers": self.layers, "substrate": self.substrate}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)


Body = Material | Layered | Heterogeneous


def matrix_of(body: Body) -> Material | Layered:
    """Return the matrix of a heterogeneous body, and any other body itself."""
    return body.matrix if isinstance(body, Heterogeneous) else body


def require_bodies(*bodies: Any, inclusions: bool = False) -> None:
    """Raise TypeError for an object that is no body.

    inclusions: whether heterogeneous bodies are supported; otherwise they raise ValueError.
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

    Raises ValueError with the reason for layers and inclusions, ValueError for free faces, and
    TypeError for anything else.
    """
    for n, body in enumerate(bodies, 1):
        if isinstance(body, Heterogeneous):
            raise ValueError(f"body{n} must be a Material, got a body with inclusions: {reason}")
        if isinstance(body, Layered):
            raise ValueError(
                f"body{n} must be a Material, got {len(body.layers)} layer(s): {reason}"
            )
        require_type(f"body{n}", body, Material)
    require_endless("ends of bodies are not supported", *bodies)


def top_thickness(body: Body) -> float:
    """Thickness of the top layer [m]; infinite for a body without layers."""
    return body.layers[0][1] if isinstance(body, Layered) else math.inf


def homogeneous_for_wave(body: Body, wavenumber: float) -> Material:
    """Return a homogeneous body as compliant as `body` for a pressure wave (wavenumber in 1/m)."""
    body = matrix_of(body)
    if isinstance(body, Material):
        return body
    nu = body.layers[0][0].nu
    compliance = float(body.wave_compliance(wavenumber))
    return Material.elastic(2 * (1 - nu**2) / (wavenumber * compliance), nu)


def elastic(body: Body) -> Body:
    """Return an elastic body with the elastic constants of `body`."""
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
    """All materials of a body, from the surface down; the matrix of a heterogeneous body."""
    if isinstance(body, Material):
        return [body]
    if isinstance(body, Heterogeneous):
        return [body.matrix]
    return [material for _, material in body._named_materials()]


def thermal_of(body: Body) -> tuple[tuple[float, float, float], ...] | None:
    """Return thermal constants of all materials from the surface down; None if any has none."""
    if isinstance(body, Heterogeneous):
        body = body.matrix
    if isinstance(body, Material):
        return None if body.thermal is None else (body.thermal,)
    constants = tuple(m.thermal for m in materials_of(body) if m.thermal is not None)
    return constants if len(constants) == len(materials_of(body)) else None


def without_softening(body: Body) -> Body:
    """Return a copy of a body whose materials have no softening law."""
    if isinstance(body, Heterogeneous):
        matrix = replace(body.matrix, softening=None)
        return Heterogeneous(matrix, body.inclusions, body.measured)
    if isinstance(body, Material):
        return replace(body, softening=None)
    *layers, substrate = (replace(material, softening=None) for material in materials_of(body))
    thickness = [h for _, h in body.layers]
    return Layered(list(zip(layers, thickness, strict=True)), substrate)


def names_of_materials(layers: int) -> list[str]:
    """Names, in results files, of the materials of a body with this number of layers."""
    return [*(f"layer{n}" for n in range(1, layers + 1)), "substrate"]


def materials_at(body: Body, depths: FloatArray) -> Iterator[tuple[Material, FloatArray]]:
    """Iterate over a body's materials, each with a mask of the given depths [m] that lie in it."""
    materials = materials_of(body)
    bottoms = body.interfaces if isinstance(body, Layered) else np.empty(0)
    numbers = np.searchsorted(bottoms, depths, side="right")
    for number, material in enumerate(materials):
        yield material, numbers == number


def backstresses_of(body: Body) -> int:
    """Number of backstresses of a body: the maximum over its materials."""
    return max(len(material.kinematic) for material in materials_of(body))


def softest(body: Body) -> Material:
    """Most compliant material of a body, for order-of-magnitude estimates."""
    body = matrix_of(body)
    if isinstance(body, Material):
        return body
    return max(materials_of(body), key=lambda material: (1 - material.nu**2) / material.E)
