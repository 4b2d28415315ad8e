# SPDX-License-Identifier: GPL-3.0-or-later
"""Fatigue criteria, evaluated at each point of a body over a stress cycle."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .. import _core
from .._util.checks import FloatArray, choice, non_negative, positive, require_type
from .._util.frozen import FrozenDict, read_only
from .._util.short_text import in_short
from .._util.tensors import von_mises
from ..bodies.layered import matrix_of
from ..bodies.layers import Layered
from ..bodies.material import Material
from ..diagnostics.plausibility import strength, warn_if_implausible
from ..solutions.state import State
from .cycle import Cycle, blocks, cycle, has_plastic_strain, plastic_strain_in, stress_in
from .field import FatigueField

__all__ = [
    "crossland",
    "dang_van",
    "fatemi_socie",
    "findley",
    "max_von_mises",
    "orthogonal_shear",
]

_MAX_SLOPE = 10.0
"""Maximum weight of the normal stress in a criterion. For metals, weights are pure numbers below 1;
a value above the maximum is probably a stress."""

Block = Callable[[slice], tuple[FloatArray, FloatArray | None]]


def dang_van(
    states: Cycle | Sequence[State] | ArrayLike, body: int | None = None, slope: float | None = None
) -> FatigueField:
    """Dang Van's criterion: maximum over the cycle of shear stress + slope * mean normal stress.

    Parameters
    ----------
    states : Cycle, sequence of State, or array_like of shape (n, 6, ...)
        Stress history, see `cycle`. For steady rolling, use `steady_cycle`.
    body : {1, 2}, optional
        Body of the states. Default: 2.
    slope : float
        Weight of the mean normal stress sigma_h, in [0, 10] [-]. Use 3 (t/f - 1/2), where t and f
        are the fatigue limits in torsion and in bending. The limit of the criterion is then t.

    Returns
    -------
    FatigueField
        Equivalent shear stress [Pa].

    Raises
    ------
    ValueError, TypeError
        The slope is missing or outside its range, or the stress history is invalid (see `cycle`).

    Notes
    -----
    The shear stress is Tresca's: half the difference between the largest and the smallest principal
    value of s(t) - s*, where s(t) is the stress deviator. s* is the residual stress deviator after
    elastic shakedown of the grains; it is the centre of the smallest ball that contains the path of
    s(t), in the norm sqrt(s:s). The ball is computed exactly. K. Dang Van, B. Griveau, O. Message
    (1989), *Biaxial and Multiaxial Fatigue*, EGF 3, 479-496; P. Ballard et al. (1995),
    doi:10.1111/j.1460-2695.1995.tb00886.x.
    """
    number = _slope("slope", slope)
    return _scalar("dang_van", {"slope": number}, states, body,
                   lambda stress: _core.fatigue.dang_van(stress, number))  # fmt: skip


def crossland(
    states: Cycle | Sequence[State] | ArrayLike, body: int | None = None, slope: float | None = None
) -> FatigueField:
    """Crossland's criterion: shear stress amplitude + slope * maximum mean normal stress.

    Parameters
    ----------
    states, body
        As for `dang_van`.
    slope : float
        Weight of the mean normal stress, in [0, 10] [-]. Use 3 t/f - sqrt(3), where t and f are the
        fatigue limits in torsion and in bending. The limit of the criterion is then t.

    Returns
    -------
    FatigueField
        Equivalent shear stress [Pa].

    Raises
    ------
    ValueError, TypeError
        The slope is missing or outside its range, or the stress history is invalid (see `cycle`).

    Notes
    -----
    The shear stress amplitude sqrt(J2,a) is the radius of the smallest ball that contains the path
    of the stress deviator s, in the norm sqrt(s:s/2). B. Crossland (1956), *Proc. Int. Conf. on
    Fatigue of Metals*, 138-149; I. V. Papadopoulos et al. (1997), *Int. J. Fatigue* 19, 219-235.
    """
    number = _slope("slope", slope)
    return _scalar("crossland", {"slope": number}, states, body,
                   lambda stress: _core.fatigue.crossland(stress, number))  # fmt: skip


def orthogonal_shear(
    states: Cycle | Sequence[State] | ArrayLike, body: int | None = None, axis: str = "x"
) -> FatigueField:
    """Amplitude (half the range in a cycle) of the shear stress on planes parallel to the surface.

    Parameters
    ----------
    states, body
        As for `dang_van`.
    axis : {"x", "y"}, optional
        Direction of the shear stress; normally the rolling direction.

    Returns
    -------
    FatigueField
        Shear stress amplitude [Pa], the tau_0 of G. Lundberg and A. Palmgren (1947), Acta
        Polytechnica 7, on which the life of rolling bearings is based.

    Raises
    ------
    ValueError, TypeError
        The stress history is invalid (see `cycle`), or the axis is unknown.
    """
    component = {"x": 4, "y": 3}[choice("axis", axis, ("x", "y"))]

    def half_range(stress: FloatArray) -> FloatArray:
        shear = stress[:, component]
        return np.asarray((shear.max(axis=0) - shear.min(axis=0)) / 2)

    return _scalar("orthogonal_shear", {"axis": axis}, states, body, half_range)


def max_von_mises(
    states: Cycle | Sequence[State] | ArrayLike, body: int | None = None
) -> FatigueField:
    """Maximum von Mises stress over the cycle, to be compared with the yield stress.

    Parameters
    ----------
    states, body
        As for `dang_van`.

    Returns
    -------
    FatigueField
        Von Mises stress [Pa].

    Raises
    ------
    ValueError, TypeError
        The stress history is invalid (see `cycle`).
    """

    def maximum(stress: FloatArray) -> FloatArray:
        return np.asarray(von_mises(np.moveaxis(stress, 1, 0)).max(axis=0))

    return _scalar("max_von_mises", {}, states, body, maximum)


def findley(
    states: Cycle | Sequence[State] | ArrayLike, body: int | None = None, k: float | None = None
) -> FatigueField:
    """Findley's criterion: maximum over all planes of shear amplitude + k * normal stress.

    Parameters
    ----------
    states, body
        As for `dang_van`.
    k : float
        Weight of the normal stress, in [0, 10] [-]; 0.2 to 0.4 for ductile metals. The criterion
        uses the maximum normal stress on each plane in the cycle.

    Returns
    -------
    FatigueField
        Equivalent shear stress [Pa], with the normal of the critical plane at each point.

    Raises
    ------
    ValueError, TypeError
        k is missing or outside its range, or the stress history is invalid (see `cycle`).

    Notes
    -----
    The shear amplitude is the radius of the smallest circle that contains the path of the shear
    stress in the plane. The search evaluates planes 11 degrees apart and then finds the local
    maxima next to the best of these planes. The result is less than 0.11 % below the true maximum
    in 99 of 100 points, and never more than 1 % below it (theory page). W. N. Findley (1959), *J.
    Eng. Ind.* 81, 301-305.
    """
    number = _slope("k", k)

    def at(cycle: Cycle, block: slice) -> tuple[FloatArray, FloatArray]:
        return _core.fatigue.findley(stress_in(cycle, block), number)

    return _over_blocks("findley", {"k": number}, "Pa", _as_cycle(states, body), 1, at)


def fatemi_socie(
    states: Cycle | Sequence[State] | ArrayLike,
    body: int | None = None,
    k: float | None = None,
    yield_stress: float | None = None,
    material: Material | None = None,
) -> FatigueField:
    """Fatemi and Socie's criterion: shear strain amplitude weighted by the normal stress.

    Parameters
    ----------
    states, body
        As for `dang_van`.
    k : float
        Weight of the normal stress, in [0, 10] [-]; 0.3 to 1 for metals. The criterion uses the
        maximum normal stress on each plane in the cycle.
    yield_stress : float, optional
        Yield stress by which the normal stress is divided [Pa], > 0. Default: initial yield stress
        of the body.
    material : Material, optional
        Material whose elastic constants convert stress to strain. Default: material of the body. A
        stress array requires both `yield_stress` and `material`.

    Returns
    -------
    FatigueField
        Damage parameter [-], with the normal of the critical plane at each point.

    Raises
    ------
    ValueError, TypeError
        k is missing or outside its range, the yield stress or the material is neither given nor
        known from the body, or the stress history is invalid (see `cycle`).

    Notes
    -----
    The value is the maximum of gamma_a (1 + k sigma_n,max/yield stress) over all planes, where
    sigma_n,max is the maximum normal stress on the plane. gamma_a, called gamma_max/2 in the
    source, is the radius of the smallest circle that contains the path of the engineering shear
    strain in the plane. This strain is the sum of elastic and plastic strain; plastic strain that
    is constant in the cycle has no effect. A negative normal stress reduces the value, but not
    below 0. Planes are searched as in `findley`. A. Fatemi, D. F. Socie (1988),
    doi:10.1111/j.1460-2695.1988.tb01169.x.
    """
    number = _slope("k", k)
    given = _as_cycle(states, body)
    moduli, limit = _elasticity(given, material), _yield_stress(given, material, yield_stress)

    def at(cycle: Cycle, block: slice) -> tuple[FloatArray, FloatArray]:
        stress = stress_in(cycle, block)
        layers = block.stop - block.start
        halved = 0.5 / np.broadcast_to(moduli, cycle.points_shape[-1:])[block]
        shear = stress * np.repeat(halved, stress.shape[2] // layers)
        if has_plastic_strain(cycle):
            shear += plastic_strain_in(cycle, block)
        return _core.fatigue.fatemi_socie(shear, stress, number / limit)

    parameters = {"k": number, "yield_stress": limit}
    return _over_blocks("fatemi_socie", parameters, "-", given, 3, at)


def _slope(name: str, value: Any) -> float:
    if value is None:
        raise TypeError(
            f"{name} is required: give the value for the material (see the documentation "
            "of the criterion)"
        )
    found = non_negative(name, value)
    if found > _MAX_SLOPE:
        raise ValueError(
            f"{name} must be in [0, {_MAX_SLOPE:g}], got {found!r}: it is a dimensionless weight; "
            "pass a fatigue limit in Pa to FatigueField.margin()"
        )
    return found


def _as_cycle(states: Cycle | Sequence[State] | ArrayLike, body: int | None) -> Cycle:
    if not isinstance(states, Cycle):
        return cycle(states, body)
    if body is not None:
        raise ValueError(
            f"body must be omitted with a Cycle, got {in_short(body)}: pass body to the function "
            "`cycle` that creates the Cycle"
        )
    return states


def _scalar(
    criterion: str,
    parameters: dict[str, Any],
    states: Cycle | Sequence[State] | ArrayLike,
    body: int | None,
    of_stress: Callable[[FloatArray], FloatArray],
) -> FatigueField:
    def at(cycle: Cycle, block: slice) -> tuple[FloatArray, None]:
        return of_stress(stress_in(cycle, block)), None

    return _over_blocks(criterion, parameters, "Pa", _as_cycle(states, body), 1, at)


def _over_blocks(
    criterion: str,
    parameters: dict[str, Any],
    unit: str,
    given: Cycle,
    fields: int,
    at: Callable[[Cycle, slice], tuple[FloatArray, FloatArray | None]],
) -> FatigueField:
    """Evaluate a criterion for one block of points after another, to limit the memory used.

    fields: number of tensor fields of one block that the criterion holds in memory at a time.
    """
    values = np.empty(given.points_shape)
    normals: FloatArray | None = None
    for block in blocks(given, fields):
        found, planes = at(given, block)
        shape = (block.stop - block.start, *given.points_shape[:-1])
        values[..., block] = np.moveaxis(found.reshape(shape), 0, -1)
        if planes is not None:
            normals = np.empty((3, *given.points_shape)) if normals is None else normals
            normals[..., block] = np.moveaxis(planes.reshape(3, *shape), 1, -1)
    if normals is not None:
        read_only(normals)
    return FatigueField(
        criterion,
        FrozenDict(parameters),
        read_only(values),
        unit,
        given.coordinates,
        given.moments,
        normals,
    )


def _elasticity(given: Cycle, material: Material | None) -> FloatArray:
    """Return the shear modulus [Pa], one value for each depth or one for all points."""
    if material is not None:
        require_type("material", material, Material)
        if material.is_rigid:
            raise ValueError("material must not be rigid: a rigid body has no strain")
    body = material if material is not None else given.body
    if body is None:
        raise TypeError("material is required to compute the strain from a stress array")
    body = matrix_of(body)
    if isinstance(body, Layered):
        layer = np.searchsorted(body.interfaces, given.coordinates["z"], side="right")
        E, nu = (np.asarray(body.parameters[name])[layer] for name in ("E", "nu"))
    else:
        E, nu = np.array([body.E]), np.array([body.nu])
    return np.asarray(E / (2 * (1 + nu)), dtype=np.float64)


def _yield_stress(given: Cycle, material: Material | None, given_stress: float | None) -> float:
    if given_stress is not None:
        checked = positive("yield_stress", given_stress)
        warn_if_implausible(strength("yield_stress", checked), stacklevel=4)
        return checked
    body = material if material is not None else given.body
    assert body is not None  # checked by _elasticity
    if not body.is_plastic:
        raise ValueError("yield_stress is required [Pa], because the material does not yield")
    return float(body.min_yield_stress)
