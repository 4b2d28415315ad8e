# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact modulus of a pair of bodies."""

from __future__ import annotations

import math
from typing import Protocol

from .._util.checks import poisson_ratio, positive
from .._util.short_text import in_short


class Body(Protocol):
    """Material attributes for `effective_modulus`: Young's modulus [Pa] and Poisson's ratio."""

    @property
    def E(self) -> float: ...
    @property
    def nu(self) -> float: ...


def effective_modulus(body1: Body, body2: Body) -> float:
    """Contact modulus of a pair, 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2.

    Parameters
    ----------
    body1, body2 : Material
        Bodies with ``E`` [Pa] (inf for a rigid body) and ``nu`` [-].

    Returns
    -------
    float
        E* [Pa] (Johnson 1985, section 4.2).

    Raises
    ------
    ValueError
        A modulus is not positive, or both bodies are rigid.
    TypeError
        A body is layered or has inclusions.
    """
    compliance = 0.0
    for name, body in (("body1", body1), ("body2", body2)):
        given = getattr(body, "E", None)
        if given is None:
            raise TypeError(
                f"{name} must be homogeneous, with E and nu, got {in_short(body)}: a layered body "
                "has no single modulus"
            )
        if hasattr(body, "matrix"):
            raise TypeError(
                f"{name} must be homogeneous, got {in_short(body)}: a body with inclusions has no "
                "single modulus; use its matrix for the contact without inclusions"
            )
        modulus = positive(f"{name}.E", given, allow_inf=True)
        if not math.isinf(modulus):
            compliance += (1.0 - poisson_ratio(f"{name}.nu", body.nu) ** 2) / modulus
    if compliance == 0.0:
        raise ValueError("body1 and body2 are both rigid: at least one must be deformable")
    return 1.0 / compliance
