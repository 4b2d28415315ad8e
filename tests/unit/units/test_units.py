# SPDX-License-Identifier: GPL-3.0-or-later
"""Values with units: conversion, refusals, and the fields of case files."""

import math
import sys
import typing

import numpy as np
import pint
import pytest
from pydantic import BaseModel

import samcontact as sc
from samcontact import units
from samcontact.cases import ALL_KINDS, CaseError, load_case
from samcontact.cases.converted import Unit


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("210 GPa", "Pa", 210e9),
        ("25 um", "m", 25e-6),
        ("25µm", "m", 25e-6),
        ("-4.5e-1 mm", "m", -0.45e-3),
        ("1.5 kN", "N", 1500.0),
        (" +.5 m/s ", "m/s", 0.5),
        ("20 degC", "K", 293.15),
        ("50.2 W/m/K", "W/(m*K)", 50.2),
        ("11.7e-6 1/K", "1/K", 11.7e-6),
        ("13.7 mm**2/s", "m**2/s", 13.7e-6),
        ("3 N/mm^2", "Pa", 3e6),
    ],
)
def test_texts_with_units_equal_numbers(text, unit, value):
    assert units.si(text, unit) == value  # to the last digit, as if given in SI


def test_angles():
    assert units.si("15 deg", "rad") == pytest.approx(math.pi / 12, rel=1e-15)


def test_quantities_of_any_registry_and_plain_numbers():
    registry = pint.UnitRegistry()
    assert units.si(registry.Quantity(2.0, "ksi"), "Pa") == pytest.approx(13.789515e6, rel=1e-6)
    heights = units.si(registry.Quantity(np.array([[1.0, 2.0]]), "nm"), "m")
    np.testing.assert_allclose(heights, [[1e-9, 2e-9]], rtol=1e-15)
    assert units.si(3, "m") == 3.0
    assert isinstance(units.si(np.float64(3.0), "m"), float)
    np.testing.assert_array_equal(units.si([1, 2], "m"), [1.0, 2.0])


@pytest.mark.parametrize("text", ["25", "25 s", "um", "25 foo", "25 m 3", "25 (", "1e um", ""])
def test_wrong_texts_are_refused(text):
    with pytest.raises(ValueError, match="value must be a number and a unit that converts to m, "):
        units.si(text, "m")


@pytest.mark.parametrize("text", ["1e400 m", "-1e309 m", "1" * 400 + " m", "1e-400 m"])
def test_numbers_beyond_the_range_are_refused(text):
    with pytest.raises(
        ValueError,
        match=r"value must be (within the range of floating-point numbers|a number and a unit .*), "
        "got '",
    ):
        units.si(text, "m")
    assert units.si("0 m", "m") == 0.0
    assert units.si("-273.15 degC", "K") == 0.0


def test_wrong_quantities_are_refused():
    registry = pint.UnitRegistry()
    with pytest.raises(ValueError, match=r"converts to Pa, got <Quantity\(2, 'meter'\)>"):
        units.si(registry.Quantity(2, "m"), "Pa")
    with pytest.raises(TypeError, match="must be a number, a quantity or text, got True"):
        units.si(True, "m")


def test_functions_do_not_drop_units():
    registry = pint.UnitRegistry()
    with pytest.raises(TypeError, match=r"R must be a number.*samcontact\.units\.si"):
        sc.hertz.point(registry.Quantity(7.5, "mm"), 1e11, load=1.0)
    grid = sc.Grid(nx=2, ny=2, dx=1.0, dy=1.0)
    with pytest.raises(TypeError, match="heights_lower has a unit"):
        sc.surfaces.from_heights(grid, registry.Quantity(np.zeros((2, 2)), "nm"))


PLAIN = """
title = "units"
[grid]
nx = 8
ny = 8
dx = 100e-6
dy = 50e-6
nz = 4
dz = 1e-4
[body1]
law = "rigid"
[[body1.layers]]
E = 3e9
nu = 0.4
thickness = 20e-6
[body2]
law = "linear_hardening"
E = 210e9
nu = 0.3
yield_stress = 1.2e9
tangent_modulus = 20e9
[body2.thermal]
conductivity = 50.2
expansion = 11.7e-6
diffusivity = 13.7e-6
[body2.kinematic]
modulus = [1e9, 2e9]
[surface]
shape = "paraboloid"
Rx = 7.5e-3
[heat]
factor = [0.0, 0.25]
velocity = [-0.1, 0.0]
[[path]]
load = 1500.0
[[path]]
approach = 1e-6
start = 2e-6
"""
WITH_UNITS = [
    ("dx = 100e-6", 'dx = "100 um"'),
    ("dy = 50e-6", 'dy = "0.05 mm"'),
    ("E = 210e9", 'E = "210 GPa"'),
    ("1.2e9", '"1200 MPa"'),
    ("E = 3e9", 'E = "3 GPa"'),
    ("thickness = 20e-6", 'thickness = "20 um"'),
    ("50.2", '"50.2 W/(m K)"'),
    ("[1e9, 2e9]", '["1 GPa", 2e9]'),
    ("Rx = 7.5e-3", 'Rx = "7.5 mm"'),
    ("0.25]", '"250 mm/s"]'),
    ("[-0.1, 0.0]", '["-10 cm/s", 0.0]'),
    ("1500.0", '"1.5 kN"'),
    ("start = 2e-6", 'start = "2 um"'),
]


def case_of(tmp_path, *changes):
    text = PLAIN
    for old, new in changes:
        assert old in text
        text = text.replace(old, new, 1)
    path = tmp_path / "case.toml"
    path.write_text(text, encoding="utf-8")
    return load_case(path)


def test_case_file_with_units_is_the_same_case(tmp_path):
    assert case_of(tmp_path, *WITH_UNITS).model_dump() == case_of(tmp_path).model_dump()


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("100e-6", '"100 s"', r"grid\.dx: must be .* converts to m, got '100 s'"),
        ("210e9", '"210"', r"body2\.E: must be .* converts to Pa, got '210'"),
        ("100e-6", '"-100 um"', r"grid\.dx: must be a finite number > 0 \[m\], got '-100 um'"),
        ("nu = 0.3", 'nu = "0.3"', r"body2\.nu: must be a number in \[0, 0\.5\), got '0\.3'"),
        ("1500.0", '"1.5 mm"', r"path\[0\]\.load: must be .* converts to N"),
        ("2e-6", '"2 N"', r"path\[1\]: start must be .* converts to m, got '2 N'"),
    ],
)
def test_errors_name_field_value_and_unit(tmp_path, old, new, message):
    with pytest.raises(CaseError, match=message):
        case_of(tmp_path, (old, new))


def test_without_pint(tmp_path, monkeypatch):
    class WithoutPint:
        @staticmethod
        def find_spec(name, *_):
            if name == "pint":
                raise ImportError(name)

    units._registry.cache_clear()
    monkeypatch.delitem(sys.modules, "pint", raising=False)
    monkeypatch.setattr(sys, "meta_path", [WithoutPint, *sys.meta_path])
    with pytest.raises(ImportError, match=r"pip install samcontact\[units\]"):
        units.si("1 m", "m")
    with pytest.raises(CaseError, match=r"grid\.dx: .*pip install samcontact\[units\].*'100 um'"):
        case_of(tmp_path, ("100e-6", '"100 um"'))
    assert case_of(tmp_path).grid.dx == 100e-6


# numbers without a dimension (width and depth of [asperities] are multiples), and start, whose unit
# depends on its segment
NUMBERS = {
    *("nu", "C", "n", "recovery", "m", "floor", "hurst", "friction", "coulomb", "lateral_creepage"),
    *("coefficient", "partition", "spread", "depth_ratio"),
    *("tol", "increment_tol", "rate", "plastic_strain", "factor"),
    *("dang_van", "crossland", "findley", "fatemi_socie"),
    *("image_tol", "exponent", "slide_to_roll", "start", "width", "depth", "threshold"),
    "shares",
    *("HV", "surface", "core", "limit", "slope", "weibull", "depth_exponent"),
    *("inner_conformity", "outer_conformity", "profile_shift", "relief_exponent", "load_factor"),
    *("mu_x", "mu_y", "body", "kinetic", "drop"),
    *("misfit", "axes", "fraction", "gap", "members"),
    *("z", "B", "R0", "modulus_slope", "carreau_exponent", "limiting_shear"),
    *("load_factors", "speed_factors", "accuracy"),
}


def parts(annotation):
    """Yield the parts of an annotation: types and the markers of Annotated."""
    yield annotation
    for inner in typing.get_args(annotation):
        yield from parts(inner)


def models(model):
    yield model
    for field in model.model_fields.values():
        for part in parts(field.annotation):
            if isinstance(part, type) and issubclass(part, BaseModel):
                yield from models(part)


def without_unit(model):
    """Return float fields that accept no texts with units."""
    for name, field in model.model_fields.items():
        found = [*parts(field.annotation), *field.metadata]
        if float in found and not any(isinstance(part, Unit) for part in found):
            yield name


def test_every_field_with_a_dimension_takes_units():
    sections = {model for case in ALL_KINDS for model in models(case)}
    assert {name for model in sections for name in without_unit(model)} == NUMBERS
