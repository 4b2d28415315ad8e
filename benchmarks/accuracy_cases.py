# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases with values known in closed form, or with reference values from a much finer grid."""

from __future__ import annotations

import math
from typing import Any

import samcontact as sc

E, NU, R = 210e9, 0.3, 7.5e-3
STEEL = {"law": "elastic", "E": E, "nu": NU}
RIGID = {"law": "rigid"}
SWIFT = {"law": "swift", "E": E, "nu": NU, "B": 945e6, "C": 20.0, "n": 0.121}
M50 = SWIFT | {"B": 1280e6, "C": 4.0, "n": 0.095}
NITRIDED = SWIFT | {"B": 1240e6, "C": 30.0, "n": 0.085}
BILINEAR = {"law": "linear_hardening", "E": E, "nu": NU, "yield_stress": 1e9,
            "tangent_modulus": 21e9}  # fmt: skip
THERMAL = {"conductivity": 50.2, "expansion": 11.7e-6, "diffusivity": 1.367e-5}
PERFECT = {"law": "perfect_plastic", "E": 200e9, "nu": 0.32, "yield_stress": 0.9115e9}
CERAMIC = {"law": "elastic", "E": 310e9, "nu": 0.29}
DIAMOND = {"law": "elastic", "E": 1141e9, "nu": 0.07}
BALL = {"shape": "paraboloid", "Rx": R}
LARGE_BALL = {"shape": "paraboloid", "Rx": 10e-3}
TIP = {"shape": "paraboloid", "Rx": 105e-6}

Case = dict[str, Any]


def pressed(body1: Case, body2: Case, load: float, surface: Case = BALL, **more: Any) -> Case:
    """Return a case with one load, followed by unloading if a body is elastic-plastic."""
    path = [{"load": load}]
    if not {body1["law"], body2["law"]} <= {"elastic", "rigid"}:
        path.append({"load": 0.0})
    return {"body1": body1, "body2": body2, "surface": surface, "path": path} | more


def rolled(body1: Case, load: float, distance: float, surface: Case, passes: int = 1) -> Case:
    """Return a case of rolling over a body with Swift hardening, unloaded after each pass."""
    roll = {"distance": distance, "step": 25e-6, "passes": passes}
    return pressed(body1, SWIFT, load, surface) | {"path": [{"load": load, "roll": roll}]}


def elliptic(ratio: float) -> Case:
    """Return a paraboloid with this ratio of the principal radii, as the section `surface`."""
    return BALL | {"Ry": ratio * R}


ELASTIC: dict[str, Case] = {
    "balls, 1500 N": pressed(STEEL, STEEL, 1500.0),
    "balls, 3 N": pressed(STEEL, STEEL, 3.0),
    "balls, 10 µm": pressed(STEEL, STEEL, 1.0) | {"path": [{"approach": 1e-5}]},
    "rigid ball on rubber": pressed(RIGID, STEEL | {"E": 5e6, "nu": 0.49}, 0.1),
    "rigid sphere": pressed(RIGID, STEEL, 50.0, {"shape": "sphere", "R": R}),
    "radii 1:1.3": pressed(STEEL, STEEL, 1000.0, elliptic(1.3)),
    "radii 1:2": pressed(STEEL, STEEL, 1000.0, elliptic(2.0)),
    "radii 2:1": pressed(STEEL, STEEL, 1000.0, elliptic(0.5)),
    "semi-axes 1:2": pressed(STEEL, STEEL, 2000.0, elliptic(2.8428)),
    "semi-axes 1:3": pressed(STEEL, STEEL, 2000.0, elliptic(5.3)),
    "semi-axes 1:4": pressed(STEEL, STEEL, 3000.0, elliptic(8.3033)),
    "semi-axes 4:1": pressed(STEEL, STEEL, 3000.0, elliptic(1 / 8.3033)),
    "semi-axes 1:6": pressed(STEEL, STEEL, 3000.0, elliptic(16.0)),
    "semi-axes 1:8": pressed(STEEL, STEEL, 5000.0, elliptic(25.2897)),
    "semi-axes 1:10": pressed(STEEL, STEEL, 5000.0, elliptic(35.5)),
    "two loads": pressed(STEEL, STEEL, 1.0) | {"path": [{"load": 100.0}, {"load": 1500.0}]},
}
YIELDING: dict[str, Case] = {
    "T1, 1500 N": pressed(STEEL, SWIFT, 1500.0),
    "T1, 600 N": pressed(STEEL, SWIFT, 600.0),
    "T1, 4000 N": pressed(STEEL, SWIFT, 4000.0),
    "V1, rigid tip": pressed(RIGID, NITRIDED, 0.65, TIP),
    "V1, 0.3 N": pressed(RIGID, NITRIDED, 0.3, TIP),
    "V1, diamond tip": pressed(DIAMOND, NITRIDED, 0.3, TIP),
    "V2, both elastic-plastic": pressed(SWIFT, SWIFT, 2000.0),
    "two laws": pressed(M50, BILINEAR, 1000.0),
    "2a, rigid on M50": pressed(RIGID, M50, 800.0, LARGE_BALL),
    "2d, rigid on perfectly plastic": pressed(RIGID, PERFECT, 92.42736, LARGE_BALL),
    "bilinear": pressed(STEEL, BILINEAR, 800.0),
    "radii 1:3, yields": pressed(STEEL, SWIFT, 3000.0, elliptic(3.0)),
    "semi-axes 1:4, yields": pressed(STEEL, SWIFT, 6000.0, elliptic(8.3033)),
    "F2, friction 0.2": pressed(
        STEEL, M50, 3000.0, LARGE_BALL, contact={"friction": 0.2}
    ),
    "F2, friction 0.25": pressed(STEEL, M50, 3000.0, LARGE_BALL, contact={"friction": 0.25}),
    "F2, 5000 N": pressed(STEEL, M50, 5000.0, LARGE_BALL, contact={"friction": 0.1}),
    "given approach": pressed(STEEL, SWIFT, 1.0)
    | {"path": [{"approach": 2.5e-5}, {"load": 0.0, "start": 1800.0}]},
    "loaded twice": pressed(STEEL, SWIFT, 1.0)
    | {"path": [{"load": w} for w in (1000.0, 0.0, 1500.0, 0.0)]},
    "heated, steady": pressed(
        STEEL, SWIFT | {"thermal": THERMAL}, 1500.0, heat={"factor": 0.02}
    ),
    "heated for 20 ms": pressed(STEEL, SWIFT | {"thermal": THERMAL}, 1.0)
    | {"heat": {"factor": 0.05, "history": [1e-3, 10.0]},
       "path": [{"load": 1500.0, "duration": 20e-3},
                {"load": 0.0, "duration": 10e-3, "heat_factor": 0.0}]},
}  # fmt: skip
ROLLING: dict[str, Case] = {
    "rolling ball": rolled(CERAMIC, 1152.9, 0.6e-3, BALL | {"Rx": 4.7625e-3}),
    "R2, two passes": rolled(CERAMIC, 1152.9, 0.15e-3, BALL | {"Rx": 4.7625e-3}, passes=2),
    "rolling along the short axis, 1:2": rolled(STEEL, 1500.0, 0.2e-3, elliptic(2.8428)),
    "rolling along the long axis, 2:1": rolled(
        STEEL, 1500.0, 0.2e-3, {"shape": "paraboloid", "Rx": 2.8428 * R, "Ry": R}
    ),
}
CASES = ELASTIC | YIELDING | ROLLING


def closed_form(case: Case) -> dict[str, float]:
    """Return the Hertz values of elastic paraboloids at the last load; for other cases, none."""
    if not {case["body1"]["law"], case["body2"]["law"]} <= {"elastic", "rigid"}:
        return {}
    if case["surface"]["shape"] != "paraboloid":
        return {}
    bodies = [_body(case[name]) for name in ("body1", "body2")]
    Rx = case["surface"]["Rx"]
    given = case["path"][-1]
    found = sc.hertz.elliptic(
        Rx, case["surface"].get("Ry", Rx), sc.hertz.effective_modulus(*bodies), **given
    )
    return {
        "max_pressure": found.p0,
        "contact_area": math.pi * found.a_x * found.a_y,
        "load": found.load,
        "approach": found.approach,
    }


def _body(fields: Case) -> sc.Material:
    plain = dict(fields)
    make = getattr(sc.Material, plain.pop("law"))
    body: sc.Material = make(**plain)
    return body
