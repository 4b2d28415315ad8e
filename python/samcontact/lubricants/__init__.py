# SPDX-License-Identifier: GPL-3.0-or-later
"""Lubricants: viscosity, density and shear stress as functions of pressure and temperature.

oil = sc.Lubricant.roelands(viscosity=0.04, pressure_viscosity=22e-9)
oil.viscosity(1e9)          # at 1 GPa [Pa s]
oil.with_eyring(5e6)        # with shear thinning
"""

from .density import DensityLaw, DowsonHigginson, Incompressible, Tait
from .grades import Oil, iso_vg, oil
from .lubricant import Lubricant, LubricantHeat
from .tables import LubricantTables

__all__ = [
    "DensityLaw",
    "DowsonHigginson",
    "Incompressible",
    "Lubricant",
    "LubricantHeat",
    "LubricantTables",
    "Oil",
    "Tait",
    "iso_vg",
    "oil",
]
