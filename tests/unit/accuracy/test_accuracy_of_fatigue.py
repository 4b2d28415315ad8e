# SPDX-License-Identifier: GPL-3.0-or-later
"""Prescribed accuracy of fatigue criteria against closed forms of Hertz contact."""

import math

import samcontact as sc
from samcontact.accuracy.error_rows import error_rows

STEEL = {"law": "elastic", "E": 210e9, "nu": 0.3}
PRESSED = {
    "title": "ball, pressed and unloaded",
    "body1": STEEL,
    "body2": STEEL,
    "surface": {"shape": "paraboloid", "Rx": 5e-3},
    "path": [{"load": 20.0}, {"load": 0.0}],
}


def test_crosslands_criterion_of_a_pressed_ball():
    """Without pressure term it is the amplitude sqrt(J2): half that of the von Mises stress."""
    case = PRESSED | {"accuracy": 0.02, "fatigue": {"crossland": 0.0}}
    found = sc.to_accuracy(case | {"quantities": ["fatigue_crossland"]}, progress=False)
    ball = sc.Material.elastic(210e9, 0.3)
    contact = sc.hertz.point(5e-3, sc.hertz.effective_modulus(ball, ball), load=20.0)
    exact = contact.max_von_mises(0.3)[0] / (2 * math.sqrt(3))
    error = found.errors["fatigue_crossland"]
    assert found.reached
    assert abs(found.values["fatigue_crossland"] - exact) < error < 0.02 * exact
    (row,) = (row for row in error_rows(found.to_dataset()) if "crossland" in row.label)
    assert row.target == 0.02
