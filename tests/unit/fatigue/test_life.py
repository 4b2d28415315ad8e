# SPDX-License-Identifier: GPL-3.0-or-later
"""Life from stressed volume: exponents of load, scaling of volume, limits, relative lives."""

import math

import numpy as np
import pytest

import samcontact as sc

BODY = sc.Material.elastic(206e9, 0.3)
E_STAR = 113e9


def line_shear(p0, body=BODY, friction=0.0):
    contact = sc.hertz.line(10e-3, E_STAR, p0=p0)
    seen = sc.fatigue.hertz_cycle(contact, body, friction=friction)
    return contact.load_per_length, sc.fatigue.orthogonal_shear(seen)


def point_shear(p0):
    contact = sc.hertz.point(10e-3, E_STAR, p0=p0)
    z, y = np.linspace(0.1, 1.5, 8) * contact.a, np.linspace(-1.2, 1.2, 7) * contact.a
    seen = sc.fatigue.hertz_cycle(contact, BODY, z=z, y=y)
    return contact.load, sc.fatigue.orthogonal_shear(seen)


def load_exponent(shear, **constants):
    """Exponent p in life ~ load^-p, from two pressures."""
    (load1, field1), (load2, field2) = shear(1.5e9), shear(2.0e9)
    first, second = (sc.fatigue.life(field, **constants) for field in (field1, field2))
    return -math.log(second.relative_to(first)) / math.log(load2 / load1)


def test_lundberg_and_palmgren_exponents_of_load():
    """p = (c - h + 2)/(3 e) = 3 for point and (c - h + 1)/(2 e) = 4 for line contact."""
    assert load_exponent(point_shear) == pytest.approx(3.0, rel=1e-9)
    assert load_exponent(line_shear, weibull=9 / 8) == pytest.approx(4.0, rel=1e-9)
    c, h, e = 8.0, 1.5, 1.3
    constants = {"exponent": c, "depth_exponent": h, "weibull": e}
    assert load_exponent(point_shear, **constants) == pytest.approx((c - h + 2) / (3 * e))
    assert load_exponent(line_shear, **constants) == pytest.approx((c - h + 1) / (2 * e))


def test_zaretsky_exponents_of_load():
    """N ~ tau^-c V^(-1/e) with V ~ a^2 (point, per length) and b^1 * depth (line)."""
    constants = {"model": "zaretsky", "exponent": 9.0, "weibull": 10 / 9}
    assert load_exponent(point_shear, **constants) == pytest.approx((9 + 2 * 0.9) / 3)
    # the field of a line contact has depths only
    assert load_exponent(line_shear, **constants) == pytest.approx((9 + 0.9) / 2)


def test_volume_and_threshold():
    _, field = line_shear(1.5e9)
    base = sc.fatigue.life(field)
    # the weakest link: twice the length, 2^(1/e) shorter life
    double = sc.fatigue.life(field, length=2.0)
    assert base.relative_to(double) == pytest.approx(2 ** (1 / (10 / 9)))
    lives = [
        sc.fatigue.life(field, limit=limit).relative_to(base) for limit in (0.0, 1e8, 2e8, 3.6e8)
    ]
    assert lives[0] == 1.0
    assert (np.diff(lives) > 0).all()
    endless = sc.fatigue.life(field, limit=0.2501 * 1.5e9)
    assert endless.relative_to(base) == math.inf
    assert endless.stressed_volume == 0.0
    assert base.relative_to(endless) == 0.0
    layered = np.linspace(1e8, 2e8, field.values.size)  # a limit for each depth
    assert lives[1] < sc.fatigue.life(field, limit=layered).relative_to(base) < lives[2]


def test_the_integral_of_a_known_field():
    """Stress z over layers to depth 1: integral of z^(c - h) is 1/(c - h + 1)."""
    n = 400
    z = (np.arange(n) + 0.5) / n * 1e-3
    stress = np.zeros((2, 6, 1, n))
    stress[0, 4], stress[1, 4] = 1e11 * z, -1e11 * z
    _, sample = point_shear(1.5e9)
    field = type(sample)(
        "orthogonal_shear", {}, sc.fatigue.orthogonal_shear(stress).values, "Pa",
        {"y": np.zeros(1), "z": z}, 2,
    )  # fmt: skip
    found = sc.fatigue.life(field, exponent=4.0, depth_exponent=1.0)
    expected = 4 * math.log(1e11) + 4 * math.log(1e-3) - math.log(4.0)
    assert found.log_integral == pytest.approx(expected, abs=1e-5)
    fixed = sc.fatigue.life(field, exponent=4.0, depth_exponent=1.0, stress_depth=1e-3)
    other = 4 * math.log(1e11) + 5 * math.log(1e-3) - math.log(5.0) - math.log(1e-3)
    assert fixed.log_integral == pytest.approx(other, abs=1e-5)


def test_lives_from_a_tested_reference():
    reference = sc.fatigue.life(line_shear(1.5e9)[1])
    constant = reference.constant_for(1e8)
    assert reference.cycles(constant) == pytest.approx(1e8)
    other = sc.fatigue.life(line_shear(1.2e9)[1])
    assert other.cycles(constant) == pytest.approx(1e8 * other.relative_to(reference))
    # Weibull: survivors exp(-(N/N0)^e)
    ratio = math.log(0.5) / math.log(0.9)
    assert reference.cycles(constant, 0.5) == pytest.approx(1e8 * ratio ** (1 / (10 / 9)))


def test_residual_compression_prolongs_life():
    treated = BODY.with_residual_stress([0.0, 1e-2], [-300e6, -300e6])
    contact = sc.hertz.line(10e-3, E_STAR, p0=1.5e9)
    plain, pressed = (
        sc.fatigue.life(sc.fatigue.dang_van(sc.fatigue.hertz_cycle(contact, body), slope=0.3),
                        depth_exponent=0.0)
        for body in (BODY, treated)
    )  # fmt: skip
    assert pressed.relative_to(plain) > 3.0


def test_stress_at_the_surface_is_told_and_wrong_input_refused():
    contact = sc.hertz.line(10e-3, E_STAR, p0=1.5e9)
    sliding = sc.fatigue.dang_van(sc.fatigue.hertz_cycle(contact, BODY, friction=0.4), slope=0.3)
    with pytest.warns(sc.ResolutionWarning, match="uppermost layer"):
        sc.fatigue.life(sliding)
    _, field = line_shear(1.5e9)
    top = sc.fatigue.dang_van(sc.fatigue.hertz_cycle(contact, BODY, z=[0.0, 1e-4]), slope=0.3)
    flat = sc.fatigue.dang_van(np.zeros((2, 6, 3)), slope=0.3)
    other = sc.fatigue.dang_van(sc.fatigue.hertz_cycle(contact, BODY), slope=0.3)
    for call, says in (
        (lambda: sc.fatigue.life(top), "no stress above the limit at the depth z = 0"),
        (lambda: sc.fatigue.life(flat), "equivalent stress .* as a function of depth"),
        (lambda: sc.fatigue.life(field, model="miner"), "model must be one of"),
        (lambda: sc.fatigue.life(field, model="zaretsky", depth_exponent=1.0), "depth_exponent"),
        (lambda: sc.fatigue.life(field, limit=[1e8, 2e8]), "one for each of 120 depths"),
        (lambda: sc.fatigue.life(field).relative_to(sc.fatigue.life(field, exponent=9.0)), "same"),
        (lambda: sc.fatigue.life(field).relative_to(sc.fatigue.life(other)), "the criterion"),
        (lambda: sc.fatigue.life(field).cycles(0.0, 1.0), "reliability must be in"),
        (
            lambda: sc.fatigue.life(field, limit=1e9).constant_for(1e6),
            "not exceed the limit anywhere",
        ),
    ):
        with pytest.raises(ValueError, match=says):
            call()


def test_a_dent_shortens_the_life():
    """Relative life of a pass over a dent: its rim adds stress close to the surface."""
    contact = sc.hertz.point(10e-3, E_STAR, p0=2e9)
    cell = contact.a / 8
    grid = sc.Grid(41, 29, cell, cell, 16, cell / 2)
    gap = sc.surfaces.paraboloid(grid, 10e-3)
    path = sc.paths.rolling(load=contact.load, distance=8 * cell, step=2 * cell, increments=1)

    def life(**relief):
        simulation = sc.Simulation(grid, BODY, BODY, gap, **relief)
        states = [one for one in simulation.run(path, progress=False) if one.load > 0]
        stress = sc.fatigue.dang_van(sc.fatigue.cycle(states), slope=0.3)
        assert stress.values.ndim == 3  # volumes of cells: no length of a raceway
        return sc.fatigue.life(stress, model="zaretsky")

    dent = sc.dents.spherical(grid, depth=3e-6, radius=0.4 * contact.a)
    assert life(relief2=dent).relative_to(life()) < 0.8


def lives_over_a_dent(grid):
    """Lives of a smooth raceway, of one with the shape of a dent, and of one with the dent.

    The shape alone lies on an elastic raceway; the dent of a particle also has its residual stress
    and hardening.
    """
    ball = sc.Material.elastic(210e9, 0.3)
    steel = sc.Material.swift(210e9, 0.3, B=945e6, C=20.0, n=0.121)
    particle = sc.overrolling.Particle(radius=500e-6, approach=5e-6)
    dented = sc.overrolling.indent(grid, steel, [particle], increments=12)
    roll = {"load": 79.0, "distance": 320e-6, "step": 16e-6}
    gap = sc.surfaces.paraboloid(grid, 4.7625e-3)
    over = sc.overrolling.roll_over(grid, ball, steel, dented, gap, **roll)

    def states(body, **relief):
        simulation = sc.Simulation(grid, ball, body, gap, **relief)
        simulation.step(load=0.0, advance=(160e-6, 160e-6))
        return simulation.run(sc.paths.rolling(**roll, increments=4), progress=False)

    shape = sc.Relief(-dented.residual_displacement(), dented.first)
    passes = {"smooth": states(steel), "shape": states(ball, relief2=shape), "dent": over.states}
    fields = {
        name: sc.fatigue.dang_van(
            sc.fatigue.cycle([one for one in found if one.load > 0]), slope=0.3
        )
        for name, found in passes.items()
    }
    lives = {name: sc.fatigue.life(one, model="zaretsky") for name, one in fields.items()}
    return {name: lives[name].relative_to(lives["smooth"]) for name in ("shape", "dent")}


@pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
def test_residual_stress_of_a_dent_restores_a_part_of_the_life():
    lives = lives_over_a_dent(sc.Grid(31, 23, 16e-6, 16e-6, 10, 16e-6))
    assert lives["shape"] == pytest.approx(0.36, abs=0.01)
    assert lives["dent"] == pytest.approx(0.53, abs=0.01)


@pytest.mark.slow
def test_lives_over_a_dent_on_finer_cells():
    lives = lives_over_a_dent(sc.Grid(61, 45, 8e-6, 8e-6, 20, 8e-6))
    assert lives["shape"] == pytest.approx(0.27, abs=0.01)
    assert lives["dent"] == pytest.approx(0.47, abs=0.01)
