# SPDX-License-Identifier: GPL-3.0-or-later
"""Boundary layer of a lubricated contact."""

from __future__ import annotations

from dataclasses import dataclass

from .._util.checks import non_negative, positive


@dataclass(frozen=True)
class Boundary:
    """Layer adsorbed on the surfaces, which carries load where the film is thin.

    The pressure of the layer is p_b (h_b/(h - h_b))^3 at a film thickness h > h_b. The layer also
    represents asperities smaller than a cell. The share of the load that the layer carries depends
    on this law; the total pressure and the film thickness hardly depend on it.

    Attributes
    ----------
    thickness : float
        Thickness h_b [m], > 0; 1 to 5 nm for adsorbed films.
    friction : float
        Coefficient of friction of the layer [-], >= 0.
    pressure : float, or None
        Pressure p_b of the layer at a film thickness of 2 h_b [Pa]. None: the maximum pressure of
        the dry contact.
    """

    thickness: float
    friction: float = 0.1
    pressure: float | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "thickness", positive("thickness", self.thickness))
        object.__setattr__(self, "friction", non_negative("friction", self.friction))
        if self.pressure is not None:
            object.__setattr__(self, "pressure", positive("pressure", self.pressure))
