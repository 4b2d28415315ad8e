# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of a script in processes with different numbers of OpenMP threads."""

import os
import subprocess
import sys
from pathlib import Path


def own(count):
    """Return environment variables for exactly this number of threads.

    "1,3": one thread, and three in loops inside a parallel loop, which OpenMP allows.
    """
    return {"OMP_NUM_THREADS": str(count), "OMP_DYNAMIC": "false"}


def outputs_with(script, *threads):
    """Return the output of a script for each number of threads.

    The number of threads is exact also on a busy machine. The script may import shared modules.
    """
    paths = [str(Path(__file__).parent), os.environ.get("PYTHONPATH", "")]
    shared = {"PYTHONPATH": os.pathsep.join(filter(None, paths))}
    return [
        subprocess.run(
            [sys.executable, "-c", script],
            env=os.environ | shared | own(count),
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for count in threads
    ]
