# SPDX-License-Identifier: GPL-3.0-or-later
"""What the main jobs cost against their size, and what a much larger one would need."""
