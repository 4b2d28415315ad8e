# SPDX-License-Identifier: GPL-3.0-or-later
"""States: fields and scalars, and the limit of small strain."""

import math
import re
import warnings

import numpy as np
import pytest
from simulation_setups import (
    BALL,
    EXACT,
    GRID,
    LOAD,
    NU,
    OTHER,
    RIGID,
    SIZE,
    SOFT,
    STEEL,
    E,
    assert_close,
    simulation,
)

import samcontact as sc
from samcontact import operators


class TestState:
    @pytest.fixture(scope="class")
    @staticmethod
    def state():
        return simulation(OTHER, SOFT).step(load=LOAD)

    def test_before_the_first_step(self):
        state = simulation(gap=BALL + 3e-6).state
        assert (state.load, state.iterations) == (0.0, 0)
        assert state.approach == (BALL + 3e-6).min()
        assert not state.pressure.any()
        assert not state.stress().any()
        assert not state.residual_displacement().any()

    def test_shapes_and_components(self, state):
        tensors = ("stress", "residual_stress", "plastic_strain")
        scalars = ("von_mises", "hydrostatic", "equivalent_plastic_strain")
        for body in (1, 2):
            for name in tensors:
                assert getattr(state, name)(body).shape == (6, *GRID.volume_shape)
            for name in scalars:
                assert getattr(state, name)(body).shape == GRID.volume_shape
            for name in ("residual_displacement", "surface_displacement"):
                assert getattr(state, name)(body).shape == GRID.surface_shape
            xx, yy, zz, yz, xz, xy = state.stress(body)
            mises = np.sqrt(
                0.5 * ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2)
                + 3 * (yz**2 + xz**2 + xy**2)
            )
            assert_close(state.von_mises(body), mises, 1e-13)
            assert_close(state.hydrostatic(body), (xx + yy + zz) / 3, 1e-13)
        assert state.pressure.shape == state.gap.shape == GRID.surface_shape
        assert state.shear.shape == (2, *GRID.surface_shape)
        # the x component changes along x: under the flank of the ball sigma_xz is odd in x
        xz = state.stress()[4]
        assert_close(xz[::-1], -xz, 1e-5)
        assert np.abs(xz[:, ::-1] - xz).max() < 1e-5 * np.abs(xz).max()

    def test_plastic_strain_is_isochoric_and_accumulates(self, state):
        strain = state.plastic_strain()
        assert_close(strain[:3].sum(axis=0) + 1.0, np.ones(GRID.volume_shape), 1e-15)
        rate = np.sqrt(2 / 3 * ((strain[:3] ** 2).sum(0) + 2 * (strain[3:] ** 2).sum(0)))
        # one increment from the virgin state: proportional, so both measures agree
        assert_close(state.equivalent_plastic_strain(), rate, 1e-12)

    @pytest.mark.parametrize("name", ["pressure", "gap"])
    def test_surface_fields_are_read_only_views(self, state, name):
        field = getattr(state, name)
        with pytest.raises(ValueError, match="read-only"):
            field[0, 0] = 1.0
        assert np.shares_memory(field, getattr(state, name))

    def test_fields_outlive_their_state(self):
        sim = simulation()
        pressure = sim.step(load=LOAD).pressure
        kept = pressure.copy()
        sim.step(load=0.5 * LOAD)
        del sim
        np.testing.assert_array_equal(pressure, kept)

    def test_writing_to_a_volume_field_changes_nothing(self, state):
        expected = state.plastic_strain().copy()
        with pytest.raises(ValueError, match="read-only"):
            state.plastic_strain()[...] = 7.0
        np.testing.assert_array_equal(state.plastic_strain(), expected)

    def test_balance(self, state):
        assert state.pressure.sum() * GRID.cell_area == pytest.approx(LOAD, rel=1e-12)
        total = BALL - state.approach
        for body in (1, 2):
            total = total + state.surface_displacement(body)
        inside = state.pressure > 0
        assert np.abs(state.gap - total).max() < 1e-6 * EXACT.approach
        assert np.abs(state.gap[inside]).max() < 1e-6 * EXACT.approach
        assert state.gap.min() > -1e-6 * EXACT.approach

    @pytest.mark.parametrize("bodies", [(STEEL, SOFT), (OTHER, SOFT)])
    def test_plastic_strain_moves_the_surface_along_all_axes(self, bodies):
        sim = simulation(*bodies)
        for step in ({"load": LOAD}, {"load": 0.0}):
            sim.step(**step)
        state = sim.state
        for body in (1, 2):
            strain = state.plastic_strain(body)
            moved = [state.residual_displacement(body, axis) for axis in "xyz"]
            for axis, found in zip("xyz", moved, strict=True):
                nu = bodies[body - 1].nu
                assert_close(
                    found, operators.residual_displacement(GRID, strain, nu, axis=axis), 1e-10
                )
            np.testing.assert_array_equal(moved[2], state.residual_displacement(body))
            if strain.any():  # the ball is round
                along_x, along_y = moved[0], moved[1]
                assert_close(along_x[::-1], -along_x, 1e-5)
                assert_close(along_x[:, ::-1], along_x, 1e-5)
                assert_close(along_y[:, ::-1], -along_y, 1e-5)
                assert np.abs(along_x).max() > 0.05 * np.abs(moved[2]).max()
        with pytest.raises(ValueError, match="axis must be one of 'x', 'y', 'z', got 2"):
            state.residual_displacement(2, axis=2)

    def test_repr(self, state):
        assert re.fullmatch(r"State\(load=.* N, approach=.* m, .*iterations=\d+\)", repr(state))

    def test_fields_that_do_not_exist(self, state):
        with pytest.raises(ValueError, match="body must be one of 1, 2, got 0"):
            state.stress(0)
        rigid = simulation(RIGID, SOFT).step(load=0.1 * LOAD)
        surface = sc.Grid(19, 21, SIZE, 0.9 * SIZE)
        flat = simulation(STEEL, STEEL, grid=surface).step(load=0.1 * LOAD)
        for name in ("stress", "von_mises", "equivalent_plastic_strain", "residual_stress"):
            with pytest.raises(ValueError, match="body 1 is rigid: it has no stress or strain"):
                getattr(rigid, name)(1)
            with pytest.raises(
                ValueError, match="the grid has no dz: fields below the surface require"
            ):
                getattr(flat, name)(2)


class TestSmallStrain:
    """Beyond a plastic strain of 5 %."""

    STRONG = sc.Material.perfect_plastic(E, NU, 1e12)

    def strained(self, sim, body, shear):
        strain = np.zeros((6, *GRID.volume_shape))
        strain[5, 9, 9, 4] = shear  # sqrt(2/3 e:e) = 2/sqrt(3) shear
        sim.set_plastic_strain(body, strain)

    @staticmethod
    def warnings_of(sim, load):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            sim.step(load=load)
        return [str(w.message) for w in caught if w.category is sc.PlasticStrainWarning]

    @pytest.mark.parametrize("body", [1, 2])
    def test_warns_once_when_it_passes_five_per_cent(self, body):
        sim = simulation(*((self.STRONG, STEEL) if body == 1 else (STEEL, self.STRONG)))
        self.strained(sim, body, 0.0499 * math.sqrt(3) / 2)
        assert self.warnings_of(sim, LOAD) == []
        assert sim.state.max_plastic_strain_magnitude(body) == pytest.approx(0.0499, rel=1e-14)
        self.strained(sim, body, -0.0501 * math.sqrt(3) / 2)
        (message,) = self.warnings_of(sim, LOAD)
        magnitude = f"the plastic strain magnitude sqrt(2/3 e:e) of body {body} is 0.0501"
        assert message.startswith(f"{magnitude}, above the small-strain limit of 0.05")
        self.strained(sim, body, 0.06)
        assert self.warnings_of(sim, LOAD) == []

    @pytest.mark.parametrize(("accumulated", "count"), [(0.0499, 0), (0.0536, 1), (0.07, 0)])
    def test_the_warning_uses_the_accumulated_strain(self, accumulated, count):
        """The warning uses the strain shown in tables, unless most of it is reversed flow."""
        sim = simulation(STEEL, self.STRONG)
        strain, equivalent = np.zeros((6, *GRID.volume_shape)), np.zeros(GRID.volume_shape)
        strain[5, 9, 9, 4], equivalent[9, 9, 4] = 0.03 * math.sqrt(3) / 2, accumulated
        sim.set_plastic_strain(2, strain, equivalent)
        messages = self.warnings_of(sim, LOAD)
        assert sim.state.max_equivalent_plastic_strain() == accumulated
        assert len(messages) == count
        for message in messages:
            assert "accumulated equivalent plastic strain of body 2 is 0.0536" in message
            assert message.endswith("at most 0.03: results are unreliable")

    def test_the_warning_may_be_an_error(self):
        """The step is completed, as with a grid that is too small."""
        sim = simulation(STEEL, self.STRONG)
        self.strained(sim, 2, 0.05)
        with pytest.raises(sc.PlasticStrainWarning, match="body 2"):
            sim.step(load=LOAD)
        assert sim.state.load == pytest.approx(LOAD)

    @pytest.mark.parametrize("symmetric", [True, False])
    def test_plastic_strain_magnitude_is_that_of_the_tensor(self, symmetric):
        gap = BALL if symmetric else BALL + GRID.x[:, None] * 1e-4
        state = simulation(gap=gap).step(load=LOAD)
        e = state.plastic_strain()
        expected = np.sqrt(2 / 3 * ((e[:3] ** 2).sum(0) + 2 * (e[3:] ** 2).sum(0)).max())
        assert state.max_plastic_strain_magnitude() == pytest.approx(expected, rel=1e-12)
        assert 0 < expected <= state.max_equivalent_plastic_strain() * (1 + 1e-12)
        assert state.max_plastic_strain_magnitude(1) == 0.0


class TestNumbersOfAState:
    def test_area_mean_pressure_and_largest_strain(self):
        sim = simulation()
        state = sim.step(load=LOAD)
        assert state.contact_area == pytest.approx(math.pi * EXACT.a**2, rel=0.1)
        assert state.mean_pressure == state.load / state.contact_area
        largest = state.equivalent_plastic_strain().max()
        assert state.max_equivalent_plastic_strain() == largest > 0
        assert state.max_equivalent_plastic_strain(body=1) == 0.0

    def test_without_contact(self):
        state = simulation(RIGID, SOFT).state
        assert (state.contact_area, state.mean_pressure) == (0.0, 0.0)
        assert state.max_equivalent_plastic_strain(1) == 0.0
        assert state.max_equivalent_plastic_strain(2) == 0.0
        with pytest.raises(ValueError, match="body must be one of 1, 2, got 0"):
            state.max_equivalent_plastic_strain(0)
