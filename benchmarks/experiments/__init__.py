# SPDX-License-Identifier: GPL-3.0-or-later
"""What is known from experiments beside what is computed: indentation, from first yield on."""
