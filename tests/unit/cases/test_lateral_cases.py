# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases whose bodies move along y: heat on a path that turns, refused input."""

import numpy as np
import pytest

from samcontact.cases import CaseError, load_case
from samcontact.results import to_dataset

TEXT = """
title = "turn"
[contact]
friction = 0.0
[grid]
nx = 12
ny = 10
dx = 60e-6
dy = 60e-6
nz = 2
dz = 60e-6
[surface]
shape = "paraboloid"
Rx = 7.5e-3
[body1]
law = "elastic"
E = 210e9
nu = 0.3
[body2]
law = "elastic"
E = 210e9
nu = 0.3
[body2.thermal]
conductivity = 50.2
expansion = 11.7e-6
diffusivity = 1.367e-5
[heat]
factor = 0.02
history = [5e-4, 1.0]
track = [150e-6, 100e-6]
[[path]]
load = 100.0
increments = 2
advance = [[0.0, 0.0], [-150e-6, 30e-6]]
duration = 2e-3
[[path]]
load = 100.0
increments = 1
advance = [[0.0, 0.0], [0.0, -100e-6]]
duration = 1e-3
"""


@pytest.fixture
def case_of(tmp_path):
    def made(old="", new=""):
        assert old in TEXT
        path = tmp_path / "case.toml"
        path.write_text(TEXT.replace(old, new, 1) if old else TEXT, encoding="utf-8")
        return load_case(path)

    return made


def test_a_heated_path_that_turns(case_of):
    case = case_of()
    steps = case.steps()
    assert [step["duration"] for step in steps] == [1e-3] * 3
    assert steps[0]["advance"] == ((0.0, 0.0), (-75e-6, 15e-6))
    simulation, path = case.build()
    assert simulation.heat.track == (150e-6, 100e-6)
    states = simulation.run(path, progress=False)
    dataset = to_dataset(simulation, states, case)
    np.testing.assert_allclose(dataset["travel_body2"], [-75e-6, -150e-6, -150e-6])
    np.testing.assert_allclose(dataset["lateral_travel_body2"], [15e-6, 30e-6, -70e-6])
    assert "travel along y, body 2" in repr(states[-1]._rows())
    assert states[-1].surface_temperature(2).max() > 1.0


@pytest.mark.parametrize(
    ("old", "new", "text"),
    [
        ("track = [150e-6, 100e-6]", "track = 150e-6", r"heat\.track along y must be at least"),
        ("track = [150e-6, 100e-6]", "track = [100e-6, 100e-6]", r"heat\.track must be at least"),
        ("friction = 0.0", "friction = 0.1", "advance along y must be equal for both bodies"),
        ("[heat]", '[relief2]\nkind = "dent"\ndepth = 1e-7\nradius = 1e-4\n[heat]',
         r"with \[relief2\], advance along y must be 0"),
        ("friction = 0.0", "friction = {coulomb = 0.1}",
         r"path\[0\]\.advance: .*body 2 along y must be a multiple of the cell size, 6e-05 m"),
        ("[0.0, -100e-6]]", "[0.0, -100e-6], [0.0, 0.0]]", r"path\[1\]\.advance: must be a list"),
    ],
)  # fmt: skip
def test_other_motion_along_y_is_refused(case_of, old, new, text):
    with pytest.raises(CaseError, match=text):
        case_of(old, new)
