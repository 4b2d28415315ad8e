# SPDX-License-Identifier: GPL-3.0-or-later
"""Friction laws: shear bounds, refused arguments, and storage."""

import copy
import dataclasses
import math
import pickle

import numpy as np
import pytest

import samcontact as sc
from samcontact.problem.friction import (
    LAWS,
    attributes_of,
    friction_law,
    law_of,
    law_of_attributes,
    sticking_law,
)

PRESSURE = np.array([[0.0, 1e-300, 2e8], [5e8, 1e9, 3e9]])
MU = 0.3
BOUNDS = {
    sc.Coulomb(MU): MU * PRESSURE,
    sc.CappedCoulomb(MU, 2e8): np.minimum(MU * PRESSURE, 2e8),
    sc.Tresca(2e8): np.where(PRESSURE > 0, 2e8, 0.0),
}
each = pytest.mark.parametrize("law", BOUNDS, ids=repr)


@each
def test_shear_bound(law):
    assert np.array_equal(law.bound(PRESSURE), BOUNDS[law])


@each
def test_ratio_is_the_bound_over_the_pressure_and_does_not_grow(law):
    pressed = PRESSURE[PRESSURE > 1.0]
    ratios = np.array([law.ratio(p) for p in pressed])
    np.testing.assert_allclose(ratios, law.bound(pressed) / pressed, rtol=1e-15)
    assert (np.diff(ratios) <= 0).all()
    assert law.ratio(0.0) >= ratios[0]


def example(constant, number):
    """A valid value of a parameter."""
    value = min(float(number), constant.le or math.inf)
    return (value,) if constant.many else value


@pytest.mark.parametrize("law", LAWS.values(), ids=list(LAWS))
def test_parameters_of_a_class_are_those_of_the_core(law):
    assert list(law.constants) == [field.name for field in dataclasses.fields(law)]
    values = {name: example(c, n) for n, (name, c) in enumerate(law.constants.items(), 1)}
    found = law(**values)
    for name, constant in law.constants.items():
        assert getattr(found, name) == values[name]

        def refuse(error, message, value, name=name, many=constant.many):
            with pytest.raises(error, match=f"^{name}.* {message}"):
                law(**values | {name: [value] if many else value})

        refuse(ValueError, "must be", math.nan)
        refuse(TypeError if not constant.many else (TypeError, ValueError), "must be", "much")
        if constant.ge is not None or constant.gt is not None:
            limit = constant.gt if constant.ge is None else constant.ge
            refuse(ValueError, "must be", limit - 0.5)
        if constant.gt is not None:
            refuse(ValueError, "must be", constant.gt)


@each
def test_a_law_without_limits_prevents_slip_and_one_of_zero_has_no_friction(law):
    assert not law.prevents_slip
    assert not law.is_frictionless
    kind, names = type(law), law.constants
    assert kind(**dict.fromkeys(names, 0.0)).is_frictionless
    endless = [name for name, constant in names.items() if constant.infinite]
    for name in endless:
        others = dict.fromkeys(names, 1.0)
        others.pop(name)
        assert kind(**others, **{name: math.inf}).prevents_slip == (not others)


ANISOTROPIC = sc.Anisotropic(0.1, MU, 0.5)
MAP = sc.MappedCoulomb([[0.1, 0.2], [MU, 0.0]], x=[0.0, 1e-3], y=[-1e-3, 0.0], body=1)
FALLING = sc.FallingCoulomb(0.1, 0.2, 1e-3)


@pytest.mark.parametrize("law", [ANISOTROPIC, MAP, FALLING], ids=repr)
def test_the_bound_is_the_largest_in_any_direction_place_and_slip_rate(law):
    np.testing.assert_allclose(law.bound(PRESSURE), MU * PRESSURE, rtol=1e-15)
    assert law.ratio(1e9) == pytest.approx(MU)
    assert not law.prevents_slip
    assert not law.is_frictionless
    assert law.needs_duration == (law is FALLING)
    assert law.varies_along_x == (law is MAP)
    table = law._repr_html_()
    assert all(name in table for name in law.constants)


ACROSS = sc.MappedCoulomb([0.1, 0.2], y=[0.0, 1e-3])


@pytest.mark.parametrize(
    "law", [*BOUNDS, friction_law(0.3), ANISOTROPIC, MAP, ACROSS, FALLING], ids=repr
)
def test_a_law_outlives_trees_attributes_copies_and_pickles(law):
    assert law_of(law.to_tree()) == law
    assert law_of_attributes(attributes_of(law) | {"body1_law": "elastic"}) == law
    assert pickle.loads(pickle.dumps(law)) == copy.deepcopy(law) == law


def test_files_without_law_attributes_have_no_law():
    assert law_of_attributes({}) is None
    assert law_of_attributes({"friction_law": "unheard of"}) is None


def test_a_number_means_full_sliding():
    law = friction_law(0.25)
    assert not law.sticks
    assert law.sliding_ratio == 0.25
    assert repr(law) == "0.25"
    assert np.array_equal(law.bound(PRESSURE), 0.25 * PRESSURE)
    with pytest.raises(TypeError, match=r"partial slip, such as .*Coulomb\(mu\), got 0.25"):
        sticking_law(0.25)
    for law in BOUNDS:
        assert law.sticks
        assert law.sliding_ratio == 0.0
        assert sticking_law(law) is law


@each
def test_notebooks_show_parameters_with_units(law):
    table = law._repr_html_()
    for name, constant in law.constants.items():
        assert name in table
        assert constant.unit in table
