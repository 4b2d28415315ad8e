# SPDX-License-Identifier: GPL-3.0-or-later
"""Minimum of a function on an interval, without loading `scipy.optimize`, which takes 0.2 s."""

from __future__ import annotations

import math
from collections.abc import Callable

_GOLDEN = 0.5 * (3.0 - math.sqrt(5.0))
_ROOT_EPS = math.sqrt(2.2e-16)
_MAX_CALLS = 500


def bounded_minimum(
    function: Callable[[float], float], low: float, high: float, xatol: float
) -> tuple[float, float]:
    """Return the place of a minimum on [low, high], which is never an end, and its value.

    Brent's search by parabolas and golden sections (1973, chapter 5). Its steps are those of
    `scipy.optimize.minimize_scalar(method="bounded")`, to the last digit. xatol: absolute error of
    the place.
    """
    a, b = low, high
    best = second = third = a + _GOLDEN * (b - a)
    f_best = f_second = f_third = function(best)
    step = before = 0.0
    for _ in range(_MAX_CALLS - 1):
        middle = 0.5 * (a + b)
        tol = _ROOT_EPS * abs(best) + xatol / 3.0
        if not abs(best - middle) > 2.0 * tol - 0.5 * (b - a):
            break
        fit = None
        if abs(before) > tol:
            r = (best - second) * (f_best - f_third)
            q = (best - third) * (f_best - f_second)
            p = (best - third) * q - (best - second) * r
            q = 2.0 * (q - r)
            p, q = (-p if q > 0.0 else p), abs(q)
            r, before = before, step
            if abs(p) < abs(0.5 * q * r) and q * (a - best) < p < q * (b - best):
                fit = p / q
        if fit is None:
            before = (a if best >= middle else b) - best
            step = _GOLDEN * before
        else:
            step, at = fit, best + fit
            if at - a < 2.0 * tol or b - at < 2.0 * tol:
                step = tol if middle >= best else -tol
        at = best + (1.0 if step >= 0.0 else -1.0) * max(abs(step), tol)
        value = function(at)
        if value <= f_best:
            a, b = (best, b) if at >= best else (a, best)
            third, f_third, second, f_second = second, f_second, best, f_best
            best, f_best = at, value
        else:
            a, b = (at, b) if at < best else (a, at)
            if value <= f_second or second == best:
                third, f_third, second, f_second = second, f_second, at, value
            elif value <= f_third or third in (best, second):
                third, f_third = at, value
    return best, f_best
