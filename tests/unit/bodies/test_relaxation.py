# SPDX-License-Identifier: GPL-3.0-or-later
"""Relaxation of materials: Laplace transforms, fits to dynamic tests, refusals."""

import pickle

import numpy as np
import pytest

import samcontact as sc
from samcontact.bodies.relaxation import creep_terms

SOFT = sc.Material.elastic(1e9, 0.4)


def test_the_relaxation_of_one_term():
    body = SOFT.with_relaxation([2.0], [0.6])
    t = np.array([0.0, 1.0, 5.0, np.inf])
    np.testing.assert_allclose(body.relaxation(t), 0.4 + 0.6 * np.exp(-t / 2.0), rtol=1e-14)
    np.testing.assert_allclose(body.creep(t), 2.5 - 1.5 * np.exp(-t / 5.0), rtol=1e-14)
    assert body.storage(0.0) == pytest.approx(0.4e9, rel=1e-14)
    assert body.loss(0.5) == pytest.approx(0.3e9, rel=1e-14)  # half of the share at 1/tau
    assert body.storage(np.inf) == pytest.approx(1e9, rel=1e-14)
    assert body.loss(np.inf) == 0.0
    assert SOFT.relaxation(3.0) == SOFT.creep(3.0) == 1.0
    assert SOFT.storage(3.0) == SOFT.E
    assert SOFT.loss(3.0) == 0.0


@pytest.mark.parametrize("total", [0.9, 1 - 1e-4, 1.0])
def test_creep_is_the_inverse_of_relaxation(total):
    """The product of both Laplace transforms times s^2 is 1, for 20 terms over 20 decades."""
    times = np.logspace(-10, 9, 20)
    shares = np.geomspace(1.0, 1e-3, 20)
    body = SOFT.with_relaxation(times, shares * (total / shares.sum()))
    times, shares = (np.array(part) for part in body.relaxation_terms)
    J, theta, rate = creep_terms(body.relaxation_terms)
    s = np.logspace(-12, 12, 49)[:, None]
    rest = body.relaxation(np.inf)
    r = rest + (shares * s * times / (1 + s * times)).sum(axis=1)
    j = 1 + (J / (1 + s * theta)).sum(axis=1) + rate / s[:, 0]
    np.testing.assert_allclose(r * j, 1.0, rtol=1e-11)
    assert (rate > 0) == (total == 1.0)


def test_terms_are_sorted_and_survive_copies():
    one, two = (
        SOFT.with_relaxation([1.0, 0.1], [0.2, 0.3]), SOFT.with_relaxation([0.1, 1.0], [0.3, 0.2])
    )  # fmt: skip
    assert one == two == pickle.loads(pickle.dumps(one))
    assert hash(one) == hash(two)
    assert one != SOFT


def test_a_dynamic_test_is_fitted():
    body = SOFT.with_relaxation([1e-3, 1.0, 100.0], [0.2, 0.3, 0.4])
    omega = np.logspace(-4, 5, 60)
    fitted = sc.Material.from_dynamic(omega, body.storage(omega), body.loss(omega), 28, nu=0.4)
    assert abs(fitted.E / body.E - 1) < 1e-6
    np.testing.assert_allclose(fitted.loss(omega), body.loss(omega), rtol=0.02)
    with pytest.warns(UserWarning, match=r"differs from the measured modulus by up to .* %: use"):
        sc.Material.from_dynamic(omega, body.storage(omega), body.loss(omega), 2)
    with pytest.raises(ValueError, match="loss must be large enough for a viscoelastic fit"):
        sc.Material.from_dynamic(omega, np.full(60, 1e9), np.zeros(60), 3)


@pytest.mark.parametrize(
    ("times", "shares", "message"),
    [
        ([1.0, 1.0], [0.1, 0.1], "times must all be different, got 1.0 twice"),
        ([1.0], [20.0], "sum of shares must be <= 1, got 20.0: divide percent by 100"),
        ([1.0], [0.1, 0.1], "times and shares must be lists of the same length"),
        ([0.0], [0.1], "times must be > 0"),
        ([1.0], [-0.1], "shares must be > 0, got -0.1"),
        (np.arange(1, 66), np.full(65, 0.01), "times must have at most 64 values, got 65"),
    ],
)
def test_wrong_terms_are_refused(times, shares, message):
    with pytest.raises(ValueError, match=message):
        SOFT.with_relaxation(times, shares)


def test_bodies_that_cannot_relax():
    for body in (sc.Material.rigid(), sc.Material.perfect_plastic(1e9, 0.4, 1e7)):
        with pytest.raises(ValueError, match="relaxation"):
            body.with_relaxation([1.0], [0.5])
    with pytest.raises(ValueError, match="residual_stress, which would relax"):
        SOFT.with_residual_stress([0.0], [1e6]).with_relaxation([1.0], [0.5])
