# SPDX-License-Identifier: GPL-3.0-or-later
"""Random histories of viscoelastic contacts: contact conditions, energy, and continuation."""

import warnings

import numpy as np
import pytest
from drawn_histories import followed, setup

import samcontact as sc

PATHS_IN_CI, PATHS_IN_ALL = 12, 500


@pytest.mark.parametrize("seed", range(PATHS_IN_CI))
def test_a_path_is_followed_and_goes_on_as_if_not_interrupted(seed, tmp_path):
    """All states are admissible; a restart from a checkpoint changes no bit."""
    states = followed(seed)
    if not isinstance(states, list):
        return
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        half, path = setup(seed)
        for step in path[:3]:
            half.step(**step)
        half.save(tmp_path / "half.h5")
        again = sc.Simulation.load(tmp_path / "half.h5")
        for step in path[3:]:
            end = again.step(**step)
    for name in ("pressure", "gap", "shear"):
        np.testing.assert_array_equal(getattr(end, name), getattr(states[-1], name))
    assert end.viscous_work(2) == states[-1].viscous_work(2)


@pytest.mark.slow
def test_most_of_many_viscoelastic_paths_are_followed_to_their_end():
    ends = [followed(seed) for seed in range(PATHS_IN_ALL)]
    stopped = [end for end in ends if not isinstance(end, list)]
    assert len(stopped) <= 0.02 * PATHS_IN_ALL, [str(end)[:200] for end in stopped]
