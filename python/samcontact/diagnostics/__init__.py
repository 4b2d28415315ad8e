# SPDX-License-Identifier: GPL-3.0-or-later
"""Warnings: probable unit mistakes, under-resolved contacts, limits of the theory."""
