# SPDX-License-Identifier: GPL-3.0-or-later
"""Command ``samcontact``: one module for each subcommand; `main` combines them."""
