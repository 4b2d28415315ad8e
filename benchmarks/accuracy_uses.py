# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases of `benchmarks.accuracy` beyond a single contact, and their reference values.

Partial slip, periodic and rough surfaces, wear, shakedown and fatigue.
"""

from __future__ import annotations

import functools
import math
from typing import Any

import samcontact as sc

Case = dict[str, Any]
ACCURACIES = (0.05, 0.02)
REFERENCE_ACCURACY = 0.006
"""Accuracy to which a use without closed form is solved as a reference."""
REFERENCE_SECONDS = 100.0
E, RADIUS, LOAD, MU = 210e9, 0.01, 100.0, 0.4
PULL = 0.6 * MU * LOAD
SOLID = {"law": "elastic", "E": E, "nu": 0.0}  # shear and pressure then have equal compliances
STEEL = {"law": "elastic", "E": E, "nu": 0.3}
BALL = {"shape": "paraboloid", "Rx": RADIUS}
STICKS = {"contact": {"friction": {"coulomb": MU}}}
SIDE, CELLS = 1e-4, 16
PERIOD = {"nx": CELLS, "ny": CELLS, "dx": SIDE / CELLS, "dy": SIDE / CELLS, "periodic": "xy"}
PLATE = {"body1": {"law": "rigid"}, "body2": {"law": "elastic", "E": 70e9, "nu": 0.3}}
WAVES = {"kind": "sinusoidal", "amplitude": 2e-7, "wavelength_x": SIDE, "wavelength_y": SIDE}
ROUGH = {"kind": "self_affine", "rms_height": 2e-8, "hurst": 0.7, "seed": 1}


def _of(name: str, body1: Case, body2: Case, surface: Case, *path: Case, **more: Any) -> Case:
    return {
        "title": name, "body1": body1, "body2": body2, "surface": surface, "path": list(path),
        "accuracy": REFERENCE_ACCURACY,
    } | more  # fmt: skip


def _contact(nu: float) -> sc.hertz.PointContact:
    body = sc.Material.elastic(E, nu)
    return sc.hertz.point(RADIUS, sc.hertz.effective_modulus(body, body), load=LOAD)


def _periodic(name: str, roughness: Case) -> Case:
    flat = {"shape": "paraboloid", "Rx": math.inf, "roughness": roughness}
    return _of(name, PLATE["body1"], PLATE["body2"], flat, {"load": 0.8}, grid=PERIOD)


def _scar() -> Case:
    step = 3.6 * _contact(0.0).a / 17
    grid = {"nx": 17, "ny": 17, "dx": step, "dy": step}
    fret = {"load": LOAD, "fret": {"shift_x": 2e-6}}
    wear = {"energy": 1e-14, "cycles": 2}
    return _of("scar", SOLID, SOLID, BALL, {"load": LOAD}, fret, grid=grid, wear=wear, **STICKS)


PRESSED = {"load": LOAD}, {"load": 0.0}
YIELDS = {"law": "perfect_plastic", "E": E, "nu": 0.3, "yield_stress": 0.6e9}
USES: dict[str, Case] = {
    "partial slip": _of(
        "pulled", SOLID, SOLID, BALL, {"load": LOAD}, {"load": LOAD, "tangential_load_x": PULL},
        quantities=["shift_x", "max_pressure", "contact_area"], **STICKS,
    ),
    "periodic waves": _periodic("waves", WAVES) | {"quantities": ["max_pressure", "contact_area"]},
    "rough, periodic": _periodic("rough", ROUGH) | {"quantities": ["max_pressure", "contact_area"]},
    "fretting wear": _scar() | {"quantities": ["worn_volume", "friction_work"]},
    "shakedown": _of(
        "pressed again", STEEL, YIELDS, BALL, *PRESSED, shakedown={"cycles": 3, "tol": 0.01},
        quantities=["max_equivalent_plastic_strain_body2", "imprint_depth_body2"],
    ),
    "fatigue": _of(
        "pressed once", STEEL, STEEL, BALL, *PRESSED, fatigue={"crossland": 0.0},
        quantities=["fatigue_crossland"],
    ),
}  # fmt: skip


def closed_form(name: str) -> dict[str, float]:
    """Return values in closed form: Hertz, Cattaneo and Mindlin; empty without one."""
    if name == "partial slip":
        whole = _contact(0.0)
        stuck = sc.hertz.point(RADIUS, whole.E_star, load=LOAD - PULL / MU)
        return {
            "shift_x": MU * (whole.approach - stuck.approach),
            "max_pressure": whole.p0, "contact_area": math.pi * whole.a**2,
        }  # fmt: skip
    if name == "fatigue":
        # amplitude of sqrt(J2) without pressure term: half the von Mises stress over sqrt(3)
        return {"fatigue_crossland": _contact(0.3).max_von_mises(0.3)[0] / (2 * math.sqrt(3))}
    return {}


@functools.cache
def reference(name: str) -> dict[str, float]:
    """Return the values in closed form or, without one, of a solution on finer grids."""
    if known := closed_form(name):
        return known
    found = sc.to_accuracy(
        USES[name], REFERENCE_ACCURACY, max_time=REFERENCE_SECONDS, progress=False
    )
    return dict(found.values)
