# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs are known by what their numbers depend on, and by nothing else."""

import subprocess
import sys

import numpy as np
import pytest

import samcontact as sc
from samcontact.runs.identity import canonical, differences, digest, identity

STEEL = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (1, 1.0),
        (np.float64(0.1), 0.1),
        ((1, 2), [1.0, 2.0]),
        ({"a": 1, "b": 2}, {"b": 2, "a": 1}),
        (np.zeros((2, 3)), np.zeros((2, 3), order="F")),
        (sc.Heat(0.1), sc.Heat([0.0, 0.1])),
    ],
)
def test_the_same(one, other):
    assert canonical(one) == canonical(other)


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (0.1, np.nextafter(0.1, 1.0)),
        (1, True),
        (1, "1"),
        (None, False),
        (["a", "b"], ["a, b"]),
        ([[1], 2], [1, [2]]),
        (np.zeros((2, 3)), np.zeros((3, 2))),
        (STEEL, STEEL.with_kinematic_hardening(3e10, 50.0)),
        (sc.softening.JohnsonCook(1800.0, 1.0), sc.softening.JohnsonCook(1800.0, 1.1)),
        (lambda rise: 1.0 + 0 * rise, lambda rise: 0.5 + 0 * rise),
    ],
)
def test_different(one, other):
    assert canonical(one) != canonical(other)
    assert digest(identity(it=one)) != digest(identity(it=other))


def test_what_differs_is_named():
    before = identity(friction=0.1, gap=np.zeros(3), grid="same")
    now = identity(friction=0.2, gap=np.ones(3), grid="same", heat=0.0)
    told = "friction 0.2 instead of 0.1, another gap, heat 0.0 instead of nothing"
    assert differences(now, before) == told


def test_in_another_process():
    code = "import sys; sys.path.insert(0, sys.argv[1]); from checkpoint_scenes import halved"
    code += "; from samcontact.runs.identity import canonical; print(canonical([halved, {'a': 1}]))"
    from checkpoint_scenes import halved

    folder = halved.__code__.co_filename.rpartition("/")[0]
    found = subprocess.run([sys.executable, "-c", code, folder], capture_output=True, check=True)
    assert found.stdout.decode().strip() == canonical([halved, {"a": 1}])
