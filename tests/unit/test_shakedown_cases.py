# SPDX-License-Identifier: GPL-3.0-or-later
"""[shakedown] of a case file: the command prints and writes what Python computes."""

import numpy as np
import pytest
import xarray as xr

from case_texts import BODIES, GRID, MINIMAL, MOVING
from command import check_failure, invoke
from samcontact import cases, shakedown
from samcontact.commands.folder import is_own

SHAKEDOWN = "[shakedown]\ncycles = 4\ntol = 0.002\n"


@pytest.fixture
def run(tmp_path):
    def run(text):
        path = tmp_path / "scene.toml"
        path.write_text(text)
        return invoke("run", path, "--output", tmp_path / "out"), tmp_path / "out"

    return run


def test_the_path_is_repeated(run):
    outcome, folder = run(f"estimate_error = false\n{MINIMAL}\n{SHAKEDOWN}")
    assert outcome.exit_code == 0, outcome.output
    simulation, path = cases.parse_case(MINIMAL).build()
    expected = shakedown.run(simulation, path, cycles=4, tol=0.002, progress=False)
    assert len(expected.cycles) > 1
    with xr.open_dataset(folder / "shakedown.nc") as found:
        assert found.attrs["verdict"] == expected.verdict
        np.testing.assert_array_equal(found["flow"], [c.flow for c in expected.cycles])
        np.testing.assert_array_equal(found["net"], [c.net for c in expected.cycles])
        np.testing.assert_array_equal(found["cycle"], [c.number for c in expected.cycles])
    assert expected.verdict in outcome.stdout
    assert (folder / "shakedown.png").exists()
    # so that a later run without it leaves nothing of it behind
    assert all(is_own(folder / name) for name in ("shakedown.nc", "shakedown.png"))


ELASTIC = MINIMAL.replace(BODIES, BODIES[: BODIES.index("[body2]")] + """[body2]
law = "elastic"
E = 210e9
nu = 0.3
[surface]
shape = "paraboloid"
Rx = 7.5e-3""")  # fmt: skip


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (ELASTIC, "a body that can yield"),
        (MOVING, "a path that brings both bodies back"),
        (f"{MINIMAL}\n[wear]\nthreshold = 0.002\n", "not for a case with wear"),
        (MINIMAL.replace(GRID, "").replace("increments", "# ").replace(
            'title = "two balls"', 'title = "two balls"\naccuracy = 0.1'),
         "not for a case with accuracy"),
    ],
)  # fmt: skip
def test_what_cannot_be_repeated_is_told_before_the_run(run, text, told):
    outcome, _ = run(f"{text}\n{SHAKEDOWN}")
    check_failure(outcome, 2, "shakedown", told)
