# SPDX-License-Identifier: GPL-3.0-or-later
"""Libraries of arrays that xarray would load in each command, to ask whether values are theirs.

Values in a command are NumPy arrays. Loading the others takes a second of a process, if installed.
"""

from __future__ import annotations

import sys
from typing import Any

_NAMES = "dask", "pint", "cupy", "sparse"


def hide() -> None:
    """Let imports of the libraries fail in this process, unless they are loaded already.

    Only a process that runs nothing but a command may do so.
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
