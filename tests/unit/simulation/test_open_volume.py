# SPDX-License-Identifier: GPL-3.0-or-later
"""The extent of plastic flow is independent of the layers and sides of the grid."""

import pickle

import numpy as np
import pytest

import samcontact as sc
from samcontact import plotting, results

ELASTIC = sc.Material.elastic(210e9, 0.3)
STEEL = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
SOFT = sc.Material.perfect_plastic(210e9, 0.3, 1.2e9)
RADIUS, CELL = 7.5e-3, 50e-6
PATH = [{"load": load} for load in (500.0, 900.0, 0.0)]
FIELDS = ("stress", "residual_stress", "plastic_strain", "equivalent_plastic_strain", "von_mises")


def simulation(nz=0, n=21, body2=STEEL, **options):
    grid = sc.Grid(n, n - 2, CELL, CELL, nz, dz=0.8 * CELL)
    return sc.Simulation(grid, ELASTIC, body2, sc.surfaces.paraboloid(grid, RADIUS), **options)


def run(sim, path=PATH):
    return sim.run(path, progress=False)


def close(actual, expected, tol):
    return np.abs(actual - expected).max() <= tol * np.abs(expected).max()


class TestDepths:
    def test_depths_without_nz_include_all_plastic_strain(self):
        states = run(simulation())
        deep = run(simulation(40))
        for state, expected in zip(states, deep, strict=True):
            n = len(state.depths)
            np.testing.assert_array_equal(state.depths, expected.depths[:n])
            for name in FIELDS:
                assert getattr(state, name)().shape[-1] == n
            for name in ("plastic_strain", "equivalent_plastic_strain"):
                np.testing.assert_array_equal(
                    getattr(state, name)(), getattr(expected, name)()[..., :n]
                )
                assert not getattr(expected, name)()[..., n:].any()
            assert close(state.stress(), expected.stress()[..., :n], 1e-3)
            np.testing.assert_array_equal(state.pressure, expected.pressure)

    def test_depths_of_an_elastic_contact_reach_one_and_a_half_radii(self):
        grid = sc.Grid(65, 65, 10e-6, 10e-6, dz=8e-6)
        gap = sc.surfaces.paraboloid(grid, RADIUS)
        contact = sc.hertz.point(RADIUS, sc.hertz.effective_modulus(ELASTIC, ELASTIC), load=200.0)
        state = sc.Simulation(grid, ELASTIC, ELASTIC, gap).step(load=200.0)
        assert state.depths[-1] + 4e-6 == pytest.approx(1.5 * contact.a, rel=0.05)

    def test_depths_of_several_spots_are_those_of_one_spot(self):
        grid = sc.Grid(64, 64, 10e-6, 10e-6, dz=2e-6, periodic="xy")
        waves = 1e-6 * np.cos(np.arange(64) * np.pi / 4)
        gap = 2e-6 - waves[:, None] - waves[None, :]
        state = sc.Simulation(grid, ELASTIC, ELASTIC, gap).step(load=5.0)
        assert 8 <= len(state.depths) <= 15

    def test_depths_are_those_of_a_grid_with_layers(self):
        state = simulation(12).step(load=500.0)
        np.testing.assert_array_equal(state.depths, state.grid.z)

    def test_a_grid_without_nz_has_no_depths(self):
        grid = simulation().grid
        for name in ("z", "volume_shape"):
            with pytest.raises(
                ValueError, match=r"volume_shape requires a grid with nz: .* State\.depths"
            ):
                getattr(grid, name)


@pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
class TestNothingIsCutOff:
    def test_few_layers_and_a_narrow_grid(self):
        expected = run(simulation(30, 41))
        for sim in (simulation(3), simulation(12), simulation(n=19)):
            for state, all_of_it in zip(run(sim), expected, strict=True):
                i = (41 - state.grid.nx) // 2
                n = min(len(state.depths), 30)
                field = all_of_it.plastic_strain()[:, i : 41 - i, i : 41 - 2 - i, :n]
                # the loading is solved to tol, and the fast operator to image_tol
                assert close(state.plastic_strain()[..., :n], field, 2e-3)
                strain = all_of_it.max_equivalent_plastic_strain()
                assert state.max_equivalent_plastic_strain() == pytest.approx(strain, rel=1e-3)

    def test_plastic_growth_beyond_the_grid_agrees_with_a_larger_grid(self):
        fine = {"image_tol": 1e-6, "tol": 1e-8}
        expected = simulation(30, 41, **fine).step(load=900.0)
        state = simulation(4, 19, **fine).step(load=900.0)
        part = expected.plastic_strain()[:, 11:30, 11:28, :4]
        assert close(state.plastic_strain(), part, 1e-6)
        print_ = expected.residual_displacement()[11:30, 11:28]
        assert close(state.residual_displacement(), print_, 1e-6)

    def test_flow_at_opposite_grid_edges_agrees(self):
        grid = sc.Grid(19, 17, CELL, CELL, dz=CELL)
        gap = ((grid.x[:, None] - 2 * CELL) ** 2 + (grid.y[None, :] - CELL) ** 2) / (2 * RADIUS)
        soft = sc.Material.linear_hardening(210e9, 0.3, 0.4e9, 10e9)
        sims = [sc.Simulation(grid, ELASTIC, soft, g) for g in (gap, gap[::-1, ::-1])]
        one, other = (sim.step(load=350.0).residual_displacement() for sim in sims)
        assert close(other[::-1, ::-1], one, 1e-4)

    def test_strain_that_lies_deeper_than_nz_can_be_set(self):
        deep = simulation().step(load=900.0)
        sim = simulation(3)
        sim.set_plastic_strain(2, deep.plastic_strain(), deep.equivalent_plastic_strain())
        assert close(sim.state.residual_displacement(), deep.residual_displacement(), 1e-9)
        assert sim.state.max_plastic_strain_magnitude() == deep.max_plastic_strain_magnitude()


def test_fully_plastic_contact_causes_no_message():
    grid = sc.Grid(41, 41, 20e-6, 20e-6, dz=20e-6)
    yielding = sc.Material.perfect_plastic(210e9, 0.3, 0.15e9)
    sim = sc.Simulation(grid, ELASTIC, yielding, sc.surfaces.paraboloid(grid, RADIUS))
    states = run(sim, [{"load": load} for load in (10.0, 30.0, 50.0, 0.0)])
    assert states[2].mean_pressure > 2.4 * 0.15e9
    assert states[3].equivalent_plastic_strain()[:, :, 1].max() > 0.005
    assert not states[3].equivalent_plastic_strain()[..., -1].any()


@pytest.mark.parametrize(
    ("periodic", "advance"), [("", (0.0, 0.0)), ("", (-CELL, -CELL)), ("xy", (0.0, 0.0))]
)
def test_checkpoint_and_copy_continue_with_identical_bits(tmp_path, periodic, advance):
    grid = sc.Grid(20, 16, CELL, CELL, dz=CELL, periodic=periodic)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    sim = sc.Simulation(grid, ELASTIC, STEEL, gap)
    first = run(sim, [PATH[0], {"load": 600.0, "advance": advance}])[-1]
    sim.save(tmp_path / "kept")
    loaded = sc.Simulation.load(tmp_path / "kept")
    copied = pickle.loads(pickle.dumps(sim))
    expected = sim.step(load=700.0, advance=advance)
    for other in (loaded, copied):
        np.testing.assert_array_equal(other.state.plastic_strain(), first.plastic_strain())
        state = other.step(load=700.0, advance=advance)
        for name in FIELDS:
            np.testing.assert_array_equal(getattr(state, name)(), getattr(expected, name)())


def test_a_periodic_half_space_that_yields_as_a_whole_is_an_error():
    grid = sc.Grid(16, 16, CELL, CELL, dz=CELL, periodic="xy")
    sim = sc.Simulation(grid, ELASTIC, SOFT, np.zeros((16, 16)))
    area = grid.nx * grid.ny * grid.cell_area
    sim.step(load=1.7e9 * area)
    with pytest.raises(ValueError, match="the plastic zone of body 2 is unbounded"):
        sim.step(load=2.2e9 * area)
    assert sim.state.load == pytest.approx(1.7e9 * area)


def test_volume_fields_of_increments_have_common_depths(tmp_path):
    sim = simulation()
    states = run(sim)
    assert len(states[0].depths) < len(states[1].depths)
    dataset = results.to_dataset(sim, states, volume="all")
    np.testing.assert_array_equal(dataset["z"], states[1].depths)
    n = len(states[0].depths)
    np.testing.assert_array_equal(
        dataset["plastic_strain_body2"].values[0][..., :n], states[0].plastic_strain()
    )
    figure = plotting.section(states[1].von_mises(), sim.grid, quantity="von_mises").figure
    assert figure.axes


def test_tracks_of_a_moving_contact():
    grid = sc.Grid(25, 15, CELL, CELL, dz=0.8 * CELL)
    sim = sc.Simulation(grid, ELASTIC, STEEL, sc.surfaces.paraboloid(grid, RADIUS))
    path = [{"load": 600.0}, *[{"load": 600.0, "advance": (-CELL, -CELL)}] * 6]
    state = run(sim, path)[-1]
    track = state.track()
    np.testing.assert_array_equal(track.z, state.depths)
    assert track.equivalent_plastic_strain().max() == state.max_equivalent_plastic_strain()


def test_softening_where_the_grid_has_no_layers():
    soft = STEEL.with_thermal(50.2, 11.7e-6, 1.367e-5).with_softening(
        lambda rise: 1 - 5e-4 * np.clip(rise, 0, 1000)
    )
    options = {"heat": sc.Heat((0.0, 0.05)), "friction": 0.1}
    states = [simulation(nz, body2=soft, **options).step(load=900.0) for nz in (0, 30)]
    n = len(states[0].depths)
    assert close(states[0].plastic_strain(), states[1].plastic_strain()[..., :n], 1e-3)
    assert close(states[0].softening(), states[1].softening()[..., :n], 1e-6)
    assert states[0].softening().min() < 0.99
