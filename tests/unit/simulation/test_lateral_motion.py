# SPDX-License-Identifier: GPL-3.0-or-later
"""Motion along y with a history: it equals motion along x with exchanged axes."""

import math

import numpy as np
import pytest

import samcontact as sc

CELL = 1e-5
SIZES = 36, 28
STEEL = sc.Material.linear_hardening(210e9, 0.3, 1e9, 20e9)
HARD = sc.Material.elastic(400e9, 0.25)
KINEMATIC = sc.Material.perfect_plastic(210e9, 0.3, 1.0e9).with_kinematic_hardening(30e9, 40.0)
ALUMINIUM = sc.Material.elastic(70e9, 0.33)
HOT = STEEL.with_thermal(50.2, 11.7e-6, 1.367e-5)
# Cells along the first and the second axis by which the bodies move: they turn, and leave their
# tractions behind.
TURNS = [(-1, 0), (-1, 0), (0, 2), (1, -1), (12, -9), (-1, 1)]


def pair(first, second, exchanged):
    return (second, first) if exchanged else (first, second)


def build(exchanged, body1, body2, friction, periodic, **settings):
    n = pair(*SIZES, exchanged)
    deep = any(body.is_plastic for body in (body1, body2))
    given = {"dz": CELL} if deep else {}
    if periodic is not None:
        given |= {"periodic": "xy"[(periodic + exchanged) % 2]} | ({"nz": 14} if deep else {})
    grid = sc.Grid(*n, CELL, CELL, **given)
    scale = 0.5 if deep else 1.0
    radii = pair(5e-3 * scale, math.inf if periodic == 1 else 8e-3 * scale, exchanged)
    gap = sc.surfaces.paraboloid(grid, *radii)
    return sc.Simulation(grid, body1, body2, gap, friction=friction(exchanged), **settings)


def path(exchanged, load, moves, sticks, duration):
    lasting = {} if duration is None else {"duration": duration}
    steps = [{"load": load} | lasting]
    for first, second in moves:
        by = pair(first * CELL, second * CELL, exchanged)
        step = {"load": load, "advance": (by, by)} | lasting
        if sticks:
            step |= {"shift": pair(2e-8, 1e-8, exchanged), "twist": -1e-4 if exchanged else 1e-4}
        steps.append(step)
    return steps


def constant(law):
    return lambda exchanged: law


@pytest.mark.parametrize(
    ("bodies", "friction", "load", "options"),
    [
        ((HARD, ALUMINIUM), constant(sc.Coulomb(0.3)), 5.0, {}),
        ((HARD, ALUMINIUM), lambda e: sc.Anisotropic(0.3, 0.2, math.pi / 2 - 0.4 if e else 0.4),
         5.0, {}),
        ((HARD, ALUMINIUM),
         lambda e: sc.MappedCoulomb([0.1, 0.3], **{"y" if e else "x": [-6e-5, 6e-5]}, body=2),
         5.0, {}),
        ((HARD, ALUMINIUM), constant(sc.FallingCoulomb(0.3, 0.2, 0.05, memory=1e-6)), 5.0,
         {"duration": 1e-5}),
        ((HARD, ALUMINIUM), constant(sc.ThirdBody(0.3, 1e9, 1e9, 1e-6)), 5.0, {}),
        ((HARD, STEEL), constant(sc.Coulomb(0.3)), 30.0, {}),
        ((STEEL, STEEL), constant(0.0), 30.0, {}),
        ((HARD, KINEMATIC), constant(0.0), 90.0, {"periodic": 1, "moves": [(-1, 0)] * 4}),
        # In sub-increments, the bodies move along y by whole cells, along x by parts of cells.
        ((HARD, KINEMATIC), constant(0.0), 30.0,
         {"increment_tol": 0.02, "moves": [(-1, 0)] * 2, "tol": 0.04}),
    ],
    ids=["slip", "anisotropic", "mapped", "falling", "third body", "slip and yield", "equal bodies",
         "line", "sub-increments"],
)  # fmt: skip
@pytest.mark.filterwarnings("ignore")
def test_exchanged_axes(bodies, friction, load, options):
    options = {
        "periodic": None,
        "duration": None,
        "moves": TURNS,
        "increment_tol": None,
        "tol": 1e-6,
    } | options
    moves, duration = options.pop("moves"), options.pop("duration")
    tol = options.pop("tol")
    found = []
    for exchanged in (False, True):
        simulation = build(exchanged, *bodies, friction, tol=1e-9, **options)
        steps = path(exchanged, load, moves, simulation.engine.setup.friction.sticks, duration)
        found.append(simulation.run(steps, progress=False))
    for straight, turned in zip(*found, strict=True):
        scale = straight.pressure.max()
        np.testing.assert_allclose(turned.pressure.T, straight.pressure, atol=tol * scale)
        shear = np.array([turned.shear[1].T, turned.shear[0].T])
        np.testing.assert_allclose(shear, straight.shear, atol=tol * scale)
        assert turned.lateral_travel == pytest.approx(straight.travel)
        for body in (1, 2):
            if bodies[body - 1].is_plastic:
                strain, other = (s.equivalent_plastic_strain(body) for s in (straight, turned))
                layers = min(strain.shape[2], other.shape[2])
                strain, other = strain[..., :layers], other.transpose(1, 0, 2)[..., :layers]
                np.testing.assert_allclose(other, strain, atol=tol * strain.max())
                assert strain.max() > 1e-5


@pytest.mark.parametrize(
    ("body", "friction", "advance", "text"),
    [
        (
            ALUMINIUM,
            sc.Coulomb(0.3),
            ((0, 0.5), (0, 0.5)),
            "along y must be a multiple of the cell",
        ),
        (ALUMINIUM, sc.Coulomb(0.3), ((0, 1), (0, 0)), "along y must be equal with partial slip"),
        (STEEL, 0.0, ((0, 0.5), (0, 0)), "along y must be a multiple of the cell"),
    ],
)
def test_other_motion_along_y_is_refused(body, friction, advance, text):
    simulation = build(False, HARD, body, constant(friction), None)
    with pytest.raises(ValueError, match=text):
        simulation.step(load=1.0, advance=tuple((CELL * x, CELL * y) for x, y in advance))


def test_fields_along_a_path_need_a_path_along_x():
    simulation = build(False, HARD, STEEL, constant(0.0), None)
    steps = [{"load": 30.0}, {"load": 30.0, "advance": ((0.0, -CELL), (0.0, -CELL))}]
    states = simulation.run(steps, progress=False)
    assert states[0].track(2).contact == 0.0
    with pytest.raises(ValueError, match=r"body 2 must not be .* of -1e-05 m"):
        states[1].track(2)
    with pytest.raises(ValueError, match="displaced along y"):
        sc.fatigue.dang_van(states, 2, 0.3)


def test_an_eigenstrain_moves_with_its_body():
    pressures = []
    for exchanged in (False, True):
        simulation = build(exchanged, HARD, STEEL, constant(0.0), None, tol=1e-10)
        simulation.step(load=1.0, advance=(pair(CELL, 0.0, exchanged),) * 2)
        first, size = (pair(*cells, exchanged) for cells in ((20, 8), (3, 5)))
        simulation.add_eigenstrain(2, [1e-3] * 3 + [0.0] * 3, (*first, 1), (*size, 2))
        state = simulation.step(load=1.0, advance=(pair(-3 * CELL, 0.0, exchanged),) * 2)
        pressures.append(state.pressure.T if exchanged else state.pressure)
    plain = build(False, HARD, STEEL, constant(0.0), None).step(load=1.0).pressure
    assert np.abs(pressures[0] - plain).max() > 0.01 * plain.max()
    np.testing.assert_allclose(pressures[1], pressures[0], atol=1e-8 * plain.max())


def test_a_body_periodic_along_y_does_not_yield_and_move_along_y():
    simulation = build(False, HARD, STEEL, constant(0.0), 1)
    with pytest.raises(ValueError, match="periodic along y: exchange the axes"):
        simulation.step(load=1.0, advance=((0.0, CELL), (0.0, CELL)))
