# SPDX-License-Identifier: GPL-3.0-or-later
"""Hardening curve from a tension or compression test: elastic line, true stress, plastic strain."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, boolean, non_negative, poisson_ratio, positive, real_array
from .depth_profiles import MAX_PROFILE_POINTS
from .noise import MAX_DEVIATIONS, merged, noise_of, non_decreasing

if TYPE_CHECKING:
    from typing_extensions import Self

_ELASTIC_PART = (0.1, 0.5)
"""Stresses between which the elastic line is fitted, as fractions of the yield stress."""
_MAX_ELASTIC_STRAIN = 0.1
"""Maximum ratio stress / E; a larger one means that the strain is in percent."""
_MIN_STRESS = 1e5
"""Minimum of the largest stress [Pa]; below it, the stress is probably in MPa or GPa."""


class FromTest:
    """Base class of `Material` that creates a material from a measured curve."""

    @classmethod
    def from_test(
        cls,
        strain: ArrayLike,
        stress: ArrayLike,
        engineering: bool = True,
        E: float | None = None,
        nu: float = 0.3,
        offset: float = 2e-4,
    ) -> Self:
        """Return a material with the hardening curve of a tension or compression test.

        Parameters
        ----------
        strain : array_like, shape (n,)
            Total strain [-], elastic part included, not in percent; increasing in tension. The
            values of a compression test are negative and decrease.
        stress : array_like, shape (n,)
            Stress [Pa] at each strain; negative in compression.
        engineering : bool, optional
            Whether the strain is the elongation over the initial length, and the stress the force
            over the initial area. If False, strain and stress are true values (logarithmic strain,
            force over the current area). Default: True.
        E : float, optional
            Young's modulus [Pa]. Default: slope of a line that is fitted by least squares to the
            curve between 10 and 50 % of the yield stress. The strain at which this line meets zero
            stress is subtracted from all strains. In a test without an extensometer, the strain
            includes the deformation of the machine, so the slope is too small: give E in this case.
            The plastic strain is then still the deviation of the curve from the fitted line, and
            therefore does not include the deformation of the machine.
        nu : float, optional
            Poisson's ratio, which the test does not measure. Default: 0.3.
        offset : float, optional
            Plastic strain at which yield begins [-], > 0 and below 0.05; 0.002 gives the usual
            proof stress. The curve beyond this strain is used as measured. Default: 2e-4, because
            the plastic strain of rolling contacts is often below 0.002.

        Returns
        -------
        Material
            Material with the law "tabulated". True strain is ln(1 + e) and true stress s (1 + e)
            for engineering values e and s; the plastic strain is true strain - true stress / E.
            Where noise makes plastic strain or stress decrease, a non-decreasing least-squares fit
            replaces the measured values.

        Raises
        ------
        ValueError
            The curve is not plausible: strain in percent, stress in MPa, necking, strain or stress
            that decreases by more than the noise of the curve, or too few points for the elastic
            line. E is not in Pa or is below the slope of the curve, or another argument is outside
            its range.
        TypeError
            An argument is not a number.
        """
        if (ratio := poisson_ratio("nu", nu)) >= 0.5:
            raise ValueError(f"nu must be < 0.5, got {ratio!r}")
        begin = non_negative("offset", offset)
        if not 0 < begin < 0.05:
            raise ValueError(f"offset must be a plastic strain in (0, 0.05), got {begin!r}")
        given_modulus = None if E is None else positive("E", E)
        e, s = _curve(strain, stress)
        if boolean("engineering", engineering):
            _require_no_neck(e, s)
        slope, start = _elastic_line(e, s, begin, given_modulus)
        modulus = slope if given_modulus is None else given_modulus
        _require_modulus(modulus, slope)
        _require_no_percent(e, s, modulus, given_modulus is not None)
        e = e - start - s * (1 / slope - 1 / modulus)  # without the deformation of the machine
        if engineering:
            s, e = s * (1 + e), np.log1p(e)
        sign = np.sign(e[-1] - e[0])
        plastic, true = _hardening(sign * e, sign * s, modulus, begin)
        made: Any = cls
        return cast("Self", made.tabulated(modulus, ratio, plastic, true))


def _curve(strain: ArrayLike, stress: ArrayLike) -> tuple[FloatArray, FloatArray]:
    e, s = real_array("strain", strain), real_array("stress", stress)
    if e.ndim != 1 or e.shape != s.shape or e.size < 4:
        raise ValueError(
            "strain and stress must be lists of the same length, at least 4, got shapes "
            f"{e.shape} and {s.shape}"
        )
    if not (np.isfinite(e).all() and np.isfinite(s).all()):
        raise ValueError("strain and stress must be finite, got NaN or inf")
    largest = float(np.abs(s).max())
    if largest < _MIN_STRESS:
        raise ValueError(
            f"stress must be in Pa, got values up to {largest:g}: multiply MPa by 1e6, GPa by 1e9"
        )
    if float(np.abs(e).max()) > 2.0:
        raise ValueError(
            f"strain must be dimensionless, got values up to {np.abs(e).max():g}: divide strains "
            "in percent by 100"
        )
    sign = 1.0 if e[-1] >= e[0] else -1.0
    fitted = non_decreasing(sign * e)
    index = np.arange(e.size, dtype=np.float64)
    wrong = np.abs(fitted - sign * e) > MAX_DEVIATIONS * noise_of(index, e)
    if wrong.any():
        i = int((np.diff(sign * e) <= 0).argmax())
        raise ValueError(
            f"strain must either only increase or only decrease, got strain[{i + 1}] = "
            f"{e[i + 1]:g} after strain[{i}] = {e[i]:g}: omit unloading"
        )
    strains, s = merged(fitted, s)
    e = sign * strains
    if e.size < 4:
        raise ValueError(f"strain must have at least 4 different values, got {e.size}")
    if sign * s[np.abs(s).argmax()] < 0:
        raise ValueError(
            "strain and stress must have equal signs: positive in tension, negative in compression"
        )
    if sign < 0 and e.min() <= -1:
        raise ValueError(f"strain must be > -1 in compression, got {e.min():g}")
    return e, s


def _require_no_neck(e: FloatArray, s: FloatArray) -> None:
    """Raise ValueError if the force of a tension test decreases after its maximum."""
    top = int(s.argmax())
    noise = MAX_DEVIATIONS * noise_of(e, s)
    if e[-1] > e[0] and s[-1] < (1 - 1e-3) * s[top] - noise:
        raise ValueError(
            f"stress must not decrease at the end, but falls from {s[top]:g} Pa at a strain of "
            f"{e[top]:g} to {s[-1]:g} Pa: the specimen necks, and the strain in the neck is "
            f"unknown; use the first {top + 1} points, or engineering=False if stress is the true "
            "stress"
        )


def _elastic_line(
    e: FloatArray, s: FloatArray, offset: float, modulus: float | None
) -> tuple[float, float]:
    """Return the slope [Pa] of the elastic line and the strain at which it meets zero stress.

    modulus: slope [Pa] of a line through the origin, which is returned if the curve has too few
    points in the elastic range. With None, such a curve raises ValueError.
    """
    size, along = np.abs(s), np.sign(e[-1] - e[0])
    limit, found = 0.5 * float(size.max()), (0.0, 0.0)
    for _ in range(20):
        first = int((size > limit).argmax()) if (size > limit).any() else size.size
        inside = np.flatnonzero(
            (size[:first] >= _ELASTIC_PART[0] * limit) & (size[:first] <= _ELASTIC_PART[1] * limit)
        )
        if inside.size < 3 and modulus is not None:
            return modulus, 0.0
        if inside.size < 3:
            raise ValueError(
                f"E is required, because fewer than 3 points of the curve lie between "
                f"{_ELASTIC_PART[0]:.0%} and {_ELASTIC_PART[1]:.0%} of the yield stress, too few "
                "to fit the elastic line"
            )
        slope, level = np.polyfit(e[inside], s[inside], 1)
        if not slope > 0:
            raise ValueError(
                "stress must increase with strain at the beginning of the curve, got a slope of "
                f"{slope:.3g} Pa"
            )
        last, found = found, (float(slope), float(-level / slope))
        if abs(found[0] / (last[0] or np.inf) - 1) < 1e-9:
            break
        elastic = np.flatnonzero(along * (e - found[1]) - size / found[0] <= offset)
        limit = float(size[elastic[-1]]) if elastic.size else limit
    return found


def _require_modulus(modulus: float, slope: float) -> None:
    """Raise ValueError for a modulus that is not in Pa, or below the slope of the curve [Pa]."""
    if modulus < 1e-3 * slope:
        raise ValueError(
            f"E must be in Pa, got {modulus:g}, but the slope of the curve is {slope:.3g} Pa: "
            "multiply GPa by 1e9"
        )
    if modulus < 0.9 * slope:
        raise ValueError(
            f"E must not be below the slope of the curve, {slope:.3g} Pa, got {modulus:g} Pa: the "
            "deformation of the testing machine can only make the slope smaller than E"
        )


def _require_no_percent(e: FloatArray, s: FloatArray, modulus: float, given: bool) -> None:
    """Raise ValueError if the strain is probably in percent."""
    top = float(np.abs(s).max())
    slopes = np.abs(np.diff(s)) / np.abs(np.diff(e))
    early = float(slopes[np.abs(s[1:]) < 0.6 * top].max(initial=0.0)) or float(slopes.max())
    if top / modulus > _MAX_ELASTIC_STRAIN or (given and early < 0.05 * modulus):
        raise ValueError(
            f"strain must be dimensionless, but the initial slope of the curve, {early:.3g} Pa, is "
            f"too small for stresses up to {top:.3g} Pa"
            f"{f' and E = {modulus:.3g} Pa' if given else ''}: divide strains in percent by 100"
        )


def _hardening(
    e: FloatArray, s: FloatArray, modulus: float, offset: float
) -> tuple[FloatArray, FloatArray]:
    """Return plastic strains, the first of them 0, and the true stress [Pa] at each strain.

    The stress is constant up to the plastic strain `offset`.
    """
    noise = noise_of(e, s)
    raw = e - s / modulus
    if not (raw > offset).any():
        raise ValueError(
            f"strain must exceed the elastic strain by more than offset = {offset:g}, got at most "
            f"{raw.max():.3g}: the specimen does not yield; use Material.elastic, or check E"
        )
    plastic = non_decreasing(raw)
    first = min(int((plastic > offset).argmax()), int((raw > offset).argmax()))
    first += int((plastic[first:] > offset).argmax())
    yields = float(s[0])
    if first > 0:
        yields = float(np.interp(offset, plastic[first - 1 : first + 1], s[first - 1 : first + 1]))
    _require_noise(
        "plastic strain", plastic[first:] - raw[first:], noise / modulus, raw[first:], s[first:]
    )
    beyond, stress = merged(plastic[first:], s[first:])
    x = np.concatenate([[0.0, offset], beyond])
    y = np.concatenate([[yields, yields], stress])
    fitted = non_decreasing(y)
    _require_noise("true stress", fitted - y, max(noise, 1e-12 * float(y.max())), x, y)
    y = fitted
    if x.size > MAX_PROFILE_POINTS:
        chosen = np.unique(np.linspace(0, x.size - 1, MAX_PROFILE_POINTS).round().astype(int))
        x, y = x[chosen], y[chosen]
    return x, y


def _require_noise(
    name: str, changes: FloatArray, noise: float, plastic: FloatArray, stress: FloatArray
) -> None:
    """Raise ValueError if a fit changes a curve by more than its noise.

    The message states the point of the curve with the largest change.
    """
    worst = int(np.abs(changes).argmax())
    if abs(changes[worst]) > MAX_DEVIATIONS * noise:
        raise ValueError(
            f"{name} must not decrease after yield by more than the noise of the curve, but it "
            f"does at a plastic strain of {plastic[worst]:.4g} and a stress of "
            f"{stress[worst]:.4g} Pa: smooth the curve there, omit an upper yield point, or check E"
        )
