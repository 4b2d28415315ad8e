# SPDX-License-Identifier: GPL-3.0-or-later
"""Minimum of a function of one variable on an interval, without the import time of SciPy."""

from __future__ import annotations

import math
from collections.abc import Callable

_GOLDEN = 0.5 * (3.0 - math.sqrt(5.0))
_ROUNDING = math.sqrt(2.2e-16)
_MAX_CALLS = 500


def bounded_minimum(
    function: Callable[[float], float], low: float, high: float, tolerance: float
) -> tuple[float, float]:
    """Return position and value of the minimum of a unimodal function on [low, high].

    The method uses golden sections and parabolas (Brent 1973, Algorithms for Minimization without
    Derivatives, chapter 5). All digits of the result equal those of
    `scipy.optimize.minimize_scalar` with method "bounded".

    tolerance: absolute error of the position.
    """
    best = second = third = low + _GOLDEN * (high - low)
    f_best = f_second = f_third = function(best)
    step = before = 0.0
    for _ in range(_MAX_CALLS - 1):
        middle = 0.5 * (low + high)
        least = _ROUNDING * abs(best) + tolerance / 3.0
        if abs(best - middle) <= 2.0 * least - 0.5 * (high - low):
            break
        parabolic = None
        if abs(before) > least:
            r = (best - second) * (f_best - f_third)
            q = (best - third) * (f_best - f_second)
            p = (best - third) * q - (best - second) * r
            q = 2.0 * (q - r)
            p, q = (-p if q > 0.0 else p), abs(q)
            halved, before = abs(0.5 * q * before), step
            if abs(p) < halved and q * (low - best) < p < q * (high - best):
                parabolic = p / q
                ahead = best + parabolic
                if ahead - low < 2.0 * least or high - ahead < 2.0 * least:
                    parabolic = math.copysign(least, middle - best)
        if parabolic is None:
            before = (low if best >= middle else high) - best
        step = _GOLDEN * before if parabolic is None else parabolic
        new = best + math.copysign(max(abs(step), least), step)
        f_new = function(new)
        if f_new <= f_best:
            low, high = (best, high) if new >= best else (low, best)
            third, second, best = second, best, new
            f_third, f_second, f_best = f_second, f_best, f_new
            continue
        low, high = (new, high) if new < best else (low, new)
        if f_new <= f_second or second == best:
            third, second, f_third, f_second = second, new, f_second, f_new
        elif f_new <= f_third or third in (best, second):
            third, f_third = new, f_new
    return best, f_best
