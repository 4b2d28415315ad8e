# SPDX-License-Identifier: GPL-3.0-or-later
"""Random contacts with each friction law end in an admissible state or in a named error."""

import pytest
from drawn_friction import run

pytestmark = pytest.mark.filterwarnings("ignore::UserWarning", "ignore::RuntimeWarning")
IN_CI, ALL = 20, 500


@pytest.mark.parametrize("number", range(IN_CI))
def test_random_histories(number):
    run(number)


@pytest.mark.slow
def test_many_random_histories():
    found = [run(number) for number in range(IN_CI, ALL)]
    assert sum(isinstance(one, int) for one in found) > 0.7 * len(found)
