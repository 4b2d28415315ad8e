# SPDX-License-Identifier: GPL-3.0-or-later
"""Command ``samcontact``, started by ``python -m samcontact``."""

from .commands.main import main

if __name__ == "__main__":
    main()
