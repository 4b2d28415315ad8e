# SPDX-License-Identifier: GPL-3.0-or-later
"""Inclusions in stressed bodies: closed forms, interfaces, stress in the matrix, statistics.

Bodies with inclusions are described by `samcontact.Heterogeneous`; the functions of this module
evaluate the states of a simulation with such a body. The stress of the matrix is taken from cells
that contain no part of an inclusion.
"""

from .butterflies import ButterflyMap, butterflies
from .closed_forms import EshelbySphere, MisfitSphere, eshelby_sphere, thermal_misfit
from .fine_box import FineBox, fine_field
from .fine_boxes import fine_boxes
from .interface import Interface, interface_stress, interfaces
from .largest import LargestInclusion
from .peaks import MatrixStatistics, Peak, peaks, statistics
from .surroundings import matrix_field
from .weibull import WeibullFit, weibull_fit

__all__ = [
    "ButterflyMap",
    "EshelbySphere",
    "FineBox",
    "Interface",
    "LargestInclusion",
    "MatrixStatistics",
    "MisfitSphere",
    "Peak",
    "WeibullFit",
    "butterflies",
    "eshelby_sphere",
    "fine_boxes",
    "fine_field",
    "interface_stress",
    "interfaces",
    "matrix_field",
    "peaks",
    "statistics",
    "thermal_misfit",
    "weibull_fit",
]
