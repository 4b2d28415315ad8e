# SPDX-License-Identifier: GPL-3.0-or-later
"""Energy of elastic-plastic contact: plastic dissipation and energy of residual stress."""

from .balancing import EnergyBalance, balance
from .work import eigenstrain_energy, plastic_work, residual_energy

__all__ = ["EnergyBalance", "balance", "eigenstrain_energy", "plastic_work", "residual_energy"]
