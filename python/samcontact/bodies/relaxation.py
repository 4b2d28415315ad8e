# SPDX-License-Identifier: GPL-3.0-or-later
"""Relaxation of viscoelastic materials (Prony series): moduli, creep, fit to dynamic tests."""

from __future__ import annotations

import math
import warnings
from dataclasses import replace
from typing import TYPE_CHECKING, Any, cast

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, finite_array, integer, poisson_ratio, real_array
from .._util.lazy_scipy import scipy
from .._util.short_text import in_short
from .constants import as_list

if TYPE_CHECKING:
    from collections.abc import Callable

    from typing_extensions import Self

RelaxationTerms = tuple[tuple[float, ...], tuple[float, ...]]
"""Increasing relaxation times [s], and the share of the instantaneous modulus for each time [-]."""

MAX_TERMS = 64
_ROUNDING = 1e-12
"""A long-time share below this value is a rounding error of the sum of the shares."""
_MAX_TIME = 1e15
"""Longest relaxation time [s]."""
_NEGLIGIBLE = 1e-9
"""A fitted share below this value counts as a rounding error."""
_POOR_FIT = 0.05
"""Largest relative error of a fitted complex modulus that does not cause a warning."""


def long_time_share(terms: RelaxationTerms) -> float:
    """Return the share of the instantaneous modulus that does not relax; 0 for a fluid."""
    rest = 1.0 - math.fsum(terms[1])
    return rest if rest > _ROUNDING else 0.0


def checked_relaxation(given: Any) -> RelaxationTerms:
    """Check relaxation times and shares, and return them in the order of increasing times."""
    if not isinstance(given, (list, tuple)) or len(given) != 2:
        raise ValueError(f"relaxation_terms must be (times, shares), got {in_short(given)}")
    times, shares = (
        finite_array(name, as_list(values))
        for name, values in zip(("times", "shares"), given, strict=True)
    )
    if times.ndim != 1 or times.shape != shares.shape or times.size == 0:
        raise ValueError(
            "times and shares must be lists of the same length >= 1, got shapes "
            f"{times.shape} and {shares.shape}"
        )
    if times.size > MAX_TERMS:
        raise ValueError(f"times must have at most {MAX_TERMS} values, got {times.size}")
    for value in times[(times <= 0) | (times > _MAX_TIME)]:
        raise ValueError(f"times must be > 0 and <= {_MAX_TIME:g} s, got {float(value)!r}")
    for value in shares[shares <= 0]:
        raise ValueError(f"shares must be > 0, got {float(value)!r}: omit terms with share 0")
    order = np.argsort(times)
    times, shares = times[order], shares[order]
    same = np.flatnonzero(np.diff(times) <= 0)
    if same.size:
        raise ValueError(
            f"times must all be different, got {float(times[same[0]])!r} twice: give it once, with "
            "the sum of the shares"
        )
    total = math.fsum(shares)
    if total > 1.0 + _ROUNDING:
        remedy = "divide percent by 100" if total > 2 else "each share is a part of E at time 0"
        raise ValueError(f"the sum of shares must be <= 1, got {total!r}: {remedy}")
    return tuple(times.tolist()), tuple(shares.tolist())


def _relaxation(terms: RelaxationTerms, t: FloatArray) -> FloatArray:
    decay = np.exp(-t[..., None] / np.asarray(terms[0]))
    ratio: FloatArray = long_time_share(terms) + decay @ np.asarray(terms[1])
    return ratio


def complex_ratio(terms: RelaxationTerms, omega: FloatArray) -> Any:
    """Return complex modulus/instantaneous modulus [-] at angular frequencies omega [rad/s]."""
    x = omega[..., None] * np.asarray(terms[0])
    with np.errstate(divide="ignore", over="ignore"):
        loss, stored = 1.0 / (x + 1.0 / x), 1.0 / (1.0 + 1.0 / x**2)
    shares = np.asarray(terms[1])
    return long_time_share(terms) + stored @ shares + 1j * (loss @ shares)


def creep_terms(terms: RelaxationTerms) -> tuple[FloatArray, FloatArray, float]:
    """Return the terms of the creep function J(t) = 1 + sum J_j (1 - exp(-t/theta_j)) + rate t.

    There is one retardation time theta between neighbouring relaxation times tau_i and, in a solid,
    one above the longest. Each is a root of r_inf = sum r_i tau_i/(theta - tau_i), with the shares
    r_i and the long-time share r_inf. It is found by bisection in log(theta/tau_i).

    Returns
    -------
    shares, times : ndarray, shape (n,)
        J_j [-] and theta_j [s]; n is the number of relaxation times, or one less for a fluid.
    rate : float
        Rate of flow of a fluid [1/s]; 0 for a solid.
    """
    tau, r = (np.asarray(values) for values in terms)
    rest = long_time_share(terms)
    flow = float(r @ tau)
    # theta - tau = tau_k expm1(m) + (tau_k - tau): no cancellation close to the pole tau_k
    apart = tau[:, None] - tau
    last = math.log1p(2.0 + 2.0 * flow / (rest * tau[-1])) if rest > 0 else None
    count = tau.size if last is not None else tau.size - 1
    high = np.append(np.log(tau[1:] / tau[:-1]), last or 0.0)[:count]
    low = np.zeros(count)
    for _ in range(200):
        middle = 0.5 * (low + high)
        beyond = tau[:count, None] * np.expm1(middle)[:, None] + apart[:count]
        with np.errstate(divide="ignore", over="ignore"):
            below = rest - (r * tau / beyond).sum(axis=1) < 0
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    beyond = tau[:count, None] * np.expm1(high)[:, None] + apart[:count]
    theta = tau[:count] * np.exp(high)
    slopes = (r * tau * (theta[:, None] / beyond) ** 2).sum(axis=1)
    return theta / slopes, theta, 1.0 / flow if rest == 0 else 0.0


def _creep(terms: RelaxationTerms, t: FloatArray) -> FloatArray:
    shares, times, rate = creep_terms(terms)
    grown: FloatArray = -np.expm1(-t[..., None] / times) @ shares
    return 1.0 + grown + (rate * t if rate > 0 else 0.0)


class HasRelaxation:
    """Base class of `Material` with viscoelastic relaxation."""

    relaxation_terms: RelaxationTerms | None
    E: Any

    def with_relaxation(self, times: ArrayLike, shares: ArrayLike) -> Self:
        """Return a copy that is linearly viscoelastic, by a generalised Maxwell model.

        After a step of strain, the modulus is E(t) = E (1 - sum(shares) + sum(shares
        exp(-t/times))). Young's modulus E of the material is therefore the instantaneous modulus,
        which applies under fast loads. Poisson's ratio is assumed to be constant, whereas in rubber
        and other polymers the bulk modulus is constant. For these materials, use the long-time
        Poisson's ratio. The relative error of a normal contact is then about 1e-3 if the bulk
        modulus is 1000 times the instantaneous shear modulus, but 9 % at short times if it is only
        10 times the instantaneous shear modulus.

        Parameters
        ----------
        times : array_like, shape (n,)
            Relaxation times [s], > 0, all different, at most 64.
        shares : array_like, shape (n,)
            Share of E that relaxes with each relaxation time [-], > 0; the sum of all shares is at
            most 1. With a sum of 1 the material is a fluid, which flows without limit under a
            constant load.

        Returns
        -------
        Material
            Material with these terms in place of earlier ones. Each increment of a simulation then
            requires a duration.

        Raises
        ------
        ValueError
            The material is rigid or plastic, times and shares differ in length, or a value is
            outside its range.
        TypeError
            A value is not a number.
        """
        return cast(
            "Self", replace(cast("Any", self), relaxation_terms=(as_list(times), as_list(shares)))
        )

    @classmethod
    def from_dynamic(
        cls,
        omega: ArrayLike,
        storage: ArrayLike,
        loss: ArrayLike,
        terms: int,
        nu: float = 0.4,
    ) -> Self:
        """Return a viscoelastic material fitted to the moduli of a dynamic test.

        The relaxation times form a geometric sequence, from 1/omega of the fastest oscillation to
        1/omega of the slowest. The modulus that belongs to each relaxation time is found by
        non-negative least squares, in which each difference between fitted and measured modulus is
        divided by the magnitude of the measured complex modulus. Relaxation times whose modulus is
        0 are omitted.

        Parameters
        ----------
        omega : array_like, shape (n,)
            Angular frequencies [rad/s], > 0: 2 pi times the frequencies in Hz.
        storage, loss : array_like, shape (n,)
            Storage and loss part of Young's modulus [Pa]. Multiply moduli measured in shear by
            2 (1 + nu).
        terms : int
            Number of relaxation times, 1 to 64; about one per decade is usual.
        nu : float, optional
            Poisson's ratio, which the test does not measure. Default: 0.4.

        Returns
        -------
        Material
            Viscoelastic material as from `Material.elastic` and `with_relaxation`; its E is the
            fitted instantaneous modulus.

        Raises
        ------
        ValueError
            The arrays differ in shape, a value is outside its range, or the fitted material does
            not relax.
        TypeError
            An argument is not a number.

        Warns
        -----
        UserWarning
            The fit differs from a measured complex modulus by more than 5 %.
        """
        w, measured = _dynamic_moduli(omega, storage, loss)
        if (ratio := poisson_ratio("nu", nu)) >= 0.5:
            raise ValueError(f"nu must be < 0.5, got {ratio!r}")
        count = integer("terms", terms, 1)
        if count > MAX_TERMS:
            raise ValueError(f"terms must be <= {MAX_TERMS}, got {count}")
        rest, times, moduli = _fitted(w, measured, count)
        E = rest + float(moduli.sum())
        made: Any = cls
        return cast("Self", made.elastic(E, ratio).with_relaxation(times, moduli / E))

    def relaxation(self, t: ArrayLike) -> float | FloatArray:
        """Return the modulus divided by E [-] at a time t >= 0 [s] after a step of strain.

        The result has the shape of t and decreases from 1 to the long-time share, which is 1
        without relaxation. Raises ValueError if t is negative or NaN.
        """
        return self._over("t", t, _relaxation, 1.0)

    def creep(self, t: ArrayLike) -> float | FloatArray:
        """Return strain/(instantaneous strain) [-] at a time t >= 0 [s] after a step of the load.

        The result has the shape of t and increases from 1; it is 1 without relaxation. Raises
        ValueError if t is negative or NaN.
        """
        return self._over("t", t, _creep, 1.0)

    def storage(self, omega: ArrayLike) -> float | FloatArray:
        """Return the storage modulus [Pa] at an angular frequency omega >= 0 [rad/s].

        The result has the shape of omega. Raises ValueError if omega is negative or NaN.
        """
        return self._over("omega", omega, lambda terms, w: self.E * complex_ratio(terms, w).real)

    def loss(self, omega: ArrayLike) -> float | FloatArray:
        """Return the loss modulus [Pa] at an angular frequency omega >= 0 [rad/s].

        The result has the shape of omega; it is 0 without relaxation. Raises ValueError if omega
        is negative or NaN.
        """
        return self._over(
            "omega", omega, lambda terms, w: self.E * complex_ratio(terms, w).imag, 0.0
        )

    def _over(
        self,
        name: str,
        given: ArrayLike,
        function: Callable[[RelaxationTerms, FloatArray], FloatArray],
        elastic: float | None = None,
    ) -> float | FloatArray:
        values = real_array(name, given)
        bad = ~(values >= 0)
        if bad.any():
            raise ValueError(f"{name} must be >= 0, got {float(values[bad].flat[0])!r}")
        if self.relaxation_terms is None:
            out = np.full(values.shape, self.E if elastic is None else elastic)
        else:
            out = np.asarray(function(self.relaxation_terms, values))
        return float(out) if values.ndim == 0 else out


def _dynamic_moduli(omega: ArrayLike, storage: ArrayLike, loss: ArrayLike) -> tuple[Any, Any]:
    w, stored, lost = (
        finite_array(name, values)
        for name, values in (("omega", omega), ("storage", storage), ("loss", loss))
    )
    if w.ndim != 1 or not (w.shape == stored.shape == lost.shape) or w.size < 2:
        raise ValueError(
            "omega, storage and loss must be lists of the same length >= 2, got shapes "
            f"{w.shape}, {stored.shape} and {lost.shape}"
        )
    for name, values in (("omega", w), ("storage", stored)):
        if not (values > 0).all():
            raise ValueError(f"{name} must be > 0, got {float(values.min())!r}")
    if not (lost >= 0).all():
        raise ValueError(f"loss must be >= 0, got {float(lost.min())!r}")
    return w, stored + 1j * lost


def _fitted(omega: FloatArray, measured: Any, count: int) -> tuple[float, FloatArray, FloatArray]:
    """Return the long-time modulus [Pa], the relaxation times [s] and the modulus of each [Pa]."""
    first, last = -math.log(omega.max()), -math.log(omega.min())
    times = np.exp(np.linspace(first, last, count) if count > 1 else [0.5 * (first + last)])
    x = 1j * omega[:, None] * times
    columns = np.column_stack([np.ones(omega.size), x / (1 + x)]) / np.abs(measured)[:, None]
    target = measured / np.abs(measured)
    found, _ = scipy.optimize.nnls(
        np.vstack([columns.real, columns.imag]), np.concatenate([target.real, target.imag])
    )
    worst = float(np.abs(columns @ found - target).max())
    if worst > _POOR_FIT:
        warnings.warn(
            f"the fit with {count} terms differs from the measured modulus by up to "
            f"{100 * worst:.0f} %: use more terms",
            UserWarning,
            stacklevel=3,
        )
    used = found[1:] > _NEGLIGIBLE * found.sum()
    if not used.any():
        raise ValueError(
            "loss must be large enough for a viscoelastic fit, got values that fit an elastic "
            "material: use Material.elastic, or check loss"
        )
    return float(found[0]), times[used], found[1:][used]
