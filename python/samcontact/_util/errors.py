# SPDX-License-Identifier: GPL-3.0-or-later
"""Warnings of the package."""

import warnings


class GridTooSmallWarning(UserWarning):
    """Warning that the contact reaches the grid edge, or that fields omit some plastic strain."""


class ConvergenceWarning(UserWarning):
    """Warning that pressure and shear did not converge; the result is the best state found."""


class PlasticStrainWarning(UserWarning):
    """Warning that the plastic strain exceeds the small-strain limit of 5 %.

    It is issued once, when the plastic strain magnitude sqrt(2/3 e:e) exceeds 5 %, or when the
    accumulated equivalent plastic strain exceeds 5 % and the magnitude is at least half of the
    accumulated strain. With a smaller magnitude, most of the accumulated strain is due to reversed
    flow.
    """


class SingularPressureWarning(UserWarning):
    """Warning that the pressure at a sharp edge is singular: it does not converge with the grid."""


class ResolutionWarning(UserWarning):
    """Warning that cells are too large for the contact, or layers for the plastic zone."""


class ElasticStrainWarning(UserWarning):
    """Warning that the elastic strain exceeds the range of linear elasticity."""


class UnitWarning(UserWarning):
    """Warning of a likely unit error: a quantity is implausible in SI units."""


class IncrementWarning(UserWarning):
    """Warning that the increments are too large: more increments would change the results."""


class WornCoatingWarning(UserWarning):
    """Warning that the top layer of a layered body has lost more than 20 % of its thickness."""


class AccuracyWarning(UserWarning):
    """Warning that a prescribed accuracy is not reached."""


def is_ignored(category: type[Warning]) -> bool:
    """Whether Python's filters ignore all warnings of a category."""
    for action, message, other, module, line in warnings.filters:
        if issubclass(category, other) and not (message or module or line):
            return action == "ignore"
    return False


def attach(error: BaseException, **results: object) -> None:
    """Store the results computed before an exception as attributes of the exception."""
    vars(error).update(results)
