# SPDX-License-Identifier: GPL-3.0-or-later
"""Transient heat of bodies that move along y, obliquely, and on paths that turn."""

import copy

import numpy as np
import pytest
from heat_setups import ALPHA, COLD, KAPPA, WARM, K, ball

import samcontact as sc

SIZE, STEP = 60e-6, 1e-3
FACTOR, P0 = 0.05, 2e9
WIDTH = 2.5 * SIZE
CERAMIC = sc.Material.elastic(380e9, 0.25).with_thermal(3.0, 7e-6, 1.2e-6)
COATED = sc.Layered([(CERAMIC, 0.5 * SIZE)], WARM)


def simulation(grid, body2=WARM, track=(20 * SIZE, 20 * SIZE), gap=ball, **other):
    heat = sc.Heat(FACTOR, history=(STEP, 1.0), track=track)
    return sc.Simulation(grid, COLD, body2, gap(grid), heat=heat, **other)


def spot(grid, x=0.0, y=0.0):
    return P0 * np.exp(-((grid.x[:, None] - x) ** 2 + (grid.y - y) ** 2) / WIDTH**2)


def fields(state):
    return [state.temperature(2), state.surface_displacement(2), state.stress(2)]


def assert_equal(found, expected, tol):
    for one, other in zip(found, expected, strict=True):
        np.testing.assert_allclose(one, other, rtol=0, atol=tol * np.abs(other).max())


def exchanged(advance):
    return tuple(pair[::-1] for pair in advance)


PATH = [
    {"advance": ((0.0, 0.0), (0.0, 2 * SIZE)), "duration": STEP},
    {"advance": ((0.0, 0.0), (SIZE, 1.5 * SIZE)), "duration": 2 * STEP},
    {"advance": ((0.0, 0.0), (-0.7 * SIZE, 0.3 * SIZE)), "duration": STEP},
]


@pytest.mark.parametrize(
    ("body2", "target", "tol"),
    [
        pytest.param(WARM, "pressure", 1e-11, id="homogeneous"),
        pytest.param(WARM, "load", 1e-6, id="contact"),
        # The fits to the modes of layers differ, because blocks of modes differ.
        pytest.param(COATED, "pressure", 1e-7, id="coated", marks=pytest.mark.slow),
    ],
)
def test_exchanged_axes_give_transposed_fields(body2, target, tol):
    grids = sc.Grid(10, 8, SIZE, 1.25 * SIZE, 2, SIZE), sc.Grid(8, 10, 1.25 * SIZE, SIZE, 2, SIZE)
    one, other = (simulation(grid, body2) for grid in grids)
    for step in PATH:
        # Off the middle, so that nothing is symmetric.
        given = {"pressure": spot(grids[0], SIZE)} if target == "pressure" else {"load": 250.0}
        turned = {n: v.T if n == "pressure" else v for n, v in given.items()}
        expected = one.step(**given, **step)
        found = other.step(**turned, **step | {"advance": exchanged(step["advance"])})
    assert found.lateral_travel == expected.travel
    assert found.travel == expected.lateral_travel == (0.0, pytest.approx(3.8 * 1.25 * SIZE, 0.3))
    stress = found.stress(2).swapaxes(1, 2)[[1, 0, 2, 4, 3, 5]]
    turned = found.temperature(2).swapaxes(0, 1), found.surface_displacement(2).T, stress
    assert expected.temperature(2).max() > 10.0
    assert_equal(turned, fields(expected), tol)


def moving_gaussian(grid, moves, z, order=60):
    """Temperature at depth z under a Gaussian flux, of the bodies' displacements and durations.

    The rectangles of the grid widen the Gaussian; the rest of their effect is of fourth order.
    """
    gauss, weights = np.polynomial.legendre.leggauss(order)
    wide = WIDTH**2 + (grid.dx**2 + grid.dy**2) / 12
    later, moved, rise = 0.0, np.zeros(2), np.zeros((grid.nx, grid.ny))
    for (x, y), dt in reversed(moves):
        # tau = s^2: age of the heat, without the singularity of the newest heat.
        low, high = np.sqrt(later), np.sqrt(later + dt)
        for s, w in zip(low + (high - low) * (gauss + 1) / 2, weights, strict=True):
            tau = s * s
            part = (tau - later) / dt
            spread = wide + 4 * KAPPA * tau
            at_x, at_y = moved[0] + part * x, moved[1] + part * y
            r2 = (grid.x[:, None] - at_x) ** 2 + (grid.y - at_y) ** 2
            value = np.exp(-r2 / spread) / spread * np.exp(-(z**2) / (4 * KAPPA * tau))
            rise += w * (high - low) * value / np.sqrt(np.pi * KAPPA)
        later, moved = later + dt, moved + np.array([x, y])
    return rise * P0 * FACTOR * WIDTH**2 * KAPPA / K


TURN = [((2 * SIZE, 1.3 * SIZE), STEP), ((2 * SIZE, 1.3 * SIZE), STEP), ((-SIZE, 3 * SIZE), STEP)]
TURN += [((-1.5 * SIZE, -4 * SIZE), 2 * STEP), ((0.0, 0.0), STEP)]


def test_a_path_that_turns_equals_a_quadrature_over_moving_sources():
    grid = sc.Grid(40, 36, SIZE / 2, SIZE / 2, 2, SIZE)
    run = simulation(grid)
    for (x, y), dt in TURN:
        state = run.step(pressure=spot(grid), advance=((0, 0), (x, y)), duration=dt)
    for k, z in enumerate((0.5 * SIZE, 1.5 * SIZE)):
        expected = moving_gaussian(grid, TURN, z)
        error = np.abs(state.temperature(2)[:, :, k] - expected).max() / expected.max()
        assert error < 2e-5, error


def test_an_oblique_path_is_the_rotated_path_along_x():
    """The direction (3, 4)/5 maps points of the grid on points of the grid."""
    grid = sc.Grid(15, 15, SIZE, SIZE, 2, SIZE)
    cells = [(0, 0), (1, 0), (-1, 0), (0, 1), (0, -1)]
    turned = [(3 * i - 4 * j + 7, 4 * i + 3 * j + 7) for i, j in cells]
    plain = [(5 * i + 7, 5 * j + 7) for i, j in cells]
    runs = []
    for direction in ((1.0, 0.0), (0.6, 0.8)):
        run = simulation(grid)
        for length in (2.0, 3.0, -1.0):
            move = tuple(length * SIZE * c for c in direction)
            state = run.step(pressure=spot(grid), advance=((0, 0), move), duration=STEP)
        runs.append(state)
    c, s = 0.6, 0.8
    turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    for (i, j), (a, b) in zip(plain, turned, strict=True):
        scale = [np.abs(f).max() for f in fields(runs[0])]
        u = [state.surface_displacement(2) for state in runs]
        assert abs(u[0][i, j] - u[1][a, b]) < 3e-4 * scale[1]
        one, other = (
            state.stress(2)[[0, 5, 4, 5, 1, 3, 4, 3, 2]][(slice(None), *at)].reshape(3, 3, 2)
            for state, at in zip(runs, ((i, j), (a, b)), strict=True)
        )
        rotated = np.einsum("ij,jkl,mk->iml", turn, one, turn)
        assert np.abs(rotated - other).max() < 2e-3 * scale[2]


def test_a_path_with_a_corner_is_the_sum_of_its_legs():
    grid = sc.Grid(10, 8, SIZE, SIZE, 2, SIZE)
    legs = [((0, 0), (2 * SIZE, 0))] * 2 + [((0, 0), (0.4 * SIZE, 2 * SIZE))] * 2
    run = simulation(grid)
    alone = [copy.deepcopy(run), copy.deepcopy(run)]
    for n, advance in enumerate(legs):
        whole = run.step(pressure=spot(grid), advance=advance, duration=STEP)
        parts = [
            each.step(pressure=spot(grid) * (n // 2 == leg), advance=advance, duration=STEP)
            for leg, each in enumerate(alone)
        ]
    heat = [[p.temperature(2), p.temperature(2)] for p in parts]
    total = [sum(each) for each in zip(*heat, strict=True)]
    assert_equal([whole.temperature(2)] * 2, total, 1e-10)
    # A checkpoint holds position and speed along both axes.
    again = copy.deepcopy(run)
    step = {"pressure": spot(grid), "advance": ((0, 0), (-SIZE, 0.5 * SIZE)), "duration": STEP}
    assert all(map(np.array_equal, fields(again.step(**step)), fields(run.step(**step))))
    with pytest.raises(ValueError, match=r"heat.track along y must be at least the length"):
        run.step(load=0.0, advance=((0, 0), (0, 17 * SIZE)), duration=STEP)


def test_a_slow_closed_path_tends_to_the_steady_state_at_rest():
    grid = sc.Grid(10, 8, SIZE, SIZE, 2, SIZE)
    long = 3e4 * WIDTH**2 / KAPPA
    heat = sc.Heat(FACTOR, history=(long, 10 * long), track=(2 * SIZE, 2 * SIZE))
    run = sc.Simulation(grid, COLD, WARM, ball(grid), heat=heat)
    side = 2 * SIZE
    square = [(0, 0), (side, 0), (side, side), (0, side), (0, 0)]
    path = sc.paths.traverse(square, step=side, pressure=spot(grid), slider=1, speed=side / long)
    state = run.run(path, progress=False)[-1]
    assert np.abs(state.lateral_travel).max() < 1e-12 * side
    rest = sc.Simulation(grid, COLD, WARM, ball(grid), heat=sc.Heat(FACTOR))
    expected = rest.step(pressure=spot(grid)).temperature(2)
    # What flows after a time t is missing: a/sqrt(pi kappa t) of the mean temperature.
    assert np.abs(state.temperature(2) - expected).max() < 5e-3 * expected.max()


def test_polygons_converge_to_a_circle_with_the_second_order():
    grid = sc.Grid(18, 18, SIZE, SIZE, 2, SIZE)
    radius, time = 2 * SIZE, 8 * STEP

    def corners(n):
        angle = 2 * np.pi * np.arange(n + 1) / n
        return radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)

    fine = [(tuple(d), time / 256) for d in -np.diff(corners(256), axis=0)]
    expected = moving_gaussian(grid, fine[-128:], 0.5 * SIZE, order=16)
    errors = []
    for n in (4, 8):
        run = simulation(grid)
        for move in -np.diff(corners(n), axis=0)[-(n // 2) :]:
            state = run.step(pressure=spot(grid), advance=((0, 0), move), duration=time / n)
        errors.append(np.abs(state.temperature(2)[:, :, 0] - expected).max() / expected.max())
    assert 3.0 < errors[0] / errors[1] < 6.0
    assert errors[1] < 0.05


ACROSS = {"load": 100.0, "advance": ((0.0, 0.0), (0.0, SIZE)), "duration": STEP}
PLASTIC = sc.Material.linear_hardening(210e9, 0.3, 900e6, 20e9).with_thermal(K, ALPHA, KAPPA)
GRID = sc.Grid(8, 8, SIZE, SIZE, 2, SIZE)


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (
            lambda: simulation(GRID, PLASTIC).step(
                **ACROSS | {"advance": ((0.0, 0.0), (0.5 * SIZE, SIZE))}
            ),
            "must be a multiple of the cell size",
        ),
        (
            lambda: simulation(GRID, relief2=sc.Relief(np.zeros((8, 8)))).step(**ACROSS),
            "with relief1 or relief2",
        ),
        (lambda: simulation(GRID, friction=0.1).step(**ACROSS), "set friction = 0, or prescribe"),
        (lambda: simulation(GRID, track=(0.0, 0.0)), "track must be > 0 along x or y"),
        (
            lambda: simulation(GRID, track=2 * SIZE).step(**ACROSS),
            "heat.track must be > 0 along y if bodies move along y",
        ),
        (
            lambda: simulation(sc.Grid(8, 8, SIZE, SIZE, periodic="y")),
            "heat.track must be 0 along y on a grid",
        ),
        (
            lambda: simulation(GRID).step(load=1.0, advance=(0.0, 0.0, SIZE), duration=STEP),
            r"advance must be a pair \(body 1, body 2\)",
        ),
        (lambda: sc.paths.traverse([(0, 0)], step=1.0, load=1.0), r"points must have shape"),
        (
            lambda: sc.paths.traverse([(0, 0), (0, 0)], step=1.0, load=1.0),
            "points must differ from one to the next",
        ),
    ],
)
def test_invalid_motion_along_y_is_refused(make, text):
    with pytest.raises(ValueError, match=text):
        make()


def test_the_energy_balance_excludes_motion_along_y():
    moved = sc.Simulation(GRID, COLD, WARM, ball(GRID))
    state = moved.step(load=50.0, advance=((0, 0), (0, SIZE)))
    with pytest.raises(ValueError, match="states must not have moved along y"):
        sc.energy.balance(moved, [state])
