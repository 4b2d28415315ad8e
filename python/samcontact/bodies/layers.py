# SPDX-License-Identifier: GPL-3.0-or-later
"""Layered bodies: coatings on a substrate."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from .. import _core
from .._util.cached_property import cached_property
from .._util.checks import BoolArray, FloatArray, finite, positive, real_array, require_type
from .._util.display import HtmlTable, Rows, quantity
from .._util.frozen import FrozenDict
from .._util.short_text import in_short
from .depth_profiles import checked_depths
from .display import material_in_short
from .material import Material


def _require_endless(name: str, material: Material) -> None:
    """Raise ValueError for a material with free faces, which are not supported with layers."""
    if material.free_faces is not None:
        raise ValueError(
            f"{name} must not have free_faces, got {material.free_faces!r}: a free face of a "
            "layered body is not supported"
        )


def _require_no_inclusions(name: str, material: Any) -> None:
    """Raise ValueError if a heterogeneous body is given in place of a material."""
    if hasattr(material, "inclusions"):
        raise ValueError(
            f"{name} must be a Material, got {in_short(material)}: give the inclusions of a "
            "layered body as samcontact.Heterogeneous(samcontact.Layered(...), inclusions)"
        )


def _checked_layers(given: Any) -> tuple[tuple[Material, float], ...]:
    if isinstance(given, (Material, str, np.ndarray)) or not isinstance(given, Iterable):
        raise TypeError(
            f"layers must be a list of pairs (material, thickness), got {in_short(given)}"
        )
    layers = []
    for n, layer in enumerate(given):
        if isinstance(layer, Material) or not isinstance(layer, Sequence) or len(layer) != 2:
            raise TypeError(
                f"layers[{n}] must be a pair (material, thickness), got {in_short(layer)}"
            )
        material, thickness = layer
        _require_no_inclusions(f"material of layers[{n}]", material)
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
        Pairs (material, thickness [m]) of any number of layers, from the surface down.
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
    (docs/theory/layers.md). In-plane stresses are discontinuous at interfaces. A depth z exactly at
    an interface belongs to the material below it; ``np.nextafter(z, 0.0)`` belongs to the layer
    above.

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
        _require_no_inclusions("substrate", substrate)
        require_type("substrate", substrate, Material)
        _require_endless("substrate", substrate)
        object.__setattr__(self, "substrate", substrate)
        _ = self._core  # which checks the thicknesses

    @cached_property
    def _core(self) -> Any:
        layers = [(material._core, h) for material, h in self.layers]
        return _core.Body(self.substrate._core, layers)

    @property
    def materials(self) -> tuple[Material, ...]:
        """All materials from the surface down, the substrate last."""
        return (*(material for material, _ in self.layers), self.substrate)

    @property
    def parameters(self) -> Mapping[str, tuple[float, ...]]:
        """E [Pa] and nu of all materials from the surface down, and all layer thicknesses [m]."""
        materials = self.materials
        return FrozenDict(
            {
                "E": tuple(material.E for material in materials),
                "nu": tuple(material.nu for material in materials),
                "thickness": tuple(h for _, h in self.layers),
            }
        )

    @property
    def thermal(self) -> tuple[tuple[float, float, float], ...] | None:
        """Thermal constants of all materials from the surface down; None unless all have them.

        Each material has a tuple (conductivity, expansion, diffusivity), see
        `Material.with_thermal`.
        """
        constants = tuple(m.thermal for m in self.materials if m.thermal is not None)
        return constants if len(constants) == len(self.materials) else None

    @property
    def softening(self) -> tuple[Callable[[FloatArray], ArrayLike] | None, ...] | None:
        """Softening laws of all materials from the surface down; None if none has a law."""
        laws = tuple(material.softening for material in self.materials)
        return laws if any(law is not None for law in laws) else None

    @property
    def min_yield_stress(self) -> float:
        """Minimum initial yield stress of all materials [Pa]; infinite if none can yield."""
        return min(material.min_yield_stress for material in self.materials)

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
        return any(material.is_plastic for material in self.materials)

    def material_at(self, z: float) -> Material:
        """Return the material at depth z [m], z >= 0; at an interface, the material below."""
        depth = finite("z", z)
        if not depth >= 0:
            raise ValueError(f"z must be >= 0, got {z!r}")
        below = int(np.searchsorted(self.interfaces, depth, side="right"))
        return self.materials[below]

    def yield_stress_at(self, z: ArrayLike) -> FloatArray:
        """Initial yield stress [Pa] at depths z [m], same shape; infinite in elastic materials.

        Raises ValueError if z is negative or not finite.
        """
        depths = checked_depths(z)
        return self._over_depth(depths, np.zeros_like(depths), Material.yield_stress_at)

    def residual_stress_at(self, z: ArrayLike) -> FloatArray:
        """Initial stresses sxx, syy and sxy [Pa] at depths z [m], each with the shape of z.

        They are 0 in a material without residual stress. Raises ValueError if z is negative or not
        finite.
        """
        depths = checked_depths(z)
        return self._over_depth(depths, np.zeros((3, *depths.shape)), Material.residual_stress_at)

    def _over_depth(
        self, depths: FloatArray, out: FloatArray, of: Callable[[Material, FloatArray], FloatArray]
    ) -> FloatArray:
        """Fill `out` with the values of the function `of(material, depths)` at all depths [m].

        The function is called once for each material, with the depths that lie in this material.
        The last axes of `out` are the axes of `depths`.
        """
        for material, there in layers_at(self, depths):
            out[..., there] = of(material, depths[there])
        return out

    def wave_compliance(self, wavenumber: ArrayLike) -> FloatArray:
        """Ratio of surface displacement u_z to pressure for a sinusoidal pressure cos(q x) [m/Pa].

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


def layers_at(body: Layered, depths: FloatArray) -> Iterator[tuple[Material, BoolArray]]:
    """Iterate over the materials of a layered body, each with a mask of the depths [m] in it."""
    numbers = np.searchsorted(body.interfaces, depths, side="right")
    for number, material in enumerate(body.materials):
        yield material, numbers == number
