# SPDX-License-Identifier: GPL-3.0-or-later
"""Free end faces of a body, perpendicular to its surface and to the y axis."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, Any, cast

from .._util.checks import choice, finite
from .._util.short_text import in_short

if TYPE_CHECKING:
    from typing_extensions import Self

FreeFaces = tuple[float, float, str]
"""Coordinates y of the low and the high face [m], infinite if absent; name of the method."""

METHODS = ("exact", "factor")
MAX_PLACE = 2.0
"""Maximum distance of a face from the middle of the grid [m]; more suggests a wrong unit."""


def checked_faces(given: Any) -> FreeFaces:
    """Return the free faces of a body after checking their number, order and distance."""
    if not isinstance(given, (list, tuple)) or len(given) != 3:
        raise ValueError(f"free_faces must contain low, high and method, got {in_short(given)}")
    low, high = (
        bound if given[n] in (None, bound) else finite(f"{name} of free_faces", given[n])
        for n, (name, bound) in enumerate((("low", -math.inf), ("high", math.inf)))
    )
    if low == -math.inf and high == math.inf:
        raise ValueError("free_faces must have a low face, a high face or both, got neither")
    for place in (low, high):
        if math.isfinite(place) and abs(place) > MAX_PLACE:
            raise ValueError(
                f"free_faces must be within {MAX_PLACE:g} m of the middle of the grid, got a face "
                f"at y = {place!r} m: millimetres instead of metres?"
            )
    if not low < high:
        raise ValueError(
            f"low of free_faces must be less than high ({high!r} m), got {low!r} m: the body lies "
            "between its two faces"
        )
    return low, high, choice("method of free_faces", given[2], METHODS)


class HasFreeFaces:
    """Base class of `Material` with free end faces."""

    free_faces: FreeFaces | None

    def with_free_faces(
        self, low: float | None = None, high: float | None = None, method: str = "exact"
    ) -> Self:
        """Return a copy with a free face at one or both ends along y, such as the ends of a roller.

        The grid must contain at least one row of cells beyond each face that the contact reaches.
        The cells beyond a face are out of contact. Near a face the body is more compliant than a
        half-space. If both bodies end at the same y, the pressure decreases towards their faces. If
        only one body ends there, the pressure increases towards its face, but less than if both
        bodies were half-spaces.

        Only frictionless contact of elastic bodies on non-periodic grids is supported. If a body
        has free faces, ValueError is raised for friction, heat, layers or plastic flow, and for a
        request for the stress of this body.

        Parameters
        ----------
        low, high : float, optional
            Coordinates y of the faces [m], on edges of cells; the body lies between the faces.
            Default: no face at this end.
        method : {"exact", "factor"}, optional
            "exact" solves for the quarter-space that ends at each face. "factor" mirrors the
            pressure about the face and multiplies it by 1.29 - (0.08 - 0.5 nu)/(1 - nu), where nu
            is Poisson's ratio; this takes less time to prepare but is less accurate.
            docs/theory/free_faces.md states the errors of both methods.

        Returns
        -------
        Material
            Material with these faces in place of earlier ones.

        Raises
        ------
        ValueError
            The material is rigid or plastic, neither `low` nor `high` is given, or `low` is not
            less than `high`.
        TypeError
            A coordinate is not a number.
        """
        for name, place in (("low", low), ("high", high)):
            if place is not None:
                finite(name, place)
        return cast("Self", replace(cast("Any", self), free_faces=(low, high, method)))


def contact_strip(bodies: Iterable[Any]) -> tuple[float, float]:
    """Limits (low, high) of y between which both bodies exist [m]; infinite without a face."""
    low, high = -math.inf, math.inf
    for body in bodies:
        if (faces := getattr(body, "free_faces", None)) is not None:
            low, high = max(low, faces[0]), min(high, faces[1])
    if not low < high:
        raise ValueError(
            f"body1 and body2 must have a common range of y between their free faces, got a low "
            f"face at y = {low!r} m and a high face at y = {high!r} m"
        )
    return low, high


def require_endless(reason: str, *bodies: Any) -> None:
    """Raise ValueError if a body has free faces; `reason` becomes part of the message."""
    for n, body in enumerate(bodies, 1):
        if getattr(body, "free_faces", None) is not None:
            raise ValueError(f"body{n} must not have free_faces, got {body.free_faces!r}: {reason}")
