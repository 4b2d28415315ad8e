# SPDX-License-Identifier: GPL-3.0-or-later
"""Viscoelastic cases to an accuracy, against closed forms: grids and increments are refined."""

import math

import numpy as np
import pytest
from scipy.integrate import quad

import samcontact as sc
from samcontact.accuracy.estimate import extrapolate_increments, irregular

E, NU, RADIUS = 1e7, 0.4, 10e-3
PLANE = E / (1 - NU**2)
TERMS = {"times": [0.1, 1.0, 10.0], "shares": [0.3, 0.3, 0.3]}
BODY = sc.Material.elastic(E, NU).with_relaxation(**TERMS)


def case(path, **changes):
    return {
        "title": "a rigid ball on a viscoelastic body",
        "body1": {"law": "rigid"},
        "body2": {"law": "elastic", "E": E, "nu": NU, "relaxation": TERMS},
        "surface": {"shape": "paraboloid", "Rx": RADIUS},
        "path": path,
    } | changes


def test_the_load_of_a_ramp_is_that_of_ting_within_its_error():
    depth, until = 2e-5, 1.0
    path = [{"approach": depth, "duration": until}, {"approach": 0.0, "duration": until}]
    found = sc.to_accuracy(case(path), 0.01, quantities=["load", "viscous_work_body2"])
    assert found.reached
    of_time = quad(lambda v: BODY.relaxation(until * (1 - v**2)) * 3 * v**2, 0.0, 1.0)[0]
    exact = 4 / 3 * PLANE * math.sqrt(RADIUS) * depth**1.5 * of_time
    error = abs(found.values["load"] - exact)
    assert error <= found.errors["load"] <= 0.01 * exact
    assert error < 5e-4 * exact
    work = found.series["viscous_work_body2"]
    assert 0 < work[0] < work[1]  # after loading and after unloading


def test_creep_over_decades_is_that_of_lee_and_radok_within_its_error():
    load, until = 0.02, 100.0
    path = [
        {"load": load, "duration": 0.0},
        {"load": load, "duration": until, "first_duration": 0.01},
    ]
    found = sc.to_accuracy(case(path), 0.01, quantities=["approach", "imprint_depth_body2"])
    assert found.reached
    hertz = (9 * load**2 / (16 * PLANE**2 * RADIUS)) ** (1 / 3)
    exact = hertz * np.array(BODY.creep([0.0, until])) ** (2 / 3)
    assert (np.abs(found.series["approach"] - exact) <= found.series_errors["approach"]).all()
    assert (found.series_errors["approach"] <= 0.01 * exact[1]).all()
    # the elastic step has one increment on each grid but the first
    steps = {(cells, count) for cells, _, count, _ in found.runs}
    assert max(count for _, count in steps) >= 32
    assert len(found.states) == 1 + found.case.path[1].increments


@pytest.mark.parametrize("order", [1, 2])
def test_the_observed_order_extrapolates_exactly(order):
    """A value with an error of pure order 1 or 2 in the increments is extrapolated to its limit."""
    counts = 2.0 ** np.arange(5)
    values = 3.0 + counts**-order
    found = extrapolate_increments(np.diff(values)[:, None], 0, 2)
    assert values[0] + found.values[0] == pytest.approx(3.0, rel=1e-12)
    more, doubled = (extrapolate_increments(np.diff(values)[:, None], n, 2).values for n in (0, 1))
    assert irregular(more, doubled, 2)[0] == 0.0
    first = extrapolate_increments(np.diff(values)[:, None])
    assert abs(values[0] + first.values[0] - 3.0) <= first.errors[0]


def test_errors_of_a_run_include_those_of_its_increments():
    """The estimates bound the true error of a creeping run with few increments."""
    grid = sc.Grid(33, 33, 2e-5, 2e-5)
    given = grid, sc.Material.rigid(), BODY, lambda grid: sc.surfaces.paraboloid(grid, RADIUS)

    def ends(count):
        simulation = sc.Simulation(*given, tol=1e-8)
        path = [{"load": 0.02 * n / count, "duration": 2.0 / count} for n in range(1, count + 1)]
        return simulation, path, simulation.run(path, progress=False)

    found = sc.estimate_errors(*ends(8))
    exact = ends(128)[2][-1]
    assert found.increments is not None
    assert set(found.increments.values) >= {"approach", "viscous_work_body2"}
    for name, value in (("approach", exact.approach), ("viscous_work_body2", exact.viscous_work())):
        true = abs(found.values[name][-1] - value) / value
        assert 1e-4 < true <= found.increments.values[name] < 8 * true


def test_refusals():
    rolls = [{"load": 0.02, "roll": {"distance": -1e-4, "step": 1e-5, "speed": 1.0}}]
    with pytest.raises(ValueError, match="relaxation of a body requires that the bodies move by"):
        sc.to_accuracy(case(rolls), 0.01)
