# SPDX-License-Identifier: GPL-3.0-or-later
"""Command ``samcontact``, started by its script or by ``python -m samcontact``."""

import gc
import os

from .commands import array_libraries
from .commands.loading import uncollected

with uncollected():
    from .commands.main import main


def start() -> None:
    """Run the command; call this only in a process that does nothing else."""
    array_libraries.hide()
    # case files need no plugins, and the search reads the metadata of all installed packages
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")
    gc.freeze()  # loaded modules are never unused: no collection examines them
    main()


if __name__ == "__main__":
    start()
