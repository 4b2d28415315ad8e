# SPDX-License-Identifier: GPL-3.0-or-later
"""Setup of a contact: grid, surfaces, friction, heating and settings."""
