# SPDX-License-Identifier: GPL-3.0-or-later
"""Indentation against experiments, on small grids: first yield, Tabor's factor, cavity model."""

import math

import pytest

from benchmarks.experiments import indentation
from benchmarks.experiments.page import TABOR


def test_first_yield_is_at_the_mean_pressure_of_experiments():
    assert 1.07 < indentation.first_yield() < 1.1
    below, above = (indentation.perfect(x, 10) for x in (2.4, 2.7))
    assert below.max_strain == 0
    assert above.max_strain > 0
    assert (
        below.mean_pressure < indentation.first_yield() * below.yield_stress < above.mean_pressure
    )


def test_perfect_plasticity_reaches_tabors_hardness():
    """At smaller loads the constraint factor follows the cavity model; strains remain small."""
    half, full = (indentation.perfect(x, 10) for x in (9.0, 35.0))
    assert half.constraint == pytest.approx(indentation.cavity(half.stiffness), rel=0.1)
    assert TABOR[0] < full.constraint < TABOR[1]
    assert full.max_strain < 1e-3
    # not Hertz, whose ratio is five times as large there
    assert indentation.hertz(full.stiffness) > 4.5 * full.constraint


def test_a_hardening_body_has_tabors_factor_at_the_representative_strain():
    found = indentation.hardening(0.1, 0.02, 8)
    assert TABOR[0] < found.constraint < TABOR[1]
    # the stress of the strain 0.2 a/R, by the power law
    ratio = found.yield_stress / (0.02 / 40.0)
    assert ratio == pytest.approx((found.radius / 0.02) ** 0.1, rel=1e-3)


def test_the_cavity_model_agrees_with_hill():
    """For (c/a)^3 = 1 the core has its initial size and a pressure of 2/3 Y."""
    nu = indentation.NU
    begins = (6 * (1 - nu) - 4 * (1 - 2 * nu)) / (1 - nu**2)
    assert indentation.cavity(begins) == pytest.approx(4 / 3)
    large = indentation.cavity(1e6) - indentation.cavity(1e5)
    assert large == pytest.approx(2 / 3 * math.log(10), rel=1e-4)
