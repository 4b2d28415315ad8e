# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs to an accuracy in partial slip."""

import itertools
import math

import numpy as np
import pytest

import samcontact as sc
from command import fields, invoke
from samcontact.accuracy import estimate
from samcontact.accuracy.refinable_case import RefinableCase
from samcontact.cases import Case, load_case

E, LOAD, RADIUS, MU, PULL = 210e9, 100.0, 0.01, 0.4, 0.6
BODY = {"law": "elastic", "E": E, "nu": 0.0}
PULLED = {"load": LOAD, "fret": {"tangential_load_x": PULL * MU * LOAD}}
LOOP = {
    "title": "fretting",
    "body1": BODY,
    "body2": BODY,
    "surface": {"shape": "paraboloid", "Rx": RADIUS},
    "contact": {"friction": {"coulomb": MU}},
    "path": [{"load": LOAD}, PULLED],
}


def test_a_fretting_loop_is_closer_to_mindlin_than_the_stated_errors():
    """Mindlin and Deresiewicz (1953), doi:10.1115/1.4010702; exact for a Poisson ratio of 0."""
    names = ["shift_x", "friction_work", "stick_fraction", "max_pressure"]
    found = sc.to_accuracy(LOOP, 0.05, quantities=names, progress=False)
    assert found.reached
    body = sc.Material.elastic(E, 0.0)
    hertz = sc.hertz.point(RADIUS, sc.hertz.effective_modulus(body, body), load=LOAD)
    compliance = 2 * 2 / (E / 2)  # sum of (2 - nu)/G of both bodies
    # Johnson (1985), eqs. 7.40, 7.42 and 7.60
    left = 1 - PULL
    shift = 3 * MU * LOAD / (16 * hertz.a) * compliance * (1 - left ** (2 / 3))
    loss = 9 * (MU * LOAD) ** 2 / (10 * hertz.a) * compliance
    loss *= 1 - left ** (5 / 3) - 5 * PULL / 6 * (1 + left ** (2 / 3))
    assert found.increments == (0, 1 * 2, 3 * 2, 5 * 2)  # pressed, and each turn of the loop
    for name, exact in (("shift_x", shift * np.array([0, 1, -1, 1])),
                        ("stick_fraction", np.array([1, *[left ** (2 / 3)] * 3]))):  # fmt: skip
        assert np.all(np.abs(found.series[name] - exact) <= found.series_errors[name] + 1e-12)
    work, errors = found.series["friction_work"], found.series_errors["friction_work"]
    assert abs(work[3] - work[1] - loss) <= errors[3] - errors[1]
    assert abs(found.values["max_pressure"] - hertz.p0) <= found.errors["max_pressure"]


def test_a_case_file_of_partial_slip_has_errors_of_the_response(tmp_path, undrawn):
    """A prescribed motion responds by a force; what vanishes by symmetry is exactly zero."""
    text = f"""title = "twisted"
accuracy = {{tangential_load_x = 0.1, torque = 0.1}}
[body1]
law = "elastic"
E = {E}
nu = 0.3
[body2]
law = "elastic"
E = {E}
nu = 0.3
[surface]
shape = "paraboloid"
Rx = {RADIUS}
[contact]
friction = {{coulomb = {MU}}}
[[path]]
load = {LOAD}
[[path]]
load = {LOAD}
shift_x = 4e-7
"""
    file = tmp_path / "slip.toml"
    file.write_text(text)
    outcome = invoke("run", file, "--output", tmp_path, "--no-figures")
    assert outcome.exit_code == 0, outcome.output
    data = fields(tmp_path)
    value, error = (data[f"tangential_load_x_{part}"][-1] for part in ("best", "error"))
    assert float(value) == pytest.approx(float(data["tangential_load_x"][-1]), rel=0.02)
    assert 0 < error < 0.1 * value
    assert data["torque_best"][-1] == data["torque_error"][-1] == 0.0
    expected = ["approach", "max_pressure", "contact_area", "tangential_load_x", "friction_work"]
    assert RefinableCase(load_case(file)).study.default_names == expected


@pytest.mark.slow
def test_errors_of_slip_cover_the_true_ones():
    """Against three finer grids: similar and dissimilar bodies, driven by forces and motions."""
    drives = [
        PULLED,
        {"load": LOAD, "fret": {"shift_x": 6e-7}},
        {"load": LOAD, "twist": 2e-3},
    ]
    bodies = [BODY, BODY | {"nu": 0.3}, {"law": "rigid"}]
    for body, drive in itertools.product(bodies, drives):
        case = LOOP | {"body1": body, "path": [{"load": LOAD}, drive], "accuracy": 0.01}
        refinable = RefinableCase(Case.model_validate(case))
        refinable.accept(0.01)
        runs = []
        for level in range(7):
            runs.append(refinable.run(level, 2).values)
            if level == 0:
                refinable.settle(refinable.run(0, 2))
        orders = refinable.orders
        truth = estimate.extrapolate_grids(runs, orders).values
        size = np.abs(truth).max(axis=0)
        for count in (4, 5):
            found = estimate.extrapolate_grids(runs[:count], orders)
            off = np.abs(found.values - truth).max(axis=0)
            assert np.all(off <= found.errors.max(axis=0) + 1e-9 * size)


def test_full_slip_in_one_direction_has_the_friction_limit():
    slid = {"load": LOAD, "shift_x": 2e-6}
    case = LOOP | {"path": [{"load": LOAD}, slid]}
    found = sc.to_accuracy(case, 0.05, quantities=["tangential_load_x"], progress=False)
    assert found.values["tangential_load_x"] == pytest.approx(MU * LOAD, rel=1e-4)
    assert math.isfinite(found.errors["tangential_load_x"])
