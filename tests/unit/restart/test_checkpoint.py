# SPDX-License-Identifier: GPL-3.0-or-later
"""Checkpoints: bit-identical continuation; damaged files and failed writes do no harm."""

import contextlib
import os
import subprocess
import sys

import h5py
import numpy as np
import pytest

import samcontact as sc
from checkpoint_setups import (
    EXACT,
    GAP,
    GRID,
    LOAD,
    MATERIALS,
    SIZE,
    assert_same,
    halved,
    simulation,
)
from samcontact.files.checksum import seal
from samcontact.restart import tree
from samcontact.simulation.journal import describe


@pytest.fixture
def path(tmp_path):
    return tmp_path / "state.h5"


@pytest.mark.parametrize(
    ("body1", "body2", "settings"),
    [
        ("elastic", "linear", {}),
        ("rigid", "perfect", {"tol": 1e-5}),
        ("swift", "elastic", {"friction": 0.1, "tol": 1e-7}),
        ("swift", "linear", {"on_border": "warn", "max_iterations": 55, "increment_tol": 0.05}),
        ("elastic", "rigid", {}),
    ],
)
def test_continuation_has_identical_bits(path, body1, body2, settings):
    sim = simulation(body1, body2, **settings)
    sim.step(load=0.4 * LOAD)
    sim.step(load=0.7 * LOAD)
    sim.save(path)
    other = sc.Simulation.load(path)

    assert other.grid == sim.grid
    assert (other.body1, other.body2) == (sim.body1, sim.body2)
    assert describe(other.engine) == describe(sim.engine)
    assert repr(other) == repr(sim)
    for name in ("friction", "tol", "increment_tol", "on_border", "max_iterations"):
        assert getattr(other, name) == getattr(sim, name)
        assert type(getattr(other, name)) is type(getattr(sim, name))
    np.testing.assert_array_equal(other.initial_gap, GAP)
    assert_same(other.state, sim.state)
    before, after = other.counters, sim.counters
    before.pop("volume_bytes"), after.pop("volume_bytes")  # kernels are built when needed
    assert before == after

    plastic = body1 in ("linear", "swift") or body2 in ("linear", "perfect")
    for arguments in ({"load": 0.9 * LOAD}, {"approach": sim.state.approach / 2}, {"load": 0.0}):
        state = sim.step(**arguments)
        assert_same(other.step(**arguments), state)
        if arguments == {"load": 0.9 * LOAD}:
            assert (state.iterations > 0) == plastic


def test_a_journal_continues_with_a_law_that_cannot_be_stored(tmp_path):
    steel = MATERIALS["linear"].with_thermal(50.0, 1e-5, 1.4e-5).with_softening(halved)

    def soft():
        heat = sc.Heat(1e-3, [1.0, 0.0], reference=1.0)
        return sc.Simulation(GRID, MATERIALS["elastic"], steel, GAP, heat=heat)

    path = [{"load": 0.2 * LOAD}, {"load": 0.3 * LOAD}]
    first = soft().run(path, progress=False, checkpoint=tmp_path)
    again = soft().run(path, progress=False, checkpoint=tmp_path)
    assert_same(again[-1], first[-1])
    assert first[-1].plastic_cells() > 0


def test_before_the_first_step(path):
    simulation().save(path)
    assert_same(sc.Simulation.load(path).step(load=LOAD), simulation().step(load=LOAD))


def test_without_layers(path):
    grid = sc.Grid(15, 17, SIZE, 0.9 * SIZE)
    sim = sc.Simulation(grid, MATERIALS["elastic"], MATERIALS["rigid"], GAP)
    sim.step(load=LOAD)
    sim.save(str(path))
    other = sc.Simulation.load(str(path))
    assert other.grid == grid
    assert_same(other.step(load=0.5 * LOAD), sim.step(load=0.5 * LOAD))


def test_after_prescribed_tractions_and_given_strain(path):
    sim = simulation("linear", "swift", friction=0.1)
    strain = 1e-4 * np.random.default_rng(3).standard_normal((6, *GRID.volume_shape))
    sim.set_plastic_strain(1, strain, np.full(GRID.volume_shape, 1e-3))
    pressure = EXACT.pressure(GRID.x[:, None], GRID.y)
    sim.step(pressure=0.6 * pressure, shear=np.stack([0.1 * pressure, 0.05 * pressure]))
    sim.save(path)
    other = sc.Simulation.load(path)
    assert_same(other.state, sim.state)
    assert_same(other.step(load=0.5 * LOAD), sim.step(load=0.5 * LOAD))


RESUME = """
import sys, numpy as np, samcontact as sc
state = sc.Simulation.load(sys.argv[1]).step(load=float(sys.argv[2]))
np.savez(sys.argv[3], pressure=state.pressure, strain=state.plastic_strain(), gap=state.gap)
"""


def test_in_another_process(path, tmp_path):
    sim = simulation(friction=0.1)
    sim.step(load=0.6 * LOAD)
    sim.save(path)
    result = tmp_path / "result.npz"
    command = [sys.executable, "-c", RESUME, str(path), repr(LOAD), str(result)]
    subprocess.run(command, check=True)
    state = sim.step(load=LOAD)
    assert state.iterations > 0
    with np.load(result) as there:
        np.testing.assert_array_equal(there["pressure"], state.pressure)
        np.testing.assert_array_equal(there["strain"], state.plastic_strain())
        np.testing.assert_array_equal(there["gap"], state.gap)


@contextlib.contextmanager
def edited(path):
    """Open a checkpoint for changes and renew its digest, so that only other checks can fail."""
    with h5py.File(path, "a") as file:
        yield file
    seal(path)


class TestDamage:
    @pytest.fixture
    def saved(self, path):
        sim = simulation()
        sim.step(load=LOAD)
        sim.save(path)
        return path

    def test_no_file(self, path):
        with pytest.raises(FileNotFoundError, match=r"no checkpoint at '.*state\.h5'"):
            sc.Simulation.load(path)

    @pytest.mark.parametrize("content", [b"", b"load,approach\n1,2\n", os.urandom(4096)])
    def test_a_file_that_is_no_checkpoint(self, path, content):
        path.write_bytes(content)
        with pytest.raises(sc.CheckpointError, match=r"state\.h5' is damaged"):
            sc.Simulation.load(path)

    def test_another_hdf5_file(self, path):
        with h5py.File(path, "w") as file:
            file["initial_gap"] = GAP
        with pytest.raises(sc.CheckpointError, match="is not a samcontact checkpoint") as caught:
            sc.Simulation.load(path)
        assert isinstance(caught.value, ValueError)

    def test_a_later_format(self, saved):
        with edited(saved) as file:
            file.attrs["format_version"] = 99
        text = "has checkpoint format 99, but samcontact .* reads format 12: use samcontact"
        with pytest.raises(sc.CheckpointError, match=text):
            sc.Simulation.load(saved)

    @pytest.mark.parametrize("part", [0.1, 0.5, 0.9, 0.999])
    def test_a_truncated_file(self, saved, part):
        content = saved.read_bytes()
        saved.write_bytes(content[: int(part * len(content))])
        with pytest.raises(sc.CheckpointError, match="is damaged"):
            sc.Simulation.load(saved)

    @pytest.mark.parametrize("name", ["pressure", "history2/strain", "history2/equivalent"])
    def test_flipped_bits_in_the_numbers(self, saved, name):
        """A changed byte in a field is detected and does not change the start slightly."""
        with h5py.File(saved, "r") as file:
            chunk = file["state"][name].id.get_chunk_info(0)
        content = bytearray(saved.read_bytes())
        content[chunk.byte_offset + chunk.size // 2] ^= 0x10
        saved.write_bytes(content)
        with pytest.raises(sc.CheckpointError, match="is damaged"):
            sc.Simulation.load(saved)

    @pytest.mark.parametrize(
        "name",
        [
            "setup/grid",
            "setup/body1",
            "setup/settings",
            "setup/gap",
            "state",
            "counters",
            "state/pressure",
            "state/history2/strain",
        ],
    )
    def test_missing_part(self, saved, name):
        with edited(saved) as file:
            del file[name]
        with pytest.raises(sc.CheckpointError, match="is damaged"):
            sc.Simulation.load(saved)

    @pytest.mark.parametrize(
        "name",
        [
            "pressure",
            "history2/strain",
            "history2/equivalent",
        ],
    )
    def test_a_part_of_wrong_shape(self, saved, name):
        with edited(saved) as file:
            values = file["state"][name][...]
            del file["state"][name]
            file["state"][name] = values[..., 1:]
        with pytest.raises(sc.CheckpointError, match="is damaged"):
            sc.Simulation.load(saved)

    @pytest.mark.parametrize("group", ["state", "state/history2"])
    def test_an_unknown_part(self, saved, group):
        """A part unknown to this version may be essential to the version that wrote it."""
        with edited(saved) as file:
            file[group].attrs["later"] = 1.0
        with pytest.raises(sc.CheckpointError, match="is damaged: unknown part 'later'"):
            sc.Simulation.load(saved)

    def test_changed_by_another_program(self, saved):
        with h5py.File(saved, "a") as file:
            file["state"].attrs["load"] = 1.0
        with pytest.raises(sc.CheckpointError, match="checksum at the end is missing"):
            sc.Simulation.load(saved)

    @pytest.mark.parametrize("name", ["pressure", "history2/strain", "history2/equivalent"])
    def test_values_that_are_nan(self, saved, name):
        with edited(saved) as file:
            file["state"][name][..., 0] = np.nan
        with pytest.raises(sc.CheckpointError, match=r"is damaged: .* finite"):
            sc.Simulation.load(saved)

    def test_another_type_of_numbers(self, saved):
        with edited(saved) as file:
            values = file["state/pressure"][...]
            del file["state/pressure"]
            file["state/pressure"] = values.astype(np.float32)
        with pytest.raises(
            sc.CheckpointError, match="pressure must be of type float64, got float32"
        ):
            sc.Simulation.load(saved)

    def test_a_group_where_an_array_belongs(self, saved):
        with edited(saved) as file:
            del file["setup/settings"]
            file["setup/settings"] = 1.0
        with pytest.raises(sc.CheckpointError, match="is damaged"):
            sc.Simulation.load(saved)

    @pytest.mark.parametrize(
        ("group", "attribute", "value"),
        [
            ("state", "past_symmetry", 7),
            ("state", "travel", [np.nan, 0.0]),
            ("state", "load", np.inf),
            ("state/history2", "box", [2**31 - 1, 0, 3, 3, 3]),
            ("state", "residual_method", 2),
            ("state", "heat_factor1", -1.0),
            ("state", "load", [1.0, 2.0]),
            ("setup/grid", "dx", -1.0),
            ("setup/body2/parameters", "nu", 0.7),
            ("setup/body2", "law", "viscous"),
            ("setup/settings", "tol", "tight"),
            ("setup/settings/friction", "coefficient", -1.0),
            ("setup/settings/friction", "law", "unheard of"),
            ("state/history2", "box", [-1, 0, 3, 3, 3]),
            ("state/history2", "mirrored", 3),
            ("state/history2", "origin", [0, 2**31 - 1]),
        ],
    )
    def test_impossible_values(self, saved, group, attribute, value):
        with edited(saved) as file:
            file[group].attrs[attribute] = value
        with pytest.raises(sc.CheckpointError, match="is damaged"):
            sc.Simulation.load(saved)

    @pytest.mark.parametrize(
        "spoil",
        [
            lambda boxes: np.repeat(boxes, 2, axis=0),
            lambda boxes: np.repeat(boxes // [1, 1, 1, 1, 2, 1], 2, axis=0),  # as many cells
            lambda boxes: boxes - [100, 0, 0, 0, 0, 0],
            lambda boxes: boxes * [1, 1, -1, -1, 1, 1],
            lambda boxes: boxes - [-(2**32), 0, 0, 0, 0, 0],
            lambda boxes: boxes[:, :4],
            lambda boxes: boxes[0],
        ],
    )
    @pytest.mark.parametrize("name", ["history2/zones", "flow_boxes2"])
    def test_impossible_boxes(self, saved, name, spoil):
        with edited(saved) as file:
            boxes = file["state"][name][...]
            del file["state"][name]
            file["state"][name] = spoil(boxes)
        with pytest.raises(sc.CheckpointError, match="is damaged"):
            sc.Simulation.load(saved)


class TestFailedSave:
    def test_a_failed_save_keeps_the_old_file(self, path, monkeypatch):
        sim = simulation()
        sim.step(load=0.5 * LOAD)
        sim.save(path)
        content = path.read_bytes()
        sim.step(load=LOAD)
        write, left = tree._dataset, [2]

        def interrupted(group, name, values):
            write(group, name, values)
            left[0] -= 1
            if left[0] == 0:
                raise OSError("No space left on device")

        with monkeypatch.context() as patch:
            patch.setattr(tree, "_dataset", interrupted)
            with pytest.raises(OSError, match="No space left"):
                sim.save(path)
            assert path.read_bytes() == content
            assert [entry.name for entry in path.parent.iterdir()] == [path.name]
        sim.save(path)
        assert_same(sc.Simulation.load(path).state, sim.state)

    def test_names_a_missing_folder(self, tmp_path):
        with pytest.raises(FileNotFoundError, match="missing"):
            simulation().save(tmp_path / "missing" / "state.h5")
