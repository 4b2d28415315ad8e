# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads the core with OpenMP threads that sleep instead of spinning while they wait.

Spinning gains a tenth on an idle machine and loses a factor of ten when another process wants the
same cores. OpenMP reads the policy once, when its library is loaded; a policy set by the user wins,
and the environment is left as it was.
"""

import os

_VARIABLE = "OMP_WAIT_POLICY"

_given = os.environ.get(_VARIABLE)
os.environ.setdefault(_VARIABLE, "passive")
try:
    from . import _core  # noqa: F401  (loading it is the purpose)
finally:
    if _given is None:
        del os.environ[_VARIABLE]
