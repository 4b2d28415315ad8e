# SPDX-License-Identifier: GPL-3.0-or-later
"""Stress cycle of material below a rolling Hertz contact, in closed form."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, real_array, require_type
from .._util.frozen import FrozenDict, read_only
from .._util.short_text import in_short
from ..bodies.depth_profiles import checked_depths
from ..bodies.material import Material
from ..hertz import LineContact, PointContact
from .cycle import Cycle
from .paths import GivenPaths

__all__ = ["hertz_cycle"]

_REACH = 4.0
"""Length of the path on either side of the contact centre, in contact radii or half-widths."""
_STEP = 0.02
"""Distance moved between two instants, in contact radii or half-widths."""
_DEPTHS = 120
_MAX_DEPTH = 3.0
"""Number of default depths, and the largest of them in contact radii or half-widths."""


def hertz_cycle(
    contact: LineContact | PointContact,
    body: Material,
    z: ArrayLike | None = None,
    y: ArrayLike | None = None,
    friction: float = 0.0,
) -> Cycle:
    """Stress cycle of material, e.g. of a gear flank, that passes below a Hertz contact along x.

    Parameters
    ----------
    contact : LineContact or PointContact
        Contact from `samcontact.hertz`.
    body : Material
        Material, whose Poisson's ratio and residual stress are used. Its plastic flow is not
        computed: use states of a simulation if the body yields.
    z : array_like, shape (nz,), optional
        Increasing depths [m], >= 0. Default: 120 depths up to 3 b, where b is the half-width or
        contact radius.
    y : array_like, shape (ny,), optional
        Increasing positions across the rolling direction [m], for a point contact only. Default: 0.
    friction : float, optional
        Coefficient of friction in full sliding; the shear traction acts on the body along +x.

    Returns
    -------
    Cycle
        Cycle whose points have the axis z (line contact) or the axes y and z (point contact). The
        material moves by 0.02 b between instants, from 4 b on one side of the contact centre to 4 b
        on the other side. In one more instant, it is far from the contact.

    Raises
    ------
    ValueError
        A depth is negative, the depths do not increase, or y is given for a line contact.
    TypeError
        `contact` is neither a LineContact nor a PointContact, or `body` is not a Material.
    """
    require_type("body", body, Material)
    if not isinstance(contact, (LineContact, PointContact)):
        raise TypeError(
            "contact must be a LineContact or PointContact of samcontact.hertz, got "
            f"{in_short(contact)}: for elliptic contacts, use steady_cycle with a simulated state"
        )
    if body.is_rigid:
        raise ValueError("body must be deformable, got a rigid one")
    size = contact.b if isinstance(contact, LineContact) else contact.a
    depths = (
        np.linspace(_MAX_DEPTH / _DEPTHS, _MAX_DEPTH, _DEPTHS) * size
        if z is None
        else _increasing("z", z)
    )
    depths = checked_depths(depths)
    count = int(_REACH / _STEP)
    x = np.arange(-count, count + 1) * (_STEP * size)
    places: dict[str, FloatArray] = {"z": read_only(depths)}
    if isinstance(contact, LineContact):
        if y is not None:
            raise ValueError("y must be omitted for a line contact, which does not vary along y")
        stress = contact.stress(x[:, None], depths, body.nu, friction)
    else:
        lines = np.zeros(1) if y is None else _increasing("y", y)
        places = {"y": read_only(lines)} | places
        stress = contact.stress(x[:, None, None], lines[:, None], depths, body.nu, friction)
    stress = np.moveaxis(stress, 0, 1)
    stress = np.concatenate([stress, np.zeros_like(stress[:1])])  # far from the contact
    xx, yy, xy = body.residual_stress_at(depths)
    for component, initial in ((0, xx), (1, yy), (5, xy)):
        stress[:, component] += initial
    return Cycle(GivenPaths(stress, None), body, FrozenDict(places))


def _increasing(name: str, given: ArrayLike) -> FloatArray:
    values = np.atleast_1d(real_array(name, given))
    if values.ndim != 1 or values.size == 0 or not np.isfinite(values).all():
        raise ValueError(
            f"{name} must be a list of one or more finite numbers, got {in_short(given)}"
        )
    if not (np.diff(values) > 0).all():
        raise ValueError(f"{name} must contain increasing numbers, got {in_short(given)}")
    return values + 0.0
