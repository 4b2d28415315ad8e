# SPDX-License-Identifier: GPL-3.0-or-later
"""Long steps: Ctrl-C gets through and leaves a usable simulation; other threads go on meanwhile.

Each runs in its own process, whose step takes seconds if nobody stops it.
"""

import contextlib
import os
import signal
import subprocess
import sys
import time

SCENE = """
import hashlib, sys, threading, time
import numpy as np
import samcontact as sc

soft = sc.Material.linear_hardening(210e9, 0.3, 1e9, 21e9)
grid = sc.Grid(121, 121, 5e-6, 5e-6, 92, 5e-6)
gap = sc.surfaces.paraboloid(grid, 7.5e-3)

def scene():
    return sc.Simulation(grid, sc.Material.rigid(), soft, gap, residual_stress="exact")

sim = scene()

def digest(state):
    fields = (state.pressure, state.gap, state.plastic_strain())
    return hashlib.sha256(b"".join(np.ascontiguousarray(f).tobytes() for f in fields)).hexdigest()
"""
INTERRUPTED = (
    SCENE
    + """
small = sim.step(load=1.0)
before = digest(small)
print("ready", flush=True)
try:
    sim.step(load=400.0)
    raise SystemExit("the step was over before it could be interrupted")
except KeyboardInterrupt:
    print("interrupted", flush=True)
assert digest(sim.state) == before
expected = scene()
expected.step(load=1.0)
assert digest(sim.step(load=2.0)) == digest(expected.step(load=2.0))
print("usable", flush=True)
"""
)
GIL = (
    SCENE
    + """
ticks, done = [], threading.Event()

def clock():
    while not done.is_set():
        ticks.append(time.perf_counter())
        time.sleep(0.01)

thread = threading.Thread(target=clock)
thread.start()
start = time.perf_counter()
try:
    sim.step(load=90.0)
finally:
    end = time.perf_counter()
    done.set()
    thread.join()
during = [t for t in ticks if start <= t <= end]
print(end - start, max(b - a for a, b in zip([start, *during], [*during, end])))
"""
)


def start(script):
    return subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True)


@contextlib.contextmanager
def killed(process):
    """Do not wait for it when the test fails."""
    try:
        yield
    finally:
        process.kill()


def test_ctrl_c_stops_a_long_step():
    with start(INTERRUPTED) as process, killed(process):
        assert process.stdout.readline().strip() == "ready"
        time.sleep(0.7)
        assert process.poll() is None
        os.kill(process.pid, signal.SIGINT)
        sent = time.perf_counter()
        assert process.stdout.readline().strip() == "interrupted"
        assert (
            time.perf_counter() - sent < 10.0
        )  # the step itself takes far longer when undisturbed
        rest, _ = process.communicate(timeout=60)
        assert rest.strip() == "usable"
        assert process.returncode == 0


def test_other_threads_go_on_during_a_step():
    with start(GIL) as process, killed(process):
        output, _ = process.communicate(timeout=120)
    assert process.returncode == 0
    duration, longest_pause = map(float, output.split())
    assert duration > 0.5  # long enough to tell
    assert longest_pause < 0.5 * duration
