# SPDX-License-Identifier: GPL-3.0-or-later
"""Critical values against published numbers and against Hertz contact at the onset of yield."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad

import samcontact as sc
from samcontact import critical, hertz
from samcontact._util.tensors import von_mises

E_STAR = 111.40819964e9
ASPERITIES = {"R": 0.5, "E_star": E_STAR, "nu": 0.32, "yield_stress": 0.9115e9}


def test_green_published_values():
    values = critical.green(**ASPERITIES)
    assert values.interference == pytest.approx(2.2143e-4, rel=2e-5)
    assert values.load == pytest.approx(346092.8, rel=1e-6)
    assert values.energy == pytest.approx(30.654, rel=2e-5)
    assert pytest.approx(1.30075 + 0.87825 * 0.32 + 0.54373 * 0.32**2, rel=1e-15) == values.C


@pytest.mark.parametrize(
    "model", [critical.green, critical.onset, critical.kogut_etsion, critical.jackson_green]
)
def test_sphere_is_a_hertz_contact_with_its_energy(model):
    values = model(**ASPERITIES)
    contact = hertz.point(0.5, E_STAR, p0=values.p0)
    assert values.p0 == pytest.approx(values.C * 0.9115e9, rel=1e-14)
    assert values.interference == pytest.approx(contact.approach, rel=1e-13)
    assert values.load == pytest.approx(contact.load, rel=1e-13)
    assert values.a == pytest.approx(contact.a, rel=1e-13)
    energy, _ = quad(
        lambda w: hertz.point(0.5, E_STAR, approach=w).load, 0.0, values.interference, epsrel=1e-10
    )
    assert values.energy == pytest.approx(energy, rel=1e-8)


@pytest.mark.parametrize(
    ("nu", "C"), [(0.25, 1.55435), (0.3, 1.61280), (0.32, 1.63697), (0.5, 1.87724)]
)
def test_onset_exact_C(nu, C):
    assert pytest.approx(C, rel=5e-6) == critical.onset(1.0, 1.0, nu, 1.0).C


@given(nu=st.floats(0.0, 0.5))
def test_fits_stay_within_their_stated_error(nu):
    arguments = {"R": 1.0, "E_star": 1.0, "nu": nu, "yield_stress": 1.0}
    exact = critical.onset(**arguments).C
    for fit in (critical.green, critical.jackson_green):
        assert pytest.approx(exact, rel=4e-3) == fit(**arguments).C
    exact = critical.onset_cylinder(**arguments).C
    assert pytest.approx(exact, rel=1.3e-3) == critical.green_cylinder(**arguments).C


def test_cylinder_is_a_line_contact():
    values = critical.onset_cylinder(1.0, E_STAR, 0.3, 1e9)
    assert pytest.approx(1.79367, rel=5e-6) == values.C
    contact = hertz.line(1.0, E_STAR, p0=values.p0)
    assert values.load_per_length == pytest.approx(contact.load_per_length, rel=1e-13)
    assert values.b == pytest.approx(contact.b, rel=1e-13)
    # below nu = 0.1938 the surface yields first, in plane strain at p0 (1 - 2 nu)
    assert pytest.approx(1.25, rel=1e-12) == critical.onset_cylinder(1.0, 1.0, 0.1, 1.0).C


def test_kogut_etsion_interference():
    K, H = 0.454 + 0.41 * 0.32, 2.8 * 0.9115e9
    expected = (3.141592653589793 * K * H / (2 * E_STAR)) ** 2 * 0.5
    assert critical.kogut_etsion(**ASPERITIES).interference == pytest.approx(expected, rel=1e-13)
    harder = critical.kogut_etsion(**ASPERITIES, hardness=2 * H)
    assert harder.interference == pytest.approx(4 * expected, rel=1e-13)


@pytest.mark.parametrize(
    "model",
    [
        critical.green,
        critical.onset,
        critical.jackson_green,
        critical.green_cylinder,
        critical.onset_cylinder,
    ],
)
@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"nu": 0.51}, r"nu must be in \[0, 0\.5\], got 0\.51"),
        ({"yield_stress": 0.0}, "yield_stress must be a finite number > 0, got 0.0"),
        ({"R": -1.0}, "R must be a finite number > 0, got -1.0"),
        ({"E_star": float("nan")}, "E_star must be a finite number > 0, got nan"),
    ],
)
def test_bad_input_is_named(model, changed, message):
    with pytest.raises(ValueError, match=message):
        model(**{**ASPERITIES, **changed})


E, NU = 210e9, 0.3
PLAIN = sc.Material.perfect_plastic(E, NU, 1e9)
FLAT = {"R": 1e-2, "E_star": E / (1 - NU**2)}


@pytest.mark.parametrize("friction", [0.0, 0.2, 0.5])
def test_a_constant_profile_gives_the_onset_of_a_homogeneous_body(friction):
    found = critical.onset_over_depth(**FLAT, body=PLAIN, friction=friction)
    expected = critical.onset_sliding(**FLAT, nu=NU, yield_stress=1e9, friction=friction)
    assert pytest.approx(found.C, rel=1e-9) == expected.C
    assert found.load == pytest.approx(expected.load, rel=1e-8)
    assert (found.x, found.z) == pytest.approx((expected.x, expected.z), abs=1e-4 * found.a)
    if friction == 0:
        exact = critical.onset(**FLAT, nu=NU, yield_stress=1e9)
        assert pytest.approx(found.C, rel=1e-9) == exact.C


def test_first_yield_of_a_hardened_case_agrees_with_finite_elements():
    """First yield is at p0 = 1.80 GPa, at a depth of 0.71 radii of that case."""
    z, a = np.linspace(0.0, 2e-3, 201), 1e-3
    body = sc.Material.swift(E, NU, 700e6, 20.0, 0.1)
    body = body.with_yield_profile(z, 1 + 0.6 * np.exp(-((z / 0.5e-3) ** 2)))
    body = body.with_residual_stress(z, -400e6 * np.exp(-((z / 0.4e-3) ** 2)))
    found = critical.onset_over_depth(2 * a * FLAT["E_star"] / np.pi / 1.8e9, FLAT["E_star"], body)
    assert found.a == pytest.approx(a, rel=0.005)
    assert found.p0 == pytest.approx(1.80e9, rel=0.005)
    assert found.z == pytest.approx(0.71 * a, abs=0.01 * a)


@pytest.mark.parametrize(
    ("z", "factor", "stress", "depth"),
    [
        ([0.0, 80e-6, 81e-6], [2.0, 2.0, 1.0], 0.0, (81e-6, 81e-6)),  # below the case
        ([0.0, 5e-6, 6e-6], [0.2, 0.2, 1.0], 0.0, (0.0, 5e-6)),  # in the skin
        ([0.0], [1.0], -4e8, (70e-6, 80e-6)),  # pressed along the surface
    ],
)
def test_first_yield_agrees_with_the_stress_along_fine_lines(z, factor, stress, depth):
    """No point of ten thousand yields below the critical load; at least one yields above it."""
    body = PLAIN.with_yield_profile(z, factor).with_residual_stress([0.0], [stress])
    found = critical.onset_over_depth(**FLAT, body=body)
    assert depth[0] <= found.z <= depth[1]
    r = np.linspace(0.0, 1.2, 101)[:, None] * found.a
    depths = np.unique(np.concatenate([np.linspace(0.0, 3 * found.a, 150), z, [found.z]]))
    for part, yields in ((1 - 1e-6, False), (1 + 1e-3, True)):
        contact = hertz.point(**FLAT, p0=part * found.p0)
        s = contact.stress(r, 0.0, depths, NU)
        s[:2] += stress
        ratio = von_mises(s) / (1e9 * np.interp(depths, z, factor))
        assert (ratio.max() >= 1) is np.bool_(yields)


def test_residual_shear_stress_helps_in_one_direction():
    """Initial pure shear, along a line without symmetry."""
    size = 3e8
    ways = [
        critical.onset_over_depth(
            **FLAT,
            body=PLAIN.with_residual_stress(
                [0.0], [size * np.cos(2 * t)], [-size * np.cos(2 * t)], [size * np.sin(2 * t)]
            ),
        )
        for t in (0.0, 0.3, np.pi / 4)
    ]
    assert [way.load for way in ways] == pytest.approx([ways[0].load] * 3, rel=1e-6)
    # On the axis s_rr, twice, and s_zz: 1/2 ((s_xx - s_yy)^2 + ...) = (s_zz - s_rr)^2 + 3 s^2.
    alone = critical.onset(**FLAT, nu=NU, yield_stress=np.sqrt(1e18 - 3 * size**2))
    assert ways[0].load == pytest.approx(alone.load, rel=1e-6)


@pytest.mark.parametrize("nu", [0.1, 0.3, 0.45])
def test_a_line_contact_on_a_constant_profile_agrees_with_its_closed_form(nu):
    body = sc.Material.perfect_plastic(E, nu, 1e9)
    found = critical.onset_cylinder_over_depth(**FLAT, body=body)
    exact = critical.onset_cylinder(**FLAT, nu=nu, yield_stress=1e9)
    assert pytest.approx(exact.C, rel=1e-8) == found.C
    assert found.load_per_length == pytest.approx(exact.load_per_length, rel=1e-8)
    assert found.x == pytest.approx(0.0, abs=1e-4 * found.b)


@pytest.mark.parametrize(
    ("z", "factor", "sxx", "syy"),
    [
        ([0.0, 0.9, 1.0], [1.6, 1.5, 1.0], 0.0, 0.0),  # below the case
        ([0.0, 0.05, 0.1], [0.4, 0.4, 1.0], 0.0, 0.0),  # in the skin
        ([0.0, 1.0], [1.0, 1.1], -3e8, 2e8),
    ],
)
def test_first_yield_of_a_line_contact_agrees_with_sums_over_strips(z, factor, sxx, syy):
    """Against sums over the strips of a periodic grid; z in half-widths."""
    b = critical.onset_cylinder(**FLAT, nu=NU, yield_stress=1e9).b
    body = PLAIN.with_yield_profile(np.multiply(z, b), factor)
    body = body.with_residual_stress([0.0], [sxx], [syy])
    found = critical.onset_cylinder_over_depth(**FLAT, body=body)
    grid = sc.Grid(481, 1, found.b / 200, 1.0, periodic="y")
    pressure = found.p0 * np.sqrt(np.maximum(1 - (grid.x / found.b) ** 2, 0.0))[:, None]
    depths = np.unique(np.concatenate([found.b * np.linspace(0.0, 1.5, 76), b * np.array(z[1:])]))
    solver = sc.ContactSolver(grid, sc.Material.rigid(), PLAIN)
    stress = solver.stress(pressure, depths)
    stress[0] += sxx
    stress[1] += syy
    used = von_mises(stress)[:, 0] / (1e9 * body.yield_factor(depths))
    assert used.max() == pytest.approx(1.0, abs=5e-3)
    i, k = np.unravel_index(int(used.argmax()), used.shape)
    assert depths[k] == pytest.approx(found.z, abs=0.05 * found.b)
    assert abs(grid.x[i]) == pytest.approx(abs(found.x), abs=0.05 * found.b)


def test_bodies_without_first_yield_are_refused():
    with pytest.raises(ValueError, match="body must be elastic-plastic, got law 'elastic'"):
        critical.onset_over_depth(**FLAT, body=sc.Material.elastic(E, NU))
    with pytest.raises(TypeError, match="body"):
        critical.onset_over_depth(**FLAT, body=1e9)
    with pytest.raises(ValueError, match="residual stress already reaches the yield stress"):
        critical.onset_over_depth(**FLAT, body=PLAIN.with_residual_stress([0.0], [1e9]))
