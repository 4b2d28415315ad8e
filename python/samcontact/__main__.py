# SPDX-License-Identifier: GPL-3.0-or-later
"""Command ``samcontact``, started by its script or by ``python -m samcontact``."""

from .commands import array_libraries
from .commands.loading import uncollected

with uncollected():
    from .commands.main import main


def start() -> None:
    """Run the command in a process of its own."""
    array_libraries.hide()
    main()


if __name__ == "__main__":
    start()
