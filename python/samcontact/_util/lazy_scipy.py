# SPDX-License-Identifier: GPL-3.0-or-later
"""SciPy, whose parts are loaded when they are needed, and refused before where memory is short.

The linear algebra (OpenBLAS) that comes with the first part reserves memory as it is loaded. Some
versions ask again for ever when there is none: nothing would end the process but SIGKILL.
"""

from __future__ import annotations

import importlib
import sys
from typing import TYPE_CHECKING, Any

from . import memory

_PARTS = 90e6
"""Address space [bytes] of the parts in use, with one thread of linear algebra."""


class _Parts:
    """Stands for the package: `scipy.special` and so on."""

    def __getattr__(self, name: str) -> Any:
        if not sys.modules.keys() & {"scipy.special", "scipy.linalg"}:
            buffers = memory.BLAS_BUFFER * (memory.blas_threads() - 1)
            memory.require_address_space("loading SciPy", _PARTS + buffers)
        part = importlib.import_module(f"scipy.{name}")
        setattr(self, name, part)
        return part


if TYPE_CHECKING:
    import scipy as scipy  # (as scipy: what this module has for others)
else:
    scipy = _Parts()
