# SPDX-License-Identifier: GPL-3.0-or-later
"""Life in rolling contact from integrals of stress over the stressed volume."""

from __future__ import annotations

import math
import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import (
    FloatArray,
    choice,
    finite,
    non_negative,
    number,
    positive,
    real_array,
    require_type,
)
from .._util.display import HtmlTable, Rows, ShortRepr, quantity
from .._util.errors import ResolutionWarning
from .._util.frozen import FrozenDict
from .field import FatigueField

__all__ = ["Life", "life"]

MODELS: Mapping[str, Mapping[str, float]] = {
    "ioannides_harris": {"exponent": 31 / 3, "depth_exponent": 7 / 3, "weibull": 10 / 9},
    "zaretsky": {"exponent": 10.0, "depth_exponent": 0.0, "weibull": 10 / 9},
}
"""Default exponents of each model."""
_MAX_SHARE = 0.5
"""Fraction of the integral that the uppermost layer of points may contribute without a warning."""


@dataclass(frozen=True, repr=False, eq=False)
class Life(ShortRepr, HtmlTable):
    """Integral of stress over volume in a model of rolling-contact life, from the function `life`.

    Attributes
    ----------
    model : str
        "ioannides_harris" or "zaretsky".
    criterion : str
        Name of the criterion that gives the stress.
    constants : mapping of str to float
        Limit [Pa], exponents, Weibull slope and length [m].
    log_integral : float
        Natural logarithm of the integral in SI units; -inf if no stress exceeds the limit.
    surface_share : float
        Fraction of the integral that comes from the uppermost layer of points [-]. If this fraction
        is large, the integral depends on the cell size.
    stressed_volume : float
        Volume in which the stress exceeds the limit [m^3]. It is proportional to `length`.
    """

    model: str
    criterion: str
    constants: Mapping[str, float]
    log_integral: float
    surface_share: float
    stressed_volume: float

    def relative_to(self, reference: Life) -> float:
        """Ratio of this life to the life of a reference at equal reliability [-].

        The ratio is infinite if only this life has no stress above the limit. It is 0 if only the
        reference has no stress above the limit.

        Raises
        ------
        ValueError
            The models, criteria or exponents differ, or both lives have no stress above the limit.
        TypeError
            The reference is not a Life.
        """
        require_type("reference", reference, Life)
        exponents = ("exponent", "depth_exponent", "weibull")
        if self.model != reference.model or any(
            self.constants[name] != reference.constants[name] for name in exponents
        ):
            raise ValueError("reference must have the same model and exponents as this life")
        if self.criterion != reference.criterion:
            raise ValueError(
                f"reference must have the criterion {self.criterion}, got {reference.criterion}"
            )
        if math.isinf(self.log_integral) and math.isinf(reference.log_integral):
            raise ValueError(
                "reference must have a stress above its limit, because this life has none: the "
                "ratio of two infinite lives is undefined"
            )
        return _exp((reference.log_integral - self.log_integral) / self.constants["weibull"])

    def constant_for(self, cycles: float, reliability: float = 0.9) -> float:
        """Logarithm of the material constant A for which this life is `cycles`.

        Parameters
        ----------
        cycles : float
            Measured life at the given reliability, in passes of the load [-], > 0.
        reliability : float, optional
            Fraction of survivors, in (0, 1). Default: 0.9, i.e. the life L10.

        Returns
        -------
        float
            Natural logarithm of A in SI units, to be passed to the method `cycles`. A is defined by
            ln(1/reliability) = A cycles^e I, with the Weibull slope e and the integral I.

        Raises
        ------
        ValueError
            An argument is outside its range, or no stress exceeds the limit.
        """
        if math.isinf(self.log_integral):
            raise ValueError(
                "the stress does not exceed the limit anywhere, so that the life is infinite: "
                "use a smaller limit"
            )
        size = positive("cycles", cycles)
        return (
            math.log(_risk(reliability))
            - self.constants["weibull"] * math.log(size)
            - self.log_integral
        )

    def cycles(self, log_constant: float, reliability: float = 0.9) -> float:
        """Life in passes of the load [-], for a material constant from `constant_for`.

        It is infinite if no stress exceeds the limit. Raises ValueError for a reliability outside
        (0, 1).
        """
        rest = math.log(_risk(reliability)) - finite("log_constant", log_constant)
        return _exp((rest - self.log_integral) / self.constants["weibull"])

    def _rows(self) -> Rows:
        rows = [("model", self.model.replace("_", "-"))]
        for name, value in self.constants.items():
            unit = {"limit": "Pa", "length": "m"}.get(name, "")
            rows.append((name.replace("_", " "), quantity(value, unit)))
        rows.append(("logarithm of the integral", f"{self.log_integral:.6g}"))
        rows.append(("share of the uppermost layer", f"{self.surface_share:.3g}"))
        return [*rows, ("stressed volume", f"{self.stressed_volume * 1e9:.4g} mm³")]


def life(
    field: FatigueField,
    model: str = "ioannides_harris",
    limit: float | ArrayLike = 0.0,
    exponent: float | None = None,
    depth_exponent: float | None = None,
    weibull: float | None = None,
    length: float = 1.0,
    stress_depth: float | None = None,
) -> Life:
    """Stress integral for the life in rolling contact, from the equivalent stress over a pass.

    The probability S of surviving N passes follows from ln(1/S) = A N^e I, where A is a material
    constant and e the Weibull slope. I is the integral of (stress - limit)^c / z^h over the volume
    in which the stress exceeds the limit, with the depth z (Ioannides and Harris). In Zaretsky's
    model the exponent is c e instead of c, and h = 0. Ratios of lives (`Life.relative_to`) do not
    depend on A and are therefore more reliable than lives; see the theory page "Life".

    Parameters
    ----------
    field : FatigueField
        Equivalent stress [Pa] from a function of `samcontact.fatigue`, with coordinates. Use
        `orthogonal_shear` for the model of Lundberg and Palmgren, and `dang_van` if residual stress
        matters.
    model : {"ioannides_harris", "zaretsky"}, optional
        Model of life.
    limit : float or array_like, optional
        Stress below which no crack starts [Pa], >= 0, for all points or one for each depth.
        Default: 0, the assumption of Lundberg and Palmgren.
    exponent : float, optional
        Stress exponent c, > 0. Default: 31/3 (Ioannides-Harris), 10 (Zaretsky).
    depth_exponent : float, optional
        Depth exponent h, >= 0. Default: 7/3; Zaretsky's model has none.
    weibull : float, optional
        Weibull slope e, > 0. Default: 10/9; Lundberg and Palmgren use 9/8 for line contact.
    length : float, optional
        Extent of the stressed volume along the axes that the field does not have, > 0. For a
        `steady_cycle` or a point contact: length of the raceway [m]. For a line contact, whose
        field has depths only: length times width of the raceway [m^2]. For states of a pass, whose
        field has all three axes: 1. Default: 1.
    stress_depth : float, optional
        Depth that replaces z in 1/z^h at all points [m], > 0, e.g. the depth of the largest stress,
        as in the formula of Lundberg and Palmgren. Default: depth of each point.

    Returns
    -------
    Life

    Raises
    ------
    ValueError
        The field has no depths, is not a stress, or has stress above the limit at depth 0 although
        h > 0; an argument is outside its range.
    TypeError
        An argument has the wrong type.

    Warns
    -----
    ResolutionWarning
        More than half of the integral is from the uppermost layer of points, because for h >= 1 the
        weight 1/z^h is not integrable at the surface. The result depends on the cell size.

    Notes
    -----
    E. Ioannides, T. A. Harris (1985), *J. Tribol.* 107, 367-377; E. V. Zaretsky (1987), *J.
    Propul. Power* 3, 76-83; G. Lundberg, A. Palmgren (1947), Acta Polytechnica 7.
    """
    require_type("field", field, FatigueField)
    if field.unit != "Pa" or "z" not in field.coordinates:
        raise ValueError(
            "field must be an equivalent stress [Pa] as a function of depth, got "
            f"{field.criterion} [{field.unit}] as a function of "
            f"{', '.join(field.coordinates) or 'points of a stress array'}"
        )
    constants = _constants(model, exponent, depth_exponent, weibull)
    power = constants["exponent"] * (constants["weibull"] if model == "zaretsky" else 1.0)
    z = field.coordinates["z"]
    bound = _limits(limit, z)
    excess = field.values - bound
    exposed = excess > 0
    weight = _volumes(field) * positive("length", length)
    at = z if stress_depth is None else np.full_like(z, positive("stress_depth", stress_depth))
    if constants["depth_exponent"] > 0 and exposed[..., at == 0].any():
        raise ValueError(
            "field must have no stress above the limit at the depth z = 0, where the weight z^-h "
            "is infinite: let the depths begin at half a cell, or set depth_exponent = 0"
        )
    logs = np.full(excess.shape, -np.inf)
    depths = np.broadcast_to(at, excess.shape)[exposed]
    logs[exposed] = (
        power * np.log(excess[exposed])
        - (constants["depth_exponent"] * np.log(depths) if constants["depth_exponent"] > 0 else 0.0)
        + np.log(weight[exposed])
    )
    top = float(logs.max())
    parts = np.exp(logs - top) if math.isfinite(top) else np.zeros_like(logs)
    total = float(parts.sum())
    share = float(parts[..., 0].sum()) / total if total > 0 and z.size > 1 else 0.0
    if share > _MAX_SHARE:
        warnings.warn(
            f"{share:.0%} of the stress integral is from the uppermost layer of points, so that "
            "the life depends on the thickness of this layer: use thinner layers and a smaller "
            "depth_exponent",
            ResolutionWarning,
            stacklevel=2,
        )
    kept = constants | {"limit": float(bound.max()), "length": float(length)}
    whole = top + math.log(total) if total > 0 else -math.inf
    return Life(
        model, field.criterion, FrozenDict(kept), whole, share, float(weight[exposed].sum())
    )


def _constants(model: Any, *given: float | None) -> dict[str, float]:
    model = choice("model", model, tuple(MODELS))
    names = ("exponent", "depth_exponent", "weibull")
    found = dict(MODELS[model])
    for name, value in zip(names, given, strict=True):
        if value is None:
            continue
        found[name] = (non_negative if name == "depth_exponent" else positive)(name, value)
        if found[name] > 100:
            raise ValueError(f"{name} must be at most 100, got {found[name]!r}")
    if model == "zaretsky" and found["depth_exponent"] != 0:
        raise ValueError('depth_exponent must be 0 or omitted with model = "zaretsky"')
    return found


def _limits(limit: float | ArrayLike, z: FloatArray) -> FloatArray:
    bound = real_array("limit", limit)
    if bound.ndim > 1 or (bound.ndim == 1 and bound.shape != z.shape):
        raise ValueError(f"limit must be one number for all, or one for each of {z.size} depths")
    if not (np.isfinite(bound) & (bound >= 0)).all():
        raise ValueError("limit must be finite and >= 0 [Pa]")
    return bound


def _volumes(field: FatigueField) -> FloatArray:
    """Return the volume that each point represents, divided by `length` (see `life`)."""
    weight: FloatArray = np.ones(())
    for axis, values in field.coordinates.items():
        weight = np.asarray(np.multiply.outer(weight, _extents(values, axis == "z")))
    return weight


def _extents(values: FloatArray, from_surface: bool) -> FloatArray:
    """Return the length along an axis that each point represents, up to half-way to others.

    from_surface: whether the first length starts at the surface, z = 0.
    """
    if values.size == 1:
        return np.array([2 * values[0] if from_surface and values[0] > 0 else 1.0])
    middles = (values[1:] + values[:-1]) / 2
    first = max(2 * values[0] - middles[0], 0.0) if from_surface else 2 * values[0] - middles[0]
    return np.diff(np.concatenate([[first], middles, [2 * values[-1] - middles[-1]]]))


def _risk(reliability: float) -> float:
    survivors = number("reliability", reliability)
    if not 0 < survivors < 1:
        raise ValueError(f"reliability must be in (0, 1), got {survivors!r}")
    return -math.log(survivors)


def _exp(power: float) -> float:
    return math.inf if power > 700 else math.exp(power)
