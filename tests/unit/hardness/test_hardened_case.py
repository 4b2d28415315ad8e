# SPDX-License-Identifier: GPL-3.0-or-later
"""Profiles of hardened cases and fatigue limits from hardness."""

import numpy as np
import pytest

import samcontact as sc
from samcontact import hardness
from samcontact.cases import Case, CaseError

CORE = sc.Material.linear_hardening(206e9, 0.3, 1e9, 10e9)
CASE = {
    "title": "hardened",
    "grid": {"nx": 9, "ny": 9, "dx": 1e-5, "dy": 1e-5, "dz": 1e-5},
    "body1": {"law": "rigid"},
    "surface": {"shape": "paraboloid", "Rx": 5e-3},
    "path": [{"load": 0.5}, {"load": 1.0}],
}
PLASTIC = {"law": "perfect_plastic", "E": 206e9, "nu": 0.3, "yield_stress": 1e9}
FORM = {"surface": 620.0, "core": 380.0, "depth": "0.8 mm"}


def test_the_case_has_its_hardness_at_its_depth():
    for limit in (430.0, 550.0, 610.0):
        case = hardness.hardened_case(620.0, 380.0, 0.8e-3, limit)
        assert case.at([0.0, 0.8e-3, 0.02]) == pytest.approx([620.0, limit, 380.0], abs=0.5)
        assert case.depth_of(limit) == pytest.approx(0.8e-3, rel=1e-12)
        assert (np.diff(case.HV) < 0).all()
    measured = hardness.HardnessProfile([0.0, 1e-3, 2e-3], [650.0, 600.0, 400.0])
    assert measured.depth_of(550.0) == pytest.approx(1.25e-3)


def test_the_yield_stress_follows_the_hardness_whatever_the_law():
    case = hardness.hardened_case(620.0, 380.0, 0.8e-3)
    z = np.asarray(case.z)
    expected = hardness.yield_from_vickers(case.at(z))
    for law in (CORE, sc.Material.swift(206e9, 0.3, 945e6, 20.0, 0.12)):
        assert case.applied_to(law).yield_stress_at(z) == pytest.approx(expected, rel=1e-12)


def test_fatigue_limits_of_murakami():
    assert hardness.bending_limit_from_vickers(300.0) == pytest.approx(480e6)
    # an inclusion of 64 micrometres halves the sixth root: 1.56 (700 + 120) / 2
    inside = hardness.bending_limit_from_vickers(700.0, defect=64e-6)
    assert inside == pytest.approx(1.56e6 * 820 / 2)
    surface = hardness.bending_limit_from_vickers(700.0, defect=64e-6, location="surface")
    assert surface / inside == pytest.approx(1.43 / 1.56)
    # a small defect does not matter in soft steel
    assert hardness.bending_limit_from_vickers(200.0, defect=1e-6) == pytest.approx(320e6)
    with pytest.warns(hardness.HardnessRangeWarning, match="HV = 700 is outside"):
        hardness.bending_limit_from_vickers(700.0)


@pytest.mark.parametrize(
    ("call", "says"),
    [
        (lambda: hardness.hardened_case(700.0, 380.0, 0.8), "depth must be in m"),
        (lambda: hardness.hardened_case(500.0, 380.0, 8e-4), "limit must be between"),
        (lambda: hardness.hardened_case(7e9, 380.0, 8e-4), "surface must be Vickers"),
        (lambda: hardness.HardnessProfile([0.0, 0.5], [700.0, 400.0]), "multiply millimetres"),
        (lambda: hardness.HardnessProfile([1e-3, 0.0], [700.0, 400.0]), "increasing"),
        (lambda: hardness.HardnessProfile([0.0], [700.0, 400.0]), "same length"),
        (lambda: hardness.HardnessProfile([0.0], [700.0]).depth_of(550), "smallest hardness"),
        (lambda: hardness.bending_limit_from_vickers(300.0, defect=20.0), "defect must be at most"),
        (
            lambda: hardness.hardened_case(620.0, 380.0, 8e-4).applied_to(
                sc.Material.elastic(2e11, 0.3)
            ),
            "must be elastic-plastic",
        ),
    ],
)
def test_slips_are_refused(call, says):
    with pytest.raises(ValueError, match=says):
        call()


def test_case_files_state_the_case_as_engineers_do():
    body = Case.model_validate(CASE | {"body2": PLASTIC | {"hardness": FORM}}).body2.build()
    same = hardness.hardened_case(620.0, 380.0, 0.8e-3)
    assert body == same.applied_to(sc.Material.perfect_plastic(206e9, 0.3, 1e9))
    points = {"z": ["0 mm", "1 mm"], "HV": [600.0, 400.0]}
    body = Case.model_validate(CASE | {"body2": PLASTIC | {"hardness": points}}).body2.build()
    assert body.yield_stress_at(5e-4) == pytest.approx(hardness.yield_from_vickers(500.0))


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"hardness": FORM | {"z": [0.0]}}, "surface, core and depth, or z and HV"),
        ({"hardness": {"surface": 620.0}}, "surface, core and depth, or z and HV"),
        ({"hardness": FORM | {"depth": "0.8 m"}}, "depth must be in m"),
        (
            {"hardness": {"z": [0.0], "HV": [600.0], "limit": 500.0}},
            "limit is the hardness at depth",
        ),
        ({"hardness": FORM, "yield_profile": {"z": [0.0], "factor": [2.0]}}, "yield_profile"),
        ({"law": "elastic", "yield_stress": None, "hardness": FORM}, "no effect on an elastic"),
        ({"fatigue": {"exposure": {}}}, r"requires the hardness of body2"),
        ({"fatigue": {"dang_van": 0.3, "life": {"criterion": "findley"}}}, "requires findley"),
    ],
)
def test_case_files_refuse_contradictions(change, says):
    fatigue = {"fatigue": change.pop("fatigue")} if "fatigue" in change else {}
    body = {k: v for k, v in (PLASTIC | change).items() if v is not None}
    with pytest.raises(CaseError, match=says):
        Case.model_validate(CASE | fatigue | {"body2": body})
