# SPDX-License-Identifier: GPL-3.0-or-later
"""Hints in the errors of case files: what an unknown field is meant to be."""

from pathlib import Path

import pytest

from samcontact.cases import CaseError
from samcontact.cases.reading import validated


@pytest.mark.parametrize(
    ("section", "fields", "says"),
    [
        ("bearing", {"designation": "6208", "load": 1.0}, r"bearing\.load: .*mean radial_load\?"),
        ("bearing", {"designation": "6208", "force": 1.0}, r"did you mean radial_load\?"),
        ("bearing", [{"designation": "6208"}], r"write \[bearing\] instead of \[\[bearing\]\]"),
        ("roller", {"width": 1e-2}, r"roller\.width: .*did you mean length\?"),
        ("roller", {"designation": "6208"}, r"; designation belongs to shape = 'bearing'"),
        ("surface", {"shape": "paraboloid", "diameter": 1.0}, r"belongs to shape = 'roller'"),
        ("body2", {"law": "elastic", "yield_stress": 1e9}, r"belongs to law = 'perfect_plastic'"),
        ("body2", {"material": "52100", "layers": 3}, r"body2\.layers: must be a list"),
        ("body2", {"material": "steel"}, r"got 'steel': for another material, omit material and"),
        ("path", [{"friction": 0.1}], r"path\[0\]\.friction: .*did you mean contact\.friction\?"),
        ("path", [{"tolerance": 0.1}], r"path\[0\]\.tolerance: .*did you mean contact\.tol\?"),
    ],
)
def test_hints_name_what_is_meant(section, fields, says):
    steel = {"material": "52100"}
    content = {"title": "t", "body1": steel, "body2": steel, section: fields}
    with pytest.raises(CaseError, match=says):
        validated(content, Path("case.toml"))
