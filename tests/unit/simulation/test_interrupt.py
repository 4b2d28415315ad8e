# SPDX-License-Identifier: GPL-3.0-or-later
"""During long steps other threads run, and Ctrl-C leaves a usable simulation.

The test uses a separate process, whose step would take a minute.
"""

import subprocess
import sys

INTERRUPTED = """
import hashlib, os, signal, sys, threading, time
import numpy as np
import samcontact as sc

soft = sc.Material.linear_hardening(210e9, 0.3, 1e9, 21e9)
grid = sc.Grid(121, 121, 5e-6, 5e-6, 92, 5e-6)
gap = sc.surfaces.paraboloid(grid, 7.5e-3)

def scene():
    return sc.Simulation(grid, sc.Material.rigid(), soft, gap, residual_stress="exact")

def digest(state):
    fields = (state.pressure, state.gap, state.plastic_strain())
    return hashlib.sha256(b"".join(np.ascontiguousarray(f).tobytes() for f in fields)).hexdigest()

sim = scene()
before = digest(sim.step(load=1.0))
main, pressed = threading.get_ident(), []

def press():
    # Were the interpreter not free during a step, this would wait for its end.
    seen = 0
    while seen < 50:
        time.sleep(0.01)
        seen += sys._current_frames()[main].f_code.co_name == "solve"
    pressed.append(seen)
    os.kill(os.getpid(), signal.SIGINT)

thread = threading.Thread(target=press)
try:
    thread.start()
    sim.step(load=400.0)
    print("the step was over before it could be interrupted", pressed, flush=True)
    os._exit(1)
except KeyboardInterrupt:
    thread.join()
assert pressed
assert digest(sim.state) == before
expected = scene()
expected.step(load=1.0)
assert digest(sim.step(load=2.0)) == digest(expected.step(load=2.0))
print("usable")
"""


def test_ctrl_c_stops_a_long_step_that_leaves_other_threads_free():
    done = subprocess.run([sys.executable, "-c", INTERRUPTED], capture_output=True, text=True)
    assert (done.returncode, done.stdout, done.stderr) == (0, "usable\n", "")
