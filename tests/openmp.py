# SPDX-License-Identifier: GPL-3.0-or-later
"""A script in processes with different numbers of OpenMP threads."""

import os
import subprocess
import sys
from pathlib import Path


def told_with(script, *threads):
    """What it prints with each of them; it may import what tests share."""
    paths = [str(Path(__file__).parent), os.environ.get("PYTHONPATH", "")]
    shared = {"PYTHONPATH": os.pathsep.join(filter(None, paths))}
    return [
        subprocess.run(
            [sys.executable, "-c", script],
            env=os.environ | shared | {"OMP_NUM_THREADS": str(count)},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for count in threads
    ]
