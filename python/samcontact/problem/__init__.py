# SPDX-License-Identifier: GPL-3.0-or-later
"""Definition of a contact problem: grid, surfaces, friction, heating and settings."""
