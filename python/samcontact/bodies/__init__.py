# SPDX-License-Identifier: GPL-3.0-or-later
"""What the two bodies are made of: materials, layers, hardening laws, depth profiles."""
