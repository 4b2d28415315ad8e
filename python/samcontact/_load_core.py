# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads the core with OpenMP threads that sleep while they wait, and not too many of them.

Spinning gains a tenth on an idle machine and loses a factor of ten when another process wants the
same cores. Thousands of threads, of a slip in OMP_NUM_THREADS, would only wait for each other.
OpenMP reads its environment once, when its library is loaded; what the user has set wins, and the
environment is left as it was.
"""

import os

_SETTINGS = {
    "OMP_WAIT_POLICY": "passive",
    "OMP_THREAD_LIMIT": str(8 * (os.cpu_count() or 1)),
}

_added = {name: value for name, value in _SETTINGS.items() if name not in os.environ}
os.environ.update(_added)
try:
    from . import _core  # noqa: F401  (loading it is the purpose)
finally:
    for _name in _added:
        del os.environ[_name]
