# SPDX-License-Identifier: GPL-3.0-or-later
"""Influence of a heat source in units of LENGTH, as in the oracles.

Ages are kappa t / LENGTH^2 and speeds V LENGTH / kappa; `temperature`, `displacement` and `stress`
translate to SI and back.
"""

import numpy as np

from samcontact import heat_kernels

LENGTH = 2.5e-5
E, NU, EXPANSION = 210e9, 0.3, 1.2e-5
CONDUCTIVITY, DIFFUSIVITY = 45.0, 1.25e-5
INF = float("inf")
AT_REST = (0.0, 0.0)
STRESS_SCALE = E * EXPANSION / (1 - NU) / CONDUCTIVITY * LENGTH
DISPLACEMENT_SCALE = EXPANSION * (1 + NU) / CONDUCTIVITY * LENGTH**2
HALF = (0.5, 0.35)
# Offsets on, in, next to and far from a source of these half sizes.
X = np.array([-3.0, -1.0, -0.5, 0.0, 0.2, 1.0, 4.0])
Y = np.array([-2.0, 0.0, 0.35, 1.5])
# (age, speed): young and old at rest; moving transient; moving steady with Peclet numbers V a/kappa
# of 0.1, 1 and 10, along an axis and not.
REGIMES = [
    (0.02, AT_REST),
    (3.0, AT_REST),
    (400.0, AT_REST),
    (0.1, (1.0, 0.5)),
    (2.0, (-8.0, 3.0)),
    (INF, (0.2, 0.0)),
    (INF, (0.0, 2.0)),
    (INF, (16.0, -12.0)),
]


def history(age, speed):
    return {
        "diffusivity": DIFFUSIVITY,
        "time": age * LENGTH**2 / DIFFUSIVITY,
        "velocity": tuple(s * DIFFUSIVITY / LENGTH for s in speed),
    }


def metres(*values):
    return [LENGTH * np.asarray(v) for v in values]


def sizes(half):
    return {"a": LENGTH * half[0], "b": LENGTH * half[1]}


def temperature(x, y, z, half, age, speed, tol=1e-6):
    values = heat_kernels.temperature(
        *metres(x, y, z), **sizes(half), conductivity=CONDUCTIVITY, **history(age, speed), tol=tol
    )
    return values * CONDUCTIVITY / LENGTH


def displacement(x, y, half, age, speed, tol=1e-6):
    values = heat_kernels.displacement(
        *metres(x, y),
        **sizes(half),
        nu=NU,
        expansion=EXPANSION,
        conductivity=CONDUCTIVITY,
        **history(age, speed),
        tol=tol,
    )
    return values / DISPLACEMENT_SCALE


def stress(x, y, z, half, age, speed, tol=1e-6, nu=NU):
    values = heat_kernels.stress(
        *metres(x, y, z),
        **sizes(half),
        E=E,
        nu=nu,
        expansion=EXPANSION,
        conductivity=CONDUCTIVITY,
        **history(age, speed),
        tol=tol,
    )
    return values / STRESS_SCALE * (1 - nu) / (1 - NU)


def steady_temperature(x, y, z, half):
    values = heat_kernels.steady_temperature(
        *metres(x, y, z), **sizes(half), conductivity=CONDUCTIVITY
    )
    return values * CONDUCTIVITY / LENGTH


def steady_stress(x, y, z, half):
    values = heat_kernels.steady_stress(
        *metres(x, y, z), **sizes(half), E=E, expansion=EXPANSION, conductivity=CONDUCTIVITY
    )
    return values / STRESS_SCALE


def steady_displacement(x, y, half, r0):
    values = heat_kernels.steady_displacement(
        *metres(x, y),
        **sizes(half),
        nu=NU,
        expansion=EXPANSION,
        conductivity=CONDUCTIVITY,
        r0=r0 * LENGTH,
    )
    return values / DISPLACEMENT_SCALE


def error(actual, expected):
    return float(np.abs(actual - expected).max() / np.abs(expected).max())


def over(x, y, function):
    return np.array([[function(i, j) for j in y] for i in x])
