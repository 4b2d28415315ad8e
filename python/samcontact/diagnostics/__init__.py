# SPDX-License-Identifier: GPL-3.0-or-later
"""Warnings: probable unit errors, under-resolved contacts, limits of the theory."""
