# SPDX-License-Identifier: GPL-3.0-or-later
"""What a contact is set up from: grid, surfaces, friction, heat and settings."""
