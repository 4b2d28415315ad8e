# SPDX-License-Identifier: GPL-3.0-or-later
"""Exclusion of array libraries (Dask, Pint, ...), which xarray loads if they are installed.

Loading them would take a second. The commands do not need them, because all values are NumPy
arrays.
"""

from __future__ import annotations

import sys
from typing import Any

_NAMES = "dask", "pint", "cupy", "sparse"


def hide() -> None:
    """Make imports of the array libraries fail in this process, unless they are already loaded.

    Call this function only in a process that runs nothing but a command.
    """
    modules: dict[str, Any] = sys.modules
    for name in _NAMES:
        modules.setdefault(name, None)


def show() -> None:
    """Undo `hide`; call this before work that needs one of the libraries."""
    modules: dict[str, Any] = sys.modules
    for name in _NAMES:
        if modules.get(name, modules) is None:
            del modules[name]
