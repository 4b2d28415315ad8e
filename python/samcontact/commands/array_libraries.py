# SPDX-License-Identifier: GPL-3.0-or-later
"""Array libraries (Dask, Pint, ...) that xarray would load in each command if they are installed.

Loading them takes a second, only to find that the values in a command are NumPy arrays.
"""

from __future__ import annotations

import sys
from typing import Any

_NAMES = "dask", "pint", "cupy", "sparse"


def hide() -> None:
    """Make imports of the libraries fail in this process, unless they are loaded already.

    Only a process that runs nothing but a command may call this function.
    """
    modules: dict[str, Any] = sys.modules
    for name in _NAMES:
        modules.setdefault(name, None)


def show() -> None:
    """Undo `hide`, before work that needs one of the libraries."""
    modules: dict[str, Any] = sys.modules
    for name in _NAMES:
        if modules.get(name, modules) is None:
            del modules[name]
