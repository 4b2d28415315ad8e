# SPDX-License-Identifier: GPL-3.0-or-later
"""``python -m samcontact`` is the command ``samcontact``."""

from .commands.main import main

if __name__ == "__main__":
    main()
