# SPDX-License-Identifier: GPL-3.0-or-later
"""Steady films: published films, balance of the flow, symmetries, cavitation and dry limit."""

import warnings

import numpy as np
import pytest

import samcontact as sc
from samcontact import _core
from samcontact.lubrication.nested import FilmTask, table_of

E_STAR, R, ETA, ALPHA = 113.74e9, 0.01, 0.04, 22e-9
BODY = sc.Material.elastic(2 * E_STAR * 0.91, 0.3)
OIL = sc.Lubricant.roelands(viscosity=ETA, pressure_viscosity=ALPHA)


class Point:
    """Circular contact with given numbers of Moes on a square grid of a width in contact radii.

    shift: distance of the contact behind the centre of the grid [radii].
    """

    def __init__(self, M, L, n, width, oil=OIL, shift=0.0):
        group = (L / (ALPHA * 2 * E_STAR)) ** 4  # eta0 (u1 + u2)/(E' R)
        self.u = 0.5 * group * 2 * E_STAR * R / ETA
        self.load = M * 2 * E_STAR * R**2 * group**0.75
        self.scale = R * np.sqrt(group)
        self.a = (0.75 * self.load * R / E_STAR) ** (1 / 3)
        step = width * self.a / n
        self.grid = sc.Grid(n, n, step, step)
        x, y = self.grid.x[:, None] - shift * self.a, self.grid.y[None, :]
        self.gap = 0.5 * (x**2 + y**2) / R
        self.oil = oil

    def solve(self, speed=None, **more):
        speed = (self.u, self.u) if speed is None else speed
        target = {} if "approach" in more or "load" in more else {"load": self.load}
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return sc.lubrication.steady(
                self.grid, BODY, BODY, self.gap, speed=speed, lubricant=self.oil,
                **target, **more,
            )  # fmt: skip


def test_central_film_of_a_heavily_loaded_ball():
    """M 200, L 10: 3.630 at 24 cells per radius (finite volumes of other code)."""
    ball = Point(200, 10, 96, 4.0, shift=0.5)
    film = ball.solve()
    assert film.central_film / ball.scale == pytest.approx(3.630, rel=5e-3)
    assert film.minimum_film / ball.scale == pytest.approx(1.75, rel=3e-2)
    assert max(level.iterations for level in film.levels) <= 12
    assert film.pressure.sum() * ball.grid.cell_area == pytest.approx(ball.load, rel=1e-6)
    assert Point(200, 10, 48, 4.0, shift=0.5).solve().central_film / ball.scale == pytest.approx(
        3.608, rel=2e-3
    )
    # at the same approach, the load is an unknown
    same = ball.solve(approach=film.approach)
    assert same.load == pytest.approx(ball.load, rel=1e-4)


def test_film_without_compression_is_near_the_formula_of_nijenbanning():
    oil = sc.Lubricant.roelands(viscosity=ETA, pressure_viscosity=ALPHA, density=None)
    ball = Point(20, 10, 96, 9.0, oil)
    contact = sc.hertz.point(R, E_STAR, load=ball.load)
    formula = sc.lubrication.nijenbanning(contact, (ball.u, ball.u), oil)
    assert ball.solve().central_film == pytest.approx(formula, rel=0.04)


@pytest.mark.parametrize(("M", "L", "central", "minimum"), [(10, 10, 4.796, 4.0925)])
def test_film_of_a_line_contact(M, L, central, minimum):
    """Other finite volumes, 1024 cells, window -5 to 1.5 half-widths."""
    group = (L / (ALPHA * 2 * E_STAR)) ** 4
    u, per_length = group * E_STAR * R / ETA, M * 2 * E_STAR * R * np.sqrt(group)
    b = np.sqrt(4 * per_length * R / (np.pi * E_STAR))
    grid = sc.Grid(512, 1, 10 * b / 512, 1e-3, periodic="y")
    film = sc.lubrication.steady(
        grid, BODY, BODY, sc.surfaces.paraboloid(grid, R, np.inf), load=1e-3 * per_length,
        speed=(u, u), lubricant=OIL,
    )  # fmt: skip
    scale = R * np.sqrt(group)
    assert film.central_film / scale == pytest.approx(central, rel=1e-3)
    assert film.minimum_film / scale == pytest.approx(minimum, rel=1e-3)


def test_directions_and_units_do_not_matter():
    ball = Point(200, 10, 48, 4.8)
    film, u = ball.solve(tol=1e-8), ball.u
    peak = film.pressure.max()
    back = ball.solve((-u, -u), tol=1e-8)
    assert np.abs(film.pressure - back.pressure[::-1]).max() < 1e-6 * peak
    across = ball.solve(((0.0, u), (0.0, u)), tol=1e-8)
    assert np.abs(film.pressure - across.pressure.T).max() < 1e-6 * peak
    slanted = ball.solve((((0.8**0.5) * u, 0.2**0.5 * u),) * 2)
    assert slanted.central_film == pytest.approx(film.central_film, rel=1e-2)
    # a scene of twice the length, with the same stresses
    twice = Point(200, 10, 48, 4.8)
    grid = sc.Grid(48, 48, 2 * ball.grid.dx, 2 * ball.grid.dy)
    large = sc.lubrication.steady(
        grid, BODY, BODY, sc.surfaces.paraboloid(grid, 2 * R), load=4 * twice.load,
        speed=(2 * u, 2 * u), lubricant=OIL, tol=1e-8,
    )  # fmt: skip
    np.testing.assert_allclose(large.film, 2 * film.film, rtol=1e-6)


def test_spin_and_starvation_thin_the_film():
    """Spin 0.3 u/a: 13 % below the straight film; supply in thicknesses of the central film."""
    ball = Point(200, 10, 48, 5.0)
    film = ball.solve()
    spun = ball.solve(spin=0.3 * ball.u / ball.a)
    assert spun.minimum_film / film.minimum_film == pytest.approx(0.87, abs=0.02)
    for supply, expected in ((8.0, 0.998), (1.5, 0.876)):
        starved = ball.solve(supply=supply * film.central_film)
        assert starved.central_film / film.central_film == pytest.approx(expected, abs=0.01)
    assert (starved.filling < 1).sum() > (film.filling < 1).sum()


def flow_of(film, order=3):
    """Return the outflow of each cell of a solution [m^3/s]."""
    task = FilmTask(
        (BODY, BODY), film.gap, True, film.load, film.velocities, film.spin, film.lubricant,
        np.inf, None, order, 1e-6, 40,
    )  # fmt: skip
    along_x, along_y = task.face_velocities(film.grid)
    fields = [np.ascontiguousarray(f) for f in (film.fluid_pressure, film.film, 1 - film.filling)]
    return _core.film_outflow(
        film.grid._core, table_of(film.lubricant, film.pressure.max()), along_x, along_y, order,
        np.inf, 0.0, fields,
    )  # fmt: skip


def test_mass_of_every_closed_box_is_conserved():
    ball = Point(200, 10, 48, 4.8)
    film = ball.solve(tol=1e-10)
    through = ball.u * film.central_film * ball.grid.dy
    outflow = flow_of(film)
    random = np.random.default_rng(1)
    for _ in range(20):
        i, j = (np.sort(random.choice(49, 2, replace=False)) for _ in range(2))
        box = outflow[i[0] : i[1], j[0] : j[1]]
        assert abs(box.sum()) < 1e-10 * through * max(i[1] - i[0], j[1] - j[0])
    assert np.all(film.fluid_pressure[film.filling < 1] == 0)
    assert film.fluid_pressure.min() >= 0


def test_derivatives_of_the_flow_are_those_of_finite_differences():
    """Newton converges quadratically only with the exact derivatives: few iterations at 1e-10."""
    film = Point(200, 10, 48, 4.8).solve(tol=1e-10)
    assert film.iterations <= 8
    assert film.residual < 1e-10


def test_films_open_from_the_dry_contact():
    """Shares of a layer of 1 nm at increasing speeds, smooth, order 1 (other code)."""
    ball = Point(200, 10, 32, 4.0)
    layer = sc.lubrication.Boundary(1e-9)
    speeds = [4.533e-7, 3.305e-4, 9.914e-4, 8.9e-3]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        curve = sc.lubrication.stribeck(
            ball.grid, BODY, BODY, ball.gap, load=ball.load, speeds=speeds, lubricant=OIL,
            boundary=layer, order=1,
        )  # fmt: skip
    np.testing.assert_allclose(curve.boundary_share, [0.9999, 0.7721, 0.483, 0.0295], atol=2e-3)
    assert np.all(np.diff(curve.central_film) > 0)
    difference = curve.solutions[0].pressure - curve.dry_pressure
    assert np.linalg.norm(difference) == pytest.approx(
        2.03e-3 * np.linalg.norm(curve.dry_pressure), rel=0.02
    )
    # a single solution finds the same state
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        alone = sc.lubrication.steady(
            ball.grid, BODY, BODY, ball.gap, load=ball.load, speed=(speeds[2],) * 2, lubricant=OIL,
            boundary=layer, order=1,
        )  # fmt: skip
    assert alone.boundary_share == pytest.approx(curve.boundary_share[2], rel=1e-3)


@pytest.mark.parametrize(
    ("thickness", "speed", "share"), [(100e-9, 1.0, 0.22), (100e-9, 3e-3, 1.0), (1e-6, 1.0, 0.99)]
)
def test_layers_as_thick_as_the_film_bear_the_load_with_it(thickness, speed, share):
    ball = Point(200, 10, 32, 5.0)
    layer = sc.lubrication.Boundary(thickness, pressure=5e8)
    film = ball.solve(speed=(speed, speed), load=20.0, boundary=layer)
    assert film.boundary_share == pytest.approx(share, abs=0.03)
    assert film.minimum_film > thickness
    law = 5e8 * (thickness / (film.film - thickness)) ** 3
    np.testing.assert_allclose(film.boundary_pressure, law, rtol=2e-3, atol=1e-5 * law.max())
    total = film.pressure.sum() * ball.grid.cell_area
    assert total == pytest.approx(20.0, rel=1e-5)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("M", "L", "n", "width", "central"),
    [
        (200, 10, 192, 4.0, 3.638),
        (20, 10, 192, 9.0, 4.158),
        (1000, 10, 192, 3.5, 3.188),
        (1000, 20, 96, 3.5, 4.87),
    ],
)
def test_films_of_light_and_heavy_loads(M, L, n, width, central):
    ball = Point(M, L, n, width, shift=0.25)
    film = ball.solve()
    assert film.central_film / ball.scale == pytest.approx(central, rel=5e-3)
    assert film.iterations <= 12


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"load": -1.0}, "load must be"),
        ({"speed": (1.0, -1.0)}, "mean speed of the surfaces or the spin"),
        ({"speed": (1.0, 2.0, 3.0)}, r"speed must be \(u1, u2\)"),
        ({"order": 4}, "order must be"),
        ({"tol": 1.0}, "tol must be"),
        ({"supply": 0.0}, "supply must be"),
        ({"grid": sc.Grid(16, 16, 1e-5, 1e-5, periodic="x")}, "grid must not be periodic"),
        ({"grid": sc.Grid(16, 1, 1e-5, 1e-5)}, "line contact"),
    ],
)
def test_wrong_arguments_are_named(change, message):
    given = {"grid": sc.Grid(16, 16, 1e-5, 1e-5), "load": 40.0, "speed": (1.0, 1.0)} | change
    grid = given.pop("grid")
    gap = sc.surfaces.paraboloid(grid, R)
    with pytest.raises(ValueError, match=message):
        sc.lubrication.steady(grid, BODY, BODY, gap, lubricant=OIL, **given)


def test_coarse_cells_and_a_short_inlet_are_told():
    ball = Point(20, 10, 48, 3.0)
    with pytest.warns(sc.GridTooSmallWarning, match="enlarge the grid towards the inlet"):
        sc.lubrication.steady(
            ball.grid, BODY, BODY, ball.gap, load=ball.load, speed=(ball.u,) * 2, lubricant=OIL
        )
    coarse = Point(200, 10, 32, 4.8)
    with pytest.warns(sc.ResolutionWarning, match="cells per contact radius"):
        sc.lubrication.steady(
            coarse.grid, BODY, BODY, coarse.gap, load=coarse.load, speed=(coarse.u,) * 2,
            lubricant=OIL,
        )  # fmt: skip
