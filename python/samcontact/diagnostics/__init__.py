# SPDX-License-Identifier: GPL-3.0-or-later
"""Warnings about probable unit errors, under-resolved contacts and limits of the theory."""
