# SPDX-License-Identifier: GPL-3.0-or-later
"""Warnings of the package."""


class GridTooSmallWarning(UserWarning):
    """The contact reaches the border of the grid, or fields do not show all plastic strain."""


class PlasticStrainWarning(UserWarning):
    """The plastic strain is beyond the small-strain theory.

    It is given when the accumulated equivalent plastic strain first passes 5 %, unless most of it
    is reversed flow (the magnitude sqrt(2/3 e:e) of the plastic strain is below half of it), or
    when that magnitude does.
    """


class SingularPressureWarning(UserWarning):
    """The pressure rises to a sharp edge, where that of elastic bodies grows without limit."""


class ResolutionWarning(UserWarning):
    """The cells of the grid are too large for the contact, or its layers for the plastic zone."""


class ElasticStrainWarning(UserWarning):
    """The elastic strain is beyond linear elasticity."""


class UnitWarning(UserWarning):
    """A quantity seems to be written in another unit than that of the SI."""


class IncrementWarning(UserWarning):
    """The increments of a path are too large: more of them would change the results."""


class AccuracyWarning(UserWarning):
    """An accuracy that was asked for is not reached."""
