# SPDX-License-Identifier: GPL-3.0-or-later
"""Static capacity of rolling bearings: the criterion of ISO 76 for elastic-plastic bodies."""
