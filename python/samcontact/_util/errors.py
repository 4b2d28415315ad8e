# SPDX-License-Identifier: GPL-3.0-or-later
"""Warnings of the package."""


class GridTooSmallWarning(UserWarning):
    """Warning that the contact reaches the grid edge, or plastic strain is outside the fields."""


class ConvergenceWarning(UserWarning):
    """Warning that no solution was found: the result is the state with the smallest error."""


class PlasticStrainWarning(UserWarning):
    """Warning that the plastic strain exceeds the small-strain limit of 5 %.

    It is issued when the accumulated equivalent plastic strain first exceeds 5 %, unless most of it
    is reversed flow (plastic strain magnitude sqrt(2/3 e:e) below half of it), or when that
    magnitude exceeds 5 %.
    """


class SingularPressureWarning(UserWarning):
    """Warning that the pressure is singular at a sharp edge and does not converge with the grid."""


class ResolutionWarning(UserWarning):
    """Warning that the cells are too large for the contact, or the layers for the plastic zone."""


class ElasticStrainWarning(UserWarning):
    """Warning that the elastic strain exceeds the range of linear elasticity."""


class UnitWarning(UserWarning):
    """Warning of a likely unit error: a quantity is implausible in SI units."""


class IncrementWarning(UserWarning):
    """Warning that the increments are too large: more increments would change the results."""


class AccuracyWarning(UserWarning):
    """Warning that a prescribed accuracy is not reached."""
