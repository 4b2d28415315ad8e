# SPDX-License-Identifier: GPL-3.0-or-later
"""Wear over several cycles: volumes, initial state of the next cycle, checkpoints, errors."""

import warnings

import numpy as np
import pytest

import samcontact as sc
from samcontact import plotting, wear
from samcontact.wear import cycles
from samcontact.wear.steps import deviator_below_worn_surface

ELASTIC = sc.Material.elastic(210e9, 0.3)
STEEL = sc.Material.swift(210e9, 0.3, 1735e6, 16.0, 0.067)
GRID = sc.Grid(29, 27, 5e-6, 5e-6, 28, 1.6e-6)
GAP = sc.surfaces.paraboloid(GRID, 4e-4)
PATH = [{"load": 5.0}, {"load": 0.0}]


def wearing(grid=GRID, **changes):
    """Run wear of a ball of 0.4 mm under a load at which the surface wears."""
    given = {"cycle": PATH, "threshold": 2e-3, "cycles": 3, "window": 7, "friction": 0.4}
    gap = changes.pop("gap", GAP)
    return wear.run(grid, ELASTIC, STEEL, gap, progress=False, **(given | changes))


@pytest.fixture(scope="module")
def worn():
    return wearing()


def test_a_light_load_wears_nothing():
    result = wearing(cycle=[{"load": 1.0}, {"load": 0.0}], window=5)
    assert result.stopped
    assert len(result.cycles) == 1
    assert result.cycles[0].volume == (0.0,)
    assert not result.relief2.heights.any()


@pytest.mark.filterwarnings("error::samcontact.ElasticStrainWarning")
def test_plastic_flow_below_the_threshold_wears_nothing():
    """No wear occurs, and no warning of the elastic pressure is issued."""
    result = wearing(threshold=0.04, cycle=[{"load": 6.0}, {"load": 0.0}])
    assert result.stopped
    assert 1e-3 < result.cycles[0].surface_strain[0] <= 0.04


def test_its_elastic_estimate_warns_of_no_yield():
    """The elastic estimate of the contact size causes no warning of yield."""
    with warnings.catch_warnings():
        warnings.simplefilter("error", sc.ElasticStrainWarning)
        assert wearing(cycles=1).cycles[-1].max_equivalent_plastic_strain[-1] > 0


def test_surfaces_may_be_functions_of_the_grid():
    """Functions are evaluated as in a simulation, but only on the given grid."""
    relief = sc.Relief(1e-8 * np.cos(np.arange(29.0 * 27)).reshape(29, 27))
    fixed = wearing(cycles=1, relief1=relief)
    made = wearing(
        cycles=1, gap=lambda grid: sc.surfaces.paraboloid(grid, 4e-4), relief1=lambda _: relief
    )
    assert made.cycles == fixed.cycles
    np.testing.assert_array_equal(made.relief2.heights, fixed.relief2.heights)
    with pytest.raises(ValueError, match="gap must have shape"):
        wearing(gap=lambda grid: np.zeros((3, 3)))


def test_lost_volume_equals_removed_volume(worn):
    assert worn.cycles[0].volume[0] > 0
    for cycle in worn.cycles:
        assert cycle.lost_volume[0] == pytest.approx(cycle.volume[0], rel=1e-12)
    total = (worn.profile(0) - worn.profile()).sum() * GRID.cell_area
    assert total == pytest.approx(worn.rate.sum(), rel=1e-12)
    assert (np.diff(worn.heights[2], axis=0) <= 0).all()
    np.testing.assert_array_equal(worn.relief2.heights, worn.profile())


def test_first_wear_is_that_of_a_simulation(worn):
    simulation = sc.Simulation(GRID, ELASTIC, STEEL, GAP, 0.4)
    loaded, unloaded = simulation.run(PATH, progress=False)
    strain = unloaded.equivalent_plastic_strain()
    expected = wear.smooth(wear.depth(strain, GRID.dz, 2e-3), 7)
    made = -worn.profile(1)[11:-11]
    np.testing.assert_allclose(made, expected, atol=1e-14 * expected.max())
    np.testing.assert_array_equal(worn.first[0].pressure, loaded.pressure)


def test_the_next_cycle_starts_from_the_worn_surface_and_remaining_strain(worn):
    first = worn.first[1]
    strain = first.equivalent_plastic_strain()
    removed = wear.depth(strain, GRID.dz, 2e-3)
    simulation = sc.Simulation(
        GRID, ELASTIC, STEEL, GAP, 0.4, relief2=sc.Relief(-wear.smooth(removed, 7))
    )
    left = np.maximum(wear.below_worn_surface(strain, removed, GRID.dz), 0.0)
    assert strain[..., 0].max() > 2e-3 > left[..., 0].max() > 1e-3
    strain = deviator_below_worn_surface(first.plastic_strain(), removed, GRID.dz)
    simulation.set_plastic_strain(2, strain, left)
    second = simulation.step(**PATH[0])
    assert second.pressure.max() == pytest.approx(worn.cycles[1].max_pressure, rel=1e-6)


def test_strain_may_move_up_by_the_smoothed_depth(worn):
    """Some strain above the threshold then remains, and causes wear without further flow."""
    exact, smoothed = (wearing(order=1, cycles=2, strain_depth=s) for s in ("exact", "smoothed"))
    left = wear.below_worn_surface(
        worn.first[1].equivalent_plastic_strain(), -smoothed.profile(1)[11:-11], GRID.dz
    )
    assert left[..., 0].max() > 2e-3
    assert smoothed.cycles[0] == exact.cycles[0]
    assert smoothed.cycles[1].volume[0] > 1.5 * exact.cycles[1].volume[0]
    assert smoothed.cycles[1].surface_strain[0] >= left[..., 0].max() * (1 - 1e-12)


def test_symmetry_is_kept(worn):
    heights = worn.profile()
    np.testing.assert_allclose(heights, heights[:, ::-1], atol=1e-12 * np.ptp(heights))


@pytest.mark.filterwarnings("ignore::samcontact.PlasticStrainWarning")
def test_an_asperity_runs_in():
    """An asperity is worn off; the ball then rests on a surface without further wear."""
    grid = sc.Grid(35, 31, 5e-6, 5e-6, 30, 1e-6)
    result = wear.run(
        grid, ELASTIC, STEEL, sc.surfaces.paraboloid(grid, 7.5e-3), window=1, order=0, friction=0.4,
        cycle=[{"load": 3.0}, {"load": 0.0}], threshold=2e-3, progress=False,
        relief2=sc.dents.spherical(grid, -0.9e-6, 25e-6),
    )  # fmt: skip
    first, last = result.cycles[0], result.cycles[-1]
    assert result.stopped
    assert last.volume == (0.0,)
    assert 2 < len(result.cycles) < 20
    assert 1e-3 < last.surface_strain[0] <= 2e-3 < first.surface_strain[0]
    assert last.max_pressure < 0.6 * first.max_pressure
    assert last.contact_area > 5 * first.contact_area
    assert all(cycle.volume[0] > 0 for cycle in result.cycles[:-1])


def test_dataset(worn):
    data = worn.to_dataset()
    assert data["wear_rate"].attrs["units"] == "m3"
    np.testing.assert_allclose(np.diff(data["worn_volume"]), worn.rate[1:])
    assert data["heights_body2"].sizes["state"] == len(worn.cycles) + 1
    assert float(data["x_body2"][25]) == pytest.approx(0.0, abs=1e-18)
    assert all(v.attrs["units"] and v.attrs["long_name"] for v in data.data_vars.values())


def test_dataset_is_saved(worn, tmp_path):
    from samcontact import results

    results.save(worn.to_dataset(), tmp_path / "wear.nc")
    with results.open_results(tmp_path / "wear.nc") as data:
        np.testing.assert_array_equal(data["wear_rate"], worn.rate)
        np.testing.assert_array_equal(data["heights_body2"], worn.heights[2])


def test_both_bodies_wear_equally():
    """The wear of body 1 is that of body 2 mirrored in x, because friction is opposite."""
    result = wear.run(
        GRID, STEEL, STEEL, GAP, cycle=[{"load": 6.5}, {"load": 0.0}], threshold=2e-3, cycles=1,
        window=5, worn=(1, 2), friction=0.4, progress=False,
    )  # fmt: skip
    assert result.cycles[0].volume[0] > 0
    mirrored = result.profile(1, body=1)[::-1]
    scale = np.abs(mirrored).max()
    np.testing.assert_allclose(mirrored, result.profile(1, body=2), atol=1e-3 * scale)


def test_kinematic_hardening_wears():
    combined = STEEL.with_kinematic_hardening(20e9, 50.0)
    result = wear.run(
        GRID, ELASTIC, combined, GAP, cycle=PATH, threshold=2e-3, cycles=2, friction=0.4,
        window=5, progress=False,
    )  # fmt: skip
    assert result.cycles[0].volume[0] > 0
    back = result.last[1].backstress()
    assert np.abs(back[:, :3].sum(axis=1)).max() < 1e-9 * np.abs(back).max()


def test_a_track_longer_than_the_grid_wears():
    length = 12 * GRID.dx
    path = [{"load": 4.9}]
    path += [{"load": 4.9, "advance": (-2 * GRID.dx, -2 * GRID.dx)}] * 6
    path += [{"load": 0.0, "advance": (length, length)}]
    result = wearing(cycle=path, cycles=2)
    x = result.x()
    deep = -result.profile(1)[:, 13]
    assert deep[np.abs(x - length) < 2 * GRID.dx].max() > 0.3 * deep.max()
    assert x[deep > 0].max() - x[deep > 0].min() > length
    for cycle in result.cycles:
        assert cycle.volume[0] > 0
        assert cycle.lost_volume[0] == pytest.approx(cycle.volume[0], rel=1e-12)
    # the second cycle meets the worn track: as a new simulation with it does
    again = sc.Simulation(GRID, ELASTIC, STEEL, GAP, 0.4, relief2=result.relief2)
    assert again.step(load=1e-3).pressure.max() > 0


def test_continuation_of_wear_is_bit_identical(tmp_path, worn):
    file = tmp_path / "wear.h5"
    partial = wearing(cycles=2, checkpoint=file)
    assert len(partial.cycles) == 2
    result = wearing(checkpoint=file)
    assert result.cycles == worn.cycles
    np.testing.assert_array_equal(result.heights[2], worn.heights[2])
    np.testing.assert_array_equal(result.last[1].pressure, worn.last[1].pressure)
    np.testing.assert_array_equal(result.first[0].pressure, worn.first[0].pressure)
    np.testing.assert_array_equal(result.last[1].plastic_strain(), worn.last[1].plastic_strain())
    again = wearing(checkpoint=file)  # a finished one gives its results again
    assert again.cycles == worn.cycles
    assert sorted(entry.name for entry in tmp_path.iterdir()) == ["wear.h5", "wear.h5.before"]


def test_a_damaged_checkpoint_is_replaced_by_that_of_the_cycle_before(tmp_path, worn):
    file = tmp_path / "wear.h5"
    wearing(cycles=3, checkpoint=file)
    content = bytearray(file.read_bytes())
    content[len(content) // 2] ^= 1
    file.write_bytes(content)
    continued = "the run continues from the checkpoint of the preceding cycle"
    for _ in range(2):  # a damaged one does not replace the good one
        with pytest.warns(UserWarning, match=rf"wear\.h5' is damaged: .*: {continued}"):
            assert wearing(cycles=2, checkpoint=file).cycles == worn.cycles[:2]
    with pytest.warns(UserWarning, match=continued):
        assert wearing(checkpoint=file).cycles == worn.cycles
    assert wearing(checkpoint=file).cycles == worn.cycles


def test_interrupted_runs_resume(tmp_path, worn, monkeypatch):
    file = tmp_path / "wear.h5"
    step, count = sc.Simulation.step, [0]

    def stop(self, **arguments):
        count[0] += 1
        if count[0] == 4:  # within the second cycle
            raise KeyboardInterrupt
        return step(self, **arguments)

    monkeypatch.setattr(sc.Simulation, "step", stop)
    with pytest.raises(KeyboardInterrupt):
        wearing(checkpoint=file)
    monkeypatch.undo()
    assert wearing(checkpoint=file).cycles == worn.cycles


def test_errors_keep_the_previous_cycles(worn, monkeypatch):
    monkeypatch.setattr(cycles, "_solve", fails_in_cycle_3(cycles._solve))
    with pytest.raises(RuntimeError) as caught:
        wearing()
    assert caught.value.result.cycles == worn.cycles[:2]
    np.testing.assert_array_equal(caught.value.result.profile(), worn.profile(2))


def fails_in_cycle_3(solve):
    def solve_or_fail(problem, standing):
        if len(standing.cycles) == 2:
            raise RuntimeError("as a cycle might")
        return solve(problem, standing)

    return solve_or_fail


def test_checkpoint_of_other_arguments_is_refused(tmp_path):
    file = tmp_path / "wear.h5"
    wearing(cycles=2, checkpoint=file)
    changes = {"threshold": 2.1e-3, "window": 5, "friction": 0.41, "tol": 1e-7}
    parts = {"window": "filter", "tol": "settings"}
    for name, value in changes.items():
        text = rf"of another run \(.*{parts.get(name, name)}.*: remove this file"
        with pytest.raises(ValueError, match=text):
            wearing(checkpoint=file, **{name: value})
    with pytest.raises(ValueError, match=r"cycles must be greater than .* \(1\), got 1"):
        wearing(checkpoint=file, cycles=1)
    file.write_bytes(b"no HDF5")
    with pytest.raises(ValueError, match=r"wear\.h5 was not written by samcontact"):
        wearing(checkpoint=file)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"threshold": 1e-5}, r"threshold must be > 2e-05 .* < 0\.05 .* got 1e-05"),
        ({"threshold": 0.06}, r"threshold must be > .* got 0\.06"),
        ({"window": None}, "exactly one of smoothing_length .* must be given, got none"),
        ({"smoothing_length": 7e-6}, "must be given, got 7e-06 and 7"),
        ({"window": None, "smoothing_length": 4e-6}, ">= one cell, 5e-06 m, got 4e-06"),
        ({"window": None, "smoothing_length": 7e-3}, r"<= 1.3e-05 m, .* got 0.007"),
        ({"window": None, "smoothing_length": 7e-6, "order": 1}, "order applies only to"),
        ({"window": 4}, "window must be an odd number"),
        ({"window": 0}, "window must be an integer >= 1, got 0"),
        ({"window": (5, 5, 5)}, "window must be a number of cells or a pair"),
        ({"window": 3, "order": 3}, "order must be < window = 3, got 3"),
        ({"window": 13}, r"window must not be larger than the contact \(9 cells"),
        ({"window": (5, 13)}, r"cells along y at maximum load\), got 13"),
        ({"strain_depth": "raw"}, "strain_depth must be one of 'exact', 'smoothed', got 'raw'"),
        ({"worn": (1,)}, "must contain only elastic-plastic bodies, got body 1 with law elastic"),
        ({"worn": ()}, r"worn must be \(1,\), \(2,\) or \(1, 2\), got \(\)"),
        ({"worn": (3,)}, "worn must be one of 1, 2, got 3"),
        ({"cycles": 0}, "cycles must be an integer >= 1, got 0"),
        ({"cycle": []}, "cycle must contain at least one step"),
        ({"cycle": [{"load": 1.0}]}, r"cycle must end unloaded, .* got \{'load': 1\.0\}"),
        ({"cycle": [{"load": 1.0}, {"approach": 0.0}]}, "cycle must end unloaded"),
        ({"cycle": [{"load": 1.0}, {"pressure": 0 * GAP}]}, "cycle must end unloaded"),
        ({"cycle": [{"load": 0.0}]}, "cycle must have at least one step with contact"),
        ({"cycle": [{"load": 1.0, "advance": (1e-6, 0.0)}, {"load": 0.0}]},
         "cycle must move both bodies back.* got sums of 1e-06 m"),
    ],
)  # fmt: skip
def test_bad_input_is_named_before_the_first_cycle(changes, message, monkeypatch):
    monkeypatch.setattr(sc.Simulation, "step", None)
    with pytest.raises(ValueError, match=message):
        wearing(**changes)


def test_a_grid_without_nz_wears_the_same(worn, tmp_path):
    grid = sc.Grid(GRID.nx, GRID.ny, GRID.dx, GRID.dy, dz=GRID.dz)
    given = {"grid": grid, "checkpoint": tmp_path / "wear"}
    wearing(cycles=2, **given)
    result = wearing(**given)
    np.testing.assert_allclose(result.profile(), worn.profile(), atol=1e-9 * np.ptp(worn.profile()))
    assert len(result.last[1].depths) < GRID.nz
    assert plotting.wear.cycle_panels(result.last).axes[1].get_ylim()[0] < GRID.nz * GRID.dz * 1e6


def test_grid_without_layers():
    flat = sc.Grid(9, 9, 1e-6, 1e-6)
    with pytest.raises(ValueError, match="grid must have layers"):
        wear.run(flat, ELASTIC, STEEL, np.zeros((9, 9)), cycle=PATH, threshold=2e-3, window=5)
