# SPDX-License-Identifier: GPL-3.0-or-later
"""Random bodies with free faces or heated layers end in admissible states or in named errors."""

import pytest
from drawn_faces import followed as followed_with_faces
from drawn_heat import followed as followed_with_heat

PATHS_IN_CI, PATHS_IN_ALL = 4, 300
FAMILIES = {"free faces": followed_with_faces, "heated layers": followed_with_heat}


@pytest.mark.parametrize("family", FAMILIES)
@pytest.mark.parametrize("count", [PATHS_IN_CI, pytest.param(PATHS_IN_ALL, marks=pytest.mark.slow)])
def test_random_paths_are_followed_or_refused(family, count):
    ends = [FAMILIES[family](seed) for seed in range(count)]
    stopped = [str(end)[:120] for end in ends if not isinstance(end, list)]
    assert len(stopped) <= 0.1 * count, stopped
