# SPDX-License-Identifier: GPL-3.0-or-later
"""Random rough surfaces that touch, are pressed and pulled off end in states or named errors."""

import numpy as np
import pytest
from drawn_adhesion import follow, follow_simulated, simulated

import samcontact as sc

PATHS_IN_CI, PATHS_IN_ALL = 15, 500
IGNORED = pytest.mark.filterwarnings(
    "ignore::samcontact.GridTooSmallWarning", "ignore::samcontact.ElasticStrainWarning",
    "ignore::samcontact.ResolutionWarning",
)  # fmt: skip


@IGNORED
@pytest.mark.parametrize("seed", range(PATHS_IN_CI))
def test_a_rough_path_ends_in_states_or_a_named_error(seed):
    follow(seed)


@pytest.mark.slow
@IGNORED
def test_most_of_many_rough_paths_are_followed_to_their_end():
    ends = [follow(seed) for seed in range(PATHS_IN_ALL)]
    stopped = [end for end in ends if not isinstance(end, int)]
    assert len(stopped) <= 0.02 * PATHS_IN_ALL, [str(end)[:200] for end in stopped]


@IGNORED
@pytest.mark.parametrize("seed", [*range(5), 36, 38, 50])
def test_a_path_with_slip_creep_or_a_machine_goes_on_as_if_not_interrupted(seed, tmp_path):
    """States satisfy the conditions of contact; a restart from a checkpoint changes no bit."""
    state = follow_simulated(seed)
    if isinstance(state, Exception):
        return
    half, steps = simulated(seed)
    for step in steps[:4]:
        half.step(**step)
    half.save(tmp_path / "half.h5")
    again = sc.Simulation.load(tmp_path / "half.h5")
    for step in steps[4:]:
        end = again.step(**step)
    np.testing.assert_array_equal(end.pressure, state.pressure)
    np.testing.assert_array_equal(end.shear, state.shear)
    assert end.approach == state.approach
