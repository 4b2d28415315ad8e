# SPDX-License-Identifier: GPL-3.0-or-later
"""Viscoelastic relaxation of homogeneous and layered bodies."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from .layered import Body, materials_of
from .layers import Layered
from .material import Material
from .relaxation import RelaxationTerms, creep_terms, long_time_share


def relaxation_of(body: Body) -> RelaxationTerms | None:
    """Return the relaxation times and shares of a body; None for an elastic body."""
    return materials_of(body)[0].relaxation_terms


def relaxes(*bodies: Body) -> bool:
    """Whether at least one of the bodies is viscoelastic."""
    return any(relaxation_of(body) is not None for body in bodies)


def longest_creep_time(body: Body) -> float:
    """Return the longest retardation time of a body [s]; 0 for an elastic body."""
    terms = relaxation_of(body)
    return 0.0 if terms is None else float(max(creep_terms(terms)[1], default=0.0))


def instantaneous(body: Body) -> Body:
    """Return an elastic body with the instantaneous moduli of a viscoelastic body."""
    return _changed(body, lambda material: replace(material, relaxation_terms=None))


def relaxed(body: Body) -> Body:
    """Return an elastic body with the long-time moduli of a viscoelastic body.

    Raises ValueError for a fluid, because its long-time modulus is 0.
    """

    def slow(material: Material) -> Material:
        share = long_time_share(material.relaxation_terms or ((), ()))
        if not share > 0:
            raise ValueError(
                "the shares of relaxation must sum to less than 1, got a fluid, which has no "
                "long-time modulus"
            )
        return Material.elastic(material.E * share, material.nu)

    return _changed(body, slow)


def vibrating(body: Body, omega: float) -> Body:
    """Return an elastic body with the magnitudes of the complex moduli of a viscoelastic body.

    omega: angular frequency of the oscillation [rad/s].
    """
    return _changed(
        body,
        lambda material: Material.elastic(
            float(np.hypot(material.storage(omega), material.loss(omega))), material.nu
        ),
    )


def softened(body: Body, share: float) -> Body:
    """Return an elastic body whose moduli are a fraction `share` of the instantaneous moduli."""
    return _changed(body, lambda material: Material.elastic(share * material.E, material.nu))


def _changed(body: Body, change: Callable[[Material], Material]) -> Body:
    """Apply a change to all materials of a viscoelastic body except a rigid substrate.

    An elastic body is returned unchanged.
    """
    if relaxation_of(body) is None:
        return body
    *layers, base = (m if m.is_rigid else change(m) for m in materials_of(body))
    if isinstance(body, Layered):
        return Layered([(m, h) for m, (_, h) in zip(layers, body.layers, strict=True)], base)
    return base


def require_no_relaxation(reason: str, *bodies: Body) -> None:
    """Raise ValueError if a body is viscoelastic; `reason` becomes part of the message."""
    for n, body in enumerate(bodies, 1):
        if (terms := relaxation_of(body)) is not None:
            times = f"{len(terms[0])} relaxation time{'s' * (len(terms[0]) > 1)}"
            raise ValueError(f"body{n} must not be viscoelastic, got {times}: {reason}")
