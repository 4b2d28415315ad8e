# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials: hardening laws in numbers, and refused arguments of the class methods."""

import math
import pickle
import re

import numpy as np
import pytest

import samcontact as sc
from samcontact.bodies.hardening_laws import LAWS

E, NU = 210e9, 0.3
# sigma_y [MPa] at 0, 20 and 2000 microstrain, from the law evaluated by hand; Boucly (2008) prints
# the second and third ("micro" and "conventional" yield).
SWIFT = {
    "AISI 52100": (945e6, 20.0, 0.121, (1357.9, 1476.7, 2373.4)),
    "M50": (1280e6, 4.0, 0.095, (1460.2, 1731.1, 2635.7)),
    "nitrided": (1240e6, 30.0, 0.085, (1655.7, 1729.2, 2369.0)),
    "running-in": (1735e6, 16.0, 0.067, (2089.2, 2205.8, 2888.7)),
}
FACTORIES = {
    "elastic": (E, NU),
    "rigid": (),
    "perfect_plastic": (E, NU, 1e9),
    "linear_hardening": (E, NU, 1e9, 0.1 * E),
    "swift": (E, NU, 945e6, 20.0, 0.121),
    "voce": (E, NU, 900e6, 1500e6, 60.0),
    "tabulated": (E, NU, (0.0, 1e-3, 0.02), (900e6, 1000e6, 1500e6)),
}


def make(law):
    return getattr(sc.Material, law)(*FACTORIES[law])


@pytest.mark.parametrize("name", SWIFT)
def test_swift_steels(name):
    B, C, n, expected = SWIFT[name]
    material = sc.Material.swift(E, NU, B, C, n)
    # half a unit of the last digit given
    actual = material.yield_stress([0.0, 20e-6, 2e-3]) / 1e6
    np.testing.assert_allclose(actual, expected, rtol=0, atol=0.05)


def test_linear_hardening_has_the_tangent_of_the_uniaxial_curve():
    yield_stress, tangent = 1e9, 35e9
    material = sc.Material.linear_hardening(E, NU, yield_stress, tangent)
    g = np.array([0.0, 1e-4, 3e-2])
    stress = material.yield_stress(g)
    total = stress / E + g
    np.testing.assert_allclose(stress - yield_stress, tangent * (total - yield_stress / E))


def test_laws_that_coincide():
    g = np.linspace(0, 0.1, 7)
    perfect = make("perfect_plastic")
    np.testing.assert_array_equal(perfect.yield_stress(g), np.full(7, 1e9))
    flat = sc.Material.linear_hardening(E, NU, 1e9, 0.0)
    np.testing.assert_array_equal(flat.yield_stress(g), perfect.yield_stress(g))
    straight = sc.Material.swift(E, NU, 2e6, 500.0, 1.0)
    np.testing.assert_allclose(straight.yield_stress(g), 1e9 + 2e12 * g, rtol=1e-14)


def test_materials_without_yield():
    for law in ("elastic", "rigid"):
        assert not make(law).is_plastic
        assert make(law).yield_stress(0.5) == math.inf
    for law in FACTORIES.keys() - {"elastic", "rigid"}:
        assert make(law).is_plastic
    assert make("rigid").is_rigid
    assert math.isinf(make("rigid").E)
    assert not make("elastic").is_rigid


def test_yield_stress_keeps_the_array_shape():
    material = make("swift")
    assert isinstance(material.yield_stress(1e-3), float)
    strided = np.linspace(0, 1e-2, 24).reshape(4, 6)[::2, ::3].T
    values = material.yield_stress(strided)
    assert values.shape == (2, 2)
    assert values[1, 0] == material.yield_stress(strided[1, 0])


@pytest.mark.parametrize("bad", [-1e-9, math.nan, math.inf])
def test_yield_stress_refuses(bad):
    with pytest.raises(ValueError, match="g must be finite and >= 0, got"):
        make("swift").yield_stress([0.0, bad])


@pytest.mark.parametrize("law", FACTORIES)
def test_is_a_value(law):
    material = make(law)
    assert material == make(law)
    assert hash(material) == hash(make(law))
    assert (material.E, material.nu) == ((E, NU) if law != "rigid" else (math.inf, material.nu))
    copy = pickle.loads(pickle.dumps(material))
    assert copy == material
    assert copy.yield_stress(1e-3) == material.yield_stress(1e-3)
    with pytest.raises(AttributeError):
        material.law = "rigid"
    assert len({make(other) for other in FACTORIES} | {material}) == len(FACTORIES)


@pytest.mark.parametrize(
    ("law", "arguments", "error", "text"),
    [
        ("elastic", (0.0, NU), ValueError, "E must be a finite number > 0 [Pa], got 0"),
        ("elastic", (-E, NU), ValueError, "E must be a finite number > 0 [Pa], got -"),
        ("elastic", (math.inf, NU), ValueError, "E must be a finite number > 0 [Pa], got inf"),
        ("elastic", (math.nan, NU), ValueError, "E must be a finite number > 0 [Pa], got nan"),
        ("elastic", (E, 0.5), ValueError, "nu must be in [0, 0.5), got 0.5"),
        ("elastic", (E, -0.1), ValueError, "nu must be in [0, 0.5), got -0.1"),
        ("elastic", (E, math.nan), ValueError, "nu must be in [0, 0.5), got nan"),
        ("elastic", ("210e9", NU), TypeError, "E must be a number, got '210e9'"),
        ("elastic", (E, None), TypeError, "nu must be a number, got None"),
        ("perfect_plastic", (E, NU, 0.0), ValueError, "yield_stress must be a finite number > 0"),
        ("perfect_plastic", (E, 0.5, 1e9), ValueError, "nu must be in [0, 0.5), got 0.5"),
        (
            "linear_hardening",
            (E, NU, 1e9, E),
            ValueError,
            "tangent_modulus must be in [0, E) with E = 2.1e+11 Pa, got 2.1e+11",
        ),
        ("linear_hardening", (E, NU, 1e9, 2 * E), ValueError, "tangent_modulus must be in [0, E)"),
        ("linear_hardening", (E, NU, 1e9, -1.0), ValueError, "tangent_modulus must be a finite"),
        ("linear_hardening", (E, NU, -1e9, 1e9), ValueError, "yield_stress must be a finite num"),
        ("linear_hardening", (E, NU, 1e9, math.nan), ValueError, "tangent_modulus must be a fin"),
        ("swift", (E, NU, 0.0, 20.0, 0.1), ValueError, "B must be a finite number > 0 [Pa], got 0"),
        ("swift", (E, NU, 1e9, 0.0, 0.1), ValueError, "C must be a finite number > 0 [microstr"),
        ("swift", (E, NU, 1e9, -4.0, 0.1), ValueError, "C must be a finite number > 0 [microstr"),
        ("swift", (E, NU, 1e9, 20.0, -0.1), ValueError, "n must be in [0, 1], got -0.1"),
        ("swift", (E, NU, 1e9, 20.0, 1.1), ValueError, "n must be in [0, 1], got 1.1"),
        ("swift", (E, NU, 1e9, 20.0, math.nan), ValueError, "n must be in [0, 1], got nan"),
    ],
)
def test_refused(law, arguments, error, text):
    with pytest.raises(error, match=re.escape(text)):
        getattr(sc.Material, law)(*arguments)


def test_unknown_law():
    with pytest.raises(ValueError, match=r"law must be one of elastic, rigid, .* got 'viscous'"):
        sc.Material("viscous", {})


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("g", [1e-13, 1e-7, 2e-5, 3e-3, 0.7, 20.0])
def test_plastic_work_of_every_law(law, g):
    """Gauss integration on growing intervals is exact to rounding for smooth yield stress."""
    material = make(law)  # a law without an entry above is not tested
    kinks = [k for k in material.parameters.get("plastic_strain", ()) if k < g]
    ends = np.union1d(kinks, [0.0, *np.geomspace(min(g, 1e-8), g, 40)])
    points, weights = np.polynomial.legendre.leggauss(20)
    half, middle = 0.5 * np.diff(ends)[:, None], 0.5 * (ends[1:] + ends[:-1])[:, None]
    if material.is_plastic:
        expected = float(np.sum(half * weights * material.yield_stress(middle + half * points)))
        assert material.plastic_work(g) == pytest.approx(expected, rel=1e-13)
    else:
        assert material.plastic_work(g) == 0.0
    assert material.plastic_work([g, 0.0]).tolist() == [material.plastic_work(g), 0.0]


@pytest.mark.parametrize("law", LAWS)
def test_constants_of_a_law_are_shown(law):
    names = LAWS[law].constants
    assert list(make(law).parameters) == list(names)
    some = next(iter(names), "K")
    listed = re.escape(", ".join(names) or "none")
    with pytest.raises(ValueError, match=rf"parameters of '{law}' must be {listed}, got {some}"):
        sc.Material(law, {some: 1.0})
    for given in (None, 3.0, [("E", 1.0)]):
        with pytest.raises(TypeError, match="parameters must be a mapping"):
            sc.Material(law, given)
    if names:
        with pytest.raises(TypeError, match="E must be a number, got '210e9'"):
            sc.Material(law, dict.fromkeys(names, "210e9"))
    backwards = dict(reversed(list(make(law).parameters.items())))
    assert repr(sc.Material(law, backwards)) == repr(make(law))
