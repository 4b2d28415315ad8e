# SPDX-License-Identifier: GPL-3.0-or-later
"""Unusual arguments of Python users: objects of other libraries, limits of ranges."""

import itertools
import sys
import warnings
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import xarray as xr

import samcontact as sc
from samcontact._util.display import quantity

pytestmark = pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning")
STEEL = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)


def small(body=STEEL, nz=10, **settings):
    grid = sc.Grid(15, 15, 72e-6, 72e-6, nz, 72e-6)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    return sc.Simulation(grid, sc.Material.elastic(210e9, 0.3), body, gap, **settings)


class TestArrays:
    """Arrays that NumPy would silently convert to numbers are refused."""

    GRID = sc.Grid(15, 15, 72e-6, 72e-6)

    @pytest.mark.parametrize(
        ("gap", "named"),
        [
            (np.full((15, 15), "1e-6"), "texts"),
            ([["1e-6"] * 15] * 15, "texts"),
            (np.full((15, 15), b"1e-6", dtype=object), "texts"),
            (np.full((15, 15), np.datetime64("2020-01-01")), "dates"),
            (np.full((15, 15), np.timedelta64(1, "s")), "time spans"),
            (np.zeros((15, 15), dtype=bool), "Boolean values"),
            (np.zeros((15, 15), dtype=[("height", float)]), "records"),
            (np.zeros((15, 15), dtype=complex).astype(object), "complex numbers"),
        ],
    )
    def test_only_numbers_are_heights(self, gap, named):
        with pytest.raises(TypeError, match=f"heights_lower must be an array of numbers.*{named}"):
            sc.surfaces.from_heights(self.GRID, gap)

    def test_a_whole_number_beyond_the_range_is_named(self):
        with pytest.raises(ValueError, match="heights_lower must be finite everywhere"):
            sc.surfaces.from_heights(self.GRID, [[10**400] * 15] * 15)

    def test_labelled_axes_in_another_order_are_refused(self):
        heights = np.random.default_rng(3).random((15, 15))
        right = xr.DataArray(heights, dims=("x", "y"))
        assert np.ptp(sc.surfaces.from_heights(self.GRID, right)) > 0
        with pytest.raises(ValueError, match=r"order x, y, z.*transpose\('x', 'y'\)"):
            sc.surfaces.from_heights(self.GRID, right.T)

    def test_fractions_and_decimals_are_numbers(self):
        exact = np.full((15, 15), Fraction(1, 4), dtype=object)
        assert not sc.surfaces.from_heights(self.GRID, exact).any()
        assert not sc.surfaces.from_heights(self.GRID, [[Decimal("0.25")] * 15] * 15).any()


class TestOneNumber:
    @pytest.mark.filterwarnings("ignore:The .generic. unit:DeprecationWarning")  # of NumPy 2.5
    def test_a_time_span_is_not_a_number(self):
        with pytest.raises(TypeError, match="load must be a number"):
            sc.hertz.point(1e-2, 1e11, load=np.timedelta64(3, "s"))
        with pytest.raises(TypeError, match="load must be a number"):
            sc.hertz.point(1e-2, 1e11, load=np.timedelta64(3))  # which is 3 to float()
        with pytest.raises(TypeError, match="nx must be an integer"):
            sc.Grid(np.timedelta64(15), 15, 1.0, 1.0)

    def test_a_body_number_of_any_integer_type_is_accepted(self):
        state = small().state
        assert np.array_equal(state.von_mises(2.0), state.von_mises(2))

    @pytest.mark.parametrize("value", [1e-35, 7.3e116, -2.5e-32])
    def test_a_size_without_prefix_is_written_unchanged(self, value):
        assert quantity(value, "m") == f"{value:.4g} m"


class TestBeyondTheRange:
    def test_tractions(self):
        pressure = np.zeros((15, 15))
        pressure[7, 7] = 1e300
        with pytest.raises(ValueError, match="pressure must be of magnitude <= 1e\\+75 Pa"):
            small().step(pressure=pressure)
        with pytest.raises(ValueError, match="shear must be of magnitude <="):
            small().step(pressure=0 * pressure, shear=pressure)

    @pytest.mark.parametrize("name", ["green", "onset", "green_cylinder", "onset_cylinder"])
    @pytest.mark.parametrize("stress", [1e-300, 1e300])
    def test_critical_values(self, name, stress):
        with pytest.raises(ValueError, match="must give finite critical values"):
            getattr(sc.critical, name)(1e-2, 1e11, 0.3, stress)

    def test_heat_names_what_the_user_gave(self):
        hot = STEEL.with_thermal(50.0, 1e-5, 1.4e-5)
        for settings, named in (
            ({"velocity": (1e12, 0.0)}, "heat.velocity of body 2 must be <="),
            ({"velocity": (0.0, 1e-300)}, "heat.velocity of body 2 must be 0 or >="),
            ({"time": 1e300}, "heat.time must be <="),
        ):
            with pytest.raises(ValueError, match=named):
                small(hot, heat=sc.Heat(0.1, **settings)).step(load=10.0)
        with pytest.raises(ValueError, match="friction times speed must be finite"):
            sc.heat.factors(1e200, 1e200)

    def test_constants_of_swift(self):
        with pytest.raises(ValueError, match=r"finite yield stress, got .*: use smaller values"):
            sc.Material.swift(210e9, 0.3, 1e200, 1e200, 1.0)
        with pytest.raises(ValueError, match="strain must be small enough"):
            STEEL.uniaxial_stress([1e300])

    @pytest.mark.parametrize("C", [1e-300, 1e-9, 20.0, 1e200])
    def test_work_of_swift_is_the_integral_of_its_stress(self, C):
        steel = sc.Material.swift(210e9, 0.3, 945e6, C, 0.121)
        # Gauss-Legendre in g = t^4, which takes away the root at 0; 1e-6 of its truncation
        t, weights = np.polynomial.legendre.leggauss(60)
        t, weights = (t + 1) / 2, weights / 2
        work = np.sum(weights * 4 * t**3 * 0.01 * steel.yield_stress(0.01 * t**4))
        assert steel.plastic_work(0.01) == pytest.approx(work, rel=1e-6)


class TestScenes:
    def test_a_large_constant_gap_is_reported(self):
        gap = sc.surfaces.paraboloid(TestArrays.GRID, 7.5e-3) + 1e6
        elastic = sc.Material.elastic(210e9, 0.3)
        solver = sc.ContactSolver(TestArrays.GRID, elastic, elastic, max_iterations=50)
        with pytest.raises(sc.ConvergenceError, match="subtract the minimum") as caught:
            solver.solve(gap, load=300.0)
        assert caught.value.iterations > 0

    @pytest.mark.parametrize("first", [15, -15, 1000])
    def test_strain_outside_the_grid_is_refused(self, first):
        simulation = small()
        with pytest.raises(ValueError, match=f"strain must overlap the grid.*first = {first}"):
            simulation.set_plastic_strain(2, np.full((6, 15, 15, 10), 1e-4), first=first)

    def test_strong_friction_does_not_converge_in_a_single_cell(self):
        soft, hard = sc.Material.elastic(70e9, 0.2), sc.Material.elastic(210e9, 0.3)
        gap = sc.surfaces.paraboloid(TestArrays.GRID, 7.5e-3)
        with pytest.raises(sc.ConvergenceError, match="the bodies overlap by") as caught:
            sc.ContactSolver(TestArrays.GRID, hard, soft, 100.0).solve(gap, load=300.0)
        assert caught.value.residual > 1e-3
        simulation = sc.Simulation(TestArrays.GRID, hard, soft, gap, 100.0)
        with pytest.raises(sc.ConvergenceError, match="the bodies overlap by"):
            simulation.step(load=300.0)
        assert simulation.state.load == 0.0

    def test_solutions_compare_without_error(self):
        elastic = sc.Material.elastic(210e9, 0.3)
        solver = sc.ContactSolver(TestArrays.GRID, elastic, elastic, on_border="warn")
        one, other = (solver.solve(np.zeros((15, 15)), load=0.0) for _ in range(2))
        assert one == one
        assert one != other
        assert len({one, other}) == 2


class TestPaths:
    def test_names_and_values_are_checked_before_the_first_increment(self):
        for wrong, error, text in (
            ({"laod": 1.0}, TypeError, "increment 2 of path.*'laod': did you mean load"),
            ({1: 2.0}, TypeError, "unknown argument 1"),
            ({"load": "x"}, TypeError, "load must be a number"),
            ({"load": -1.0}, ValueError, "load must be a finite number >= 0"),
        ):
            with pytest.raises(error, match=text) as caught:
                small().run([{"load": 10.0}, wrong], progress=False)
            assert caught.value.states == []

    def test_an_infinite_path_is_refused(self):
        with pytest.raises(ValueError, match="at most 100000 increments"):
            small().run(({"load": 1.0} for _ in itertools.count()), progress=False)

    def test_a_path_changed_during_the_run_has_no_effect(self):
        path = [{"load": 300.0}, {"load": 400.0}]

        def law(rise):
            path[1]["load"] = 1.0
            return np.ones_like(rise)

        hot = STEEL.with_thermal(50.0, 1e-5, 1.4e-5).with_softening(law)
        states = small(hot, heat=sc.Heat(1e-3)).run(path, progress=False)
        assert [state.load for state in states] == [300.0, 400.0]

    @pytest.mark.parametrize("folder", ["", "a\0b", 3])
    def test_a_checkpoint_is_a_path(self, folder):
        with pytest.raises(
            (TypeError, ValueError), match=r"checkpoint must be a (non-empty )?path"
        ):
            small().run([{"load": 1.0}], progress=False, checkpoint=folder)

    def test_files(self, tmp_path):
        with pytest.raises(FileNotFoundError, match=r"the folder does not exist.*none/x\.h5"):
            small().save(tmp_path / "none" / "x.h5")
        with pytest.raises(TypeError, match="path must be a path"):
            sc.Simulation.load(None)
        small().save(tmp_path / "x.h5")
        with pytest.raises(TypeError, match="softening must be a pair"):
            sc.Simulation.load(tmp_path / "x.h5", softening=None)


@pytest.mark.usefixtures("steps_alone")
class TestInTheMiddle:
    def test_a_warning_made_an_error_keeps_its_increment(self, tmp_path):
        path = [{"load": 20.0}, {"load": 500.0}, {"load": 0.0}]
        firm = sc.Material.linear_hardening(210e9, 0.3, 5e8, 2e10)

        def run():
            return small(firm, nz=2, on_border="warn").run(
                path, progress=False, checkpoint=tmp_path
            )

        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with pytest.raises(sc.GridTooSmallWarning) as caught:
                run()
        assert [state.load for state in caught.value.states] == [20.0, 500.0]
        assert len(list(tmp_path.glob("*.h5"))) == 2
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            assert len(run()) == 3

    def test_one_increment_at_a_time(self):
        held = []

        def law(rise):
            with pytest.raises(RuntimeError, match="an increment is already in progress"):
                held[0].step(load=1.0)
            return np.ones_like(rise)

        hot = STEEL.with_thermal(50.0, 1e-5, 1.4e-5).with_softening(law)
        held.append(small(hot, heat=sc.Heat(1e-3)))
        assert held[0].step(load=300.0).load == 300.0
        assert held[0].step(load=400.0).load == 400.0

    def test_a_broken_stream_does_not_end_a_run(self, monkeypatch):
        class Broken:
            def write(self, text):
                raise OSError(28, "No space left on device")

        monkeypatch.setattr(sys, "stderr", Broken())
        assert len(small().run([{"load": 300.0}])) == 1
