# SPDX-License-Identifier: GPL-3.0-or-later
"""Ctrl-C takes effect at any time, and only the current increment is lost."""

import random
import signal

from faulting import finished, start, tried

SCENE = """
import hashlib, os, signal, sys, threading, time, warnings
import numpy as np
import samcontact as sc
warnings.simplefilter("ignore")
elastic = sc.Material.elastic(210e9, 0.3)
steel = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
grid = sc.Grid(41, 41, 36e-6, 36e-6, 24, 36e-6)
gap = sc.surfaces.paraboloid(grid, 7.5e-3)

def scene(method):
    return sc.Simulation(grid, elastic, steel, gap, residual_stress=method)

def digest(*states):
    fields = [f for s in states for f in (s.pressure, s.gap, s.plastic_strain())]
    return hashlib.sha256(b"".join(np.ascontiguousarray(f).tobytes() for f in fields)).hexdigest()

def press_after(seconds):
    def press():
        time.sleep(seconds)
        os.kill(os.getpid(), signal.SIGINT)
    return threading.Thread(target=press)
"""
STEPS = (
    SCENE
    + """
def expected(method):
    for _ in range(2):  # the first makes plans
        sim = scene(method)
        sim.step(load=300.0)
        begun = time.perf_counter()
        result = digest(sim.step(load=1200.0)), time.perf_counter() - begun
    return result

known = {method: expected(method) for method in ("fast", "exact")}
def interrupted(method, moment):
    result, whole = known[method]
    sim = scene(method)
    before = digest(sim.step(load=300.0))
    thread = press_after(moment * whole)
    try:
        thread.start()
        sim.step(load=1200.0)
        while True:  # it comes, or the test never ends
            time.sleep(0.01)
    except KeyboardInterrupt:
        thread.join()
    stopped = digest(sim.state) == before
    if stopped:
        sim.step(load=1200.0)
    assert digest(sim.state) == result
    return stopped

for number, moment in enumerate(map(float, sys.argv[1:])):
    while not interrupted(("fast", "exact")[number % 2], moment):
        moment /= 2  # the step was faster than the one before
print("interrupted")
"""
)
RUNS = (
    SCENE
    + """
import glob, shutil
path = [{"load": load} for load in (200.0, 400.0, 600.0, 800.0, 400.0, 0.0)]
for number in range(2):  # the first makes plans
    begun = time.perf_counter()
    folder = f"{sys.argv[1]}/whole{number}"
    result = digest(*scene("fast").run(path, progress=False, checkpoint=folder))
    whole = time.perf_counter() - begun
def interrupted(folder, moment):
    sim = scene("fast")
    thread = press_after(moment * whole)
    try:
        thread.start()
        sim.run(path, progress=False, checkpoint=folder)
        while True:
            time.sleep(0.01)
    except KeyboardInterrupt as error:
        stopped = len(getattr(error, "states", path)) < len(path)
        thread.join()
    assert not glob.glob(folder + "/*.part")
    assert digest(*scene("fast").run(path, progress=False, checkpoint=folder)) == result
    shutil.rmtree(folder)
    return stopped

for number, moment in enumerate(map(float, sys.argv[2:])):
    while not interrupted(f"{sys.argv[1]}/{number}", moment):
        moment /= 2
print("interrupted")
"""
)


def moments(name, count):
    """Return times spread over the whole duration of a run."""
    times = random.Random(name)
    return [(trial + times.random()) / count * 0.9 for trial in range(count)]


@tried("interrupt: step")
def test_steps(count):
    assert finished(STEPS, *moments("step", count)) == "interrupted\n"


@tried("interrupt: run")
def test_runs_with_checkpoints(count, tmp_path):
    assert finished(RUNS, tmp_path, *moments("run", count)) == "interrupted\n"


WRITING = """
import os, signal, sys
import samcontact as sc
from samcontact.restart import file
grid = sc.Grid(15, 15, 60e-6, 60e-6)
elastic = sc.Material.elastic(210e9, 0.3)
sim = sc.Simulation(grid, elastic, elastic, sc.surfaces.paraboloid(grid, 7.5e-3))
sim.step(load=100.0)
write = file.write_tree

def pressed(*arguments):
    os.kill(os.getpid(), signal.SIGINT)
    write(*arguments)

file.write_tree = pressed
try:
    sim.save(sys.argv[1])
    raise SystemExit("Ctrl-C was lost")
except KeyboardInterrupt:
    pass
assert sc.Simulation.load(sys.argv[1]).state.load == sim.state.load
print("whole")
"""


def test_an_interrupt_does_not_truncate_a_file(tmp_path):
    with start(WRITING, tmp_path / "state.h5") as process:
        output, errors = process.communicate()
    assert (process.returncode, output, errors) == (0, "whole\n", "")
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    assert [file.name for file in tmp_path.iterdir()] == ["state.h5"]
