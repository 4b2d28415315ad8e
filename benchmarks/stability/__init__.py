# SPDX-License-Identifier: GPL-3.0-or-later
"""What extreme scenes cost and lose: units, cycles, materials, cells, friction and coatings."""
