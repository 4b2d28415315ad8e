# SPDX-License-Identifier: GPL-3.0-or-later
"""Processes killed at any time resume from their files with bit-identical results."""

import contextlib
import random
import shutil
import signal

import pytest
from faulting import Nursery, with_trials_of_each

BEGIN = """
import hashlib, sys, warnings
import numpy as np
import h5netcdf, scipy.ndimage, scipy.optimize, scipy.special, xarray, samcontact.cases  # once
import samcontact as sc
warnings.simplefilter("ignore")
elastic = sc.Material.elastic(210e9, 0.3)
steel = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)

def digest(*fields):
    data = b"".join(np.ascontiguousarray(field, dtype=float).tobytes() for field in fields)
    return hashlib.sha256(data).hexdigest()

"""
RUN = """
def computed(folder):
    grid = sc.Grid(15, 15, 60e-6, 60e-6, 10, 60e-6)
    sim = sc.Simulation(grid, elastic, steel, sc.surfaces.paraboloid(grid, 7.5e-3))
    path = sc.paths.rolling(load=600.0, distance=300e-6, step=60e-6, increments=3)
    states = sim.run(path, progress=False, checkpoint=folder)
    fields = [[s.load, s.approach] for s in states]
    fields += [field for s in states for field in (s.pressure, s.gap, s.plastic_strain())]
    return digest(*fields)
"""
WEAR = """
def computed(folder):
    grid = sc.Grid(25, 21, 30e-6, 30e-6, 16, 20e-6)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    gap -= sc.surfaces.sinusoidal(grid, 2e-6, 120e-6, 120e-6)
    result = sc.wear.run(grid, elastic, steel, gap, cycle=[{"load": 40.0}, {"load": 0.0}],
                         threshold=2.5e-3, cycles=6, window=3, checkpoint=folder + ".h5",
                         progress=False)
    assert len(result.cycles) >= 3
    numbers = [[c.number, *c.volume, *c.depth, c.max_pressure] for c in result.cycles]
    return digest(result.heights[2], numbers, *(s.pressure for s in result.last))
"""
ASPERITIES = """
def computed(folder):
    collision = sc.asperities.Collision(1e-3, 1e-3, 2e-6)
    grid = collision.grid(increments=4, width=1.5, depth=1.2)
    result = sc.asperities.collide(collision, steel, steel, grid, passes=1, checkpoint=folder,
                               progress=False, tol=1e-4, on_border="warn")
    series = result.series
    return digest(*(series[name].values for name in sorted(series.data_vars)))
"""
SWEEP = """
def computed(folder):
    from samcontact.cases import parse_case
    case = parse_case('''
    title = "sweep"
    grid = {nx = 15, ny = 13, dx = 60e-6, dy = 60e-6, nz = 12, dz = 60e-6}
    body1 = {law = "elastic", E = 210e9, nu = 0.3}
    body2 = {law = "swift", E = 210e9, nu = 0.3, B = 945e6, C = 20, n = 0.121}
    surface = {shape = "paraboloid", Rx = 7.5e-3}
    path = [{load = 600.0, increments = 2}]
    ''')
    values = {"path[0].load": [400.0, 800.0]}
    data = sc.sweep(case, values, output=folder, progress=False)
    assert (data["status"].values == "done").all(), data["error"].values
    numbers = [n for n in sorted(data.data_vars) if data[n].dtype.kind == "f"]
    return digest(*(data[name].values for name in numbers))
"""
SCRIPTS = {
    "kill: run": RUN, "kill: wear": WEAR, "kill: asperities": ASPERITIES, "kill: sweep": SWEEP,
}  # fmt: skip
# With a place, the process kills itself at a system call of a write, which a random time rarely
# hits.
ANY = (
    BEGIN
    + f"SCRIPTS = {SCRIPTS!r}\n"
    + """
import os, signal
from samcontact.files import atomic as _atomic

def deadly(module, name, number):
    call, left = getattr(module, name), [number]
    def counted(*arguments, **named):
        left[0] -= 1
        if left[0] == 0:
            os.kill(os.getpid(), signal.SIGKILL)
        return call(*arguments, **named)
    setattr(module, name, counted)

def computed(argument):
    kind, folder, *place = argument.split("|")
    if place:
        owners = {"os": os, "file": _atomic._ErrorHoldingFile, "atomic": _atomic}
        deadly(owners[place[0]], place[1], int(place[2]))
    space = dict(globals())
    exec(SCRIPTS[kind], space)
    return space["computed"](folder)
"""
)


@pytest.fixture(scope="module")
def nursery():
    with contextlib.closing(Nursery(ANY)) as made:
        yield made


@with_trials_of_each(SCRIPTS)
def test_any_time(name, nursery, count, tmp_path):
    """Kill at times spread over the run, twice in the same folder, then let the run finish."""
    times = random.Random(name)
    expected, whole = nursery.run(f"{name}|{tmp_path / 'whole'}")
    assert len(expected) == 64, nursery.message()
    for trial in range(count):
        folder = tmp_path / f"trial{trial}"
        run = f"{name}|{folder}"
        moments = [(trial + times.random()) / count * whole for _ in range(2)]
        while nursery.run(run, moments[0], signal.SIGKILL)[0] is not None:
            shutil.rmtree(folder, ignore_errors=True)
            moments[0] /= 2  # the run had already ended
        nursery.run(run, moments[1], signal.SIGKILL)
        assert nursery.run(run)[0] == expected
        shutil.rmtree(folder, ignore_errors=True)


@pytest.fixture(scope="module")
def written(nursery, tmp_path_factory):
    """Return the digest of an undisturbed run."""
    return nursery.run(f"kill: run|{tmp_path_factory.mktemp('written') / 'whole'}")[0]


@pytest.mark.parametrize(
    ("module", "name", "number"),
    [
        ("file", "write", 60),
        ("atomic", "seal", 2),
        ("os", "replace", 4),
    ],
)
def test_while_writing(nursery, written, tmp_path, module, name, number):
    run = f"kill: run|{tmp_path / 'run'}"
    assert len(written) == 64
    assert nursery.run(f"{run}|{module}|{name}|{number}")[0] is None
    assert (tmp_path / "run").is_dir()
    assert nursery.message() == ""  # of an error; it was killed
    assert nursery.run(run)[0] == written
