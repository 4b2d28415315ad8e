# SPDX-License-Identifier: GPL-3.0-or-later
"""SciPy; each subpackage is loaded on first use, if enough address space is available.

The linear algebra library (OpenBLAS) is loaded with the first subpackage and then reserves memory.
Without enough memory, some versions of OpenBLAS retry indefinitely, and only SIGKILL would end the
process.
"""

from __future__ import annotations

import importlib
import sys
from typing import TYPE_CHECKING, Any

from . import memory

_SCIPY_BYTES = 90e6
"""Address space of the subpackages in use, with one thread of linear algebra [bytes]."""


class _LazyModule:
    """Proxy of the package `scipy`; an attribute such as `special` loads the subpackage."""

    def __getattr__(self, name: str) -> Any:
        if not sys.modules.keys() & {"scipy.special", "scipy.linalg"}:
            buffers = memory.BLAS_BUFFER_BYTES * (memory.blas_threads() - 1)
            memory.require_address_space("loading SciPy", _SCIPY_BYTES + buffers)
        part = importlib.import_module(f"scipy.{name}")
        setattr(self, name, part)
        return part


if TYPE_CHECKING:
    import scipy as scipy  # "as scipy" marks an explicit export
else:
    scipy = _LazyModule()
