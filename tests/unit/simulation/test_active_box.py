# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields are computed only in the active box, and only on the half or quarter left by mirror
planes; neither changes the result."""

import numpy as np
import pytest

import samcontact as sc

E, NU = 210e9, 0.3
ELASTIC = sc.Material.elastic(E, NU)
STEEL = sc.Material.swift(E, NU, 945e6, 20.0, 0.121)
RADIUS = 7.5e-3
CELL = 40e-6


def simulation(nx=33, ny=33, nz=20, gap=None, bodies=(ELASTIC, STEEL), **options):
    grid = sc.Grid(nx, ny, CELL, CELL, nz, CELL)
    if gap is None:
        gap = sc.surfaces.paraboloid(grid, Rx=RADIUS)
    return sc.Simulation(grid, *bodies, gap, **{"residual_stress": "fast", **options})


def box(state, body=2):
    return getattr(state._core, f"history{body}")["box"]


def mirrors(state, body=2):
    return getattr(state._core, f"history{body}")["mirrored"]


def middle(field, like):
    """Return the part of a wide field that lies on a smaller grid."""
    i, j = ((w - n) // 2 for w, n in zip(field.shape[-3:-1], like.shape[-3:-1], strict=True))
    return field[..., i : i + like.shape[-3], j : j + like.shape[-2], : like.shape[-1]]


def close(actual, expected, tol):
    return np.abs(actual - expected).max() <= tol * np.abs(expected).max()


class TestBox:
    def test_is_as_small_as_the_plastic_zone(self):
        state = simulation(65, 61, 60).step(load=600.0)
        _, _, nx, ny, nz = box(state)
        plastic = state.equivalent_plastic_strain() > 0
        assert 2 * plastic.any(axis=(1, 2)).sum() > nx
        assert nx <= 33
        assert ny <= 31
        assert plastic.any(axis=(0, 1)).sum() < nz < 30

    def test_a_larger_grid_changes_nothing(self):
        """A larger grid changes fields only by the periodic images of the fast operator."""
        loads = (500.0, 1500.0, 700.0)
        near, wide = simulation(), simulation(65, 61, 40)
        for load in loads:
            small, large = near.step(load=load), wide.step(load=load)
            assert close(middle(large.pressure[..., None], small.pressure[..., None])[..., 0],
                         small.pressure, 2e-4)  # fmt: skip
            for name in ("equivalent_plastic_strain", "von_mises"):
                field = getattr(small, name)()
                assert close(middle(getattr(large, name)(), field), field, 2e-3)

    def test_grows_with_the_load(self):
        sim = simulation(65, 65, 40)
        sizes = [np.prod(box(sim.step(load=load))[2:]) for load in (400.0, 900.0, 1500.0)]
        assert sizes == sorted(sizes)
        assert sizes[0] < 0.5 * sizes[2]

    def test_one_large_increment_finds_its_box(self):
        """The plastic zone of one increment is wider than predicted by its elastic trial."""
        options = {"bodies": (ELASTIC, sc.Material.perfect_plastic(E, NU, 1.2e9))}
        state = simulation(49, 49, 36, **options).step(load=1500.0)
        i0, j0, nx, ny, nz = box(state)
        grid = state.grid
        rim = np.zeros(grid.volume_shape, dtype=bool)
        if mirrors(state) == 2:
            nx, ny = grid.nx - 2 * (grid.nx - i0 - nx), grid.ny - 2 * (grid.ny - j0 - ny)
            i0, j0 = (grid.nx - nx) // 2, (grid.ny - ny) // 2
        rim[i0 : i0 + nx, j0 : j0 + ny, :nz] = True
        rim[i0 + 1 : i0 + nx - 1, j0 + 1 : j0 + ny - 1, : nz - 1] = False
        assert not state.equivalent_plastic_strain()[rim].any()

    def test_fields_outside_the_box_are_computed_on_demand(self):
        state = simulation(65, 61, 60).step(load=600.0)
        stress = state.stress()
        assert stress.shape == (6, 65, 61, 60)
        whole = sc.operators.surface_stress(state.grid, state.pressure, state.grid.z, NU)
        far = np.s_[:, :, :, 45:]
        assert close(stress[far], whole[far], 0.02)
        assert not np.array_equal(stress[far], whole[far])
        print_ = state.residual_displacement()
        expected = sc.operators.residual_displacement(state.grid, state.plastic_strain(), NU)
        assert close(print_, expected, 1e-10)

    def test_separate_asperities(self):
        """Two asperities that yield one after the other."""
        grid = sc.Grid(81, 33, CELL, CELL, 24, CELL)
        bumps = [((grid.x[:, None] - x) ** 2 + grid.y**2) / (2 * RADIUS) + h
                 for x, h in ((-0.8e-3, 0.0), (0.8e-3, 6e-6))]  # fmt: skip
        sim = simulation(81, 33, 24, gap=np.minimum(*bumps))
        first = sim.step(load=600.0).equivalent_plastic_strain().max(axis=(1, 2))
        assert first[:40].any()
        assert not first[41:].any()
        state = sim.step(load=2200.0)
        second = state.equivalent_plastic_strain().max(axis=(1, 2))
        assert second[:40].max() > second[41:].max() > 0
        assert state.von_mises().max() < STEEL.yield_stress(second.max()) * (1 + 1e-5)

    def test_rough_contact_equals_that_with_the_whole_grid_in_the_box(self):
        grid = sc.Grid(48, 40, 2e-6, 2e-6, 24, 2e-6)
        heights = sc.surfaces.rough_self_affine(grid, 120e-9, 0.8, seed=5)
        gap = sc.surfaces.paraboloid(grid, Rx=4e-4) - heights
        small = sc.Simulation(grid, ELASTIC, STEEL, gap, residual_stress="fast")
        state = small.step(load=1.5)
        assert box(state)[4] < 20
        whole = sc.Simulation(grid, ELASTIC, STEEL, gap, residual_stress="fast")
        # A strain too small to matter in the corners spans the box.
        strain = np.zeros((6, *grid.volume_shape))
        strain[5][np.ix_((0, -1), (0, -1), (0, -1))] = 1e-15
        whole.set_plastic_strain(2, strain, np.full(grid.volume_shape, 1e-16))
        reference = whole.step(load=1.5)
        assert box(reference) == [0, 0, 48, 40, 24]
        assert close(state.pressure, reference.pressure, 1e-3)
        field = reference.equivalent_plastic_strain()
        assert close(state.equivalent_plastic_strain(), field, 3e-3)


class TestMirrors:
    @pytest.mark.parametrize(("nx", "ny"), [(33, 33), (32, 34), (33, 30)])
    def test_quarter_equals_whole(self, nx, ny):
        sim, crooked = simulation(nx, ny), simulation(nx, ny)
        gap = np.array(crooked.initial_gap)
        gap[0, 0] *= 1 + 1e-9  # no longer symmetric to rounding
        crooked = simulation(nx, ny, gap=gap)
        for load in (900.0, 1500.0, 0.0):
            quarter, whole = sim.step(load=load), crooked.step(load=load)
            assert (mirrors(quarter), mirrors(whole)) == (2, 0)
            for name in ("plastic_strain", "stress", "residual_displacement"):
                assert close(getattr(quarter, name)(), getattr(whole, name)(), 1e-4)
            assert abs(quarter.iterations - whole.iterations) <= 2

    def test_half_with_friction(self):
        bodies = (sc.Material.rigid(), STEEL)
        sim = simulation(bodies=bodies, friction=0.2)
        state = sim.step(load=900.0)
        assert mirrors(state) == 1
        gap = np.array(sim.initial_gap)
        gap[0, 0] *= 1 + 1e-9
        whole = simulation(bodies=bodies, friction=0.2, gap=gap).step(load=900.0)
        assert mirrors(whole) == 0
        for name in ("plastic_strain", "stress", "residual_displacement"):
            assert close(getattr(state, name)(), getattr(whole, name)(), 1e-4)
        strain = state.plastic_strain()
        assert close(strain[5], -strain[5][:, ::-1], 1e-12)  # xy is odd in y
        assert close(strain[4], strain[4][:, ::-1], 1e-12)  # xz is even

    def test_mirror_planes_are_dropped_later(self):
        """Shear after a symmetric indentation removes one mirror plane, then both."""
        sim = simulation()
        grid = sim.grid
        state = sim.step(load=1200.0)
        before = state.equivalent_plastic_strain()
        pressure = np.array(state.pressure)
        assert mirrors(state) == 2
        state = sim.step(pressure=pressure, shear=0.3 * pressure)
        assert mirrors(state) == 1
        assert (state.equivalent_plastic_strain() >= before).all()
        shear_field = np.stack([0.2 * pressure, 0.3 * pressure])
        state = sim.step(pressure=pressure, shear=shear_field)
        assert mirrors(state) == 0
        assert (state.equivalent_plastic_strain() >= before).all()
        assert state.grid == grid

    @pytest.mark.parametrize("sliding", [0.0, 0.2])
    def test_shear_is_a_vector_in_mirrors(self, sliding):
        """Shear towards the middle has mirror planes: s_x is odd about x = 0, s_y about y = 0."""
        sim, crooked = simulation(), simulation()
        x, y = np.meshgrid(sim.grid.x, sim.grid.y, indexing="ij")
        pressure = 4.5e9 * np.sqrt(np.maximum(1 - (x**2 + y**2) / (0.2 * np.ptp(x)) ** 2, 0))
        shear = pressure * np.stack([sliding - 0.3 * x / x.max(), -0.3 * y / y.max()])
        state = sim.step(pressure=pressure, shear=shear)
        shear[1, 16, 16] += 1e-8 * pressure.max()
        whole = crooked.step(pressure=pressure, shear=shear)
        assert (mirrors(state), mirrors(whole)) == (1 if sliding else 2, 0)
        assert state.max_plastic_strain_magnitude() > 1e-3
        for name in ("plastic_strain", "stress", "residual_displacement"):
            assert close(getattr(state, name)(), getattr(whole, name)(), 1e-4)
        for axis in "xy":
            moved, reference = (s.residual_displacement(2, axis) for s in (state, whole))
            assert close(moved, reference, 1e-4)

    def test_both_bodies(self):
        state = simulation(bodies=(STEEL, STEEL)).step(load=1200.0)
        for name in ("plastic_strain", "residual_displacement"):
            assert close(getattr(state, name)(1), getattr(state, name)(2), 1e-6)


def test_the_operator_is_independent_of_the_grid_size():
    """The stress of one strained cell is that of the chosen operator on any grid."""
    strain = [1e-3, -1e-3, 0.0, 5e-4, 0.0, 0.0]
    for cells in (8, 33):
        fast, exact = (simulation(cells, cells, 20, residual_stress=m) for m in ("fast", "exact"))
        given = np.zeros((6, cells, cells, 20))
        given[:, cells // 2, cells // 2, 3] = strain
        for one in (fast, exact):
            one.set_plastic_strain(2, given)
        expected = sc.operators.residual_stress(exact.grid, given, E, NU)
        assert close(exact.state.residual_stress(), expected, 1e-10)
        default = sc.Simulation(fast.grid, ELASTIC, STEEL, np.zeros((cells, cells)))
        default.set_plastic_strain(2, given)
        found = fast.state.residual_stress()
        assert not close(found, expected, 1e-2)
        np.testing.assert_array_equal(default.state.residual_stress(), found)


def test_tolerances_of_the_fast_operator_reach_the_result():
    coarse = simulation(image_tol=0.1).step(load=1500.0).von_mises()
    fine = simulation(image_tol=1e-5).step(load=1500.0).von_mises()
    assert not np.array_equal(coarse, fine)
    assert close(coarse, fine, 5e-3)


@pytest.mark.parametrize(
    ("argument", "text"),
    [({"residual_stress": "quick"}, "residual_stress must be one of"),
     ({"image_tol": 0.2}, r"image_tol must be in \[1e-6, 0.1\], got 0.2")],
)  # fmt: skip
def test_bad_arguments(argument, text):
    with pytest.raises(ValueError, match=text):
        simulation(**argument)


@pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
class TestFewLongCells:
    """A box needs a few cells beyond the grid, however long these are."""

    MATERIAL = sc.Material.linear_hardening(E, NU, 1e9, 10e9)
    HALF = 2.5e-4
    """Half the width of the grid across the line."""

    def largest(self, rows, length, periodic="", across="y"):
        cells = {"nx": 27, "ny": rows, "dx": 2 * self.HALF / 27, "dy": length * self.HALF}
        radii = (5e-3, np.inf)
        if across == "x":
            cells = {"nx": rows, "ny": 27, "dx": cells["dy"], "dy": cells["dx"]}
            radii = radii[::-1]
        grid = sc.Grid(**cells, nz=12, dz=2 * self.HALF / 27, periodic=periodic)
        gap = sc.surfaces.paraboloid(grid, *radii)
        sim = sc.Simulation(grid, ELASTIC, self.MATERIAL, gap, on_border="warn")
        return sim.step(load=5.3e5 * rows * length * self.HALF).max_equivalent_plastic_strain()

    def test_one_row_is_two_rows_of_half_the_length(self):
        """One row equals two rows of cells of half the length, except for end effects."""
        plane = self.largest(1, 10, periodic="y")
        assert plane > 5e-4
        ends = [self.largest(1, length) / plane - 1 for length in (10, 100, 1000)]
        assert ends[0] > 6 * ends[1] > 36 * ends[2] > 0, ends
        assert ends[2] < 0.01
        assert self.largest(2, 500) == pytest.approx(plane, rel=0.01)

    def test_a_column_equals_a_row(self):
        row = self.largest(1, 10)
        assert self.largest(1, 10, across="x") == pytest.approx(row, rel=1e-6)

    def test_one_cell_yields(self):
        sim = sc.Simulation(sc.Grid(1, 1, 1e-4, 1e-4, 10, 2e-5), ELASTIC, self.MATERIAL, [[0.0]])
        strain = [
            sim.step(pressure=[[p]]).max_equivalent_plastic_strain() for p in (1.5e9, 2e9, 2.5e9)
        ]
        assert strain[0] == 0 < strain[1] < strain[2] < 0.01
