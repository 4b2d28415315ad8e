# SPDX-License-Identifier: GPL-3.0-or-later
"""Command ``samcontact``: `main` assembles it from the subcommands in the other modules."""
