# SPDX-License-Identifier: GPL-3.0-or-later
"""Fatigue criteria at many points: independent of threads, interrupted by Ctrl-C."""

import subprocess
import sys

from openmp import outputs_with

DIGITS = """
import hashlib
import numpy as np
import samcontact as sc
stress = np.random.default_rng(2).standard_normal((11, 6, 21, 40)).cumsum(axis=0)
found = [sc.fatigue.dang_van(stress, slope=0.3), sc.fatigue.crossland(stress, slope=0.3),
         sc.fatigue.findley(stress, k=0.3)]
parts = [field.values.tobytes() for field in found] + [found[-1].normals.tobytes()]
print(hashlib.sha256(b"".join(parts)).hexdigest())
"""

INTERRUPTED = """
import os, signal, sys, threading, time
import numpy as np
import samcontact as sc

stress = np.tile(np.random.default_rng(2).standard_normal((40, 6, 500)), 300)
done = threading.Event()

def press():
    # Were the interpreter not free meanwhile, this would wait for the end.
    for _ in range(20):
        time.sleep(0.01)
    if not done.is_set():
        os.kill(os.getpid(), signal.SIGINT)

thread = threading.Thread(target=press)
try:
    thread.start()
    sc.fatigue.findley(stress, k=0.3)
    done.set()
    print("it was over before it could be interrupted")
except KeyboardInterrupt:
    thread.join()
    print("interrupted", sc.fatigue.dang_van(stress[..., :5], slope=0.0).values.shape)
"""


def test_threads_change_no_digit():
    one, *others = outputs_with(DIGITS, 1, 2, 5)
    assert one.strip()
    assert set(others) == {one}


def test_ctrl_c_stops_a_search_over_many_points():
    command = [sys.executable, "-c", INTERRUPTED]
    done = subprocess.run(command, capture_output=True, text=True)
    assert (done.returncode, done.stdout, done.stderr) == (0, "interrupted (5,)\n", "")
