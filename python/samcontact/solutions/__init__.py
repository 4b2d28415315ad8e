# SPDX-License-Identifier: GPL-3.0-or-later
"""Solved contacts and states of a simulation, and what follows from their fields."""
