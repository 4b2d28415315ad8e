# SPDX-License-Identifier: GPL-3.0-or-later
"""Damaged checkpoints are refused with a reason, or give exactly the written state."""

import hashlib
import warnings

import numpy as np
import pytest
from damaging import change_boxes, damage, edit, write_edited
from fuzzing import try_all, unless_refused, with_trials
from hypothesis import strategies as st

import samcontact as sc
from rough_setups import PERCENT, RIGID, zones_of
from rough_setups import simulation as rough_simulation
from samcontact import wear
from samcontact.files.ownership import is_marked
from samcontact.restart.file import READ_ERRORS, CheckpointError
from samcontact.wear import checkpoint as wear_checkpoint
from samcontact.wear import repeating

STEEL = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
HARD = sc.Material.linear_hardening(210e9, 0.3, 1e9, 21e9).with_kinematic_hardening(3e10, 50.0)
GRID = sc.Grid(9, 9, 90e-6, 90e-6, 8, 80e-6)
GAP = sc.surfaces.paraboloid(GRID, 7.5e-3)
BUMP = sc.dents.spherical(GRID, 1e-7, 1e-4)
PATH = [
    {"load": 600.0},
    {"load": 700.0, "advance": (30e-6, 90e-6)},
    {"load": 0.0},
]


def problem():
    return sc.Simulation(GRID, HARD, STEEL, GAP, relief2=BUMP, on_border="warn", tol=1e-5)


def digest(simulation):
    """Return a digest of all data that the next step starts from."""
    state, total = simulation.state, hashlib.sha256()
    fields = [state.pressure, state.gap, state.shear, simulation.initial_gap]
    for body in (1, 2):
        track = state.track(body, margin=0)
        fields += [track.plastic_strain(), track.equivalent_plastic_strain(), track.backstress()]
    for field in fields:
        total.update(np.ascontiguousarray(field).tobytes())
    numbers = (state.load, state.approach, state.travel, state.time, state.iterations)
    total.update(repr((simulation, numbers)).encode())
    return total.hexdigest()


@pytest.fixture(scope="module")
def saved(tmp_path_factory):
    """Return the bytes of a checkpoint with most kinds of parts, and the digest of its state."""
    simulation = problem()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", sc.ResolutionWarning)
        simulation.run(PATH[:2], progress=False)
    file = tmp_path_factory.mktemp("saved") / "state.h5"
    simulation.save(file)
    assert simulation.state.plastic_cells() > 50
    return file.read_bytes(), digest(simulation)


@with_trials("flipped or cut bytes of checkpoints")
def test_damaged_bytes(saved, tmp_path, count):
    content, expected = saved
    file = tmp_path / "state.h5"
    same = 0

    def check(hurt):
        nonlocal same
        file.write_bytes(hurt(content))
        simulation = unless_refused(lambda: sc.Simulation.load(file), CheckpointError, str(file))
        if simulation is None:
            return
        assert digest(simulation) == expected
        same += 1

    try_all(check, count, hurt=damage())
    assert same < 0.2 * count  # zeros for zeros, and the like


@with_trials("edited parts of checkpoints")
def test_edited_parts(saved, tmp_path, count):
    """Files with a matching digest: accepted content can be computed with."""
    file = tmp_path / "state.h5"

    def check(change):
        write_edited(saved[0], file, change)
        simulation = unless_refused(lambda: sc.Simulation.load(file), CheckpointError, str(file))
        if simulation is None:
            return
        assert np.isfinite(simulation.state.pressure).all()
        for body in (1, 2):
            assert np.isfinite(simulation.state.track(body, margin=0).plastic_strain()).all()

    try_all(check, count, change=edit())


@with_trials("boxes of subdomains in checkpoints")
def test_changed_boxes(tmp_path, count):
    """Accepted content can be continued from; an error of a step is a documented one."""
    first, file = tmp_path / "first.h5", tmp_path / "state.h5"
    simulation = rough_simulation(RIGID, STEEL, tol=1e-2)
    simulation.step(load=PERCENT)
    simulation.save(first)
    content, boxes = first.read_bytes(), zones_of(simulation, 2)
    assert len(boxes) > 4
    some, refused = 3 * np.prod(boxes[:, 2:5], axis=1).sum(), 0

    def check(name, data):
        nonlocal refused
        write_edited(content, file, data.draw(change_boxes(f"state/{name}")))
        simulation = unless_refused(lambda: sc.Simulation.load(file), CheckpointError, str(file))
        refused += simulation is None
        if simulation is None or np.prod(zones_of(simulation, 2)[:, 2:], axis=1).sum() > some:
            return
        state = unless_refused(
            lambda: simulation.step(load=1.2 * PERCENT), (ValueError, sc.ConvergenceError)
        )
        if state is not None:
            assert np.isfinite(state.pressure).all()
            assert np.isfinite(state.plastic_strain()).all()

    names = st.sampled_from(["history2/zones", "flow_boxes2"])
    try_all(check, count, name=names, data=st.data())
    assert refused > 0.3 * count


@with_trials("flipped or cut bytes of a journal")
@pytest.mark.filterwarnings("ignore:.*is damaged")
def test_damaged_journal(tmp_path, count):
    """A run ends with the same bits, or refuses a file that it no longer recognises."""
    folder = tmp_path / "journal"
    elastic = sc.Material.elastic(210e9, 0.3)

    def run():
        simulation = sc.Simulation(GRID, elastic, STEEL, GAP, tol=1e-5)
        path = [{"load": 300.0}, {"load": 400.0}]
        simulation.run(path, progress=False, checkpoint=folder)
        return digest(simulation)

    expected = run()
    contents = {file.name: file.read_bytes() for file in sorted(folder.iterdir())}
    assert sorted(contents) == ["increment_00001.h5", "increment_00002.h5"]

    def check(hurt, name):
        for each, content in contents.items():
            (folder / each).write_bytes(hurt(content) if each == name else content)
        wanted = expected if is_marked(folder / name) else None
        assert unless_refused(run, ValueError, str(folder)) == wanted

    try_all(check, count, hurt=damage(), name=st.sampled_from(sorted(contents)))


@pytest.fixture(scope="module")
def worn(tmp_path_factory):
    """Return the bytes of a wear checkpoint, its setup and its state."""
    file = tmp_path_factory.mktemp("worn") / "cycle.h5"
    kept = []
    latest = wear_checkpoint.latest

    def spy(path, problem):
        kept.append(problem)
        return latest(path, problem)

    repeating.latest = spy
    try:
        grid = sc.Grid(15, 13, 60e-6, 60e-6, 12, 40e-6)
        gap = sc.surfaces.paraboloid(grid, 7.5e-3)
        gap -= sc.surfaces.sinusoidal(grid, 3e-6, 180e-6, 180e-6)
        wear.run(
            grid, sc.Material.elastic(210e9, 0.3), STEEL, gap, cycle=[{"load": 400.0}, {"load": 0}],
            threshold=3e-3, cycles=3, window=3, checkpoint=file, progress=False, tol=1e-4,
        )  # fmt: skip
    finally:
        repeating.latest = latest
    standing = latest(file, kept[0])
    assert len(standing.cycles) == 2
    return file.read_bytes(), kept[0], standing_digest(standing)


def standing_digest(standing):
    total = hashlib.sha256(repr(standing.cycles).encode())
    for body, heights in sorted(standing.heights.items()):
        total.update(repr(body).encode() + np.stack(heights).tobytes())
    for body, kept in sorted(standing.strains.items()):
        total.update(repr((body, kept.first, kept.strain.shape)).encode())
        for field in (kept.strain, kept.equivalent, kept.backstress):
            total.update(b"" if field is None else np.ascontiguousarray(field).tobytes())
    return total.hexdigest()


@with_trials("flipped or cut bytes of wear checkpoints")
def test_damaged_wear(worn, tmp_path, count):
    content, scene_, expected = worn
    file = tmp_path / "cycle.h5"

    def check(hurt):
        file.write_bytes(hurt(content))
        standing = unless_refused(
            lambda: wear_checkpoint.read(file, scene_), CheckpointError, str(file)
        )
        if standing is None:
            return
        assert standing_digest(standing) == expected

    try_all(check, count, hurt=damage())


@with_trials("edited parts of wear checkpoints")
def test_edited_wear(worn, tmp_path, count):
    content, scene_, _ = worn
    file = tmp_path / "cycle.h5"

    def check(change):
        write_edited(content, file, change)
        standing = unless_refused(
            lambda: wear_checkpoint.read(file, scene_), CheckpointError, str(file)
        )
        if standing is None:
            return
        for heights in standing.heights.values():
            assert len(heights) == len(standing.cycles) + 1
            assert np.isfinite(heights).all()

    try_all(check, count, change=edit())


def test_errors_of_libraries_become_refusals():
    """READ_ERRORS contain CheckpointError, so that a refusal in a helper remains a refusal."""
    assert issubclass(CheckpointError, READ_ERRORS)
