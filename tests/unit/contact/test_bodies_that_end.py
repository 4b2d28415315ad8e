# SPDX-License-Identifier: GPL-3.0-or-later
"""Gaps that are infinite outside a body."""

import numpy as np
import pytest
from contact_setups import RIGID, STEEL

import samcontact as sc
from samcontact import plotting, results, surfaces
from samcontact.simulation.repeated import coarsened

SOFT = sc.Material.linear_hardening(210e9, 0.3, 1e9, 10e9)
E_STAR = 210e9 / (1 - 0.3**2)
UM = 1e-6


def ended(grid, gap, radius):
    """Return the gap, infinite beyond a radius."""
    return np.where(np.hypot(grid.x[:, None], grid.y) > radius, np.inf, gap)


@pytest.mark.parametrize("periodic", ["", "y", "xy"])
@pytest.mark.parametrize("friction", [0.0, 0.2, sc.Coulomb(0.3)])
def test_a_body_that_ends_next_to_the_contact(periodic, friction):
    """Cells out of contact do not affect the solution."""
    grid = sc.Grid(72, 64, UM, UM, periodic=periodic)
    gap = surfaces.paraboloid(grid, 1e-3)
    other = sc.Material.elastic(70e9, 0.33)
    solver = sc.ContactSolver(grid, other, STEEL, friction)
    motion = {"shift": (2e-9, 1e-9)} if isinstance(friction, sc.Coulomb) else {}
    end = ended(grid, gap, 28e-6)
    whole, part = (solver.solve(g, load=0.5, **motion) for g in (gap, end))
    body = np.isfinite(end)
    assert part.approach == pytest.approx(whole.approach, rel=1e-7)
    for name in ("pressure", "shear"):
        a, b = getattr(whole, name, 0.0), getattr(part, name, 0.0)
        np.testing.assert_allclose(a, b, rtol=0, atol=1e-6 * whole.pressure.max())
    np.testing.assert_allclose(part.gap[body], whole.gap[body], rtol=0, atol=1e-7 * whole.approach)
    assert np.all(part.gap[~body] == np.inf)
    pressed = solver.solve(end, approach=whole.approach, **motion)
    assert pressed.load == pytest.approx(0.5, rel=1e-6)


@pytest.mark.filterwarnings("ignore::samcontact.SingularPressureWarning")
def test_a_flat_punch():
    """Boussinesq: the load is 2 E* a times the approach."""
    radius, errors = 0.3e-3, []
    for n in (32, 128):
        grid = sc.Grid(n, n, 1e-3 / n, 1e-3 / n)
        gap = ended(grid, np.zeros((n, n)), radius)
        found = sc.ContactSolver(grid, RIGID, STEEL).solve(gap, load=1000.0)
        assert np.all(found.pressure[np.isinf(gap)] == 0.0)
        assert np.all(found.pressure[gap == 0.0] > 0.0)
        errors.append(abs(found.approach * 2 * E_STAR * radius / 1000.0 - 1))
    assert errors[1] < 0.005 < errors[0]


def test_islands_smaller_than_coarse_cells():
    """Every coarse cell is partly outside the body; the solution converges nevertheless."""
    grid = sc.Grid(128, 128, UM, UM, periodic="xy")
    gap = np.full((128, 128), np.inf)
    gap[::4, ::4] = 0.0
    found = sc.ContactSolver(grid, RIGID, STEEL).solve(gap, load=1.0)
    assert np.all((found.pressure > 0) == np.isfinite(gap))
    np.testing.assert_allclose(
        found.pressure[::4, ::4], 1.0 / (32 * 32 * UM**2), rtol=1e-7
    )  # each as the others


PATH = [
    {"load": 1.0},
    {"load": 1.5},
    {"load": 1.5, "advance": (0.0, 2.5e-6)},
    {"load": 1.5, "advance": (0.0, 2.5e-6)},
    {"load": 0.0},
]


class TestSimulation:
    grid = sc.Grid(48, 32, 2 * UM, 2 * UM, dz=2 * UM)
    gap = surfaces.paraboloid(grid, 1e-3)

    def simulation(self, gap):
        return sc.Simulation(self.grid, RIGID, SOFT, gap)

    def test_plastic_and_moving(self, tmp_path):
        """A truncated ball moves over an elastic-plastic body by fractions of a cell."""
        end = ended(self.grid, self.gap, 24e-6)
        expected = self.simulation(self.gap).run(PATH, progress=False)
        simulation = self.simulation(end)
        states = simulation.run(PATH[:3], progress=False)
        simulation.save(tmp_path / "c.h5")
        goes_on = sc.Simulation.load(tmp_path / "c.h5")
        assert np.array_equal(goes_on.initial_gap, end)
        states += goes_on.run(PATH[3:], progress=False)
        for state, whole in zip(states, expected, strict=True):
            top = max(1.0, whole.pressure.max())
            np.testing.assert_allclose(state.pressure, whole.pressure, rtol=0, atol=1e-6 * top)
            assert state.max_plastic_strain_magnitude(2) == pytest.approx(
                whole.max_plastic_strain_magnitude(2), rel=1e-6
            )
            # the grid goes with the ball, to the nearest cell
            np.testing.assert_array_equal(np.isinf(state.gap), np.isinf(end))

    def test_results_figures_and_grid_errors(self, tmp_path):
        end = ended(self.grid, self.gap, 24e-6)
        simulation = self.simulation(end)
        states = simulation.run(PATH[:2], progress=False)
        half = coarsened(simulation, sc.Heat(0.0)).initial_gap
        known = np.isfinite(half)
        assert 0.9 < 4 * known.sum() / np.isfinite(end).sum() < 1.1
        assert np.abs(half[known]).max() <= 1.05 * end[np.isfinite(end)].max()
        errors = sc.estimate_errors(self.simulation(end), PATH[:2], states)
        assert np.isfinite(errors.errors["approach"]).all()
        assert np.isnan(errors.slope_beyond)
        ax = plotting.surface_map(states[-1].gap, self.grid, quantity="gap")
        assert ax.get_title().endswith("white: contact or no body")
        results.save(results.to_dataset(simulation, states), tmp_path / "r.nc")
        with results.open_results(tmp_path / "r.nc") as data:
            np.testing.assert_array_equal(data["gap"].values[-1], states[-1].gap)


def test_the_grid_is_enlarged_over_the_end_of_a_body():
    def gap(grid):
        return ended(grid, surfaces.paraboloid(grid, 1e-3), 30e-6)

    grid = sc.Grid(16, 16, 2 * UM, 2 * UM)
    simulation = sc.Simulation(grid, RIGID, STEEL, gap)
    state = simulation.step(load=3.0)
    assert state.grid.nx > 16
    wide = sc.Grid(64, 64, 2 * UM, 2 * UM)
    expected = sc.Simulation(wide, RIGID, STEEL, gap(wide)).step(load=3.0)
    assert state.approach == pytest.approx(expected.approach, rel=1e-6)

    def narrower(grid):
        return ended(grid, surfaces.paraboloid(grid, 1e-3), 30e-6 * 16 / grid.nx)

    with pytest.raises(sc.GridTooSmallError, match="must give the same result on every grid"):
        sc.Simulation(grid, RIGID, STEEL, narrower).step(load=3.0)


def test_unmeasured_points_are_outside_the_body():
    grid = sc.Grid(40, 40, UM, UM)
    surface = sc.measured.MeasuredSurface(np.zeros((20, 20)), UM)
    gap = surfaces.from_heights(grid, surface.on(grid, fill=-np.inf))
    assert np.isfinite(gap).sum() == 400
    assert np.all(gap[10:30, 10:30] == 0.0)
    upper = surfaces.from_heights(grid, np.zeros((40, 40)), np.where(gap == 0.0, 0.0, np.inf))
    np.testing.assert_array_equal(upper, gap)
    with pytest.raises(ValueError, match="fill must be a finite number, got -inf"):
        surface.relief(sc.Grid(20, 20, UM, UM), fill=-np.inf)


@pytest.mark.parametrize("value", [np.nan, -np.inf])
def test_nan_and_negative_infinity_are_no_gap(value):
    grid = sc.Grid(8, 8, UM, UM)
    gap = surfaces.paraboloid(grid, 1e-3)
    gap[2, 3] = value
    text = rf"gap must be finite everywhere, or \+inf where there is no body, got {value} at"
    for call in (
        lambda: sc.Simulation(grid, RIGID, STEEL, gap),
        lambda: sc.ContactSolver(grid, RIGID, STEEL).solve(gap, load=1.0),
    ):
        with pytest.raises(ValueError, match=text):
            call()
    with pytest.raises(ValueError, match=r"heights_lower must be .* or -inf where there is no"):
        surfaces.from_heights(grid, -gap)
    with pytest.raises(ValueError, match=r"got \+inf \(no body\) in all cells"):
        sc.Simulation(grid, RIGID, STEEL, np.full((8, 8), np.inf))


class TestFixedGapAtTheBorder:
    """Grids that cannot be enlarged are not enlarged."""

    grid = sc.Grid(48, 40, UM, UM)
    rough = 1e-8 * np.random.default_rng(3).standard_normal((48, 40))

    def message(self, gap, load, simulated):
        def press():
            if simulated:
                return sc.Simulation(self.grid, RIGID, STEEL, gap).step(load=load)
            return sc.ContactSolver(self.grid, RIGID, STEEL).solve(gap, load=load)

        with pytest.raises(sc.GridTooSmallError) as caught:
            press()
        return str(caught.value)

    @pytest.mark.parametrize("simulated", [False, True])
    def test_a_tilted_map(self, simulated):
        text = self.message(self.rough + 4e-3 * self.grid.x[:, None], 1e-3, simulated)
        assert "The gap is tilted by 18" in text
        assert 'detrend="height"' in text
        assert 'on_border="warn"' in text
        assert "enlarge n" not in text

    @pytest.mark.parametrize("simulated", [False, True])
    def test_a_map_that_touches_everywhere(self, simulated):
        text = self.message(self.rough, 100.0, simulated)
        assert "and covers 100 % of the grid" in text
        assert 'Grid(..., periodic="xy")' in text
        assert "enlarge n" not in text

    @pytest.mark.parametrize("height", [1e-6, -1e-6, 1 / 3])
    def test_a_constant_gap_is_not_tilted(self, height):
        text = self.message(np.full(self.grid.surface_shape, height), 1.0, False)
        assert "in contact everywhere" in text
        assert "tilted" not in text

    def test_a_map_that_touches_here_and_there(self):
        text = self.message(self.rough, 1e-2, False)
        assert "enlarge n" in text
        assert 'detrend="curvature", or make the surface periodic' in text

    @pytest.mark.parametrize(
        ("slope", "load", "text"), [(4e-3, 1e-3, "is tilted by 18"), (0.0, 100.0, "everywhere")]
    )
    def test_warnings_and_errors_have_the_same_text(self, slope, load, text):
        gap = self.rough + slope * self.grid.x[:, None]
        solver = sc.ContactSolver(self.grid, RIGID, STEEL, on_border="warn")
        simulation = sc.Simulation(self.grid, RIGID, STEEL, gap, on_border="warn")
        for call in (lambda: solver.solve(gap, load=load), lambda: simulation.step(load=load)):
            with pytest.warns(sc.GridTooSmallWarning, match=text) as caught:
                call()
            assert not any("enlarge n" in str(w.message) for w in caught)

    def test_numbers_are_rounded(self):
        grid = sc.Grid(30, 30, 1e-5 / 3, 1e-5 / 3)
        solver = sc.ContactSolver(grid, RIGID, STEEL)
        with pytest.raises(sc.GridTooSmallError, match=r"^at load 12\.3457 N .*\(0\.0001 m x 0\.0"):
            solver.solve(np.zeros((30, 30)), load=12.345678901234567)
