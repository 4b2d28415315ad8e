# SPDX-License-Identifier: GPL-3.0-or-later
"""Processes forked after use of the core, in which OpenMP threads do not survive."""

import os
import subprocess
import sys

import pytest

SETUP = """
import hashlib, multiprocessing, os, sys, threading
import samcontact as sc
grid = sc.Grid(32, 32, 30e-6, 30e-6, 8, 30e-6)
steel = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
gap = sc.surfaces.paraboloid(grid, 7.5e-3)

def made():
    elastic = sc.Material.elastic(210e9, 0.3)
    simulation = sc.Simulation(grid, elastic, steel, gap, on_border="warn")
    simulation.step(load=300.0)
    return simulation

def digest(simulation):
    state = simulation.step(load=500.0)
    return hashlib.sha256(state.pressure.tobytes() + state.stress().tobytes()).hexdigest()

simulation = made()
"""
FORK = """
pid = os.fork()
if pid == 0:
    print(digest(simulation), flush=True)
    os._exit(0)
assert os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]) == 0
print(digest(simulation))
"""
POOL = """
with multiprocessing.get_context("fork").Pool(2) as pool:
    print(*pool.map(digest, [simulation, made()]), sep="\\n")
print(digest(simulation))
"""
WHILE_OTHERS_WORK = """
# Another thread makes plans and allocates at any moment of the forks.
going = True
def solve():
    n = 20
    while going:
        n = 20 + (n + 7) % 90
        own = sc.Grid(n, n, 1e-5, 1e-5)
        elastic = sc.Material.elastic(210e9, 0.3)
        sc.ContactSolver(own, elastic, elastic, on_border="warn").solve(
            sc.surfaces.paraboloid(own, 7.5e-3), load=1.0)
thread = threading.Thread(target=solve, daemon=True)  # a failure must end the process
thread.start()
for _ in range(5):
    pid = os.fork()
    if pid == 0:
        digest(made())
        os._exit(0)
    assert os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]) == 0
going = False
thread.join()
print("done")
"""


def printed(script, threads):
    own = {"OMP_NUM_THREADS": str(threads)}
    done = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", SETUP + script],
        env=os.environ | own,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.split()


@pytest.mark.skipif(not hasattr(os, "fork"), reason="forks")
@pytest.mark.parametrize("script", [FORK, POOL], ids=["os.fork", "multiprocessing"])
@pytest.mark.parametrize("threads", [1, 2])
def test_a_forked_child_computes_equal_digits(script, threads):
    digests = printed(script, threads)
    assert len(digests) >= 2
    assert len(set(digests)) == 1


@pytest.mark.skipif(not hasattr(os, "fork"), reason="forks")
def test_a_fork_during_work_of_another_thread_leaves_no_lock():
    assert printed(WHILE_OTHERS_WORK, 1) == ["done"]
