# SPDX-License-Identifier: GPL-3.0-or-later
"""The command ``samcontact``: `main` puts it together, and each other module holds some of it."""
