# SPDX-License-Identifier: GPL-3.0-or-later
"""Wear: depth, smoothing and the strain that is left; cycles, checkpoints, and what is refused."""

import numpy as np
import pytest

import samcontact as sc
from samcontact import wear
from samcontact._wear_steps import shift_deviator

RNG = np.random.default_rng(7)
ELASTIC = sc.Material.elastic(210e9, 0.3)
STEEL = sc.Material.swift(210e9, 0.3, 1735e6, 16.0, 0.067)
GRID = sc.Grid(29, 27, 5e-6, 5e-6, 28, 1.6e-6)
GAP = sc.surfaces.paraboloid(GRID, 4e-4)
PATH = [{"load": 5.0}, {"load": 0.0}]


def wearing(**changes):
    """A ball of 0.4 mm under a load at which the surface wears."""
    given = {"cycle": PATH, "threshold": 2e-3, "cycles": 3, "window": 7, "friction": 0.4}
    return wear.run(GRID, ELASTIC, STEEL, GAP, progress=False, **(given | changes))


@pytest.fixture(scope="module")
def worn():
    return wearing()


def columns(profile, nz, dz):
    z = (np.arange(nz) + 0.5) * dz
    return profile(z)[None, None, :]


def test_depth_of_a_linear_profile_is_exact():
    field = columns(lambda z: 0.01 - 700.0 * z, 12, 1e-6)
    assert wear.depth(field, 1e-6, 0.004)[0, 0] == pytest.approx(6e-3 / 700, rel=1e-14)


def test_depth_of_an_exponential_converges():
    exact = 1e-5 * np.log(5.0)
    errors = []
    for n in (10, 20, 40, 80):
        dz = 4e-5 / n
        field = columns(lambda z: 0.01 * np.exp(-z / 1e-5), n, dz)
        errors.append(abs(wear.depth(field, dz, 0.002)[0, 0] - exact))
    assert errors[0] < 0.01 * exact
    assert errors[3] < errors[0] / 64  # of second order at least


def test_depth_lies_between_the_two_layers():
    """Where polynomials would overshoot: a plateau, and then a step."""
    field = np.array([5.0, 5.0, 5.0, 5.0, 0.0, 0.0, 0.0])[None, None, :]
    found = [wear.depth(field, 1.0, limit)[0, 0] for limit in (4.999, 2.5, 0.001)]
    assert 3.5 < found[0] < found[1] < found[2] < 4.5
    assert found[1] == pytest.approx(4.0, abs=1e-12)


def test_depth_only_from_the_surface_down():
    field = np.zeros((3, 1, 6))
    field[0, 0] = [1, 3, 3, 1, 0, 0]  # below the surface only
    field[1, 0] = [3, 1, 3, 3, 0, 0]  # the second zone is not connected
    field[2, 0] = [2, 0, 0, 0, 0, 0]  # at the threshold, not beyond
    found = wear.depth(field, 1.0, 2.0)[:, 0]
    assert found[0] == 0
    assert found[2] == 0
    assert 0.5 < found[1] < 1.5


@pytest.mark.parametrize(("window", "order"), [(5, 2), ((7, 3), 1), (9, 4), ((1, 5), 2)])
def test_smoothing_keeps_the_volume(window, order):
    given = np.zeros((20, 18))
    given[6:15, 5:11] = RNG.uniform(0, 3e-6, (9, 6))
    given[0, 0] = 2e-6  # at the border of the array
    made = wear.smooth(given, window, order)
    assert made.min() >= 0
    assert np.abs(made - given).max() > 1e-7
    assert made.sum() == pytest.approx(given.sum(), rel=1e-14)


def test_smoothing_fits_a_polynomial_in_each_window():
    """Against a least-squares fit of x^m y^n, m and n up to the order, about one cell."""
    given = 10 + RNG.uniform(0, 1, (15, 13))
    made = wear.smooth(given, (5, 7), 2)
    x, y = (a.ravel() for a in np.meshgrid(np.arange(-2, 3), np.arange(-3, 4), indexing="ij"))
    terms = np.stack([x**m * y**n for m in range(3) for n in range(3)], axis=1)
    fitted = np.linalg.lstsq(terms.astype(float), given[5:10, 3:10].ravel(), rcond=None)[0][0]
    other = np.linalg.lstsq(terms.astype(float), given[6:11, 4:11].ravel(), rcond=None)[0][0]
    # up to the factor that restores the volume, which is lost beyond the array here
    assert made[7, 6] / made[8, 7] == pytest.approx(fitted / other, rel=1e-12)


def test_smoothing_reproduces_polynomials_inside():
    x, y = np.meshgrid(np.arange(30.0), np.arange(26.0), indexing="ij")
    surface = 50 + x + 0.1 * (x - 12) ** 2 + 0.05 * (y - 9) ** 2
    given = np.zeros((40, 36))
    given[5:35, 5:31] = surface
    made = wear.smooth(given, 5, 2)[7:33, 7:29]
    ratio = made / surface[2:28, 2:24]
    np.testing.assert_allclose(ratio, ratio[0, 0], rtol=1e-12)


@pytest.mark.parametrize("window", [None, 1, (1, 1)])
def test_no_smoothing(window):
    given = RNG.uniform(0, 1, (6, 5))
    np.testing.assert_array_equal(wear.smooth(given, window, 0), given)


def test_shift_by_whole_layers():
    field = RNG.normal(size=(6, 4, 3, 9))
    layers = RNG.integers(0, 11, (4, 3))
    made = wear.shift(field, layers * 2.0, 2.0)
    for i, j in np.ndindex(4, 3):
        n = min(int(layers[i, j]), 9)
        expected = np.concatenate([field[:, i, j, n:], np.zeros((6, n))], axis=1)
        np.testing.assert_allclose(made[:, i, j], expected, atol=1e-14)


def test_shift_between_layers():
    z = (np.arange(60) + 0.5) * 0.1
    field = np.broadcast_to(np.exp(-z), (2, 1, 60))
    made = wear.shift(field, np.array([[0.234], [0.0]]), 0.1)
    np.testing.assert_allclose(made[0, 0, :50], np.exp(-z - 0.234)[:50], rtol=2e-3)
    np.testing.assert_array_equal(made[1], field[1])


def test_shift_does_not_overshoot():
    field = RNG.uniform(0, 1, (5, 4, 12)) ** 8
    made = wear.shift(field, RNG.uniform(0, 6, (5, 4)), 1.0)
    assert made.min() >= -1e-15
    assert (made.max(axis=2) <= field.max(axis=2) + 1e-15).all()


def test_shifted_deviators_stay_deviators():
    field = RNG.normal(size=(6, 3, 2, 8))
    field[2] = -field[0] - field[1]
    field[0, 2, 1] += 1.0  # one column is no deviator
    removed = np.array([[0.3, 0.0], [1.7, 2.2], [0.4, 0.6]])
    made = shift_deviator(field, removed, 1.0)
    trace = made[:3].sum(axis=0)
    assert np.abs(trace[:2]).max() < 1e-14
    np.testing.assert_allclose(made[:, 2, 1], wear.shift(field, removed, 1.0)[:, 2, 1])
    assert np.abs(wear.shift(field, removed, 1.0)[:3, :2].sum(axis=0)).max() > 1e-3


def test_a_light_load_wears_nothing():
    result = wearing(cycle=[{"load": 1.0}, {"load": 0.0}], window=5)
    assert result.stopped
    assert len(result.cycles) == 1
    assert result.cycles[0].volume == (0.0,)
    assert not result.relief2.heights.any()


def test_plastic_flow_below_the_threshold_wears_nothing():
    result = wearing(threshold=0.04, cycle=[{"load": 6.0}, {"load": 0.0}])
    assert result.stopped
    assert 1e-3 < result.cycles[0].surface_strain[0] <= 0.04


def test_volume_lost_is_volume_removed(worn):
    assert worn.cycles[0].volume[0] > 0
    for cycle in worn.cycles:
        assert cycle.lost[0] == pytest.approx(cycle.volume[0], rel=1e-12)
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


def test_next_cycle_starts_from_the_worn_surface_and_what_is_left(worn):
    first = worn.first[1]
    strain = first.equivalent_plastic_strain()
    removed = wear.depth(strain, GRID.dz, 2e-3)
    simulation = sc.Simulation(
        GRID, ELASTIC, STEEL, GAP, 0.4, relief2=sc.Relief(-wear.smooth(removed, 7))
    )
    left = np.maximum(wear.shift(strain, removed, GRID.dz), 0.0)
    assert strain[..., 0].max() > 2e-3 > left[..., 0].max() > 1e-3
    simulation.set_plastic_strain(2, shift_deviator(first.plastic_strain(), removed, GRID.dz), left)
    second = simulation.step(**PATH[0])
    assert second.pressure.max() == pytest.approx(worn.cycles[1].max_pressure, rel=1e-6)


def test_strain_may_move_up_by_the_smoothed_depth(worn):
    """Then some of what exceeds the threshold stays, and wears without any new flow."""
    exact, smoothed = (wearing(order=1, cycles=2, strain_depth=s) for s in ("exact", "smoothed"))
    left = wear.shift(
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
    """A bump is worn off; the ball then rests on a surface that does not wear."""
    grid = sc.Grid(35, 31, 5e-6, 5e-6, 30, 1e-6)
    result = wear.run(
        grid, ELASTIC, STEEL, sc.surfaces.paraboloid(grid, 7.5e-3), window=None, friction=0.4,
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


def test_both_bodies_wear_alike():
    """Friction on body 1 acts the other way: its wear is body 2's, mirrored in x."""
    result = wear.run(
        GRID, STEEL, STEEL, GAP, cycle=[{"load": 6.5}, {"load": 0.0}], threshold=2e-3, cycles=1,
        worn=(1, 2), friction=0.4, progress=False,
    )  # fmt: skip
    assert result.cycles[0].volume[0] > 0
    mirrored = result.profile(1, body=1)[::-1]
    scale = np.abs(mirrored).max()
    np.testing.assert_allclose(mirrored, result.profile(1, body=2), atol=1e-3 * scale)


def test_kinematic_hardening_wears():
    combined = STEEL.with_kinematic_hardening(20e9, 50.0)
    result = wear.run(
        GRID, ELASTIC, combined, GAP, cycle=PATH, threshold=2e-3, cycles=2, friction=0.4,
        progress=False,
    )  # fmt: skip
    assert result.cycles[0].volume[0] > 0
    back = result.last[1].backstress()
    assert np.abs(back[:, :3].sum(axis=1)).max() < 1e-9 * np.abs(back).max()


def test_a_track_longer_than_the_grid_wears():
    length = 12 * GRID.dx
    path = [{"load": 4.6}]
    path += [{"load": 4.6, "advance": (-2 * GRID.dx, -2 * GRID.dx)}] * 6
    path += [{"load": 0.0, "advance": (length, length)}]
    result = wearing(cycle=path, cycles=2)
    x = result.x()
    deep = -result.profile(1)[:, 13]
    assert deep[np.abs(x - length) < 2 * GRID.dx].max() > 0.3 * deep.max()
    assert x[deep > 0].max() - x[deep > 0].min() > length
    for cycle in result.cycles:
        assert cycle.volume[0] > 0
        assert cycle.lost[0] == pytest.approx(cycle.volume[0], rel=1e-12)
    # the second cycle meets the worn track: as a new simulation with it does
    again = sc.Simulation(GRID, ELASTIC, STEEL, GAP, 0.4, relief2=result.relief2)
    assert again.step(load=1e-3).pressure.max() > 0


def test_goes_on_bit_identically(tmp_path, worn):
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
    assert [entry.name for entry in tmp_path.iterdir()] == ["wear.h5"]


def test_interrupted_runs_go_on(tmp_path, worn, monkeypatch):
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


def test_errors_bring_the_cycles_before_them(worn, monkeypatch):
    monkeypatch.setattr(wear, "_solve", fails_in_cycle_3(wear._solve))
    with pytest.raises(RuntimeError) as caught:
        wearing()
    assert caught.value.result.cycles == worn.cycles[:2]
    np.testing.assert_array_equal(caught.value.result.profile(), worn.profile(2))


def fails_in_cycle_3(solve):
    def solve_or_fail(scene, standing):
        if len(standing.cycles) == 2:
            raise RuntimeError("as a cycle might")
        return solve(scene, standing)

    return solve_or_fail


def test_checkpoint_of_other_arguments_is_refused(tmp_path):
    file = tmp_path / "wear.h5"
    wearing(cycles=2, checkpoint=file)
    for change in ({"threshold": 2.1e-3}, {"window": 5}, {"friction": 0.41}, {"tol": 1e-7}):
        with pytest.raises(ValueError, match="was written with other arguments"):
            wearing(checkpoint=file, **change)
    with pytest.raises(ValueError, match="cycles must be > 1, those of the checkpoint, got 1"):
        wearing(checkpoint=file, cycles=1)
    file.write_bytes(b"no HDF5")
    with pytest.raises(ValueError, match=r"wear\.h5' is damaged"):
        wearing(checkpoint=file)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"threshold": 1e-5}, r"threshold must be above 2e-05, .* below 0\.05, .* got 1e-05"),
        ({"threshold": 0.06}, r"threshold must be above .* got 0\.06"),
        ({"window": 4}, "window must be odd"),
        ({"window": 0}, "window must be an integer >= 1, got 0"),
        ({"window": (5, 5, 5)}, "window must be a number of cells or a pair"),
        ({"window": 3, "order": 3}, "order must be less than window = 3, got 3"),
        ({"window": 13}, "window must not be larger than the contact, which is 9 cells long"),
        ({"window": (5, 13)}, "cells long along y at the largest load, got 13"),
        ({"strain_depth": "raw"}, "strain_depth must be one of 'exact', 'smoothed', got 'raw'"),
        ({"worn": (1,)}, "worn must name inelastic bodies; body 1 is elastic"),
        ({"worn": ()}, r"worn must be \(1,\), \(2,\) or \(1, 2\), got \(\)"),
        ({"worn": (3,)}, "worn must be one of 1, 2, got 3"),
        ({"cycles": 0}, "cycles must be an integer >= 1, got 0"),
        ({"cycle": []}, "cycle must hold at least one step"),
        ({"cycle": [{"load": 1.0}]}, r"cycle must end unloaded, .* got \{'load': 1\.0\}"),
        ({"cycle": [{"load": 1.0}, {"approach": 0.0}]}, "cycle must end unloaded"),
        ({"cycle": [{"load": 1.0}, {"pressure": 0 * GAP}]}, "cycle must end unloaded"),
        ({"cycle": [{"load": 0.0}]}, "cycle must bring the bodies into contact"),
        ({"cycle": [{"load": 1.0, "advance": (1e-6, 0.0)}, {"load": 0.0}]},
         "cycle must bring both bodies back .* got 1e-06 m"),
    ],
)  # fmt: skip
def test_bad_input_is_named_before_the_first_cycle(changes, message, monkeypatch):
    monkeypatch.setattr(sc.Simulation, "step", None)
    with pytest.raises(ValueError, match=message):
        wearing(**changes)


def test_grid_without_layers():
    flat = sc.Grid(9, 9, 1e-6, 1e-6)
    with pytest.raises(ValueError, match="grid must have layers"):
        wear.run(flat, ELASTIC, STEEL, np.zeros((9, 9)), cycle=PATH, threshold=2e-3)


def test_strain_to_the_bottom():
    with pytest.raises(ValueError, match=r"the grid is too shallow: .* threshold = 0\.5"):
        wear.depth(np.ones((2, 2, 3)), 1e-6, 0.5)


def test_bad_fields():
    with pytest.raises(ValueError, match="depth must be >= 0 everywhere, got -1"):
        wear.smooth(-np.ones((7, 7)))
    with pytest.raises(ValueError, match="depth must be >= 0 everywhere, got -1"):
        wear.shift(np.ones((7, 7, 2)), -np.ones((7, 7)), 1.0)
    with pytest.raises(ValueError, match=r"equivalent must have shape \(nx, ny, nz\)"):
        wear.depth(np.ones((7, 7)), 1.0, 0.1)
