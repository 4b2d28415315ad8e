# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files that begin with a roller or a bearing: short forms, loads, grids, errors."""

import numpy as np
import pytest

import samcontact as sc
from samcontact.accuracy.refinable_case import RefinableCase
from samcontact.cases import Case, CaseError, parse_case

ELASTIC = {"law": "elastic", "E": 207e9, "nu": 0.3}
SWIFT = {"law": "swift", "E": 207e9, "nu": 0.3, "B": 945e6, "C": 20.0, "n": 0.121}
PAIR = {"title": "t", "body1": ELASTIC, "body2": ELASTIC}
BEARING = {"designation": "6208", "radial_load": 18e3}
ROLLER = {"diameter": 10e-3, "length": 10e-3, "pitch_diameter": 50e-3}


def test_a_bearing_is_enough_for_a_run():
    """The most loaded ball has the Hertz pressure of the governing race."""
    case = Case.model_validate(PAIR | {"bearing": BEARING})
    simulation, path = case.build()
    assert [step["load"] for step in path] == pytest.approx([10e3])
    state = simulation.run(path, progress=False)[-1]
    hertz = sc.bearings.standard("6208").hertz("inner", 10e3)
    assert state.pressure.max() == pytest.approx(hertz.p0, rel=0.01)
    # the rated load gives the pressure of the standard
    assert hertz.p0 * (18.08 / 18.0) ** (1 / 3) == pytest.approx(4.2e9, rel=1e-3)


def test_elastic_plastic_bearings_are_unloaded():
    case = Case.model_validate(PAIR | {"body2": SWIFT, "bearing": BEARING})
    assert [segment.load for segment in case.path] == pytest.approx([10e3, 0.0])
    # the load is a part of the path in any way in which the case is written
    again = Case.model_validate(case.model_dump(exclude_unset=True))
    assert again.path[0].load == case.path[0].load
    assert again.grid == case.grid


def test_a_short_form_is_a_surface():
    long = Case.model_validate(PAIR | {"surface": {"shape": "bearing", **BEARING}})
    assert long.surface == Case.model_validate(PAIR | {"bearing": BEARING}).surface
    clearance = BEARING | {"clearance": 20e-6, "axial_load": 2e3}
    case = Case.model_validate(PAIR | {"bearing": clearance})
    bearing = sc.bearings.standard("6208", clearance=20e-6)
    assert case.path[0].load == pytest.approx(bearing.max_element_load(18e3, 2e3))
    contact = {"designation": "6208", "race": "outer"}
    case = Case.model_validate(PAIR | {"bearing": contact, "path": [{"load": 13e3}]})
    assert case.surface.radii()[0] == pytest.approx(7.2e-3)


def test_a_moment_tilts_the_most_loaded_roller():
    rollers = {
        "kind": "cylindrical_roller", "element_diameter": 10e-3, "pitch_diameter": 50e-3,
        "elements": 13, "length": 10e-3, "clearance": 10e-6, "radial_load": 40e3, "moment": 10.0,
    }  # fmt: skip
    case = Case.model_validate(PAIR | {"bearing": rollers})
    grid = case.grid.build()
    gap = case.surface.build(grid, None)
    bearing = case.surface.bearing
    tilt = 0.5 * bearing.element_loads(40e3, moment=10.0).tilt
    assert tilt > 1e-5
    np.testing.assert_allclose(gap, bearing.gap("inner", tilt)(grid), rtol=1e-12)
    # as cells of the grid cover the roller, the load keeps its moment about the middle
    state = case.build()[0].run(case.steps(), progress=False)[-1]
    assert (state.pressure * grid.y).sum() > 0.0


def test_a_roller_has_grids_that_resolve_its_ends():
    case = Case.model_validate(
        PAIR | {"accuracy": 0.02, "roller": ROLLER, "path": [{"load": 15e3}]}
    )
    grids = RefinableCase(case).grids
    first = grids.on(0, free=False)
    assert first.ny * first.dy == pytest.approx(10e-3, rel=0.01)
    assert first.dy < 12e-6 < first.dx
    assert grids.on(2, free=False).dy == pytest.approx(first.dy / 2)
    lundberg = ROLLER | {"profile": "lundberg", "design_load": 12e3}
    case = Case.model_validate(PAIR | {"roller": lundberg, "path": [{"load": 15e3}]})
    E_star = sc.hertz.effective_modulus(*(case.body1.build(),) * 2)
    known = sc.surfaces.roller(
        case.grid.build(), 5e-3, 10e-3, "lundberg", race_radius=20e-3, design_load=12e3,
        E_star=E_star,
    )  # fmt: skip
    np.testing.assert_array_equal(case.surface.build(case.grid.build(), None), known)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"bearing": {"designation": "9999", "radial_load": 1.0}}, "bearing: designation must be"),
        ({"bearing": BEARING | {"balls": 9}}, r"bearing\.balls: unknown field"),
        ({"bearing": BEARING | {"bore": 0.04}}, "exactly one of designation, bore and outside"),
        ({"bearing": BEARING | {"elements": 9}}, "elements requires kind"),
        ({"bearing": {"kind": "deep_groove", "radial_load": 1.0}}, "element_diameter is required"),
        ({"bearing": {"designation": "6208"}}, "load_factor requires a part with a load"),
        ({"bearing": BEARING, "path": [{"load": 1.0}]}, "load must be 0 or omitted with loads on"),
        ({"bearing": BEARING, "roller": ROLLER}, "only one section .* got roller and bearing"),
        ({"roller": ROLLER}, "path: required field is missing"),
        ({"roller": ROLLER | {"profile": "table"}}, "profile_y must be given if, and only if, pro"),
        ({"roller": ROLLER | {"tilt": 1.0}}, "roller: tilt must be between"),
        (
            {"roller": {"diameter": 1e-2, "length": 1e-2, "race": "outer"}},
            "race requires pitch_diameter",
        ),
    ],
)
def test_bad_sections_are_named(change, message):
    import json

    text = json.dumps(PAIR | change)
    lines = [f"{name} = {toml(value)}" for name, value in json.loads(text).items()]
    with pytest.raises(CaseError, match=message):
        parse_case("\n".join(lines))


def toml(value):
    """Return a value as TOML on one line."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{name} = {toml(part)}" for name, part in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    return f'"{value}"' if isinstance(value, str) else repr(value)
