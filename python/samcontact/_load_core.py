# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads the core with OpenMP threads that soon sleep while they wait, and not too many of them.

A thread that sleeps takes as long to wake as a small transform takes, on virtual machines above
all; one that spins loses a factor of ten when another process wants the same cores. So it spins for
some tenths of a millisecond. Thousands of threads, of a slip in OMP_NUM_THREADS, would only wait
for each other. OpenMP reads its environment once, when its library is loaded; what the user has set
wins, and the environment is left as it was.
"""

import os

_SETTINGS = {
    "OMP_WAIT_POLICY": "passive",
    "GOMP_SPINCOUNT": "10000",
    "OMP_THREAD_LIMIT": str(8 * (os.cpu_count() or 1)),
}

_added = {name: value for name, value in _SETTINGS.items() if name not in os.environ}
os.environ.update(_added)
try:
    from . import _core  # noqa: F401  (loading it is the purpose)
finally:
    for _name in _added:
        del os.environ[_name]
