# SPDX-License-Identifier: GPL-3.0-or-later
"""Relaxation of a body: of its material, or of all its layers."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from .layered import Body, Layered, materials_of
from .relaxation import RelaxationTerms


def relaxation_of(body: Body) -> RelaxationTerms | None:
    """Return the relaxation times and shares of a body; None for an elastic body."""
    return materials_of(body)[0].relaxation_terms


def relaxes(*bodies: Body) -> bool:
    """Whether a body is viscoelastic."""
    return any(relaxation_of(body) is not None for body in bodies)


def instantaneous(body: Body) -> Body:
    """Return the elastic body that a body is for fast loads."""
    if relaxation_of(body) is None:
        return body
    if isinstance(body, Layered):
        layers = [(replace(material, relaxation_terms=None), h) for material, h in body.layers]
        return Layered(layers, replace(body.substrate, relaxation_terms=None))
    return replace(body, relaxation_terms=None)


def require_no_relaxation(reason: str, *bodies: Any) -> None:
    """Raise ValueError, with the reason, for viscoelastic bodies."""
    for n, body in enumerate(bodies, 1):
        if isinstance(body, Body) and (terms := relaxation_of(body)) is not None:
            times = f"{len(terms[0])} relaxation time{'s' * (len(terms[0]) > 1)}"
            raise ValueError(f"body{n} must not be viscoelastic, got {times}: {reason}")
